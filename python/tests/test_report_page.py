"""The page of a run: that it is whole in itself, and, where there is a Chromium, that it shows what it should, on a wide
and on a narrow window."""
import io
import json
import re

import matplotlib.image
import numpy
import pytest
from swarf import results
from swarf.report import command, frames, page

import browser
import conftest

COLUMNS = {"time": "s", "immersion": "deg", "force_x": "N", "force_y": "N", "force_z": "N", "force_planar": "N",
           "torque": "N m", "external_work": "J", "plastic_work": "J", "friction_work": "J", "elastic_energy": "J",
           "kinetic_energy": "J", "energy_residual": "J", "plastic_heat": "J", "work_heat": "J", "tool_heat": "J",
           "max_temperature": "K", "tool_max_temperature": "K"}
DECK = """# Written by swarf: the deck with every default, in SI units.
title = "a slice <of> 10 um"

[material.ti64]
A = "862000000 Pa"

[[body]]
name = "work"
fill = "particles"
inner_radius = "0.0004 m"

[tool]
kind = "end_mill"
spindle_speed = "1047.1975511965977 rad/s"
helix = "0.4398229715025711 rad"

[run]
courant = 0.8

[output]
picture_view = [0.0, 0.0, 1.0]
[[output.published]]
label = "measured"
force = "10.5 N"
"""


def write_run(folder, force=3.0, count=401):
    """A run in miniature: a block of particles beside one of hexes, and a tool that turns by ten degrees a frame."""
    (folder / "frames").mkdir(parents=True)
    (folder / "deck.toml").write_text(DECK)
    time = numpy.linspace(0, 2e-4, count)
    values = {name: 0 * time for name in COLUMNS}
    values |= {"time": time, "immersion": 70 + 6e4 * time, "force_x": -0.6 * force * time / 2e-4,
               "force_y": 0.8 * force * time / 2e-4, "external_work": 1e-4 * time, "plastic_work": 0.8e-4 * time,
               "plastic_heat": 0.7e-4 * time, "work_heat": 0.5e-4 * time, "max_temperature": 300 + 1e6 * time,
               "tool_max_temperature": 300 + 5e5 * time}
    values["force_planar"] = numpy.hypot(values["force_x"], values["force_y"])
    rows = zip(*(values[name] for name in COLUMNS))
    (folder / "history.csv").write_text(",".join(f"{name} [{unit}]" for name, unit in COLUMNS.items()) + "\n"
                                        + "".join(",".join(f"{v:.9g}" for v in row) + "\n" for row in rows))
    filtered = ("force_x", "force_y", "force_z", "force_planar", "torque")
    conftest.write_hdf5(folder / "results.h5", {
        **{name: (unit, values[name]) for name, unit in COLUMNS.items()},
        **{f"{name}_filtered": (COLUMNS[name], values[name]) for name in filtered}})
    (folder / "summary.json").write_text(json.dumps({
        "ended": "complete", "why": "", "warnings": "", "version": "0.2.0", "commit": "abc1234", "particles": 240, "hexes": 2,
        "steps": 9, "cost": {"cpu_seconds": 2.5, "wall_seconds": 3.0, "threads": 1}}))
    step = 2.5e-6
    at = step * numpy.stack(numpy.meshgrid(*map(numpy.arange, (10, 8, 3)), indexing="ij"), -1).reshape(-1, 3)
    corners = conftest.CORNERS
    nodes = numpy.concatenate([corners, corners + [0, 0, 1]])[[0, 1, 2, 3, 4, 5, 6, 7, 12, 13, 14, 15]]
    block = numpy.array([[0, 1, 2, 3, 4, 5, 6, 7], [4, 5, 6, 7, 8, 9, 10, 11]])
    listed = "frame,time [s],immersion [deg],parts,checksums\n"
    for k in range(3):
        c, s = numpy.cos(k * numpy.pi / 18), numpy.sin(k * numpy.pi / 18)
        turn = numpy.array([[c, s, 0], [-s, c, 0], [0, 0, 1]])
        triangles = 2e-5 * numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [0, 1, 1]], float)
        def part(which):
            return folder / "frames" / f"frame_{k:04d}_{which}"
        conftest.write_vtk(part("particles.vtu"), "UnstructuredGrid", {
            "position": at.astype("f4"), "temperature": (300 + 1e7 * at[:, 0]).astype("f4"),
            "velocity": numpy.ones((len(at), 3), "f4"), "volume": numpy.full(len(at), step**3, "f4"),
            "identity": numpy.arange(len(at), dtype="i4")})
        conftest.write_vtk(part("hexes.vtu"), "UnstructuredGrid", {
            "position": (2e-5 * (nodes - [1.2, 0, 0])).astype("f4"), "temperature": numpy.array([310, 320], "f4"),
            "velocity": numpy.zeros((12, 3), "f4"), "active": numpy.array([1, 1], "i4"),
            "connectivity": block.ravel().astype("i4")})
        conftest.write_vtk(part("tool.vtp"), "PolyData", {
            "position": (triangles @ turn.T + [3e-5, 1e-6 * k, 0]).astype("f4")})
        listed += f"{k},{1e-4 * k},{70 + 6 * k},hexes particles tool,\n"
    (folder / "frames.csv").write_text(listed)
    return folder


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    return write_run(tmp_path_factory.mktemp("runs") / "slice")


def test_page_is_whole_in_itself(run, capsys):
    assert command.main([str(run)]) == 0
    text = (run / "report.html").read_text()
    assert not re.search(r'(src|href)="(?!data:|#)', text) and "@import" not in text
    assert "a slice &lt;of&gt; 10 um" in text and "a slice <of>" not in text
    for said in ("10000 rpm", "25.2 deg", "862 MPa", "400 um", "measured", "-71.4 %", "abc1234", "0.2.0"):
        assert said in text, said
    assert len(text) < 15e6


def test_hexes_show_their_outside_only(run):
    frame = results.read(run).frames[0]
    owner, quads = frames.outer_faces(frame.hexes["connectivity"], frame.hexes["active"])
    assert len(quads) == 10  # two cubes that share a side
    assert len(frames.outer_faces(frame.hexes["connectivity"], numpy.array([1, 0]))[1]) == 6  # one is deleted


def test_tool_motion_is_found(run):
    base, _, last = (frame.tool["position"].reshape(-1, 3) * 1e6 for frame in results.read(run).frames)
    matrix = numpy.array(frames.turn_of(base, last)).reshape(4, 4).T
    assert numpy.allclose(base @ matrix[:3, :3].T + matrix[:3, 3], last, atol=1e-4)


def test_a_large_scene_is_thinned_out_and_says_so(run):
    scene, text = frames.pack_scene(results.read(run), "x", budget=6000)
    assert len(text) < 1.5 * 6000 and "one particle in" in scene["note"]
    whole, _ = frames.pack_scene(results.read(run), "x", budget=1e6)
    assert whole["note"] == "3 frames, all particles" and whole["frames"][0]["particles"]["points"]["count"] == 240


def test_no_results_is_an_error(tmp_path):
    with pytest.raises(ValueError, match="holds no results"):
        page.make([tmp_path])


def test_several_runs_are_compared(run, tmp_path):
    other = write_run(tmp_path / "other", 4.0)
    (other / "deck.toml").write_text(DECK.replace("courant = 0.8", "courant = 0.5"))
    text = page.make([run, other])
    assert "Planar resultant of all runs" in text and "run.courant" in text and ">0.5<" in text


def colours_of(png):
    pixels = matplotlib.image.imread(io.BytesIO(png))[..., :3]
    return pixels, len(numpy.unique((pixels * 255).astype(int).reshape(-1, 3), axis=0))


@pytest.mark.parametrize("width, height", [(1280, 900), (390, 844)])
def test_browser_shows_it(run, tmp_path, width, height):
    if not browser.find():
        pytest.skip("no Chromium here (Debian: chromium)")
    target = tmp_path / "report.html"
    target.write_text(page.make([run]))
    shown = browser.Browser(tmp_path / "profile")
    try:
        shown.open(target.as_uri(), width, height)
        shown.wait_for("[...document.querySelectorAll('.scene')].every((one) => one.dataset.ready)")
        shown.evaluate("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
        assert shown.complaints() == []
        assert shown.evaluate("document.documentElement.scrollWidth") <= width  # nothing sticks out sideways
        for chart in shown.evaluate("[...document.querySelectorAll('.chart')].map((one) => one.id)"):
            pixels, _ = colours_of(shown.picture(f"#{chart} canvas"))
            coloured = (pixels.max(2) - pixels.min(2) > 0.2) | (pixels.max(2) < 0.3)
            assert coloured.sum() > 150, f"{chart} is blank"
        pixels, different = colours_of(shown.picture("#run0-scene canvas"))
        covered = (pixels.min(2) < 0.97).mean()
        assert 0.03 < covered < 0.97 and different > 50, (covered, different)

        shown.evaluate("document.querySelector('#run0-scene canvas').focus()")
        for _ in range(4):
            shown.call("Input.dispatchKeyEvent", type="keyDown", key="ArrowRight", code="ArrowRight")
        shown.evaluate("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
        turned, _ = colours_of(shown.picture("#run0-scene canvas"))
        assert (numpy.abs(turned - pixels).max(2) > 0.1).mean() > 0.01  # the view has turned

        names = shown.names("image") + shown.names("img")
        assert any(name.startswith("Force on the tool") for name in names)
        assert any(name.startswith("Three-dimensional view") for name in names)
        buttons, sliders = shown.names("button"), shown.names("slider")
        assert all(names) and all(buttons) and sliders and all(sliders)
        assert "Data of Force on the tool as csv" in buttons
        text = shown.evaluate("""new Promise((done) => {
            URL.createObjectURL = (blob) => { blob.text().then(done); return "#"; };
            document.querySelector('button[data-chart="run0-force"]').click(); })""")
        head, first, *_, last = text.strip().split("\n")
        assert head.startswith('"Immersion angle [deg]","unfiltered resultant","F_x"')
        assert len(text.strip().split("\n")) == 402 and last.split(",")[1] == "3"
    finally:
        shown.close()
