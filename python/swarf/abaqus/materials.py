"""[material.NAME] from *MATERIAL and what follows it."""
from .reader import Fault, number

OF_MATERIAL = {"DENSITY", "ELASTIC", "PLASTIC", "RATE DEPENDENT", "CONDUCTIVITY", "SPECIFIC HEAT", "DAMAGE INITIATION",
               "INELASTIC HEAT FRACTION"}


def read(keywords):
    """{name in upper case: (name, {keyword's name: keyword})}"""
    found, current = {}, None
    for keyword in keywords:
        if keyword.name == "MATERIAL":
            if not keyword.get("NAME"):
                raise Fault(keyword, "expected NAME=")
            current = {}
            found[keyword.get("NAME")] = (keyword.options["NAME"], current)
            keyword.is_used = True
        elif current is not None and keyword.name in OF_MATERIAL:
            if keyword.name in current:
                raise Fault(keyword, f"is given twice, first in line {current[keyword.name].line}")
            current[keyword.name] = keyword
        elif keyword.name in ("STEP", "AMPLITUDE", "BOUNDARY", "INITIAL CONDITIONS"):
            current = None
    return found


def _rows(keyword, width):
    """Rows of `width` values and a temperature, or None."""
    rows = []
    for line, fields in keyword.rows:
        values = [number(keyword, line, field) for field in fields]
        if len(values) not in (width, width + 1):
            raise Fault(keyword, f"expected {width} values and a temperature, got {len(values)}", line)
        rows.append((values[:width], values[width] if len(values) > width else None))
    if not rows:
        raise Fault(keyword, "expected a line of numbers after it")
    if len(rows) > 1 and any(temperature is None for _, temperature in rows):
        raise Fault(keyword, "expected a temperature in each of several lines")
    keyword.is_used = True
    return rows


def _over_temperature(rows, column, text, units):
    """One value, or a table as decks have it."""
    if len(rows) == 1:
        return text(rows[0][0][column])
    return [[units.a_temperature(temperature), text(values[column])] for values, temperature in rows]


def _values(keyword, least, most):
    """Of a single row, without trailing zeros that Abaqus/CAE adds."""
    if len(keyword.rows) != 1:
        raise Fault(keyword, f"expected one line, got {len(keyword.rows)}: dependence on temperature or fields is not "
                             "read")
    values = keyword.numbers()
    if not least <= len(values) <= most:
        raise Fault(keyword, f"expected {least} to {most} values, got {len(values)}", keyword.rows[0][0])
    keyword.is_used = True
    return values


def section(given, units, notes):
    """The section of one material; what swarf needs and the file has not goes into the notes."""
    name, parts = given
    deck = {"law": "elastic"}

    def need(keyword_name, key):
        notes.append(f"[material.{name}] needs {key}, and the file has no *{keyword_name} for it: add it")

    if "DENSITY" in parts:
        deck["density"] = units.a_density(_values(parts["DENSITY"], 1, 1)[0])
    else:
        need("DENSITY", "density")
    if "ELASTIC" in parts:
        keyword = parts["ELASTIC"]
        if (keyword.get("TYPE") or "ISOTROPIC") not in ("ISO", "ISOTROPIC"):
            raise Fault(keyword, f"of type {keyword.get('TYPE')} is not read: expected an isotropic one")
        rows = _rows(keyword, 2)
        if len({values[1] for values, _ in rows}) > 1:
            raise Fault(keyword, "has a Poisson's ratio that depends on the temperature: expected one value")
        deck["youngs_modulus"] = _over_temperature(rows, 0, units.a_pressure, units)
        deck["poissons_ratio"] = rows[0][0][1]
    else:
        need("ELASTIC", "youngs_modulus and poissons_ratio")
    for keyword_name, key, text in (("CONDUCTIVITY", "conductivity", units.a_conductivity),
                                    ("SPECIFIC HEAT", "specific_heat", units.a_specific_heat)):
        if keyword_name in parts:
            deck[key] = _over_temperature(_rows(parts[keyword_name], 1), 0, text, units)
    if "PLASTIC" in parts:
        _add_plastic(deck, parts, units, name)
        if deck["law"] == "johnson_cook" and "specific_heat" not in deck:
            need("SPECIFIC HEAT", "specific_heat")
    if "DAMAGE INITIATION" in parts:
        _add_damage(deck, parts, notes, name)
    return deck


def _add_plastic(deck, parts, units, name):
    keyword = parts["PLASTIC"]
    kind = keyword.get("HARDENING") or "ISOTROPIC"
    if kind == "ISOTROPIC" and len(keyword.rows) == 1 and keyword.numbers()[1:2] in ([], [0.0]):
        deck |= {"law": "linear_hardening", "yield_stress": units.a_pressure(keyword.numbers()[0]),
                 "hardening_modulus": "0 Pa"}
        keyword.is_used = True
    elif kind == "JOHNSON COOK":
        A, B, n, m, melt, transition = _values(keyword, 6, 6)
        deck |= {"law": "johnson_cook", "A": units.a_pressure(A), "B": units.a_pressure(B), "n": n, "m": m, "C": 0.0,
                 "melt_temperature": units.a_temperature(melt),
                 "reference_temperature": units.a_temperature(transition)}
        if "RATE DEPENDENT" in parts:
            rate = parts["RATE DEPENDENT"]
            if rate.get("TYPE") != "JOHNSON COOK":
                raise Fault(rate, "is not read: expected TYPE=JOHNSON COOK")
            deck["C"], reference = _values(rate, 2, 2)
            deck["reference_rate"] = units.a_rate(reference)
    else:
        raise Fault(keyword, f"of material {name} is not read: expected HARDENING=JOHNSON COOK, or one line with the "
                             "yield stress of a material that does not harden")
    # Without the keyword Abaqus makes no heat of the plastic work, unless the step is adiabatic.
    heat = parts.get("INELASTIC HEAT FRACTION")
    if heat:
        deck["taylor_quinney"] = _values(heat, 1, 1)[0] if heat.rows else 0.9
        heat.is_used = True


def _add_damage(deck, parts, notes, name):
    """The file's d3 has the other sign than Johnson & Cook (1985), which decks keep."""
    keyword = parts["DAMAGE INITIATION"]
    if keyword.get("CRITERION") != "JOHNSON COOK":
        return  # it is listed among what is left out
    if deck["law"] != "johnson_cook":
        raise Fault(keyword, f"of material {name} needs *PLASTIC, HARDENING=JOHNSON COOK")
    d1, d2, d3, d4, d5, *own = _values(keyword, 5, 8)
    deck["damage"] = [d1, d2, -d3, d4, d5]
    notes.append(f"line {keyword.line}: {name} has no strength left where the deck's damage reaches 1; *DAMAGE EVOLUTION, "
                 "which does that little by little, is not read")
    flow = parts["PLASTIC"].numbers()[4:6] + (parts["RATE DEPENDENT"].numbers()[1:] if "RATE DEPENDENT" in parts else [])
    if own != flow[:len(own)]:
        notes.append(f"line {keyword.line}: the damage of {name} has temperatures and a rate of its own, {own}: the deck "
                     f"has one set, {flow}, that of *PLASTIC and *RATE DEPENDENT")
