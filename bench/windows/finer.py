#!/usr/bin/env python3
"""The pass and its windows again in smaller cells: is what windows miss where the chip is thin the chip's history, or
too few particles across it? Writes the entry "finer" of results.json. The whole pass has its far part frozen.

usage: finer.py PROGRAM [--no-run]
"""
import json
import pathlib
import subprocess
import sys

import measure  # also makes swarf known
import swarf

# um: cells of the bulk; the cut zone has twice as many around
CELLS = {3.0: ([458, 4, 11], [229, 2, 8]), 2.4: ([574, 5, 14], [287, 2, 10])}
WHOLE = 2.4  # um: the pass runs as a whole too, and all its windows
THIN = (150, 170)  # deg
COURANT = 0.45


def deck_of(spacing, **more):
    cut_zone, bulk = CELLS[spacing]
    return measure.vary(measure.DECK, {"body[cut zone].cells": cut_zone, "body[bulk].cells": bulk,
                                       "run.courant": COURANT, **more})


def windows_name(spacing):
    return f"windows_{spacing:g}_um"


def run(program):
    for spacing in CELLS:
        name = windows_name(spacing)
        deck = measure.write_deck(name, deck_of(spacing))
        first = 10 if spacing == WHOLE else THIN[0]
        subprocess.run([program, "run", deck, "--windows", f"{first}:{THIN[1]}:20", "--output", measure.RESULTS / name,
                        "--threads", "1", "--no-pictures", "--resume"], check=True)
    frozen = deck_of(WHOLE, **{"sleep.distance": measure.SLEEP_DISTANCE})
    measure.run_whole(program, "whole_finer", measure.write_deck("whole_finer", frozen))


def measure_windows(spacing, whole):
    joined = swarf.read(measure.RESULTS / windows_name(spacing)).joined
    rows = []
    for one in joined["windows"].values():
        if one["ended"] != "complete":
            continue
        rows.append({key: one[key] for key in ("immersion", "force_planar", "error_planar", "core_seconds", "uncut_chip")})
    if whole:
        measure.set_beside_pass(rows, whole, measure.WIDTH)
    return {"spacing": spacing, "courant": COURANT, "core_seconds": joined["core_seconds"],
            "scatter": joined["scatter_between_windows"], "windows": rows}


def main():
    if "--no-run" not in sys.argv:
        run(pathlib.Path(sys.argv[1]).resolve())
    folder = measure.RESULTS / "whole_finer"
    whole = measure.read_samples(folder)
    found = [measure_windows(spacing, whole if spacing == WHOLE else None) for spacing in CELLS]
    entry = {"windows": found, "whole": {"spacing": WHOLE, "end": whole[-1][0], "bins": measure.bins(whole)}}
    if measure.is_complete(folder):
        summary = swarf.read(folder).summary
        entry["whole"] |= {"core_seconds": summary["cost"]["cpu_seconds"], "particles": summary["particles"],
                           "steps": summary["steps"],
                           "energy_residual": summary["energies"]["worst_residual_over_external"]}
    kept = measure.HERE / "results.json"
    measure.write_results(json.loads(kept.read_text()) | {"finer": entry})


if __name__ == "__main__":
    main()
