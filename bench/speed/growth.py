"""docs/reports/growth.*: cost, gain of the second thread and memory against the number of particles or hexes."""
import matplotlib.pyplot as plt
from swarf import reports

import memory

TEXT = """
## Growth

![Cost and memory against size](growth.png)

Time of an item and step (of a core on 1 thread, by the clock on 2), the second thread's gain by the clock, and memory of
the scene "particles", against size; what was asked for is dashed. Sizes of a million and more: one round.
"""
LINES = [("step, particles", 64, "particles", "o", "C0"), ("step, particles", 32, "particles, float", "s", "C2"),
         ("step, hexes", 64, "hexes", "^", "C1")]


def series(results, name, bits, threads, value):
    sizes = [size for size in results.step_sizes(name) if results.get(name, size, threads, bits)]
    rows = [results.get(name, size, threads, bits) for size in sizes]
    return [row["items"] for row in rows], [value(row) for row in rows]


def draw_cost(axes, results):
    for name, bits, label, mark, colour in LINES:
        for threads, line in ((1, ":"), (2, "-")):
            x, y = series(results, name, bits, threads, lambda row: 1e9 * results.seconds(row))
            if not x:
                continue
            axes.plot(x, y, line, marker=mark, color=colour, markersize=4, linewidth=1.2,
                      fillstyle="full" if threads == 2 else "none",
                      label=f"{label}, {threads} thread{'s' if threads > 1 else ''}")
    for size, asked in ((1e5, 2.0), (1e6, 1.8), (4e6, 1.8)):
        axes.plot([size / 1.4, size * 1.4], [1e3 / asked] * 2, "--", color="C0", linewidth=0.9)
    axes.plot([123_840 / 1.4, 123_840 * 1.4], [1e3 / 3.0] * 2, "--", color="C1", linewidth=0.9)
    axes.set(ylabel="ns per item and step", title="cost")


def draw_gain(axes, results):
    for name, bits, label, mark, colour in LINES:
        x, one = series(results, name, bits, 1, lambda row: row)
        two = series(results, name, bits, 2, lambda row: row)[1]
        if not two:
            continue
        axes.plot(x[:len(two)], [results.ratio(*both) for both in zip(one, two)], "-", marker=mark, color=colour,
                  markersize=4, linewidth=1.2, label=label)
    axes.axhline(1.9, linestyle="--", color="0.3", linewidth=0.9)
    axes.set(ylabel="2 threads over 1", title="second thread")


def draw_memory(axes, results):
    rows = [row for row in (results.get("step, particles", size, 1) for size in results.step_sizes("step, particles"))
            if "bytes" in row]
    x = [row["items"] for row in rows]
    kinds = (("process, most", "v", "C3", lambda row: row["most_resident"]),
             ("Views", "o", "C0", lambda row: sum(row["bytes"].values())),
             ("Views without ghosts and tool", "D", "C4",
              lambda row: row["items"] * sum(one[1] for one in memory.views(row) if one[0] != "tool")))
    for label, mark, colour, value in kinds:
        axes.plot(x, [value(row) / row["items"] for row in rows], "-", marker=mark, color=colour, markersize=4,
                  linewidth=1.2, label=label)
    axes.axhline(600, linestyle="--", color="0.3", linewidth=0.9)
    axes.set(ylabel="bytes a particle", title="memory, double")


def draw(results):
    figure, panels = plt.subplots(1, 3, figsize=(11.7, 4.2), dpi=150, layout="constrained")
    for axes, paint in zip(panels, (draw_cost, draw_gain, draw_memory)):
        paint(axes, results)
        axes.set(xscale="log", xlabel="particles or hexes", ylim=(0, 1.3 * axes.get_ylim()[1]))  # room for the legend
        axes.grid(alpha=0.3, linewidth=0.4)
        axes.legend(fontsize=7, framealpha=1, ncols=2 if axes is panels[0] else 1)
    reports.save(figure, "growth")
