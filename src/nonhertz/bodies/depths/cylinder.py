"""``"cylinder"``: a solid cylinder of infinite length, in place of a depth."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from nonhertz.bodies import endless_cylinder
from nonhertz.bodies.depths.diameter import Diameter
from nonhertz.errors import InputError

if TYPE_CHECKING:
    from nonhertz.bodies.images import Images
    from nonhertz.bodies.solid import Shape, Solid

Array = NDArray[np.float64]


class Cylinder(Diameter):
    """Displacement against the axis of an endless solid cylinder, pressed alike on two opposite sides.

    Notes
    -----
    A uniform load compresses it as in plane strain, and by what the cylinder is free to grow longer. Side faces can be
    mirrored: that is the model of Chiu and Hartnett with mirrored ends. Of a body with free faces it is 22 % off the
    compression, because what these add far away knows no girth: `Finite` is for those.

    References
    ----------
    Y. P. Chiu and M. J. Hartnett, A numerical solution for the contact problem involving bodies with cylindrical
    surface considering cylinder effect, Journal of Tribology 109 (1987) 479-485, doi:10.1115/1.3261480.
    """

    word = "cylinder"
    meaning = "on the axis of a cylinder of infinite length that deforms as a whole"
    place = "its axis, and it deforms as a solid cylinder of infinite length, pressed alike on the opposite side"

    def refuse(self, body: Solid) -> None:
        """Refuse free side faces."""
        if any(body.free_faces):
            remedy = "write depth = 'finite', or side_faces = 'mirror'"
            raise InputError("depth", self.word, "not be used for a body with free side faces", remedy)

    def reference(self, body: Solid, shape: Shape, images: Images) -> AxisOfCylinder:
        """Return by how much less the surface moves than that of a flat body."""
        return AxisOfCylinder(self.below(body, shape), body.material.poisson, images.with_direct())


@dataclass(frozen=True)
class AxisOfCylinder:
    """What the displacement of an endless cylinder is less than that of a flat body.

    Attributes
    ----------
    below : callable
        y [mm] -> the diameter [mm].
    poisson : float
        Poisson's ratio.
    terms : ndarray, shape (terms, 3)
        Rows (sign, offset, weight) as for the surface, for this body alone; weights include its share of the
        compliance. Images of a series that are further away move nothing.
    """

    below: Callable[[Array], Array]
    poisson: float
    terms: Array

    def displacement(self, y: Array, edges: Array) -> Array:
        """Return it under ``y`` per unit of K q of each strip, shape (..., places, strips)."""
        radius = 0.5 * self.below(y.ravel()).reshape(y.shape)[..., None]
        found = np.zeros((*y.shape, edges.shape[-1] - 1))
        for sign, offset, weight in self.terms:
            distance = (sign * edges[..., None, :] + offset - y[..., None]) / radius
            found -= sign * weight * np.diff(endless_cylinder.displacement(distance, self.poisson), axis=-1)
        return found
