"""Tapered and barrel rollers under pressure normal to their surface, against three-dimensional finite elements."""

import math

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.bodies import ends
from nonhertz.bodies.influence import HALF_SPACE, Influence, influence_of
from nonhertz.strip.influence import displacements

BARREL_END = 9.5  # mm, of a barrel of 20 mm
# w / (K q) of a load on one strip of 0.2 mm, in its own middle: at the low (small) end, in the middle and at the high
# end. Modes n = 0, 2 ... 512 around, elements of degree 6 graded to edges and strips, forces and displacement normal to
# the surface; a program of its own, which has the values of finite-roller.json on a cylinder to 1e-6.
# Half-angle, Poisson's ratio, diameter in the middle, length, half-width of the load, and these.
CASES = [
    (2.862405, 0.3, 20.0, 20.0, 0.290461, (3.51459, 2.16169, 4.04208)),
    (2.862405, 0.3, 20.0, 20.0, 0.091852, (5.60556, 4.02135, 6.23975)),
    (15.0, 0.3, 20.0, 20.0, 0.290461, (2.81294, 2.15712, 5.92654)),
    (15.0, 0.3, 20.0, 20.0, 0.091852, (4.77251, 4.01641, 8.52300)),
    (8.0, 0.2, 16.0, 10.0, 0.377366, (2.66540, 1.83596, 3.92010)),
    (10.0, 0.3, 20.0, 30.0, 0.237160, (3.36662, 2.44117, 5.41372)),
    (12.0, 0.4, 20.0, 30.0, 0.227856, (3.48917, 2.49598, 6.39448)),
    (5.0, 0.45, 20.0, 12.0, 0.351040, (3.40018, 1.92338, 4.47683)),
    (None, 0.3, 20.0, 24.0, 0.265153, (3.53690, 2.28603, 3.53690)),
    (None, 0.3, 20.0, 24.0, 0.083849, (5.62786, 4.18994, 5.62786)),
]


def diameters(half_angle, middle, length):
    """Those in the plane normal to the surface, along the surface of a taper and along the axis of a barrel."""
    half = 0.5 * length
    if half_angle is not None:
        change = length * math.tan(math.radians(half_angle))
        return nh.TabulatedDiameter((-half, half), (middle - change, middle + change))
    drop = 0.5 * middle - BARREL_END
    radius = (half**2 + drop**2) / (2.0 * drop)
    z = np.linspace(-half, half, 65)
    across = 0.5 * middle - radius + np.sqrt(radius**2 - z**2)
    return nh.TabulatedDiameter(tuple(z), tuple(2.0 * across / np.sqrt(1.0 - (z / radius) ** 2)))


@pytest.mark.slow
@pytest.mark.parametrize(("half_angle", "poisson", "middle", "length", "half_width", "expected"), CASES)
def test_strips_at_the_ends_move_the_surface_as_elements_say(
    half_angle, poisson, middle, length, half_width, expected
):  # fmt: skip
    material = nh.Material(206000.0, poisson)
    roller = nh.Roller(diameter=diameters(half_angle, middle, length), length=length, material=material)
    both = influence_of(nh.Contact(roller, nh.Plate(material=material)), nh.SEMI_ELLIPTIC)
    square = np.array([half_width**2])
    for y, w in zip((-0.5 * length + 0.1, 0.0, 0.5 * length - 0.1), expected, strict=True):
        edges = np.array([y - 0.1, y + 0.1])
        of_both, of_plate = (
            displacements(each, np.array([y]), edges, 1.0 / square, square, nh.SEMI_ELLIPTIC)[0]
            for each in (both, Influence(HALF_SPACE))
        )
        # What the width changes on a strip counts in full on one that is narrower than the contact: 0.2 to 0.5 %.
        assert 2.0 * of_both - of_plate == pytest.approx(w, rel=7e-3)


def test_the_moment_of_a_tapered_roller_on_a_flat():
    # By the elements above: -2926 N mm; with right corners and pressure square to the axis -300.
    roller = nh.Roller(diameter=nh.TabulatedDiameter((-10.0, 10.0), (19.0, 21.0)), length=20.0)
    solution = nh.solve(nh.Contact(roller, nh.Plate()), load=30e3)
    assert solution.moment == pytest.approx(-2926.0, rel=0.1)


@pytest.mark.parametrize(
    ("angle", "alpha"),
    [(82.0, 0.1007), (87.1, 0.1862), (90.0, 0.22599), (92.9, 0.2608), (98.0, 0.3123), (105.0, 0.3668)],
)
def test_sharp_ends_have_the_exponent_of_their_wedge(angle, alpha):
    # A wedge on a half-space of the same material, both by the plane solution of the wedge: no slope under s^-alpha.
    image, extra = ends.corner_weights(math.radians(angle))
    assert ends.edge_exponent(0.5 * (1.0 + image), 0.5 * (1.0 + extra)) == pytest.approx(alpha, abs=6e-3)


def test_a_wedge_of_180_degrees_is_a_half_plane_and_one_of_90_a_quarter_plane():
    for alpha in (-0.3, 0.2, 0.4):
        half = ends.slope_of_wedge(alpha, math.pi)
        assert half == pytest.approx(math.pi / math.tan(math.pi * alpha), rel=1e-9)
        quarter = math.pi / math.sin(math.pi * alpha) * ends.wedge_slope(alpha, 1.0, 1.0)
        assert ends.slope_of_wedge(alpha, 0.5 * math.pi) == pytest.approx(quarter, rel=1e-9)
