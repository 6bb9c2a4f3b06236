"""Cases on given strips: the load raised in steps where nothing else leads to an answer."""

import numpy as np
import pytest
from core_pieces import interpret

import nonhertz as nh
from nonhertz.model.prescription import Prescription
from nonhertz.solver.one import problem_of
from nonhertz.strip import solving
from nonhertz.strip.influence import blank_remote
from nonhertz.strip.newton import TOLERANCE
from nonhertz.strip.problem import row_of
from nonhertz.strip.records import CONVERGED, STAGNATED, BoundaryConditions, NewtonOptions, States

STRIPS = row_of(np.linspace(-10.0, 10.0, 22))


@pytest.fixture
def problem():
    roller = nh.Roller(diameter=20, length=20, profile=nh.profile.crown(4000))
    return problem_of(nh.Contact(roller, nh.Plate()), Prescription(load=3e3, tilt=2e-4), nh.SEMI_ELLIPTIC)


def raised(problem):
    """Return how raising the load of the problem ends, and the state that it leaves."""
    grids, found = problem.model.deep(problem.model.grids(*STRIPS)), States.unsolved(*STRIPS, 1)
    unknowns = solving.unknowns_of(found, 0, found.m.shape[1])
    conditions = BoundaryConditions(problem.prescribed, problem.target)
    options = NewtonOptions(TOLERANCE, 1.0, True, False)
    status, *_ = solving.loop(
        solving.strips_of(grids, 0), conditions, problem.model.kernel, unknowns, grids.min_depth[0], options, True
    )
    return status, found.one(0)


def test_a_load_that_is_raised_arrives_going_on_from_rise_to_rise(problem, monkeypatch):
    begun, ended, newton = [], [], solving.newton

    def noting(strips, conditions, kernel, unknowns, *others):
        begun.append(unknowns.m.copy())
        done = newton(strips, conditions, kernel, unknowns, *others)
        ended.append(unknowns.m.copy())
        return done

    interpret(monkeypatch, newton=noting)
    status, state = raised(problem)
    assert status == CONVERGED
    # The loop's tolerance.
    np.testing.assert_allclose(state.scaled_load, problem.target[0], rtol=1e-11)
    assert len(begun) > 5
    np.testing.assert_array_equal(begun[1:], ended[:-1])


def test_before_a_rise_is_given_up_it_has_been_cut_to_a_thousandth_of_the_load(problem, monkeypatch):
    """Beyond three tenths of the load nothing converges."""
    tried, newton = [], solving.newton

    def failing(strips, conditions, *others):
        share = float(conditions.target[0] / problem.target[0])
        tried.append(share)
        return newton(strips, conditions, *others) if share <= 0.3 else (STAGNATED, 1, np.inf)

    interpret(monkeypatch, newton=failing)
    status, _ = raised(problem)
    assert status == STAGNATED
    beyond = min(share for share in tried if share > 0.3)
    reached = max(share for share in tried if share <= 0.3)
    assert beyond - reached < 2e-3


def test_a_case_that_cannot_follow_is_left_as_it_was():
    roller = nh.Roller(diameter=20, length=20, profile=nh.profile.crown(4000))
    problem = problem_of(nh.Contact(roller, nh.Plate()), Prescription(approach=0.01, tilt=0.0), nh.SEMI_ELLIPTIC)
    grids, found, answer = problem.model.deep(problem.model.grids(*STRIPS)), States.unsolved(*STRIPS, 1), np.zeros(6)
    target = problem.target[None]
    solving.solve_on_strips(
        grids,
        BoundaryConditions(problem.prescribed, target),
        problem.model.kernel,
        States.none(),
        found,
        TOLERANCE,
        False,
    )
    assert found.status[0] == CONVERGED
    before = [each.copy() for each in found]
    remote, apart = (
        blank_remote(21, problem.model.kernel),
        BoundaryConditions(problem.prescribed, np.array([[-1.0, 0.0]])),
    )
    assert not solving.follow(grids, apart, problem.model.kernel, remote, found, answer)
    for was, each in zip(before, found, strict=True):
        np.testing.assert_array_equal(each, was)
    assert not answer.any()
