"""Free ends: strips against a plane grid, and both against three-dimensional solutions of the quarter-space.

With ``side_faces = "free"`` both take from the solved quarter-space what one wave across adds. From there each goes its
own way: strips integrate it along their length for a semi-elliptic pressure across, cells have a matrix between rows.
The three-dimensional solutions are of two half-spaces, iterated until both faces are free.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from nonhertz.model.body import Body, Ring, Roller
from nonhertz.model.contact import Contact
from nonhertz.model.material import Material
from nonhertz.model.profile import Profile, iso_logarithmic, partial_crown
from nonhertz.patch.solution import PatchSolution
from nonhertz.patch.solver import solve as solve_patch
from nonhertz.result.solution import Solution
from nonhertz.solver.one import solve
from nonhertz.verify.claim import Claim, pressures, series, solved
from nonhertz.verify.quarter_space import EXACT_BOTH, EXACT_ROLLER

TITLE = "Free ends: strips against a plane grid"
CELLS = (64, 1024)
HALF = 10.0  # mm: of the rollers' length
PLACES, FAR = (0.1, 0.25, 0.5, 1.0, 2.0), 8.0  # half-widths from the end, mm
# Closer to a sharp end cells and strips bear different means of a pressure without a limit.
TOLERANCES = (None, 1e-2, 5e-3, 5e-3, 5e-3)
_GRID, _ITERATED = "plane grid", "two half-spaces iterated"
# Pressures at PLACES of the straight roller, in the middle, and the moment at 0.3 mrad.
PRESSURES, MIDDLE, MOMENT = (2687.0, 2416.0, 2298.0, 2227.0, 2181.0), 2098.9, 9412.0
# p(0, y) / p(0, 8) beside a face, y in mm at PLACES, by whether both bodies end there or one.
BESIDE = {True: EXACT_BOTH, False: EXACT_ROLLER}


@dataclass(frozen=True, eq=False)
class Case:
    """A roller of 20 x 20 mm on a ring of 80 mm; ``runs_out`` if the contact ends before the roller."""

    name: str
    contact: Contact
    given: dict[str, Any]
    runs_out: bool = False


def roller_on(ring_ends: bool, *, depth: str = "none", profile: Profile | None = None) -> Contact:
    """Return the roller, on a ring that ends with it or goes on."""
    free = {"material": Material(206000.0, 0.3), "side_faces": "free"}
    shape = {} if profile is None else {"profile": profile}
    roller = Roller(diameter=20.0, length=2.0 * HALF, depth=depth, **free, **shape)  # type: ignore[arg-type]
    ring = {"length": 2.0 * HALF, **free} if ring_ends else {"material": free["material"]}
    return Contact(roller, Ring(diameter=80.0, **ring))  # type: ignore[arg-type]


_LOGARITHM = iso_logarithmic(diameter=20.0, length=2.0 * HALF)
_TILTED = {"load": 20e3, "tilt": 0.3e-3}
STRAIGHT, TILTED, TOGETHER, LOGARITHM, WHOLE = CASES = (
    Case("straight", roller_on(False), {"load": 20e3}),
    Case("straight, tilted", roller_on(False), _TILTED),
    Case("together", roller_on(True), _TILTED),
    # Runs out 0.3 half-widths from the end of the roller, where the last row of cells touches in part.
    Case("logarithm", roller_on(False, profile=_LOGARITHM), {"load": 42e3, "tilt": 0.3e-3}, runs_out=True),
    Case("whole roller", roller_on(False, depth="finite"), _TILTED),
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


def claims() -> Iterator[Claim]:
    """Yield the claims."""
    for case in CASES:
        yield from _of_case(case)
    yield Claim(
        "straight, plane grid: pressure in the middle", _ITERATED, MIDDLE,
        lambda: pressures(on_grid(STRAIGHT), [0.0])[0], 1e-3, "MPa",
    )  # fmt: skip
    yield Claim("straight, tilted, plane grid: moment", _ITERATED, MOMENT, lambda: on_grid(TILTED).moment, 5e-3, "N mm")
    yield from series(
        [f"straight, plane grid: pressure {place:g} half-widths from the end" for place in PLACES], _ITERATED,
        PRESSURES, lambda: pressures(on_grid(STRAIGHT), HALF - half_width(STRAIGHT) * np.array(PLACES)), TOLERANCES,
        "MPa",
    )  # fmt: skip
    for both in (True, False):
        yield from _beside_a_face(both)


def _of_case(case: Case) -> Iterator[Claim]:
    name = case.name

    def towards_end() -> list[float]:
        return list(by_strips(case).contact_y[-1][1] - half_width(case) * np.array(PLACES))

    def claim(what: str, quantity: str, tolerance: float, unit: str) -> Claim:
        return Claim(
            f"{name}: {what}", _GRID, lambda: float(getattr(on_grid(case), quantity)),
            lambda: float(getattr(by_strips(case), quantity)), tolerance, unit,
        )  # fmt: skip

    yield claim("approach", "approach", 1e-4, "mm")
    yield Claim(
        f"{name}: pressure in the middle", _GRID, lambda: pressures(on_grid(case), [0.0])[0],
        lambda: pressures(by_strips(case), [0.0])[0], 2e-4, "MPa",
    )  # fmt: skip
    # Beside a sharp end it is found a half-width from it, between two rows.
    yield claim("greatest pressure", "max_pressure", 2e-3, "MPa")
    if "tilt" in case.given:
        yield claim("moment", "moment", 1e-3, "N mm")
    tolerances = [None if case.runs_out and place < 0.5 else TOLERANCES[i] for i, place in enumerate(PLACES)]
    yield from series(
        [f"{name}: pressure {place:g} half-widths from the end of the contact" for place in PLACES], _GRID,
        lambda: pressures(on_grid(case), towards_end()), lambda: pressures(by_strips(case), towards_end()), tolerances,
        "MPa",
    )  # fmt: skip


@solved
def _ratios(both: bool) -> tuple[list[float], list[float]]:
    """Return p(y) / p(8) at PLACES of strips and plane grid, for bodies on y > 0 of which one or both end there."""
    material = Material(182000.0, 0.3)
    profile = partial_crown(radius=2500.0, straight=26.0).shifted(-20.0)
    roller = Body(
        diameter=200.0, length=40.0, position=20.0, material=material, profile=profile, side_faces=("free", "none")
    )
    flat = Body(length=40.0, position=20.0, material=material, side_faces=("free", "none"))
    contact = Contact(roller, flat if both else Body(material=material))
    case = Case("beside a face", contact, {"load": 785.4 * 14.0})
    strips, grid = (np.array(pressures(each, [*PLACES, FAR])) for each in (by_strips(case), on_grid(case)))
    return list(strips[:-1] / strips[-1]), list(grid[:-1] / grid[-1])


def _beside_a_face(both: bool) -> Iterator[Claim]:
    name = "both bodies end" if both else "one body ends"

    def at(place: int) -> Iterator[Claim]:
        quantity = f"{name}: pressure at y = {PLACES[place]:g} mm over that at {FAR:g} mm"

        def by_grid() -> float:
            return _ratios(both)[1][place]

        yield Claim(f"{quantity}, plane grid", _ITERATED, BESIDE[both][place], by_grid, 1.5e-2)
        yield Claim(f"{quantity}, strips", _GRID, by_grid, lambda: _ratios(both)[0][place], 5e-3)

    for place in range(len(PLACES)):
        yield from at(place)
