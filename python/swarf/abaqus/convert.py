"""The deck of a model, the files beside it, and what was left out of it."""
import re

from . import holds, materials, meshes
from .model import HEXES, PARTICLES, Model
from .reader import Fault, number

# They say nothing by themselves.
FRAME = {"HEADING", "STEP", "END STEP", "SURFACE INTERACTION", "CONTACT", "CONTACT INCLUSIONS", "CONTACT PAIR",
         "CONTACT PROPERTY ASSIGNMENT", "PHYSICAL CONSTANTS"}


def safe(name):
    return re.sub(r"[^A-Za-z0-9_-]+", "_", name)


class Converter:
    def __init__(self, keywords, units, stem):
        self.keywords, self.units, self.stem = keywords, units, stem
        self.model = Model(keywords)
        self.reasons = {}  # id of a keyword or row: (keyword, line, why it is left out)
        self.notes = []  # what the user has to look at
        self.files = {}  # name: text
        self.bodies = {}  # (key of the instance, "hexes" or "particles"): section of the deck
        self.tool = None  # key of its instance

    def leave_out(self, keyword, why, line=None):
        self.reasons[id(keyword), line] = (keyword, line or keyword.line, why)

    def used(self, name):
        """What a later step says is not in the deck."""
        steps = 0
        for keyword in self.keywords:
            steps += keyword.name == "STEP"
            if keyword.name == name and steps < 2:
                keyword.is_used = True
                yield keyword

    def convert(self):
        self._read_temperature_unit()
        deck = {"title": f"imported from {self.keywords[0].file}", "material": {}, "body": []}
        known = materials.read(self.keywords)
        self._find_bodies(known)
        for body in self.bodies.values():
            name = body["material"]
            if name not in deck["material"]:
                deck["material"][name] = materials.section(known[name.upper()], self.units, self.notes)
                self._add_plastic_heat(deck["material"][name])
        holds.read(self)
        self._read_ties()
        self._write_files()
        deck["body"] = list(self.bodies.values())
        if self.tool is not None:
            deck["tool"] = self._tool()
            deck["contact"] = self._contact()
        deck["run"] = self._run()
        return deck

    def _read_temperature_unit(self):
        for keyword in self.used("PHYSICAL CONSTANTS"):
            zero = keyword.options.get("ABSOLUTE ZERO")
            if zero is None:
                continue
            said = {0.0: "K", -273.15: "degC"}.get(number(keyword, keyword.line, zero))
            if said is None or self.units.temperature not in (None, said):
                raise Fault(keyword, f"has its absolute zero at {zero}: expected 0 (K) or -273.15 (degC), as --temperature "
                                     "says")
            self.units.temperature = said

    def _add_plastic_heat(self, material):
        adiabatic = any("ADIABATIC" in one.options for one in self.keywords)
        if material["law"] != "elastic" and "taylor_quinney" not in material:
            material["taylor_quinney"] = 0.9 if adiabatic else 0.0

    def _find_bodies(self, known):
        for key, instance in self.model.instances.items():
            if instance.rigid:
                if instance.elements_of(HEXES + PARTICLES):
                    raise ValueError(f"instance {instance.name} has rigid and other elements: expected them apart")
                if self.tool is not None:
                    raise ValueError(f"instances {self.model.instances[self.tool].name} and {instance.name} are rigid: "
                                     "expected one, the tool")
                self.tool = key
            for kinds, fill in ((HEXES, "hexes"), (PARTICLES, "particles")):
                elements = instance.elements_of(kinds)
                if elements:
                    both = instance.elements_of(HEXES) and fill == "particles"
                    name = instance.name + (" particles" if both else "")
                    self.bodies[key, fill] = {
                        "name": name, "shape": "mesh", "fill": fill,
                        "material": self._material_of(instance, elements, known),
                        "file": f"{self.stem}_{safe(name)}." + ("inp" if fill == "hexes" else "csv"),
                        "file_scale": self.units.unit_length}
        if not self.bodies:
            raise ValueError("the file has no C3D8R, C3D8 or PC3D elements: nothing to cut")

    @staticmethod
    def _material_of(instance, elements, known):
        of = {}
        for section in instance.part.sections:
            of |= dict.fromkeys(instance.part.element_sets.get(section.elements, []), section)
        for number, (_, _, keyword) in elements.items():
            if number not in of:
                raise Fault(keyword, f"element {number} has no *SOLID SECTION before the end of its part")
        found = {of[number].material: of[number] for number in elements}
        if len(found) > 1:
            raise Fault(list(found.values())[1].keyword, f"gives {instance.name} a second material: expected one for its "
                        "hexes and one for its particles; make parts of them and tie these")
        name, section = next(iter(found.items()))
        if name not in known:
            raise Fault(section.keyword, f"there is no *MATERIAL, NAME={name}")
        return known[name][0]

    def _read_ties(self):
        for keyword in self.used("TIE"):
            for line, fields in keyword.rows:
                owners = [self.model.instance_of_surface(field) for field in fields[:2]]
                pairs = [(a, b) for a, b in (owners, owners[::-1])
                         if (a, "particles") in self.bodies and (b, "hexes") in self.bodies]
                if None in owners:
                    self.leave_out(keyword, f"whose the surfaces {', '.join(fields)} are cannot be told", line)
                elif not pairs:
                    self.leave_out(keyword, f"{' and '.join(fields[:2])}: only particles are tied, to hexes", line)
                else:
                    particles, hexes = pairs[0]
                    self.bodies[particles, "particles"]["tie"] = self.bodies[hexes, "hexes"]["name"]

    def _write_files(self):
        for (key, fill), body in self.bodies.items():
            instance = self.model.instances[key]
            sets = {name: self.model.find_nodes(name).get(key, []) for name in body.get("faces", {})}
            write = meshes.hexes if fill == "hexes" else meshes.particles
            self.files[body["file"]] = write(instance, sets)
            if fill == "hexes" and instance.elements_of(("C3D8", "C3D8T")):
                self.notes.append(f"{body['name']}: C3D8 elements become hexes with one integration point and hourglass "
                                  "stiffness")

    def _tool(self):
        instance = self.model.instances[self.tool]
        name = f"{self.stem}_{safe(instance.name)}.stl"
        self.files[name] = meshes.stl(instance)
        return {"kind": "stl", "file": name, "file_scale": self.units.unit_length,
                "velocity": [self.units.a_velocity(value) for value in holds.velocity_of_tool(self)]}

    def _contact(self):
        found, contact = {}, {}
        if len(self.bodies) > 1:
            self.notes.append("[contact] between_bodies says whether bodies press each other, all alike: *CONTACT PAIR does "
                              "not choose")
        for keyword in self.used("FRICTION"):
            others = sorted(set(keyword.options) - {"TAUMAX"})
            if others:
                self.leave_out(keyword, f"{others[0]}: expected a coefficient of Coulomb friction")
                continue
            if "TAUMAX" in keyword.options:
                limit = number(keyword, keyword.line, keyword.options["TAUMAX"])
                contact["shear_limit"] = self.units.a_pressure(limit)
            found.setdefault(keyword.numbers()[0] if keyword.rows else 0.0, keyword)
            if keyword.rows and len(keyword.rows[0][1]) > 1:
                self.notes.append(f"line {keyword.line}: of *FRICTION only the first coefficient is read, not its "
                                  "dependence on slip rate, pressure or temperature")
        if len(found) > 1:
            raise Fault(list(found.values())[1], f"the coefficients {', '.join(map(str, found))} differ: a deck has one")
        if not found:
            self.notes.append("[contact] needs friction, and the file has no *FRICTION for it: add it")
            return contact
        return {"friction": next(iter(found))} | contact

    def _run(self):
        steps = [one for one in self.keywords if one.name == "STEP"]
        for other in steps[1:]:
            self.leave_out(other, "only the first step is read")
        run = {}
        for keyword in self.keywords:
            if steps[1:] and keyword.line > steps[1].line:
                break
            if keyword.name in ("DYNAMIC", "DYNAMIC TEMPERATURE-DISPLACEMENT") and "EXPLICIT" in keyword.options:
                values = keyword.numbers()
                if len(values) < 2:
                    raise Fault(keyword, "expected the time of the step as the second number")
                run["end_time"] = self.units.a_time(values[1])
                keyword.is_used = True
            if keyword.name == "FIXED MASS SCALING" and "FACTOR" in keyword.options:
                if "ELSET" in keyword.options:
                    self.leave_out(keyword, "expected no ELSET: run.mass_factor is of all bodies")
                    continue
                run["mass_factor"] = number(keyword, keyword.line, keyword.options["FACTOR"])
                keyword.is_used = True
        if "end_time" not in run:
            self.notes.append("[run] needs end_time, and the file has no *DYNAMIC, EXPLICIT for it: add it")
        return run

    def left_out(self):
        """(line, keyword, why or "") of all that is not in the deck, in the order of the file."""
        rows = [(line, keyword, why) for keyword, line, why in self.reasons.values()]
        said = {id(keyword) for keyword, _, _ in self.reasons.values()}
        rows += [(one.line, one, "") for one in self.keywords
                 if not one.is_used and one.name not in FRAME and id(one) not in said]
        return sorted(rows, key=lambda row: row[0])
