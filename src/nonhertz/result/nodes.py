"""A contact on the nodes of a finite element mesh: pressures at the nodes, and forces that add up to the load.

The load of every strip is divided into small point loads across and along it. Each is distributed to the three nodes of
its triangle such that force and moments are preserved (barycentric coordinates, the shape functions of a linear
triangle). The triangles are those of Delaunay, since a list of nodes has no elements.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.inputs.checks import broadcast, numbers

if TYPE_CHECKING:
    from scipy.spatial import Delaunay

    from nonhertz.result.solution import Solution

Array = NDArray[np.float64]

_REMEDY = "give the coordinates of the nodes on the surface in mm"
_PER_SPACING = 6  # point loads per distance of two nodes, so that forces on neighbouring nodes are smooth
_MOST = 1000  # point loads across a strip, or along it


@dataclass(frozen=True, eq=False)
class NodalLoads:
    """A contact on the nodes of a mesh.

    Attributes
    ----------
    x, y : ndarray, shape (nodes,)
        Coordinates of the nodes [mm], across and along the contact.
    pressure : ndarray, shape (nodes,)
        Contact pressure at each node [MPa], zero out of contact. Pressures are samples: the load to which they
        integrate depends on the interpolation between the nodes.
    force : ndarray, shape (nodes,)
        Force on each node, normal to the surface [N]; NaN if the nodes span no area. The sum over all nodes is the load
        of the strips less ``outside``, and its moments about x and y are those of these strips.
    area : ndarray, shape (nodes,)
        A third of the area of the triangles around each node [mm^2].
    outside : float
        Load outside all triangles [N]: zero if the nodes surround the contact.
    """

    x: Array
    y: Array
    pressure: Array
    force: Array
    area: Array
    outside: float

    @property
    def interpolated_load(self) -> float:
        """The load of the pressures, interpolated linearly on the triangles [N]: the sum of pressure times area."""
        return float(self.pressure @ self.area)


def nodal_loads(solution: Solution, x: ArrayLike, y: ArrayLike) -> NodalLoads:
    """Return pressures and forces at nodes; see `nonhertz.Solution.at_nodes`."""
    from scipy.spatial import Delaunay, QhullError

    places = broadcast(_REMEDY, numbers("x", x, _REMEDY), numbers("y", y, _REMEDY))
    across, along = (np.ravel(place) for place in places)
    pressure = solution.pressure(across, along)
    try:
        mesh = Delaunay(np.column_stack([across, along]))
    except (QhullError, ValueError):  # fewer than three nodes, or all on a line
        nothing = np.full(across.shape, np.nan)
        return NodalLoads(
            across, along, pressure, nothing, np.zeros(across.shape), float(np.sum(_from_strips(solution)))
        )
    force, outside = _spread(solution, mesh)
    return NodalLoads(across, along, pressure, force, _areas(mesh), outside)


def _from_strips(solution: Solution) -> Array:
    return solution.line_load * solution.strip_width


def _spread(solution: Solution, mesh: Delaunay) -> tuple[Array, float]:
    """Return the forces on the nodes, and the load outside all triangles."""
    forces, outside = np.zeros(len(mesh.points)), 0.0
    spacing = _find_spacing(solution, mesh)
    for load, middle, width, half_width in zip(
        _from_strips(solution), solution.y, solution.strip_width, solution.half_width, strict=True
    ):
        if load > 0.0:
            places, shares = _point_loads(middle, width, half_width, spacing)
            triangles = mesh.find_simplex(places)
            inside = triangles >= 0
            outside += load * float(np.sum(shares[~inside]))
            nodes, weights = _barycentric(mesh, triangles[inside], places[inside])
            np.add.at(forces, nodes, load * shares[inside, None] * weights)
    return forces, outside


def _find_spacing(solution: Solution, mesh: Delaunay) -> tuple[float, float]:
    """Return the spacing across and along of nodes in contact, or of all nodes if none is in contact."""
    ends = np.concatenate([mesh.simplices[:, [0, 1]], mesh.simplices[:, [1, 2]], mesh.simplices[:, [2, 0]]])
    touching = solution.pressure(*mesh.points.T) > 0.0
    near = np.any(touching[ends], axis=1)
    first, last = mesh.points[ends[near] if np.any(near) else ends].transpose(1, 0, 2)
    across, along = np.abs(last - first).T
    return _usual(across), _usual(along)


def _usual(distances: Array) -> float:
    # In a rectangular mesh a third of the distances is zero.
    return float(np.median(distances[distances > 1e-6 * np.max(distances)]))


def _point_loads(middle: float, width: float, half_width: float, spacing: tuple[float, float]) -> tuple[Array, Array]:
    """Return places and shares of the point loads of a strip, whose pressure across is a semi-ellipse."""
    count = _count(2.0 * half_width, spacing[0])
    # Gauss-Chebyshev nodes of the second kind: their weight function is the semi-ellipse.
    angle = np.pi * np.arange(1, count + 1) / (count + 1)
    x, of_x = half_width * np.cos(angle), np.sin(angle) ** 2
    number = _count(width, spacing[1])
    y = middle + width * ((np.arange(number) + 0.5) / number - 0.5)
    places = np.stack(np.meshgrid(x, y), axis=-1).reshape(-1, 2)
    return places, np.tile(of_x / np.sum(of_x), number) / number


def _count(length: float, spacing: float) -> int:
    return int(np.clip(math.ceil(_PER_SPACING * length / spacing), 3, _MOST))


def _barycentric(mesh: Delaunay, triangles: NDArray[np.intp], places: Array) -> tuple[NDArray[np.intp], Array]:
    """Return the three nodes around each place, and their shares."""
    transform = mesh.transform[triangles]
    first = np.einsum("nij,nj->ni", transform[:, :2], places - transform[:, 2])
    return mesh.simplices[triangles], np.column_stack([first, 1.0 - np.sum(first, axis=1)])


def _areas(mesh: Delaunay) -> Array:
    a, b, c = (mesh.points[mesh.simplices[:, k]] for k in range(3))
    (ux, uy), (vx, vy) = (b - a).T, (c - a).T
    area = np.zeros(len(mesh.points))
    np.add.at(area, mesh.simplices, np.abs(ux * vy - uy * vx)[:, None] / 6.0)
    return area
