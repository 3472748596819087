"""Errors of the points against the reference, and which points no cheaper one beats."""
import numpy

from points import MEAN_OF
from reference import ENERGY

ASIDE = ("combination", "at the limit")  # groups that are tried, not charted


def error_of(row, quantity, found):
    """Relative error, or None."""
    if quantity not in found or row.get(quantity) is None:
        return None
    return found[quantity].error(row[quantity])


def likely_error(row, found):
    """Of the cutting force; of the mean of three where it is known: where one run met the rows is luck."""
    return found["cutting_force"].error(row.get("cutting_force_of_three", row["cutting_force"]))


def label_of(row):
    repeated = row["runs"] > 1 and row["group"] not in MEAN_OF.values()
    return f"{row['label']} ({row['runs']} runs)" if repeated else row["label"]


def level_of(row, found):
    """Error and standard error together, no less than what the reference is known to."""
    reference = found["cutting_force"]
    return max(abs(likely_error(row, found)) + row["cutting_force_error"] / abs(reference.value), reference.relative,
               1e-12)


def front_of(rows, found):
    """Points that no cheaper one beats: not by chance, so with their scatter. Points that do not keep their energy
    cannot be on it."""
    front, best = [], numpy.inf
    kept = [row for row in rows if abs(row["energy_residual"]) <= ENERGY]
    for row in sorted(kept, key=lambda one: (one["core_seconds"], level_of(one, found))):
        if level_of(row, found) < best:
            front.append(row)
            best = level_of(row, found)
    return front
