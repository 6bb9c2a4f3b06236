"""Quantities as text: what is read, to what number, and what is refused."""

import math
import sys

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import nonhertz as nh
from nonhertz.errors import InputError
from nonhertz.inputs import units
from nonhertz.inputs.units import to_unit

UNITS = ("mm", "N", "MPa", "1/MPa", "rad", "N mm")


@pytest.mark.parametrize(
    ("text", "unit", "number"),
    [
        ("20 mm", "mm", 20.0),
        ("12 um", "mm", 0.012),
        ("12 µm", "mm", 0.012),  # the micro sign
        ("12 μm", "mm", 0.012),  # the Greek letter
        ("0.1 um", "mm", 0.0001),
        ("-1.5e-3 m", "mm", -1.5),
        ("1 in", "mm", 25.4),
        ("1 mil", "mm", 0.0254),
        ("2 mils", "mm", 0.0508),
        ("1 mil/in", "rad", math.atan(0.001)),
        ("1 thou", "mm", 0.0254),
        ("20 kN", "N", 20000.0),
        ("20kN", "N", 20000.0),
        ("  20   kN ", "N", 20000.0),
        ("207 GPa", "MPa", 207000.0),
        ("207000 N/mm2", "MPa", 207000.0),
        ("207000 N/mm²", "MPa", 207000.0),
        ("207000 N/mm^2", "MPa", 207000.0),
        ("207000 N/mm**2", "MPa", 207000.0),
        ("2.8e-6 1/MPa", "1/MPa", 2.8e-6),
        ("2.8e-6 / MPa", "1/MPa", 2.8e-6),
        ("2.8e-6 MPa^-1", "1/MPa", 2.8e-6),
        ("0.5 mrad", "rad", 0.0005),
        ("0.03 deg", "rad", math.radians(0.03)),
        ("0.03°", "rad", math.radians(0.03)),
        ("0.5 mm/m", "rad", math.atan(0.0005)),
        ("8 um/25 mm", "rad", math.atan(0.00032)),
        ("-8um / 2.5 cm", "rad", -math.atan(0.00032)),
        ("1 mm/1 mm", "rad", math.pi / 4),
        ("1e-3 mm/.5 mm", "rad", math.atan(0.002)),
        ("1 in/1 ft", "rad", math.atan(1 / 12)),
        ("5 N m", "N mm", 5000.0),
        ("5 N·m", "N mm", 5000.0),
        ("5 N*m", "N mm", 5000.0),
        ("5 Nm", "N mm", 5000.0),
        ("5 kNm", "N mm", 5e6),
        ("5 Nmm", "N mm", 5.0),
        ("30 Msi", "MPa", 30e6 * 4.4482216152605 / 25.4**2),
        ("2 tf", "N", 19613.3),
        ("1 kp", "N", 9.80665),
    ],
)
def test_text_with_a_unit_is_read(text, unit, number):
    # One rounding of the factor and one of the product.
    assert to_unit("field", text, unit) == pytest.approx(number, rel=4e-16, abs=0.0)


def test_decimal_submultiples_do_not_gain_digits():
    assert [to_unit("field", f"0.{i} um", "mm") for i in range(1, 10)] == [float(f"0.{i}e-3") for i in range(1, 10)]


@pytest.mark.parametrize(
    ("text", "unit", "sentence"),
    [
        ("5 kg", "mm", "a unit of length: write a number in mm, or text with a unit of length such as '20 mm'."),
        ("5", "mm", "a unit: write 5 without quotes if it is in mm."),
        ("8 um", "rad", "a unit of angle: write a number in rad, or text with a unit of angle such as '0.5 mrad' or "),
        ("1 mil", "rad", "a unit of angle, and a mil is a thousandth of an inch: write a number in rad, or text with "),
        ("2,5 um", "mm", "a decimal point: write 2.5 um."),
        ("20e3 lb", "N", "a unit of force: write 20e3 lbf."),
        ("5 n", "mm", "a known unit: write a number in mm, or text"),
        ("30 msi", "MPa", "a known unit: write 30 Msi."),
        ("2 t", "N", "a unit of force: write 2 tf."),
        ("2 tonf", "N", "a unit of one meaning: write 2 tf for tonnes, 4000 lbf for short, 4480 for long tons."),
        ("5 N", "mm^2/s", "a unit of viscosity: write a number in mm^2/s, or text with a unit of visco"),
    ],
)
def test_a_refusal_is_one_sentence(text, unit, sentence):
    with pytest.raises(InputError) as caught:
        to_unit("length", text, unit)
    assert str(caught.value).startswith(f"length = '{text}' must have {sentence}")


def test_what_some_versions_of_pint_take_for_knots_is_meant_as_kilonewtons():
    with pytest.raises(InputError, match=r"^load = '20 kn' must have a (unit of force|known unit): write 20 kN\.$"):
        to_unit("load", "20 kn", "N")


@pytest.mark.parametrize(
    "text", ["20 cP", "20cP", "20 mPa s", "20 mPas", "20 mPa*s", "0.02 Pa·s", "0.2 P", "0.02 N s/m^2"]
)
def test_of_a_dynamic_viscosity_the_density_is_asked_for(text):
    # 1 mPa s over 1 g/cm^3 is 1 mm^2/s.
    with pytest.raises(InputError) as caught:
        to_unit("viscosity", text, "mm^2/s")
    said = "divide by the oil's density: 0.87 g/cm^3 would give '22.99 mm^2/s'"
    assert str(caught.value) == f"viscosity = '{text}' must be a kinematic viscosity: {said}."
    assert to_unit("viscosity", "22.99 mm^2/s", "mm^2/s") == pytest.approx(20.0 / 0.87, rel=1e-4)


@pytest.mark.parametrize("text", ["20 inch", "8 um/25 yd"])
def test_without_pint_a_unit_is_refused_in_a_sentence(text, monkeypatch):
    monkeypatch.setitem(sys.modules, "pint", None)
    units._factor.cache_clear()
    with pytest.raises(InputError, match=r"must be a plain number in rad where pint, .*: pip install pint\.$"):
        to_unit("angle", text, "rad")
    with pytest.raises(InputError, match=r"^diameter = '2 cm' must be a plain number in mm where pint, which reads"):
        nh.Roller(diameter="2 cm", length=20.0)
    assert nh.Roller(diameter="20 mm", length=20.0).diameter == 20.0


@pytest.mark.parametrize(("unit", "text"), [(unit, text) for unit, known in units._KNOWN.items() for text in known])
def test_units_that_are_known_without_pint_are_what_pint_says(unit, text, monkeypatch):
    known = to_unit("field", f"0.7 {text}", unit)
    monkeypatch.setattr(units, "_KNOWN", {})
    units._factor.cache_clear()
    assert to_unit("field", f"0.7 {text}", unit) == known


@pytest.mark.parametrize(
    ("text", "unit"),
    [
        ("", "mm"),
        ("five mm", "mm"),
        ("5 mn m", "mm"),
        ("0.3", ""),
        ("nan mm", "mm"),
        ("1,5 mm", "mm"),
        ("5 mm + 3 mm", "mm"),
        ("8 um/25 mm", "N"),
        ("8 um/25", "rad"),
        ("8/25 mm", "rad"),
        ("8 um/25 mm/2 mm", "rad"),
        ("8 um/0 mm", "rad"),
        ("8 um/-25 mm", "rad"),
        ("5 degC", "rad"),  # converts, but not by a factor
        ("5 lb", "N"),  # a mass
        ("9**9**9**9 mm", "mm"),  # would never end if it were calculated
        ("5 " + "m*" * 1000 + "m", "mm"),
    ],
)
def test_what_is_no_quantity_of_the_kind_is_refused(text, unit):
    with pytest.raises(InputError):
        to_unit("field", text, unit)


@pytest.mark.parametrize("value", [True, None, [1.0], {"a": 1}])
def test_what_is_neither_number_nor_text_is_left_to_the_model(value):
    assert to_unit("field", value, "mm") is value


def test_integers_too_large_for_a_float_become_infinite():
    assert to_unit("field", 10**400, "mm") == math.inf
    assert to_unit("field", -(10**400), "mm") == -math.inf


def read_or_refused(text: str, unit: str) -> float | str:
    """Return the number, or the sentence that refuses the text."""
    try:
        return float(to_unit("field", text, unit))
    except InputError as error:
        return str(error)


# The first text with a unit imports pint.
@settings(deadline=None)
@given(rise=st.floats(-100.0, 100.0), run=st.floats(1e-3, 100.0))
def test_a_slope_is_the_angle_of_that_tangent(rise, run):
    angle = to_unit("field", f"{rise} um/{run} mm", "rad")
    assert math.tan(angle) == pytest.approx(1e-3 * rise / run, rel=1e-13)
    assert to_unit("field", f"{rise / run!r} um/mm", "rad") == pytest.approx(angle, rel=1e-14)


# The first text with a unit imports pint.
@settings(deadline=None, max_examples=40)
@given(text=st.text(max_size=30), unit=st.sampled_from(UNITS))
def test_any_text_is_read_or_refused_in_a_sentence(text, unit):
    outcome = read_or_refused(text, unit)
    assert isinstance(outcome, float) or (outcome.startswith("field = ") and "\n" not in outcome)


# The first text with a unit imports pint.
@pytest.mark.slow
@settings(deadline=None)
@given(text=st.from_regex(r"[0-9]{1,3} ?[a-zA-Z]{1,4}([ */^][a-zA-Z0-9]{1,3})?", fullmatch=True))
def test_whatever_looks_like_a_quantity_is_read_or_refused(text):
    for unit in UNITS:
        outcome = read_or_refused(text, unit)
        assert isinstance(outcome, float) or outcome.startswith("field = ")
