"""Fatigue life against published figures."""

import numpy as np
import pytest

from claims import fatigue_life
from nonhertz import life

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
    np.testing.assert_allclose(fatigue_life.quadrature(model), (top, integral), rtol=1e-4, atol=0.0)


@pytest.mark.parametrize(("slope", "expected"), [(10 / 9, 9.9), (9 / 8, 9.889), (1.5, 9.667), (2.0, 9.5)])
def test_zaretsky_hardly_depends_on_the_slope(slope, expected):
    # The life goes with the pressure to the power c + 1/e: half of it with the load.
    model = life.zaretsky(slope=slope)
    (first,), (second,) = (life.assess(fatigue_life.line(load), model, body="b") for load in (5e3, 20e3))
    found = -np.log2(second.over(first))
    np.testing.assert_allclose(found, expected, rtol=1e-4, atol=0.0)
