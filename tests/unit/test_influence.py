"""Strips added up: coefficients, displacement, terms, points at depth, and what a strip does at its own centre."""

import numpy as np
import pytest
from core_pieces import NO_DEPTH, kernel_of, strips_between
from scipy.integrate import quad

import nonhertz as nh
from nonhertz.bodies.depths import DepthInDiameters, EvenDepth, PointsAtDepth
from nonhertz.bodies.images import FarImages
from nonhertz.bodies.influence import HALF_SPACE, Influence
from nonhertz.native import core
from nonhertz.strip.influence import displacements

EDGES = np.array([-2.0, -1.4, -0.3, 0.1, 0.9, 3.0])
LOW, HIGH = EDGES[:-1], EDGES[1:]
Y = 0.5 * (LOW + HIGH)
M = np.array([0.09, 0.25, 0.0, 0.36, 0.01])
R = np.array([0.02, 0.03, 0.05, 0.025, 0.04])
ACTIVE = np.flatnonzero(M > 0.0)
both_elements = pytest.mark.parametrize("element", [nh.SEMI_ELLIPTIC, nh.PARABOLIC], ids=lambda e: e.name)


def blocks(element, *, m=M, terms=HALF_SPACE, at_depth=NO_DEPTH):
    """[A], [t A'], [B], [t B'] of every active strip at every active centre."""
    return coefficients_between(strips_between(EDGES, at_depth=at_depth), m, ACTIVE, kernel_of(element, terms))


def coefficients_between(strips, m, active, kernel):
    """The same of any strips."""
    return core.coefficients(strips, m, active, kernel)[:, active]


def assert_coefficients(values, expected):
    """Compare with differences of the functions: what the powers of far strips leave out stays below 10^-12."""
    # 10^-12 times the next coefficient of a series, in t B' twelve times that.
    np.testing.assert_allclose(values[:3], expected[:3], rtol=1e-12, atol=2e-13)
    np.testing.assert_allclose(values[3], expected[3], rtol=1e-12, atol=2e-12)


@both_elements
def test_coefficients_are_differences_between_edges(element):
    a = np.sqrt(M[ACTIVE])
    upper = element.functions((HIGH[ACTIVE] - Y[ACTIVE, None]) / a)
    lower = element.functions((LOW[ACTIVE] - Y[ACTIVE, None]) / a)
    assert_coefficients(blocks(element), np.subtract(upper, lower))


@both_elements
@pytest.mark.parametrize("widest", [0.4, 0.01, 1e-6])
@pytest.mark.parametrize(
    "active", [np.arange(12), np.arange(3, 9), np.array([0, 1, 5, 6, 7])], ids=["all", "some", "two runs"]
)
def test_near_and_far_coefficients_are_those_of_the_functions(element, active, widest):
    # The first term moves edges along, the second turns them about a face. The narrower the contact, the more is far.
    edges, m = np.linspace(-6.0, 6.0, 13) ** 3 / 36.0, np.linspace(0.2, 1.0, 12) * widest
    y, terms = 0.5 * (edges[1:] + edges[:-1]), np.array([[1.0, 0.0, 1.0], [-1.0, 13.0, 0.8], [1.0, 26.0, 0.3]])
    strips, kernel = strips_between(edges), kernel_of(element, terms)
    values, expected = coefficients_between(strips, m, active, kernel), np.zeros((4, active.size, active.size))
    a = np.sqrt(m[active])
    for sign, offset, weight in terms:
        ends = [
            element.functions((sign * side[active] + offset - y[active, None]) / a) for side in (edges[1:], edges[:-1])
        ]
        expected += sign * weight * np.subtract(*ends)
    assert_coefficients(values, expected)


@both_elements
def test_a_distant_strip_is_the_point_load_of_boussinesq(element):
    # w = K Q / distance, and its curvature K Q / distance^3; the next terms are (width / distance)^2 = 6e-6.
    m, width, distance = 0.04, 0.5, 200.0
    half = 0.5 * width
    strips = strips_between(np.array([-half, half, distance - half, distance + half]))
    values = coefficients_between(strips, np.full(3, m), np.arange(3), kernel_of(element))
    np.testing.assert_allclose(values[0, 0, 2], width / distance, rtol=1e-5, atol=0.0)
    np.testing.assert_allclose(values[2, 0, 2] / m, width / distance**3, rtol=1e-5, atol=0.0)


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
    assert_coefficients(image, weight * np.subtract(upper, lower))


@both_elements
def test_displacement_does_not_depend_on_how_a_strip_is_cut(element):
    def from_strips(edges):
        r, m = np.full(edges.size - 1, 0.03), np.full(edges.size - 1, 0.2)
        return displacements(Influence(HALF_SPACE), np.array([0.7]), edges, r, m, element)

    whole, parts = from_strips(np.array([-1.0, 2.0])), from_strips(np.array([-1.0, 0.4, 1.1, 2.0]))
    np.testing.assert_allclose(parts, whole, rtol=1e-13, atol=0.0)


# Points at depth


def deep(depth, *, terms=HALF_SPACE, poisson=0.3, far=None):
    return PointsAtDepth(EvenDepth(depth), 1.0 / (2.0 * (1.0 - poisson)), np.atleast_2d(terms), far)


@pytest.mark.parametrize("poisson", [0.0, 0.3, 0.5])
@pytest.mark.parametrize("depth", [0.05, 1.5, 40.0])
def test_displacement_at_depth_is_that_of_point_loads_below_them(depth, poisson):
    # Boussinesq: a load F on the surface moves a point at depth d and distance R = sqrt(s^2 + d^2) by
    # w = F / (4 pi G) (2 (1 - nu) / R + d^2 / R^3) in its own direction.
    material = nh.Material(modulus=206000.0, poisson=poisson)
    shear = material.modulus / (2.0 * (1.0 + poisson))

    def moved(s):
        distance = np.hypot(s, depth)
        return (2.0 * (1.0 - poisson) / distance + depth**2 / distance**3) / (4.0 * np.pi * shear)

    places = np.array([-3.0, -0.3, 0.4])
    expected = [
        [quad(moved, low - y, high - y, points=[0.0] if low < y < high else None, epsabs=0.0, epsrel=1e-13)[0]
         for low, high in zip(LOW, HIGH, strict=True)]
        for y in places
    ]  # fmt: skip
    found = material.compliance * deep(depth, poisson=poisson).displacement(places, EDGES)
    # Differences between edges lose a digit or two where the strip is far away.
    np.testing.assert_allclose(found, expected, rtol=1e-11, atol=0.0)


def test_every_place_has_its_own_depth():
    body = nh.Body(diameter=lambda y: 2.0 + 2.0 * y**2)
    varying, depths = PointsAtDepth(DepthInDiameters(body, 0.5), 1.0 / 1.4, HALF_SPACE), 1.0 + Y**2
    rows = [deep(depth).displacement(np.array([y]), EDGES)[0] for y, depth in zip(Y, depths, strict=True)]
    np.testing.assert_allclose(varying.displacement(Y, EDGES), rows, rtol=1e-13, atol=0.0)


def test_what_far_images_add_goes_by_the_load_of_each_strip():
    # They lift the surface, so they count against the points at depth: line loads, and an integral of what is beyond.
    depth, factor, distance, weight, beyond = 15.0, 1.0 / 1.4, np.array([100.0, 200.0]), np.array([0.5, 0.3]), 250.0

    def moved(s):
        return 1.0 / s - (1.0 + factor * depth**2 / (s**2 + depth**2)) / np.hypot(s, depth)

    rest = 0.3 / 100.0 * quad(moved, beyond, np.inf, epsabs=0.0, epsrel=1e-12)[0]
    far = FarImages(distance, weight, beyond, 100.0)
    with_far, without = (deep(depth, far=images).displacement(Y, EDGES) for images in (far, None))
    expected = np.outer(np.full(Y.size, weight @ moved(distance) + rest), np.diff(EDGES))
    np.testing.assert_allclose(without - with_far, expected, rtol=1e-9, atol=0.0)


def test_without_depths_nothing_moves_there():
    np.testing.assert_array_equal(Influence(HALF_SPACE).at_depth(Y, EDGES), np.zeros((Y.size, Y.size)))


@both_elements
def test_displacements_are_those_of_the_surface_against_the_points_at_depth(element):
    terms = np.vstack([HALF_SPACE, (-1.0, 7.0, 0.7)])
    influence = Influence(terms, (deep(1.5, terms=terms),))
    found = displacements(influence, Y, EDGES, R, M, element)
    expected = blocks(element, terms=terms, at_depth=influence.at_depth(Y, EDGES))[0] @ (R * M)[ACTIVE]
    np.testing.assert_allclose(found[ACTIVE], expected, rtol=1e-13, atol=0.0)
