"""Decks as Python dictionaries: read, change, compare, write. And what a run of one will cost, roughly."""
import math
import re
import tomllib

UNITS = {"m": 1, "mm": 1e-3, "um": 1e-6, "s": 1, "ms": 1e-3, "us": 1e-6, "deg": math.pi / 180, "rad": 1,
         "m/s": 1, "m/min": 1 / 60, "rpm": 2 * math.pi / 60, "GPa": 1e9, "MPa": 1e6, "kg/m3": 1}


def read(path):
    with open(path, "rb") as file:
        return tomllib.load(file)


def si(text):
    """The value of "10 um" in SI units."""
    number, unit = text.split(maxsplit=1)
    return float(number) * UNITS[unit]


def length(value):
    return f"{value * 1e6:.9g} um"


def body(deck, name):
    return next((one for one in deck["body"] if one["name"] == name), None)


def _value(value):
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return '"' + value.replace("\\", "\\\\").replace('"', '\\"') + '"'
    if isinstance(value, list):
        return "[" + ", ".join(_value(one) for one in value) + "]"
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key} = {_value(one)}" for key, one in value.items()) + " }"
    return repr(value)


def _key(key):
    return key if re.fullmatch(r"[A-Za-z0-9_-]+", key) else _value(key)


def _table(table, head, name, lines):
    if head:
        lines += ["", head]
    nested = {}
    for key, value in table.items():
        if isinstance(value, dict) or (key == "body" and isinstance(value, list)):
            nested[key] = value
        else:
            lines.append(f"{_key(key)} = {_value(value)}")
    for key, value in nested.items():
        path = f"{name}.{_key(key)}" if name else _key(key)
        for one in value if isinstance(value, list) else [value]:
            _table(one, f"[[{path}]]" if isinstance(value, list) else f"[{path}]", path, lines)


def text(deck):
    lines = []
    _table(deck, "", "", lines)
    return "\n".join(lines) + "\n"


def flat(value, path=""):
    """{"run.courant": 0.5, "body[cut zone].spacing": "5 um", ...}"""
    if isinstance(value, dict):
        items = [(f"{path}.{key}" if path else key, one) for key, one in value.items()]
    elif isinstance(value, list) and (not value or isinstance(value[0], dict)):
        items = [(f"{path}[{one.get('name', k)}]", one) for k, one in enumerate(value)]
    else:
        return {path: value}
    return {key: leaf for name, one in items for key, leaf in flat(one, name).items()}


def changes(deck, base, but=("title", "output.")):
    """The keys in which deck differs from base, as text. A body that only one of them has is named as a whole."""
    ours, theirs = {one["name"]: one for one in deck["body"]}, {one["name"]: one for one in base["body"]}
    parts = [f"no body[{name}]" for name in theirs if name not in ours]
    parts += [f"body[{name}] of {_volume_and_cells(one)[1]} {one['fill']}"
              + "".join(f", {key} = {_value(one[key])}" for key in one if key.startswith("convert"))
              for name, one in ours.items() if name not in theirs]
    shared = [name for name in ours if name in theirs]
    new, old = (flat({**one, "body": [body(one, name) for name in shared]}) for one in (deck, base))
    names = [key for key in list(old) + [key for key in new if key not in old]
             if new.get(key) != old.get(key) and not key.startswith(but)]
    return "; ".join(parts + [f"{key} = {_value(new[key])}" if key in new else f"no {key}" for key in names])


def _volume_and_cells(one):
    """Volume of a body, m3, and its number of cells."""
    if one["shape"] == "block":
        edges = [si(edge) for edge in one["size"]]
    else:  # a sector of a ring: around, axial, radial
        inner, outer = si(one["inner_radius"]), si(one["outer_radius"])
        angle = si(one.get("end_angle", "360 deg")) - si(one.get("start_angle", "0 deg"))
        edges = [angle * (inner + outer) / 2, si(one["height"]), outer - inner]
    if "cells" in one:
        return math.prod(edges), math.prod(one["cells"])
    spacing = si(one["spacing"])
    return math.prod(edges), math.prod(max(1, round(edge / spacing)) for edge in edges)


def end_time(deck):
    if "end_time" in deck["run"]:
        return si(deck["run"]["end_time"])
    turn = si(deck["run"]["end_immersion"]) - si(deck["tool"]["start_angle"])
    return turn / si(deck["tool"]["spindle_speed"])


def predicted_core_seconds(deck, seconds_per_particle_step=2e-6):
    """Steps by the Courant number and the scaled wave speed; work by counts and neighbours."""
    material = next(iter(deck["material"].values()))
    E, nu = si(material["youngs_modulus"]), material["poissons_ratio"]
    wave = math.sqrt(E * (1 - nu) / (1 + nu) / (1 - 2 * nu) / si(material["density"]) / deck["run"]["mass_factor"])
    ratio = deck.get("particles", {}).get("smoothing_ratio", 1.2)
    work, reach = 0, math.inf
    for one in deck["body"]:
        volume, cells = _volume_and_cells(one)
        spacing = (volume / cells) ** (1 / 3)
        if one["fill"] == "particles":
            work += cells * (ratio / 1.2) ** 3
            reach = min(reach, ratio * spacing)
        else:
            work += 0.3 * cells
            reach = min(reach, spacing)
    steps = end_time(deck) / (deck["run"].get("courant", 0.3) * reach / wave)
    return work * steps * seconds_per_particle_step
