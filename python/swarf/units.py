"""Quantities as decks say them, "10 um", and their values in SI units, as src/deck/units.cpp reads them."""
import math
import re
from decimal import Decimal

PREFIXES = {"n": -9, "u": -6, "µ": -6, "μ": -6, "m": -3, "c": -2, "k": 3, "M": 6, "G": 9}
WITH_PREFIX = {"m": 0, "g": -3, "s": 0, "K": 0, "rad": 0, "N": 0, "Pa": 0, "J": 0, "W": 0, "Hz": 0}
PLAIN = {"deg": (math.pi, 180), "rev": (2 * math.pi, 1), "rpm": (2 * math.pi, 60), "min": (60, 1), "h": (3600, 1),
         "%": (1, 100)}


def _symbol(name):
    """(power of ten, numerator, denominator) of one symbol, such as mm or deg."""
    if name in PLAIN:
        return 0, *PLAIN[name]
    if name in WITH_PREFIX:
        return WITH_PREFIX[name], 1, 1
    if name[:1] in PREFIXES and name[1:] in WITH_PREFIX:
        return PREFIXES[name[0]] + WITH_PREFIX[name[1:]], 1, 1
    raise ValueError(f'there is no unit "{name}"')


def _unit(text):
    """The same of a product, such as J/kg/K, N/mm2, 1/s or m/s^2."""
    exponent, numerator, denominator = 0, 1, 1
    for part in re.split(r"(?=[/*])", text.removeprefix("1") if text.startswith("1/") else text):
        if not part:
            continue
        sign, name, power = re.fullmatch(r"([/*]?)(.*?)\^?(\d?)", part).groups()
        ten, above, below = _symbol(name)
        power = int(power or 1)
        if sign == "/":
            ten, above, below = -ten, below, above
        exponent, numerator, denominator = exponent + power * ten, numerator * above**power, denominator * below**power
    return exponent, numerator, denominator


def si(text):
    """The value of a quantity in SI units: si("10 um") is 1e-05, si("25 degC") is 298.15, si("5 %") is 0.05."""
    number, unit = text.split(maxsplit=1)
    if unit == "degC":
        return float(number) + 273.15
    exponent, numerator, denominator = _unit(unit)
    return float(Decimal(number).scaleb(exponent)) * numerator / denominator


def quantity(value, unit, digits=9):
    """The text of a value in SI units, as a deck wants it: quantity(1e-05, "um") is "10 um"."""
    exponent, numerator, denominator = _unit(unit)
    return f"{value * 10**-exponent * denominator / numerator:.{digits}g} {unit}"
