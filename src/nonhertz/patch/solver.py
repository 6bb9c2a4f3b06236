"""The entry point: a contact, or any gap, and its loading in, a solution on a plane grid out."""

from __future__ import annotations

import math
from collections.abc import Iterable
from concurrent.futures import Executor, ThreadPoolExecutor
from contextlib import AbstractContextManager, nullcontext
from dataclasses import replace

import numpy as np

from nonhertz.bodies.shape import HERTZ
from nonhertz.errors import ConvergenceError, InputError
from nonhertz.findings import warn
from nonhertz.inputs.checks import number_that, numbers, whole
from nonhertz.model.contact import Contact
from nonhertz.model.prescription import Prescription
from nonhertz.model.profile.base import at_ends
from nonhertz.patch import nearness
from nonhertz.patch.between import find_unseen_overlap
from nonhertz.patch.cascade import Outcome, PatchProblem, solve_on, solve_on_half
from nonhertz.patch.grid import Grid, Span, widest_run
from nonhertz.patch.limits import (
    error_estimate,
    find_unresolved,
    overlaps,
    singularities,
    strains,
    uncertain,
)
from nonhertz.patch.nearness import Overlap, Window
from nonhertz.patch.resources import check_cells, refuse_excess
from nonhertz.patch.search import Search
from nonhertz.patch.solution import PatchSolution
from nonhertz.patch.surface import Feature, Surface, refuse_no_bodies
from nonhertz.patch.verdict import find_complaint
from nonhertz.result.checks import LEAST_OF_ALL, refuse_thin_bodies
from nonhertz.result.status import ErrorEstimate, Status

CELLS = (128, 512)
WORTH_THREADS = 2**16  # cells: below this, distributing blocks costs more than it saves
ACROSS = 129  # samples of a given region

_residual = number_that(lambda tolerance: 1e-12 <= tolerance <= 1e-2, "lie between 1e-12 and 0.01")
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
    features: Feature | Iterable[Feature] = (),
    gap: Feature | None = None,
    tolerance: float = 1e-8,
    threads: int | None = None,
) -> PatchSolution:
    """Solve a contact on a plane grid, which resolves the surfaces across the contact as well as along.

    Parameters
    ----------
    contact : Contact
        The two bodies: materials, side faces and depths; also the gap, unless ``gap`` is given.
    approach : float, optional
        delta [mm]: how far the bodies move together on the line y = 0. Give this or ``load``.
    load : float, optional
        Q [N], positive. Give this or ``approach``.
    tilt : float, optional
        gamma [rad] about x; the interference is approach + tilt y - gap. Zero if neither this nor ``moment`` is
        given. The bodies cannot rotate about y.
    moment : float, optional
        T [N mm], integral of pressure times y.
    cells : tuple of int, optional
        Number of cells (across, along), at least 4 each; (128, 512) if left out.
    region : tuple of two pairs of float, optional
        ((x_low, x_high), (y_low, y_high)) [mm] covered by the cells, cut off where a body ends. Found automatically if
        left out.
    features : callable or several
        Each (x, y) [mm] -> relief [mm], for broadcastable arrays, added to the gap; see `nonhertz.patch.features`.
    gap : callable, optional
        (x, y) [mm] -> undeformed gap [mm], in place of x^2 / (2 rho(y)) + h(y).
    tolerance : float
        Largest residual, from 1e-12 to 1e-2: the largest gap in contact or overlap elsewhere, over the largest
        elastic displacement. Load and moment are met to rounding.
    threads : int, optional
        Threads for the transforms, one if left out: for many contacts, a process each makes better use of the cores.
        The result does not depend on it.

    Returns
    -------
    PatchSolution

    Raises
    ------
    InputError
        If the input is invalid, or the solve needs more memory than is available.
    ConvergenceError
        If the iterations fail, or if their result breaks a condition when it is checked again from the returned
        arrays alone; its ``solution`` holds the state reached.

    Warns
    -----
    AccuracyWarning
        If the result strains the model's validity; ``solution.findings`` has the details.

    Notes
    -----
    Uniform pressure in each cell, half-space displacements with the corrections of `nonhertz.bodies`, no friction.
    Nothing is assumed about the shape of the pressure. See docs/explain/patch.md.

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
    >>> dented = solve(contact, load=6e3, cells=(48, 96), features=[Dent(depth=0.002, diameter=1.5)])
    >>> dented.max_pressure > 1.05 * smooth.max_pressure
    True
    """
    refuse_no_bodies(contact)
    prescription = Prescription(approach=approach, load=load, tilt=tilt, moment=moment)
    prescription.refuse_outside(contact)
    cells = check_cells(CELLS if cells is None else cells)
    _residual("tolerance", tolerance, "give the largest residual, such as 1e-8")
    spans = None if region is None else _check_region(contact, region)
    refuse_excess(cells, contact)
    surface = Surface.checked(contact, gap, features)
    problem = PatchProblem(surface, prescription)
    search = Search(problem)
    with _pool(threads, cells) as pool:
        if spans is None:
            outcome, overlap = search.found(cells, tolerance, pool)
        else:
            outcome, overlap = _in_region(search, Grid(*spans, cells, contact.interval), tolerance, pool)
        levels = solve_on_half(problem, outcome, tolerance, pool)
    solution = _solution(problem, contact, outcome)
    half_width = 0.5 * solution.dx * widest_run(solution.footprint)
    refuse_thin_bodies(contact, HERTZ, solution.y, half_width, LEAST_OF_ALL, prescription.pressed)
    broken = find_complaint(solution, surface, prescription, tolerance)
    if solution.status is not Status.CONVERGED:
        raise ConvergenceError(_describe_failure(solution, broken, tolerance), solution)
    if not solution.footprint.any():
        condition = "put the centre of a cell inside the contact"
        raise InputError("cells", cells, condition, "give more cells, or leave the region out")
    if broken:
        raise ConvergenceError(_withheld_words(broken), replace(solution, status=Status.REFUTED))
    unseen, largest = (
        find_unseen_overlap(solution, surface),
        outcome.largest_displacement(surface(*outcome.grid.centres)),
    )
    estimate = error_estimate(solution, problem, outcome, levels, unseen, largest)
    solution = replace(solution, error_estimate=estimate)
    findings = (
        *strains(solution, problem.influence, outcome.grid),
        *overlaps(overlap, unseen, largest),
        *uncertain(solution, largest),
        *find_unresolved(surface.features, solution.dx, solution.dy),
    )
    warn(findings)
    rolls_on = surface.changes_across(*outcome.grid.centres)
    return replace(solution, findings=(*findings, *singularities(solution)), rolls_on=rolls_on)


def _in_region(search: Search, grid: Grid, tolerance: float, pool: Executor | None) -> tuple[Outcome, Overlap | None]:
    """Solve in a given region, and return the overlap that it leaves out."""
    if search.prescribed.load is None:
        within = Window(np.linspace(*grid.x_span, ACROSS), np.linspace(*grid.y_span, nearness.ALONG))
        search.refuse_apart((within,))
    outcome = solve_on(search.problem, grid, tolerance, pool)
    # A contact that is cut off continues beyond the region; the warning about the border says so.
    if np.any(grid.cut(outcome.state.pressure > 0.0)):
        return outcome, None
    return outcome, nearness.find_overlap(
        search.problem, outcome, search.windows(grid), smooth=search.own_gap, region_given=True
    )


def _describe_failure(solution: PatchSolution, broken: str, tolerance: float) -> str:
    """Return the message for a failed solve: the residual reached, and likely causes."""
    stiff = "a moment carried by only one or two rows of cells, or a gap that is rough from cell to cell"
    missed = solution.residual > tolerance
    lacking = f"The residual is {solution.residual:.2g}, not {tolerance:g}" if missed else broken.rstrip(".")
    return (
        f"{solution.status.value} {lacking}; likely causes are {stiff}. Try another number of cells, or another region."
    )


def _withheld_words(broken: str) -> str:
    """Return the message for a solution that failed the final check."""
    return (
        f"The iterations ended, but a separate check of their solution failed, so it is withheld. {broken} Likely "
        "causes are a gap that returns different values when called again, or numbers too far apart in size. Try "
        "another tolerance, another number of cells, or another region."
    )


def _solution(problem: PatchProblem, contact: Contact, outcome: Outcome) -> PatchSolution:
    """Return the result of the iterations, without an error estimate yet."""
    grid, state = outcome.grid, outcome.state
    pressure = state.pressure / contact.compliance
    area = grid.dx * grid.dy
    line_load = pressure.sum(axis=0)
    return PatchSolution(
        contact=contact,
        status=state.status,
        approach=state.rigid[0],
        penetration=nearness.penetration(problem.gap, grid, *state.rigid),
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
        error_estimate=ErrorEstimate(*[math.inf] * 5),
        findings=(),
    )


def _check_region(contact: Contact, region: tuple[Span, Span]) -> tuple[Span, Span]:
    ends = numbers("region", region, _REGION_REMEDY)
    if ends.shape != (2, 2):
        raise InputError("region", region, "be two pairs of ends", _REGION_REMEDY)
    (x_low, x_high), (y_low, y_high) = ends.tolist()
    low, high = np.clip(at_ends((y_low, y_high), contact.interval), *contact.interval).tolist()
    if not (x_low < x_high and low < high):
        raise InputError("region", region, "ascend in both directions and overlap both bodies", _REGION_REMEDY)
    return (x_low, x_high), (low, high)


def _pool(threads: int | None, cells: tuple[int, int]) -> AbstractContextManager[Executor | None]:
    if threads is None:
        return nullcontext()
    threads = whole("threads", threads, 1, math.inf, "give the number of threads, or leave it out for one")
    if threads == 1 or cells[0] * cells[1] < WORTH_THREADS:
        return nullcontext()
    return ThreadPoolExecutor(threads)
