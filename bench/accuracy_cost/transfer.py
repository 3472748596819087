"""src/accuracy/chart.toml: the points of the chart in terms that carry over to another deck, for the key run.accuracy.

Lengths are counted in uncut chip thicknesses h or in spacings, inertia as wave speed of the scaled mass over cutting
speed. A point whose changes cannot be said so (a shorter work, another build, hexes only) is left out: nothing is
promised from it. Points are read from the keys changed of results.csv, so also those that the sweep found itself.
"""
import json
import math
import pathlib
import re
import sys

import tomli_w
from swarf import decks, si

import advise
import ranking
from points import MEAN_OF, Point
from reference import ENERGY

WINDOWS = pathlib.Path(__file__).resolve().parents[1] / "windows"
sys.path.append(str(WINDOWS))
from common import AHEAD, RUN_INS, SPACING, WIDTH, ratio_of_means

HEAD = """# Written by bench/accuracy_cost/draw.py from results.csv, and from bench/windows/results.json: what the key
# run.accuracy picks from. Not to be edited.
# Errors are of the mean cutting force of one run (of three where runs = 3), relative to the reference; level: the most
# that error and standard error come to together, here and at all finer spacings with the same settings. Where it is
# missing the settings have run at one spacing only, or a finer one did not keep its energy. Windows: against the whole
# pass in the same cells, deg.
"""
SLICE = re.compile(r"body\[.*\]\.height|tool\.(width|length)")
ENTRY = re.compile(r"body\[.*\]\.end_angle|tool\.start_angle|run\.end_time")


def carries(name, value, base, face):
    """Has this change of a key a meaning in another deck?"""
    if name.startswith("particles.") or name in ("run.mass_factor", "run.courant", "sleep.distance"):
        return True
    if name in ("body[bulk]", "body[cut zone].tie", f"body[cut zone].faces.{face}") or SLICE.fullmatch(name):
        return True
    if ENTRY.fullmatch(name):
        return True  # less cut before the mean: the deck's own is longer
    last = name.rsplit(".", 1)[-1]
    if last == "size":  # the height is the depth of the work; the length is looked at as what lies ahead
        return base[name][1] == value[1]
    if last == "cells":
        return base[name][2] == value[2]
    return last == "position" and base[name][:2] == value[:2]


def ahead(scene, flat):
    """Of the work in front of the tool at the end, m; infinite where its length is not along the cut."""
    if scene.name != "orthogonal":
        return math.inf
    end = si(flat["tool.position"][0]) + si(flat["tool.velocity"][0]) * si(flat["run.end_time"])
    return si(flat["body[cut zone].size"][0]) - end - si(flat["tool.edge_radius"])


def wave_speed(flat):
    E, nu, rho = (next(one for key, one in flat.items() if key.endswith("." + name))
                  for name in ("youngs_modulus", "poissons_ratio", "density"))
    return math.sqrt(si(E) * (1 - nu) / (1 + nu) / (1 - 2 * nu) / si(rho))


def cut(scene, deck, flat):
    """Of the scene: uncut chip, m; cutting speed, m/s; time of the run, s; cut before the mean and in it, m."""
    if scene.name == "orthogonal":
        speed, end = si(flat["tool.velocity"][0]), si(flat["run.end_time"])
        gap = -si(flat["tool.position"][0]) - si(flat["tool.edge_radius"])
        run_in = (1 - scene.averaged) * end * speed - gap
        return scene.uncut(deck, 0), speed, end, run_in, scene.averaged * end * speed
    radius, spindle = si(flat["tool.diameter"]) / 2, si(flat["tool.spindle_speed"])
    end = (si(flat["run.end_immersion"]) - si(flat["tool.start_angle"])) / spindle
    entry = math.pi / 2 - si(flat["body[cut zone].end_angle"])
    begin, last = (math.radians(one) for one in scene.immersion)
    return si(flat["tool.feed_per_tooth"]), radius * spindle, end, (begin - entry) * radius, (last - begin) * radius


def point(scene, root, row, rows, found):
    """One entry of the file, or None if the row cannot be carried over."""
    deck, changes = Point(scene, "", "", spacing=row["spacing"]).deck(root), row["changes"]
    base, flat = (decks.flat(one) for one in (deck, decks.vary(deck, changes)))
    face = "y_min" if scene.name == "orthogonal" else "outer"
    if row["build"] != "release" or not all(carries(*one, base, face) for one in changes.items()):
        return None
    if ahead(scene, flat) < ahead(scene, base) - 20e-6:  # it is set in steps of 40 um
        return None
    chip, speed, end, run_in, measured = cut(scene, deck, flat)
    spacing, mass = row["spacing"] * 1e-6, flat["run.mass_factor"]
    scaled = wave_speed(flat) / math.sqrt(mass)
    thickness = si(flat["body[cut zone].size"][2] if scene.name == "orthogonal" else flat["body[cut zone].height"])
    runs = row["runs"] if row["group"] in MEAN_OF.values() else 1
    reference = found["cutting_force"]
    entry = {
        "label": row["label"], "runs": runs, "chip_rows": chip / spacing, "slice_rows": round(thickness / spacing),
        "wave_over_speed": scaled / speed, "courant": flat["run.courant"], "bulk": "body[bulk]" not in changes,
        "particles": {key.removeprefix("particles."): one for key, one in flat.items() if key.startswith("particles.")},
        "sleep_rows": si(flat["sleep.distance"]) / spacing if "sleep.distance" in flat else 0.0,
        "run_in": run_in / chip, "measured": measured / chip, "error": ranking.likely_error(row, found),
        "standard_error": row["cutting_force_error"] / abs(reference.value),
        "level": advise.level_of_finer(row, rows, found), "energy_residual": row["energy_residual"],
        "core_seconds": row["core_seconds"], "cost": row["core_seconds"] / advise.base_of(scene, rows)["core_seconds"],
        "step": end / row["steps"] * scaled / spacing,
        "seconds_per_particle_step": row["core_seconds"] / row["particle_steps"]}
    return {key: value for key, value in entry.items() if value is not None}


def scene_table(scene, root, rows, found):
    deck = Point(scene, "", "", spacing=scene.spacing).deck(root)
    flat = decks.flat(deck)
    reference, chip = found["cutting_force"], cut(scene, deck, flat)[0]
    zone = decks.body(deck, "cut zone")
    depth = -si(zone["origin"][1]) if scene.name == "orthogonal" else (
        si(zone["outer_radius"]) - si(zone["inner_radius"]))
    kind = deck["tool"]["kind"]
    where = (f"over the last {100 * scene.averaged:.0f} % of the cut" if scene.name == "orthogonal" else
             f"at immersion {scene.immersion[0]:.0f} to {scene.immersion[1]:.0f} deg")
    entries = [point(scene, root, row, rows, found) for row in sorted(rows, key=lambda one: one["core_seconds"])
               if row["group"] not in ("committed deck", *ranking.ASIDE) and abs(row["energy_residual"]) <= ENERGY]
    table = {"title": scene.title, "deck": scene.deck_file, "reference": reference.value,
             "uncertainty": reference.relative, "said": reference.said, "where": where,
             "edge_over_chip": si(deck["tool"]["edge_radius"]) / chip,
             "rake": math.degrees(si(deck["tool"]["rake"])), "depth": depth / chip,
             "points": [entry for entry in entries if entry]}
    if kind == "end_mill":
        table["windows"] = list(windows(si(deck["tool"]["feed_per_tooth"])))
    return kind, table


def windows(chip):
    found = json.loads((WINDOWS / "results.json").read_text())
    measured = [(SPACING, one["run_in"], one) for one in found["windows"]]
    finest = found["finer"]["whole"]["spacing"]  # that has a whole pass
    measured += [(one["spacing"], RUN_INS[-1], one) for one in found["finer"]["windows"] if one["spacing"] == finest]
    for spacing, run_in, one in measured:
        ratio, error = ratio_of_means([(row["force_planar"], row["whole_planar"]) for row in one["windows"]])
        yield {"chip_rows": 1e6 * chip / spacing, "count": len(one["windows"]), "run_in": float(run_in),
               "width": float(WIDTH), "ahead": float(AHEAD), "error": ratio - 1, "standard_error": error}


def rounded(value):
    if isinstance(value, dict):
        return {key: rounded(one) for key, one in value.items()}
    if isinstance(value, list):
        return [rounded(one) for one in value]
    return float(f"{value:.5g}") if isinstance(value, float) else value


def text(drawn, scenes, root):
    """drawn: {scene: (labels, rows, references)} as draw.py has them."""
    chart = {}
    for name, (_, rows, found) in drawn.items():
        complete = [row for row in rows if row.get("cutting_force") is not None and row["group"] not in ranking.ASIDE]
        kind, table = scene_table(scenes[name], root, complete, found)
        chart[kind] = rounded(table)
    return HEAD + "\n" + tomli_w.dumps(chart)
