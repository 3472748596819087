"""The files beside the deck: hexes and particles of bodies, facets of the tool."""
from .model import HEXES, PARTICLES, RIGID
from .reader import Fault


def _numbers(x):
    return ", ".join(f"{value:.12g}" for value in x)


def hexes(instance, sets):
    """The text of a body of hexes; sets: {name: numbers of nodes}."""
    part = instance.part
    elements = instance.elements_of(HEXES)
    used = dict.fromkeys(node for _, nodes, _ in elements.values() for node in nodes)
    lines = [f"** {instance.name}, in its place", "*NODE"]
    lines += [f"{node}, {_numbers(instance.place(part.nodes[node]))}" for node in used]
    lines.append("*ELEMENT, TYPE=C3D8R")
    lines += [", ".join(map(str, [number, *nodes])) for number, (_, nodes, _) in elements.items()]
    for name, numbers in sets.items():
        lines.append(f"*NSET, NSET={name}")
        members = [str(node) for node in dict.fromkeys(numbers) if node in used]
        lines += [", ".join(members[k:k + 16]) for k in range(0, len(members), 16)]
    return "\n".join(lines) + "\n"


def half_edges(instance):
    """{number of a particle: half the edge of its cube}"""
    part, particles = instance.part, instance.elements_of(PARTICLES)
    found = {}
    for section in part.sections:
        members = [one for one in part.element_sets.get(section.elements, []) if one in particles]
        if members and not section.half_edge:
            raise Fault(section.keyword, "has no characteristic length for its particles: expected half the edge of the "
                                         "cube that a particle fills in the line below")
        found |= dict.fromkeys(members, section.half_edge)
    return found


def particles(instance, sets):
    """Rows x, y, z, volume, and the sets that a particle is in."""
    part, half = instance.part, half_edges(instance)
    sets = {name: set(numbers) for name, numbers in sets.items()}
    lines = [f"# {instance.name}, in its place: x, y, z, volume, sets"]
    for number, (_, (node,), keyword) in instance.elements_of(PARTICLES).items():
        if number not in half:
            raise Fault(keyword, f"particle {number} has no *SOLID SECTION")
        own = [name for name, numbers in sets.items() if node in numbers]
        lines.append(", ".join([_numbers(instance.place(part.nodes[node])), f"{(2 * half[number])**3:.12g}", *own]))
    return "\n".join(lines) + "\n"


# Corners of the sides, counter-clockwise from outside, by the number of corners of a solid.
SIDES = {4: ((0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)),
         6: ((0, 2, 1), (3, 4, 5), (0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)),
         8: ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))}


def _outer_sides(instance):
    """Of a rigid body; of solids the sides that no other one shares."""
    sides = {}
    for number in sorted(instance.rigid):
        kind, nodes, _ = instance.part.elements[number]
        if kind in RIGID:
            sides[number] = nodes
            continue
        corners = nodes[:4] if len(nodes) == 10 else nodes
        for side in SIDES[len(corners)]:
            mine = [corners[k] for k in side]
            key = frozenset(mine)
            if key in sides:
                del sides[key]
            else:
                sides[key] = mine
    return sides.values()


def facets(instance):
    """Triangles of a rigid body, outwards if it is closed: where they enclose a negative volume all are turned."""
    triangles = []
    for nodes in _outer_sides(instance):
        x = [instance.place(instance.part.nodes[node]) for node in nodes]
        triangles.append(x[:3])
        if len(x) == 4 and nodes[3] != nodes[2]:
            triangles.append([x[0], x[2], x[3]])
    low = [min(x[d] for one in triangles for x in one) for d in range(3)]
    volume = 0
    for one in triangles:
        (a, b, c), (d, e, f), (g, h, i) = [[x[k] - low[k] for k in range(3)] for x in one]
        volume += a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
    return [one[::-1] for one in triangles] if volume < 0 else triangles


def stl(instance):
    lines = ["solid tool"]
    for triangle in facets(instance):
        lines += ["facet normal 0 0 0", "outer loop"]
        lines += ["vertex " + " ".join(f"{value:.12g}" for value in x) for x in triangle]
        lines += ["endloop", "endfacet"]
    return "\n".join(lines + ["endsolid tool"]) + "\n"
