"""What the forces hang on: the base scene of the orthogonal cut with one physical input changed. These points answer
another question than the sweep's, so they are in neither its chart nor its front."""
from swarf import quantity, si

from points import Point, setter
from scenes import SCENES

GROUP = "physics"
SCENE = SCENES["orthogonal"]


def edge_radius(radius):
    def change(deck):
        moved = si(deck["tool"]["edge_radius"]) - radius
        deck["tool"]["edge_radius"] = quantity(radius, "um")
        position = deck["tool"]["position"]  # of the lowest point: the front of the edge stays where it was
        position[0] = quantity(si(position[0]) + moved, "um")
    return change


def material(**values):
    return lambda deck: next(iter(deck["material"].values())).update(values)


def harder(share):
    def change(deck):
        law = next(iter(deck["material"].values()))
        law["A"] = quantity(si(law["A"]) * (1 + share), "MPa", 6)
    return change


def insulated_tool(share):
    """The tool takes the rest of the friction heat, and nothing else."""
    def change(deck):
        for key in ("material", "temperature"):
            deck["tool"].pop(key, None)
        deck["contact"]["heat_to_workpiece"] = share
    return change


def adiabatic(deck):
    insulated_tool(0.5)(deck)
    material(conductivity="0 W/m/K")(deck)


POINTS = [Point(SCENE, GROUP, label, change) for label, change in (
    ("friction 0.1", setter("contact", friction=0.1)),
    ("friction 0.3", setter("contact", friction=0.3)),
    ("friction 0.5", setter("contact", friction=0.5)),
    ("no shear limit", lambda deck: deck["contact"].pop("shear_limit")),
    ("edge radius 10 um", edge_radius(10e-6)),
    ("edge radius 30 um", edge_radius(30e-6)),
    ("clearance 7 deg", setter("tool", clearance="7 deg")),
    ("friction heat all to the tool", insulated_tool(0.0)),
    ("friction heat all to the work", insulated_tool(1.0)),
    ("no conduction", adiabatic),
    ("A +10 %", harder(0.1)),
    ("C 0", material(C=0.0)),
    ("Taylor-Quinney 0", material(taylor_quinney=0.0)),
)]
