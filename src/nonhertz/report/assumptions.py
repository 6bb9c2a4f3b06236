"""What the result rests on: each assumption with its criterion, this case's number, and whether it holds.

Limits are those that the solver warns by, and for errors the difference from which on a comparison of methods tells
why. Where no input tells whether an assumption holds, that is said.
"""

from __future__ import annotations

import enum
import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nonhertz.bodies.ends import ends
from nonhertz.comparison.reasons import TOLD
from nonhertz.report.results import CaseResults
from nonhertz.result.checks import LEAST_DEPTH, checks
from nonhertz.result.numerals import digits, given
from nonhertz.result.solution import EdgeKind, EdgePressure, Solution, Status
from nonhertz.strip.element import SEMI_ELLIPTIC

Array = NDArray[np.float64]

# Of the yield strength, the pressure p0 of a line contact at which flow begins below the surface, by Tresca's
# criterion: K. L. Johnson, Contact Mechanics, Cambridge University Press 1985, section 6.1.
FLOW_BEGINS = 1.67


class Verdict(enum.Enum):
    """Whether an assumption holds; each member's value is what the reader sees."""

    HOLDS = "holds"
    STRAINED = "strained"
    NOT_MET = "not met"
    OPEN = "not judged"


@dataclass(frozen=True)
class Assumption:
    """One assumption.

    Attributes
    ----------
    name : str
        What is assumed.
    criterion : str
        When that can be.
    number : str
        What this case has.
    verdict : Verdict
        Whether it holds.
    remark : str
        What follows from that; may be empty.
    """

    name: str
    criterion: str
    number: str
    verdict: Verdict
    remark: str = ""


def assumptions(found: CaseResults) -> list[Assumption]:
    """Return the assumptions behind a result and whether they hold."""
    solution = found.solution
    rows = [_converged(solution)]
    if solution.contact_y and solution.status is Status.CONVERGED:
        rows += [*_valid(solution), *_ends(solution)]
        rows += [_smooth(solution), *_fine(solution), _shape(solution), *_elastic(found)]
    rows.append(
        Assumption("Surfaces", "dry, smooth, without friction", "no such input", Verdict.OPEN, "Roughness is left out.")
    )
    return rows


def _converged(solution: Solution) -> Assumption:
    fine = solution.status is Status.CONVERGED
    remark = "" if fine else "The numbers are those at which the solver stopped. They mean nothing."
    return Assumption(
        "Solved",
        "every contact condition is met",
        f"{solution.status.label}, {solution.iterations} Newton steps",
        Verdict.HOLDS if fine else Verdict.NOT_MET,
        remark,
    )


def _valid(solution: Solution) -> Iterator[Assumption]:
    """Yield the checks that the solver warns by, and of bodies without a depth that there is none."""
    for check in checks(solution, ends(solution.contact)):
        number = digits(check.value, 3)
        yield Assumption(check.assumption, check.criterion, number, _strained_if(not check.holds), check.remark)
    for name, body in (("a", solution.contact.a), ("b", solution.contact.b)):
        if body.behind.below(body, solution.element) is None:
            remark = "A half-space of endless depth: approach counts from a point far away."
            criterion = f"depth of at least {LEAST_DEPTH:g} half-widths"
            yield Assumption(f"Body {name} is thick", criterion, "no depth given", Verdict.OPEN, remark)


_ENDS = {
    EdgeKind.RUN_OUT: (Verdict.HOLDS, ""),
    EdgeKind.FINITE: (Verdict.STRAINED, "Freed of shear, not of normal stress: the true pressure at the end is lower."),
    EdgeKind.SINGULAR: (
        Verdict.NOT_MET,
        "The pressure has no limit there; trust it from a quarter of a half-width inwards.",
    ),
    EdgeKind.CORNER: (Verdict.NOT_MET, "The pressure has no limit at a corner of the profile: give it a radius."),
    EdgeKind.CUT_OFF: (Verdict.NOT_MET, "The pressure there is that of bodies cut off: give more strips."),
}


def _ends(solution: Solution) -> Iterator[Assumption]:
    for edge, name in zip(solution.edge_pressure, ("low", "high"), strict=True):
        verdict, remark = _ENDS[edge.kind]
        what = f"Contact ends inside the bodies at {name} y"
        yield Assumption(what, "pressure falls to zero before a body ends", _end(edge), verdict, remark)


def _end(edge: EdgePressure) -> str:
    kind = edge.kind.label.replace("-", " ")
    return f"{kind} at y = {edge.y:.5g} mm" + (f", {edge.law}" if edge.law else "")


def _smooth(solution: Solution) -> Assumption:
    low, high = solution.contact_y[0][0], solution.contact_y[-1][1]
    bends = sum(low < y < high for y in solution.contact.bends)
    number = "1 bend of the relief in contact" if bends == 1 else f"{bends or 'no'} bends of the relief in contact"
    corner = solution.peaks_at_corner
    remark = "The largest pressure has no limit: give the corner a radius." if corner else ""
    criterion = "no corner of the profile bears the largest pressure"
    return Assumption("Smooth along y", criterion, number, Verdict.NOT_MET if corner else Verdict.HOLDS, remark)


def _fine(solution: Solution) -> Iterator[Assumption]:
    estimate = solution.error_estimate
    criterion = f"the solve's own estimate of its error is up to {100.0 * TOLD:g} %"
    # Whichever of the two is prescribed has no error.
    name, error = max((("approach", estimate.approach), ("load", estimate.load)), key=lambda each: each[1])
    yield Assumption(f"Grid fine enough for the {name}", criterion, _percent(error), _known(error))
    corner = solution.peaks_at_corner
    verdict = Verdict.NOT_MET if corner else _known(estimate.max_pressure)
    remark = "The largest pressure rises with every refinement." if corner else ""
    number = "no limit" if corner else _percent(estimate.max_pressure)
    yield Assumption("Grid fine enough for the largest pressure", criterion, number, verdict, remark)


def _shape(solution: Solution) -> Assumption:
    remark = "'nonhertz compare' solves the case on a plane grid that assumes no shape."
    if solution.element is not SEMI_ELLIPTIC:
        remark = f"The parabola has an error of about 1 % that no refinement removes. {remark}"
    return Assumption(
        "Pressure across", "has the shape of the strips' element", solution.element.name, Verdict.OPEN, remark
    )


def _elastic(found: CaseResults) -> Iterator[Assumption]:
    solution = found.solution
    pressure = solution.max_pressure
    where = " away from singular ends" if solution.singular_ends else ""
    yield Assumption(
        "Linear elastic bodies",
        f"p0 below {FLOW_BEGINS:g} yield strengths (line contact, Tresca; Johnson 1985, section 6.1)",
        f"p0 = {digits(pressure)} MPa{where}",
        Verdict.OPEN,
        f"No input says when the material flows: it must bear {digits(pressure / FLOW_BEGINS, 4)} MPa before it does.",
    )
    if found.stress:
        largest = found.stress[0]
        yield Assumption(
            f"Linear elastic below the surface of body {largest.body}",
            "von Mises stress below the yield strength",
            f"{digits(largest.von_mises.max)} MPa at z = {digits(largest.von_mises.z, 3)} mm",
            Verdict.OPEN,
        )


def _strained_if(strained: bool) -> Verdict:
    return Verdict.STRAINED if strained else Verdict.HOLDS


def _known(error: float) -> Verdict:
    return _strained_if(error > TOLD) if math.isfinite(error) else Verdict.OPEN


def _percent(error: float) -> str:
    if not math.isfinite(error):
        return "not known"
    return f"about {given(100.0 * error, 1)} %" if error > 1e-12 else "none"
