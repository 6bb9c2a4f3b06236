"""Sharp ends against solutions whose pressure across is free: numbers of docs/end_study.py, converged to 3e-4.

Strength, and the largest half-width that counts. Rollers of 20 mm diameter on a flat, steel, half-spaces with images
that add up to kappa.
"""

import math

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.result.end_fit import fit_strength

# kappa, length [mm], load [N], crown radius [mm], K [MPa mm^alpha], relative error documented
CASES = [
    (0.0, 20.0, 20e3, math.inf, 812.08, 2e-3),
    (0.0, 20.0, 20e3, 4000.0, 519.48, 2e-3),
    (0.0, 20.0, 500.0, math.inf, 59.62, 2e-3),
    (0.0, 6.0, 20e3, math.inf, 1587.31, 4e-3),
    (0.0, 2.0, 4e3, math.inf, 931.04, 6e-3),
    (0.25, 20.0, 20e3, math.inf, 822.99, 2e-3),
    (0.5, 20.0, 20e3, math.inf, 835.88, 2e-3),
    (0.5, 20.0, 20e3, 4000.0, 490.28, 2e-3),
    (0.8, 20.0, 20e3, math.inf, 866.24, 2e-3),
    (0.8, 20.0, 20e3, 4000.0, 429.80, 2e-3),
]


def solved(kappa, length, load, crown, element):
    profile = nh.profile.crown(crown) if math.isfinite(crown) else nh.profile.straight()
    body = nh.Roller(diameter=20.0, length=length, profile=profile, side_faces=2.0 * kappa or "none", depth="none")
    return nh.solve(nh.Contact(body, nh.Plate()), load=load, element=element)


@pytest.mark.parametrize("element", [nh.SEMI_ELLIPTIC, nh.PARABOLIC], ids=lambda each: each.name)
@pytest.mark.parametrize(("kappa", "length", "load", "crown", "expected", "error"), CASES)
def test_strength(element, kappa, length, load, crown, expected, error):
    edge = solved(kappa, length, load, crown, element).edge_pressure[1]
    assert edge.strength == pytest.approx(expected, rel=error if element is nh.SEMI_ELLIPTIC else 0.03)


def test_pressures_that_are_no_numbers_have_no_strength():
    pressure = np.where(np.arange(10) == 1, np.nan, 100.0)
    assert fit_strength(np.linspace(0.0, 1.0, 11), pressure, (0.0, 0.0), 1.0, nh.SEMI_ELLIPTIC) == (None, None)


# Straight rollers, where the contact is widest at its ends: kappa, length [mm], load [N], and the largest half-width
# [mm] more than a half-width from them.
WIDEST = [
    (0.0, 20.0, 20e3, 0.38210),
    (0.0, 20.0, 500.0, 0.066918),
    (0.0, 6.0, 20e3, 0.60165),
    (0.0, 2.0, 4e3, 0.42680),
    (0.5, 20.0, 20e3, 0.36058),
    (0.5, 20.0, 500.0, 0.059943),
]


@pytest.mark.parametrize(("kappa", "length", "load", "expected"), WIDEST)
def test_largest_half_width(kappa, length, load, expected):
    solution = solved(kappa, length, load, math.inf, nh.SEMI_ELLIPTIC)
    assert solution.max_half_width == pytest.approx(expected, rel=0.005)
    # The last strip's is not that of the contact, which goes on flaring towards the end.
    assert solution.half_width.max() > 1.02 * solution.max_half_width
