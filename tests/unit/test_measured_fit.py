"""Fits: parameters come back, kinds are told apart, and what nobody can tell is refused."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from nonhertz.errors import InputError
from nonhertz.measured import Points, ProfileFit, fit, fit_best
from nonhertz.measured.fitting import KINDS
from nonhertz.model.profile import CATALOGUE
from nonhertz.show.measured import _parameter

Y = np.linspace(-5.0, 5.0, 1001)
NOISE = 1e-4
TRUE = {
    "crown": {"radius": 1200.0},
    "partial-crown": {"radius": 400.0, "straight": 4.0},
    "two-radius": {"radius": 3000.0, "end_radius": 300.0, "middle": 5.0},
    "logarithmic": {"amplitude": 0.008, "length": 8.5, "straight": 2.0},
    "tapered-ends": {"straight": 5.0, "angle": 0.004},
    "conical": {"angle": 8e-4},
    "straight": {},
}


def line(kind: str, shift: float = 0.0, offset: float = 0.0, tilt: float = 0.0, noise: float = 0.0) -> Points:
    relief = CATALOGUE[kind](**TRUE[kind]).relief(Y - shift) + offset + tilt * Y
    return Points(Y, -relief + noise * np.random.default_rng(3).standard_normal(len(Y)))


def test_every_kind_is_tried():
    assert set(TRUE) == set(KINDS)


@pytest.mark.parametrize("kind", TRUE)
def test_parameters_come_back_of_a_clean_line(kind):
    shift = 0.0 if kind in {"straight", "conical"} else 0.12
    found = fit(line(kind, shift=shift), kind)
    assert found.rms < 1e-7  # mm; a tenth of a nanometre
    for name, value in TRUE[kind].items():
        # Where two lengths can stand in for one another the last digits of a nanometre decide.
        assert_allclose(found.parameters[name], value, rtol=1e-3, err_msg=name)
    assert_allclose(found.shift, shift, atol=1e-3)


@pytest.mark.parametrize("kind", ["partial-crown", "two-radius", "logarithmic", "tapered-ends"])
def test_a_tilt_comes_back_beside_shift_and_offset(kind):
    found = fit(line(kind, shift=-0.1, tilt=3e-4), kind, tilt=True)
    assert_allclose([found.tilt, found.shift], [3e-4, -0.1], rtol=5e-3)


@pytest.mark.parametrize("kind", ["crown", "partial-crown", "tapered-ends", "logarithmic"])
def test_noise_moves_parameters_by_their_standard_errors(kind):
    found = fit(line(kind, noise=NOISE), kind)
    assert_allclose(found.rms, NOISE, rtol=0.1)  # of 1000 points, good to 2 %
    for name, value in TRUE[kind].items():
        # One draw of noise lies beyond four standard errors once in sixteen thousand.
        assert abs(found.parameters[name] - value) < 4.0 * found.standard_errors[name], name


@pytest.mark.parametrize("kind", ["crown", "partial-crown", "logarithmic", "tapered-ends", "straight"])
def test_the_true_kind_is_ranked_first(kind):
    """Kinds that hold the true one as a special case leave no less than chance: the penalty decides."""
    best = fit_best(line(kind, noise=NOISE))
    assert best[0].kind == kind
    assert [each.penalised for each in best] == sorted(each.penalised for each in best)


def test_what_is_known_is_not_fitted():
    found = fit(line("partial-crown"), "partial-crown", straight=4.0)
    assert "straight" not in found.standard_errors
    assert_allclose(found.parameters["radius"], 400.0, rtol=1e-5)


def test_a_parameter_that_the_line_says_nothing_about_has_no_standard_error():
    found = fit(line("straight", noise=NOISE), "two-radius")
    assert np.isinf(list(found.standard_errors.values())).any() or found.standard_errors["radius"] > 1e4


def test_a_radius_that_a_flat_line_does_not_tell_has_a_large_standard_error():
    """Heights of 0.1 um on 10 mm say no more of a crown than that its curvature is below some 1e-5 per mm."""
    found = fit(line("straight", noise=NOISE), "crown")
    # The curvature has the standard deviation s sqrt(720 / n) / L^2 of a parabola through noise; 1 / R that of R / R^2.
    curvature = NOISE * np.sqrt(720.0 / len(Y)) / 10.0**2
    told = found.standard_errors["radius"] / found.parameters["radius"] ** 2
    assert_allclose(told, curvature, rtol=0.15)


def test_a_hollow_line_is_fitted_with_a_negative_radius():
    assert_allclose(fit(Points(Y, Y**2 / 1600.0), "crown").parameters["radius"], -800.0, rtol=1e-3)


@pytest.mark.parametrize(
    ("kind", "options", "sentence"),
    [
        ("crowned", {}, "kind = 'crowned' must be one of 'straight'"),
        ("crown", {"tilt": True}, "tilt = True must not be free together with the shift of a crown"),
        ("conical", {"tilt": True}, "tilt = True must not be free together with the angle of a conical"),
        ("crown", {"radus": 3.0}, "fixed = 'radus' must be one of 'radius', 'centre'"),
    ],
    ids=range(4),
)
def test_what_cannot_be_fitted_is_refused(kind, options, sentence):
    with pytest.raises(InputError, match=sentence):
        fit(line("crown"), kind, **options)


def test_the_relief_of_a_fit_is_what_was_fitted():
    points = line("two-radius", shift=0.1, offset=0.002, tilt=1e-4)
    found = fit(points, "two-radius", tilt=True)
    relief = points.height.max() - points.height
    assert_allclose(found.relief(points.y), relief, atol=4.0 * found.largest + 1e-9)


def test_the_standard_error_of_a_height_is_that_of_a_mean():
    """Of heights that alternate, so that neighbours are not alike: s / sqrt(n), with s over n - 1."""
    y = np.linspace(-5.0, 5.0, 8)
    found = fit(Points(y, 1e-3 * (-1.0) ** np.arange(8)), "straight", shift=False)
    assert found.standard_errors["offset"] == pytest.approx(1e-3 / np.sqrt(7.0), rel=1e-6)


@pytest.mark.parametrize(("asked", "given"), [("relief", "x"), ("relief", [1j]), ("unit_of", "slope")])
def test_a_fit_is_asked_for_places_and_parameters(asked, given):
    with pytest.raises(InputError, match=r"^(y|name) = "):
        getattr(fit(line("crown"), "crown"), asked)(given)


def test_nothing_is_said_of_a_parameter_that_its_error_swallows():
    # Of a line with a step in it: a circle of any radius, far away, fits as well.
    numbers = {"offset": 0.28, "tilt": 0.0, "rms": 2e-3, "largest": 6e-3, "points": 12.0, "penalised": -137.0}
    lost = ProfileFit("crown", {"radius": -347e3}, {"radius": 22.5e6, "shift": 28e3}, shift=434.0, **numbers)
    assert [_parameter(lost, name) for name in ("radius", "shift")] == [
        "radius not determined by the points",
        "shift not determined by the points",
    ]
    kept = ProfileFit("crown", {"radius": 500.0}, {"radius": 0.5, "shift": 0.02}, shift=0.0, **numbers)
    assert [_parameter(kept, name) for name in ("radius", "shift")] == [
        "radius 500.00 +- 0.50 mm",
        "shift 0 +- 20 \u00b5m",
    ]
