"""Stress below Hertz's contacts against published figures, and that a wrong field is noticed."""

from dataclasses import replace

import numpy as np
import pytest

import nonhertz as nh
from nonhertz import subsurface
from nonhertz.subsurface.inside import Inside
from nonhertz.verify import subsurface_stress as below
from nonhertz.verify.subsurface_stress import STEEL, _Circle, _Line

# Boussinesq's point loads summed over 400 x 400 cells of an ellipse, derived apart from here for nu = 0.3: b/a, the
# largest von Mises stress over p0 and its depth over b, and the same of the maximum shear stress.
SUMMED = (
    (0.1, (0.57214, 0.7170), (0.31436, 0.7710)),
    (0.3, (0.59702, 0.6813), (0.32458, 0.7043)),
    (0.5, (0.61077, 0.6217), (0.32414, 0.6306)),
    (0.7, (0.61738, 0.5609), (0.31948, 0.5641)),
    (0.9, (0.61980, 0.5058), (0.31329, 0.5066)),
)
# Lundberg and Palmgren: b/a, tau_0 / p0 and z_0 / b.
ORTHOGONAL = ((0.1, 0.24938, 0.49632), (0.5, 0.23719, 0.43507), (1.0, 0.21389, 0.35086))


@pytest.mark.parametrize(("ratio", "von_mises", "shear"), SUMMED)
def test_closed_form_on_the_axis_is_the_sum_of_point_loads(ratio, von_mises, shear):
    depth = np.linspace(0.3, 0.9, 121)
    on_axis = [below._axis(ratio, each) for each in depth]
    for of, expected in ((below._von_mises_on_axis, von_mises), (below._shear_on_axis, shear)):
        value, place = below._vertex(depth, np.array([of(each) for each in on_axis]))
        # The digits of the table; what 400 x 400 cells leave is less.
        assert abs(value - expected[0]) < 2e-5
        assert abs(place - expected[1]) < 3e-4


@pytest.mark.parametrize(("ratio", "value", "depth"), ORTHOGONAL)
def test_orthogonal_shear_stress_of_lundberg_and_palmgren(ratio, value, depth):
    np.testing.assert_allclose(below._lundberg(ratio), (value, depth), rtol=0.0, atol=1e-5)


def test_closed_form_on_the_axis_of_a_circle():
    # Johnson (1985), Eqs. (3.45): sigma_z = -1 / (1 + z^2), sigma_r = -(1 + nu) (1 - z atan(1/z)) + 1 / (2 (1 + z^2)).
    for z in (0.05, 0.48, 2.0):
        radial = -1.3 * (1.0 - z * np.arctan(1.0 / z)) + 0.5 / (1.0 + z**2)
        np.testing.assert_allclose(below._axis(1.0, z), (radial, radial, -1.0 / (1.0 + z**2)), rtol=0.0, atol=1e-9)


def failed(checks):
    return {check.claim for check in checks if check.passed is False}


def test_a_field_that_is_five_per_cent_off_is_noticed(monkeypatch):
    line, circle = _Line.of(STEEL), _Circle.of()
    right = Inside.stress
    monkeypatch.setattr(Inside, "stress", lambda inside, points: 1.05 * right(inside, points))
    assert len(failed(below._plane_strain(line))) == 2
    assert len(failed(below._on_cells(circle))) == 3
    found = subsurface.extremes(circle.strips, 0.0)
    assert len(failed(below._landmarks("circle", below._CIRCLE, circle.hertz, found))) == 3


def test_a_shear_stress_that_is_five_per_cent_off_is_out_of_balance(monkeypatch):
    right = Inside.stress
    factors = np.where(np.arange(6) == below.TAU_XZ, 1.05, 1.0)
    monkeypatch.setattr(Inside, "stress", lambda inside, points: factors * right(inside, points))
    roller = nh.Roller(diameter=20, length=20, profile=nh.profile.crown(radius=2000))
    solution = nh.solve(nh.Contact(roller, nh.Plate()), load=6e3)
    assert any("balance" in claim for claim in failed(below._balance(solution)))


def test_images_that_weigh_a_tenth_too_little_are_noticed(monkeypatch):
    right = Inside.of.__func__

    def lighter(cls, solution, name):
        inside = right(cls, solution, name)
        weight = np.where(np.arange(len(inside.terms)) > 0, 0.9, 1.0)
        return replace(inside, terms=inside.terms * np.column_stack([np.ones((weight.size, 2)), weight]))

    monkeypatch.setattr(Inside, "of", classmethod(lighter))
    assert failed(below._plane_strain(_Line.of(STEEL)))
