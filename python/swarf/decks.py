"""Decks as dictionaries, as TOML has them: read, vary, compare and write.

A key has a path: "run.courant", "material.ti64.A", "body[cut zone].spacing". In brackets stands the name of the table
of a list, or its place in the list if it has no name. Comments of a deck are not kept.
"""
import copy
import json
import math
import re
import tomllib

import tomli_w

from .units import si


def read(path):
    """The deck of a file: {"run": {"courant": 0.5, ...}, "body": [{"name": "cut zone", ...}, ...], ...}."""
    with open(path, "rb") as file:
        return tomllib.load(file)


def write(path, deck):
    with open(path, "wb") as file:
        tomli_w.dump(deck, file)


def body(deck, name):
    """The body of that name, or None."""
    return next((one for one in deck["body"] if one["name"] == name), None)


def flat(value, path=""):
    """{path of the key: value} of all keys; values are numbers, texts and lists of them."""
    if isinstance(value, dict):
        items = [(f"{path}.{key}" if path else key, one) for key, one in value.items()]
    elif isinstance(value, list) and (not value or isinstance(value[0], dict)):
        items = [(f"{path}[{one.get('name', k)}]", one) for k, one in enumerate(value)]
    else:
        return {path: value}
    return {key: leaf for name, one in items for key, leaf in flat(one, name).items()}


def _place(table, name):
    """Where the table of that name or number stands in a list; at its end if there is none."""
    return next((k for k, one in enumerate(table) if str(one.get("name", k)) == name), len(table))


def vary(deck, changes):
    """A copy of the deck with the values of these paths instead of its own. Sections that are missing are made, None
    takes a key out: vary(deck, {"run.courant": 0.5, "body[cut zone].spacing": "4 um", "sleep": None})."""
    deck = copy.deepcopy(deck)
    for path, value in changes.items():
        *parents, last = re.findall(r"([^.\[\]]+)|\[([^\]]*)\]", path)
        table = deck
        for key, name in parents:
            if name:
                table = table[_place(table, name)]
            else:
                table = table.setdefault(key, {})
        key = _place(table, last[1]) if last[1] else last[0]
        if isinstance(table, list):
            table[key:key + 1] = [] if value is None else [copy.deepcopy(value)]
        elif value is None:
            table.pop(key, None)
        else:
            table[key] = copy.deepcopy(value)
    return deck


def changes(deck, base, but=("title", "output.")):
    """What vary needs to make deck of base: {path: value, or None where base alone has the key}. A body that only one
    of them has is one change. Paths that begin as `but` says are left out."""
    ours, theirs = ({one["name"]: one for one in side["body"]} for side in (deck, base))
    found = {f"body[{name}]": None for name in theirs if name not in ours}
    found |= {f"body[{name}]": one for name, one in ours.items() if name not in theirs}
    shared = [name for name in ours if name in theirs]
    new, old = (flat({**side, "body": [body(side, name) for name in shared]}) for side in (deck, base))
    return found | {key: new.get(key) for key in old | new if new.get(key) != old.get(key) and not key.startswith(but)}


def describe(changes):
    """Changes in words, for a reader."""
    def said(path, value):
        if value is None:
            return f"no {path}"
        if isinstance(value, dict):
            more = {key: one for key, one in value.items() if key.startswith("convert")}
            return ", ".join([f"{path} of {volume_and_cells(value)[1]} {value['fill']}"]
                             + [said(*one) for one in more.items()])
        return f"{path} = {json.dumps(value, ensure_ascii=False)}"
    return "; ".join(said(*one) for one in changes.items())


def volume_and_cells(one):
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
    """When the run ends, s."""
    if "end_time" in deck["run"]:
        return si(deck["run"]["end_time"])
    turn = si(deck["run"]["end_immersion"]) - si(deck["tool"]["start_angle"])
    return turn / si(deck["tool"]["spindle_speed"])
