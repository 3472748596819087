"""docs/reports/roofline.png and .svg: every kernel under the ceilings of the machine, on one thread and on two."""
import matplotlib.pyplot as plt
import numpy
from matplotlib.ticker import FormatStrFormatter, LogLocator, NullFormatter
from swarf import labels, reports

OF_HEXES = ("hex_velocity_gradient", "hex_forces", "hex_heat", "gather_corner_forces", "couple_nodes", "delete_hexes",
            "freeze_hexes", "choose_hexes")
OFF = ("sum_density", "reference_gradient")  # of options that no deck here has: a crowd of labels


def draw_ceiling(axes, results, threads):
    flops, bytes_ = results.ceiling(threads)
    intensity = numpy.geomspace(*axes.get_xlim(), 200)
    axes.plot(intensity, numpy.minimum(flops, bytes_ * intensity) / 1e9, color="0.3", linewidth=1.2, zorder=1)
    axes.text(axes.get_xlim()[1] / 1.08, flops / 1e9 * 1.06, f"fused multiply-adds {flops / 1e9:.0f} GFLOP/s",
              ha="right", fontsize=7, color="0.3")
    left = axes.get_xlim()[0] * 1.15
    angle = axes.transData.transform([(1, 1), (10, 10)])
    angle = numpy.degrees(numpy.arctan2(*(angle[1] - angle[0])[::-1]))
    axes.text(left, bytes_ * left / 1e9 * 1.12, f"triad {bytes_ / 1e9:.0f} GB/s", rotation=angle,
              rotation_mode="anchor", fontsize=7, color="0.3")


def draw_kernels(figure, axes, results, size, threads):
    marks, clear = [], []
    for name in results.names(step=False):
        row = results.get(name, size, threads)
        if not row or not row["flops_per_item"] or name in OFF:
            continue
        x = row["flops_per_item"] / row["bytes_per_item"]
        y, lanes = (row[f"{kind}_per_item"] / results.seconds(row) / 1e9 for kind in ("flops", "lane_flops"))
        colour = "C0" if lanes > y else "C1" if name in OF_HEXES else "0.3"
        if lanes > y:
            axes.plot([x, x], [y, lanes], color=colour, linewidth=0.8, alpha=0.6, zorder=2)
            axes.plot(x, lanes, "o", color=colour, markersize=4, fillstyle="none", zorder=3)
            axes.annotate(name.replace("_", " "), (x, y), xytext=(2, -5), textcoords="offset points", fontsize=6.5,
                          rotation=-60, rotation_mode="anchor", va="center")  # side by side: these crowd
            clear += [(x, level) for level in numpy.geomspace(y, lanes, 6)]
        else:
            marks.append((x, y, name.replace("_", " ")))
        axes.plot(x, y, "o", color=colour, markersize=4, zorder=3)
    labels.place(figure, axes, marks, clear, size=6.5)


def draw(results, size):
    figure, panels = plt.subplots(1, 2, figsize=(11.7, 5.6), dpi=150, sharey=True, layout="constrained")
    top = results.ceiling(2)[0] / 1e9
    for axes, threads in zip(panels, (1, 2)):
        axes.set(xscale="log", yscale="log", xlim=(0.04, 90), ylim=(0.15, 2 * top),
                 xlabel="operations per byte of compulsory traffic")
        for axis in (axes.xaxis, axes.yaxis):
            axis.set_major_locator(LogLocator(subs=(1, 2, 5)))
            axis.set_major_formatter(FormatStrFormatter("%g"))
            axis.set_minor_formatter(NullFormatter())
        axes.grid(alpha=0.3, linewidth=0.4)
        cells = f"{size:,}".replace(",", " ")
        axes.set_title(f"{threads} thread{'s' if threads > 1 else ''}, {cells} particles or hexes, double", fontsize=9)
    panels[0].set_ylabel("GFLOP/s")
    figure.canvas.draw()
    figure.set_layout_engine("none")  # labels are placed in the frame as it is now
    for axes, threads in zip(panels, (1, 2)):
        draw_ceiling(axes, results, threads)
        draw_kernels(figure, axes, results, size, threads)
    panels[0].plot([], [], "o", color="C0", markersize=4, label="pair sums: pairs within the support")
    panels[0].plot([], [], "o", color="C0", markersize=4, fillstyle="none", label="... and all that the lanes compute")
    panels[0].plot([], [], "o", color="C1", markersize=4, label="hexes")
    panels[0].plot([], [], "o", color="0.3", markersize=4, label="points, one by one")
    panels[0].legend(loc="upper left", fontsize=7, framealpha=1)
    reports.save(figure, "roofline")
