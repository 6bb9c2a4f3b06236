"""What a solution on a plane grid cannot say: its error of discretisation, and where the model is strained."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from nonhertz.finite import Influence
from nonhertz.model.contact import Contact
from nonhertz.patch import region as regions
from nonhertz.patch.cascade import Outcome, Problem
from nonhertz.patch.grid import Grid
from nonhertz.patch.solution import PatchSolution
from nonhertz.solution import ErrorEstimate, Status

Mask = NDArray[np.bool_]

FINITE = 0.999  # image weight from which on the pressure is finite up to an end
MOST_OF_RADIUS = 0.3
LEAST_DEPTH = 3.0  # half-widths
HEAVIEST = 1.0 + 1e-9
MARGIN = 1.5


def error_estimate(contact: Contact, problem: Problem, outcome: Outcome) -> ErrorEstimate:
    """Return how much the last refinements changed the results, as far as the finest grid may err at most.

    Infinite where there was no coarser grid, and for the pressure at a sharp end, which has no limit.
    """
    levels = outcome.levels[-3:]
    if outcome.state.status is not Status.CONVERGED or len(levels) < 2:
        return ErrorEstimate(math.inf, math.inf, math.inf)
    by_load = problem.by_force[0]
    rows: Mask = np.any(outcome.state.pressure > 0.0, axis=0)
    singular = bool(sharp_ends(contact, problem.influence, outcome.grid, rows))
    return ErrorEstimate(
        approach=_change([level.approach for level in levels]) if by_load else 0.0,
        load=0.0 if by_load else _change([level.load for level in levels]),
        max_pressure=math.inf if singular else _change([level.max_pressure for level in levels]),
    )


def _change(values: list[float]) -> float:
    """Return the last relative change, or half of the one before if that is more: one may be small by chance.

    At a sharp end errors fall in proportion to the cells, and then the last change is the error itself; the margin is
    for that. At smooth ends they fall faster.
    """
    changes = np.abs(np.diff(values))[::-1] * (1.0, 0.5)[: len(values) - 1]
    return MARGIN * float(np.max(changes)) / abs(values[-1]) if values[-1] != 0.0 else 0.0


def sharp_ends(contact: Contact, influence: Influence, grid: Grid, rows: Mask) -> list[float]:
    """Return where the contact reaches an end of a body at which side faces do not keep the pressure finite."""
    found = []
    for row, at, limit in ((0, grid.y_span[0], contact.interval[0]), (-1, grid.y_span[1], contact.interval[1])):
        if rows[row] and at == limit:
            mirrors = [end.image_weight for end in influence.ends if abs(end.y - at) < 0.5 * grid.dy]
            if sum(mirrors) < FINITE:
                found.append(at)
    return found


def strains(solution: PatchSolution, influence: Influence, grid: Grid) -> tuple[str, ...]:
    """Return a sentence for every way in which the result leaves the model's validity."""
    touching = solution.footprint.any(axis=0)
    sentences = [*_cut_off(solution, grid), *_heavy_images(influence)]
    if not touching.any():
        return tuple(sentences)
    y, half_width = solution.y[touching], solution.half_width[touching]
    sharpest = np.maximum(np.abs(solution.contact.a.curvature(y)), np.abs(solution.contact.b.curvature(y)))
    ratio = float(np.max(half_width * sharpest))
    if ratio > MOST_OF_RADIUS:
        sentences.append(
            f"The half-width is {ratio:.2f} of the smaller radius of curvature, over {MOST_OF_RADIUS}: half-spaces do "
            "not describe such a contact."
        )
    depth = float(np.min(influence.shallowest(y) / half_width))
    if depth < LEAST_DEPTH:
        sentences.append(
            f"The depth of a body is only {depth:.2f} half-widths, less than {LEAST_DEPTH:g}: it is so thin that "
            "neither half-spaces nor line loads describe it."
        )
    return tuple(sentences)


def _cut_off(solution: PatchSolution, grid: Grid) -> list[str]:
    """Return a sentence for each border of the region that cuts the contact where the bodies go on."""
    across = regions.borders(grid.x_span, np.any(solution.footprint, axis=1))
    along = regions.borders(grid.y_span, np.any(solution.footprint, axis=0), solution.contact.interval)
    places = [
        *zip("xx", grid.x_span, across, strict=True),
        *zip("yy", grid.y_span, along, strict=True),
    ]
    return [
        f"The region ends at {axis} = {end:.6g} mm while the contact goes on: the pressure there is that of bodies cut "
        "off; give a larger region, or leave it out."
        for axis, end, cut in places
        if cut
    ]


def _heavy_images(influence: Influence) -> list[str]:
    """Return a sentence for each place at which images had to weigh less than asked."""
    return [
        f"The images about the side face at y = {end.y:.6g} mm would weigh {end.wanted:.3g} of the surface, and above "
        "1 refinement leads nowhere: their weights were lowered until it is 1."
        for end in influence.ends
        if end.wanted > HEAVIEST
    ]


def singularities(solution: PatchSolution, influence: Influence, grid: Grid) -> tuple[str, ...]:
    """Return a sentence for every sharp end that the contact reaches."""
    return tuple(
        f"The contact reaches the sharp end at y = {y:.6g} mm, where the pressure is singular: the value there is that "
        f"of a cell {solution.dy:.3g} mm long, not a limit."
        for y in sharp_ends(solution.contact, influence, grid, np.any(solution.footprint, axis=0))
    )
