"""Bearings that cannot be: one sentence each."""

import math

import numpy as np
import pytest

import nonhertz as nh

ROLLER = nh.Roller(diameter=9.0, length=10.0, profile=nh.profile.crown(4000))
PARTS = {"roller": ROLLER, "inner": nh.Ring(diameter=37.5), "outer": nh.Ring(diameter=-55.5), "rollers": 13}
CONE = nh.Roller(diameter=nh.TabulatedDiameter((-5.0, 5.0), (9.4, 8.6)), length=10.0, profile=nh.profile.crown(4000))
TAPER = {"roller": CONE, "inner": nh.Ring(diameter=37.3), "outer": nh.Ring(diameter=-55.7), "rollers": 13}


def cylindrical(**changes):
    return nh.bearing.CylindricalRollerBearing(**(PARTS | changes))


def tapered(**changes):
    return nh.bearing.TaperedRollerBearing(**(TAPER | {"contact_angle": 0.2} | changes))


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: cylindrical(rollers=0), "rollers = 0 must be a whole number from 1 to 1000"),
        (lambda: cylindrical(pitch_diameter=8.0), "none fits"),
        (lambda: cylindrical(roller=nh.Body(diameter=9.0)), "roller.length must be given"),
        (lambda: cylindrical(clearance=-1.0), "clearance = -1.0 must lie between -0.465 and 0.465 mm, for displ"),
        (lambda: tapered(clearance=-20), "clearance = -20.0 must lie between -1.15 and 1.15 mm, for displacements"),
        (
            lambda: nh.bearing.solve(cylindrical(), radial=1e3, speed=1e9),
            "speed = 1000000000.0 must not exceed 4.11e+05",
        ),
        (
            lambda: nh.bearing.paired(tapered(), "B", 20),
            "must be one of 'X', 'O', 'tandem': 'X' is face to face, 'O' b",
        ),
        (
            lambda: nh.study.diagram(nh.new_case(), "clearance", "0 : 1 um"),
            "must be a BearingCase, or the name of a be",
        ),
        (lambda: nh.files.read_trace(None), "file = None must be the path of a file: give a string or a Path."),
        (
            lambda: nh.measured.Trace([1, 2, 3, 4, 5], [0]),
            "must have 5 numbers, as y has, not 1: give one per position",
        ),
        (lambda: cylindrical(outer_shape=lambda angle: 0.0), "outer_shape = () must return 13 lengths"),
        (lambda: tapered(contact_angle=0.05), "contact_angle = 0.05 must exceed the rollers' cone angle"),
        (lambda: nh.bearing.solve(cylindrical(), radial=1e3, method="slices").contact(0), "method = 'slices' must be"),
        (lambda: nh.bearing.solve(cylindrical(), radial=1000.0).contact(13), "roller = 13 must be a whole number from"),
    ],
)
def test_what_cannot_be_is_refused_in_one_sentence(make, message):
    with pytest.raises(nh.InputError) as refused:
        make()
    assert message in str(refused.value)
    assert str(refused.value).count("\n") == 0


def test_text_with_a_unit_is_the_number():
    loaded = nh.bearing.solve(cylindrical(), radial="1 kN", speed="50 Hz", method="slices")
    assert loaded.speed == 3000.0
    assert np.array_equal(loaded.load, nh.bearing.solve(cylindrical(), radial=1e3, speed=3e3, method="slices").load)


def test_needles_on_a_huge_circle_are_no_overflow():
    needles = {"roller": nh.Roller(diameter=1e-90, length=1.0), "pitch_diameter": 1e90}
    with pytest.raises(nh.InputError, match=r"^roller\.diameter = 1e-90 must fill"):
        nh.bearing.CylindricalRollerBearing(
            inner=nh.Ring(diameter=40), outer=nh.Ring(diameter=-60), rollers=3, **needles
        )


def test_without_a_force_nothing_is_loaded():
    found = nh.bearing.solve(cylindrical(clearance=0.02))
    assert np.all(found.load == 0.0)
    assert np.all(found.max_pressure == 0.0)


def test_preload_loads_every_roller_alike():
    found = nh.bearing.solve(cylindrical(clearance=-0.01))
    np.testing.assert_allclose(found.load, found.load[0, 0], rtol=1e-9)
    assert found.load[0, 0] > 100.0


def test_a_displacement_takes_the_force_that_moves_so_far():
    loaded = nh.bearing.solve(cylindrical(clearance=0.01), radial=(8e3, -3e3), tilt=5e-4)
    moved = nh.bearing.solve(cylindrical(clearance=0.01), radial_displacement=loaded.displacement[1:3], tilt=5e-4)
    np.testing.assert_allclose(moved.force[1:], loaded.force[1:], rtol=1e-5, atol=0.5)


def test_a_shape_that_leaves_less_room_loads_the_roller_there():
    def bump(angle):
        return np.where(np.abs(angle) < 0.1, 0.004, 0.0)

    plain, bumped = (nh.bearing.solve(cylindrical(outer_shape=shape), radial=8e3) for shape in (None, bump))
    assert bumped.load[0, 1] > 1.05 * plain.load[0, 1]
    assert bumped.load[1, 1] < plain.load[1, 1]


def test_speed_presses_idle_rollers_against_the_outer_ring():
    found = nh.bearing.solve(cylindrical(clearance=0.02), radial=5e3, speed=6000.0)
    mass = cylindrical().inertia.mass
    assert mass == pytest.approx(7.85e-9 * math.pi / 4.0 * 81.0 * 10.0)
    cage = 0.5 * 6000.0 * math.pi / 30.0 * (1.0 - 9.0 / 46.5)
    assert found.roller_load[0, 1] == pytest.approx(mass * 23.25 * cage**2)
    assert found.load[6, 0] == 0.0
    assert found.load[6, 1] == pytest.approx(found.roller_load[0, 1], rel=1e-7)
    np.testing.assert_allclose(found.load[0, 1] - found.load[0, 0], found.roller_load[0, 1], rtol=1e-5)


@pytest.mark.parametrize("with_clearance", [False, True])
def test_needles_have_the_clearance_of_their_group(with_clearance):
    # Group C4 of a bore of 25 mm is 50 to 75 um, of needles of 3 mm more than 2 %.
    wider = 0.075 if with_clearance else 0.0
    rings = {"inner": nh.Ring(diameter=30.0), "outer": nh.Ring(diameter=-(36.0 + wider))}
    needle = nh.Roller(diameter=3.0, length=16.0, profile=nh.profile.crown(4000))
    row = nh.bearing.NeedleRollerBearing(roller=needle, **rings, rollers=24, clearance=0.075)
    found = nh.bearing.solve(row, radial=5e3, method="slices")
    assert found.force[1] == pytest.approx(5e3)
    # The exact gap of an eccentric inner ring of radius 15, less that of small motions, at 90 degrees to the motion.
    eccentric = 0.5 * row.clearance
    beside = math.hypot(16.5, eccentric) - 16.5
    assert beside < 0.005 * eccentric
