"""Free ends: strips compared with a plane grid, and both with three-dimensional solutions of the quarter-space."""

from __future__ import annotations

import functools
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from nonhertz.errors import without_accuracy_warnings
from nonhertz.model.body import Body, Ring, Roller
from nonhertz.model.contact import Contact
from nonhertz.model.material import Material
from nonhertz.model.profile import Profile, iso_logarithmic, partial_crown
from nonhertz.patch.solution import PatchSolution
from nonhertz.patch.solver import solve as solve_patch
from nonhertz.plot.style import FIRST, INK, SECOND, SMALL_SIZE
from nonhertz.result.solution import Solution
from nonhertz.solver.one import solve
from nonhertz.verify.claim import Check, Picture, Section

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = NDArray[np.float64]

CELLS = (64, 1024)
HALF = 10.0  # mm: of the rollers' length
PLACES = (0.1, 0.25, 0.5, 1.0, 2.0)  # half-widths from the end
# Closer to a sharp end cells and strips bear different means of a pressure without a limit.
TOLERANCES = {0.25: 1e-2, 0.5: 5e-3, 1.0: 5e-3, 2.0: 5e-3}
FAR = 8.0

_GRID = "plane grid"
_ITERATED = "two half-spaces iterated"
# Pressures at PLACES of the straight roller, in the middle, and the moment at 0.3 mrad.
_PRESSURES, _MIDDLE, _MOMENT = (2687.0, 2416.0, 2298.0, 2227.0, 2181.0), 2098.9, 9412.0
# p(0, y) / p(0, 8) beside a face, y in mm at PLACES.
_BESIDE = {True: (0.657, 0.753, 0.828, 0.885, 0.925), False: (1.193, 1.091, 1.035, 1.011, 0.998)}
_TEXT = """\
With `side_faces = "free"`, strips and plane grid take from the solved quarter-space what one wave across adds. From
there each goes its own way: strips integrate it along their length for a pressure that is semi-elliptic across, cells
have a matrix between their rows, and assume nothing across. All rollers are 20 x 20 mm on a ring of 80 mm, both with E
= 206000 MPa and $\\nu$ = 0.3, on {across} x {along} cells:

{cases}

| case | approach | pressure in the middle | moment | {headings} |
|---|---:|---:|---:|{rules}
{rows}

Listed is by how much semi-elliptic strips are off the plane grid, in per cent; pressures at distances from the end of
the contact at high y, in half-widths.

**Found.** Strips and plane grid agree within {approach:.4f} % in approach and within {moment:.3f} % in the moment, and
within {pressure:.2f} % in the pressure from a quarter of the half-width inwards where a body ends, from half of it
where a contact runs out. Two half-spaces iterated in three dimensions, on bodies that are cut off, give the straight
roller a pressure in the middle of {middle:.1f} MPa, the plane grid {grid_middle:.1f}, and a moment that is
{moment_off:+.2f} % off. Beside a single face (the case of the section on mirroring) three methods find these p(y)/p(8)
at y = {places} mm:

{beside}

Where both bodies end all three agree. Where one goes on, strips and plane grid are within {between:.1f} % of each other
and up to {beyond:.1f} % below the three-dimensional solution, so that this is no error of the shape that strips assume
across; that of the straight roller differs by {straight:.1f} % at the same distance.
"""


@dataclass(frozen=True, eq=False)
class _Case:
    name: str
    words: str
    contact: Contact
    given: dict[str, Any]


def _roller_on(ring_ends: bool, *, depth: str = "none", profile: Profile | None = None) -> Contact:
    free = {"material": Material(206000.0, 0.3), "side_faces": "free"}
    shape = {} if profile is None else {"profile": profile}
    roller = Roller(diameter=20.0, length=2.0 * HALF, depth=depth, **free, **shape)  # type: ignore[arg-type]
    ring = {"length": 2.0 * HALF, **free} if ring_ends else {"material": free["material"]}
    return Contact(roller, Ring(diameter=80.0, **ring))  # type: ignore[arg-type]


_LOGARITHM = iso_logarithmic(diameter=20.0, length=2.0 * HALF)
_TILTED = {"load": 20e3, "tilt": 0.3e-3}
_CASES = (
    _Case("straight", "straight, on a long ring, 20 kN", _roller_on(False), {"load": 20e3}),
    _Case("straight, tilted", "the same, tilted by 0.3 mrad", _roller_on(False), _TILTED),
    _Case("together", "the ring as long as the roller, tilted by 0.3 mrad", _roller_on(True), _TILTED),
    _Case(
        "logarithm", "profile of ISO 16281, on a long ring, 42 kN, tilted by 0.3 mrad: runs out 0.3 half-widths from "
        "the end of the roller",
        _roller_on(False, profile=_LOGARITHM), {"load": 42e3, "tilt": 0.3e-3},
    ),
    _Case(
        "whole roller", "the straight roller on the long ring with `depth = \"finite\"`, tilted by 0.3 mrad",
        _roller_on(False, depth="finite"), _TILTED,
    ),
)  # fmt: skip


@dataclass(frozen=True, eq=False)
class _Solved:
    strips: Solution
    grid: PatchSolution

    @classmethod
    def of(cls, case: _Case) -> _Solved:
        return cls(solve(case.contact, **case.given), solve_patch(case.contact, **case.given, cells=CELLS))

    def pressures(self, y: Array) -> tuple[Array, Array]:
        """Return the pressures on the centre line of strips and grid at places [mm]."""
        strips, grid = (np.interp(y, each.y, each.centre_pressure) for each in (self.strips, self.grid))
        return strips, grid

    @property
    def half_width(self) -> float:
        """Half-width in the middle [mm]."""
        return float(np.interp(0.0, self.grid.y, self.grid.half_width))

    @property
    def towards_end(self) -> Array:
        """Differences of the pressures at PLACES from the end of the contact at high y, relative."""
        end = self.strips.contact_y[-1][1]
        strips, grid = self.pressures(end - self.half_width * np.array(PLACES))
        return strips / grid - 1.0

    @property
    def runs_out(self) -> bool:
        """Whether the contact ends before the roller, where the last row of cells touches in part."""
        return self.strips.contact_y[-1][1] < HALF

    @property
    def judged(self) -> tuple[float | None, ...]:
        """Tolerances at PLACES."""
        return tuple(TOLERANCES.get(place) if place >= 0.5 or not self.runs_out else None for place in PLACES)


@without_accuracy_warnings()
def section() -> Section:
    """Return the comparison of all cases."""
    found = {case.name: _Solved.of(case) for case in _CASES}
    beside = {both: _beside_a_face(both) for both in (True, False)}
    checks = [check for case in _CASES for check in _checks(case, found[case.name])]
    checks += [*_iterated(found), *(check for both, rows in beside.items() for check in _ratio_checks(both, rows))]
    picture = Picture(
        "free-ends-plane-grid",
        "Pressure towards the end of the roller, over that in its middle: strips (lines) and plane grid (dots); a "
        "straight roller on a long ring, and on one that ends with it.",
        functools.partial(_draw, {name: found[name] for name in ("straight, tilted", "together")}),
    )
    return Section("Free ends: strips against a plane grid", _text(found, beside), tuple(checks), (picture,))


def _checks(case: _Case, found: _Solved) -> list[Check]:
    strips, grid = found.strips, found.grid
    middle = [float(each[0]) for each in found.pressures(np.zeros(1))]
    checks = [
        Check(f"{case.name}: approach", _GRID, grid.approach, strips.approach, 1e-4, "mm"),
        Check(f"{case.name}: pressure in the middle", _GRID, middle[1], middle[0], 2e-4, "MPa"),
        # Beside a sharp end it is found a half-width from it, between two rows.
        Check(f"{case.name}: greatest pressure", _GRID, grid.max_pressure, strips.max_pressure, 2e-3, "MPa"),
    ]
    if "tilt" in case.given:
        checks.append(Check(f"{case.name}: moment", _GRID, grid.moment, strips.moment, 1e-3, "N mm"))
    end = strips.contact_y[-1][1]
    at_places = zip(*found.pressures(end - found.half_width * np.array(PLACES)), strict=True)
    for place, tolerance, (of_strips, of_grid) in zip(PLACES, found.judged, at_places, strict=True):
        claim = f"{case.name}: pressure {place:g} half-widths from the end of the contact"
        checks.append(Check(claim, _GRID, float(of_grid), float(of_strips), tolerance, "MPa"))
    return checks


def _iterated(found: dict[str, _Solved]) -> list[Check]:
    """Return checks of the plane grid against a three-dimensional solution."""
    straight, tilted = found["straight"], found["straight, tilted"]
    middle = float(straight.pressures(np.zeros(1))[1][0])
    checks = [
        Check("straight, plane grid: pressure in the middle", _ITERATED, _MIDDLE, middle, 1e-3, "MPa"),
        Check("straight, tilted, plane grid: moment", _ITERATED, _MOMENT, tilted.grid.moment, 5e-3, "N mm"),
    ]
    of_grid = straight.pressures(HALF - straight.half_width * np.array(PLACES))[1].tolist()
    for place, expected, computed in zip(PLACES, _PRESSURES, of_grid, strict=True):
        claim = f"straight, plane grid: pressure {place:g} half-widths from the end"
        checks.append(Check(claim, _ITERATED, expected, computed, TOLERANCES.get(place), "MPa"))
    return checks


def _beside_a_face(both: bool) -> tuple[Array, Array]:
    """Return p(y) / p(8) at PLACES of strips and plane grid, for bodies on y > 0 of which one or both end there."""
    material = Material(182000.0, 0.3)
    profile = partial_crown(radius=2500.0, straight=26.0).shifted(-20.0)
    roller = Body(
        diameter=200.0, length=40.0, position=20.0, material=material, profile=profile, side_faces=("free", "none")
    )
    flat = Body(length=40.0, position=20.0, material=material, side_faces=("free", "none"))
    contact = Contact(roller, flat if both else Body(material=material))
    load = 785.4 * 14.0
    solved = _Solved(solve(contact, load=load), solve_patch(contact, load=load, cells=CELLS))
    strips, grid = solved.pressures(np.array([*PLACES, FAR]))
    return strips[:-1] / strips[-1], grid[:-1] / grid[-1]


def _ratio_checks(both: bool, found: tuple[Array, Array]) -> list[Check]:
    name = _name_of(both)
    checks = []
    for place, expected, strips, grid in zip(PLACES, _BESIDE[both], *(each.tolist() for each in found), strict=True):
        claim = f"{name}: pressure at y = {place:g} mm over that at 8 mm"
        checks.append(Check(f"{claim}, plane grid", _ITERATED, expected, grid, 1.5e-2))
        checks.append(Check(f"{claim}, strips", _GRID, grid, strips, 5e-3))
    return checks


def _name_of(both: bool) -> str:
    return "both bodies end" if both else "one body ends"


def _text(found: dict[str, _Solved], beside: dict[bool, tuple[Array, Array]]) -> str:
    worst = [
        abs(difference)
        for each in found.values()
        for difference, tolerance in zip(each.towards_end.tolist(), each.judged, strict=True)
        if tolerance
    ]
    tilted = [found[case.name] for case in _CASES if "tilt" in case.given]
    straight, one_ends = found["straight"], beside[False]
    at_quarter = float(straight.pressures(np.array([HALF - PLACES[1] * straight.half_width]))[1][0])
    return _TEXT.format(
        across=CELLS[0],
        along=CELLS[1],
        cases="\n".join(f"- **{case.name}**: {case.words}." for case in _CASES),
        headings=" | ".join(f"{place:g} b" for place in PLACES),
        rules="---:|" * len(PLACES),
        rows="\n".join(_row(case, found[case.name]) for case in _CASES),
        approach=100.0 * max(abs(each.strips.approach / each.grid.approach - 1.0) for each in found.values()),
        moment=100.0 * max(abs(each.strips.moment / each.grid.moment - 1.0) for each in tilted),
        pressure=100.0 * max(worst),
        middle=_MIDDLE,
        grid_middle=float(straight.pressures(np.zeros(1))[1][0]),
        moment_off=100.0 * (found["straight, tilted"].grid.moment / _MOMENT - 1.0),
        places=", ".join(f"{place:g}" for place in PLACES),
        beside=_beside_table(beside),
        between=100.0 * float(np.max(np.abs(one_ends[0] / one_ends[1] - 1.0))),
        beyond=100.0 * float(np.max(1.0 - one_ends[1] / _BESIDE[False])),
        straight=100.0 * abs(at_quarter / _PRESSURES[1] - 1.0),
    )


def _row(case: _Case, found: _Solved) -> str:
    strips, grid = found.strips, found.grid
    middle = [float(each[0]) for each in found.pressures(np.zeros(1))]
    moment = f"{100.0 * (strips.moment / grid.moment - 1.0):+.3f}" if "tilt" in case.given else "-"
    cells = [f"{100.0 * (strips.approach / grid.approach - 1.0):+.4f}", f"{100.0 * (middle[0] / middle[1] - 1.0):+.4f}"]
    cells += [moment, *(f"{100.0 * each:+.2f}" for each in found.towards_end.tolist())]
    return f"| {case.name} | {' | '.join(cells)} |"


def _beside_table(beside: dict[bool, tuple[Array, Array]]) -> str:
    lines = ["| y (mm) | " + " | ".join(f"{place:g}" for place in PLACES) + " |", "|---|" + "---|" * len(PLACES)]
    for both, (strips, grid) in beside.items():
        rows = ("three-dimensional", _BESIDE[both]), ("plane grid", grid), ("strips", strips)
        lines += [f"| {_name_of(both)}: {how} | {' | '.join(f'{each:.3f}' for each in row)} |" for how, row in rows]
    return "\n".join(lines)


def _draw(found: dict[str, _Solved], figure: Figure) -> None:
    axes = figure.add_subplot()
    for (name, each), colour in zip(found.items(), (FIRST, SECOND), strict=True):
        strips, grid = (one.centre_pressure / float(np.interp(0.0, one.y, one.centre_pressure))
                        for one in (each.strips, each.grid))  # fmt: skip
        axes.plot((HALF - each.strips.y) / each.half_width, strips, color=colour, label=name)
        axes.plot((HALF - each.grid.y) / each.half_width, grid, ".", color=INK, markersize=3.0)
    axes.set(
        xscale="log", xlim=(0.02, 10.0), ylim=(0.4, 2.2), xlabel="distance from the end (half-widths)",
        ylabel="p / p in the middle",
    )  # fmt: skip
    axes.legend(loc="upper right", fontsize=SMALL_SIZE)
