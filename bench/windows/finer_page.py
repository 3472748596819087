"""The section of docs/reports/windows.md on smaller cells, and its picture."""
import numpy
from swarf import reports

from common import COLOURS, RUN_INS, SPACING, percent, ratio_of_means, save, smooth
import matplotlib.pyplot as plt

FIRST, LAST = 150, 170  # deg, where the windows in large cells miss most


def at(windows, immersion):
    return next(one for one in windows["windows"] if round(one["immersion"]) == immersion)


def coarse(found):
    """The windows in the cells of the committed deck, with the same run-in."""
    return {"spacing": SPACING, **next(one for one in found["windows"] if one["run_in"] == RUN_INS[-1])}


def picture(found):
    entry = found["finer"]
    fine = next(one for one in entry["windows"] if one["spacing"] == entry["whole"]["spacing"])
    figure, axes = plt.subplots(figsize=(9, 5))
    bins = entry["whole"]["bins"]
    middles, _ = smooth(numpy.array(bins["immersion"]), 6)
    components = [smooth(numpy.array(bins[name]), 6)[0] for name in ("force_x", "force_y")]
    axes.plot(middles, numpy.hypot(*components), color="black", linewidth=2,
              label=f"whole pass in cells of {fine['spacing']:g} um, means over 6°")
    axes.errorbar([one["immersion"] for one in fine["windows"]], [one["force_planar"] for one in fine["windows"]],
                  yerr=fine["scatter"], color=COLOURS[0], marker="o", linestyle="none", capsize=3,
                  label=f"windows in cells of {fine['spacing']:g} um")
    for windows, marker in ((coarse(found), "v"), (entry["windows"][0], "s")):
        axes.plot([FIRST, LAST], [at(windows, angle)["force_planar"] for angle in (FIRST, LAST)], marker, color=COLOURS[1],
                  fillstyle="none", label=f"windows in cells of {windows['spacing']:g} um")
    axes.set(xlabel="immersion / deg", ylabel="planar force / N", ylim=(0, None))
    axes.legend(frameon=False, loc="lower center")
    save(figure, (axes,), "windows_finer")


def share(row):
    return percent(row["force_planar"] / row["whole_planar"] - 1) if "whole_planar" in row else "-"


def write(found):
    entry = found["finer"]
    whole = entry["whole"]
    fine = next(one for one in entry["windows"] if one["spacing"] == whole["spacing"])
    state = (f"{whole['particles']} particles, {whole['steps']} steps, {whole['core_seconds']:.0f} core-seconds, worst energy "
             f"residual {100 * whole['energy_residual']:.2f} % of the external work" if "core_seconds" in whole else
             f"run to {whole['end']:.1f} deg so far")
    lines = ["## In smaller cells", "", "![Force over immersion in smaller cells](windows_finer.png)", "",
             "Where the chip is thin the windows in large cells miss most. Is it the chip that the whole pass brings along, "
             "or a lattice that puts hardly more than one particle across what is cut? The same windows (6 deg after 5 deg of "
             f"run-in, Courant number {fine['courant']:g}) in smaller cells:" + (f" They are from {entry['from']}." if "from" in entry else "")]
    head = ["cells / um"]
    for angle in (FIRST, LAST):
        head += [f"uncut chip at {angle} deg, cells", f"force at {angle} deg / N"]
    rows = []
    for windows in (coarse(found), *entry["windows"]):
        rows.append([f"{windows['spacing']:g}"])
        for angle in (FIRST, LAST):
            chip = at(entry["windows"][0], angle)["uncut_chip"] * 1e6
            rows[-1] += [f"{chip / windows['spacing']:.1f}", f"{at(windows, angle)['force_planar']:.2f}"]
    lines += reports.table(head, rows)
    rows = [one for one in fine["windows"] if "whole_planar" in one]
    ratio, error = ratio_of_means([(one["force_planar"], one["whole_planar"]) for one in rows])
    cost = ""
    if "core_seconds" in whole:
        cost = (f" The windows took {fine['core_seconds']:.0f} core-seconds: "
                f"{100 * fine['core_seconds'] / whole['core_seconds']:.0f} % of that pass, which freezes its far part.")
    lines += [f"Against the whole pass in cells of {whole['spacing']:g} um, its far part frozen ({state}): mean force "
              f"{percent(ratio - 1)}, standard error {100 * error:.1f} % from the scatter of "
              f"{len(rows)} windows.{cost}"]
    head = ["immersion / deg", "uncut chip, cells", "window / N", "whole pass / N", "difference", "core-seconds"]
    table = []
    for one in fine["windows"]:
        known = f"{one['whole_planar']:.2f}" if "whole_planar" in one else "not reached"
        table.append([f"{one['immersion']:g}", f"{1e6 * one['uncut_chip'] / fine['spacing']:.1f}",
                      f"{one['force_planar']:.2f}", known, share(one), f"{one['core_seconds']:.0f}"])
    return [*lines, *reports.table(head, table)]
