"""Where the strips lie: equal ones, the user's own, and the automatic grid."""

from dataclasses import dataclass, replace

import numpy as np
import pytest
from core_pieces import strips_between

import nonhertz as nh
from nonhertz.bodies.influence import influence_of
from nonhertz.errors import without_accuracy_warnings
from nonhertz.model.profile import Profile
from nonhertz.native import core
from nonhertz.strip.influence import displacements
from nonhertz.strip.model import model_of

HALF = 10.0
profile = nh.profile


BODIES = {"half-spaces": {"side_faces": "none", "depth": "none"}, "finite bodies": {}}
both = pytest.mark.parametrize("bodies", BODIES.values(), ids=BODIES)


def solved(shape, bodies=BODIES["half-spaces"], *, strips="auto", **prescribed):
    roller = nh.Roller(diameter=20, length=2 * HALF, profile=shape, **bodies)
    return nh.solve(nh.Contact(roller, nh.Plate()), strips=strips, **prescribed)


LOGARITHMIC = profile.logarithmic(amplitude=0.005, length=20, fraction=0.9999)
SYMMETRIC = {
    "ends inside": (profile.crown(1000), {"load": 1000}),
    "ends inside, by approach": (profile.crown(4000), {"approach": 0.004}),
    "crown over sharp ends": (profile.crown(4000), {"load": 20e3}),
    "straight": (profile.straight(), {"load": 20e3}),
    "hollow": (profile.crown(-4000), {"load": 8e3}),
    "logarithmic": (LOGARITHMIC, {"load": 40e3}),
    "ISO": (profile.iso_logarithmic(20, 20), {"load": 20e3}),
    "tapered ends": (profile.tapered_ends(14, 1e-3), {"load": 20e3}),
    "partial crown": (profile.partial_crown(500, 12), {"load": 20e3}),
    "partial crown with a kink": (profile.partial_crown(500, 12, blended=False), {"load": 20e3}),
    "chamfer": (profile.chamfer(20, 0.5), {"load": 20e3}),
}
TILTED = {
    "crown, tilted": (profile.crown(4000), {"load": 3000, "tilt": -5e-4}),
    "logarithmic, tilted": (LOGARITHMIC, {"load": 40e3, "tilt": -1e-3}),
    "logarithmic, by moment": (LOGARITHMIC, {"load": 20e3, "moment": 30e3}),
    "straight, half lifted": (profile.straight(), {"load": 5e3, "tilt": 1e-3}),
}
ONE_INTERVAL = SYMMETRIC | TILTED
KINKED = ("partial crown with a kink", "tapered ends", "chamfer")
SHARP = ("crown over sharp ends", "straight", "hollow", "tapered ends", "partial crown")


def cases(table):
    return pytest.mark.parametrize("case", table.values(), ids=table)


def edges(solution):
    return np.append(solution.y - 0.5 * solution.strip_width, solution.y[-1] + 0.5 * solution.strip_width[-1])


# Automatic


@both
@pytest.mark.parametrize("name", ONE_INTERVAL)
def test_automatic_strips_cover_the_contact_and_are_narrow_where_it_ends(name, bodies):
    shape, prescribed = ONE_INTERVAL[name]
    solution = solved(shape, bodies, **prescribed)
    y, width, all_edges = solution.y, solution.strip_width, edges(solution)
    assert np.all(np.diff(y) > 0.0)
    assert np.all(width > 0.0)
    # They abut: centres and widths are rounded, a few units in the last place of the half length.
    np.testing.assert_allclose((y + 0.5 * width)[:-1], all_edges[1:-1], rtol=0.0, atol=1e-13 * HALF)

    ((first, last),) = solution.contact_y
    low, high = all_edges[[0, -1]]
    assert -HALF * (1.0 + 1e-15) <= low < first + 1e-12
    assert last - 1e-12 < high <= HALF * (1.0 + 1e-15)
    for end, at in ((low, 0), (high, -1)):
        apart = solution.line_load[at] == 0.0 and solution.gap[at] > 0.0
        assert abs(end) > HALF * (1.0 - 1e-15) or apart

    # At the accuracy of 1e-4; marks and features may add a few.
    assert 40 <= solution.strips <= 145
    at_middle = np.argmin(np.abs(y))
    assert solution.line_load[at_middle] > 0.0
    assert abs(y[at_middle]) < 1e-12 * HALF

    bearing = width[solution.line_load > 0.0]
    if "inside" in name or "tilted" in name:
        assert bearing[[0, -1]].max() < 0.9 * bearing.max()
    if name not in KINKED:
        # Neighbours differ little. The outermost strips in contact may be the first of the wider ones outside.
        assert np.max(np.abs(np.diff(np.log(bearing[2:-2])))) < np.log(1.4)
    if name in SHARP:
        # Strips much narrower than a few hundredths of the half-width gain nothing (docs/explain/grid.md).
        share = width / solution.half_width
        assert np.all(share > 1.0 / 40.0)
        assert share[[0, -1]].max() < 0.1
    if name in SYMMETRIC:
        # To rounding: a grid that leans to one side gives a moment where there is none.
        np.testing.assert_allclose(y, -y[::-1], rtol=0.0, atol=1e-9 * HALF)


@dataclass(frozen=True)
class Waves(Profile):
    """Waviness along the axis, from zero to ``height``."""

    height: float
    waves: int
    phase: float

    def relief(self, y):
        place = np.pi * self.waves * np.asarray(y, dtype=float) / HALF + self.phase
        return 0.5 * self.height * (1.0 - np.cos(place))


def displaced_half_spaces(solution, y):
    """Displacement at ``y``, straight from the element's functions."""
    half, a = 0.5 * solution.strip_width, np.maximum(solution.element_half_width, 1e-12)
    upper = solution.element.functions((solution.y + half - y[:, None]) / a)[0]
    lower = solution.element.functions((solution.y - half - y[:, None]) / a)[0]
    return solution.contact.compliance * (upper - lower) @ solution.line_load


def displaced_finite_bodies(solution, y):
    """Displacement at ``y`` with images and depths, as `nonhertz.bodies.influence` lists them."""
    m = solution.element_half_width**2
    q = solution.contact.compliance * solution.line_load
    r = np.divide(q, m, out=np.zeros_like(q), where=m > 0.0)
    influence = influence_of(solution.contact, solution.element)
    return displacements(influence, y, solution.edges, r, m, solution.element)


@pytest.mark.parametrize(
    ("bodies", "displaced"),
    [(BODIES["half-spaces"], displaced_half_spaces), (BODIES["finite bodies"], displaced_finite_bodies)],
    ids=BODIES,
)
@pytest.mark.parametrize(("waves", "phase", "load"), [(1, 1.8, 500), (1, 3.9, 2000), (2, 5.7, 500), (3, 2.7, 2000)])
def test_no_contact_is_missed_between_the_strips(waves, phase, load, bodies, displaced):
    # Many points on the whole length, not strip centres: a wide strip out of contact may hide another interval.
    solution = solved(Waves(0.02, waves, phase), bodies, load=load)
    y = np.linspace(-HALF, HALF, 2001)
    for low, high in solution.contact_y:
        margin = 0.02 * (high - low)  # where the contact ends is known to a strip only
        y = y[(y < low - margin) | (y > high + margin)]
    interference = solution.approach + solution.tilt * y - solution.contact.separation(y)
    # The margin may still hold a little of a strip that straddles an end: 5e-3 of the interference there.
    assert np.min(displaced(solution, y) - interference) > -5e-3 * np.max(solution.interference)


# Chosen


@pytest.mark.filterwarnings("ignore::nonhertz.AccuracyWarning")
@pytest.mark.parametrize("count", [3, 20, 41])
def test_a_number_makes_equal_strips_over_the_whole_length(count):
    solution = solved(profile.crown(4000), load=20e3, strips=count)
    np.testing.assert_allclose(edges(solution), np.linspace(-HALF, HALF, count + 1), rtol=0.0, atol=1e-13 * HALF)


def test_given_edges_are_kept():
    given = np.array([-9.0, -7.0, -3.0, -1.0, 0.5, 2.0, 6.0, 9.5])
    solution = solved(profile.crown(4000), load=3e3, strips=given)
    np.testing.assert_allclose(edges(solution), given, rtol=0.0, atol=1e-13 * HALF)
    as_list = solved(profile.crown(4000), load=3e3, strips=list(given))
    np.testing.assert_array_equal(as_list.line_load, solution.line_load)


# Ends anywhere


ENDS = [0.0, 1e-12, 1e-6, 1e-2]
NEXT_TO_ZERO = {
    "crown": (profile.crown(4000), 1e3),
    "straight": (profile.straight(), 1e3),
    "a speck of load": (profile.iso_logarithmic(20, 20), 1e-2),
    "dimple": (profile.tabulated([-10, -6.01, -6, 6, 6.01, 10], [1, 1, 0, 0, 1, 1]), 1.0),
}


@pytest.mark.filterwarnings("ignore::nonhertz.AccuracyWarning")
@pytest.mark.parametrize("beyond", ENDS, ids=str)
@cases(NEXT_TO_ZERO)
def test_a_body_that_ends_next_to_the_middle_is_solved_as_its_mirror_image_is(case, beyond):
    shape, load = case
    roller = nh.Roller(diameter=20, length=20, profile=shape)
    low, high = (
        nh.solve(nh.Contact(roller, nh.Plate(length=20, position=side * (10.0 - beyond))), load=load)
        for side in (-1.0, 1.0)
    )
    for one in (low, high):
        # Narrower strips would be lost in the rounding of y.
        assert np.min(np.diff(one.edges)) > 1e-10
    both_errors = low.error_estimate.approach + high.error_estimate.approach
    np.testing.assert_allclose(low.approach, high.approach, rtol=both_errors + 1e-9, atol=0.0)


def test_strips_that_all_lie_at_one_side_of_the_middle_ascend():
    # The moment presses one corner of a dimple: nearly all strips are wanted there, and not half a one in the middle.
    dimple = nh.Contact(nh.Roller(diameter=20, length=20, profile=NEXT_TO_ZERO["dimple"][0]), nh.Plate())
    with pytest.warns(nh.AccuracyWarning, match="uncertain"):
        solution = nh.solve(dimple, load=0.0105, moment=0.0365)
    assert np.min(np.diff(solution.edges)) > 1e-10
    np.testing.assert_allclose(solution.load, 0.0105, rtol=1e-9, atol=0.0)


def test_bodies_that_overlap_by_next_to_nothing_are_refused():
    told = r"position = -19\.9999999999 must let the bodies overlap by more than 1e-08"
    with pytest.raises(nh.InputError, match=told):
        nh.Contact(nh.Roller(diameter=20, length=20), nh.Plate(length=20, position=-20 + 1e-10))


@pytest.mark.filterwarnings("ignore::nonhertz.AccuracyWarning")
def test_a_bump_narrower_than_any_sample_is_found():
    # A plateau 24 um wide that stands out to where it touches too, between two of 600 samples.
    place = 7.45
    around = [-10, place - 0.02, place - 0.012, place + 0.012, place + 0.02, 10]
    ridge = profile.tabulated(around, [0, 0, -0.0547, -0.0547, 0, 0], "linear")
    contact = nh.Contact(nh.Roller(diameter=20, length=20, profile=profile.crown(500) + ridge), nh.Plate())
    solution = nh.solve(contact, approach=0.002)
    assert any(low < place < high for low, high in solution.contact_y)


@pytest.mark.slow
@pytest.mark.parametrize("load", [3809.409, 3809.447, 3809.79, 3813.2])
def test_a_peak_at_a_corner_is_resolved_beside_a_middle_that_bears_as_much(load):
    """As long as it was not, it was 4 % too low, just under what the middle bears."""
    roller = nh.Roller(diameter=9.0, length=10.0, corner_radius=0.3, profile=nh.profile.crown(1200.0))
    contact = nh.Contact(roller, nh.Ring(diameter=-55.5, depth=3.25))
    solution = nh.solve(contact, load=load, tilt=0.14592933e-3)
    assert solution.max_pressure_y == pytest.approx(4.7036, abs=1e-3)
    exact = nh.solve(contact, load=load, tilt=0.14592933e-3, accuracy=1e-6).max_pressure
    assert solution.max_pressure == pytest.approx(exact, rel=3e-3)
    assert solution.error_estimate.max_pressure < 0.01


@pytest.mark.slow
def test_a_strip_that_leaves_and_comes_back_takes_no_strips_from_one_of_two_mirror_images():
    """Whole steps drove a strip on a corner of 0.03 mm out again and again: 106 strips, and 112 in the mirror image."""
    shape = nh.profile.partial_crown(893.3939306521892, 17.41565049580703)
    corner = {"corner_radius": 0.027672889463461386}
    roller = nh.Roller(diameter=39.90513602747661, length=27.933595219233624, profile=shape, **corner)
    with without_accuracy_warnings():
        one, other = (
            nh.solve(nh.Contact(roller, nh.Plate()), load=46901.63943623674, moment=sign * 62816.77986540584)
            for sign in (-1.0, 1.0)
        )
        # What was the grid of one only, from its other end.
        again = nh.solve(nh.Contact(roller, nh.Plate()), load=one.load, moment=one.moment, strips=-other.edges[::-1])
    assert one.strips == other.strips == again.strips == 113
    for name in ("approach", "max_pressure"):
        assert getattr(one, name) == pytest.approx(getattr(other, name), rel=1e-8)
        assert getattr(one, name) == pytest.approx(getattr(again, name), rel=1e-8)


def test_a_corner_that_an_end_presses_on_is_found_however_short_the_contact():
    # A speck of contact beside a chamfer: the kink bends the profile at one sample, and strips as narrow as that asked
    # for as far as the next sample were more than any grid has.
    ring = nh.Ring(diameter=-0.3, depth=0.5)
    roller = nh.Roller(diameter=0.06, length=0.2877, side_faces="mirror", depth="none", position=-0.02)
    roller = replace(roller, profile=profile.chamfer(length=0.2877, width=1.2e-5).shifted(0.1034))
    with without_accuracy_warnings():
        solution = nh.solve(nh.Contact(ring, roller), approach=8.65e-19, moment=-3e-17)
    corner = -0.02 + 0.1034 - 0.5 * 0.2877 + 1.2e-5
    assert solution.contact_y[0][0] == pytest.approx(corner, abs=1e-3)
    assert solution.contact_y[0][1] > 0.0


@pytest.mark.parametrize("fine", [np.linspace(-0.5, 0.5, 21), np.linspace(-6.0, 0.5, 66)], ids=["middle", "one side"])
def test_a_strip_beside_the_contact_hides_no_other_contact(fine):
    # The strips beside the fine ones have their centres out of contact, and nearly all of the contact within.
    roller = nh.Roller(diameter=20, length=20, profile=profile.crown(4000))
    edges = np.concatenate([[-10.0], fine, [10.0]])
    with without_accuracy_warnings():
        solution = nh.solve(nh.Contact(roller, nh.Ring(diameter=80)), approach=2e-3, strips=edges)
    assert any("a contact region is missed" in said for said in solution.warnings)


def test_the_approach_at_which_unbounded_bodies_touch_counts_every_bump_in_sight():
    bump = profile.tabulated([-1e5, -8140.0, -8100.0, -8060.0, 1e5], [0, 0, -1e-3, 0, 0], interpolation="linear")
    contact = nh.Contact(nh.Ring(diameter=1200, profile=bump), nh.Plate())
    with pytest.raises(nh.InputError, match=r"must exceed -0\.000999") as refused:
        nh.solve(contact, approach=-1.1e-3, strips=3)
    assert refused.value.field == "approach"


@pytest.mark.filterwarnings("ignore::nonhertz.AccuracyWarning")
def test_every_point_of_a_rough_table_is_looked_at():
    # 72 points of a measured line, more kinks than count as such; two stand out, and few samples of 600 see the lower.
    y = np.linspace(-15.0, 15.0, 72)
    relief = np.where(np.arange(72) % 2 == 0, 2e-4, 3e-4)
    relief[[41, 46]] = [-1.40e-4, -1.67e-4]
    contact = nh.Contact(nh.Roller(diameter=5, length=30, profile=profile.tabulated(y, relief, "linear")), nh.Plate())
    solution = nh.solve(contact, approach=-1.39e-4)
    assert [sum(low < y[at] < high for low, high in solution.contact_y) for at in (41, 46)] == [1, 1]


@pytest.mark.parametrize(("low", "high", "cut"), [(-10.0, 2.0, [False, True]), (-2.0, 10.0, [True, False])])
def test_strips_that_end_within_the_contact_are_cut_off_there(low, high, cut):
    grid, state = crowned_on_part(low, high, 30)
    assert [core.reaches(grid, state.m, side) for side in (-1, 1)] == cut


def parabola(edges):
    """Strips, and m = 1 - y^2 where that is positive."""
    y = 0.5 * (edges[1:] + edges[:-1])
    return strips_between(edges), np.maximum(1.0 - y**2, 0.0)


def test_the_fall_towards_an_end_is_the_distance_at_which_half_the_summit_is_left():
    grid, m = parabola(np.linspace(-2.0, 2.0, 401))
    for side in (-1, 1):
        # m = 1 - y^2 is a half at 0.7071; between centres it is interpolated.
        np.testing.assert_allclose(core.fall(grid, m, -1.0, 1.0, side), 1.0 - np.sqrt(0.5), rtol=0.0, atol=2e-3)


def test_near_a_place_counts_the_widest_of_three_strips_in_contact():
    grid, m = parabola(np.linspace(-2.0, 2.0, 41))
    bearing = np.flatnonzero(m > 0.0)
    np.testing.assert_allclose(core.width_near(grid, m, 1.5), np.sqrt(m[bearing[-3:]].max()), rtol=1e-12, atol=0.0)
    np.testing.assert_allclose(core.width_near(grid, m, -1.5), np.sqrt(m[bearing[:3]].max()), rtol=1e-12, atol=0.0)
    assert core.width_near(grid, np.zeros_like(m), 0.0) == 0.0


def crowned_on_part(low, high, strips):
    model = model_of(nh.Contact(nh.Roller(diameter=20, length=20, profile=profile.crown(2000)), nh.Plate()))
    return approached(model, 0.01, np.linspace(low, high, strips + 1))


def approached(model, approach, edges):
    """A grid, and its state at an approach."""
    grid = model.grid(edges)
    return grid, core.solve_on(grid, (False, False), (approach, 0.0), model.kernel)


def test_a_kink_counts_in_contact_and_in_the_strips_beside_it():
    grid, state = crowned_on_part(-10.0, 10.0, 40)
    last = np.flatnonzero(state.m > 0.0)[-1]
    assert last < state.m.size - 4
    near = [core.is_nearly_touching(grid, state.m, float(grid.y[at])) for at in range(last, last + 4)]
    assert near == [True, True, False, False]


def test_an_overlap_is_found_where_it_is_and_as_wide_as_it_is():
    y = np.linspace(-15.0, 15.0, 72)
    relief = np.where(np.arange(72) % 2 == 0, 2e-4, 3e-4)
    relief[[41, 46]] = [-1.40e-4, -1.67e-4]
    contact = nh.Contact(nh.Roller(diameter=5, length=30, profile=profile.tabulated(y, relief, "linear")), nh.Plate())
    model = model_of(contact)
    ((place, width),) = core.overlaps(model, *approached(model, -1.39e-4, np.linspace(4.3, 4.6, 31)), -15.0, 15.0)
    np.testing.assert_allclose(place, y[41], rtol=0.0, atol=1e-3)
    # One micrometre over a fall of 0.34 um (0.44 um) in 0.42 mm either way, seen twice as wide, in five strips.
    assert 1e-4 < width < 2e-3


def test_an_overlap_right_beside_a_contact_is_none_of_its_own():
    model = model_of(nh.Contact(nh.Roller(diameter=20, length=20, profile=profile.crown(2000)), nh.Plate()))
    grid, state = approached(model, 0.01, np.linspace(-9.0, -2.0, 61))
    ((begin, end),) = core.intervals(grid.edges, state.m)
    ((place, width),) = core.overlaps(model, grid, state, -10.0, 10.0)
    # In five strips, from the first of 600 samples that is a fiftieth of the contact's length beyond its end.
    assert 0.0 <= place - 2.5 * width - (end + 0.02 * (end - begin)) < 20.0 / 600.0


@pytest.mark.parametrize(("share", "extra"), [(1.0, None), (0.5, None), (1.0, 0.4)])
def test_strips_are_laid_as_a_coarser_solution_calls_for(share, extra):
    grid, state = crowned_on_part(-10.0, 10.0, 40)
    ((first, last),) = core.intervals(grid, state.m)
    model = model_of(nh.Contact(nh.Roller(diameter=20, length=20, profile=profile.crown(2000)), nh.Plate()))
    wanted = [] if extra is None else [(extra, 0.01)]
    laid = np.array(core.lay(model, grid, state, -10.0, 10.0, wanted, 0.28, share, 40.0))
    assert laid[0] == -10.0
    assert laid[-1] == 10.0
    # An edge lies on each end of the contact, and the middle of a strip on y = 0.
    assert {first, last} <= set(laid.tolist())
    middle = np.searchsorted(laid, 0.0)
    assert laid[middle] == pytest.approx(-laid[middle - 1], rel=1e-12)
    widths, whole = np.diff(laid), core.lay(model, grid, state, -10.0, 10.0, wanted, 0.28, 1.0, 40.0)
    assert laid.size - 1 == pytest.approx(share * (len(whole) - 1), abs=2)
    if extra is not None:
        at = np.searchsorted(laid, extra) - 1
        assert 0.005 < widths[at] < 0.015
        assert widths[at] == widths.min()


def test_more_strips_than_the_limit_are_not_laid():
    grid, state = crowned_on_part(-10.0, 10.0, 40)
    model = model_of(nh.Contact(nh.Roller(diameter=20, length=20, profile=profile.crown(2000)), nh.Plate()))
    narrow = [(place, 0.01) for place in np.linspace(-1.0, 1.0, 21)]
    counts = [len(core.lay(model, grid, state, -10.0, 10.0, narrow, 1.0, 1.0, limit)) - 1 for limit in (30.0, 1000.0)]
    assert counts[0] <= 32 < counts[1]


@pytest.mark.parametrize(
    ("shape", "places", "turn"),
    [
        (profile.tapered_ends(14, 1e-3), [-7.0, 7.0], np.tan(1e-3)),
        (profile.partial_crown(500, 12, blended=True), [], 0.0),  # only the curvature jumps
    ],
    ids=["kinks", "none"],
)
def test_a_kink_is_where_the_slope_jumps(shape, places, turn):
    contact = nh.Contact(nh.Roller(diameter=20, length=20, profile=shape), nh.Plate())
    kinks, turns = core.kinks_among(model_of(contact), np.array(contact.bends), 20.0)
    np.testing.assert_allclose(kinks, places, rtol=1e-12)
    np.testing.assert_allclose(turns, turn, rtol=1e-6)


def test_first_strips_see_a_contact_that_falls_between_those_along_the_bodies():
    # 24 strips have their middle edge where a crown touches; its contact is 0.06 mm long.
    model = model_of(nh.Contact(nh.Roller(diameter=20, length=20, profile=profile.crown(500)), nh.Plate()))
    given = (False, False), (1e-6, 0.0)
    assert not core.is_feasible(model, np.linspace(-10.0, 10.0, 25), *given)
    edges = core.first_strips(model, *given)
    assert core.is_feasible(model, edges, *given)
    assert edges[-1] - edges[0] < 1.0


@pytest.mark.parametrize("side", [-1.0, 1.0])
def test_a_grid_cut_from_an_end_next_to_the_middle_does_not_depend_on_the_unit_of_length(side):
    # 5 mm are next to the middle of 20 m, in strips, if not in millimetres.
    def edges(times):
        roller = nh.Roller(diameter=20 * times, length=20 * times, profile=profile.crown(4000 * times))
        plate = nh.Plate(length=20 * times, position=side * (10.0 - 5e-3) * times)
        with without_accuracy_warnings():
            return nh.solve(nh.Contact(roller, plate), load=1e3 * times**2).edges

    np.testing.assert_allclose(edges(1024.0) / 1024.0, edges(1.0), rtol=1e-6, atol=1e-9)


@pytest.mark.parametrize("summit", [3.2, 3.25])  # apart at 3.0 and 3.5, as deep in both for the second
def test_a_summit_between_samples_is_looked_at_and_where_there_is_no_body_none_is(summit):
    y = np.linspace(0.0, 10.0, 21)
    depth = 1e-3 - (y - summit) ** 2
    depth[y > 6.0] = -np.inf
    np.testing.assert_allclose(core.summits_of(y, depth), [summit], rtol=1e-12, atol=0.0)
    assert core.summits_of(y, depth - 2e-3).size == 0
    assert core.summits_of(y, np.full(21, -np.inf)).size == 0
