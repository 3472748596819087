"""The part of docs/reports/accuracy_cost.md that says what the forces hang on: changes by one physical input each."""
import csv
import itertools
import math
import statistics

from swarf import decks, reports, si

import physics

MEASURED = reports.ROOT / "tests/verification/data/ti64_orthogonal_cutting.csv"
ALIKE = ("repeat", "courant", "mass", "diffusion")  # groups that differ from the base by chance, as far as physics goes
NAMES = {"cutting_force": ("F_c", "Fc"), "feed_force": ("F_f", "Ff"), "ratio": ("h_c / h", "ratio")}


def measured():
    """{quantity: value and two standard deviations} at the speed and the depth of the deck."""
    deck = decks.read(reports.ROOT / physics.SCENE.deck_file)
    speed, depth = si(deck["tool"]["velocity"][0]) * 60, physics.SCENE.uncut(deck, 0) * 1e6
    with open(MEASURED) as file:
        rows = csv.DictReader(line for line in file if not line.startswith("#"))
        row = next(one for one in rows if math.isclose(float(one["vc_m_min"]), speed)
                   and math.isclose(float(one["h_um"]), depth))
    return {name: (float(row[f"{key}_lam0_exp"]), float(row[f"{key}_lam0_2s"])) for name, (_, key) in NAMES.items()}


def values(row):
    """{quantity: value and standard error}"""
    found = {name: (row[name], row.get(name + "_own_error", row.get(name + "_error")) or 0.0)  # at the same rows
             for name in ("cutting_force", "feed_force")}
    if row.get("chip_thickness") is not None:
        thickness, error = row["chip_thickness"], row.get("chip_thickness_own_error", row.get("chip_thickness_error"))
        found["ratio"] = (thickness / row["uncut_thickness"], (error or 0.0) / row["uncut_thickness"])
    return found


def scatter_of(runs, spacing):
    """{quantity: standard deviation} of runs of the base's physics and spacing: time step, mass factor and pressure
    diffusion should change nothing, and what they do change F_f by is what one run is worth."""
    alike = [row for row in runs if row["scene"] == physics.SCENE.name and row["spacing"] == spacing
             and (row["group"] in ALIKE or row["group"] == "spacing") and row["status"] == "complete"]
    found = {name: [values(row)[name][0] for row in alike if name in values(row)] for name in NAMES}
    return len(alike), {name: statistics.stdev(ours) if len(ours) > 1 else 0.0 for name, ours in found.items()}


def change(row, base, scatter):
    """{quantity: relative change, and twice its standard error}. A run scatters as those alike do, if its own blocks
    do not show more; so does the mean of the base's, for its repeats are all too alike."""
    ours, theirs, found = values(row), values(base), {}
    for name in NAMES:
        if name in ours and name in theirs:
            (value, error), (was, known) = ours[name], theirs[name]
            single, mean = max(error, scatter[name]), max(known, scatter[name] / base["runs"] ** 0.5)
            found[name] = (value / was - 1, 2 * math.hypot(single, mean) / abs(was))
    return found


def text_of(value, error):
    return f"{100 * value:+.1f} +- {100 * error:.1f} %"


def input_of(row):
    return next(iter(row["changes"]))


def limits(base, found):
    """{quantity: value and two standard deviations} with the spacing taken to 0: what the base's spacing adds is no
    gap that an input could close."""
    scale = {"cutting_force": 1, "feed_force": 1, "chip_thickness": 1 / base["uncut_thickness"]}
    return {"ratio" if name == "chip_thickness" else name: (scale[name] * found[name].value,
                                                            scale[name] * found[name].uncertainty)
            for name in scale if name in found}


def distance(shift, ours, target):
    """Root mean square of what is missing to the measurement, in its standard deviations."""
    off = [(ours[name][0] * (1 + shift[name]) - value) / (two_sigma / 2) for name, (value, two_sigma) in target.items()
           if name in shift]
    return math.sqrt(sum(one**2 for one in off) / len(off))


def listed(parts):
    return "; ".join(parts) or "none"


def hangs_on(name, changes):
    """Which inputs move it by more than the scatter, the strongest first, and which do not."""
    seen = {label: one[name] for label, one in changes.items() if name in one and abs(one[name][0]) > one[name][1]}
    ordered = sorted(seen, key=lambda label: -abs(seen[label][0]))
    unseen = [label for label, one in changes.items() if name in one and label not in seen]
    return (f"{NAMES[name][0]} hangs on: " + listed(f"{label} {text_of(*seen[label])}" for label in ordered)
            + ". Not beyond the scatter: " + listed(unseen) + ".")


def gap(base, ours, target):
    at_base = values(base)
    parts = [f"{NAMES[name][0]} is {ours[name][0]:.3g} +- {ours[name][1]:.2g} at the reference ("
             f"{100 * (ours[name][0] / value - 1):+.0f} %; in the base {100 * (at_base[name][0] / value - 1):+.0f} %), "
             f"measured {value:.3g} +- {two_sigma:.2g}"
             for name, (value, two_sigma) in target.items() if name in ours and name in at_base]
    inside = [NAMES[name][0] for name, (value, two_sigma) in target.items()
              if name in ours and abs(ours[name][0] - value) <= two_sigma]
    return "; ".join(parts) + f" (all 2 sigma). Inside the experiment's scatter: {', '.join(inside) or 'none'}."


def closing(rows, ours, changes, target):
    """What would bring all three to the measurement together."""
    shifts = {label: {name: one[0] for name, one in found.items()} for label, found in changes.items()}
    inputs = {row["label"]: input_of(row) for row in rows}
    start = distance(dict.fromkeys(ours, 0.0), ours, target)
    single = sorted((distance(shift, ours, target), label) for label, shift in shifts.items())
    better = [f"{label} ({off:.2g})" for off, label in single if off < start]
    worse = [f"{label} ({off:.2g})" for off, label in reversed(single) if off >= start]
    yield (f"All three together are {start:.2g} standard deviations of the experiment from the measurement (root mean "
           f"square). Nearer with: {listed(better)}. Not nearer with: {listed(worse)}.")
    pairs = sorted((distance({name: shifts[a][name] + shifts[b][name] for name in shifts[a] if name in shifts[b]},
                             ours, target), a, b) for a, b in itertools.combinations(shifts, 2)
                   if inputs[a] != inputs[b])
    if pairs:
        off, a, b = pairs[0]
        yield f"Nearest of the sums of two changes (added up, not run): {a} and {b}, {off:.2g}."


def directions(changes, ours, target):
    """Which inputs take each force the way it has to go by more than the scatter, and whether one does both."""
    closing_one = {}
    for name in ("cutting_force", "feed_force"):
        way = math.copysign(1, target[name][0] - ours[name][0])
        closing_one[name] = [label for label, one in changes.items() if one[name][0] * way > one[name][1]]
        yield f"{NAMES[name][0]} has to go {'up' if way > 0 else 'down'}, which does: {listed(closing_one[name])}."
    yield f"Both at once: {listed(one for one in closing_one['cutting_force'] if one in closing_one['feed_force'])}."


def edge_for_feed_force(changes, ours, target):
    """The radius of the edge, linear between the sharper one and the deck's, that gives the measured F_f."""
    deck = decks.read(reports.ROOT / physics.SCENE.deck_file)
    radius, sharper = si(deck["tool"]["edge_radius"]), "edge radius 10 um"
    if sharper not in changes:
        return
    wanted = target["feed_force"][0] / ours["feed_force"][0] - 1
    share = wanted / changes[sharper]["feed_force"][0]
    found = radius - share * (radius - 10e-6)
    yield (f"Linear between {sharper} and the deck's, the measured F_f needs an edge of {found * 1e6:.3g} um, where "
           f"F_c is {100 * share * changes[sharper]['cutting_force'][0]:+.1f} %.")


def section(runs, base, found):
    rows = [row for row in runs if row["group"] == physics.GROUP]
    alike, scatter = scatter_of(runs, base["spacing"])
    yield "\n## What the forces hang on\n"
    missing = [point.label for point in physics.POINTS if point.label not in {row["label"] for row in rows}]
    failed = [row["label"] for row in rows if row.get("cutting_force") is None]
    rows = [row for row in rows if row.get("cutting_force") is not None]
    yield (f"The base of the orthogonal cut ({base['runs']} runs, dx = {base['spacing']:.3g} um) with one physical "
           "input changed at a time. Not in the chart above, and not for choosing: other inputs are other experiments. "
           "Changes are against the base, +- twice the standard error of the difference; a run is taken to scatter as "
           f"{alike} runs do that differ in the time step, the mass factor or the pressure diffusion, or as its own "
           "blocks if that is more.\n")
    if missing or failed:
        yield f"Have not run: {listed(missing)}. Did not end: {listed(failed)}.\n"
    target, changes = measured(), {row["label"]: change(row, base, scatter) for row in rows}
    ours = limits(base, found)
    yield " ".join([gap(base, ours, target), hangs_on("cutting_force", changes), hangs_on("feed_force", changes),
                    *directions(changes, ours, target), *edge_for_feed_force(changes, ours, target),
                    *closing(rows, ours, changes, target)]) + "\n"
    head = ["input", "F_c, N", "F_f, N", "h_c / h", "F_c", "F_f", "h_c / h", "highest temperature, K", "keys changed"]
    table, order = [], [point.label for point in physics.POINTS]
    for row in [base] + sorted(rows, key=lambda one: order.index(one["label"])):
        ours, moved = values(row), changes.get(row["label"], {})
        table.append([f"base ({row['runs']} runs)" if row is base else row["label"],
                      *(f"{ours[name][0]:.3g}" if name in ours else "-" for name in NAMES),
                      *(text_of(*moved[name]) if name in moved else "-" for name in NAMES),
                      f"{row['max_temperature']:.0f}", decks.describe(row["changes"]) or "-"])
    table.append(["measured (Ducobu et al. 2024; 2 sigma)",
                  *(f"{value:.3g} +- {two_sigma:.2g}" for value, two_sigma in target.values()), *"-----"])
    yield from reports.table(head, table)
