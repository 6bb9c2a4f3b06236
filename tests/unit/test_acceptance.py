"""The last check: no solution leaves the package that does not meet what was prescribed."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import nonhertz as nh
from nonhertz.bearing.equilibrium import States
from nonhertz.errors import without_accuracy_warnings
from nonhertz.model.prescription import Prescription
from nonhertz.native import core
from nonhertz.result.maximum import largest_pressure
from nonhertz.result.outcome import outcome, restore, states_of_levels
from nonhertz.solver.one import problem_of, result_of
from nonhertz.strip.influence import kernel_of

FINITE = nh.Contact(
    nh.Roller(diameter=20, length=20, profile=nh.profile.crown(2000), side_faces="calibrated"), nh.Ring(diameter=80)
)
BY_FORCE, BY_MOTION = {"load": 8e3, "moment": 4e3}, {"approach": 0.02, "tilt": 2e-4}
PARTLY = {"load": 2e3, "tilt": 5e-4}  # lifts off on one side


def solved(given, contact=FINITE):
    problem = problem_of(contact, Prescription(**given), nh.SEMI_ELLIPTIC)
    return problem, result_of(problem, 31)


def verdict(problem, state):
    """What is said of a state that claims to have converged."""
    with pytest.raises(nh.ConvergenceError) as caught:
        outcome(problem, restore(problem, [state], 0.0, accepted=False))
    assert caught.value.solution.status is nh.Status.REFUTED
    return str(caught.value)


def changed_of(result, changed):
    """The finest state of a result with some of its arrays changed."""
    finest = states_of_levels(result)[0]._replace(rigid=np.array(result.rigid), stiffness=np.array(result.stiffness))
    return finest._replace(**{name: change(finest) for name, change in changed.items()})


def bearing(state):
    return int(np.argmax(state.m))


def idle(state):
    return int(np.flatnonzero(state.m == 0.0)[0])


def at(name, place, value):
    """A change of one entry of an array of the state."""

    def changed(state):
        array = getattr(state, name).copy()
        array[place(state)] = value(array[place(state)]) if callable(value) else value
        return array

    return changed


def middles(state):
    return 0.5 * (state.edges[1:] + state.edges[:-1])


@pytest.mark.parametrize("given", [BY_FORCE, BY_MOTION, PARTLY], ids=["forces", "motions", "partly"])
def test_a_solution_passes(given):
    assert outcome(*solved(given)).status is nh.Status.CONVERGED


@pytest.mark.parametrize(
    ("given", "changed", "words"),
    [
        (BY_FORCE, {"r": lambda state: 1.0001 * state.r}, "The load of the state reached is 8000.8 N, not 8000."),
        (
            BY_FORCE,
            {"r": lambda state: state.r * (1.0 + 1e-4 * (middles(state) - 0.5))},
            "The moment of the state reached is",
        ),
        (
            BY_MOTION,
            {"rigid": lambda state: state.rigid * [1.001, 1.0]},
            "The approach of the state reached",
        ),
        (BY_MOTION, {"rigid": lambda state: state.rigid * [1.0, 0.9]}, "The tilt of the state reached is 0.00018 rad"),
        (BY_MOTION, {"r": at("r", bearing, np.nan)}, "not finite"),
        (BY_MOTION, {"gap": at("gap", bearing, np.nan)}, "not finite"),
        (BY_MOTION, {"stiffness": lambda state: state.stiffness * np.nan}, "The stiffness"),
        (BY_MOTION, {"stiffness": lambda state: -state.stiffness}, "the equilibrium is unstable"),
        (
            BY_MOTION,
            {"stiffness": lambda state: state.stiffness * [[1.0, 0.0], [0.0, -1.0]]},
            "the equilibrium is unstable",
        ),
        (BY_MOTION, {"r": at("r", bearing, lambda r: -r)}, "has tension at y ="),
        (BY_MOTION, {"r": at("r", bearing, lambda r: 1.0001 * r)}, "leaves a gap"),
        (PARTLY, {"gap": at("gap", idle, 0.0)}, "leaves a gap"),
        (PARTLY, {"rigid": lambda state: np.add(state.rigid, [1e-4, 0.0])}, "leaves a gap"),
        (BY_MOTION, {"m": lambda state: 1.0001 * state.m, "r": lambda state: state.r / 1.0001}, "leaves a gap"),
    ],
)
def test_what_is_not_one_is_refuted_in_words(given, changed, words):
    problem, result = solved(given)
    told = verdict(problem, changed_of(result, changed))
    assert words in told
    assert told.endswith("Try another number of strips, or a smaller load first.")


def test_a_single_strip_that_resists_no_tilt_is_a_solution():
    with without_accuracy_warnings():
        alone = nh.solve(FINITE, load=8e3, strips=1)
    assert alone.status is nh.Status.CONVERGED
    assert abs(alone.stiffness[1, 1]) < 1e-6 * alone.stiffness[0, 0]


def test_an_interference_that_rounding_hides_is_no_solution_alone_or_among_many():
    # Tilt times y is 0.1 mm and rounded to 1e-17, the interference 2e-14.
    contact = nh.Contact(nh.Roller(diameter=20, length=20, side_faces="none", depth="none"), nh.Plate(depth="none"))
    edges = np.linspace(9.999999, 10.0, 12)
    given = {"approach": 2e-14 - 1e-2 * np.mean(edges[-2:]), "tilt": 1e-2, "strips": edges}
    with without_accuracy_warnings():
        with pytest.raises(nh.ConvergenceError, match="which is lost in the rounding of tilt and relief"):
            nh.solve(contact, **given)
        many = nh.solve_many(contact, **{**given, "approach": [given["approach"]]})
    assert not many.converged[0]


def test_bodies_that_overlap_out_of_contact_are_refuted():
    _, result = solved(PARTLY)
    state = changed_of(result, {})
    nearer = 0.1 * (middles(state) < -8.0)
    bump = nh.profile.tabulated([-10.0, -8.001, -7.999, 10.0], [-0.1, -0.1, 0.0, 0.0], interpolation="linear")
    body = replace(FINITE.a, profile=FINITE.a.profile + bump)
    sharp, _ = solved(PARTLY, replace(FINITE, a=body))
    assert "overlap by" in verdict(sharp, state._replace(gap=state.gap - nearer))


def test_surfaces_of_another_curvature_are_refuted():
    _, result = solved(BY_MOTION)
    rounder, _ = solved(BY_MOTION, replace(FINITE, b=replace(FINITE.b, diameter=79.9)))
    assert "the curvatures across the contact do not match" in verdict(rounder, changed_of(result, {}))


def test_a_loop_that_is_mistaken_of_itself_is_not_believed():
    """Springs are no solution, even if their state claims to be one."""
    problem, result = solved(BY_FORCE)
    edges, y = result.edges, middles(states_of_levels(result)[0])
    none, sharper = np.zeros((0, 0)), np.full(y.shape, 0.1)
    grid = core.Grid(edges, FINITE.curvature(y), FINITE.separation(y), np.full(y.shape, np.inf), sharper, none, none)
    springs = core.start_from_springs(
        grid, problem.by_force, problem.target, kernel_of(problem.model.influence, nh.SEMI_ELLIPTIC)
    )
    wrong = changed_of(result, {})._replace(r=springs.r, m=springs.m, rigid=springs.rigid)
    assert "The state reached leaves a gap" in verdict(problem, wrong)


def conforming():
    faces = {"side_faces": "none", "depth": "none"}
    wide = nh.Contact(nh.Roller(diameter=94, length=19, **faces), nh.Ring(diameter=-94.3))
    return wide, {"load": 1.15e6, "moment": 9.6e6, "strips": 50}


def test_a_solution_that_is_reached_in_steps_is_refused_for_its_width():
    # Rises in steps from a small load: a share of it is no solution, and the whole one is wider than the roller.
    contact, given = conforming()
    with without_accuracy_warnings():
        many = nh.solve_many(contact, **given)
        with pytest.raises(nh.InputError, match=r"load = 1150000\.0 must leave the half-width, 80\.7 mm"):
            nh.solve(contact, **given)
    assert not np.any(many.converged)
    assert isinstance(many.failures[0], nh.InputError)


class Broken(nh.profile.Straight):
    """A profile of the user's own with a fault."""

    def relief(self, y):
        raise ZeroDivisionError("of the user's own")


@pytest.mark.parametrize("strips", [None, 11], ids=str)
def test_a_case_that_raises_does_not_take_the_others_with_it(strips):
    good = nh.Contact(nh.Roller(diameter=20, length=20, profile=nh.profile.crown(4000)), nh.Plate())
    bad = nh.Contact(nh.Roller(diameter=20, length=20, profile=Broken()), nh.Plate())
    many = nh.solve_many([good, bad, good], load=1e3, strips=strips)
    assert many.converged.tolist() == [True, False, True]
    assert isinstance(many.failures[1], ZeroDivisionError)


@pytest.mark.filterwarnings("ignore:The requested accuracy of:nonhertz.AccuracyWarning")
def test_of_two_solutions_the_one_that_the_bodies_can_stay_in_is_found():
    # 4.5 times as wide as long: on the first grid the loop ends in an unsymmetric state of negative stiffness.
    contact = nh.Contact(nh.Body(diameter=100, profile=nh.profile.crown(5)), nh.Plate())
    hertz = nh.hertz.point_contact(radius_x=50, radius_y=5, compliance=contact.compliance, load=500)
    with pytest.warns(nh.AccuracyWarning, match="wider than long"):
        solution = nh.solve(contact, load=500, accuracy=1e-5)
    assert solution.stiffness[1, 1] > 0.0
    np.testing.assert_allclose(solution.stiffness[0, 0], 1.5 * 500 / hertz.approach, rtol=0.05, atol=0.0)


# A table 0.1 um long with three contacts, of which the last one ends with the table.
SHORT = nh.Contact(
    nh.Body(
        diameter=131.11712674119833,
        profile=nh.profile.tabulated(
            np.linspace(-1.0, 1.0, 6) * 6.426589668581528e-05,
            [
                1.332649575584776e-10, 2.4873141557468044e-12, 9.966748098683935e-11,
                4.5450439069657607e-11, 1.3771021492241595e-10, 1.3999210961049497e-11,
            ],
        ),
    ),
    nh.Plate(),
)  # fmt: skip
TOUCHING = 1.0660334299590901e-10


@pytest.mark.parametrize("scale", [1.0, 10.0, 1e4])
def test_a_tiny_contact_with_an_end_has_a_largest_pressure(scale):
    made = SHORT.a.profile
    profile = nh.profile.tabulated(scale * np.array(made.y), scale * np.array(made.values))
    contact = nh.Contact(nh.Body(diameter=scale * SHORT.a.diameter, profile=profile), nh.Plate())
    with without_accuracy_warnings():
        found = nh.solve(contact, approach=scale * TOUCHING)
        many = nh.solve_many(contact, approach=[scale * TOUCHING])
    assert 0.0 < found.max_pressure <= found.centre_pressure.max()
    assert 0.0 < found.max_half_width <= found.half_width.max()
    assert many.max_pressure[0] == found.max_pressure
    # The same body at another size has the same pressures, and half-widths in proportion.
    assert found.max_half_width / scale == pytest.approx(1.0238e-4, rel=1e-3)


@settings(max_examples=200, deadline=None)
@given(st.integers(0, 2**32 - 1))
def test_the_largest_pressure_is_never_above_that_of_all_strips(seed):
    rng = np.random.default_rng(seed)
    count = int(rng.integers(3, 20))
    y = np.cumsum(10.0 ** rng.uniform(-6.0, 0.0, count))
    pressure, half_width = 10.0 ** rng.uniform(0.0, 5.0, count), 10.0 ** rng.uniform(-6.0, 1.0, count)
    apart = rng.random(count) < 0.2
    pressure[apart] = half_width[apart] = 0.0
    ends = rng.choice(np.concatenate([y, y + 1e-3, y[:1] - 1e-6, y[-1:] + 1e-6]), int(rng.integers(1, 4)))
    highest, place = largest_pressure(y, pressure, half_width, ends)
    assert 0.0 <= highest <= pressure.max() * (1.0 + 1e-12)
    assert y[0] <= place <= y[-1]


@pytest.mark.parametrize("towards", [-1.0, 1.0])
def test_of_two_maxima_that_mirror_each_other_the_first_along_the_contact_is_named(towards):
    y, half_width = np.array([-3.0, -2.0, 0.0, 2.0, 3.0]), np.full(5, 0.1)
    pressure = np.array([1.0, 2.0, 1.0, 2.0, 1.0]) * (1.0 + towards * 1e-12 * np.sign(y))
    assert largest_pressure(y, pressure, half_width, np.empty(0)) == (pressure.max(), -2.0)
    assert largest_pressure(y, pressure, half_width, np.array([-2.05]))[1] == 2.0


def test_no_patch_whose_results_are_not_numbers_leaves_as_converged(monkeypatch):
    monkeypatch.setattr("nonhertz.patch.solution.PatchSolution._largest", (np.nan, 0.0), raising=False)
    with pytest.raises(nh.ConvergenceError, match="The max_pressure is nan, not a finite number"):
        nh.patch.solve(FINITE, load=8e3, cells=(16, 32))


def test_a_state_of_a_bearing_with_a_load_that_is_not_a_number_is_not_settled():
    shapes = [(5,), (5,), (5, 5), (), (), (3, 3), (3, 2, 2), (3, 2, 7)]
    states = States(*(np.zeros((2, *shape)) for shape in shapes))
    assert states.converged(1e-9).tolist() == [True, True]
    states.answer[1, 2, 0, 0] = np.nan
    assert states.converged(1e-9).tolist() == [True, False]
    states.force[0, 3] = np.inf
    assert states.converged(1e-9).tolist() == [False, False]
