"""What a finished run says: forces with their statistical error, chip thickness, temperatures, cost."""
import math

import numpy

import swarf
from swarf import si

BLOCKS = 6  # of the averaging window: enough to see the scatter, each longer than a swing of the force


def tool_frame(deck, time):
    """Lowest point of the edge, direction of the cut and direction away from the finished surface, in the plane."""
    tool = deck["tool"]
    position = numpy.array([si(one) for one in tool["position"][:2]])
    if tool["kind"] == "wedge":
        velocity = numpy.array([si(one) for one in tool["velocity"][:2]])
        return position + velocity * time, numpy.array([1.0, 0.0]), numpy.array([0.0, 1.0])
    speed = si(tool["spindle_speed"])
    feed = si(tool["feed_per_tooth"]) * tool["flutes"] * speed / (2 * math.pi)
    axis = position + feed * time * numpy.array(tool["feed_direction"][:2])
    immersion = si(tool["start_angle"]) + speed * time  # clockwise from +y
    radial = numpy.array([math.sin(immersion), math.cos(immersion)])
    return (axis + si(tool["diameter"]) / 2 * radial,
            numpy.array([math.cos(immersion), -math.sin(immersion)]), -radial)


def cutting_forces(deck, table):
    """On the tool: F_c against its motion, F_f away from the finished surface."""
    force = numpy.stack([table["force_x"], table["force_y"]], axis=1)
    frames = [tool_frame(deck, time) for time in table["time"]]
    cut, away = (numpy.array([frame[k] for frame in frames]) for k in (1, 2))
    return -(force * cut).sum(axis=1), (force * away).sum(axis=1)


def mean_and_error(time, values, begin, end, trend):
    """Mean over [begin, end] and its standard error from the means of blocks. A trend that belongs to the scene
    (the chip of a mill grows) is no scatter: it is taken out before."""
    inside = (time > begin) & (time <= end * (1 + 1e-12))
    weight = numpy.diff(time, prepend=time[0])[inside]  # a sample is the mean since the one before
    time, values = time[inside], values[inside]
    if len(values) < 4 * BLOCKS:
        return None, None
    mean = numpy.average(values, weights=weight)
    if trend:
        values = values - numpy.polyval(numpy.polyfit(time, values, 1, w=numpy.sqrt(weight)), time)
    block = numpy.minimum(((time - begin) / (end - begin) * BLOCKS).astype(int), BLOCKS - 1)
    means = [numpy.average(values[block == k], weights=weight[block == k]) for k in range(BLOCKS)]
    return float(mean), float(numpy.std(means, ddof=1) / math.sqrt(BLOCKS))


def material_points(frame):
    """Position, volume and temperature of particles and of the hexes that are left."""
    parts = []
    if particles := frame.particles:
        parts.append((particles["position"], particles["volume"], particles["temperature"]))
    if hexes := frame.hexes:
        centre = hexes["position"][hexes["connectivity"]].mean(axis=1)
        alive = hexes["active"] > 0
        parts.append((centre[alive], hexes["volume"][alive], hexes["temperature"][alive]))
    return [numpy.concatenate(one).astype(float) for one in zip(*parts)]


def chip_of(deck, frame, uncut, width):
    """Thickness and mean temperature of the chip on the rake face.

    Measured where the chip is free of the work: from where the rake face is 1.1 uncut thicknesses above the
    finished surface, over half an uncut thickness along the face. Thickness = volume there / width / that length:
    a mean normal to the rake face. None while the chip does not yet reach half an uncut thickness further.
    """
    tip, cut, away = tool_frame(deck, frame.time)
    tool = deck["tool"]
    rake, radius = si(tool["rake"]), si(tool["edge_radius"])
    normal = math.cos(rake) * cut + math.sin(rake) * away
    along = math.cos(rake) * away - math.sin(rake) * cut
    position, volume, temperature = material_points(frame)
    from_centre = position[:, :2] - (tip + radius * away)
    s, d = from_centre @ along, from_centre @ normal - radius
    begin = (1.1 * uncut - radius * (1 + math.sin(rake))) / math.cos(rake)
    on_face = (s > begin) & (d > -0.25 * uncut) & (d < 5 * uncut)
    here = on_face & (s <= begin + 0.5 * uncut)
    if not (on_face & (s > begin + uncut)).any() or not here.any():
        return None
    # A chip that curls may come by a second time: what lies beyond a gap of two spacings is not counted.
    outwards = numpy.flatnonzero(here)[numpy.argsort(d[here])]
    gaps = numpy.diff(d[outwards]) > 2 * numpy.cbrt(volume[outwards].mean())
    here = outwards[:numpy.argmax(gaps) + 1] if gaps.any() else outwards
    return volume[here].sum() / width / (0.5 * uncut), numpy.average(temperature[here], weights=volume[here])


def mean_chip(deck, frames, scene, begin, end):
    found = [chip_of(deck, frame, scene.uncut(deck, frame.time), scene.width(deck)) for frame in frames
             if begin < frame.time <= end * 1.001]
    found = [one for one in found if one]
    return tuple(float(one) for one in numpy.mean(found, axis=0)) if found else (None, None)


def measure(deck, folder, scene):
    """One row of the results."""
    run = swarf.read(folder)
    summary = run.summary
    why = summary["why"] if summary["ended"] == "failed" or summary["why"] == "SIGXCPU" else summary["ended"]
    row = {"status": why, "core_seconds": summary["cost"]["cpu_seconds"],
           "particles": summary["particles"], "hexes": summary["hexes"], "steps": summary["steps"],
           "particle_steps": summary["particles"] * summary["steps"],
           "energy_residual": summary["energies"]["worst_residual_over_external"],
           "viscous_share": summary["energies"]["viscous_share"],
           "hourglass_share": summary["energies"]["hourglass_work"] / summary["energies"]["external_work"]
           if summary["energies"]["external_work"] else None,
           "kinetic_share": summary["energies"]["kinetic_energy"] / summary["energies"]["external_work"]
           if summary["energies"]["external_work"] else None}
    if not run.is_complete:
        return row
    table = run.history
    begin, end = scene.window(deck, table["time"][-1])
    for name, values in zip(("cutting_force", "feed_force"), cutting_forces(deck, table)):
        row[name], row[name + "_error"] = mean_and_error(table["time"], values, begin, end, scene.trend)
    inside = (table["time"] > begin) & (table["time"] <= end * (1 + 1e-12))
    row["max_temperature"] = float(table["max_temperature"][inside].mean())
    row["uncut_thickness"] = scene.uncut(deck, (begin + end) / 2)
    row["chip_thickness"], row["chip_temperature"] = mean_chip(deck, run.frames, scene, begin, end)
    return row
