import pytest
import swarf
from conftest import ROOT
from swarf import decks

INPUTS = sorted((ROOT / "inputs").glob("*.toml"))


@pytest.fixture
def deck():
    return swarf.read_deck(ROOT / "inputs/orthogonal_cutting.toml")


@pytest.mark.parametrize("path", INPUTS, ids=lambda path: path.name)
def test_round_trip(path, tmp_path):
    deck = swarf.read_deck(path)
    swarf.write_deck(tmp_path / "deck.toml", deck)
    assert swarf.read_deck(tmp_path / "deck.toml") == deck


def test_vary(deck):
    varied = swarf.vary(deck, {"run.courant": 0.25, "body[cut zone].spacing": "4 um", "material.ti64.A": "900 MPa",
                               "sleep.distance": "60 um", "contact.friction": None, "body[bulk]": None})
    assert varied["run"]["courant"] == 0.25 and varied["sleep"] == {"distance": "60 um"}
    assert decks.body(varied, "cut zone")["spacing"] == "4 um" and decks.body(varied, "bulk") is None
    assert varied["material"]["ti64"]["A"] == "900 MPa" and "friction" not in varied["contact"]
    assert "friction" in deck["contact"] and decks.body(deck, "bulk")


def test_vary_adds_a_body_and_changes_one_of_a_list(deck):
    work = dict(decks.body(deck, "bulk"), name="work")
    varied = swarf.vary(deck, {"body[work]": work, "output.published[0].force": "1 N"})
    assert decks.body(varied, "work") == work and len(varied["body"]) == 3
    assert varied["output"]["published"][0]["force"] == "1 N"


@pytest.mark.parametrize("changes", [
    {"run.courant": 0.25}, {"tool.position": ["0 um", "1 um", "2 um"], "contact.friction": None},
    {"sleep.distance": "60 um"}, {"body[bulk]": None, "body[cut zone].faces.y_min": "fixed"}])
def test_changes_are_what_vary_was_asked(deck, changes):
    assert decks.changes(swarf.vary(deck, changes), deck) == changes


def test_description(deck):
    work = dict(decks.body(deck, "bulk"), name="work", cells=[4, 4, 4], convert_distance="10 um")
    assert decks.describe({"body[bulk]": None, "body[work]": work, "run.courant": 0.5}) == (
        'no body[bulk]; body[work] of 64 hexes, convert_distance = "10 um"; run.courant = 0.5')


def test_end_time(deck):
    assert decks.end_time(deck) == swarf.si(deck["run"]["end_time"])
    mill = swarf.read_deck(ROOT / "inputs/micro_milling.toml")
    assert decks.end_time(mill) == pytest.approx((187 + 2) / 360 * 60 / 10000)
