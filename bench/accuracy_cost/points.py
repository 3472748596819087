"""The points of the sweep. Each is the scene's deck with a few keys replaced, at one spacing."""
import copy
from dataclasses import dataclass, replace
from typing import Callable

from swarf import decks, quantity

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
            return {}
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


# A row of particles that passes just below the edge at one spacing passes above it at another, and the force with it.
# Thicker and thinner by a third of a spacing, the edge meets the rows at three places evenly apart: in the mean what
# it meets falls to a third, and the thickness is the deck's.
THICKNESSES = {"h + dx/3": 1 / 3, "h - dx/3": -1 / 3}
THREE = "thickness"  # the group of these points
STIFFNESS_0 = "stiffness 0 over dx"
MEAN_OF = {"spacing": "mean of three", "together": "together, mean of three",
           STIFFNESS_0: "stiffness 0, mean of three"}  # groups that have such points


# Each was stable alone; together they ask most of the stable step, which counts the viscosity and the hourglass
# stiffness, but not what the corrected gradient of a strained chip adds.
AT_LIMIT = (("courant 0.9", "h/dx 1.0"), ("courant 0.9", "viscosity 1"))


def thicknesses(point, group):
    """The two points that differ from this one in where the edge meets the rows."""
    def by(share):
        def change(deck):
            point.change(deck)
            point.scene.thicken(deck, share * (point.spacing or point.scene.spacing) * 1e-6)
        return change
    return [replace(point, group=group, label=f"{point.label}, {name}", change=by(share))
            for name, share in THICKNESSES.items()]


# Without hourglass stiffness over the spacing: does the force that it adds vanish with the spacing?
NO_STIFFNESS = [80 / n for n in (8, 10, 12, 20, 24)]

ALWAYS, ORTHOGONAL, FULL = "always", "orthogonal", "full"  # which sweep: also the short one, in which scene
METHOD = [
    ("smoothing length", "h/dx 1.0", setter("particles", smoothing_ratio=1.0), ALWAYS),
    ("smoothing length", "h/dx 1.35", setter("particles", smoothing_ratio=1.35), FULL),
    ("smoothing length", "h/dx 1.5", setter("particles", smoothing_ratio=1.5), ALWAYS),
    ("smoothing length", "h evolving", setter("particles", smoothing_length="evolving"), FULL),
    ("density", "density by summation", setter("particles", density="summation"), FULL),
    ("correction", "no correction", setter("particles", correction=False, correct_forces=False), ALWAYS),
    ("correction", "forces not corrected", setter("particles", correct_forces=False), FULL),
    ("mass", "mass 1e2", setter("run", mass_factor=1e2), FULL),
    ("mass", "mass 1e3", setter("run", mass_factor=1e3), ORTHOGONAL),
    ("mass", "mass 3e4", setter("run", mass_factor=3e4), FULL),
    ("mass", "mass 1e5", setter("run", mass_factor=1e5), ALWAYS),
    ("viscosity", "viscosity 0", setter("particles", viscosity_linear=0.0), ALWAYS),
    ("viscosity", "viscosity 0.5", setter("particles", viscosity_linear=0.5), FULL),
    ("viscosity", "viscosity 1", setter("particles", viscosity_linear=1.0), ORTHOGONAL),
    ("hourglass stiffness", "stiffness 0", setter("particles", hourglass_stiffness=0.0), ALWAYS),
    ("hourglass stiffness", "stiffness 0.1", setter("particles", hourglass_stiffness=0.1), ALWAYS),
    ("hourglass stiffness", "stiffness 1", setter("particles", hourglass_stiffness=1.0), ALWAYS),
    ("diffusion", "no pressure diffusion", setter("particles", pressure_diffusion=0.0), ALWAYS),
    ("diffusion", "pressure diffusion 0.003", setter("particles", pressure_diffusion=0.003), ALWAYS),
    ("shifting", "no shifting", setter("particles", shifting=False), ALWAYS),
    ("courant", "courant 0.5", setter("run", courant=0.5), ALWAYS),
    ("courant", "courant 0.9", setter("run", courant=0.9), ALWAYS),
    ("contact", "contact stiffness 0.1", setter("contact", stiffness=0.1), ALWAYS),
    ("contact", "contact stiffness 1", setter("contact", stiffness=1.0), ALWAYS),
]


def frozen(scene, count):
    """What is farther than so many spacings from the active region freezes."""
    def change(deck):
        deck["sleep"] = {"distance": quantity(count * scene.spacing_of(deck), "um")}
    return change


def retired(scene, count):
    """Spent chip leaves as well that is farther than so many spacings from all."""
    def change(deck):
        frozen(scene, 24)(deck)
        deck["retire"] = {"distance": quantity(count * scene.spacing_of(deck), "um")}
    return change


CONVERTING = "hexes convert"


def converting(scene, count):
    """No band of particles: hexes of two spacings become particles within so many spacings of the tool."""
    def change(deck):
        spacing = scene.spacing_of(deck)
        scene.fill_all(deck, "hexes")
        scene.coarsen(deck)
        decks.body(deck, "work")["convert_distance"] = quantity(count * spacing, "um")
    return change


def work_of(scene):
    """What the work is made of: settings of the scene, not of the method."""
    return [
        ("sleep", "sleep beyond 16 dx", frozen(scene, 16), ALWAYS),
        ("sleep", "sleep beyond 24 dx", frozen(scene, 24), ALWAYS),
        ("sleep", "sleep beyond 24 dx, retire beyond 8 dx", retired(scene, 8), ALWAYS),
        ("slice", "slice 3 dx", lambda deck: scene.set_slice(deck, 3), ALWAYS),
        ("slice", "slice 6 dx", lambda deck: scene.set_slice(deck, 6), ALWAYS),
        ("slice", "slice 12 dx", lambda deck: scene.set_slice(deck, 12), FULL),
        ("fill", "particles only", lambda deck: scene.fill_all(deck, "particles"), FULL),
        ("fill", "particles only, shallow", scene.only_cut_zone, ALWAYS),
        ("fill", "hexes, deleted at 1", all_hexes(scene, 1.0), ORTHOGONAL),
        ("fill", "hexes, deleted at 2", all_hexes(scene, 2.0), ALWAYS),
        ("fill", f"{CONVERTING} within 3 dx", converting(scene, 3), ALWAYS),
        ("fill", f"{CONVERTING} within 7 dx", converting(scene, 7), ALWAYS),
    ]


def orthogonal_work(scene):
    return [
        ("band", "band 20 um", lambda deck: scene.set_band(deck, 20e-6), ALWAYS),
        ("band", "band 80 um", lambda deck: scene.set_band(deck, 80e-6), FULL),
        ("window", "cut 70 um", lambda deck: scene.set_cut(deck, 0.15e-3), ALWAYS),
        ("window", "cut 195 um", lambda deck: scene.set_cut(deck, 0.4e-3), FULL),
        ("length", "work 240 um", lambda deck: scene.set_length(deck, 240e-6), ALWAYS),
        ("length", "work 400 um", lambda deck: scene.set_length(deck, 400e-6), FULL),
    ]


def milling_work(scene):
    return [
        ("band", "band -4 rows", lambda deck: scene.set_band(deck, -4), ALWAYS),
        ("band", "band +6 rows", lambda deck: scene.set_band(deck, 6), FULL),
        ("length", "sector from 5 deg", lambda deck: scene.set_sector(deck, 5), ALWAYS),
        ("length", "sector from -4 deg", lambda deck: scene.set_sector(deck, -4), ALWAYS),
        ("window", "entry at 73 deg", lambda deck: scene.set_entry(deck, 73), ALWAYS),
        ("window", "entry at 74.5 deg", lambda deck: scene.set_entry(deck, 74.5), ALWAYS),
    ]


def points_of(scene):
    own_work = orthogonal_work(scene) if scene.name == "orthogonal" else milling_work(scene)
    points = [Point(scene, "spacing", f"dx {spacing:.3g}", spacing=spacing, full=spacing in scene.fine_spacings)
              for spacing in scene.spacings + scene.fine_spacings]
    points += [one for point in list(points) for one in thicknesses(point, THREE)]
    points += [Point(scene, "repeat", f"repeat {k}", shorter_step(k)) for k in (1, 2, 3)]
    if scene.name == "orthogonal":
        without = [Point(scene, STIFFNESS_0, f"stiffness 0, dx {spacing:.3g}",
                         setter("particles", hourglass_stiffness=0.0), spacing) for spacing in NO_STIFFNESS]
        points += without + [replace(one, full=True) for point in without for one in thicknesses(point, THREE)]
    points += [Point(scene, group, label, change, full=sweep not in (ALWAYS, scene.name))
               for group, label, change, sweep in METHOD + work_of(scene) + own_work]
    of_label = {point.label: point for point in points}
    points += [at_once(scene, [of_label[label] for label in labels], "at the limit", " + ".join(labels),
                       scene.spacings[0]) for labels in AT_LIMIT]
    return points + [Point(scene, "precision", "float", build="float"),
                     Point(scene, "committed deck", "shipped deck", committed=True)]


def at_once(scene, chosen, group, label, spacing):
    """The chosen settings of all groups at once, in the order of the list of points."""
    if any(point.group == "fill" for point in chosen):  # one body: there is no band
        chosen = [point for point in chosen if point.group != "band"]
    if any(point.label.startswith(CONVERTING) for point in chosen):  # swarf refuses both at once
        chosen = [point for point in chosen if point.group != "sleep"]

    def change(deck):
        for point in chosen:
            point.change(deck)
    build = next((point.build for point in chosen if point.build != "release"), "release")
    return Point(scene, group, label, change, spacing=spacing, build=build)


def trial(scene, chosen):
    """At a coarse spacing: do these get on?"""
    label = " + ".join(point.label for point in chosen) + f", dx {scene.trial_spacing:.3g}"
    return at_once(scene, chosen, "combination", label, scene.trial_spacing)


def together(scene, chosen):
    found = [at_once(scene, chosen, "together", f"together, dx {spacing:.3g}", spacing)
             for spacing in scene.together_spacings]
    return [one for point in found for one in (point, *thicknesses(point, THREE))]


ALL = [point for scene in SCENES.values() for point in points_of(scene)]
