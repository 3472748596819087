"""The pictures of a study."""
import math

import matplotlib

matplotlib.use("Agg")  # without a screen
import matplotlib.pyplot as plt
import numpy

from .table import UNITS

BLUE, VERMILION, GREY = "#0072b2", "#d55e00", "#777777"  # Okabe & Ito 2008


def label(study):
    return f"{study.response.replace('_', ' ')} [{UNITS[study.response]}]"


def save(figure, path):
    figure.savefig(path, dpi=120, metadata={"Software": None})
    plt.close(figure)
    return path


def known(error):
    return 0 if math.isnan(error) else error


def draw_tornado(study, bars, base, path):
    figure, axes = plt.subplots(figsize=(8, 1.4 + 0.55 * len(bars)), layout="constrained")
    for k, bar in enumerate(reversed(bars)):
        for value, error, said, colour in ((bar.low, bar.low_error, bar.low_value, BLUE),
                                           (bar.high, bar.high_error, bar.high_value, VERMILION)):
            axes.barh(k, value - base, left=base, color=colour, height=0.6)
            axes.errorbar(value, k, xerr=known(error), color="black", capsize=3, linewidth=1)
            outward = 1 if value >= base else -1
            axes.annotate(f"{said}", (value + outward * known(error), k), xytext=(5 * outward, 0),
                          textcoords="offset points", va="center", ha="left" if outward > 0 else "right", fontsize=8)
    axes.axvline(base, color="black", linewidth=1)
    axes.set_yticks(range(len(bars)), [bar.parameter.name for bar in reversed(bars)])
    axes.margins(x=0.18)
    axes.set_xlabel(label(study))
    axes.set_title(f"{study.title}: each parameter from low to high")
    return save(figure, path)


def draw_main_effects(study, effects, path):
    figure, panels = plt.subplots(1, len(effects), figsize=(max(5, 2.8 * len(effects)), 3.4), layout="constrained",
                                  sharey=True, squeeze=False)
    for axes, parameter in zip(panels[0], study.parameters):
        levels = effects[parameter.name]
        x = ([parameter.number(value) for value, *_ in levels] if parameter.unit is not None else
             numpy.arange(len(levels)))
        y, errors = [one[1] for one in levels], [known(one[2]) for one in levels]
        axes.errorbar(x, y, yerr=errors, color=BLUE, marker="o", capsize=3)
        if parameter.unit is None:
            axes.set_xticks(x, [str(value) for value, *_ in levels])
        axes.set_xlabel(parameter.title)
    panels[0][0].set_ylabel(label(study))
    figure.suptitle(f"{study.title}: main effects")
    return save(figure, path)


def draw_surface(study, surface, bars, path):
    """Over the two parameters of most effect, the others in the middle; and how well it foretells points left out."""
    names = [bar.parameter.name for bar in bars[:2]]
    chosen = [next(k for k, one in enumerate(study.parameters) if one.name == name) for name in names]
    figure, panels = plt.subplots(1, 2, figsize=(11, 4.4), layout="constrained")
    at = numpy.linspace(0, 1, 41)
    if len(chosen) == 2:
        grid = numpy.full((len(at)**2, len(study.parameters)), 0.5)
        grid[:, chosen[0]], grid[:, chosen[1]] = (one.ravel() for one in numpy.meshgrid(at, at))
        first, second = (study.parameters[k] for k in chosen)
        x, y = (one.low + at * (one.high - one.low) for one in (first, second))
        drawn = panels[0].contourf(x, y, surface.predict(grid)[0].reshape(len(at), len(at)), 14, cmap="viridis")
        figure.colorbar(drawn, label=label(study))
        points = [[one.low + share * (one.high - one.low) for share in surface.x[:, k]]
                  for one, k in ((first, chosen[0]), (second, chosen[1]))]
        panels[0].plot(*points, "o", color="white", markeredgecolor="black", markersize=5)
        panels[0].set(xlabel=first.title, ylabel=second.title, title=f"{surface.model.name}, others in the middle")
    else:
        one = study.parameters[chosen[0]]
        value, error = surface.predict(at[:, None])
        x = one.low + at * (one.high - one.low)
        panels[0].plot(x, value, color=BLUE)
        panels[0].fill_between(x, value - error, value + error, color=BLUE, alpha=0.2)
        panels[0].plot(one.low + surface.x[:, 0] * (one.high - one.low), surface.y, "o", color="black")
        panels[0].set(xlabel=one.title, ylabel=label(study), title=surface.model.name)
    ends = [min(surface.y.min(), surface.left_out.min()), max(surface.y.max(), surface.left_out.max())]
    panels[1].plot(ends, ends, color=GREY, linewidth=1)
    panels[1].plot(surface.y, surface.left_out, "o", color=VERMILION)
    panels[1].set(xlabel=f"run: {label(study)}", ylabel="surface of the other runs",
                  title=f"points left out: off by {surface.error:.3g} {UNITS[study.response]}")
    return save(figure, path)
