"""The results of a run: read("results/NAME") and look at its attributes. What is not there is not read."""
import csv
import json
import pathlib
from functools import cached_property

import h5py
import numpy

from . import decks, vtk


class Table(dict):
    """{column: array of shape (rows,)}; units[column] is the unit of its numbers, "1" if they have none."""

    def __init__(self, columns, units):
        super().__init__(columns)
        self.units = units


def read_table(path):
    """A table of a file of comma separated values with columns such as "force_x [N]". A last line that is still being
    written is left out."""
    head, _, body = pathlib.Path(path).read_text().partition("\n")
    names, units = zip(*(column.removesuffix("]").split(" [") for column in head.split(",")))
    lines = body[:body.rfind("\n") + 1].splitlines()
    rows = numpy.loadtxt(lines, delimiter=",", ndmin=2) if lines else numpy.empty((0, len(names)))
    return Table(zip(names, rows.T), dict(zip(names, units)))


def read_hdf5(path):
    """The table of a results.h5: the columns of the history, and those filtered, NAME_filtered."""
    with h5py.File(path) as file:
        columns = file["history"]
        units = {name: numpy.bytes_(one.attrs["units"]).decode() for name, one in columns.items()}
        return Table({name: one[:] for name, one in columns.items()}, units)


class Frame:
    """The state at one time, s, and immersion, deg, or None. Its parts are {name: array} (vtk.read), or None;
    each look at one reads its file."""

    def __init__(self, folder, row):
        self.index, self.time = int(row["frame"]), float(row["time [s]"])
        self.immersion = float(row["immersion [deg]"]) if row["immersion [deg]"] else None
        self.parts = row["parts"].split()
        self._path = f"{folder}/frames/frame_{self.index:04d}"

    def _read(self, part, kind="vtu"):
        return vtk.read(f"{self._path}_{part}.{kind}") if part in self.parts else None

    @property
    def particles(self):
        return self._read("particles")

    @property
    def hexes(self):
        """Points are the nodes; "connectivity" has shape (hexes, 8), the other fields but velocity are of the hexes."""
        arrays = self._read("hexes")
        return arrays and arrays | {"connectivity": arrays["connectivity"].reshape(-1, 8)}

    @property
    def tool(self):
        """Triangles: "position" has shape (triangles, 3 corners, 3). Of each triangle contact_pressure, Pa,
        sliding_speed, m/s, friction_power, W/m2, since the frame before, temperature, K, if the tool conducts, and
        wear_depth, m, if it wears."""
        arrays = self._read("tool", "vtp")
        return arrays and arrays | {"position": arrays["position"].reshape(-1, 3, 3)}


class Results:
    """The folder of a run, or of the windows of a pass."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        if not self.folder.is_dir():
            raise FileNotFoundError(f"{folder}: there is no such folder of results")

    @cached_property
    def deck(self):
        """With every default, in SI units."""
        return decks.read(self.folder / "deck.toml")

    @cached_property
    def history(self):
        """Table of all samples: time, s, immersion, deg, forces on the tool, N, energies, J, temperatures, K, ..."""
        return read_table(self.folder / "history.csv")

    @cached_property
    def filtered(self):
        """Table of time, immersion, and forces and torque without what is faster than the filter's frequency."""
        table = read_hdf5(self.folder / "results.h5")
        names = {"time": "time", "immersion": "immersion"}
        names |= {name.removesuffix("_filtered"): name for name in table if name.endswith("_filtered")}
        return Table({name: table[full] for name, full in names.items()},
                     {name: table.units[full] for name, full in names.items()})

    @property
    def has_ended(self):
        return (self.folder / "summary.json").exists()

    @property
    def is_complete(self):
        return self.has_ended and self.summary["ended"] == "complete"

    @cached_property
    def summary(self):
        """Counts, energies, costs and how the run has ended."""
        return json.loads((self.folder / "summary.json").read_text())

    @cached_property
    def frames(self):
        """List of Frame, by time."""
        with open(self.folder / "frames.csv", newline="") as file:
            return [Frame(self.folder, row) for row in csv.DictReader(file)]

    @cached_property
    def joined(self):
        """What the windows of a pass say together: costs, and the mean force of each by its name."""
        return json.loads((self.folder / "windows.json").read_text())

    @cached_property
    def window_forces(self):
        """Table of the windows that are complete: immersion, deg, mean forces and their standard errors, N, ..."""
        return read_table(self.folder / "windows.csv")

    @cached_property
    def windows(self):
        """{name: Results} of the windows of a pass."""
        return {name: Results(self.folder / name) for name in self.joined["windows"]}


def read(folder):
    """Results of the folder, such as results/NAME. Files are read when they are first looked at."""
    return Results(folder)
