"""Motions of rings and rollers in the plane through the axis, against rotations of bodies in space."""

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation

from nonhertz.bearing.section import point_motion, raceway_motion, ring_motion

ANGLES = np.array([0.0, 0.7, 2.0, 4.5])


def test_motion_at_a_roller_is_that_of_the_ring_in_space():
    x, r = 3.0, 40.0
    found = ring_motion(ANGLES, (x, r))
    small = 1e-7
    for k, moved in enumerate(small * np.eye(5)):
        turned = Rotation.from_rotvec([0.0, moved[3], moved[4]])
        for j, phi in enumerate(ANGLES):
            radial, tangent = np.array([0.0, np.cos(phi), np.sin(phi)]), np.array([0.0, -np.sin(phi), np.cos(phi)])
            place = np.array([x, 0.0, 0.0]) + r * radial
            by = turned.apply(place) - place + moved[:3]
            expected = [by[0], by @ radial, turned.as_rotvec() @ tangent]
            assert_allclose(found[j, :, k] * small, expected, atol=1e-11)


@pytest.mark.parametrize("inner", [True, False])
@pytest.mark.parametrize("angle", [0.0, 0.3, np.pi / 2])
def test_a_raceway_is_approached_along_its_normal_and_tilts_along_the_roller(inner, angle):
    motion = raceway_motion(angle, inner=inner)
    out = 1.0 if inner else -1.0
    normal = out * np.array([np.sin(angle), np.cos(angle)])
    along = np.array([np.cos(angle), -np.sin(angle)])
    radius = 5.0
    against = np.array([0.02, -0.01, 0.003])
    for y in (-4.0, 0.0, 4.0):
        # How far a point of the ring at y moves into the roller.
        place = -radius * normal + y * along
        moved = against[:2] + against[2] * np.array([-place[1], place[0]])
        approach, tilt = motion @ against
        assert approach + tilt * y == pytest.approx(normal @ moved, rel=1e-12)


def test_a_point_is_approached_along_its_normal():
    normal, place = np.array([0.8, -0.6]), np.array([-3.0, 2.0])
    against = np.array([0.02, -0.01, 0.003])
    moved = against[:2] + against[2] * np.array([-place[1], place[0]])
    assert_allclose(point_motion(normal, place) @ against, [normal @ moved, 0.0])
