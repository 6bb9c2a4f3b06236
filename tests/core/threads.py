"""Solves in threads of the core and of Python, for a sanitizer that looks for races; run by sanitized.py."""

from concurrent.futures import ThreadPoolExecutor

import numpy as np
import other_core

import nonhertz as nh

assert other_core.path
PROFILE = nh.profile.crown(radius=1000)
CONTACT = nh.Contact(nh.Roller(diameter=20, length=20, profile=PROFILE), nh.Ring(diameter=80))
LOADS = np.linspace(1e3, 2e4, 120)
NU206 = nh.bearing.CylindricalRollerBearing(
    roller=nh.Roller(diameter=9, length=10, corner_radius=0.3, profile=PROFILE), inner=nh.Ring(diameter=37.5),
    outer=nh.Ring(diameter=-55.5), rollers=13, clearance=0.0184,
)  # fmt: skip


def solved(strips):
    """Return the pressures of many loads, in two threads of Python that enter the core without its lock."""
    return nh.solve_many(CONTACT, load=LOADS, strips=strips, threads=2).max_pressure


def balanced(method):
    """Return how a bearing moves under many loads, worked out by threads of the core."""
    return nh.bearing.solve_many(NU206, radial=LOADS, method=method, threads=3).displacement


if __name__ == "__main__":
    with ThreadPoolExecutor(3) as pool:
        one, other, third = pool.map(solved, (11, 11, 21))
        bearings = list(pool.map(balanced, ("slices", "slices")))
    assert np.array_equal(one, other)
    assert not np.array_equal(one, third)
    assert np.array_equal(*bearings)
