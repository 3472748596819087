"""STUDY.toml: which decks a study runs."""
import difflib
import itertools
import pathlib
import tomllib
from dataclasses import dataclass, field

import numpy
from scipy.stats import qmc

from .. import decks
from ..units import quantity, si

DESIGNS = ("one_at_a_time", "grid", "latin_hypercube", "sobol")
KEYS = {"deck": str, "title": str, "design": str, "samples": int, "seed": int, "windows": str, "threads": int,
        "response": str, "surface": str, "base": dict, "parameter": list, "repeats": dict}
PARAMETER_KEYS = {"key", "name", "values", "range", "levels"}
REPEATS_KEYS = {"count", "key", "step"}
RESPONSES = ("force_planar", "force_x", "force_y", "force_z", "torque", "force_planar_peak", "max_temperature")


def unit_of(value):
    """"um" of "10 um"; "" of a number; None of a word."""
    if isinstance(value, str):
        number, _, unit = value.partition(" ")
        try:
            float(number), si(value)
        except ValueError:
            return None
        return unit
    return "" if isinstance(value, (int, float)) and not isinstance(value, bool) else None


def number_of(value, unit):
    """In that unit; of the deck's own value, which may have another."""
    if not unit:
        return float(value)
    if unit_of(value) == unit:
        return float(value.partition(" ")[0])
    return si(value) - 273.15 if unit == "degC" else si(value) / si(f"1 {unit}")


@dataclass
class Parameter:
    keys: list          # paths in the deck; all take the value
    name: str
    unit: str           # None: of words, which have no order
    values: list        # levels; of a range its ends and what lies between
    low: float = None   # of numbers
    high: float = None

    def at(self, share):
        """The value that share of the way from low to high, as the deck has it."""
        value = self.low + share * (self.high - self.low)
        return f"{value:.9g} {self.unit}" if self.unit else float(f"{value:.9g}")

    def number(self, value):
        return number_of(value, self.unit) if self.unit is not None else float(self.values.index(value))

    @property
    def title(self):
        return f"{self.name} [{self.unit}]" if self.unit else self.name


@dataclass
class Task:
    """One run: the point of the plan it belongs to, and which repeat of it."""
    number: int
    point: int
    repeat: int
    changes: dict


@dataclass
class Study:
    file: pathlib.Path
    deck: dict
    deck_file: pathlib.Path
    title: str
    design: str
    parameters: list
    points: list                     # {name of the parameter: value}
    base_point: int = None           # of one_at_a_time: the deck as it is
    windows: str = ""
    threads: int = 1
    response: str = "force_planar"
    surface: str = ""
    repeats: dict = field(default_factory=lambda: {"count": 1})
    tasks: list = field(default_factory=list)

    def deck_of(self, task):
        return decks.vary(self.deck, task.changes)


def complain(path, key, message):
    raise ValueError(f"{path}: {key}: {message}")


def check_keys(path, table, known, where=""):
    for key in table:
        if key not in known:
            near = difflib.get_close_matches(key, known, 1)
            complain(path, where + key, "is not a known key." + (f' Did you mean "{near[0]}"?' if near else
                                                                 f" Known are {', '.join(sorted(known))}."))


def read_parameter(path, one, deck, design):
    check_keys(path, one, PARAMETER_KEYS, "parameter.")
    if "key" not in one:
        complain(path, "parameter.key", 'is missing: the path of a key of the deck, such as "tool.edge_radius"')
    keys = one["key"] if isinstance(one["key"], list) else [one["key"]]
    where = f"parameter {keys[0]}"
    if ("values" in one) == ("range" in one):
        complain(path, where, "give either values = [...] or range = [low, high]")
    listed = one.get("values", one.get("range"))
    if not isinstance(listed, list) or len(listed) < (2 if "range" in one else 1):
        complain(path, where, "expected a list" + (" of two, low and high" if "range" in one else ""))
    units = {unit_of(value) for value in listed}
    if "range" in one and None in units:
        complain(path, where, 'a range is of numbers, such as ["2 um", "20 um"]')
    if None not in units and len(units) > 1:
        complain(path, where, f"give all values in one unit, not in {' and '.join(sorted(units))}")
    unit = None if None in units else units.pop()
    name = one.get("name", keys[0].rpartition(".")[2])
    parameter = Parameter(keys, name, unit, list(listed))
    if unit is not None:
        numbers = [number_of(value, unit) for value in listed]
        parameter.low, parameter.high = min(numbers), max(numbers)
    if "range" in one:
        if not numbers[0] < numbers[1]:
            complain(path, where, "expected low < high in range")
        levels = one.get("levels", 2)
        if not isinstance(levels, int) or levels < 2:
            complain(path, where, "expected levels = 2 or more")
        parameter.values = [parameter.at(share) for share in numpy.linspace(0, 1, levels)]
    elif design in ("latin_hypercube", "sobol") and (unit is None or parameter.low == parameter.high):
        complain(path, where, f"{design} needs numbers from low to high: use range = [low, high], or design = \"grid\"")
    return parameter


def base_value(deck, key):
    return decks.flat(deck).get(key)


def make_points(path, design, parameters, deck, samples, seed):
    """Points of the plan, and which of them is the deck as it is."""
    names = [parameter.name for parameter in parameters]
    if design == "grid":
        return [dict(zip(names, values)) for values in itertools.product(*(one.values for one in parameters))], None
    if design == "one_at_a_time":
        base = {}
        for parameter in parameters:
            base[parameter.name] = base_value(deck, parameter.keys[0])
            if base[parameter.name] is None:
                complain(path, f"parameter {parameter.keys[0]}", "the deck has no such key to start from; set it in "
                         "[base]")
            if parameter.unit is None and base[parameter.name] not in parameter.values:
                parameter.values.insert(0, base[parameter.name])
        points = [base]
        for parameter in parameters:
            for value in parameter.values:
                if value != base[parameter.name] and parameter.number(value) != parameter.number(base[parameter.name]):
                    points.append(base | {parameter.name: value})
        return points, 0
    count = len(parameters)
    if design == "sobol":
        sampler = qmc.Sobol(count, scramble=True, seed=seed)
        if samples & (samples - 1):
            complain(path, "samples", f"a Sobol sequence is even with powers of two only: use {1 << samples.bit_length()}")
        shares = sampler.random(samples)
    else:
        shares = qmc.LatinHypercube(count, seed=seed).random(samples)
    return [{one.name: one.at(share) for one, share in zip(parameters, row)} for row in shares], None


def changes_of(study, point):
    return {key: value for one in study.parameters for key in one.keys for value in [point[one.name]]}


def read(path):
    path = pathlib.Path(path)
    try:
        with open(path, "rb") as file:
            table = tomllib.load(file)
    except tomllib.TOMLDecodeError as error:
        raise ValueError(f"{path}: this is not TOML: {error}") from None
    check_keys(path, table, KEYS)
    for key, kind in KEYS.items():
        if key in table and not isinstance(table[key], kind):
            complain(path, key, f"expected {kind.__name__}")
    for key in ("deck", "parameter", "design"):
        if key not in table:
            complain(path, key, "is missing")
    design = table["design"]
    if design not in DESIGNS:
        complain(path, "design", f"expected one of {', '.join(DESIGNS)}")
    if table.get("response", RESPONSES[0]) not in RESPONSES:
        complain(path, "response", f"expected one of {', '.join(RESPONSES)}")
    if table.get("surface", "") not in ("", "quadratic", "gaussian_process", "none"):
        complain(path, "surface", "expected quadratic, gaussian_process or none")
    samples = table.get("samples", 0)
    if (samples > 0) != (design in ("latin_hypercube", "sobol")):
        complain(path, "samples", "goes with latin_hypercube and sobol, which need it")
    deck_file = path.parent / table["deck"]
    deck = decks.vary(decks.read(deck_file), table.get("base", {}))
    parameters = [read_parameter(path, one, deck, design) for one in table["parameter"]]
    names = [one.name for one in parameters]
    if len(set(names)) < len(names):
        complain(path, "parameter", "two have the same name; give one a name of its own")
    points, base = make_points(path, design, parameters, deck, samples, table.get("seed", 1))
    repeats = {"count": 1} | table.get("repeats", {})
    check_keys(path, repeats, REPEATS_KEYS, "repeats.")
    if repeats["count"] > 1 and not {"key", "step"} <= set(repeats):
        complain(path, "repeats", 'count > 1 needs key and step, such as key = "tool.start_angle", step = "0.1 deg"')
    study = Study(path, deck, deck_file, table.get("title", path.stem), design, parameters, points, base,
                  table.get("windows", ""), table.get("threads", 1), table.get("response", RESPONSES[0]),
                  table.get("surface", ""), repeats)
    for k, point in enumerate(points):
        for repeat in range(repeats["count"]):
            changes = changes_of(study, point)
            if repeat:
                unit = unit_of(repeats["step"])
                start = changes.get(repeats["key"], base_value(deck, repeats["key"]))
                if start is None:
                    complain(path, "repeats.key", f"the deck has no {repeats['key']}")
                changes[repeats["key"]] = (quantity(si(start) + repeat * si(repeats["step"]), unit) if unit
                                           else start + repeat * repeats["step"])
            study.tasks.append(Task(len(study.tasks), k, repeat, changes))
    return study
