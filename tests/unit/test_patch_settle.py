"""Finding the set where it is hard: loads on a row or two of cells, and the way out by prescribed motion."""

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.bodies.influence import HALF_SPACE, Influence
from nonhertz.patch import settle as settling
from nonhertz.patch.convolution import Convolution
from nonhertz.patch.grid import Grid
from nonhertz.patch.inverse import Inverse
from nonhertz.patch.settle import CellState, Task, settle

GRID = Grid((-1.0, 1.0), (-4.0, 4.0), (14, 20))
TOLERANCE = 1e-9


def task(by_force, target, sharpness=0.02):
    gap = GRID.x[:, None] ** 2 + sharpness * GRID.y**2
    area = GRID.dx * GRID.dy
    scaled = tuple(value / area if forced else value for value, forced in zip(target, by_force, strict=True))
    return Task(gap, Convolution(GRID, Influence(HALF_SPACE)), Inverse(GRID), GRID.y, by_force, scaled)


def start():
    return np.ones(GRID.cells)


def moments(state):
    """Load and moment, times K."""
    line_load = state.pressure.sum(axis=0) * GRID.dx * GRID.dy
    return line_load.sum(), line_load @ GRID.y


@pytest.mark.parametrize("arm", [0.0, 0.1, -2.3, 3.7])
def test_a_moment_on_a_row_or_two_of_cells(arm):
    # A ridge so sharp that without the moment one row would touch.
    state = settle(task((True, True), (0.05, 0.05 * arm), sharpness=3.0), start(), (0.0, 0.0), TOLERANCE)
    assert state.status is nh.Status.CONVERGED
    load, moment = moments(state)
    # Load and moment are met to rounding of the last steps, or to the tolerance by motion.
    np.testing.assert_allclose([load, moment], [0.05, 0.05 * arm], rtol=1e-8, atol=1e-10)
    assert state.pressure.min() >= 0.0
    assert np.abs(state.gap[state.pressure > 0.0]).max() < 1e-8
    assert state.gap.min() > -1e-8


@pytest.mark.parametrize(
    ("by_force", "target"),
    [
        ((True, True), (0.8, 0.4)),
        ((True, False), (0.8, 0.05)),
        ((False, True), (0.3, -0.2)),
        ((False, True), (-0.1, 0.2)),
    ],
)
def test_by_motion_leads_where_sets_lead(by_force, target):
    problem = task(by_force, target)
    direct = settle(problem, start(), (0.0, 0.0), TOLERANCE)
    assert direct.status is nh.Status.CONVERGED
    rigid = tuple(0.0 if forced else value for value, forced in zip(target, by_force, strict=True))
    nowhere = CellState(np.zeros(GRID.cells), problem.undeformed, rigid, np.inf, nh.Status.ITERATION_LIMIT)
    by_motion = settling.settle_by_motion(problem, nowhere, TOLERANCE)
    assert by_motion.status is nh.Status.CONVERGED
    # Both meet the conditions to 1e-9 of the displacement, which pressures magnify.
    np.testing.assert_allclose(by_motion.rigid, direct.rigid, rtol=1e-6, atol=1e-9)
    np.testing.assert_allclose(by_motion.pressure, direct.pressure, rtol=0.0, atol=1e-6 * direct.pressure.max())


def test_what_no_cell_can_bear_ends_without_a_solution():
    # Beyond the centre of the last row.
    state = settle(task((True, True), (0.05, 0.05 * 3.95)), start(), (0.0, 0.0), TOLERANCE)
    assert state.status is nh.Status.ITERATION_LIMIT
