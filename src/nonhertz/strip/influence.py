"""From strip loads to displacement on the centre line, per unit of compliance: the description of bodies for the core.

The effect of a strip at a point is the difference of an element's functions between its two edges; its images act in
the same way from their own positions. The core adds up *terms* (`nonhertz.bodies.influence`) of any origin; distant
ones are added up once per grid. The displacement at depth is linear in the loads and independent of the half-widths,
so it is computed once per grid, as a matrix that the loop subtracts.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nonhertz.bodies.influence import Influence
from nonhertz.native import core
from nonhertz.strip.element import Element
from nonhertz.strip.free_end import face_table

Array = NDArray[np.float64]


def kernel_of(influence: Influence, element: Element) -> core.Kernel:
    """Return the influence of strips for the core."""
    terms = [core.Term(*term) for term in influence.terms.tolist()]
    faces = [
        core.Face(face.y, face.side, face.share, face_table(element, face.poisson)) for face in influence.faces
    ]  # fmt: skip
    return core.Kernel(element.core, terms, faces)


def displacements(influence: Influence, y: Array, edges: Array, r: Array, m: Array, element: Element) -> Array:
    """Return the displacement per unit of compliance at several places ``y``, relative to the points at depth."""
    at_depth: Array = influence.at_depth(y, edges) @ (r * m)
    by_width = influence.by_width(0.5 * (edges[1:] + edges[:-1]), element.hertz_ratio)
    nothing = np.zeros(m.size)
    grid = core.Grid(edges, nothing, nothing, nothing, nothing, np.zeros((0, 0)), by_width)
    return core.displacements(y, grid, r, m, kernel_of(influence, element)) - at_depth
