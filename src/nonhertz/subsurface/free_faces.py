"""What a free side face adds to the field of a pressure and its images, below one solution.

Images of full weight free a side face of shear and double its normal stress. What takes that away
(`nonhertz.bodies.quarter_space_field`) is summed over wave numbers k across the contact, once for each face, into a
table of splines over x, the distance from the edge and the direction there, which costs each point next to nothing. All
of the load counts, however far from the face: its normal stress falls only as the inverse of the distance.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING

import numpy as np
from numpy.polynomial import chebyshev, legendre
from numpy.typing import NDArray

from nonhertz.bodies.quarter_space_field import ANGLES, COMPONENTS, DIRECTIONS, DISTANCES, quarter_space_field

if TYPE_CHECKING:
    from scipy.interpolate import NdBSpline

Array = NDArray[np.float64]

# Six stresses and three displacements: which are odd in x under a load that is even, and which are odd in y.
_ODD = np.array([False, False, False, False, True, True, True, False, False])
_ALONG = np.array([False, False, False, True, False, True, False, True, False])
_STRESSES = 6

# Wave numbers over the inverse of the half-width: the largest, and the longest panel; and Gauss's nodes on each panel.
_LARGEST, _STEP, _NODES = 30.0, 2.5, 6
# Further across, in half-widths, cos(k x) turns too often for these nodes: the field is smoothed over a part of x.
_FROM, _SMOOTHED = 1.2, 0.15
_CLOSEST, _RADIAL = 0.05, 0.25  # distance from the edge, in half-widths, and steps of its logarithm
_ACROSS, _ACROSS_STEP = 0.8, 0.1  # x is 0.8 half-widths times sinh of these steps
_ANGLES = np.linspace(0.0, 0.5 * np.pi, 9)
_BEYOND = 2.0  # how far the table reaches, over the distance of the load's far end


@dataclass(frozen=True, eq=False)
class Spectrum:
    """A pressure that is constant along y between edges, by its cosine and sine transforms across.

    Attributes
    ----------
    edges : ndarray, shape (n,)
        Where the pressure changes [mm].
    even, odd : ndarray, shape (wave numbers, n)
        The transform [N/mm] before each edge less that behind it; ``odd`` is None for a symmetric pressure.
    """

    edges: Array
    even: Array
    odd: Array | None


@dataclass(frozen=True, eq=False)
class FreeFaceField:
    """What one free side face adds.

    Attributes
    ----------
    place, side : float
        Where the face is [mm]; -1 at the low, 1 at the high end of the body.
    half_width, farthest : float
        The half-width of the contact near the face, and how far the table reaches [mm].
    parts : tuple of (ndarray of bool, NdBSpline, NdBSpline)
        Of the even part of the pressure, and of the odd one if there is one: what changes its sign with x, and stress
        and the shear modulus times displacement over x, the distance from the edge and the direction.
    """

    place: float
    side: float
    half_width: float
    farthest: float
    parts: tuple[tuple[NDArray[np.bool_], NdBSpline, NdBSpline], ...]

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
        """Return what a face adds to a load that has a spectrum, and its far end at the distance ``reach`` [mm]."""
        from scipy.interpolate import NdBSpline

        field, (k, weight) = quarter_space_field(poisson), _wave_numbers(half_width, reach)
        farthest = _BEYOND * reach
        across = _grid(0.0, np.arcsinh(farthest / (_ACROSS * half_width)), _ACROSS_STEP)
        radial = _grid(np.log(_CLOSEST * half_width), np.log(farthest), _RADIAL)
        (t_x, to_x), (t_r, to_r), (t_a, to_a) = (_spline(each) for each in (across, radial, _ANGLES))
        by_distance = to_r @ _between_distances(np.log(k)[:, None] + radial)
        x = _ACROSS * half_width * np.sinh(across)[:, None]
        smoothed = _SMOOTHED * np.maximum(x - _FROM * half_width, 0.0)
        waves = to_x @ (weight / np.pi * np.exp(1j * k * x - 0.5 * (k * smoothed) ** 2))
        load, parts = spectrum(k, place), []
        for steps, turned, wave in ((load.even, _ODD, waves), (load.odd, ~_ODD, -1j * waves)):
            if steps is None:
                continue
            found = field.at_places(field.projected(k, side * (place - load.edges), -side * steps))
            found = by_distance @ found.reshape(k.size, DISTANCES.size, -1)
            found = to_a @ _between_angles() @ found.reshape(k.size, radial.size, DIRECTIONS, COMPONENTS)
            found[..., _STRESSES:] *= 0.5 / k[:, None, None, None]
            table = np.empty((x.size, *found.shape[1:]))
            for these, of in ((~_ODD, wave.real), (_ODD, wave.imag)):
                table[..., these] = np.tensordot(of, found[..., these], 1)
            stress, displacement = np.split(table, [_STRESSES], axis=-1)
            knots = t_x, t_r, t_a
            parts.append((turned, *(NdBSpline(knots, np.ascontiguousarray(c), 3) for c in (stress, displacement))))
        return cls(place, side, half_width, farthest, tuple(parts))

    def stress(self, points: Array) -> Array:
        """Return the stress [MPa] at ``points`` (n, 3), shape (n, 6)."""
        where, nearer = self._seen(points)
        found = sum(stress(where) * self._signs(points, turned)[:, :_STRESSES] for turned, stress, _ in self.parts)
        return np.asarray(nearer**2 * found)

    def displacement(self, points: Array) -> Array:
        """Return the shear modulus times the displacement [N/mm] at ``points`` (n, 3), shape (n, 3)."""
        where, nearer = self._seen(points)
        found = sum(moved(where) * self._signs(points, turned)[:, _STRESSES:] for turned, _, moved in self.parts)
        return np.asarray(nearer * found)

    def _seen(self, points: Array) -> tuple[Array, Array]:
        """Return where points are in the table, and by how much nearer than they are: beyond it a load is a point."""
        x, along, z = np.abs(points[:, 0]), np.maximum(self.side * (self.place - points[:, 1]), 0.0), points[:, 2]
        distance = np.hypot(along, z)
        nearer = self.farthest / np.maximum(np.hypot(x, distance), self.farthest)
        radial = np.log(np.maximum(distance * nearer, _CLOSEST * self.half_width))
        across = np.arcsinh(x * nearer / (_ACROSS * self.half_width))
        return np.column_stack([across, radial, np.arctan2(z, along)]), nearer[:, None]

    def _signs(self, points: Array, turned: NDArray[np.bool_]) -> Array:
        """Return the signs that components have on this side of x = 0, seen from this face."""
        mirrored = np.where(_ALONG, -self.side, 1.0)
        return mirrored * np.where(turned & (points[:, :1] < 0.0), -1.0, 1.0)


def _wave_numbers(half_width: float, reach: float) -> tuple[Array, Array]:
    """Return wave numbers [1/mm] and their weights in an integral."""
    edges = [0.0, 0.25 / reach]
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
    """Return equal steps that are no longer than the given one."""
    return np.linspace(low, high, max(int(np.ceil((high - low) / step)), 3) + 1)


def _spline(grid: Array) -> tuple[Array, Array]:
    """Return the knots of cubic splines through values on a grid, and the matrix from values to coefficients."""
    from scipy.interpolate import make_interp_spline

    spline = make_interp_spline(grid, np.eye(grid.size), 3)
    return spline.t, spline.c


def _between_distances(logarithm: Array) -> Array:
    """Return the matrices from values at `DISTANCES` to values between them; nothing is left beyond."""
    from scipy.interpolate import CubicSpline

    known = np.log(DISTANCES)
    found: Array = CubicSpline(known, np.eye(known.size))(np.clip(logarithm, known[0], known[-1]))
    found[logarithm > known[-1]] = 0.0
    return found


@cache
def _between_angles() -> Array:
    """Return the matrix from values at `ANGLES` to those on the table's directions."""
    table, given = (chebyshev.chebvander(4.0 / np.pi * each - 1.0, DIRECTIONS - 1) for each in (_ANGLES, ANGLES))
    return np.asarray(table @ np.linalg.inv(given))
