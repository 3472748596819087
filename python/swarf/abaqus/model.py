"""What a file says of parts, instances, sets, sections and surfaces."""
import dataclasses
import math

from .reader import Fault, label, number as read_number

HEXES, PARTICLES, RIGID = ("C3D8R", "C3D8", "C3D8RT", "C3D8T"), ("PC3D",), ("R3D4", "R3D3")
# In rigid bodies only: there a mesh is no more than its outer sides.
SOLIDS = {"C3D4": 4, "C3D4T": 4, "C3D10": 10, "C3D10M": 10, "C3D10MT": 10, "C3D6": 6, "C3D6T": 6}
SIZES = {**dict.fromkeys(HEXES, 8), "PC3D": 1, "R3D4": 4, "R3D3": 3, **SOLIDS}
AT_A_POINT = ("MASS", "ROTARYI")  # of a reference point: a driven tool needs no inertia


@dataclasses.dataclass
class Section:
    keyword: object
    elements: str  # the set's name
    material: str
    half_edge: float | None  # of particles


class Part:
    """Nodes, elements and sets of a part, or of all of a file that has no parts."""

    def __init__(self, name):
        self.name = name
        self.nodes = {}  # number: [x, y, z]
        self.elements = {}  # number: (type, nodes, keyword)
        self.node_sets, self.element_sets = {}, {}  # upper-case name: list of numbers
        self.sections = []


@dataclasses.dataclass
class Instance:
    name: str
    part: Part
    shift: tuple = (0.0, 0.0, 0.0)
    turn: tuple | None = None  # a point, another of the axis, deg
    node_sets: dict = dataclasses.field(default_factory=dict)  # of the assembly
    rigid: set = dataclasses.field(default_factory=set)  # numbers of elements
    reference: dict | None = None  # the node that its rigid body follows, as find_nodes gives it

    def elements_of(self, kinds):
        """Those that deform."""
        return {number: one for number, one in self.part.elements.items() if one[0] in kinds and number not in self.rigid}

    def place(self, x):
        """Translation, then rotation about the axis from the first to the second point."""
        x = [a + b for a, b in zip(x, self.shift)]
        if self.turn is None:
            return x
        a, b, angle = self.turn
        axis = [q - p for p, q in zip(a, b)]
        length = math.sqrt(sum(c * c for c in axis))
        u = [c / length for c in axis]
        r = [c - p for c, p in zip(x, a)]
        cos, sin = math.cos(math.radians(angle)), math.sin(math.radians(angle))
        along = sum(p * q for p, q in zip(u, r))
        cross = [u[1] * r[2] - u[2] * r[1], u[2] * r[0] - u[0] * r[2], u[0] * r[1] - u[1] * r[0]]
        return [a[d] + r[d] * cos + cross[d] * sin + u[d] * along * (1 - cos) for d in range(3)]


class Model:
    def __init__(self, keywords):
        self.keywords = keywords
        self.parts, self.instances, self.surfaces = {}, {}, {}
        self.element_sets = {}  # of the assembly: name: (key of the instance, numbers)
        self.flat = Part("MODEL")
        self.rigid_bodies = []  # keyword, and the part that it is in or None
        part, instance, inside = self.flat, None, None
        for keyword in keywords:
            name = keyword.name
            if name == "PART":
                part = self.parts.setdefault(keyword.get("NAME"), Part(keyword.options.get("NAME")))
            elif name == "END PART":
                part = self.flat
            elif name == "ASSEMBLY":
                inside = "assembly"
            elif name == "END ASSEMBLY":
                inside = None
            elif name == "INSTANCE":
                instance = self._add_instance(keyword)
            elif name == "END INSTANCE":
                instance = None
            elif name == "NODE":
                self._add_nodes(keyword, instance.part if instance else part)
            elif name == "ELEMENT":
                if keyword.get("TYPE") in AT_A_POINT:
                    continue
                self._add_elements(keyword, instance.part if instance else part)
            elif name in ("NSET", "ELSET"):
                self._add_set(keyword, instance.part if instance else part, inside == "assembly" and not instance)
            elif name == "SOLID SECTION":
                half = keyword.numbers()[0] if keyword.rows and keyword.rows[0][1] else None
                where = instance.part if instance else part
                where.sections.append(Section(keyword, keyword.get("ELSET"), keyword.get("MATERIAL"), half))
            elif name == "RIGID BODY":
                if keyword.get("ELSET") is None:  # an analytical surface, or sets of nodes
                    continue
                where = instance.part if instance else part
                self.rigid_bodies.append((keyword, None if where is self.flat else where))
            elif name == "SURFACE":
                self.surfaces[keyword.get("NAME")] = keyword
            else:
                continue
            keyword.is_used = True
        if self.flat.elements:
            self.instances["MODEL"] = Instance("MODEL", self.flat)
        if not self.instances:
            raise ValueError("the file has no elements: expected parts and instances, or *NODE and *ELEMENT")
        self._make_rigid()

    def _add_instance(self, keyword):
        part = self.parts.get(keyword.get("PART"))
        if part is None:
            raise Fault(keyword, f'there is no part "{keyword.options.get("PART")}" before it')
        # Of an independent instance the mesh follows here, and its part is empty.
        instance = Instance(keyword.options.get("NAME"), part if part.nodes else Part(part.name))
        if keyword.rows:
            instance.shift = tuple((keyword.numbers(0) + [0.0] * 3)[:3])
        if len(keyword.rows) > 1:
            turn = keyword.numbers(1)
            if len(turn) != 7 or turn[:3] == turn[3:6]:
                raise Fault(keyword, "expected two points of the axis and an angle", keyword.rows[1][0])
            instance.turn = (turn[:3], turn[3:6], turn[6])
        self.instances[keyword.get("NAME")] = instance
        return instance

    def _add_nodes(self, keyword, part):
        for line, fields in keyword.rows:
            number = label(keyword, line, fields[0])
            if number in part.nodes:
                raise Fault(keyword, f"node {number} is there already", line)
            part.nodes[number] = [read_number(keyword, line, fields[d]) if d < len(fields) else 0.0 for d in (1, 2, 3)]
            if keyword.get("NSET"):
                part.node_sets.setdefault(keyword.get("NSET"), []).append(number)

    def _add_elements(self, keyword, part):
        kind = keyword.get("TYPE")
        if kind not in SIZES:
            raise Fault(keyword, f"elements of type {kind} are not read: expected C3D8R, C3D8 or PC3D, and R3D4, R3D3 or a "
                                 "solid in a rigid body")
        for line, fields in keyword.rows:
            number, *nodes = [label(keyword, line, field) for field in fields]
            if len(nodes) != SIZES[kind]:
                raise Fault(keyword, f"element {number} has {len(nodes)} nodes: expected {SIZES[kind]}", line)
            missing = [node for node in nodes if node not in part.nodes]
            if missing:
                raise Fault(keyword, f"there is no node {missing[0]} before it", line)
            if number in part.elements:
                raise Fault(keyword, f"element {number} is there already", line)
            part.elements[number] = (kind, nodes, keyword)
            if keyword.get("ELSET"):
                part.element_sets.setdefault(keyword.get("ELSET"), []).append(number)

    def _add_set(self, keyword, part, is_of_assembly):
        is_nodes = keyword.name == "NSET"
        name = keyword.get(keyword.name)
        numbers = []
        known = part.node_sets if is_nodes else part.element_sets
        for line, fields in keyword.rows:
            if "GENERATE" in keyword.options:
                first, last, step = ([label(keyword, line, field) for field in fields] + [1])[:3]
                if not 0 < step or last - first > 10**8:
                    raise Fault(keyword, "expected first, last and step of at most 1e8 numbers", line)
                numbers += range(first, last + 1, step)
                continue
            for field in fields:
                if field.upper() in known:
                    numbers += known[field.upper()]
                else:
                    numbers.append(label(keyword, line, field))
        if not is_of_assembly:
            known.setdefault(name, []).extend(numbers)
            return
        owner = self.instances.get(keyword.get("INSTANCE"))
        if owner is None:  # of reference points of the assembly
            known.setdefault(name, []).extend(numbers)
        elif is_nodes:
            owner.node_sets.setdefault(name, []).extend(numbers)
        else:
            self.element_sets.setdefault(name, (keyword.get("INSTANCE"), []))[1].extend(numbers)

    def find_elements(self, name):
        """{key of an instance: numbers} of a set of elements, by its name in the assembly."""
        owner, _, own = name.rpartition(".")
        if owner in self.instances:
            return {owner: self.instances[owner].part.element_sets.get(own, [])}
        if name in self.element_sets:
            key, numbers = self.element_sets[name]
            return {key: numbers}
        return {"MODEL": self.flat.element_sets[name]} if "MODEL" in self.instances and name in (
            self.flat.element_sets) else {}

    def _make_rigid(self):
        for instance in self.instances.values():
            instance.rigid = {number for number, one in instance.part.elements.items() if one[0] in RIGID}
        for keyword, part in self.rigid_bodies:
            name, reference = keyword.get("ELSET"), keyword.get("REF NODE")
            if part is None:
                found, node = self.find_elements(name), self.find_nodes(reference)
                bodies = {key: (numbers, node) for key, numbers in found.items()}
            else:
                nodes = part.node_sets.get(reference) or [label(keyword, keyword.line, reference)]
                bodies = {key: (part.element_sets.get(name, []), {key: nodes})
                          for key, one in self.instances.items() if one.part is part}
            if not any(numbers for numbers, _ in bodies.values()):
                raise Fault(keyword, f'there is no set of elements "{keyword.options["ELSET"]}"')
            for key, (numbers, node) in bodies.items():
                self.instances[key].rigid |= set(numbers)
                self.instances[key].reference = node
        for instance in self.instances.values():
            for number, (kind, _, keyword) in instance.part.elements.items():
                if kind in SOLIDS and number not in instance.rigid:
                    raise Fault(keyword, f"elements of type {kind} are not read, but in a rigid body: expected C3D8R, C3D8 "
                                         "or PC3D")

    def find_nodes(self, name):
        """{instance: numbers} of a set of nodes that a step or an initial condition names."""
        name = name.upper()
        if "." in name:
            owner, _, own = name.partition(".")
            instance = self.instances.get(owner)
            sets = {**instance.part.node_sets, **instance.node_sets} if instance else {}
            if own in sets:
                return {owner: sets[own]}
            if instance and own.isdigit():
                return {owner: [int(own)]}
        found = {key: one.node_sets[name] for key, one in self.instances.items() if name in one.node_sets}
        if not found and name in self.flat.node_sets:  # of a file without parts, or reference points of the assembly
            found = {"MODEL" if "MODEL" in self.instances else "": self.flat.node_sets[name]}
        if not found:
            holders = {key: one.part.node_sets[name] for key, one in self.instances.items()
                       if name in one.part.node_sets}
            found = holders if len(holders) == 1 else {}
        if not found and name.isdigit():
            found = {"MODEL" if "MODEL" in self.instances else "": [int(name)]}
        return found

    def instance_of_surface(self, name):
        """The instance that a surface lies on, by the sets that it is made of; None if that cannot be told."""
        name = name.upper()
        owner, _, own = name.rpartition(".")
        if owner in self.instances:
            return owner
        keyword = self.surfaces.get(name)
        if keyword is None:
            return None
        for _, fields in keyword.rows:
            one = fields[0].upper()
            if one.partition(".")[0] in self.instances and "." in one:
                return one.partition(".")[0]
            if one in self.element_sets:
                return self.element_sets[one][0]
            found = self.find_nodes(one)
            if len(found) == 1:
                return next(iter(found))
            holders = [key for key, other in self.instances.items() if one in other.part.element_sets]
            if len(holders) == 1:
                return holders[0]
        return None

