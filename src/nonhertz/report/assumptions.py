"""What a result rests on: each assumption with its criterion, this case's number, and whether it holds.

The limits are those at which the solver warns, and for errors the difference above which a comparison of methods names
the place. Where no input shows whether an assumption holds, it is marked as not judged. A single contact and all those
of a bearing are judged alike.
"""

from __future__ import annotations

import enum
import math
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from nonhertz.amounts import format_digits, format_error, mm, mpa, mrad, newton
from nonhertz.bearing.bearings import CylindricalRollerBearing, RollerBearing, TaperedRollerBearing
from nonhertz.bearing.equilibrium import TOLERANCE
from nonhertz.bearing.section import RINGS
from nonhertz.bearing.solution import BearingSolution
from nonhertz.bodies.depths import depth_below
from nonhertz.bodies.ends import ends
from nonhertz.comparison.value import NOTABLE
from nonhertz.report.results import BearingResults, CaseResults, Results
from nonhertz.result.checks import LEAST_DEPTH, ValidityCheck, checks
from nonhertz.result.edges import EdgeKind
from nonhertz.result.ends import leaves_stress
from nonhertz.result.solution import Solution
from nonhertz.result.status import Status
from nonhertz.result.validity import ROUND_IT
from nonhertz.show.bearing import most_loaded
from nonhertz.strength import CheckStatus, onset_of_yield
from nonhertz.strip.element import SEMI_ELLIPTIC

NO_ERROR = 1e-12  # relative: rounding
# A load that turns with a tilted ring by 1 %, the difference that counts in comparisons.
MOST_TILT = NOTABLE
COUNTS = 0.1  # of the largest load: of contacts that bear less the errors are relative to little
NO_INPUT = "not an input"
_NO_TILT = 1e-12  # rad: rounding
_PARTS = {"Body a is thick": "Rollers are thick", "Body b is thick": "Rings are thick"}


class Verdict(enum.Enum):
    """Whether an assumption holds, from the best to the worst; each member's value is what the reader sees."""

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


SURFACES = Assumption("Surfaces", "dry, smooth, without friction", NO_INPUT, remark="Roughness is neglected.")
_NEGLECTED = (
    Assumption("Rollers do not skew", "axes stay in planes with that of the bearing", NO_INPUT),
    Assumption("No friction, no film", "contacts and ribs transmit normal loads alone", NO_INPUT),
    Assumption("Even cage", "rollers keep their distances", NO_INPUT, remark="The cage takes no load."),
    Assumption(
        "Steady state",
        "one position of the rollers, the first where the angle is zero",
        NO_INPUT,
        remark="Centrifugal loads follow from the speed; vibrations do not.",
    ),
)
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
Contacts = Mapping[str, Sequence[Solution]]  # by the name of their ring, empty for a single contact; the first counts


def assumptions(found: Results) -> list[Assumption]:
    """Return the assumptions behind a result and whether they hold."""
    return [*(_of_bearing(found) if isinstance(found, BearingResults) else _of_contact(found)), SURFACES]


def _of_contact(found: CaseResults) -> Iterator[Assumption]:
    solution = found.solution
    fine = solution.status is Status.CONVERGED
    yield Assumption(
        "Solved",
        "every contact condition is met",
        f"{solution.status.label}, {solution.iterations} Newton steps",
        Verdict.HOLDS if fine else Verdict.NOT_MET,
        "" if fine else "The numbers are those at which the solver stopped. They are meaningless.",
    )
    if not (fine and solution.contact_y):
        return
    yield from _of_contacts({"": [solution]})
    for name, body in (("a", solution.contact.a), ("b", solution.contact.b)):
        if depth_below(body, solution.element) is None:
            remark = "A half-space of infinite depth: the approach is measured against a distant point."
            criterion = f"depth of at least {LEAST_DEPTH:g} half-widths"
            yield Assumption(f"Body {name} is thick", criterion, "no depth given", remark=remark)
    for each in found.strengths:
        largest = each.largest.von_mises
        told = [check for check in each.checks if check.name in {"yield", "bore", "core"}]
        verdicts = {check.verdict for check in told}
        known = Verdict.OPEN if CheckStatus.UNKNOWN in verdicts else Verdict.HOLDS
        yield Assumption(
            f"Linear elastic below the surface of body {each.body}",
            "von Mises stress below the yield strength",
            f"{mpa(largest.max)} {largest.site}z = {mm(largest.z):3}",
            Verdict.NOT_MET if CheckStatus.OVER in verdicts else known,
            " ".join(check.sentence for check in told),
        )


def _of_bearing(found: BearingResults) -> Iterator[Assumption]:
    solution = found.solution
    if solution is None:
        words = "Solved", "rollers and rings are in balance", "no balance"
        yield Assumption(*words, Verdict.NOT_MET, "There are no results.")
        return
    number = f"{solution.residual:.1g} of the loads left, {solution.iterations} Newton steps"
    criterion = f"at most {TOLERANCE:.1g} of the loads is left unbalanced"
    yield Assumption("Rollers and rings in balance", criterion, number, strained_if(solution.residual > TOLERANCE))
    tilt = float(np.max(np.abs(solution.displacement[3:])))
    yield Assumption(
        "Contact angles stay as they are",
        f"the inner ring tilts by less than {mrad(MOST_TILT):g}, which turns a load by 1 %",
        f"{mrad(tilt):4}",
        strained_if(tilt > MOST_TILT),
        _angles(solution.bearing.rows[0].bearing),
    )
    if solution.method != "strips":
        yield from _of_slices(solution)
    elif solution.distinct_contacts:
        # At each ring the most loaded first; equal ones once.
        contacts: dict[str, list[Solution]] = {}
        for each in sorted(solution.distinct_contacts, key=lambda each: (each.ring, -each.solved.load)):
            contacts.setdefault(RINGS[each.ring], []).append(each.solved)
        yield from _of_contacts(contacts)
        yield from _whole_rollers(solution)
    yield from _ribs(solution)
    yield from _shapes(solution)
    yield from _NEGLECTED


def _of_contacts(contacts: Contacts) -> Iterator[Assumption]:
    """Yield what the strips of a contact, or of all contacts of a bearing, rest on."""
    every = [each for ring in contacts.values() for each in ring]
    corner = any(each.peaks_at_corner for each in every)
    yield from _valid(contacts)
    yield _ends(every)
    bends = max(
        sum(each.contact_y[0][0] < y < each.contact_y[-1][1] for y in each.contact.bends if each.contact_y)
        for each in every
    )
    yield Assumption(
        "Smooth along y",
        "no corner of the profile bears the largest pressure",
        "1 bend of the relief in contact" if bends == 1 else f"{bends or 'no'} bends of the relief in contact",
        Verdict.NOT_MET if corner else Verdict.HOLDS,
        f"The largest pressure has no limit: {ROUND_IT}." if corner else "",
    )
    most = max(each.load for each in every)
    estimates = [each.error_estimate for each in every if each.load > COUNTS * most]
    # The prescribed one of the two has no error.
    error, name = max((getattr(each, name), name) for each in estimates for name in ("approach", "load"))
    yield _fine_enough(f"the {name}", error)
    yield _fine_enough("the largest pressure", max(each.max_pressure for each in estimates), at_corner=corner)
    element = every[0].element
    remark = "'nonhertz compare' solves a single contact on a plane grid that assumes no shape."
    if element != SEMI_ELLIPTIC:
        remark = f"The parabola has an error of about 1 % that no refinement removes. {remark}"
    yield Assumption("Pressure across", "has the shape of the strips' element", element.name, remark=remark)
    pressure = max(each.max_pressure for each in every)
    where = " away from singular ends" if any(each.singular_ends for each in every) else ""
    least = min(onset_of_yield(body.material.poisson)[1] for body in (every[0].contact.a, every[0].contact.b))
    yield Assumption(
        "Linear elastic bodies",
        f"p0 below {least:.3g} times the yield strength (line contact, von Mises; Johnson 1985, section 6.1)",
        f"p0 = {mpa(pressure)}{where}",
        remark=f"The yield strength must be above {mpa(pressure / least):4}.",
    )


def _checks(solution: Solution) -> tuple[ValidityCheck, ...]:
    return checks(solution, solution.judgement.judged(solution).checks, ends(solution.contact))


def _valid(contacts: Contacts) -> Iterator[Assumption]:
    """Yield each condition of the contacts once: at each ring the most loaded contact that violates it, or of all."""
    made = {
        ring: [{check.assumption: check for check in _checks(each)} for each in every]
        for ring, every in contacts.items()
    }
    for name in dict.fromkeys(name for ring in made.values() for each in ring for name in each):
        shown: list[tuple[str, ValidityCheck]] = []
        for ring, these in made.items():
            having = [each[name] for each in these if name in each]
            if having:
                shown.append((ring, next((check for check in having if not check.holds), having[0])))
        failing = [check for _, check in shown if not check.holds]
        words = ", ".join(f"{format_digits(check.value, 3)}{ring and f' at the {ring} ring'}" for ring, check in shown)
        first = failing[0] if failing else shown[0][1]
        called = name if "" in contacts else _PARTS.get(name, name)
        yield Assumption(called, first.criterion, words, strained_if(bool(failing)), first.remark)


def _ends(contacts: Sequence[Solution]) -> Assumption:
    """Return the worst of all ends; those of a single contact are named, of several counted."""
    every = [(contact, edge) for contact in contacts for edge in contact.edge_pressure]
    judged = [
        _LEAVES_STRESS if edge.kind is EdgeKind.FINITE and leaves_stress(contact.contact, edge) else ENDS[edge.kind]
        for contact, edge in every
    ]
    verdict = max((each for each, _ in judged), key=[*Verdict].index, default=Verdict.HOLDS)
    kinds = [edge.kind.label.replace("-", " ") for _, edge in every]
    words = [
        f"{kind} at y = {mm(edge.y):.5g}" + (f", {edge.law}" if edge.law else "")
        for kind, (_, edge) in zip(kinds, every, strict=True)
    ]
    if len(contacts) > 1:
        words = [f"ends: {', '.join(f'{number} {kind}' for kind, number in Counter(kinds).most_common())}"]
    return Assumption(
        "Contact ends inside the bodies",
        "pressure falls to zero before a body ends",
        "; ".join(words),
        verdict,
        " ".join(dict.fromkeys(remark for each, remark in judged if each is verdict)),
    )


def _fine_enough(what: str, error: float, *, at_corner: bool = False) -> Assumption:
    """Return the assumption that a grid is fine enough for a number of this estimated error, or at a corner's peak."""
    name = f"Grid fine enough for {what}"
    criterion = f"the solver's own error estimate is at most {100.0 * NOTABLE:g} %"
    if at_corner:
        remark = "At a corner of the profile it rises with every refinement."
        return Assumption(name, criterion, "no limit", Verdict.NOT_MET, remark)
    if not math.isfinite(error):
        return Assumption(name, criterion, "unknown")
    number = format_error(error) if error > NO_ERROR else "none"
    return Assumption(name, criterion, number, strained_if(error > NOTABLE))


def strained_if(strained: bool) -> Verdict:
    """Return the verdict on a number that is within its limit or not."""
    return Verdict.STRAINED if strained else Verdict.HOLDS


# Of bearings alone


def _angles(row: RollerBearing) -> str:
    inner, outer = (math.degrees(each) for each in row.contact_angles)
    if inner == outer:
        return f"The contact angle is {format_digits(inner, 4)} degrees." if inner else ""
    angles = format_digits(inner, 4), format_digits(outer, 4)
    return "Contact angles are {} degrees at the inner and {} at the outer ring.".format(*angles)


def _whole_rollers(solution: BearingSolution) -> Iterator[Assumption]:
    if solution.bearing.rows[0].bearing.roller.behind.shown != "finite":
        return
    j = most_loaded(solution)
    tilt = np.where(np.abs(solution.tilt[j]) > _NO_TILT, solution.tilt[j], 0.0)
    loads, tilts = newton(*solution.load[j], between=" and "), mrad(*tilt, between=" and ")
    number = f"{loads:4}, tilted by {tilts:4}, at inner and outer ring"
    remark = "The whole roller is elastic. Where its contacts differ, the odd part of its deformation is neglected."
    yield Assumption("Rollers are pressed alike from both sides", "same load and tilt", number, remark=remark)


def _of_slices(solution: BearingSolution) -> Iterator[Assumption]:
    remark = "Solve by strips for pressures, and for rings and rollers of other stiffness than the standard's."
    criterion = "slices of ISO/TS 16281 do not feel each other"
    yield Assumption("Independent slices", criterion, "by slices", remark=remark)
    if isinstance(solution.bearing.rows[0].bearing, TaperedRollerBearing):
        remark = "Slices ignore the ribs of tapered rows: only the loads on the raceways remain."
        yield Assumption("Ribs", "bear part of the load", "none", remark=remark)


def _ribs(solution: BearingSolution) -> Iterator[Assumption]:
    """Yield whether the contacts of the ribs of each ring stay on flank and roller."""
    rib_of = getattr(solution.bearing.rows[0].bearing, "rib", None)
    remark = "Where the ribs touch is a guess: give bearing.rib." if rib_of is None else ""
    if rib_of is not None and rib_of.edge is None:
        remark = "Where the flank ends is not known: give bearing.rib.edge. Compared with the roller's end alone."
    for ring in RINGS:
        loads = [
            (load, rib)
            for number, each in enumerate(solution.bearing.rows)
            for line in solution.each_rib_load[solution.rollers_of(number)].tolist()
            for load, rib in zip(line, each.bearing.rib_contacts, strict=False)
            if rib.ring == ring and load > 0.0
        ]
        if not loads:
            continue
        load, rib = max(loads, key=lambda each: each[0])
        beyond = rib.reaches_an_edge(load)
        more = "Where it reaches an edge the pressure is higher than Hertz's." if beyond else ""
        yield Assumption(
            f"Ellipse on the ribs of the {ring} ring",
            f"reaches no edge, {mm(rib.room):3} away along the flank",
            f"{mm(rib.under(load).half_length):3} under {newton(load)}",
            Verdict.STRAINED if beyond else Verdict.OPEN if rib_of is None else Verdict.HOLDS,
            f"{more} {remark}".strip(),
        )


def _shapes(solution: BearingSolution) -> Iterator[Assumption]:
    row = solution.bearing.rows[0].bearing
    shaped = [ring for ring in RINGS if getattr(row, f"{ring}_shape") is not None]
    said = f"{' and '.join(shaped)} ring{'s' if len(shaped) > 1 else ''} with a shape" if shaped else "round rings"
    remark = "Rings do not bend under the rollers: give soft housings and ovality as shapes."
    if "inner" in shaped:
        remark += " The shape of the inner ring is that of one moment: it turns."
    yield Assumption("Rings keep their shape", "stiff in shaft and housing", said, remark=remark)
    if isinstance(row, CylindricalRollerBearing) and not row.rib_contacts:
        number = f"design {row.design}"
        yield Assumption("Ribs bear nothing", "rings free along the axis", number, remark="They guide rollers.")
