"""Places a label beside each point of a chart so that none covers another, a point or the frame."""
import math


def _overlap(a, b):
    return max(0, min(a[2], b[2]) - max(a[0], b[0])) * max(0, min(a[3], b[3]) - max(a[1], b[1]))


def _candidates():
    """Offsets of the label's nearest corner or edge from the point, in points: near ones first."""
    for distance in (5, 8, 12, 18, 26, 36, 48, 62, 78, 96, 116):
        for step in range(16):
            yield distance, 2 * math.pi * step / 16


def place(figure, axes, points, keep_clear=(), size=7):
    """points: (x, y, text). keep_clear: (x, y) that no label may cover. Labels far from their point get a line."""
    renderer = figure.canvas.get_renderer()
    pixels = figure.dpi / 72
    frame = axes.get_window_extent(renderer)
    taken = []
    for x, y in [point[:2] for point in points] + list(keep_clear):
        px, py = axes.transData.transform((x, y))
        taken.append((px - 3 * pixels, py - 3 * pixels, px + 3 * pixels, py + 3 * pixels))
    for x, y, text in sorted(points, key=lambda point: (point[0], point[1])):
        px, py = axes.transData.transform((x, y))
        drawn = axes.text(0, 0, text, fontsize=size, transform=None)
        box = drawn.get_window_extent(renderer)
        drawn.remove()
        width, height = box.width + 2 * pixels, box.height + 1 * pixels
        best = None
        for distance, angle in _candidates():
            cos, sin = math.cos(angle), math.sin(angle)
            cx = px + distance * pixels * cos + width / 2 * max(-1, min(1, 1.5 * cos))
            cy = py + distance * pixels * sin + height / 2 * max(-1, min(1, 1.5 * sin))
            here = (cx - width / 2, cy - height / 2, cx + width / 2, cy + height / 2)
            outside = here[0] < frame.x0 or here[2] > frame.x1 or here[1] < frame.y0 or here[3] > frame.y1
            cost = sum(_overlap(here, other) for other in taken) + (1e9 if outside else 0)
            if best is None or cost < best[0]:
                best = (cost, here, distance)
            if cost == 0:
                break
        _, here, distance = best
        taken.append(here)
        centre = ((here[0] + here[2]) / 2, (here[1] + here[3]) / 2)
        line = {"arrowstyle": "-", "color": "0.6", "linewidth": 0.5, "shrinkA": 0, "shrinkB": 2}
        axes.annotate(text, (x, y), xytext=axes.transData.inverted().transform(centre), fontsize=size, ha="center",
                      va="center", zorder=5, arrowprops=line if distance > 8 else None)
