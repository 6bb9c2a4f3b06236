"""Limits of a solution on a plane grid: its discretisation error, and strains of the model."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import mm
from nonhertz.bodies.influence import Influence
from nonhertz.bodies.shape import HERTZ
from nonhertz.findings import Finding, finding
from nonhertz.model.contact import sharper_curvature
from nonhertz.patch.between import Unseen
from nonhertz.patch.cascade import GridLevel, Outcome, PatchProblem
from nonhertz.patch.features import Dent, Waviness
from nonhertz.patch.grid import Grid, widest_run
from nonhertz.patch.nearness import Overlap
from nonhertz.patch.solution import PatchSolution
from nonhertz.result.checks import check_curvature, image_weights, small_strains, thick
from nonhertz.result.edges import EdgeKind, SingularEnd
from nonhertz.result.maximum import largest_pressure, singular_y
from nonhertz.result.penetration import is_noticeable
from nonhertz.result.status import ErrorEstimate, Status

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

FEWEST_CELLS = 6.0  # per feature, below which a warning is given
# Factors on the last change, for approach and load and for the maximum pressure: calibrated on random contacts
# (tests/campaign/test_patch_estimate.py); with 1.5 for all, one approach in 25 exceeded its estimate.
MARGIN, PRESSURE_MARGIN = 3.0, 1.5
LONGEST_AT_END = 0.8  # half-widths: longer cells at a singular end allow no interpolation
LEAST_CELLS = 2.0  # per feature: with fewer the maximum pressure is arbitrary
STEEPEST = 1.5  # d ln(load) / d ln(displacement) of a paraboloid
ROUGH, ROUGH_PRESSURE = 0.05, 0.2  # estimated relative errors above which a warning is given
UNSEEN = 0.01  # of the largest displacement: an overlap between cell centres above which a warning is given


def error_estimate(
    solution: PatchSolution,
    problem: PatchProblem,
    outcome: Outcome,
    levels: tuple[GridLevel, ...],
    unseen: Unseen,
    largest: float,
) -> ErrorEstimate:
    """Return the estimated error of the finest grid, from the last refinements and the gap between its cells.

    It was at least as large as the true error in 99 % of random cases, and twelve times as large in the median.

    ``levels`` are grids that double the cells in both directions (`cascade.halved`), ``largest`` is the largest
    displacement [mm]. Infinite if there is no coarser grid, since fewer than 8 cells are not halved; and for a singular
    pressure: at the edge of a body, where the region cuts the contact, over a feature of less than two cells, or
    next to a singular end on cells longer than the half-width there.
    """
    if solution.status is not Status.CONVERGED or len(levels) < 2:
        return ErrorEstimate(*[math.inf] * 5)
    by_load, by_moment = problem.prescribed.by_force
    before_touch = solution.approach - solution.penetration
    reach = 0.5 * (outcome.grid.y_span[1] - outcome.grid.y_span[0])
    states = [(level.approach, level.load, level.moment, level.tilt) for level in levels]
    approach, load, moment, tilt = np.array(states).T
    singular = singular_y(solution)
    highest = np.array([largest_pressure(*level.along, singular)[0] for level in levels])
    of_pressure = max(_change(highest, PRESSURE_MARGIN), _share(unseen.pressure, solution.max_pressure))
    of_approach = max(_change(approach - before_touch), _share(unseen.lift, solution.penetration))
    of_load = max(_change(load), STEEPEST * _share(unseen.lift, largest))
    return ErrorEstimate(
        approach=of_approach if by_load else 0.0,
        load=0.0 if by_load else of_load,
        max_pressure=math.inf if _is_unlimited(solution, problem, outcome.grid) else of_pressure,
        moment=0.0 if by_moment else _change(moment, whole=float(load[-1]) * reach),
        tilt=_change(reach * tilt, whole=solution.penetration) if by_moment else 0.0,
    )


def _is_unlimited(solution: PatchSolution, problem: PatchProblem, grid: Grid) -> bool:
    """Return whether the maximum pressure is singular, or arbitrary on these cells."""
    lost = any(size < LEAST_CELLS * side for _, size, side in _sizes(problem.gap.features, solution.dx, solution.dy))
    cut = bool(_cut_off(solution, grid) or _edges_of_bodies(solution))
    return lost or cut or any(_too_long(solution, end) for end in solution.singular_ends)


def _share(error: float, whole: float) -> float:
    return error / abs(whole) if whole != 0.0 else math.inf if error > 0.0 else 0.0


def _change(values: Array, margin: float = MARGIN, whole: float | None = None) -> float:
    """Return the last change, or half the one before if larger, relative to ``whole`` or else the last value.

    Two changes are used because one may be small by chance.

    At a sharp end errors fall in proportion to the cell size, so the last change is the error itself, which the margin
    covers. At smooth ends they fall faster.
    """
    changes = np.abs(np.diff(values))[::-1] * (1.0, 0.5)[: values.size - 1]
    whole = abs(float(values[-1]) if whole is None else whole)
    return margin * float(np.max(changes)) / whole if whole != 0.0 else 0.0


def strains(solution: PatchSolution, influence: Influence, grid: Grid) -> tuple[Finding, ...]:
    """Return a finding for every way in which the result exceeds the model's validity."""
    touching, contact = solution.footprint.any(axis=0), solution.contact
    checks = [*image_weights(influence.ends)]
    if touching.any():
        y, half_width = solution.y[touching], 0.5 * solution.dx * widest_run(solution.footprint)[touching]
        mean = solution.load / (float(solution.footprint.sum()) * solution.dx * solution.dy)
        ratio = float(np.max(half_width * sharper_curvature(contact, y)))
        checks += [check_curvature(ratio), small_strains(contact, mean), *thick(contact, HERTZ, y, half_width)]
    return (*_cut_off(solution, grid), *(finding for check in checks for finding in check.findings))


def overlaps(beyond: Overlap | None, between: Unseen, largest: float) -> Iterator[Finding]:
    """Yield findings on overlaps beyond the region and between cell centres.

    ``largest`` is the largest displacement [mm].
    """

    def overlapping(code: str, words: str, depth: float, at: Overlap | Unseen) -> Finding:
        return finding(code, words, overlap=mm(depth), x=mm(at.x), y=mm(at.y))

    if beyond is not None:
        words = (
            "The bodies overlap by {overlap:.3g} outside the region, at x = {x:.4g}, y = {y:.4g}: a contact there is "
            "left out; give a larger region, and enough cells for it."
        )
        yield overlapping("overlap-beyond-the-region", words, beyond.depth, beyond)
    if between.overlap > UNSEEN * largest:
        words = (
            "The bodies overlap by {overlap:.3g} between cell centres, at x = {x:.4g}, y = {y:.4g}: these cells miss a "
            "peak of the gap or a small contact there; give more cells."
        )
        yield overlapping("overlap-between-cells", words, between.overlap, between)


def uncertain(solution: PatchSolution, largest: float) -> Iterator[Finding]:
    """Yield a finding for each large estimated error, or one that no error can be estimated.

    ``largest`` is the largest displacement [mm], to which an error of the approach is relative.
    """
    error = solution.error_estimate
    if math.isinf(error.approach):
        yield finding(
            "unknown-error",
            "The grid of {across} x {along} cells is too coarse to estimate the error of its solution: the numbers may "
            "be far off; give at least 8 cells in each direction.",
            across=solution.cells[0],
            along=solution.cells[1],
        )
        return
    approached = "penetration" if is_noticeable(solution.approach, solution.penetration) else "approach"
    stated = (
        (approached, error.approach, error.approach * solution.penetration, ROUGH * largest),
        ("load", error.load, error.load, ROUGH),
        ("maximum pressure", error.max_pressure, error.max_pressure, ROUGH_PRESSURE),
    )
    for name, share, size, most in stated:
        if most < size < math.inf:
            yield finding(
                "uncertain",
                "The estimated error of the {quantity} is {error:.2g} of its value; give more cells.",
                quantity=name,
                error=share,
            )


def find_unresolved(features: Iterable[object], dx: float, dy: float) -> Iterator[Finding]:
    """Yield a finding for every feature that spans only a few cells."""
    for name, size, side in _sizes(features, dx, dy):
        if size < FEWEST_CELLS * side:
            yield finding(
                "unresolved-feature",
                "The {feature} of {size:.3g} is only {cells:.1f} cells long, fewer than {fewest:g}: the pressure "
                "there is not resolved; give more cells, or a smaller region.",
                feature=name,
                size=mm(size),
                cells=size / side,
                fewest=FEWEST_CELLS,
            )


def _sizes(features: Iterable[object], dx: float, dy: float) -> Iterator[tuple[str, float, float]]:
    """Yield name and size [mm] of the parts of features, and the cell side in their direction."""
    for feature in features:
        if isinstance(feature, Dent):
            yield "diameter of a dent", float(feature.diameter), max(dx, dy)
            if feature.shoulder > 0.0:
                ring = 0.5 * (float(feature.shoulder_diameter or 0.0) - float(feature.diameter))
                yield "shoulder of a dent", ring, max(dx, dy)
        elif isinstance(feature, Waviness) and feature.amplitude > 0.0:
            # The relevant number is that of waves per cell, in the direction with more of them.
            side = max(abs(math.cos(feature.angle)) * dx, abs(math.sin(feature.angle)) * dy)
            yield "wavelength", float(feature.wavelength), side


def _cut_off(solution: PatchSolution, grid: Grid) -> list[Finding]:
    """Return a finding for each border of the region that cuts the contact where the bodies continue."""
    ends = zip("xxyy", np.ravel([grid.x_span, grid.y_span]), np.ravel(grid.cut(solution.footprint)), strict=True)
    return [
        finding(
            "cut-off",
            "The region ends at {axis} = {end:.6g} while the contact continues: the pressure there is that of "
            "truncated bodies; give a larger region, or leave it out.",
            axis=axis,
            end=mm(end),
        )
        for axis, end, cut in ends
        if cut
    ]


def _too_long(solution: PatchSolution, end: SingularEnd) -> bool:
    """Return whether the cells at a singular end are about as long as the half-width, too long to show the rise."""
    touching = np.flatnonzero(solution.half_width > 0.0)
    nearest = touching[np.abs(solution.y[touching] - end.y).argmin()]
    return bool(solution.dy > LONGEST_AT_END * solution.half_width[nearest])


def singularities(solution: PatchSolution) -> tuple[Finding, ...]:
    """Return findings on singular ends and on edges of bodies in the gap."""
    reached = {
        EdgeKind.SINGULAR: ("sharp-end", "reaches the sharp end"),
        EdgeKind.CORNER: ("corner-end", "ends at a corner of the profile"),
    }
    taken = "taken more than a half-width from it."
    beside = "that of the row next to it, since cells are about as long as the half-width; give more cells along."
    ends = tuple(
        finding(
            reached[end.kind][0],
            f"The contact {reached[end.kind][1]} at y = {{y:.6g}}, where the pressure is singular. The value there is "
            "that of a cell {length:.3g} long, not a limit, and the maximum pressure is "
            f"{beside if _too_long(solution, end) else taken}",
            y=mm(end.y),
            length=mm(solution.dy),
        )
        for end in solution.singular_ends
    )
    return (*ends, *_edges_of_bodies(solution))


def _edges_of_bodies(solution: PatchSolution) -> list[Finding]:
    """Return a finding if the contact reaches cells without a body, at the maximum pressure beside them."""
    without = np.pad(np.isposinf(solution.gap), 1)
    beside = without[2:, 1:-1] | without[:-2, 1:-1] | without[1:-1, 2:] | without[1:-1, :-2]
    pressure = np.where(beside, solution.pressure, 0.0)
    if not pressure.any():
        return []
    i, j = np.unravel_index(int(pressure.argmax()), pressure.shape)
    return [
        finding(
            "edge-of-a-body",
            "The contact reaches the edge of a body at x = {x:.6g}, y = {y:.6g}, beyond which the gap is infinite and "
            "where the pressure is singular. The values there are those of cells {cells:.3g} in size, not a limit.",
            x=mm(solution.x[i]),
            y=mm(solution.y[j]),
            cells=mm(solution.dx, solution.dy, between=" x "),
        )
    ]
