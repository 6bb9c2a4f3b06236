"""Tolerances: quantiles and indices of functions whose are known."""

import contextlib
import math
import sqlite3
from dataclasses import replace

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.figures.value import Bars, Span, Whiskers
from nonhertz.files.sampling import Sampling
from nonhertz.files.spreads import Distribution
from nonhertz.plot.drawer import sheet_of
from nonhertz.show.sections import Table
from nonhertz.show.studies import tolerance_sections
from nonhertz.study.figures import tolerance_figures
from nonhertz.study.limits import Limit, capabilities
from nonhertz.study.store import FILE
from nonhertz.study.tolerances import quantile, sobol_indices
from nonhertz.verdict import Level

ROLLER = nh.Roller(diameter=20, length=20, profile=nh.profile.crown(radius=4000), side_faces="none", depth="none")
PLATE = nh.Plate(side_faces="none", depth="none")
CASE = nh.Case(nh.Contact(ROLLER, PLATE), {"load": 20e3}, {"strips": 31})


def ishigami(x, a=7.0, b=0.1):
    """Return Ishigami and Homma's function (1990), whose indices have closed forms."""
    return np.sin(x[:, 0]) + a * np.sin(x[:, 1]) ** 2 + b * x[:, 2] ** 4 * np.sin(x[:, 0])


def drawn(function, distributions, count, seed):
    """Return the results of Saltelli's arrangement in blocks."""
    sampling = Sampling(count, "saltelli", seed)
    return function(sampling.draw(distributions)).reshape(-1, len(distributions) + 2)


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
        assert (first.first_low, first.first_high, first.total, first.total_high) == (1.0, 1.0, 1.0, 1.0)
        for each in others:
            assert each.total == 0.0
            assert (each.first, each.first_low, each.first_high, each.total_high) == (0.0, 0.0, 0.0, 0.0)


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
    # A load is no tolerance, and the diameter has no share worth tightening; nor is the load a result.
    assert found.tightened_first == {}
    assert [each.name for each in found.results] == ["max_pressure"]
    figures = tolerance_figures(found)
    (bars,) = figures["indices"].panels
    assert bars.along.categories == ("Load", "Body a, diameter")
    shares = {mark.name: mark.y.tolist() for mark in bars.marks if isinstance(mark, Bars)}
    indices = found.indices("max_pressure")
    assert shares == {"in total": [index.total for index in indices], "alone": [index.first for index in indices]}
    whiskers = [mark for mark in bars.marks if isinstance(mark, Whiskers)]
    assert [mark.high.tolist() for mark in whiskers] == [
        [index.first_high for index in indices], [index.total_high for index in indices]
    ]  # fmt: skip
    assert "max_pressure,alone,Load," in figures["indices"].to_csv()
    (axes,) = sheet_of(figures["indices"]).axes
    assert [text.get_text() for text in axes.get_yticklabels()] == ["Load", "Body a, diameter"]
    assert (axes.get_xlim(), axes.get_ylim()) == ((0.0, 1.0), (1.5, -0.5)), "the largest is on top"
    pressure, load = figures["distribution"].panels
    quantiles = found.quantiles("max_pressure")
    ends = [(quantile.low, quantile.high) for quantile in quantiles if np.isfinite(quantile.low + quantile.high)]
    assert [(mark.low, mark.high) for mark in pressure.marks if isinstance(mark, Span)] == ends
    (counts,) = (mark for mark in load.marks if isinstance(mark, Bars))
    assert counts.y.sum() == found.samples("load").size
    low, middle, high = found.quantiles("load")
    assert low.low <= 20e3 - 2.326e3 <= low.high or low.low == -math.inf
    assert middle.low <= 20e3 <= middle.high
    assert high.low <= 20e3 + 2.326e3
    assert "1 %, 50 % and 99 %" in repr(found)


def test_what_the_case_gives_and_places_are_no_results_and_a_load_is_no_tolerance():
    over = {"load.load": "normal(20 kN, 1 kN)", "load.tilt": "0 +- 0.1 mrad", "body.a.profile.radius": "+- 1500 mm"}
    found = nh.tolerance(CASE, over=over, samples=100, workers=1)
    names = [each.name for each in found.results]
    assert names == ["approach", "moment", "max_pressure", "max_half_width", "contact_length"]
    assert set(found.tightened_first) <= set(names)
    assert found.tightened_first["max_pressure"][0] == "body.a.profile.radius"
    assert found.tightened_first["moment"] == ("load.tilt",)
    blocks = [block for section in tolerance_sections(found) for block in section.blocks]
    tables = [block for block in blocks if isinstance(block, Table)]
    assert [each.heads[0] for each in tables if "in total" in each.heads] == ["variance of maximum pressure"]
    remarks = {row[0]: row[3] for each in tables if "in total" in each.heads for row in each.rows}
    assert remarks["load.load"] == "operating load"
    assert remarks["body.a.profile.radius"] in {"tighten this first", "tighten one of these first"}
    assert sum(len(each.rows) for each in tables) - len(found.sweep.assumed) < 12


@pytest.mark.parametrize(("limit", "sign"), [(2.0, 1.0), (-1.0, 1.0), (1.0, -1.0)])
def test_the_share_beyond_a_limit_and_cpk_of_a_normal_distribution(limit, sign):
    bound = Limit("load", most=limit) if sign > 0.0 else Limit("load", least=limit)
    true = 0.5 * math.erfc(sign * limit / math.sqrt(2.0))
    generator, held = np.random.default_rng(4), 0
    for _ in range(200):
        (found,) = capabilities(bound, generator.standard_normal(400))
        assert found.fraction == found.beyond / found.samples
        # Of the mean, whose standard error is 1/20, and of the deviation: four of them together, in units of 3 sigma.
        assert found.cpk == pytest.approx(sign * limit / 3.0, abs=4.0 * math.hypot(0.05, limit * 0.05 / 2**0.5) / 3.0)
        held += found.low <= true <= found.high
    assert held >= 182  # of 190 that 95 % would be: 2.6 standard deviations fewer


def test_the_interval_of_a_share_is_that_of_clopper_and_pearson():
    values = np.r_[np.zeros(99), 5.0, np.nan]
    (some,) = capabilities(Limit("load", most=4.0), values)
    assert (some.samples, some.beyond) == (100, 1)
    assert (some.low, some.high) == pytest.approx((1.0 - 0.975 ** (1.0 / 100.0), 0.0544594), rel=1e-5)
    (none,) = capabilities(Limit("load", most=6.0), values)
    assert (none.fraction, none.low, none.high) == (0.0, 0.0, pytest.approx(1.0 - 0.025 ** (1.0 / 100.0)))
    (alike,) = capabilities(Limit("load", least=1.0), np.zeros(5))
    assert (alike.fraction, alike.cpk) == (1.0, -math.inf)
    assert capabilities(Limit("load", least=1.0), np.full(5, np.nan)) == []


def test_limits_are_counted_of_what_is_drawn():
    over, limits = {"load.load": "normal(nominal, 1 kN)"}, {"load": "at most 21.5 kN", "relative_life": "at least 0.1"}
    found = nh.tolerance(CASE, over=over, samples=600, quantities=("load",), limits=limits, workers=1)
    load, life = found.capabilities
    assert load.fraction == pytest.approx(0.0668072, abs=0.01)  # of a normal distribution beyond 1.5 sigma
    assert load.low <= 0.0668072 <= load.high
    assert load.cpk == pytest.approx(0.5, abs=0.02)
    assert load.normal_fraction == pytest.approx(0.0668072, abs=0.005)
    assert (life.quantity, life.beyond) == ("relative_life", 0)
    assert found.verdict.level is Level.NOT_MET
    assert found.verdict.sentence == f"{load.beyond} of 400 samples are beyond the limit of the load, at most 21.5 kN."


@pytest.mark.parametrize(
    ("limits", "what"),
    [
        (
            {"max_presure": "at most 3 GPa"},
            r"Unknown quantity limits\.max_presure\. Did you mean limits\.max_pressure\?",
        ),
        ({"max_pressure": "3 GPa"}, "begin with 'at most' or 'at least'"),
        ({"max_pressure": "at most 3 mm"}, "must have a unit of stress"),
        (["max_pressure"], "limits = .* must be a dictionary"),
    ],
)
def test_limits_that_cannot_be_read_are_refused(limits, what):
    with pytest.raises(nh.InputError, match=what):
        nh.tolerance(CASE, over={"load.load": "+- 1 kN"}, samples=8, limits=limits)


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
