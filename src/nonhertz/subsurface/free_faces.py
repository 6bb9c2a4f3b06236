"""Correction for a free side face to the field of a pressure and its images, below one solution.

Images of full weight free a side face of shear and double its normal stress. The correction that removes it
(`nonhertz.bodies.quarter_space_field`) is summed over wave numbers k across the contact, once for each face, into a
table of splines over x, the distance from the edge and the direction there, which is cheap to evaluate at each point.
The whole load is included, however far from the face: its normal stress falls only with the inverse of the distance.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache, cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

from nonhertz.bodies.quarter_space_field import (
    COMPONENTS,
    DIRECTIONS,
    FARTHEST_APART,
    QuarterSpaceField,
    between_angles,
    quarter_space_field,
)

if TYPE_CHECKING:
    from scipy.interpolate import NdBSpline

Array = NDArray[np.float64]

# Six stresses and three displacements: which are odd in x under an even load, and which are odd in y.
_ODD = np.array([False, False, False, False, True, True, True, False, False])
_ALONG = np.array([False, False, False, True, False, True, False, True, False])
_STRESSES = 6

# Wave numbers over the inverse of the half-width: the largest, and the longest panel; and Gauss's nodes on each panel.
_LARGEST, _STEP, _NODES = 30.0, 2.5, 6
# Further across, in half-widths, cos(k x) oscillates too fast for these nodes: the field is smoothed over a part of x.
_FROM, _SMOOTHED = 1.2, 0.15
_CLOSEST, _RADIAL = 0.05, 0.25  # distance from the edge, in half-widths, and steps of its logarithm
_ACROSS, _ACROSS_STEP = 0.8, 0.1  # x is 0.8 half-widths times sinh of these steps
_ANGLES = np.linspace(0.0, 0.5 * np.pi, 9)
# Images of a face's correction on either side, times the length over the half-width; and their largest number.
_SEEN, _MOST_IMAGES = 20.0, 8
_BEYOND = 2.0  # reach of the table over the distance of the load's far end


@dataclass(frozen=True, eq=False)
class Spectrum:
    """Cosine and sine transforms across of a pressure that is constant along y between edges.

    Attributes
    ----------
    edges : ndarray, shape (n,)
        Positions where the pressure changes [mm].
    even, odd : ndarray, shape (wave numbers, n)
        The transform [N/mm] before each edge minus that behind it; ``odd`` is None for a symmetric pressure.
    """

    edges: Array
    even: Array
    odd: Array | None

    @property
    def steps(self) -> tuple[Array, ...]:
        """Both transforms, or the only one."""
        return (self.even,) if self.odd is None else (self.even, self.odd)


@dataclass(frozen=True, eq=False)
class Between:
    """The load between two free faces, with its images.

    Attributes
    ----------
    terms : ndarray, shape (terms, 3)
        Rows (sign, offset, weight) of the load itself and its images, all of weight 1.
    afar : tuple of float, or None
        Positions where line loads begin that represent all further images [mm], low and high, and their size [N/mm].
    """

    terms: Array
    afar: tuple[float, float, float] | None

    def projected(
        self, field: QuarterSpaceField, k: Array, edges: Array, steps: Array, place: float, side: float
    ) -> Array:
        """Return the coefficients of a face without the other: for half of the load on either side of it."""
        halves: dict[tuple[float, float], float] = {}
        for sign, offset, _ in self.terms.tolist():
            turned, start = -side * sign, side * (place - offset)
            mirrored = 1.0 if start + 0.5 * turned * (edges[0] + edges[-1]) > 0.0 else -1.0
            key = round(mirrored * start, 9), mirrored * turned
            halves[key] = halves.get(key, 0.0) + 0.5
        total = sum(
            half * field.projected(k, np.maximum(start + turned * edges, 0.0), turned * steps)
            for (start, turned), half in halves.items()
        )
        if self.afar is not None:
            low, high, mean = self.afar
            far = np.array([place - low, high - place, np.inf])
            total += field.projected(k, far, np.tile([-0.5 * mean, -0.5 * mean, mean], (k.size, 1)))
        return np.asarray(total)


@dataclass(eq=False)
class _Part:
    """Correction for a face, for the even or the odd part of a load.

    Attributes
    ----------
    is_odd : bool
        Whether it is the odd part.
    alone, both : ndarray, shape (wave numbers, rank)
        Coefficients of the field of this face alone, and together with another face; see `QuarterSpaceField`.
    """

    is_odd: bool
    alone: Array
    both: Array

    @property
    def turned(self) -> NDArray[np.bool_]:
        """Mask of the components that change sign with x."""
        return ~_ODD if self.is_odd else _ODD


@dataclass(frozen=True, eq=False)
class _Waves:
    """Wave numbers [1/mm] with their weights in an integral, and the field of a material."""

    field: QuarterSpaceField
    k: Array
    weight: Array

    @classmethod
    def of(cls, poisson: float, half_width: float, farthest: float) -> _Waves:
        """Return the wave numbers needed for a contact of this half-width."""
        return cls(quarter_space_field(poisson), *_wave_numbers(half_width, farthest))

    def alone(self, load: Spectrum, place: float, side: float) -> tuple[_Part, ...]:
        """Return the correction for a face for each part of a load."""
        distance, parts = side * (place - load.edges), []
        for odd, steps in enumerate(load.steps):
            coefficients = self.field.projected(self.k, distance, -side * steps)
            parts.append(_Part(bool(odd), coefficients, coefficients))
        return tuple(parts)


@dataclass(frozen=True, eq=False)
class FreeFaceField:
    """Correction for one free side face.

    Attributes
    ----------
    place, side : float
        Position of the face [mm]; -1 at the low, 1 at the high end of the body.
    half_width, farthest : float
        Half-width of the contact near the face, and reach of the table [mm].
    length : float
        The distance of another free face [mm], 0 if there is none.
    images : int
        Number of mirror images of the correction on either side, if there is another free face.
    waves : _Waves
        The wave numbers of the sum.
    parts : tuple of _Part
        Corrections for the even part of the pressure, and for the odd part if there is one.
    """

    place: float
    side: float
    half_width: float
    farthest: float
    length: float
    images: int
    waves: _Waves
    parts: tuple[_Part, ...]

    @classmethod
    def of(
        cls,
        spectrum: Callable[[Array, float], Spectrum],
        place: float,
        side: float,
        half_width: float,
        reach: float,
        poisson: float,
    ) -> FreeFaceField:
        """Return the correction for a face under a load with a spectrum and its far end at ``reach`` [mm]."""
        farthest = _BEYOND * reach
        waves = _Waves.of(poisson, half_width, farthest)
        parts = waves.alone(spectrum(waves.k, place), place, side)
        return cls(place, side, half_width, farthest, 0.0, 0, waves, parts)

    @classmethod
    def pair(
        cls,
        spectrum: Callable[[Array, float], Spectrum],
        places: tuple[float, float],
        half_widths: tuple[float, float],
        reaches: tuple[float, float],
        poisson: float,
        between: Between,
    ) -> tuple[FreeFaceField, FreeFaceField]:
        """Return the corrections for both faces of a body, low and high.

        For stress, each face also removes the stress that the other leaves on it. Displacement omits this, as the
        solver does.
        """
        farthest_load = max(reaches)
        low, high = cls._alike(spectrum, places, half_widths[0], farthest_load, poisson, between)
        if half_widths[0] != half_widths[1]:
            high = cls._alike(spectrum, places, half_widths[1], farthest_load, poisson, between)[1]
        return low, high

    @classmethod
    def _alike(
        cls,
        spectrum: Callable[[Array, float], Spectrum],
        places: tuple[float, float],
        half_width: float,
        reach: float,
        poisson: float,
        between: Between,
    ) -> tuple[FreeFaceField, FreeFaceField]:
        """Return the corrections for both faces on the scale of one half-width: much of the work is common to both."""
        length, sides = places[1] - places[0], (-1.0, 1.0)
        images = min(math.ceil(_SEEN * half_width / length), _MOST_IMAGES)
        farthest = max(_BEYOND * reach, (2.0 * images + 1.0) * length)
        waves = _Waves.of(poisson, half_width, farthest)
        near = waves.k * length < FARTHEST_APART
        loads = [spectrum(waves.k, place) for place in places]
        alone = [waves.alone(*group) for group in zip(loads, places, sides, strict=True)]
        for parts in zip(*alone, strict=True):
            odd = parts[0].is_odd
            images_of = replace(between, afar=None) if odd else between  # an odd load has no mean
            one, other = (
                images_of.projected(waves.field, waves.k[near], load.edges, load.steps[odd][near], place, side)
                for load, place, side in zip(loads, places, sides, strict=True)
            )
            changed = waves.field.between_faces(waves.k[near] * length, one, other, images)
            for part, coefficients in zip(parts, changed, strict=True):
                part.both = part.alone.copy()
                part.both[near] = coefficients
        low, high = (
            cls(place, side, half_width, farthest, length, images, waves, parts)
            for place, side, parts in zip(places, sides, alone, strict=True)
        )
        return low, high

    @cached_property
    def _of_stress(self) -> list[tuple[NDArray[np.bool_], NdBSpline]]:
        return [(part.turned, self._spline(part, part.both, slice(_STRESSES))) for part in self.parts]

    @cached_property
    def _of_displacement(self) -> list[tuple[NDArray[np.bool_], NdBSpline]]:
        return [(part.turned, self._spline(part, part.alone, slice(_STRESSES, COMPONENTS))) for part in self.parts]

    @cached_property
    def _grids(self) -> tuple[tuple[Array, Array, Array], Array, Array, Array]:
        """Knots of the table, logarithms of radii, and the matrices to coefficients from waves and values at radii."""
        across = _grid(0.0, np.arcsinh(self.farthest / (_ACROSS * self.half_width)), _ACROSS_STEP)
        radial = _grid(np.log(_CLOSEST * self.half_width), np.log(self.farthest), _RADIAL)
        (t_x, to_x), (t_r, to_r), (t_a, _) = _spline(across), _spline(radial), _of_angles()
        x = _ACROSS * self.half_width * np.sinh(across)[:, None]
        smoothed = _SMOOTHED * np.maximum(x - _FROM * self.half_width, 0.0)
        k, weight = self.waves.k, self.waves.weight
        waves = to_x @ (weight / np.pi * np.exp(1j * k * x - 0.5 * (k * smoothed) ** 2))
        return (t_x, t_r, t_a), radial, waves, to_r

    def _spline(self, part: _Part, coefficients: Array, of: slice) -> NdBSpline:
        """Return some components over x, the distance from the edge and the direction."""
        from scipy.interpolate import NdBSpline

        knots, radial, waves, to_r = self._grids
        k, odd = self.waves.k, _ODD[of]
        samples = self.waves.field.at_places(coefficients, of, k, radial).reshape(k.size, -1, odd.size)
        if of.start:
            samples = samples * (0.5 / k[:, None, None])
        wave = -1j * waves if part.is_odd else waves
        table = np.empty((waves.shape[0], *samples.shape[1:]))
        table[..., ~odd] = np.tensordot(wave.real, samples[..., ~odd], 1)
        table[..., odd] = np.tensordot(wave.imag, samples[..., odd], 1)
        table = to_r @ table.reshape(waves.shape[0], radial.size, -1)
        table = _of_angles()[1] @ table.reshape(*table.shape[:2], DIRECTIONS, -1)
        return NdBSpline(knots, table, 3)

    def stress(self, points: Array) -> Array:
        """Return the stress [MPa] at ``points`` (n, 3), shape (n, 6)."""
        total, apart = np.zeros((len(points), _STRESSES)), 2.0 * self.side * self.length
        ahead = [(1.0, -n * apart) for n in range(self.images + 1)]
        for sign, offset in [*ahead, *((-1.0, 2.0 * self.place + shift) for _, shift in ahead[1:])]:
            seen = np.column_stack([points[:, 0], sign * points[:, 1] + offset, points[:, 2]])
            where, nearer = self._seen(seen)
            part = sum(stress(where) * self._signs(points, turned)[:, :_STRESSES] for turned, stress in self._of_stress)
            total += nearer**2 * part * np.where(_ALONG[:_STRESSES], sign, 1.0)
        return total

    def displacement(self, points: Array) -> Array:
        """Return the shear modulus times the displacement [N/mm] at ``points`` (n, 3), shape (n, 3)."""
        where, nearer = self._seen(points)
        total = sum(
            moved(where) * self._signs(points, turned)[:, _STRESSES:] for turned, moved in self._of_displacement
        )
        return np.asarray(nearer * total)

    def _seen(self, points: Array) -> tuple[Array, Array]:
        """Return points moved into the table, and the ratio of distances: beyond the table the load acts as a point."""
        x, along, z = np.abs(points[:, 0]), np.maximum(self.side * (self.place - points[:, 1]), 0.0), points[:, 2]
        distance = np.hypot(along, z)
        nearer = self.farthest / np.maximum(np.hypot(x, distance), self.farthest)
        radial = np.log(np.maximum(distance * nearer, _CLOSEST * self.half_width))
        across = np.arcsinh(x * nearer / (_ACROSS * self.half_width))
        return np.column_stack([across, radial, np.arctan2(z, along)]), nearer[:, None]

    def _signs(self, points: Array, turned: NDArray[np.bool_]) -> Array:
        """Return the signs of components on this side of x = 0, seen from this face."""
        mirrored = np.where(_ALONG, -self.side, 1.0)
        return mirrored * np.where(turned & (points[:, :1] < 0.0), -1.0, 1.0)


def _wave_numbers(half_width: float, reach: float) -> tuple[Array, Array]:
    """Return wave numbers [1/mm] and their weights in an integral."""
    edges = [0.0, 0.5 / reach]
    while edges[-1] < _LARGEST / half_width:
        edges.append(edges[-1] + min(edges[-1], _STEP / half_width))
    node, weight = legendre.leggauss(_NODES)
    low, half = np.array(edges[:-1])[:, None], 0.5 * np.diff(edges)[:, None]
    k, weights = low + half * (1.0 + node), half * weight
    # Displacement grows as a logarithm towards k = 0.
    weights[0] *= 2.0 * k[0] / edges[1]
    k[0] *= k[0] / edges[1]
    return k.ravel(), weights.ravel()


def _grid(low: float, high: float, step: float) -> Array:
    """Return equal steps no longer than a given one."""
    return np.linspace(low, high, max(int(np.ceil((high - low) / step)), 3) + 1)


def _spline(grid: Array) -> tuple[Array, Array]:
    """Return the knots of cubic splines through values on a grid, and the matrix from values to coefficients."""
    from scipy.interpolate import make_interp_spline

    spline = make_interp_spline(grid, np.eye(grid.size), 3)
    return spline.t, spline.c


@cache
def _of_angles() -> tuple[Array, Array]:
    """Return the knots of splines over directions, and the matrix from the field's values to coefficients."""
    knots, to = _spline(_ANGLES)
    return knots, to @ between_angles(_ANGLES)
