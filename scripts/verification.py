"""Runs the verification programs, one test at a time, and writes docs/reports/verification.md with its plots.

A test writes its rows and curves into the folder named by SWARF_VERIFICATION (tests/verification/case.hpp). They are
kept in BUILD/verification/results, so that the page can be made again after a part of the cases was run.
"""
import json
import os
import re
import shutil
import subprocess
import sys
import time
from fnmatch import fnmatch
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "python"))
import matplotlib.pyplot as plt
from swarf import reports

LIMIT = float(os.environ.get("SWARF_VERIFY_LIMIT", 7200))  # seconds for one test


def tests_of(program):
    listing = subprocess.run([program, "--gtest_list_tests"], capture_output=True, text=True, check=True).stdout
    suite = ""
    for line in listing.splitlines():
        if line.startswith("  "):
            yield suite + line.split()[0]
        elif line.endswith("."):
            suite = line


def run_test(program, test, folder):
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    print(f"{program.name} {test}", flush=True)
    begin = time.monotonic()
    with open(folder / "log", "w") as log:
        try:
            status = subprocess.run([program, f"--gtest_filter={test}"], stdout=log, stderr=subprocess.STDOUT,
                                    env=dict(os.environ, SWARF_VERIFICATION=str(folder)), timeout=LIMIT).returncode
        except subprocess.TimeoutExpired:
            status = f"stopped after {LIMIT:g} s"
    result = {"status": status, "seconds": time.monotonic() - begin, "threads": os.environ.get("OMP_NUM_THREADS", "2"),
              "commit": reports.commit("include", "kernels", "src", "tests")}
    (folder / "test.json").write_text(json.dumps(result))
    print(f"  {'ok' if status == 0 else 'FAILED'} after {result['seconds']:.1f} s", flush=True)


def read_lines(file):
    return [json.loads(line) for line in file.read_text().splitlines()] if file.exists() else []


def passes(row):
    return row["error"] is not None and row["error"] <= row["allowed"]


def results_of(program, test, folder):
    """The rows of one test; a test that ended badly without a failing row gets one that says so."""
    if not (folder / "test.json").exists():
        return [], [], None
    result = json.loads((folder / "test.json").read_text())
    rows = read_lines(folder / "rows.jsonl")
    if result["status"] != 0 and all(passes(r) != bool(r["known_fault"]) for r in rows):
        text = re.findall(r"(?:C\+\+ exception with description \"|Failure\n)(.*)", (folder / "log").read_text())
        rows.append({"name": rows[-1]["name"] if rows else program.name, "what": f"{test} ends without a fault",
                     "parameters": "", "reference": 0, "unit": "", "source": "", "ours": None, "error": None,
                     "allowed": 0, "absolute": True, "known_fault": text[0] if text else f"exit status {result['status']}"})
    for row in rows:
        row["seconds"] = None
    if rows:
        rows[0]["seconds"] = result["seconds"]
    return rows, read_lines(folder / "curves.jsonl"), result


def number(value, digits):
    return "-" if value is None else f"{value:.{digits}g}"


def error_text(row, key):
    value = row[key]
    if value is None:
        return "-"
    return number(value, 2) if row["absolute"] else f"{100 * value:.2g} %"


def plot(curve, file):
    figure, axes = plt.subplots(figsize=(6.4, 4.2), constrained_layout=True)
    markers = iter("osD^vP*X" * 4)
    for s in curve["series"]:
        style = {"color": "black"} if s["reference"] else {}
        if s["points"]:
            style.update(linestyle="none", marker="o" if s["reference"] else next(markers), markersize=5, fillstyle="none")
        elif curve["log_log"] and not s["reference"]:
            style.update(marker=next(markers), markersize=5)
        if s["reference"] and not s["points"]:
            style.update(linewidth=1.0, linestyle="--")
        pairs = [(x, y) for x, y in zip(s["x"], s["y"]) if x is not None and y is not None]
        axes.plot([x for x, _ in pairs], [y for _, y in pairs], label=s["label"],
                  zorder=3 if s["reference"] else 2, **style)
    if curve["log_log"]:
        axes.set_xscale("log"), axes.set_yscale("log")
    axes.set_xlabel(curve["x_label"]), axes.set_ylabel(curve["y_label"])
    axes.set_title(curve["title"], fontsize=10)
    axes.grid(alpha=0.3), axes.legend(fontsize=8)
    figure.savefig(file, dpi=110, metadata={"Software": None})
    plt.close(figure)


def by_case(rows):
    found = {}
    for row in rows:
        found.setdefault(row["name"], []).append(row)
    return found


def summary(cases):
    """A line for each case."""
    return reports.table(["case", "rows", "pass", "run time"], [
        [name, len(rows), "yes" if all(map(passes, rows)) else f"**{len([r for r in rows if not passes(r)])} FAIL**",
         f"{sum(r['seconds'] or 0 for r in rows):.1f} s"] for name, rows in cases.items()])


def case_table(rows, sources):
    table = []
    for r in rows:
        unit = f" {r['unit']}" if r["unit"] else ""
        source = f" [{sources.index(r['source']) + 1}](#sources)" if r["source"] else ""
        table.append([r["what"] + source, r["parameters"], number(r["reference"], 6) + unit, number(r["ours"], 6) + unit,
                      error_text(r, "error"), error_text(r, "allowed"), "yes" if passes(r) else "**FAIL**"])
    return reports.table(["tests", "parameters", "reference", "ours", "error", "allowed", "pass"], table)


def write_page(rows, curves, results, missing):
    sources = list(dict.fromkeys(r["source"] for r in rows if r["source"]))
    bad = [r for r in rows if not passes(r)]
    commits, threads = ({r[key] for r in results} for key in ("commit", "threads"))
    lines = ["# Verification", "",
             "Made by `scripts/verify`; no number here is typed by hand. Every row is an assertion of a test in "
             "tests/verification, where the reason of the allowed error stands beside it. A row that fails is asserted to "
             "fail, and says below why, as far as is known.", "",
             f"**{len(rows) - len(bad)} of {len(rows)} rows pass.** Commit {', '.join(sorted(commits))}; "
             f"{', '.join(sorted(threads))} thread(s) of {reports.processor()}.", *summary(by_case(rows))]
    if missing:
        lines += ["Not run: " + ", ".join(missing) + ".", ""]
    if bad:
        lines += ["## Rows that fail", ""]
        lines += [f"- {r['name']}, {r['what']} ({r['parameters']}): {r['known_fault'] or 'cause not known'}" for r in bad]
    for name, of_case in by_case(rows).items():
        lines += ["", f"## {name}", *case_table(of_case, sources)]
    if curves:
        lines += ["## Curves", ""]
        lines += [f"![{c['title']}](verification/{c['file']}.png)" for c in curves]
    lines += ["", "## Sources", ""] + [f"{k + 1}. {s}" for k, s in enumerate(sources)]
    reports.write("verification", lines)
    return bad


def main():
    build, wanted = Path(sys.argv[1]), sys.argv[2:]
    folder = (build / "verification").resolve()
    programs = sorted(p for p in folder.glob("verify_*") if p.is_file())
    rows, curves, results, missing = [], [], [], []
    for program in programs:
        for test in tests_of(program):
            place = folder / "results" / program.name / test
            if not wanted or any(fnmatch(f"{program.name}/{test}", w if "/" in w else w + "/*")
                                 for w in wanted):
                run_test(program, test, place)
            new_rows, new_curves, result = results_of(program, test, place)
            missing += [] if result else [f"{program.name} {test}"]
            rows += new_rows
            curves += new_curves
            results += [result] if result else []
    rows.sort(key=lambda r: int((re.match(r"\d+", r["name"]) or ["999"])[0]))  # stable: keeps the order of a test
    pictures = reports.FOLDER / "verification"
    shutil.rmtree(pictures, ignore_errors=True)
    pictures.mkdir(parents=True)
    for curve in curves:
        plot(curve, pictures / f"{curve['file']}.png")
    bad = write_page(rows, curves, results, missing)
    for r in bad:
        print(f"FAIL {r['name']}: {r['what']} ({r['parameters']})")
    print(f"{len(rows) - len(bad)} of {len(rows)} rows pass: docs/reports/verification.md")
    return any(result["status"] != 0 for result in results)


sys.exit(main())
