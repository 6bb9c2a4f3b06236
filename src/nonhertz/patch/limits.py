"""What a solution on a plane grid cannot say: its error of discretisation, and where the model is strained."""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from nonhertz.errors import InputError
from nonhertz.finite import HERTZ, Influence, depth_below
from nonhertz.model.body import Body
from nonhertz.model.contact import Contact
from nonhertz.patch import region as regions
from nonhertz.patch.cascade import Level, Outcome, Problem
from nonhertz.patch.features import Dent, Waviness
from nonhertz.patch.grid import Grid
from nonhertz.patch.nearness import Overlap
from nonhertz.patch.solution import PatchSolution
from nonhertz.solution import ErrorEstimate, Status

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

FINITE = 0.999  # image weight from which on the pressure is finite up to an end
MOST_OF_RADIUS = 0.3
LEAST_DEPTH, LEAST_OF_ALL = 3.0, 1.0  # half-widths: warned of below the first, refused below the second
FEWEST_CELLS = 6.0  # that a feature is to be long
HEAVIEST = 1.0 + 1e-9
MARGIN = 1.5


def error_estimate(contact: Contact, problem: Problem, outcome: Outcome, levels: tuple[Level, ...]) -> ErrorEstimate:
    """Return how much the last refinements changed the results, as far as the finest grid may err at most.

    ``levels`` are grids that double the cells in both directions (`cascade.halved`). Infinite where there is no coarser
    one, fewer than 8 cells having no half, and for the pressure at a sharp end, which has no limit.
    """
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
    y, half_width = solution.y[touching], 0.5 * solution.dx * widest_run(solution.footprint)[touching]
    sharpest = np.maximum(np.abs(solution.contact.a.curvature(y)), np.abs(solution.contact.b.curvature(y)))
    ratio = float(np.max(half_width * sharpest))
    if ratio > MOST_OF_RADIUS:
        sentences.append(
            f"The half-width is {ratio:.2f} of the smaller radius of curvature, over {MOST_OF_RADIUS}: half-spaces do "
            "not describe such a contact."
        )
    sentences.extend(
        f"The depth of body {name} is only {ratio:.2f} half-widths, less than {LEAST_DEPTH:g}: the body is so thin "
        "that neither half-spaces nor line loads describe it."
        for name, _, ratio in _depths(solution.contact, y, half_width)
        if ratio < LEAST_DEPTH
    )
    return tuple(sentences)


def widest_run(footprint: Mask) -> Array:
    """Return the number of cells in the widest piece of the contact at every station, shape (ny,)."""
    run: Array = np.zeros(footprint.shape[1])
    widest = run.copy()
    for row in footprint:
        run = (run + 1.0) * row
        np.maximum(widest, run, out=widest)
    return widest


def refuse_thin_bodies(contact: Contact, y: Array, half_width: Array) -> None:
    """Refuse a depth so small that the points at depth move as much as the surface.

    Raises
    ------
    InputError
    """
    widest = float(np.max(half_width))
    for name, body, ratio in _depths(contact, y, half_width):
        if ratio < LEAST_OF_ALL:
            shown = ratio * widest if isinstance(body.depth, str) else body.depth
            condition = f"be large against the half-width of the contact, about {widest:.2g} mm"
            remedy = "give the thickness of the body, or 'none'"
            raise InputError("depth", shown, condition, remedy).within(f"body.{name}")


def _depths(contact: Contact, y: Array, half_width: Array) -> list[tuple[str, Body, float]]:
    """Return name, body and least depth in half-widths of each body that has a depth."""
    touching = half_width > 0.0
    found = []
    for name, body in (("a", contact.a), ("b", contact.b)):
        below = depth_below(body, HERTZ)
        if below is not None and np.any(touching):
            found.append((name, body, float(np.min(below(y[touching]) / half_width[touching]))))
    return found


def overlaps(overlap: Overlap | None) -> tuple[str, ...]:
    """Return a sentence where the bodies overlap beyond the region."""
    if overlap is None:
        return ()
    return (
        f"Beyond the region the bodies overlap, by {overlap.depth:.3g} mm at x = {overlap.x:.4g}, y = {overlap.y:.4g} "
        "mm: they touch there too, which is left out; give a larger region, and cells enough for it.",
    )


def unresolved(features: Iterable[object], dx: float, dy: float) -> tuple[str, ...]:
    """Return a sentence for every feature that a few cells only are to show."""
    sentences = []
    for feature in features:
        for name, size, sides in _sizes(feature, dx, dy):
            if size < FEWEST_CELLS * sides:
                sentences.append(
                    f"The {name} of {size:.3g} mm is only {size / sides:.1f} cells long, fewer than {FEWEST_CELLS:g}: "
                    "the pressure there is a matter of chance; give more cells, or a smaller region."
                )
    return tuple(sentences)


def _sizes(feature: object, dx: float, dy: float) -> list[tuple[str, float, float]]:
    """Return name and size [mm] of what a feature is made of, and the side of a cell in its direction."""
    if isinstance(feature, Dent):
        sizes = [("diameter of a dent", float(feature.diameter), max(dx, dy))]
        if feature.shoulder > 0.0:
            ring = 0.5 * (float(feature.shoulder_diameter or 0.0) - float(feature.diameter))
            sizes.append(("shoulder of a dent", ring, max(dx, dy)))
        return sizes
    if isinstance(feature, Waviness) and feature.amplitude > 0.0:
        # Waves per cell are what counts, and they come from both directions.
        across, along = abs(math.cos(feature.angle)) * dx, abs(math.sin(feature.angle)) * dy
        return [("wavelength", float(feature.wavelength), max(across, along))]
    return []


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
