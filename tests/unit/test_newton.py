"""The Newton loop: how it ends, how fast it gets there, and the stiffness that it leaves."""

import numpy as np
import pytest
from core_pieces import interpret, kernel_of, strips_between

import nonhertz as nh
from nonhertz.bodies.influence import HALF_SPACE, Influence, influence_of
from nonhertz.strip import newton as loop
from nonhertz.strip.influence import remote_of
from nonhertz.strip.records import CONVERGED, ITERATION_LIMIT, STAGNATED, BoundaryConditions, NewtonOptions, Unknowns

STRIPS = 21
EDGES = np.linspace(-10.0, 10.0, STRIPS + 1)
Y = 0.5 * (EDGES[1:] + EDGES[:-1])
RADIUS, TILT = 10.0, 2e-4
CROWN = Y**2 / 8000.0
K_LOAD = 0.0084  # K Q [mm^2], 3 kN on steel: the contact ends inside the body on both sides
GIVEN = BoundaryConditions(np.array([True, False]), np.array([K_LOAD, TILT]))
HALF_SPACES = Influence(HALF_SPACE)


def crowned(influence=HALF_SPACES, separation=CROWN):
    at_depth = influence.at_depth(Y, EDGES)
    return strips_between(EDGES[:-1], EDGES[1:], curvature=1.0 / RADIUS, separation=separation, at_depth=at_depth)


def unknowns_from(r, m, rigid, gap=None):
    return Unknowns(r, m, rigid, np.zeros(STRIPS) if gap is None else gap, np.zeros((2, 2)))


def run(r, m, rigid, *, relaxation=1.0, eager=True, element=nh.SEMI_ELLIPTIC, influence=HALF_SPACES):
    """Press a tilted crowned roller by a load, from a given start: status, steps, residual."""
    strips, kernel = crowned(influence), kernel_of(element, influence.terms)
    options, remote = NewtonOptions(loop.TOLERANCE, relaxation, eager, False), remote_of(strips, kernel, m)
    return loop.newton(strips, GIVEN, kernel, unknowns_from(r, m, rigid), options, remote, np.empty(2))


def start(m=0.05):
    """A plain start: every strip in contact and equally wide."""
    return np.full(STRIPS, 0.025), np.full(STRIPS, m), np.array([0.01, TILT])


def answer(influence=HALF_SPACES):
    r, m, rigid = start()
    assert run(r, m, rigid, influence=influence)[0] == CONVERGED
    return r, m, rigid


def contact(profile=None, **body):
    roller = nh.Roller(diameter=20, length=20, profile=profile or nh.profile.crown(4000), **body)
    return nh.Contact(roller, nh.Plate())


FINITE = influence_of(contact(side_faces="calibrated", images=3), nh.SEMI_ELLIPTIC)
both_kinds = pytest.mark.parametrize("influence", [HALF_SPACES, FINITE], ids=["half-spaces", "finite bodies"])


# How it ends


@pytest.mark.slow
@both_kinds
def test_it_converges_with_the_contact_ending_inside(influence):
    r, m, rigid = start()
    status, steps, residual = run(r, m, rigid, influence=influence)
    assert status == CONVERGED
    assert residual < 1e-11  # the loop's own tolerance
    assert steps <= 12
    assert m[0] == m[-1] == 0.0
    assert abs(np.sum(r * m) * (EDGES[1] - EDGES[0]) / K_LOAD - 1.0) < 1e-11


@both_kinds
def test_any_start_leads_to_the_same_answer(influence):
    _, m, rigid = answer(influence)
    for alone in (0, STRIPS // 2, STRIPS - 1):
        other_r, other_m, other_rigid = start(0.0)
        other_m[alone] = 0.05
        assert run(other_r, other_m, other_rigid, influence=influence)[0] == CONVERGED
        # Both meet the conditions to 1e-11 of the whole contact, which a speck of a strip at its tip hardly sees; the
        # condition of the system costs a digit or two.
        np.testing.assert_allclose(other_m, m, rtol=1e-9, atol=1e-10 * np.max(m))
        np.testing.assert_allclose(other_rigid, rigid, rtol=1e-9, atol=0.0)


def test_steps_cut_to_a_thousandth_run_into_the_limit():
    status, steps, residual = run(*start(), relaxation=1e-3)
    assert status == ITERATION_LIMIT
    assert steps == loop.STEP_LIMIT
    assert residual > 1e-3


def test_a_poisoned_start_stagnates():
    r, m, rigid = start()
    r[3] = np.nan
    assert run(r, m, rigid)[0] == STAGNATED


def test_nothing_in_contact_stagnates():
    status, steps, *_ = run(*start(0.0))
    assert (status, steps) == (STAGNATED, 0)


def hurried(strips, conditions, kernel, unknowns, options, *others):
    return loop.newton(strips, conditions, kernel, unknowns, options._replace(relaxation=1e-3), *others)


def lost(*arguments):
    return STAGNATED, 1, np.inf


def emptied(strips, conditions, kernel, unknowns, *others):
    unknowns.m[:] = 0.0
    return loop.newton(strips, conditions, kernel, unknowns, *others)


@pytest.mark.parametrize(
    ("impaired", "status"),
    [
        (hurried, nh.Status.ITERATION_LIMIT),
        (lost, nh.Status.STAGNATED),
        (emptied, nh.Status.STAGNATED),
    ],
    ids=["limit", "stagnated", "nothing in contact"],
)
def test_a_loop_that_fails_raises_with_the_solution_so_far(monkeypatch, impaired, status):
    interpret(monkeypatch, newton=impaired)
    with pytest.raises(nh.ConvergenceError) as failure:
        nh.solve(contact(), load=7e3, strips=11)
    solution = failure.value.solution
    assert solution.status is status
    assert str(failure.value).startswith(status.value)
    assert solution.strips == 11
    assert solution.error_estimate == nh.ErrorEstimate(*[np.inf] * 5)


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
    strips, kernel = crowned(separation=separation), kernel_of()
    remote = remote_of(strips, kernel, np.full(m.size, max(m.max(), 1e-6)))
    return loop.violation(strips, GIVEN, kernel, remote, unknowns_from(r, m, rigid, gap))


def deepest(rigid):
    return np.max(rigid[0] + rigid[1] * Y - CROWN)


def test_the_check_passes_the_answer():
    assert check(*answer()) < loop.TOLERANCE


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


def kept(arm, at, moment=True):
    """Return which strips are in contact after a lone one at ``at`` is asked for a load at ``arm``."""
    m = np.zeros(STRIPS)
    r = np.zeros(STRIPS)
    r[at], m[at] = 0.025, 0.05
    target = K_LOAD * np.array([1.0, Y[at] + arm])
    loop.pair_lone_strip(
        crowned(), BoundaryConditions(np.array([True, moment]), target), unknowns_from(r, m, np.zeros(2))
    )
    assert np.array_equal(r > 0.0, m > 0.0)
    return np.flatnonzero(m).tolist()


@pytest.mark.parametrize(
    ("arm", "at", "expected"),
    [(0.1, 5, [5, 6]), (-0.1, 5, [4, 5]), (0.0, 5, [5]), (0.1, STRIPS - 1, [STRIPS - 1]), (-0.1, 0, [0])],
)
def test_the_neighbour_on_the_side_of_the_load_joins_a_lone_strip(arm, at, expected):
    assert kept(arm, at) == expected


def test_a_lone_strip_stays_alone_where_the_tilt_is_given():
    assert kept(0.1, 5, moment=False) == [5]


# How fast it gets there


@both_kinds
@pytest.mark.parametrize("element", [nh.SEMI_ELLIPTIC, nh.PARABOLIC], ids=lambda e: e.name)
def test_near_the_answer_the_error_is_squared(element, influence):
    # From 1e-3 off: 1e-6, 1e-12. A Jacobian 1 % wrong would take five steps, each a factor of 100.
    r, m, rigid = start()
    run(r, m, rigid, element=element, influence=influence)
    off = 1e-3 * np.cos(7.0 * Y)
    near = r * (1.0 + off), m * (1.0 - off), rigid * (1.0 + 1e-3)
    status, steps, *_ = run(*near, element=element, influence=influence)
    assert status == CONVERGED
    assert steps <= 3


@both_kinds
def test_stepping_in_both_at_once_leads_to_the_same_answer(influence):
    r, m, rigid = start()
    assert run(r, m, rigid, influence=influence, eager=False)[0] == CONVERGED
    # As for other starts, above.
    _, expected_m, expected_rigid = answer(influence)
    np.testing.assert_allclose(m, expected_m, rtol=1e-9, atol=1e-10 * np.max(m))
    np.testing.assert_allclose(rigid, expected_rigid, rtol=1e-9, atol=0.0)


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
