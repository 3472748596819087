"""Reads the frames that swarf writes: VTK unstructured grids, raw appended data, compressed by zlib."""
import re
import xml.etree.ElementTree as xml
import zlib

import numpy

TYPES = {"Float32": "f4", "Float64": "f8", "Int32": "i4", "Int64": "i8", "UInt8": "u1", "UInt32": "u4", "UInt64": "u8"}


def _array(data, start, header, kind):
    def words(at, count):
        return numpy.frombuffer(data, header, count, at)

    step = numpy.dtype(header).itemsize
    blocks = int(words(start, 1)[0])
    sizes = words(start + 3 * step, blocks)
    at = start + (3 + blocks) * step
    parts = []
    for size in sizes:
        parts.append(zlib.decompress(data[at:at + int(size)]))
        at += int(size)
    return numpy.frombuffer(b"".join(parts), kind)


def read(path):
    """{name: array} of points, cells and topology; vectors have one row each."""
    with open(path, "rb") as file:
        data = file.read()
    begin = re.search(rb"<AppendedData[^>]*>\s*_", data)
    tree = xml.fromstring(data[:begin.start()].decode() + "</VTKFile>")
    header = TYPES[tree.get("header_type")]
    arrays = {}
    for one in tree.iter("DataArray"):
        if one.get("format") != "appended":
            continue
        values = _array(data, begin.end() + int(one.get("offset")), "<" + header, "<" + TYPES[one.get("type")])
        width = int(one.get("NumberOfComponents") or 1)
        arrays[one.get("Name")] = values.reshape(-1, width) if width > 1 else values
    return arrays
