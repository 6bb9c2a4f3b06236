"""Fatigue life against published figures, and that wrong stresses are noticed."""

from dataclasses import replace

import numpy as np
import pytest

from nonhertz import life
from nonhertz.life import capacity
from nonhertz.subsurface.inside import Inside
from nonhertz.verify import fatigue_life

# Derived apart from here, on 3000 depths, to about 1e-4: s_max / p0 and the integral of (s / s_max)^k / z^h.
INTEGRALS = (
    (life.lundberg_palmgren(), 0.25, 3.91426),
    (life.weibull(), 0.300283, 0.76035),
    (life.zaretsky(), 0.300283, 0.77027),
    (life.zaretsky(slope=10 / 9), 0.300283, 0.77639),
)


@pytest.mark.parametrize(("model", "top", "integral"), INTEGRALS, ids=lambda each: getattr(each, "name", str(each)))
def test_quadrature_of_the_ideal_integral(model, top, integral):
    # Their own accuracy.
    np.testing.assert_allclose(fatigue_life._quadrature(model), (top, integral), rtol=1e-4, atol=0.0)


@pytest.mark.parametrize(("slope", "expected"), [(10 / 9, 9.9), (9 / 8, 9.889), (1.5, 9.667), (2.0, 9.5)])
def test_zaretsky_hardly_depends_on_the_slope(slope, expected):
    # The life goes with the pressure to the power c + 1/e: half of it with the load.
    model = life.zaretsky(slope=slope)
    (first,), (second,) = (life.assess(fatigue_life._line(load), model, body="b") for load in (5e3, 20e3))
    found = -np.log2(second.over(first))
    np.testing.assert_allclose(found, expected, rtol=1e-4, atol=0.0)


def failed(checks):
    return [check.claim for check in checks if check.passed is False]


def test_stresses_that_are_five_per_cent_off_are_noticed(monkeypatch):
    right = Inside.stress
    monkeypatch.setattr(Inside, "stress", lambda inside, points: 1.05 * right(inside, points))
    line = fatigue_life._line()
    lives = life.assess(line, body="b")
    by_volume = {"lundberg-palmgren", "ioannides-harris", "zaretsky", "weibull"}
    assert {claim.partition(":")[0] for claim in failed(fatigue_life._ideal(lives))} == by_volume
    assert len(failed(fatigue_life._integrals(line, lives))) == 3


def test_a_reduction_that_is_five_per_cent_off_is_noticed(monkeypatch):
    monkeypatch.setattr(capacity, "MATERIAL_FACTOR", 1.05 * capacity.MATERIAL_FACTOR)
    assert {"ISO 281: C_r", "ISO/TS 16281: Q_ci", "ISO/TS 16281: Q_ce"} <= set(failed(fatigue_life._standard()))


def test_pressures_that_are_five_per_cent_off_are_noticed(monkeypatch):
    right = fatigue_life.laminae_of

    def off(solution, model):
        found = right(solution, model)
        return replace(found, factor=1.05 * found.factor)

    monkeypatch.setattr(fatigue_life, "laminae_of", off)
    assert len(failed(fatigue_life._constant())) == 2
