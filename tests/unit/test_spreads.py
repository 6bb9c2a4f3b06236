"""What parameters run over: ranges, lists and distributions."""

import numpy as np
import pytest
from scipy import stats

import nonhertz as nh
from nonhertz.files.paths import Parameter
from nonhertz.files.sampling import METHODS, Sampling
from nonhertz.files.spreads import Distribution, parse_bounds, parse_spread

LOAD = Parameter("load.load", ("load", "load"), "N")
STRIPS = Parameter("solver.strips", ("solver", "strips"), "", whole=True)
MATERIAL = Parameter("body.a.material", ("body", "a", "material"), None)
DIAMETER = Parameter("body.a.diameter", ("body", "a", "diameter"), "mm")
DOCUMENT = {"body": {"a": {"diameter": "20 mm"}}}


@pytest.mark.parametrize(
    ("parameter", "given", "values"),
    [
        (LOAD, "0 : 4 kN : 3", (0.0, 2e3, 4e3)),
        (LOAD, "5 kN, 15 kN", (5e3, 15e3)),
        (LOAD, "5 kN", (5e3,)),
        (LOAD, ["5 kN", 6000], (5e3, 6e3)),
        (LOAD, np.array([1.0, 2.0]), (1.0, 2.0)),
        (STRIPS, "11 : 31 : 3", (11, 21, 31)),
        (STRIPS, ["auto", 41], ("auto", 41)),
        (MATERIAL, "steel, aluminium", ("steel", "aluminium")),
    ],
)
def test_values_are_in_the_base_unit(parameter, given, values):
    found = parse_spread(parameter, given, {})
    assert found == values
    assert [type(each) for each in found] == [type(each) for each in values]


def test_the_ends_of_a_distribution_are_its_limits_where_it_has_any():
    assert Distribution("uniform", (-1.0, 4.0)).ends == (-1.0, 4.0)
    assert Distribution("triangular", (0.0, 1.0, 4.0)).ends == (0.0, 4.0)
    assert Distribution("normal", (0.0, 1.0), (-1.0, 2.0)).ends == (-1.0, 2.0)
    below, above = Distribution("normal", (5.0, 2.0)).ends
    assert stats.norm(5.0, 2.0).cdf(below) == pytest.approx(1e-9, rel=0.02)  # one sample in 10^9 is beyond
    assert stats.norm(5.0, 2.0).sf(above) == pytest.approx(1e-9, rel=0.02)


@pytest.mark.parametrize(
    ("parameter", "given", "what"),
    [
        (LOAD, "1 kN : 5 kN", "must have a number of values"),
        (LOAD, "5 kN : 1 kN : 3", "must ascend"),
        (LOAD, "1 : 5 kN : 3", "must have a unit"),
        (LOAD, "1 kN : 5 kN : 1", "must have a whole number from 2"),
        (LOAD, [], "must hold values"),
        (LOAD, None, "must hold values"),
        (LOAD, ["5 kN", "5 mm"], "must have a unit of force"),
        (LOAD, [float("nan")], "must be a finite number"),
        (LOAD, "gauss(1 kN, 1 N)", "must be one of normal, uniform, triangular"),
        (LOAD, "normal(1 kN)", "must have 2 numbers"),
        (LOAD, "normal(1 kN, 0)", "must have a standard deviation above zero"),
        (LOAD, "uniform(2 kN, 1 kN)", "must have numbers that ascend"),
        (LOAD, "2 kN +- 0", "must have numbers that ascend"),
        (LOAD, "normal(2 kN +- 5 um)", "must have a unit of force"),
        (LOAD, "+- 1 N", "must refer to a number that the case gives"),
        (LOAD, "triangular(1 kN, 5 kN, 3 kN)", "must have numbers that ascend"),
        (LOAD, "normal(1 kN, 1 N) within 2 kN : 3 kN", "include part of the distribution"),
        (LOAD, "uniform(1 kN, 2 kN) within 1 kN : 3 kN", "have limits that belong to a normal distribution"),
        (LOAD, "normal(nominal, 1 N)", "must refer to a number that the case gives"),
        (STRIPS, "11 : 20 : 5", "must step through whole numbers"),
        (STRIPS, "uniform(11, 20)", "must be a list"),
        (MATERIAL, Distribution("uniform", (0.0, 1.0)), "must be a list"),
    ],
)
def test_what_is_no_spread_is_refused_in_one_sentence(parameter, given, what):
    with pytest.raises(nh.InputError, match=what) as caught:
        parse_spread(parameter, given, {})
    assert str(caught.value).count("must") == 1 or "that must" in str(caught.value)


def test_nominal_is_what_the_case_has():
    found = parse_spread(DIAMETER, "normal(nominal, 5 um) within 19.99 mm : 20.01 mm", DOCUMENT)
    assert found == Distribution("normal", (20.0, 0.005), (19.99, 20.01))


@pytest.mark.parametrize(
    ("given", "kind", "numbers"),
    [
        ("uniform(nominal +- 5 um)", "uniform", (19.995, 20.005)),
        ("normal(20.1 mm +- 6 um)", "normal", (20.1, 0.002)),  # limits at three standard deviations
        ("triangular(nominal ± 5 um)", "triangular", (19.995, 20.0, 20.005)),
        ("+- 5 um", "uniform", (19.995, 20.005)),
        ("nominal +/- 5e-3mm", "uniform", (19.995, 20.005)),
        ("uniform(nominal 0 -13 um)", "uniform", (19.987, 20.0)),  # h6
        ("normal(20 mm +15 um +2 um)", "normal", (20.0085, 0.013 / 6.0)),  # k6
        ("20 mm -1e-2 mm +2e-2 mm", "uniform", (19.99, 20.02)),
    ],
)
def test_limits_of_a_drawing_are_a_distribution(given, kind, numbers):
    found = parse_spread(DIAMETER, given, DOCUMENT)
    assert found.kind == kind
    assert found.numbers == pytest.approx(numbers, rel=1e-12)


def test_of_a_normal_distribution_one_in_370_lies_beyond_the_limits_of_a_drawing():
    found = parse_spread(DIAMETER, "normal(nominal +- 5 um)", DOCUMENT)
    np.testing.assert_allclose(found.quantile([0.00134990, 0.99865010]), [19.995, 20.005], rtol=1e-9)


def test_lists_and_ranges_of_negative_numbers_are_no_deviations():
    tilt = Parameter("load.tilt", ("load", "tilt"), "rad")
    assert parse_spread(tilt, "-2 mrad, -1 mrad", {}) == (-2e-3, -1e-3)
    assert parse_spread(tilt, "-2 mrad : -1 mrad : 2", {}) == (-2e-3, -1e-3)


@pytest.mark.parametrize(
    ("mine", "theirs"),
    [
        (Distribution("normal", (3.0, 0.5)), stats.norm(3.0, 0.5)),
        (Distribution("uniform", (-1.0, 4.0)), stats.uniform(-1.0, 5.0)),
        (Distribution("triangular", (1.0, 2.0, 5.0)), stats.triang(0.25, 1.0, 4.0)),
        (Distribution("triangular", (1.0, 1.0, 5.0)), stats.triang(0.0, 1.0, 4.0)),
        (Distribution("normal", (3.0, 0.5), (3.2, 4.0)), stats.truncnorm(0.4, 2.0, 3.0, 0.5)),
        (Distribution("normal", (3.0, 0.5), (1.0, 2.0)), stats.truncnorm(-4.0, -2.0, 3.0, 0.5)),
    ],
)
def test_quantiles_are_those_of_scipy(mine, theirs):
    shares = np.array([1e-9, 0.01, 0.25, 0.5, 0.9, 0.999])
    np.testing.assert_allclose(mine.quantile(shares), theirs.ppf(shares), rtol=1e-9)


@pytest.mark.parametrize("method", METHODS)
def test_samples_have_mean_and_deviation_of_their_distribution(method):
    drawn = Sampling(4096, method, 3).draw([Distribution("normal", (2.0, 0.5)), Distribution("uniform", (0.0, 1.0))])
    assert drawn.shape == (4096, 2)
    # Four standard errors of random samples; the others are closer.
    np.testing.assert_allclose(drawn.mean(axis=0), [2.0, 0.5], atol=4.0 * 0.5 / 64.0)
    np.testing.assert_allclose(drawn.std(axis=0), [0.5, 12.0**-0.5], rtol=0.05)
    assert abs(np.corrcoef(drawn.T)[0, 1]) < 0.07
    np.testing.assert_array_equal(
        drawn[:10],
        Sampling(4096, method, 3).draw([Distribution("normal", (2.0, 0.5)), Distribution("uniform", (0.0, 1.0))])[:10],
    )
    assert np.any(
        drawn
        != Sampling(4096, method, 4).draw([Distribution("normal", (2.0, 0.5)), Distribution("uniform", (0.0, 1.0))])
    )


def test_a_latin_hypercube_has_one_sample_in_each_layer():
    layers = np.floor(50.0 * Sampling(50, "latin-hypercube", 1).shares(3)).astype(int)
    np.testing.assert_array_equal(np.sort(layers, axis=0), np.arange(50)[:, None] * np.ones(3, dtype=int))


def test_bounds_are_lowest_and_highest():
    assert parse_bounds(LOAD, "1 kN : 2 kN") == (1e3, 2e3)
    assert parse_bounds(LOAD, [1e3, "2 kN"]) == (1e3, 2e3)
    for given, what in (
        ("1 kN : 2 kN : 3", "without a number of values"), ([2.0, 1.0], "ascend"), ([1.0], "be a range"),
    ):  # fmt: skip
        with pytest.raises(nh.InputError, match=what):
            parse_bounds(LOAD, given)
    with pytest.raises(nh.InputError, match="change gradually"):
        parse_bounds(MATERIAL, "a : b")
