"""Units in which people read results: numbers and units of text, tables and rows."""

from __future__ import annotations

import re
from contextvars import copy_context

import pint
import pytest

from nonhertz.errors import InputError
from nonhertz.result.reading import INCH, POUND_FORCE, SI, US, choose_units, chosen
from nonhertz.result.reading import US_UNITS as WORDS

PINT = pint.UnitRegistry()
SPELLED = {"um": "micrometer", "µm": "micrometer", "uin": "microinch", "µin": "microinch", "mil": "milliinch"}


@pytest.mark.parametrize("unit", WORDS)
def test_every_unit_is_as_large_as_what_stands_for_it(unit: str) -> None:
    word, factor = US.of(unit)
    assert size(unit) / size(word) == pytest.approx(factor, rel=1e-12)


def size(unit: str) -> float:
    """Return the size of a unit in SI base units."""
    words = re.sub(r"[^\W\d]+", lambda found: SPELLED.get(found[0], found[0]), unit).replace(" ", "*")
    return float(PINT.Quantity(1.0, PINT.parse_units(words)).to_base_units().magnitude)


def test_inch_and_pound_are_exact() -> None:
    assert INCH == 25.4
    assert POUND_FORCE == 0.45359237 * 9.80665


@pytest.mark.parametrize(
    ("said", "read"),
    [
        ("20.000 kN", "4496.2 lbf"),
        ("32.151 um", "1265.8 uin"),
        ("−9.419 mm", "−0.3708 in"),
        ("0 mm", "0 in"),
        ("2397.0 MPa", "347.66 ksi"),
        ("0.5 MPa", "72.52 psi"),
        ("20 mm^2/s and 3000 1/min", "20 mm^2/s and 3000 1/min"),
        ("2 Newton steps, 5 in all", "2 Newton steps, 5 in all"),
        # Several numbers share a unit, but a count before a size has none.
        ("-9.4189 to 9.4189 mm", "-0.37082 to 0.37082 in"),
        ("13, 9 x 10 mm", "13, 0.3543 x 0.3937 in"),
        ("0, 11000, 0 N", "0, 2472.9, 0 lbf"),
        ("4041.1 and 4043.0 N", "908.48 and 908.90 lbf"),
        ("at x = 0.2304, y = -0.1108 mm", "at x = 0.009071, y = -0.004362 in"),
        ("roller (diameter 15, length 20 mm; ends free)", "roller (diameter 0.5906, length 0.7874 in; ends free)"),
        ("C = 44.00 kN, C0 = 36.53 kN", "C = 9892 lbf, C0 = 8212 lbf"),
        ("9 values, 0 to 8 mm", "9 values, 0 to 0.315 in"),
        ("Ra 0.0832, Rq 0.105, Rz 0.551 um", "Ra 3.28, Rq 4.13, Rz 21.7 uin"),
        # An error keeps its second digit, and the number before it the same place.
        ("1308 +- 5 MPa", "189.71 +- 0.73 ksi"),
        ("radius 4400 +- 1000 mm, shift 0.12 +- 0.23 mm", "radius 173 +- 39 in, shift 0.0047 +- 0.0091 in"),
        ("+-0.2304 mm", "+-0.009071 in"),
        # K s^-1/2: the unit of K has the exponent of the length.
        ("K = 348.4 MPa mm^0.5", "K = 10.03 ksi in^0.5"),
        ("$K$ = 348.4 MPa mm$^{0.5}$", "$K$ = 10.03 ksi in$^{0.5}$"),
    ],
)
def test_text_in_us_units(said: str, read: str) -> None:
    assert US(said) == read
    assert SI(said) == said


def test_columns_have_the_units_of_their_heads() -> None:
    heads, rows = US.columns(("", "load [N]", "at [mm]"), [("20 mm", "20000, at 5 mm", "+-0.2304"), ("b", "", "0")])
    assert heads == ("", "load [lbf]", "at [in]")
    assert rows == [("0.7874 in", "4496.2, at 0.1969 in", "+-0.009071"), ("b", "", "0")]


def test_rows_of_a_table_may_have_units_in_their_names() -> None:
    rows = [
        ("diameter [mm]", "10.9371 to 10.1233"),
        ("relief at y = 5 mm [µm]", "9.16 and 9.16"),
        ("corner", "R 0.3 mm"),
    ]
    assert US.columns(("", "rollers"), rows)[1] == [
        ("diameter [in]", "0.430594 to 0.398555"),
        ("relief at y = 0.1969 in [µin]", "361 and 361"),
        ("corner", "R 0.01181 in"),
    ]


@pytest.mark.parametrize(
    ("said", "read"),
    [
        (("approach", "29.714", "29.800", "um"), ("approach", "1169.8", "1173.2", "uin")),
        (("load [N]", "20000", "20.000 %"), ("load [lbf]", "4496.2", "20.000 %")),
        # Small beside a bare number: both in the same unit.
        (("p", "0.50000 MPa", "0.25000", "+5 %"), ("p", "0.072519 ksi", "0.036259", "+5 %")),
        (("steps", "3", "4"), ("steps", "3", "4")),
    ],
)
def test_bare_numbers_have_the_unit_of_their_row(said: tuple[str, ...], read: tuple[str, ...]) -> None:
    assert US.row(said) == read
    assert SI.row(said) == said


def test_inputs_keep_six_digits() -> None:
    assert US.value("46.5", "mm", given=True) == ("1.83071", "in")
    assert US.value("46.5", "mm") == ("1.83", "in")
    assert US.value("0.5", "mrad") == ("0.5", "mrad")


def test_units_are_chosen_for_a_context() -> None:
    inside = copy_context()
    inside.run(choose_units, "us")
    assert inside.run(chosen) is US
    assert chosen() is SI


def test_other_units_are_refused() -> None:
    with pytest.raises(InputError, match="units = 'cgs' must be 'si' or 'us'"):
        choose_units("cgs")
