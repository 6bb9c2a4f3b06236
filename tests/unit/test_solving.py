"""Cases on given strips: what is tried where a loop does not end, and contacts that follow."""

import numpy as np
import pytest
from core_pieces import kernel_of, strips_between

import nonhertz as nh
from nonhertz.native import core
from nonhertz.strip.problem import StripModel

EDGES = np.linspace(-10.0, 10.0, 22)
K_LOAD = 1e-3


def never_met(strips):
    """Solve a crowned roller, in contact in its middle, to a tolerance that is not met but where the load is raised."""
    edges = np.linspace(-10.0, 10.0, strips + 1)
    y = 0.5 * (edges[1:] + edges[:-1])
    grid = strips_between(edges, separation=y**2 / 100.0)
    return core.solve_on(grid, (True, False), (K_LOAD, 0.0), kernel_of(), tolerance=0.0), np.diff(edges)


def test_a_load_that_is_raised_arrives():
    state, width = never_met(399)
    assert state.status == core.Status.CONVERGED
    # The loop's tolerance.
    np.testing.assert_allclose((state.r * state.m) @ width, K_LOAD, rtol=1e-11)


def test_on_very_many_strips_the_load_is_not_raised():
    state, _ = never_met(core.PATIENT_STRIPS + 1)
    assert state.status == core.Status.ITERATION_LIMIT


@pytest.fixture
def followed():
    """A contact that is solved, its model, and strips on which it follows."""
    roller = nh.Roller(diameter=20, length=20, profile=nh.profile.crown(4000))
    model = StripModel.of(nh.Contact(roller, nh.Plate()), nh.SEMI_ELLIPTIC).in_core
    grid = model.grid(EDGES)
    state = core.solve_on(grid, (False, False), (0.01, 0.0), model.kernel)
    assert state.status == core.Status.CONVERGED
    return model, grid, state


def test_a_case_that_follows_is_the_one_that_is_solved_there(followed):
    model, grid, state = followed
    pose = 0.011, 1e-4
    (load, moment), there = core.Following(grid, model.kernel).follow(pose, state)
    alone = core.solve_on(grid, (False, False), pose, model.kernel)
    loads = alone.r * alone.m * np.diff(EDGES)
    # Load and moment are accurate to the square of the last step, what they come from to the step.
    np.testing.assert_allclose([load, moment], [loads.sum(), loads @ grid.y], rtol=1e-9)
    np.testing.assert_allclose(there.stiffness, alone.stiffness, rtol=1e-4)


def test_a_case_that_cannot_follow_is_left_as_it_was(followed):
    model, grid, state = followed
    resultant, there = core.Following(grid, model.kernel).follow((-1.0, 0.0), state)
    assert resultant is None
    for name in ("r", "m", "gap", "rigid", "stiffness"):
        np.testing.assert_array_equal(getattr(there, name), getattr(state, name))
