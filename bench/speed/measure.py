#!/usr/bin/env python3
"""Runs every benchmark on each number of threads, several rounds, and writes bench/results.json.

A round takes the ceilings of the machine first and then every program, on one thread and on two, so that ratios can be
taken within a round: a machine that is busy then slows down both. Sizes of a million run in one round only.
"""
import argparse
import json
import os
import pathlib
import platform
import statistics
import subprocess
import time

HERE = pathlib.Path(__file__).resolve().parent
RESULTS = HERE.parent / "results.json"
LARGE = 500_000
FLOAT = ("bench_machine", "bench_step")  # the others differ as they do
FIELDS = ("items", "flops_per_item", "bytes_per_item", "lane_flops_per_item", "pairs_per_item", "lane_pairs_per_item",
          "particles", "tied", "images", "hexes", "steps")


def programs(build):
    found = sorted(path for path in (build / "bench").glob("bench_*") if path.is_file() and os.access(path, os.X_OK))
    return sorted(found, key=lambda path: path.name != "bench_machine")


def run(program, sizes, threads, seconds):
    environment = {"OMP_WAIT_POLICY": "passive", "OMP_PROC_BIND": "false", **os.environ,
                   "OMP_NUM_THREADS": str(threads), "SWARF_BENCH_SIZES": " ".join(map(str, sizes))}
    command = [program, f"--benchmark_min_time={seconds}", "--benchmark_format=json"]
    done = subprocess.run(command, env=environment, stdout=subprocess.PIPE, check=True)
    return json.loads(done.stdout)


def key_of(row, context):
    name, *rest = row["name"].split("/")
    size = int(rest[0]) if rest and rest[0].isdigit() else 0
    return name, size, int(context["threads"]), 8 * int(context["real_bytes"])


def take(found, build, threads, round_number, options):
    """Every program of a build once. Sizes of a million in the first round only, the step at them if asked for."""
    loads, small = [], [size for size in options.sizes if size < LARGE]
    for program in programs(build):
        if build == options.float and program.name not in FLOAT:
            continue
        large = round_number == 0 and (options.large_steps or program.name != "bench_step")
        sizes = options.sizes if large else small
        if not sizes:
            continue
        loads.append(os.getloadavg()[0])
        answer = run(program, sizes, threads, options.seconds)
        for row in answer["benchmarks"]:
            if row.get("error_occurred"):
                raise SystemExit(f"{program.name}: {row['name']}: {row['error_message']}")
            measured = found.setdefault(key_of(row, answer["context"]), {"rounds": {}})
            measured["rounds"][round_number] = 1 / row["items_per_second"]
            share = row["cpu_time"] / row["real_time"]
            measured.setdefault("core_share", []).append(share)
            measured.setdefault("core_seconds", []).append(share / row["items_per_second"])
            measured.update({field: row[field] for field in FIELDS if field in row})
            for phase in (one for one in row if one.startswith("phase: ")):
                measured.setdefault("phases", {}).setdefault(phase[7:], []).append(share * row[phase] / row["items"])
    return loads


def row_of(key, measured):
    name, size, threads, bits = key
    times = list(measured["rounds"].values())
    row = {"name": name, "size": size, "threads": threads, "bits": bits, "seconds_per_item": statistics.median(times),
           "best": min(times), "rounds": measured["rounds"]}
    if threads == 1:  # of a core, that this process got: the rest went to other programs, and its time there
        row["core_share"] = statistics.median(measured["core_share"])
        row["core_seconds_per_item"] = statistics.median(measured["core_seconds"])
    row |= {field: measured[field] for field in FIELDS if field in measured}
    if "phases" in measured:
        row["phases"] = {phase: statistics.median(values) for phase, values in measured["phases"].items()}
    return row


def processor():
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return platform.processor()


def commit():
    here = HERE.parents[1]
    head = subprocess.run(["git", "-C", here, "describe", "--always", "--dirty", "--exclude=*"], capture_output=True,
                          text=True)
    return head.stdout.strip()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--float", type=pathlib.Path, help="build folder in float, for the whole step")
    parser.add_argument("--sizes", type=int, nargs="+", default=[10_000, 100_000, 1_000_000])
    parser.add_argument("--threads", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--seconds", type=float, default=0.15, help="least time of a measurement")
    parser.add_argument("--quick", action="store_true", help="one round, no size of a million")
    parser.add_argument("--large-steps", action="store_true", help="the whole step at a million, too: minutes")
    options = parser.parse_args()
    if options.quick:
        options.rounds, options.sizes = 1, [size for size in options.sizes if size < LARGE]
    found, loads, begun = {}, [], time.time()
    for number in range(options.rounds):
        for threads in options.threads:
            for build in filter(None, (options.build, options.float)):
                loads += take(found, build, threads, number, options)
        print(f"round {number + 1} of {options.rounds}: {time.time() - begun:.0f} s, load {loads[-1]:.1f}", flush=True)
    names = list(dict.fromkeys(key[0] for key in found))  # in the order of the programs
    results = {
        "commit": commit(), "date": time.strftime("%Y-%m-%d %H:%M UTC", time.gmtime()),
        "processor": processor(), "cores": os.cpu_count(), "rounds": options.rounds, "seconds": time.time() - begun,
        "load_average": {"first": loads[0], "median": statistics.median(loads), "most": max(loads)},
        "rows": [row_of(key, found[key]) for key in sorted(found, key=lambda key: (names.index(key[0]), *key[1:]))]}
    RESULTS.write_text(json.dumps(results, indent=1) + "\n")


if __name__ == "__main__":
    main()
