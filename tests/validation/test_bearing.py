"""Whole bearings: what no claim says of them."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

import nonhertz as nh
from claims import known_bearings as known

STIFFNESS, EXPONENT = 35948.0, 10.0 / 9.0
LOADS = {"radial": known.MASTA.radial, "axial": known.MASTA.axial}


def test_a_tapered_bearing_has_the_safety_of_its_catalogue():
    catalogue = {"dynamic": known.MASTA.dynamic, "static": known.MASTA.static}
    found = nh.bearing.assess(nh.bearing.solve(known.hr30306j(), **LOADS, method="slices"), **catalogue)
    assert found.static_safety == pytest.approx(2.0)
    # The formulas' own ratings are within 1.4 % of the catalogue's.
    own = nh.bearing.rating(known.hr30306j())
    assert (own.dynamic, own.static) == pytest.approx((59.5e3, 60e3), rel=0.014)


def test_the_rib_of_a_tapered_bearing_bears_what_the_contact_angles_leave():
    found = nh.bearing.solve(known.hr30306j(), **LOADS)
    assert found.load[5].max() == 0.0
    # At every loaded roller the rib bears what the contact angles leave of the axial loads.
    inner, outer = found.contact_angle[0]
    left = found.load[:, 1] * np.sin(outer) - found.load[:, 0] * np.sin(inner)
    assert_allclose(found.rib_load[:5, 0], left[:5] / 0.99, rtol=0.02)


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
