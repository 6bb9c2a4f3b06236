"""Errors of a surrogate against solved cases from which it was not built."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nonhertz.maps.fitting import LIGHT, Samples, Shape
from nonhertz.native import core

Array = NDArray[np.float64]

#: Stated over largest sampled error. With 150 check points, up to 3 of 600 other points were worse than stated.
SAFETY = 1.5


@dataclass(frozen=True)
class SampledErrors:
    """The largest errors of a map at its check points, against the solver at the same approach and tilt, times 1.5.

    They are not bounds: a few points in a thousand elsewhere may be worse. "Load" below is the load at the point, but
    at least a hundredth of the map's largest; "stiffness" is d load / d approach there; the half-length is half the
    length over which the bodies can touch or, if that is unlimited, touch under the largest load.

    Attributes
    ----------
    load : float
        Error of the load over load.
    moment : float
        Error of the moment over load times half-length.
    stiffness : float
        The largest error of the four entries, over stiffness, stiffness times half-length, and times its square.
    max_pressure : float
        Error of the maximum pressure over that pressure, but over at least a fifth of the largest in the map.
    max_half_width : float
        Error of the largest half-width over that half-width, likewise.
    strip_loads : float
        The largest error of the load on a station over load.
    points : int
        Number of check points.
    """

    load: float
    moment: float
    stiffness: float
    max_pressure: float
    max_half_width: float
    strip_loads: float
    points: int


@dataclass(frozen=True)
class Misses:
    """Errors of a surrogate at check points: rows in the order, and relative to the quantities, of `SampledErrors`."""

    relative: Array

    @classmethod
    def of(cls, shape: Shape, table: Array, stations: Array, samples: Samples) -> Misses:
        """Compare a surrogate with solved cases at the same approach and tilt."""
        states = core.map_states(table, False, samples.approach, samples.tilt)
        strip_loads = core.map_shares(table, np.ascontiguousarray(states[:, 2]), samples.tilt, stations)
        light = np.maximum(samples.load, LIGHT * shape.max_load)
        half, solid = shape.half_length, samples.stiffness
        # The stiffness grows about as the cube root of the load.
        stiffness = solid[:, 0, 0] * np.cbrt(light / samples.load)
        entries = [
            (states[:, 4] - solid[:, 0, 0]) / stiffness,
            (states[:, 5] - solid[:, 0, 1]) / stiffness / half,
            (states[:, 6] - solid[:, 1, 1]) / stiffness / half**2,
        ]
        relative = [
            np.abs(states[:, 2] - samples.load) / light,
            np.abs(states[:, 3] - samples.moment) / (light * half),
            np.abs(entries).max(axis=0),
            np.abs(states[:, 8] - samples.max_pressure) / _but_least(samples.max_pressure),
            np.abs(states[:, 9] - samples.max_half_width) / _but_least(samples.max_half_width),
            np.abs(strip_loads - samples.strip_loads).max(axis=1) / light,
        ]
        return cls(np.array(relative))

    @property
    def combined(self) -> Array:
        """The larger error of load and moment, shape (points,)."""
        combined: Array = self.relative[:2].max(axis=0)
        return combined

    @property
    def worst(self) -> float:
        """The largest error of load and moment."""
        return float(self.combined.max())

    @property
    def typical(self) -> float:
        """The root mean square of the errors of load and moment."""
        return float(np.sqrt(np.mean(self.combined**2)))

    def sampled(self) -> SampledErrors:
        """Return the largest error of each quantity times `SAFETY`."""
        return SampledErrors(*(SAFETY * self.relative.max(axis=1)).tolist(), points=self.relative.shape[1])  # type: ignore[misc]


def _but_least(values: Array) -> Array:
    """Return values, but at least the value that the largest would have under a hundredth of its load."""
    least: Array = np.maximum(values, np.cbrt(LIGHT) * values.max())
    return least
