"""Elliptical contacts solved on strips against Hertz: any ellipticity and load, along the line, tilted, unlike bodies.

A semi-ellipsoid of pressure is made of semi-elliptic strips, so these converge to the exact solution; the
paper's parabolic strips have a bias of their own that no refinement removes.
"""

import numpy as np
import pytest

import nonhertz as nh
from claims.hertz import Parabola, errors

STEEL = nh.Material(modulus=207000, poisson=0.3)


def hertz(*, radius_y=100.0, load=1000.0):
    return nh.hertz.point_contact(radius_x=10.0, radius_y=radius_y, load=load, compliance=2.0 * STEEL.compliance)


def solved(exact, tilt=0.0):
    """Solve the same contact on strips."""
    profile = Parabola(exact.radius_y)
    body = nh.Body(diameter=2.0 * exact.radius_x, profile=profile, material=STEEL, side_faces="none")
    return nh.solve(nh.Contact(body, nh.Plate(material=STEEL)), load=exact.load, tilt=tilt, accuracy=1e-5)


@pytest.mark.parametrize("radius_y", [15.0, 30.0, 100.0, 1e3, 1e4, 1e5])
@pytest.mark.parametrize("load", [1.0, 1e4])
def test_automatic_grid_for_any_ellipticity_and_load(radius_y, load):
    exact = hertz(radius_y=radius_y, load=load)
    np.testing.assert_allclose(errors(solved(exact), exact), 0.0, rtol=0.0, atol=5e-5)


@pytest.mark.parametrize("radius_y", [30.0, 1e3])
def test_along_the_line_and_at_its_ends(radius_y):
    exact = hertz(radius_y=radius_y)
    solution = solved(exact)
    # In the middle the figure for the greatest pressure holds everywhere; strips near the end see it by their width.
    for reach, rtol in ((0.7, 3e-4), (0.9, 3e-3)):
        inside = np.abs(solution.y) < reach * exact.half_length
        y = solution.y[inside]
        np.testing.assert_allclose(solution.centre_pressure[inside], exact.pressure(y), rtol=rtol, atol=0.0)
        np.testing.assert_allclose(solution.half_width[inside], exact.half_width_at(y), rtol=rtol, atol=0.0)
        np.testing.assert_allclose(solution.line_load[inside], exact.line_load_at(y), rtol=2.0 * rtol, atol=0.0)
    # The strip that holds the end has the mean load over its width, a few thousandths off.
    off = np.abs(solution.line_load - exact.line_load_at(solution.y))
    assert np.max(off) < 0.01 * exact.line_load_at(0.0)
    # To a strip at the end, 1 % of the half-length.
    ends = [[-exact.half_length, exact.half_length]]
    np.testing.assert_allclose(solution.contact_y, ends, rtol=0.01, atol=0.0)


@pytest.mark.parametrize("slope", [-2e-3, 5e-4])
def test_a_tilted_ellipse_is_a_shifted_one(slope):
    # delta + gamma y - y^2/(2R) = (delta + gamma^2 R/2) - (y - gamma R)^2/(2R).
    exact = hertz(radius_y=1000.0)
    solution = solved(exact, tilt=slope)
    shift = slope * exact.radius_y
    found = [solution.max_pressure, solution.half_width.max(), solution.approach + 0.5 * slope * shift]
    expected = [exact.max_pressure, exact.half_width, exact.approach]
    np.testing.assert_allclose(found, expected, rtol=1e-4, atol=0.0)  # no strip is centred on the summit
    # The load acts at the shifted centre, to a ten-thousandth of the contact's half-length.
    assert abs(solution.moment / solution.load - shift) < 1e-4 * exact.half_length


def test_unlike_bodies_share_the_same_ellipse():
    # Half of each curvature and compliance on each body, one concave: only the sums matter to Hertz.
    other = nh.Material(modulus=STEEL.modulus / 3.0, poisson=0.3)
    a = nh.Body(diameter=10.0, profile=Parabola(40.0), material=other)
    b = nh.Ring(diameter=-20.0, profile=Parabola(-200.0 / 3.0), material=STEEL)
    exact = nh.hertz.point_contact(radius_x=10, radius_y=100, load=1000, compliance=4.0 * STEEL.compliance)
    solution = nh.solve(nh.Contact(a, b), load=1000, accuracy=1e-5)
    np.testing.assert_allclose(errors(solution, exact), 0.0, rtol=0.0, atol=5e-5)
