"""Boundary and initial conditions: held and driven sets of nodes, the tool's velocity, velocities and temperatures."""
from .model import HEXES, PARTICLES
from .reader import Fault, number

WORDS = {"ENCASTRE": (1, 2, 3), "PINNED": (1, 2, 3)}


def _freedoms(keyword, line, fields):
    """Degrees of freedom of a row, and the value there; None for a word that holds only some directions."""
    word = fields[1].upper() if len(fields) > 1 else ""
    if word in WORDS:
        return WORDS[word], 0.0
    if not word.isdigit():
        return None
    first = int(word)
    if len(fields) > 2 and fields[2] and not fields[2].isdigit():
        raise Fault(keyword, f'expected a direction, 1 to 6, got "{fields[2]}"', line)
    last = int(fields[2]) if len(fields) > 2 and fields[2] else first
    return tuple(range(first, last + 1)), number(keyword, line, fields[3]) if len(fields) > 3 else 0.0


def read(of):
    """Fills bodies and of.motion: {freedom: velocity} of the tool."""
    of.motion = {}
    reference = None if of.tool is None else of.model.instances[of.tool].reference
    held = {}  # name of the set: {freedom: velocity}
    places = {}
    for keyword in of.used("BOUNDARY"):
        kind = keyword.get("TYPE") or "DISPLACEMENT"
        if "AMPLITUDE" in keyword.options or kind not in ("DISPLACEMENT", "VELOCITY") or keyword.get("OP") == "NEW":
            of.leave_out(keyword, "expected a displacement of 0 or a velocity, without an amplitude, that no step takes "
                                  "back")
            continue
        for line, fields in keyword.rows:
            found = _freedoms(keyword, line, fields)
            if found is None:
                of.leave_out(keyword, f"{', '.join(fields)}: a face of a mesh is held in all directions", line)
                continue
            freedoms, value = found
            if kind == "DISPLACEMENT" and value != 0:
                of.leave_out(keyword, f"{', '.join(fields)}: a displacement without a time", line)
                continue
            mine = dict.fromkeys(freedoms, value)
            nodes = of.model.find_nodes(fields[0])
            if not nodes:
                of.leave_out(keyword, f"whose set {fields[0]} is cannot be told", line)
            elif reference and nodes == reference:
                of.motion |= mine
            else:
                held.setdefault(fields[0], {}).update(mine)
                places.setdefault(fields[0], (keyword, line, nodes))
    for name, freedoms in held.items():
        _hold(of, name, freedoms, places[name])
    _read_initial(of, reference)


def _hold(of, name, freedoms, place):
    keyword, line, nodes = place
    missing = [one for one in (1, 2, 3) if one not in freedoms]
    if missing:
        return of.leave_out(keyword, f"{name}: is free in {', '.join(map(str, missing))}, and a face of a mesh is held in "
                                     "all directions", line)
    speed = [freedoms[one] for one in (1, 2, 3)]
    face = {"velocity": [of.units.a_velocity(value) for value in speed]} if any(speed) else "fixed"
    done = False
    for key, numbers in nodes.items():
        for fill in ("hexes", "particles"):
            body = of.bodies.get((key, fill))
            if body and _members(of, key, fill) & set(numbers):
                body.setdefault("faces", {})[name.rpartition(".")[2]] = face
                done = True
    if not done:
        of.leave_out(keyword, f"{name}: holds no node of a body", line)


def _members(of, key, fill):
    """Nodes of a body."""
    elements = of.model.instances[key].elements_of(HEXES if fill == "hexes" else PARTICLES)
    return {node for _, nodes, _ in elements.values() for node in nodes}


def _read_initial(of, reference):
    speeds = {}
    for keyword in of.used("INITIAL CONDITIONS"):
        kind = keyword.get("TYPE")
        if kind not in ("TEMPERATURE", "VELOCITY"):
            of.leave_out(keyword, "only temperature and velocity are read")
            continue
        for line, fields in keyword.rows:
            nodes = of.model.find_nodes(fields[0])
            if nodes and nodes == reference:
                if kind == "VELOCITY":
                    of.leave_out(keyword, "the tool moves as *BOUNDARY says", line)
                continue
            bodies = [(place, body) for place, body in of.bodies.items()
                      if place[0] in nodes and set(nodes[place[0]]) >= _members(of, *place)]
            if not bodies:
                of.leave_out(keyword, f"{', '.join(fields)}: expected a set of all nodes of a body", line)
            for place, body in bodies:
                if kind == "TEMPERATURE":
                    body["temperature"] = of.units.a_temperature(number(keyword, line, fields[1]))
                    continue
                if fields[1] not in ("1", "2", "3"):
                    raise Fault(keyword, f'expected the direction 1, 2 or 3, got "{fields[1]}"', line)
                speeds.setdefault(place, [0.0] * 3)[int(fields[1]) - 1] = number(keyword, line, fields[2])
    for place, speed in speeds.items():
        of.bodies[place]["velocity"] = [of.units.a_velocity(value) for value in speed]
    for body in of.bodies.values():
        if "temperature" not in body:
            of.notes.append(f"{body['name']}: has no initial temperature in the file; the deck's default is 25 degC")


def velocity_of_tool(of):
    turning = {one: value for one, value in of.motion.items() if one in (4, 5, 6) and value != 0}
    if turning:
        of.notes.append(f"the tool turns in the file (freedoms {', '.join(map(str, turning))}): a tool of an STL file moves "
                        "straight on, so that this is left out; an end mill is a tool of kind \"end_mill\"")
    missing = [str(one) for one in (1, 2, 3) if one not in of.motion]
    if missing:
        of.notes.append(f"the file does not drive the tool in {', '.join(missing)}: the deck has it at rest there")
    return [of.motion.get(one, 0.0) for one in (1, 2, 3)]
