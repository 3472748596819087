"""docs/reports/accuracy_cost.md: the pictures, what to take from them and the table, all from the results."""
from swarf import decks, reports

import advise
import physics
import physics_page
import points
import ranking
from points import MEAN_OF
from reference import ENERGY, QUANTITIES
from scenes import SCENES

HEAD = """# Accuracy against cost

Made by `bench/accuracy_cost/run`; every number is from `bench/accuracy_cost/results.csv`, and measured as said
[at the end](#how-it-is-measured).
"""

METHOD = """
## How it is measured

Cost is the processor time of the whole program on one thread, so it does not count waiting for other programs. One
setting is changed at a time from the committed decks, in a shorter form of them (`bench/accuracy_cost/scenes.py`);
"together" has the best setting of each at once, but those that lose the energy balance with others. "3 x" is the mean
of three runs: at the uncut thickness and at a third of a spacing more and less, so that the edge meets the rows of
particles at three places.

- Cutting force: component against the motion of the edge, feed force: away from the finished surface.
  {windows}
  Their scatter, drawn twice, is the standard error of six block means, or what repeats with a step a little
  shorter differ by, or what the three thicknesses of each spacing differ by beyond a line in the thickness (divided
  by the root of three for a mean of three), whichever is most; for means also what they leave about the fit over the
  spacing.
- Chip thickness: volume of the chip per width and length along the rake face, over half an uncut thickness h
  of that face, from where it is 1.1 h above the finished surface. Chip temperature: mean there.
- Reference: the limit of spacing 0 with the observed order (Richardson), from the points that differ in spacing
  only, means of three where they have run. Its uncertainty is twice the standard deviation of that limit when the
  points scatter by their own error or by what the fit leaves, whichever is more. A series that changes but shows no
  order between first (surfaces, contact) and second (the kernel sum) lies between the limits of these two, each with
  its error; one that does not change by more than
  its scatter is the mean of the finest three. It says nothing about settings that all points share.
- Errors carry their sign: two that cancel are luck, not accuracy. "For 5 %" asks that error and standard error
  together are within 5 %. Points whose energy residual exceeds {energy:.0f} % of the external work are drawn hollow and
  are neither advised nor on the front, which is of error and standard error together as well. For both, the error
  of a point with three thicknesses is that of their mean: where one run meets the rows is luck.
- `accuracy = "10 %"` in `[run]` of a deck reads this chart (`src/accuracy/chart.toml`, written with this page).
"""


def _number(value, digits=3):
    return "-" if value is None else f"{value:.{digits}g}"


def reference_lines(found):
    for quantity, reference in found.items():
        scale, unit = {"cutting_force": (1, "N"), "feed_force": (1, "N"), "chip_thickness": (1e6, "um")}.get(
            quantity, (1, "K"))
        yield (f"- {QUANTITIES[quantity]}: {scale * reference.value:.4g} +- {scale * reference.uncertainty:.2g} {unit} "
               f"({100 * reference.relative:.1f} %), {reference.said}")


def table(rows, found):
    names = [quantity for quantity in QUANTITIES if quantity in found]
    head = ["point", "core-s", *(QUANTITIES[name] for name in names), "energy residual", "M particle-steps", "F_c, N",
            "F_f, N", "h_c / h", "swept", "keys changed"]
    cells = []
    for row in sorted(rows, key=lambda one: (one["group"], one["core_seconds"] or 0)):
        ratio = row["chip_thickness"] / row["uncut_thickness"] if row.get("chip_thickness") else None
        said = decks.describe(row["changes"]) or "-"
        if row["status"] != "complete":
            said = f"**{row['status']}** {said}"
        steps = row["particle_steps"] / 1e6 if row.get("particle_steps") is not None else None
        cells.append([ranking.label_of(row), _number(row["core_seconds"]),
                      *(advise.percent(ranking.error_of(row, name, found)) for name in names),
                      advise.percent(row.get("energy_residual")), _number(steps),
                      *(f"{row[name]:.4g} +- {row[name + '_error']:.2g}" if row.get(name) is not None else "-"
                        for name in ("cutting_force", "feed_force")), _number(ratio), row["group"], said])
    return reports.table(head, cells)


SHARED = ("mass 1e2", "mass 1e3", "courant 0.5", "viscosity 0", "slice 6 dx", "slice 12 dx", "work 400 um",
          "sector from -4 deg", "cut 195 um", "band 80 um", "band +6 rows")


def shared_settings(scene, rows):
    """What settings closer to their limit do to the base: the reference, which shares the base's, does not say."""
    base = next((row for row in rows if row["group"] == "spacing" and row["spacing"] == scene.spacing), None)
    if not base:
        return None
    changes = []
    for row in rows:
        if row["label"] in SHARED:
            errors = (one["cutting_force_own_error"] for one in (row, base))
            scatter = sum(error**2 for error in errors)**0.5 / base["cutting_force"]
            changes.append(f"{row['label']} {advise.percent(row['cutting_force'] / base['cutting_force'] - 1)} "
                           f"(+- {200 * scatter:.1f})")
    return ("All points share what the reference therefore does not see. Cutting force against the base, with settings "
            f"closer to their limit: {', '.join(changes)}.") if changes else None


def stiffness_over_spacing(rows):
    """What the hourglass stiffness does to the force at each spacing: as an error of the method it has to vanish."""
    with_it = {row["spacing"]: row for row in rows if row["group"] == "spacing"}
    without = {row["spacing"]: row for row in rows
               if row["group"] == points.STIFFNESS_0 or row["label"] == "stiffness 0"}
    means = [{row["spacing"]: row for row in rows if row["group"] == MEAN_OF[group]}
             for group in ("spacing", points.STIFFNESS_0)]
    for spacing in set(means[0]) & set(means[1]):
        with_it[spacing], without[spacing] = means[0][spacing], means[1][spacing]
    both = sorted(set(with_it) & set(without), reverse=True)
    if len(both) < 2:
        return None
    said = []
    for spacing in both:
        ours, theirs = with_it[spacing], without[spacing]
        errors = (one["cutting_force_own_error"] for one in (ours, theirs))
        scatter = sum(error**2 for error in errors)**0.5 / theirs["cutting_force"]
        change = ours["cutting_force"] / theirs["cutting_force"] - 1
        said.append(f"{advise.percent(change)} (+- {200 * scatter:.1f}) at dx = {spacing:.3g} um")
    return f"What the default hourglass stiffness adds to the cutting force: {', '.join(said)}."


def hourglass_over_spacing(rows):
    """Work of the hourglass control is an error of the method: it should fall with the spacing."""
    series = sorted((row["spacing"], row["hourglass_share"]) for row in rows if row["group"] == "spacing")
    listed = ", ".join(f"{100 * share:.1f} % at {spacing:.3g} um" for spacing, share in reversed(series))
    stays = series[0][1] > 0.5 * series[-1][1]
    others = ", ".join(f"{row['label']} {100 * row['hourglass_share']:.1f} %" for row in rows
                       if row["group"] in ("hourglass stiffness", "correction", "smoothing length"))
    return (f"Of the external work the hourglass control takes {listed}"
            + (": it does not vanish with the spacing, so the reference shares it" if stays else "") + ". "
            + (f"With other settings: {others}." if others else ""))


def series_of(scene):
    return {point.label for point in points.points_of(scene) if point.group == "spacing" and not point.full}


def section(name, tried, rows, found):
    scene = SCENES[name]
    planned = {point.label for point in points.points_of(scene) if not point.full}
    missing = [point.label for point in points.points_of(scene) if point.label in planned - tried]
    complete = [row for row in rows if row.get("cutting_force") is not None and row["group"] not in ranking.ASIDE]
    failed = [row for row in rows if row["status"] != "complete" and row["group"] not in ranking.ASIDE]
    yield f"\n## {scene.title.capitalize()}\n"
    yield f"![Error of the cutting force against core-seconds](accuracy_cost_{name}.png)\n"
    if missing:
        yield f"Not finished: {len(missing)} of {len(planned)} points have not run: {', '.join(missing)}.\n"
    if series_of(scene) <= tried:
        yield advise.advice(complete, found) + " " + advise.front(scene, complete, found) + "\n"
    else:
        yield "The series of spacings is not whole, so there is no reference to conclude from.\n"
    yield advise.shipped(scene, complete, found) + "\n"
    if failed:
        yield f"{len(failed)} of {len(rows)} points did not end: " + ", ".join(row["label"] for row in failed) + ".\n"
    if combined := advise.combination(rows):
        yield combined + "\n"
    yield "Reference (errors in the table are relative to it):\n"
    yield "\n".join(reference_lines(found)) + "\n"
    if shared := shared_settings(scene, complete):
        yield shared + "\n"
    if stiffness := stiffness_over_spacing(complete):
        yield stiffness + "\n"
    yield hourglass_over_spacing(complete) + "\n"
    yield from table(rows, found)


def summary(name, tried, rows, found):
    """The reference, what to use, and what is shipped, in a few lines."""
    scene, reference = SCENES[name], found["cutting_force"]
    complete = [row for row in rows if row.get("cutting_force") is not None and row["group"] not in ranking.ASIDE]
    base = advise.base_of(scene, complete)
    advice = (advise.advice(complete, found) if series_of(scene) <= tried else
              "The series of spacings is not whole, so nothing is advised.")
    return (f"- **{scene.title.capitalize()}**: cutting force {reference.value:.3g} N, known to "
            f"{100 * reference.relative:.1f} %. {advice} The shipped settings: {base['core_seconds']:.3g} core-seconds, "
            f"{advise.percent(ranking.error_of(base, 'cutting_force', found))}.")


def lines(drawn, runs):
    yield HEAD
    yield from (summary(name, *one) for name, one in drawn.items())
    for name, (tried, rows, found) in drawn.items():
        yield from section(name, tried, rows, found)
        if name == physics.SCENE.name and any(row["group"] == physics.GROUP for row in runs):
            yield from physics_page.section(runs, advise.base_of(SCENES[name], rows), found)
    for scene in SCENES.values():
        if scene.name not in drawn:
            tried = sum(row["scene"] == scene.name for row in runs)
            planned = sum(not point.full for point in points.points_of(scene))
            yield f"\n## {scene.title.capitalize()}\n\n{tried} of {planned} points have run: too few to draw."
    orthogonal, milling = SCENES["orthogonal"], SCENES["milling"]
    windows = (f"Means over the last {100 * orthogonal.averaged:.0f} % of the orthogonal cut, and over immersion "
               f"{milling.immersion[0]:.0f} to {milling.immersion[1]:.0f} deg of the mill.")
    yield METHOD.format(windows=windows, energy=100 * ENERGY)
