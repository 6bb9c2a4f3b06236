"""``"finite"``: the roller itself, whole, with its bore if it has one, in place of a depth."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import mm
from nonhertz.bodies.depths.depth import Depth
from nonhertz.bodies.outline import Outline
from nonhertz.bodies.wall_stress import WallModes, wall_modes
from nonhertz.bodies.whole_roller import LONGEST, SHORTEST, WholeRoller, whole_roller
from nonhertz.errors import InputError

if TYPE_CHECKING:
    from nonhertz.bodies.images import Images
    from nonhertz.bodies.solid import Shape, Solid

Array = NDArray[np.float64]


_REMEDY = "write 'plane-strain'"
_THINNEST, _STEEPEST = 0.08, 0.28  # wall over radius, and slope of the surface
_SAMPLES = 33  # of a diameter that is a function
_DIGITS = 12


class Finite(Depth):
    """Displacement against the axis of a roller with free ends, pressed alike on two opposite sides.

    The roller is solid or has a bore, and its diameter may vary along the axis, as that of a tapered roller does.

    Notes
    -----
    Against spectral finite elements of a roller as long as its diameter: 0.15 % of the compression under a uniform
    load, of the compliance against tilting, and of the peak under a load of half a millimetre. Profile and rounded
    corners are neglected, and the load on the opposite side is taken to be the same. Where the diameter varies, y runs
    along the surface, diameters are those in the plane normal to it, and the load is normal to it; side faces are
    square to the axis. Up to a half-angle of 15 degrees the displacement under a strip at an end is within 0.7 % of
    finite elements. The sum of the load's axial part is left to a rib or the raceways. The bending of a wall is in its
    stress, but for bores with steps.
    """

    word = "finite"
    meaning = "on the axis of a roller that deforms as a whole, which needs side_faces = 'free' and a length"
    place = "its axis, and it deforms as a whole, pressed alike on the opposite side"
    of_diameter = True
    bored = True

    def refuse(self, body: Solid) -> None:
        """Refuse a body that is no roller with free ends."""
        if body.length is None or not all(body.free_faces):
            remedy = "write side_faces = 'free', or depth = 'plane-strain'"
            raise InputError("depth", self.word, "only be used for a body with two free side faces", remedy)
        if body.images != 1:
            raise InputError("images", body.images, "be 1 where depth = 'finite', which has them all", "leave it out")
        outline, radius = outline_of(body)
        slenderness = outline.half_length
        if not SHORTEST <= slenderness <= LONGEST:
            condition = f"only be used for a length of {SHORTEST:g} to {LONGEST:g} diameters, not {slenderness:.3g}"
            raise InputError("depth", self.word, condition, _REMEDY)
        if outline.steepest > _STEEPEST:
            condition = f"only be used where the radius changes by less than {_STEEPEST:g} of the way along the axis"
            raise InputError("depth", self.word, condition, _REMEDY)
        if outline.wall < _THINNEST:
            condition = f"leave a wall of {_THINNEST:g} times the radius at least, not {mm(outline.wall * radius):.3g}"
            raise InputError("bore", body.bore, condition, "reduce the bore")

    def corner_angles(self, body: Solid) -> tuple[float, float]:
        """Return those of side faces that are square to the axis, of a surface that may not be along it."""
        return outline_of(body)[0].corner_angles if callable(body.diameter) else super().corner_angles(body)

    def below(self, body: Solid, shape: Shape) -> Callable[[Array], Array]:
        """Return the diameter, or the wall: half-widths must be small compared with it."""
        outline, radius = outline_of(body)
        return partial(_everywhere, radius * (outline.wall if outline.bored else 2.0))

    def reference(self, body: Solid, shape: Shape, images: Images) -> AxisOfRoller:
        """Return by how much less the surface moves than that of a flat body with free ends."""
        outline, radius = outline_of(body)
        whole = whole_roller(outline, body.material.poisson)
        return AxisOfRoller(self.below(body, shape), whole, radius, _middle(body), images.share)


def whole(body: Solid) -> bool:
    """Return whether a body can deform as a whole."""
    try:
        Finite().refuse(body)
    except InputError as error:
        return error.field == "bore"  # whose own sentence says what is wrong
    return True


def bending_of(body: Solid) -> tuple[WallModes, float, float] | None:
    """Return the modes of the stress in a hollow roller, the radius that is their unit, and its middle [mm].

    None if it is not hollow, or if its bore has steps, for which modes are not known.
    """
    if body.bore is None:
        return None
    outline, radius = outline_of(body)
    if outline.kinks or min(outline.inner) <= 0.0:
        return None
    return wall_modes(outline, body.material.poisson), radius, _middle(body)


def _middle(body: Solid) -> float:
    return 0.5 * (body.faces[0] + body.faces[1])


def outline_of(body: Solid) -> tuple[Outline, float]:
    """Return the outline of a roller, and the radius of its surface in the middle [mm], which is its unit."""
    assert body.length is not None
    half, middle = 0.5 * body.length, _middle(body)
    diameters = (body.diameter, body.bore)
    points = {-half, half}
    for each in diameters:
        inner = getattr(each, "y", np.linspace(-half, half, _SAMPLES) if callable(each) else ())
        points |= {float(place) for place in inner if abs(place) < half}
    z = np.array(sorted(points))
    curvature = body.curvature(z + middle)
    if not np.all(curvature > 0.0):
        raise InputError("depth", Finite.word, "only be used for a body that is convex everywhere", _REMEDY)
    given = body.bore if body.bore is not None else 0.0
    bore: Array = np.asarray(given(z) if callable(given) else np.full(z.shape, given), dtype=float)
    radius = 1.0 / float(body.curvature(np.array([middle]))[0])
    rows: tuple[Array, ...] = (z, 1.0 / curvature, 0.5 * bore)
    # Rounded, so that the same shape in another unit of length is known again. Sizes beyond all numbers are refused.
    with np.errstate(all="ignore"):
        places, outer, inner = (tuple(np.round(row / radius, _DIGITS).tolist()) for row in rows)
    return Outline(places, outer, inner), radius


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
