#!/usr/bin/env python3
"""Draws accuracy against cost from results.csv: a picture of each scene, PNG and SVG,
docs/reports/accuracy_cost.md, and src/accuracy/chart.toml for the key run.accuracy."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "python"))
import matplotlib.pyplot as plt
import numpy
from matplotlib.ticker import FormatStrFormatter, LogLocator, NullFormatter

from swarf import labels, reports

import page
import physics
import ranking
import results
import transfer
from points import MEAN_OF
from reference import ENERGY, combine, references, widen
from scenes import SCENES

HERE = pathlib.Path(__file__).resolve().parent
MARKERS = "osD^v<>pPXhd*"
FLOOR = 0.1  # of the band's height: a smaller error is drawn here


def set_axes(axes, rows, errors, reference):
    """Returns the least error that the axes show; smaller ones are drawn there."""
    known = 100 * reference.relative
    bottom = max(1e-2, min(FLOOR * known if known > 0 else 1e-2, 0.5 * max(errors.values())))
    costs = [row["core_seconds"] for row in rows]
    axes.set(xscale="log", yscale="log", ylim=(bottom, 2 * max([*errors.values(), known])),
             xlim=(min(costs) / 1.6, max(costs) * 1.8), xlabel="cost, core-seconds",
             ylabel=f"error of the cutting force against {reference.value:.3g} N, %")
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(LogLocator(subs=(1, 2, 5)))
        axis.set_major_formatter(FormatStrFormatter("%g"))
        axis.set_minor_formatter(NullFormatter())
    axes.grid(alpha=0.3, linewidth=0.4)
    axes.axhspan(bottom, known, color="0.92", zorder=0)
    axes.text(0.995, known, "uncertainty of the reference (2 sigma) ", transform=axes.get_yaxis_transform(),
              ha="right", va="top", fontsize=7, color="0.35")
    return bottom


def draw_front(axes, rows, found, bottom):
    """Returns points along the line, for labels to keep clear of."""
    costs = [row["core_seconds"] for row in rows]
    levels = [max(100 * ranking.level_of(row, found), bottom) for row in rows]
    costs.append(axes.get_xlim()[1])
    levels.append(levels[-1])
    axes.step(costs, levels, where="post", color="C3", linewidth=1.2, zorder=1,
              label="Pareto front (error + standard error)")
    corners = [point for k in range(len(rows)) for point in
               ((costs[k], levels[k]), (costs[k + 1], levels[k]), (costs[k + 1], levels[k + 1]))]
    return [(x, y) for (x0, y0), (x1, y1) in zip(corners, corners[1:])
            for x, y in zip(numpy.geomspace(x0, x1, 40), numpy.geomspace(y0, y1, 40))]


def draw_cost(axes, figure, scene, rows, found):
    reference = found["cutting_force"]
    errors = {row["label"]: 100 * abs(ranking.error_of(row, "cutting_force", found)) for row in rows}
    bottom = set_axes(axes, rows, errors, reference)
    figure.canvas.draw()
    figure.set_layout_engine("none")  # labels are placed in the frame as it is now
    best = ranking.front_of(rows, found)
    line = draw_front(axes, best, found, bottom)
    groups = list(dict.fromkeys(row["group"] for row in rows))
    marks = []
    for row in rows:
        x, y = row["core_seconds"], max(errors[row["label"]], 1.05 * bottom)
        marks.append((x, y, ranking.label_of(row)))
        scatter = 200 * (row["cutting_force_error"] or 0) / abs(reference.value)
        axes.plot([x, x], [max(y - scatter, bottom), y + scatter], color="0.8", linewidth=0.8, zorder=2)
        axes.plot(x, y, MARKERS[groups.index(row["group"]) % len(MARKERS)], color="C3" if row in best else "0.25",
                  markersize=4, zorder=4, fillstyle="full" if abs(row["energy_residual"]) <= ENERGY else "none")
        if row["group"] == "committed deck":
            axes.plot(x, y, "*", color="C0", markersize=13, zorder=3, label="shipped deck, whole")
        elif row["group"] == "spacing" and row["spacing"] == scene.spacing:
            axes.plot(x, y, "o", color="C0", markersize=10, fillstyle="none", zorder=3,
                      label="shipped settings: base of the changes one at a time")
    axes.legend(loc="upper right", fontsize=7, framealpha=1)
    labels.place(figure, axes, marks, line)


def draw_convergence(axes, reference):
    spacing, values, error = reference.series
    axes.errorbar(spacing, values, 2 * error, fmt="o", color="0.25", markersize=4, capsize=2, linewidth=0.8)
    line = numpy.linspace(0, max(spacing), 100)
    for limit, slope, order in reference.curves:
        axes.plot(line, limit + slope * line**order, color="C3", linewidth=1)
    axes.axhspan(reference.value - reference.uncertainty, reference.value + reference.uncertainty, color="0.9")
    axes.axhline(reference.value, color="0.5", linewidth=0.8, linestyle="--")
    axes.set(xlabel="spacing dx, um", ylabel="cutting force, N", xlim=(0, None))
    axes.set_title(f"{reference.value:.3g} +- {reference.uncertainty:.2g} N,\n{reference.said}", fontsize=8)
    axes.grid(alpha=0.3, linewidth=0.4)


def draw(scene, rows, found):
    figure, (left, right) = plt.subplots(1, 2, figsize=(11.7, 8.3), dpi=150, width_ratios=(2.6, 1),
                                         layout="constrained")
    complete = [row for row in rows if row.get("cutting_force") is not None and row["group"] not in ranking.ASIDE]
    note = "3 x: mean of three uncut thicknesses" if any(row["group"] in MEAN_OF.values() for row in rows) else ""
    figure.suptitle(f"Accuracy against cost: {scene.title}", fontsize=11)
    left.set_title(note, fontsize=8)
    draw_convergence(right, found["cutting_force"])
    failed = [row["label"] for row in rows if row["status"] != "complete" and row["group"] not in ranking.ASIDE]
    if failed:
        figure.supxlabel("did not end: " + ", ".join(failed), fontsize=7)
    draw_cost(left, figure, scene, complete, found)
    reports.save(figure, f"accuracy_cost_{scene.name}")


def main():
    rows = results.read(HERE / "results.csv")
    drawn = {}
    for scene in SCENES.values():
        runs = [row for row in rows if row["scene"] == scene.name and row["group"] != physics.GROUP]
        ours, scatter = combine(runs, scene.spacing)
        found = references(ours)
        if "cutting_force" not in found:
            print(f"{scene.name}: not enough points yet", file=sys.stderr)
            continue
        widen(ours, found, scatter)
        draw(scene, ours, found)
        drawn[scene.name] = ({row["label"] for row in runs}, ours, found)
    if drawn:
        reports.write("accuracy_cost", page.lines(drawn, rows))
        (reports.ROOT / "src/accuracy/chart.toml").write_text(transfer.text(drawn, SCENES, reports.ROOT))


if __name__ == "__main__":
    main()
