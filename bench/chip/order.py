"""How even the particles of a chip lie: lengths over the spacing, pressures over the yield stress A."""
import numpy
from scipy import ndimage, spatial

PLASTIC = 0.3  # from this plastic strain on a particle counts as chip
RADIUS = 0.9   # of the ball that a particle fills: half the diagonal of its cube is 0.87


def repeated(points, width):
    """The slice and its two periodic neighbours, and the row that each point came from."""
    shift = numpy.array([0, 0, width])
    return numpy.concatenate([points, points + shift, points - shift]), numpy.tile(numpy.arange(len(points)), 3)


def kernel(q):
    return (0.25 * numpy.clip(2 - q, 0, None) ** 3 - numpy.clip(1 - q, 0, None) ** 3) / numpy.pi


def pressure_noise(tree, all_points, row, points, pressure, chosen):
    """Root mean square of what a linear fit to the nearest neighbours does not explain."""
    beyond = []
    for i in chosen:
        near = [k for k in tree.query_ball_point(points[i], 1.6) if row[k] != i]
        if len(near) > 6:
            away = numpy.c_[numpy.ones(len(near)), all_points[near] - points[i]]
            beyond.append(pressure[i] - numpy.linalg.lstsq(away, pressure[row[near]], rcond=None)[0][0])
    return float(numpy.sqrt(numpy.mean(numpy.square(beyond))))


def void_share(points, width, chip):
    """Share of the chip that no ball covers. The chip: its balls, closed over gaps of up to two spacings."""
    cell = 1 / 6
    all_points, _ = repeated(points, width)
    low, high = points[chip].min(axis=0) - 3, points[chip].max(axis=0) + 3
    axes = [numpy.arange(low[k], high[k], cell) for k in (0, 1)] + [numpy.arange(0, width, cell) + points[:, 2].min()]
    grid = numpy.stack(numpy.meshgrid(*axes, indexing="ij"), axis=-1)
    reached = spatial.cKDTree(all_points).query(grid, distance_upper_bound=RADIUS)[0] < numpy.inf
    chip_near = spatial.cKDTree(repeated(points[chip], width)[0]).query(grid, distance_upper_bound=1.6)[0] < numpy.inf
    layers = len(axes[2])
    wide = ndimage.distance_transform_edt(~numpy.concatenate([reached] * 3, axis=2)) <= 1 / cell
    closed = (ndimage.distance_transform_edt(wide) > 1 / cell)[:, :, layers:2 * layers] & chip_near
    return float((closed & ~reached).sum() / closed.sum())


def measure(frame, spacing, width, yield_stress, ratio=1.2):
    points, width = frame["position"].astype(float) / spacing, width / spacing
    volume, pressure = frame["volume"] / spacing ** 3, frame["pressure"] / yield_stress
    chip = frame["equivalent_plastic_strain"] > PLASTIC
    chosen = numpy.flatnonzero(chip)
    all_points, row = repeated(points, width)
    tree = spatial.cKDTree(all_points)
    nearest = tree.query(points[chip], k=2)[0][:, 1]
    sums = []
    for i in chosen:
        near = numpy.array(tree.query_ball_point(points[i], 2 * ratio))
        sums.append((volume[row[near]] * kernel(numpy.linalg.norm(all_points[near] - points[i], axis=1) / ratio)).sum()
                    / ratio ** 3)
    return {"nearest": float(numpy.percentile(nearest, 5)), "dense": float(numpy.percentile(sums, 95)),
            "noise": pressure_noise(tree, all_points, row, points, pressure, chosen),
            "voids": void_share(points, width, chip)}
