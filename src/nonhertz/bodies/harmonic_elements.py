"""Spectral finite elements for a body of revolution under pressure that varies as cos(n theta).

In the plane of radius r and axial position z, displacement is (u cos, v sin, w cos) of n theta, and the energy is that
of three-dimensional elasticity. Elements are products of polynomials through Gauss-Lobatto nodes, in z and in the
fraction s of the wall from the bore or the axis to the surface; they shrink towards the edges between surface and side
faces. Lengths are in radii of the surface. Where the outline is symmetric, only half of the length is solved. The core
solves the equations; the mesh is laid and results are evaluated here.
"""

from __future__ import annotations

import itertools
import math
import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache, cached_property

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

from nonhertz.model.outline import Outline
from nonhertz.native import core

Array = NDArray[np.float64]

DEGREE = 6
# Sizes of elements [radii] at edges, per unit of distance from them, and at most along the axis and through the wall.
_FINEST, _GROWTH, _LARGEST_ALONG, _LARGEST_ACROSS = 0.036, 0.96, 0.4, 0.35
_BY_WAVE = 0.86  # size of the smallest element times the largest number of waves around
_NODES = DEGREE + 1
_GROWN = 2.6  # size of an element that begins at a corner over that of the one on the other side
_FINE_BORDERS = 801  # points between which borders of elements are interpolated
_FINE = 65  # points from a corner to half-way to the next at which sizes of elements are evaluated
_LOAD_NODES = 16  # on an element's surface, where loads are polynomials of a high degree


@dataclass(frozen=True)
class HarmonicElements:
    """A body of revolution whose side faces, and bore if it has one, are free of stress.

    Parameters
    ----------
    outline : Outline
        A section through its axis.
    poisson : float
        Poisson's ratio.
    most : float
        The largest number of waves around.
    longest : float
        The longest element along the axis [radii], where the loads need shorter ones than the body.
    """

    outline: Outline
    poisson: float
    most: float
    longest: float = _LARGEST_ALONG

    def forces(self, loads: Callable[[Array], Array]) -> Array:
        """Return the nodal forces of loads normal to the surface that vary as cos(n theta).

        Parameters
        ----------
        loads : callable
            z [radii], shape (m,) -> force of each load on an arc of 1 rad per length of the surface, shape (m, loads);
            even and odd functions in turn where the outline is symmetric, evaluated for z > 0 only.

        Returns
        -------
        ndarray, shape (loads, 2, columns)
            Radial and axial forces on the nodes of the surface.
        """
        node, weight = legendre.leggauss(_LOAD_NODES)
        values, _ = nodal_polynomials(node)
        half = 0.5 * np.diff(self.axial_borders)[:, None]
        z = self.axial_borders[:-1, None] + half * (1.0 + node)
        pressure = loads(z.ravel()).reshape(*z.shape, -1) * (half * weight)[..., None]
        slope = self.outline.slopes(z.ravel())[0].reshape(*z.shape, 1)
        forces = np.zeros((pressure.shape[-1], 2, self.columns))
        for e, on_element in enumerate(pressure):
            nodes = slice(e * DEGREE, (e + 1) * DEGREE + 1)
            forces[:, 0, nodes] -= on_element.T @ values
            forces[:, 1, nodes] += (slope[e] * on_element).T @ values
        return forces

    def work(self, modes: Sequence[int], forces: Array, readings: Array | None = None) -> Array:
        """Return the work over K = (1 - nu^2) / (pi E) of forces on the displacement by other forces.

        Parameters
        ----------
        modes : sequence of int
            Numbers of waves around, without 1. Under axisymmetric forces (0) a rib is assumed to take up their axial
            component.
        forces, readings : ndarray, shape (loads, 2, columns)
            Nodal forces, as `forces` returns them: those that cause the displacement, and those whose work is returned,
            by default the same.

        Returns
        -------
        ndarray, shape (modes, readings, loads)
        """
        loads = forces.reshape(len(forces), -1)
        other = loads[:0] if readings is None else readings.reshape(len(readings), -1)
        return np.array(self._solver.works(list(modes), loads, other, threads=os.cpu_count() or 1))

    def displaced(self, n: int, forces: Array) -> Array:
        """Return the nodal displacements over K = (1 - nu^2) / (pi E) by forces, as `work` takes them.

        Returns
        -------
        ndarray, shape (loads, 3, rows, columns)
            By component (u, v, w), then along the wall, then along the axis.
        """
        moved = self._solver.displacement(n, forces.reshape(len(forces), -1))
        return np.reshape(moved, (-1, 3, self.rows, self.columns))

    def stress(self, n: int, displaced: Array, shares: Array, places: Array) -> Array:
        """Return the stress of nodal displacements, as `displaced` returns them.

        Parameters
        ----------
        n : int
            Number of waves around.
        displaced : ndarray, shape (loads, 3, rows, columns)
            Nodal displacements over K.
        shares : ndarray, shape (s,)
            Positions through the wall, from 0 at the bore or the axis to 1 at the surface.
        places : ndarray, shape (m,)
            Axial positions from the middle [radii]; not negative where the outline is symmetric.

        Returns
        -------
        ndarray, shape (s, m, 6, loads)
            The factors of cos(n theta) in the stresses rr, tt, yy and ry, and of sin(n theta) in rt and ty.
        """
        (value_s, slope_s), (value_z, slope_z) = (
            _interpolation_matrices(self.wall_borders, shares),
            _interpolation_matrices(self.axial_borders, places),
        )
        nodal = (1.0 - self.poisson) / (2.0 * np.pi) * displaced
        moved, along_s, along_z = (
            np.einsum("si,mcij,pj->cspm", one, nodal, other, optimize=True)
            for one, other in ((value_s, value_z), (slope_s, value_z), (value_s, slope_z))
        )
        (outer, inner), (outer_slope, inner_slope) = self.outline.radii(places), self.outline.slopes(places)
        wall, share = outer - inner, shares[:, None]
        radius = (inner + share * wall)[..., None]
        shift = (-(inner_slope + share * (outer_slope - inner_slope)) / wall)[..., None]
        (u, v, w), (u_r, v_r, w_r) = moved, along_s / wall[:, None]
        u_z, v_z, w_z = along_z + shift * along_s
        hoop = (u + n * v) / radius
        mean = 2.0 * self.poisson / (1.0 - 2.0 * self.poisson) * (u_r + hoop + w_z)
        shears = v_r - (v + n * u) / radius, u_z + w_r, v_z - n * w / radius
        return np.stack([mean + 2.0 * u_r, mean + 2.0 * hoop, mean + 2.0 * w_z, *shears], axis=2)

    @cached_property
    def axial_borders(self) -> Array:
        """Borders of the elements along the axis [radii], shape (elements + 1,)."""
        half = borders_towards_end(self.outline.half_length, self._finest, _GROWTH, min(_LARGEST_ALONG, self.longest))
        if self.outline.symmetric:
            return with_kinks(half, tuple(kink for kink in self.outline.kinks if kink > 0.0), self._finest)
        return with_kinks(np.concatenate([-half[:0:-1], half]), self.outline.kinks, self._finest)

    @cached_property
    def wall_borders(self) -> Array:
        """Borders of elements from the bore or the axis to the surface, as fractions of the wall."""
        wall = self.outline.wall
        return borders_towards_end(wall, self._finest, _GROWTH, _LARGEST_ACROSS) / wall

    @property
    def _finest(self) -> float:
        return min(_FINEST, _BY_WAVE / self.most)

    @property
    def rows(self) -> int:
        """Nodes through the wall."""
        return DEGREE * (self.wall_borders.size - 1) + 1

    @property
    def columns(self) -> int:
        """Nodes along the axis."""
        return DEGREE * (self.axial_borders.size - 1) + 1

    @cached_property
    def _solver(self) -> core.HarmonicElements:
        node, weight = legendre.leggauss(_NODES)
        borders = self.axial_borders
        z = borders[:-1, None] + 0.5 * np.diff(borders)[:, None] * (1.0 + node)
        sections = *self.outline.radii(z), *self.outline.slopes(z)
        return core.HarmonicElements(
            self.poisson, self.wall_borders, borders, *sections, *nodal_polynomials(node), node, weight,
            bored=self.outline.bored, symmetric=self.outline.symmetric,
        )  # fmt: skip


@cache
def _from_nodes() -> tuple[Array, Array]:
    """Return the matrices from values at the Gauss-Lobatto nodes to Legendre coefficients, and to those of slopes."""
    inner = legendre.legroots(legendre.legder(np.eye(_NODES)[DEGREE]))
    nodes = np.concatenate([[-1.0], np.sort(inner.real), [1.0]])
    coefficients = np.linalg.inv(legendre.legvander(nodes, DEGREE))
    return coefficients, np.asarray(legendre.legder(coefficients), dtype=np.float64)


def nodal_polynomials(places: Array) -> tuple[Array, Array]:
    """Return values and slopes of the nodal polynomials at places from -1 to 1, shape (places, nodes)."""
    values, slopes = _from_nodes()
    return legendre.legvander(places, DEGREE) @ values, legendre.legvander(places, DEGREE - 1) @ slopes


def _interpolation_matrices(borders: Array, places: Array) -> tuple[Array, Array]:
    """Return the matrices from nodal values to values and slopes at places, shape (places, nodes)."""
    e = np.clip(np.searchsorted(borders, places) - 1, 0, borders.size - 2)
    half = 0.5 * np.diff(borders)[e]
    values, slopes = nodal_polynomials((places - borders[e]) / half - 1.0)
    matrices = np.zeros((2, places.size, DEGREE * (borders.size - 1) + 1))
    rows, columns = np.arange(places.size)[:, None], e[:, None] * DEGREE + np.arange(_NODES)
    matrices[0, rows, columns], matrices[1, rows, columns] = values, slopes / half[:, None]
    return matrices[0], matrices[1]


def borders_towards_end(length: float, finest: float, growth: float, largest: float) -> Array:
    """Return borders of elements from 0 to a length; the elements shrink towards its end.

    An element at a distance d from the end is ``finest + growth * d`` long, at most ``largest``. The borders divide the
    integral of the density of elements evenly, so that a small change of the length moves all of them slightly.
    """
    distance = length * np.linspace(0.0, 1.0, _FINE_BORDERS) ** 2
    density = 1.0 / np.minimum(finest + growth * distance, largest)
    elements = np.concatenate([[0.0], np.cumsum(0.5 * np.diff(distance) * (density[1:] + density[:-1]))])
    count = max(2, math.ceil(elements[-1]))
    borders: Array = length - np.interp(elements[-1] * np.linspace(1.0, 0.0, count + 1), elements, distance)
    borders[0], borders[-1] = 0.0, length
    return borders


def with_kinks(borders: Array, kinks: tuple[float, ...], smallest: float) -> Array:
    """Return borders of elements that include the kinks, next to which elements are no larger than between them.

    Elements grow in proportion to their distance from a kink: beside the short wall of a step they are as short as this
    wall.
    """
    if not kinks:
        return borders
    places = np.array([borders[0], *kinks, borders[-1]])
    gaps = np.diff(places)
    finest = np.minimum(np.minimum(gaps[:-1], gaps[1:]), smallest)
    pieces = [places[:1]]
    for low, high in itertools.pairwise(places.tolist()):
        # Distances down to that at which elements no longer shrink.
        near = np.geomspace(min(0.1 * np.min(finest) / (high - low), 0.1), 0.5, _FINE)
        fine = low + (high - low) * np.concatenate([[0.0], near, 1.0 - near[-2::-1], [1.0]])
        fine[-1] = high
        middle = 0.5 * (fine[1:] + fine[:-1])
        at = np.clip(np.searchsorted(borders, middle) - 1, 0, borders.size - 2)
        allowed = np.min(finest + (_GROWN - 1.0) * np.abs(middle[:, None] - places[1:-1]), axis=1)
        elements = np.concatenate([[0.0], np.cumsum(np.diff(fine) / np.minimum(np.diff(borders)[at], allowed))])
        count = max(1, round(elements[-1]))
        pieces.append(np.interp(np.arange(1, count + 1) * elements[-1] / count, elements, fine))
    return np.concatenate(pieces)
