"""The targets that were set for two cores before anything was measured, and what is measured."""

from swarf import reports


def rate(results, name, size, threads=2, bits=64):
    row = results.get(f"step, {name}", size, threads, bits)
    return 1e-6 / row["seconds_per_item"] if row else None


def speed_up(results, name, size):
    one, two = (results.get(f"step, {name}", size, threads) for threads in (1, 2))
    return results.ratio(one, two) if one and two else None


def float_gain(results, size):
    double, single = (rate(results, "particles", size, bits=bits) for bits in (64, 32))
    return single / double if double and single else None


def size_text(size):
    return f"{size:,}".replace(",", " ")


def measured(results):
    """(what, target, unit, is the target a most, value or None)"""
    for size, target in ((100_000, 2.0), (1_000_000, 1.8), (4_000_000, 1.8)):
        yield (f"whole step, {size_text(size)} particles, 2 threads", target, " M/s", False,
               rate(results, "particles", size))
    for size in (100_000, 1_000_000):
        yield f"float over double, {size_text(size)} particles, 2 threads", 1.4, "", False, float_gain(results, size)
    yield "whole step, 123 840 hexes, 2 threads", 3.0, " M/s", False, rate(results, "hexes", 123_840)
    for name, size in (("particles", 100_000), ("particles", 1_000_000), ("particles", 4_000_000), ("hexes", 123_840)):
        yield f"2 over 1 thread, {size_text(size)} {name}", 1.9, "", False, speed_up(results, name, size)
    start = results.all.get("start_up", {}).get("2")
    yield "start of `inputs/micro_milling.toml` to its first step, 2 threads", 10, " s", True, start and start["seconds"]
    for size in (1_000_000, 4_000_000):
        for bits, word in ((64, "double"), (32, "float")):
            row = results.get("step, particles", size, 1, bits)
            yield (f"memory at {size_text(size)} particles in {word}, lists and ghosts included", 600, " bytes a particle",
                   True, row and row["most_resident"] / row["items"])


def is_met(target, most, value):
    return value <= target if most else value >= target


def summary(results):
    """How many are met, and by how much the others are missed."""
    known = [one for one in measured(results) if one[-1] is not None]
    missed = [(what, target, unit, value) for what, target, unit, most, value in known if not is_met(target, most, value)]
    said = f"{len(known) - len(missed)} of {len(known)} targets are met."
    return said + (" Missed: " + "; ".join(f"{what} ({value:.{0 if target >= 100 else 2}f}{unit} for {target:g})"
                                           for what, target, unit, value in missed) + "." if missed else "")


def rows(results):
    table = []
    for what, target, unit, most, value in measured(results):
        digits = 0 if target >= 100 else 2
        met = "not measured" if value is None else "yes" if is_met(target, most, value) else "**no**"
        table.append([what, f"{'at most' if most else 'at least'} {target:g}{unit}",
                      "-" if value is None else f"{value:.{digits}f}{unit}", met])
    yield from reports.table(["what", "target", "measured", "met"], table)
    load, cores = results.all["load_average"]["median"], results.all["cores"]
    if load > 1.2 * cores:
        yield (f"\nOther programs ran beside (load {load:.1f} on {cores} cores): what is said of 2 threads is too low, and a "
               "rate that is not met may be met on a quiet machine.")
