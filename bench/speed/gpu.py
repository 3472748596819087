"""What a GPU would do, on paper: bytes and operations of a particle and step over the rates of a data sheet."""
from swarf import reports

from targets import size_text

FLOPS, BYTES, MEMORY = 34e12, 3.3e12, 80e9  # H100 SXM, NVIDIA's data sheet: double, memory
TEXT = """
## Estimate, not measured: a GPU

On paper: an H100 ({flops:.0f} TFLOP/s in double, {bytes_:.1f} TB/s, {memory:.0f} GB). Time of a kernel: operations or
bytes over these rates, whichever takes longer; calls a step as measured in the scene "particles" on this page. On a GPU
each particle has its own list ({near:.0f} rows of the skin's reach). "Each field once": caches serve all neighbours, the
most that is possible. "Each neighbour anew": every pair reads the fields of its neighbour from memory, as if there were
no cache. Nothing here was run on a GPU: launches, waiting for memory, divergence and atomics are left out.
"""


def calls(results, size):
    """(kernel, calls a step) of the scene "particles"."""
    step = results.get("step, particles", size, 1)
    rebuilds = 1 / step["steps"]
    of = step.get("calls", {})
    return [("velocity_gradient", 1), ("update_stress, 20 % plastic", 1), ("diffuse_pressure", of["diffuse_pressure"]),
            ("prepare_pair_state", 1), ("particle_forces, hourglass stiffness", 1), ("conduct_heat", of["conduct_heat"]),
            ("integrate", 2), ("tool_contact", 1), ("sort_particles", rebuilds), ("find_neighbors", rebuilds),
            *((name, of[name]) for name in ("find_shifts", "transport_fields") if name in of)]


def seconds(row, bytes_):
    return max(row["gpu_flops_per_item"] / FLOPS, row[bytes_] / BYTES)


def lines(results, size):
    if not (results.get("step, particles", size, 1) or {}).get("calls"):
        return
    near = results.get("find_neighbors", size, 1)["near_pairs_per_item"]
    yield TEXT.format(flops=FLOPS / 1e12, bytes_=BYTES / 1e12, memory=MEMORY / 1e9, near=near)
    head = ["kernel", "calls a step", "flop", "bytes, each field once", "ps a step", "bound by",
            "bytes, each neighbour anew", "ps a step"]
    table = []
    best = worst = flops = once = anew = 0
    for name, times in calls(results, size):
        row = results.get(name, size, 1)
        fast, slow = (times * seconds(row, f"{kind}_bytes_per_item") for kind in ("gpu", "gathered"))
        best, worst, flops = best + fast, worst + slow, flops + times * row["gpu_flops_per_item"]
        once, anew = once + times * row["gpu_bytes_per_item"], anew + times * row["gathered_bytes_per_item"]
        bound = "operations" if row["gpu_flops_per_item"] / FLOPS > row["gpu_bytes_per_item"] / BYTES else "memory"
        table.append([name, f"{times:.2f}", f"{row['gpu_flops_per_item']:.0f}", f"{row['gpu_bytes_per_item']:.0f}",
                      f"{1e12 * fast:.0f}", bound, f"{row['gathered_bytes_per_item']:.0f}", f"{1e12 * slow:.0f}"])
    table.append(["**a step**", "", f"{flops:.0f}", f"{once:.0f}", f"{1e12 * best:.0f}", "", f"{anew:.0f}",
                  f"{1e12 * worst:.0f}"])
    yield from reports.table(head, table)
    two = results.get("step, particles", size, 2)
    step = results.get("step, particles", size, 1)
    yield (f"\nSo between {1e-6 / worst:.0f} and {1e-6 / best:.0f} million particle-steps a second; measured here on 2 "
           f"threads: {1e-6 / two['seconds_per_item']:.2f}. Its memory would hold about "
           f"{1e-6 * MEMORY * step['items'] / sum(step['bytes'].values()):.0f} million particles of this scene. Counts "
           f"are those at {size_text(size)} particles.")
