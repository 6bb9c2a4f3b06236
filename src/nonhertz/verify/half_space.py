"""Rollers on half-spaces against converged results of another method."""

from __future__ import annotations

import functools
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from nonhertz.model.body import Plate, Roller
from nonhertz.model.contact import Contact
from nonhertz.model.material import STEEL
from nonhertz.model.profile import Profile, crown, straight
from nonhertz.plot.style import FIRST, INK, SECOND
from nonhertz.result.solution import Solution
from nonhertz.solver.one import solve
from nonhertz.verify.claim import Check, Picture, Section

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_SOURCE = "uniform rectangles, extrapolated"
_TEXT = """\
Three rollers, diameter 20 and length 20 mm, on a plate; both bodies are half-spaces of steel (E = 207000 MPa, $\\nu$
= 0.3) with a cut end. The references were made once with a program that knows nothing of strips: uniform rectangles
on a plane grid of up to 512 x 4096 points, constrained conjugate gradients, extrapolated in the mesh; the last 0.15
mm at sharp ends from a denser grid fitted to the contact. Their own uncertainty is below 4e-5.

- **tilted crown**: crown radius 4000 mm, 3000 N, tilt -0.5 mrad. The contact ends inside the body.
- **flat crown**: the same roller under 20000 N. The contact reaches both sharp ends.
- **straight**: no profile, 20000 N, sharp ends.

At a sharp end the pressure is singular, $p \\sim K / \\sqrt s$ at a distance $s$. The pressure *at* the end has no
value to compare; $K$ has.

**Found.** In the middle strips are off by {centre:.3f} % at most, sharp ends or not. Half a millimetre from the sharp
ends, more than one half-width, the pressure is off by {near:.1f} % at most. $K$ comes out {low:+.2f} and {high:+.2f}
% off; that of the references itself changes by 0.15 % with the way it is extrapolated.
"""


@dataclass(frozen=True)
class _Reference:
    """A case, and the results of the other program."""

    name: str
    profile: Profile
    load: float
    tilt: float
    approach: float
    pressure: float
    half_width: float
    tolerance: float
    moment: float | None = None
    strength: float | None = None
    inwards: tuple[tuple[float, float], ...] = ()
    """Positions [mm] and pressures [MPa] towards the sharp end."""


_REFERENCES = (
    _Reference(
        "tilted crown", crown(4000.0), 3000.0, -0.5e-3, 0.008110877926920768, 1008.3656928162496, 0.1771221103260539,
        tolerance=1e-4, moment=-6000.0,
    ),
    _Reference(
        "flat crown", crown(4000.0), 20000.0, 0.0, 0.032192419785281, 2039.162368630195, 0.3581713384284778,
        tolerance=1e-3, strength=519.65668923665,
        inwards=((5.0, 1919.7077), (9.0, 1671.4055), (9.5, 1685.8013), (9.9, 2160.3937)),
    ),
    _Reference(
        "straight", straight(), 20000.0, 0.0, 0.02741221026671631, 1797.524086773164, 0.3160655726010909,
        tolerance=1e-3, strength=812.2881555201532,
        inwards=((5.0, 1828.1434), (9.0, 2018.2763), (9.5, 2168.5957), (9.9, 3120.7061)),
    ),
)  # fmt: skip
_JUDGED_TO = 9.5  # mm: closer to the end than one half-width the pressure across is not a semi-ellipse


def section() -> Section:
    """Return the comparison of the three cases."""
    solutions = [_solve(reference) for reference in _REFERENCES]
    checks: list[Check] = []
    for reference, solution in zip(_REFERENCES, solutions, strict=True):
        checks += _checks(reference, solution)
    strengths = [100.0 * check.difference for check in checks if check.claim.endswith("K at the end")]
    near = max(abs(100.0 * check.difference) for check in checks if f"y = {_JUDGED_TO:g}" in check.claim)
    centre = max(abs(100.0 * check.difference) for check in checks if "centre" in check.claim)
    text = _TEXT.format(centre=centre, near=near, low=min(strengths), high=max(strengths))
    picture = Picture(
        "half-space-pressure",
        "Pressure on the centre line: strips (lines with a dot per strip) and the reference (rings). The last dots "
        "at y = 10 mm lie far above the frame and mean nothing.",
        functools.partial(_draw, list(zip(_REFERENCES, solutions, strict=True))),
    )
    return Section("Rollers on half-spaces", text, tuple(checks), (picture,))


def _solve(reference: _Reference) -> Solution:
    roller = Roller(
        diameter=20.0, length=20.0, profile=reference.profile, material=STEEL, side_faces="none", depth="none"
    )
    # At sharp ends strips have an error of their own, which more of them do not remove.
    accuracy = 1e-5 if reference.strength is None else None
    return solve(Contact(roller, Plate(material=STEEL)), load=reference.load, tilt=reference.tilt, accuracy=accuracy)


def _checks(reference: _Reference, solution: Solution) -> list[Check]:
    name, tolerance = reference.name, reference.tolerance
    centre = int(np.argmin(np.abs(solution.y)))
    half_width = float(solution.half_width[centre])
    checks = [
        Check(f"{name}: approach", _SOURCE, reference.approach, solution.approach, tolerance, "mm"),
        Check(
            f"{name}: centre pressure",
            _SOURCE,
            reference.pressure,
            float(solution.centre_pressure[centre]),
            tolerance,
            "MPa",
        ),
        Check(f"{name}: centre half-width", _SOURCE, reference.half_width, half_width, tolerance, "mm"),
    ]
    if reference.moment is not None:
        checks.append(Check(f"{name}: moment", _SOURCE, reference.moment, solution.moment, 3e-4, "N mm"))
    for place, pressure in reference.inwards:
        computed = float(np.interp(place, solution.y, solution.centre_pressure))
        judged = 1e-2 if place <= _JUDGED_TO else None
        checks.append(Check(f"{name}: pressure at y = {place:g} mm", _SOURCE, pressure, computed, judged, "MPa"))
    if reference.strength is not None:
        computed = solution.edge_pressure[1].strength or float("nan")
        checks.append(Check(f"{name}: K at the end", _SOURCE, reference.strength, computed, 3e-3, "MPa mm^0.5"))
    return checks


def _draw(cases: list[tuple[_Reference, Solution]], figure: Figure) -> None:
    axes = figure.add_subplot()
    styles = zip((FIRST, SECOND, INK), ("-", "--", ":"), strict=True)
    for (reference, solution), (colour, dashes) in zip(cases, styles, strict=True):
        touching = solution.line_load > 0.0
        axes.plot(
            solution.y[touching], solution.centre_pressure[touching], linestyle=dashes, color=colour, marker=".",
            markersize=3.0, label=reference.name,
        )  # fmt: skip
        places = [(0.0, reference.pressure), *reference.inwards]
        axes.plot(*zip(*places, strict=True), "o", color=colour, mfc="none")
    axes.set(xlim=(-10.5, 10.5), ylim=(0.0, 3500.0), xlabel="y (mm)", ylabel="pressure $p_0$ (MPa)")
    axes.legend(loc="upper center")
