"""The field of single strips and of their tails, against quadrature of Boussinesq's point load."""

from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import quad

from nonhertz.bodies import wall_stress
from nonhertz.hertz import line_contact
from nonhertz.native import core
from nonhertz.subsurface.lamination import Lamination
from nonhertz.subsurface.strips import StripLoad
from nonhertz.subsurface.tails import DISPLACEMENT

POISSON = 0.28
NODES, WEIGHTS = np.polynomial.legendre.leggauss(160)


def point_load(x, y, z):
    """Return 2 pi times the stress, and 4 pi G times the displacement, of a unit load at the origin.

    Johnson, Contact Mechanics, 1985, Eqs. (3.18) and (3.19).
    """
    r2, R = x * x + y * y, np.sqrt(x * x + y * y + z * z)
    lateral = (1.0 - 2.0 * POISSON) / r2
    s_x = lateral * ((1.0 - z / R) * (x * x - y * y) / r2 + z * y * y / R**3) - 3.0 * z * x * x / R**5
    s_y = lateral * ((1.0 - z / R) * (y * y - x * x) / r2 + z * x * x / R**3) - 3.0 * z * y * y / R**5
    t_xy = lateral * ((1.0 - z / R) * 2.0 * x * y / r2 - x * y * z / R**3) - 3.0 * x * y * z / R**5
    stress = [s_x, s_y, -3.0 * z**3 / R**5, -3.0 * y * z * z / R**5, -3.0 * x * z * z / R**5, t_xy]
    beside = (1.0 - 2.0 * POISSON) / (R * (R + z))
    moved = [x * z / R**3 - beside * x, y * z / R**3 - beside * y, 2.0 * (1.0 - POISSON) / R + z * z / R**3]
    return np.array(stress), np.array(moved)


def by_quadrature(strips, point):
    """Return stress and G u below strips (low, high, q, a), point load by point load."""
    stress, moved = np.zeros(6), np.zeros(3)
    for low, high, q, a in strips:
        angle = 0.5 * np.pi * (NODES + 1.0)
        across, share = a * np.cos(angle), WEIGHTS * np.sin(angle) ** 2
        along = 0.5 * (low + high) + 0.5 * (high - low) * NODES
        load = q * share[:, None] * (0.5 * (high - low) * WEIGHTS)
        of_stress, of_moved = point_load(point[0] - across[:, None], point[1] - along, point[2] + 0.0 * load)
        stress += np.sum(of_stress * load, axis=(1, 2)) / (2.0 * np.pi)
        moved += np.sum(of_moved * load, axis=(1, 2)) / (4.0 * np.pi)
    return stress, moved


def load_of(strips):
    low, high, q, a = np.array(strips).T
    # Each strip is its own and only piece.
    double = [np.concatenate([each, each]) for each in (low, high, q, a)]
    return StripLoad(Lamination(*double, np.arange(len(strips), 2 * len(strips) + 1)))


STRIPS = [(-1.0, -0.2, 700.0, 0.25), (-0.2, 0.5, 1000.0, 0.3), (0.5, 2.0, 800.0, 0.28)]
POINTS = {
    "under a strip": (0.1, 0.1, 0.2),
    "beside the contact": (0.5, -0.6, 0.15),
    "beyond its end": (-0.2, 2.3, 0.3),
    "under an edge": (0.05, 0.5, 0.12),
    "far along": (0.05, 9.0, 0.8),
    "far across": (4.0, 0.3, 0.4),
    "far below": (1.0, -2.0, 6.0),
}


@pytest.mark.parametrize("place", POINTS)
def test_stress_and_displacement_are_those_of_the_point_loads(place):
    point = POINTS[place]
    stress, moved = by_quadrature(STRIPS, point)
    load, points = load_of(STRIPS), np.array([point])
    # What the strips add has an error of 1e-8 each; the quadrature here is as good, far away better.
    np.testing.assert_allclose(load.stress(points, POISSON)[0], stress, rtol=0.0, atol=5e-8 * np.abs(stress).max())
    np.testing.assert_allclose(load.displacement(points, POISSON)[0], moved, rtol=0.0, atol=5e-9 * np.abs(moved).max())


@pytest.mark.parametrize("component", range(6))
def test_a_tail_is_the_integral_of_point_loads(component):
    X, Y, z = 0.4, 0.3, 0.25
    # The point lies at the origin of y, the load ahead of it: field less source is -s.
    expected, _ = quad(lambda s: point_load(X, -s, z)[0][component], Y, np.inf, epsabs=1e-12)
    assert core.stress_tail(X, Y, z, POISSON)[component] == pytest.approx(expected, abs=1e-10)


@pytest.mark.parametrize("component", range(3))
def test_two_tails_differ_by_the_displacement_of_the_segment_between_them(component):
    X, z = 0.4, 0.25
    near, far = (core.displacement_tail(X, Y, z, POISSON)[DISPLACEMENT[component]] for Y in (0.3, 1.7))
    expected, _ = quad(lambda s: point_load(X, -s, z)[1][component], 0.3, 1.7, epsabs=1e-12)
    assert near - far == pytest.approx(expected, abs=1e-10)


def test_a_long_strip_is_hertz_line_contact_up_to_the_surface():
    line = line_contact(line_load=1000.0, radius=10.0, compliance=2.8e-6)
    b = line.half_width
    load = load_of([(-1e4, 1e4, 1000.0, b)])
    x, z = (
        grid.ravel() for grid in np.meshgrid(np.linspace(-3.0, 3.0, 25) * b, np.array([0.0, 1e-9, 0.01, 1.0, 9.0]) * b)
    )
    found = load.stress(np.column_stack([x, np.full(x.size, 3.0), z]), 0.3)
    # Beyond 1e4 mm there is nothing: (1 - 2 nu) q / (pi 1e4 mm) are missing.
    np.testing.assert_allclose(found, line.stress(x, z, 0.3), rtol=0.0, atol=2e-5 * line.max_pressure)


def test_rules_integrate_polynomials_over_the_semi_ellipse():
    rules = core.semi_ellipse_rules()
    nodes, weights, starts = rules.nodes, rules.weights, rules.starts
    second, fourth = 0.25, 0.125
    for low, high in pairwise(starts):
        assert weights[low:high].sum() == pytest.approx(1.0, abs=1e-14)
        assert weights[low:high] @ nodes[low:high] ** 2 == pytest.approx(second, abs=1e-14)
        if high - low > 2:
            assert weights[low:high] @ nodes[low:high] ** 4 == pytest.approx(fourth, abs=1e-14)
    assert np.all(np.diff(rules.enough) < 0.0)
    assert nodes.size == starts[-1] > 1000


@pytest.mark.parametrize("depth", [0.0, 1e-6, 1e-3, 0.02])
def test_where_strips_are_cut_the_field_does_not_see_it(depth):
    pieces = [(0.02 * k, 0.02 * (k + 1), 1000.0, 0.3) for k in range(-20, 20)]
    y = np.concatenate([np.linspace(-0.1, 0.1, 41), 0.02 * np.arange(-5, 6), 0.02 * np.arange(-5, 6) + 1e-13])
    points = np.column_stack([0.01 + 0.0 * y, y, np.full(y.size, depth)])
    whole = load_of([(-0.4, 0.4, 1000.0, 0.3)]).stress(points, 0.3)
    p0 = 2.0 * 1000.0 / (np.pi * 0.3)
    np.testing.assert_allclose(load_of(pieces).stress(points, 0.3), whole, rtol=0.0, atol=1e-6 * p0)


@pytest.mark.parametrize("y", [0.46, -0.46])
def test_pieces_of_one_strip_are_each_integrated_as_by_themselves(y):
    # Beside the end of eight pieces, of which four are added at a time: each needs more nodes than the one before it.
    low = np.linspace(-0.4, 0.3, 8)
    pieces = np.column_stack([low, low + 0.1, np.linspace(600.0, 1000.0, 8), np.full(8, 0.3)])
    numbers = np.vstack([[-0.4, 0.4, 800.0, 0.3], pieces]).T
    together = StripLoad(Lamination(*(np.ascontiguousarray(row) for row in numbers), np.array([1, 9])))
    points = np.array([[0.1, y, 0.02], [-0.2, y, 0.1]])
    alone = load_of(pieces).stress(points, POISSON)
    np.testing.assert_allclose(together.stress(points, POISSON), alone, rtol=0.0, atol=1e-7 * np.abs(alone).max())


def test_nothing_bears_nothing():
    empty = StripLoad(Lamination(*(np.empty(0) for _ in range(4)), np.zeros(1, dtype=np.int64)))
    assert not empty.stress(np.zeros((2, 3)), 0.3).any()


def test_from_the_opposite_side_point_loads_are_those_of_boussinesq():
    outer, places, forces = 10.0, np.array([-2.0, 1.5]), np.array([700.0, 400.0])
    points = np.array([[0.5, 0.3, 7.0], [-1.0, 2.0, 9.0], [2.0, -4.0, 6.5], [1e-4, 1.5, 8.0]])
    found, even = np.zeros((4, 6)), np.ones(4)
    wall = core.Wall(np.zeros((1, 6, 2, 2)), 0.9, places, forces)
    wall.add(points, 0.0 * even, outer * even, 5.0 * even, POISSON, found)
    # Turned by half a revolution about the axis, which turns tau_yz and tau_xy round.
    for (x, y, z), row in zip(points, found * [1.0, 1.0, 1.0, -1.0, 1.0, -1.0], strict=True):
        loads = zip(places, forces, strict=True)
        expected = sum(force * point_load(-x, y - place, 2.0 * outer - z)[0] for place, force in loads)
        np.testing.assert_allclose(row, expected / (2.0 * np.pi), rtol=1e-5, atol=1e-9)


def test_the_modes_of_point_loads_are_taken_from_those_of_boussinesq():
    points = np.array([[0.5, 0.3, 0.7], [-1.0, 2.0, 0.4], [1e-4, 1e-4, 0.8]])
    for point, row in zip(points, wall_stress._point_load(*points.T, POISSON), strict=True):
        np.testing.assert_allclose(row, point_load(*point)[0] / (2.0 * np.pi), rtol=1e-5, atol=1e-9)


@pytest.mark.parametrize("n", [0, 1])
def test_modes_of_a_wall_are_turned_from_its_radius_into_the_axes_of_the_contact(n):
    amplitudes = np.array([3.0, -5.0, 2.0, 7.0, 1.0, 4.0])  # rr, tt, yy, rt, ry, ty
    modes, outer, theta = np.zeros((2, 6, 2, 2)), 10.0, np.array([0.0, 0.4, -1.1])
    modes[n, :, 0, 0] = amplitudes
    points = np.column_stack([8.0 * np.sin(theta), [0.0, 1.0, 2.0], outer - 8.0 * np.cos(theta)])
    found, even = np.zeros((3, 6)), np.ones(3)
    core.Wall(modes, 0.9, np.zeros(1), np.zeros(1)).add(points, 0.0 * even, outer * even, 5.0 * even, POISSON, found)
    for angle, stress in zip(theta, found, strict=True):
        across, along = np.cos(2.0 * n * angle), np.sin(2.0 * n * angle)
        rr, tt, yy, rt, ry, ty = amplitudes * [across, across, across, along, across, along]
        polar = np.array([[rr, rt, ry], [rt, tt, ty], [ry, ty, yy]])
        # Radius and turning round, in x, y and the depth; then the axis of the roller.
        c, s = np.cos(angle), np.sin(angle)
        turn = np.array([[s, c, 0.0], [0.0, 0.0, 1.0], [-c, s, 0.0]])
        full = turn @ polar @ turn.T
        expected = [full[0, 0], full[1, 1], full[2, 2], full[1, 2], full[0, 2], full[0, 1]]
        np.testing.assert_allclose(stress, expected, rtol=1e-12, atol=1e-12)
