"""Runs the orthogonal cut over the spacing, with shifting and without, and writes docs/reports/chip.md."""
import argparse
import concurrent.futures
import pathlib
import subprocess
import sys

import numpy

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "python"), str(ROOT / "bench" / "accuracy_cost")]
import swarf  # noqa: E402
from swarf import decks, reports  # noqa: E402

import measure as forces  # noqa: E402
import order  # noqa: E402
from scenes import SCENES  # noqa: E402

SCENE = SCENES["orthogonal"]
RUNS = ROOT / "results" / "chip"
CUT = 0.5e-3  # s: 250 um of cut; the second half counts
OFFSETS = (0, 1 / 3, -1 / 3)  # spacings by which the edge meets the rows deeper


def deck_of(spacing, offset, shifting):
    deck = decks.read(ROOT / SCENE.deck_file)
    SCENE.set_cut(deck, CUT)
    SCENE.set_spacing(deck, spacing)
    SCENE.thicken(deck, offset * spacing * 1e-6)
    deck["particles"]["shifting"] = shifting
    deck["title"] = f"chip at {spacing:g} um"
    return deck


def run(job):
    spacing, offset, shifting = job
    folder = RUNS / f"{spacing:.4g}um_{offset:+.2f}_{'shifting' if shifting else 'without'}"
    deck = deck_of(*job)
    if not (folder / "summary.json").exists():
        RUNS.mkdir(parents=True, exist_ok=True)
        file = RUNS / f"{folder.name}.toml"
        decks.write(file, deck)
        subprocess.run([ROOT / "build/release/swarf", "run", file, "-o", folder, "--overwrite", "--threads", "1", "--no-pictures"],
                       stdout=subprocess.DEVNULL, check=False)
    return {**measured(deck, folder, spacing), "spacing": spacing, "shifting": shifting}


def measured(deck, folder, spacing):
    run = swarf.read(folder)
    if not run.is_complete:
        return {"ended": run.summary["ended"]}
    table, energies = run.history, run.summary["energies"]
    begin, end = CUT / 2, table["time"][-1]
    A = swarf.si(next(iter(deck["material"].values()))["A"])
    row = order.measure(run.frames[-1].particles, spacing * 1e-6, SCENE.width(deck), A)
    share = 40e-6 / SCENE.uncut(deck, 0)  # the force of a cut is nearly in proportion to its thickness
    for name, values in zip(("Fc", "Ff"), forces.cutting_forces(deck, table)):
        row[name] = share * forces.mean_and_error(table["time"], values, begin, end, False)[0]
    row["stabilisers"] = (energies["hourglass_work"] + energies["viscous_work"]) / energies["external_work"]
    row["shifting_work"] = energies["shifting_work"] / energies["external_work"]
    row["residual"], row["seconds"] = energies["worst_residual_over_external"], run.summary["cost"]["cpu_seconds"]
    return row


COLUMNS = (("nearest", "nearest neighbour, 5 %", "{:.2f}", 1), ("dense", "sum V W, 95 %", "{:.2f}", 1),
           ("voids", "voids, %", "{:.1f}", 100), ("noise", "pressure noise / A", "{:.2f}", 1),
           ("stabilisers", "stabilisers' work, %", "{:.1f}", 100), ("shifting_work", "shifting's, %", "{:.3f}", 100),
           ("residual", "energy residual, %", "{:.2f}", 100), ("seconds", "core-seconds", "{:.0f}", 1))


def line(rows):
    cells = [f"{rows[0]['spacing']:.3g}", "yes" if rows[0]["shifting"] else "no"]
    for name in ("Fc", "Ff"):
        values = [one[name] for one in rows]
        cells.append(f"{numpy.mean(values):.1f} +- {numpy.std(values, ddof=1) / len(values) ** 0.5:.1f}"
                     if len(values) > 1 else f"{values[0]:.1f}")
    return cells + [form.format(by * numpy.mean([one[name] for one in rows])) for name, _, form, by in COLUMNS]


def summary(rows):
    """What shifting does at the finest spacing that has run with it and without."""
    same = {shifting: [one for one in rows if one["shifting"] is shifting and "Fc" in one] for shifting in (True, False)}
    both = {one["spacing"] for one in same[True]} & {one["spacing"] for one in same[False]}
    if not both:
        return "No spacing has run both with shifting and without."
    finest = min(both)
    mean = {shifting: {name: numpy.mean([one[name] for one in found if one["spacing"] == finest])
                       for name in ("Fc", "voids", "nearest")} for shifting, found in same.items()}
    return (f"**At {finest:.3g} um, with shifting (without): F_c {mean[True]['Fc']:.1f} ({mean[False]['Fc']:.1f}) N, voids in "
            f"{100 * mean[True]['voids']:.1f} ({100 * mean[False]['voids']:.1f}) % of the chip, nearest neighbours "
            f"{mean[True]['nearest']:.2f} ({mean[False]['nearest']:.2f}) spacings apart.**")


def page(rows):
    head = ["spacing, um", "shifting", "F_c, N", "F_f, N"] + [title for _, title, _, _ in COLUMNS]
    table = []
    for key in sorted({(one["shifting"], one["spacing"]) for one in rows}, key=lambda k: (not k[0], -k[1])):
        same = [one for one in rows if (one["shifting"], one["spacing"]) == key and "Fc" in one]
        if same:
            table.append(line(same))
    failed = [f"Did not end: {one['spacing']:g} um, {one['ended']}" for one in rows if "Fc" not in one]
    text = (ROOT / "bench/chip/page.md").read_text().replace("SUMMARY", summary(rows))
    before, after = text.split("TABLE")
    reports.write("chip", [before, *reports.table(head, table, key=2), *failed, after])


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--spacings", type=float, nargs="+", default=[10, 8, 80 / 12, 5, 4])
    options = parser.parse_args()
    jobs = [(spacing, offset, shifting) for spacing in options.spacings for shifting in (True, False)
            for offset in OFFSETS]
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        page(list(pool.map(run, jobs)))


if __name__ == "__main__":
    main()
