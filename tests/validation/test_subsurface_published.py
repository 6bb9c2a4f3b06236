"""Closed forms of the stress below Hertz's contacts against published figures."""

import numpy as np
import pytest

from claims import subsurface_stress as below

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
    on_axis = [below.on_axis(ratio, each) for each in depth]
    for of, expected in ((below.von_mises_on_axis, von_mises), (below.shear_on_axis, shear)):
        value, place = below.vertex(depth, np.array([of(each) for each in on_axis]))
        # The digits of the table; what 400 x 400 cells leave is less.
        assert abs(value - expected[0]) < 2e-5
        assert abs(place - expected[1]) < 3e-4


@pytest.mark.parametrize(("ratio", "value", "depth"), ORTHOGONAL)
def test_orthogonal_shear_stress_of_lundberg_and_palmgren(ratio, value, depth):
    np.testing.assert_allclose(below.lundberg(ratio), (value, depth), rtol=0.0, atol=1e-5)


def test_closed_form_on_the_axis_of_a_circle():
    # Johnson (1985), Eqs. (3.45): sigma_z = -1 / (1 + z^2), sigma_r = -(1 + nu) (1 - z atan(1/z)) + 1 / (2 (1 + z^2)).
    for z in (0.05, 0.48, 2.0):
        radial = -1.3 * (1.0 - z * np.arctan(1.0 / z)) + 0.5 / (1.0 + z**2)
        np.testing.assert_allclose(below.on_axis(1.0, z), (radial, radial, -1.0 / (1.0 + z**2)), rtol=0.0, atol=1e-9)
