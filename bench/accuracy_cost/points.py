"""The points of the sweep. Each is the scene's deck with a few keys replaced, at one spacing."""
import copy
from dataclasses import dataclass
from typing import Callable

import decks
from scenes import SCENES


@dataclass(frozen=True)
class Point:
    scene: object
    group: str  # what is swept; points of one group exclude each other
    label: str  # beside the point in the chart
    change: Callable = lambda deck: None
    spacing: float = 0      # um; 0: as the sweep's base
    full: bool = False      # only with --full
    build: str = "release"  # preset of the program
    committed: bool = False  # the committed deck, whole

    @property
    def name(self):
        return f"{self.scene.name}: {self.label}"

    def deck(self, root):
        deck = decks.read(root / self.scene.deck_file)
        if self.committed:
            self.scene.prepare_output(deck)
        else:
            self.scene.base(deck)
            self.scene.set_spacing(deck, self.spacing or self.scene.spacing)
            self.change(deck)
        deck["title"] = self.name
        return deck

    def changes(self, root):
        """What was replaced in the committed deck beside the shortening and the refinement of all points."""
        deck = self.deck(root)
        if self.committed:
            return ""
        return decks.changes(deck, Point(self.scene, "", "", spacing=self.spacing).deck(root))


def setter(section, **values):
    return lambda deck: deck.setdefault(section, {}).update(copy.deepcopy(values))


def shorter_step(k):
    """By so little that only chance changes the result."""
    def change(deck):
        deck["run"]["courant"] = round(deck["run"]["courant"] * (1 - 0.02 * k), 6)
    return change


def all_hexes(scene, strain):
    def change(deck):
        scene.fill_all(deck, "hexes")
        deck.setdefault("hexes", {})["delete_at_strain"] = strain
    return change


# group, label, change, only with --full
METHOD = [
    ("smoothing length", "h/dx 1.0", setter("particles", smoothing_ratio=1.0), False),
    ("smoothing length", "h/dx 1.35", setter("particles", smoothing_ratio=1.35), True),
    ("smoothing length", "h/dx 1.5", setter("particles", smoothing_ratio=1.5), False),
    ("smoothing length", "h evolving", setter("particles", smoothing_length="evolving"), True),
    ("density", "density by summation", setter("particles", density="summation"), True),
    ("correction", "no correction", setter("particles", correction=False, correct_forces=False), False),
    ("correction", "forces not corrected", setter("particles", correct_forces=False), True),
    ("mass", "mass 1e2", setter("run", mass_factor=1e2), True),
    ("mass", "mass 1e3", setter("run", mass_factor=1e3), False),
    ("mass", "mass 3e4", setter("run", mass_factor=3e4), True),
    ("mass", "mass 1e5", setter("run", mass_factor=1e5), False),
    ("viscosity", "viscosity 0", setter("particles", viscosity_linear=0.0), False),
    ("viscosity", "viscosity 0.5", setter("particles", viscosity_linear=0.5), True),
    ("viscosity", "viscosity 1", setter("particles", viscosity_linear=1.0), False),
    ("viscosity form", "viscosity of Monaghan", setter("particles", viscosity_form="monaghan"), False),
    ("hourglass", "hourglass 0", setter("particles", hourglass_viscosity=0.0), False),
    ("hourglass", "hourglass 0.1", setter("particles", hourglass_viscosity=0.1), True),
    ("hourglass", "hourglass 1", setter("particles", hourglass_viscosity=1.0), False),
    ("artificial stress", "no artificial stress", setter("particles", artificial_stress=0.0), False),
    ("courant", "courant 0.3", setter("run", courant=0.3), False),
    ("courant", "courant 0.7", setter("run", courant=0.7), False),
    ("contact", "contact stiffness 0.03", setter("contact", stiffness=0.03), True),
]


def points_of(scene):
    points = [Point(scene, "spacing", f"dx {spacing:.3g}", spacing=spacing) for spacing in scene.spacings]
    points += [Point(scene, "spacing", f"dx {spacing:.3g}", spacing=spacing, full=True)
               for spacing in scene.fine_spacings]
    points += [Point(scene, group, label, change, full=full) for group, label, change, full in METHOD]
    points += [Point(scene, "repeat", f"repeat {k}, dx {spacing:.3g}", shorter_step(k), spacing=spacing)
               for spacing in scene.spacings if spacing >= scene.spacing for k in (1, 2, 3)]
    points += [
        Point(scene, "precision", "float", build="float"),
        Point(scene, "slice", "slice 3 dx", lambda deck: scene.set_slice(deck, 3)),
        Point(scene, "slice", "slice 6 dx", lambda deck: scene.set_slice(deck, 6)),
        Point(scene, "slice", "slice 12 dx", lambda deck: scene.set_slice(deck, 12), full=True),
        Point(scene, "fill", "particles only", lambda deck: scene.fill_all(deck, "particles"), full=True),
        Point(scene, "fill", "particles only, shallow", scene.only_cut_zone),
        Point(scene, "fill", "hexes, deleted at 1", all_hexes(scene, 1.0)),
        Point(scene, "fill", "hexes, deleted at 2", all_hexes(scene, 2.0)),
        Point(scene, "committed deck", "shipped deck", committed=True),
    ]
    if scene.name == "orthogonal":
        points += [Point(scene, "band", f"band {1e6 * below:.0f} um", lambda deck, below=below:
                         scene.set_band(deck, below), full=full) for below, full in ((20e-6, False), (80e-6, True))]
        points += [Point(scene, "window", f"cut {0.5e6 * (time - 1e-5):.0f} um", lambda deck, time=time:
                         scene.set_cut(deck, time), full=full) for time, full in ((0.15e-3, False), (0.4e-3, True))]
        points += [Point(scene, "length", f"work {1e6 * length:.0f} um", lambda deck, length=length:
                         scene.set_length(deck, length)) for length in (240e-6, 400e-6)]
    else:
        points += [Point(scene, "band", f"band {rows:+d} rows", lambda deck, rows=rows:
                         scene.set_band(deck, rows), full=full) for rows, full in ((-4, False), (6, True))]
        points += [Point(scene, "length", f"sector from {begin} deg", lambda deck, begin=begin:
                         scene.set_sector(deck, begin)) for begin in (5, -4)]
        points += [Point(scene, "window", f"entry at {angle} deg", lambda deck, angle=angle:
                         scene.set_entry(deck, angle)) for angle in (73, 74.5)]
    return points


def together(scene, chosen, spacings):
    """The chosen settings of all groups at once, in the order of the list of points."""
    if any(point.group == "fill" for point in chosen):  # one body: there is no band
        chosen = [point for point in chosen if point.group != "band"]

    def change(deck):
        for point in chosen:
            point.change(deck)
    build = next((point.build for point in chosen if point.build != "release"), "release")
    return [Point(scene, "together", f"together, dx {spacing:.3g}", change, spacing=spacing, build=build)
            for spacing in spacings]


ALL = [point for scene in SCENES.values() for point in points_of(scene)]
