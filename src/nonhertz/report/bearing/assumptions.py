"""What the result of a bearing rests on, and whether it holds; what is neglected is named and not judged."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from nonhertz.amounts import digits, mm, mpa, mrad, newton
from nonhertz.bearing.bearings import CylindricalRollerBearing, RollerBearing, TaperedRollerBearing
from nonhertz.bearing.equilibrium import TOLERANCE
from nonhertz.bearing.frames import RINGS
from nonhertz.bearing.solution import BearingSolution
from nonhertz.bodies.ends import ends
from nonhertz.comparison.value import NOTABLE
from nonhertz.report.assumptions import (
    ENDS,
    SURFACES,
    Assumption,
    Verdict,
    elastic_below_yield,
    fine_enough,
    strained_if,
)
from nonhertz.report.bearing.results import BearingResults
from nonhertz.result.checks import ValidityCheck, checks
from nonhertz.result.solution import Solution
from nonhertz.show.bearing import most_loaded
from nonhertz.verdict import STATIC_LIMIT

# A load that turns with a tilted ring by 1 %, the difference that counts in comparisons.
MOST_TILT = NOTABLE
_PARTS = {"Body a is thick": "Rollers are thick", "Body b is thick": "Rings are thick"}


def bearing_assumptions(found: BearingResults) -> list[Assumption]:
    """Return the assumptions behind the result of a bearing and whether they hold."""
    solution = found.solution
    if solution is None:
        words = "Solved", "rollers and rings are in balance", "no balance"
        return [Assumption(*words, Verdict.NOT_MET, "There are no results.")]
    rows = [_balanced(solution), _small_motions(solution)]
    rows += _of_strips(solution) if solution.method == "strips" else _of_slices(solution)
    rows += [*_ribs(solution), *_shapes(solution), *_NEGLECTED]
    return [*rows, SURFACES]


def _balanced(solution: BearingSolution) -> Assumption:
    number = f"{solution.residual:.1g} of the loads left, {solution.steps} Newton steps"
    criterion = f"at most {TOLERANCE:.1g} of the loads is left unbalanced"
    return Assumption("Rollers and rings in balance", criterion, number, strained_if(solution.residual > TOLERANCE))


def _small_motions(solution: BearingSolution) -> Assumption:
    tilt = float(np.max(np.abs(solution.displacement[3:])))
    return Assumption(
        "Contact angles stay as they are",
        f"the inner ring tilts by less than {mrad(MOST_TILT):g}, which turns a load by 1 %",
        f"{mrad(tilt):4}",
        strained_if(tilt > MOST_TILT),
        _angles(solution.bearing.rows[0].bearing),
    )


def _angles(row: RollerBearing) -> str:
    inner, outer = (math.degrees(each) for each in row.contact_angles)
    if inner == outer:
        return f"The contact angle is {digits(inner, 4)} degrees." if inner else ""
    return f"Contact angles are {digits(inner, 4)} degrees at the inner and {digits(outer, 4)} at the outer ring."


def _of_strips(solution: BearingSolution) -> Iterator[Assumption]:
    contacts = _contacts(solution)
    if not contacts[0] and not contacts[1]:
        return
    every = [each for ring in contacts for each in ring]
    yield from _valid(contacts)
    yield _ends(every)
    yield from _fine(every)
    remark = "The semi-ellipse is exact for long contacts; the plane grid of a single contact assumes no shape."
    yield Assumption("Pressure across", "has the shape of the strips' element", "semi-elliptic", Verdict.OPEN, remark)
    yield from _whole_rollers(solution)
    pressure = float(solution.max_pressure.max())
    yield elastic_below_yield(pressure)
    yield Assumption(
        "No lasting indentation that matters",
        f"maximum pressure up to {mpa(STATIC_LIMIT):g}, at which ISO 76 puts 1/10000 of the rollers' diameter",
        f"{mpa(pressure):4}",
        strained_if(pressure > STATIC_LIMIT),
    )


def _contacts(solution: BearingSolution) -> tuple[list[Solution], list[Solution]]:
    """Return the loaded contacts at the inner and at the outer ring, the most loaded first; equal ones once."""
    every = ([solution.contact(j, ring) for j in range(solution.angle.size)] for ring in RINGS)
    distinct = ({id(each): each for each in of_ring if each is not None} for of_ring in every)
    inner, outer = (sorted(of_ring.values(), key=lambda each: -each.load) for of_ring in distinct)
    return inner, outer


def _valid(contacts: tuple[list[Solution], list[Solution]]) -> Iterator[Assumption]:
    """Yield each condition of the contacts once: at each ring the most loaded contact that violates it, or of all."""
    made = [
        [{check.assumption: check for check in checks(each, ends(each.contact))} for each in ring if each.contact_y]
        for ring in contacts
    ]
    names = dict.fromkeys(name for ring in made for each in ring for name in each)
    for name in names:
        shown: list[tuple[str, ValidityCheck]] = []
        for ring, these in zip(RINGS, made, strict=True):
            having = [each[name] for each in these if name in each]
            if having:
                shown.append((ring, next((check for check in having if not check.holds), having[0])))
        failing = [check for _, check in shown if not check.holds]
        words = ", ".join(f"{digits(check.value, 3)} at the {ring} ring" for ring, check in shown)
        first = failing[0] if failing else shown[0][1]
        yield Assumption(_PARTS.get(name, name), first.criterion, words, strained_if(bool(failing)), first.remark)


def _ends(contacts: list[Solution]) -> Assumption:
    kinds = Counter(edge.kind for contact in contacts for edge in contact.edge_pressure)
    strained = [kind for kind in kinds if ENDS[kind][0] is not Verdict.HOLDS]
    words = ", ".join(f"{number} {kind.label}" for kind, number in kinds.most_common())
    verdict, remark = ENDS[strained[0]] if strained else (Verdict.HOLDS, "")
    return Assumption(
        "Contacts end inside the bodies", "pressure falls to zero before a body ends", f"ends: {words}", verdict, remark
    )


def _fine(contacts: list[Solution]) -> Iterator[Assumption]:
    # Of contacts that bear little the errors are relative to little.
    estimates = [each.error_estimate for each in contacts if each.load > 0.1 * contacts[0].load]
    yield fine_enough("the loads", max(each.load for each in estimates))
    at_corner = any(each.peaks_at_corner for each in contacts)
    yield fine_enough("the largest pressures", max(each.max_pressure for each in estimates), at_corner=at_corner)


def _whole_rollers(solution: BearingSolution) -> Iterator[Assumption]:
    row = solution.bearing.rows[0].bearing
    if row.roller.behind.shown != "finite" or not solution.load.any():
        return
    j = most_loaded(solution)
    loads, tilts = newton(*solution.load[j], between=" and "), mrad(*solution.tilt[j], between=" and ")
    number = f"{loads:4}, tilted by {tilts:4}, at inner and outer ring"
    remark = "The whole roller is elastic. Where its contacts differ, the odd part of its deformation is neglected."
    yield Assumption("Rollers are pressed alike from both sides", "same load and tilt", number, Verdict.OPEN, remark)


def _of_slices(solution: BearingSolution) -> Iterator[Assumption]:
    remark = "Solve by strips for pressures, and for rings and rollers of other stiffness than the standard's."
    criterion = "slices of ISO/TS 16281 do not feel each other"
    yield Assumption("Independent slices", criterion, "by slices", Verdict.OPEN, remark)
    if isinstance(solution.bearing.rows[0].bearing, TaperedRollerBearing):
        remark = "Slices know no ribs of tapered rows: what presses on the raceways is left."
        yield Assumption("Ribs", "bear part of the load", "none", Verdict.OPEN, remark)


def _ribs(solution: BearingSolution) -> Iterator[Assumption]:
    """Yield whether the contacts of the ribs of each ring stay on flank and roller."""
    row = solution.bearing.rows[0].bearing
    if not solution.rib_loads.size:
        return
    given = getattr(row, "rib", None)
    remark = "Where the ribs touch is a guess: give bearing.rib." if given is None else ""
    if given is not None and given.edge is None:
        remark = "Where the flank ends is not known: give bearing.rib.edge. Compared with the roller's end alone."
    for ring in RINGS:
        loads = [
            (load, rib)
            for number, each in enumerate(solution.bearing.rows)
            for line in solution.rib_loads[solution.rollers_of(number)].tolist()
            for load, rib in zip(line, each.bearing.rib_contacts, strict=False)
            if rib.ring == ring and load > 0.0
        ]
        if not loads:
            continue
        load, rib = max(loads, key=lambda each: each[0])
        ellipse = rib.under(load)
        beyond = rib.reaches_an_edge(load)
        verdict = Verdict.STRAINED if beyond else Verdict.OPEN if given is None else Verdict.HOLDS
        more = "Where it reaches an edge the pressure is higher than Hertz's." if beyond else ""
        yield Assumption(
            f"Ellipse on the ribs of the {ring} ring",
            f"reaches no edge, {mm(rib.room):3} away along the flank",
            f"{mm(ellipse.half_length):3} under {newton(load)}",
            verdict,
            f"{more} {remark}".strip(),
        )


def _shapes(solution: BearingSolution) -> Iterator[Assumption]:
    row = solution.bearing.rows[0].bearing
    given = [ring for ring in RINGS if getattr(row, f"{ring}_shape") is not None]
    said = f"{' and '.join(given)} ring{'s' if len(given) > 1 else ''} with a shape" if given else "round rings"
    remark = "Rings do not bend under the rollers: give soft housings and ovality as shapes."
    if "inner" in given:
        remark += " The shape of the inner ring is that of one moment: it turns."
    yield Assumption("Rings keep their shape", "stiff in shaft and housing", said, Verdict.OPEN, remark)
    if isinstance(row, CylindricalRollerBearing) and not row.rib_contacts:
        yield Assumption(
            "Ribs bear nothing",
            "rings free along the axis",
            f"design {row.design}",
            Verdict.OPEN,
            "They guide rollers.",
        )


_REST = Assumption("", "", "not an input", Verdict.OPEN)
_NEGLECTED = (
    replace(_REST, name="Rollers do not skew", criterion="axes stay in planes with that of the bearing"),
    replace(_REST, name="No friction, no film", criterion="contacts and ribs transmit normal loads alone"),
    replace(
        _REST, name="Even cage", criterion="rollers keep their distances", remark="The cage bears and takes no load."
    ),
    replace(
        _REST, name="Steady state", criterion="one position of the rollers, the first where the angle is zero",
        remark="Centrifugal loads follow from the speed; vibrations do not.",
    ),
)  # fmt: skip
