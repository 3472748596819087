"""Means of three thicknesses: one row for each three runs, and what a single run of them scatters by."""
import math

from points import MEAN_OF, THICKNESSES


def threes(rows):
    """[(as it is, thicker, thinner)] of all points that have run at all three."""
    complete = {row["label"]: row for row in rows if row["status"] == "complete"}
    found = ([row, *(complete.get(f"{label}, {name}") for name in THICKNESSES)] for label, row in complete.items())
    return [three for three in found if all(three) and three[0]["group"] in MEAN_OF]


def scatter_of(found, quantity):
    """Standard deviation of a run about the mean of its three, over the spacing: a row more or less below the edge is
    that much thickness. Without what is due to the thickness: that is taken to be linear, and alike at all spacings.
    None if there are too few."""
    found = [three for three in found if three[0]["group"] == "spacing" and all(row.get(quantity) for row in three)]
    if len(found) < 2:
        return None
    offsets, values = [], []
    for three in found:
        mean = sum(row[quantity] for row in three) / 3
        offsets += [(row["uncut_thickness"] - three[0]["uncut_thickness"]) / row["spacing"] for row in three]
        values += [(row[quantity] - mean) / row["spacing"] for row in three]
    slope = sum(x * y for x, y in zip(offsets, values)) / sum(x * x for x in offsets)
    squares = sum((y - slope * x) ** 2 for x, y in zip(offsets, values))
    return math.sqrt(squares / (2 * len(found) - 1))


def mean_of(three, scatter):
    row = dict(three[0], group=MEAN_OF[three[0]["group"]], label=f"3 x {three[0]['label']}", runs=3)
    for name in ("core_seconds", "particle_steps"):
        row[name] = sum(one[name] for one in three)
    row["energy_residual"] = max((one["energy_residual"] for one in three), key=abs)
    for quantity, single in scatter.items():
        if all(one.get(quantity) for one in three):
            row[quantity] = sum(one[quantity] for one in three) / 3
            row[quantity + "_error"] = single * row["spacing"] / math.sqrt(3)
            three[0][quantity + "_of_three"] = row[quantity]
    return row


def means(rows, quantities):
    """The mean rows, and {quantity: standard deviation of one run over its spacing}."""
    found = threes(rows)
    scatter = {quantity: single for quantity in quantities if (single := scatter_of(found, quantity)) is not None}
    return [mean_of(three, scatter) for three in found] if scatter else [], scatter
