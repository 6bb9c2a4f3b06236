"""Correction for free side faces to the displacement of pressures and their images, on cells.

The correction at the distance u from a face for a load at the distance v (`nonhertz.bodies.quarter_space`) is, across
the contact, a sum of images and of pressures on half-planes at distances d_j (u + v), which have closed integrals over
the width of a cell. Along the contact it is not a convolution but a matrix, smooth on the scale of u and v: the first
cells from the face have a node each, the others share a few nodes on panels that double in size, with polynomial
interpolation. There are thus some sixty nodes whatever the number of cells, and the matrix is symmetric, as it must be.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

from nonhertz.bodies.influence import FreeSide
from nonhertz.bodies.quarter_space import free_face
from nonhertz.patch.grid import lagrange

Array = NDArray[np.float64]

NEAR = 8  # cells over which the logarithm at the edge is averaged, rather than taken at their centres
POINTS = 5  # in that average
# Nodes on a panel twice as far from the face at its end as at its start: the relative interpolation error is 1e-7.
NODES = 10


@dataclass(frozen=True, eq=False)
class FreeEnd:
    """The free side faces at one position, and the nodes of a grid that ends there or before.

    Attributes
    ----------
    faces : tuple of FreeSide
        One face, or two where both bodies end.
    dy : float
        Length of a cell [mm].
    nodes : ndarray, shape (nodes,)
        Distances from the face [mm], those of the near cells first.
    weights : ndarray, shape (ny, nodes)
        Matrix from values at nodes to those at the centres of rows.
    """

    faces: tuple[FreeSide, ...]
    dy: float
    nodes: Array
    weights: Array

    def gathered(self, pressure: Array) -> Array:
        """Return loads per width at the nodes [MPa mm], shape (..., nodes), from pressures of shape (..., ny)."""
        return self.dy * pressure @ self.weights

    def kernel(self, x_edges: Array) -> Array:
        """Return the displacement over K at nodes per unit of gathered load, for cells between edges across.

        Parameters
        ----------
        x_edges : ndarray, shape (m + 1,)
            Distances across [mm], ascending.

        Returns
        -------
        ndarray, shape (m, nodes, nodes)
            Symmetric in the last two.
        """
        count = self.nodes.size
        row, column = np.tril_indices(count)
        displacement = np.empty((x_edges.size - 1, count, count))
        displacement[:, row, column] = displacement[:, column, row] = self.pairwise(
            x_edges, self.nodes[row], self.nodes[column]
        )
        # Between the first cells it is averaged over the cell of the load.
        point, share = legendre.leggauss(POINTS)
        u = self.nodes[:NEAR]
        v = np.maximum(u[:, None] + 0.5 * self.dy * point, 0.0)
        places, loads = np.broadcast_arrays(u[:, None, None], v)
        sampled = self.pairwise(x_edges, places.ravel(), loads.ravel()).reshape(-1, *places.shape)
        averaged = 0.5 * sampled @ share
        displacement[:, : u.size, : u.size] = 0.5 * (averaged + averaged.transpose(0, 2, 1))
        return displacement

    def pairwise(self, x_edges: Array, u: Array, v: Array) -> Array:
        """Return the kernel for pairs of distances from the face, shape (m, pairs)."""
        total = np.zeros((x_edges.size - 1, u.size))
        for distance, of_image, of_plane in face_terms(self.faces, u, v):
            x = x_edges[:, None] / distance
            total += of_image * np.diff(np.arcsinh(x), axis=0) + of_plane * np.diff(np.arctan(x), axis=0)
        return total


def _nodes(start: float, dy: float, count: int) -> tuple[Array, Array]:
    """Return nodes for rows that begin at a distance from a face, and their weights, shape (count, nodes)."""
    from scipy.linalg import block_diag

    distance = start + dy * (np.arange(count, dtype=np.float64) + 0.5)
    near = min(NEAR, count)
    nodes, weights = [distance[:near]], [np.eye(near)]
    for first, beyond in _panels(start / dy, near, count):
        rows = distance[first:beyond]
        if rows.size <= NODES:
            nodes.append(rows)
            weights.append(np.eye(rows.size))
            continue
        angle = math.pi * (np.arange(NODES) + 0.5) / NODES
        nodes.append(0.5 * (rows[0] + rows[-1]) - 0.5 * dy * rows.size * np.cos(angle))
        weights.append(lagrange(rows, nodes[-1]))
    return np.concatenate(nodes), block_diag(*weights)


def _panels(cells_before: float, near: int, count: int) -> Iterator[tuple[int, int]]:
    """Yield first and last + 1 of the rows of each panel, twice as far from the face at its end as at its start."""
    first = near
    while first < count:
        beyond = min(2 * first + int(cells_before), count)
        yield first, beyond
        first = beyond


def free_ends(faces: tuple[FreeSide, ...], y: Array, dy: float) -> tuple[FreeEnd, ...]:
    """Return the free side faces, grouped by position, with nodes for rows of cells.

    Parameters
    ----------
    faces : tuple of FreeSide
        Faces of both bodies.
    y : ndarray, shape (ny,)
        Centres of the rows [mm], ascending.
    dy : float
        Length of a cell [mm].
    """
    ends = []
    faces = merge_faces(faces)
    for place, side in dict.fromkeys((face.y, face.side) for face in faces):
        nearest = float(y[0] if side < 0 else y[-1])
        nodes, weights = _nodes(max(side * (place - nearest) - 0.5 * dy, 0.0), dy, y.size)
        here = tuple(face for face in faces if (face.y, face.side) == (place, side))
        ends.append(FreeEnd(here, dy, nodes, weights if side < 0 else weights[::-1]))
    return tuple(ends)


def most_nodes(count: int) -> int:
    """Return an upper bound of the number of nodes of a free end on a number of rows."""
    near = min(NEAR, count)
    return near + sum(min(beyond - first, NODES) for first, beyond in _panels(0.0, near, count))


def merge_faces(faces: tuple[FreeSide, ...]) -> tuple[FreeSide, ...]:
    """Return side faces with those of equal position and Poisson's ratio merged into one share."""
    shares: dict[FreeSide, float] = {}
    for face in faces:
        alike = replace(face, share=0.0)
        shares[alike] = shares.get(alike, 0.0) + face.share
    return tuple(replace(alike, share=share) for alike, share in shares.items())


def at_points(faces: tuple[FreeSide, ...], x: Array, y: Array, x_force: Array, y_force: Array) -> Array:
    """Return the displacement over K at points per unit of force at others [1/mm], shape (places, forces)."""
    squared = np.square(x[:, None] - x_force)
    total = np.zeros(squared.shape)
    for face in faces:
        u, v = (np.maximum(face.side * (face.y - position), 0.0) for position in (y, y_force))
        for distance, of_image, of_plane in face_terms((face,), *np.broadcast_arrays(u[:, None], v)):
            away = squared + distance**2
            total += of_image / np.sqrt(away) + of_plane * distance / away
    return total


def face_terms(faces: tuple[FreeSide, ...], u: Array, v: Array) -> Iterator[tuple[Array, Array, Array]]:
    """Yield distances [mm], and the factors of 1 / r and of distance / r^2 there, r^2 = x^2 + distance^2."""
    for face_of_body in faces:
        face = free_face(face_of_body.poisson)
        of_direction = face_of_body.share * face.towards(u, v)
        for j, ratio in enumerate(face.distances):
            yield ratio * (u + v), of_direction[..., 0, j], of_direction[..., 1, j] / math.pi
