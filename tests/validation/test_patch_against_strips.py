"""Plane grid against strips, two methods that share nothing but the bodies and what their faces and depths add.

Beside what the claims say: weights, depths, rounded corners, and free faces of unlike bodies.
"""

import math

import numpy as np
import pytest

import nonhertz as nh
from claims.claim import pressures

# Sharp ends, where the pressure has no limit, and corners.
pytestmark = pytest.mark.filterwarnings("ignore::nonhertz.AccuracyWarning")

LOGARITHMIC = {"profile": nh.profile.iso_logarithmic(diameter=15, length=16)}
SMOOTH = {
    "logarithmic, calibrated": ({**LOGARITHMIC, "side_faces": "calibrated"}, {"load": 10e3, "tilt": 3e-4}),
    "logarithmic, unlike faces": (
        {**LOGARITHMIC, "side_faces": (0.4, 1.6), "images": 3}, {"load": 10e3, "tilt": -3e-4}
    ),
    "logarithmic, by approach": ({**LOGARITHMIC, "images": "series"}, {"approach": 0.02, "moment": -3e3}),
}  # fmt: skip


def in_middle(solution, quantity):
    return float(np.interp(0.0, solution.y, getattr(solution, quantity)))


@pytest.mark.parametrize("name", SMOOTH)
def test_smooth_contacts(name):
    changes, prescribed = SMOOTH[name]
    contact = nh.Contact(
        nh.Roller(**({"diameter": 15, "length": 16, "side_faces": "mirror"} | changes)), nh.Ring(diameter=60)
    )
    strips, patch = nh.solve(contact, **prescribed), nh.patch.solve(contact, **prescribed, cells=(96, 256))
    # 2e-4 is what both methods ask of themselves; the strips' own estimate of their error is of that size.
    assert patch.approach == pytest.approx(strips.approach, rel=2e-4)
    assert patch.load == pytest.approx(strips.load, rel=3e-4)  # goes like approach to the 10/9
    assert patch.tilt == pytest.approx(strips.tilt, rel=1e-3, abs=1e-7)
    assert patch.moment == pytest.approx(strips.moment, rel=0.0, abs=3e-4 * strips.load)
    for quantity, off in (("centre_pressure", 2e-4), ("line_load", 3e-4)):
        assert in_middle(patch, quantity) == pytest.approx(in_middle(strips, quantity), rel=off)


def test_a_straight_roller_away_from_its_ends():
    # Mirrored ends on a long plate: a weak singularity, which strips take for a semi-ellipse across. The middle is
    # what both can know.
    contact = nh.Contact(nh.Roller(diameter=15, length=16, side_faces="mirror"), nh.Plate())
    strips, patch = nh.solve(contact, load=10e3), nh.patch.solve(contact, load=10e3, cells=(64, 512))
    inner = np.abs(strips.y) < 6.0
    pressure = np.interp(strips.y[inner], patch.y, patch.centre_pressure)
    np.testing.assert_allclose(pressure, strips.centre_pressure[inner], rtol=1e-3, atol=0.0)
    np.testing.assert_allclose(patch.approach, strips.approach, rtol=1e-3, atol=0.0)


@pytest.mark.slow
@pytest.mark.parametrize("drop", [0.010, 0.015, 0.020, 0.025])
def test_the_peak_at_a_rounded_corner(drop):
    # The crown drops by so much at the ends of its land.
    crown = nh.profile.crown(radius=9.5**2 / (2.0 * drop))
    roller = nh.Roller(diameter=15.0, length=20.0, profile=crown, corner_radius=0.5, side_faces="mirror", depth="none")
    contact, given = nh.Contact(roller, nh.Ring(diameter=80.0)), {"load": 30e3, "tilt": math.radians(2.0 / 60.0)}
    strips, grid = nh.solve(contact, **given), nh.patch.solve(contact, **given, cells=(64, 2048))
    highest = int(np.argmax(grid.centre_pressure))
    assert strips.max_pressure == pytest.approx(grid.centre_pressure[highest], rel=0.005)
    assert strips.max_pressure_y == pytest.approx(grid.y[highest], abs=0.01)
    assert strips.approach == pytest.approx(grid.approach, rel=1e-4)
    assert strips.moment == pytest.approx(grid.moment, rel=1e-3)


# Free faces: strips read their own integrals of what they add along their length, of a pressure that is a semi-ellipse
# across; cells have a matrix between rows, of a pressure that is anything across.
STEEL = nh.Material(206000.0, 0.3)
SIZE = {"diameter": 20.0, "length": 20.0}
FREE = {"side_faces": "free", "depth": "none", "material": STEEL}
AS_LONG = nh.Ring(diameter=80.0, length=20.0, **FREE)
TILTED = {"tilt": 0.3e-3}
FREE_FACES = {
    "straight, both end": (FREE, AS_LONG, {"load": 20e3}),
    "logarithmic, both end": (
        FREE | {"profile": nh.profile.iso_logarithmic(**SIZE)}, AS_LONG, {"load": 42e3, **TILTED}
    ),
    "unlike bodies and faces": (
        FREE | {"material": nh.Material(100000.0, 0.42), "side_faces": ("free", "mirror")},
        nh.Ring(diameter=80.0, length=20.4, position=0.1, **FREE), {"load": 10e3, **TILTED},
    ),
    "plane-strain depth": (
        FREE | {"depth": "plane-strain"}, nh.Ring(diameter=80.0, material=STEEL), {"load": 20e3, **TILTED}
    ),
}  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize("name", FREE_FACES)
def test_free_faces(name):
    changes, ring, given = FREE_FACES[name]
    contact = nh.Contact(nh.Roller(**SIZE, **changes), ring)
    strips, patch = nh.solve(contact, **given), nh.patch.solve(contact, **given, cells=(64, 512))
    # Found: 1e-5, 3e-4 where tilted, and 3e-5.
    assert patch.approach == pytest.approx(strips.approach, rel=5e-5)
    assert patch.moment == pytest.approx(strips.moment, rel=1e-3, abs=1.0)
    assert in_middle(patch, "centre_pressure") == pytest.approx(in_middle(strips, "centre_pressure"), rel=1e-4)
    assert patch.max_pressure == pytest.approx(strips.max_pressure, rel=2e-3)
    half_width = float(strips.half_width.max())
    places = np.outer([-1.0, 1.0], 10.0 - half_width * np.array([0.5, 0.7, 1.0, 2.0, 5.0])).ravel()
    clear = np.min(np.abs(places[:, None] - np.ravel(strips.contact_y)), axis=1) > 0.25 * half_width
    of_patch, of_strips = (np.array(pressures(each, places))[clear] for each in (patch, strips))
    np.testing.assert_allclose(of_patch, of_strips, rtol=5e-3)
