"""Stands in for the program where a test is of what studies do with runs: "runs" a deck in no time, with a mean force
that is known, F = 3 + 2 a - b^2 of the deck's [run] a and b. Where KILL_AT is in the environment and the run's deck has
that name, the first call dies as a killed process does, behind a checkpoint."""
import os
import pathlib
import signal
import sys
import tomllib

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import conftest  # noqa: E402  writes results as swarf does


def main():
    deck_file, folder = pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[sys.argv.index("--output") + 1])
    deck = tomllib.loads(deck_file.read_text())
    folder.mkdir(parents=True, exist_ok=True)
    with open(folder / "calls", "a") as calls:
        calls.write(" ".join(sys.argv[1:]) + "\n")
    (folder / "deck.toml").write_text(deck_file.read_text())
    (folder / "history.csv").write_text("time [s],force_x [N]\n")
    (folder / "checkpoint.h5").write_text("of a test")
    if os.environ.get("KILL_AT") == deck_file.stem and "--resume" not in sys.argv:
        os.kill(os.getpid(), signal.SIGKILL)
    if deck["run"].get("fails"):
        return 3
    value = 3 + 2 * deck["run"]["a"] - deck["run"].get("b", 0)**2 + deck["run"].get("offset", 0)
    time = numpy.linspace(0, 1e-3, 401)
    force = value * (1 + 0.1 * numpy.sin(2e5 * time)) * (time > 0)
    rows = numpy.array([time, 0.6 * force, -0.8 * force, 0 * time, 4e-4 * force, 300 + 1e5 * time]).T
    head = "time [s],force_x [N],force_y [N],force_z [N],torque [N m],max_temperature [K]\n"
    (folder / "history.csv").write_text(head + "".join(",".join(map(repr, map(float, row))) + "\n" for row in rows))
    conftest.write_hdf5(folder / "results.h5", {"time": ("s", time), "immersion": ("deg", 0 * time),
                                                "force_planar_filtered": ("N", force)})
    (folder / "summary.json").write_text('{"ended": "complete", "cost": {"cpu_seconds": 1.5}}')
    return 0


if __name__ == "__main__":
    sys.exit(main())
