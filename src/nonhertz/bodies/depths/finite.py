"""``"finite"``: the roller itself, whole, in place of a depth."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from numbers import Real
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from nonhertz.bodies.depths.depth import Depth
from nonhertz.bodies.whole_roller import LONGEST, SHORTEST, WholeRoller, whole_roller
from nonhertz.errors import InputError

if TYPE_CHECKING:
    from nonhertz.bodies.images import Images
    from nonhertz.bodies.solid import Shape, Solid

Array = NDArray[np.float64]


class Finite(Depth):
    """Displacement against the roller's axis, of a solid cylinder with free ends, pressed alike on two opposite sides.

    Notes
    -----
    Against spectral finite elements of a roller as long as its diameter: 0.2 % of the compression under a uniform load,
    0.1 % of the compliance against tilting, 0.4 % of the peak under a load of half a millimetre. Corners and profile
    are neglected, and the load on the opposite side is taken to be the same.
    """

    word = "finite"
    meaning = "on the axis of a roller that deforms as a whole, which needs side_faces = 'free' and a length"
    place = "its axis, and it deforms as a whole: a solid cylinder, pressed alike on the opposite side"
    of_diameter = True

    def refuse(self, body: Solid) -> None:
        """Refuse a body that is not a solid cylinder with free ends."""
        if isinstance(body.diameter, bool) or not isinstance(body.diameter, Real):
            raise InputError("depth", self.word, "only be used for a body of one diameter", "write 'plane-strain'")
        if body.length is None or not all(body.free_faces):
            remedy = "write side_faces = 'free', or depth = 'plane-strain'"
            raise InputError("depth", self.word, "only be used for a body with two free side faces", remedy)
        if body.images != 1:
            raise InputError("images", body.images, "be 1 where depth = 'finite', which has them all", "leave it out")
        slenderness = body.length / float(body.diameter)
        if not SHORTEST <= slenderness <= LONGEST:
            condition = f"only be used for a length of {SHORTEST:g} to {LONGEST:g} diameters, not {slenderness:.3g}"
            raise InputError("depth", self.word, condition, "write 'plane-strain'")

    def below(self, body: Solid, shape: Shape) -> Callable[[Array], Array]:
        """Return the diameter: half-widths must be small compared with it."""
        return partial(_everywhere, 2.0 / float(body.curvature(np.zeros(1))[0]))

    def reference(self, body: Solid, shape: Shape, images: Images) -> AxisOfRoller:
        """Return by how much less the surface moves than that of a flat body with free ends."""
        assert body.length is not None
        radius = 1.0 / float(body.curvature(np.zeros(1))[0])
        middle = 0.5 * (body.faces[0] + body.faces[1])
        whole = whole_roller(0.5 * body.length / radius, body.material.poisson)
        return AxisOfRoller(self.below(body, shape), whole, radius, middle, images.share)


def _everywhere(value: float, y: Array) -> Array:
    return np.full(y.shape, value)


@dataclass(frozen=True)
class AxisOfRoller:
    """What the displacement of a whole roller is less than that of a flat body with free ends.

    Attributes
    ----------
    below : callable
        y [mm] -> the diameter [mm].
    whole : WholeRoller
        The difference, for a radius of 1.
    radius, middle : float
        Radius, and axial position of the middle [mm].
    share : float
        Share of the body in the compliance of the contact.
    """

    below: Callable[[Array], Array]
    whole: WholeRoller
    radius: float
    middle: float
    share: float

    def displacement(self, y: Array, edges: Array) -> Array:
        """Return it under ``y`` per unit of K q of each strip, shape (..., places, strips)."""
        places, ends = ((each - self.middle) / self.radius for each in (y, edges))
        return -self.share * self.whole.displacement(places, ends)
