"""A tiny folder of results, byte for byte in the formats that swarf writes."""
import json
import pathlib
import struct
import sys
import zlib

import h5py
import numpy
import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "python"))

# As src/output/history.cpp: a line of names with units, a line a sample.
HISTORY = """time [s],immersion [deg],step [1],force_x [N],force_y [N],torque [N m],max_temperature [K]
0,0,0,0,0,0,298.15
1e-06,0.06,10,1.5,-2,0.0005,310
2.5e-06,0.15,20,1.25,-2.25,0.000625,320.5
"""
FRAMES = """frame,time [s],immersion [deg],parts,checksums
0,0,0,hexes particles tool,7624577facaadad0 4575f4deac99cef2 12f6f731907055ea
1,2.5e-06,,particles,c38c9bd6c134b1bd
"""
DECK = """# Written by swarf: the deck with every default, in SI units.
title = "tiny"

[[body]]
name = "work"
spacing = "5e-06 m"

[run]
end_time = "2.5e-06 s"
courant = 0.5
"""
CORNERS = numpy.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], "f4")
PARTICLES = {"position": CORNERS[:2] * numpy.float32(5e-6), "temperature": numpy.array([300, 310], "f4"),
             "stress": numpy.arange(12, dtype="f4").reshape(2, 6), "body": numpy.array([0, 0], "i4"),
             "connectivity": numpy.array([0, 1], "i4")}
HEXES = {"position": CORNERS, "active": numpy.array([1], "i4"), "connectivity": numpy.arange(8, dtype="i4")}
TOOL = {"position": CORNERS[[0, 1, 2, 4, 5, 6]], "connectivity": numpy.arange(6, dtype="i4")}
KINDS = {"f4": "Float32", "i4": "Int32"}


def write_vtk(path, kind, arrays, block=32):
    """As vtkXMLWriter with appended data, not encoded, in blocks of so many bytes, each compressed by zlib."""
    entries, appended = "", b""
    for name, values in arrays.items():
        data = values.tobytes()
        blocks = [data[at:at + block] for at in range(0, len(data), block)]
        packed = [zlib.compress(one) for one in blocks]
        last = len(data) % block
        sizes = [len(blocks), block, last, *map(len, packed)]
        width = values.shape[1] if values.ndim > 1 else 1
        entries += (f'<DataArray type="{KINDS[values.dtype.str[1:]]}" Name="{name}" NumberOfComponents="{width}" '
                    f'format="appended" offset="{len(appended)}"/>\n')
        appended += struct.pack(f"<{len(sizes)}I", *sizes) + b"".join(packed)
    head = (f'<VTKFile type="{kind}" version="0.1" byte_order="LittleEndian" header_type="UInt32" '
            f'compressor="vtkZLibDataCompressor">\n<{kind}><Piece>\n{entries}</Piece></{kind}>\n'
            '<AppendedData encoding="raw">\n   _')
    path.write_bytes(head.encode() + appended + b"\n  </AppendedData>\n</VTKFile>\n")


def write_hdf5(path, columns):
    """As write_history_hdf5 of src/output/write_hdf5.cpp: group history, a dataset a column, its unit beside it."""
    with h5py.File(path, "w") as file:
        for name, (unit, values) in columns.items():
            one = file.create_dataset(f"history/{name}", data=numpy.array(values, "<f8"), chunks=(4096,),
                                      maxshape=(None,), shuffle=True, compression="gzip", compression_opts=4)
            one.attrs["units"] = numpy.bytes_(unit)


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "deck.toml").write_text(DECK)
    (tmp_path / "history.csv").write_text(HISTORY)
    (tmp_path / "frames.csv").write_text(FRAMES)
    (tmp_path / "summary.json").write_text(json.dumps({"ended": "complete", "steps": 20}))
    write_hdf5(tmp_path / "results.h5", {
        "time": ("s", [0, 1e-6, 2.5e-6]), "immersion": ("deg", [0, 0.06, 0.15]), "force_x": ("N", [0, 1.5, 1.25]),
        "force_x_filtered": ("N", [0, 1.25, 1.5]), "torque_filtered": ("N m", [0, 5e-4, 6e-4])})
    frames = tmp_path / "frames"
    frames.mkdir()
    write_vtk(frames / "frame_0000_hexes.vtu", "UnstructuredGrid", HEXES)
    write_vtk(frames / "frame_0000_tool.vtp", "PolyData", TOOL)
    for k in (0, 1):
        write_vtk(frames / f"frame_{k:04d}_particles.vtu", "UnstructuredGrid", PARTICLES)
    return tmp_path
