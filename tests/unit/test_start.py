"""Where the Newton loop starts: independent springs carry exactly what is prescribed."""

import numpy as np
import pytest
from core_pieces import kernel_of, state_of, strips_between

from nonhertz.native import core

EDGES = np.linspace(-10.0, 10.0, 42)
Y, WIDTH = 0.5 * (EDGES[1:] + EDGES[:-1]), np.diff(EDGES)
CROWN = Y**2 / 2000.0


def winkler_state(prescribed, target, separation=CROWN):
    strips = strips_between(EDGES, separation=separation)
    state = core.start_from_springs(strips, prescribed, target, kernel_of())
    return state.r * state.m, np.array(state.rigid)


@pytest.mark.parametrize("moment", [0.0, 1e-2, -3e-2])
def test_springs_carry_load_and_moment(moment):
    q, _ = winkler_state([True, True], [1e-2, moment])
    np.testing.assert_allclose(np.sum(q * WIDTH), 1e-2, rtol=1e-9, atol=0.0)
    # A start: the bracket around the tilt is 1e-10 wide, of which the moment sees the tenfold at most.
    np.testing.assert_allclose(np.sum(q * Y * WIDTH), moment, rtol=1e-8, atol=1e-11)


@pytest.mark.parametrize("tilt", [0.0, 1e-3])
def test_springs_carry_the_load_at_a_tilt(tilt):
    q, rigid = winkler_state([True, False], [1e-2, tilt])
    np.testing.assert_allclose(np.sum(q * WIDTH), 1e-2, rtol=1e-12, atol=0.0)
    assert rigid[1] == tilt
    assert np.all((q > 0.0) == (rigid[0] + tilt * Y > CROWN))


def test_springs_keep_a_prescribed_approach_and_tilt():
    _, rigid = winkler_state([False, False], [0.01, 2e-4])
    assert rigid.tolist() == [0.01, 2e-4]


def test_an_infinite_relief_bears_nothing():
    q, _ = winkler_state([True, False], [1e-2, 0.0], np.where(np.abs(Y) > 5.0, np.inf, CROWN))
    assert np.all(q[np.abs(Y) > 5.0] == 0.0)


def test_no_contact_is_left_when_the_moment_vanishes_only_there():
    # A hump at y = 6 alone: without contact there is no moment, with contact there always is.
    q, _ = winkler_state([False, True], [0.001, 0.0], np.where(np.abs(Y - 6.0) < 1.0, 0.0, 1.0))
    assert np.all(q == 0.0)


def test_a_parabola_is_prolonged_to_where_it_ends():
    m = np.maximum(1.0 - (Y / 6.3) ** 2, 0.0)
    edges = np.linspace(-9.925, 9.925, 398)
    finer, near = 0.5 * (edges[1:] + edges[:-1]), state_of(np.full(Y.size, 0.025), m, (0.01, 2e-4))
    found = core.start_from_other(strips_between(EDGES), near, strips_between(edges), (True, False), (1e-2, 3e-4))
    assert np.all(found.r == 0.025)
    assert found.rigid == [0.01, 3e-4]
    # A chord continued over one more strip misses the parabola by twice (strip / 6.3)^2.
    within = 2.0 * (WIDTH[0] / 6.3) ** 2
    np.testing.assert_allclose(found.m, np.maximum(1.0 - (finer / 6.3) ** 2, 0.0), rtol=0.0, atol=within)
    ends = finer[found.m > 0.0][[0, -1]]
    np.testing.assert_allclose(ends, [-6.3, 6.3], rtol=0.0, atol=0.1)
