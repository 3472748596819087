"""docs/reports/stability.md and its picture, all from the results and the catalogue of the program."""
import math
import textwrap

import matplotlib.pyplot as plt
from swarf import reports

plt.rcParams["svg.fonttype"] = "none"

LOOKS = {"stable": ("#e8f1e4", "black"), "degraded": ("#f5c26b", "black"), "failed": ("#8c2d19", "white"),
         "not run": ("white", "0.5"), "": ("white", "0.6")}

HEAD = """# Stability where methods fail

Made by `scripts/stability`; every number is from `tests/stability/results.jsonl`. Formulations meet tests that break
them: each is *stable*, *degraded* or *failed* there by the [limits](#limits), which were set before the runs. Failed also
means: the run ended before its time. A cell of the picture shows the measure that decides.
"""


def number(value):
    if value is None:
        return "no number"
    if value != 0 and (abs(value) < 1e-3 or abs(value) >= 1e3):
        digits = 0 if abs(value) < 1e-3 or value == 10 ** round(math.log10(value)) else 1
        return f"{value:.{digits}e}".replace("e-0", "e-").replace("e+0", "e")
    return f"{value:.2g}"


def sentence(text):
    return text[0].upper() + text[1:]


def shown(limit, value):
    """In words, for a cell."""
    text = limit["shown"]
    if value is None:
        return f"{text.removesuffix(' %')}: a run stops"
    if text.endswith("%"):
        return f"{text[:-2]} {number(100 * value)} %"
    return f"{text} {number(value)}"


def class_of(limit, value):
    if value is None:
        return "failed"
    sign = -1 if limit["more_is_better"] else 1
    if sign * value <= sign * limit["stable"]:
        return "stable"
    worst = limit["failed"]
    return "degraded" if worst is None or sign * value <= sign * worst else "failed"


DEFAULTS = """
## What follows for the defaults

- `particles.correction`, `correct_forces` = true: with plain sums a body with a surface tears when it rotates.
- `particles.viscosity_linear` = 0.3 damps what no gradient sees: of a zero-energy mode {damped} is left without a
  stiffness. Under the mass factor of the cutting decks the work errs by {viscous} between viscosity 0 and 0.5.
- `particles.hourglass_stiffness` = 0.3 holds: rings, plates and zero-energy modes are stable with it and not without.
  The pulled strip, a tension that no metal bears, asks for 2, which breaks above a Courant number of {stiffer}. In the
  cut the pressure's noise is {soft_noise} of the yield stress without, {noise} with 0.3, {stiffer_noise} with 2.
- `particles.pressure_diffusion` = 0; 0.03 in the decks that cut: it lessens the noise of the pressure there. Without
  a stiffness it feeds what alternates in the plate, and it takes its share of the work under
  a mass factor.
- `particles.shifting` = true: of the plastic strain of a layer sheared to 10 from disorder {unshifted_strain} is missing
  without, {shifted_strain} with it; neighbours in the chip are {unshifted_nearest} and {shifted_nearest} spacings apart.
  A strip of metal that is pulled slowly parts without it, and more slowly still (verification) with it.
- `particles.kernel_frame` = "current": "initial" is best in everything that it can do, but cannot follow a chip.
- `hexes.hourglass` = "stiffness": it holds what "viscous" only slows. Neither takes the shear of a cut.
- `run.courant` = 0.8: shaken cubes of all formulations hold at and below {courant}. Soft bodies that tear ask for 0.3.
- `run.mass_factor` = 1e4 at 0.5 m/s and 10 um: the largest at which the defaults keep the work within 10 %.
"""


class Matrix:
    def __init__(self, catalogue, results):
        self.rows, self.tests = catalogue["formulations"], catalogue["tests"]
        self.limits = {limit["name"]: limit for limit in catalogue["limits"]}
        self.results = results

    def cell(self, row, test):
        """Class and text."""
        if test["name"] not in row["tests"]:
            return "", "-"
        result = self.results.get((row["name"], test["name"]))
        if not result:
            return "not run", "not run"
        if result["decisive"]:
            measure = result["decisive"]
            return result["class"], shown(self.limits[measure], result["measures"][measure])
        if result["reached"] is None:
            return result["class"], "no end"
        return result["class"], f"ends at {100 * result['reached']:.0f} %"

    def count(self, row, name):
        return sum(self.cell(row, test)[0] == name for test in self.tests)


def draw(matrix):
    rows, tests = matrix.rows, matrix.tests
    figure, axes = plt.subplots(figsize=(13.6, 1.6 + 0.36 * len(rows)), layout="constrained")
    for y, row in enumerate(rows):
        for x, test in enumerate(tests):
            name, text = matrix.cell(row, test)
            color, ink = LOOKS[name]
            axes.add_patch(plt.Rectangle((x, y), 1, 1, facecolor=color, edgecolor="white", linewidth=1.5))
            axes.text(x + 0.5, y + 0.5, "\n".join(textwrap.wrap(text.replace(" %", "\u00a0%"), 12)), ha="center",
                      va="center", fontsize=6.5, color=ink, linespacing=0.95)
    axes.set(xlim=(0, len(tests)), ylim=(len(rows), 0))
    axes.set_yticks([y + 0.5 for y in range(len(rows))], ["\n".join(textwrap.wrap(row["text"], 44)) for row in rows],
                    fontsize=8)
    axes.set_xticks([x + 0.5 for x in range(len(tests))], ["\n".join(textwrap.wrap(t["title"], 12)) for t in tests],
                    fontsize=8)
    axes.xaxis.tick_top()
    axes.tick_params(length=0)
    for spine in axes.spines.values():
        spine.set_visible(False)
    handles = [plt.Rectangle((0, 0), 1, 1, facecolor=LOOKS[name][0], edgecolor="0.6") for name in LOOKS if name]
    names = [name for name in LOOKS if name]
    axes.legend(handles[:3], names[:3], loc="upper center", bbox_to_anchor=(0.5, -0.005), ncols=3, fontsize=8,
                frameon=False)
    reports.save(figure, "stability", dpi=150)


def defaults(matrix):
    """DEFAULTS with its numbers, or nothing if one has not run."""
    def value(formulation, test, measure):
        return matrix.results[formulation, test]["measures"][measure]

    def percent(*cell):
        return f"{number(100 * value(*cell))} %"
    try:
        courant = min(result["measures"]["courant"]
                      for (_, test), result in matrix.results.items() if test == "courant")
        return DEFAULTS.format(
            viscous=percent("defaults", "viscosity", "viscosity_shipped"),
            damped=percent("defaults_soft", "zero_energy", "mode_left"),
            courant=number(courant),
            stiffer=number(value("defaults_stiffer", "courant", "courant")),
            noise=number(value("defaults", "cut", "pressure_noise")),
            unshifted_strain=percent("cutting_unshifted", "shear_metal", "strain_missing"),
            shifted_strain=percent("cutting", "shear_metal", "strain_missing"),
            unshifted_nearest=number(value("cutting_unshifted", "voids", "nearest")),
            shifted_nearest=number(value("cutting", "voids", "nearest")),
            soft_noise=number(value("defaults_soft", "cut", "pressure_noise")),
            stiffer_noise=number(value("defaults_stiffer", "cut", "pressure_noise")))
    except (KeyError, TypeError):
        return ""


def count_table(matrix):
    """How often each formulation is what."""
    names = [name for name in LOOKS if name]
    return reports.table(["formulation", *names], [[row["text"], *(matrix.count(row, name) for name in names)]
                                                   for row in matrix.rows])


def test_table(matrix, test):
    found = [(row, matrix.results[row["name"], test["name"]]) for row in matrix.rows
             if (row["name"], test["name"]) in matrix.results]
    measures = list(dict.fromkeys(m for _, result in found for m in result["measures"]))
    yield f"\n### {sentence(test['title'])}\n"
    yield f"{sentence(test['text'])}.\n"
    table = []
    for row, result in found:
        values = []
        for m in measures:
            if m not in result["measures"]:
                values.append("-")
                continue
            value, limit = result["measures"][m], matrix.limits[m]
            text = number(100 * value if limit["shown"].endswith("%") and value is not None else value)
            values.append({"failed": f"**{text}**", "degraded": f"*{text}*"}.get(class_of(limit, value), text))
        steps = "-" if result["steps"] is None else f"{result['steps']:.0f}"
        seconds = "-" if result["seconds"] is None else f"{result['seconds']:.1f}"
        table.append([row["text"], result["class"], *values, steps, seconds])
    head = ["formulation", "class", *(matrix.limits[m]["shown"] for m in measures), "steps", "seconds"]
    yield from reports.table(head, table)
    if test["why"]:
        yield f"\n{test['why']}"
    for row, result in found:
        if result["fault"]:
            at = "" if result["reached"] is None else f" at {100 * result['reached']:.0f} % of its time"
            yield f"\n{row['text']}{at}: {result['fault']}"


def limit_table(matrix):
    rows = []
    for limit in matrix.limits.values():
        stable, failed = f"{limit['stable']:g}", "never" if limit["failed"] is None else f"{limit['failed']:g}"
        if limit["more_is_better"]:
            stable, failed = f"at least {stable}", f"less than {failed}"
        rows.append([limit["shown"].removesuffix(" %"), stable, failed, limit["text"], limit["reason"]])
    return reports.table(["measure", "stable up to", "failed beyond", "what it is", "why"], rows)


def changes(matrix):
    """What one change to a formulation does to its cells, by the pairs that the rows' names make."""
    order = {"stable": 0, "degraded": 1, "failed": 2}
    by_name = {row["name"]: row for row in matrix.rows}
    for name, base in PAIRS:
        if name not in by_name or base not in by_name:
            continue
        better, worse = [], []
        for test in matrix.tests:
            before, after = matrix.cell(by_name[base], test), matrix.cell(by_name[name], test)
            if before[0] not in order or after[0] not in order or before[0] == after[0]:
                continue
            line = f"{test['title']} ({before[1]} -> {after[1]})"
            (better if order[after[0]] < order[before[0]] else worse).append(line)
        yield (f"- **{by_name[name]['text']}** against {by_name[base]['text']}: "
               + ("better in " + ", ".join(better) if better else "better in nothing")
               + ("; worse in " + ", ".join(worse) if worse else "; worse in nothing") + ".")


PAIRS = [
    ("corrected", "plain"), ("pressure_diffusion", "corrected"),
    ("hourglass_stiffness", "corrected"),
    ("shifting", "corrected"),
    ("defaults_soft", "shifting"),
    ("defaults_pressure_diffusion", "defaults"), ("defaults", "defaults_soft"),
    ("defaults_stiffer", "defaults"), ("cutting", "defaults"),
    ("cutting", "cutting_unshifted"),
    ("total_lagrangian_viscous", "total_lagrangian"),
    ("total_lagrangian_stiff", "total_lagrangian_viscous"), ("total_lagrangian_viscous", "defaults"),
    ("hexes_viscous", "hexes_stiffness"), ("hexes_stiffness_deleted", "hexes_stiffness"),
    ("hexes_viscous_deleted", "hexes_viscous")]


def write_page(catalogue, results):
    matrix = Matrix(catalogue, results)
    draw(matrix)
    cells = [matrix.cell(row, test)[0] for row in matrix.rows for test in matrix.tests]
    commits = sorted({result["commit"] for result in results.values()})
    seconds = sum(result["seconds"] or 0 for result in results.values())
    lines = [HEAD, f"{cells.count('stable')} cells are stable, {cells.count('degraded')} degraded, "
             f"{cells.count('failed')} failed, {cells.count('not run')} have not run. One thread, {seconds:.0f} s for "
             f"all. Commits: {', '.join(commits)}.\n",
             *count_table(matrix), "![The stability matrix](stability.png)", defaults(matrix),
             "\n## What one change does\n", "By class; a cell that stays in its class is not named.\n", *changes(matrix),
             "\n## Limits\n", *limit_table(matrix), "\n## Each test\n"]
    for test in matrix.tests:
        lines += test_table(matrix, test)
    reports.write("stability", lines)
    print(f"{cells.count('stable')} stable, {cells.count('degraded')} degraded, {cells.count('failed')} failed: "
          "docs/reports/stability.md")
