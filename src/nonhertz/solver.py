"""The one verb: a contact and what is prescribed in, a solution out."""

from __future__ import annotations

import math
import warnings
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.edge import edge_pressures, sharp_end_error
from nonhertz.errors import AccuracyWarning, ConvergenceError, InputError
from nonhertz.finite import depth_below, influence_of
from nonhertz.model.body import Body
from nonhertz.model.contact import Contact
from nonhertz.model.prescription import Prescription
from nonhertz.solution import EdgeKind, EdgePressure, ErrorEstimate, Solution, Status
from nonhertz.strip.element import SEMI_ELLIPTIC, Element
from nonhertz.strip.grid import kinks
from nonhertz.strip.levels import Levels, on_automatic_strips, on_equal_strips, on_given_strips
from nonhertz.strip.newton import CONVERGED, ITERATION_LIMIT, STAGNATED
from nonhertz.strip.state import SCARCELY, Problem, State, sprung

Array = NDArray[np.float64]

FEWEST_STRIPS, MOST_STRIPS = 1, 2000
MOST_OF_RADIUS = 0.3
LEAST_DEPTH = 3.0  # half-widths
HEAVIEST = 1.0 + 1e-9
WIDER_THAN_LONG = 1.02  # so that a circle is not called wide for its rounding
_STATUS = {CONVERGED: Status.CONVERGED, ITERATION_LIMIT: Status.ITERATION_LIMIT, STAGNATED: Status.STAGNATED}


def solve(
    contact: Contact,
    *,
    approach: float | None = None,
    load: float | None = None,
    tilt: float | None = None,
    moment: float | None = None,
    element: Element = SEMI_ELLIPTIC,
    strips: int | str | ArrayLike | None = None,
) -> Solution:
    """Press the bodies of a contact together.

    Parameters
    ----------
    contact : Contact
        The two bodies.
    approach : float, optional
        delta [mm]: how much nearer the bodies come on the line y = 0. Give this or ``load``.
    load : float, optional
        Q [N], positive. Give this or ``approach``.
    tilt : float, optional
        gamma [rad] about x; the interference is approach + tilt y - separation. Zero if neither this nor
        ``moment`` is given.
    moment : float, optional
        T [N mm], integral of pressure times y.
    element : Element
        SEMI_ELLIPTIC, or the paper's PARABOLIC.
    strips : int or array_like or "auto", optional
        A number: that many equal strips over the length on which both bodies can touch. An array: the edges of
        the strips [mm], ascending. Left out or ``"auto"``: a graded grid that follows the contact.

    Returns
    -------
    Solution

    Raises
    ------
    InputError
        If the input cannot be solved as it stands.
    ConvergenceError
        If the Newton loop fails; its ``solution`` holds the state reached.

    Warns
    -----
    AccuracyWarning
        If the result strains the model's validity; the sentences are in ``solution.warnings`` too.

    Examples
    --------
    >>> from nonhertz.model.body import Plate, Roller
    >>> from nonhertz.model.profile import crown
    >>> roller = Roller(diameter=20, length=20, profile=crown(radius=4000))
    >>> solution = solve(Contact(roller, Plate()), load=20e3, tilt=0.5e-3)
    >>> round(solution.moment / solution.load, 2)
    0.87
    """
    if not isinstance(contact, Contact):
        raise InputError("contact", contact, "be a Contact", "make one of two bodies with nonhertz.Contact")
    if not isinstance(element, Element):
        remedy = "use nonhertz.SEMI_ELLIPTIC or nonhertz.PARABOLIC"
        raise InputError("element", element, "be an element", remedy)
    prescription = Prescription.checked(approach, load, tilt, moment)
    prescription.refuse_outside(contact)
    problem = _problem(contact, prescription, element)
    levels = _levels(contact, problem, strips)
    solution = _solution(contact, element, problem, levels)
    _refuse_thin_bodies(solution, problem)
    if solution.status is not Status.CONVERGED:
        raise ConvergenceError(
            f"{solution.status.value} Try another number of strips, or a smaller load first.", solution
        )
    strains = _strains(solution, problem)
    for sentence in strains:
        warnings.warn(sentence, AccuracyWarning, stacklevel=2)
    return replace(solution, warnings=(*strains, *_singularities(solution)))


def _problem(contact: Contact, given: Prescription, element: Element) -> Problem:
    factor = contact.compliance
    target = np.array([
        given.first * (factor if given.by_load else 1.0),
        given.second * (factor if given.by_moment else 1.0),
    ])  # fmt: skip
    prescribed = np.array([given.by_load, given.by_moment])
    influence = influence_of(contact, element)
    return Problem(contact.separation, contact.curvature, element, prescribed, target, influence)


def _levels(contact: Contact, problem: Problem, strips: int | str | ArrayLike | None) -> Levels:
    remedy = "leave it out for an automatic grid"
    if strips is None or (isinstance(strips, str) and strips == "auto"):
        return on_automatic_strips(problem, contact.interval, contact.bends)
    if isinstance(strips, (int, np.integer)) and not isinstance(strips, bool):
        if not FEWEST_STRIPS <= strips <= MOST_STRIPS:
            raise InputError("strips", strips, f"lie between {FEWEST_STRIPS} and {MOST_STRIPS}", remedy)
        return on_equal_strips(problem, contact.interval, int(strips))
    if isinstance(strips, (Sequence, np.ndarray)) and not isinstance(strips, str):
        return on_given_strips(problem, _checked_edges(contact, strips))
    raise InputError("strips", strips, "be 'auto', a whole number or edges", remedy)


def _checked_edges(contact: Contact, strips: ArrayLike) -> Array:
    low, high = contact.interval
    remedy = "give ascending strip edges in mm within the bodies"
    try:
        edges = np.asarray(strips, dtype=float)
    except (TypeError, ValueError):
        raise InputError("strips", strips, "ascend and be finite", remedy) from None
    if edges.ndim != 1 or not FEWEST_STRIPS < edges.size <= MOST_STRIPS + 1:
        raise InputError(
            "strips",
            edges.shape,
            f"be a row of {FEWEST_STRIPS + 1} edges at least and {MOST_STRIPS + 1} at most",
            remedy,
        )
    if not np.all(np.isfinite(edges)) or np.any(np.diff(edges) <= 0.0):
        raise InputError("strips", edges.tolist(), "ascend and be finite", remedy)
    if edges[0] < low or edges[-1] > high:
        raise InputError("strips", (float(edges[0]), float(edges[-1])), f"lie between {low} and {high}", remedy)
    return edges


def _solution(contact: Contact, element: Element, problem: Problem, levels: Levels) -> Solution:
    state, compliance = levels.finest, contact.compliance
    edges = edge_pressures(contact, problem, state)
    at_corner = state.converged and _peaks_at_kink(contact, state)
    with np.errstate(over="ignore"):  # a loop that failed may leave anything
        line_load, stiffness = state.r * state.m / compliance, state.stiffness / compliance
    return Solution(
        contact=contact,
        element=element,
        status=_STATUS[state.status],
        approach=float(state.rigid[0]),
        tilt=float(state.rigid[1]),
        load=state.load / compliance,
        moment=state.moment / compliance,
        stiffness=stiffness,
        edges=state.edges.copy(),
        line_load=line_load,
        element_half_width=np.sqrt(state.m),
        gap=state.gap,
        contact_y=state.contact,
        edge_pressure=edges,
        peaks_at_corner=at_corner,
        iterations=state.steps,
        error_estimate=_error_estimate(problem, levels, edges, at_corner),
        warnings=(),
    )


def _error_estimate(
    problem: Problem, levels: Levels, edges: tuple[EdgePressure, ...], at_corner: bool
) -> ErrorEstimate:
    state = levels.finest
    if not state.converged:
        return ErrorEstimate(math.inf, math.inf, math.inf)
    by_load = bool(problem.prescribed[0])
    floor = sharp_end_error(edges, sum(high - low for low, high in state.contact))
    singular = at_corner or not all(edge.converges for edge in edges)
    return ErrorEstimate(
        approach=max(floor, levels.difference(lambda level: float(level.rigid[0]))) if by_load else 0.0,
        load=0.0 if by_load else max(floor, levels.difference(lambda level: level.load)),
        max_pressure=math.inf if singular else levels.difference(lambda level: float(np.max(level.pressure))),
    )


def _peaks_at_kink(contact: Contact, state: State) -> bool:
    """Return whether the largest pressure is at a corner of the profile, where it has no limit either."""
    at = int(np.argmax(state.pressure))
    return any(
        abs(place - state.y[at]) <= 1.5 * state.width[at]
        for place, _ in kinks(contact.separation, contact.bends, state)
    )


def _strains(solution: Solution, problem: Problem) -> tuple[str, ...]:
    """Return a sentence for every way in which the result leaves the model's validity."""
    sentences = []
    widest = 2.0 * float(np.max(solution.half_width))
    longest = max(end - start for start, end in solution.contact_y)
    if widest > WIDER_THAN_LONG * longest:
        sentences.append(
            f"The contact is wider than long: width / length = {widest / longest:.2f}, and strips should be "
            "long against their width in sum; expect errors where the contact ends."
        )
    touching = solution.line_load > 0.0
    y = solution.y[touching]
    curvature = np.maximum(np.abs(solution.contact.a.curvature(y)), np.abs(solution.contact.b.curvature(y)))
    ratio = float(np.max(solution.half_width[touching] * curvature))
    if ratio > MOST_OF_RADIUS:
        sentences.append(
            f"The half-width is {ratio:.2f} of the smaller radius of curvature, over {MOST_OF_RADIUS}: neither "
            "half-spaces nor a parabolic separation describe such a contact."
        )
    sentences.extend(_thin_bodies(solution))
    sentences.extend(_heavy_images(problem))
    return tuple(sentences)


def _refuse_thin_bodies(solution: Solution, problem: Problem) -> None:
    """Refuse a depth so small that the points at depth move as much as the surface."""
    converged = solution.status is Status.CONVERGED
    # A loop that failed leaves half-widths that mean nothing; those of springs may be too small by a half.
    half_width = solution.half_width
    if not converged:
        half_width = solution.element.hertz_ratio * np.sqrt(sprung(problem, solution.edges).m)
    least = 1.0 if converged else SCARCELY
    widest = float(np.max(half_width))
    for name, body, ratio in _depths(solution, half_width):
        if ratio < least:
            shown = ratio * widest if isinstance(body.depth, str) else body.depth
            condition = f"be large against the half-width of the contact, about {widest:.2g} mm"
            remedy = "give the thickness of the body, or 'none'"
            raise InputError("depth", shown, condition, remedy).within(f"body.{name}")


def _thin_bodies(solution: Solution) -> list[str]:
    """Return a sentence for each body whose depth is not large against the half-width."""
    return [
        f"The depth of body {name} is only {ratio:.2f} half-widths, less than {LEAST_DEPTH:g}: the body is so thin "
        "that neither half-spaces nor line loads describe it."
        for name, _, ratio in _depths(solution, solution.half_width)
        if ratio < LEAST_DEPTH
    ]


def _depths(solution: Solution, half_width: Array) -> list[tuple[str, Body, float]]:
    """Return name, body and least depth in half-widths of each body that has a depth."""
    touching = half_width > 0.0
    if not np.any(touching):
        return []
    found = []
    for name, body in (("a", solution.contact.a), ("b", solution.contact.b)):
        below = depth_below(body, solution.element)
        if below is not None:
            found.append((name, body, float(np.min(below(solution.y[touching]) / half_width[touching]))))
    return found


def _heavy_images(problem: Problem) -> list[str]:
    """Return a sentence for each place at which images had to weigh less than asked."""
    return [
        f"The images about the side face at y = {end.y:.6g} mm would weigh {end.wanted:.3g} of the surface, a face of "
        "the other body at the same place counted in, and above 1 refinement leads nowhere: their weights were lowered "
        "until it is 1. The pressure up to that end is finite only by this."
        for end in problem.influence.ends
        if end.wanted > HEAVIEST
    ]


def _singularities(solution: Solution) -> tuple[str, ...]:
    """Return a sentence for every sharp end that the contact reaches, and for a corner that bears the maximum."""
    sentences = []
    for edge in solution.edge_pressure:
        if edge.kind is EdgeKind.SINGULAR:
            known = "" if edge.strength is None else f" with K = {edge.strength:.4g} MPa mm^{edge.exponent:.3g}"
            sentences.append(
                f"The contact reaches the sharp end at y = {edge.y:.6g} mm ({edge.convention}), where the pressure is "
                f"singular, p ~ K / s^{edge.exponent:.3g} at small distances s{known}: the value there is that of a "
                f"strip {edge.strip_width:.3g} mm wide, not a limit."
            )
        elif edge.kind is EdgeKind.CUT_OFF:
            sentences.append(
                f"The strips end at y = {edge.y:.6g} mm while the contact goes on: the pressure there is that of "
                "bodies cut off; give strips up to the end of the contact, or leave them out."
            )
    if solution.peaks_at_corner:
        width = float(solution.strip_width[solution.peak_pressure.argmax()])
        sentences.append(
            f"The largest pressure is at a corner of the profile near y = {solution.max_pressure_y:.6g} mm, where it "
            f"is singular: it is that of a strip {width:.3g} mm wide, not a limit; give the corner a radius."
        )
    return tuple(sentences)
