"""The Newton loop: how it ends, how fast it gets there, and the stiffness that it leaves."""

import numpy as np
import pytest
from core_pieces import kernel_of, state_of, strips_between

import nonhertz as nh
from nonhertz.bodies.influence import HALF_SPACE, Influence, influence_of
from nonhertz.model.prescription import Prescription
from nonhertz.native import core
from nonhertz.result.outcome import LevelState, outcome, restore
from nonhertz.solver.one import problem_of

STRIPS = 21
EDGES = np.linspace(-10.0, 10.0, STRIPS + 1)
Y = 0.5 * (EDGES[1:] + EDGES[:-1])
RADIUS, TILT = 10.0, 2e-4
CROWN = Y**2 / 8000.0
K_LOAD = 0.0084  # K Q [mm^2], 3 kN on steel: the contact ends inside the body on both sides
GIVEN = (True, False), (K_LOAD, TILT)
CONVERGED, ITERATION_LIMIT, STAGNATED = core.Status
STEP_LIMIT = 60
HALF_SPACES = Influence(HALF_SPACE)


def crowned(influence=HALF_SPACES, separation=CROWN):
    at_depth = influence.at_depth(Y, EDGES)
    return strips_between(EDGES, curvature=1.0 / RADIUS, separation=separation, at_depth=at_depth)


def run(r, m, rigid, *, given=GIVEN, element=nh.SEMI_ELLIPTIC, influence=HALF_SPACES, **options):
    """Press a tilted crowned roller by a load, from a given start."""
    kernel = kernel_of(element, influence.terms)
    return core.newton(crowned(influence), *given, kernel, state_of(r, m, rigid), **options)


def start(m=0.05):
    """A plain start: every strip in contact and equally wide."""
    return np.full(STRIPS, 0.025), np.full(STRIPS, m), np.array([0.01, TILT])


def answer(influence=HALF_SPACES):
    state = run(*start(), influence=influence)
    assert state.status == CONVERGED
    return state.r, state.m, np.array(state.rigid)


def contact(profile=None, **body):
    roller = nh.Roller(diameter=20, length=20, profile=profile or nh.profile.crown(4000), **body)
    return nh.Contact(roller, nh.Plate())


FINITE = influence_of(contact(side_faces="calibrated", images=3), nh.SEMI_ELLIPTIC)
both_kinds = pytest.mark.parametrize("influence", [HALF_SPACES, FINITE], ids=["half-spaces", "finite bodies"])


# How it ends


@pytest.mark.slow
@both_kinds
def test_it_converges_with_the_contact_ending_inside(influence):
    state = run(*start(), influence=influence)
    assert state.status == CONVERGED
    assert state.residual < 1e-11  # the loop's own tolerance
    assert state.steps <= 12
    assert state.m[0] == state.m[-1] == 0.0
    assert abs(np.sum(state.r * state.m) * (EDGES[1] - EDGES[0]) / K_LOAD - 1.0) < 1e-11


@both_kinds
def test_any_start_leads_to_the_same_answer(influence):
    _, m, rigid = answer(influence)
    for alone in (0, STRIPS // 2, STRIPS - 1):
        other_r, other_m, other_rigid = start(0.0)
        other_m[alone] = 0.05
        other = run(other_r, other_m, other_rigid, influence=influence)
        assert other.status == CONVERGED
        # Both meet the conditions to 1e-11 of the whole contact, which a speck of a strip at its tip hardly sees; the
        # condition of the system costs a digit or two.
        np.testing.assert_allclose(other.m, m, rtol=1e-9, atol=1e-10 * np.max(m))
        np.testing.assert_allclose(other.rigid, rigid, rtol=1e-9, atol=0.0)


def test_steps_cut_to_a_thousandth_run_into_the_limit():
    state = run(*start(), relaxation=1e-3)
    assert state.status == ITERATION_LIMIT
    assert state.steps == STEP_LIMIT
    assert state.residual > 1e-3


def test_a_poisoned_start_stagnates():
    r, m, rigid = start()
    r[3] = np.nan
    assert run(r, m, rigid).status == STAGNATED


def test_nothing_in_contact_stagnates():
    state = run(*start(0.0))
    assert (state.status, state.steps) == (STAGNATED, 0)


def ended(status):
    """What is said of a contact whose loop has ended so."""
    problem = problem_of(contact(), Prescription(load=7e3, tilt=0.0), nh.SEMI_ELLIPTIC)
    edges, nothing = np.linspace(-10.0, 10.0, 12), np.zeros(11)
    left = LevelState(edges, nothing, nothing, nothing, (0.01, 0.0), ((0.0, 0.0), (0.0, 0.0)), int(status), 60, np.inf)
    with pytest.raises(nh.ConvergenceError) as failure:
        outcome(problem, restore(problem, [left], 0.0))
    return failure.value


@pytest.mark.parametrize("name", ["ITERATION_LIMIT", "STAGNATED"])
def test_a_loop_that_fails_raises_with_the_solution_so_far(name):
    failure = ended(core.Status[name])
    assert failure.solution.status is nh.Status[name]
    assert str(failure).startswith(nh.Status[name].value)
    assert failure.solution.strips == 11
    assert failure.solution.error_estimate == nh.ErrorEstimate(*[np.inf] * 5)


def test_a_contact_may_be_much_wider_than_long():
    """The loop gives up on half-widths that diverge, and on nothing that a disc can have."""
    disc = nh.Roller(diameter=4000.0, length=0.5, side_faces="none", depth="none")
    with pytest.warns(nh.AccuracyWarning):
        solution = nh.solve(nh.Contact(disc, nh.Plate()), load=2500.0, strips=5)
    assert solution.half_width.min() > 10.0 * 0.25
    # To the loop's tolerance.
    np.testing.assert_allclose(solution.line_load @ np.diff(solution.edges), 2500.0, rtol=1e-11)


# What is checked once it has converged


def check(r, m, rigid, separation=CROWN, gap=None):
    """Return what the last check finds wrong with a state on half-spaces under the load, and fill ``gap``."""
    found, state = core.violation(crowned(separation=separation), *GIVEN, kernel_of(), state_of(r, m, rigid))
    if gap is not None:
        gap[:] = state.gap
    return found


def deepest(rigid):
    return np.max(rigid[0] + rigid[1] * Y - CROWN)


def test_the_check_passes_the_answer():
    assert check(*answer()) < core.TOLERANCE


@pytest.mark.parametrize("error", [1e-3, -1e-3])
def test_the_check_sees_a_gap_or_an_overlap_in_contact(error):
    r, m, rigid = answer()
    scale = deepest(rigid)
    separation = CROWN.copy()
    # Beside the deepest strip, so that the depth it is measured by stays as it is.
    separation[np.argmax(m) + 2] -= error * scale
    np.testing.assert_allclose(check(r, m, rigid, separation), 1e-3, rtol=1e-6)


def test_the_check_sees_an_overlap_out_of_contact():
    r, m, rigid = answer()
    gap, separation = np.zeros(STRIPS), CROWN.copy()
    check(r, m, rigid, gap=gap)
    separation[0] -= gap[0] + 1e-3 * deepest(rigid)
    assert gap[0] > 0.0
    np.testing.assert_allclose(check(r, m, rigid, separation), 1e-3, rtol=1e-6)


def test_the_check_sees_another_load():
    r, m, rigid = answer()
    # Loads a thousandth higher move the surface a thousandth further.
    np.testing.assert_allclose(check(1.001 * r, m, rigid), 1e-3, rtol=1e-6)


# A lone strip


@pytest.mark.parametrize("alone", [0, 5, STRIPS - 1])
@pytest.mark.parametrize("arm", [2.5, -2.5])
def test_a_lone_strip_is_joined_by_a_neighbour_where_load_and_moment_are_given(alone, arm):
    r, m, rigid = start(0.0)
    m[alone] = 0.05
    state = run(r, m, rigid, given=((True, True), (K_LOAD, K_LOAD * arm)))
    assert state.status == CONVERGED
    q = state.r * state.m * np.diff(EDGES)
    np.testing.assert_allclose([q.sum(), q @ Y], [K_LOAD, K_LOAD * arm], rtol=1e-10)


def test_a_lone_strip_stays_alone_below_its_load():
    r, m, _ = start(0.0)
    m[5] = 0.05
    light = 1e-7 * K_LOAD
    state = run(r, 1e-6 * m, np.array([1e-6, Y[5] / 4000.0]), given=((True, True), (light, light * Y[5])))
    assert state.status == CONVERGED
    assert np.flatnonzero(state.m).tolist() == [5]


# How fast it gets there


@both_kinds
@pytest.mark.parametrize("element", [nh.SEMI_ELLIPTIC, nh.PARABOLIC], ids=lambda e: e.name)
def test_near_the_answer_the_error_is_squared(element, influence):
    # From 1e-3 off: 1e-6, 1e-12. A Jacobian 1 % wrong would take five steps, each a factor of 100.
    state = run(*start(), element=element, influence=influence)
    off = 1e-3 * np.cos(7.0 * Y)
    near = state.r * (1.0 + off), state.m * (1.0 - off), np.array(state.rigid) * (1.0 + 1e-3)
    state = run(*near, element=element, influence=influence)
    assert state.status == CONVERGED
    assert state.steps <= 3


@both_kinds
def test_stepping_in_both_at_once_leads_to_the_same_answer(influence):
    state = run(*start(), influence=influence, eager=False)
    assert state.status == CONVERGED
    # As for other starts, above.
    _, expected_m, expected_rigid = answer(influence)
    np.testing.assert_allclose(state.m, expected_m, rtol=1e-9, atol=1e-10 * np.max(expected_m))
    np.testing.assert_allclose(state.rigid, expected_rigid, rtol=1e-9, atol=0.0)


# The stiffness

SHAPES = {
    "contact ends inside": ({}, 0.01, 2e-4),
    "sharp ends": ({"profile": nh.profile.straight()}, 0.02, 5e-4),
    "shifted": ({"profile": nh.profile.crown(4000, centre=2.0), "position": 1.0}, 0.012, -1e-4),
    "two intervals": ({"profile": nh.profile.crown(-4000)}, 0.004, 1e-4),
}
BODIES = {
    "half-space": {"side_faces": "none", "depth": "none"},
    "finite": {"side_faces": "calibrated", "images": 3},
    "free faces": {"side_faces": "free", "depth": "none"},
}
CASES = {
    f"{name}, {kind}": (contact(**shape, **body), approach, tilt)
    for name, (shape, approach, tilt) in SHAPES.items()
    for kind, body in BODIES.items()
}


@pytest.mark.filterwarnings("ignore:The (load|maximum pressure) is uncertain")
@pytest.mark.parametrize("case", CASES.values(), ids=CASES)
@pytest.mark.parametrize("element", [nh.SEMI_ELLIPTIC, nh.PARABOLIC], ids=lambda e: e.name)
def test_stiffness_is_the_derivative_of_the_solution(case, element):
    # Central differences: steps of 1e-4 leave 1e-8, and the loop's tolerance of 1e-11 over the step 1e-7.
    pressed, approach, tilt = case
    steps = np.diag([1e-4 * approach, 1e-4 * approach / 10.0])

    def state(motion):
        solution = nh.solve(pressed, approach=approach + motion[0], tilt=tilt + motion[1], strips=21, element=element)
        return solution, np.array([solution.load, solution.moment])

    solution, _ = state(np.zeros(2))
    for k in range(2):
        (ahead, after), (behind, before) = state(steps[k]), state(-steps[k])
        assert ahead.contact_y[0][0] < 0.0 < ahead.load  # in contact at all
        assert np.array_equal(ahead.line_load > 0.0, behind.line_load > 0.0)  # no strip came or went
        change = (after - before) / (2.0 * steps[k, k])
        scale = np.array([solution.load, 10.0 * solution.load]) / steps[k, k] * 1e-4
        np.testing.assert_allclose(solution.stiffness[:, k] / scale, change / scale, rtol=1e-6, atol=1e-6)


@pytest.mark.parametrize("radius_y", [30.0, 100.0, 3000.0])
def test_stiffness_of_an_ellipse_is_that_of_hertz(radius_y):
    # 3/2 Q / delta. On strips the stiffness goes up and down with the place of the contact's end within its
    # strip, twenty times the error of the load itself: 1e-3 on an automatic grid.
    compliance = 2.0 * nh.Material(modulus=207000, poisson=0.3).compliance
    hertz = nh.hertz.point_contact(radius_x=10, radius_y=radius_y, compliance=compliance, load=100)
    roller = nh.Body(diameter=20, profile=nh.profile.crown(radius_y))
    solution = nh.solve(nh.Contact(roller, nh.Plate()), load=100)
    np.testing.assert_allclose(solution.stiffness[0, 0], hertz.stiffness, rtol=3e-3, atol=0.0)
