"""The outline of a roller: a section through its axis."""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

_KINK = 0.03  # change of slope at which an outline has a corner
_GROWN = 2.6  # size of an element that begins at a corner over that of the one on the other side
_FINE_BORDERS = 801  # of places between which borders of elements are interpolated
_FINE = 65  # places from a corner to half-way to the next at which sizes of elements are looked at


@dataclass(frozen=True)
class Outline:
    """Radii of the surface and of the bore along the axis, linear between places; all in some radius of the surface.

    Parameters
    ----------
    z : tuple of float
        Axial positions from the middle, ascending, from one side face to the other.
    outer, inner : tuple of float
        Radii of the surface and of the bore there; 0 where there is none.
    """

    z: tuple[float, ...]
    outer: tuple[float, ...]
    inner: tuple[float, ...]

    @classmethod
    def cylinder(cls, half_length: float, bore: float = 0.0) -> Outline:
        """Return that of a cylinder of radius 1."""
        return cls((-half_length, half_length), (1.0, 1.0), (bore, bore))

    @property
    def half_length(self) -> float:
        """Half the distance between the side faces."""
        return self.z[-1]

    @property
    def symmetric(self) -> bool:
        """Whether it is its own mirror image about the middle."""
        z, outer, inner = (np.array(each) for each in (self.z, self.outer, self.inner))
        return bool(np.all(z == -z[::-1]) and np.all(outer == outer[::-1]) and np.all(inner == inner[::-1]))

    @property
    def bored(self) -> bool:
        """Whether there is a bore."""
        return max(self.inner) > 0.0

    @property
    def wall(self) -> float:
        """The thinnest wall; that of a solid one is the radius."""
        return min(outer - inner for outer, inner in zip(self.outer, self.inner, strict=True))

    @property
    def steepest(self) -> float:
        """The largest slope of the surface."""
        return float(np.max(np.abs(np.diff(self.outer) / np.diff(self.z))))

    @cached_property
    def kinks(self) -> tuple[float, ...]:
        """Axial positions of corners of the outline, but for the side faces."""
        slopes = np.array([np.diff(radius) / np.diff(self.z) for radius in (self.outer, self.inner)])
        sharp = np.any(np.abs(np.diff(slopes, axis=1)) > _KINK, axis=0)
        return tuple(place for place, is_sharp in zip(self.z[1:-1], sharp, strict=True) if is_sharp)

    def radii(self, z: Array) -> tuple[Array, Array]:
        """Return the radii of surface and bore at places."""
        outer: Array = np.interp(z, self.z, self.outer)
        inner: Array = np.interp(z, self.z, self.inner)
        return outer, inner

    def slopes(self, z: Array) -> tuple[Array, Array]:
        """Return how both radii change along the axis at places between the points."""
        at = np.clip(np.searchsorted(self.z, z) - 1, 0, len(self.z) - 2)
        outer, inner = (np.diff(radius) / np.diff(self.z) for radius in (self.outer, self.inner))
        return outer[at], inner[at]

    def cosines(self, z: Array) -> Array:
        """Return the cosine of the angle between surface and axis at places between the points."""
        found: Array = 1.0 / np.hypot(1.0, self.slopes(z)[0])
        return found

    def girths(self, z: Array) -> Array:
        """Return the distances of the surface from the axis, of which the radii are those normal to the surface."""
        found: Array = self.radii(z)[0] * self.cosines(z)
        return found

    @property
    def corner_angles(self) -> tuple[float, float]:
        """Angles between the surface and both side faces, within the body [rad]."""
        low, high = self.slopes(np.array([self.z[0], self.z[-1]]))[0]
        return 0.5 * math.pi + math.atan(low), 0.5 * math.pi - math.atan(high)


def borders_towards_end(length: float, finest: float, growth: float, largest: float) -> Array:
    """Return borders of elements from 0 to a length, which shrink towards its end.

    An element at a distance d from the end is ``finest + growth * d`` long, ``largest`` at most. The borders divide the
    integral of the density of elements evenly, so that a small change of the length moves all of them a little.
    """
    distance = length * np.linspace(0.0, 1.0, _FINE_BORDERS) ** 2
    density = 1.0 / np.minimum(finest + growth * distance, largest)
    elements = np.concatenate([[0.0], np.cumsum(0.5 * np.diff(distance) * (density[1:] + density[:-1]))])
    count = max(2, math.ceil(elements[-1]))
    found: Array = length - np.interp(elements[-1] * np.linspace(1.0, 0.0, count + 1), elements, distance)
    found[0], found[-1] = 0.0, length
    return found


def with_kinks(borders: Array, kinks: tuple[float, ...], smallest: float) -> Array:
    """Return borders of elements with some places among them, next to which elements are no larger than between them.

    Elements grow away from a place in proportion to their distance: beside the short wall of a step they are as short
    as this wall.
    """
    if not kinks:
        return borders
    places = np.array([borders[0], *kinks, borders[-1]])
    gaps = np.diff(places)
    finest = np.minimum(np.minimum(gaps[:-1], gaps[1:]), smallest)
    found = [places[:1]]
    for low, high in itertools.pairwise(places.tolist()):
        # Distances down to where elements no longer shrink.
        near = np.geomspace(min(0.1 * np.min(finest) / (high - low), 0.1), 0.5, _FINE)
        fine = low + (high - low) * np.concatenate([[0.0], near, 1.0 - near[-2::-1], [1.0]])
        fine[-1] = high
        middle = 0.5 * (fine[1:] + fine[:-1])
        at = np.clip(np.searchsorted(borders, middle) - 1, 0, borders.size - 2)
        allowed = np.min(finest + (_GROWN - 1.0) * np.abs(middle[:, None] - places[1:-1]), axis=1)
        elements = np.concatenate([[0.0], np.cumsum(np.diff(fine) / np.minimum(np.diff(borders)[at], allowed))])
        count = max(1, round(elements[-1]))
        found.append(np.interp(np.arange(1, count + 1) * elements[-1] / count, elements, fine))
    return np.concatenate(found)
