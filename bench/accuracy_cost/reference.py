"""What the results converge to: extrapolation over the spacing (Richardson 1911) with the observed order."""
import math
from dataclasses import dataclass

import numpy

import points
import thickness

ENERGY = 0.01  # of the external work: with a larger residual a small error is luck
QUANTITIES = {"cutting_force": "F_c", "feed_force": "F_f", "chip_thickness": "chip thickness",
              "chip_temperature": "chip temperature", "max_temperature": "highest temperature"}
ORDERS = numpy.linspace(1.0, 2.0, 21)  # surfaces and contact: first; the kernel sum in a smooth field: second
SAMPLES = 500
SERIES = ("spacing", "mean of three")  # groups that differ in the spacing only
CHEAPER = 0.85  # of the base's cost; the processor time of like runs differs by a tenth
# groups that are not of one setting
SETTINGS_BUT = ("combination", "at the limit", "committed deck", *points.MEAN_OF, *points.MEAN_OF.values())


@dataclass
class Reference:
    value: float
    uncertainty: float  # two standard deviations
    order: float | None  # None: the series shows none
    said: str            # where the value is from
    series: tuple = ()   # spacing, value, standard error
    curves: tuple = ()   # limit, slope, order: value(spacing) = limit + slope * spacing^order
    scatter: float = 0.0  # what the fit leaves of one point
    excess: float = 1.0   # that over the errors of the points, or 1

    def error(self, value):
        return (value - self.value) / abs(self.value)

    @property
    def relative(self):
        return self.uncertainty / abs(self.value)


def _fit(spacing, values, sigma, order):
    """Limit, slope, sum of squares, standard error of the limit; that is no less than what the fit leaves asks for."""
    matrix = numpy.stack([numpy.ones_like(spacing), spacing**order], axis=1) / sigma[:, None]
    covariance = numpy.linalg.inv(matrix.T @ matrix)
    limit, slope = covariance @ matrix.T @ (values / sigma)
    squares = ((matrix @ (limit, slope) - values / sigma) ** 2).sum()
    return limit, slope, squares, numpy.sqrt(covariance[0, 0] * max(1.0, squares / (len(values) - 2)))


def _best(spacing, values, sigma):
    """Limit, slope, order, sum of squares of the order that leaves least."""
    fits = ((order, _fit(spacing, values, sigma, order)) for order in ORDERS)
    return min(((limit, slope, order, squares) for order, (limit, slope, squares, _) in fits), key=lambda fit: fit[3])


def extrapolate(spacing, values, error):
    """The limit at spacing 0, with its uncertainty when the values scatter by their own error, or by what the fit
    leaves of them if that is more. If the series changes by more than that, but its best order lies at a bound, the
    order is not known: then the limits of first and of second order, each with its error, bound the value. If it does
    not change by more: the mean of its finest three with their range, no less than twice the mean's standard error."""
    spacing, values, error = (numpy.array(one, float)[numpy.argsort(spacing)] for one in (spacing, values, error))
    series = (spacing, values, error)
    if len(values) < 4:
        finest = values[:3]
        spread = float(numpy.ptp(finest)) if len(finest) > 1 else abs(finest[0])
        return Reference(finest[0], spread, None, "the finest", series)
    if not error.all():  # not known of some: all alike
        error[:] = 1e-6 * abs(values).max()
    limit, slope, order, squares = _best(spacing, values, error)
    excess = max(1.0, float(numpy.sqrt(squares / (len(values) - 3))))
    sigma = error * excess
    left = float(numpy.sqrt(((values - limit - slope * spacing**order) ** 2).sum() / (len(values) - 3)))
    if abs(slope) * (spacing[-1] ** order - spacing[0] ** order) <= 2 * sigma.mean():
        spread = max(float(numpy.ptp(values[:3])), 2 * float(numpy.hypot.reduce(sigma[:3])) / 3)
        return Reference(float(values[:3].mean()), spread, None, "no order observed: mean of the finest three", series,
                         (), left, excess)
    if order in (ORDERS[0], ORDERS[-1]):
        fits = {one: _fit(spacing, values, error, one) for one in (1, 2)}
        low = min(fit[0] - 2 * fit[3] for fit in fits.values())
        high = max(fit[0] + 2 * fit[3] for fit in fits.values())
        return Reference((low + high) / 2, (high - low) / 2, None, "order not determined: between first and second",
                         series, tuple((*fit[:2], one) for one, fit in fits.items()), left, excess)
    random = numpy.random.default_rng(1)
    limits = [_best(spacing, random.normal(values, sigma), sigma)[0] for _ in range(SAMPLES)]
    return Reference(float(limit), 2 * float(numpy.std(limits)), float(order), f"observed order {order:.2g}", series,
                     ((limit, slope, order),), left, excess)


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


def no_worse(row, base, references):
    """Forces and chip thickness within the scatter of both, or nearer to the reference; and the energy is kept."""
    if row["status"] != "complete" or abs(row["energy_residual"]) > ENERGY:
        return False
    for quantity in ("cutting_force", "feed_force", "chip_thickness"):
        if quantity not in references or base.get(quantity) is None:
            continue
        if row.get(quantity) is None:
            return False
        ours, theirs = (abs(references[quantity].error(one.get(quantity + "_of_three", one[quantity])))
                        for one in (row, base))
        scatter = numpy.hypot(row.get(quantity + "_error") or 0, base.get(quantity + "_error") or 0)
        if ours > theirs + scatter / abs(references[quantity].value):
            return False
    return True


def best_settings(rows, base, references):
    """Of each group the cheapest setting that is no worse than the base, and which costs less by more than the same
    run's cost differs."""
    own = {key: value for key, value in base.items() if not key.endswith("_of_three")}  # the rows are met alike
    groups = {}
    for row in rows:
        if row["group"] in SETTINGS_BUT:
            continue
        good = no_worse(row, own, references)
        best = groups.get(row["group"])
        if good and row["core_seconds"] < (best["core_seconds"] if best else CHEAPER * base["core_seconds"]):
            groups[row["group"]] = row
    return sorted(groups.values(), key=lambda row: row["core_seconds"])


def agrees(row, rows):
    """Keeps its energy, and its force is that of the base's settings at the same spacing within twice the scatter:
    small changes that each pass may add up."""
    same = {one["group"]: one for one in rows if one["group"] in SERIES
            and math.isclose(one["spacing"], row["spacing"], rel_tol=1e-6)}  # a file has seven digits
    if row["status"] != "complete" or abs(row["energy_residual"]) > ENERGY or not same:
        return False
    base = same.get("mean of three", same["spacing"])
    scatter = numpy.hypot(base["cutting_force_error"], same["spacing"]["cutting_force_error"])
    return bool(abs(row["cutting_force"] - base["cutting_force"]) <= 2 * scatter)
