"""Strips added up: coefficients, displacement, terms, and what a strip does at its own centre."""

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.strip.influence import HALF_SPACE, coefficients, displacement, self_displacement

EDGES = np.array([-2.0, -1.4, -0.3, 0.1, 0.9, 3.0])
LOW, HIGH = EDGES[:-1], EDGES[1:]
Y = 0.5 * (LOW + HIGH)
M = np.array([0.09, 0.25, 0.0, 0.36, 0.01])
R = np.array([0.02, 0.03, 0.05, 0.025, 0.04])
ACTIVE = np.flatnonzero(M > 0.0)
both_elements = pytest.mark.parametrize("element", [nh.SEMI_ELLIPTIC, nh.PARABOLIC], ids=lambda e: e.name)


def blocks(element, *, m=M, terms=HALF_SPACE, low=LOW, high=HIGH, y=Y):
    """[A], [t A'], [B], [t B'] of every active strip at every active centre."""
    values = np.empty((4, ACTIVE.size, ACTIVE.size))
    coefficients(y, low, high, m, ACTIVE, np.atleast_2d(terms), element.table, values)
    return values


@both_elements
def test_coefficients_are_differences_between_edges(element):
    a = np.sqrt(M[ACTIVE])
    upper = element.functions((HIGH[ACTIVE] - Y[ACTIVE, None]) / a)
    lower = element.functions((LOW[ACTIVE] - Y[ACTIVE, None]) / a)
    # Differences of values near 3 that the table holds to 1e-15.
    np.testing.assert_allclose(blocks(element), np.subtract(upper, lower), rtol=1e-12, atol=1e-14)


@both_elements
def test_a_distant_strip_is_the_point_load_of_boussinesq(element):
    # w = K Q / distance, and its curvature K Q / distance^3; the next terms are (width / distance)^2 = 6e-6.
    m, width, distance = 0.04, 0.5, 200.0
    values = np.empty((4, 2, 2))
    y = np.array([0.0, distance])
    coefficients(y, y - 0.5 * width, y + 0.5 * width, np.full(2, m), np.arange(2), HALF_SPACE, element.table, values)
    np.testing.assert_allclose(values[0, 0, 1], width / distance, rtol=1e-5, atol=0.0)
    np.testing.assert_allclose(values[2, 0, 1] / m, width / distance**3, rtol=1e-5, atol=0.0)


@both_elements
def test_derivatives_by_the_squared_half_width_are_those_of_the_values(element):
    # Central differences of a smooth function with a relative step of 1e-5: 1e-10 off, and rounding 1e-11.
    step = 1e-5
    a, ta, _, tb = blocks(element)
    up, down = blocks(element, m=M * (1.0 + step)), blocks(element, m=M * (1.0 - step))
    of_displacement = ((1.0 + step) * up[0] - (1.0 - step) * down[0]) / (2.0 * step)
    np.testing.assert_allclose(a - 0.5 * ta, of_displacement, rtol=1e-7, atol=1e-10)
    of_curvature = (up[2] - down[2]) / (2.0 * step)
    np.testing.assert_allclose(-0.5 * tb, of_curvature, rtol=1e-7, atol=1e-10)


@both_elements
def test_an_image_is_the_mirrored_strip(element):
    # A face at f sends the strip to 2 f - high ... 2 f - low with the same load and half-width.
    face, weight = 3.5, 0.7
    image = blocks(element, terms=(-1.0, 2.0 * face, weight))
    a = np.sqrt(M[ACTIVE])
    upper = element.functions((2.0 * face - LOW[ACTIVE] - Y[ACTIVE, None]) / a)
    lower = element.functions((2.0 * face - HIGH[ACTIVE] - Y[ACTIVE, None]) / a)
    # Differences of values near 3 that the table holds to 1e-15.
    np.testing.assert_allclose(image, weight * np.subtract(upper, lower), rtol=1e-12, atol=1e-14)


@both_elements
def test_terms_add_up(element):
    image = (-1.0, 7.0, 0.7)
    together = blocks(element, terms=np.vstack([HALF_SPACE, image]))
    np.testing.assert_allclose(together, blocks(element) + blocks(element, terms=image), rtol=1e-13, atol=1e-14)


@both_elements
def test_displacement_is_the_coefficients_times_the_loads(element):
    terms = np.vstack([HALF_SPACE, (-1.0, 7.0, 0.7)])
    expected = blocks(element, terms=terms)[0] @ (R * M)[ACTIVE]
    found = [displacement(y, LOW, HIGH, R, M, ACTIVE, terms, element.table) for y in Y[ACTIVE]]
    np.testing.assert_allclose(found, expected, rtol=1e-13, atol=0.0)


@both_elements
def test_displacement_does_not_depend_on_how_a_strip_is_cut(element):
    def from_strips(edges):
        n = edges.size - 1
        r, m, active = np.full(n, 0.03), np.full(n, 0.2), np.arange(n)
        return displacement(0.7, edges[:-1], edges[1:], r, m, active, HALF_SPACE, element.table)

    whole, parts = from_strips(np.array([-1.0, 2.0])), from_strips(np.array([-1.0, 0.4, 1.1, 2.0]))
    np.testing.assert_allclose(parts, whole, rtol=1e-13, atol=0.0)


@both_elements
def test_a_strip_at_its_own_centre(element):
    width, m = 0.8, 0.36
    value, slope = self_displacement(width, m, element.table)
    a, ta, *_ = element.functions(0.5 * width / np.sqrt(m))
    np.testing.assert_allclose([value, slope], [2.0 * a, 2.0 * a - ta], rtol=1e-13, atol=0.0)
    # m [A](m) is concave and rises from zero: what the Newton loop relies on when a strip enters or leaves.
    m = np.geomspace(1e-6, 1e6, 200)
    values, slopes = np.array([self_displacement(width, k, element.table) for k in m]).T
    assert np.all(np.diff(m * values) > 0.0)
    assert np.all(np.diff(slopes) < 0.0)
