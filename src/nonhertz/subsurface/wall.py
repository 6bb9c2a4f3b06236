"""The stress in a hollow roller of a solution: stress of both contacts, and bending of the wall between them.

The opposite side of the roller has the same load, so a point in the lower half is evaluated from there; the other
contact is then so far away that point loads represent its strips. See `nonhertz.bodies.wall_stress` for the bending.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

from nonhertz.bodies.wall_stress import OPPOSITE, TOP, bending_of
from nonhertz.model.body import Body
from nonhertz.native import core
from nonhertz.result.solved import Solved
from nonhertz.subsurface.extent import Extent
from nonhertz.subsurface.free_faces import FreeFaceField

Array = NDArray[np.float64]

_NODES = 2  # of Gauss's rule on a strip, for the distant contact
_NODES_OF_MODES = 8  # and for its projection on polynomials


@dataclass(frozen=True, eq=False)
class Wall:
    """A hollow roller under the pressure of a solution.

    Attributes
    ----------
    extent : Extent
        Its material.
    in_core : core.Wall
        Chebyshev coefficients of the polar stress of each mode [MPa]; positions [mm] and forces [N] of the point loads
        that represent a contact seen from the opposite side.
    faces : tuple of FreeFaceField
        Corrections for free side faces to the field of one contact.
    """

    extent: Extent
    in_core: core.Wall
    faces: tuple[FreeFaceField, ...]

    @classmethod
    def of(
        cls, solution: Solved, body: Body, extent: Extent, images: Array, faces: tuple[FreeFaceField, ...]
    ) -> Wall | None:
        """Return the wall of a body; None if it has no bore, or one with steps.

        ``images`` are rows (sign, offset, weight) of the pressure and its images.
        """
        geometry = bending_of(body)
        if geometry is None:
            return None
        (bending, radius), middle = geometry, body.position
        pressed = solution.line_load > 0.0
        low, high, line_load = solution.edges[:-1][pressed], solution.edges[1:][pressed], solution.line_load[pressed]
        y, width = _on_strips(low, high, _NODES_OF_MODES)
        shares = _spread(bending.waves, solution.extent_across[1][pressed] / extent.radii(0.5 * (low + high))[0])
        on_strips = np.sum(width[..., None] * bending.polynomials((y - middle) / radius), axis=1) / radius
        modes = bending.stress((shares * line_load / radius) @ on_strips)
        y, width = _on_strips(low, high, _NODES)
        places, forces = y.ravel(), (line_load[:, None] * width).ravel()
        seen = np.concatenate([sign * places + offset for sign, offset, _ in images])
        forces = np.concatenate([weight * forces for _, _, weight in images])

        def of_faces(points: Array) -> Array:
            return sum((face.stress(radius * points + [0.0, middle, 0.0]) for face in faces), np.zeros(6))

        return cls(extent, core.Wall(modes - bending.of_field(of_faces), TOP, seen, forces), faces)

    def stress(self, points: Array, near: Callable[[Array], Array]) -> Array:
        """Return the stress [MPa] at ``points`` (n, 3), shape (n, 6), given that of the contact itself."""
        outer, inner = self.extent.radii(points[:, 1])
        lower = points[:, 2] > outer
        opposite = np.column_stack([-points[:, 0], points[:, 1], 2.0 * outer - points[:, 2]])
        seen, opposite = np.where(lower[:, None], opposite, points), np.where(lower[:, None], points, opposite)
        total = near(seen)
        for face in self.faces:
            total += OPPOSITE * face.stress(opposite)
        low, high = self.extent.body.faces
        along = (2.0 * seen[:, 1] - low - high) / (high - low)
        self.in_core.add(seen, along, outer, inner, self.extent.body.material.poisson, total)
        total[lower] *= OPPOSITE
        return total


def _on_strips(low: Array, high: Array, count: int) -> tuple[Array, Array]:
    """Return Gauss's points on strips, and their weights, shape (strips, count)."""
    node, weight = legendre.leggauss(count)
    half = 0.5 * (high - low)[:, None]
    return low[:, None] + half * (1.0 + node), half * weight


def _spread(waves: Array, half_width: Array) -> Array:
    """Return each mode of a semi-ellipse of a half-width [radii] over that of a line load, shape (waves, strips)."""
    from scipy import special

    turns = np.maximum(waves[:, None] * half_width, 1e-9)
    factor: Array = 2.0 * special.j1(turns) / turns
    return factor
