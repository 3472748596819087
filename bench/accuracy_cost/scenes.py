"""The two scenes of the sweep: a shorter form of each committed deck, how to refine it, and what is measured in it."""
import math

from swarf import decks, quantity, si


class Orthogonal:
    name, deck_file = "orthogonal", "inputs/orthogonal_cutting.toml"
    title = "orthogonal cutting"
    # um; whole cells in the 80 um of the cut zone. Many coarse ones: which row of particles passes below the edge
    # differs between them, and with it the force.
    spacing, spacings, fine_spacings = 5.0, [80 / n for n in (8, 9, 10, 11, 12, 14, 16, 20, 24, 32)], [2.0]
    trial_spacing, together_spacings = 80 / 12, [80 / n for n in (8, 10, 12, 16, 20)]
    trend = False
    cut_time = 0.2e-3   # 95 um of cut. Later the force wanders: repeats then differ by 4 %, here by 1 %
    averaged = 0.5      # of the cut, at its end
    ahead = 225e-6      # of work in front of the tool at the end; 105 um change the force by 12 % at dx = 10 um

    def base(self, deck):
        self.set_cut(deck, self.cut_time)

    def set_cut(self, deck, time):
        deck["run"]["end_time"] = quantity(time, "ms", 6)
        cut = si(deck["tool"]["position"][0]) + si(deck["tool"]["velocity"][0]) * time
        self.set_length(deck, 40e-6 * round((cut + si(deck["tool"]["edge_radius"]) + self.ahead) / 40e-6))

    def set_length(self, deck, length):
        for one in deck["body"]:
            one["size"][0] = quantity(length, "um")
        self.prepare_output(deck)

    def prepare_output(self, deck):
        deck["output"] = {"force_scale": 1e-3 / self.width(deck), "history_steps": 10,
                          "frame_time": quantity(self.averaged / 5 * decks.end_time(deck), "us", 6)}

    def set_spacing(self, deck, spacing):
        decks.body(deck, "cut zone")["spacing"] = f"{spacing:.9g} um"
        decks.body(deck, "bulk")["spacing"] = f"{2 * spacing:.9g} um"
        self.set_slice(deck, 4)

    def set_slice(self, deck, count):
        width = count * si(deck["body"][0]["spacing"])
        for one in deck["body"]:
            one["size"][2] = quantity(width, "um")
        deck["tool"]["width"] = quantity(3 * width, "um")
        deck["tool"]["position"][2] = quantity(width / 2, "um")
        self.prepare_output(deck)

    def thicken(self, deck, more):
        position = deck["tool"]["position"]
        position[1] = quantity(si(position[1]) - more, "um")

    def set_band(self, deck, below):
        """Depth of the particles below the finished surface; hexes fill what was there before."""
        cut_zone, bulk = decks.body(deck, "cut zone"), decks.body(deck, "bulk")
        bottom, chip = si(bulk["origin"][1]), self.uncut(deck, 0)
        cut_zone["origin"][1], cut_zone["size"][1] = quantity(-below, "um"), quantity(below + chip, "um")
        bulk["size"][1] = quantity(-below - bottom, "um")

    def fill_all(self, deck, fill):
        cut_zone, bulk = decks.body(deck, "cut zone"), decks.body(deck, "bulk")
        top = si(cut_zone["origin"][1]) + si(cut_zone["size"][1])
        bulk.update(name="work", fill=fill, spacing=cut_zone["spacing"])
        bulk["size"][1] = quantity(top - si(bulk["origin"][1]), "um")
        deck["body"] = [bulk]

    def coarsen(self, deck):
        """The one body in cells twice as large."""
        work = decks.body(deck, "work")
        work["spacing"] = quantity(2 * si(work["spacing"]), "um")

    def only_cut_zone(self, deck):
        cut_zone = decks.body(deck, "cut zone")
        del cut_zone["tie"]
        cut_zone["faces"]["y_min"] = "fixed"
        deck["body"] = [cut_zone]

    def spacing_of(self, deck):
        return si(decks.body(deck, "cut zone")["spacing"])

    def uncut(self, deck, time):
        one = deck["body"][0]
        return si(one["origin"][1]) + si(one["size"][1]) - si(deck["tool"]["position"][1])

    def width(self, deck):
        return si(deck["body"][0]["size"][2])

    def window(self, deck, end):
        return (1 - self.averaged) * end, end


class Milling:
    name, deck_file = "milling", "inputs/micro_milling_quick.toml"
    title = "milling slice"
    spacing, spacings, fine_spacings = 2.5, [32.5 / n for n in (8, 9, 10, 11, 13, 16, 20)], [1.25]  # um; 13: as shipped
    trial_spacing, together_spacings = 32.5 / 10, [32.5 / n for n in (8, 10, 13, 16)]
    trend = True            # the chip grows with the immersion
    sector_start = 2.0        # deg, instead of -12: the run ends sooner
    immersion = (76.0, 81.0)  # deg: the averages are from here to here, also of runs that end later
    entry = 72.0              # deg: where the tooth meets the sector of the committed deck

    def base(self, deck):
        self.set_sector(deck, self.sector_start)
        deck["run"]["end_immersion"] = f"{self.immersion[1]} deg"
        self.prepare_output(deck)

    def set_sector(self, deck, begin):
        for one in deck["body"]:
            start, end = (si(one[key]) for key in ("start_angle", "end_angle"))
            share = (end - math.radians(begin)) / (end - start)
            one["cells"][0] = round(one["cells"][0] * share)
            one["start_angle"] = f"{begin} deg"

    def prepare_output(self, deck):
        deck["output"] = {"force_scale": 100e-6 / self.width(deck), "history_steps": 10, "frame_immersion": "1 deg"}

    def set_entry(self, deck, immersion):
        """A later entry: less cut before the window of the average."""
        for one in deck["body"]:
            start, end = (si(one[key]) for key in ("start_angle", "end_angle"))
            later = end - math.radians(immersion - self.entry)
            one["cells"][0] = round(one["cells"][0] * (later - start) / (end - start))
            one["end_angle"] = quantity(later, "deg", 6)
        angle = math.degrees(si(deck["tool"]["start_angle"])) + immersion - self.entry
        deck["tool"]["start_angle"] = f"{angle:.6g} deg"

    def set_spacing(self, deck, spacing):
        cut_zone, bulk = decks.body(deck, "cut zone"), decks.body(deck, "bulk")
        finer = self.spacing / spacing
        around = round(bulk["cells"][0] * finer)
        bulk["cells"] = [around, 2, round(bulk["cells"][2] * finer)]
        cut_zone["cells"] = [2 * around, 4, round(cut_zone["cells"][2] * finer)]
        self._set_height(deck, 4 * spacing * 1e-6)

    def _set_height(self, deck, height):
        for one in deck["body"]:
            one["height"] = quantity(height, "um")
        deck["tool"]["length"] = quantity(3 * height, "um")
        deck["tool"]["position"][2] = quantity(-height, "um")
        self.prepare_output(deck)

    def set_slice(self, deck, count):
        cell = self.spacing_of(deck)
        decks.body(deck, "cut zone")["cells"][1] = count
        if bulk := decks.body(deck, "bulk"):
            bulk["cells"][1] = count // 2
        self._set_height(deck, count * cell)

    def thicken(self, deck, more):
        tool = deck["tool"]
        tool["feed_per_tooth"] = quantity(si(tool["feed_per_tooth"]) + more, "um")

    def set_band(self, deck, rows):
        """Rows of particles along the radius, more or fewer; hexes fill what was there before."""
        cut_zone, bulk = decks.body(deck, "cut zone"), decks.body(deck, "bulk")
        inner, border = si(cut_zone["inner_radius"]), si(cut_zone["outer_radius"])
        cell = (border - inner + si(deck["tool"]["feed_per_tooth"])) / cut_zone["cells"][2]
        moved = border + rows * cell
        share = (si(bulk["outer_radius"]) - moved) / (si(bulk["outer_radius"]) - border)
        cut_zone["cells"][2] += rows
        cut_zone["outer_radius"] = bulk["inner_radius"] = quantity(moved, "um")
        bulk["cells"][2] = round(bulk["cells"][2] * share)

    def fill_all(self, deck, fill):
        cut_zone, bulk = decks.body(deck, "cut zone"), decks.body(deck, "bulk")
        inner, border, outer = (si(one) for one in
                                (cut_zone["inner_radius"], cut_zone["outer_radius"], bulk["outer_radius"]))
        feed = si(deck["tool"]["feed_per_tooth"])
        rows = round(cut_zone["cells"][2] * (outer - inner + feed) / (border - inner + feed))
        cut_zone.update(name="work", fill=fill, outer_radius=bulk["outer_radius"], faces=bulk["faces"])
        cut_zone["cells"][2] = rows
        del cut_zone["tie"]
        deck["body"] = [cut_zone]

    def coarsen(self, deck):
        """The one body in cells twice as large."""
        work = decks.body(deck, "work")
        work["cells"] = [count // 2 for count in work["cells"]]

    def only_cut_zone(self, deck):
        cut_zone = decks.body(deck, "cut zone")
        del cut_zone["tie"]
        cut_zone["faces"]["outer"] = "fixed"
        deck["body"] = [cut_zone]

    def spacing_of(self, deck):
        return self.width(deck) / decks.body(deck, "cut zone")["cells"][1]

    def uncut(self, deck, time):
        tool = deck["tool"]
        return si(tool["feed_per_tooth"]) * math.sin(
            si(tool["start_angle"]) + si(tool["spindle_speed"]) * time)

    def width(self, deck):
        return si(deck["body"][0]["height"])

    def window(self, deck, end):
        tool = deck["tool"]
        return tuple((math.radians(one) - si(tool["start_angle"])) / si(tool["spindle_speed"])
                     for one in self.immersion)


SCENES = {scene.name: scene for scene in (Orthogonal(), Milling())}
