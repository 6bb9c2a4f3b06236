"""Strips on one grid: the load raised in steps where nothing else leads to an answer."""

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.model.prescription import Prescription
from nonhertz.solver.one import problem_of
from nonhertz.strip.newton import STAGNATED
from nonhertz.strip.state import State, Strips

EDGES = np.linspace(-10.0, 10.0, 22)


@pytest.fixture
def problem():
    roller = nh.Roller(diameter=20, length=20, profile=nh.profile.crown(4000))
    return problem_of(nh.Contact(roller, nh.Plate()), Prescription.checked(None, 3e3, 2e-4, None), nh.SEMI_ELLIPTIC)


def test_a_load_that_is_raised_arrives(problem):
    state = Strips.of(problem, EDGES).raised(problem)
    assert state.converged
    # The loop's tolerance.
    np.testing.assert_allclose(state.load, problem.target[0], rtol=1e-11)


def test_before_a_rise_is_given_up_it_has_been_cut_to_a_thousandth_of_the_load(problem, monkeypatch):
    """Beyond three tenths of the load nothing converges."""
    tried, loop = [], Strips.loop

    def failing(strips, raised, *arguments, **options):
        share = float(raised.target[0] / problem.target[0])
        tried.append(share)
        if share <= 0.3:
            return loop(strips, raised, *arguments, **options)
        nothing = np.zeros(EDGES.size - 1)
        return State(EDGES, nothing, nothing, np.zeros(2), nothing, np.zeros((2, 2)), STAGNATED, 1, np.inf)

    monkeypatch.setattr(Strips, "loop", failing)
    Strips.of(problem, EDGES).raised(problem)
    beyond = min(share for share in tried if share > 0.3)
    reached = max(share for share in tried if share <= 0.3)
    assert beyond - reached < 2e-3
