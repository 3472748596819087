"""swarf import: what a deck makes of an Abaqus model. Formats as the keywords' reference has them; the models are ours."""
import math

import pytest
import swarf
from swarf.__main__ import main
from swarf.abaqus import convert, reader, scales

CUBE = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
SIDES = ["1, 4, 3, 2", "5, 6, 7, 8", "1, 2, 6, 5", "2, 3, 7, 6", "3, 4, 8, 7", "4, 1, 5, 8"]
NODES = "".join(f"{k}, {x}., {y}., {z}.\n" for k, (x, y, z) in enumerate(CUBE, 1))
DOTS = [(x, y, z) for x in (0.25, 0.75) for y in (1.25, 1.75) for z in (0.25, 0.75)]


def part(name, elements, more=""):
    return f"*Part, name={name}\n*Node\n{NODES}{elements}{more}*End Part\n"


WORK = part("Work", "*Element, type=C3D8R, elset=All\n1, 1, 2, 3, 4, 5, 6, 7, 8\n",
            "*Nset, nset=Everything, generate\n1, 8, 1\n*Nset, nset=Base\n1, 2, 5, 6\n"
            "*Solid Section, elset=All, material=Steel-42\n,\n")
ZONE = ("*Part, name=Zone\n*Node\n" + "".join(f"{k}, {x}, {y}, {z}\n" for k, (x, y, z) in enumerate(DOTS, 1))
        + "*Element, type=PC3D, elset=Dots\n" + "".join(f"{k}, {k}\n" for k in range(1, 9))
        + "*Nset, nset=All, generate\n1, 8\n*Solid Section, elset=Dots, material=STEEL-42\n0.25\n*End Part\n")
TOOL = part("Tool", "*Element, type=R3D4, elset=Skin\n" + "".join(f"{k}, {one}\n" for k, one in enumerate(SIDES, 1)),
            "*Node\n99, 0.5, 0.5, 0.5\n*Nset, nset=RP\n99,\n*Rigid Body, ref node=RP, elset=Skin\n")
ASSEMBLY = """*Assembly, name=A
*Instance, name=Work-1, part=Work
*End Instance
*Instance, name=Zone-1, part=Zone
*End Instance
*Instance, name=Tool-1, part=Tool
-2., 1., 0.
*End Instance
*Elset, elset=Upper, instance=Work-1
1,
*Surface, type=ELEMENT, name=Top
Upper, S5
*Surface, type=NODE, name=Below
Zone-1.All,
*Tie, name=Joint
Below, Top
*End Assembly
"""
MATERIAL = """*Material, name=Steel-42
*Density
7.8e-9
*Elastic
210000., 0.3
*Plastic, hardening=JOHNSON COOK
500., 300., 0.3, 1.1, 1500., 20.
*Rate Dependent, type=JOHNSON COOK
0.02, 1000.
*Specific Heat
4.6e8
*Conductivity
40., 20.
30., 700.
*Damage Initiation, criterion=JOHNSON COOK
0.05, 3.4, 2.1, 0.002, 0.6, 1500., 20., 1000.
"""
CONDITIONS = """*Initial Conditions, type=TEMPERATURE
Work-1.Everything, 20.
Zone-1.All, 25.
*Initial Conditions, type=VELOCITY
Zone-1.All, 2, -300.
*Surface Interaction, name=Int
*Friction
0.25,
*Step, name=Cut
*Dynamic, Explicit
, 2e-5
*Boundary
Work-1.Base, ENCASTRE
*Boundary, type=VELOCITY
Tool-1.RP, 1, 1, 1500.
Tool-1.RP, 2, 6
*Output, field
*End Step
"""
MODEL = "*Heading\n" + WORK + ZONE + TOOL + ASSEMBLY + MATERIAL + CONDITIONS


def imported(tmp_path, text, units="mm-tonne-s", temperature="degC"):
    file = tmp_path / "model.inp"
    file.write_text(text)
    converter = convert.Converter(reader.read(file), scales.parse(units, temperature), "model")
    return converter.convert(), converter


def edited(*pairs):
    text = MODEL
    for old, new in pairs:
        assert old in text
        text = text.replace(old, new, 1)
    return text


def rows(text):
    return [[float(one) for one in line.split(",")[:4]] for line in text.splitlines() if line[0].isdigit() or line[0] == "-"]


def test_deck(tmp_path):
    deck, converter = imported(tmp_path, MODEL)
    work, zone = deck["body"]
    assert work["fill"] == "hexes" and zone["fill"] == "particles" and zone["tie"] == work["name"] == "Work-1"
    assert work["faces"] == {"Base": "fixed"} and work["file_scale"] == "1 mm"
    assert (work["temperature"], zone["temperature"]) == ("20 degC", "25 degC")
    assert [swarf.si(one) for one in zone["velocity"]] == [0, pytest.approx(-0.3), 0]
    assert [swarf.si(one) for one in deck["tool"]["velocity"]] == [pytest.approx(1.5), 0, 0]
    assert deck["contact"] == {"friction": 0.25} and swarf.si(deck["run"]["end_time"]) == 2e-5
    assert [(line, keyword.name) for line, keyword, _ in converter.left_out()] == [
        (MODEL[:MODEL.index("*Output")].count("\n") + 1, "OUTPUT")]


def test_material(tmp_path):
    deck, _ = imported(tmp_path, MODEL)
    steel = deck["material"]["Steel-42"]
    wanted = {"density": 7800, "youngs_modulus": 210e9, "A": 500e6, "B": 300e6, "reference_rate": 1000,
              "specific_heat": 460, "melt_temperature": 1773.15, "reference_temperature": 293.15}
    assert {key: swarf.si(steel[key]) for key in wanted} == pytest.approx(wanted)
    assert (steel["n"], steel["m"], steel["C"], steel["poissons_ratio"]) == (0.3, 1.1, 0.02, 0.3)
    assert [swarf.si(one) for row in steel["conductivity"] for one in row] == pytest.approx([293.15, 40, 973.15, 30])
    # sigma* of 1985 is positive in tension, the file's triaxiality enters as exp(-d3 eta).
    assert steel["damage"] == [0.05, 3.4, -2.1, 0.002, 0.6]
    assert steel["taylor_quinney"] == 0, "no heat without *Inelastic Heat Fraction, but in an adiabatic step"
    deck, _ = imported(tmp_path, edited(("*Dynamic, Explicit", "*Dynamic, Explicit, adiabatic")))
    assert deck["material"]["Steel-42"]["taylor_quinney"] == 0.9
    deck, _ = imported(tmp_path, edited(("*Specific Heat", "*Inelastic Heat Fraction\n0.8,\n*Specific Heat")))
    assert deck["material"]["Steel-42"]["taylor_quinney"] == 0.8


@pytest.mark.parametrize("units, density, pressure, speed", [
    ("m-kg-s", 1, 1, 1), ("mm-tonne-s", 1e12, 1e6, 1e-3), ("mm-kg-ms", 1e9, 1e9, 1), ("um-kg-s", 1e18, 1e6, 1e-6)])
def test_units(units, density, pressure, speed):
    scale = scales.parse(units)
    assert swarf.si(scale.a_density(2)) == pytest.approx(2 * density)
    assert swarf.si(scale.a_pressure(2)) == pytest.approx(2 * pressure)
    assert swarf.si(scale.a_velocity(2)) == pytest.approx(2 * speed)
    # A conductivity over a density and a heat is a length squared over a time, in any units.
    assert (swarf.si(scale.a_conductivity(3)) / swarf.si(scale.a_density(2)) / swarf.si(scale.a_specific_heat(5))
            == pytest.approx(0.3 * scale.length**2 / scale.time))


def test_instances_are_moved_and_then_turned(tmp_path):
    """Translation by (1, 0, 0), then 90 degrees about z through (1, 1): (x, y) goes to (2 - y, 1 + x - 0)."""
    turned = edited(("part=Work\n", "part=Work\n1., 0., 0.\n1., 1., 0., 1., 1., 2., 90.\n"))
    _, converter = imported(tmp_path, turned)
    for number, x, y, z in rows(converter.files["model_Work-1.inp"])[:8]:
        a, b, c = CUBE[int(number) - 1]
        assert (x, y, z) == pytest.approx((2 - b, 1 + a, c))
    assert rows(converter.files["model_Zone-1.csv"])[0] == [0.25, 1.25, 0.25, 0.125]


def test_tool_is_a_closed_surface_turned_outwards(tmp_path):
    for text in (MODEL, edited(*[(one, ", ".join(reversed(one.split(", ")))) for one in SIDES])):
        _, converter = imported(tmp_path, text)
        x = [[float(one) for one in line.split()[1:]] for line in converter.files["model_Tool-1.stl"].splitlines()
             if line.startswith("vertex")]
        volume = sum(a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
                     for (a, b, c), (d, e, f), (g, h, i) in zip(x[::3], x[1::3], x[2::3])) / 6
        assert len(x) == 36 and volume == pytest.approx(1)
        assert min(one[0] for one in x) == -2 and max(one[1] for one in x) == 2


def test_a_rigid_body_of_solids_is_its_outer_sides(tmp_path):
    """Two hexes above each other, and the tetrahedra of a cube; a set of the assembly, its reference point, too."""
    upper = "".join(f"{k + 8}, {x}., {y}., {z + 1}.\n" for k, (x, y, z) in enumerate(CUBE, 1) if z == 1)
    hexes = f"{upper}*Element, type=C3D8R\n1, 1, 2, 3, 4, 5, 6, 7, 8\n2, 5, 6, 7, 8, 13, 14, 15, 16\n"
    tets = "*Element, type=C3D4\n1, 1, 2, 4, 5\n2, 3, 4, 2, 7\n3, 6, 5, 7, 2\n4, 8, 7, 5, 4\n5, 2, 4, 5, 7\n"
    rigid = ("*Node\n7, 0., 0., 0.\n*Nset, nset=Point\n7,\n*Elset, elset=Whole, instance=Tool-1, generate\n1, {}, 1\n"
             "*Rigid Body, ref node=Point, elset=Whole\n*End Assembly")
    for mesh, count, volume, facets in ((hexes, 2, 2, 20), (tets, 5, 1, 12)):
        text = edited((TOOL, part("Tool", mesh)), ("*End Assembly", rigid.format(count)), ("Tool-1.RP, 1", "Point, 1"),
                      ("Tool-1.RP, 2", "Point, 2"))
        deck, converter = imported(tmp_path, text)
        x = [[float(one) for one in line.split()[1:]] for line in converter.files["model_Tool-1.stl"].splitlines()
             if line.startswith("vertex")]
        found = sum(a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
                    for (a, b, c), (d, e, f), (g, h, i) in zip(x[::3], x[1::3], x[2::3])) / 6
        assert found == pytest.approx(volume) and len(x) == 3 * facets
        assert len(deck["body"]) == 2 and swarf.si(deck["tool"]["velocity"][0]) == pytest.approx(1.5)
    with pytest.raises(ValueError, match="C3D4 are not read, but in a rigid body"):
        imported(tmp_path, edited((TOOL, part("Tool", tets))))


def test_an_independent_instance_has_its_mesh_within(tmp_path):
    inside = WORK.removeprefix("*Part, name=Work\n").removesuffix("*End Part\n")
    text = edited((WORK, "*Part, name=Work\n*End Part\n"), ("part=Work\n", "part=Work\n0., 0., 5.\n" + inside))
    deck, converter = imported(tmp_path, text)
    assert deck["body"][0]["faces"] == {"Base": "fixed"} and deck["body"][1]["tie"] == "Work-1"
    assert min(row[3] for row in rows(converter.files["model_Work-1.inp"])[:8]) == 5


def test_left_out_says_line_and_why(tmp_path):
    text = edited(("Work-1.Base, ENCASTRE", "Work-1.Base, XSYMM\nWork-1.Base, 1, 2"),
                  ("*Output, field", "*Boundary, amplitude=Ramp\nWork-1.Base, 1, 1, 3.\n*Output, field"),
                  ("Zone-1.All, 2, -300.", "Work-1.Base, 2, -300."),
                  ("Below, Top", "Top, Top"))
    deck, converter = imported(tmp_path, text)
    found = {text.splitlines()[line - 1]: why for line, _, why in converter.left_out()}
    assert "held in all directions" in found["Work-1.Base, XSYMM"]
    assert "is free in 3" in found["Work-1.Base, 1, 2"]
    assert "without an amplitude" in found["*Boundary, amplitude=Ramp"]
    assert "all nodes of a body" in found["Work-1.Base, 2, -300."]
    assert "only particles are tied, to hexes" in found["Top, Top"]
    assert "faces" not in deck["body"][0] and "tie" not in deck["body"][1] and "velocity" not in deck["body"][1]


def test_what_a_deck_needs_is_said(tmp_path):
    deck, converter = imported(tmp_path, edited(("*Specific Heat\n4.6e8\n", ""), ("*Friction\n0.25,\n", ""),
                                                ("Tool-1.RP, 2, 6", "Tool-1.RP, 6, 6, 100.")))
    said = "\n".join(converter.notes)
    for words in ("[material.Steel-42] needs specific_heat", "[contact] needs friction", "does not drive the tool in 2, 3",
                  "the tool turns in the file"):
        assert words in said
    assert "specific_heat" not in deck["material"]["Steel-42"] and deck["contact"] == {}


def test_a_file_without_parts(tmp_path):
    text = ("*NODE, NSET=ALL\n" + NODES + "*ELEMENT, TYPE=C3D8, ELSET=E\n7, 1, 2, 3, 4,\n5, 6, 7, 8\n"
            "*SOLID SECTION, ELSET=E, MATERIAL=M\n*MATERIAL, NAME=M\n*DENSITY\n7800.\n*ELASTIC\n2.1D11, 0.3\n"
            "*PLASTIC\n4.E8, 0.\n*BOUNDARY, TYPE=VELOCITY\nALL, 1, 3, 2.\n*STEP\n*DYNAMIC, EXPLICIT\n, 1E-6\n*END STEP\n")
    deck, converter = imported(tmp_path, text, "m-kg-s", None)
    assert deck["material"]["M"] == {"law": "linear_hardening", "density": "7800 kg/m3", "poissons_ratio": 0.3,
                                     "youngs_modulus": "210000000000 Pa", "yield_stress": "400000000 Pa",
                                     "hardening_modulus": "0 Pa", "taylor_quinney": 0.0}
    assert deck["body"][0]["faces"] == {"ALL": {"velocity": ["2 m/s"] * 3}} and "tool" not in deck
    assert "*NSET, NSET=ALL\n1, 2, 3, 4, 5, 6, 7, 8\n" in converter.files["model_MODEL.inp"]


@pytest.mark.parametrize("pairs, words", [
    ([("type=C3D8R", "type=C3D10M")], ":13: *ELEMENT: element 1 has 8 nodes: expected 10"),
    ([("type=C3D8R", "type=C3D20R")], ":12: *ELEMENT: elements of type C3D20R are not read"),
    ([("hardening=JOHNSON COOK", "hardening=KINEMATIC")], "*PLASTIC: of material Steel-42 is not read"),
    ([("material=Steel-42", "material=Brass")], "there is no *MATERIAL, NAME=BRASS"),
    ([("*Heading", "*Include, input=other.inp")], ":1: *INCLUDE: is not followed"),
    ([("part=Zone", "part=Zone\n*End Instance\n*Instance, name=Tool-2, part=Tool")], "are rigid: expected one, the tool"),
    ([("material=STEEL-42\n0.25", "material=STEEL-42\n,")], "has no characteristic length"),
    ([("7.8e-9", "heavy")], '*DENSITY: expected a number, got "heavy"'),
    ([("1, 1, 2, 3, 4, 5, 6, 7, 8", "1, 1, 2, 3, 4, 5, 6, 7, 80")], "there is no node 80 before it"),
    ([("*Node", "*Node, system=C")], ":3: *NODE: SYSTEM is not followed"),
    ([("*Material, name=Steel-42", "*Material")], "*MATERIAL: expected NAME="),
    ([("7.8e-9", "nan")], '*DENSITY: expected a number, got "nan"'),
    ([(", 2e-5", ", 2e-5\n*Fixed Mass Scaling, factor=many")], '*FIXED MASS SCALING: expected a number, got "many"'),
    ([("Tool-1.RP, 2, 6", "Tool-1.RP, 2, x")], ':116: *BOUNDARY: expected a direction, 1 to 6, got "x"'),
])
def test_faults(tmp_path, pairs, words):
    with pytest.raises(ValueError) as fault:
        imported(tmp_path, edited(*pairs))
    assert words in str(fault.value)


def test_a_later_step_changes_nothing(tmp_path):
    later = "*Step\n*Boundary, type=VELOCITY\nWork-1.Base, 1, 3, 9.\n*Friction\n0.9,\n*End Step\n"
    deck, converter = imported(tmp_path, MODEL + later)
    assert deck == imported(tmp_path, MODEL)[0]
    assert {"STEP", "BOUNDARY", "FRICTION"} <= {keyword.name for _, keyword, _ in converter.left_out()}


def test_what_friction_is_not_of_coulomb(tmp_path):
    deck, _ = imported(tmp_path, edited(("*Friction", "*Friction, taumax=300.")))
    assert deck["contact"] == {"friction": 0.25, "shear_limit": "300000000 Pa"}
    deck, converter = imported(tmp_path, edited(("*Friction\n0.25,", "*Friction, rough")))
    assert "friction" not in deck["contact"]
    assert any("ROUGH" in why for _, _, why in converter.left_out())


def test_mass_scaling_of_some_elements_is_left_out(tmp_path):
    deck, converter = imported(tmp_path, edited((", 2e-5", ", 2e-5\n*Fixed Mass Scaling, factor=100, elset=All")))
    assert "mass_factor" not in deck["run"]
    assert any("no ELSET" in why for _, _, why in converter.left_out())


def test_units_and_temperature_must_be_said(tmp_path):
    with pytest.raises(ValueError, match="give --temperature K or --temperature degC"):
        imported(tmp_path, MODEL, temperature=None)
    deck, _ = imported(tmp_path, edited(("*Heading", "*Heading\n*Physical Constants, absolute zero=-273.15")),
                       temperature=None)
    assert deck["body"][0]["temperature"] == "20 degC"
    for word in ("SI", "mm-t-s", "mm-tonne-s-K"):
        with pytest.raises(ValueError, match="expected length-mass-time"):
            scales.parse(word)


def test_command_writes_no_file_that_is_there(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "model.inp").write_text(MODEL)
    words = ["import", "model.inp", "--units", "mm-tonne-s", "--temperature", "degC"]
    assert main(words) == 0
    assert swarf.read_deck("model.toml")["tool"]["file"] == "model_Tool-1.stl"
    assert "*OUTPUT, FIELD" in capsys.readouterr().out
    (tmp_path / "model_Zone-1.csv").write_text("mine")
    assert main(words) == 1 and "is there already" in capsys.readouterr().err
    assert (tmp_path / "model_Zone-1.csv").read_text() == "mine"
    assert main([*words, "--overwrite"]) == 0 and math.isclose(rows((tmp_path / "model_Zone-1.csv").read_text())[0][3], 0.125)
