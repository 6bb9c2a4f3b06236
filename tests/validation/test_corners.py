"""Rounded corners against the plane grid, which has no strips."""

import math

import numpy as np
import pytest

import nonhertz as nh

pytestmark = pytest.mark.filterwarnings("ignore::nonhertz.AccuracyWarning")

LOAD = {"load": 30e3, "tilt": math.radians(2.0 / 60.0)}


def rounded(drop):
    """A roller whose crown drops by so much at the ends of its land, on a ring."""
    crown = nh.profile.crown(radius=9.5**2 / (2.0 * drop))
    roller = nh.Roller(diameter=15.0, length=20.0, profile=crown, corner_radius=0.5, side_faces="mirror", depth="none")
    return nh.Contact(roller, nh.Ring(diameter=80.0))


@pytest.mark.slow
@pytest.mark.parametrize("drop", [0.010, 0.015, 0.020, 0.025])
def test_the_peak_at_a_rounded_corner_is_that_of_the_plane_grid(drop):
    strips, grid = nh.solve(rounded(drop), **LOAD), nh.patch.solve(rounded(drop), **LOAD, cells=(64, 2048))
    highest = int(np.argmax(grid.centre_pressure))
    assert strips.max_pressure == pytest.approx(grid.centre_pressure[highest], rel=0.005)
    assert strips.max_pressure_y == pytest.approx(grid.y[highest], abs=0.01)
    assert strips.approach == pytest.approx(grid.approach, rel=1e-4)
    assert strips.moment == pytest.approx(grid.moment, rel=1e-3)
