#!/usr/bin/env python3
"""Runs every benchmark on each number of threads, several rounds, and writes bench/results.json.

A round takes the ceilings of the machine first and then every program, on one thread and on two, so that ratios can be
taken within a round: a machine that is busy then slows down both. Large sizes run in one round only. Cut short, it
goes on where it was (kept.py).
"""
import argparse
import json
import os
import pathlib
import statistics
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "python"))
from swarf.reports import commit, processor

import start_up
from kept import Kept

RESULTS = pathlib.Path(__file__).resolve().parents[1] / "results.json"
LARGE = 500_000
# The whole step, each scene and size in a process of its own, so that its memory is seen.
STEPS = {
    64: {"particles": (10_000, 100_000, 1_000_000, 4_000_000), "particles, plain sums": (10_000, 100_000),
         "hexes": (10_000, 100_000, 123_840, 1_000_000), "hybrid": (10_000, 100_000)},
    32: {"particles": (10_000, 100_000, 1_000_000, 4_000_000), "hexes": (10_000, 100_000, 123_840), "hybrid": (10_000, 100_000)},
}
FIELDS = ("items", "flops_per_item", "bytes_per_item", "lane_flops_per_item", "pairs_per_item", "lane_pairs_per_item",
          "listed_pairs_per_item", "near_pairs_per_item", "gpu_flops_per_item", "gpu_bytes_per_item",
          "gathered_bytes_per_item", "particles", "rows", "tied", "ghosts", "hexes", "steps", "most_resident",
          "resident")


def programs(build):
    found = sorted(path for path in (build / "bench").glob("bench_*") if path.is_file() and os.access(path, os.X_OK))
    return sorted(found, key=lambda path: path.name != "bench_machine")


def kernels(program):
    listed = subprocess.run([program, "--benchmark_list_tests"], stdout=subprocess.PIPE, text=True, check=True).stdout
    return list(dict.fromkeys(line.split("/")[0] for line in listed.splitlines()))


def run(program, sizes, threads, options, part=None):
    environment = {"OMP_WAIT_POLICY": "passive", "OMP_PROC_BIND": "false", **os.environ,
                   "OMP_NUM_THREADS": str(threads), "SWARF_BENCH_SIZES": " ".join(map(str, sizes))}
    command = [program, f"--benchmark_min_time={options.seconds}", "--benchmark_format=json"]
    if part:  # a process of its own, so that nothing before it is in the caches or in memory
        command.append(f"--benchmark_filter=^{part}/")
    done = subprocess.run(command, env=environment, stdout=subprocess.PIPE, check=True)
    answer = json.loads(done.stdout)
    for row in answer["benchmarks"]:
        if row.get("error_occurred"):
            raise SystemExit(f"{program.name}: {row['name']}: {row['error_message']}")
    return answer


def key_of(row, context):
    name, *rest = row["name"].split("/")
    size = int(rest[0]) if rest and rest[0].isdigit() else 0
    return name, size, int(context["threads"]), 8 * int(context["real_bytes"])


def visits(build, bits, number, options):
    """(program, sizes, part of it) of a round: large sizes in the first one only."""
    fits = lambda sizes: [size for size in sizes
                          if size <= options.largest and (size < LARGE or (number == 0 and not options.quick))]
    for program in programs(build):
        if program.name == "bench_step":
            for scene, sizes in STEPS[bits].items():
                yield from ((program, [size], f"step, {scene}") for size in fits(sizes))
        elif bits == 64 or program.name == "bench_machine":  # kernels in float differ as the step does
            if fits(options.sizes):
                for part in kernels(program) if program.name == "bench_kernels" else [None]:
                    yield program, fits(options.sizes), part


def add(found, number, answer):
    for row in answer["benchmarks"]:
        measured = found.setdefault(key_of(row, answer["context"]), {"rounds": {}})
        measured["rounds"][number] = 1 / row["items_per_second"]
        share = row["cpu_time"] / row["real_time"]
        measured.setdefault("core_share", []).append(share)
        measured.setdefault("core_seconds", []).append(share / row["items_per_second"])
        measured.update({field: row[field] for field in FIELDS if field in row})
        for phase in (one for one in row if one.startswith("phase: ")):
            measured.setdefault("phases", {}).setdefault(phase[7:], []).append(share * row[phase] / row["items"])
        for kind in ("calls", "bytes"):
            counts = {name[len(kind) + 2:]: row[name] for name in row if name.startswith(kind + ": ")}
            if counts:
                measured[kind] = counts


def row_of(key, measured):
    name, size, threads, bits = key
    times = list(measured["rounds"].values())
    row = {"name": name, "size": size, "threads": threads, "bits": bits, "seconds_per_item": statistics.median(times),
           "best": min(times), "rounds": measured["rounds"]}
    if threads == 1:  # of a core, that this process got: the rest went to other programs, and its time there
        row["core_share"] = statistics.median(measured["core_share"])
        row["core_seconds_per_item"] = statistics.median(measured["core_seconds"])
        row |= {kind: measured[kind] for kind in ("calls", "bytes") if kind in measured}
    row |= {field: measured[field] for field in FIELDS if field in measured}
    if "phases" in measured:
        row["phases"] = {phase: statistics.median(values) for phase, values in measured["phases"].items()}
    return row


def take_rounds(options, kept):
    found, begun = {}, time.time()
    for number in range(options.rounds):
        for threads in options.threads:
            for build, bits in ((options.build, 64), (options.float, 32)):
                for program, sizes, part in visits(build, bits, number, options) if build else ():
                    name = f"{number}-{threads}-{bits}-{program.name}-{part or ''}-{'-'.join(map(str, sizes))}"
                    add(found, number, kept.get(name, lambda: run(program, sizes, threads, options, part)))
        print(f"round {number + 1} of {options.rounds}: {time.time() - begun:.0f} s, load {os.getloadavg()[0]:.1f}",
              flush=True)
    return found


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--float", type=pathlib.Path, help="build folder in float, for the whole step")
    parser.add_argument("--sizes", type=int, nargs="+", default=[10_000, 100_000, 1_000_000], help="of the kernels")
    parser.add_argument("--largest", type=int, default=4_000_000, help="size; 4 million particles take 5 GB")
    parser.add_argument("--threads", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--seconds", type=float, default=0.15, help="least time of a measurement")
    parser.add_argument("--quick", action="store_true", help="one round, nothing of a million")
    options = parser.parse_args()
    if options.quick:
        options.rounds = 1
    kept = Kept(options.build / "bench" / "measured", newest=max(p.stat().st_mtime for p in programs(options.build)))
    begun, measured = time.time(), kept.get("commit", lambda: commit("bench", "include", "kernels", "src"))  # the tree may change meanwhile
    found = take_rounds(options, kept)
    start = {threads: kept.get(f"start-up-{threads}", lambda: start_up.measure(options.build / "swarf", threads))
             for threads in (() if options.quick else options.threads)}
    names = list(dict.fromkeys(key[0] for key in found))  # in the order of the programs
    results = {
        "commit": measured, "date": time.strftime("%Y-%m-%d %H:%M UTC", time.gmtime()),
        "processor": processor(), "cores": os.cpu_count(), "rounds": options.rounds, "seconds": time.time() - begun,
        "load_average": {"first": kept.loads[0], "median": statistics.median(kept.loads), "most": max(kept.loads)},
        "start_up": start,
        "rows": [row_of(key, found[key]) for key in sorted(found, key=lambda key: (names.index(key[0]), *key[1:]))]}
    RESULTS.write_text(json.dumps(results, indent=1) + "\n")
    kept.forget()


if __name__ == "__main__":
    main()
