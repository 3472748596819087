"""The page itself: one file, nothing of which comes from a network."""
import base64
import csv
import datetime
import html
import json
import pathlib
import re
import subprocess

from .. import decks, results
from ..units import si
from . import curves, frames

HERE = pathlib.Path(__file__).parent
BUDGET = 8e6  # bytes of all 3D views before they are deflated
SCENES = 4    # views of one page: browsers draw few at once
PICTURES = 3e6
HANDY = [("rad/s", "rpm", 60 / (2 * 3.141592653589793)), ("rad", "deg", 180 / 3.141592653589793)]


def escape(text):
    return html.escape(str(text), quote=True)


def handy(value):
    """A value of a resolved deck, in SI units, in the unit that machinists use."""
    if isinstance(value, list):
        return "[" + ", ".join(handy(one) for one in value) + "]"
    if not isinstance(value, str) or not re.match(r"[-+.\d]", value) or " " not in value:
        return str(value).lower() if isinstance(value, bool) else str(value)
    number, unit = value.split(" ", 1)
    try:
        amount = float(number)
    except ValueError:
        return value
    for si_unit, other, factor in HANDY:
        if unit == si_unit:
            return f"{amount * factor:.6g} {other}"
    if unit in ("m", "s", "Pa", "Hz", "N", "N/m") and amount:
        steps = {"m": (-6, -3, 0), "s": (-6, -3, 0), "Pa": (0, 6, 9), "Hz": (0, 3, 6), "N": (0,), "N/m": (0,)}[unit]
        ten = max([k for k in steps if abs(amount) >= 10**k * 0.9999999] or [steps[0]])
        prefix = {-6: "u", -3: "m", 0: "", 3: "k", 6: "M", 9: "G"}[ten]
        return f"{amount / 10**ten:.6g} {prefix}{unit}"
    return f"{amount:.6g} {unit}"


def table(head, rows, name=None):
    """Cells that are numbers stand to the right."""
    def cell(text):
        text = str(text)
        return f'<td{" class=number" if re.fullmatch(r"[-+]?[0-9.]+(e[-+]?[0-9]+)?( %| [A-Za-z/0-9]+)?", text) else ""}>' \
            f"{escape(text)}</td>"
    body = "".join(f"<tr>{''.join(map(cell, row))}</tr>" for row in rows)
    top = "".join(f'<th scope="col">{escape(one)}</th>' for one in head)
    button = f'<p><button type="button" data-table="{name}">Table as csv</button></p>' if name else ""
    return f'<div class="wide"><table{f" id={name}" if name else ""}><thead><tr>{top}</tr></thead>' \
        f"<tbody>{body}</tbody></table></div>{button}"


def figure_of(chart):
    return f"""<figure aria-labelledby="{chart['id']}-title"><h3 id="{chart['id']}-title">{escape(chart['title'])}</h3>
<div class="chart" id="{chart['id']}"></div>
<figcaption>Drag to zoom, double click for all; a click on a name hides its curve.
<button type="button" data-chart="{chart['id']}" aria-label="Data of {escape(chart['title'])} as csv">Data as csv</button>
</figcaption></figure>"""


def picture(path, words):
    data = base64.b64encode(path.read_bytes()).decode()
    return f'<figure><img src="data:image/png;base64,{data}" alt="{escape(words)}"><figcaption>{escape(words)}' \
        "</figcaption></figure>"


def strip_of(run):
    """The chip pictures that the run has drawn, as far as there is room."""
    single = sorted((run.folder / "pictures").glob("chip_*.png"))
    chosen, room = [], PICTURES
    for path in single:
        room -= path.stat().st_size
        if room > 0:
            chosen.append(path)
    if not chosen:
        return ""
    titles = {frame.index: frame for frame in run.frames}
    parts = []
    for path in chosen:
        frame = titles.get(int(path.stem.split("_")[1]))
        at = "" if frame is None else f" at {frame.immersion:.1f} deg" if frame.immersion is not None else \
            f" at {1e3 * frame.time:.4g} ms"
        parts.append(picture(path, f"Chip{at}"))
    left = f'<p class="note">{len(single) - len(chosen)} more in the folder.</p>' if len(single) > len(chosen) else ""
    return f'<h3>Chip</h3><div class="strip" tabindex="0" role="group" aria-label="Pictures of the chip">{"".join(parts)}' \
        f"</div>{left}"


def scene_of(scene, data):
    name = scene["id"]
    fields = "".join(f'<option>{escape(one["title"])}{" [" + one["unit"] + "]" if one["unit"] else ""}</option>'
                     for one in scene["fields"])
    has = {part: any(one.get(part) for one in scene["frames"]) for part in ("particles", "hexes", "tool")}
    boxes = "".join(f'<label{"" if has[part] else " hidden"}><input type="checkbox" id="{name}-{part}"'
                    f'{" checked" if has[part] else ""}> {part}</label>' for part in has)
    return f"""<h3 id="{name}-title">The cut, to turn</h3>
<div class="scene" id="{name}" role="group" aria-labelledby="{name}-title"></div>
<div class="controls" role="group" aria-label="Controls of the view">
<button type="button" id="{name}-play">Play</button>
<label for="{name}-time">Time</label><input type="range" id="{name}-time" min="0" max="{len(scene['frames']) - 1}"
 value="{len(scene['frames']) - 1}"><output id="{name}-now" for="{name}-time"></output></div>
<div class="controls"><label>Colour <select id="{name}-field">{fields}</select></label>
<span><span id="{name}-low"></span> <span class="bar" id="{name}-bar" aria-hidden="true"></span>
<span id="{name}-high"></span></span>{boxes}<button type="button" id="{name}-home">Face the cut</button></div>
<p class="note">Drag turns, the wheel zooms, shift and drag moves; with the keyboard arrows turn, + and - zoom, Home
faces the cut. <span id="{name}-state">The view is being made.</span></p>
<script type="text/plain" id="{name}-data">{data}</script>"""


def ledger(run, names):
    history = run.history
    given = abs(history["external_work"][-1]) or 1
    rows = [(name.replace("_", " "), f"{1e6 * history[name][-1]:.5g} uJ", f"{100 * history[name][-1] / given:.3g} %")
            for name in names if name in history]
    return rows


def key_numbers(run):
    history, filtered = run.history, curves.filtered_of(run)
    late = history["time"] >= 0.5 * (history["time"][0] + history["time"][-1])
    summary = run.summary if run.has_ended else {}
    numbers = [("planar resultant, filtered peak", f"{filtered['force_planar'].max():.4g} N"),
               ("planar resultant, filtered mean of the second half", f"{filtered['force_planar'][late].mean():.4g} N"),
               ("mean F_x, F_y, F_z of the second half",
                ", ".join(f"{history[f'force_{c}'][late].mean():.4g}" for c in "xyz") + " N"),
               ("hottest point of the work", f"{history['max_temperature'].max():.5g} K")]
    if history["external_work"][-1]:
        worst = abs(history["energy_residual"]).max() / abs(history["external_work"]).max()
        numbers.append(("largest energy residual over external work", f"{100 * worst:.3g} %"))
    if summary:
        cost = summary["cost"]
        numbers += [("particles, hexes", f"{summary['particles']}, {summary['hexes']}"),
                    ("steps", summary["steps"]), ("core time", f"{cost['cpu_seconds']:.4g} s"),
                    ("wall time", f"{cost['wall_seconds']:.4g} s, {cost['threads']} threads")]
    return numbers


def comparison(run):
    peak = curves.filtered_of(run)["force_planar"].max()
    rows = [(one["label"], f"{si(one['force']):.4g} N", f"{100 * (peak / si(one['force']) - 1):+.1f} %")
            for one in run.deck.get("output", {}).get("published", [])]
    return rows and f"<h3>Published values</h3><p>The filtered peak of this run is {peak:.4g} N.</p>" + table(
        ["published", "planar resultant", "this run is off by"], rows)


def deck_section(run, name):
    rows = [(path, handy(value)) for path, value in decks.flat(run.deck).items()]
    text = (run.folder / "deck.toml").read_text()
    return f"""<details><summary>All {len(rows)} values of the deck</summary>{table(["key", "value"], rows, f"{name}-deck")}
</details><details><summary>The resolved deck, as a file</summary><pre>{escape(text)}</pre></details>"""


def run_section(run, name, scene, charts):
    parts = [f'<p class="lead">{escape(run.folder)}</p>']
    summary = run.summary if run.has_ended else {}
    ended = summary.get("ended", "not ended yet")
    if ended != "complete":
        parts.append(f'<p class="warning">This run is {escape(ended)}: {escape(summary.get("why", ""))}</p>')
    if summary.get("warnings"):
        parts.append(f'<p class="warning">{escape(summary["warnings"])}</p>')
    parts.append(table(["", "value"], key_numbers(run), f"{name}-numbers"))
    own = [curves.force_chart(run, name), curves.energy_chart(run, name), curves.heat_chart(run, name),
           curves.temperature_chart(run, name)]
    own = [one for one in own if one]
    charts += own
    parts.append(figure_of(own[0]))
    parts.append(comparison(run) or "")
    parts.append(strip_of(run))
    if scene:
        parts.append(scene_of(*scene))
    parts.append('<div class="pair">' + "".join(map(figure_of, own[1:])) + "</div>")
    energy = ledger(run, ["external_work", "plastic_work", "friction_work", "elastic_energy", "kinetic_energy",
                          "viscous_work", "hourglass_work", "contact_energy", "tie_work", "shifting_work",
                          "energy_residual"])
    heat = ledger(run, ["plastic_heat", "friction_work", "work_heat", "tool_heat", "heat_out", "heat_residual"])
    parts.append('<div class="pair"><div><h3>Energy at the end</h3>'
                 + table(["", "energy", "of the external work"], energy, f"{name}-energies")
                 + "</div><div><h3>Heat at the end</h3>"
                 + table(["", "heat", "of the external work"], heat, f"{name}-heats") + "</div></div>")
    parts.append("<h3>Deck</h3>" + deck_section(run, name))
    return "\n".join(parts)


def windows_section(run, name, charts):
    chart = curves.windows_chart(run, name)
    charts.append(chart)
    rows = list(zip(*(run.window_forces[column] for column in run.window_forces)))
    head = [f"{column} [{run.window_forces.units[column]}]" for column in run.window_forces]
    return figure_of(chart) + table(head, [[f"{value:.5g}" for value in row] for row in rows], f"{name}-windows-table")


def study_section(folder, name):
    with open(folder / "study.csv", newline="") as file:
        head, *rows = csv.reader(file)

    def short(text):
        try:
            return f"{float(text):.5g}"
        except ValueError:
            return text
    parts = [picture(folder / file, words) for file, words in (("tornado.png", "Tornado of the study"),
             ("main_effects.png", "Main effects"), ("surface.png", "Response surface")) if (folder / file).exists()]
    parts.append(table(head, [[short(cell) for cell in row] for row in rows], f"{name}-study"))
    parts.append(f"<details><summary>The study, as a file</summary><pre>{escape((folder / 'study.toml').read_text())}</pre>"
                 "</details>")
    return "".join(parts)


def differences(runs, names):
    """Keys that differ between the decks, a column a run."""
    flats = [decks.flat(run.deck) for run in runs]
    keys = [key for key in dict.fromkeys(key for one in flats for key in one)
            if len({json.dumps(one.get(key)) for one in flats}) > 1 and key != "title"]
    return [(key, *(handy(one.get(key, "-")) for one in flats)) for key in keys]


def comparison_section(runs, names, charts):
    parts = []
    chart = curves.compare_chart(runs, names)
    if chart:
        charts.append(chart)
        parts.append(figure_of(chart))
    numbers = [dict(key_numbers(run)) for run in runs]
    keys = list(dict.fromkeys(key for one in numbers for key in one))
    parts.append("<h3>Numbers</h3>" + table(["", *names], [(key, *(one.get(key, "-") for one in numbers)) for key in keys],
                                            "compare-numbers"))
    changed = differences(runs, names)
    parts.append("<h3>What differs between the decks</h3>"
                 + (table(["key", *names], changed, "compare-decks") if changed else "<p>Nothing.</p>"))
    return "".join(parts)


def origin():
    """(how to cite, commit of the sources or None)."""
    root = HERE.parents[2]
    cite = {}
    for folder in (root, HERE.parents[1]):
        if (folder / "CITATION.cff").exists():
            for line in (folder / "CITATION.cff").read_text().splitlines():
                key, _, value = line.partition(": ")
                cite.setdefault(key.strip(" -"), value.strip('"'))
            break
    done = subprocess.run(["git", "-C", root, "rev-parse", "--short", "HEAD"], capture_output=True, text=True) \
        if (root / ".git").exists() else None
    return cite, done.stdout.strip() if done and done.returncode == 0 else None


def cite_section(runs):
    cite, commit = origin()
    versions = sorted({run.summary["version"] for run in runs if run.has_ended and "version" in run.summary})
    commits = sorted({run.summary["commit"] for run in runs if run.has_ended and run.summary.get("commit")})
    said = f"{cite.get('name', 'the swarf authors')}, {cite.get('title', 'swarf')}, version " \
        f"{', '.join(versions) or cite.get('version', 'unknown')}, {cite.get('license', 'BSD-3-Clause')}"
    lines = [f"<p>Cite as: {escape(said)}.</p>"]
    if commits:
        lines.append(f"<p>The program that ran was built from commit {escape(', '.join(commits))}.</p>")
    lines.append(f"<p>This page was made on {datetime.date.today().isoformat()}"
                 + (f" by the sources of commit {escape(commit)}" if commit else "") + ".</p>")
    return "".join(lines)


def short_name(run):
    return run.folder.resolve().name


def title_of(run):
    if (run.folder / "deck.toml").exists():
        return run.deck.get("title", short_name(run))
    return run.joined.get("title", short_name(run)) if (run.folder / "windows.json").exists() else short_name(run)


def make(folders, title=None):
    """The page of these folders of runs, passes in windows or studies."""
    everything = [results.read(folder) for folder in folders]
    runs = [run for run in everything if (run.folder / "history.csv").exists()]
    for run in everything:
        if run not in runs and not (run.folder / "windows.csv").exists() and not (run.folder / "study.csv").exists():
            raise ValueError(f"{run.folder}: holds no results: no history.csv, windows.csv or study.csv")
    names = [short_name(run) for run in runs]
    if len(set(names)) < len(names):
        names = [str(run.folder) for run in runs]
    charts, scenes, sections = [], [], []
    if len(runs) > 1:
        sections.append(("compare", "Comparison", comparison_section(runs, names, charts)))
    shown = min(len(runs), SCENES)
    for k, run in enumerate(everything):
        name = f"run{k}"
        if run in runs:
            scene = frames.pack_scene(run, f"{name}-scene", BUDGET / shown) if runs.index(run) < SCENES else None
            if scene:
                scene[0]["summary"] = "Three-dimensional view of particles, hexes and tool. Arrow keys turn it."
                scenes.append(scene[0])
            heading = "Results" if len(everything) == 1 else f"{names[runs.index(run)]}: {run.deck.get('title', '')}"
            sections.append((name, heading, run_section(run, name, scene, charts)))
        elif (run.folder / "study.csv").exists():
            sections.append((name, f"Study {short_name(run)}", study_section(run.folder, name)))
        else:
            sections.append((name, run.joined.get("title", "windows"), windows_section(run, name, charts)))
    if not title:
        title = title_of(everything[0]) if len(everything) == 1 else f"Comparison of {', '.join(map(short_name, everything))}"
    sections.append(("cite", "How to cite", cite_section(runs)))
    data = json.dumps({"charts": charts, "scenes": scenes}, separators=(",", ":")).replace("<", "\\u003c")
    body = "\n".join(f'<section aria-labelledby="{key}-heading"><h2 id="{key}-heading">{escape(heading)}</h2>{content}'
                     "</section>" for key, heading, content in sections)
    links = "".join(f'<a href="#{key}-heading">{escape(heading)}</a>' for key, heading, _ in sections)
    script = (HERE / "viewer.js").read_text().replace("</script", "<\\/script")
    return f"""<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>{escape(title)}</title><link rel="icon" href="data:,"><style>{(HERE / "page.css").read_text()}</style></head>
<body><header><h1>{escape(title)}</h1><nav aria-label="Parts of this page">{links}</nav></header>
<main>{body}</main>
<script type="application/json" id="page-data">{data}</script>
<script>{script}</script></body></html>
"""
