"""Solves in threads of the core and of Python, for a sanitizer that looks for races; run by sanitized.py."""

from concurrent.futures import ThreadPoolExecutor

import numpy as np
import other_core

import nonhertz as nh

assert other_core.path
CONTACT = nh.Contact(nh.Roller(diameter=20, length=20, profile=nh.profile.crown(radius=1000)), nh.Ring(diameter=80))
LOADS = np.linspace(1e3, 2e4, 120)


def solved(strips):
    """Return the pressures of many loads, worked out by two threads of the core."""
    return nh.solve_many(CONTACT, load=LOADS, strips=strips, threads=2).max_pressure


if __name__ == "__main__":
    with ThreadPoolExecutor(3) as pool:
        (one, other, third) = pool.map(solved, (11, 11, 21))
    assert np.array_equal(one, other)
    assert not np.array_equal(one, third)
