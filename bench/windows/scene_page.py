"""The section of docs/reports/windows.md on the whole scene, and its picture."""
import numpy
from swarf import reports

from common import COLOURS, compare, percent, ratio_of_means, save, smooth
import matplotlib.pyplot as plt

CORES = 2


def hours(core_seconds):
    return f"{core_seconds / CORES / 3600:.2f} h"


def picture(found):
    whole, windows = found["scene_pass"], found["scene"]
    width = windows["width"]  # deg, of the mean that is drawn
    figure, axes = plt.subplots(figsize=(9, 5))
    for name, what, colour in (("bins", "both teeth", "0.6"), ("cutting", "the tooth that cuts", "black")):
        bins = whole[name]
        angle = smooth(numpy.array(bins["immersion"]), width)[0]
        components = [smooth(numpy.array(bins[axis]), width)[0] for axis in ("force_x", "force_y")]
        axes.plot(angle, numpy.hypot(*components), color=colour, linewidth=2, label=f"whole pass, {what}, means over {width}°")
    for values, axis, style in zip(components, "xy", ("--", ":")):
        axes.plot(angle, values, color="black", linewidth=1, linestyle=style, label=f"{axis}, the tooth that cuts")
    rows = windows["rows"]
    axes.errorbar([row["immersion"] for row in rows], [row["force_planar"] for row in rows],
                  yerr=[row["error_planar"] for row in rows], color=COLOURS[0], marker="o", linestyle="none", capsize=3,
                  label=f"windows of {windows['width']}° after {windows['run_in']}° of run-in")
    axes.axhline(0, color="black", linewidth=0.8)
    axes.set(xlabel="immersion / deg", ylabel="planar force / N")
    axes.legend(frameon=False, fontsize=8)
    save(figure, (axes,), "windows_scene")


def describe_before(whole, before):
    return (f"- commit {before['commit']}, `distance = \"{before['distance']}\"`, `courant = {before['courant']}`, "
            f"{before['steps']} steps in {before['core_seconds']:.0f} core-seconds of an {before['machine']}: "
            f"{compare(whole, before, 'cutting')}.")


def write_pass(found):
    whole = found["scene_pass"]
    to = f"It has run to {whole['end']:.0f} deg so far" if "end" in whole else "It ran from the entry to the exit"
    lines = ["![Force of the whole scene over immersion](windows_scene.png)", "",
             "![The chip of the whole scene at five angles, coloured by temperature](../chip_scene.png)", "",
             f"The whole pass, with `[sleep] distance = \"{whole['distance']}\"` and `courant = {whole['courant']}`: {whole['particles']} "
             f"particles and {whole['hexes']} hexes, of the particles {100 * whole['active']:.1f} % active on the mean. {to}: "
             f"{whole['steps']} steps, {whole['core_seconds']:.0f} core-seconds ({whole['wall_seconds'] / 3600:.2f} h on "
             f"{' and '.join(map(str, whole['threads']))} threads of an {whole['machine']}; {hours(whole['core_seconds'])} if two cores shared it evenly), "
             f"{whole['peak_memory_bytes'] / 2**20:.0f} MiB, worst energy residual {100 * whole['energy_residual']:.2f} % of the "
             f"external work, {whole['leaked_particles']} leaked particles. The same pass without freezing has not been run.", ""]
    if "scene_passes_before" in found:
        lines += ["How far passes of this scene are apart: it has run before, with other round-off, and as said. This pass against "
                  "those:", ""]
        lines += [describe_before(whole, before) for before in found["scene_passes_before"]] + [""]
    if "scene_pass_failed" in found:
        failed = found["scene_pass_failed"]
        lines += [f"With `courant = {failed['courant']}` instead of {whole['courant']} (commit {failed['commit']}) swarf stopped it at "
                  f"{failed['end']:.0f} deg, step {failed['step']}: \"{failed['said']}\". It made energy from {failed['from']} deg on: "
                  f"{100 * failed['energy_residual']:.1f} % of the external work at the end.", ""]
    rows = [row for row in found["scene"]["rows"] if "whole_planar" in row]
    if len(rows) > 2:
        ratio, error = ratio_of_means([(row["force_planar"], row["whole_planar"]) for row in rows])
        lines += [f"The mean force of the {len(rows)} windows that it has passed differs from that of its cutting tooth by "
                  f"{percent(ratio - 1)}, standard error {100 * error:.1f} % from the scatter of the windows. By the helix "
                  "the tooth before leaves until 187 deg while this one enters, and its force is against the other's: a "
                  "window, which has one tooth's work, lacks it below 12 deg. The windows ran at `courant = "
                  f"{found['scene']['courant']}`.", ""]
    return lines


def write_probes(found):
    """How the force of a window comes down to that of the pass as it turns on: what the run-in is for."""
    probes = sorted(found["scene_probes"], key=lambda one: one["run_in"])
    at, width = probes[0]["immersion"], found["scene"]["width"]
    whole = found["scene_pass"]["cutting"]

    def force(bins, middle):
        inside = [k for k, angle in enumerate(bins["immersion"]) if abs(angle - middle) < 0.5 * width]
        if len(inside) < width - 1:
            return None
        return numpy.hypot(*(numpy.mean([bins[axis][k] for k in inside]) for axis in ("force_x", "force_y")))

    middles = [angle for angle in numpy.arange(at, 0, -width)[::-1] if force(probes[-1]["bins"], angle)]
    lines = [f"### What the run-in does, at {at:g} deg", "",
             f"The same window with its far part frozen as well (`[sleep] distance = \"{probes[0]['distance']}\"`), "
             f"after short and long run-in, in means over {width} deg while it turns, against the cutting tooth of the whole pass:"]
    head = ["immersion / deg", "whole pass / N"]
    for one in probes:
        head += [f"run-in {one['run_in']} deg / N", "difference"]
    rows = []
    for angle in middles:
        reference = force(whole, angle)
        rows.append([f"{angle:g}", f"{reference:.2f}"])
        for one in probes:
            value = force(one["bins"], angle)
            rows[-1] += [f"{value:.2f}", percent(value / reference - 1)] if value else ["", ""]
    costs = " and ".join(f"{one['core_seconds']:.0f}" for one in probes)
    return [*lines, *reports.table(head, rows), f"They took {costs} core-seconds.", ""]


def write_change(found, title, text, name, reference):
    """What a setting alone does to the windows: they have the same run-in with it and without."""
    with_it, without = ({row["immersion"]: row for row in found[one]["rows"]} for one in (name, reference))
    both = sorted(with_it.keys() & without.keys())
    ratio, error = ratio_of_means([(with_it[at]["force_planar"], without[at]["force_planar"]) for at in both])
    costs = [sum(rows[at]["core_seconds"] for at in both) for rows in (with_it, without)]
    lines = [f"### {title}", "",
             f"{text}: the mean force of the {len(both)} differs by {percent(ratio - 1)}, standard error {100 * error:.1f} % from "
             f"their scatter, for {costs[0]:.0f} core-seconds instead of {costs[1]:.0f}."]
    head = ["immersion / deg", "with it / N", "standard error / N", "without / N", "difference", "core-seconds", "without"]
    rows = []
    for at in both:
        one, other = with_it[at], without[at]
        rows.append([f"{at:g}", f"{one['force_planar']:.2f}", f"{one['error_planar']:.2f}", f"{other['force_planar']:.2f}",
                     percent(one["force_planar"] / other["force_planar"] - 1), f"{one['core_seconds']:.0f}",
                     f"{other['core_seconds']:.0f}"])
    return [*lines, *reports.table(head, rows)]


def write_changes(found):
    lines = []
    if "scene_frozen" in found:
        lines += write_change(found, "What freezing does", "The same windows with their far part frozen (`[sleep] distance = "
                              f"\"{found['scene_frozen']['distance']}\"`)", "scene_frozen", "scene")
    if "scene_mass" in found:
        mass = found["scene_mass"]
        lines += write_change(found, "What more mass does",
                              f"The windows frozen under `mass_factor = {mass['mass_factor']:g}`, twice the deck's, against them under "
                              f"the deck's (run on an {mass['machine']}, those without it on an {found['scene_frozen']['machine']})",
                              "scene_mass", "scene_frozen")
    return lines


def write(found):
    scene = found["scene"]
    rows = scene["rows"]
    if not rows:
        return []
    core_seconds = sum(row["core_seconds"] for row in rows) / len(rows)
    count = (scene["last"] - scene["first"]) // scene["step"] + 1
    lines = ["## The whole scene", "",
             f"`{scene['deck']}` at full resolution, with its helix and the full depth of cut. Windows of "
             f"{scene['width']} deg after {scene['run_in']} deg of run-in took {core_seconds:.0f} core-seconds each on the "
             f"mean: {count} take {hours(count * core_seconds)} on two cores that do nothing else. From them swarf predicts "
             f"{hours(scene['predicted_core_seconds'])} for the whole pass without freezing.", ""]
    lines += write_pass(found) if "scene_pass" in found else []
    head = ["immersion / deg", "uncut chip at the end face / um", "planar / N", "standard error / N",
            "whole pass, same tooth / N", "difference", "F_x / N", "F_y / N", "F_z / N", "particles", "hexes", "steps",
            "core-seconds", "memory / MiB", "energy residual", "leaked"]
    table = []
    for row in rows:
        whole = row.get("whole_planar")
        table.append([f"{row['immersion']:g}", f"{1e6 * row['uncut_chip']:.2f}", f"{row['force_planar']:.2f}",
                      f"{row['error_planar']:.2f}",
                      *((f"{whole:.2f}", percent(row["force_planar"] / whole - 1)) if whole else ("not reached", "")),
                      *(f"{row[axis]:.2f}" for axis in ("force_x", "force_y", "force_z")),
                      *(row[name] for name in ("particles", "hexes", "steps")), f"{row['core_seconds']:.0f}",
                      f"{row['peak_memory_bytes'] / 2**20:.0f}", f"{100 * row['energy_residual']:.2f} %",
                      row["leaked_particles"]])
    lines += reports.table(head, table)
    lines += write_changes(found)
    return lines + (write_probes(found) if {"scene_probes", "scene_pass"} <= found.keys() else [])
