"""Strains of the model in a solved case, and refusals; each in one sentence.

The core computes the numbers, for one case and for each of many; here they are compared with limits.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import format_error, mm, um
from nonhertz.errors import InputError
from nonhertz.findings import Finding, finding
from nonhertz.model.contact import sharper_curvature
from nonhertz.model.side_faces import SERIES
from nonhertz.native import core
from nonhertz.result.checks import HEAVIEST, LEAST_OF_ALL, WAY_OUT, all_hold, checks, refuse_thin_bodies
from nonhertz.result.edges import EdgeKind
from nonhertz.result.penetration import is_noticeable
from nonhertz.result.solution import Solution
from nonhertz.result.status import Status
from nonhertz.strip.problem import Problem

Array = NDArray[np.float64]

LARGE_ERROR, LARGE_PRESSURE_ERROR = 0.05, 0.2  # estimated errors; a result worse than this is unfit for design
MISSED = 0.02  # of the deepest interference: an overlap this large where no strip is in contact is a missed contact
WIDEST_SERIES = 2.0  # lengths; a line load 17 lengths away is then accurate to 0.2 %
SCARCELY = 4.0  # half-widths of springs: if no solution is found, a body of smaller depth is the reason


def is_strained(problem: Problem, judged: core.Judgement) -> bool:
    """Return whether `strains` finds anything, at a hundredth of its cost."""
    errors, contact = judged.errors, problem.contact
    softer = min(contact.a.material.modulus, contact.b.material.modulus)
    large, large_pressure = LARGE_ERROR, LARGE_PRESSURE_ERROR
    if problem.pressure_accuracy is not None:
        large_pressure = min(large_pressure, problem.pressure_accuracy + errors.pressure_left_by_modes)
    elif problem.accuracy_given and problem.accuracy is not None:
        large = min(large, problem.accuracy + errors.left_by_modes)
    return not (
        all_hold(judged.checks, softer)
        and errors.approach <= large
        and errors.load <= large
        and errors.max_pressure <= large_pressure
        and not judged.checks.missed > MISSED * judged.checks.pressed
        and all(end.requested <= HEAVIEST for end in problem.model.influence.ends)
    )


def strains(solution: Solution, problem: Problem, judged: core.Judgement) -> Iterator[Finding]:
    """Yield every condition in which the result exceeds the model's validity."""
    for check in checks(solution, judged.checks, problem.model.influence.ends):
        yield from check.findings
    yield from _large_errors(solution)
    yield from _short_of_accuracy(solution, problem, judged.errors)
    yield from _find_missed_contact(judged.checks)
    yield from _without_limit(solution)


def _large_errors(solution: Solution) -> Iterator[Finding]:
    """Yield every result whose estimated error is large; an unbounded maximum has a finding of its own."""
    estimate = solution.error_estimate
    approached = "approach"
    if estimate.approach > LARGE_ERROR and is_noticeable(solution.approach, solution.penetration):
        approached = "penetration"
    yield from _uncertain(approached, estimate.approach)
    yield from _uncertain("load", estimate.load)
    if not (solution.peaks_at_corner or any(edge.kind is EdgeKind.CUT_OFF for edge in solution.judgement.ends)):
        yield from _uncertain("maximum pressure", estimate.max_pressure, LARGE_PRESSURE_ERROR)


def _short_of_accuracy(solution: Solution, problem: Problem, errors: core.Errors) -> Iterator[Finding]:
    """Yield that the requested accuracy is not met; larger errors have findings of their own."""
    name, error = max(("approach", errors.approach), ("load", errors.load), key=lambda pair: pair[1])
    is_given, accuracy, by_modes, large = problem.accuracy_given, problem.accuracy, errors.left_by_modes, LARGE_ERROR
    if problem.pressure_accuracy is not None:
        name, error, accuracy = "maximum pressure", errors.max_pressure, problem.pressure_accuracy
        is_given, by_modes, large = True, errors.pressure_left_by_modes, LARGE_PRESSURE_ERROR
    # The error of the modes of a whole roller does not depend on strips.
    if is_given and accuracy is not None and accuracy < error - by_modes <= large:
        yield finding(
            "short-of-accuracy",
            "The requested accuracy of {asked:g} is not met: the error of the {quantity} is estimated at {error:.2g}, "
            "on {strips} strips. The rest is due to sharp ends, corners or roughness that strips do not resolve.",
            asked=accuracy,
            quantity=name,
            error=error,
            strips=solution.strips,
        )


def _uncertain(quantity: str, error: float, least: float = LARGE_ERROR) -> Iterator[Finding]:
    if error == np.inf:
        yield finding(
            "unknown-error",
            "The discretisation error of the {quantity} is not known: there is no solution on fewer strips.",
            quantity=quantity,
        )
    elif error > least:
        yield finding(
            "uncertain",
            "The {quantity} is uncertain: its discretisation error is estimated at {size}; give more strips.",
            quantity=quantity,
            error=error,
            size=format_error(error) if error < 1.0 else "more than its own size",
        )


def _find_missed_contact(values: core.Checks) -> Iterator[Finding]:
    """Yield where the bodies overlap although no strip there is in contact."""
    if values.missed > MISSED * values.pressed:
        yield finding(
            "missed-contact",
            "The bodies overlap by {overlap:.2g} at y = {y:.6g}, where no strip has its centre: a contact region is "
            "missed; give narrower strips there.",
            overlap=um(values.missed),
            y=mm(values.missed_y),
        )


ROUND_IT = "round it as it is in reality, by a corner_radius or a chamfer with a blend_radius beside the profile"
_NO_LIMIT = (
    "the value there depends on its strip, which is {width:.3g} wide, and the maximum pressure is taken more than a "
    "half-width from it"
)


def singularities(solution: Solution, judged: core.Judgement) -> tuple[Finding, ...]:
    """Return each end of the contact at which the pressure is unbounded."""
    sharp = {edge.y: edge for edge in solution.judgement.ends if edge.kind is EdgeKind.SINGULAR}
    findings = []
    for end in judged.singular:
        if end.is_corner:
            findings.append(
                finding(
                    "corner-end",
                    "The contact ends at a corner of the profile at y = {y:.6g}, where the pressure is singular: "
                    f"{_NO_LIMIT}; {ROUND_IT}.",
                    y=mm(end.y),
                    width=mm(end.width),
                )
            )
        else:
            edge = sharp[end.y]
            findings.append(
                finding(
                    "sharp-end",
                    "The contact reaches the sharp end at y = {y:.6g} ({convention}), where the pressure is singular, "
                    f"p ~ K / s^{{exponent:.3g}} at small distances s: {_NO_LIMIT}.",
                    y=mm(edge.y),
                    convention=edge.convention,
                    exponent=edge.exponent,
                    width=mm(end.width),
                )
            )
    return tuple(findings)


def _without_limit(solution: Solution) -> Iterator[Finding]:
    """Yield ends at which the strips cut the contact off, and a corner within it with the maximum pressure."""
    for edge in solution.judgement.ends:
        if edge.kind is EdgeKind.CUT_OFF:
            yield finding(
                "cut-off",
                "The strips end at y = {y:.6g} while the contact continues: the pressure there is that of bodies cut "
                "off; give strips up to the end of the contact, or leave them out.",
                y=mm(edge.y),
            )
    if solution.peaks_at_corner:
        width = float(solution.strip_width[np.abs(solution.y - solution.max_pressure_y).argmin()])
        yield finding(
            "corner-peak",
            "The maximum pressure is at a corner of the profile near y = {y:.6g}, where it is singular: the value "
            f"depends on its strip, which is {{width:.3g}} wide; {ROUND_IT}.",
            y=mm(solution.max_pressure_y),
            width=mm(width),
        )


def refuse_wide(solution: Solution, problem: Problem) -> None:
    """Refuse a contact that is wider than the radius of a body, or than the depth of the material behind it."""
    converged = solution.status is Status.CONVERGED
    # After a failed loop half-widths are meaningless; those of springs may be too small by half.
    half_width = solution.half_width
    if not converged:
        squares = core.springs(problem.model.in_core, problem.by_force, problem.target, solution.edges)
        half_width = solution.element.hertz_ratio * np.sqrt(squares)
    if not np.isfinite(np.max(half_width)):
        return
    name, per = ("load", problem.contact.compliance) if problem.by_force[0] else ("approach", 1.0)
    pressed = name, float(problem.target[0]) / per
    wide = np.flatnonzero(half_width * sharper_curvature(solution.contact, solution.y) > 1.0)
    # Springs under a moment near the ends are wide whatever the load is.
    if wide.size and (converged or not problem.by_force[1]):
        worst = wide[np.argmax(half_width[wide])]
        radius = 1.0 / float(sharper_curvature(solution.contact, solution.y[worst : worst + 1])[0])
        condition = (
            f"leave the half-width, {mm(half_width[worst]):.3g} at y = {mm(solution.y[worst]):.6g}, below the "
            f"radius of {mm(radius):.3g} of the more sharply curved body"
        )
        raise InputError(*pressed, condition, WAY_OUT)
    least = LEAST_OF_ALL if converged else SCARCELY
    refuse_thin_bodies(solution.contact, solution.element, solution.y, half_width, least, pressed)


def refuse_wide_series(solution: Solution) -> None:
    """Refuse a series of images under a contact so wide that the far ones are no longer line loads."""
    widest = float(np.max(solution.half_width))
    for name, body in (("a", solution.contact.a), ("b", solution.contact.b)):
        if body.images == SERIES and body.length is not None and widest > WIDEST_SERIES * body.length:
            condition = (
                f"only be used where the half-width, {mm(widest):.3g} here, is at most {WIDEST_SERIES:g} times the "
                f"body's length of {mm(body.length):g}"
            )
            raise InputError("images", SERIES, condition, "give a number of images").within(f"body.{name}")
