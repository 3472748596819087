"""The part of docs/accuracy_cost.md that says what the forces hang on: changes by one physical input each."""
import csv
import itertools
import math
import pathlib

import decks
import physics

ROOT = pathlib.Path(__file__).resolve().parents[2]
MEASURED = ROOT / "tests/verification/data/ti64_orthogonal_cutting.csv"
NAMES = {"cutting_force": ("F_c", "Fc"), "feed_force": ("F_f", "Ff"), "ratio": ("h_c / h", "ratio")}


def measured():
    """{quantity: value and two standard deviations} at the speed and the depth of the deck."""
    deck = decks.read(ROOT / physics.SCENE.deck_file)
    speed, depth = decks.si(deck["tool"]["velocity"][0]) * 60, physics.SCENE.uncut(deck, 0) * 1e6
    with open(MEASURED) as file:
        rows = csv.DictReader(line for line in file if not line.startswith("#"))
        row = next(one for one in rows if math.isclose(float(one["vc_m_min"]), speed)
                   and math.isclose(float(one["h_um"]), depth))
    return {name: (float(row[f"{key}_lam0_exp"]), float(row[f"{key}_lam0_2s"])) for name, (_, key) in NAMES.items()}


def values(row):
    """{quantity: value and standard error}"""
    found = {name: (row[name], row.get(name + "_error") or 0.0) for name in ("cutting_force", "feed_force")}
    if row.get("chip_thickness") is not None:
        found["ratio"] = tuple((row.get(key) or 0.0) / row["uncut_thickness"]
                               for key in ("chip_thickness", "chip_thickness_error"))
    return found


def change(row, base):
    """{quantity: relative change, and twice its standard error}. A run that was not repeated scatters as the base's
    repeats do, if its own blocks do not show more."""
    ours, theirs, found = values(row), values(base), {}
    for name in NAMES:
        if name in ours and name in theirs:
            (value, error), (was, known) = ours[name], theirs[name]
            single = max(error, known * base["runs"] ** 0.5)
            found[name] = (value / was - 1, 2 * math.hypot(single, known) / abs(was))
    return found


def text_of(value, error):
    return f"{100 * value:+.1f} +- {100 * error:.1f} %"


def input_of(row):
    return row["changes"].split(" = ")[0].removeprefix("no ")


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
    parts = [f"{NAMES[name][0]} is {ours[name][0]:.3g} +- {ours[name][1]:.2g} with the spacing taken to 0 ("
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


def feed_alone(changes, ours, target):
    """Inputs that take F_f the way it has to go, and F_c not the wrong way beyond the scatter."""
    wanted = {name: math.copysign(1, target[name][0] - ours[name][0]) for name in ("cutting_force", "feed_force")}
    good, costly = [], []
    for label, one in changes.items():
        (feed, scatter), (cut, around) = one["feed_force"], one["cutting_force"]
        if feed * wanted["feed_force"] > scatter:
            away = -cut * wanted["cutting_force"] > around
            (costly if away else good).append(f"{label} (F_f {text_of(feed, scatter)}, F_c {text_of(cut, around)})")
    return (f"F_f has to go {'up' if wanted['feed_force'] > 0 else 'down'}. Without taking F_c away from the "
            f"measurement does that: {listed(good)}; and with an F_c that goes the wrong way: {listed(costly)}.")


def section(rows, base, found):
    yield "\n## What the forces hang on\n"
    missing = [point.label for point in physics.POINTS if point.label not in {row["label"] for row in rows}]
    failed = [row["label"] for row in rows if row.get("cutting_force") is None]
    rows = [row for row in rows if row.get("cutting_force") is not None]
    yield (f"The base of the orthogonal cut ({base['runs']} runs, dx = {base['spacing']:.3g} um) with one physical "
           "input changed at a time. Not in the chart above, and not for choosing: other inputs are other experiments. "
           "Changes are against the base, +- twice the standard error of the difference; a run that was not repeated "
           "is taken to scatter as the base's repeats do, or as its own blocks if that is more.\n")
    if missing or failed:
        yield f"Have not run: {listed(missing)}. Did not end: {listed(failed)}.\n"
    target, changes = measured(), {row["label"]: change(row, base) for row in rows}
    ours = limits(base, found)
    yield " ".join([gap(base, ours, target), hangs_on("cutting_force", changes), hangs_on("feed_force", changes),
                    feed_alone(changes, ours, target), *closing(rows, ours, changes, target)]) + "\n"
    yield "| input | F_c, N | F_f, N | h_c / h | F_c | F_f | h_c / h | highest temperature, K | keys changed |"
    yield "|" + "---|" * 9
    order = [point.label for point in physics.POINTS]
    for row in [base] + sorted(rows, key=lambda one: order.index(one["label"])):
        ours = values(row)
        numbers = " | ".join(f"{ours[name][0]:.3g}" if name in ours else "-" for name in NAMES)
        moved = changes.get(row["label"], {})
        shifts = " | ".join(text_of(*moved[name]) if name in moved else "-" for name in NAMES)
        label = f"base ({row['runs']} runs)" if row is base else row["label"]
        yield f"| {label} | {numbers} | {shifts} | {row['max_temperature']:.0f} | {row['changes'] or '-'} |"
    theirs = " | ".join(f"{value:.3g} +- {two_sigma:.2g}" for value, two_sigma in target.values())
    yield f"| measured (Ducobu et al. 2024; 2 sigma) | {theirs} | - | - | - | - | - |"
