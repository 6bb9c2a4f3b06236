"""Free ends: what mirroring leaves, and strips against a plane grid; both beside three-dimensional solutions.

These are of two half-spaces, iterated until both faces are free, after Hetenyi. With ``side_faces = "free"`` strips and
plane grid take from the solved quarter-space what one wave across adds. From there each goes its own way: strips
integrate it along their length for a semi-elliptic pressure across, cells have a matrix between rows.
"""

from __future__ import annotations

import functools
import operator
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from claims.claim import Case, Claim, Evidence, pressures, solved
from nonhertz import Body, Contact, Material, Ring, Roller, Solution, solve
from nonhertz.model.profile import Profile, iso_logarithmic, partial_crown, straight, tabulated
from nonhertz.patch.solution import PatchSolution
from nonhertz.patch.solver import solve as solve_patch

# What mirroring leaves: bodies on y > 0 with a combined radius of 100 mm, separation 0 up to y = 13 mm and
# (y - 13)^2 / 5000 beyond; the half-width is about 0.85 mm. Compared are p(0, y) / p(0, 8).

LENGTH, FLAT = 60.0, 13.0  # mm: length of the bodies, where the run-out begins
DISTANCES, FAR = (0.1, 0.25, 0.5, 1.0, 2.0, 5.0), 8.0  # mm
MIRRORED_TOLERANCES = (None, 0.03, 0.015, 0.007, 0.007, 0.007)

# p(0, y) / p(0, 8) at DISTANCES from three-dimensional solutions: with exact free ends of both bodies or of the roller,
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


def mirrored() -> Iterator[Claim]:
    """Yield the claims about mirrored ends."""
    for name, (weights, expected) in MIRRORED.items():
        yield from _mirrored(name, weights, "three-dimensional solution, mirrored", expected, MIRRORED_TOLERANCES)
    name, source = "roller ends, weight 1.6 (calibrated)", "three-dimensional solution, free end"
    yield from _mirrored(name, (1.6, 0.0), source, EXACT_ROLLER, (None,) * len(DISTANCES))


def _mirrored(
    name: str,
    weights: tuple[float, float],
    source: str,
    expected: tuple[float, ...],
    tolerances: tuple[float | None, ...],
) -> Iterator[Claim]:
    of = Evidence(name, source, functools.partial(_mirrored_ratios, *weights))
    quantities = [f"pressure at y = {place:g} mm over that at {FAR:g} mm" for place in DISTANCES]
    why = "across the last quarter of a half-width the pressure is no semi-ellipse"
    yield from of.each(quantities, tolerances, expected=expected, why=why)


def _mirrored_ratios(of_roller: float, of_flat: float) -> list[float]:
    *near, far = pressures(with_weights(of_roller, of_flat), [*DISTANCES, FAR])
    return [pressure / far for pressure in near]


# Strips against the plane grid

CELLS = (64, 1024)
HALF = 10.0  # mm: of the rollers' length
PLACES = (0.1, 0.25, 0.5, 1.0, 2.0)  # half-widths from the end, or mm
# Closer to a sharp end cells and strips bear different means of a pressure without a limit.
TOLERANCES = (None, 1e-2, 5e-3, 5e-3, 5e-3)
_GRID, _ITERATED = "plane grid", "two half-spaces iterated"
# Pressures at PLACES of the straight roller, in the middle, and the moment at 0.3 mrad.
PRESSURES, MIDDLE, MOMENT = (2687.0, 2416.0, 2298.0, 2227.0, 2181.0), 2098.9, 9412.0
# p(0, y) / p(0, 8) beside a face, y in mm at PLACES, by whether both bodies end there or one.
BESIDE = {True: EXACT_BOTH, False: EXACT_ROLLER}


def roller_on(ring_ends: bool, *, depth: str = "none", profile: Profile | None = None) -> Contact:
    """Return the roller, on a ring that ends with it or goes on."""
    steel = Material(206000.0, 0.3)
    ends: dict[str, Any] = {"length": 2.0 * HALF, "side_faces": "free"}
    roller = Roller(diameter=20.0, material=steel, depth=depth, profile=profile or straight(), **ends)
    return Contact(roller, Ring(diameter=80.0, material=steel, **(ends if ring_ends else {})))


_LOGARITHM = iso_logarithmic(diameter=20.0, length=2.0 * HALF)
_TILTED = {"load": 20e3, "tilt": 0.3e-3}
# Rollers of 20 x 20 mm on a ring of 80 mm.
STRAIGHT, TILTED, TOGETHER, _, _ = CASES = (
    Case("straight", roller_on(False), {"load": 20e3}, sharp=True),
    Case("straight, tilted", roller_on(False), _TILTED, sharp=True),
    Case("together", roller_on(True), _TILTED, sharp=True),
    # Runs out 0.3 half-widths from the end of the roller, where the last row of cells touches in part.
    Case("logarithm", roller_on(False, profile=_LOGARITHM), {"load": 42e3, "tilt": 0.3e-3}),
    Case("whole roller", roller_on(False, depth="finite"), _TILTED, sharp=True),
)


@solved
def by_strips(case: Case) -> Solution:
    """Return a case on strips."""
    return solve(case.contact, **case.given)


@solved
def on_grid(case: Case) -> PatchSolution:
    """Return a case on the plane grid."""
    return solve_patch(case.contact, **case.given, cells=CELLS)


def half_width(case: Case) -> float:
    """Return the half-width in the middle [mm]."""
    return float(np.interp(0.0, on_grid(case).y, on_grid(case).half_width))


def free() -> Iterator[Claim]:
    """Yield the claims about free ends."""
    for case in CASES:
        yield from _of_case(case)
    of = Evidence("straight, plane grid", _ITERATED, lambda: on_grid(STRAIGHT))
    yield of.claim("pressure in the middle", _in_middle, 1e-3, "MPa", expected=MIDDLE)
    tilted = Evidence("straight, tilted, plane grid", _ITERATED, lambda: on_grid(TILTED))
    yield tilted.claim("moment", "moment", 5e-3, "N mm", expected=MOMENT)
    towards_end = lambda: pressures(of.found(), HALF - half_width(STRAIGHT) * np.array(PLACES))  # noqa: E731
    yield from Evidence(of.name, _ITERATED, towards_end).each(
        [f"pressure {place:g} half-widths from the end" for place in PLACES], TOLERANCES, "MPa", expected=PRESSURES
    )
    for both, name in ((True, "both bodies end"), (False, "one body ends")):
        strips, grid = functools.partial(_ratios, both), functools.partial(_ratios, both, on_grid)
        for place, y in enumerate(PLACES):
            ratio, at = f"pressure at y = {y:g} mm over that at {FAR:g} mm", operator.itemgetter(place)
            exact = BESIDE[both][place]
            yield Evidence(name, _ITERATED, grid).claim(f"{ratio}, plane grid", at, 1.5e-2, expected=exact)
            yield Evidence(name, _GRID, strips, grid).claim(f"{ratio}, strips", at, 5e-3)


def _in_middle(solution: Solution | PatchSolution) -> float:
    return pressures(solution, [0.0])[0]


def _of_case(case: Case) -> Iterator[Claim]:
    of = Evidence(case.name, _GRID, functools.partial(by_strips, case), functools.partial(on_grid, case))

    def towards_end(solution: Solution | PatchSolution) -> list[float]:
        end = by_strips(case).contact_y[-1][1]
        return pressures(solution, end - half_width(case) * np.array(PLACES))

    yield of.claim("approach", "approach", 1e-4, "mm")
    yield of.claim("pressure in the middle", _in_middle, 2e-4, "MPa")
    # Beside a sharp end it is found a half-width from it, between two rows.
    yield of.claim("greatest pressure", "max_pressure", 2e-3, "MPa")
    if "tilt" in case.given:
        yield of.claim("moment", "moment", 1e-3, "N mm")
    tolerances = [None if not case.sharp and place < 0.5 else TOLERANCES[i] for i, place in enumerate(PLACES)]
    both = lambda: towards_end(by_strips(case)), lambda: towards_end(on_grid(case))
    names = [f"pressure {place:g} half-widths from the end of the contact" for place in PLACES]
    yield from Evidence(case.name, _GRID, *both).each(names, tolerances, "MPa")


@solved
def _ratios(both: bool, solved_by: Callable[[Case], Solution | PatchSolution] = by_strips) -> list[float]:
    """Return p(y) / p(8) at PLACES for bodies on y > 0 of which one or both end there."""
    placed: dict[str, Any] = {"length": 40.0, "position": 20.0, "side_faces": ("free", "none")}
    material = Material(182000.0, 0.3)
    profile = partial_crown(radius=2500.0, straight=26.0).shifted(-20.0)
    roller = Body(diameter=200.0, material=material, profile=profile, **placed)
    flat = Body(material=material, **placed) if both else Body(material=material)
    case = Case("beside a face", Contact(roller, flat), {"load": 785.4 * 14.0})
    pressure = np.array(pressures(solved_by(case), [*PLACES, FAR]))
    return list(pressure[:-1] / pressure[-1])
