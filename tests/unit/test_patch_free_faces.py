"""What free side faces add on cells: against the quarter-space itself, by reciprocity, and node by node."""

import numpy as np
import pytest
from scipy import integrate, special

import nonhertz as nh
from nonhertz.bodies.influence import HALF_SPACE, FreeSide, Influence, influence_of
from nonhertz.bodies.quarter_space import free_face
from nonhertz.bodies.shape import HERTZ
from nonhertz.patch.convolution import Convolution
from nonhertz.patch.free_faces import at_points, free_ends, merge_faces
from nonhertz.patch.grid import Grid
from nonhertz.patch.kernel import edges_from

STEEL = 0.3
EDGE = FreeSide(0.0, -1, 1.0, STEEL)  # of a body on y > 0
MIRRORED = np.array([[-1.0, 0.0, 1.0]])


def added(grid, pressure, faces=(EDGE,)):
    """What faces add to the displacement under a pressure."""
    bare = Convolution(grid, Influence(HALF_SPACE))(pressure)
    return Convolution(grid, Influence(HALF_SPACE, faces=faces))(pressure) - bare


@pytest.mark.parametrize(
    ("near", "expected"),
    [(0.5, {0.0: 1.506, 1.0: 1.833}), (0.0, {0.0: 1.677, 0.5: 1.783, 1.0: 1.741})],
    ids=["apart", "touching"],
)
def test_a_square_of_uniform_pressure(near, expected):
    # Hetenyi's two half-spaces, iterated on rectangles: 1 + what is added over what the image does, nu = 0.3.
    grid = Grid((-0.5, 0.5), (0.0, 2.0), (21, 400))
    loaded = (grid.y > near) & (grid.y < near + 1.0)
    pressure = np.tile(loaded.astype(float), (21, 1))
    image = Convolution(grid, Influence(MIRRORED))(pressure)
    ratio = 1.0 + (added(grid, pressure) / image)[10]
    np.testing.assert_allclose(np.interp(list(expected), grid.y, ratio), list(expected.values()), rtol=0.01)


def test_one_cell_is_the_integral_over_wave_numbers():
    face, dx, dy = free_face(STEEL), 0.05, 0.03
    y = dy * (np.arange(300) + 0.5)
    (end,) = free_ends((EDGE,), y, dy)
    at, load = 60, 200

    def wave(k, x):
        u, v = np.array([k * y[at]]), np.array([k * y[load]])
        weights = face.towards(u, v)[0]
        distance = face.distances * (u + v)
        effect = np.sum(weights[0] * 2.0 * special.k0(distance) + weights[1] * np.exp(-distance))
        return effect * np.cos(k * x) * 2.0 * np.sin(0.5 * k * dx) / k / np.pi

    kernel = end.kernel(edges_from(0.0, 40, dx))
    found = dy * end.weights[at] @ kernel @ end.weights[load]
    for column in (0, 7, 39):
        exact = dy * integrate.quad(wave, 0.0, 30.0, args=(column * dx,), limit=400, epsabs=1e-12)[0]
        assert found[column] == pytest.approx(exact, rel=1e-6)


@pytest.mark.parametrize("start", [0.0, 0.2, 9.0])
def test_nodes_stand_for_all_cells(start):
    # The same rows as parts of grids so short that each has a node of its own.
    dy, count = 0.04, 300
    y = start + dy * (np.arange(count) + 0.5)
    (end,) = free_ends((EDGE,), y, dy)
    assert end.nodes.size < count / 4
    np.testing.assert_allclose(end.weights.sum(axis=1), 1.0, rtol=1e-12)
    x_edges = edges_from(0.0, 3, 0.01)
    through_nodes = end.weights @ end.kernel(x_edges) @ end.weights.T
    rows = np.array([8, 9, 13, 31, 77, 130, 299])
    for one in rows:
        for other in rows:
            exact = end.pairwise(x_edges, y[[one]], y[[other]])[:, 0]
            np.testing.assert_allclose(through_nodes[:, one, other], exact, rtol=3e-7)


def test_the_cells_at_the_edge_are_averaged():
    dy = 0.04
    (end,) = free_ends((EDGE,), dy * (np.arange(12) + 0.5), dy)
    x_edges = edges_from(0.0, 1, 0.01)
    at = 0.5 * dy

    def along(v):
        return float(end.pairwise(x_edges, np.array([at]), np.array([v]))[0, 0])

    exact = integrate.quad(along, 0.0, dy, epsabs=1e-13)[0] / dy
    assert end.kernel(x_edges)[0, 0, 0] == pytest.approx(exact, rel=1e-4)
    assert abs(along(at) / exact - 1.0) > 1e-3


UNLIKE = nh.Contact(
    nh.Roller(diameter=20, length=20, side_faces=("free", 0.7), depth="none"),
    nh.Ring(diameter=60, length=21, position=0.2, material=nh.Material(100000.0, 0.2), side_faces="free"),
)


def test_the_displacement_of_a_load_elsewhere_is_that_of_the_other_load_here():
    influence = influence_of(UNLIKE, HERTZ)
    assert len(influence.faces) == 3
    grid = Grid((-0.3, 0.4), (-10.0, 10.0), (5, 40))
    convolution = Convolution(grid, Influence(HALF_SPACE, faces=influence.faces))
    units = np.eye(200).reshape(200, 5, 40)
    matrix = np.array([convolution(unit).ravel() for unit in units])
    np.testing.assert_allclose(matrix, matrix.T, rtol=1e-12, atol=0.0)
    assert np.linalg.eigvalsh(matrix).min() > 0.0


def test_both_ends_of_a_body_are_alike():
    low, high = FreeSide(-10.0, -1, 0.5, STEEL), FreeSide(10.0, 1, 0.5, STEEL)
    grid = Grid((-0.3, 0.4), (-10.0, 10.0), (6, 90))
    pressure = np.random.default_rng(0).random(grid.cells)
    turned = added(grid, pressure[:, ::-1], (high,))[:, ::-1]
    np.testing.assert_allclose(added(grid, pressure, (low,)), turned, rtol=1e-11)
    together = added(grid, pressure, (low,)) + added(grid, pressure, (high,))
    np.testing.assert_allclose(added(grid, pressure, (low, high)), together, rtol=1e-11)


def test_faces_at_the_same_place_are_one():
    one = FreeSide(0.0, -1, 0.3, STEEL)
    assert merge_faces((one, one, FreeSide(0.0, -1, 0.3, 0.2))) == (
        FreeSide(0.0, -1, 0.6, STEEL), FreeSide(0.0, -1, 0.3, 0.2),
    )  # fmt: skip
    grid = Grid((-0.3, 0.4), (0.0, 10.0), (6, 30))
    pressure = np.random.default_rng(0).random(grid.cells)
    np.testing.assert_allclose(added(grid, pressure, (one, one)), 2.0 * added(grid, pressure, (one,)), rtol=1e-11)


def test_far_from_a_cell_its_load_is_a_force():
    dx, dy = 0.02, 0.03
    y = dy * (np.arange(200) + 0.5)
    (end,) = free_ends((EDGE,), y, dy)
    kernel = dy * end.weights[50] @ end.kernel(edges_from(0.0, 100, dx)) @ end.weights[160]
    forces = at_points((EDGE,), np.array([0.0, 0.4]), y[[50, 50]], np.array([0.0]), y[[160]])
    np.testing.assert_allclose(dx * dy * forces[:, 0], kernel[[0, 20]], rtol=1e-4)
