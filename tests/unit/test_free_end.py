"""What a free side face adds to strips: the table against direct integration, and where its parts meet."""

import math

import numpy as np
import pytest
from core_pieces import strips_between

import nonhertz as nh
from nonhertz.bodies.influence import HALF_SPACE, FreeSide, Influence
from nonhertz.bodies.quarter_space import free_face
from nonhertz.native import core
from nonhertz.strip import free_end
from nonhertz.strip.free_end import CLOSE, face_table
from nonhertz.strip.influence import kernel_of

ELEMENTS = [nh.SEMI_ELLIPTIC, nh.PARABOLIC]
H, RHO_H, C, RHO_C = range(4)


def added(u, inner, outer, element=nh.SEMI_ELLIPTIC, poisson=0.3):
    return np.array(core.free_end(u, inner, outer, face_table(element, poisson), element.core))


def integrated(u, inner, outer, element=nh.SEMI_ELLIPTIC, poisson=0.3):
    """H and C of a strip, by Gauss's rule on panels that narrow towards the place and the face."""
    breaks = {inner, outer, *(each for each in u * 2.0 ** np.arange(-8.0, 9.0) if inner < each < outer)}
    if inner == 0.0:
        breaks |= set(outer * 2.0 ** np.arange(-30.0, 0.0))
    breaks = np.sort(list(breaks))
    node, weight = np.polynomial.legendre.leggauss(20)
    half = 0.5 * np.diff(breaks)
    v = (0.5 * (breaks[1:] + breaks[:-1]))[:, None] + half[:, None] * node
    return np.array([
        np.sum(density * half[:, None] * weight)
        for density in free_end.densities(element, free_face(poisson), np.array(u), v)
    ])  # fmt: skip


@pytest.mark.parametrize("element", ELEMENTS)
@pytest.mark.parametrize("poisson", [0.0, 0.3])
@pytest.mark.parametrize(
    ("u", "inner", "outer"),
    [
        (0.01, 0.0, 0.02), (0.02, 0.3, 0.5), (0.4, 0.0, 0.1), (1.0, 0.7, 1.3), (3.0, 2.0, 2.1), (0.5, 5.0, 7.0),
        (1.0, 2.0, 40.0), (6.0, 1.5, 30.0), (20.0, 0.0, 50.0), (30.0, 0.1, 0.4), (9.0, 2.0, 4.0),
    ],
)  # fmt: skip
def test_strips_of_all_sizes_are_integrals_over_loads(element, poisson, u, inner, outer):
    expected = integrated(u, inner, outer, element, poisson)
    scale = integrated(u, 0.0, outer, element, poisson)  # differences of these are what is read from the table
    np.testing.assert_allclose(
        added(u, inner, outer, element, poisson)[[H, C]], expected, rtol=1e-5, atol=1e-8 + 1e-6 * np.abs(scale).max()
    )


@pytest.mark.parametrize("element", ELEMENTS)
@pytest.mark.parametrize(
    ("u", "inner", "outer"), [(0.02, 0.0, 0.05), (0.7, 0.3, 2.0), (3.0, 2.0, 20.0), (12.0, 3.0, 5.0)]
)
def test_derivatives_are_those_of_the_functions(element, u, inner, outer):
    step = 1e-4
    bigger, smaller = (added(u * by, inner * by, outer * by, element) for by in (1.0 + step, 1.0 - step))
    found = added(u, inner, outer, element)
    np.testing.assert_allclose(found[[RHO_H, RHO_C]], ((bigger - smaller) / (2.0 * step))[[H, C]], atol=1e-4)


@pytest.mark.parametrize("element", ELEMENTS)
@pytest.mark.parametrize(("u", "inner", "outer"), [(0.02, 0.0, 0.05), (0.7, 0.3, 2.0), (12.0, 3.0, 5.0)])
def test_it_is_the_displacement_of_pieces_of_the_pressure_and_its_curvature_across(element, u, inner, outer):
    # The displacement beside the centre line too, by the same weights, of pieces of the pressure at angles.
    face, node, weight = free_face(0.3), *np.polynomial.legendre.leggauss(40)
    v = 0.5 * (inner + outer) + 0.5 * (outer - inner) * node
    angle = math.pi * (np.arange(400) + 0.5) / 400
    across = np.cos(angle)
    shape = 2.0 / math.pi * np.sin(angle) if element is nh.SEMI_ELLIPTIC else 0.75 * np.sin(angle) ** 2
    pressure = shape * np.sin(angle) * math.pi / 400  # times the width of a piece

    def displacement(x):
        weights = face.towards(np.full(40, u), v)
        distance = np.multiply.outer(u + v, face.distances)[:, :, None]
        beside = np.hypot(distance, x - across)
        of_pieces = weights[:, 0, :, None] / beside + weights[:, 1, :, None] * distance / math.pi / beside**2
        return float(weight @ (of_pieces.sum(axis=1) @ pressure)) * 0.5 * (outer - inner)

    step = 0.02
    bent = (displacement(step) - 2.0 * displacement(0.0) + displacement(-step)) / step**2
    found = added(u, inner, outer, element)
    assert displacement(0.0) == pytest.approx(found[H], rel=1e-3)
    assert -bent == pytest.approx(found[C], rel=5e-3, abs=2e-6)


@pytest.mark.parametrize("border", [CLOSE, 2.0**-3, 1.0, 4.0])
@pytest.mark.parametrize("other", [3e-4, 0.1, 0.9, 5.0, 60.0])
def test_nothing_jumps_where_parts_of_the_table_meet(border, other):
    below, above = border * (1.0 - 1e-12), border * (1.0 + 1e-12)
    for places in (lambda at: (at, 0.0, other), lambda at: (other, 0.0, at), lambda at: (other, at, 100.0)):
        before, after = added(*places(below)), added(*places(above))
        np.testing.assert_allclose(before[[H, C]], after[[H, C]], atol=1e-6 * (1.0 + np.abs(before).max()))


def test_nothing_jumps_where_a_strip_gets_far_away():
    before, after = added(5.0, 3.0 - 1e-12, 3.5), added(5.0, 3.0 + 1e-12, 3.5)
    np.testing.assert_allclose(before, after, atol=1e-6)


def test_a_strip_at_the_face_itself_adds_something_and_one_without_width_nothing():
    assert np.all(np.isfinite(added(0.0, 0.0, 1e-6)))
    assert added(0.0, 0.0, 0.1)[H] > 0.0
    np.testing.assert_array_equal(added(0.5, 0.3, 0.3), 0.0)


@pytest.mark.parametrize("finer", [1e-2, 1e-4])
def test_closer_than_the_table_the_logarithm_goes_on(finer):
    u, inner, outer = 0.5 * CLOSE * finer, 0.25 * CLOSE * finer, CLOSE * finer
    np.testing.assert_allclose(added(u, inner, outer)[[H, C]], integrated(u, inner, outer), rtol=0.01)


def test_faces_of_two_materials_at_one_place_add_what_each_does():
    """Of both bodies: what is kept of one face for its next place is none of the other's."""
    grid = strips_between(np.array([-2.0, -1.2]))
    sides = FreeSide(-2.0, -1, 0.4, 0.3), FreeSide(-2.0, -1, 0.6, 0.0)

    def blocks(*faces):
        kernel = kernel_of(Influence(np.atleast_2d(HALF_SPACE), faces=faces), nh.SEMI_ELLIPTIC)
        return core.coefficients(grid, np.array([0.36]), np.array([0]), kernel)

    one, other = (blocks(side) - blocks() for side in sides)
    np.testing.assert_allclose(blocks(*sides) - blocks(), one + other, rtol=1e-12)
    assert not np.allclose(one / 0.4, other / 0.6, rtol=1e-2)
