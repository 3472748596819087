"""Runs the cells of the stability matrix, each in a process of its own, and keeps one line of results for each in
tests/stability/results.jsonl; then draws docs/reports/stability.md (stability_page.py)."""
import json
import os
import pathlib
import subprocess
import sys
from fnmatch import fnmatch

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "python"))
from swarf.reports import commit

import stability_page

FOLDER = pathlib.Path("tests/stability")
RESULTS, CATALOGUE = FOLDER / "results.jsonl", FOLDER / "catalogue.json"
PROGRAM_IS_OF = ("include", "kernels", "src", "tests/stability/*pp", "tests/verification")
LIMIT = 300  # seconds for one cell


def read_results():
    lines = RESULTS.read_text().splitlines() if RESULTS.exists() else []
    return {(row["formulation"], row["test"]): row for row in map(json.loads, lines)}


def write(path, text):
    temporary = path.with_suffix(".tmp")
    temporary.write_text(text)
    os.replace(temporary, path)


def run_cell(program, formulation, test):
    environment = {**os.environ, "OMP_NUM_THREADS": "1", "OMP_PROC_BIND": "false"}
    dead = {"formulation": formulation, "test": test, "class": "failed", "decisive": "", "reached": None,
            "measures": {}, "steps": None, "seconds": LIMIT}
    try:
        done = subprocess.run([program, "--formulation", formulation, "--test", test], capture_output=True, text=True,
                              env=environment, timeout=LIMIT, preexec_fn=lambda: os.nice(10))
    except subprocess.TimeoutExpired:
        return {**dead, "fault": f"stopped after {LIMIT} s"}
    if done.returncode != 0:
        return {**dead, "fault": (done.stderr.strip().splitlines() or [f"exit status {done.returncode}"])[-1],
                "seconds": None}
    return json.loads(done.stdout)


def main():
    build, wanted = pathlib.Path(sys.argv[1]), sys.argv[2:]
    if wanted != ["--page"]:
        program = build / "tests" / "stability" / "stability"
        catalogue = json.loads(subprocess.run([program, "--list"], capture_output=True, text=True, check=True).stdout)
        write(CATALOGUE, json.dumps(catalogue, indent=1) + "\n")
        results = read_results()
        cells = [(row["name"], test) for row in catalogue["formulations"] for test in row["tests"]]
        results = {cell: results[cell] for cell in cells if cell in results}
        for cell in cells:
            name = "/".join(cell)
            asked = any(fnmatch(name, w if "/" in w else w + "/*") for w in wanted if not w.startswith("--"))
            missing = cell not in results and (not wanted or wanted == ["--all"])
            if not (asked or missing or wanted == ["--all"]):
                continue
            row = {**run_cell(program, *cell), "commit": commit(*PROGRAM_IS_OF)}
            results[cell] = row
            write(RESULTS, "".join(json.dumps(results[c]) + "\n" for c in cells if c in results))
            print(f"{name:<44} {row['class']:<9} {row['decisive'] or row['fault'][:60]}", flush=True)
    catalogue = json.loads(CATALOGUE.read_text())
    stability_page.write_page(catalogue, read_results())


main()
