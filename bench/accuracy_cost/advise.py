"""What to take from the results: what to use for an asked accuracy, what is on the front, whether what is shipped
should move, and which settings get on with one another."""
import math

from swarf import decks

import points
import ranking
from points import MEAN_OF
from reference import CHEAPER, ENERGY, agrees, no_worse


def percent(value):
    return "-" if value is None else f"{100 * value:+.1f} %"


def level_of_finer(row, rows, found):
    """The most that error and scatter come to together, of this row and of every finer one with the same settings: one
    within a limit among others that are not is chance. None if a finer one does not keep its energy, or if the
    settings have run at one spacing only: one run alone may be luck."""
    def level(one):
        return abs(ranking.likely_error(one, found)) + one["cutting_force_error"] / abs(found["cutting_force"].value)
    series = {*MEAN_OF, *MEAN_OF.values()} - {points.STIFFNESS_0}
    if row["group"] in series:
        alike = [one for one in rows if one["group"] == row["group"]]
    else:
        alike = [one for one in rows if (one["changes"], one["build"]) == (row["changes"], row["build"])
                 and one["group"] not in (*series, "committed deck")]
    finer = [one for one in alike if one["spacing"] <= row["spacing"]]
    if len({one["spacing"] for one in alike}) < 2 or any(abs(one["energy_residual"]) > ENERGY for one in finer):
        return None
    return max(level(one) for one in finer)


def qualifies(row, rows, found, limit):
    level = level_of_finer(row, rows, found)
    return level is not None and level <= limit


def advice(rows, found):
    known = found["cutting_force"].relative
    limits = [limit for limit in (0.05, 0.02, 0.01) if limit >= known]
    parts = [advised(rows, found, limit, f"{100 * limit:.0f} %") for limit in limits]
    if len(limits) < 3:
        tighter = next(limit for limit in (0.05, 0.02, 0.01) if limit < known)
        parts.append(f"For {100 * tighter:.0f} %: cannot be said, the reference itself is known to "
                     f"{100 * known:.1f} %.")
    if not limits:
        parts.append(advised(rows, found, known, f"these {100 * known:.1f} %"))
    return " ".join(parts)


def advised(rows, found, limit, name):
    good = [row for row in rows if qualifies(row, rows, found, limit)]
    if not good:
        return f"For {name}: none of these points."
    shipped = next((row for row in rows if row["group"] == "committed deck"), None)
    row = min(good, key=lambda one: one["core_seconds"])
    compared = f", {row['core_seconds'] / shipped['core_seconds']:.2g} of the shipped deck" if shipped else ""
    keys = f" ({decks.describe(row['changes'])})" if row["changes"] else ""
    return (f"For {name} of the cutting force use \"{row['label']}\"{keys}: {row['core_seconds']:.0f} "
            f"core-seconds{compared}.")


def base_of(scene, rows):
    return next(row for row in rows if row["group"] == "spacing" and row["spacing"] == scene.spacing)


def front(scene, rows, found):
    """What is on the front, and whether the shipped settings are."""
    best = ranking.front_of(rows, found)
    base = base_of(scene, rows)
    said = "are on it" if base in best else "are not on it"
    listed = ", ".join(f"{row['label']} ({row['core_seconds']:.3g} core-seconds, "
                       f"{percent(ranking.error_of(row, 'cutting_force', found))})" for row in best)
    return (f"On the front: {listed}. The shipped settings ({base['label']}, {base['core_seconds']:.3g} core-seconds, "
            f"{percent(ranking.error_of(base, 'cutting_force', found))}) {said}.")


def difference(row, base):
    """Relative, with twice its standard error."""
    return (row["cutting_force"] / base["cutting_force"] - 1,
            2 * math.hypot(row["cutting_force_error"], base["cutting_force_error"]) / base["cutting_force"])


def shipped(scene, rows, found):
    """Whether what is shipped should move: only if a cheaper point is nearer to the reference by more than chance."""
    base = base_of(scene, rows)
    value, near = found["cutting_force"].value, []
    for row in rows:
        gained = (abs(ranking.likely_error(base, found)) - abs(ranking.likely_error(row, found))) * abs(value)
        known = 2 * math.hypot(row["cutting_force_error"], base["cutting_force_error"])
        kept = abs(row["energy_residual"]) <= ENERGY
        if kept and row["core_seconds"] < CHEAPER * base["core_seconds"] and gained > known:
            near.append(row["label"])
    said = ("Cheaper than the shipped settings and nearer to the reference by more than twice the scatter: "
            f"{', '.join(near)}." if near else "No point that is cheaper than the shipped settings is nearer to the "
            "reference by more than twice the scatter.")
    cheap = [row["label"] for row in rows if row["core_seconds"] <= base["core_seconds"] / 5
             and no_worse(row, base, found) and ranking.level_of(row, found) <= ranking.level_of(base, found)]
    said += (" A fifth of the cost or less, and neither error and scatter together nor, within the scatter, feed force "
             f"or chip thickness any worse: {', '.join(cheap) if cheap else 'none'}.")
    if not near and not cheap:
        said += " So they stay."
    whole = next((row for row in rows if row["group"] == "committed deck"), None)
    if whole:
        change, error = difference(whole, base)
        said += (f" The shipped deck, whole, costs {whole['core_seconds'] / base['core_seconds']:.1f} times the base "
                 f"because it cuts for longer, and its cutting force is {percent(change)} (+- {100 * error:.1f}) "
                 f"against the base.")
    return said


def combination(rows):
    """Which of the best settings get on with one another, and pairs that do not."""
    def said_of(row):
        force = f"F_c {row['cutting_force']:.3g} N, " if row.get("cutting_force") is not None else ""
        ended = "" if row["status"] == "complete" else ", did not end"
        return f"\"{row['label']}\" ({force}energy residual {percent(row['energy_residual'])}{ended})"

    def listed(some):
        return "; ".join(said_of(row) for row in some)

    tried = [row for row in rows if row["group"] == "combination"]
    said = ""
    if tried:
        kept = [row for row in tried if agrees(row, rows)]
        best = decks.describe(max((row["changes"] for row in kept), key=len)) if kept else "none"
        lost = listed(row for row in tried if row not in kept)
        said = (f"Together: of each group the cheapest setting that is no worse, within the scatter, and costs at most "
                f"{100 * CHEAPER:.0f} % of the base, the cheapest first, tried at dx = {tried[0]['spacing']:.3g} um. "
                f"These keep energy and force: {best}." + (f" These do not, so their last was left out: {lost}." if lost
                                                           else ""))
    pairs = [row for row in rows if row["group"] == "at the limit"]
    if pairs:
        said += (f" At the limit of the time step, each setting stable alone, at dx = {pairs[0]['spacing']:.3g} um: "
                 f"{listed(pairs)}. The step counts the viscosities and the hourglass stiffness (kernels/stable_step.cpp), not "
                 "what the corrected gradient of a strained chip adds.")
    return said.strip()
