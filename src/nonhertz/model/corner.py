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
from nonhertz.inputs.descriptions import Quantity
from nonhertz.inputs.fields import Input, cross_check, input_class
from nonhertz.model.profile.base import SAME_PLACE, Formula, Profile
from nonhertz.model.profile.circular import drop_of_circle

Array = NDArray[np.float64]

_STEP = 1e-6  # of the land, for slope and curvature near its ends
_SHARPEST = 10.0  # over the extent of a corner: the largest curvature of a land before it
_PLACES, _SECTIONS = 32, 6  # of the search for that curvature: they narrow it to a billionth of the land


class Corner(ABC):
    """The shape of a body between the end of its profile and a side face; it begins with the slope of the profile."""

    @property
    @abstractmethod
    def extent(self) -> float:
        """Length along the axis from its beginning to the side face [mm]."""

    def drop(self, distance: ArrayLike) -> Array:
        """Return the drop below the tangent at its beginning [mm].

        Parameters
        ----------
        distance : array_like
            Distance from its beginning along the axis [mm], not negative; beyond its extent the result is meaningless.
        """
        return self.drop_at(numbers("distance", distance, "give distances from the end of the land in mm"))

    @abstractmethod
    def drop_at(self, distance: Array) -> Array:
        """Return the drop at distances that are known to be numbers."""

    @property
    def bends(self) -> tuple[float, ...]:
        """Distances from its beginning at which its slope or curvature jumps [mm], other than 0."""
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


@input_class()
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
            "radius of the arc between surface and chamfer; 0 for an edge, where the pressure is singular",
            not_negative,
            "give the radius of the arc between surface and chamfer in mm, or 0 for an edge",
        ),
    ] = 0.0

    @cross_check("length", "angle", "blend_radius")
    def _check_arc(self) -> None:
        if self.arc > self.length:
            condition = f"leave the arc, {mm(self.arc):.4g} along the axis, within the chamfer's {mm(self.length):g}"
            raise InputError("blend_radius", self.blend_radius, condition, "reduce it, or lengthen the chamfer")

    @property
    def arc(self) -> float:
        """Length of the arc along the axis [mm]."""
        return self.blend_radius * math.sin(self.angle)

    @property
    def extent(self) -> float:
        """The length [mm]."""
        return self.length

    def drop_at(self, distance: Array) -> Array:
        """Return the drop at distances that are known to be numbers."""
        straight = np.maximum(distance - self.arc, 0.0) * math.tan(self.angle)
        if self.blend_radius == 0.0:
            return straight
        return np.asarray(straight + drop_of_circle(self.blend_radius, np.minimum(distance, self.arc)))

    @property
    def bends(self) -> tuple[float, ...]:
        """Where the arc becomes straight."""
        return (self.arc,) if 0.0 < self.arc < self.length else ()


@dataclass(frozen=True)
class Cornered(Formula):
    """A profile up to the ends of a land, and corners from there to the side faces.

    Corners begin with the slope of the profile at the end of the land. Where the profile ends in an edge, such as a
    logarithm where it becomes infinite, it continues along its tangent from where its radius of curvature has fallen to
    a tenth of the corner's extent: the part farther out is too narrow to carry load. The surface is thus finite and
    smooth.

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
        If the corners leave no land, or the profile stops before the ends of the land.
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
        _ = self.tangents

    @property
    def land_end(self) -> float:
        """Distance from the middle at which the corners begin [mm]."""
        return self.half_length - self.corner.extent

    @cached_property
    def tangents(self) -> Array:
        """Beginning of the tangents at low and high y: distance from the middle, relief and slope, shape (2, 3)."""
        return np.array([self._tangent(side) for side in (-1.0, 1.0)])

    def _tangent(self, side: float) -> tuple[float, float, float]:
        """Return where the land at low (-1) or high y (1) ends or becomes an edge: distance, relief, slope outwards."""
        places = np.array([self.land_end])
        relief, slope, sharpness = self._shape(side, places)
        if not sharpness[0] <= _SHARPEST:
            places = np.array([0.0, self.land_end])
            for _ in range(_SECTIONS):
                places = np.linspace(places[0], places[-1], _PLACES + 1)
                relief, slope, sharpness = self._shape(side, places)
                blunt = np.flatnonzero(sharpness <= _SHARPEST)
                outermost = slice(blunt[-1], blunt[-1] + 2) if blunt.size else slice(2)
                places, relief, slope, sharpness = (of[outermost] for of in (places, relief, slope, sharpness))
        end = (1.0 - SAME_PLACE) * self.land_end
        is_edge = places[0] >= end or sharpness[0] > 0.9 * _SHARPEST or np.isfinite(relief[-1])
        if side * self.land.extent[int(side > 0.0)] < end or not (np.isfinite(relief[0]) and is_edge):
            ends = mm(-self.land_end, self.land_end, between=" and ")
            condition = f"reach both ends of the land, y = {ends:g}"
            raise InputError("profile", self.land, condition, "extend the profile, or leave out the corner")
        return float(places[0]), float(relief[0]), float(slope[0])

    def _shape(self, side: float, distance: Array) -> tuple[Array, Array, Array]:
        """Return relief, slope outwards and curvature times the corner's extent on one side; NaN past its end."""
        step = _STEP * self.land_end
        places = side * (distance - step * np.arange(3.0)[:, None])
        # One-dimensional, as a user's own profile may expect.
        relief = self.land.relief_at(places.ravel()).reshape(places.shape)
        with np.errstate(invalid="ignore"):
            slope = (3.0 * relief[0] - 4.0 * relief[1] + relief[2]) / (2.0 * step)
            curvature = (relief[0] - 2.0 * relief[1] + relief[2]) / step**2
        return relief[0], slope, np.abs(curvature) * self.corner.extent

    def relief_at(self, y: Array) -> Array:
        """Return the relief [mm]; infinite beyond the side faces."""
        (low, low_relief, low_slope), (high, high_relief, high_slope) = self.tangents
        relief = np.array(self.land.relief_at(np.minimum(np.maximum(y, -low), high)))
        beyond = (y < -low) | (y > high)
        distance, at_low = np.abs(y[beyond]), y[beyond] < 0.0
        if distance.size:
            within = np.minimum(distance, self.half_length)
            tangent = np.where(
                at_low, low_relief + low_slope * (within - low), high_relief + high_slope * (within - high)
            )
            on_corner = np.minimum(np.maximum(within - self.land_end, 0.0), self.corner.extent)
            relief[beyond] = np.where(distance > self.half_length, np.inf, tangent + self.corner.drop_at(on_corner))
        return relief

    @property
    def bends(self) -> tuple[float, ...]:
        """Bends of the land, beginnings of the tangents, and beginnings and bends of the corners."""
        outwards = (self.land_end, *(self.land_end + place for place in self.corner.bends))
        low, high = self.tangents[:, 0].tolist()
        return tuple(sorted({*self._on_land(self.land.bends), -low, high, *outwards, *(-place for place in outwards)}))

    @property
    def crests(self) -> tuple[float, ...]:
        """Crests of the land, and its ends."""
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
        low, high = self.tangents[:, 0]
        return tuple(place for place in places if -low < place < high)
