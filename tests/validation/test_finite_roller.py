"""Whole rollers, cylindrical, tapered and barrel-shaped, against three-dimensional finite elements."""

import json
import math
from pathlib import Path

import numpy as np
import pytest
from scipy import special

import nonhertz as nh
from claims import whole_roller
from claims.whole_roller import displaced
from nonhertz.bodies import ends

REFERENCE = json.loads((Path(__file__).parent / "data" / "finite-roller.json").read_text(encoding="utf-8"))
CASES = {case["id"]: case for case in REFERENCE["cases"]}
LOADS = {
    "1": np.ones_like,
    "2": lambda y: np.abs(y) < 8.0,
    "4": lambda y: 0.1 * y,
    "5-0": lambda y: np.abs(y) < 0.25,
    "5-9.75": lambda y: y > 9.5,
    "6-0.0": np.ones_like,
    "8": np.ones_like,
}  # over 1000 N/mm
EDGES = np.unique(
    np.concatenate([
        np.linspace(-10.0, 10.0, 161), [-9.5, -8.0, -0.25, 0.25, 8.0, 9.5],
        *(sign * (10.0 - np.geomspace(0.005, 0.12, 14)) for sign in (-1.0, 1.0)),
    ])
)  # fmt: skip


def cylinder(length, poisson):
    material = nh.Material(206000.0, poisson)
    return nh.Roller(diameter=20.0, length=length, material=material, side_faces="free", depth="finite")


@pytest.mark.parametrize("name", CASES)
def test_a_load_moves_the_surface_as_elements_say(name):
    case, poisson = CASES[name], CASES[name]["nu"]
    y, expected = np.array(case["y"]), np.array(case["w"])
    load = 1e3 * LOADS[name](0.5 * (EDGES[1:] + EDGES[:-1]))
    found = (
        displaced(cylinder(case["L"], poisson), y, EDGES, load, case["b"]) * nh.Material(206000.0, poisson).compliance
    )
    if LOADS[name] is np.ones_like:
        np.testing.assert_allclose(found, expected, rtol=5e-4)
    else:
        # Two are half as long as they are wide: what the width changes is not all on their strips.
        short = name.startswith("5")
        np.testing.assert_allclose(found, expected, atol=(4e-3 if short else 1.5e-3) * np.abs(expected).max())
    if name == "4":
        # The compliance against tilting.
        assert np.trapezoid(found * y, y) == pytest.approx(np.trapezoid(expected * y, y), rel=1e-3)


def test_a_long_roller_is_compressed_as_in_plane_strain_and_grows_longer():
    # Johnson's compression of a long cylinder, and what a roller that is free to grow longer adds.
    poisson, half_width = 0.3, 0.3
    found = displaced(cylinder(160.0, poisson), np.zeros(1), np.linspace(-80.0, 80.0, 641), np.ones(640), half_width)
    expected = 2.0 * math.log(40.0 / half_width) - 1.0 + 2.0 * poisson**2 / (1.0 - poisson**2)
    assert found == pytest.approx(expected, rel=2e-3)


@pytest.mark.parametrize("poisson", [0.1, 0.3])
def test_a_wider_load_compresses_a_roller_by_the_sum_over_all_its_modes(poisson):
    # A disc in plane strain: mode n moves by (n - beta) / (n^2 - 1) (Michell), a semi-ellipse has 2 J1(n b) / (n b) of
    # it. The ends change nothing of what the width does in the middle.
    n, beta = np.arange(2.0, 4e5, 2.0), (1.0 - 2.0 * poisson) / (2.0 * (1.0 - poisson))
    widths = np.array([0.003, 0.01, 0.03, 0.06, 0.12, 0.16, 0.28])  # over the radius
    modes = 4.0 * (n - beta) / (n**2 - 1.0)
    expected = np.array([modes @ (2.0 * special.j1(n * width) / (n * width)) for width in widths])
    roller, edges = cylinder(40.0, poisson), np.linspace(-20.0, 20.0, 81)
    found = np.array([float(displaced(roller, np.zeros(1), edges, np.ones(80), 10.0 * each)[0]) for each in widths])
    np.testing.assert_allclose((found - found[0]) - (expected - expected[0]), 0.0, atol=4e-4 * found.min())


@pytest.mark.parametrize(
    ("load", "errors"),
    [
        (whole_roller.UNIFORM, {0.0: -0.0089, 9.5: 0.0351, 10.0: 0.0502}),
        (whole_roller.PLANE, {0.0: -0.0006, 10.0: 0.0855}),
    ],
)
def test_a_roller_with_free_ends_and_a_depth_is_as_far_off_as_documented(load, errors):
    (model,) = (each for each in whole_roller.MODELS if each.name == "free ends, plane-strain depth")
    found = whole_roller.moved(model.roller(load.poisson), load, np.array(list(errors)))
    expected = np.interp(list(errors), load.y, load.moved)
    np.testing.assert_allclose(found / expected - 1.0, list(errors.values()), rtol=0.0, atol=0.002)


BARREL_END = 9.5  # mm, of a barrel of 20 mm
# w / (K q) of a load on one strip of 0.2 mm, in its own middle: at the low (small) end, in the middle and at the high
# end. Modes n = 0, 2 ... 512 around, elements of degree 6 graded to edges and strips, forces and displacement normal to
# the surface; a program of its own, which has the values of finite-roller.json on a cylinder to 1e-6.
# Half-angle (None for a barrel), Poisson's ratio, diameter in the middle, length, half-width of the load, and these.
TAPERED = [
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
@pytest.mark.parametrize(("half_angle", "poisson", "middle", "length", "half_width", "expected"), TAPERED)
def test_tapered_rollers_under_pressure_normal_to_their_surface(
    half_angle, poisson, middle, length, half_width, expected
):  # fmt: skip
    material = nh.Material(206000.0, poisson)
    roller = nh.Roller(diameter=diameters(half_angle, middle, length), length=length, material=material)
    for y, w in zip((-0.5 * length + 0.1, 0.0, 0.5 * length - 0.1), expected, strict=True):
        found = displaced(roller, np.array([y]), np.array([y - 0.1, y + 0.1]), np.ones(1), half_width)
        # What the width changes on a strip counts in full on one that is narrower than the contact: 0.2 to 0.9 %.
        assert found == pytest.approx(w, rel=1e-2)


def test_the_moment_of_a_tapered_roller_on_a_flat():
    # By the elements above: -2926 N mm; with right corners and pressure square to the axis -300.
    roller = nh.Roller(diameter=nh.TabulatedDiameter((-10.0, 10.0), (19.0, 21.0)), length=20.0)
    solution = nh.solve(nh.Contact(roller, nh.Plate()), load=30e3, strips=100)
    assert solution.moment == pytest.approx(-2926.0, rel=0.07)


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
