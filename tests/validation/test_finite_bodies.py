"""Finite length and thickness: what no claim says of a second implementation and of free faces.

"The second implementation" is a second, separate implementation of the paper's model: J. M. de Mul, J. J. Kalker,
G. M. Vree, An orthogonal uniform/parabolic surface pressure half-space element, CIMNE, Barcelona 1998. The summit s
of a strip is p = s (c^2 - x^2), so that q = 4/3 s c^3. All digits given are met.
"""

import numpy as np
import pytest

import nonhertz as nh
from claims import bodies, paper_rollers
from claims.claim import pressures
from claims.free_ends import DISTANCES, EXACT_ROLLER, FAR, with_weights
from claims.paper_rollers import half_digit
from nonhertz.native import core
from nonhertz.strip.problem import StripModel

pytestmark = pytest.mark.filterwarnings("ignore::nonhertz.AccuracyWarning")

STEEL = nh.Material(modulus=206000, poisson=0.3)
HALF_SPACE = {"side_faces": "none", "depth": "none"}


@pytest.mark.parametrize(("images", "approach"), [(1, "25.463"), (40, "25.336")])
def test_approach_of_two_rollers_with_a_depth_of_one_diameter(images, approach):
    found = 1e3 * bodies.pair(nh.PARABOLIC, 41, images=images, depth="diameter").approach
    assert found == pytest.approx(float(approach), rel=0.0, abs=half_digit(approach))


@pytest.mark.parametrize("images", [1, 2, 4, 10, 40, "series"])
def test_pressure_of_two_rollers_is_uniform(images):
    # To 1e-4, as in the second implementation; more images leave less.
    pressure = bodies.pair(nh.PARABOLIC, 41, images=images).centre_pressure
    np.testing.assert_allclose(pressure, np.mean(pressure), rtol=1e-4, atol=0.0)


def test_the_greatest_pressure_of_a_tilted_roller_on_a_ring_is_where_it_was():
    contact = paper_rollers.contact(nh.profile.iso_logarithmic(diameter=15, length=16), "diameter")
    solution = nh.solve(contact, load=20e3, tilt=5e-4, element=nh.PARABOLIC, strips=41)
    assert solution.max_pressure_y == pytest.approx(3.9024, abs=half_digit("3.9024"))


# Single coefficients of that roller: a strip of width 0.4 at y = 1 with c = 0.25 acts at yi. Per unit of the summit
# C is the displacement and P the flattening, Cd and Pd their derivatives by c; with images and depth C and Cd are those
# against the point at depth.

SINGLE = [
    # body, yi, C, Cd, P, Pd
    (HALF_SPACE, 0.0, "1.18000912e-8", "1.40992791e-7", "1.19573140e-8", "1.37802852e-7"),
    (HALF_SPACE, 1.0, "1.09428655e-7", "1.10433121e-6", "2.35687676e-6", "7.02720057e-6"),
    ({"depth": "diameter"}, 0.0, "1.05087834e-8", "1.25496803e-7", "1.19631716e-8", "1.37873131e-7"),
    ({"depth": "diameter"}, 2.0, "1.05365897e-8", "1.25830420e-7", "1.19643568e-8", "1.37887348e-7"),
]


@pytest.mark.parametrize(("body", "yi", "displacement", "by_c", "flattening", "flattening_by_c"), SINGLE)
def test_single_coefficients(body, yi, displacement, by_c, flattening, flattening_by_c):
    # One body alone: the other is all but rigid.
    roller = nh.Roller(**{"diameter": 15, "length": 16, "material": STEEL, "side_faces": "mirror"} | body)
    contact = nh.Contact(roller, nh.Plate(material=nh.Material(1e18, 0.3)))
    model = StripModel.of(contact, nh.PARABOLIC).in_core
    edges, c = np.array([-0.2, 0.2, 0.8, 1.2, 1.8, 2.2]), 0.25
    strips = model.grid(edges)
    blocks = core.coefficients(strips, np.full(5, c**2), np.arange(5), model.kernel)
    a, ta, b, tb = roller.material.compliance * blocks[:, np.argmin(np.abs(strips.y - yi)), 2]
    found = [4.0 / 3.0 * c**3 * a, 4.0 / 3.0 * c**2 * (3.0 * a - ta), 4.0 / 3.0 * c * b, 4.0 / 3.0 * (b - tb)]
    # Nine digits are given.
    for value, printed in zip(found, (displacement, by_c, flattening, flattening_by_c), strict=True):
        mantissa, exponent = printed.split("e")
        digit = half_digit(mantissa) * 10.0 ** int(exponent)
        assert value == pytest.approx(float(printed), rel=0.0, abs=digit)


def test_the_calibrated_weight_is_near_the_free_face():
    # The weight was fitted to bring pressures within 2 % from a quarter of the half-width inwards.
    def off(weight):
        pressure = np.array(pressures(with_weights(weight, 0.0), [*DISTANCES[1:], FAR]))
        return np.abs(pressure[:-1] / pressure[-1] / EXACT_ROLLER[1:] - 1.0)

    assert np.all(off("calibrated") < 0.02)
    assert np.all(off("calibrated") < off("mirror"))
