"""The one verb: a contact and what is prescribed in, a solution out."""

from __future__ import annotations

import math
import warnings
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.errors import AccuracyWarning, ConvergenceError, InputError
from nonhertz.model.checks import finite, positive
from nonhertz.model.contact import Contact
from nonhertz.solution import ErrorEstimate, Solution, Status
from nonhertz.strip.element import SEMI_ELLIPTIC, Element
from nonhertz.strip.grid import Sizes, ends_of_contact, graded, reaches, sizes, uniform
from nonhertz.strip.newton import CONVERGED, ITERATION_LIMIT, STAGNATED
from nonhertz.strip.state import Problem, State, half_space_problem, settle, sprung

Array = NDArray[np.float64]

FEWEST_STRIPS, MOST_STRIPS = 3, 2000
STRIP_LIMIT = 87  # of an automatic grid on one interval of contact
COARSE_STRIPS = 24
FINE_STRIPS = 2000  # of springs, to find where bodies overlap
COARSEST_LEVEL = 10
FEWER_STRIPS = (1.0, 0.94, 0.88, 0.82, 0.76)  # tried in turn where a grid has no solution
ROUGH_SHARE = 0.35  # of the strips, on the grid from which the final one is learnt
WELL_FILLED = 0.4  # of the region by the contact, before a grid is graded from it
MOST_OF_RADIUS = 0.3
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
    1.24
    """
    if not isinstance(contact, Contact):
        raise InputError("contact", contact, "be a Contact", "make one of two bodies with nonhertz.Contact")
    if not isinstance(element, Element):
        remedy = "use nonhertz.SEMI_ELLIPTIC or nonhertz.PARABOLIC"
        raise InputError("element", element, "be an element", remedy)
    prescription = _Prescription.checked(approach, load, tilt, moment)
    problem = prescription.problem(contact, element)
    solution = _solution(contact, element, _solved_pair(contact, problem, strips))
    if solution.status is not Status.CONVERGED:
        raise ConvergenceError(
            f"{solution.status.value} Try another number of strips, or a smaller load first.", solution
        )
    for sentence in _strains(solution):
        warnings.warn(sentence, AccuracyWarning, stacklevel=2)
    return solution


@dataclass(frozen=True)
class _Prescription:
    """The two given quantities, checked."""

    by_load: bool
    by_moment: bool
    first: float
    second: float

    @classmethod
    def checked(
        cls, approach: float | None, load: float | None, tilt: float | None, moment: float | None
    ) -> _Prescription:
        if (approach is None) == (load is None):
            raise InputError("load", load, "be given where approach is not, and only there", "give load or approach")
        if tilt is not None and moment is not None:
            raise InputError("moment", moment, "not be given together with tilt", "give tilt or moment")
        if load is not None:
            positive("load", load, "give the force in N that presses the bodies together")
        if approach is not None:
            finite("approach", approach, "give the approach in mm")
        if moment is not None:
            finite("moment", moment, "give the moment in N mm")
        if tilt is not None:
            finite("tilt", tilt, "give the tilt in rad")
        first = load if load is not None else approach
        second = moment if moment is not None else (tilt or 0.0)
        assert first is not None
        return cls(load is not None, moment is not None, float(first), float(second))

    def problem(self, contact: Contact, element: Element) -> Problem:
        factor = contact.compliance
        target = np.array([
            self.first * (factor if self.by_load else 1.0),
            self.second * (factor if self.by_moment else 1.0),
        ])  # fmt: skip
        prescribed = np.array([self.by_load, self.by_moment])
        return half_space_problem(contact.separation, contact.curvature, element, prescribed, target)


@dataclass(frozen=True)
class _Pair:
    """The state on the grid of the result, and one on about half as many strips if that could be had."""

    fine: State
    coarse: State | None


def _solved_pair(contact: Contact, problem: Problem, strips: int | str | ArrayLike | None) -> _Pair:
    if strips is None or (isinstance(strips, str) and strips == "auto"):
        return _automatic(contact, problem)
    if isinstance(strips, (int, np.integer)) and not isinstance(strips, bool):
        return _equal(contact, problem, int(strips))
    if isinstance(strips, (list, tuple, np.ndarray)):
        return _given(contact, problem, np.asarray(strips, dtype=float))
    raise InputError("strips", strips, "be 'auto', a whole number or edges", "leave it out for an automatic grid")


def _equal(contact: Contact, problem: Problem, count: int) -> _Pair:
    """Solve on equal strips, from the coarsest level up."""
    if not FEWEST_STRIPS <= count <= MOST_STRIPS:
        remedy = "leave it out for an automatic grid"
        raise InputError("strips", count, f"lie between {FEWEST_STRIPS} and {MOST_STRIPS}", remedy)
    low, high = _region(contact, problem)
    return _raised_levels(problem, [uniform(low, high, level) for level in _levels(count)])


def _given(contact: Contact, problem: Problem, edges: Array) -> _Pair:
    """Solve on the user's own strips."""
    low, high = contact.interval
    remedy = "give ascending strip edges in mm within the bodies"
    if edges.ndim != 1 or not FEWEST_STRIPS < edges.size <= MOST_STRIPS + 1:
        raise InputError("strips", edges.shape, f"be a row of {FEWEST_STRIPS + 1} edges at least", remedy)
    if not np.all(np.isfinite(edges)) or np.any(np.diff(edges) <= 0.0):
        raise InputError("strips", edges.tolist(), "ascend and be finite", remedy)
    if edges[0] < low or edges[-1] > high:
        raise InputError("strips", (float(edges[0]), float(edges[-1])), f"lie between {low} and {high}", remedy)
    levels = [edges]
    while len(levels) < 2 or levels[-1].size // 2 > COARSEST_LEVEL:
        levels.append(np.unique(np.concatenate([levels[-1][:-1:2], edges[-1:]])))
    return _raised_levels(problem, levels)


def _levels(count: int) -> list[int]:
    """Return numbers of strips, each half the one before."""
    counts = [count, max(count // 2, 2)]
    while counts[-1] // 2 >= COARSEST_LEVEL:
        counts.append(counts[-1] // 2)
    return counts


def _raised_levels(problem: Problem, levels: list[Array]) -> _Pair:
    """Solve on the finest level first named, each level starting from the next coarser one.

    On strips that are wide against the half-width the loop converges from springs; on narrow ones it wants a
    start that has the shape of the contact, which the coarser level gives it.
    """
    finest = levels[0]
    _refuse_infeasible(problem, finest)
    coarse: State | None = None
    for edges in reversed(levels[1:]):
        if _feasible(problem, edges):
            state = settle(problem, edges, coarse, patient=False)
            coarse = state if state.converged else None
    return _Pair(settle(problem, finest, coarse), coarse)


def _automatic(contact: Contact, problem: Problem) -> _Pair:
    """Solve on a graded grid: find the contact on equal strips, learn its features, then solve on half and all."""
    state = _located(contact, problem, *_region(contact, problem))
    coarse: State | None = None
    wanted: Sizes | None = None
    for learn, share in ((True, ROUGH_SHARE), (True, 0.5), (False, 1.0)):
        if not state.converged:
            break
        if learn or wanted is None:
            wanted = sizes(problem, state, contact.bends)
        coarse, state = state, _settled(problem, wanted, state, share)
    return _Pair(state, coarse)


def _settled(problem: Problem, wanted: Sizes, near: State, share: float) -> State:
    """Return the solution on a graded grid, or on a slightly coarser one where that has none.

    Where a blunt contact ends just at the edge of a strip, that strip can be unable to bear load (its neighbours
    alone curve the surface more than the bodies do) and yet be overlapped without it. The next grid has its edges
    elsewhere.
    """
    limit = STRIP_LIMIT if len(wanted.contact) == 1 else 2 * STRIP_LIMIT
    low, high = float(near.edges[0]), float(near.edges[-1])
    state = near
    for fewer in FEWER_STRIPS:
        edges = graded(wanted, low, high, limit, fewer * share)
        state = settle(problem, edges, near, patient=fewer == FEWER_STRIPS[-1])
        if state.converged:
            break
    return state


def _located(contact: Contact, problem: Problem, low: float, high: float) -> State:
    """Return a solution on equal strips of a region that the contact fills well."""
    bodies = contact.interval
    if not problem.prescribed[0]:
        low, high = _neighbourhood(problem, low, high)
    edges = uniform(low, high, COARSE_STRIPS)
    _refuse_infeasible(problem, edges)
    state = settle(problem, edges)
    for _ in range(40):
        if not state.converged:
            break
        ends = ends_of_contact(state)
        first, last = ends[0][0], ends[-1][1]
        span = last - first
        low, high = float(state.edges[0]), float(state.edges[-1])
        cut = (state.m[0] > 0.0 and low > bodies[0]) or (state.m[-1] > 0.0 and high < bodies[1])
        if not cut and span > WELL_FILLED * (high - low):
            break
        margin = max(0.3 * span, 2.0 * float(np.min(state.width))) * (4.0 if cut else 1.0)
        edges = uniform(max(first - margin, bodies[0]), min(last + margin, bodies[1]), COARSE_STRIPS)
        state = settle(problem, edges)
    return state


def _neighbourhood(problem: Problem, low: float, high: float) -> tuple[float, float]:
    """Return where the bodies overlap at a prescribed approach, and a margin: it may be a speck of the interval."""
    for _ in range(3):
        fine = sprung(problem, uniform(low, high, FINE_STRIPS))
        touching = np.flatnonzero(fine.m > 0.0)
        margin = float(high - low) / FINE_STRIPS
        if touching.size:
            first, last = float(fine.edges[touching[0]]), float(fine.edges[touching[-1] + 1])
            margin += 0.3 * (last - first)
            return max(low, first - margin), min(high, last + margin)
        nearest = float(fine.y[np.argmax(fine.rigid[0] + fine.rigid[1] * fine.y - problem.separation(fine.y))])
        low, high = max(low, nearest - 2.0 * margin), min(high, nearest + 2.0 * margin)
    return low, high


def _region(contact: Contact, problem: Problem) -> tuple[float, float]:
    """Return the interval on which to look for the contact; finite even where the bodies are unbounded."""
    low, high = contact.interval
    if math.isfinite(low) and math.isfinite(high):
        return low, high
    scale = 1.0 / float(np.max(contact.curvature(np.zeros(1))))
    edge = np.concatenate([[0.0], scale * np.geomspace(1e-5, 1e4, 160)])
    edges = np.unique(np.clip(np.concatenate([-edge[::-1], edge]), low, high))
    touching = np.flatnonzero(sprung(problem, edges).m > 0.0)
    if touching.size == 0:
        _refuse_no_contact(problem, edges)
    first, last = touching[0], touching[-1] + 1
    if (first == 0 and not math.isfinite(low)) or (last == edges.size - 1 and not math.isfinite(high)):
        remedy = "give one of the bodies a length, or a profile that falls away"
        raise InputError("length", None, "be given where nothing else ends the contact", remedy)
    reach = 0.5 * float(edges[last] - edges[first])
    return max(low, float(edges[first]) - reach), min(high, float(edges[last]) + reach)


def _feasible(problem: Problem, edges: Array) -> bool:
    try:
        _refuse_infeasible(problem, edges)
    except InputError:
        return False
    return True


def _refuse_infeasible(problem: Problem, edges: Array) -> None:
    """Refuse a prescription that no loads on these strips can meet."""
    y = 0.5 * (edges[1:] + edges[:-1])
    separation = problem.separation(y)
    usable = y[np.isfinite(separation)]
    if usable.size == 0:
        remedy = "take relief away or lengthen the logarithm"
        raise InputError("profile", math.inf, "leave a finite separation somewhere on the bodies", remedy)
    by_load, by_moment = problem.prescribed
    first, second = problem.target
    if by_load and by_moment:
        arm = second / first
        if not usable[0] <= arm <= usable[-1]:
            condition = f"keep moment / load between {usable[0]:.6g} and {usable[-1]:.6g} mm"
            raise InputError("moment", f"{arm:.6g} mm x load", condition, "reduce the moment or add strips")
    elif by_moment:
        if (second > 0.0 and usable[-1] <= 0.0) or (second < 0.0 and usable[0] >= 0.0):
            raise InputError("moment", "of this sign", "come from strips on that side", "turn its sign")
        if second == 0.0 and not np.any(sprung(problem, edges).m > 0.0):
            raise InputError(
                "approach", float(first), "make the bodies touch at the tilt of zero moment", "raise it, or give a tilt"
            )
    elif not by_load and not np.any(first + second * y - separation > 0.0):
        _refuse_no_contact(problem, edges)


def _refuse_no_contact(problem: Problem, edges: Array) -> None:
    """Say why no strip touches at the prescribed approach: too few strips, or bodies too far apart."""
    fine = sprung(problem, uniform(float(edges[0]), float(edges[-1]), FINE_STRIPS))
    if np.any(fine.m > 0.0):
        remedy = "take more strips, or leave it out for an automatic grid"
        raise InputError("strips", edges.size - 1, "put the centre of a strip into the contact", remedy)
    tilt = 0.0 if problem.prescribed[1] else problem.target[1]
    needed = round(float(np.min(problem.separation(fine.y) - tilt * fine.y)), 12)
    raise InputError(
        "approach",
        float(problem.target[0]),
        f"exceed {needed:.6g} mm, where the bodies begin to touch",
        "raise it, or prescribe the load",
    )


def _solution(contact: Contact, element: Element, pair: _Pair) -> Solution:
    state, compliance = pair.fine, contact.compliance
    estimate = _error_estimate(pair)
    solution = Solution(
        contact=contact,
        element=element,
        status=_STATUS[state.status],
        approach=float(state.rigid[0]),
        tilt=float(state.rigid[1]),
        load=state.load / compliance,
        moment=state.moment / compliance,
        stiffness=state.stiffness / compliance,
        edges=state.edges.copy(),
        line_load=state.r * state.m / compliance,
        element_half_width=np.sqrt(state.m),
        gap=state.gap,
        contact_y=tuple(ends_of_contact(state)),
        iterations=state.steps,
        error_estimate=estimate,
        warnings=(),
    )
    if not state.converged:
        return solution
    return replace(solution, warnings=(*_strains(solution), *_sharp_ends(contact, state)))


def _error_estimate(pair: _Pair) -> ErrorEstimate:
    """Compare the result with that on half the strips; the difference bounds an error that at least halves."""
    fine, coarse = pair.fine, pair.coarse
    if coarse is None or not (fine.converged and coarse.converged):
        return ErrorEstimate(math.inf, math.inf, math.inf)
    singular = reaches(fine, -1) or reaches(fine, 1)
    summit, coarse_summit = float(np.max(fine.pressure)), float(np.max(coarse.pressure))
    return ErrorEstimate(
        approach=float(abs(coarse.rigid[0] / fine.rigid[0] - 1.0)) if fine.rigid[0] != 0.0 else math.inf,
        load=abs(coarse.load / fine.load - 1.0),
        max_pressure=math.inf if singular else abs(coarse_summit / summit - 1.0),
    )


def _strains(solution: Solution) -> tuple[str, ...]:
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
    return tuple(sentences)


def _sharp_ends(contact: Contact, state: State) -> tuple[str, ...]:
    """Return a sentence for every sharp end that the contact reaches."""
    sentences = []
    for side, place in ((-1, state.edges[0]), (1, state.edges[-1])):
        if reaches(state, side) and place in contact.interval:
            width = state.width[0 if side < 0 else -1]
            sentences.append(
                f"The contact reaches the sharp end at y = {place:.6g} mm, where the pressure of a half-space is "
                f"singular: the value there is that of a strip {width:.3g} mm wide, not a limit."
            )
    return tuple(sentences)
