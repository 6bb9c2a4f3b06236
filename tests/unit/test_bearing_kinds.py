"""Spherical, thrust and paired bearings: what each kind is there for."""

import dataclasses
import warnings
from pathlib import Path

import numpy as np
import pytest
from crowned_rows import TAPER, barrels, nu206, row, washers
from numpy.testing import assert_allclose

import nonhertz as nh
from nonhertz.bearing.standard import standard_slices
from nonhertz.show.bearing import summary_rows

B = nh.bearing
THRUST = washers(depth=4.0)
SPHERICAL = barrels(clearance=0.02)


@pytest.mark.parametrize("method", ["strips", "slices"])
def test_a_spherical_bearing_aligns_itself(method):
    """Barrels roll on a sphere: a tilt of 5 mrad leaves no moment. By slices it was 83 N m."""
    row = SPHERICAL
    # Lines of pressure meet in the middle of the sphere.
    bearing = B.paired(row, "X", row.pitch * np.tan(row.contact_angle))
    straight, tilted = (B.solve(bearing, radial=40e3, axial=5e3, tilt=tilt, method=method) for tilt in (0.0, 5e-3))
    assert_allclose(tilted.load, straight.load, rtol=2e-3, atol=1.0)
    assert np.abs(tilted.force[3:]).max() < 1e-4 * 40e3
    assert tilted.stiffness[4, 4] < 1e-6 * tilted.stiffness[1, 1] * row.pitch**2
    # On a shaft that is tilted a row of cylindrical rollers would bear a moment.
    assert straight.load[17:].max() > 2.0 * straight.load[:17].max()


@pytest.mark.parametrize("distance", [0.0, 18.0, 18.2440])
def test_a_moment_on_a_bearing_that_aligns_itself_is_refused(distance):
    """It was searched for minutes, and not found."""
    bearing = B.paired(SPHERICAL, "X", distance) if distance else SPHERICAL
    with pytest.raises(nh.InputError) as refused:
        B.solve(bearing, radial=40e3, axial=9e3, moment=5e3)
    told = "moment = 5000.0 must be zero for a bearing whose inner ring is free to turn about the centre of a sphere"
    assert str(refused.value).startswith(told)
    held, free = (B.solve(bearing, radial=40e3, axial=9e3, method="slices", **each) for each in ({}, {"moment": 0.0}))
    assert_allclose(free.load, held.load)
    # Rows that are further apart bear one by the distance of their spheres.
    apart = B.solve(B.paired(SPHERICAL, "O", 30.0), radial=40e3, moment=1e5, method="slices")
    assert_allclose(apart.force[4], 1e5)


def test_rollers_of_a_thrust_bearing_share_the_load():
    found = B.solve(THRUST, axial=50e3)
    assert_allclose(found.load, 2500.0, rtol=1e-8)
    assert_allclose(found.force[[1, 2]], 0.0, atol=1e-6)
    tilted = B.solve(THRUST, axial=50e3, moment=(0.0, 3e5))
    load, angle = tilted.load[:, 0], tilted.angle
    assert load.sum() == pytest.approx(50e3, rel=1e-8)
    # The moment of the loads, and what the tilted contacts bear themselves.
    about_z = -30.0 * load @ np.cos(angle) + tilted.moment[:, 0] @ np.cos(angle)
    assert about_z == pytest.approx(3e5, rel=1e-6)


@pytest.mark.parametrize("method", ["strips", "slices"])
def test_two_rows_back_to_back_are_stiffer_against_tilting(method):
    found = {
        each: B.solve(B.paired(TAPER, each, 20.0, clearance=-0.01), radial=20e3, axial=6e3, method=method)
        for each in ("X", "O")
    }
    assert found["O"].stiffness[3, 3] > 5.0 * found["X"].stiffness[3, 3]
    # Without a tilt they are the same rows in another order.
    assert_allclose(found["O"].load[:14], found["X"].load[14:], rtol=1e-6, atol=1e-3)
    assert_allclose(found["O"].displacement[:3], found["X"].displacement[:3], rtol=1e-6, atol=1e-9)
    for each in found.values():
        assert each.load.shape == (28, 2)
        assert_allclose(each.stiffness, each.stiffness.T, rtol=1e-4, atol=1e-4 * each.stiffness[3, 3])


def test_a_row_that_is_turned_round_is_its_mirror_image():
    turned = B.Paired(bearings=(TAPER,), x=(0.0,), turned=(True,))
    one = B.solve(TAPER, radial=20e3, axial=7e3, tilt=3e-4)
    other = B.solve(turned, radial=20e3, axial=-7e3, tilt=-3e-4)
    assert_allclose(other.load, one.load, rtol=1e-8, atol=1e-5)
    assert_allclose(other.tilt, one.tilt, atol=1e-11)
    assert_allclose(other.displacement * [-1, 1, 1, -1, -1], one.displacement, rtol=1e-8, atol=1e-12)
    assert_allclose(other.rib_load, one.rib_load, rtol=1e-7, atol=1e-4)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (
            lambda: B.solve(THRUST, axial=-1000.0),
            "axial = -1000.0 must act along +x, the only direction in which this ",
        ),
        (lambda: B.solve(THRUST, radial=1e3), "radial = 1000.0 must be zero for a bearing whose inner ring is free"),
        (
            lambda: B.rating(
                dataclasses.replace(TAPER, outer=nh.Ring(diameter=-62.32, material=nh.Material(1e5, 0.3)))
            ),
            "must be of bearing steel",
        ),
        (lambda: B.Paired(bearings=(TAPER,), x=(0.0, 1.0), turned=(True,)), "x = (0.0, 1.0) must hold 1 positions"),
        (lambda: B.Paired(bearings=(), x=(), turned=()), "bearings = () must be rows of rollers"),
        (lambda: B.Paired(bearings=(TAPER,), x=(0.0,), turned=(3,)), "turned = 3 must be"),
        (
            lambda: B.solve(B.paired(TAPER, "tandem", 20.0), radial=20e3, axial=1e3),
            "axial = 1000.0 must exceed 4.2 kN",
        ),
    ],
)
def test_what_cannot_be_is_refused_in_one_sentence(make, message):
    with pytest.raises(nh.InputError) as refused:
        make()
    assert message in str(refused.value)


def momenta(row, rollers_density, speed, time, sense=-1.0):
    """Momentum of a tapered roller and its angular momentum about its middle's place now, from all its points."""
    half, slope = 0.5 * row.roller_length, np.tan(row.half_cone_angle)
    gauss, weights = np.polynomial.legendre.leggauss(12)
    y = half * gauss
    inclined = 0.5 * sum(row.contact_angles)
    ratio = row.roller_diameter * np.cos(inclined) / row.pitch
    cage, roll = 0.5 * speed * (1.0 + sense * ratio), 0.5 * speed * row.pitch / row.roller_diameter * (1.0 - ratio**2)
    x, radial = np.array([1.0, 0.0, 0.0]), np.array([0.0, np.cos(cage * time), np.sin(cage * time)])
    axis = np.cos(inclined) * x - np.sin(inclined) * radial
    across, tangent = np.cross(np.cross(x, radial), axis), np.cross(x, radial)
    middle = 0.5 * row.pitch * radial
    # An inner ring turns faster than the cage, and a roller against the cage the other way; with an outer ring its way.
    turning, of_middle = cage * x + sense * roll * axis, np.cross(cage * x, middle)
    linear, angular = np.zeros(3), np.zeros(3)
    for place, weight in zip(y, weights * half, strict=True):
        outside = 0.5 * row.roller_diameter - place * slope
        radii, ring = 0.5 * outside * (gauss + 1.0), 0.5 * outside * weights
        for angle in 2.0 * np.pi * np.arange(8) / 8:
            way = np.cos(angle) * across + np.sin(angle) * tangent
            for radius, thick in zip(radii, ring, strict=True):
                mass = rollers_density * weight * thick * radius * 2.0 * np.pi / 8
                at = place * axis + radius * way
                velocity = of_middle + np.cross(turning, at)
                linear += mass * velocity
                angular += mass * np.cross(middle + at, velocity)
    return linear, angular


@pytest.mark.parametrize(
    ("length", "ring", "sense"), [(8.0, "inner", -1.0), (24.0, "inner", -1.0), (24.0, "outer", 1.0)]
)
def test_speed_loads_a_tapered_roller_with_what_its_points_need(length, ring, sense):
    """The rate of the momenta of all points of the roller, in space; the second one about where the middle is now."""
    taper = 0.05 * length
    cone = nh.Roller(diameter=nh.TabulatedDiameter((-length / 2, length / 2), (12 + taper, 12 - taper)), length=length)
    row = B.TaperedRollerBearing(
        roller=cone, inner=nh.Ring(diameter=88), outer=nh.Ring(diameter=-113.5), rollers=14, contact_angle=0.4,
    )  # fmt: skip
    speed, step = 300.0, 1e-6
    (low, about_low), (high, about_high) = (momenta(row, 7.85e-9, speed, time, sense) for time in (-step, step))
    force = (high - low) / (2.0 * step)
    moment = (about_high - about_low) / (2.0 * step) - np.cross([0.0, 0.5 * row.pitch, 0.0], force)
    loads = row.load_by_speed(speed, ring)
    assert loads[1] == pytest.approx(-force[1], rel=1e-4)
    # A positive moment turns x towards r, about z where the roller is at y.
    # Of the two parts, gyroscopic and of the centrifugal load on its lever, the difference is left under an outer ring.
    largest = abs(loads[1] * row.inertia.middle)
    assert loads[2] == pytest.approx(-moment[2], rel=1e-4, abs=0.0 if ring == "inner" else 1e-4 * largest)
    assert loads[2] < 0.0


@pytest.mark.parametrize("ring", ["inner", "outer"])
def test_cones_that_meet_in_a_point_are_led_around_as_they_roll(ring):
    """Both lines of contact pass through the apex, and on that of the ring at rest the roller does not move.

    Its axis lies halfway between them, and moves half as fast as the line on the other ring, but for 1 / cos(beta).
    """
    beta, outer, apex, half = 0.09, 0.52, 60.0, 7.0
    ends = [2.0 * (apex + y) * np.tan(beta) for y in (half, -half)]
    cone = nh.Roller(diameter=nh.TabulatedDiameter((-half, half), ends), length=2.0 * half)
    pitch = 2.0 * apex * np.sin(outer - beta)
    inner, wide = (pitch * np.tan(angle) / np.tan(outer - beta) for angle in (outer - 2.0 * beta, outer))
    row = B.TaperedRollerBearing(
        roller=cone, inner=nh.Ring(diameter=inner), outer=nh.Ring(diameter=-wide), rollers=10, contact_angle=outer,
        pitch_diameter=pitch,
    )  # fmt: skip
    speed, driven = 1000.0, {"inner": outer - 2.0 * beta, "outer": outer}[ring]
    cage = 0.5 * speed * np.sin(driven) / (np.cos(beta) * np.sin(outer - beta))
    at = 0.5 * pitch - row.inertia.middle * np.sin(outer - beta)
    assert row.load_by_speed(speed, ring)[1] == pytest.approx(row.inertia.mass * cage**2 * at, rel=1e-9)
    motion = row.kinematics(**{f"{ring}_speed": speed})
    assert motion.cage_speed == pytest.approx(cage, rel=1e-9)
    assert abs(motion.roller_speed) == pytest.approx(
        cage * np.sin({"inner": outer, "outer": outer - 2.0 * beta}[ring]) / np.sin(beta), rel=1e-9
    )


def test_a_turning_outer_ring_leads_the_rollers_around_faster():
    """By hand: m omega_c^2 D_pw / 2 with omega_c = omega (1 + D / D_pw) / 2, 102.0 N; of an inner ring 46.6 N."""
    cage = 15e3 * np.pi / 30.0 * 0.5 * (1.0 + 9.0 / 46.5)
    by_hand = 7.85e-9 * 0.25 * np.pi * 81.0 * 10.0 * cage**2 * 0.5 * 46.5
    assert by_hand == pytest.approx(102.0, abs=0.05)
    for ring, load in (("outer", by_hand), ("inner", 46.6)):
        case = nh.BearingCase(nu206(), {"speed": 15000.0}, {"method": "slices"}, {"turning": ring})
        assert case.solve().load[:, 1] == pytest.approx(load, rel=1e-3)
    with pytest.raises(nh.InputError, match="turning = 'both' must be one of"):
        B.solve(nu206(), speed=1e3, turning="both")


def test_rollers_between_washers_are_turned_by_speed():
    """By hand: a roller on a radial axis, led around at half the speed, that rolls on the pitch circle."""
    loads = THRUST.load_by_speed(100.0)
    polar = 0.5 * THRUST.inertia.mass * (0.5 * THRUST.roller_diameter) ** 2
    spin = 0.5 * 100.0 * THRUST.pitch / THRUST.roller_diameter
    assert loads[:2].tolist() == [0.0, 0.0]
    # The angular momentum along r grows along the tangent as the cage turns; y of the roller goes the other way.
    assert loads[2] == pytest.approx(-polar * spin * 50.0, rel=1e-9)
    found = B.solve(THRUST, axial=5e3, speed=3000.0)
    assert found.moment[0, 0] - found.moment[0, 1] == pytest.approx(-found.roller_load[0, 2], rel=1e-6)


def test_barrels_are_held_along_their_axes():
    """On the sphere of the outer ring nothing else does: idle ones slid away, and their bearing had no balance."""
    bearing = barrels(0.2, 10.0, 10.0, 100.2, 14, 0.02)
    load = bearing.load_by_speed(300.0)
    assert load[1] > 0.0
    assert_allclose(load[0] / load[1], np.tan(0.2), rtol=1e-12)
    found = nh.bearing.solve(bearing, radial_displacement=0.04, axial_displacement=0.0, speed=2000.0)
    idle = found.load[:, 0] == 0.0
    assert np.any(idle)
    assert_allclose(found.load[idle, 1], np.hypot(load[0], load[1]) * (2000.0 * np.pi / 30.0 / 300.0) ** 2, rtol=1e-6)


@pytest.mark.parametrize(
    ("name", "of_strips"), [("steel", 0.14), ("silicon-nitride", 0.14), ("aluminium", 0.14), ("POM", 0.25)]
)
def test_slices_are_as_stiff_as_their_materials(name, of_strips):
    """Palmgren's 3.84e-5 Q^0.9 / L^0.8 for steel is 0.39 {4 (1 - nu_1^2) / E_1 + 4 (1 - nu_2^2) / E_2}^0.9 (Harris)."""
    row = nu206(material=nh.MATERIALS[name])
    compliances = [4.0 * (1.0 - each.poisson**2) / each.modulus for each in (row.roller.material, row.inner.material)]
    approach = 0.39 * sum(compliances) ** 0.9 * 3e3**0.9 / 10.0**0.8
    # The standard's constant differs from that of 0.39 by 4 %.
    law = standard_slices(row)
    assert law.loads(np.array([approach]), np.zeros(1)).sum() == pytest.approx(3e3, rel=0.045)
    slices, strips = (B.solve(row, radial=3e3, method=method).displacement[1] for method in ("slices", "strips"))
    assert slices == pytest.approx(strips, rel=of_strips)


def test_slices_say_that_they_take_hollow_rollers_as_solid():
    with pytest.warns(nh.AccuracyWarning, match="treat hollow rollers as solid ones"):
        B.solve(nu206(bore=5.0), radial=3e3, method="slices")


def test_ceramic_rollers_have_their_density():
    """46.6 N of steel rollers at 15,000/min times 3.2 / 7.85: 19.0 N."""
    loads = {
        name: nu206(material=nh.MATERIALS[name]).load_by_speed(15e3 * np.pi / 30.0)[1]
        for name in ("steel", "100Cr6", "R260", "silicon-nitride", "zirconia")
    }
    assert loads["steel"] == loads["100Cr6"] == loads["R260"] == pytest.approx(46.6, abs=0.05)
    assert loads["silicon-nitride"] == pytest.approx(19.0, abs=0.05)
    assert loads["zirconia"] == pytest.approx(46.6 * 6.05 / 7.85, rel=1e-3)
    odd = nu206(material=nh.Material(modulus=50e3, poisson=0.3))
    assert odd.load_by_speed(0.0).tolist() == [0.0, 0.0, 0.0]
    with pytest.raises(nh.InputError, match="density must be given for rollers that are neither of steel"):
        odd.load_by_speed(1.0)


def test_a_pitch_circle_lies_between_the_raceways():
    assert dataclasses.replace(nu206(), pitch_diameter=46.6).pitch == 46.6
    with pytest.raises(nh.InputError, match=r"pitch_diameter = 48\.0 must lie within 2 % .* of the 46\.5 mm between"):
        dataclasses.replace(nu206(), pitch_diameter=48.0)


@pytest.mark.parametrize(("outer", "said"), [(55.5, ""), (55.5184, ""), (55.55, "50.00 µm"), (55.48, "-20.00 µm")])
def test_clearance_that_is_built_into_the_raceways_is_said_not_to_count(outer, said):
    row = dataclasses.replace(nu206(), outer=nh.Ring(diameter=-outer, depth=3.25))
    case = nh.BearingCase(row, {"radial": 1e3}, {"method": "slices"})
    rows = [each for each in summary_rows(case, case.solve()) if each[2].startswith("from the diameters of raceways")]
    assert [each[1] for each in rows] == ([said] if said else [])


def test_what_contacts_warn_of_is_said_once():
    """Only the command line said that rollers reach their sharp ends, or are as thin as their contact is wide."""
    rings = {"inner": nh.Ring(diameter=60.0, depth=0.4), "outer": nh.Ring(diameter=-100.0)}
    bearing = B.CylindricalRollerBearing(roller=nh.Roller(diameter=20.0, length=30.0), **rings, rollers=8)
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        found = B.solve(bearing, radial=20e3)
    assert [str(each.message) for each in said] == [each.headline for each in found.findings]
    kinds = "depth of body b is only", "reaches the sharp end"
    assert [kind for kind in kinds for each in said if kind in str(each.message)] == list(kinds)
    # As single solves have it, away from the ends.
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        alone = nh.solve(bearing.contacts[0], load=found.load[0, 0])
    assert found.max_pressure[0, 0] == pytest.approx(alone.max_pressure, rel=1e-9)
    assert set(alone.warnings[:1]) < {
        sentence.partition(" ring: ")[2].partition(" (And")[0] for sentence in found.warnings
    }


def test_a_force_that_a_single_roller_does_not_feel_has_no_balance():
    """The ring was moved by 1e300 mm, with 1,200 warnings of NumPy."""
    with pytest.raises(nh.ConvergenceError, match="No equilibrium"):
        B.solve(row(rollers=1), radial=(1e3, 500.0))


@pytest.mark.parametrize("clearance", [-3.0, 1.3])
def test_a_clearance_between_rows_is_small_in_the_bearing(clearance):
    """As of each row: displacements of a millimetre are beyond the model."""
    row = nh.read_bearing(Path(__file__).parents[2] / "examples" / "tapered-pair.toml").bearing.bearings[0]
    with pytest.raises(nh.InputError, match=r"^pair\.clearance = \S+ must lie between -1\.23 and 1\.23 mm"):
        nh.bearing.paired(row, "O", 20.0, clearance=clearance)


def test_thrust_bearings_may_be_millimetres_apart():
    """Their rings move along the axis, which changes no direction in which rollers are pressed."""
    assert nh.bearing.paired(washers(), "O", 40.0, clearance=0.5).clearance == 0.5
