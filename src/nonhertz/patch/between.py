"""The gap between cell centres, which a solution on these cells cannot include.

The gap is evaluated again at sixteen points in every cell. Where it is smooth on the scale of cells, cubic
interpolation between cell centres predicts it there. Where it is smaller than predicted, the bodies overlap undetected
by the difference minus the clearance of the solution: a small contact or a pressure peak that these cells miss. Where
the bodies touch, the deviation either way, divided by the displacement per unit of pressure on such a part of a cell,
is the possible error of the pressure. A body smaller than a quarter of a cell may still lie between all points.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nonhertz.patch.grid import interpolation
from nonhertz.patch.kernel import edges_from, rectangles
from nonhertz.patch.solution import PatchSolution
from nonhertz.patch.surface import Gap
from nonhertz.patch.verdict import displacement

Array = NDArray[np.float64]

PARTS = 4  # per side of a cell
# Rows of cells at a time: a fraction of all, so that sixteen points per cell take less memory than the solve.
SHARE, FEWEST_ROWS, MOST_ROWS = 64, 4, 32
MOST_CANDIDATES = 60


@dataclass(frozen=True)
class Unseen:
    """Overlap between cell centres.

    Attributes
    ----------
    overlap : float
        Largest overlap between cell centres [mm], zero if there is none.
    x, y : float
        Its position [mm].
    pressure : float
        Possible increase of the maximum pressure [MPa].
    lift : float
        Approximate distance by which the bodies would have to move apart: the overlap averaged over the contact [mm].
    """

    overlap: float
    x: float
    y: float
    pressure: float
    lift: float


def find_unseen_overlap(solution: PatchSolution, gap: Gap) -> Unseen:
    """Return the overlap of the gap (x, y) [mm] -> [mm] between the cell centres of a solution."""
    undeformed = gap(solution.x[:, None], solution.y[None, :])
    whole = np.isfinite(undeformed)
    known, clearance = np.where(whole, undeformed, 0.0), np.where(whole, solution.gap, 0.0)
    parts = [centres_of_parts(np.arange(n, dtype=float), 1.0) for n in solution.cells]
    cubic = [interpolation(places, n, 4) for places, n in zip(parts, solution.cells, strict=True)]
    # Beyond the last centre the clearance keeps its last value.
    linear = [
        interpolation(np.clip(places, 0.0, n - 1.0), n, 2) for places, n in zip(parts, solution.cells, strict=True)
    ]
    x, y = (centres_of_parts(centres, side) for centres, side in ((solution.x, solution.dx), (solution.y, solution.dy)))
    from scipy import ndimage, sparse

    around = np.ones((3, 3))
    # A profile that falls away where the contact ends, as a logarithmic one does, does not raise the pressure there.
    inner = ndimage.binary_erosion(solution.footprint, around)
    near, holes = ndimage.binary_dilation(solution.footprint, around), sparse.csr_array(~whole, dtype=float)
    # For a part of a cell, not a whole cell: a peak may be that narrow, and then raises the pressure more.
    side = edges_from(0.0, 1, solution.dx / PARTS), edges_from(0.0, 1, solution.dy / PARTS)
    own = solution.contact.compliance * float(rectangles(*side)[0, 0])
    deepest, highest, lifted = (0.0, 0.0, 0.0), 0.0, 0.0
    candidates = []
    step = min(max(solution.cells[0] // SHARE, FEWEST_ROWS), MOST_ROWS)
    for start in range(0, solution.cells[0], step):
        cells = slice(start, min(start + step, solution.cells[0]))
        rows = slice(PARTS * start, PARTS * cells.stop)
        here = gap(x[rows, None], y[None, :])
        # Smooth and rough gaps cannot be distinguished where a node of the interpolation has no body.
        regular = (abs(cubic[0][rows]) @ holes @ abs(cubic[1]).T).toarray() == 0.0
        regular &= np.isfinite(here)
        nearer = np.subtract(cubic[0][rows] @ known @ cubic[1].T, here, out=np.zeros_like(here), where=regular)
        overlap = np.where(regular, nearer - linear[0][rows] @ clearance @ linear[1].T, 0.0)
        i, j = np.unravel_index(int(overlap.argmax()), overlap.shape)
        deepest = max(deepest, (float(overlap[i, j]), float(x[rows][i]), float(y[j])))
        unseen = np.maximum(_of_cells(overlap), 0.0)
        lifted += float(np.sum(unseen))
        # A hollow spreads its load over its rim, a peak carries its load alone.
        rough = np.where(inner[cells], _of_cells(np.maximum(nearer, -nearer / PARTS)), unseen)
        highest = max(highest, float(np.max(solution.pressure[cells] + rough / own)))
        # Bodies without a cell centre on them.
        lone = np.where(regular | np.kron(near[cells], np.ones((PARTS, PARTS), dtype=bool)), np.inf, here)
        depth = solution.approach + solution.tilt * y - lone
        deep, along = np.nonzero(depth > 0.0)
        places = start + deep // PARTS, along // PARTS, x[rows][deep], y[along]
        candidates.append(np.column_stack([depth[deep, along], *places]))
    missed = np.concatenate(candidates)
    missed = missed[np.argsort(-missed[:, 0])][:MOST_CANDIDATES]
    if missed.size:
        missed[:, 0] -= displacement(solution, missed[:, 1:3].astype(np.intp))
        overlap, _, _, *place = missed[missed[:, 0].argmax()].tolist()
        deepest, highest = max(deepest, (overlap, place[0], place[1])), max(highest, overlap / own)
        lifted += float(np.maximum(missed[:, 0], 0.0).sum())
    return Unseen(*deepest, highest - float(solution.pressure.max()), lifted / max(int(solution.footprint.sum()), 1))


def centres_of_parts(centres: Array, side: float) -> Array:
    """Return the centre of every part of the cells, ascending."""
    parts = (np.arange(PARTS) + 0.5) / PARTS - 0.5
    places: Array = (centres[:, None] + side * parts).ravel()
    return places


def _of_cells(parts: Array) -> Array:
    """Return the largest value among the parts of every cell."""
    nx, ny = parts.shape[0] // PARTS, parts.shape[1] // PARTS
    largest: Array = parts.reshape(nx, PARTS, ny, PARTS).max(axis=(1, 3))
    return largest
