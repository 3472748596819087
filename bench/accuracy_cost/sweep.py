#!/usr/bin/env python3
"""Runs the points of the sweep, cheapest first, and keeps one line of results for each.

May be stopped at any time and started again: a point that has ended with the same deck and the same program is not
run again. Runs use one thread, and cost is processor time, so that other programs on the machine disturb it little.
"""
import argparse
import fcntl
import hashlib
import json
import os
import pathlib
import re
import resource
import signal
import statistics
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "python"))
from swarf import decks

import measure
import physics
import points
import reference
import results
from cost import predicted_core_seconds
from scenes import SCENES

EVERY = points.ALL + physics.POINTS
ROOT = pathlib.Path(__file__).resolve().parents[2]
RESULTS = pathlib.Path(__file__).resolve().parent / "results.csv"
SECONDS_PER_PARTICLE_STEP = 2e-6  # until the results say better
TIMES_PREDICTED = 8               # a run that needs more than this is stopped


def digest(data):
    return hashlib.sha256(data).hexdigest()[:12]


class Sweep:
    FOUND = ("combination", "together")  # groups of points that the results of others say

    def __init__(self, options):
        self.options = options
        self.runs = ROOT / "results" / "accuracy_cost"
        self.runs.mkdir(parents=True, exist_ok=True)
        self.lock = open(self.runs / "lock", "w")
        fcntl.flock(self.lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        self.programs = {build: pathlib.Path(path) for build, path in
                         (("release", options.program), ("float", options.float_program))}
        self.digests = {build: digest(path.read_bytes()) for build, path in self.programs.items() if path.exists()}
        self.rows = results.read(RESULTS)
        self.spent = 0.0

    def hash_of(self, point):
        return digest(json.dumps(point.deck(ROOT), sort_keys=True).encode())

    def row_of(self, point):
        """What is known of this very point, by this very program."""
        for row in self.rows:
            if (row["scene"], row["label"]) == (point.scene.name, point.label):
                known = self.options.any_program or row["program"] == self.digests.get(point.build)
                return row if known and row["deck"] == self.hash_of(point) else None
        return None

    def predicted(self, point):
        ratios = [row["core_seconds"] / predicted_core_seconds(one.deck(ROOT))
                  for one in EVERY if (row := self.row_of(one)) and row["status"] == "complete"]
        scale = statistics.median(ratios) if ratios else SECONDS_PER_PARTICLE_STEP / 2e-6
        return scale * predicted_core_seconds(point.deck(ROOT))

    def keep(self, row):
        """In place of what was known of the point, and of points that were of other decks or programs."""
        current = [one for point in EVERY if (one := self.row_of(point))]
        current += [one for one in self.rows if one["group"] in self.FOUND or "together" in one["label"]]
        self.rows = list({(one["scene"], one["label"]): one for one in [*current, row]}.values())
        results.write(RESULTS, self.rows)

    def run_program(self, point, deck_file, folder, limit):
        """Exit status; the processor time is limited, not the wall clock, for the machine may be busy."""
        command = [self.programs[point.build], "run", deck_file, "--output", folder, "--overwrite", "--threads", "1",
                   "--no-pictures"]
        environment = {**os.environ, "OMP_NUM_THREADS": "1", "OMP_PROC_BIND": "false"}

        def prepare():
            os.nice(10)
            resource.setrlimit(resource.RLIMIT_CPU, (int(limit) + 1, int(limit) + 60))

        with open(f"{folder}.log", "w") as log:
            child = subprocess.Popen(command, stdout=log, stderr=log, env=environment, preexec_fn=prepare,
                                     pass_fds=[self.lock.fileno()])  # a run that outlives us keeps others out
            try:
                return child.wait()
            finally:
                if child.poll() is None:
                    child.kill()
                    child.wait()

    def run(self, point):
        folder = self.runs / re.sub(r"[^a-z0-9.+-]+", "_", point.name.lower())
        deck, deck_file = point.deck(ROOT), pathlib.Path(f"{folder}.toml")
        decks.write(deck_file, deck)
        (folder / "summary.json").unlink(missing_ok=True)
        predicted = self.predicted(point)
        print(f"{point.name:<40} {predicted:7.0f} s predicted", end="", flush=True)
        status = self.run_program(point, deck_file, folder, TIMES_PREDICTED * predicted + 30)
        row = {"scene": point.scene.name, "group": point.group, "label": point.label, "build": point.build,
               "changes": point.changes(ROOT), "spacing": point.spacing or point.scene.spacing,
               "deck": self.hash_of(point), "program": self.digests[point.build]}
        if (folder / "summary.json").exists():
            row.update(measure.measure(deck, folder, point.scene))
        if row.get("status") == "SIGXCPU" or status == -signal.SIGXCPU:
            row["status"] = f"needed more than {TIMES_PREDICTED} times the predicted core-seconds"
        elif "status" not in row:
            lines = pathlib.Path(f"{folder}.log").read_text().strip().splitlines()
            row["status"] = (lines[-1] if lines else f"ended with status {status}").replace(str(ROOT) + "/", "")
        if row["status"] == "interrupted":
            sys.exit(130)
        self.spent += row.get("core_seconds") or 0
        self.keep(row)
        force = row.get("cutting_force")
        print(f" {row.get('core_seconds') or 0:7.0f} s  " +
              (f"F_c {force:.4g} N" if force is not None else row["status"]), flush=True)

    def affordable(self, point):
        return self.options.budget is None or self.spent + self.predicted(point) <= self.options.budget

    def run_missing(self, wanted):
        """Cheapest first. Returns how many were left out for want of budget or program."""
        left = 0
        for point in sorted(wanted, key=lambda one: predicted_core_seconds(one.deck(ROOT))):
            if self.row_of(point):
                continue
            if point.build not in self.digests or not self.affordable(point):
                left += 1
                continue
            self.run(point)
        return left

    def best(self, scene):
        """The best settings, cheapest first, when every setting has been tried, or of those that have if that is
        asked for."""
        singles = [point for point in points.points_of(scene) if (self.options.full or not point.full)
                   and not point.label.startswith(points.CONVERTING)]  # that is another scene: it goes with no other setting
        rows = [row for point in singles if (row := self.row_of(point))]
        all_tried = len(rows) == len(singles)
        rows, scatter = reference.combine(rows, scene.spacing)
        base = next((row for row in rows if row["group"] == "spacing" and row["spacing"] == scene.spacing), None)
        if not (all_tried or self.options.together) or not base or base["status"] != "complete":
            return [], rows
        found = reference.references(rows)
        best = reference.best_settings(reference.widen(rows, found, scatter), base, found)
        of_label = {point.label: point for point in singles}
        return [of_label[row["label"]] for row in best], rows

    def together(self, scene):
        """The best settings at once: one after the other joins those before it, unless together they do not agree
        with the base, each passing alone as it may."""
        chosen, tried = [], []
        best, rows = self.best(scene)
        for setting in best:
            trial = points.trial(scene, [*chosen, setting])
            if chosen and trial.changes(ROOT) == points.trial(scene, chosen).changes(ROOT):
                continue  # there is no band without hexes
            tried.append(trial)
            self.run_missing(tried[-1:])
            row = self.row_of(tried[-1])
            if row and reference.agrees(row, rows):
                chosen.append(setting)
        found = points.together(scene, chosen) if len(chosen) > 1 else []
        decks_now = {self.hash_of(point) for point in tried + found}
        self.rows = [row for row in self.rows if row["scene"] != scene.name or row["deck"] in decks_now
                     or not (row["group"] in self.FOUND or "together" in row["label"])]
        return found


def plan(sweep, wanted):
    total = 0
    for point in sorted(wanted, key=lambda one: predicted_core_seconds(one.deck(ROOT))):
        row = sweep.row_of(point)
        seconds = 0 if row else sweep.predicted(point)
        total += seconds
        note = f"has run: {row['status']}" if row else f"{seconds:.0f} s"
        print(f"{point.name:<40} {note:<24} {decks.describe(point.changes(ROOT))}")
    print(f"to run: {total:.0f} core-seconds, and the best settings together after that")


def options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--full", action="store_true", help="all points, also the long ones")
    parser.add_argument("--budget", type=float, help="core-seconds this call may use")
    parser.add_argument("--scene", choices=list(SCENES), help="only this scene")
    parser.add_argument("--only", help="only points whose label contains this")
    parser.add_argument("--group", action="append", help="only points of this group; may be given again")
    parser.add_argument("--together", action="store_true", help="the best settings at once, before all have been tried")
    parser.add_argument("--list", action="store_true", help="say what would run and what it costs")
    parser.add_argument("--any-program", action="store_true", help="keep points that another build has run")
    parser.add_argument("--program", default=ROOT / "build/release/swarf")
    parser.add_argument("--float-program", default=ROOT / "build/float/swarf")
    return parser.parse_args()


def main():
    chosen = options()
    sweep = Sweep(chosen)
    scenes = [scene for scene in SCENES.values() if chosen.scene in (None, scene.name)]
    wanted = [point for point in EVERY if point.scene in scenes and (chosen.full or not point.full)
              and (not chosen.only or chosen.only in point.label) and (not chosen.group or point.group in chosen.group)]
    if chosen.list:
        return plan(sweep, wanted)
    left = sweep.run_missing(wanted)
    for scene in scenes:
        left += sweep.run_missing(sweep.together(scene))
    if left:
        print(f"{left} points left out: over the budget, or their program is not built", file=sys.stderr)


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))
    try:
        main()
    except KeyboardInterrupt:
        sys.exit(130)
    except BlockingIOError:
        sys.exit("another sweep is running")
