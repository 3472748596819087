"""The charts of a page, as its script draws them."""
import numpy

from .. import results

BLUE, VERMILION, GREEN, ORANGE, PURPLE, BLACK, GREY = ("#0072b2", "#d55e00", "#009e73", "#e69f00", "#cc79a7", "#141414",
                                                       "#9aa3ad")  # Okabe & Ito 2008
MOST = 4000  # samples of a curve; of longer ones every so many


def short(values):
    return [None if not numpy.isfinite(value) else float(f"{value:.6g}") for value in values]


def curve(label, values, colour, width=2, **more):
    return {"label": label, "values": short(values), "colour": colour, "width": width, **more}


def axis_of(table, every):
    """Immersion where the run has one, else time."""
    angle = table.get("immersion", numpy.zeros(1))
    if angle.max() > angle.min():
        return "Immersion angle [deg]", angle[::every]
    return "Time [ms]", 1e3 * table["time"][::every]


def chart(name, title, x, y_title, curves, levels=(), summary=""):
    title_x, values = x
    for label, level in levels:
        curves.append(curve(label, numpy.full(len(values), level), GREY, 1.5, dash=[8, 6]))
    numbers = [value for one in curves if one.get("show", True) and one["width"] > 1 for value in one["values"]
               if value is not None]
    low, high = min([0, *numbers]), max([0, *numbers])
    air = 0.06 * ((high - low) or 1)
    return {"id": name, "title": title, "x": {"title": title_x, "values": short(values)},
            "y": {"title": y_title, "range": [low - air if low < 0 else 0, high + air]}, "curves": curves,
            "summary": f"{title}. {summary} The data can be downloaded as csv below."}


def filtered_of(run):
    if (run.folder / "results.h5").exists():
        return run.filtered
    return run.history  # of a run that goes on


def model_of(run, x):
    """The mechanistic model's planar resultant at these immersions, or None."""
    path = run.folder / "mechanistic.csv"
    if not path.exists() or not x[0].startswith("Immersion"):
        return None
    model = results.read_table(path)
    return numpy.interp(x[1], model["immersion"], model["force_planar"], left=numpy.nan, right=numpy.nan)


def published_of(run):
    from ..units import si
    return [(f"{one['label']}, {si(one['force']):.4g} N", si(one["force"]))
            for one in run.deck.get("output", {}).get("published", [])]


def force_chart(run, name):
    history, filtered = run.history, filtered_of(run)
    every = -(-len(history["time"]) // MOST)
    x = axis_of(history, every)
    curves = [curve("unfiltered resultant", history["force_planar"][::every], "#b8bec6", 1),
              curve("F_x", filtered["force_x"][::every], BLUE), curve("F_y", filtered["force_y"][::every], VERMILION),
              curve("F_z", filtered["force_z"][::every], GREEN),
              curve("planar resultant", filtered["force_planar"][::every], BLACK, 3)]
    model = model_of(run, x)
    if model is not None:
        curves.append(curve("mechanistic model", model, PURPLE, 2.5, dash=[3, 4]))
    peak = filtered["force_planar"]
    return chart(f"{name}-force", "Force on the tool", x, "Force [N]", curves, published_of(run),
                 f"The filtered planar resultant has its peak of {peak.max():.3g} N at {x[0].split(' [')[0].lower()} "
                 f"{axis_of(filtered, 1)[1][int(peak.argmax())]:.4g}.")


def energy_chart(run, name):
    history = run.history
    every = -(-len(history["time"]) // MOST)
    terms = [("external_work", BLACK), ("plastic_work", VERMILION), ("friction_work", ORANGE), ("elastic_energy", BLUE),
             ("kinetic_energy", "#56b4e9"), ("viscous_work", GREEN), ("hourglass_work", PURPLE),
             ("contact_energy", GREY), ("energy_residual", "#000000")]
    curves = [curve(name_.replace("_", " "), 1e6 * history[name_][::every], colour, 3 if name_ == "external_work" else 2,
                    **({"dash": [8, 6]} if name_ == "energy_residual" else {}))
              for name_, colour in terms if name_ in history and numpy.abs(history[name_]).max() > 0]
    return chart(f"{name}-energy", "Energy", axis_of(history, every), "Energy [uJ]", curves,
                 summary=f"External work at the end {1e6 * history['external_work'][-1]:.4g} uJ.")


def heat_chart(run, name):
    history = run.history
    every = -(-len(history["time"]) // MOST)
    terms = [("plastic_heat", VERMILION), ("friction_work", ORANGE), ("work_heat", BLUE), ("tool_heat", GREEN),
             ("heat_out", PURPLE), ("heat_residual", "#000000")]
    curves = [curve(name_.replace("_", " "), 1e6 * history[name_][::every], colour)
              for name_, colour in terms if name_ in history and numpy.abs(history[name_]).max() > 0]
    return curves and chart(f"{name}-heat", "Heat made, stored and gone", axis_of(history, every), "Heat [uJ]", curves)


def temperature_chart(run, name):
    history = run.history
    every = -(-len(history["time"]) // MOST)
    curves = [curve("hottest of the work", history["max_temperature"][::every], VERMILION)]
    if "tool_max_temperature" in history and history["tool_max_temperature"].max() > 0:
        curves.append(curve("hottest of the tool", history["tool_max_temperature"][::every], BLUE))
    return chart(f"{name}-temperature", "Largest temperatures", axis_of(history, every), "Temperature [K]", curves,
                 summary=f"The hottest point reaches {history['max_temperature'].max():.4g} K.")


def compare_chart(runs, names):
    """Filtered planar resultants of several runs over one axis."""
    axes = [axis_of(filtered_of(run), 1) for run in runs]
    titles = {title for title, _ in axes}
    if len(titles) > 1:
        return None
    ends = [(values.min(), values.max()) for _, values in axes]
    at = numpy.linspace(min(low for low, _ in ends), max(high for _, high in ends), 1500)
    wheel = [BLACK, BLUE, VERMILION, GREEN, ORANGE, PURPLE, "#56b4e9", GREY]
    curves = [curve(name, numpy.interp(at, x[1], filtered_of(run)["force_planar"], left=numpy.nan, right=numpy.nan),
                    wheel[k % len(wheel)], 2.5, **({"dash": [8, 4]} if k >= len(wheel) else {}))
              for k, (run, name, x) in enumerate(zip(runs, names, axes))]
    return chart("compare-force", "Planar resultant of all runs, filtered", (titles.pop(), at), "Force [N]", curves,
                 published_of(runs[0]))


def windows_chart(run, name):
    table = run.window_forces
    curves = [curve("F_x", table["force_x"], BLUE), curve("F_y", table["force_y"], VERMILION),
              curve("F_z", table["force_z"], GREEN), curve("planar resultant", table["force_planar"], BLACK, 3),
              curve("one standard error above", table["force_planar"] + table["error_planar"], GREY, 1.2, dash=[2, 3]),
              curve("one standard error below", table["force_planar"] - table["error_planar"], GREY, 1.2, dash=[2, 3])]
    return chart(f"{name}-windows", "Mean force of each window", ("Immersion angle [deg]", table["immersion"]), "Force [N]",
                 curves, published_of_windows(run))


def published_of_windows(run):
    from .. import decks
    from ..units import si
    deck = decks.read(run.folder / "windows.toml")
    return [(one["label"], si(one["force"])) for one in deck.get("output", {}).get("published", [])]
