"""Tolerances: quantiles and indices of functions whose are known."""

import contextlib
import math
import sqlite3
from dataclasses import replace

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.files.sampling import Sampling
from nonhertz.files.spreads import Distribution
from nonhertz.show.sections import Table
from nonhertz.show.studies import tolerance_sections
from nonhertz.study.pictures import tolerance_figures
from nonhertz.study.store import FILE
from nonhertz.study.tolerances import quantile, sobol_indices

ROLLER = nh.Roller(diameter=20, length=20, profile=nh.profile.crown(radius=4000), side_faces="none", depth="none")
PLATE = nh.Plate(side_faces="none", depth="none")
CASE = nh.Case(nh.Contact(ROLLER, PLATE), {"load": 20e3}, {"strips": 31})


def ishigami(x, a=7.0, b=0.1):
    """Return Ishigami and Homma's function (1990), whose indices have closed forms."""
    return np.sin(x[:, 0]) + a * np.sin(x[:, 1]) ** 2 + b * x[:, 2] ** 4 * np.sin(x[:, 0])


def drawn(function, distributions, count, seed):
    """Return the results of Saltelli's arrangement in blocks."""
    sampling = Sampling(count, "saltelli", seed)
    return function(sampling.drawn(distributions)).reshape(-1, len(distributions) + 2)


def test_indices_of_the_ishigami_function_are_within_their_intervals():
    a, b, pi = 7.0, 0.1, math.pi
    variance = a**2 / 8.0 + b * pi**4 / 5.0 + b**2 * pi**8 / 18.0 + 0.5
    alone = {"x1": 0.5 * (1.0 + b * pi**4 / 5.0) ** 2, "x2": a**2 / 8.0, "x3": 0.0}
    together = 8.0 * b**2 * pi**8 / 225.0
    total = {"x1": alone["x1"] + together, "x2": alone["x2"], "x3": together}
    inside = 0
    for seed in range(10):
        blocks = drawn(ishigami, [Distribution("uniform", (-pi, pi))] * 3, 10_000, seed)
        found = sobol_indices(("x1", "x2", "x3"), blocks)
        assert [each.path for each in found] == ["x1", "x2", "x3"]
        for each in found:
            inside += each.first_low <= alone[each.path] / variance <= each.first_high
            inside += each.total_low <= total[each.path] / variance <= each.total_high
            assert each.total_high - each.total_low < 0.2
    # Of 60 intervals of 95 %, that four or more are missed has a probability of 0.35 for independent samples; samples
    # that fill space evenly are closer.
    assert inside >= 57


def test_indices_of_a_linear_function_are_its_squared_slopes():
    slopes = np.array([3.0, 2.0, 1.0])
    blocks = drawn(lambda x: x @ slopes, [Distribution("normal", (0.0, 1.0))] * 3, 10_000, 5)
    for each, slope in zip(sobol_indices(("a", "b", "c"), blocks), slopes, strict=True):
        assert each.first_low <= slope**2 / 14.0 <= each.first_high
        assert each.total_low <= slope**2 / 14.0 <= each.total_high
        # The variance of Janon's estimate for normal pairs of correlation s is (1 - s^2)^2 / n or less.
        assert each.first == pytest.approx(slope**2 / 14.0, abs=2.0 / math.sqrt(len(blocks)))
        assert each.total == pytest.approx(slope**2 / 14.0, abs=2.0 / math.sqrt(len(blocks)))


@pytest.mark.parametrize("count", [40, 400])
def test_indices_and_their_intervals_stay_between_0_and_1_where_one_parameter_does_it_all(count):
    for seed in range(5):
        blocks = drawn(lambda x: 5.0 + x[:, 1], [Distribution("normal", (0.0, 1.0))] * 3, count, seed)
        first, *others = sobol_indices(("a", "b", "c"), blocks)
        assert (first.path, first.first) == ("b", 1.0)
        assert 0.0 < first.total_low <= first.total <= first.total_high <= 1.0
        for each in others:
            assert each.total == 0.0
            assert 0.0 == each.first_low <= each.first <= each.first_high < 1.0


@pytest.mark.parametrize("share", [0.01, 0.5, 0.99])
def test_intervals_hold_the_true_quantile_as_often_as_they_say(share):
    generator = np.random.default_rng(3)
    true = Distribution("normal", (0.0, 1.0)).quantile(share)
    found = [quantile(generator.standard_normal(400), share) for _ in range(2000)]
    held = np.mean([each.low <= true <= each.high for each in found])
    # 95 % or a little more, as numbers are whole: three standard errors of 2000 trials are 1.5 %.
    assert 0.935 <= held <= 0.99
    assert all(each.low <= each.value <= each.high for each in found)


def test_of_few_samples_the_interval_says_so():
    found = quantile(np.arange(20.0), 0.99)
    assert math.isinf(found.high)
    nothing = quantile(np.zeros(0), 0.5)
    assert math.isnan(nothing.value)
    assert (nothing.low, nothing.high) == (-math.inf, math.inf)


def test_intervals_of_quantiles_hold_for_the_samples_that_are_drawn():
    slopes = np.array([3.0, 2.0, 1.0])
    true = Distribution("normal", (0.0, math.sqrt(14.0))).quantile(0.9)
    held = 0
    for seed in range(40):
        blocks = drawn(lambda x: x @ slopes, [Distribution("normal", (0.0, 1.0))] * 3, 2000, seed)
        found = quantile(blocks[:, [0, -1]].ravel(), 0.9)
        held += found.low <= true <= found.high
    assert held >= 36


@pytest.mark.parametrize("method", ["random", "saltelli"])
def test_samples_have_a_number_of_parameters(method):
    for asked in (Sampling(40, method).shares, Sampling(40, method).size):
        with pytest.raises(nh.InputError, match="dimensions = 0 must be a whole number"):
            asked(0)


def test_in_a_block_of_samples_one_parameter_differs_from_the_first():
    found = Sampling(40, "saltelli", 2).shares(3).reshape(-1, 5, 3)
    assert len(found) == 8
    for k in range(3):
        np.testing.assert_array_equal(found[:, k + 1, k], found[:, -1, k])
        others = [j for j in range(3) if j != k]
        np.testing.assert_array_equal(found[:, k + 1][:, others], found[:, 0][:, others])
    assert np.all(found[:, 0] != found[:, -1])


@pytest.mark.slow
def test_a_tolerance_study_ranks_what_matters():
    over = {"load.load": "normal(20 kN, 1 kN)", "body.a.diameter": "normal(nominal, 1 um)"}
    found = nh.tolerance(CASE, over=over, samples=400, seed=3, quantities=("max_pressure", "load"))
    assert [each.path for each in found.indices("max_pressure")] == ["load.load", "body.a.diameter"]
    assert found.indices("max_pressure")[0].total == pytest.approx(1.0, abs=0.15)
    assert found.tightened_first["max_pressure"] == "load.load"
    bars = tolerance_figures(found)["indices"].axes[0]
    assert [text.get_text() for text in bars.get_yticklabels()] == ["Load", "Body a, diameter"]
    assert bars.get_xlim() == (0.0, 1.0)
    low, middle, high = found.quantiles("load")
    assert low.low <= 20e3 - 2.326e3 <= low.high or low.low == -math.inf
    assert middle.low <= 20e3 <= middle.high
    assert high.low <= 20e3 + 2.326e3
    assert "1 %, 50 % and 99 %" in repr(found)


def test_rows_that_fail_are_left_out_of_quantiles_and_indices(tmp_path):
    over = {"load.load": "uniform(10 kN, 20 kN)", "body.a.length": "uniform(19 mm, 20 mm)"}
    found = nh.tolerance(CASE, over=over, samples=80, quantities=("approach",), out=tmp_path)
    assert found.independent[:4].tolist() == [0, 3, 4, 7]  # first and last of a block of four
    values = found.sweep["approach"].copy()
    assert np.isfinite(values).all()
    rows = sqlite3.connect(tmp_path / FILE)
    with contextlib.closing(rows), rows:
        rows.execute("update rows set n0 = null where number = 3")
    assert len(found.indices("approach")) == 2
    assert np.isnan(found.sweep["approach"]).sum() == 1
    for shares in (0.0, 1.0, [[0.1, 0.5]]):
        with pytest.raises(nh.InputError, match="must lie above 0 and below 1"):
            found.quantiles("approach", shares)


def test_values_in_place_of_a_distribution_are_refused():
    with pytest.raises(nh.InputError, match="must be a distribution"):
        nh.tolerance(CASE, over={"load.load": "10 kN, 20 kN"})


def test_warnings_are_counted_in_whole_numbers():
    sharp = nh.Case(
        nh.Contact(nh.Roller(diameter=20, length=20, depth="none"), nh.Plate()), {"load": 20e3}, {"strips": 31}
    )
    found = nh.tolerance(sharp, over={"load.load": "uniform(19 kN, 21 kN)"}, samples=8, workers=1)
    blocks = [block for section in tolerance_sections(found) for block in section.blocks]
    rows = {row[0]: row[1] for block in blocks if isinstance(block, Table) for row in block.rows}
    assert rows["warnings"] == "2"


@pytest.mark.slow
def test_rollers_of_similar_shape_are_those_of_their_own():
    roller = nh.Roller(diameter=15, length=20, profile=nh.profile.logarithmic(amplitude=2e-3, length=20, fraction=0.99))
    case = nh.Case(nh.Contact(roller, nh.Ring(diameter=80, length=24)), {"load": 20e3})
    diameters = [14.98, 15.0, 15.013]
    found = nh.sweep(case, over={"body.a.diameter": diameters}, quantities=("approach", "max_pressure"))
    for number, diameter in enumerate(diameters):
        alone = nh.solve(nh.Contact(replace(roller, diameter=diameter), case.contact.b), load=20e3)
        assert found["approach"][number] == pytest.approx(alone.approach, rel=3e-7)
        assert found["max_pressure"][number] == pytest.approx(alone.max_pressure, rel=3e-7)
