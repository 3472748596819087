"""Reads the frames that swarf writes: VTK grids (.vtu) and surfaces (.vtp), raw appended data compressed by zlib."""
import xml.etree.ElementTree as xml
import zlib

import numpy

TYPES = {"Float32": "f4", "Float64": "f8", "Int32": "i4", "Int64": "i8", "UInt8": "u1", "UInt32": "u4", "UInt64": "u8"}


def _array(data, start, header, kind):
    """The array that begins there: number of blocks, two sizes, the size of each compressed block, the blocks."""
    step = numpy.dtype(header).itemsize
    blocks = int(numpy.frombuffer(data, header, 1, start)[0])
    at = start + (3 + blocks) * step
    parts = []
    for size in numpy.frombuffer(data, header, blocks, start + 3 * step):
        parts.append(zlib.decompress(data[at:at + int(size)]))
        at += int(size)
    return numpy.frombuffer(b"".join(parts), kind)


def read(path):
    """{name: array} of points, cells and topology. Scalars: (count,), vectors: (count, 3), stress: (count, 6) as xx, yy,
    zz, xy, yz, zx; SI units. "position" is of the points, "connectivity" has the points of the cells one after another."""
    with open(path, "rb") as file:
        data = file.read()
    head = data.index(b"<AppendedData")
    begin = data.index(b"_", head) + 1
    tree = xml.fromstring(data[:head].decode() + "</VTKFile>")
    header = "<" + TYPES[tree.get("header_type")]
    arrays = {}
    for one in tree.iter("DataArray"):
        if one.get("format") != "appended":
            continue
        values = _array(data, begin + int(one.get("offset")), header, "<" + TYPES[one.get("type")])
        width = int(one.get("NumberOfComponents") or 1)
        arrays[one.get("Name")] = values.reshape(-1, width) if width > 1 else values
    return arrays
