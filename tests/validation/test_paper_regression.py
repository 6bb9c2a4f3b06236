"""The paper's model without corrections, against a second, separate implementation of it.

J. M. de Mul, J. J. Kalker, G. M. Vree, An orthogonal uniform/parabolic surface pressure half-space element,
CIMNE, Barcelona 1998. Roller 15 x 16 on a ring of diameter 60, ISO profile, E = 206000, nu = 0.3, 20 kN,
41 equal strips. The summit s of a strip is p = s (c^2 - x^2), so that q = 4/3 s c^3. All digits are met.
"""

import numpy as np
import pytest

import nonhertz as nh

pytestmark = pytest.mark.filterwarnings("ignore:The maximum pressure is uncertain")  # of 41 equal strips

STRIPS = {  # strip: y, s [N/mm^4], c [mm], q [N/mm]
    20: ("0.000000", "20287.832", "0.3653221", "1318.8704"),
    10: ("-3.902439", "20450.2174", "0.3626138", None),
    0: ("-7.804878", "31306.818", "0.2482942", "638.965"),
}


@pytest.fixture(scope="module")
def solution():
    material = nh.Material(modulus=206000, poisson=0.3)
    profile = nh.profile.logarithmic(amplitude=0.00035 * 15, length=16)
    roller = nh.Roller(diameter=15, length=16, profile=profile, material=material, side_faces="none", depth="none")
    ring = nh.Ring(diameter=60, material=material)
    return nh.solve(nh.Contact(roller, ring), load=20e3, element=nh.PARABOLIC, strips=41)


def assert_all_digits(found, printed):
    decimals = len(printed.partition(".")[2])
    assert abs(found - float(printed)) <= 0.501 * 10.0**-decimals, (found, printed)


def test_approach(solution):
    assert_all_digits(1e3 * solution.approach, "37.453024")


@pytest.mark.parametrize("strip", STRIPS)
def test_strips(solution, strip):
    y, summit, c, q = STRIPS[strip]
    assert_all_digits(solution.y[strip], y)
    assert_all_digits(0.75 * solution.line_load[strip] / solution.element_half_width[strip] ** 3, summit)
    assert_all_digits(solution.element_half_width[strip], c)
    if q is not None:
        assert_all_digits(solution.line_load[strip], q)


def test_what_is_reported_is_the_hertz_equivalent(solution):
    # The paper's Eqs. (61)-(62): b = sqrt(2/3) c, p0 = 2 q / (pi b) = 4 sqrt(6) / (3 pi) s c^2.
    c = solution.element_half_width
    summit = 0.75 * solution.line_load / c**3
    np.testing.assert_allclose(solution.half_width, 0.8164965809 * c, rtol=1e-9, atol=0.0)
    np.testing.assert_allclose(solution.centre_pressure, 1.0395957 * summit * c**2, rtol=5e-8, atol=0.0)
