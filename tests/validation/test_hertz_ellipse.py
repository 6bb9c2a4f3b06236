"""Elliptical contacts solved on strips against Hertz: closed form, published numbers, and literal figures.

A semi-ellipsoid of pressure is made of semi-elliptic strips, so these converge to the exact solution; the
paper's parabolic strips have a bias of their own that no refinement removes.
"""

from dataclasses import dataclass

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.model.profile import Profile

STEEL = nh.Material(modulus=207000, poisson=0.3)
# Rx 10, Ry 100, 1000 N, steel: from Johnson 1985, Eqs. (4.25)-(4.28), with mpmath in 30 digits.
LITERAL = {
    "half_width": 0.26197489937219,
    "half_length": 1.17874225447462,
    "max_pressure": 1546.18997154843,
    "approach": 0.0103787089074731,
}


@dataclass(frozen=True)
class Parabola(Profile):
    """The relief that Hertz's theory means: y^2 / (2 R)."""

    radius: float

    def relief(self, y):
        return np.asarray(y, dtype=float) ** 2 / (2.0 * self.radius)


def hertz(*, radius_x=10.0, radius_y=100.0, load=1000.0, material=STEEL):
    return nh.hertz.point_contact(radius_x=radius_x, radius_y=radius_y, load=load, compliance=2.0 * material.compliance)


def solved(exact, *, reach=None, material=STEEL, **arguments):
    """Solve the same contact on strips, the body ``reach`` half-lengths of the contact to either side."""
    body = nh.Body(
        diameter=2.0 * exact.radius_x,
        length=None if reach is None else 2.0 * reach * exact.half_length,
        profile=Parabola(exact.radius_y),
        material=material,
        side_faces="none",
    )
    grid = {"accuracy": 1e-5} if arguments.get("strips", "auto") == "auto" else {}
    return nh.solve(nh.Contact(body, nh.Plate(material=material)), **({"load": exact.load} | grid | arguments))


def errors(solution, exact):
    """Relative errors of greatest pressure, greatest half-width and approach."""
    return np.array(
        [
            solution.max_pressure / exact.max_pressure - 1.0,
            solution.half_width.max() / exact.half_width - 1.0,
            solution.approach / exact.approach - 1.0,
        ]
    )


# Semi-elliptic


def test_closed_form_has_the_literal_numbers():
    exact = hertz()
    for name, value in LITERAL.items():
        np.testing.assert_allclose(getattr(exact, name), value, rtol=1e-12, atol=0.0, err_msg=name)


def test_forty_one_equal_strips():
    solution = solved(hertz(), reach=1.3, strips=41)
    found = [solution.half_width.max(), solution.max_pressure, solution.approach]
    expected = [LITERAL[name] for name in ("half_width", "max_pressure", "approach")]
    np.testing.assert_allclose(found, expected, rtol=2e-4, atol=0.0)  # the figure to reach


def test_automatic_grid():
    solution = solved(hertz())
    found = [solution.half_width.max(), solution.max_pressure, solution.approach]
    expected = [LITERAL[name] for name in ("half_width", "max_pressure", "approach")]
    np.testing.assert_allclose(found, expected, rtol=5e-5, atol=0.0)  # the figure to reach


@pytest.mark.parametrize("radius_y", [15.0, 30.0, 100.0, 1e3, 1e4, 1e5])
@pytest.mark.parametrize("load", [1.0, 1e4])
def test_automatic_grid_for_any_ellipticity_and_load(radius_y, load):
    exact = hertz(radius_y=radius_y, load=load)
    np.testing.assert_allclose(errors(solved(exact), exact), 0.0, rtol=0.0, atol=5e-5)


# In the middle the figure for the greatest pressure holds everywhere; strips near the end see it by their width.
@pytest.mark.parametrize(("reach", "rtol"), [(0.7, 3e-4), (0.9, 3e-3)])
@pytest.mark.parametrize("radius_y", [30.0, 1e3])
def test_pressure_and_half_width_along_the_line(radius_y, reach, rtol):
    exact = hertz(radius_y=radius_y)
    solution = solved(exact)
    inside = np.abs(solution.y) < reach * exact.half_length
    y = solution.y[inside]
    np.testing.assert_allclose(solution.centre_pressure[inside], exact.pressure(y), rtol=rtol, atol=0.0)
    np.testing.assert_allclose(solution.half_width[inside], exact.half_width_at(y), rtol=rtol, atol=0.0)
    np.testing.assert_allclose(solution.line_load[inside], exact.line_load_at(y), rtol=2.0 * rtol, atol=0.0)


@pytest.mark.parametrize("radius_y", [30.0, 1e3])
def test_line_load_up_to_the_ends(radius_y):
    exact = hertz(radius_y=radius_y)
    solution = solved(exact)
    # The strip that holds the end has the mean load over its width, a few thousandths off.
    off = np.abs(solution.line_load - exact.line_load_at(solution.y))
    assert np.max(off) < 0.01 * exact.line_load_at(0.0)


@pytest.mark.parametrize("radius_y", [30.0, 1e3])
def test_ends_of_the_contact(radius_y):
    exact = hertz(radius_y=radius_y)
    ((low, high),) = solved(exact).contact_y
    # To a strip at the end, 1 % of the half-length.
    np.testing.assert_allclose([low, high], [-exact.half_length, exact.half_length], rtol=0.01, atol=0.0)


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


def test_the_approach_gives_the_load():
    exact = hertz()
    solution = solved(exact, load=None, approach=exact.approach)
    # Q grows with delta^(3/2): half again the error of the approach.
    np.testing.assert_allclose(solution.load, exact.load, rtol=1e-4, atol=0.0)


def test_unlike_bodies_share_the_same_ellipse():
    # Half of each curvature and compliance on each body, one concave: only the sums matter to Hertz.
    other = nh.Material(modulus=STEEL.modulus / 3.0, poisson=0.3)
    a = nh.Body(diameter=10.0, profile=Parabola(40.0), material=other)
    b = nh.Ring(diameter=-20.0, profile=Parabola(-200.0 / 3.0), material=STEEL)
    exact = nh.hertz.point_contact(radius_x=10, radius_y=100, load=1000, compliance=4.0 * STEEL.compliance)
    solution = nh.solve(nh.Contact(a, b), load=1000, accuracy=1e-5)
    np.testing.assert_allclose(errors(solution, exact), 0.0, rtol=0.0, atol=5e-5)


# Parabolic


@pytest.mark.parametrize("strips", [41, "auto"])
def test_bias_of_the_parabola(strips):
    # docs/explain/theory.md: p0 +0.61 %, b +0.65 %, delta -1.4 %, to the digits given.
    exact = hertz()
    bias = 100.0 * errors(solved(exact, reach=1.3, strips=strips, element=nh.PARABOLIC), exact)
    np.testing.assert_allclose(bias[:2], [0.61, 0.65], rtol=0.0, atol=0.006)
    assert abs(bias[2] + 1.4) < 0.05


# A separate implementation of the parabolic element, 41 strips over |y| <= 1.35 a: E = 206000, nu = 0.3,
# Rx = 10, Q = 2000. a/b, Ry, Hertz's a, b, p0, delta [um], and the element's errors in p0, b, delta [%].
SEPARATE = [
    (3, 53.0, 1.1247, 0.37491, 2264.7, 18.968, 0.72, 0.79, -1.64),
    (5, 118.3, 1.5987, 0.31974, 1868.2, 15.917, 0.60, 0.63, -1.39),
    (10, 365.4, 2.5554, 0.25554, 1462.4, 12.201, 0.47, 0.47, -1.13),
    (20, 1176.5, 4.0666, 0.20333, 1154.9, 9.0956, 0.38, 0.37, -0.95),
    (50, 5810.0, 7.4979, 0.14996, 849.3, 5.9623, 0.29, 0.29, -0.79),
]


@pytest.mark.parametrize("row", SEPARATE, ids=lambda row: f"a over b {row[0]}")
def test_errors_of_the_parabola_in_a_separate_implementation(row):
    ellipticity, radius_y, half_length, half_width, pressure, approach, *expected = row
    material = nh.Material(modulus=206000, poisson=0.3)
    exact = hertz(radius_y=radius_y, load=2000.0, material=material)
    found = [exact.ellipticity, exact.half_length, exact.half_width, exact.max_pressure, 1e3 * exact.approach]
    # Ry is given to four digits, as rounded from the ellipticity.
    published = [ellipticity, half_length, half_width, pressure, approach]
    np.testing.assert_allclose(found, published, rtol=5e-4, atol=0.0)
    solution = solved(exact, reach=1.35, strips=41, element=nh.PARABOLIC, material=material)
    np.testing.assert_allclose(100.0 * errors(solution, exact), expected, rtol=0.0, atol=0.006)  # two decimals


def test_shape_of_the_parabola_in_a_separate_implementation():
    # The same, a/b = 10: pressure over Hertz's p0 at four places (Hertz himself: .9165 .8000 .6000 .4359).
    material = nh.Material(modulus=206000, poisson=0.3)
    exact = hertz(radius_y=365.4, load=2000.0, material=material)
    solution = solved(exact, reach=1.35, strips=41, element=nh.PARABOLIC, material=material)
    places = np.array([0.4, 0.6, 0.8, 0.9]) * exact.half_length
    shape = np.interp(places, solution.y, solution.centre_pressure) / exact.max_pressure
    np.testing.assert_allclose(shape, [0.9191, 0.7993, 0.5920, 0.4159], rtol=0.0, atol=2e-4)
