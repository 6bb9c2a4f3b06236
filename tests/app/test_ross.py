"""Bearings in ROSS: its rotors on ours against closed forms, and axes and units against forces."""

import doctest
import importlib
import math
import re
from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_allclose

import nonhertz as nh
from nonhertz.rotor import bearing_element, stiffness

B = nh.bearing
PLAIN = {"side_faces": "none", "depth": "none"}
ROW = B.CylindricalRollerBearing(
    roller=nh.Roller(diameter=9.0, length=10.0, profile=nh.profile.crown(1200.0), **PLAIN),
    inner=nh.Ring(diameter=37.5),
    outer=nh.Ring(diameter=-55.5),
    rollers=13,
    clearance=0.01,
)
CONE = B.TaperedRollerBearing(
    roller=nh.Roller(
        diameter=nh.TabulatedDiameter((-5.825, 5.825), (10.94, 10.12)),
        length=11.65,
        profile=nh.profile.crown(8000.0),
        **PLAIN,
    ),
    inner=nh.Ring(diameter=40.8),
    outer=nh.Ring(diameter=-62.32),
    rollers=14,
    contact_angle=0.207,
)
LOADED = B.solve(ROW, radial=(6e3, 3e3), method="slices")
# Little more thrust than holds the row together, so that one side bears the load.
THRUST = B.solve(CONE, radial=(9e3, 4e3), axial=2.6e3, method="slices")


@pytest.fixture(scope="module")
def ross():
    # Which ignores what its imports warn of.
    return pytest.importorskip("ross")


# Without ROSS


def test_forces_along_its_axes_follow_from_displacements_along_them():
    # ROSS's x, y, z in the order in which they are here.
    ours, step = [1, 2, 0], 1e-6
    found = stiffness(THRUST)
    for k, motion in enumerate(ours):
        moved = np.array([THRUST.displacement + way * step * np.eye(5)[motion] for way in (-1.0, 1.0)])
        low, high = B.solve_many(CONE, displacement=moved, method="slices").force
        by_metre = (high - low)[ours] / (2.0 * step * 1e-3)
        assert_allclose(found[:, k], by_metre, rtol=1e-4, atol=1e-4 * found[0, 0])
    # The load lies between x and y, nearer to x: there it is stiffest, and both are coupled.
    assert found[0, 0] > found[1, 1] > 1e6
    assert found[0, 1] == pytest.approx(found[1, 0], rel=1e-6)
    assert found[0, 1] > 1e6


def test_a_load_along_our_y_is_one_along_its_x():
    along = {name: stiffness(B.solve(ROW, radial=load, method="slices")) for name, load in
             {"y": (6e3, 0.0), "z": (0.0, 6e3)}.items()}  # fmt: skip
    assert along["y"][0, 0] > 1.5 * along["y"][1, 1]
    assert along["z"][1, 1] > 1.5 * along["z"][0, 0]


@pytest.mark.parametrize("free", ["x", "about_z"])
def test_a_motion_that_is_let_go_gives_way(free):
    # By solving with the force along it kept as it is.
    kept = {"moment": tuple(THRUST.force[3:])} if free == "about_z" else {}
    found, step = stiffness(THRUST, free=[free] if free == "x" else ["about_y", "about_z"]), 1e-5
    moved = []
    for way in (-1.0, 1.0):
        radial = {"radial_displacement": tuple(THRUST.displacement[1:3] + np.array([way * step, 0.0]))}
        held = {"axial": 2.6e3} if free == "x" else {"axial_displacement": float(THRUST.displacement[0])}
        moved.append(B.solve(CONE, **radial, **held, **kept, method="slices").force)
    assert_allclose(found[:2, 0], (moved[1] - moved[0])[1:3] / (2.0 * step * 1e-3), rtol=1e-3)
    assert found[0, 0] < 0.98 * stiffness(THRUST)[0, 0]
    assert bool(found[2, 2] == 0.0) is (free == "x")


def test_what_nothing_resists_changes_nothing():
    # A cylindrical row is free along its axis.
    assert_allclose(stiffness(LOADED, free=["x"]), stiffness(LOADED), rtol=1e-12)


def test_rosss_absence_is_said(monkeypatch):
    def missing(name, *_):
        raise ImportError(name)

    monkeypatch.setattr(importlib, "import_module", missing)
    with pytest.raises(ImportError, match=r"bearing_element needs ross-rotordynamics: .* with the extra 'ross'"):
        bearing_element(0, LOADED)


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"n": -1}, "n = -1 must be a whole number"),
        ({"solution": ROW}, "solution = .* must be solutions of a bearing"),
        ({"solution": [ROW]}, "solution = .* must be a BearingSolution"),
        ({"solution": []}, "must hold a solution for each speed"),
        ({"solution": [LOADED, LOADED]}, "speed = None must be real numbers: give the speed of each solution"),
        ({"solution": [LOADED, LOADED], "speed": [100.0, 100.0]}, "must be ascending and as many as the solutions, 2"),
        ({"speed": 100.0}, "speed = 100.0 must be ascending and as many as the solutions, 1"),
        ({"damping": -1.0}, "damping = -1.0 must not be negative"),
        ({"damping_time": None}, "damping_time = None must be"),
        ({"free": ["y"]}, "free = 'y' must be a motion that ROSS does not need"),
        ({"free": "x"}, "free = 'x' must be a list of motions"),
    ],
)
def test_bad_arguments_are_refused(given, said):
    with pytest.raises(nh.InputError, match=said):
        bearing_element(**{"n": 0, "solution": LOADED} | given)


# With ROSS

PAGE = Path(__file__).parents[2] / "docs" / "how-to" / "bearing-elsewhere.md"
LENGTH, MASS, MODULUS = 0.4, 30.0, 211e9


def rotor(ross, bearings, diameter):
    """A light shaft, a thousandth of the disc at most, and a disc without moments of inertia in its middle."""
    light = ross.Material(name="light", rho=10.0, E=MODULUS, G_s=MODULUS / 2.6)
    piece = {"L": LENGTH / 6, "idl": 0.0, "odl": diameter, "material": light}
    shaft = [ross.ShaftElement(**piece, shear_effects=False, rotary_inertia=False) for _ in range(6)]
    # Not quite without, as ROSS inverts the matrix of masses.
    return ross.Rotor(shaft, [ross.DiskElement(n=3, m=MASS, Id=1e-4, Ip=1e-4)], bearings)


def bending_stiffness(diameter):
    """Of a shaft on two supports, in its middle: 48 E I / L^3."""
    return 48.0 * MODULUS * math.pi * diameter**4 / 64.0 / LENGTH**3


def on_both_ends(solution):
    return [bearing_element(at, solution, tag=f"bearing {at}") for at in (0, 6)]


def nearest(values, to):
    return values[np.argmin(np.abs(values - to))]


def test_the_element_has_the_stiffness_of_the_bearing(ross):
    element = bearing_element(3, THRUST, damping=200.0, damping_time=1e-5, tag="left")
    assert isinstance(element, ross.BearingElement)
    assert (element.n, element.tag) == (3, "left")
    held = np.ones((3, 3))
    held[:2, 2] = held[2, :2] = 0.0  # ROSS does not couple radial with axial motions
    assert_allclose(element.K(0.0), stiffness(THRUST) * held, rtol=1e-12)
    assert_allclose(element.C(0.0), 1e-5 * stiffness(THRUST) * held + 200.0 * np.eye(3), rtol=1e-12)
    free_along = bearing_element(0, LOADED, damping=200.0)
    assert free_along.C(0.0)[2, 2] == 0.0


def test_a_rigid_rotor_has_the_natural_frequencies_of_a_mass_on_springs(ross):
    # Both bearings bear half of the disc; along the axes of their stiffness, motions are not coupled.
    found = rotor(ross, on_both_ends(LOADED), 0.3).run_modal(0.0, num_modes=12).wn
    for spring in np.linalg.eigvalsh(2.0 * stiffness(LOADED)[:2, :2]):
        in_series = 1.0 / (1.0 / spring + 1.0 / bending_stiffness(0.3))
        assert in_series > 0.9 * spring
        expected = math.sqrt(in_series / MASS)
        # The shaft weighs 0.9 % of the disc here, and half of that at its ends.
        assert nearest(found, expected) == pytest.approx(expected, rel=5e-3)


@pytest.mark.parametrize("diameter", [0.02, 0.04, 0.08])
def test_the_first_critical_speed_of_a_flexible_shaft_on_our_bearings(ross, diameter):
    # Jeffcott's rotor: the shaft in series with both bearings. Without gyroscopic moments a critical speed is a natural
    # frequency.
    symmetric = B.solve(ROW, radial=(6e3, 0.0), method="slices")
    found = rotor(ross, on_both_ends(symmetric), diameter).run_critical_speed(num_modes=8).wn()
    by_axis = 1.0 / (1.0 / bending_stiffness(diameter) + 1.0 / (2.0 * np.diag(stiffness(symmetric))[:2]))
    expected = np.sqrt(by_axis / MASS)
    # A cylindrical row leaves the rotor free along its axis.
    assert np.min(found[found > 1.0]) == pytest.approx(np.min(expected), rel=1e-3)
    if diameter > 0.05:
        # The bearings give way as much as the shaft.
        assert np.min(expected) < 0.9 * math.sqrt(bending_stiffness(diameter) / MASS)


def test_axial_stiffness_carries_the_rotor_along_its_axis(ross):
    found = rotor(ross, on_both_ends(THRUST), 0.3).run_modal(0.0, num_modes=12).wn
    expected = math.sqrt(2.0 * stiffness(THRUST)[2, 2] / MASS)
    # The shaft is a hundred times as stiff along its axis.
    assert nearest(found, expected) == pytest.approx(expected, rel=1e-2)


def test_coefficients_follow_speed(ross):
    # Rollers pressed outwards leave the inner ring softer; at 24,000 1/min by more than a hundredth.
    speed = np.array([0.0, 8e3, 16e3, 24e3])
    states = [B.solve(ROW, radial=1e3, speed=float(each), method="slices") for each in speed]
    element = bearing_element(0, states, speed=speed)
    assert_allclose(element.frequency, speed * 2.0 * math.pi / 60.0, rtol=1e-12)
    for each, at in zip(states, element.frequency, strict=True):
        assert_allclose(element.K(at)[:2, :2], stiffness(each)[:2, :2], rtol=1e-6, atol=1.0)
    assert abs(element.kxx[-1] / element.kxx[0] - 1.0) > 1e-2


@pytest.mark.slow
def test_what_the_how_to_shows_runs(ross, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    text = PAGE.read_text(encoding="utf-8")
    assert text.count("```py\n") == 2
    # Up to the tables, whose blocks are doctests of their own, as those before them are.
    upto = text[: text.index("## Forces for multibody programs")]
    names: dict[str, object] = {}
    for kind, block in re.findall(r"^```(pycon|py)\n(.*?)^```$", upto, re.MULTILINE | re.DOTALL):
        examples = doctest.DocTestParser().get_examples(block)
        exec("".join(each.source for each in examples) if kind == "pycon" else block, names)
    # Shaft and disc on points, by Rayleigh's quotient: 48 E I / L^3 bears the disc and half of the shaft.
    shaft, disc = 7810.0 * math.pi / 4.0 * 0.03**2 * 0.4, 7810.0 * math.pi / 4.0 * (0.2**2 - 0.03**2) * 0.03
    bending = 48.0 * 211e9 * math.pi * 0.03**4 / 64.0 / 0.4**3
    alone = math.sqrt(bending / (disc + 17.0 / 35.0 * shaft)) * 30.0 / math.pi
    first = min(each for each in names["critical"] if each > 100.0)
    assert 0.96 * alone < first < 1.01 * alone
    assert names["element"].frequency[-1] == pytest.approx(15e3 * math.pi / 30.0)
