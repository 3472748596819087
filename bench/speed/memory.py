"""Where the bytes of a particle are: every View, and the whole process."""
from swarf import reports

from targets import size_text

TEXT = """
## Memory

Scene "particles", double, 1 thread. Views: what Kokkos holds when it holds the most, from one rebuild of the lists to
the next. Process: resident memory, the most of the whole run, the building of the scene among it. A periodic slice has
ghosts, rows of their own of whatever a neighbour is read from; they are the fewer the thicker the slice."""


def growth_rows(results):
    head = ["particles", "ghosts", "Views, bytes a particle", "without ghosts and tool", "process, most", "process, after"]
    table = []
    for size in results.step_sizes("step, particles"):
        row = results.get("step, particles", size, 1)
        if "bytes" not in row:
            continue
        items = row["items"]
        own = sum(one[1] for one in views(row) if one[0] != "tool")
        table.append([size_text(int(items)), f"{100 * row['ghosts'] / items:.0f} %",
                      f"{sum(row['bytes'].values()) / items:.0f}", f"{own:.0f}", f"{row['most_resident'] / items:.0f}",
                      f"{row['resident'] / items:.0f}"])
    return reports.table(head, table)


def views(row):
    """(label, bytes of a particle's own row, bytes a particle with its share of ghosts), largest first."""
    items, found = row["items"], {}
    for label, size in row["bytes"].items():
        label = "tool" if label.startswith("tool_") else label or "(no label)"
        # Rows of particles alone, with room for ghosts, or with ghosts: whole numbers fill them.
        fits = [rows for rows in (items, row["rows"], items + row["ghosts"]) if size > items and size % rows < 1024]
        own = size * items / fits[0] if fits else size
        before = found.get(label, (0, 0))
        found[label] = before[0] + own / items, before[1] + size / items
    return sorted(((label, *both) for label, both in found.items()), key=lambda one: -one[2])


def slope(results, small, large):
    a, b = (results.get("step, particles", size, 1) for size in (small, large))
    return (b["most_resident"] - a["most_resident"]) / (b["items"] - a["items"])


def view_rows(results):
    size = max(size for size in results.step_sizes("step, particles")
               if "bytes" in results.get("step, particles", size, 1))
    yield f"\nViews at {size_text(size)} particles; those of less than half a byte a particle together.\n"
    table, rest = [], [0, 0]
    for label, own, all_ in views(results.get("step, particles", size, 1)):
        if all_ >= 0.5:
            table.append([label, f"{own:.1f}", f"{all_:.1f}"])
        else:
            rest = [rest[0] + own, rest[1] + all_]
    table.append(["others", f"{rest[0]:.1f}", f"{rest[1]:.1f}"])
    yield from reports.table(["View", "bytes of a row", "bytes a particle, with ghosts"], table)


def lines(results):
    sizes = results.step_sizes("step, particles")
    if not any("bytes" in results.get("step, particles", size, 1) for size in sizes):
        return
    yield TEXT
    yield from growth_rows(results)
    if len(sizes) > 1:
        small, large = sizes[-2:]
        yield (f"\nThe process grows by {slope(results, small, large):.0f} bytes a particle from {size_text(small)} to "
               f"{size_text(large)}.")
    yield from view_rows(results)
