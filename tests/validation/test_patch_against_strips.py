"""Rectangles against strips, two methods that share nothing but the bodies: smooth contacts, faces, depths, tilt."""

import numpy as np
import pytest

import nonhertz as nh

LOGARITHMIC = nh.profile.iso_logarithmic(diameter=15, length=16)
HALF_SPACE = {"side_faces": "none", "depth": "none"}
CASES = {
    "crown, half-spaces": ({"profile": nh.profile.crown(1000), **HALF_SPACE}, {"load": 5e3}),
    "crown, mirrored": ({"profile": nh.profile.crown(1000)}, {"load": 5e3, "tilt": 3e-4}),
    "logarithmic, half-spaces": ({"profile": LOGARITHMIC, **HALF_SPACE}, {"load": 10e3, "tilt": 3e-4}),
    "logarithmic, mirrored": ({"profile": LOGARITHMIC}, {"load": 10e3}),
    "logarithmic, calibrated": ({"profile": LOGARITHMIC, "side_faces": "calibrated"}, {"load": 10e3, "tilt": 3e-4}),
    "logarithmic, unlike faces": (
        {"profile": LOGARITHMIC, "side_faces": (0.4, 1.6), "images": 3},
        {"load": 10e3, "tilt": -3e-4},
    ),
    "logarithmic, tapered": (
        {"profile": LOGARITHMIC, "diameter": nh.TabulatedDiameter((-8.0, 8.0), (14.0, 17.0))},
        {"load": 10e3, "moment": 5e3},
    ),
    "logarithmic, by approach": ({"profile": LOGARITHMIC, "images": "series"}, {"approach": 0.02, "moment": -3e3}),
}


@pytest.mark.parametrize("name", CASES)
def test_both_find_the_same(name):
    changes, prescribed = CASES[name]
    roller = nh.Roller(**({"diameter": 15, "length": 16, "side_faces": "mirror"} | changes))
    contact = nh.Contact(roller, nh.Ring(diameter=60))
    strips = nh.solve(contact, **prescribed)
    patch = nh.patch.solve(contact, **prescribed, cells=(96, 256))
    middle = [float(np.interp(0.0, patch.y, each)) for each in (patch.centre_pressure, patch.line_load)]
    at = np.argmin(np.abs(strips.y))
    assert abs(strips.y[at]) < 1e-9
    # 2e-4 is what both methods ask of themselves; the strips' own estimate of their error is of that size.
    np.testing.assert_allclose(patch.approach, strips.approach, rtol=2e-4, atol=0.0)
    np.testing.assert_allclose(patch.load, strips.load, rtol=3e-4, atol=0.0)  # goes like approach to the 10/9
    np.testing.assert_allclose(patch.tilt, strips.tilt, rtol=1e-3, atol=1e-7)
    np.testing.assert_allclose(patch.moment, strips.moment, rtol=0.0, atol=3e-4 * strips.load)
    np.testing.assert_allclose(middle[0], strips.centre_pressure[at], rtol=2e-4, atol=0.0)
    np.testing.assert_allclose(middle[1], strips.line_load[at], rtol=3e-4, atol=0.0)


def test_a_straight_roller_away_from_its_ends():
    # Mirrored ends on a long plate: a weak singularity, which strips take for a semi-ellipse across. The middle is
    # what both can know.
    contact = nh.Contact(nh.Roller(diameter=15, length=16, side_faces="mirror"), nh.Plate())
    strips, patch = nh.solve(contact, load=10e3), nh.patch.solve(contact, load=10e3, cells=(64, 512))
    inner = np.abs(strips.y) < 6.0
    pressure = np.interp(strips.y[inner], patch.y, patch.centre_pressure)
    np.testing.assert_allclose(pressure, strips.centre_pressure[inner], rtol=1e-3, atol=0.0)
    np.testing.assert_allclose(patch.approach, strips.approach, rtol=1e-3, atol=0.0)
