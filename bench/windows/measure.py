#!/usr/bin/env python3
"""Runs a pass as a whole, with its far part frozen, with its spent chip retired as well, and as windows, and compares
their forces: results.json beside this file. What it holds of runs that are not here stays.

usage: measure.py PROGRAM [--scene] [--only NAME] [--no-run]
--scene: runs the whole scene too, hours: its windows, and its pass with the far part frozen on all cores
--only NAME: runs only that one of the parts "frozen", "frozen_nearer" and "retired"
--no-run: measures what has run, also an unfinished whole pass, or an interrupted part
"""
import json
import math
import os
import pathlib
import re
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "python"))
import numpy
import swarf
from swarf.reports import ROOT, processor

from common import AHEAD, RUN_INS, WIDTH

HERE = pathlib.Path(__file__).resolve().parent
DECK = ROOT / "inputs" / "micro_milling_pass.toml"
SCENE = ROOT / "inputs" / "micro_milling.toml"
SCENE_WINDOWS = {"first": 10, "last": 170, "step": 20, "width": 4, "run_in": 8}  # deg
RESULTS = ROOT / "results" / "windows"
# One window alone, where the others differ most from the whole pass, with one key of it changed at a time: which of
# them makes the difference.
PROBES = {"probe_ahead": {"run_in": 10, "ahead": 21}, "probe_run_in": {"run_in": 40, "ahead": AHEAD}}
PROBED = 150  # deg
# One window of the whole scene, its far part frozen, where it differs most from the pass, by its run-in in deg.
SCENE_PROBES = {"scene_probe_8": 8, "scene_probe_28": 28}
SCENE_PROBED = 90  # deg
SLEEP_DISTANCE = RETIRE_DISTANCE = "60 um"
SCENE_FROZEN = {"sleep.distance": swarf.read_deck(SCENE)["sleep"]["distance"]}
PARTS = {"frozen": {"sleep.distance": SLEEP_DISTANCE}, "frozen_nearer": {"sleep.distance": "48 um"},
         "retired": {"sleep.distance": SLEEP_DISTANCE, "retire.distance": RETIRE_DISTANCE}}
SCENE_MASS = {"run.mass_factor": 2e4}  # the same windows frozen under twice the scene's mass factor
CUTTING = "tooth1_"  # with a helix the tooth before still leaves while this one enters: a window has not that one
SCENES = ("scene", "scene_frozen", "scene_mass")  # windows of the whole scene
BIN = 1.0  # deg


def vary(deck, changes):
    """The deck of this file as a whole pass, active, with these changes."""
    return swarf.vary(swarf.read_deck(deck), {"windows": None, "sleep": None, **changes})


def write_deck(name, deck):
    RESULTS.mkdir(parents=True, exist_ok=True)
    swarf.write_deck(RESULTS / f"{name}.toml", deck)
    return RESULTS / f"{name}.toml"


def run_windows(program, name, deck, windows, changes=None):
    changes = {**(changes or {}), **{f"windows.{key}": f"{value} deg" for key, value in windows.items()}}
    subprocess.run([program, "run", write_deck(name, vary(deck, changes)), "--output", RESULTS / name, "--threads", "1",
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
        run_windows(program, "scene_frozen", SCENE, SCENE_WINDOWS, SCENE_FROZEN)
        run_windows(program, "scene_mass", SCENE, SCENE_WINDOWS, SCENE_MASS | SCENE_FROZEN)
        for name, run_in in SCENE_PROBES.items():
            one = {"first": SCENE_PROBED, "last": SCENE_PROBED, "run_in": run_in}
            run_windows(program, name, SCENE, {**SCENE_WINDOWS, **one}, SCENE_FROZEN)
        run_whole(program, "scene_pass", write_deck("scene_pass", vary(SCENE, SCENE_FROZEN)), os.cpu_count())
    for name in PARTS:
        run_part(program, name)
    run_whole(program, "whole", DECK)


def run_part(program, name):
    run_whole(program, name, write_deck(name, vary(DECK, PARTS[name])))


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
    return before + [swarf.read(folder).summary["cost"]]


def is_complete(folder):
    return folder.exists() and swarf.read(folder).is_complete


def read_samples(folder, of=""):
    """(immersion in the middle of the sample, its duration, force x, force y), of all teeth, or of CUTTING alone"""
    history = swarf.read(folder).history
    angle = history["immersion"]
    return list(zip(0.5 * (angle[:-1] + angle[1:]), numpy.diff(history["time"]), history[f"{of}force_x"][1:],
                    history[f"{of}force_y"][1:]))


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
    of_pass = swarf.read(RESULTS / f"run_in_{run_in}")
    joined = of_pass.joined
    windows = []
    for name, one in joined["windows"].items():
        if one["ended"] != "complete":
            continue
        samples = read_samples(of_pass.folder / name)
        windows.append({"immersion": one["immersion"], "force_planar": one["force_planar"],
                        "error_planar": one["error_planar"], "core_seconds": one["core_seconds"],
                        "start": samples[0][0], "bins": bins(samples)})
    set_beside_pass(windows, whole, WIDTH)
    return {"run_in": run_in, "width": WIDTH, "core_seconds": joined["core_seconds"],
            "scatter": joined["scatter_between_windows"],
            "predicted_core_seconds": joined["predicted_core_seconds_of_whole_pass"], "windows": windows}


def sleep_distance(deck):
    """None where nothing is frozen; run writes its deck in m"""
    distance = deck.get("sleep", {}).get("distance")
    return distance and swarf.quantity(swarf.si(distance), "um", 6)


def measure_probe(name, keys):
    of_pass = swarf.read(RESULTS / name)
    window, one = next(iter(of_pass.joined["windows"].items()))
    return {**keys, "distance": sleep_distance(of_pass.windows[window].deck),
            **{key: one[key] for key in ("immersion", "force_planar", "error_planar", "core_seconds")},
            "bins": bins(read_samples(of_pass.folder / window))}


def measure_part(name):
    """A pass of which a part does nothing."""
    run, costs = swarf.read(RESULTS / name), read_costs(RESULTS / name)
    summary, samples = run.summary, read_samples(RESULTS / name)
    moved = sum(cost["particle_steps_per_second"] * cost["wall_seconds"] for cost in costs)
    found = {"distance": sleep_distance(run.deck), "core_seconds": sum(cost["cpu_seconds"] for cost in costs),
             "wall_seconds": sum(cost["wall_seconds"] for cost in costs),
             "threads": sorted({cost["threads"] for cost in costs}),
             "peak_memory_bytes": max(cost["peak_memory_bytes"] for cost in costs),
             **{key: summary[key] for key in ("particles", "hexes", "steps", "leaked_particles")},
             "bins": bins(samples), "active": moved / (summary["particles"] * summary["steps"]),
             "energy_residual": summary["energies"]["worst_residual_over_external"]}
    if not run.is_complete:
        found["end"] = samples[-1][0]
    if "retired" in summary:
        found |= {"retire_distance": RETIRE_DISTANCE,
                  "retired": {key: summary["retired"][key] for key in ("particles", "met_since")}}
    return found


def measure_scene(name):
    of_pass = swarf.read(RESULTS / name)
    forces, joined = of_pass.window_forces, of_pass.joined
    rows = [dict(zip(forces, map(float, values))) for values in zip(*forces.values())]
    window_at = {one["immersion"]: of_pass.windows[name] for name, one in joined["windows"].items()}
    for row in rows:
        summary = window_at[row["immersion"]].summary
        row |= {key: summary[key] for key in ("particles", "hexes", "steps", "leaked_particles")}
        row |= {"peak_memory_bytes": summary["cost"]["peak_memory_bytes"]}
        row |= {"energy_residual": summary["energies"]["worst_residual_over_external"]}
    deck = next(iter(of_pass.windows.values())).deck
    return {"deck": str(SCENE.relative_to(ROOT)), **SCENE_WINDOWS, "rows": rows, "distance": sleep_distance(deck),
            **{key: deck["run"][key] for key in ("courant", "mass_factor")}, "machine": processor(),
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
        summary = swarf.read(RESULTS / "whole").summary
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
        courant = swarf.read(RESULTS / "scene_pass").deck["run"]["courant"]
        found["scene_pass"] |= {"machine": processor(), "courant": courant, "cutting": bins(whole)}
    probes = [measure_probe(name, {"run_in": run_in}) for name, run_in in SCENE_PROBES.items()
              if (RESULTS / name / "windows.json").exists()]
    found |= {"scene_probes": probes} if probes else {}
    write_results(found)


if __name__ == "__main__":
    main()
