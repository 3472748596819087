"""What the results converge to: extrapolation over the spacing (Richardson 1911) with the observed order."""
from dataclasses import dataclass

import numpy

QUANTITIES = {"cutting_force": "F_c", "feed_force": "F_f", "chip_thickness": "chip thickness",
              "chip_temperature": "chip temperature", "max_temperature": "highest temperature"}
ORDERS = numpy.linspace(0.5, 2.0, 31)  # the kernel sum is of second order at best
SAMPLES = 500


@dataclass
class Reference:
    value: float
    uncertainty: float  # two standard deviations
    order: float | None  # None: the series shows none
    slope: float = 0.0   # value(spacing) = value + slope * spacing^order
    series: tuple = ()   # spacing, value, standard error

    def error(self, value):
        return (value - self.value) / abs(self.value)

    @property
    def relative(self):
        return self.uncertainty / abs(self.value)


def _fits(spacing, values, sigma):
    """For each order: limit, slope, sum of squares."""
    weight = 1 / sigma
    for order in ORDERS:
        matrix = numpy.stack([numpy.ones_like(spacing), spacing**order], axis=1)
        (limit, slope), *_ = numpy.linalg.lstsq(matrix * weight[:, None], values * weight, rcond=None)
        yield limit, slope, order, (((matrix @ (limit, slope) - values) * weight) ** 2).sum()


def _best(spacing, values, sigma):
    return min(_fits(spacing, values, sigma), key=lambda fit: fit[3])


def extrapolate(spacing, values, error):
    """The limit at spacing 0. Its uncertainty is that of the limit when the values scatter by their own error, or
    by what the fit leaves of them if that is more. A series that is not finer than its scatter, or whose best
    order lies at a bound, has no observed order: then the mean and the range of its finest three stand for it."""
    spacing, values, error = (numpy.array(one, float)[numpy.argsort(spacing)] for one in (spacing, values, error))
    series = (spacing, values, error)
    if len(values) < 4:
        finest = values[:3]
        return Reference(finest[0], float(numpy.ptp(finest)) if len(finest) > 1 else abs(finest[0]), None, 0.0, series)
    error = numpy.maximum(error, 1e-6 * abs(values).max())
    limit, slope, order, squares = _best(spacing, values, error)
    left = numpy.sqrt(squares / (len(values) - 3))  # of the own errors
    sigma = error * max(1.0, left)
    random = numpy.random.default_rng(1)
    limits = [_best(spacing, random.normal(values, sigma), sigma)[0] for _ in range(SAMPLES)]
    seen = abs(slope) * (spacing[-1] ** order - spacing[0] ** order) > 2 * sigma.mean()
    if not seen or order in (ORDERS[0], ORDERS[-1]):
        finest = values[:3]
        spread = max(float(numpy.ptp(finest)), 2 * float(sigma[:3].mean()))
        return Reference(float(finest.mean()), spread, None, 0.0, series)
    return Reference(float(limit), 2 * float(numpy.std(limits)), float(order), float(slope), series)


def _merge(runs):
    """One row for runs that differ by chance only: means. The shares are of their scatter, by quantity."""
    row, shares = dict(runs[0], runs=len(runs)), {}
    row["core_seconds"] = float(numpy.mean([one["core_seconds"] for one in runs]))
    for quantity in QUANTITIES:
        values = [one[quantity] for one in runs if one.get(quantity) is not None]
        row[quantity] = float(numpy.mean(values)) if values else None
        if len(values) > 2:
            shares[quantity] = float(numpy.std(values, ddof=1) / abs(numpy.mean(values)))
    return row, shares


def combine(rows, base_spacing):
    """One row per setting. Repeats of a spacing, whose step is a little shorter, become one row with it: after a
    while they are other cuts, and what they differ by is scatter, which the blocks of one run do not show.
    Settings and spacings without repeats of their own take the scatter of the base's."""
    same, alone = {}, []
    for row in rows:
        if row["group"] in ("spacing", "repeat") and row["status"] == "complete":
            same.setdefault(row["spacing"], []).append(row)
        elif row["group"] != "repeat":
            alone.append((dict(row, runs=1), {}))
    merged = {spacing: _merge(sorted(runs, key=lambda one: one["group"] == "repeat")) for spacing, runs in same.items()}
    merged = {spacing: one for spacing, one in merged.items() if one[0]["group"] == "spacing"}
    usual = merged[base_spacing][1] if base_spacing in merged else {}
    for row, shares in [*merged.values(), *alone]:
        for quantity in QUANTITIES:
            if row.get(quantity) is not None:
                scatter = shares.get(quantity, usual.get(quantity, 0.0)) * abs(row[quantity])
                own = row.get(quantity + "_error") or 0.0
                row[quantity + "_error"] = max(own, scatter) / row["runs"] ** 0.5
    return [row for row, _ in [*merged.values(), *alone]]


def references(rows):
    """{quantity: Reference} from the points that differ in spacing only."""
    found = {}
    for quantity in QUANTITIES:
        series = [row for row in rows if row["group"] == "spacing" and row.get(quantity) is not None]
        if len(series) < 2:
            continue
        found[quantity] = extrapolate([row["spacing"] for row in series], [row[quantity] for row in series],
                                      [row.get(quantity + "_error") or 0.0 for row in series])
    return found


def best_settings(rows, base, references):
    """Of each group the cheapest setting whose errors are, within twice the scatter, no worse than the base's."""
    def no_worse(row, quantity):
        if quantity not in references or base.get(quantity) is None:
            return True
        if row.get(quantity) is None:
            return False
        scatter = numpy.hypot(row.get(quantity + "_error") or 0, base.get(quantity + "_error") or 0)
        value = references[quantity].value
        return abs(row[quantity] - value) <= abs(base[quantity] - value) + 2 * scatter

    groups = {}
    for row in rows:
        if row["group"] in ("spacing", "together", "committed deck") or row["status"] != "complete":
            continue
        good = all(no_worse(row, quantity) for quantity in ("cutting_force", "feed_force", "chip_thickness"))
        if good and row["core_seconds"] < groups.get(row["group"], base)["core_seconds"]:
            groups[row["group"]] = row
    return list(groups.values())
