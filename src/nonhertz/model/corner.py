"""The corners between the surface of a body and its side faces: rounded, or chamfered with a blend."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass
from functools import cached_property
from typing import Annotated

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.amounts import mm
from nonhertz.errors import InputError
from nonhertz.inputs.checks import not_negative, number_that, numbers, positive
from nonhertz.inputs.fields import Input, Quantity, described, together
from nonhertz.model.profile.base import Formula, Profile
from nonhertz.model.profile.circular import drop_of_circle

Array = NDArray[np.float64]

_STEP = 1e-4  # of the land, for the slope at its ends
_STEEPEST = 0.5  # slope of a profile where a corner begins


class Corner(ABC):
    """What takes the ends of a body away, beginning with the slope that its profile has there."""

    @property
    @abstractmethod
    def extent(self) -> float:
        """Length along the axis from where it begins to the side face [mm]."""

    def drop(self, distance: ArrayLike) -> Array:
        """Return how far it lies below the tangent at its beginning [mm].

        Parameters
        ----------
        distance : array_like
            From its beginning along the axis [mm], not negative; beyond its extent the result means nothing.
        """
        return self.drop_at(numbers("distance", distance, "give distances from the end of the land in mm"))

    @abstractmethod
    def drop_at(self, distance: Array) -> Array:
        """Return the drop at distances that are known to be numbers."""

    @property
    def bends(self) -> tuple[float, ...]:
        """Distances from its beginning at which its slope or curvature jumps [mm], beside 0."""
        return ()


@dataclass(frozen=True)
class Rounded(Corner):
    """A quarter of a circle.

    Parameters
    ----------
    radius : float
        Its radius [mm].
    """

    radius: float

    def __post_init__(self) -> None:
        positive("corner_radius", self.radius, "give the radius in mm, or leave it out for a sharp end")

    @property
    def extent(self) -> float:
        """The radius [mm]."""
        return self.radius

    def drop_at(self, distance: Array) -> Array:
        """Return the drop at distances that are known to be numbers."""
        return drop_of_circle(self.radius, distance)


_acute = number_that(lambda angle: 0.0 < angle < 0.5 * math.pi, "lie between 0 and pi / 2")


@described()
class Chamfer(Input, Corner):
    """Chamfers at both ends of a body, each with an arc that blends it into the surface.

    Raises
    ------
    InputError
        If a value is out of range, or the arc is longer than the chamfer.

    Examples
    --------
    >>> chamfer = Chamfer(length=1.0, angle=0.3, blend_radius=2.0)
    >>> round(float(chamfer.drop(1.0)), 4)
    0.2158
    """

    length: Annotated[
        float,
        Quantity(
            "mm",
            "length along the axis, the arc included",
            positive,
            "give the length of the chamfer along the axis in mm",
        ),
    ]
    angle: Annotated[
        float,
        Quantity(
            "rad",
            "angle from the axis, below pi / 2",
            _acute,
            "give the angle between chamfer and axis in rad, or as text with a unit",
        ),
    ]
    blend_radius: Annotated[
        float,
        Quantity(
            "mm",
            "radius of the arc between surface and chamfer; 0 for an edge, where pressure has no limit",
            not_negative,
            "give the radius of the arc between surface and chamfer in mm, or 0 for an edge",
        ),
    ] = 0.0

    @together("length", "angle", "blend_radius")
    def _check_arc(self) -> None:
        if self._arc > self.length:
            condition = f"leave the arc, {mm(self._arc):.4g} along the axis, within the chamfer's {mm(self.length):g}"
            raise InputError("blend_radius", self.blend_radius, condition, "reduce it, or lengthen the chamfer")

    @property
    def _arc(self) -> float:
        return self.blend_radius * math.sin(self.angle)

    @property
    def extent(self) -> float:
        """The length [mm]."""
        return self.length

    def drop_at(self, distance: Array) -> Array:
        """Return the drop at distances that are known to be numbers."""
        straight = np.maximum(distance - self._arc, 0.0) * math.tan(self.angle)
        if self.blend_radius == 0.0:
            return straight
        return np.asarray(straight + drop_of_circle(self.blend_radius, np.minimum(distance, self._arc)))

    @property
    def bends(self) -> tuple[float, ...]:
        """Where the arc becomes straight."""
        return (self._arc,) if 0.0 < self._arc < self.length else ()


@dataclass(frozen=True)
class Cornered(Formula):
    """A profile up to the ends of a land, and corners from there to the side faces.

    Parameters
    ----------
    land : Profile
        Relief of the land.
    half_length : float
        Half the distance between the side faces [mm].
    corner : Corner
        The corner at either end.

    Raises
    ------
    InputError
        If the corners leave no land, or the profile does not reach its ends or is steep there.
    """

    land: Profile
    half_length: float
    corner: Corner

    def __post_init__(self) -> None:
        if self.land_end <= 0.0:
            name = "corner_radius" if isinstance(self.corner, Rounded) else "chamfer"
            condition = (
                f"leave a land: two corners of {mm(self.corner.extent):g} are {mm(2.0 * self.corner.extent):g} long"
            )
            raise InputError("length", 2.0 * self.half_length, condition, f"reduce {name}, or lengthen the body")
        steepest = float(np.max(np.abs(self._tangents), initial=0.0, where=np.isfinite(self._tangents)))
        if not np.all(np.isfinite(self._tangents)) or steepest > _STEEPEST:
            ends = mm(-self.land_end, self.land_end, between=" and ")
            condition = f"reach both ends of the land, y = {ends:g}, with a gentle slope"
            raise InputError("profile", self.land, condition, "change the profile, or leave out the corner")

    @property
    def land_end(self) -> float:
        """Distance from the middle at which the corners begin [mm]."""
        return self.half_length - self.corner.extent

    @cached_property
    def _tangents(self) -> Array:
        """Relief and slope outwards at both ends of the land, low y first, shape (2, 2)."""
        step = _STEP * self.land_end
        inwards = self.land_end - step * np.arange(3.0)
        with np.errstate(invalid="ignore"):
            relief = np.array([self.land.relief_at(side * inwards) for side in (-1.0, 1.0)])
            slope = (3.0 * relief[:, 0] - 4.0 * relief[:, 1] + relief[:, 2]) / (2.0 * step)
        return np.stack([relief[:, 0], slope])

    def relief_at(self, y: Array) -> Array:
        """Return the relief [mm]; infinite beyond the side faces."""
        beyond = np.abs(y) - self.land_end
        relief = np.array(self.land.relief_at(np.minimum(np.maximum(y, -self.land_end), self.land_end)))
        on_corners = beyond > 0.0
        distance, at_low = beyond[on_corners], y[on_corners] < 0.0
        if distance.size:
            (low, high), (low_slope, high_slope) = self._tangents
            within = np.minimum(distance, self.corner.extent)
            tangent = np.where(at_low, low + low_slope * within, high + high_slope * within)
            fallen = tangent + self.corner.drop_at(within)
            relief[on_corners] = np.where(distance > self.corner.extent, np.inf, fallen)
        return relief

    @property
    def bends(self) -> tuple[float, ...]:
        """Those of the land, and where corners begin and bend."""
        outwards = (self.land_end, *(self.land_end + each for each in self.corner.bends))
        return tuple(sorted({*self._on_land(self.land.bends), *outwards, *(-each for each in outwards)}))

    @property
    def crests(self) -> tuple[float, ...]:
        """Those of the land, and its ends."""
        return tuple(sorted({*self._on_land(self.land.crests), -self.land_end, self.land_end}))

    @property
    def extent(self) -> tuple[float, float]:
        """From side face to side face [mm]."""
        return -self.half_length, self.half_length

    @property
    def joints(self) -> tuple[float, float]:
        """The ends of the land [mm]."""
        return -self.land_end, self.land_end

    def _on_land(self, places: tuple[float, ...]) -> tuple[float, ...]:
        return tuple(each for each in places if abs(each) < self.land_end)
