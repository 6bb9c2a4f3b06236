"""The strip of the half-space program CONTACT: one element 200 mm long under a cylinder of radius 500 mm.

Example "carter2d" of E. A. H. Vollebregt, https://github.com/eve70a/CONTACT: both bodies G = 82000 MPa, nu = 0.28, load
35780 N, the pressure uniform along y; results approach 0.00649156 mm, greatest pressure 113.9 MPa, half-width 1.0 mm.
"""

import numpy as np
import pytest

import nonhertz as nh

pytestmark = pytest.mark.filterwarnings("ignore:The discretisation error of the")  # one strip has no estimate

LENGTH, RADIUS, LOAD = 200.0, 500.0, 35780.0
MATERIAL = nh.Material(modulus=2.0 * 82000.0 * 1.28, poisson=0.28)
COMPLIANCE = 2.0 * MATERIAL.compliance


def pressed(element, profile=None, strips=1):
    shape = {} if profile is None else {"profile": profile}
    roller = nh.Roller(diameter=2 * RADIUS, length=LENGTH, material=MATERIAL, side_faces="none", depth="none", **shape)
    return nh.solve(nh.Contact(roller, nh.Plate(material=MATERIAL)), load=LOAD, element=element, strips=strips)


def test_semi_elliptic_strip_is_that_of_contact():
    strip = pressed(nh.SEMI_ELLIPTIC)
    assert strip.approach == pytest.approx(0.00649156, rel=1e-4)  # the figure to reach
    assert strip.half_width[0] == pytest.approx(1.0, abs=5e-4)  # digits given
    assert strip.centre_pressure[0] == pytest.approx(113.89, abs=5e-3)


def test_parabolic_strip_has_its_known_deficit():
    # The same strip with the paper's element: -0.96 % in approach, 2 q K times 0.0625464, from the two logarithms.
    strip = pressed(nh.PARABOLIC)
    assert strip.approach == pytest.approx(0.00642906, abs=5e-9)
    assert strip.approach + 2.0 * LOAD / LENGTH * COMPLIANCE * 0.0625464 == pytest.approx(0.00649161, abs=5e-9)
    assert (strip.half_width[0], strip.centre_pressure[0]) == pytest.approx((0.999998, 113.892), rel=5e-6)


def test_closed_form_of_puttock_and_thwaite_is_the_same():
    line = nh.hertz.line_contact(line_load=LOAD / LENGTH, radius=RADIUS, compliance=COMPLIANCE)
    closed = nh.hertz.half_space_line_compression(line, length=LENGTH)
    assert closed == pytest.approx(0.00649159, abs=5e-9)
    # It leaves out q K b^2 / (2 L^2), 1e-5 of itself, which the strip contains.
    assert pressed(nh.SEMI_ELLIPTIC).approach == pytest.approx(closed, rel=1e-5)
    assert line.max_pressure == pytest.approx(113.9, abs=0.05)
    assert line.half_width == pytest.approx(1.0, rel=2e-5)


@pytest.mark.parametrize("element", [nh.SEMI_ELLIPTIC, nh.PARABOLIC], ids=lambda e: e.name)
def test_a_uniform_pressure_needs_lundbergs_relief(element):
    # On many strips the load is spread evenly only if the ends are relieved; the approach is then the same.
    profile = nh.profile.lundberg(load=LOAD, length=LENGTH, radius=RADIUS, compliance=COMPLIANCE)
    solution = pressed(element, profile, strips=None)
    middle = np.abs(solution.y) < 0.45 * LENGTH
    # The ends within a half-width are not quite uniform; the middle feels it by 1e-4.
    np.testing.assert_allclose(solution.centre_pressure[middle], 113.89, rtol=2e-3, atol=0.0)
    assert solution.approach == pytest.approx(pressed(element).approach, rel=2e-3)
