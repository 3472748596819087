"""What the runs of a study gave, as one table."""
import csv
import math

import h5py
import numpy

from .. import results
from .runs import is_complete

UNITS = {"force_planar": "N", "force_x": "N", "force_y": "N", "force_z": "N", "torque": "N m",
         "force_planar_peak": "N", "max_temperature": "K", "core_seconds": "s"}


def block_error(time, values):
    """Standard error of the mean of a history: that of 16, 8 and 4 block means about a line, the largest, as swarf's
    windows have it (src/windows/join_windows.hpp). NaN where samples are too few."""
    error = math.nan
    place = (time - time[0]) / (time[-1] - time[0]) if len(time) > 1 else numpy.zeros(len(time))
    for blocks in (16, 8, 4):
        means = [values[(place >= b / blocks) & ((place < (b + 1) / blocks) | (b + 1 == blocks))] for b in range(blocks)]
        if min(map(len, means)) == 0:
            continue
        means = numpy.array([one.mean() for one in means])
        at = numpy.arange(blocks) - (blocks - 1) / 2
        left = means - means.mean() - at * (at @ means) / (at @ at)
        error = numpy.nanmax([error, math.sqrt(left @ left / (blocks - 2) / blocks)])
    return error


def measure_run(folder):
    """{response: (value, own error)} of a whole run: means of its second half, where the chip has formed."""
    run = results.read(folder)
    history = run.history
    late = history["time"] >= 0.5 * (history["time"][0] + history["time"][-1])
    time, found = history["time"][late], {}
    for name in ("force_x", "force_y", "force_z", "torque"):
        found[name] = (history[name][late].mean(), block_error(time, history[name][late]))
    x, y = found["force_x"][0], found["force_y"][0]
    planar = math.hypot(x, y)
    along = (history["force_x"][late] * x + history["force_y"][late] * y) / (planar or 1)  # not the noise's length
    found["force_planar"] = (planar, block_error(time, along))
    found["force_planar_peak"] = (run.filtered["force_planar"].max(), math.nan)
    found["max_temperature"] = (history["max_temperature"].max(), math.nan)
    found["core_seconds"] = (run.summary["cost"]["cpu_seconds"], math.nan)
    return found


def measure_windows(folder):
    """The same of a pass in windows: means of the windows."""
    run = results.read(folder)
    table, found = run.window_forces, {}
    for name in ("x", "y", "z", "planar"):
        error = table[f"error_{name}"]
        found[f"force_{name}"] = (table[f"force_{name}"].mean(), math.sqrt((error**2).sum()) / len(error))
    peak = int(table["force_planar"].argmax())
    found["force_planar_peak"] = (table["force_planar"][peak], table["error_planar"][peak])
    histories = [one.history for one in run.windows.values()]
    found["torque"] = (numpy.mean([one["torque"][len(one["torque"]) // 2:].mean() for one in histories]), math.nan)
    found["max_temperature"] = (max(one["max_temperature"].max() for one in histories), math.nan)
    found["core_seconds"] = (run.joined["core_seconds"], math.nan)
    return found


def measure(study, folder):
    """A dictionary for each run that is complete: "task", "point", "repeat", and the responses."""
    rows = []
    for task in study.tasks:
        if is_complete(study, folder, task):
            measured = (measure_windows if study.windows else measure_run)(folder.run(task))
            rows.append({"task": task.number, "point": task.point, "repeat": task.repeat, **measured})
    return rows


def join_repeats(study, rows):
    """A dictionary for each point with a complete run: its number, how many repeats, responses (value, error). The error
    is that of the scatter between repeats or the runs' own, whichever is more."""
    points = []
    for k in range(len(study.points)):
        own = [row for row in rows if row["point"] == k]
        if not own:
            continue
        joined = {"point": k, "repeats": len(own)}
        for name in UNITS:
            values = numpy.array([row[name][0] for row in own])
            errors = numpy.array([row[name][1] for row in own])
            error = math.sqrt((errors**2).mean() / len(own))  # NaN: not known
            if len(own) > 1:
                between = values.std(ddof=1) / math.sqrt(len(own))
                error = between if math.isnan(error) else max(error, between)
            joined[name] = (values.mean(), error)
        points.append(joined)
    return points


def columns_of(study, points):
    """{column: (unit, values)} of the whole table."""
    columns = {"point": ("1", [one["point"] for one in points]), "repeats": ("1", [one["repeats"] for one in points])}
    for parameter in study.parameters:
        values = [study.points[one["point"]][parameter.name] for one in points]
        if parameter.unit is not None:
            values = [parameter.number(value) for value in values]
        columns[parameter.name] = (parameter.unit or "1", values)
    for name, unit in UNITS.items():
        columns[name] = (unit, [one[name][0] for one in points])
        columns[f"{name}_error"] = (unit, [one[name][1] for one in points])
    return columns


def write(study, folder, points):
    """study.csv and study.h5."""
    columns = columns_of(study, points)
    with open(folder.path / "study.csv", "w", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(f"{name} [{unit}]" for name, (unit, _) in columns.items())
        out.writerows(zip(*(values for _, values in columns.values())))
    with h5py.File(folder.path / "study.h5", "w") as file:
        file.attrs["study"], file.attrs["deck"] = study.file.read_text(), study.deck_file.read_text()
        for name, (unit, values) in columns.items():
            is_text = any(isinstance(value, str) for value in values)
            one = file.create_dataset(f"study/{name}", data=[str(value) for value in values] if is_text else values)
            one.attrs["units"] = numpy.bytes_(unit)
    return columns
