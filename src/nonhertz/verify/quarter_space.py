"""Free ends: mirrored pressure compared with the exact solution of the quarter-space."""

from __future__ import annotations

import functools
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from nonhertz.errors import without_accuracy_warnings
from nonhertz.model.body import Body
from nonhertz.model.contact import Contact
from nonhertz.model.material import Material
from nonhertz.model.profile import Profile, tabulated
from nonhertz.plot.style import FAINT_INK, FIRST, INK, SECOND
from nonhertz.result.solution import Solution
from nonhertz.solver.one import solve
from nonhertz.verify.claim import Check, Picture, Section

if TYPE_CHECKING:
    from matplotlib.figure import Figure

UNIT, LENGTH, FLAT = 1.0, 60.0, 13.0  # mm: b of the table, length of the bodies, where the run-out begins
PLACES = (0.1, 0.25, 0.5, 1.0, 2.0, 5.0)
FAR = 8.0
TOLERANCES = {0.25: 0.03, 0.5: 0.015, 1.0: 0.007, 2.0: 0.007, 5.0: 0.007}

# p(0, y) / p(0, 8) at PLACES from three-dimensional solutions.
_EXACT_BOTH = (0.657, 0.753, 0.828, 0.885, 0.925, 0.972)
_EXACT_ROLLER = (1.193, 1.091, 1.035, 1.011, 0.998, 0.992)


@dataclass(frozen=True)
class _Row:
    """Image weights of both bodies, the three-dimensional solution with them, and that of the exact free end."""

    name: str
    weights: tuple[float, float]
    mirrored: tuple[float, ...]
    exact: tuple[float, ...]


_ROWS = (
    _Row("both bodies end, weight 1", (1.0, 1.0), (0.984, 0.984, 0.984, 0.984, 0.985, 0.990), _EXACT_BOTH),
    _Row("roller ends, weight 1", (1.0, 0.0), (1.534, 1.272, 1.134, 1.068, 1.030, 1.001), _EXACT_ROLLER),
    _Row("roller ends, weight 1.7", (1.7, 0.0), (1.125, 1.061, 1.026, 1.008, 0.998, 0.993), _EXACT_ROLLER),
    _Row("half-space", (0.0, 0.0), (2.405, 1.681, 1.324, 1.166, 1.080, 1.013), _EXACT_ROLLER),
)
_MIRRORED = "three-dimensional solution, mirrored"
_EXACT = "three-dimensional solution, free end"
_TEXT = """\
Mirroring frees a side face of shear only. The normal stress that it leaves on the face, twice that of the half-space,
holds the material together, so the true end is softer and its pressure lower. What that amounts to is known from
three-dimensional solutions of the quarter-space after Hetényi, two overlapping half-spaces that cancel each other's
stress on the faces. Case: bodies on $y > 0$ with $\\nu$ = 0.3 and E = 182000 MPa each, $\\rho$ = 100 mm, separation 0
up to $y$ = 13 mm and $(y - 13)^2/5000$ beyond, 10996 N, no depth; the half-width is then about 0.85 mm. Listed is
$p(0,y)/p(0,8)$.

{table}

**Found.** Strips reproduce what mirroring means in three dimensions: within {quarter:.1f} % at $y$ = 0.25 mm,
{half:.1f} % at 0.5 mm and {beyond:.1f} % from 1 mm on, where theirs is a pressure that is semi-elliptic across. What
mirroring leaves is another matter: with weight 1 the pressure at $y$ = 0.25 mm under a roller that ends on a long
body is {over:.0f} % above that of the true free end. The weight `"calibrated"`, 1.6 at $\\nu$ = 0.3, is what brings
it nearest. Where both bodies end at the same place, weights up to 1 leave the pressure flat while the true one falls
to about half, and heavier ones have no solution that refinement converges to. The exact rows are from the
three-dimensional solution; with `side_faces = "free"` strips and plane grid come to them, in a section of their own.
"""


@without_accuracy_warnings()
def section() -> Section:
    """Return the table of free and mirrored ends."""
    solutions = [_solve(row.weights) for row in _ROWS]
    solved = list(zip(_ROWS, map(_ratios, solutions), strict=True))
    checks: list[Check] = []
    for row, computed in solved:
        for place, mirrored, value in zip(PLACES, row.mirrored, computed, strict=True):
            claim = f"{row.name}: pressure at y = {place:g} mm over that at 8 mm"
            checks.append(Check(claim, _MIRRORED, mirrored, value, TOLERANCES.get(place)))
    calibrated = _ratios(_solve((1.6, 0.0)))
    for place, exact, value in zip(PLACES, _EXACT_ROLLER, calibrated, strict=True):
        claim = f"roller ends, weight 1.6 (calibrated): pressure at y = {place:g} mm over that at 8 mm"
        checks.append(Check(claim, _EXACT, exact, value, None))
    worst = {
        place: max(abs(check.difference) for check in checks if check.tolerance and f"y = {place:g} " in check.claim)
        for place in TOLERANCES
    }
    text = _TEXT.format(
        table=_table(solved, calibrated),
        quarter=100.0 * worst[0.25],
        half=100.0 * worst[0.5],
        beyond=100.0 * max(worst[1.0], worst[2.0], worst[5.0]),
        over=100.0 * (solved[1][1][1] / _EXACT_ROLLER[1] - 1.0),
    )
    picture = Picture(
        "free-ends",
        "Pressure towards a free end over that at y = 8 mm: strips (lines) and exact free ends (rings: the roller ends "
        "on a long body; squares: both end).",
        functools.partial(_draw, solutions),
    )
    return Section("Free ends: what mirroring leaves", text, tuple(checks), (picture,))


def _profile() -> Profile:
    y = np.linspace(FLAT, 33.0, 400)
    return tabulated(y=[0.0 - 0.5 * LENGTH, *(y - 0.5 * LENGTH)], relief=[0.0, *((y - FLAT) ** 2 / 5000.0)])


def _solve(weights: tuple[float, float]) -> Solution:
    material = Material(182000.0, 0.3)
    roller = Body(
        diameter=200.0, length=LENGTH, position=0.5 * LENGTH, material=material, profile=_profile(),
        side_faces=(weights[0], "none"),
    )  # fmt: skip
    flat = Body(length=LENGTH, position=0.5 * LENGTH, material=material, side_faces=(weights[1], "none"))
    return solve(Contact(roller, flat), load=785.4 * 14.0)


def _ratios(solution: Solution) -> tuple[float, ...]:
    pressure = np.interp((*PLACES, FAR), solution.y, solution.centre_pressure)
    return tuple((pressure[:-1] / pressure[-1]).tolist())


def _table(solved: list[tuple[_Row, tuple[float, ...]]], calibrated: tuple[float, ...]) -> str:
    lines = ["| y (mm) | " + " | ".join(f"{place:g}" for place in PLACES) + " |", "|---|" + "---|" * len(PLACES)]

    def add(name: str, values: tuple[float, ...]) -> None:
        lines.append(f"| {name} | " + " | ".join(f"{value:.3f}" for value in values) + " |")

    add("**both bodies end: exact**", _EXACT_BOTH)
    add("**roller ends on a long body: exact**", _EXACT_ROLLER)
    for row, computed in solved:
        add(f"{row.name}: three-dimensional", row.mirrored)
        add(f"{row.name}: strips", computed)
    add("roller ends, weight 1.6 (calibrated): strips", calibrated)
    return "\n".join(lines)


def _draw(solutions: list[Solution], figure: Figure) -> None:
    axes = figure.add_subplot()
    styles = ((FIRST, "-"), (SECOND, "-"), (SECOND, "--"), (FAINT_INK, ":"))
    for row, solution, (colour, dashes) in zip(_ROWS, solutions, styles, strict=True):
        far = float(np.interp(FAR, solution.y, solution.centre_pressure))
        axes.plot(solution.y, solution.centre_pressure / far, color=colour, linestyle=dashes, label=row.name)
    axes.plot(PLACES, _EXACT_ROLLER, "o", color=INK, mfc="none", label="roller ends: exact")
    axes.plot(PLACES, _EXACT_BOTH, "s", color=INK, mfc="none", label="both bodies end: exact")
    axes.set(
        xscale="log", xlim=(0.05, 10.0), ylim=(0.4, 2.6), xlabel="distance from the end (mm)", ylabel="p / p(8 mm)"
    )
    axes.legend(loc="upper right")
