"""What the pages of windows have in common: colours, the ratio of two mean forces, and how a picture is finished."""
import math

import numpy
from swarf import reports

SPACING = 4.0  # um, of inputs/micro_milling_pass.toml across the chip
RUN_INS = (10, 5)  # deg; the first is long, so that it shows what a shorter one would have measured
WIDTH, AHEAD = 6, 7  # deg, of a measurement, and of the material after it
COLOURS = ("#0072b2", "#d55e00")  # Okabe & Ito 2008


def planar(bins):
    return numpy.hypot(bins["force_x"], bins["force_y"])


def smooth(values, count):
    kernel = numpy.ones(count) / count
    return numpy.convolve(values, kernel, mode="valid"), (count - 1) // 2


def percent(value):
    return f"{100 * value:+.1f} %"


def ratio_of_means(pairs):
    """(mean of the first / mean of the second, its standard error from the scatter of the pairs); Cochran 1977, 2.11"""
    pairs = numpy.asarray(pairs, dtype=float)
    ratio = pairs[:, 0].sum() / pairs[:, 1].sum()
    left = pairs[:, 0] - ratio * pairs[:, 1]
    return ratio, left.std(ddof=1) * math.sqrt(len(pairs)) / pairs[:, 1].sum()


def stretches(part, reference, of="bins"):
    """[(force of the part, of the reference)] where both have been, in means over 10 deg."""
    part, reference = part[of], reference[of]
    force = dict(zip(reference["immersion"], planar(reference)))
    pairs = numpy.array([(value, force[angle]) for angle, value in zip(part["immersion"], planar(part))
                         if 0 < angle < 180 and angle in force])
    return pairs[:len(pairs) // 10 * 10].reshape(-1, 10, 2).mean(axis=1)


def ratio_text(pairs):
    """Of the mean of the first to that of the second."""
    ratio, error = ratio_of_means(pairs)
    return f"{percent(ratio - 1)} (standard error {100 * error:.1f} %)"


def compare(part, reference, of="bins"):
    """What the part changes in the force."""
    means = stretches(part, reference, of)
    ratio, error = ratio_of_means(means)
    return (f"Mean force {percent(ratio - 1)}, standard error {100 * error:.1f} % from the scatter of {len(means)} stretches "
            f"of 10 deg, which differ by {100 * math.sqrt(((means[:, 0] / means[:, 1] - 1) ** 2).mean()):.0f} % (root mean "
            f"square)")


def save(figure, axes, name):
    for one in axes:
        one.spines[["top", "right"]].set_visible(False)
        one.grid(color="0.92")
    figure.tight_layout()
    reports.save(figure, name, dpi=150)
