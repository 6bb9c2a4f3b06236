"""What results say of themselves where they are printed."""

import dataclasses
import re

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.errors import without_accuracy_warnings

ROLLER = nh.Roller(diameter=20, length=20, profile=nh.profile.crown(2000))
CONTACT = nh.Contact(ROLLER, nh.Ring(diameter=80))
FITS = nh.bearing.Mounting(shaft="k5", housing="H7")


def quietly(solve, *arguments, **given):
    with without_accuracy_warnings():
        return solve(*arguments, **given)


@pytest.fixture(scope="module")
def solved():
    return nh.solve(CONTACT, load=5e3, tilt=0.2e-3)


def test_a_solution_is_printed_in_ten_lines_at_most(solved):
    said = repr(solved).splitlines()
    assert len(said) <= 10
    assert said[1].strip() == (
        "roller (diameter 20 mm, length 20 mm; ends free, depth finite) against ring (diameter 80 mm; depth none)"
    )
    assert "load 5.0000 kN" in repr(solved)
    assert "tilt 0.20000 mrad" in repr(solved)
    assert f"approach {1e3 * solved.approach:.3f} µm, error about" in repr(solved)
    assert re.search(r"maximum pressure \d+\.\d MPa at y = \S+ mm, error about", repr(solved))
    assert "both ends run out" in repr(solved)


def test_maxima_that_mirror_each_other_are_two_places_and_neighbours_one():
    sharp = quietly(nh.solve, nh.Contact(nh.Roller(diameter=20, length=20), nh.Ring(diameter=80)), load=20e3)
    low, high = re.search(r"maximum pressure \S+ MPa at y = (\S+) and (\S+) mm, away from", repr(sharp)).groups()
    assert float(low) == -float(high) == pytest.approx(-abs(sharp.max_pressure_y), abs=1e-3)
    even = quietly(nh.solve, CONTACT, load=5e3, strips=20)
    assert re.search(r"maximum pressure \S+ MPa at y = \S+ mm", repr(even))


def test_plane_grids_and_batches_are_printed_too():
    patch = quietly(nh.patch.solve, CONTACT, load=5e3, cells=(32, 64))
    assert len(repr(patch).splitlines()) <= 10
    assert "32 x 64 cells" in repr(patch)
    many = quietly(nh.solve_many, CONTACT, approach=[[5e-3, 6e-3], [7e-3, -1.0]], strips=21)
    said = repr(many)
    assert "3 of 4 cases converged, shape 2 x 2" in said
    assert "approach 5.0000 to 7.0000 µm" in said
    assert "failed: case (1, 1): approach = -1.0" in said


def test_warnings_take_one_line():
    sharp = quietly(nh.solve, nh.Contact(nh.Roller(diameter=20, length=20), nh.Ring(diameter=80)), load=5e3)
    (life,) = nh.life.assess(sharp, "iso-16281")
    assert len(sharp.warnings) == 2
    assert repr(sharp).splitlines()[-1].endswith(" ... (and 1 more)")
    assert repr(life).splitlines()[-1].startswith("  warning: The contact reaches the sharp end")


def test_measured_points_are_printed_by_their_range():
    y = np.linspace(-9.0, 9.0, 400)
    trace = nh.measured.Trace(y, 1e-4 * y**2, name="roller 7")
    assert repr(trace).startswith("Trace(y=<400: -9.000 to 9.000>, height=<400: ")
    assert repr(nh.measured.Measured(trace).levelled()) == "Measured(trace='roller 7', steps=(Level(),))"


def test_inputs_print_as_they_are_typed() -> None:
    """A material of the library by its name, a long row of numbers by its ends; a material of one's own in full."""
    bearing_steel = nh.Roller(diameter=9.0, length=10.0, material=nh.MATERIALS["52100"])
    assert repr(bearing_steel) == "Roller(material='100Cr6', diameter=9, length=10)"
    own = nh.Material(modulus=150e3, poisson=0.3)
    assert repr(nh.Plate(material=own)) == "Plate(material=Material(modulus=150000, poisson=0.3))"
    y = np.linspace(-1.0, 1.0, 7)
    assert (
        repr(nh.profile.tabulated(y, 0.01 * y**2 / 3.0))
        == "tabulated(y=(-1, ..., 1), relief=(0.00333333, ..., 0.00333333))"
    )
    listed = repr(nh.MATERIALS).splitlines()
    assert "52100: Material(modulus=210000, poisson=0.3, hardness='58 HRC', pressure_limit=4000)" in listed


def test_moments_that_are_rounding_are_printed_as_zero():
    assert "moment 0 N mm" in repr(nh.solve_many(CONTACT, load=[5e3, 6e3], strips=41))


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (
            lambda: nh.hertz.line_contact(line_load=1e3, radius=10, e_star=1e5),
            "half_width=0.35682, max_pressure=1784.1)",
        ),
        (lambda: nh.bearing.rating(nh.new_bearing().bearing), "Rating(dynamic=40434, static=39025, inner="),
        (
            lambda: nh.subsurface.stress(nh.solve(CONTACT, load=5e3), 0, 0, 0.1),
            "Field(body='a', x=0, y=0, z=0.10000, s",
        ),
        (
            lambda: nh.solve_many(CONTACT, load=[5e3, 6e3]),
            "  tilt 0 mrad\n  load 5.0000 to 6.0000 kN\n  moment 0 N mm",
        ),
        (
            lambda: nh.bearing.solve_many(nh.new_bearing().bearing, radial=[1e3, 5e3], method="slices"),
            "CylindricalRollerBearing of 13 rollers, by slices\n  2 of 2 states converged, shape 2\n  largest load of",
        ),
        (
            lambda: nh.bearing.assess(
                nh.bearing.solve(nh.new_bearing().bearing, radial=1e4, speed=3e3), required="9 h"
            ),
            "\n  required 1.620 million revolutions: met\n",
        ),
        (
            lambda: FITS.ranges(dataclasses.replace(nh.new_bearing().bearing, bore=30, outside_diameter=62)),
            "\n  interference on the shaft 2.000 to 21.00 µm, likely 11.50 µm\n",
        ),
    ],
)
def test_values_are_printed_short_and_in_words(value, text):
    printed = repr(quietly(value))
    assert text in printed
    assert len(printed.splitlines()) <= 10


def test_films_are_printed_in_words_and_no_bracket_stays_open():
    solution = nh.bearing.solve(nh.new_bearing().bearing, radial=1e4, speed=3e3)
    films = nh.bearing.films(solution, lubrication=nh.bearing.Lubrication(viscosity=20))
    roller, ring = films.least
    assert f"least film {1e3 * films.least_film[roller, ring]:.5f} µm" in repr(films)
    assert f"between roller {roller + 1} and the inner ring" in repr(films)
    for value in (films.contacts[0], nh.subsurface.extremes(solution.contact(0))):
        assert repr(value).count("(") == repr(value).count(")")
