"""The outline of a roller: a section through its axis, and which bodies can deform as a whole."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import mm
from nonhertz.errors import InputError

if TYPE_CHECKING:
    from nonhertz.model.body import Body

Array = NDArray[np.float64]

_KINK = 0.03  # change of slope at which an outline has a corner
_SHORTEST, _LONGEST = 0.1, 10.0  # length over diameter
_THINNEST, _STEEPEST = 0.08, 0.28  # wall over radius, and slope of the surface
_SAMPLES = 33  # of a diameter given as a function
_DIGITS = 12


@dataclass(frozen=True)
class Outline:
    """Radii of the surface and of the bore along the axis, linear between points; lengths over a radius of the surface.

    Parameters
    ----------
    z : tuple of float
        Axial positions from the middle, ascending, from one side face to the other.
    outer, inner : tuple of float
        Radii of the surface and of the bore there; 0 where there is no bore.
    """

    z: tuple[float, ...]
    outer: tuple[float, ...]
    inner: tuple[float, ...]

    @classmethod
    def cylinder(cls, half_length: float, bore: float = 0.0) -> Outline:
        """Return the outline of a cylinder of radius 1."""
        return cls((-half_length, half_length), (1.0, 1.0), (bore, bore))

    @property
    def half_length(self) -> float:
        """Half the distance between the side faces."""
        return self.z[-1]

    @property
    def symmetric(self) -> bool:
        """Whether it is its own mirror image about the middle."""
        z, *radii = self._points
        return bool(np.all(z == -z[::-1]) and all(np.all(row == row[::-1]) for row in radii))

    @property
    def bored(self) -> bool:
        """Whether there is a bore."""
        return max(self.inner) > 0.0

    @property
    def wall(self) -> float:
        """The thinnest wall; the radius of a solid roller."""
        return min(outer - inner for outer, inner in zip(self.outer, self.inner, strict=True))

    @property
    def steepest(self) -> float:
        """The largest slope of the surface."""
        return float(np.max(np.abs(self._slopes[0])))

    @cached_property
    def kinks(self) -> tuple[float, ...]:
        """Axial positions of corners of the outline, other than at the side faces."""
        sharp = np.any(np.abs(np.diff(self._slopes, axis=1)) > _KINK, axis=0)
        return tuple(place for place, is_sharp in zip(self.z[1:-1], sharp, strict=True) if is_sharp)

    def radii(self, z: Array) -> tuple[Array, Array]:
        """Return the radii of surface and bore at places."""
        points, outer, inner = self._points
        return np.interp(z, points, outer), np.interp(z, points, inner)

    @cached_property
    def _points(self) -> Array:
        return np.array([self.z, self.outer, self.inner])

    @cached_property
    def _slopes(self) -> Array:
        points, *radii = self._points
        slopes: Array = np.diff(radii, axis=1) / np.diff(points)
        return slopes

    def slopes(self, z: Array) -> tuple[Array, Array]:
        """Return the slopes of both radii along the axis at positions between the points."""
        at = np.clip(np.searchsorted(self._points[0], z) - 1, 0, len(self.z) - 2)
        return self._slopes[0, at], self._slopes[1, at]

    def cosines(self, z: Array) -> Array:
        """Return the cosine of the angle between surface and axis at places between the points."""
        cosine: Array = 1.0 / np.hypot(1.0, self.slopes(z)[0])
        return cosine

    def girths(self, z: Array) -> Array:
        """Return the distances of the surface from the axis; the radii are measured normal to the surface."""
        girth: Array = self.radii(z)[0] * self.cosines(z)
        return girth

    @property
    def corner_angles(self) -> tuple[float, float]:
        """Angles between the surface and both side faces, within the body [rad]."""
        low, high = self.slopes(np.array([self.z[0], self.z[-1]]))[0]
        return 0.5 * math.pi + math.atan(low), 0.5 * math.pi - math.atan(high)


def outline_of(body: Body) -> tuple[Outline, float]:
    """Return the outline of a roller, and the radius of its surface in the middle [mm], which is its unit."""
    assert body.length is not None
    half, middle = 0.5 * body.length, body.position
    diameters = (body.diameter, body.bore)
    points = {-half, half}
    for diameter in diameters:
        inner = getattr(diameter, "y", np.linspace(-half, half, _SAMPLES) if callable(diameter) else ())
        points |= {float(place) for place in inner if abs(place) < half}
    z = np.array(sorted(points))
    curvature = body.curvature(z + middle)
    if not np.all(curvature > 0.0):
        raise _not_whole_error(body, "only be used for a body that is convex everywhere")
    inner_diameter = body.bore if body.bore is not None else 0.0
    bore = inner_diameter(z) if callable(inner_diameter) else np.full(z.shape, inner_diameter)
    radius = 1.0 / float(body.curvature(np.array([middle]))[0])
    rows: tuple[Array, ...] = (z, 1.0 / curvature, 0.5 * np.asarray(bore, dtype=float))
    # Rounded, so that the same shape in another unit of length is recognised. Sizes that overflow are refused.
    with np.errstate(all="ignore"):
        places, outer, inner = (tuple(np.round(row / radius, _DIGITS).tolist()) for row in rows)
    return Outline(places, outer, inner), radius


def refuse_unless_whole(body: Body) -> None:
    """Refuse a body other than a roller with free ends."""
    if body.length is None or not all(body.free_faces):
        raise _not_whole_error(
            body, "only be used for a body with two free side faces", "write side_faces = 'free', or "
        )
    if body.images != 1:
        raise InputError("images", body.images, "be 1 where depth = 'finite', which has them all", "leave it out")
    outline, radius = body.outline
    slenderness = outline.half_length
    if not _SHORTEST <= slenderness <= _LONGEST:
        condition = f"only be used for a length of {_SHORTEST:g} to {_LONGEST:g} diameters, not {slenderness:.3g}"
        raise _not_whole_error(body, condition, wall=outline.wall * radius)
    if outline.steepest > _STEEPEST:
        condition = f"only be used where the radius changes by less than {_STEEPEST:g} of the way along the axis"
        raise _not_whole_error(body, condition, wall=outline.wall * radius)
    if outline.wall < _THINNEST:
        condition = f"leave a wall of {_THINNEST:g} times the radius at least, not {mm(outline.wall * radius):.3g}"
        raise InputError("bore", body.bore, condition, "reduce the bore")


def _not_whole_error(body: Body, condition: str, first: str = "", wall: float | None = None) -> InputError:
    """Return the error for a body that cannot deform as a whole: about its bore, which requires that, if it has one."""
    if body.bore is None:
        return InputError("depth", "finite", condition, f"{first}write depth = 'plane-strain'")
    instead = "" if wall is None else f", and give the thickness of the wall instead, depth = {wall:.6g}"
    return InputError("bore", body.bore, condition, f"{first}leave it out{instead}")


def can_be_whole(body: Body) -> bool:
    """Return whether a body can deform as a whole, or has a bore, whose own error says why it cannot."""
    try:
        refuse_unless_whole(body)
    except InputError:
        return body.bore is not None
    return True
