"""The assumptions behind a result: each with its criterion, the number of this case, and whether it holds.

The limits are those at which the solver warns, and for errors the difference above which a comparison of methods names
the place. An assumption that no input can confirm is marked as not judged. Single contacts and contacts of bearings are
judged by the same rules.
"""

from __future__ import annotations

import enum
import math
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import chain
from operator import attrgetter, itemgetter

import numpy as np

from nonhertz.amounts import format_digits, format_error, mm, mpa, mrad, newton
from nonhertz.bearing.bearings import CylindricalRollerBearing, RollerBearing, TaperedRollerBearing
from nonhertz.bearing.equilibrium import TOLERANCE, drop_tilt_rounding
from nonhertz.bearing.ribs import Rib
from nonhertz.bearing.section import RINGS
from nonhertz.bearing.solution import BearingSolution
from nonhertz.bodies.depths import depth_below
from nonhertz.bodies.ends import ends
from nonhertz.comparison.value import NOTABLE
from nonhertz.model.contact import Contact
from nonhertz.report.results import BearingResults, CaseResults, Results
from nonhertz.result.checks import LEAST_DEPTH, ValidityCheck, checks
from nonhertz.result.edges import EdgeKind, EdgePressure
from nonhertz.result.ends import leaves_stress
from nonhertz.result.solution import Solution
from nonhertz.result.status import Status
from nonhertz.result.validity import ROUND_IT
from nonhertz.show.bearing import most_loaded
from nonhertz.strength import CheckStatus, Strength, onset_of_yield
from nonhertz.strip.element import SEMI_ELLIPTIC

NO_ERROR = 1e-12  # relative: rounding
# rad: the tilt of a ring that turns a load by 1 %, the difference that counts in comparisons.
MOST_TILT = NOTABLE
COUNTS = 0.1  # of the largest load; in contacts with less, errors are relative to little
NO_INPUT = "not an input"
_PARTS = {"Body a is thick": "Rollers are thick", "Body b is thick": "Rings are thick"}


class Verdict(enum.Enum):
    """Whether an assumption holds, from best to worst; the value of a member is shown to the reader."""

    HOLDS = "holds"
    OPEN = "not judged"
    STRAINED = "strained"
    NOT_MET = "not met"


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
    verdict: Verdict = Verdict.OPEN
    remark: str = ""


SURFACES = Assumption("Surfaces", "dry, smooth and frictionless", NO_INPUT, remark="Roughness is neglected.")
_NEGLECTED = (
    Assumption("Rollers do not skew", "the axes of rollers and bearing stay in a plane", NO_INPUT),
    Assumption("No friction, no film", "contacts and ribs transmit normal loads only", NO_INPUT),
    Assumption("Equally spaced rollers", "the cage keeps their distances", NO_INPUT, remark="The cage is not loaded."),
    Assumption(
        "Steady state",
        "one position of the rollers, the first at angle zero",
        NO_INPUT,
        remark="Centrifugal loads are included, vibrations are not.",
    ),
)
#: The verdict on each kind of end, and its consequence.
ENDS = {
    EdgeKind.RUN_OUT: (Verdict.HOLDS, ""),
    EdgeKind.FINITE: (Verdict.HOLDS, "Both bodies end there with free faces: the pressure is finite."),
    EdgeKind.SINGULAR: (
        Verdict.NOT_MET,
        "Edge loading: the pressure is unbounded there; it is reliable from a quarter of a half-width inwards.",
    ),
    EdgeKind.CORNER: (Verdict.NOT_MET, "The pressure is unbounded at a corner of the profile: give it a radius."),
    EdgeKind.CUT_OFF: (Verdict.NOT_MET, "The strips end before the contact does: give more strips."),
}
_LEAVES_STRESS = (
    Verdict.STRAINED,
    "The side face is free of shear, but not of normal stress: the true pressure at the end is lower.",
)
_HOLDS = attrgetter("holds")
Contacts = Mapping[str, Sequence[Solution]]  # by ring, or "" for a single contact; the first one counts


def judge_assumptions(result: Results) -> list[Assumption]:
    """Return the assumptions behind a result and whether they hold."""
    return [*(_judge_bearing(result) if isinstance(result, BearingResults) else _judge_contact(result)), SURFACES]


def _judge_contact(result: CaseResults) -> Iterator[Assumption]:
    solution = result.solution
    fine = solution.status is Status.CONVERGED
    yield Assumption(
        "Solved",
        "every contact condition is met",
        f"{solution.status.label}, {solution.iterations} Newton steps",
        Verdict.HOLDS if fine else Verdict.NOT_MET,
        "" if fine else "The numbers are those at which the solver stopped; they are not results.",
    )
    if not (fine and solution.contact_y):
        return
    yield from _judge_strips({"": [solution]})
    for name, body in solution.contact.bodies.items():
        if depth_below(body, solution.element) is None:
            remark = "A half-space of infinite depth: the approach is measured against a distant point."
            criterion = f"depth of at least {LEAST_DEPTH:g} half-widths"
            yield Assumption(f"Body {name} is thick", criterion, "no depth given", remark=remark)
    yield from map(_judge_strength, result.strengths)


def _judge_strength(strength: Strength) -> Assumption:
    largest = strength.largest.von_mises
    checks = [check for check in strength.checks if check.name in {"yield", "bore", "core"}]
    verdicts = {check.verdict for check in checks}
    known = Verdict.OPEN if CheckStatus.UNKNOWN in verdicts else Verdict.HOLDS
    return Assumption(
        f"Linear elastic below the surface of body {strength.body}",
        "von Mises stress below the yield strength",
        f"{mpa(largest.max)} {largest.site}z = {mm(largest.z):3}",
        Verdict.NOT_MET if CheckStatus.OVER in verdicts else known,
        " ".join(check.sentence for check in checks),
    )


def _judge_bearing(result: BearingResults) -> Iterator[Assumption]:
    solution = result.solution
    if solution is None:
        words = "Solved", "rollers and rings are in equilibrium", "no equilibrium"
        yield Assumption(*words, Verdict.NOT_MET, "There are no results.")
        return
    number = f"residual {solution.residual:.1g} of the loads, {solution.iterations} Newton steps"
    criterion = f"residual of at most {TOLERANCE:.1g} of the loads"
    yield Assumption("Rollers and rings in equilibrium", criterion, number, verdict_for(solution.residual > TOLERANCE))
    tilt = float(np.max(np.abs(solution.displacement[3:])))
    yield Assumption(
        "Contact angles do not change",
        f"the inner ring tilts by less than {mrad(MOST_TILT):g}, which turns a load by 1 %",
        f"{mrad(tilt):4}",
        verdict_for(tilt > MOST_TILT),
        _angle_remark(solution.bearing.rows[0].bearing),
    )
    if solution.method != "strips":
        yield from _judge_slices(solution)
    elif solution.distinct_contacts:
        # By ring, the most loaded contact first; equal contacts once.
        contacts: dict[str, list[Solution]] = {}
        for contact in sorted(solution.distinct_contacts, key=lambda contact: (contact.ring, -contact.solved.load)):
            contacts.setdefault(RINGS[contact.ring], []).append(contact.solved)
        yield from _judge_strips(contacts)
        yield from _judge_whole_rollers(solution)
    yield from _judge_ribs(solution)
    yield from _judge_shapes(solution)
    yield from _NEGLECTED


def _judge_strips(contacts: Contacts) -> Iterator[Assumption]:
    """Yield the assumptions of strips, for one contact or for all contacts of a bearing."""
    solutions = [*chain.from_iterable(contacts.values())]
    yield from _judge_validity(contacts)
    yield _judge_ends(solutions)
    yield _judge_smoothness(solutions)
    yield from _judge_grids(solutions)
    element = solutions[0].element
    remark = "A comparison of a single contact with a plane grid, which assumes no shape, shows the error."
    if element != SEMI_ELLIPTIC:
        remark = f"The parabola has an error of about 1 % that no refinement removes. {remark}"
    yield Assumption("Pressure across", "has the shape of the strips' element", element.name, remark=remark)
    pressure = max(solution.max_pressure for solution in solutions)
    where = " away from singular ends" if any(solution.singular_ends for solution in solutions) else ""
    contact = solutions[0].contact
    least = min(onset_of_yield(body.material.poisson)[1] for body in (contact.a, contact.b))
    yield Assumption(
        "Linear elastic bodies",
        f"p0 below {least:.3g} times the yield strength (line contact, von Mises; Johnson 1985, section 6.1)",
        f"p0 = {mpa(pressure)}{where}",
        remark=f"The yield strength must be above {mpa(pressure / least):4}.",
    )


def _judge_smoothness(solutions: Sequence[Solution]) -> Assumption:
    corner = any(solution.peaks_at_corner for solution in solutions)
    counts = (
        sum(solution.contact_y[0][0] < y < solution.contact_y[-1][1] for y in solution.contact.bends)
        for solution in solutions
        if solution.contact_y
    )
    bends = max(counts, default=0)
    return Assumption(
        "Smooth along y",
        "the maximum pressure is not at a corner of the profile",
        f"{bends or 'no'} bend{'s' * (bends != 1)} of the relief in contact",
        Verdict.NOT_MET if corner else Verdict.HOLDS,
        f"The maximum pressure is unbounded: {ROUND_IT}." if corner else "",
    )


def _judge_grids(solutions: Sequence[Solution]) -> Iterator[Assumption]:
    most = max(solution.load for solution in solutions)
    estimates = [solution.error_estimate for solution in solutions if solution.load > COUNTS * most]
    # Either approach or load is prescribed and has no error.
    error, name = max((getattr(estimate, name), name) for estimate in estimates for name in ("approach", "load"))
    yield _judge_grid(f"the {name}", error)
    corner = any(solution.peaks_at_corner for solution in solutions)
    yield _judge_grid("the maximum pressure", max(estimate.max_pressure for estimate in estimates), at_corner=corner)


def _checks(solution: Solution) -> tuple[ValidityCheck, ...]:
    return checks(solution, solution.judgement.judged(solution).checks, ends(solution.contact))


def _judge_validity(contacts: Contacts) -> Iterator[Assumption]:
    """Yield each condition of the contacts once: by ring, for the most loaded contact that violates it, or of all."""
    by_name: dict[str, dict[str, ValidityCheck]] = {}
    for ring, solutions in contacts.items():
        for check in chain.from_iterable(map(_checks, solutions)):
            rings = by_name.setdefault(check.assumption, {})
            rings[ring] = min(rings.get(ring, check), check, key=_HOLDS)
    for name, rings in by_name.items():
        worst = min(rings.values(), key=_HOLDS)
        numbers = [f"{format_digits(c.value, 3)}{ring and f' at the {ring} ring'}" for ring, c in rings.items()]
        part = name if "" in contacts else _PARTS.get(name, name)
        yield Assumption(part, worst.criterion, ", ".join(numbers), verdict_for(not worst.holds), worst.remark)


def _judge_end(contact: Contact, edge: EdgePressure) -> tuple[Verdict, str]:
    finite = edge.kind is EdgeKind.FINITE
    return _LEAVES_STRESS if finite and leaves_stress(contact, edge) else ENDS[edge.kind]


def _edge_kind(edge: EdgePressure) -> str:
    return edge.kind.label.replace("-", " ")


def _describe_edge(edge: EdgePressure) -> str:
    return f"{_edge_kind(edge)} at y = {mm(edge.y):.5g}{f', {edge.law}' if edge.law else ''}"


def _judge_ends(solutions: Sequence[Solution]) -> Assumption:
    """Return the verdict on the worst end; the ends of one contact are listed, those of several are counted."""
    edges = [(solution.contact, edge) for solution in solutions for edge in solution.edge_pressure]
    verdicts = [_judge_end(*pair) for pair in edges]
    worst = max((verdict for verdict, _ in verdicts), key=[*Verdict].index, default=Verdict.HOLDS)
    if len(solutions) > 1:
        counts = Counter(_edge_kind(edge) for _, edge in edges).most_common()
        words = f"ends: {', '.join(f'{number} {kind}' for kind, number in counts)}"
    else:
        words = "; ".join(_describe_edge(edge) for _, edge in edges)
    return Assumption(
        "Contact ends inside the bodies",
        "pressure falls to zero before a body ends",
        words,
        worst,
        " ".join(dict.fromkeys(remark for verdict, remark in verdicts if verdict is worst)),
    )


def _judge_grid(what: str, error: float, *, at_corner: bool = False) -> Assumption:
    """Return the assumption that a grid is fine enough for a number with this estimated error."""
    name = f"Grid fine enough for {what}"
    criterion = f"the solver's own error estimate is at most {100.0 * NOTABLE:g} %"
    if at_corner:
        remark = "At a corner of the profile the pressure rises with every refinement."
        return Assumption(name, criterion, "unbounded", Verdict.NOT_MET, remark)
    if not math.isfinite(error):
        return Assumption(name, criterion, "unknown")
    number = format_error(error) if error > NO_ERROR else "none"
    return Assumption(name, criterion, number, verdict_for(error > NOTABLE))


def verdict_for(strained: bool) -> Verdict:
    """Return the verdict on a condition that is strained or holds."""
    return Verdict.STRAINED if strained else Verdict.HOLDS


# Bearings only


def _angle_remark(row: RollerBearing) -> str:
    inner, outer = map(math.degrees, row.contact_angles)
    if inner == outer:
        return f"The contact angle is {format_digits(inner, 4)} degrees." if inner else ""
    angles = format_digits(inner, 4), format_digits(outer, 4)
    return "Contact angles are {} degrees at the inner and {} at the outer ring.".format(*angles)


def _judge_whole_rollers(solution: BearingSolution) -> Iterator[Assumption]:
    if solution.bearing.rows[0].bearing.roller.behind.shown != "finite":
        return
    j = most_loaded(solution)
    tilt = drop_tilt_rounding(solution.tilt[j])
    loads, tilts = newton(*solution.load[j], between=" and "), mrad(*tilt, between=" and ")
    number = f"{loads:4}, tilted by {tilts:4}, at inner and outer ring"
    remark = "The whole roller is elastic. Where its two contacts differ, the odd part of its deformation is neglected."
    yield Assumption("Rollers are loaded equally on both sides", "same load and tilt", number, remark=remark)


def _judge_slices(solution: BearingSolution) -> Iterator[Assumption]:
    remark = "Solve by strips for pressures, or if rings and rollers are not as stiff as the standard assumes."
    criterion = "slices of ISO/TS 16281 do not affect each other"
    yield Assumption("Independent slices", criterion, "by slices", remark=remark)
    if isinstance(solution.bearing.rows[0].bearing, TaperedRollerBearing):
        remark = "Slices neglect the ribs of tapered rows: only the raceways are loaded."
        yield Assumption("Ribs", "support part of the load", "none", remark=remark)


def _judge_ribs(solution: BearingSolution) -> Iterator[Assumption]:
    """Yield for each ring whether the contacts with its ribs stay within flank and roller end."""
    known, remark = _judge_flanks(getattr(solution.bearing.rows[0].bearing, "rib", None))
    loads = [
        (load, rib)
        for number, row in enumerate(solution.bearing.rows)
        for line in solution.each_rib_load[solution.rollers_of(number)].tolist()
        for load, rib in zip(line, row.bearing.rib_contacts, strict=False)
        if load > 0.0
    ]
    for ring in RINGS:
        load, rib = max((pair for pair in loads if pair[1].ring == ring), key=itemgetter(0), default=(0.0, None))
        if rib is None:
            continue
        beyond = rib.reaches_an_edge(load)
        more = "Where the ellipse reaches an edge, the pressure is higher than by Hertz." if beyond else ""
        yield Assumption(
            f"Ellipse on the ribs of the {ring} ring",
            f"reaches no edge, {mm(rib.room):3} away along the flank",
            f"{mm(rib.under(load).half_length):3} under {newton(load)}",
            Verdict.STRAINED if beyond else known,
            f"{more} {remark}".strip(),
        )


def _judge_flanks(rib: Rib | None) -> tuple[Verdict, str]:
    """Return the verdict on ellipses within known edges, and a remark on what is unknown of the flanks."""
    if rib is None:
        return Verdict.OPEN, "The position of the contact on the ribs is a guess: give bearing.rib."
    if rib.edge is None:
        return (
            Verdict.HOLDS,
            "The edge of the flank is not known: give bearing.rib.edge. Only the roller's end is checked.",
        )
    return Verdict.HOLDS, ""


def _judge_shapes(solution: BearingSolution) -> Iterator[Assumption]:
    row = solution.bearing.rows[0].bearing
    shaped = [ring for ring in RINGS if getattr(row, f"{ring}_shape") is not None]
    number = f"{' and '.join(shaped)} ring{'s' if len(shaped) > 1 else ''} with a shape" if shaped else "round rings"
    remark = "Rings do not bend under the rollers: describe ovality or a soft housing by the shape of a ring."
    if "inner" in shaped:
        remark += " The shape of the inner ring, which turns, is that at one instant."
    yield Assumption("Rings keep their shape", "stiff in shaft and housing", number, remark=remark)
    if isinstance(row, CylindricalRollerBearing) and not row.rib_contacts:
        words = "Ribs support no axial load", "rings free along the axis", f"design {row.design}"
        yield Assumption(*words, remark="They only guide rollers.")
