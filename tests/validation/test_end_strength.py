"""The strength of sharp ends against solutions whose pressure is free across (docs/end_study.py, its table's numbers).

They are converged to 2e-4. Rollers of 20 mm diameter on a flat, steel, half-spaces with images that add up to kappa.
"""

import math

import pytest

import nonhertz as nh

# kappa, length [mm], load [N], crown radius [mm], K [MPa mm^alpha], relative error documented
CASES = [
    (0.0, 20.0, 20e3, math.inf, 811.33, 2e-3),
    (0.0, 20.0, 20e3, 4000.0, 519.00, 2e-3),
    (0.0, 20.0, 500.0, math.inf, 59.56, 2e-3),
    (0.0, 6.0, 20e3, math.inf, 1585.87, 4e-3),
    (0.0, 2.0, 4e3, math.inf, 930.18, 6e-3),
    (0.25, 20.0, 20e3, math.inf, 822.34, 2e-3),
    (0.5, 20.0, 20e3, math.inf, 835.38, 2e-3),
    (0.5, 20.0, 20e3, 4000.0, 489.95, 2e-3),
    (0.8, 20.0, 20e3, math.inf, 866.07, 2e-3),
    (0.8, 20.0, 20e3, 4000.0, 429.45, 2e-3),
]


def strength(kappa, length, load, crown, element):
    profile = nh.profile.crown(crown) if math.isfinite(crown) else nh.profile.straight()
    body = nh.Roller(diameter=20.0, length=length, profile=profile, side_faces=2.0 * kappa or "none", depth="none")
    return nh.solve(nh.Contact(body, nh.Plate()), load=load, element=element).edge_pressure[1].strength


@pytest.mark.parametrize(("kappa", "length", "load", "crown", "expected", "error"), CASES)
def test_strength_of_semi_elliptic_strips(kappa, length, load, crown, expected, error):
    assert strength(kappa, length, load, crown, nh.SEMI_ELLIPTIC) == pytest.approx(expected, rel=error)


@pytest.mark.parametrize(("kappa", "length", "load", "crown", "expected", "error"), CASES)
def test_strength_of_parabolic_strips(kappa, length, load, crown, expected, error):
    assert strength(kappa, length, load, crown, nh.PARABOLIC) == pytest.approx(expected, rel=0.03)
