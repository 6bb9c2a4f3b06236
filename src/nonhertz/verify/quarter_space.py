"""Free ends: what mirroring leaves, by three-dimensional solutions of the quarter-space after Hetenyi.

Bodies on y > 0 with a combined radius of 100 mm, separation 0 up to y = 13 mm and (y - 13)^2 / 5000 beyond; the
half-width is about 0.85 mm. Compared are p(0, y) / p(0, 8).
"""

from __future__ import annotations

import functools
from collections.abc import Iterator
from typing import Any

import numpy as np

from nonhertz.model.body import Body
from nonhertz.model.contact import Contact
from nonhertz.model.material import Material
from nonhertz.model.profile import tabulated
from nonhertz.result.solution import Solution
from nonhertz.solver.one import solve
from nonhertz.verify.claim import Claim, pressures, series, solved

TITLE = "Free ends: what mirroring leaves"
LENGTH, FLAT = 60.0, 13.0  # mm: length of the bodies, where the run-out begins
PLACES, FAR = (0.1, 0.25, 0.5, 1.0, 2.0, 5.0), 8.0
TOLERANCES = (None, 0.03, 0.015, 0.007, 0.007, 0.007)

# p(0, y) / p(0, 8) at PLACES from three-dimensional solutions: with exact free ends of both bodies or of the roller,
# and mirrored, by what ends with which weights of the images of both bodies.
EXACT_BOTH = (0.657, 0.753, 0.828, 0.885, 0.925, 0.972)
EXACT_ROLLER = (1.193, 1.091, 1.035, 1.011, 0.998, 0.992)
MIRRORED = {
    "both bodies end, weight 1": ((1.0, 1.0), (0.984, 0.984, 0.984, 0.984, 0.985, 0.990)),
    "roller ends, weight 1": ((1.0, 0.0), (1.534, 1.272, 1.134, 1.068, 1.030, 1.001)),
    "roller ends, weight 1.7": ((1.7, 0.0), (1.125, 1.061, 1.026, 1.008, 0.998, 0.993)),
    "half-space": ((0.0, 0.0), (2.405, 1.681, 1.324, 1.166, 1.080, 1.013)),
}


@solved
def with_weights(of_roller: float, of_flat: float) -> Solution:
    """Return the case with image weights of both bodies."""
    middle = 0.5 * LENGTH
    placed: dict[str, Any] = {"length": LENGTH, "position": middle, "material": Material(182000.0, 0.3)}
    y = np.linspace(FLAT, 33.0, 400)
    profile = tabulated(y=[0.0 - middle, *(y - middle)], relief=[0.0, *((y - FLAT) ** 2 / 5000.0)])
    roller = Body(diameter=200.0, profile=profile, side_faces=(of_roller, "none"), **placed)
    return solve(Contact(roller, Body(side_faces=(of_flat, "none"), **placed)), load=785.4 * 14.0)


def claims() -> Iterator[Claim]:
    """Yield the claims."""
    for name, (weights, expected) in MIRRORED.items():
        yield from _of_case(name, weights, "three-dimensional solution, mirrored", expected, TOLERANCES)
    name, source = "roller ends, weight 1.6 (calibrated)", "three-dimensional solution, free end"
    yield from _of_case(name, (1.6, 0.0), source, EXACT_ROLLER, (None,) * len(PLACES))


def _of_case(
    name: str,
    weights: tuple[float, float],
    source: str,
    expected: tuple[float, ...],
    tolerances: tuple[float | None, ...],
) -> Iterator[Claim]:
    quantities = [f"{name}: pressure at y = {place:g} mm over that at {FAR:g} mm" for place in PLACES]
    why = "across the last quarter of a half-width the pressure is no semi-ellipse"
    found = functools.partial(_ratios, *weights)
    yield from series(quantities, source, expected, found, tolerances, why=why)


def _ratios(of_roller: float, of_flat: float) -> list[float]:
    *near, far = pressures(with_weights(of_roller, of_flat), [*PLACES, FAR])
    return [pressure / far for pressure in near]
