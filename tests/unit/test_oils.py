"""Oils by their grades: viscosities in the bearing, what pressure does to them, and what goes together."""

import math

import pytest

import nonhertz as nh
from nonhertz.bearing.oil import viscosity_at_100
from nonhertz.files.starting import starting_bearing

LUBRICATION = nh.bearing.Lubrication


# ASTM D2270 and what follows from its table: viscosities at 40 and 100 degC, and the index. The first two are the
# examples of the standard (as the package chemicals quotes them), the third an oil of a public program.
@pytest.mark.parametrize(
    ("at_40", "at_100", "index"), [(73.30, 8.86, 92.0), (22.83, 5.05, 156.37), (218.0, 24.6, 142.0)]
)
def test_a_viscosity_index_is_that_of_the_standard(at_40, at_100, index):
    assert viscosity_at_100(at_40, index) == pytest.approx(at_100, rel=2e-3)


def test_an_oil_of_index_100_or_0_is_that_of_the_table():
    # H and L of the table of ASTM D2270 at 10 mm^2/s.
    assert viscosity_at_100(82.87, 100.0) == pytest.approx(10.0, rel=1e-3)
    assert viscosity_at_100(147.7, 0.0) == pytest.approx(10.0, rel=1e-3)


@pytest.mark.parametrize("written", ["ISO VG 68", "iso vg 68", "VG68", "68"])
def test_a_grade_may_be_written_in_several_ways(written):
    oil = LUBRICATION(oil=written, temperature=40)
    assert oil.oil == "ISO VG 68"
    assert oil.in_place.viscosity == pytest.approx(68.0)


def test_between_two_temperatures_the_viscosity_is_that_of_astm_d341():
    oil = LUBRICATION(viscosities=[68, 8.7], temperature=70, density="0.9 g/cm^3")
    assert oil.in_place.viscosity == nh.bearing.oil_viscosity(70, viscosities=(68, 8.7))
    assert oil.dynamic_viscosity == pytest.approx(oil.in_place.viscosity * 0.9e-9)


def test_pressure_raises_the_viscosity_of_a_mineral_oil_as_published():
    # Gold's coefficients in the sheet of the program contact_mechanics: 115.664 mm^2/s has 19.1688 / GPa.
    assert LUBRICATION(viscosity=115.664).pressure_coefficient == pytest.approx(19.1688e-3, rel=1e-4)
    assert LUBRICATION(viscosity=20, pressure_viscosity="22 1/GPa").pressure_coefficient == pytest.approx(0.022)
    assert LUBRICATION().pressure_coefficient is LUBRICATION().dynamic_viscosity is None


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"oil": "ISO VG 69", "temperature": 50}, "oil = 'ISO VG 69' must be a grade of ISO 3448, VG 2, 3, 5"),
        ({"oil": "ISO VG 68"}, "temperature must be given with an oil"),
        ({"oil": "ISO VG 68", "temperature": 50, "viscosity": 20}, "oil = 'ISO VG 68' must not be given together with"),
        ({"oil": "ISO VG 68", "temperature": 400}, r"temperature = 400\.0 must lie between -60 and 250 degC"),
        ({"oil": "ISO VG 10", "temperature": 200}, r"temperature = 200\.0 must leave the oil with more than 2 mm2/s"),
        ({"viscosities": [8.7, 68], "temperature": 70}, r"viscosities = \(8\.7, 68\.0\) must exceed 2 mm2/s and be"),
        ({"viscosity": 20, "grease": True, "cleanliness": "-/17/14"}, "cleanliness = '-/17/14' must be 'high' or one"),
        ({"cleanliness": "high"}, "cleanliness = 'high' must be given with a viscosity"),
        ({"oil": "ISO VG 68", "temperature": 50, "viscosity_index": 300}, r"viscosity_index = 300\.0 must not exceed"),
    ],
)
def test_what_does_not_go_together_ends_in_a_sentence(given, words):
    with pytest.raises(nh.InputError, match=words):
        LUBRICATION(**given)


@pytest.mark.parametrize(("level", "small", "large"), [("normal", 0.5, 0.6), ("typical", 0.1, 0.2), ("severe", 0, 0)])
def test_levels_of_the_guide_have_their_lower_end(level, small, large):
    factor = nh.bearing.contamination_factor
    assert (factor(1.0, 99.0, level), factor(2.0, 100.0, level)) == (small, large)


def test_a_bearing_in_grease_of_a_grade_has_a_modified_life_and_says_what_it_assumes(tmp_path):
    path = tmp_path / "nu206.toml"
    path.write_text(starting_bearing("cylindrical"), encoding="utf-8")
    oil = {"oil": "ISO VG 68", "temperature": 70, "grease": True, "cleanliness": "normal", "viscosity": None}
    case = nh.read_bearing(path, {f"lubrication.{name}": value for name, value in oil.items()})
    found = case.solve("slices")
    life = case.assess(found)
    expected = nh.bearing.assess(found, speed=3000, viscosity=case.lubrication.in_place.viscosity, contamination=0.5)
    assert life.modified_life == pytest.approx(expected.modified_life)
    assert math.isfinite(life.modified_life)
    said = [dict(each.numbers)["default"] for each in case.assumed]
    assert {"viscosity index of 95", "oil of 880 kg/m³", "alpha of a mineral oil"} <= set(said)
    case.write(tmp_path / "again.toml")
    assert nh.read_bearing(tmp_path / "again.toml").lubrication == case.lubrication
