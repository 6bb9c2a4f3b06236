"""What strains the model in a solved case, and what is refused for it; each in one sentence."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import about, mm, um
from nonhertz.errors import InputError
from nonhertz.findings import Finding, finding
from nonhertz.model.contact import Contact, sharper_curvature
from nonhertz.model.side_faces import SERIES
from nonhertz.native import core
from nonhertz.result.checks import (
    HEAVIEST,
    LEAST_DEPTH,
    LEAST_OF_ALL,
    MOST_OF_MODULUS,
    MOST_OF_RADIUS,
    MOST_UNEVEN,
    WAY_OUT,
    WIDER_THAN_LONG,
    checks,
    refuse_thin_bodies,
)
from nonhertz.result.ends import step_at
from nonhertz.result.estimate import (
    LARGE_ERROR,
    LARGE_PRESSURE_ERROR,
    LEFT_BY_MODES,
    MISSED,
    PRESSURE_LEFT_BY_MODES,
    has_whole_roller,
)
from nonhertz.result.penetration import is_noticeable
from nonhertz.result.solution import EdgeKind, Solution, Status
from nonhertz.strip.overlaps import overlapping, runs
from nonhertz.strip.problem import Problem
from nonhertz.strip.records import States
from nonhertz.strip.solving import SCARCELY

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]

AT_CORNER = 1.5  # strips: a maximum this close to a corner of the profile is attributed to the corner
WIDEST_SERIES = 2.0  # lengths; a line load 17 lengths away is then accurate to 0.2 %


def is_strained(problem: Problem, judgement: core.Judgement) -> bool:
    """Return whether `strains` finds anything."""
    checks, errors, influence = judgement.checks, judgement.errors, problem.model.influence
    contact, by_modes = problem.contact, has_whole_roller(problem)
    asked = problem.accuracy if problem.accuracy_given and problem.accuracy is not None else LARGE_ERROR
    of_pressure = LARGE_PRESSURE_ERROR if problem.pressure_accuracy is None else problem.pressure_accuracy
    softer = min(contact.a.material.modulus, contact.b.material.modulus)
    return not (
        checks.length_ratio <= WIDER_THAN_LONG
        and checks.radius_ratio <= MOST_OF_RADIUS
        and checks.unevenness <= MOST_UNEVEN * checks.deepest
        and checks.mean_pressure <= MOST_OF_MODULUS * softer
        and checks.depth_ratio >= LEAST_DEPTH
        and max(errors.approach, errors.load) <= min(LARGE_ERROR, asked + LEFT_BY_MODES * by_modes)
        and errors.max_pressure <= min(LARGE_PRESSURE_ERROR, of_pressure + PRESSURE_LEFT_BY_MODES * by_modes)
        and not checks.missed > MISSED * checks.pressed
        and not judgement.peaks_at_corner
        and not any(end.kind == core.EndKind.CUT_OFF for end in judgement.ends)
        and not any(end.requested > HEAVIEST for end in influence.ends)
    )


def strains(solution: Solution, problem: Problem, state: States) -> Iterator[Finding]:
    """Yield every way in which the result leaves the model's validity."""
    for check in checks(solution, problem.model.influence.ends):
        yield from check.findings
    yield from _large_errors(solution)
    yield from _short_of_accuracy(solution, problem)
    yield from missed_contact(problem, state)
    yield from _without_limit(solution)


def _large_errors(solution: Solution) -> Iterator[Finding]:
    """Yield every result whose estimated error is large; a maximum without a limit has a finding of its own."""
    estimate = solution.error_estimate
    approached = "approach"
    if estimate.approach > LARGE_ERROR and is_noticeable(solution.approach, solution.penetration):
        approached = "penetration"
    yield from _uncertain(approached, estimate.approach)
    yield from _uncertain("load", estimate.load)
    if not (solution.peaks_at_corner or any(edge.kind is EdgeKind.CUT_OFF for edge in solution.judgement.ends)):
        yield from _uncertain("maximum pressure", estimate.max_pressure, LARGE_PRESSURE_ERROR)


def _short_of_accuracy(solution: Solution, problem: Problem) -> Iterator[Finding]:
    """Yield that the accuracy that was asked for is not met; larger errors have findings of their own."""
    estimate, asked = solution.error_estimate, problem.accuracy
    name, error = max(("approach", estimate.approach), ("load", estimate.load), key=lambda each: each[1])
    is_given, by_modes, large = problem.accuracy_given, LEFT_BY_MODES, LARGE_ERROR
    if problem.pressure_accuracy is not None:
        name, error, asked = "largest pressure", estimate.max_pressure, problem.pressure_accuracy
        is_given, by_modes, large = True, PRESSURE_LEFT_BY_MODES, LARGE_PRESSURE_ERROR
    # Strips have no part in what the modes of a whole roller leave.
    if is_given and asked is not None and asked < error - by_modes * has_whole_roller(problem) <= large:
        yield finding(
            "short-of-accuracy",
            "The accuracy of {asked:g} asked for is not met: the error of the {quantity} is estimated at {error:.2g}, "
            "on {strips} strips; what is left is at sharp ends, corners or in roughness that strips do not resolve.",
            asked=asked,
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
            size=about(error) if error < 1.0 else "more than its own size",
        )


def missed_contact(problem: Problem, state: States) -> Iterator[Finding]:
    """Yield where the bodies overlap although no strip there is in contact."""
    region = searched(problem.contact, float(state.edges[0]), float(state.edges[-1]))
    y, overlap = overlapping(problem, state, region)
    overlap = np.where(_next_to_contact(state, y), 0.0, overlap)
    if not np.any(overlap > 0.0):
        return
    pressed = 0.5 * (state.edges[1:] + state.edges[:-1])[state.m > 0.0]
    deepest = float(np.max(state.rigid[0] + state.rigid[1] * pressed - problem.model.separation(pressed)))
    if np.any(overlap > MISSED * deepest):
        worst = int(np.argmax(overlap))
        yield finding(
            "missed-contact",
            "The bodies overlap by {overlap:.2g} at y = {y:.6g}, where no strip has its centre: a contact region is "
            "missed; give narrower strips there.",
            overlap=um(overlap[worst]),
            y=mm(y[worst]),
        )


def searched(contact: Contact, low: float, high: float) -> tuple[float, float]:
    """Return where contacts that strips between two places may have missed are looked for [mm]."""
    return max(contact.interval[0], 2.0 * low - high), min(contact.interval[1], 2.0 * high - low)


def _next_to_contact(state: States, y: Array) -> Flags:
    """Return which places lie in strips in contact, or within a strip width beside them, where the contact ends."""
    found: Flags = np.zeros(y.shape, dtype=bool)
    for first, last in runs(state.m > 0.0):
        low, high = state.edges[first] - state.width[first], state.edges[last + 1] + state.width[last]
        found |= (y >= low) & (y <= high)
    return found


ROUND_IT = "round it as it is in reality, by a corner_radius or a chamfer with a blend_radius beside the profile"
_NO_LIMIT = (
    "the value there is that of a strip {width:.3g} wide, not a limit, and the maximum pressure is taken more than a "
    "half-width from it"
)


def singularities(solution: Solution) -> tuple[Finding, ...]:
    """Return each end of the contact at which the pressure has no limit."""
    sharp = {edge.y: edge for edge in solution.judgement.ends if edge.kind is EdgeKind.SINGULAR}
    found = []
    for end in solution.singular_ends:
        width = mm(step_at(solution, end))
        if end.kind is EdgeKind.SINGULAR:
            edge = sharp[end.y]
            found.append(
                finding(
                    "sharp-end",
                    "The contact reaches the sharp end at y = {y:.6g} ({convention}), where the pressure is singular, "
                    f"p ~ K / s^{{exponent:.3g}} at small distances s: {_NO_LIMIT}.",
                    y=mm(edge.y),
                    convention=edge.convention,
                    exponent=edge.exponent,
                    width=width,
                )
            )
        else:
            found.append(
                finding(
                    "corner-end",
                    "The contact ends at a corner of the profile at y = {y:.6g}, where the pressure is singular: "
                    f"{_NO_LIMIT}; {ROUND_IT}.",
                    y=mm(end.y),
                    width=width,
                )
            )
    return tuple(found)


def _without_limit(solution: Solution) -> Iterator[Finding]:
    """Yield ends at which the strips cut the contact off, and a corner within it that carries the maximum."""
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
            "The largest pressure is at a corner of the profile near y = {y:.6g}, where it is singular: it is that of "
            f"a strip {{width:.3g}} wide, not a limit; {ROUND_IT}.",
            y=mm(solution.max_pressure_y),
            width=mm(width),
        )


def refuse_wide(solution: Solution, problem: Problem) -> None:
    """Refuse a contact wider than one of its bodies is round, or than the material behind it is deep."""
    converged = solution.status is Status.CONVERGED
    # A loop that failed leaves meaningless half-widths; those of springs may be too small by half.
    half_width = solution.half_width
    if not converged:
        squares = core.springs(problem.model.in_core, *problem.conditions, solution.edges)
        half_width = solution.element.hertz_ratio * np.sqrt(squares)
    if not np.isfinite(np.max(half_width)):
        return
    name, per = ("load", problem.contact.compliance) if problem.prescribed[0] else ("approach", 1.0)
    pressed = name, float(problem.target[0]) / per
    wide = np.flatnonzero(half_width * sharper_curvature(solution.contact, solution.y) > 1.0)
    # Springs under a moment near the ends are wide whatever the load is.
    if wide.size and (converged or not problem.prescribed[1]):
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
