"""Whole bearings against Stribeck and Sjovall, the slices of ISO/TS 16281, MASTA, and contacts solved one by one."""

import warnings

import numpy as np
import pytest
from numpy.testing import assert_allclose

import nonhertz as nh
from nonhertz.bearing.equilibrium import Joint, System, balanced
from nonhertz.bearing.laws import Slices
from nonhertz.bearing.section import raceway_motion, ring_motion
from nonhertz.verify import known_bearings as known

RADIAL = np.array([False, True, True, False, False])
STIFFNESS, EXPONENT = 35948.0, 10.0 / 9.0


def row(rollers, pitch, law, angle=0.0, clearance=0.0):
    at, gap = 2.0 * np.pi * np.arange(rollers) / rollers, np.full(rollers, 0.25 * clearance)
    joints = (
        Joint(True, raceway_motion(angle, inner=True), gap, law, 0),
        Joint(False, raceway_motion(angle, inner=False), gap, law, 1),
    )
    return System(ring_motion(at, (0.0, 0.5 * pitch)), joints, np.zeros((rollers, 3)), 5.0)


def laminae(length, count, relief=None):
    """Slices of which two in series have the stiffness of the standard."""
    y = (np.arange(count) + 0.5) * length / count - 0.5 * length
    drop = np.zeros(count) if relief is None else relief(y)
    return Slices(y, drop, STIFFNESS * length ** (8.0 / 9.0) / count * 2.0**EXPONENT, EXPONENT)


# Stribeck and Sjovall: integrals over very many rollers


@pytest.mark.parametrize(("exponent", "stribeck", "sjovall"), known.SPREADS)
@pytest.mark.parametrize("angle", [0.0, 0.3])
def test_without_clearance_loads_are_those_of_stribeck_and_sjovall(exponent, stribeck, sjovall, angle):
    rollers = row(360, 4000.0, Slices(np.zeros(1), np.zeros(1), 3e5, exponent), angle)
    states = balanced(rollers, RADIAL, np.array([[0.0, 1e5, 0.0, 0.0, 0.0]]), np.zeros((1, 5)), 0.01)
    weighted, plain = (known.zone_integral(exponent, weighted=each) for each in (True, False))
    factor = states.rollers.load.max() * 360 * np.cos(angle) / 1e5
    assert factor == pytest.approx(1.0 / weighted, rel=1e-4)
    assert factor == pytest.approx(stribeck, rel=1e-3)
    if angle:
        ratio = states.force[0, 0] / (1e5 * np.tan(angle))
        assert ratio == pytest.approx(plain / weighted, rel=1e-4)
        assert ratio == pytest.approx(sjovall, rel=1e-3)


# The example of ISO/TS 16281's slices


@pytest.mark.parametrize("case", known.LAMINA_CASES, ids=lambda case: case.name)
def test_the_standards_example_to_all_digits(case):
    relief = known.StandardLogarithm().relief if case.profiled else None
    rollers = row(14, 65.0, laminae(9.6, 41, relief), clearance=case.clearance)
    target = np.array([[0.0, known.LAMINA_LOAD, 0.0, 0.0, case.tilt]])
    states = balanced(rollers, RADIAL, target, np.zeros((1, 5)), 0.01)
    load = states.rollers.load[0, :, 0]
    assert_allclose(load[: len(case.loads)], case.loads, atol=0.006)
    assert_allclose(load[1:], load[:0:-1], atol=1e-6)
    if case.displacement is not None:
        digit = 6e-5 if case.displacement > 9.0 else 6e-6
        assert 1e3 * states.ring[0, 1] == pytest.approx(case.displacement, abs=digit)


# The last digit of three of those with the edge function was not reproduced.
@pytest.mark.parametrize("case", known.LAMINA_CASES, ids=lambda case: case.name)
def test_the_standards_example_has_these_lives(case):
    found = nh.bearing.solve(case.bearing, radial=known.LAMINA_LOAD, tilt=case.tilt, method="slices")
    assert_allclose(found.load[: len(case.loads), 0], case.loads, atol=0.006)
    none, standard = (nh.bearing.assess(found, edge_stress=each).reference for each in ("none", "standard"))
    assert none == pytest.approx(case.life, rel=1e-5, abs=0.5 if case.life > 1e4 else 0.06)
    assert standard == pytest.approx(case.edged_life, rel=8e-5)
    assert nh.bearing.assess(found).basic == pytest.approx(known.LAMINA_BASIC_LIFE, abs=0.05)


# NSK HR30306J as MASTA solved it, quoted in the tests of a public program

MASTA = np.array(known.MASTA.loads)
LOADS = {"radial": known.MASTA.radial, "axial": known.MASTA.axial}


def test_a_tapered_bearing_by_slices_has_the_loads_of_masta():
    found = nh.bearing.solve(known.hr30306j(), **LOADS, method="slices")
    assert_allclose(found.load[:6, 0], MASTA, rtol=3e-3, atol=1.0)
    assert 1e3 * found.displacement[1] == pytest.approx(known.SLICES_DISPLACEMENT, abs=6e-3)


def test_a_tapered_bearing_has_the_ratings_of_masta():
    """Its life by these laminae is 19.43, against 21.66 and 20.71 here, and its factor 1.154, 1.139 or 1.18."""
    found = nh.bearing.solve(known.hr30306j(), **LOADS, method="slices", laminae=known.MASTA.laminae)
    catalogue = {"dynamic": known.MASTA.dynamic, "static": known.MASTA.static, "laminae": known.MASTA.laminae}
    plain = nh.bearing.assess(found, **catalogue, edge_stress="none")
    assert plain.reference == pytest.approx(known.SLICES_LIFE, abs=0.005)
    assert 1e-3 * plain.rating.inner == pytest.approx(14.16, abs=0.006)
    assert 1e-3 * plain.rating.outer == pytest.approx(24.20, abs=0.02)
    assert 1e-3 * plain.rating.fatigue_limit == pytest.approx(7.317, abs=5e-4)
    assert plain.static_safety == pytest.approx(2.0)
    oiled = nh.bearing.assess(found, **catalogue, speed=known.MASTA.speed, viscosity=known.MASTA.viscosity)
    assert oiled.reference == pytest.approx(known.SLICES_EDGED_LIFE, abs=0.005)
    assert oiled.viscosity_ratio == pytest.approx(3.413, abs=5e-4)
    assert oiled.contamination == pytest.approx(0.8174, abs=5e-5)
    assert oiled.life_factor == pytest.approx(known.SLICES_FACTOR, abs=0.005)
    assert oiled.modified == pytest.approx(oiled.reference * oiled.life_factor)
    # The formulas' own ratings are within 1.4 % of the catalogue's.
    assert nh.bearing.rating(known.hr30306j()).dynamic == pytest.approx(59.5e3, rel=0.014)
    assert nh.bearing.rating(known.hr30306j()).static == pytest.approx(60e3, rel=0.014)


def test_a_tapered_bearing_by_strips_has_nearly_these_loads():
    """Strips know of the inner ring's smaller contact angle, of the rib, and of how the bodies give way."""
    found = nh.bearing.solve(known.hr30306j(), **LOADS)
    assert_allclose(found.load[:4, 1], MASTA[:4], rtol=0.02)
    assert found.load[5].max() == 0.0
    # At every loaded roller the rib bears what the contact angles leave of the axial loads.
    inner, outer = found.contact_angle[0]
    left = found.load[:, 1] * np.sin(outer) - found.load[:, 0] * np.sin(inner)
    assert_allclose(found.rib_load[:5, 0], left[:5] / 0.99, rtol=0.02)


# NU 206 by hand


@pytest.mark.slow
def test_nu_206_has_the_loads_of_contacts_solved_one_by_one():
    bearing = known.nu206()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", nh.AccuracyWarning)
        displacement, loads = known.by_hand(bearing, known.NU206_LOAD, known.NU206_TILT)
    found = nh.bearing.solve(bearing, radial=known.NU206_LOAD, tilt=known.NU206_TILT)
    assert_allclose(found.load[:4, 0], loads, rtol=1e-4, atol=0.1)
    assert found.displacement[1] == pytest.approx(displacement, rel=1e-4)


def test_pressures_are_those_of_the_contact_alone():
    found = nh.bearing.solve(known.nu206(), radial=known.NU206_LOAD, tilt=known.NU206_TILT)
    contact = found.contact(0, "inner")
    assert contact.load == pytest.approx(found.load[0, 0], rel=1e-4)
    assert contact.moment == pytest.approx(found.moment[0, 0], rel=1e-3)
    assert found.max_pressure[0, 0] == contact.max_pressure
    assert found.max_pressure[0, 0] == found.max_pressure.max()
    assert found.contact(6) is None
    assert found.max_pressure[6].max() == 0.0
    assert np.isnan(found.max_pressure_y[6]).all()


# Rollers that stand at the edge of the load zone without load


@pytest.mark.parametrize("turned", [0.0, 0.25 * np.pi, 0.5 * np.pi, np.pi])
@pytest.mark.parametrize("clearance", [0.0, 1e-9])
@pytest.mark.parametrize("method", ["slices", "strips"])
def test_rollers_at_the_edge_of_the_load_zone_have_no_part_in_the_stiffness(method, clearance, turned):
    """An overlap of 1e-19 mm had: 362.90 N/um by slices, 382.6 to 580.7 by strips, by how the load was turned."""
    rings = {"inner": nh.Ring(diameter=60.0), "outer": nh.Ring(diameter=-100.0)}
    roller = nh.Roller(diameter=20.0, length=30.0)
    bearing = nh.bearing.CylindricalRollerBearing(roller=roller, **rings, rollers=8, clearance=clearance)
    along, across = np.array([[np.cos(turned), np.sin(turned)], [-np.sin(turned), np.cos(turned)]])
    found = nh.bearing.solve(bearing, radial=500.0 * along, method=method)
    moved = found.displacement[1:3] @ along
    # Three rollers bear, at 0 and 45 degrees to the load: by the slices' formula, or contacts solved one by one.
    if method == "slices":
        k = STIFFNESS * 30.0 ** (8.0 / 9.0)
        pressed = np.array([1.0, 0.5**0.5]) * moved - 0.5 * clearance
        load, slope = k * pressed**EXPONENT, EXPONENT * k * pressed ** (EXPONENT - 1.0)
    else:
        pairs = [[nh.solve(c, load=q) for c in bearing.contacts] for q in np.sort(found.load[:, 0])[[-1, -2]]]
        load = np.array([inner.load for inner, _ in pairs])
        slope = np.array([1.0 / sum(1.0 / each.stiffness[0, 0] for each in pair) for pair in pairs])
    assert_allclose(load[0] + 2.0**0.5 * load[1], 500.0, rtol=1e-6)
    stiffness = found.stiffness[1:3, 1:3]
    off = 1e-8 if method == "slices" else 3e-4
    assert_allclose(along @ stiffness @ along, slope[0] + slope[1], rtol=off)
    assert_allclose(across @ stiffness @ across, slope[1], rtol=off)
    # Two more bear where the ring moves across by 10 nm, one on either side.
    beside = np.flatnonzero(np.abs(np.cos(found.angle - turned)) < 1e-9)
    assert found.edge_rollers.tolist() == beside.tolist()
    if method == "slices" and not turned:
        assert_allclose(found.edge_stiffness[2], slope[1] + k * (1e-5 - 0.5 * clearance) ** EXPONENT / 1e-5, rtol=1e-4)
        assert_allclose(stiffness[1, 1], 356.01e3, rtol=1e-5)
        assert_allclose(stiffness[0, 0], 725.99e3, rtol=1e-5)
