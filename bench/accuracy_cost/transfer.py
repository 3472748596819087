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
import tomllib

import advise
import decks
import draw
from points import MEAN_OF, Point
from reference import ENERGY

WINDOWS = pathlib.Path(__file__).resolve().parents[1] / "windows"
sys.path.append(str(WINDOWS))
from common import AHEAD, RUN_INS, SPACING, WIDTH, ratio_of_means

HEAD = """# Written by bench/accuracy_cost/draw.py from results.csv, and from bench/windows/results.json: what the key
# run.accuracy picks from. Not to be edited.
# Errors are of the mean cutting force of one run (of three where runs = 3), relative to the reference; level: the most
# that error and standard error come to together, here and at all finer spacings with the same settings. Where it is
# missing the settings have run at one spacing only, or a finer one did not keep its energy.
"""
AXIAL = {"size": 2, "cells": 1, "position": 2}  # entries that the slice changes, of block, ring and tool
SLICE = re.compile(r"body\[.*\]\.height|tool\.(width|length)")
ENTRY = re.compile(r"body\[.*\]\.end_angle|tool\.start_angle|run\.end_time")


def parsed(changes):
    """{"run.courant": 0.5, "body[bulk]": None}; None: removed."""
    found = {}
    for part in changes.split("; ") if changes else []:
        name, equals, value = part.partition(" = ")
        if equals:
            found[name] = tomllib.loads(f"value = {value}")["value"]
        else:
            found[name.removeprefix("no ")] = None
    return found


def changed_deck(scene, root, row):
    """The deck of the base at the row's spacing, the changes, and its flat form with them. Bodies must be the base's."""
    deck = Point(scene, "", "", spacing=row["spacing"]).deck(root)
    flat, changes = decks.flat(deck), parsed(row["changes"])
    for name, value in changes.items():
        if value is None:
            flat = {key: one for key, one in flat.items() if key != name and not key.startswith(name + ".")}
        else:
            flat[name] = value
    return deck, changes, flat


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
    end = decks.si(flat["tool.position"][0]) + decks.si(flat["tool.velocity"][0]) * decks.si(flat["run.end_time"])
    return decks.si(flat["body[cut zone].size"][0]) - end - decks.si(flat["tool.edge_radius"])


def wave_speed(flat):
    E, nu, rho = (next(one for key, one in flat.items() if key.endswith("." + name))
                  for name in ("youngs_modulus", "poissons_ratio", "density"))
    return math.sqrt(decks.si(E) * (1 - nu) / (1 + nu) / (1 - 2 * nu) / decks.si(rho))


def cut(scene, deck, flat):
    """Of the scene: uncut chip, m; cutting speed, m/s; time of the run, s; cut before the mean and in it, m."""
    if scene.name == "orthogonal":
        speed, end = decks.si(flat["tool.velocity"][0]), decks.si(flat["run.end_time"])
        gap = -decks.si(flat["tool.position"][0]) - decks.si(flat["tool.edge_radius"])
        run_in = (1 - scene.averaged) * end * speed - gap
        return scene.uncut(deck, 0), speed, end, run_in, scene.averaged * end * speed
    radius, spindle = decks.si(flat["tool.diameter"]) / 2, decks.si(flat["tool.spindle_speed"])
    end = (decks.si(flat["run.end_immersion"]) - decks.si(flat["tool.start_angle"])) / spindle
    entry = math.pi / 2 - decks.si(flat["body[cut zone].end_angle"])
    begin, last = (math.radians(one) for one in scene.immersion)
    return decks.si(flat["tool.feed_per_tooth"]), radius * spindle, end, (begin - entry) * radius, (last - begin) * radius


def point(scene, root, row, rows, found):
    """One entry of the file, or None if the row cannot be carried over."""
    deck, changes, flat = changed_deck(scene, root, row)
    base = decks.flat(deck)
    face = "y_min" if scene.name == "orthogonal" else "outer"
    if row["build"] != "release" or not all(carries(*one, base, face) for one in changes.items()):
        return None
    if ahead(scene, flat) < ahead(scene, base) - 20e-6:  # it is set in steps of 40 um
        return None
    chip, speed, end, run_in, measured = cut(scene, deck, flat)
    spacing, mass = row["spacing"] * 1e-6, flat["run.mass_factor"]
    scaled = wave_speed(flat) / math.sqrt(mass)
    thickness = decks.si(flat["body[cut zone].size"][2] if scene.name == "orthogonal" else flat["body[cut zone].height"])
    runs = row["runs"] if row["group"] in MEAN_OF.values() else 1
    reference = found["cutting_force"]
    entry = {
        "label": row["label"], "runs": runs, "chip_rows": chip / spacing, "slice_rows": round(thickness / spacing),
        "wave_over_speed": scaled / speed, "courant": flat["run.courant"], "bulk": "body[bulk]" not in changes,
        "particles": {key.removeprefix("particles."): one for key, one in flat.items() if key.startswith("particles.")},
        "sleep_rows": decks.si(flat["sleep.distance"]) / spacing if "sleep.distance" in flat else 0.0,
        "run_in": run_in / chip, "measured": measured / chip, "error": draw.likely_error(row, found),
        "standard_error": row["cutting_force_error"] / abs(reference.value),
        "level": advise.level_of_finer(row, rows, found), "energy_residual": row["energy_residual"],
        "core_seconds": row["core_seconds"], "cost": row["core_seconds"] / advise.base_of(scene, rows)["core_seconds"],
        "step": end / row["steps"] * scaled / spacing,
        "seconds_per_particle_step": row["core_seconds"] / row["particle_steps"]}
    return {key: value for key, value in entry.items() if value is not None}


def scene_lines(scene, root, rows, found):
    deck = Point(scene, "", "", spacing=scene.spacing).deck(root)
    flat = decks.flat(deck)
    reference, chip = found["cutting_force"], cut(scene, deck, flat)[0]
    zone = decks.body(deck, "cut zone")
    depth = -decks.si(zone["origin"][1]) if scene.name == "orthogonal" else (
        decks.si(zone["outer_radius"]) - decks.si(zone["inner_radius"]))
    kind = deck["tool"]["kind"]
    where = (f"over the last {100 * scene.averaged:.0f} % of the cut" if scene.name == "orthogonal" else
             f"at immersion {scene.immersion[0]:.0f} to {scene.immersion[1]:.0f} deg")
    head = {"title": scene.title, "deck": scene.deck_file, "reference": reference.value,
            "uncertainty": reference.relative, "said": reference.said, "where": where, "edge_over_chip":
            decks.si(deck["tool"]["edge_radius"]) / chip, "rake": math.degrees(decks.si(deck["tool"]["rake"])),
            "depth": depth / chip}
    yield f"\n[{kind}]"
    yield from (f"{key} = {value_text(value)}" for key, value in head.items())
    yield "points = ["
    for row in sorted(rows, key=lambda one: one["core_seconds"]):
        if row["group"] in ("committed deck", *draw.ASIDE) or abs(row["energy_residual"]) > ENERGY:
            continue
        if entry := point(scene, root, row, rows, found):
            yield f"  {value_text(entry)},"
    yield "]"
    if kind == "end_mill":
        yield "windows = [ # against the whole pass in the same cells, from bench/windows/results.json; deg"
        yield from (f"  {value_text(entry)}," for entry in windows(decks.si(deck["tool"]["feed_per_tooth"])))
        yield "]"


def windows(chip):
    found = json.loads((WINDOWS / "results.json").read_text())
    measured = [(SPACING, one["run_in"], one) for one in found["windows"]]
    finest = found["finer"]["whole"]["spacing"]  # that has a whole pass
    measured += [(one["spacing"], RUN_INS[-1], one) for one in found["finer"]["windows"] if one["spacing"] == finest]
    for spacing, run_in, one in measured:
        ratio, error = ratio_of_means([(row["force_planar"], row["whole_planar"]) for row in one["windows"]])
        yield {"chip_rows": 1e6 * chip / spacing, "count": len(one["windows"]), "run_in": float(run_in),
               "width": float(WIDTH), "ahead": float(AHEAD), "error": ratio - 1, "standard_error": error}


def value_text(value):
    if isinstance(value, float):
        return repr(float(f"{value:.5g}"))
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key} = {value_text(one)}" for key, one in value.items()) + " }"
    return decks._value(value)


def text(drawn, scenes, root):
    """drawn: {scene: (labels, rows, references)} as draw.py has them."""
    lines = [HEAD.rstrip()]
    for name, (_, rows, found) in drawn.items():
        complete = [row for row in rows if row.get("cutting_force") is not None and row["group"] not in draw.ASIDE]
        lines += scene_lines(scenes[name], root, complete, found)
    return "\n".join(lines) + "\n"
