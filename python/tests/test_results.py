import json

import numpy
import pytest
import swarf

from conftest import CORNERS, PARTICLES


def test_history(folder):
    history = swarf.read(folder).history
    assert list(history)[:3] == ["time", "immersion", "step"]
    assert history["force_y"].tolist() == [0, -2, -2.25] and history["time"].dtype == float
    assert history.units["torque"] == "N m" and history.units["step"] == "1"


def test_history_of_a_run_that_still_writes(folder):
    with open(folder / "history.csv", "a") as file:
        file.write("3e-06,0.2,30,1.2")
    assert len(swarf.read(folder).history["time"]) == 3


def test_history_without_samples(folder):
    (folder / "history.csv").write_text("time [s],force_x [N]\n")
    assert swarf.read(folder).history["force_x"].shape == (0,)


def test_filtered(folder):
    filtered = swarf.read(folder).filtered
    assert set(filtered) == {"time", "immersion", "force_x", "torque"}
    assert filtered["force_x"].tolist() == [0, 1.25, 1.5] and filtered.units["torque"] == "N m"


def test_frames(folder):
    first, last = swarf.read(folder).frames
    assert (first.immersion, last.time, last.immersion) == (0, 2.5e-6, None)
    for name, values in PARTICLES.items():
        assert numpy.array_equal(last.particles[name], values)
    assert first.hexes["connectivity"].shape == (1, 8) and numpy.array_equal(first.hexes["position"], CORNERS)
    assert first.tool["position"].shape == (2, 3, 3)
    assert last.hexes is None and last.tool is None


def test_deck_and_summary(folder):
    run = swarf.read(folder)
    assert run.is_complete and run.summary["steps"] == 20
    assert swarf.si(run.deck["body"][0]["spacing"]) == 5e-6


def test_run_that_has_not_ended(folder):
    (folder / "summary.json").unlink()
    assert not swarf.read(folder).is_complete


def test_windows(folder):
    (folder / "window_010").mkdir()
    (folder / "windows.json").write_text(json.dumps({"windows": {"window_010": {"immersion": 10}}}))
    (folder / "windows.csv").write_text("immersion [deg],force_planar [N]\n10,1.75\n")
    run = swarf.read(folder)
    assert run.windows["window_010"].folder == folder / "window_010"
    assert run.window_forces["force_planar"].tolist() == [1.75]


def test_no_such_folder(folder):
    with pytest.raises(FileNotFoundError, match="no such folder of results"):
        swarf.read(folder / "nowhere")
