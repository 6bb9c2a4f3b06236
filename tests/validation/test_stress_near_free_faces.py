"""Stress near free side faces against direct sums and finite elements that share no code with the package."""

import json
from pathlib import Path

import numpy as np
import pytest
from free_face_elements import places, solved

import nonhertz as nh
from nonhertz import subsurface
from nonhertz.subsurface.field import von_mises_of
from nonhertz.subsurface.free_faces import FreeFaceField
from nonhertz.subsurface.lamination import Lamination
from nonhertz.subsurface.strips import StripLoad

pytestmark = pytest.mark.filterwarnings("ignore::nonhertz.AccuracyWarning")

DATA = Path(__file__).parent / "data"
ELEMENTS = json.loads((DATA / "free-faces.json").read_text(encoding="utf-8"))
SUMS = np.loadtxt(DATA / "quarter-space-stress.txt")
# Poisson's ratio, and strips: from, to, p0 and half-width.
STRIPS = {
    "A": (0.3, [(0.0, 2000.0, 1.0, 1.0)]),
    "B": (0.2, [(0.5, 2.0, 1.0, 1.0)]),
    "C": (0.4, [(0.0, 0.6, 0.7, 0.8), (0.6, 2.0, 0.95, 0.95), (2.0, 8.0, 1.0, 1.0)]),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", STRIPS)
def test_a_quarter_space_under_strips(name):
    poisson, strips = STRIPS[name]
    low, high, pressure, half_width = np.array(strips).T
    twice = [np.tile(each, 2) for each in (low, high, 0.5 * np.pi * pressure * half_width, half_width)]
    load = StripLoad(Lamination(*twice, len(strips) + np.arange(len(strips) + 1)))
    face = FreeFaceField.of(load.spectrum, 0.0, -1.0, 1.0, min(high.max(), 200.0), poisson)
    points, wanted = SUMS[:, :3], SUMS[:, 3:].reshape(-1, 3, 6)[:, "ABC".index(name)]
    images = load.stress(points * [1.0, -1.0, 1.0], poisson) * [1.0, 1.0, 1.0, -1.0, 1.0, -1.0]
    found = load.stress(points, poisson) + images + face.stress(points)
    # The sums have four digits; at 0.3 and more of the half-width the table leaves 1e-4.
    np.testing.assert_allclose(found, wanted, rtol=0.0, atol=2e-4)


@pytest.mark.slow
@pytest.mark.parametrize("name", ELEMENTS)
def test_finite_elements_of_bodies_between_free_faces(name):
    solution = solved(ELEMENTS[name])
    points, wanted = places(solution), np.array(ELEMENTS[name]["stress"])
    found = subsurface.stress(solution, *points.T)
    # Without the images beyond the first sigma_x would be off by 1.4 %, and by 5.7 % in a body 4 half-widths wide.
    assert np.abs(found.stress - wanted).max() < 0.008 * solution.max_pressure
    # Of the largest in the body: here, or that of a line contact elsewhere. With images alone it is -10 to +50 %.
    largest = max(float(von_mises_of(wanted).max()), 0.558 * solution.max_pressure)
    assert np.abs(found.von_mises - von_mises_of(wanted)).max() < 0.0125 * largest


@pytest.mark.slow
def test_the_largest_stress_of_both_bodies_that_end_together():
    # Von Mises stress by finite elements of a long body, by the distance from its face; with images alone it is 1205.
    roller = nh.Roller(diameter=20, length=20, material=nh.Material(206000.0, 0.3))
    ring = nh.Ring(diameter=80, length=20, depth=10, material=nh.Material(206000.0, 0.3))
    solution = nh.solve(nh.Contact(roller, ring), load=20e3)
    distance = np.array([0.0, 0.1, 0.2, 0.3, 0.5, 1.0, 2.0, 5.0])
    wanted = [1229.9, 1309.4, 1336.6, 1321.3, 1285.6, 1245.5, 1229.4, 1220.1]
    found = subsurface.axial_plane(solution, 10.0 - distance, np.linspace(0.08, 0.4, 33)).von_mises.max(axis=1)
    # What the other face adds, 20 mm away, is 0.4 %.
    np.testing.assert_allclose(found, wanted, rtol=0.01)
    largest = subsurface.extremes(solution, depths=(0.08, 1.0)).von_mises
    assert largest.max == pytest.approx(1337.0, rel=0.02)
    assert abs(largest.y) == pytest.approx(9.8, abs=0.05)
