#!/usr/bin/env python3
"""Runs a pass as a whole, with its far part asleep, with its spent chip retired as well, and as windows, and compares
their forces: results.json beside this file. What it holds of runs that are not here stays.

usage: measure.py PROGRAM [--scene] [--only NAME] [--no-run]
--scene: runs the whole scene too, hours: its windows, and its pass with the far part asleep on all cores
--only NAME: runs only that one of the parts "asleep", "asleep_nearer" and "retired"
--no-run: measures what has run, also an unfinished whole pass, or an interrupted part
"""
import csv
import json
import math
import os
import pathlib
import re
import subprocess
import sys

from common import AHEAD, RUN_INS, WIDTH

HERE = pathlib.Path(__file__).resolve().parent
sys.path.append(str(HERE.parent / "speed"))
from processor import processor

ROOT = HERE.parents[1]
DECK = ROOT / "inputs" / "micro_milling_pass.toml"
SCENE = ROOT / "inputs" / "micro_milling.toml"
SCENE_WINDOWS = {"first": 10, "last": 170, "step": 20, "width": 4, "run_in": 8}  # deg
RESULTS = ROOT / "results" / "windows"
# One window alone, where the others differ most from the whole pass, with one key of it changed at a time: which of
# them makes the difference.
PROBES = {"probe_ahead": {"run_in": 10, "ahead": 21}, "probe_run_in": {"run_in": 40, "ahead": AHEAD}}
PROBED = 150  # deg
# One window of the whole scene, its far part asleep, where it differs most from the pass, by its run-in in deg.
SCENE_PROBES = {"scene_probe_8": 8, "scene_probe_28": 28}
SCENE_PROBED = 90  # deg
SLEEP_DISTANCE = RETIRE_DISTANCE = "60 um"
SCENE_ASLEEP = {"sleep": {"distance": re.search(r'\n\[sleep\]\ndistance = "([^"]+)"', SCENE.read_text())[1]}}
PARTS = {"asleep": {"sleep": {"distance": SLEEP_DISTANCE}},
         "asleep_nearer": {"sleep": {"distance": "48 um"}},
         "retired": {"sleep": {"distance": SLEEP_DISTANCE}, "retire": {"distance": RETIRE_DISTANCE}}}
SCENE_MASS = "2e4"  # the same windows asleep under twice the scene's mass factor
CUTTING = "tooth1_"  # with a helix the tooth before still leaves while this one enters: a window has not that one
SCENES = ("scene", "scene_asleep", "scene_mass")  # windows of the whole scene
BIN = 1.0  # deg


def read_whole_and_awake(deck):
    """Its text without [windows], which is its end, and [sleep]"""
    text = re.sub(r"\n\[windows\].*", "", deck.read_text(), flags=re.S)
    return re.sub(r"\n\[sleep\]\n(.+\n)*", "", text)


def write_deck(name, deck, sections, mass_factor=None):
    RESULTS.mkdir(parents=True, exist_ok=True)
    text = read_whole_and_awake(deck)
    if mass_factor:
        text = re.sub(r"\nmass_factor = \S+", f"\nmass_factor = {mass_factor}", text)
    file = RESULTS / f"{name}.toml"
    for section, keys in sections.items():
        text += f"\n[{section}]\n" + "".join(f'{key} = "{value}"\n' for key, value in keys.items())
    file.write_text(text)
    return file


def run_windows(program, name, deck, windows, mass_factor=None, **more):
    keys = {key: f"{value} deg" for key, value in windows.items()}
    subprocess.run([program, "run", write_deck(name, deck, {**more, "windows": keys}, mass_factor), "--output", RESULTS / name, "--threads", "1",
                    "--no-pictures", "--resume"], check=True)


def run(program):
    if "--only" in sys.argv:
        return run_part(program, sys.argv[sys.argv.index("--only") + 1])
    for run_in in RUN_INS:
        run_windows(program, f"run_in_{run_in}", DECK,
                    {"first": 10, "last": 170, "step": 20, "width": WIDTH, "run_in": run_in, "ahead": AHEAD})
    for name, keys in PROBES.items():
        run_windows(program, name, DECK, {"first": PROBED, "last": PROBED, "step": 20, "width": WIDTH, **keys})
    if "--scene" in sys.argv:
        run_windows(program, "scene", SCENE, SCENE_WINDOWS)
        run_windows(program, "scene_asleep", SCENE, SCENE_WINDOWS, **SCENE_ASLEEP)
        run_windows(program, "scene_mass", SCENE, SCENE_WINDOWS, SCENE_MASS, **SCENE_ASLEEP)
        for name, run_in in SCENE_PROBES.items():
            one = {"first": SCENE_PROBED, "last": SCENE_PROBED, "run_in": run_in}
            run_windows(program, name, SCENE, {**SCENE_WINDOWS, **one}, **SCENE_ASLEEP)
        run_whole(program, "scene_pass", write_deck("scene_pass", SCENE, SCENE_ASLEEP), os.cpu_count())
    for name in PARTS:
        run_part(program, name)
    run_whole(program, "whole", DECK)


def run_part(program, name):
    run_whole(program, name, write_deck(name, DECK, PARTS[name]))


def run_whole(program, name, deck, threads=1):
    folder = RESULTS / name
    if not is_complete(folder):
        resume = "--resume" if (folder / "checkpoint.h5").exists() else "--overwrite"
        keep_cost(folder)
        subprocess.run([program, "run", deck, "--whole", "--output", folder, "--threads", str(threads), "--no-pictures",
                        resume], check=True)


def keep_cost(folder):
    """Of the part that was interrupted: the summary that comes next is of the rest only."""
    if (folder / "summary.json").exists():
        (folder / "costs.json").write_text(json.dumps(read_costs(folder)))
        (folder / "summary.json").unlink()


def read_costs(folder):
    """One for each time that the run was started."""
    before = json.loads((folder / "costs.json").read_text()) if (folder / "costs.json").exists() else []
    return before + [json.loads((folder / "summary.json").read_text())["cost"]]


def is_complete(folder):
    summary = folder / "summary.json"
    return summary.exists() and json.loads(summary.read_text())["ended"] == "complete"


def read_samples(folder, of=""):
    """(immersion in the middle of the sample, its duration, force x, force y), of all teeth, or of CUTTING alone"""
    names = ("immersion [deg]", "time [s]", f"{of}force_x [N]", f"{of}force_y [N]")
    with open(folder / "history.csv", newline="") as file:
        rows = [[float(row[name]) for name in names] for row in csv.DictReader(file) if None not in row.values()]
    return [(0.5 * (a[0] + b[0]), b[1] - a[1], b[2], b[3]) for a, b in zip(rows, rows[1:])]


def mean(samples, low, high):
    inside = [(dt, x, y) for angle, dt, x, y in samples if low <= angle < high]
    time = sum(dt for dt, _, _ in inside)
    return [sum(dt * force[k] for dt, *force in inside) / time for k in (0, 1)]


def bins(samples):
    low = math.ceil(samples[0][0] / BIN) * BIN
    count = int((samples[-1][0] - low) / BIN)
    middles = [low + (k + 0.5) * BIN for k in range(count)]
    forces = [mean(samples, m - 0.5 * BIN, m + 0.5 * BIN) for m in middles]
    return {"immersion": middles, "force_x": [round(f[0], 4) for f in forces],
            "force_y": [round(f[1], 4) for f in forces]}


def set_beside_pass(rows, whole, width):
    """The pass's force in each window that it has gone through."""
    for row in rows:
        low, high = row["immersion"] - 0.5 * width, row["immersion"] + 0.5 * width
        if whole[-1][0] >= high:
            row["whole_planar"] = math.hypot(*mean(whole, low, high))


def measure_windows(run_in, whole):
    folder = RESULTS / f"run_in_{run_in}"
    joined = json.loads((folder / "windows.json").read_text())
    windows = []
    for name, one in joined["windows"].items():
        if one["ended"] != "complete":
            continue
        samples = read_samples(folder / name)
        windows.append({"immersion": one["immersion"], "force_planar": one["force_planar"],
                        "error_planar": one["error_planar"], "core_seconds": one["core_seconds"],
                        "start": samples[0][0], "bins": bins(samples)})
    set_beside_pass(windows, whole, WIDTH)
    return {"run_in": run_in, "width": WIDTH, "core_seconds": joined["core_seconds"],
            "scatter": joined["scatter_between_windows"],
            "predicted_core_seconds": joined["predicted_core_seconds_of_whole_pass"], "windows": windows}


def sleep_distance(deck):
    """None where nothing sleeps; run writes its deck in m"""
    found = re.search(r'\n\[sleep\]\ndistance = "(.+) m"', deck.read_text())
    return found and f"{1e6 * float(found[1]):g} um"


def number(key, deck):
    return float(re.search(rf"\n{key} = (\S+)", deck.read_text())[1])


def measure_probe(name, keys):
    folder = RESULTS / name
    one = next(iter(json.loads((folder / "windows.json").read_text())["windows"].items()))
    samples = read_samples(folder / one[0])
    return {**keys, "distance": sleep_distance(folder / one[0] / "deck.toml"),
            **{key: one[1][key] for key in ("immersion", "force_planar", "error_planar", "core_seconds")},
            "bins": bins(samples)}


def measure_part(name):
    """A pass of which a part does nothing."""
    summary = json.loads((RESULTS / name / "summary.json").read_text())
    costs = read_costs(RESULTS / name)
    moved = sum(cost["particle_steps_per_second"] * cost["wall_seconds"] for cost in costs)
    found = {"distance": sleep_distance(RESULTS / name / "deck.toml"), "core_seconds": sum(cost["cpu_seconds"] for cost in costs),
             "wall_seconds": sum(cost["wall_seconds"] for cost in costs),
             "threads": sorted({cost["threads"] for cost in costs}),
             "peak_memory_bytes": max(cost["peak_memory_bytes"] for cost in costs),
             **{key: summary[key] for key in ("particles", "hexes", "steps", "leaked_particles")},
             "bins": bins(read_samples(RESULTS / name)),
             "awake": moved / (summary["particles"] * summary["steps"]),
             "energy_residual": summary["energies"]["worst_residual_over_external"]}
    if not is_complete(RESULTS / name):
        found["end"] = read_samples(RESULTS / name)[-1][0]
    if "retired" in summary:
        found |= {"retire_distance": RETIRE_DISTANCE,
                  "retired": {key: summary["retired"][key] for key in ("particles", "met_since")}}
    return found


def measure_scene(name):
    folder = RESULTS / name
    joined = json.loads((folder / "windows.json").read_text())
    with open(folder / "windows.csv", newline="") as file:
        rows = [{name.split(" [")[0]: float(value) for name, value in row.items()} for row in csv.DictReader(file)]
    names = {one["immersion"]: name for name, one in joined["windows"].items()}
    for row in rows:
        summary = json.loads((folder / names[row["immersion"]] / "summary.json").read_text())
        row |= {key: summary[key] for key in ("particles", "hexes", "steps", "leaked_particles")}
        row |= {"peak_memory_bytes": summary["cost"]["peak_memory_bytes"]}
        row |= {"energy_residual": summary["energies"]["worst_residual_over_external"]}
    deck = folder / next(iter(names.values())) / "deck.toml"
    return {"deck": str(SCENE.relative_to(ROOT)), **SCENE_WINDOWS, "rows": rows, "distance": sleep_distance(deck),
            **{key: number(key, deck) for key in ("courant", "mass_factor")}, "machine": processor(),
            "predicted_core_seconds": joined["predicted_core_seconds_of_whole_pass"]}


def write_results(found):
    text = json.dumps(found, indent=1)
    text = re.sub(r"\[\s+([^][{}]*?)\s+\]", lambda m: "[" + re.sub(r"\s+", " ", m[1]) + "]", text)
    (HERE / "results.json").write_text(text + "\n")


def measure_pass():
    whole = read_samples(RESULTS / "whole")
    found = {"deck": str(DECK.relative_to(ROOT)), "whole": {"end": whole[-1][0], "bins": bins(whole)},
             "windows": [measure_windows(run_in, whole) for run_in in RUN_INS]}
    if is_complete(RESULTS / "whole"):
        summary = json.loads((RESULTS / "whole" / "summary.json").read_text())
        found["whole"] |= {"core_seconds": summary["cost"]["cpu_seconds"], "particles": summary["particles"],
                           "steps": summary["steps"]}
    found["probes"] = [measure_probe(name, keys) for name, keys in PROBES.items()
                       if is_complete(RESULTS / name / f"window_{PROBED:03d}")]
    return found


def main():
    if "--no-run" not in sys.argv:
        run(pathlib.Path(sys.argv[1]).resolve())
    kept = HERE / "results.json"
    found = json.loads(kept.read_text()) if kept.exists() else {}
    if (RESULTS / "whole" / "history.csv").exists():
        found |= measure_pass()
    for name in (*PARTS, "scene_pass"):
        if (RESULTS / name / "summary.json").exists():
            found[name] = measure_part(name)
    for name in SCENES:
        if (RESULTS / name / "windows.csv").exists():
            found[name] = measure_scene(name)
    if "scene_pass" in found and (RESULTS / "scene_pass").exists():
        whole = read_samples(RESULTS / "scene_pass", CUTTING)
        for name in set(SCENES) & found.keys():
            set_beside_pass(found[name]["rows"], whole, SCENE_WINDOWS["width"])
        found["scene_pass"] |= {"machine": processor(), "courant": number("courant", RESULTS / "scene_pass" / "deck.toml"),
                                "cutting": bins(whole)}
    probes = [measure_probe(name, {"run_in": run_in}) for name, run_in in SCENE_PROBES.items()
              if (RESULTS / name / "windows.json").exists()]
    found |= {"scene_probes": probes} if probes else {}
    write_results(found)


if __name__ == "__main__":
    main()
