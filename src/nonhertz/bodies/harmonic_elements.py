"""Spectral finite elements for a solid cylinder under pressure that varies as cos(n theta).

In the plane of radius r and axial position z, displacement is (u cos, v sin, w cos) of n theta, and the energy that of
three-dimensional elasticity. Elements are products of polynomials through Gauss-Lobatto nodes; they shrink towards the
edge between surface and end face. Lengths are in radii. Only half of the length is solved for: loads are even or odd.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

Array = NDArray[np.float64]
#: One term of a strain: component of displacement, functions of r and of z at quadrature points, factor.
Term = tuple[int, Array, Array, float]

DEGREE = 6
_SMALLEST, _GROWTH, _LARGEST = 0.1, 2.6, 0.6  # sizes of elements [radii]
U, V, W = range(3)


@dataclass(frozen=True)
class Cylinder:
    """A solid cylinder with end faces free of stress, from its middle to one of them.

    Parameters
    ----------
    half_length : float
        Half its length [radii].
    poisson : float
        Poisson's ratio.
    """

    half_length: float
    poisson: float

    def compressed(self, n: int, loads: Sequence[Callable[[Array], Array]], places: Array) -> Array:
        """Return how far the surface moves inwards under pressures cos(n theta) f(z).

        Parameters
        ----------
        n : int
            Number of waves around, even.
        loads : sequence of callable
            z [radii] -> f; even and odd functions in turn.
        places : ndarray, shape (m,)
            Where, from the middle [radii].

        Returns
        -------
        ndarray, shape (m, loads)
            Over the pressure's amplitude, the radius and K = (1 - nu^2) / (pi E).
        """
        # Imported here, because most contacts need no finite elements.
        from scipy.sparse.linalg import splu

        radial, axial = _breaks(1.0), _breaks(self.half_length)
        rows, columns = _count(radial), _count(axial)
        stiffness, forces = self._stiffness(n, radial, axial), self._forces(loads, rows, axial)
        moved = np.zeros_like(forces)
        for odd in (False, True):
            free = _free(n, rows, columns, odd=odd)
            matrix = stiffness[free][:, free].tocsc()
            factors = splu(matrix, "MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True})
            these = slice(int(odd), None, 2)
            moved[free, these] = factors.solve(forces[free, these])
        surface = moved[: rows * columns].reshape(rows, columns, -1)[-1]
        # The shear modulus is 1: 1 / mu = 2 pi K / (1 - nu).
        found: Array = -2.0 * np.pi / (1.0 - self.poisson) * _interpolated(axial, surface, np.abs(places))
        found[:, 1::2] *= np.sign(places)[:, None]
        return found

    def _forces(self, loads: Sequence[Callable[[Array], Array]], rows: int, axial: Array) -> Array:
        """Return the forces of pressures on the surface, shape (unknowns, loads)."""
        forces = np.zeros((3, rows, _count(axial), len(loads)))
        node, weight = legendre.leggauss(DEGREE + 1)
        values, _ = _polynomials(node)
        for e, (low, high) in enumerate(itertools.pairwise(axial)):
            z, half = 0.5 * (low + high) + 0.5 * (high - low) * node, 0.5 * (high - low)
            pressure = np.array([load(z) for load in loads]).T
            forces[U, -1, e * DEGREE : (e + 1) * DEGREE + 1] -= half * values.T @ (weight[:, None] * pressure)
        return forces.reshape(-1, len(loads))

    def _stiffness(self, n: int, radial: Array, axial: Array):  # type: ignore[no-untyped-def]  # scipy has no types
        from scipy import sparse

        rows, columns, nodes = _count(radial), _count(axial), DEGREE + 1
        local = np.arange(nodes)
        values, to_row, to_column = [], [], []
        for i, inner in enumerate(radial[:-1]):
            for j, low in enumerate(axial[:-1]):
                matrix = self._element(n, (inner, radial[i + 1]), (low, axial[j + 1]))
                of_component = rows * columns * np.arange(3)[:, None, None]
                unknown = (of_component + columns * (i * DEGREE + local)[:, None] + j * DEGREE + local).ravel()
                values.append(matrix.ravel())
                to_row.append(np.repeat(unknown, unknown.size))
                to_column.append(np.tile(unknown, unknown.size))
        places = np.concatenate(to_row), np.concatenate(to_column)
        size = 3 * rows * columns
        return sparse.csc_matrix((np.concatenate(values), places), shape=(size, size))

    def _element(self, n: int, radial: tuple[float, float], axial: tuple[float, float]) -> Array:
        """Return the stiffness of one element between two radii and two axial positions."""
        node, weight = legendre.leggauss(DEGREE + 1)
        values, slopes = _polynomials(node)
        half_r, half_z = 0.5 * (radial[1] - radial[0]), 0.5 * (axial[1] - axial[0])
        radius = radial[0] + half_r * (1.0 + node)
        by_r, along_r, over_r = values, slopes / half_r, values / radius[:, None]
        by_z, along_z = values, slopes / half_z
        strain_r: list[Term] = [(U, along_r, by_z, 1.0)]
        strain_t: list[Term] = [(U, over_r, by_z, 1.0), (V, over_r, by_z, n)]
        strain_z: list[Term] = [(W, by_r, along_z, 1.0)]
        shear_rt: list[Term] = [(U, over_r, by_z, -n), (V, over_r, by_z, -1.0), (V, along_r, by_z, 1.0)]
        shear_rz: list[Term] = [(U, by_r, along_z, 1.0), (W, along_r, by_z, 1.0)]
        shear_tz: list[Term] = [(V, by_r, along_z, 1.0), (W, over_r, by_z, -n)]
        parts = [
            ([*strain_r, *strain_t, *strain_z], 2.0 * self.poisson / (1.0 - 2.0 * self.poisson)),
            (strain_r, 2.0), (strain_t, 2.0), (strain_z, 2.0),
            (shear_rt, 1.0), (shear_rz, 1.0), (shear_tz, 1.0),
        ]  # fmt: skip
        size = DEGREE + 1
        matrix = np.zeros((3, size, size, 3, size, size))
        for terms, modulus in parts:
            for one, one_r, one_z, factor in terms:
                for other, other_r, other_z, other_factor in terms:
                    of_r = np.einsum("qi,qj,q->ij", one_r, other_r, half_r * weight * radius)
                    of_z = np.einsum("qi,qj,q->ij", one_z, other_z, half_z * weight)
                    product = np.einsum("ij,kl->ikjl", of_r, of_z)
                    matrix[one, :, :, other] += modulus * factor * other_factor * product
        return matrix.reshape(3 * size * size, -1)


def _breaks(length: float) -> Array:
    """Return the borders of elements from 0 to a length, which shrink towards its end."""
    found, size = [length], min(_SMALLEST, 0.5 * length)
    while found[-1] - size > 0.4 * size:
        found.append(found[-1] - size)
        size = min(_GROWTH * size, _LARGEST)
    return np.array([*found[:0:-1], length]) if found[-1] == 0.0 else np.array([0.0, *found[::-1]])


def _count(breaks: Array) -> int:
    return DEGREE * (breaks.size - 1) + 1


def _free(n: int, rows: int, columns: int, *, odd: bool) -> NDArray[np.int64]:
    """Return the unknowns that are not zero on the axis or in the middle, by symmetry."""
    held = np.zeros((3, rows, columns), dtype=bool)
    held[:2, 0] = True
    if n:
        held[W, 0] = True
    else:
        held[V] = True  # no torsion
    held[[U, V] if odd else [W], :, 0] = True
    if odd and n == 0:
        held[W, 0, 0] = True  # a motion along the axis
    return np.flatnonzero(~held)


@cache
def _nodes() -> Array:
    """Return the Gauss-Lobatto nodes."""
    inner = legendre.legroots(legendre.legder(np.eye(DEGREE + 1)[DEGREE]))
    return np.concatenate([[-1.0], np.sort(inner.real), [1.0]])


def _polynomials(places: Array) -> tuple[Array, Array]:
    """Return values and slopes of the polynomials through the nodes at places from -1 to 1, shape (places, nodes)."""
    from_nodes = np.linalg.inv(legendre.legvander(_nodes(), DEGREE))
    slopes = np.array([legendre.legval(places, legendre.legder(unit)) for unit in np.eye(DEGREE + 1)]).T
    return legendre.legvander(places, DEGREE) @ from_nodes, slopes @ from_nodes


def _interpolated(breaks: Array, values: Array, places: Array) -> Array:
    """Return nodal values (nodes, k) at places."""
    found = []
    for place in places:
        e = int(np.clip(np.searchsorted(breaks, place) - 1, 0, breaks.size - 2))
        local = (2.0 * place - breaks[e] - breaks[e + 1]) / (breaks[e + 1] - breaks[e])
        weights, _ = _polynomials(np.array([local]))
        found.append(weights[0] @ values[e * DEGREE : (e + 1) * DEGREE + 1])
    return np.array(found)
