"""The field inside the elastic quarter-space: correction for a free side face below the surface.

The loads T of `nonhertz.bodies.quarter_space`, a pressure f on the surface and g on the side face, each mirrored,
belong to a load that varies as cos(k x) along the edge; this module computes their field in the body. With distances
multiplied by k, a line load on a half-space at the distance s along its surface and r from the point causes, at the
depth d, the stresses and displacements

    sigma_d = P_d - d P_dd                            tau_sd = -d P_sd               P = K0(r) / pi
    sigma_s = -m (Q - P_d) - d P_ss + 2 nu P_d        tau_xs = m Q_s + d P_s         Q = -S / pi
    sigma_x = m Q + d P + 2 nu P_d                    tau_xd = d P_d                 m = 1 - 2 nu
    2 G u_x = m Q + d P     2 G u_s = -m Q_s - d P_s      2 G u_d = 2 (1 - nu) P - d P_d

where S is the integral of K0 over the depth to infinity and indices are derivatives; tau_xs, tau_xd and u_x vary as
sin(k x), the others as cos(k x). All are linear in nu, so that one table serves all materials.

Towards the edge f and g grow as a logarithm, and only the sum of their fields is bounded: neither may be cut off alone.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache, cached_property, lru_cache

import numpy as np
from numpy.polynomial import chebyshev, legendre
from numpy.typing import NDArray

from nonhertz.bodies.quarter_space import NODES, corner_operator, interpolation, nodes_on, to_legendre
from nonhertz.bodies.stored import MOST, cache_on_disk
from nonhertz.native import core

Array = NDArray[np.float64]

# Points at which the field is tabulated: distances from the edge times k, and directions from the surface to the face.
DISTANCES = np.geomspace(1e-5, 18.0, 42)
DIRECTIONS = 8
ANGLES = 0.25 * np.pi * (1.0 - np.cos(np.pi * np.arange(DIRECTIONS) / (DIRECTIONS - 1)))
OFF_THE_PLANES = 1e-5  # rad: on a loaded plane itself the kernels are singular
COMPONENTS = 9  # six stresses and three displacements
# Between these Poisson's ratios, up to 0.5, the field is interpolated to 1e-5; below -0.5 it is extrapolated.
POISSONS = 0.5 * chebyshev.chebpts1(8)
_RANK_ERROR = 1e-6  # of the largest singular value
FARTHEST_APART = 12.0
_APART = np.geomspace(0.01, FARTHEST_APART, 20)  # distances between two faces times k
_DEPTH_NODES = 40
_FARTHEST = 40.0  # beyond which K0 is negligible
# From (d, s, x, xs, xd, sd; u_x, u_s, u_d) to (x, y, z, yz, xz, xy; u_x, u_y, u_z) of loads on surface and side face.
_OF_SURFACE, _OF_FACE = [2, 1, 0, 5, 4, 3, 6, 7, 8], [2, 0, 1, 5, 3, 4, 6, 8, 7]


@dataclass(frozen=True, eq=False)
class QuarterSpaceField:
    """Correction for a free side face to the field of loads and their mirror images, for loads that vary as cos(k x).

    Attributes
    ----------
    panels : ndarray, shape (panels + 1,)
        Edges of the panels on which loads are polynomials, distances from the edge times k.
    loads : ndarray, shape (nodes, rank)
        Matrix from the load on the nodes' parts of the surface to coefficients.
    residuals : ndarray, shape (nodes, rank)
        Matrix from a prescribed normal pressure on the side face at the nodes to coefficients.
    places : ndarray, shape (distances, directions, components, rank)
        Arrays from coefficients to stresses, and displacements times 2 G k, at `DISTANCES` and `ANGLES`.
    """

    panels: Array
    loads: Array
    residuals: Array
    places: Array

    def projected(self, k: Array, edges: Array, steps: Array) -> Array:
        """Return coefficients of a load that is constant along y between edges.

        Parameters
        ----------
        k : ndarray, shape (m,)
            Wave numbers [1/mm].
        edges : ndarray, shape (n,)
            Distances from the side face [mm].
        steps : ndarray, shape (m, n)
            Steps of the load at the edges [N/mm]: load before each edge minus load beyond it.

        Returns
        -------
        ndarray, shape (m, rank)
        """
        loads: Array = core.at_nodes(self.panels, to_legendre(), _gauss_weights(), k, edges, steps) @ self.loads
        return loads

    def at_places(self, coefficients: Array, components: slice, k: Array, log_r: Array) -> Array:
        """Return some components of the field at distances from the edge; zero beyond `DISTANCES`.

        Parameters
        ----------
        coefficients : ndarray, shape (m, rank)
            Coefficients for the wave numbers ``k`` [1/mm].
        log_r : ndarray, shape (n,)
            Logarithms of distances [mm], ascending.

        Returns
        -------
        ndarray, shape (m, n, directions, components)
        """
        knots, splines = self._by_distance
        of = splines[:, :, components]
        of_waves = coefficients @ of.reshape(-1, of.shape[-1]).T
        field = core.between_distances(knots, np.log(k), log_r, of_waves)
        return field.reshape(k.size, log_r.size, DIRECTIONS, -1)

    @cached_property
    def _by_distance(self) -> tuple[Array, Array]:
        """Knots and coefficients of the splines through `places`."""
        from scipy.interpolate import make_interp_spline

        spline = make_interp_spline(np.log(DISTANCES), self.places, 3)
        return spline.t, spline.c

    @cached_property
    def _across(self) -> Callable[[Array], Array]:
        """Logarithm of a distance times k -> matrix from the coefficients of this face to those of a face there."""
        from scipy.interpolate import CubicSpline

        depth, _ = nodes_on(self.panels)
        changes = []
        for distance in _APART:
            by_distance = between_distances(np.log(np.hypot(distance, depth)))
            by_angle = between_angles(np.arctan2(depth, distance))
            normal = np.einsum("nj,nd,jdr->nr", by_distance, by_angle, self.places[:, :, 1])
            changes.append(normal.T @ self.residuals)
        change: Callable[[Array], Array] = CubicSpline(np.log(_APART), np.array(changes))
        return change

    def between_faces(self, distance: Array, one: Array, other: Array, images: int) -> tuple[Array, Array]:
        """Return the coefficients of two faces that together remove the stress that each leaves on the other.

        Parameters
        ----------
        distance : ndarray, shape (m,)
            Between the faces, times k.
        one, other : ndarray, shape (m, rank)
            Coefficients of both without the other.
        images : int
            Number of mirror images of each correction on either side, twice the distance apart: they lie at even
            multiples of the distance from the face's own plane, at odd multiples from the other.
        """

        def seen(times: int) -> Array:
            apart = times * distance
            change = self._across(np.log(np.clip(apart, _APART[0], FARTHEST_APART)))
            return np.where(apart < FARTHEST_APART, change.T, 0.0).T

        even = np.eye(one.shape[1]) + 2.0 * sum(seen(2 * n) for n in range(1, images + 1))
        odd = 2.0 * sum(seen(2 * n - 1) for n in range(1, images + 1)) + seen(2 * images + 1)
        same, opposed = (
            np.linalg.solve((even + sign * odd).transpose(0, 2, 1), (one + sign * other)[..., None])[..., 0]
            for sign in (1.0, -1.0)
        )
        return 0.5 * (same + opposed), 0.5 * (same - opposed)


@cache
def _gauss_weights() -> Array:
    return legendre.leggauss(NODES)[1]


def between_distances(logarithm: Array) -> Array:
    """Return the matrices from values at `DISTANCES` to values between them; zero beyond."""
    from scipy.interpolate import CubicSpline

    known = np.log(DISTANCES)
    matrix: Array = CubicSpline(known, np.eye(known.size))(np.clip(logarithm, known[0], known[-1]))
    matrix[logarithm > known[-1]] = 0.0
    return matrix


def between_angles(angle: Array) -> Array:
    """Return the matrix from values at `ANGLES` to values between them."""
    between, at_nodes = (chebyshev.chebvander(4.0 / np.pi * angles - 1.0, DIRECTIONS - 1) for angles in (angle, ANGLES))
    return np.asarray(between @ np.linalg.inv(at_nodes))


@lru_cache(MOST)
def quarter_space_field(poisson: float) -> QuarterSpaceField:
    """Return the field of a material."""
    panels, y, _, _, _ = corner_operator(poisson)
    table, count = _table(), DISTANCES.size * DIRECTIONS * COMPONENTS
    of_materials = table[count:].reshape(POISSONS.size, 2, y.size, -1)
    degree = POISSONS.size - 1
    share = chebyshev.chebvander(2.0 * poisson, degree) @ np.linalg.inv(chebyshev.chebvander(2.0 * POISSONS, degree))
    loads, residuals = np.tensordot(share.ravel(), of_materials, 1)
    return QuarterSpaceField(
        panels, loads, residuals, table[:count].reshape(DISTANCES.size, DIRECTIONS, COMPONENTS, -1)
    )


@cache_on_disk(__name__, "nonhertz.bodies.quarter_space")
def _table() -> Array:
    """Return a low-rank form of the field of any load for all `POISSONS`: the points, followed by the loads."""
    panels, y, weight, _, _ = corner_operator(0.0)
    rows = []
    for distance in DISTANCES:
        for angle in np.clip(ANGLES, OFF_THE_PLANES, 0.5 * np.pi - OFF_THE_PLANES):
            along, below = distance * np.cos(angle), distance * np.sin(angle)
            by_surface = _rule(panels, y, weight, along, below)[:, _OF_SURFACE]
            rows.append((by_surface, _rule(panels, y, weight, below, along)[:, _OF_FACE]))
    surface, face = (np.concatenate(parts, axis=1) for parts in zip(*rows, strict=True))
    # Columns weighted for loads given as integrals over the nodes' parts of the surface.
    scale = np.sqrt(weight)
    of_places, of_residuals, to_residual = [], [], []
    for poisson in POISSONS:
        operator = corner_operator(poisson)[-1]
        # g removes the stress that mirrored loads leave on the face, and causes f on the surface.
        of_face = np.linalg.inv(np.eye(y.size) - operator @ operator)
        of_surface = operator @ of_face
        field = (surface[0] + poisson * surface[1]) @ of_surface - (face[0] + poisson * face[1]) @ of_face
        of_residuals.append(field)
        to_residual.append(operator / weight)
        basis, values = _low_rank(field @ to_residual[-1] * scale)
        of_places.append(basis * values)
    basis, values = _low_rank(np.concatenate(of_places, axis=1))
    loads = [
        np.stack([basis.T @ field @ to, basis.T @ field]) for field, to in zip(of_residuals, to_residual, strict=True)
    ]
    return np.concatenate(
        [
            basis,
            np.array(loads).reshape(POISSONS.size, 2, basis.shape[1], -1).swapaxes(2, 3).reshape(-1, basis.shape[1]),
        ]
    )


def _low_rank(matrix: Array) -> tuple[Array, Array]:
    """Return orthogonal columns that span a matrix to `_RANK_ERROR`, and their singular values."""
    vectors, values, _ = np.linalg.svd(matrix, full_matrices=False)
    significant = values > _RANK_ERROR * values[0]
    return vectors[:, significant], values[significant]


def _rule(panels: Array, y: Array, weight: Array, s: float, d: float) -> Array:
    """Return the field at one point of mirrored loads at the nodes of one plane, shape (2, components, nodes).

    Its own panel and those beside it are divided into parts no longer than their distance from the point.
    """
    nearest = np.hypot(0.0, d) * 0.8 * 2.0 ** np.arange(64)
    cuts = s + np.concatenate([-nearest, [0.0], nearest])
    edges = np.unique(np.concatenate([panels, cuts[(cuts > 0.0) & (cuts < panels[-1])]]))
    node, share = legendre.leggauss(NODES)
    half = 0.5 * np.diff(edges)[:, None]
    points = 0.5 * (edges[1:] + edges[:-1])[:, None] + half * node
    panel, values = interpolation(panels, points.ravel())
    direct = _kernel(s - points.ravel(), d).reshape(2, COMPONENTS, -1, NODES) * (half * share)
    parts = np.einsum("ncpi,pij->pncj", direct, values.reshape(*points.shape, NODES))
    rule = np.zeros((panels.size - 1, 2, COMPONENTS, NODES))
    np.add.at(rule, panel[::NODES], parts)
    return np.moveaxis(rule, 0, 2).reshape(2, COMPONENTS, -1) + _kernel(s + y, d) * weight


def _kernel(s: Array, d: float) -> Array:
    """Return the field at the depth ``d`` and distances ``s`` from line loads cos(k x), shape (2, components, n).

    The first part does not depend on nu, the second is times nu.
    """
    from scipy import special

    r = np.hypot(s, d)
    k0, k1 = special.k0(r), special.k1(r)
    p_d, p_s, p_sd = -k1 * d / r, -k1 * s / r, s * d / r**2 * (k0 + 2.0 * k1 / r)
    p_dd = d**2 / r**2 * (k0 + k1 / r) - k1 * s**2 / r**3
    p_ss = s**2 / r**2 * (k0 + k1 / r) - k1 * d**2 / r**3
    # S by the substitution R = |s| cosh u.
    aside = np.maximum(np.abs(s), 1e-14)
    node, share = legendre.leggauss(_DEPTH_NODES)
    end = 0.5 * np.arcsinh(np.minimum(d, _FARTHEST) / aside)[:, None]
    radius = aside[:, None] * np.cosh(end * (1.0 + node))
    q = np.sum(end * share * radius * special.k0(radius), axis=1) - 0.5 * np.pi * np.exp(-aside)
    q_s = np.sign(s) * (0.5 * np.pi * np.exp(-aside) - aside * np.sum(end * share * special.k1(radius), axis=1))
    nothing = np.zeros_like(r)
    fixed = [
        p_d - d * p_dd, p_d - q - d * p_ss, q + d * k0, q_s + d * p_s, d * p_d, -d * p_sd,
        q + d * k0, -q_s - d * p_s, 2.0 * k0 - d * p_d,
    ]  # fmt: skip
    times_poisson = [
        nothing, 2.0 * q, 2.0 * (p_d - q), -2.0 * q_s, nothing, nothing, -2.0 * q, 2.0 * q_s, -2.0 * k0
    ]  # fmt: skip
    return np.array([fixed, times_poisson]) / np.pi
