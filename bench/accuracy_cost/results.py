"""results.csv: one line per point, small enough to commit. Every write leaves a whole file."""
import csv
import json
import os

COLUMNS = ["scene", "group", "label", "changes", "spacing", "build", "status", "core_seconds", "particle_steps",
           "particles", "hexes", "steps", "cutting_force", "cutting_force_error", "feed_force", "feed_force_error",
           "chip_thickness", "uncut_thickness", "chip_temperature", "max_temperature", "energy_residual",
           "viscous_share", "hourglass_share", "kinetic_share", "deck", "program"]
TEXT = {"scene", "group", "label", "build", "status", "deck", "program"}


def _parse(column, text):
    if column in TEXT:
        return text
    if column == "changes":
        return json.loads(text)  # {path of the key: value}, as swarf.vary takes them
    return float(text) if text else None


def _format(value):
    if value is None:
        return ""
    if isinstance(value, dict):
        return json.dumps(value)
    return f"{value:.7g}" if isinstance(value, float) else str(value)


def read(path):
    if not path.exists():
        return []
    with open(path, newline="") as file:
        return [{column: _parse(column, row.get(column, "")) for column in COLUMNS} for row in csv.DictReader(file)]


def write(path, rows):
    rows = sorted(rows, key=lambda row: (row["scene"], row["group"], row["label"]))
    temporary = path.with_suffix(".tmp")
    with open(temporary, "w", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(COLUMNS)
        out.writerows([_format(row.get(column)) for column in COLUMNS] for row in rows)
    os.replace(temporary, path)
