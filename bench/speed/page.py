#!/usr/bin/env python3
"""docs/reports/speed.md, roofline.* and growth.*: all from bench/results.json, but for the peers' figures (peers.py), the
targets (targets.py) and a GPU's data sheet (gpu.py)."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "python"))
from swarf import reports

import gpu
import growth
import memory
import peers
import roofline
import targets
from results import Results

HEAD = """# Speed

Made by `bench/run`; every number of ours is from `bench/results.json`. Commit {commit}, {date}; {processor}, {cores} \
cores, rounds: {rounds}. Times are medians of the rounds (sizes of a million and more: one round), "best" the fastest \
round, ratios are taken within a round.

{summary}

**How quiet the machine was:** load average {first:.1f} at the start, median {median:.1f}, most {most:.1f} on {cores} \
cores; a process of one thread got {share:.0f} % of a core (median of all rows). Alone, the load is at most the number \
of threads and the share 100 %; otherwise the rates below are too low, those on two threads most. "Core": rate by the \
processor time of one thread, which does not count waiting for other programs.

Ceilings, best of the rounds, double: {ceilings}.

## Targets

Set for 2 cores before anything was measured.
"""

STEP_TEXT = """
## The whole step

Settings of `inputs/orthogonal_cutting.toml` (its stabilisers, conduction, contact), bodies scaled to the size; from one
rebuild of the neighbour lists to the next, checks and samples included. Plain sums: without hourglass stiffness.
M/s: million particle-, or hex-, steps a second.
"""

KERNEL_TEXT = """
## Kernels

Operations and bytes are counted from the equations (the count stands at the head of each `bench/bench_*.cpp`): of
pairs within the support; the lanes compute more, because a list is shared by the {width} particles of a cluster and
has a skin. Bytes: each field once. Share: of this machine's fused multiply-adds (in brackets with all that the lanes
compute) and of its triad, same round and threads.

![Roofline](roofline.png)
"""

PEER_TEXT = """
## Peers

Ours: the whole step as above, 56 neighbours inside. A step costs nearly in proportion to neighbours, so their product
with the particle-steps compares codes better.
"""


def rate(row):
    return f"{1e-6 / row['seconds_per_item']:.2f}" if row else "-"


def spaced(size):
    return f"{size:,}".replace(",", " ")


def summary(results):
    steps = {name: results.get(f"step, {name}", 100_000, 2) for name in ("particles", "hexes")}
    found = ", ".join(f"{rate(row)} million {name}" for name, row in steps.items() if row)
    return f"**A second on two threads: {found}** (whole step, 100 000 of them, double). {targets.summary(results)}"


def head(results):
    everything = results.all
    load = everything["load_average"]
    shares = sorted(row["core_share"] for row in everything["rows"] if "core_share" in row)
    ceilings = "; ".join("{:.1f} GFLOP/s, {:.1f} GB/s on {}".format(
        *(value / 1e9 for value in results.ceiling(threads)), "2 threads" if threads > 1 else "1 thread")
        for threads in (1, 2))
    return HEAD.format(**everything, **load, summary=summary(results), share=100 * shares[len(shares) // 2], ceilings=ceilings)


def step_rows(results):
    head = ["scene", "size", "bits", "core, M/s", "M/s, 1 thread", "best", "M/s, 2 threads", "best", "2 over 1 thread"]
    table = []
    for name in results.names(step=True):
        for size in results.step_sizes(name):
            for bits in (64, 32):
                one, two = (results.get(name, size, threads, bits) for threads in (1, 2))
                if not one or not two:
                    continue
                table.append([name[6:], spaced(size), bits, f"{1e-6 / one['core_seconds_per_item']:.2f}", rate(one),
                              f"{1e-6 / one['best']:.2f}", rate(two), f"{1e-6 / two['best']:.2f}",
                              f"{results.ratio(one, two):.2f}"])
    return reports.table(head, table, key=3)


def phase_rows(results, size):
    names = results.names(step=True)
    rows = {name: results.get(name, size, 1) for name in names}
    phases = sorted({phase for row in rows.values() for phase in row["phases"]},
                    key=lambda phase: -max(row["phases"].get(phase, 0) for row in rows.values()))
    yield f"\nWhere the time goes: ns of a core per item and step, one thread, {spaced(size)} items, double.\n"
    yield from reports.table(["phase", *(name[6:] for name in names)], [
        [phase, *(f"{1e9 * rows[name]['phases'].get(phase, 0):.1f}" for name in names)] for phase in phases])


def start_line(results):
    """Of the program, from its start to the first step of the full scene."""
    runs = results.all.get("start_up", {})
    if not runs:
        return ""
    deck, most = next(iter(runs.values()))["deck"], max(run["most_resident"] for run in runs.values())
    times = ", ".join(f"{run['seconds']:.1f} s on {threads} thread{'s' if int(threads) > 1 else ''} "
                      f"({run['core_seconds']:.1f} s of a core in all)" for threads, run in runs.items())
    return (f"\nStart-up, from the start of the program to the first step of `inputs/{deck}`, first frame and checkpoint\n"
            f"written: {times}. Most memory: {most / 1e6:.0f} MB.")


def kernel_rows(results):
    head = ["kernel", "size", "core, M/s", "M/s, 1 thread", "M/s, 2 threads", "2 over 1", "flop", "byte",
            "GFLOP/s, 2 threads", "GB/s", "share of FMA", "share of triad"]
    table = []
    for name in results.names(step=False):
        for size in results.sizes():
            one, two = (results.get(name, size, threads) for threads in (1, 2))
            if not one or not two:
                continue
            flops, lanes = results.share(two, "flops"), results.share(two, "lane_flops")
            more = f" ({100 * lanes:.0f} %)" if lanes > 1.001 * flops else ""
            table.append([name, spaced(size), f"{1e-6 / one['core_seconds_per_item']:.2f}", rate(one), rate(two),
                          f"{results.ratio(one, two):.2f}", f"{one['flops_per_item']:.0f}",
                          f"{one['bytes_per_item']:.0f}",
                          f"{two['flops_per_item'] / two['seconds_per_item'] / 1e9:.1f}",
                          f"{two['bytes_per_item'] / two['seconds_per_item'] / 1e9:.1f}",
                          f"{100 * flops:.1f} %{more}", f"{100 * results.share(two, 'bytes'):.0f} %"])
    return reports.table(head, table, key=2)


def list_line(results, size):
    row = results.get("find_neighbors", size, 1)
    pairs, lanes, listed = (row[f"{kind}pairs_per_item"] for kind in ("", "lane_", "listed_"))
    return (f"\nLists at {spaced(size)} particles: {pairs:.1f} neighbours within the support; {listed:.0f} rows listed, "
            f"{lanes:.0f} of them within the support of a lane: {100 * pairs / lanes:.0f} % of the lanes' work counts.\n")


def peer_rows(results, size):
    head = ["code, case", "elements", "neighbours", "M/s, 1 core", "M/s, 2 cores", "source"]
    pairs, table = results.get("find_neighbors", size, 1)["pairs_per_item"], []
    for name in results.names(step=True):
        one, two = (results.get(name, size, threads) for threads in (1, 2))
        neighbours = "-" if name == "step, hexes" else f"{pairs:.0f}"
        table.append([f"**swarf**, {name[6:]}", spaced(int(one["items"])), neighbours, rate(one), rate(two), "this page"])
    table += [[code, spaced(elements), *more, "[1]"] for code, elements, *more in peers.MEASURED]
    yield from reports.table(head, table)
    yield f"\n[1] {peers.HERE_SOURCE}.\n\nPublished by their authors, on other machines:\n"
    for code, figure in peers.PUBLISHED:
        yield f"- {code}: {figure}."


def main():
    results = Results()
    size = 100_000 if 100_000 in results.sizes() else results.sizes()[-1]
    roofline.draw(results, size)
    growth.draw(results)
    lines = [head(results), *targets.rows(results), STEP_TEXT, *step_rows(results), start_line(results),
             *phase_rows(results, size), growth.TEXT, *memory.lines(results), KERNEL_TEXT.format(width=8),
             list_line(results, size), *kernel_rows(results), PEER_TEXT, *peer_rows(results, size),
             *gpu.lines(results, results.sizes()[-1])]
    reports.write("speed", lines)


if __name__ == "__main__":
    main()
