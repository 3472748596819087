#!/usr/bin/env python3
"""Draws docs/reports/windows*.png, .svg and writes docs/reports/windows.md from results.json."""
import json
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "python"))
import numpy
from swarf import reports

from common import AHEAD, COLOURS, compare, percent, planar, ratio_of_means, ratio_text, save, smooth, stretches
import finer_page
import matplotlib.pyplot as plt
import scene_page

HERE = pathlib.Path(__file__).resolve().parent
MARKERS = "os"


def compared(windows):
    """The windows whose immersion the whole pass has reached."""
    return [one for one in windows["windows"] if "whole_planar" in one]


def differences(windows):
    return numpy.array([one["force_planar"] / one["whole_planar"] - 1 for one in compared(windows)])


def ratio_since_entry(windows, whole):
    """Mean over the windows of force / force of the whole pass there, by how far the tool has turned, with its
    standard error."""
    of_whole = dict(zip(whole["immersion"], planar(whole)))
    found = {}
    for one in compared(windows):
        for angle, force in zip(one["bins"]["immersion"], planar(one["bins"])):
            turned = round(angle - one["start"] - 0.5) + 0.5
            if angle in of_whole and of_whole[angle] > 0:
                found.setdefault(turned, []).append((force, of_whole[angle]))
    rows = []
    for turned in sorted(found):
        if len(found[turned]) > 2:
            rows.append((turned, *ratio_of_means(found[turned])))
    return numpy.array(rows)


def draw(found):
    figure, (curve, run_in) = plt.subplots(2, 1, figsize=(9, 8.5), height_ratios=(3, 2))
    bins = found["whole"]["bins"]
    width = int(found["windows"][0]["width"])
    force, angle = planar(bins), numpy.array(bins["immersion"])
    curve.plot(angle, force, color="0.75", linewidth=1, label="whole pass, means over 1°")
    components = [smooth(numpy.array(bins[name]), width)[0] for name in ("force_x", "force_y")]
    middles = smooth(angle, width)[0]
    curve.plot(middles, numpy.hypot(*components), color="black", linewidth=2, label=f"whole pass, means over {width}°")
    for name, style, what in (("frozen", "--", "its far part frozen"), ("retired", ":", "its spent chip retired as well")):
        if name in found:
            part = found[name]["bins"]
            curve.plot(smooth(numpy.array(part["immersion"]), width)[0],
                       numpy.hypot(*(smooth(numpy.array(part[axis]), width)[0] for axis in ("force_x", "force_y"))),
                       color="black", linewidth=1.2, linestyle=style, label=f"{what}, means over {width}°")
    for windows, colour, marker in zip(found["windows"], COLOURS, MARKERS):
        rows = windows["windows"]
        curve.errorbar([one["immersion"] for one in rows], [one["force_planar"] for one in rows],
                       yerr=[max(one["error_planar"], windows["scatter"]) for one in rows], color=colour, marker=marker, linestyle="none",
                       capsize=3, label=f"windows of {width}° after {windows['run_in']}° of run-in")
        ratio = ratio_since_entry(windows, bins)
        if len(ratio):
            run_in.errorbar(ratio[:, 0], ratio[:, 1], yerr=ratio[:, 2], color=colour, marker=marker, capsize=3,
                            label=f"windows with {windows['run_in']}° of run-in")
    curve.set(xlabel="immersion / deg", ylabel="planar force / N", ylim=(0, None))
    curve.legend(frameon=False)
    run_in.axhline(1, color="black", linewidth=1)
    run_in.set(xlabel="turned since the window's run began, just outside of the material / deg",
               ylabel="force, window / whole pass\n(of the means over the windows)")
    run_in.legend(frameon=False)
    save(figure, (curve, run_in), "windows")


def write_table(windows):
    head = ["immersion / deg", "windows / N", "standard error / N", "whole pass / N", "difference", "core-seconds"]
    rows = []
    for one in windows["windows"]:
        whole = one.get("whole_planar")
        rows.append([f"{one['immersion']:g}", f"{one['force_planar']:.3f}", f"{one['error_planar']:.3f}",
                     *((f"{whole:.3f}", percent(one["force_planar"] / whole - 1)) if whole else ("not reached", "")),
                     f"{one['core_seconds']:.0f}"])
    return reports.table(head, rows)


def summarize(windows, found):
    whole, rows = found["whole"], compared(windows)
    name = f"After {windows['run_in']} deg of run-in"
    lines = []
    if len(rows) > 2:
        difference = differences(windows)
        ratio, error = ratio_of_means([(one["force_planar"], one["whole_planar"]) for one in rows])
        own = numpy.mean([one["error_planar"] / one["force_planar"] for one in rows])
        lines.append(f"- {name}: the mean force of the {len(rows)} windows differs from the whole pass's at the same "
                     f"angles by {percent(ratio - 1)}, with a standard error of {100 * error:.1f} % from the scatter "
                     f"of the windows. Single windows differ by {100 * math.sqrt((difference ** 2).mean()):.0f} % "
                     f"(root mean square), the largest by {percent(difference[abs(difference).argmax()])}; their own "
                     f"standard errors, from inside of a measurement, are {100 * own:.0f} % on "
                     f"the mean, and too small, because the force swings over more than a measurement. The scatter between "
                     f"the {len(windows['windows'])} windows, which needs no whole pass and is what the bars show, is "
                     f"{100 * windows['scatter'] / numpy.mean([one['force_planar'] for one in windows['windows']]):.0f}"
                     f" % of their mean.")
    cost = f"- {name}: the {len(windows['windows'])} windows took {windows['core_seconds']:.0f} core-seconds"
    if "core_seconds" in whole:
        cost += (f", the whole pass {whole['core_seconds']:.0f}: {100 * windows['core_seconds'] / whole['core_seconds']:.1f}"
                 f" % of it. swarf predicted the whole pass at {windows['predicted_core_seconds']:.0f} from the windows")
    else:
        cost += f"; swarf predicts {windows['predicted_core_seconds']:.0f} for the whole pass"
    return lines + [cost + "."]


def whole_runs(found, first):
    """All that the windows have cut after `first` degrees of turning, against the whole pass at the same angles."""
    bins = found["whole"]["bins"]
    of_whole = dict(zip(bins["immersion"], planar(bins)))
    sums = []
    for windows in found["windows"]:
        for one in windows["windows"]:
            pairs = [(force, of_whole[angle]) for angle, force in zip(one["bins"]["immersion"], planar(one["bins"]))
                     if angle in of_whole and angle - one["start"] > first]
            if pairs:
                sums.append(numpy.sum(pairs, axis=0))
    if len(sums) < 3:
        return []
    ratio, error = ratio_of_means(sums)
    return [f"- All that the {len(sums)} windows of both sets have cut where the whole pass has been, {first} deg after "
            f"their start and later, run-in or not: the mean force differs by {percent(ratio - 1)}, standard error "
            f"{100 * error:.1f} %."]


def between(found):
    """How far two windows at the same place differ that begin at different places: both see the same pass."""
    first, second = ({one["immersion"]: one["force_planar"] for one in windows["windows"]}
                     for windows in found["windows"])
    common = sorted(set(first) & set(second))
    if len(common) < 3:
        return []
    ratios = numpy.array([second[angle] / first[angle] - 1 for angle in common])
    return [f"- The two sets of windows differ by {100 * math.sqrt((ratios ** 2).mean()):.0f} % in single windows "
            f"(root mean square) and by {percent(sum(second[a] for a in common) / sum(first[a] for a in common) - 1)} in "
            f"the mean: what the place of the entry alone changes."]


def write_probes(found):
    """What one window alone gives with one key changed."""
    lines = []
    for probe in found.get("probes", []):
        at = probe["immersion"]
        normal = next(one for one in found["windows"][0]["windows"] if one["immersion"] == at)
        whole = normal.get("whole_planar")
        if not whole:
            continue
        lines.append([probe["run_in"], probe["ahead"], f"{probe['force_planar']:.3f}",
                      percent(probe["force_planar"] / whole - 1), f"{probe['core_seconds']:.0f}"])
    if not lines:
        return []
    lines.insert(0, [found["windows"][0]["run_in"], AHEAD, f"{normal['force_planar']:.3f}",
                     percent(normal["force_planar"] / whole - 1), f"{normal['core_seconds']:.0f}"])
    head = ["run-in / deg", "ahead / deg", "planar force / N", "against the whole pass", "core-seconds"]
    return [f"## What makes the difference at {at:g} deg", "",
            "The same window with one key changed at a time: the material that goes on ahead of it, and the run-in.",
            *reports.table(head, lines)]


def write_cost(part, whole):
    if "end" in part:
        return f" It has run to {part['end']:.0f} deg so far, in {part['core_seconds']:.0f} core-seconds."
    if "core_seconds" not in whole:
        return ""
    return (f" It took {part['core_seconds']:.0f} core-seconds: {100 * part['core_seconds'] / whole['core_seconds']:.0f}"
            " % of the whole.")


def write_frozen(found):
    whole, lines = found["whole"], ["## The whole pass with its far part frozen", ""]
    for frozen in (found[name] for name in ("frozen", "frozen_nearer") if name in found):
        lines += [f"- `[sleep] distance = \"{frozen['distance']}\"`: {100 * frozen['active']:.0f} % of the particles were active on "
                  f"the mean, near the tooth that cuts, and at both ends of the pass near the other one."
                  f"{write_cost(frozen, whole)} {compare(frozen, whole)}; worst energy residual "
                  f"{100 * frozen['energy_residual']:.2f} % of the external work."]
    if "frozen_nearer" in found:
        lines += ["", f"The two against each other: {compare(found['frozen_nearer'], found['frozen'])}. If the border did this, "
                  "the nearer one would do more. Passes of this coarse slice scatter: the force swings over more than a "
                  "stretch, so that the standard errors are too small."]
    return lines + [""]


def write_origin(entry):
    """Of entries that are older than the rest of results.json."""
    return f" This is from {entry['from']}." if "from" in entry else ""


def write_retired(found):
    whole, part = found["whole"], found["retired"]
    left = part["retired"]
    lines = ["## The whole pass with its spent chip retired as well", "",
             f"`[retire] distance = \"{part['retire_distance']}\"`: {100 * part['active']:.0f} % of the particles were active on "
             f"the mean.{write_cost(part, whole)} {compare(part, whole)}; worst energy residual "
             f"{100 * part['energy_residual']:.2f} % of the external work.", "",
             f"{left['particles']} particles left. Had they flown on in a straight line, {left['met_since']} of them would have "
             f"met the tool or the work since, which the forces lack.{write_origin(part)}"]
    if "frozen" in found:
        lines += ["", f"Against the pass with only its far part frozen, at the same angles. {compare(part, found['frozen'])}."]
    return lines + [""]


def write_summary(found):
    """The answers, in a line each."""
    whole = found["whole"]

    def cost(core_seconds, whole):
        return f", for {100 * core_seconds / whole['core_seconds']:.0f} % of its core-seconds" if "core_seconds" in whole else ""
    for windows in found["windows"]:
        pairs = [(one["force_planar"], one["whole_planar"]) for one in compared(windows)]
        if len(pairs) > 2:
            yield (f"- Windows of {windows['width']} deg after {windows['run_in']} deg of run-in: mean force "
                   f"{ratio_text(pairs)} against the whole pass{cost(windows['core_seconds'], whole)}.")
    if "frozen" in found:
        yield (f"- The whole pass with its far part frozen: mean force {ratio_text(stretches(found['frozen'], whole))} "
               f"against the whole pass active{cost(found['frozen']['core_seconds'], whole)}.")
    if "finer" in found:
        finer = found["finer"]["whole"]
        fine = next(one for one in found["finer"]["windows"] if one["spacing"] == finer["spacing"])
        pairs = [(one["force_planar"], one["whole_planar"]) for one in fine["windows"] if "whole_planar" in one]
        yield (f"- In cells of {fine['spacing']:g} um: windows {ratio_text(pairs)} against the pass frozen"
               f"{cost(fine['core_seconds'], finer)}.")
    if {"scene", "scene_pass"} <= found.keys():
        rows = found["scene"]["rows"]
        pairs = [(row["force_planar"], row["whole_planar"]) for row in rows if "whole_planar" in row]
        yield (f"- The whole scene (`{found['scene']['deck']}`): {len(pairs)} windows {ratio_text(pairs)} against the "
               f"pass frozen{cost(sum(row['core_seconds'] for row in rows), found['scene_pass'])}.")


def write_page(found):
    whole = found["whole"]
    state = (f"{whole['particles']} particles, {whole['steps']} steps, {whole['core_seconds']:.0f} core-seconds"
             if "core_seconds" in whole else
             f"run to {whole['end']:.1f} deg so far: windows beyond that have nothing to be compared with")
    lines = ["# Windows against the whole pass", "",
             "Made by `bench/windows/run`; every number is from `bench/windows/results.json`.", "",
             *write_summary(found), "",
             f"The scene is `{found['deck']}`: a periodic slice, so without a helix, in cells of 4 um. The whole pass: "
             f"{state}.", "", "![Force over immersion, and what the run-in does](windows.png)", "",
             "The lower picture compares force by force at the same angle, whatever the window's measurement is: where "
             "it has settled, the run-in is long enough.", ""]
    for windows in found["windows"]:
        lines += summarize(windows, found)
    lines += whole_runs(found, 2) + between(found) + [""]
    for windows in found["windows"]:
        lines += [f"## Windows of {windows['width']} deg after {windows['run_in']} deg of run-in", "",
                  *write_table(windows), ""]
    lines += write_probes(found)
    lines += write_frozen(found) if "frozen" in found else []
    lines += write_retired(found) if "retired" in found else []
    lines += finer_page.write(found) if "finer" in found else []
    lines += scene_page.write(found) if "scene" in found else []
    reports.write("windows", lines)


def main():
    found = json.loads((HERE / "results.json").read_text())
    draw(found)
    if "finer" in found:
        finer_page.picture(found)
    if {"scene", "scene_pass"} <= found.keys():
        scene_page.picture(found)
    write_page(found)


if __name__ == "__main__":
    main()
