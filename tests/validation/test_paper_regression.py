"""The paper's model without corrections, against a second, separate implementation of it.

J. M. de Mul, J. J. Kalker, G. M. Vree, An orthogonal uniform/parabolic surface pressure half-space element,
CIMNE, Barcelona 1998. Roller 15 x 16 on a ring of diameter 60, ISO profile, E = 206000, nu = 0.3, 20 kN,
41 equal strips. The summit s of a strip is p = s (c^2 - x^2), so that q = 4/3 s c^3. All digits are met.
"""

import pytest

import nonhertz as nh
from claims.paper_rollers import QUANTITIES, half_digit

pytestmark = pytest.mark.filterwarnings("ignore:The maximum pressure is uncertain")  # of 41 equal strips

# What is printed, by the number of the strip.
PRINTED = [
    ("approach", None, "37.453024"),
    ("summit s", 20, "20287.832"), ("c", 20, "0.3653221"), ("line load", 20, "1318.8704"),
    ("summit s", 10, "20450.2174"), ("c", 10, "0.3626138"),
    ("summit s", 0, "31306.818"), ("c", 0, "0.2482942"), ("line load", 0, "638.965"),
]  # fmt: skip


@pytest.fixture(scope="module")
def solution():
    material = nh.Material(modulus=206000, poisson=0.3)
    profile = nh.profile.logarithmic(amplitude=0.00035 * 15, length=16)
    roller = nh.Roller(diameter=15, length=16, profile=profile, material=material, side_faces="none", depth="none")
    ring = nh.Ring(diameter=60, material=material)
    return nh.solve(nh.Contact(roller, ring), load=20e3, element=nh.PARABOLIC, strips=41)


@pytest.mark.parametrize(("name", "strip", "printed"), PRINTED)
def test_all_digits_are_met(solution, name, strip, printed):
    _, measure = QUANTITIES[name]
    assert measure(solution, strip) == pytest.approx(float(printed), rel=0.0, abs=half_digit(printed))
