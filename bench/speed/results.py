"""bench/results.json as the page and the picture need it."""
import json
import pathlib
import statistics

RESULTS = pathlib.Path(__file__).resolve().parents[1] / "results.json"


class Results:
    def __init__(self):
        self.all = json.loads(RESULTS.read_text())
        self.rows = {(row["name"], row["size"], row["threads"], row["bits"]): row for row in self.all["rows"]}

    def get(self, name, size, threads, bits=64):
        return self.rows.get((name, size, threads, bits))

    def names(self, step):
        found = dict.fromkeys(row["name"] for row in self.all["rows"])
        return [name for name in found if name.startswith("step,") == step and name not in ("peak_fma", "triad")]

    def sizes(self):
        return sorted({row["size"] for row in self.all["rows"] if row["name"] in self.names(step=False)})

    def step_sizes(self, name):
        return sorted({row["size"] for row in self.all["rows"] if row["name"] == name and row["bits"] == 64})

    def ceiling(self, threads, bits=64):
        """Operations and bytes per second, the most of all rounds: what the machine can do. On one thread by processor
        time, which does not count waiting for other programs."""
        (fma,), (triad,) = ([row for row in self.all["rows"] if row["name"] == name and row["threads"] == threads
                             and row["bits"] == bits] for name in ("peak_fma", "triad"))
        best = [min(self.seconds(row), row["best"]) for row in (fma, triad)]
        return fma["flops_per_item"] / best[0], triad["bytes_per_item"] / best[1]

    @staticmethod
    def seconds(row):
        """Of an item: of a core on one thread, by the clock on two."""
        return row.get("core_seconds_per_item", row["seconds_per_item"])

    def share(self, row, quantity):
        """Of the ceiling of the same round, median of the rounds."""
        name, bound = {"flops": ("peak_fma", "flops_per_item"), "lane_flops": ("peak_fma", "flops_per_item"),
                       "bytes": ("triad", "bytes_per_item")}[quantity]
        ceiling = next(one for one in self.all["rows"]
                       if (one["name"], one["threads"], one["bits"]) == (name, row["threads"], row["bits"]))
        return statistics.median(row[f"{quantity}_per_item"] / row["rounds"][k] * ceiling["rounds"][k] / ceiling[bound]
                                 for k in row["rounds"])

    def ratio(self, slow, fast):
        """How many times as fast, in the same rounds."""
        shared = [k for k in slow["rounds"] if k in fast["rounds"]]
        return statistics.median(slow["rounds"][k] / fast["rounds"][k] for k in shared)
