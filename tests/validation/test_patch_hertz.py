"""Rectangles against Hertz's closed forms: the ellipse, the circle, the line contact between mirrored faces."""

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.hertz import line_contact, plane_strain_cylinder_compression, point_contact

STEEL = nh.Material(modulus=206000.0, poisson=0.3)
UNBOUNDED = nh.Contact(nh.Body(diameter=20, material=STEEL), nh.Plate(material=STEEL))


def paraboloid(radius_x, radius_y):
    return lambda x, y: x**2 / (2.0 * radius_x) + y**2 / (2.0 * radius_y)


def at_the_middle(solution, values):
    return float(np.interp(0.0, solution.y, values))


@pytest.mark.parametrize("radius_y", [10.0, 100.0, 5810.0], ids=["circle", "a / b = 4.5", "a / b = 50"])
def test_the_ellipse(radius_y):
    exact = point_contact(load=2000.0, radius_x=10.0, radius_y=radius_y, compliance=UNBOUNDED.compliance)
    found = nh.patch.solve(UNBOUNDED, load=2000.0, gap=paraboloid(10.0, radius_y), cells=(128, 256))
    # What the package asks of itself is 2e-4; the ellipse has no sharp end, and approach and middle do better.
    np.testing.assert_allclose(found.approach, exact.approach, rtol=5e-5, atol=0.0)
    np.testing.assert_allclose(at_the_middle(found, found.centre_pressure), exact.max_pressure, rtol=5e-5, atol=0.0)
    np.testing.assert_allclose(found.max_pressure, exact.max_pressure, rtol=2e-4, atol=0.0)
    # The footprint is one of cells: its edge is known to a sixth of one, 1/55 of the half-width.
    np.testing.assert_allclose(at_the_middle(found, found.half_width), exact.half_width, rtol=3e-3, atol=0.0)
    area = np.pi * exact.half_width * exact.half_length
    np.testing.assert_allclose(found.contact_area, area, rtol=0.02, atol=0.0)


def test_pressure_everywhere():
    exact = point_contact(load=1000.0, radius_x=10.0, radius_y=100.0, compliance=UNBOUNDED.compliance)
    found = nh.patch.solve(UNBOUNDED, load=1000.0, gap=paraboloid(10.0, 100.0), cells=(128, 256))
    expected = exact.pressure(found.y[None, :], found.x[:, None])
    # Away from the edge, where the root of the distance is not resolved.
    inside = expected > 0.3 * exact.max_pressure
    np.testing.assert_allclose(found.pressure[inside], expected[inside], rtol=0.0, atol=1e-3 * exact.max_pressure)
    along = np.abs(found.y) < 0.9 * exact.half_length
    np.testing.assert_allclose(
        found.line_load[along], exact.line_load_at(found.y[along]), rtol=0.0, atol=1e-3 * exact.line_load_at(0.0)
    )


def test_pressed_by_approach_it_bears_the_load():
    exact = point_contact(approach=0.01, radius_x=10.0, radius_y=100.0, compliance=UNBOUNDED.compliance)
    found = nh.patch.solve(UNBOUNDED, approach=0.01, gap=paraboloid(10.0, 100.0), cells=(128, 256))
    np.testing.assert_allclose(found.load, exact.load, rtol=5e-5, atol=0.0)


def test_tilt_shifts_a_parabola():
    # gamma y - y^2 / (2 Ry) is a parabola about gamma Ry, higher by gamma^2 Ry / 2.
    exact = point_contact(load=1000.0, radius_x=10.0, radius_y=100.0, compliance=UNBOUNDED.compliance)
    tilt = 2e-3
    found = nh.patch.solve(UNBOUNDED, load=1000.0, tilt=tilt, gap=paraboloid(10.0, 100.0), cells=(128, 256))
    np.testing.assert_allclose(found.approach, exact.approach - 0.5 * tilt**2 * 100.0, rtol=5e-5, atol=0.0)
    np.testing.assert_allclose(found.moment, 1000.0 * tilt * 100.0, rtol=1e-4, atol=0.0)


@pytest.mark.parametrize("images", [4, "series"])
def test_two_equal_rollers_with_coincident_ends_are_in_plane_strain(images):
    # Companion notes 9.4: mirrored about both ends, the pressure is that of a line without ends, and measured against
    # the depth of plane strain the approach is Johnson's (5.57), twice 12.04 micrometres.
    roller = nh.Roller(diameter=10, length=10, material=STEEL, side_faces="mirror", images=images)
    contact = nh.Contact(roller, roller)
    exact = line_contact(line_load=1000.0, radius=2.5, compliance=contact.compliance)
    approach = 2.0 * plane_strain_cylinder_compression(exact, diameter=10.0, material=STEEL)
    np.testing.assert_allclose(approach, 24.0803e-3, rtol=1e-5, atol=0.0)
    found = nh.patch.solve(contact, load=10e3, cells=(128, 32))
    # What four images leave of the series, 2.5e-4 (9.4: 24.0871); with all of them, the cells.
    np.testing.assert_allclose(found.approach, approach, rtol=2e-5 if images == "series" else 3e-4, atol=0.0)
    np.testing.assert_allclose(found.centre_pressure, exact.max_pressure, rtol=5e-5, atol=0.0)
    np.testing.assert_allclose(found.half_width, exact.half_width, rtol=1e-3, atol=0.0)
    assert found.warnings == ()
