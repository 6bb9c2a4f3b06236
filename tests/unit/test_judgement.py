"""What the core says of strips that are solved: errors from coarser grids, and what strips do not see."""

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.errors import without_accuracy_warnings
from nonhertz.native import core
from nonhertz.strip.model import model_of

EDGES = np.linspace(-10.0, 10.0, 42)


def on_plate(profile):
    return nh.Contact(nh.Roller(diameter=20, length=20, profile=profile, side_faces="none", depth="none"), nh.Plate())


CROWNED = on_plate(nh.profile.crown(600))
MODEL = model_of(CROWNED)


def level_of(solution, model=MODEL, **changes):
    """The state of a solution, or of one that differs from it."""
    compliance, squares = solution.contact.compliance, solution.element_half_width**2
    ratios = np.divide(compliance * solution.line_load, squares, out=np.zeros_like(squares), where=squares > 0.0)
    known = {
        "r": ratios, "m": squares, "gap": solution.gap, "rigid": (solution.approach, solution.tilt),
        "stiffness": compliance * solution.stiffness, "status": core.Status.CONVERGED, "steps": 1, "residual": 0.0,
    }  # fmt: skip
    return core.Level(model, solution.edges, core.State(**known | changes))


def judged(*levels, model=MODEL, accuracy=0.0, by_force=(True, False)):
    return core.judge(model, by_force, (0.0, 0.0), list(levels), accuracy)


@pytest.fixture(scope="module")
def solved():
    """A contact that runs out on its strips."""
    return nh.solve(CROWNED, load=5e3, strips=EDGES)


@pytest.mark.parametrize(
    ("changes", "left"),
    [
        # Twice the last change; half of that before where the last is small by chance.
        ((0.02, 0.03), 0.04), ((0.0, 0.1), 0.1), ((0.02,), 0.04),
        # Unknown without two levels.
        ((), np.inf),
    ],
)  # fmt: skip
def test_what_is_left_follows_from_the_last_changes(solved, changes, left):
    coarser = [level_of(solved, rigid=(solved.approach - share * solved.penetration, 0.0)) for share in changes]
    assert judged(level_of(solved), *coarser).errors.approach == pytest.approx(left, rel=1e-3)


@pytest.mark.parametrize(("change", "left"), [(0.01, 0.4 * 0.01), (0.0, 0.9e-4)])
def test_strips_that_follow_the_ends_leave_less_but_never_nothing(solved, change, left):
    coarser = level_of(solved, rigid=(solved.approach - change * solved.penetration, 0.0))
    errors = judged(level_of(solved), coarser, accuracy=1e-4).errors
    assert errors.approach == pytest.approx(left, rel=1e-3)


def test_what_is_prescribed_has_no_error(solved):
    errors = judged(level_of(solved), level_of(solved), by_force=(False, True)).errors
    assert (errors.approach, errors.moment) == (0.0, 0.0)
    assert errors.load > 0.0
    assert errors.tilt > 0.0


def test_of_a_loop_that_failed_no_error_is_known(solved):
    errors = judged(level_of(solved, status=core.Status.STAGNATED)).errors
    assert [errors.approach, errors.load, errors.max_pressure, errors.moment, errors.tilt] == [np.inf] * 5


def test_a_state_that_is_not_finite_passes_no_check(solved):
    wide = judged(level_of(solved, m=np.where(solved.half_width > 0.0, np.nan, 0.0))).checks
    assert not wide.radius_ratio <= 1.0
    assert np.isnan(wide.half_width)
    nowhere = judged(level_of(solved, m=np.zeros(solved.strips)))
    assert nowhere.contact == []
    assert nowhere.max_pressure == nowhere.max_half_width == 0.0


def test_mirrored_contacts_are_judged_alike():
    sides = []
    for sign in (1.0, -1.0):
        contact = on_plate(nh.profile.crown(600).shifted(1.3 * sign))
        with without_accuracy_warnings():
            solution = nh.solve(contact, load=60e3, tilt=sign * 1e-4, strips=31)
        model = model_of(contact)
        sides.append(judged(level_of(solution, model), model=model))
    one, other = sides
    assert one.max_pressure == pytest.approx(other.max_pressure, rel=1e-9)
    assert one.max_pressure_y == pytest.approx(-other.max_pressure_y, rel=1e-9)
    assert [end.kind for end in one.ends] == [end.kind for end in other.ends][::-1]
    assert one.errors.max_pressure == pytest.approx(other.errors.max_pressure, rel=1e-6)
    assert one.checks.unevenness == pytest.approx(other.checks.unevenness, rel=1e-6)
    assert one.penetration == pytest.approx(other.penetration, rel=1e-9)


@pytest.mark.parametrize("at", [-7.0, 7.0])
def test_a_crest_within_the_outermost_strip_counts(at):
    wedge = nh.profile.tabulated([-20.0, at, 20.0], [0.3, 0.0, 0.3], interpolation="linear")
    contact = nh.Contact(nh.Roller(diameter=20, length=20, profile=wedge), nh.Plate())
    edges = np.array([-10.0, 0.0, 10.0])
    assert core.penetration(model_of(contact), edges, (0.1, 0.0)) == pytest.approx(0.1)


class Waved(nh.profile.Profile):
    """Waves of this height above and below their mean, much shorter than the contact is wide."""

    height = 1e-4

    def relief(self, y):
        return self.height * (1.0 + np.cos(2.0 * np.pi * np.asarray(y, dtype=float) / 0.0317))


def test_waves_depart_from_every_parabola_by_their_root_mean_square(solved):
    assert judged(level_of(solved)).checks.unevenness < 1e-8
    model = model_of(on_plate(Waved()))
    found = judged(level_of(solved, model, rigid=(1.0, 0.0)), model=model).checks.unevenness
    # The parabola takes three of nine numbers, which could be any.
    assert found == pytest.approx(Waved.height / np.sqrt(2.0) * np.sqrt(6.0 / 9.0), rel=0.2)
    # The approach is off by as much, within strips instead of half-widths, of 1 mm that the bodies approach.
    level = level_of(solved, model, rigid=(1.0, 0.0))
    assert judged(level, level, model=model).errors.approach == pytest.approx(found, rel=0.5)


def test_each_end_is_as_sharp_as_the_strip_beside_it_is_narrow():
    edges = np.array([-10.0, -9.5, -4.0, 3.0, 9.0, 10.0])
    model = model_of(on_plate(nh.profile.straight()))
    state = core.State(r=np.ones(5), m=np.full(5, 1e-2), gap=np.zeros(5), rigid=(1e-2, 0.0), stiffness=np.eye(2),
                       status=core.Status.CONVERGED, steps=1, residual=0.0)  # fmt: skip
    singular = judged(core.Level(model, edges, state), model=model).singular
    assert [(end.y, end.width) for end in singular] == [(-10.0, 0.5), (10.0, 1.0)]


def test_bodies_overlap_beyond_strips_that_end_within_the_contact():
    with without_accuracy_warnings():
        part = nh.solve(CROWNED, approach=5e-3, strips=np.linspace(-1.0, 1.0, 12))
    checks = judged(level_of(part), by_force=(False, False)).checks
    # The surface beside it is lifted by less than the bodies overlap there.
    assert 0.0 < checks.missed < 5e-3
    assert 1.0 < abs(checks.missed_y) < 2.5


@pytest.mark.parametrize("kept", [-1.6, -0.6])
def test_what_is_missed_on_one_side_is_missed_on_the_other(solved, kept):
    found = []
    for sign in (-1.0, 1.0):
        some = np.where(sign * solved.y < kept, solved.element_half_width**2, 0.0)
        found.append(judged(level_of(solved, m=some)).checks)
    assert found[0].missed > 0.0
    assert found[0].missed == pytest.approx(found[1].missed, rel=1e-9)
    assert found[0].missed_y == pytest.approx(-found[1].missed_y, rel=1e-9)


@pytest.mark.parametrize("seed", range(4))
def test_a_summit_on_uneven_strips_may_be_as_much_higher_as_its_mirror_image(seed):
    """Any numbers will do for the half-widths."""
    drawn = [np.random.default_rng(seed).uniform(0.02, 0.05, count) for count in (41, 20)]
    ends = []
    for turned in (1, -1):
        levels = []
        for half in drawn:
            n, edges = half.size, np.linspace(-10.0, 10.0, half.size + 1)
            state = core.State(r=np.ones(n), m=half[::turned] ** 2, gap=np.zeros(n), rigid=(1e-2, 0.0),
                               stiffness=np.eye(2), status=core.Status.CONVERGED, steps=1, residual=0.0)  # fmt: skip
            levels.append(core.Level(MODEL, edges, state))
        ends.append(judged(*levels).errors.max_pressure)
    assert ends[0] == pytest.approx(ends[1], rel=1e-9)
