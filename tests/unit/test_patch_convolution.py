"""The convolution against the sum over all cells, with images and depths; and its rough inverse."""

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.bodies.influence import HALF_SPACE, Influence, influence_of
from nonhertz.bodies.shape import HERTZ
from nonhertz.patch.convolution import Convolution
from nonhertz.patch.grid import Grid
from nonhertz.patch.inverse import Inverse
from nonhertz.patch.kernel import edges_from, rectangles

BODIES = {
    "half-spaces": ({"side_faces": "none", "depth": "none"}, {}),
    "mirrored": ({"depth": "none"}, {}),
    "mirrored, deep": ({}, {}),
    "unlike faces, three images": (
        {"side_faces": (0.4, 1.6), "images": 3, "position": 0.3},
        {"length": 24, "position": 0.7},
    ),
    "series": ({"images": "series"}, {"depth": 7.0}),
}
SIZES = [(5, 7), (6, 4), (11, 13)]


def influence(name):
    roller, plate = BODIES[name]
    return influence_of(
        nh.Contact(
            nh.Roller(**{"diameter": 20, "length": 20, "side_faces": "mirror"} | roller),
            nh.Plate(**{"side_faces": "mirror"} | plate),
        ),
        HERTZ,
    )


def summed(grid, influence, pressure):
    """Every cell on every cell, image by image."""
    total = -influence.at_depth(grid.y, grid.y_edges) @ (grid.dx * pressure.sum(axis=0))
    total = np.tile(total, (grid.cells[0], 1))
    for sign, offset, weight in influence.terms:
        for j, place in enumerate(sign * grid.y + offset):
            along = edges_from(grid.y[0] - place, grid.cells[1], grid.dy)
            for i, x in enumerate(grid.x):
                across = edges_from(grid.x[0] - x, grid.cells[0], grid.dx)
                total += weight * pressure[i, j] * rectangles(across, along)
    return total


@pytest.mark.parametrize("name", BODIES)
@pytest.mark.parametrize("cells", SIZES, ids=str)
def test_it_is_the_sum_over_all_cells(name, cells):
    # A region that is symmetric about nothing.
    grid = Grid((-0.3, 0.45), (-9.0, 8.5), cells)
    pressure = np.random.default_rng(0).random(cells)
    exact = summed(grid, influence(name), pressure)
    # Rounding of some thousand terms.
    np.testing.assert_allclose(
        Convolution(grid, influence(name))(pressure), exact, rtol=0.0, atol=3e-14 * np.max(np.abs(exact))
    )


@pytest.mark.parametrize("sides", [(1.0, 1.0), (1.0, 30.0), (10.0, 1.0)], ids=str)
def test_the_inverse_on_a_set_errs_by_a_bounded_factor(sides):
    # The spectrum of M K on an ellipse that fills the region lies between 0.8 and 6: what makes the number of steps
    # independent of the number of cells.
    for cells in ((10, 20), (16, 32)):
        grid = Grid((-sides[0], sides[0]), (-sides[1], sides[1]), cells)
        inside = np.hypot(grid.x[:, None] / sides[0], grid.y / sides[1]) < 1.0
        units = [np.zeros(cells) for _ in range(np.count_nonzero(inside))]
        for unit, place in zip(units, np.argwhere(inside), strict=True):
            unit[tuple(place)] = 1.0
        convolution, inverse = Convolution(grid, Influence(HALF_SPACE)), Inverse(grid)
        forward = np.array([convolution(unit)[inside] for unit in units])
        backward = np.array([inverse(unit)[inside] for unit in units])
        values = np.linalg.eigvals(backward @ forward)
        assert np.max(np.abs(values.imag)) < 1e-9  # both are symmetric and positive
        assert values.real.min() > 0.8
        assert values.real.max() < 6.0
