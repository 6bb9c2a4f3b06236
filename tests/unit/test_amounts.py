"""Numbers with their units as people read them, in SI and in US units."""

import re
from contextvars import copy_context

import pint
import pytest

from nonhertz.amounts import (
    INCH,
    POUND_FORCE,
    SI,
    US,
    EndStrength,
    amount,
    choose_units,
    current_units,
    display_units,
    mm,
    mpa,
    mrad,
    newton,
    newton_mm,
    um,
    with_error,
)
from nonhertz.errors import InputError

PINT = pint.UnitRegistry()
SPELLED = {"um": "micrometer", "µm": "micrometer", "uin": "microinch", "µin": "microinch", "mil": "milliinch"}


@pytest.mark.parametrize("unit", US.table)
def test_every_unit_is_as_large_as_what_stands_for_it(unit):
    word, factor = US.of(unit)
    assert size(unit) / size(word) == pytest.approx(factor, rel=1e-12)


def size(unit: str) -> float:
    """Return the size of a unit in SI base units."""
    words = re.sub(r"[^\W\d]+", lambda found: SPELLED.get(found[0], found[0]), unit).replace(" ", "*")
    return float(PINT.Quantity(1.0, PINT.parse_units(words)).to_base_units().magnitude)


def test_inch_and_pound_are_exact():
    assert INCH == 25.4
    assert POUND_FORCE == 0.45359237 * 9.80665


@pytest.mark.parametrize(
    ("found", "spec", "si", "us"),
    [
        (newton(20000.0), "", "20.000 kN", "4496.2 lbf"),
        (newton(999.9999), "", "1.0000 kN", "224.81 lbf"),
        (um(0.032151), "", "32.151 µm", "1265.8 µin"),
        (mm(-9.419), "4", "-9.419 mm", "-0.3708 in"),
        (mm(0.0), "", "0 mm", "0 in"),
        (mpa(2397.0), "", "2397.0 MPa", "347.66 ksi"),
        (mpa(0.5), "4", "0.5000 MPa", "72.52 psi"),
        (mpa(0.0), "", "0 MPa", "0 ksi"),
        (mm(-9.4189, 9.4189, between=" to "), "", "-9.4189 to 9.4189 mm", "-0.37082 to 0.37082 in"),
        (mm(46.5), "g", "46.5 mm", "1.831 in"),
        (mm(9.0, 10.0, between=" x "), "g", "9 x 10 mm", "0.3543 x 0.3937 in"),
        (um(0.0325), "g", "32.5 µm", "1280 µin"),
        (mpa(4000.0), "g", "4000 MPa", "580.2 ksi"),
        (mm(20.375), "g", "20.375 mm", "0.80217 in"),
        (mm(18.1234567), "g", "18.1235 mm", "0.713522 in"),
        (mm(0.4), ".2g", "0.4 mm", "0.016 in"),
        (newton(0.0, 11000.0, 0.0), "", "0, 11.000, 0 kN", "0, 2472.9, 0 lbf"),
        (newton(4041.1, 4043.0, between=" and "), "", "4.0411 and 4.0430 kN", "908.48 and 908.90 lbf"),
        (newton_mm(-15.8e3), "", "-15.800 N m", "-139.84 lbf in"),
        (mrad(5e-4), "g", "0.5 mrad", "0.5 mrad"),
        (amount(652630.0, "N/mm", "N/um"), "", "652.63 N/µm", "3.7266 lbf/µin"),
        (amount(0.3, ""), "g", "0.3", "0.3"),
        (amount((1.0, float("inf")), "MPa"), "4", "1.000, inf MPa", "145.0, inf psi"),
    ],
)
def test_text_of_amounts(found, spec, si, us):
    assert format(found, spec) == si
    with display_units("us"):
        assert format(found, spec) == us


def test_errors_keep_their_second_digit():
    with display_units("us"):
        assert with_error(mm(4361.8), 1034.0) == "172 +- 41 in"
        assert with_error(mpa(1308.0), 5.0) == "189.71 +- 0.73 ksi"


def test_the_strength_of_an_end_has_a_power_of_a_length():
    with display_units("us"):
        assert str(EndStrength(348.4, 0.5)) == "10.03 ksi in^0.5"


def test_units_are_chosen_for_a_context():
    inside = copy_context()
    inside.run(choose_units, "us")
    assert inside.run(current_units) is US
    assert current_units() is SI


def test_other_units_are_refused():
    with pytest.raises(InputError, match="units = 'cgs' must be 'si' or 'us'"):
        choose_units("cgs")
