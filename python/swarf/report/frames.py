"""Frames of a run as the page has them: 16 bits a number, deflated, in base64. Lengths in micrometres."""
import base64
import zlib

import numpy

UM = 1e6
FIELDS = [("temperature", "temperature", "K", 1), ("equivalent_plastic_strain", "plastic strain", "", 1),
          ("von_mises", "von Mises stress", "MPa", 1e-6), ("velocity", "speed", "m/s", 1)]
SIDES = numpy.array([[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]])


class Pack:
    """Blocks of one scene, one behind the other."""

    def __init__(self):
        self.blocks, self.size = [], 0

    def put(self, array):
        at = self.size
        data = array.tobytes()
        data += b"\0" * (-len(data) % 4)
        self.blocks.append(data)
        self.size += len(data)
        return at

    def numbers(self, values):
        """Between the least and the most of each column in 65 535 steps."""
        values = numpy.asarray(values, float).reshape(len(values), -1)
        low, high = (values.min(0), values.max(0)) if len(values) else (numpy.zeros(values.shape[1]),) * 2
        span = numpy.where(high > low, high - low, 1)
        raw = numpy.rint((values - low) / span * 65535).astype("<u2")
        return {"at": self.put(raw), "count": len(values), "width": values.shape[1], "low": [float(v) for v in low],
                "high": [float(v) for v in high]}

    def text(self):
        return base64.b64encode(zlib.compress(b"".join(self.blocks), 9)).decode()


def field_of(arrays, name, scale):
    values = numpy.asarray(arrays[name], float)
    return scale * (numpy.linalg.norm(values, axis=1) if values.ndim > 1 else values)


def outer_faces(connectivity, active):
    """(hex, four nodes) of each side that no other hex shares; of hexes that are there."""
    alive = numpy.flatnonzero(active != 0)
    quads = connectivity[alive][:, SIDES].reshape(-1, 4)
    owner = numpy.repeat(alive, 6)
    _, first, count = numpy.unique(numpy.sort(quads, axis=1), axis=0, return_index=True, return_counts=True)
    alone = first[count == 1]
    return owner[alone], quads[alone]


def turn_of(base, now):
    """The rigid motion from base to now, as a matrix of columns one after another (Kabsch 1976)."""
    a, b = base - base.mean(0), now - now.mean(0)
    u, _, v = numpy.linalg.svd(a.T @ b)
    flip = numpy.diag([1, 1, numpy.sign(numpy.linalg.det(u @ v))])
    matrix = numpy.eye(4)
    matrix[:3, :3] = (u @ flip @ v).T
    matrix[:3, 3] = now.mean(0) - matrix[:3, :3] @ base.mean(0)
    return [round(float(value), 9) for value in matrix.T.ravel()]


def particles_of(frame, every, pack):
    arrays = frame.particles
    if arrays is None:
        return None, None
    chosen = arrays["identity"] % every == 0 if every > 1 and "identity" in arrays else slice(None, None, every)
    points = UM * arrays["position"][chosen]
    fields = {name: field_of(arrays, name, scale)[chosen] for name, _, _, scale in FIELDS if name in arrays}
    return points, {"points": pack.numbers(points), "fields": {name: pack.numbers(v) for name, v in fields.items()}}


def hexes_of(frame, pack):
    arrays = frame.hexes
    if arrays is None:
        return None
    owner, quads = outer_faces(arrays["connectivity"], arrays.get("active", numpy.ones(len(arrays["connectivity"]))))
    if len(owner) == 0:
        return None
    fields = {}
    for name, _, _, scale in FIELDS:
        if name in arrays:
            values = field_of(arrays, name, scale)
            at_nodes = len(values) == len(arrays["position"])
            fields[name] = values[quads].ravel() if at_nodes else numpy.repeat(values[owner], 4)
    corners = numpy.arange(quads.size, dtype="<u4")  # each side has its own, so that colours do not run together
    return {"points": pack.numbers(UM * arrays["position"][quads].reshape(-1, 3)),
            "faces": {"at": pack.put(corners), "count": len(quads)},
            "fields": {name: pack.numbers(values) for name, values in fields.items()}}


def thin_out(run, budget):
    """(every so many frames, every so many particles) that keep a scene within so many bytes before it is deflated."""
    frames = [frame for frame in run.frames if frame.parts]
    first = frames[0]
    particles = len(first.particles["position"]) if "particles" in first.parts else 0
    faces = len(outer_faces(first.hexes["connectivity"], first.hexes["active"])[0]) if "hexes" in first.parts else 0
    of_frame = lambda every: particles / every * 2 * (3 + len(FIELDS)) + faces * (4 * 2 * (3 + len(FIELDS)) + 16)
    skip = max(1, -(-len(frames) // 40))
    every = 1
    while of_frame(every) * len(frames) / skip > budget and every < max(1, particles // 20000):
        every += 1
    while of_frame(every) * len(frames) / skip > budget and len(frames) / skip > 8:
        skip += 1
    while of_frame(every) * len(frames) / skip > budget and every < max(particles, 1):
        every += 1
    return skip, every


def pack_scene(run, name, budget):
    """(what the page's script needs to know, the data as text), or None of a run without frames."""
    frames = [frame for frame in run.frames if frame.parts] if (run.folder / "frames.csv").exists() else []
    if not frames:
        return None
    skip, every = thin_out(run, budget)
    chosen = sorted(set(range(0, len(frames), skip)) | {len(frames) - 1})
    pack, listed, reach = Pack(), [], []
    tool = next((frame.tool["position"].reshape(-1, 3) * UM for frame in frames if frame.tool is not None), None)
    for k in chosen:
        frame = frames[k]
        time = f"{1e3 * frame.time:.4g} ms" if frame.time < 1 else f"{frame.time:.4g} s"
        one = {"title": time if frame.immersion is None else f"{frame.immersion:.1f} deg, {time}"}
        points, one["particles"] = particles_of(frame, every, pack)
        one["hexes"] = hexes_of(frame, pack)
        if tool is not None and frame.tool is not None:
            one["tool"] = turn_of(tool, frame.tool["position"].reshape(-1, 3) * UM)
        reach.append(points)
        listed.append(one)
    ranges = field_ranges(listed)
    first = frames[0].particles
    spacing = UM * float(first["volume"].mean())**(1 / 3) if first is not None and "volume" in first else 1.0
    scene = {"id": name, "frames": listed, "tool": None if tool is None else pack.numbers(tool), "fields": ranges,
             **camera(run, reach, listed, spacing)}
    thinned = ([f"one particle in {every}"] if every > 1 else []) + ([f"one frame in {skip}"] if skip > 1 else [])
    scene["note"] = f"{len(chosen)} frames" + (f"; shown: {', '.join(thinned)}" if thinned else ", all particles")
    if every > 1:
        scene["radius"] *= every**(1 / 3)
    return scene, pack.text()


def field_ranges(listed):
    ranges = []
    for name, title, unit, _ in FIELDS:
        both = [one[part]["fields"][name] for one in listed for part in ("particles", "hexes")
                if one[part] and name in one[part]["fields"]]
        if both:
            ranges.append({"name": name, "title": title, "unit": unit, "low": min(one["low"][0] for one in both),
                           "high": max(one["high"][0] for one in both)})
    return ranges


def camera(run, reach, listed, spacing):
    """At the particles, along output.picture_view; of a scene of hexes only at them."""
    view = numpy.array(run.deck.get("output", {}).get("picture_view", [0, 0, 1]), float)
    view /= numpy.linalg.norm(view)
    up = numpy.array([0, 1, 0]) if abs(view[1]) < 0.9 else numpy.array([0, 0, 1])
    points = [one for one in reach if one is not None]
    if points:
        low, high = numpy.min([one.min(0) for one in points], 0), numpy.max([one.max(0) for one in points], 0)
    else:
        box = [one["hexes"]["points"] for one in listed if one["hexes"]]
        low, high = (numpy.array(end(one[key] for one in box)) for end, key in ((min, "low"), (max, "high")))
    size = float(numpy.linalg.norm(high - low))
    return {"focus": [float(v) for v in (low + high) / 2], "view": view.tolist(), "up": up.tolist(), "distance": 3 * size,
            "scale": 0.36 * size, "radius": 0.62 * spacing}
