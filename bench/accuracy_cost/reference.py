"""What the results converge to: extrapolation over the spacing (Richardson 1911) with the observed order."""
from dataclasses import dataclass

import numpy

import points
import thickness

ENERGY = 0.01  # of the external work: with a larger residual a small error is luck
QUANTITIES = {"cutting_force": "F_c", "feed_force": "F_f", "chip_thickness": "chip thickness",
              "chip_temperature": "chip temperature", "max_temperature": "highest temperature"}
ORDERS = numpy.linspace(0.5, 2.0, 31)  # the kernel sum is of second order at best
SAMPLES = 500
SERIES = ("spacing", "mean of three")  # groups that differ in the spacing only
CHEAPER = 0.85  # of the base's cost; the processor time of like runs differs by a tenth
SETTINGS_BUT = ("stiffness 0 over dx", "combination", "together", "together, mean of three",
                "committed deck", *SERIES)  # groups that are not of one setting


@dataclass
class Reference:
    value: float
    uncertainty: float  # two standard deviations
    order: float | None  # None: the series shows none
    slope: float = 0.0   # value(spacing) = value + slope * spacing^order
    series: tuple = ()   # spacing, value, standard error
    scatter: float = 0.0  # what the fit leaves of one point
    excess: float = 1.0   # that over the errors of the points, or 1

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
    order lies at a bound, has no observed order: then the mean of its finest three stands for it, with their range,
    but no less than twice the standard error of that mean."""
    spacing, values, error = (numpy.array(one, float)[numpy.argsort(spacing)] for one in (spacing, values, error))
    series = (spacing, values, error)
    if len(values) < 4:
        finest = values[:3]
        return Reference(finest[0], float(numpy.ptp(finest)) if len(finest) > 1 else abs(finest[0]), None, 0.0, series)
    if not error.all():  # not known of some: all alike
        error[:] = 1e-6 * abs(values).max()
    limit, slope, order, squares = _best(spacing, values, error)
    fitted = limit + slope * spacing**order
    scatter = float(numpy.sqrt(((values - fitted) ** 2).sum() / (len(values) - 3)))
    excess = max(1.0, float(numpy.sqrt(squares / (len(values) - 3))))
    sigma = error * excess
    random = numpy.random.default_rng(1)
    limits = [_best(spacing, random.normal(values, sigma), sigma)[0] for _ in range(SAMPLES)]
    seen = abs(slope) * (spacing[-1] ** order - spacing[0] ** order) > 2 * sigma.mean()
    if not seen or order in (ORDERS[0], ORDERS[-1]):
        finest = values[:3]
        spread = max(float(numpy.ptp(finest)), 2 * float(numpy.hypot.reduce(sigma[:3])) / len(finest))
        return Reference(float(finest.mean()), spread, None, 0.0, series, scatter, excess)
    return Reference(float(limit), 2 * float(numpy.std(limits)), float(order), float(slope), series, scatter, excess)


def _mean(runs):
    """One row for runs that differ by chance only."""
    row = dict(runs[0], runs=len(runs), core_seconds=float(numpy.mean([one["core_seconds"] for one in runs])))
    for quantity in QUANTITIES:
        values = [one[quantity] for one in runs if one.get(quantity) is not None]
        if len(values) > 1:
            error = max(numpy.mean([one.get(quantity + "_error") or 0.0 for one in runs]), numpy.std(values, ddof=1))
            row[quantity], row[quantity + "_error"] = float(numpy.mean(values)), float(error / len(values) ** 0.5)
    return row


def combine(rows, base_spacing):
    """One row per setting: repeats of the base, whose step is a little shorter, become one row with it. Points of
    three thicknesses become their mean, beside the point that is as the deck. And what one run scatters by, over
    the spacing."""
    same = [row for row in rows if row["status"] == "complete" and
            (row["group"] == "repeat" or row["group"] == "spacing" and row["spacing"] == base_spacing)]
    others = [dict(row, runs=1) for row in rows if row["group"] != "repeat" and row not in same]
    same.sort(key=lambda row: row["group"] == "repeat")
    single = ([_mean(same)] if same and same[0]["group"] == "spacing" else []) + others
    means, scatter = thickness.means(single, QUANTITIES)
    return [row for row in single if row["group"] != points.THREE] + means, scatter


def widen(rows, found, scatter):
    """No error less than what one run scatters by when the edge meets the rows elsewhere, or, if that is not known,
    what the points leave about the fit over the spacing: neither the blocks nor the repeats of one spacing show it."""
    for row in rows:
        for quantity, reference in found.items():
            if row.get(quantity) is None:
                continue
            own = row[quantity + "_own_error"] = row.get(quantity + "_error") or 0.0  # enough at the same rows
            if row["group"] in points.MEAN_OF.values():
                row[quantity + "_error"] = own * reference.excess
            elif quantity in scatter or row["group"] != "spacing":
                single = scatter[quantity] * row["spacing"] if quantity in scatter else reference.scatter
                row[quantity + "_error"] = max(own, single)
    return rows


def references(rows):
    """{quantity: Reference} from the points that differ in spacing only: means of three, if enough have run."""
    found = {}
    for quantity in QUANTITIES:
        known = {group: [row for row in rows if row["group"] == group and row.get(quantity) is not None]
                 for group in SERIES}
        series = known["mean of three"] if len(known["mean of three"]) >= 4 else known["spacing"]
        if len(series) < 2:
            continue
        found[quantity] = extrapolate([row["spacing"] for row in series], [row[quantity] for row in series],
                                      [row.get(quantity + "_error") or 0.0 for row in series])
    return found


def best_settings(rows, base, references):
    """Of each group the cheapest setting whose errors are, within the scatter of both, no worse than the base's, and
    which costs less by more than the same run's cost differs."""
    def no_worse(row, quantity):
        if quantity not in references or base.get(quantity) is None:
            return True
        if row.get(quantity) is None:
            return False
        scatter = numpy.hypot(row.get(quantity + "_error") or 0, base.get(quantity + "_error") or 0)
        value = references[quantity].value
        return abs(row[quantity] - value) <= abs(base[quantity] - value) + scatter

    groups = {}
    for row in rows:
        if row["group"] in SETTINGS_BUT or row["status"] != "complete" or abs(row["energy_residual"]) > ENERGY:
            continue
        good = all(no_worse(row, quantity) for quantity in ("cutting_force", "feed_force", "chip_thickness"))
        best = groups.get(row["group"])
        if good and row["core_seconds"] < (best["core_seconds"] if best else CHEAPER * base["core_seconds"]):
            groups[row["group"]] = row
    return sorted(groups.values(), key=lambda row: row["core_seconds"])
