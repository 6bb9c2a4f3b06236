"""The final check of a solution before it leaves the package: every condition again, from the returned arrays alone.

The check does not use the iterations. The undeformed gap is evaluated again on all cells, load and moment are summed
from the pressures, and the displacement at a sample of cells is a plain sum over all others, without Fourier
transforms, images and depth included: it shares only `kernel.rectangles`, which tests compare with closed forms, with
`convolution`. A wrong spectrum, a stale array or a set that did not converge is thus detected.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import mm, mpa, newton
from nonhertz.bodies.influence import influence_of
from nonhertz.bodies.shape import HERTZ
from nonhertz.model.prescription import Prescription
from nonhertz.patch.free_faces import free_ends
from nonhertz.patch.kernel import edges_from, rectangles
from nonhertz.patch.solution import PatchSolution
from nonhertz.patch.surface import Gap
from nonhertz.result.solved import not_finite

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]
Places = NDArray[np.intp]

TOUCHING, APART = 40, 20  # cells of each kind in the sample, in addition to the extreme ones
ROWS = 16  # distances at a time, few enough to keep the kernel's temporaries in the cache
# Rounding differences of sums over many cells in another order, relative to the largest displacement, and to load and
# moment.
ROUNDING, BALANCED = 1e-11, 1e-9
LAST_DIGITS = 32.0 * float(np.finfo(float).eps)  # of the undeformed gap, which may be far larger than the deformed one


def find_complaint(solution: PatchSolution, gap: Gap, prescription: Prescription, tolerance: float) -> str:
    """Return a sentence on the first condition that a solution breaks, empty if it meets all of them.

    Parameters
    ----------
    solution : PatchSolution
        The solution about to be returned.
    gap : callable
        x, y [mm] -> undeformed gap [mm].
    prescription : Prescription
        What was prescribed.
    tolerance : float
        Largest residual requested.
    """
    return next(_complaints(solution, gap, prescription, tolerance), "")


def _complaints(solution: PatchSolution, gap: Gap, prescription: Prescription, tolerance: float) -> Iterator[str]:
    # The order matters: each check relies on those before it.
    if not np.isfinite(solution.pressure).all():
        yield "The pressure of a cell is not a finite number."
    for name in not_finite(solution):
        yield f"The {name} is {getattr(solution, name)}, not a finite number."
    if not np.isfinite(solution.gap).all(where=solution.footprint) or np.isnan(solution.gap).any():
        yield "The gap of a cell is not a number."
    if (lowest := float(solution.pressure.min())) < 0.0:
        yield f"A cell is in tension, {mpa(-lowest):.3g}."
    yield from _find_unbalanced(solution, prescription, max(tolerance, BALANCED))
    yield from _open_or_overlapping(solution, gap(solution.x[:, None], solution.y[None, :]), tolerance)


def _find_unbalanced(solution: PatchSolution, prescription: Prescription, allowed: float) -> Iterator[str]:
    """Yield complaints on load, approach, moment or tilt that differ from the prescribed value or the sum of cells."""
    area, line = solution.dx * solution.dy, solution.pressure.sum(axis=0)
    load, moment, levers = area * line.sum(), area * (line @ solution.y), area * (line @ np.abs(solution.y))
    pairs = []
    if prescription.approach is not None:
        pairs.append(("approach", "mm", solution.approach, prescription.approach, 0.0))
    if prescription.load is not None:
        pairs.append(("load", "N", load, prescription.load, allowed * prescription.load))
    if prescription.moment is None:
        pairs.append(("tilt", "rad", solution.tilt, prescription.tilt or 0.0, 0.0))
    else:
        pairs.append(("moment", "N mm", moment, prescription.moment, allowed * max(levers, abs(prescription.moment))))
    pairs += [
        ("load", "N", solution.load, load, BALANCED * load),
        ("moment", "N mm", solution.moment, moment, BALANCED * levers),
    ]
    for name, unit, value, required, room in pairs:
        if not abs(value - required) <= room:
            yield f"The {name} came to {value:.10g} {unit} instead of {required:.10g} {unit}."


def _open_or_overlapping(solution: PatchSolution, undeformed: Array, tolerance: float) -> Iterator[str]:
    """Yield complaints on cells under pressure that are apart, others that overlap, and a gap unlike the pressure's."""
    bearing = np.isfinite(undeformed)
    outside = solution.footprint & ~bearing
    if outside.any():
        borne = float(solution.pressure[outside].sum()) * solution.dx * solution.dy
        yield f"Cells without a body, where the gap is infinite, carry {newton(borne):.3g}."
    rigid = solution.approach + solution.tilt * solution.y
    displaced = np.subtract(solution.gap, undeformed, out=np.zeros_like(undeformed), where=bearing)
    displaced += rigid * bearing
    largest = float(np.max(np.abs(displaced)))
    digits = LAST_DIGITS * float(np.max(np.abs(undeformed[bearing]), initial=0.0) + np.max(np.abs(rigid)))
    allowed = (tolerance + ROUNDING) * largest + digits
    if (apart := float(np.max(np.abs(solution.gap[solution.footprint]), initial=0.0))) > allowed:
        yield f"Cells under pressure are apart or overlap by {mm(apart):.3g}."
    if (overlap := -float(np.min(solution.gap[bearing], initial=0.0))) > allowed:
        yield f"Cells without pressure overlap by {mm(overlap):.3g}."
    places = _sample(solution, bearing)
    gap = undeformed[tuple(places.T)] - rigid[places[:, 1]] + displacement(solution, places)
    if (wrong := float(np.max(np.abs(gap - solution.gap[tuple(places.T)]), initial=0.0))) > allowed:
        differs = f"a sum over all cells differs by {mm(wrong):.3g}"
        yield f"The gap is not that of the bodies under these pressures: {differs}."


def _sample(solution: PatchSolution, bearing: Mask) -> Places:
    """Return the indices of cells to examine, shape (places, 2): the extreme ones, and some spread over the rest."""
    pressure, gap = solution.pressure.ravel(), solution.gap.ravel()
    touching, apart = np.flatnonzero(pressure), np.flatnonzero(bearing.ravel() & (pressure == 0.0))
    chosen = [_evenly(touching, TOUCHING), _evenly(apart, APART)]
    if touching.size:
        chosen.append(touching[[pressure[touching].argmax(), np.abs(gap[touching]).argmax()]])
    if apart.size:
        chosen.append(apart[[gap[apart].argmin()]])
    return np.stack(np.unravel_index(np.unique(np.concatenate(chosen)), solution.pressure.shape), axis=1)


def _evenly(cells: Places, most: int) -> Places:
    return cells[np.unique(np.linspace(0, cells.size - 1, min(most, cells.size)).astype(np.intp))]


def displacement(solution: PatchSolution, places: Places) -> Array:
    """Return the displacement [mm] of both surfaces together at the centres of some cells, by plain sums.

    Parameters
    ----------
    solution : PatchSolution
        The solution with the pressures.
    places : ndarray, shape (places, 2)
        Indices across and along.

    Returns
    -------
    ndarray, shape (places,)
    """
    influence, pressure, total = influence_of(solution.contact, HERTZ), solution.pressure, np.zeros(places.shape[0])
    (nx, ny), dx, dy = pressure.shape, solution.dx, solution.dy
    away = [np.abs(np.arange(nx) - i) for i in places[:, 0]]
    blocks = [edges_from(start * dx, min(ROWS, nx - start), dx) for start in range(0, nx, ROWS)]
    for sign, offset, weight in influence.terms.tolist():
        # The pressure in column l is j - l cells away if shifted, j + l cells if mirrored about the first row.
        first = -(ny - 1) * dy if sign > 0.0 else 2.0 * float(solution.y[0])
        along = edges_from(first - offset, 2 * ny - 1, dy)
        kernel = np.concatenate([rectangles(across, along) for across in blocks])
        for place, j in enumerate(places[:, 1].tolist()):
            seen = kernel[away[place], j : j + ny]
            total[place] += weight * np.vdot(seen[:, ::-1] if sign > 0.0 else seen, pressure)
    for end in free_ends(influence.faces, solution.y, dy):
        loads = end.gathered(pressure)
        kernel = np.concatenate([end.kernel(across) for across in blocks])
        for place, j in enumerate(places[:, 1].tolist()):
            total[place] += np.vdot((end.weights[j] @ kernel)[away[place]], loads)
    if influence.references:
        edges = np.append(solution.y - 0.5 * dy, solution.y[-1] + 0.5 * dy)
        rows, which = np.unique(places[:, 1], return_inverse=True)
        total -= (influence.at_depth(solution.y[rows], edges) @ solution.line_load)[which]
    return solution.contact.compliance * total
