"""What the result rests on: each assumption with its criterion, this case's number, and whether it holds.

The limits are those at which the solver warns, and for errors the difference above which a comparison of methods names
the place. Where no input shows whether an assumption holds, it is marked as not judged.
"""

from __future__ import annotations

import enum
import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import digits, given, mm, mpa
from nonhertz.bodies.ends import ends
from nonhertz.comparison.value import NOTABLE
from nonhertz.report.results import CaseResults
from nonhertz.result.checks import LEAST_DEPTH, checks
from nonhertz.result.ends import leaves_stress
from nonhertz.result.solution import EdgeKind, EdgePressure, Solution, Status
from nonhertz.result.validity import ROUND_IT
from nonhertz.strength import Verdict as StrengthVerdict
from nonhertz.strip.element import SEMI_ELLIPTIC

Array = NDArray[np.float64]

# Pressure p0 of a line contact over the yield strength at the onset of yield below the surface, by Tresca's criterion:
# K. L. Johnson, Contact Mechanics, Cambridge University Press 1985, section 6.1.
FLOW_BEGINS = 1.67
NO_ERROR = 1e-12  # relative: rounding


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
        When it holds.
    number : str
        The value for this case.
    verdict : Verdict
        Whether it holds.
    remark : str
        The consequence; may be empty.
    """

    name: str
    criterion: str
    number: str
    verdict: Verdict
    remark: str = ""


SURFACES = Assumption(
    "Surfaces", "dry, smooth, without friction", "not an input", Verdict.OPEN, "Roughness is neglected."
)


def assumptions(found: CaseResults) -> list[Assumption]:
    """Return the assumptions behind a result and whether they hold."""
    solution = found.solution
    rows = [_converged(solution)]
    if solution.contact_y and solution.status is Status.CONVERGED:
        rows += [*_valid(solution), *_ends(solution)]
        rows += [_smooth(solution), *_fine(solution), _shape(solution), *_elastic(found)]
    rows.append(SURFACES)
    return rows


def _converged(solution: Solution) -> Assumption:
    fine = solution.status is Status.CONVERGED
    remark = "" if fine else "The numbers are those at which the solver stopped. They are meaningless."
    return Assumption(
        "Solved",
        "every contact condition is met",
        f"{solution.status.label}, {solution.iterations} Newton steps",
        Verdict.HOLDS if fine else Verdict.NOT_MET,
        remark,
    )


def _valid(solution: Solution) -> Iterator[Assumption]:
    """Yield the checks behind the solver's warnings, and a note for each body without a depth."""
    for check in checks(solution, ends(solution.contact)):
        number = digits(check.value, 3)
        yield Assumption(check.assumption, check.criterion, number, strained_if(not check.holds), check.remark)
    for name, body in (("a", solution.contact.a), ("b", solution.contact.b)):
        if body.behind.below(body, solution.element) is None:
            remark = "A half-space of infinite depth: the approach is measured against a distant point."
            criterion = f"depth of at least {LEAST_DEPTH:g} half-widths"
            yield Assumption(f"Body {name} is thick", criterion, "no depth given", Verdict.OPEN, remark)


#: The verdict on each kind of end, and its consequence.
ENDS = {
    EdgeKind.RUN_OUT: (Verdict.HOLDS, ""),
    EdgeKind.FINITE: (Verdict.HOLDS, "Both bodies end there with free faces: the pressure is finite."),
    EdgeKind.SINGULAR: (
        Verdict.NOT_MET,
        "The pressure has no limit there; trust it from a quarter of a half-width inwards.",
    ),
    EdgeKind.CORNER: (Verdict.NOT_MET, "The pressure has no limit at a corner of the profile: give it a radius."),
    EdgeKind.CUT_OFF: (Verdict.NOT_MET, "The strips end before the contact does: give more strips."),
}


_LEAVES_STRESS = (
    Verdict.STRAINED,
    "Freed of shear, not of normal stress: the true pressure at the end is lower.",
)


def _ends(solution: Solution) -> Iterator[Assumption]:
    for edge, name in zip(solution.edge_pressure, ("low", "high"), strict=True):
        verdict, remark = ENDS[edge.kind]
        if edge.kind is EdgeKind.FINITE and leaves_stress(solution.contact, edge):
            verdict, remark = _LEAVES_STRESS
        what = f"Contact ends inside the bodies at {name} y"
        yield Assumption(what, "pressure falls to zero before a body ends", _end(edge), verdict, remark)


def _end(edge: EdgePressure) -> str:
    kind = edge.kind.label.replace("-", " ")
    return f"{kind} at y = {mm(edge.y):.5g}" + (f", {edge.law}" if edge.law else "")


def _smooth(solution: Solution) -> Assumption:
    low, high = solution.contact_y[0][0], solution.contact_y[-1][1]
    bends = sum(low < y < high for y in solution.contact.bends)
    number = "1 bend of the relief in contact" if bends == 1 else f"{bends or 'no'} bends of the relief in contact"
    corner = solution.peaks_at_corner
    remark = f"The largest pressure has no limit: {ROUND_IT}." if corner else ""
    criterion = "no corner of the profile bears the largest pressure"
    return Assumption("Smooth along y", criterion, number, Verdict.NOT_MET if corner else Verdict.HOLDS, remark)


def _fine(solution: Solution) -> Iterator[Assumption]:
    estimate = solution.error_estimate
    # The prescribed one of the two has no error.
    name, error = max((("approach", estimate.approach), ("load", estimate.load)), key=lambda each: each[1])
    yield fine_enough(f"the {name}", error)
    yield fine_enough("the largest pressure", estimate.max_pressure, at_corner=solution.peaks_at_corner)


def fine_enough(what: str, error: float, *, at_corner: bool = False) -> Assumption:
    """Return the assumption that a grid is fine enough for a number of this estimated error, or at a corner's peak."""
    name, criterion = (
        f"Grid fine enough for {what}",
        f"the solver's own error estimate is at most {100.0 * NOTABLE:g} %",
    )
    if at_corner:
        remark = "At a corner of the profile it rises with every refinement."
        return Assumption(name, criterion, "no limit", Verdict.NOT_MET, remark)
    if not math.isfinite(error):
        return Assumption(name, criterion, "unknown", Verdict.OPEN)
    number = f"about {given(100.0 * error, 1)} %" if error > NO_ERROR else "none"
    return Assumption(name, criterion, number, strained_if(error > NOTABLE))


def _shape(solution: Solution) -> Assumption:
    remark = "'nonhertz compare' solves the case on a plane grid that assumes no shape."
    if solution.element is not SEMI_ELLIPTIC:
        remark = f"The parabola has an error of about 1 % that no refinement removes. {remark}"
    return Assumption(
        "Pressure across", "has the shape of the strips' element", solution.element.name, Verdict.OPEN, remark
    )


def _elastic(found: CaseResults) -> Iterator[Assumption]:
    solution = found.solution
    where = " away from singular ends" if solution.singular_ends else ""
    yield elastic_below_yield(solution.max_pressure, where)
    for each in found.strengths:
        largest, checks = (
            each.largest.von_mises,
            [check for check in each.checks if check.name in {"yield", "bore", "core"}],
        )
        yield Assumption(
            f"Linear elastic below the surface of body {each.body}",
            "von Mises stress below the yield strength",
            f"{mpa(largest.max)} {largest.site}z = {mm(largest.z):3}",
            _of_strength({check.verdict for check in checks}),
            " ".join(check.sentence for check in checks),
        )


def _of_strength(found: set[StrengthVerdict]) -> Verdict:
    if StrengthVerdict.OVER in found:
        return Verdict.STRAINED
    return Verdict.OPEN if StrengthVerdict.UNKNOWN in found else Verdict.HOLDS


def elastic_below_yield(pressure: float, where: str = "") -> Assumption:
    """Return the assumption that no body yields under a maximum pressure [MPa]; ``where`` it is, after a blank."""
    return Assumption(
        "Linear elastic bodies",
        f"p0 below {FLOW_BEGINS:g} times the yield strength (line contact, Tresca; Johnson 1985, section 6.1)",
        f"p0 = {mpa(pressure)}{where}",
        Verdict.OPEN,
        f"The yield strength must be above {mpa(pressure / FLOW_BEGINS):4}.",
    )


def strained_if(strained: bool) -> Verdict:
    """Return the verdict on a number that is within its limit or not."""
    return Verdict.STRAINED if strained else Verdict.HOLDS
