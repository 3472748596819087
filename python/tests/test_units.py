import math

import pytest
import swarf


@pytest.mark.parametrize("text, value", [
    ("10 um", 1e-5), ("25.2 deg", math.radians(25.2)), ("10000 rpm", 10000 * 2 * math.pi / 60), ("25 degC", 298.15),
    ("30 m/min", 0.5), ("110 GPa", 110e9), ("1 1/s", 1), ("526.3 J/kg/K", 526.3), ("4430 kg/m3", 4430), ("2 N/mm2", 2e6),
    ("9.81 m/s^2", 9.81), ("1e6 W/m2/K", 1e6), ("0.1 us", 1e-7), ("-2.5 µm", -2.5e-6), ("5 %", 0.05), ("1 rev", 2 * math.pi)])
def test_si(text, value):
    assert swarf.si(text) == pytest.approx(value, rel=1e-15)


def test_si_is_rounded_once():
    assert swarf.si("10 um") == 1e-5 and swarf.si("436.3 um") == 436.3e-6 and swarf.si("1e-05 m") == 1e-5


@pytest.mark.parametrize("text", ["10 furlong", "10 m/", "10 1", "10 kdeg"])
def test_no_such_unit(text):
    with pytest.raises(ValueError, match="there is no unit"):
        swarf.si(text)


@pytest.mark.parametrize("value, unit, text", [(1e-5, "um", "10 um"), (0.5, "m/min", "30 m/min"),
                                               (math.radians(25.2), "deg", "25.2 deg"), (862e6, "MPa", "862 MPa")])
def test_quantity(value, unit, text):
    assert swarf.quantity(value, unit) == text
