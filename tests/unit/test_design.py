"""Designs: gradients along variables, optima that are known, and what must hold."""

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.figures.value import Line
from nonhertz.files.free_forms import FreeForm, parse_free_form
from nonhertz.plot.drawer import sheet_of
from nonhertz.result.quantities import QUANTITIES
from nonhertz.study.design import optimize, pareto
from nonhertz.study.design_task import check_design, find_starts
from nonhertz.study.figures import design_figures, front_figures
from nonhertz.study.limits import limits_in
from nonhertz.study.objective import Variable
from nonhertz.study.search import _Searcher

pytestmark = pytest.mark.filterwarnings("ignore::nonhertz.AccuracyWarning")

ROLLER = nh.Roller(diameter=20, length=20, profile=nh.profile.crown(radius=4000), side_faces="none", depth="none")
PLATE = nh.Plate(side_faces="none", depth="none")
CASE = nh.Case(nh.Contact(ROLLER, PLATE), {"load": 20e3}, {"strips": 41})
LOADS = [nh.life.ContactLoadCase(load=20e3, share=0.7), nh.life.ContactLoadCase(load=20e3, share=0.3, tilt=0.7e-3)]
RADIUS = {"body.a.profile.radius": "1500 mm : 30000 mm"}


def asked(vary, goal="pressure", loads=None, constraints=None, case=CASE):
    return check_design(case, vary, goal, loads or LOADS, constraints, None, None)[0]


@pytest.mark.parametrize("goal", ["pressure", "life"])
@pytest.mark.parametrize(
    ("vary", "x"),
    [
        (RADIUS, [0.4]),
        ({"body.a.diameter": "15 mm : 25 mm"}, [0.3]),
        ({"body.a.profile": "free(40 um, 3)"}, [0.3, 0.3, 0.5]),
    ],
)
def test_derivatives_are_those_of_differences(goal, vary, x):
    # So light that contacts end where they run out: beside ends without a limit, places move with the half-width.
    light = [replace(each, load=3e3, tilt=0.3 * each.tilt) for each in LOADS]
    task, x = asked(vary, goal, light), np.array(x)
    judged = task.at(x)
    peaks = judged.peaks()
    slopes = judged.slope_of_damage()[None] if goal == "life" else judged.slopes_of_peaks(peaks)
    for k in range(x.size):
        values = []
        for step in (-2e-3, 2e-3):
            moved = x.copy()
            moved[k] += step
            there = task.at(moved)
            if goal == "life":
                values.append([math.log(there.damage)])
            else:
                values.append([math.log(there.solutions[n].pressure(0.0, y)) for n, y, _ in peaks])
        differences = (np.array(values[1]) - np.array(values[0])) / 4e-3
        # Strips are equal, so that they stay where they are; the differences err by the square of their step.
        np.testing.assert_allclose(slopes[:, k], differences, atol=0.02 * np.abs(slopes).max())


@pytest.mark.slow
def test_the_crown_for_a_load_is_the_best_of_many():
    found = optimize(CASE, bounds=RADIUS, loads=LOADS, n_starts=3, workers=1)
    radii = np.geomspace(1500.0, 30000.0, 60)
    swept = nh.sweep(
        CASE, over={"body.a.profile.radius": radii, "load.tilt": [0.0, 0.7e-3]}, quantities=("max_pressure",), workers=1
    )
    least = swept["max_pressure"].max(axis=1).min()
    assert found.value <= least * 1.001
    assert found.value == pytest.approx(least, rel=5e-3)
    assert found.value < found.before
    assert found.agreeing == 3
    assert found.worst in {"20 kN without tilt", "20 kN at 0.7 mrad"}
    # At the ends of bands the goal is worse by the cost.
    (narrow, wide) = found.bands
    assert wide.low <= narrow.low <= found.values["body.a.profile.radius"] <= narrow.high <= wide.high
    for cost, band in ((0.01, narrow), (0.05, wide)):
        for radius in (band.low, band.high):
            bodies = replace(ROLLER, profile=nh.profile.crown(radius=radius))
            there = max(
                nh.solve(nh.Contact(bodies, PLATE), load=each.load, tilt=each.tilt, strips=41).max_pressure
                for each in LOADS
            )
            assert there / found.value - 1.0 == pytest.approx(cost, abs=4e-3)


@pytest.mark.parametrize(("low", "high", "said"), [(1500.0, 2000.0, "highest"), (4e3, 6e3, "lowest"), (2e3, 4e3, "")])
def test_an_optimum_at_an_end_of_its_range_is_warned_of(low, high, said):
    found = optimize(CASE, bounds={"body.a.profile.radius": (low, high)}, loads=LOADS, n_starts=1, workers=1)
    words = f"The best body.a.profile.radius is the {said} of its range, {low:g} to {high:g} mm: "
    assert [each.startswith(words) for each in found.warnings] == ([True] if said else [])
    assert [each.kind for each in found.findings] == (["at-bound"] if said else [])


def test_the_longest_life_is_longer_than_that_of_neighbours():
    found = optimize(CASE, bounds=RADIUS, goal="life", loads=LOADS, n_starts=2, workers=1)
    assert found.value > 1.0
    assert found.before == 1.0
    task = asked(RADIUS, "life")
    x = task.variables[0].share(found.values["body.a.profile.radius"])
    here = task.at(np.array([x])).damage
    assert all(task.at(np.array([x + step])).damage > here for step in (-0.05, 0.05))
    assert "% of the damage" in found.worst
    figure = design_figures(found)["design"]
    upright, tilted, profiles, searches = figure.panels
    assert [panel.heading for panel in (upright, tilted)] == ["20 kN without tilt", "20 kN at 0.7 mrad"]
    lines = {mark.name: mark for mark in tilted.marks if isinstance(mark, Line)}
    solution = nh.solve(found.case.contact, load=20e3, tilt=0.7e-3, strips=41)
    assert np.interp(solution.y, lines["designed"].x, lines["designed"].y) == pytest.approx(solution.centre_pressure)
    assert [mark.y.tolist() for mark in profiles.marks] == [relief.tolist() for relief in found.relief[1:]]
    assert {mark.name: mark.y[-1] for mark in searches.marks} == {
        f"start {number}": start.value for number, start in enumerate(found.starts, start=1)
    }
    axes, *_ = sheet_of(figure).axes
    assert axes.get_ylim()[0] == 0.0


@pytest.mark.slow
def test_without_tilt_a_free_profile_comes_close_to_uniform_pressure():
    case = nh.Case(CASE.contact, {"load": 20e3}, {})
    found = optimize(case, bounds={"body.a.profile": "free(60 um, 6)"}, n_starts=1, workers=1)
    solution = nh.solve(found.case.contact, load=20e3)
    # The search ends to the accuracy of the case, wherever a less accurate one led it.
    assert found.starts[0].history[-1] == found.value == pytest.approx(solution.max_pressure, rel=1e-6)
    inner = np.abs(solution.y) < 8.0
    # Six steps leave a ripple; eight are within 2 % over 90 % of the length (docs/benchmarks/studies.md).
    assert np.ptp(solution.centre_pressure[inner]) < 0.05 * solution.max_pressure
    y, relief, was = found.relief
    half = y.size // 2
    assert np.all(np.diff(relief[half:]) >= -1e-12)
    np.testing.assert_allclose(relief, relief[::-1], atol=1e-12)
    assert np.any(relief != was)


@pytest.mark.slow
def test_limits_hold_under_every_load():
    free = optimize(CASE, bounds=RADIUS, loads=LOADS, n_starts=2, workers=1)
    most = max(nh.solve(free.case.contact, load=each.load, tilt=each.tilt, strips=41).approach for each in LOADS)
    held = optimize(
        CASE, bounds=RADIUS, loads=LOADS, n_starts=2, workers=1, constraints={"approach": f"at most {0.95e3 * most} um"}
    )
    for each in LOADS:
        assert nh.solve(held.case.contact, load=each.load, tilt=each.tilt, strips=41).approach <= 0.951 * most
    assert held.value > free.value
    # One that has no gradient is met by differences.
    least = free_stiffness(free)
    stiff = optimize(
        CASE,
        bounds=RADIUS,
        loads=LOADS,
        n_starts=2,
        workers=1,
        constraints={"load_by_approach": f"at least {1.01 * least}"},
    )
    assert free_stiffness(stiff) >= 1.009 * least


def test_margins_by_differences_are_those_of_gradients():
    task, x = (
        asked(RADIUS, constraints={"approach": "at most 30 um", "max_pressure": "at least 1500 MPa"}),
        np.array([0.4]),
    )
    judged = task.at(x)
    approach, pressure = ([getattr(each, name) for each in judged.solutions] for name in ("approach", "max_pressure"))
    expected = [*(1.0 - np.array(approach) / 0.03), *(np.array(pressure) / 1500.0 - 1.0)]
    np.testing.assert_allclose(judged.margins(), expected, rtol=1e-12)
    exact = judged.slopes_of_margins()
    # Over a hundredth of the way between the bounds.
    np.testing.assert_allclose(_Searcher(task)._differences(x, len(exact)), exact, rtol=0.05)


def free_stiffness(found):
    """Return the least stiffness against approach under all loads."""
    contact = found.case.contact
    return min(nh.solve(contact, load=each.load, tilt=each.tilt, strips=41).stiffness[0, 0] for each in LOADS)


def test_a_limit_that_nothing_meets_is_told_with_how_much_is_missing():
    with pytest.raises(nh.InputError, match=r"every start falls short, by .* % at least"):
        optimize(CASE, bounds=RADIUS, n_starts=1, workers=1, constraints={"approach": "at most 1 um"})


@pytest.mark.slow
def test_no_point_of_a_front_is_better_than_another_in_both():
    case = replace(CASE, solver={"strips": 31})
    found = pareto(case, first=LOADS[:1], second=LOADS[1:], bounds=RADIUS, points=3, n_starts=1, workers=1)
    assert len(found.first) == 3
    assert np.all(np.diff(found.first) <= 1e-3 * found.first[0])
    assert np.all(np.diff(found.second) >= -1e-3 * found.second[0])
    assert found.first[0] > found.first[-1]
    assert found.second[0] < found.second[-1]
    # The point between is the best of those that have the pressure between, under the second loads.
    assert found.second[1] == pytest.approx(0.5 * (found.second[0] + found.second[-1]), rel=1e-3)
    assert found.warnings == ()


def test_points_of_a_front_at_an_end_of_a_range_are_warned_of():
    case, vary = replace(CASE, solver={"strips": 11}), {"body.a.profile.radius": (1500.0, 2000.0)}
    found = pareto(case, first=LOADS[:1], second=LOADS[1:], bounds=vary, points=3, n_starts=1, workers=1)
    figure = front_figures(found, ("upright", "tilted"))["front"]
    (line,) = figure.panels[0].marks
    assert (line.x.tolist(), line.y.tolist()) == (list(found.first), list(found.second))
    assert figure.to_csv().splitlines()[0] == "panel,line,upright [MPa],value,unit"
    (axes,) = sheet_of(figure).axes
    assert axes.get_xlabel() == "Maximum pressure, upright [MPa]"
    every = f"at {len(found.first)} of {len(found.first)} points"
    said = f"The best body.a.profile.radius is the highest of its range, 1500 to 2000 mm, {every}: "
    assert [each.startswith(said) for each in found.warnings] == [True]


def test_bounds_of_a_free_profile_are_those_of_its_steps():
    form, half, rng = FreeForm(0.06, 5, steepest=0.004, roundest=300.0), 9.5, np.random.default_rng(1)
    shares = 0.4 * rng.random(5)
    y, relief = form.places(half), form.relief(shares)
    slopes = np.diff(relief) / np.diff(y)
    both = np.concatenate([-slopes[:1], slopes])
    middles = np.concatenate([-0.5 * y[1:2], 0.5 * (y[1:] + y[:-1])])
    curvatures = np.diff(both) / np.diff(middles)
    margins, gradient = form.margins(shares, half)
    expected = [1.0 - relief[-1:] / 0.06, 1.0 - slopes / 0.004, 1.0 - 300.0 * curvatures, 1.0 + 300.0 * curvatures]
    np.testing.assert_allclose(margins, np.concatenate(expected), rtol=1e-12)
    for k in range(5):
        step = 1e-6 * np.eye(5)[k]
        change = (form.margins(shares + step, half)[0] - form.margins(shares - step, half)[0]) / 2e-6
        np.testing.assert_allclose(gradient[:, k], change, atol=1e-6 * np.abs(gradient).max())


@pytest.mark.slow
def test_a_free_profile_stays_within_the_slope_and_the_curvature_that_it_may_have():
    loose, bound = (
        optimize(CASE, bounds={"body.a.profile": text}, loads=LOADS, n_starts=2, workers=1)
        for text in ("free(60 um, 5)", "free(60 um, 5, slope 2 mrad, radius 2000 mm)")
    )
    (tables,) = bound.case.document["body"]["a"]["profile"]
    y, relief = np.array(tables["y"]), np.array(tables["relief"])
    slopes = np.diff(relief) / np.diff(y)
    curvatures = np.diff(slopes) / np.diff(0.5 * (y[1:] + y[:-1]))
    assert np.abs(slopes).max() <= 2e-3 * (1.0 + 1e-3)
    assert np.abs(curvatures).max() <= 1.0 / 2000.0 * (1.0 + 1e-3)
    assert loose.value < bound.value < bound.before


def test_a_free_profile_grows_from_the_middle():
    form = parse_free_form("body.a.profile", "free(60 um, 4)")
    assert form == FreeForm(0.06, 4)
    np.testing.assert_allclose(form.relief([0.1, 0.2, 0.3, 0.4]), 0.06 * np.cumsum([0.0, 0.01, 0.04, 0.09, 0.16]))
    assert form.places(10.0)[-1] == pytest.approx(10.0)
    assert parse_free_form("x", "1 um : 2 um") is None
    assert parse_free_form("x", "free(60 um, slope 5 mrad)") == FreeForm(0.06, 8, 0.005)
    assert parse_free_form("x", "free(60 um, 4, radius 0.2 m, slope 5 mrad)") == FreeForm(0.06, 4, 0.005, 200.0)
    for text in (
        *(
            "free(0)",
            "free(60 um, 1)",
            "free(60)",
            "free(60 um, 8, slope 0)",
            "free(60 um, slope 1 mrad, slope 2 mrad)",
        ),
        *("free(60 um, slope 1 mm)", "free(60 um, 8, 3)", "free(60 um, 8, steep 1 mrad)", "free()"),
    ):
        with pytest.raises(nh.InputError):
            parse_free_form("x", text)


BY_ITS_DROP = nh.Case.of(
    {
        "body": {"a": {"diameter": 20.0, "length": 20.0, "profile": {"kind": "crown", "drop": "9 um"}}, "b": {}},
        "load": {"load": "20 kN"},
    },
    Path("case.toml"),
)


@pytest.mark.parametrize(
    ("given", "what"),
    [
        ({"bounds": {}}, "must name a path"),
        ({"bounds": {"body.a.profile.radiu": "1 m : 2 m"}}, "Did you mean body.a.profile.radius"),
        ({"bounds": {"body.a.profile.radius": "2 m : 1 m"}}, "must ascend"),
        ({"bounds": {"body.a.material": "steel"}}, "change gradually"),
        ({"case": BY_ITS_DROP}, "beside body.a.profile.drop, which replaces it in the case: vary that"),
        ({"bounds": {"body.a.length": (-1.0, 2.0)}}, "be valid in the case"),
        ({"goal": "beauty"}, "goal = 'beauty' must be one of"),
        ({"loads": []}, "be load cases"),
        ({"loads": LOADS[:1]}, "must add up to 1"),
        ({"constraints": {"aproach": "at most 1 um"}}, "Unknown quantity aproach. Did you mean approach"),
        ({"constraints": {"approach": "1 um"}}, "begin with 'at most' or 'at least'"),
        ({"constraints": {"approach": "at most 0 um"}}, "must not be zero"),
        ({"goal": "life", "model": nh.life.ioannides_harris()}, "fatigue_limit"),
        ({"n_starts": 0}, "n_starts = 0 must be"),
        ({"case": nh.Case(CASE.contact, {"approach": 0.01})}, "have a load"),
    ],
)
def test_what_cannot_be_designed_is_refused_in_one_sentence(given, what):
    with pytest.raises(nh.InputError, match=what) as caught:
        optimize(**{"case": CASE, "bounds": RADIUS, "workers": 1} | given)
    assert len(str(caught.value).splitlines()) == 1


def test_searches_begin_all_over_a_range_but_not_at_its_ends():
    vary = RADIUS | {"body.a.diameter": "15 mm : 25 mm"}
    now, *spread = find_starts(asked(vary), 17)
    np.testing.assert_allclose(now, [math.log(4000 / 1500) / math.log(30000 / 1500), 0.5])
    low, high = np.min(spread, axis=0), np.max(spread, axis=0)
    assert np.all((low > 0.0) & (low < 0.15) & (high > 0.85) & (high < 1.0))


def test_a_wide_range_is_searched_in_its_logarithm():
    assert Variable("drop", 2e-3, 0.2).value(0.5) == pytest.approx(0.02)
    assert Variable("diameter", 15.0, 25.0).value(0.5) == 20.0


def test_limits_are_read_with_their_units():
    most, least = limits_in({"approach": "at most 30 um", "load_by_approach": "at least 5e5"}, QUANTITIES)
    assert (most.most, most.least) == (0.03, None)
    assert (least.most, least.least) == (None, 5e5)
