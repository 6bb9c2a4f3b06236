"""The verb: a contact, or any gap, and what is prescribed in, a solution on a plane grid out."""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable, Sequence
from concurrent.futures import Executor, ThreadPoolExecutor
from contextlib import AbstractContextManager, nullcontext
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.errors import AccuracyWarning, ConvergenceError, InputError
from nonhertz.finite import HERTZ, influence_of
from nonhertz.model.checks import finite, positive
from nonhertz.model.contact import Contact
from nonhertz.model.prescription import Prescription
from nonhertz.patch import region as regions
from nonhertz.patch.cascade import Gap, Outcome, Problem, solve_on
from nonhertz.patch.grid import Grid
from nonhertz.patch.limits import error_estimate, singularities, strains
from nonhertz.patch.resources import refuse_excess
from nonhertz.patch.solution import PatchSolution
from nonhertz.solution import Status

Array = NDArray[np.float64]
Feature = Callable[[Array, Array], ArrayLike]
Span = tuple[float, float]

CELLS = (128, 512)
FEWEST_CELLS = 4
TIGHTEST, LOOSEST = 1e-12, 1e-2
WORTH_THREADS = 2**16  # cells: below, handing out blocks costs more than it saves
SNAP = 1e-9  # of the length of a region
MOST_ENLARGEMENTS, ENLARGEMENT = 6, 0.15

_REGION_REMEDY = "give ((x_low, x_high), (y_low, y_high)) in mm, or leave it out"


def solve(
    contact: Contact,
    *,
    approach: float | None = None,
    load: float | None = None,
    tilt: float | None = None,
    moment: float | None = None,
    cells: tuple[int, int] | None = None,
    region: tuple[Span, Span] | None = None,
    features: Sequence[Feature] = (),
    gap: Feature | None = None,
    tolerance: float = 1e-8,
    threads: int | None = None,
) -> PatchSolution:
    """Press the bodies of a contact together, their surfaces resolved across the contact as well as along.

    Parameters
    ----------
    contact : Contact
        The two bodies: materials, side faces and depths; also the gap, unless ``gap`` is given.
    approach : float, optional
        delta [mm]: how much nearer the bodies come on the line y = 0. Give this or ``load``.
    load : float, optional
        Q [N], positive. Give this or ``approach``.
    tilt : float, optional
        gamma [rad] about x; the interference is approach + tilt y - gap. Zero if neither this nor ``moment`` is
        given. About y the bodies are held upright.
    moment : float, optional
        T [N mm], integral of pressure times y.
    cells : tuple of int, optional
        Number of cells (across, along), 4 at least; (128, 512) if left out.
    region : tuple of two pairs of float, optional
        ((x_low, x_high), (y_low, y_high)) [mm] to lay the cells over, cut off where a body ends. Found by itself if
        left out.
    features : sequence of callable
        Each (x, y) [mm] -> relief [mm] of broadcastable arrays, added to the gap; see `nonhertz.patch.features`.
    gap : callable, optional
        (x, y) [mm] -> undeformed gap [mm], in place of x^2 / (2 rho(y)) + h(y).
    tolerance : float
        Largest residual, from 1e-12 to 1e-2: the largest gap in contact or overlap elsewhere, over the largest
        elastic displacement. Load and moment are met to rounding.
    threads : int, optional
        Threads for the transforms, one if left out: where many contacts are to be solved, a process each is the better
        use of cores. The result does not depend on it.

    Returns
    -------
    PatchSolution

    Raises
    ------
    InputError
        If the input cannot be solved as it stands, or not in the memory at hand.
    ConvergenceError
        If the iterations fail; its ``solution`` holds the state reached.

    Warns
    -----
    AccuracyWarning
        If the result strains the model's validity; the sentences are in ``solution.warnings`` too.

    Notes
    -----
    Uniform pressure in each cell, half-space displacements with the corrections of `nonhertz.finite`, no friction.
    Nothing is assumed of the shape of the pressure. See docs/explain/patch.md.

    References
    ----------
    J. M. de Mul, J. J. Kalker and B. Fredriksson, The contact between arbitrarily curved bodies of finite dimensions,
    Journal of Tribology 108 (1986) 140-148, doi:10.1115/1.3261134.

    Examples
    --------
    >>> from nonhertz.model.body import Plate, Roller
    >>> from nonhertz.model.profile import crown
    >>> from nonhertz.patch.features import Dent
    >>> contact = Contact(Roller(diameter=20, length=20, profile=crown(radius=4000)), Plate())
    >>> smooth = solve(contact, load=6e3, cells=(48, 96))
    >>> dented = solve(contact, load=6e3, cells=(48, 96), features=[Dent(depth=0.002, diameter=0.3)])
    >>> dented.max_pressure > 1.05 * smooth.max_pressure
    True
    """
    if not isinstance(contact, Contact):
        raise InputError("contact", contact, "be a Contact", "make one of two bodies with nonhertz.Contact")
    prescription = Prescription.checked(approach, load, tilt, moment)
    prescription.refuse_outside(contact)
    cells = _checked_cells(CELLS if cells is None else cells)
    finite("tolerance", tolerance, "give the largest residual, 1e-8 say")
    if not TIGHTEST <= tolerance <= LOOSEST:
        raise InputError("tolerance", tolerance, f"lie between {TIGHTEST:g} and {LOOSEST:g}", "use 1e-8")
    spans = None if region is None else _checked_region(contact, region)
    refuse_excess(cells, contact)
    problem = _problem(contact, prescription, _whole_gap(contact, gap, features))
    with _pool(threads, cells) as pool:
        if spans is None:
            outcome = _in_found_region(problem, contact, prescription, cells, tolerance, pool)
        else:
            outcome = solve_on(problem, Grid(*spans, cells), tolerance, pool)
    solution = _solution(contact, problem, outcome)
    if solution.status is not Status.CONVERGED:
        raise ConvergenceError(f"{solution.status.value} Try another number of cells, or another region.", solution)
    sentences = strains(solution, problem.influence, outcome.grid)
    for sentence in sentences:
        warnings.warn(sentence, AccuracyWarning, stacklevel=2)
    return replace(solution, warnings=(*sentences, *singularities(solution, problem.influence, outcome.grid)))


def undeformed_gap(contact: Contact, x: ArrayLike, y: ArrayLike) -> Array:
    """Return the gap x^2 / (2 rho(y)) + h(y) [mm] of the undeformed bodies.

    Parameters
    ----------
    contact : Contact
        The two bodies.
    x, y : array_like
        Positions [mm], broadcast against each other.

    Returns
    -------
    ndarray

    Examples
    --------
    >>> from nonhertz.model.body import Plate, Roller
    >>> undeformed_gap(Contact(Roller(diameter=20, length=20), Plate()), [0.0, 0.2], 5.0).round(6).tolist()
    [0.0, 0.002]
    """
    y = np.asarray(y, dtype=float)
    across: Array = 0.5 * np.asarray(x, dtype=float) ** 2 * contact.curvature(y) + contact.separation(y)
    return across


def _whole_gap(contact: Contact, gap: Feature | None, features: Sequence[Feature]) -> Gap:
    for name, each in (("gap", gap), *(("features", feature) for feature in features)):
        if not callable(each) and not (name == "gap" and each is None):
            raise InputError(name, each, "be callable with x and y", "give a function of x and y in mm that returns mm")

    def whole(x: Array, y: Array) -> Array:
        bare = undeformed_gap(contact, x, y) if gap is None else np.asarray(gap(x, y), dtype=float)
        return bare + sum((np.asarray(feature(x, y), dtype=float) for feature in features), np.zeros(()))

    return whole


def _problem(contact: Contact, given: Prescription, gap: Gap) -> Problem:
    factor = contact.compliance
    first = given.first * (factor if given.by_load else 1.0)
    second = given.second * (factor if given.by_moment else 1.0)
    influence = influence_of(contact, HERTZ)
    return Problem(gap, influence, (given.by_load, given.by_moment), (first, second))


def _in_found_region(
    problem: Problem,
    contact: Contact,
    given: Prescription,
    cells: tuple[int, int],
    tolerance: float,
    pool: Executor | None,
) -> Outcome:
    """Solve in a region that is found first, and made larger where a finer grid shows the contact to go on."""
    x_span, y_span = regions.find(problem, contact.interval, _half_width(contact, given))
    for _ in range(MOST_ENLARGEMENTS):
        outcome = solve_on(problem, Grid(x_span, y_span, cells), tolerance, pool)
        touching = outcome.state.pressure > 0.0
        across = regions.borders(x_span, np.any(touching, axis=1))
        along = regions.borders(y_span, np.any(touching, axis=0), contact.interval)
        if not any((*across, *along)):
            break
        x_span = regions.widened(x_span, across, ENLARGEMENT)
        y_span = regions.widened(y_span, along, ENLARGEMENT, contact.interval)
    return outcome


def _half_width(contact: Contact, given: Prescription) -> float:
    """Return a first guess of the half-width [mm], that of a Hertz line contact."""
    low, high = contact.interval
    middle = float(np.clip(0.0, low, high))
    radius = 1.0 / float(contact.curvature(np.array([middle]))[0])
    if not given.by_load:
        return math.sqrt(2.0 * radius * abs(given.first)) or 0.01 * radius
    if math.isfinite(high - low):
        return 2.0 * math.sqrt(contact.compliance * given.first / (high - low) * radius)
    return math.cbrt(contact.compliance * given.first * radius)


def _solution(contact: Contact, problem: Problem, outcome: Outcome) -> PatchSolution:
    grid, state = outcome.grid, outcome.state
    pressure = state.pressure / contact.compliance
    area = grid.dx * grid.dy
    line_load = pressure.sum(axis=0)
    return PatchSolution(
        contact=contact,
        status=state.status,
        approach=state.rigid[0],
        tilt=state.rigid[1],
        load=float(line_load.sum()) * area,
        moment=float(line_load @ grid.y) * area,
        x=grid.x,
        y=grid.y,
        dx=grid.dx,
        dy=grid.dy,
        pressure=pressure,
        gap=state.gap,
        iterations=outcome.convolutions,
        residual=state.residual,
        error_estimate=error_estimate(contact, problem, outcome),
        warnings=(),
    )


def _checked_cells(cells: tuple[int, int]) -> tuple[int, int]:
    remedy = "give two whole numbers, (128, 512) say"
    if not isinstance(cells, (tuple, list)) or len(cells) != 2:
        raise InputError("cells", cells, "be a pair (across, along)", remedy)
    for number in cells:
        if isinstance(number, bool) or not isinstance(number, (int, np.integer)) or number < FEWEST_CELLS:
            raise InputError("cells", cells, f"be whole numbers of at least {FEWEST_CELLS}", remedy)
    return int(cells[0]), int(cells[1])


def _checked_region(contact: Contact, region: tuple[Span, Span]) -> tuple[Span, Span]:
    try:
        (x_low, x_high), (y_low, y_high) = region
    except (TypeError, ValueError):
        raise InputError("region", region, "be two pairs of ends", _REGION_REMEDY) from None
    for end in (x_low, x_high, y_low, y_high):
        finite("region", end, _REGION_REMEDY)
    # An end that was worked out from cells is off by rounding, and would not be known for that of a body.
    near = SNAP * (float(y_high) - float(y_low))
    low, high = (float(end) for end in contact.interval)
    low, high = (low if y_low < low + near else float(y_low)), (high if y_high > high - near else float(y_high))
    if not (x_low < x_high and low < high):
        raise InputError("region", region, "ascend both ways and overlap with both bodies", _REGION_REMEDY)
    return (float(x_low), float(x_high)), (low, high)


def _pool(threads: int | None, cells: tuple[int, int]) -> AbstractContextManager[Executor | None]:
    if threads is None:
        return nullcontext()
    positive("threads", threads, "give the number of threads, or leave it out for one")
    if threads == 1 or cells[0] * cells[1] < WORTH_THREADS:
        return nullcontext()
    return ThreadPoolExecutor(int(threads))
