"""Every script of the gallery runs, and one number of each is what others have found."""

import dataclasses
import json
import warnings
from pathlib import Path

import numpy as np
import pytest
from matplotlib.figure import Figure
from numpy.testing import assert_allclose
from scipy.optimize import brentq
from scipy.special import ellipe, ellipk
from scripts import script

import nonhertz as nh

pytestmark = pytest.mark.slow

ROOT = Path(__file__).parents[2]
GALLERY = ROOT / "examples" / "gallery"
SCRIPTS = sorted(path.stem for path in GALLERY.glob("*.py"))


def run(name):
    """Return a script after it has run; what it filters of warnings is undone."""
    with warnings.catch_warnings():
        found = script(GALLERY / f"{name}.py")
    assert isinstance(found.figure, Figure)
    return found


def elliptical(load, radius_x, radius_y, modulus=207e3, poisson=0.3):
    """Return Hertz's maximum pressure [MPa] by K. L. Johnson, Contact Mechanics (1985), Eqs. (4.25) to (4.30).

    Two equal bodies; radius_x is the smaller radius. With the complete elliptic integrals, not those of
    `nonhertz.hertz`.
    """

    def excess(ratio):  # minor over major axis
        squared = 1 - ratio**2
        first, second = ellipk(squared), ellipe(squared)
        return (second / ratio**2 - first) / (first - second) - radius_y / radius_x

    ratio = brentq(excess, 1e-3, 1 - 1e-6)
    squared = 1 - ratio**2
    effective = 0.5 * modulus / (1 - poisson**2)
    mean = (radius_x * radius_y) ** 0.5
    shape = 4 / (np.pi * squared) * ratio**1.5
    shape *= ((ellipe(squared) / ratio**2 - ellipk(squared)) * (ellipk(squared) - ellipe(squared))) ** 0.5
    middle = (3 * load * mean / (4 * effective) * shape) ** (1 / 3)  # (a b)^(1/2)
    return 1.5 * load / (np.pi * middle**2)


def test_none_is_without_a_test():
    tested = {name.removeprefix("test_") for name in globals() if name.startswith("test_")}
    assert set(SCRIPTS) <= tested


def test_the_method():
    script = run("the_method")
    # A second program by another hand: C, C', P and P' of a strip for one steel body, below the strip and beside it.
    y, c, compliance = np.array([0.0, 1.0]), np.full(2, 0.25), (1 - 0.3**2) / (np.pi * 206000)
    found = [compliance * each[:, 1] for each in script.coefficients(y, np.full(2, 0.4), c)]
    beside, below = (1.18000912e-8, 1.40992791e-7, 1.19573140e-8, 1.37802852e-7), (
        1.09428655e-7, 1.10433121e-6, 2.35687676e-6, 7.02720057e-6
    )  # fmt: skip
    assert_allclose(np.transpose(found), [beside, below], rtol=1e-8)
    # The library on the same strips: an ellipse, one that the body cuts off, and a long contact that lifts off tilted.
    whole, cut_off, long = script.edges, np.linspace(-4, 4, 42), np.linspace(-10, 10, 42)
    for case in ((100, whole, 1000), (100, cut_off, 8000), (1000, long, 20e3, 2e-3)):
        approach, pressure, half_width, moment = script.pressed(*case)
        expected = script.by_the_library(*case)
        assert_allclose(approach, expected[0], rtol=1e-9)
        assert_allclose(pressure, expected[1], rtol=1e-9, atol=1e-9 * pressure.max())
        assert_allclose(half_width, expected[2], rtol=1e-9, atol=1e-9 * half_width.max())
        assert_allclose(moment, expected[3], rtol=1e-9, atol=1e-6)


def test_crown_or_logarithm():
    script = run("crown_or_logarithm")
    # The contact on the strong crown ends well inside the roller: it is Hertz's ellipse. Side faces 1.6 mm beyond it,
    # six half-widths, leave some tenths of a percent.
    expected = elliptical(script.LOAD, script.RADIUS, 600)
    assert_allclose(script.upright["crown, radius 0.6 m"].max_pressure, expected, rtol=5e-3)


def test_elliptical_footprint():
    # Two and a half times the accuracy that the automatic grid aims for in the approach.
    assert_allclose(run("elliptical_footprint").solution.max_pressure, elliptical(1000, 10, 100), rtol=2.5e-4)


def test_sharp_end():
    # A body ends on one of the same material and is freed of shear: cos(pi alpha) = 1/2. The powers -alpha and alpha
    # are fitted to the pressures within a quarter of the half-width, but for the strips at the very end.
    finest = run("sharp_end").refined[0]
    distance, pressure = 10 - finest.y[-16:-3], finest.centre_pressure[-16:-3]

    def misfit(alpha):
        powers = np.stack([distance**-alpha, distance**alpha], axis=1) / pressure[:, None]
        return np.linalg.lstsq(powers, np.ones(distance.size), rcond=None)[1][0]

    alphas = np.linspace(0.2, 0.5, 301)
    assert_allclose(alphas[np.argmin([misfit(alpha) for alpha in alphas])], 1 / 3, rtol=0.03)


def test_misalignment_map():
    script = run("misalignment_map")
    path = ROOT / "benchmarks" / "logarithmic.json"
    reference = json.loads(path.read_text(encoding="utf-8"))["cases"]["logarithmic"]["value"]
    case = script.many[-1, int(np.argmin(np.abs(script.TILTS + 1e-3)))]
    assert_allclose((case.load, case.tilt), (40e3, -1e-3), rtol=1e-9)
    # Rectangles on a plane grid, by programs of others. The tilt drives the pressure up to the steep end of the
    # profile, where strips are good for half a percent.
    assert_allclose(case.approach, reference["approach"], rtol=1e-4)
    assert_allclose(case.max_pressure, reference["max_pressure"], rtol=5e-3)


@pytest.mark.campaign
def test_stress_below():
    # Johnson, Section 4.2(a): 0.30 p0 at 0.78 half-widths below a line contact. The profile makes it a little shorter.
    script = run("stress_below")
    assert_allclose(script.below.max_shear.max() / script.pressure, 0.30, atol=0.005)
    assert_allclose(script.depths[script.deepest], 0.78, atol=0.02)


@pytest.mark.campaign
def test_life_against_drop():
    # The profile designed for a load spreads it evenly over an upright roller, all but its ends: the ideal, life 1.
    script = run("life_against_drop")
    at_design = np.interp(script.LOAD, script.DESIGN_LOADS, script.lives["upright"])
    # The ends are free, softer than those of the half-spaces that the profile is designed for: they bear less.
    assert 0.93 < at_design < 1.0
    best = [script.drops[lives.argmax()] for lives in script.lives.values()]
    assert np.all(np.diff(best) > 0)


def test_dent():
    # Away from the dent, two methods that share nothing; cells of 0.02 mm and the dent's load leave some tenths.
    script = run("dent")
    for y in (-6.0, -3.0, 0.0, 6.0):
        on_the_grid = np.interp(y, script.dented.y, script.dented.centre_pressure)
        assert_allclose(on_the_grid, np.interp(y, script.strips.y, script.strips.centre_pressure), rtol=5e-3)


def test_wheel_on_rail():
    # On one arc the contact is Hertz's ellipse, be it wider than long. An arc that is tilted, not turned, has the
    # second derivative (1 + slope^2)^1.5 / radius. Between the arcs a plane grid, which shares nothing with strips.
    script = run("wheel_on_rail")
    level, tilted = script.solutions[0], script.solutions[-1]
    steep = script.STEEP_ARC / (1 + tilted.tilt**2) ** 1.5
    assert_allclose(level.max_pressure, elliptical(script.LOAD, script.FLAT_ARC, 460), rtol=5e-4)
    assert_allclose(tilted.max_pressure, elliptical(script.LOAD, steep, 460), rtol=5e-4)
    strips = [script.solutions[number].max_pressure for number in script.CHECKED]
    # The coarse cells smooth the corner of the pressure at the joint of the arcs.
    assert_allclose(strips, [grid.max_pressure for grid in script.on_grid], rtol=6e-3)


def test_measured_bearing():
    # A plane grid on the same points, which shares nothing with strips; 512 cells along leave a tenth of a percent.
    script = run("measured_bearing")
    upright = script.found["first roller"][0]
    strips = upright.contact(0, "inner")
    grid = nh.patch.solve(strips.contact, load=strips.load, cells=(32, 512))
    assert_allclose(strips.max_pressure, grid.max_pressure, rtol=2e-3)
    # Rollers balance the bearing: a sum by hand.
    assert_allclose(upright.load[:, 0] @ np.cos(upright.angle), script.LOAD, rtol=1e-6)


def even_life(load, dynamic, rollers, gamma):
    """Return L10r [10^6] if all loads [N], of shape (rollers, 2), were even along the rollers.

    ISO/TS 16281 with all laminae alike, for an inner ring that turns; lambda nu = 0.83 is ISO 281's.
    """
    ratio = (1.038 * ((1 - gamma) / (1 + gamma)) ** (143 / 108)) ** 4.5
    inner = dynamic / (0.83 * 0.378 * rollers) * (1 + ratio) ** (2 / 9)
    outer = dynamic / (0.83 * 0.364 * rollers) * (1 + 1 / ratio) ** (2 / 9)
    turning = np.mean(load[:, 0] ** 4) ** (1 / 4)
    standing = np.mean(load[:, 1] ** 4.5) ** (1 / 4.5)
    return ((turning / inner) ** 4.5 + (standing / outer) ** 4.5) ** (-8 / 9)


def test_misaligned_bearing():
    script = run("misaligned_bearing")
    even = {name: even_life(states[0].load, script.DYNAMIC, 13, 9 / 46.5) for name, states in script.found.items()}
    # Straight rollers are even between their corners, which is what ISO 281 counts. Beside the corners the pressure
    # peaks, which does not count here, and takes some load from elsewhere.
    straight = nh.bearing.assess(script.found["straight"][0], dynamic=script.DYNAMIC, edge_stress="none").reference_life
    assert_allclose(straight, even["straight"], rtol=0.01)
    # Nothing beats even loads, and tilt never helps.
    assert all(each[0] < even[name] for name, each in script.lives.items())
    assert all(np.all(np.diff(each) < 0.0) for each in script.lives.values())


def test_spherical_under_tilt():
    script = run("spherical_under_tilt")
    upright, tilted = script.found["spherical"][0], script.found["spherical"][-1]
    # A sphere turns in a sphere. A roller shifts along its groove to follow, by a thousandth of its length.
    assert_allclose(tilted.load, upright.load, rtol=2e-3, atol=1.0)
    assert abs(tilted.force[4]) < 1e-6 * abs(script.found["cylindrical"][-1].force[4])
    # Hertz's ellipse. It ends 0.4 mm before the barrels do, whose free ends are softer: the middle bears a little more.
    inner = 0.5 * script.PITCH / np.cos(script.ANGLE) - 0.5 * script.DIAMETER
    radius = 1 / (2 / script.DIAMETER + 1 / inner)
    along = 1 / (1 / (0.97 * script.SPHERE) - 1 / script.SPHERE)
    expected = elliptical(upright.load[0, 0], radius, along)
    assert 1.0 < upright.max_pressure[0, 0] / expected < 1.02


def test_tapered_pair():
    script = run("tapered_pair")
    # The shaft is in balance: outer rings, on which there are no ribs, bear what it bears.
    assert_allclose(script.rows @ [1.0, -1.0], script.AXIAL, rtol=1e-6)
    # Hertz's exponent for ellipses, 3/2, on half-spaces, where the approach is that of the contact alone. The curvature
    # of cones changes along them, and rollers under thrust tilt a little.
    bodies = {name: getattr(script.ROW, name) for name in ("roller", "inner", "outer")}
    loose = {name: dataclasses.replace(body, depth="none", side_faces="none") for name, body in bodies.items()}
    script.ROW = dataclasses.replace(script.ROW, **loose)
    half = 0.5 * script.TAKEN
    rest, gone = (nh.bearing.solve(script.pair(script.TAKEN), axial_displacement=by) for by in (0.0, half))
    assert_allclose(gone.force[0] / script.thrusts(rest)[0], 2**1.5, rtol=0.01)
    # Thin rings yield as the load: a little more.
    assert 1.0 < script.let_go / script.preload / 2**1.5 < 1.07


def test_design_a_profile():
    script = run("design_a_profile")
    assert script.crown.agreeing == script.free.agreeing == 2
    # A free form can do what a crown does.
    assert script.free.value < script.crown.value < script.crown.before
    # Hertz's line pressure with the load spread evenly over the land bounds the best from below.
    reduced = 1 / (2 / 20 + 2 / 80)
    hertz = nh.hertz.line_contact(line_load=20e3 / 19, radius=reduced, compliance=script.case.contact.compliance)
    assert 1.0 < script.free.value / hertz.max_pressure < 1.15


def test_sweep_of_a_bearing():
    script = run("sweep_of_a_bearing")
    assert script.found.failed == 0
    row = dataclasses.replace(script.bearing, clearance=0.02)
    alone = nh.bearing.solve(row, radial=11e3, tilt=0.75e-3, method="slices")
    at = int(np.argmin(np.abs(script.found["bearing.clearance"][:, 0] - 0.02)))
    assert_allclose(script.found["max_load"][at, 4], alone.load.max(), rtol=1e-12)
    assert np.all(np.diff(script.life, axis=1) < 0.0)


def test_which_tolerance():
    script = run("which_tolerance")
    low, middle, high = script.quantiles
    assert low.value < middle.value < high.value
    # The load by itself: p is about as its power 0.4 of a crown, so that 0.5 of 15 kN make 1.3 %.
    of_load = next(each for each in script.indices if each.path == "load.load")
    values = script.found.samples("max_pressure")
    assert_allclose(np.sqrt(of_load.first) * values.std() / values.mean(), 0.4 * 0.5 / 15, rtol=0.35)
    assert abs(sum(each.first for each in script.indices) - 1.0) < 0.35
