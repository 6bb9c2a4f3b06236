"""Speeds of cage and rollers and frequencies of over-rolling, against what makers have published."""

import math

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.bearing.kinematics import make_kinematics
from nonhertz.errors import InputError

# Makers' multiples of the speed, as the Bearing Data Center of Case Western Reserve University lists them beside the
# diameters in inch: of the rings, the cage, and twice that of a ball. Kinematics are those of rollers.
PUBLISHED = {
    "SKF 6205-2RS JEM": (9, 0.3126, 1.537, (5.4152, 3.5848, 0.39828, 4.7135)),
    "SKF 6203-2RS JEM": (8, 0.2656, 1.122, (4.9469, 3.0530, 0.3817, 3.9874)),
}
# G. Forbes, Curtin University: data of a machinery fault simulator (2012), in mm; a ball is counted by its turns there.
ER_16K = (9, 7.9375, 38.50, (5.428, 3.572, 0.3969, 2.0 * 2.32))


@pytest.mark.parametrize("name", PUBLISHED)
def test_multiples_of_the_speed_are_those_of_the_maker(name):
    balls, ball, pitch, published = PUBLISHED[name]
    found = make_kinematics(balls, ball / pitch, ball / pitch, 60.0, 0.0)
    computed = found.inner_frequency, found.outer_frequency, found.cage_speed / 60.0, found.roller_frequency
    for value, digits in zip(computed, published, strict=True):
        assert value == pytest.approx(digits, abs=3e-4)


def test_multiples_of_the_speed_of_a_third_bearing():
    balls, ball, pitch, published = ER_16K
    motion = make_kinematics(balls, ball / pitch, ball / pitch, 60.0, 0.0)
    computed = motion.inner_frequency, motion.outer_frequency, motion.cage_speed / 60.0, motion.roller_frequency
    assert computed == pytest.approx(published, abs=6e-3)  # half of the last digit, of the last one twice


def test_two_rows_of_rollers_with_a_contact_angle():
    # Rexnord ZA-2115 at 2000/min; Qiu, Lee, Lin, Yu: J. Sound Vib. 289 (2006) 1066: BPFO, BPFI, BSF and cage.
    size = 0.331 / 2.815
    found = make_kinematics(16, size, size * math.cos(math.radians(15.17)), 2000.0, 0.0)
    computed = found.outer_frequency, found.inner_frequency, found.roller_frequency / 2.0, found.cage_speed / 60.0
    assert computed == pytest.approx((236.4, 296.9, 139.9, 14.7), abs=0.08)


@pytest.mark.parametrize(
    ("cage", "spin", "outer", "inner", "outer_turns"),
    [(0.397, 2.328, 3.574, 5.426, 0.603), (0.417, 2.933, 4.588, 6.412, 0.583), (0.381, 1.982, 4.572, 7.428, 0.619)],
)
def test_each_multiple_of_a_catalogue_follows_from_that_of_the_outer_ring(cage, spin, outer, inner, outer_turns):
    # Timken, housed units, table A-9: 205K, 9106 and 318W, of 9, 11 and 12 balls, whose diameters are not listed.
    balls = round(inner + outer)
    ratio = 1.0 - 2.0 * outer / balls
    found = make_kinematics(balls, ratio, ratio, 60.0, 0.0)
    assert (found.cage_speed / 60.0, found.inner_frequency) == pytest.approx((cage, inner), abs=5.1e-4)
    assert found.roller_frequency / 2.0 == pytest.approx(spin, abs=2e-3)  # the last digit of the ratio is worth so much
    assert make_kinematics(balls, ratio, ratio, 0.0, 60.0).cage_speed / 60.0 == pytest.approx(outer_turns, abs=5.1e-4)


def cylindrical():
    return nh.bearing.CylindricalRollerBearing(
        roller=nh.Roller(diameter=9, length=10), inner=nh.Ring(diameter=37.5), outer=nh.Ring(diameter=-55.5), rollers=13
    )


def test_rollers_roll_on_both_rings_without_sliding():
    found = cylindrical().kinematics(inner_speed=3000, outer_speed=-400)
    assert (3000 - found.cage_speed) * 37.5 == pytest.approx(-found.roller_speed * 9)
    assert (found.cage_speed + 400) * 55.5 == pytest.approx(-found.roller_speed * 9)
    assert found.inner_frequency + found.outer_frequency == pytest.approx(13 * 3400 / 60)


def test_all_that_counts_is_how_the_rings_turn_against_each_other():
    one, other = cylindrical().kinematics(inner_speed=3000), cylindrical().kinematics(outer_speed=-3000)
    for name in ("inner_frequency", "outer_frequency", "roller_frequency", "roller_speed"):
        assert getattr(one, name) == pytest.approx(getattr(other, name))
    assert one.shaft_frequency == other.shaft_frequency == 50


def test_tapered_rollers_roll_on_cones_that_meet_in_one_point():
    # With the apex on the bearing's axis the radii of raceway and roller are proportional all along the roller.
    half, inclined, pitch = math.radians(2.0), math.radians(12.0), 52.0
    diameter = pitch * math.tan(half) / math.sin(inclined)
    y = np.array([-6.0, 6.0])
    roller = nh.Roller(diameter=nh.TabulatedDiameter(tuple(y), tuple(diameter - 2 * np.tan(half) * y)), length=12)
    gap = diameter * math.cos(half) ** 2 / math.cos(inclined)
    rings = {"inner": nh.Ring(diameter=pitch - gap), "outer": nh.Ring(diameter=-(pitch + gap))}
    row = nh.bearing.TaperedRollerBearing(roller=roller, **rings, rollers=15, contact_angle=inclined + half)
    found = row.kinematics(inner_speed=1000)
    assert found.cage_speed == pytest.approx(
        500 * math.sin(inclined - half) / math.sin(inclined) / math.cos(half), rel=1e-9
    )


def test_rollers_between_washers_turn_with_half_the_speed():
    row = nh.bearing.CylindricalThrustBearing(
        roller=nh.Roller(diameter=6, length=6), inner=nh.Plate(), outer=nh.Plate(), rollers=20, pitch_diameter=48
    )
    found = row.kinematics(inner_speed=900)
    assert (found.cage_speed, found.roller_speed) == pytest.approx((450, -450 * 48 / 6))
    assert found.inner_frequency == pytest.approx(found.outer_frequency) == pytest.approx(20 * 450 / 60)


@pytest.mark.parametrize("speeds", [{}, {"inner_speed": 100, "outer_speed": 100}, {"inner_speed": math.nan}])
def test_nothing_rolls_without_a_difference_of_speeds(speeds):
    with pytest.raises(InputError, match=r"inner_speed = .* must (differ|be)"):
        cylindrical().kinematics(**speeds)
