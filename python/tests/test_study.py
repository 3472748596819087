"""Studies: what they run, that they go on, and what they say of a response that is known."""
import csv
import math
import pathlib
import sys

import h5py
import numpy
import pytest
from swarf import decks
from swarf.study import command, effects, plan, runs, table

FAKE = pathlib.Path(__file__).with_name("fake_swarf.py")
DECK = 'title = "known"\n\n[run]\na = 1.0\nb = 1.0\nlength = "10 um"\nword = "fixed"\nstart = "0 deg"\n'
A, B = '[[parameter]]\nkey = "run.a"\nrange = [0.0, 2.0]\nlevels = 3\n', '[[parameter]]\nkey = "run.b"\nrange = ' \
    '[1.0, 3.0]\nlevels = 3\n'


def write_program(path, before=""):
    """A program that is fake_swarf.py, by the Python that runs the tests."""
    path.write_text(f'#!/bin/sh\n{before}exec {sys.executable} {FAKE} "$@"\n')
    path.chmod(0o755)
    return path


@pytest.fixture
def studies(tmp_path, monkeypatch):
    (tmp_path / "deck.toml").write_text(DECK)
    monkeypatch.setenv("SWARF_PROGRAM", str(write_program(tmp_path / "swarf")))
    monkeypatch.chdir(tmp_path)

    def write(text, name="plan.toml"):
        (tmp_path / name).write_text('deck = "deck.toml"\n' + text)
        return tmp_path / name
    return write


def test_designs(studies):
    grid = plan.read(studies('design = "grid"\n' + A + B))
    assert len(grid.points) == 9 and {point["a"] for point in grid.points} == {0.0, 1.0, 2.0}
    one = plan.read(studies('design = "one_at_a_time"\n' + A + B))
    assert one.points[0] == {"a": 1.0, "b": 1.0} and len(one.points) == 5  # a: 0, 2; b: 2, 3
    sobol = plan.read(studies('design = "sobol"\nsamples = 16\n' + A + B))
    for parameter in sobol.parameters:  # a scrambled net in base 2: one point in each sixteenth
        shares = [(point[parameter.name] - parameter.low) / (parameter.high - parameter.low) for point in sobol.points]
        assert sorted(int(16 * share) for share in shares) == list(range(16))
    cube = plan.read(studies('design = "latin_hypercube"\nsamples = 7\n' + A + B))
    assert sorted(int(7 * point["a"] / 2) for point in cube.points) == list(range(7))


def test_values_have_units_and_may_be_words(studies):
    study = plan.read(studies('design = "grid"\n[[parameter]]\nkey = "run.length"\nvalues = ["0.005 mm", "0.02 mm"]\n'
                              '[[parameter]]\nkey = "run.word"\nvalues = ["fixed", "free"]\n'))
    length, word = study.parameters
    assert [length.number(value) for value in length.values] == pytest.approx([0.005, 0.02])
    assert length.number("10 um") == pytest.approx(0.01)  # the deck's own value
    assert word.unit is None and study.deck_of(study.tasks[-1])["run"]["word"] == "free"


@pytest.mark.parametrize("text, message", [
    ('design = "grid"\nsampels = 3\n' + A, 'sampels: is not a known key. Did you mean "samples"?'),
    ('design = "sobl"\n' + A, "design: expected one of one_at_a_time, grid"),
    ('design = "sobol"\n' + A, "samples: goes with latin_hypercube and sobol"),
    ('design = "sobol"\nsamples = 12\n' + A, "use 16"),
    ('design = "grid"\n[[parameter]]\nkey = "run.a"\n', "give either values"),
    ('design = "grid"\n[[parameter]]\nkey = "run.a"\nrange = ["1 um", "2 s"]\n', "give all values in one unit, not in s and um"),
    ('design = "grid"\n[[parameter]]\nkey = "run.a"\nrange = [2.0, 1.0]\n', "expected low < high"),
    ('design = "one_at_a_time"\n[[parameter]]\nkey = "run.none"\nvalues = [1.0]\n', "the deck has no such key"),
    ('design = "grid"\nresponse = "force"\n' + A, "response: expected one of force_planar"),
    ('design = "grid"\n' + A + '[repeats]\ncount = 2\n', "count > 1 needs key and step"),
    ('design = "grid"\n' + A + A, "two have the same name"),
])
def test_faults_say_what_to_do(studies, text, message):
    with pytest.raises(ValueError, match=message.replace("?", r"\?")):
        plan.read(studies(text))


def test_runs_tables_and_pictures(studies, capsys):
    path = studies('design = "grid"\ntitle = "plane"\n' + A + B)
    assert command.main([str(path), "--jobs", "3"]) == 0
    assert "9 of 9" in capsys.readouterr().out
    folder = path.parent / "results" / "plan"
    with open(folder / "study.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    for row in rows:
        known = 3 + 2 * float(row["a [1]"]) - float(row["b [1]"])**2
        assert float(row["force_planar [N]"]) == pytest.approx(abs(known), rel=0.01, abs=1e-3)
    with h5py.File(folder / "study.h5") as file:
        assert file["study/force_planar"].attrs["units"] == b"N" and len(file["study/a"]) == 9
        assert "plane" in file.attrs["study"]
    for name in ("main_effects.png", "tornado.png", "surface.png"):
        assert (folder / name).stat().st_size > 5000


def test_goes_on_and_takes_up_what_has_changed(studies):
    path = studies('design = "grid"\n' + A)
    folder = path.parent / "results" / "plan"
    assert command.main([str(path)]) == 0
    assert command.main([str(path)]) == 0
    calls = [(folder / "runs" / f"run_{k:04d}" / "calls").read_text().count("\n") for k in range(3)]
    assert calls == [1, 1, 1]  # the second call ran nothing
    path.write_text(path.read_text().replace("2.0]", "4.0]"))
    assert command.main([str(path)]) == 0
    assert decks.read(folder / "decks" / "run_0002.toml")["run"]["a"] == 4.0
    assert "--overwrite" in (folder / "runs" / "run_0002" / "calls").read_text()
    calls = [(folder / "runs" / f"run_{k:04d}" / "calls").read_text().count("\n") for k in range(3)]
    assert calls == [1, 1, 1]  # a = 0 stayed; the two others are new


def test_a_killed_run_goes_on_from_its_checkpoint(studies, monkeypatch):
    monkeypatch.setenv("KILL_AT", "run_0001")
    path = studies('design = "grid"\n' + A)
    assert command.main([str(path), "--jobs", "2"]) == 0
    calls = (path.parent / "results" / "plan" / "runs" / "run_0001" / "calls").read_text().splitlines()
    assert len(calls) == 2 and calls[0].endswith("--overwrite") and calls[1].endswith("--resume")


def test_a_run_that_fails_is_left_out_and_said(studies, capsys):
    path = studies('design = "grid"\n' + A + '[[parameter]]\nkey = "run.fails"\nvalues = [false, true]\n')
    assert command.main([str(path)]) == 3
    assert "3 of 6 runs are not complete" in capsys.readouterr().out


def test_repeats_give_the_error(studies):
    path = studies('design = "grid"\n[[parameter]]\nkey = "run.a"\nvalues = [1.0]\n[repeats]\ncount = 3\n'
                   'key = "run.offset"\nstep = 0.3\n[base]\n"run.offset" = 0.0\n"run.b" = 0.0\n')
    assert command.main([str(path)]) == 0
    study = plan.read(path)
    point = table.join_repeats(study, table.measure(study, runs.Folder(path.parent / "results" / "plan")))[0]
    value, error = point["force_planar"]
    assert value == pytest.approx(5.3, rel=0.01)  # of 5, 5.3, 5.6
    assert error == pytest.approx(0.3 / math.sqrt(3), rel=0.05)


def known_points(study, noise=0.0):
    random = numpy.random.default_rng(1)
    return [{"point": k, "repeats": 1, "force_planar": (3 + 2 * point["a"] - point["b"]**2 + noise * random.normal(), 0.1)}
            for k, point in enumerate(study.points)]


def test_tornado_of_a_known_response(studies):
    study = plan.read(studies('design = "one_at_a_time"\n' + A + B))
    bars, base = effects.tornado(study, known_points(study), None)
    assert base == 4 and [bar.parameter.name for bar in bars] == ["b", "a"]
    assert (bars[0].low, bars[0].high, bars[1].low, bars[1].high) == (4, -4, 2, 6)


@pytest.mark.parametrize("surface", ["quadratic", "gaussian_process"])
def test_surface_finds_a_known_response(studies, surface):
    if surface == "gaussian_process":
        pytest.importorskip("sklearn")
    study = plan.read(studies(f'design = "sobol"\nsamples = 16\nsurface = "{surface}"\n' + A + B))
    fitted, why_not = effects.fit_surface(study, known_points(study))
    assert not why_not
    value, error = fitted.predict(numpy.array([[0.5, 0.5]]))  # a = 1, b = 2
    assert value[0] == pytest.approx(1, abs=1e-6 if surface == "quadratic" else 0.1)
    assert fitted.error < (1e-6 if surface == "quadratic" else 0.5)  # of a response that spans 12 N
    bars, _ = effects.tornado(study, known_points(study), fitted)
    assert [bar.parameter.name for bar in bars] == ["b", "a"]
    assert bars[1].high - bars[1].low == pytest.approx(4, abs=1e-6 if surface == "quadratic" else 0.4)


def test_no_surface_says_why(studies):
    study = plan.read(studies('design = "grid"\n' + A + B.replace("3\n", "2\n")))
    assert "three levels" in effects.fit_surface(study, known_points(study))[1] or \
        "points" in effects.fit_surface(study, known_points(study))[1]


def test_another_folder_is_left_alone(studies):
    path = studies('design = "grid"\n' + A)
    (path.parent / "mine").mkdir()
    (path.parent / "mine" / "thesis.txt").write_text("mine")
    with pytest.raises(ValueError, match="is not the folder of a study"):
        command.main([str(path), "--output", str(path.parent / "mine")])
