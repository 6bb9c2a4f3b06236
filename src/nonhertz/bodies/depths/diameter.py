"""``"diameter"``: the point opposite the contact, at a depth of one diameter or a multiple of it."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from nonhertz.bodies.depths.depth import Depth
from nonhertz.errors import InputError

if TYPE_CHECKING:
    from nonhertz.bodies.solid import Shape, Solid

Array = NDArray[np.float64]


class Diameter(Depth):
    """Displacement against a point as many diameters below the surface as `diameters` says."""

    word = "diameter"
    meaning = "a diameter below the surface"
    of_diameter = True
    place = "a point its diameter below the surface"

    def diameters(self, body: Solid, shape: Shape) -> float:
        """Return depth / diameter."""
        return 1.0

    def below(self, body: Solid, shape: Shape) -> Callable[[Array], Array]:
        """Return y [mm] -> depth [mm].

        The returned function raises InputError where the body is not convex.
        """
        # A partial function rather than a nested one, so that its holder can be pickled.
        return partial(_in_diameters, body, self.word, self.diameters(body, shape))


def _in_diameters(body: Solid, word: str, diameters: float, y: Array) -> Array:
    curvature = body.curvature(y)
    if np.any(curvature <= 0.0):
        remedy = "give the thickness of the body in mm, or write 'none'"
        raise InputError("depth", word, "only be used for a body that is convex everywhere", remedy)
    depth: Array = 2.0 * diameters / curvature
    return depth
