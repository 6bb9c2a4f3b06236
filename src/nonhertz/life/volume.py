"""The stresses at every point below a contact while the load rolls over it, common to all volume models.

The stresses over a pass are evaluated at one or two Gauss points along every strip, and beyond both ends of the
contact, at equal steps of the square root of the depth, in which the amplitude of the orthogonal shear stress is smooth
up to the surface. A spline through them gives the stress at many more depths, so that tenth powers and fatigue limits
are integrated as accurately as the stress itself. Below four half-widths there is hardly any damage, except in a
hollow roller, whose wall bends: there the integral extends to the bore and, along the roller, to its side faces, at
points that turn with it.

Towards a sharp end, or a corner of the profile where the contact ends, the stress grows without bound, and so fast that
its tenth power is not integrable. The volume within a tenth of the largest half-width of such an end is left out: the
strip model is not valid there either.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Unpack

import numpy as np
from numpy.typing import NDArray

from nonhertz.errors import InputError
from nonhertz.hertz import line_contact
from nonhertz.life.catalogue import VolumeModel
from nonhertz.life.lamina import LEFT_OUT, refuse_rolling_on
from nonhertz.model.body import BodyName
from nonhertz.model.contact import Contact
from nonhertz.patch.solution import PatchSolution
from nonhertz.result.read_only import ReadOnly
from nonhertz.result.solved import Solved
from nonhertz.subsurface.evaluation import Running, across_at, refuse_options
from nonhertz.subsurface.inside import Inside
from nonhertz.subsurface.rolling import QUANTITIES, passage, plane_strain_passage, revolution

Array = NDArray[np.float64]

LEVELS = 32
# Between these depths, in half-widths, ten Gauss points each; the volume below contributes less than 1e-4.
PANELS = np.array([0.0, 0.05, 0.15, 0.3, 0.45, 0.6, 0.8, 1.0, 1.25, 1.6, 2.2, 3.0, 4.0])
DEEP = 12  # Gauss points from there to the bore
SHALLOWEST = 1e-6  # half-widths: on the surface itself quadrature across breaks down
NARROW = 0.25  # half-widths
BEYOND = np.array([0.0, 0.1, 0.25, 0.5, 1.0, 2.0])  # distances beyond the contact's ends, in half-widths
TO_FACES = 5  # intervals from there to the side faces of a hollow roller
MOST_ROWS = 128  # of a plane grid
# Half-widths: distance from a line load at which it acts like a pressure distributed across. Fitted to the whole field
# at corners of 0.3 and 1 mm; with 0.2 and 0.8 the life is off by 5 to 18 %.
SPREAD = 0.5
NEARBY = 6.0  # half-widths: loads further away contribute less than 1e-3 at the depths of damage


@dataclass(frozen=True, eq=False, repr=False)
class Exposure(ReadOnly):
    """The largest stresses over a pass of the load, throughout the volume under a contact.

    Attributes
    ----------
    body : {"a", "b"}
        Which body.
    y, width : ndarray, shape (stations,)
        Stations [mm], and their weights in an integral along y [mm].
    half_width : ndarray, shape (stations,)
        Half-width of the contact, or beyond its ends the width of its field [mm].
    z, height : ndarray, shape (stations, depths)
        Depths [mm], and their weights in an integral over z [mm].
    orthogonal_shear, shear, von_mises : ndarray, shape (stations, depths)
        Largest values over a pass [MPa], or over a revolution deep in the wall of a hollow roller.
    counted : ndarray of bool, shape (stations, depths)
        False within a tenth of the largest half-width of an end in ``sharp``.
    reference : Exposure or None
        Exposure of the same contact under an ideal pressure: Hertz's line contact with a uniform load per unit length.
        None where the length over which the bodies can touch is unlimited.
    sharp : tuple of float
        Positions of the ends of the contact at which the stress is singular [mm]: sharp ends of a body, or corners of
        the profile.
    """

    body: BodyName
    y: Array
    width: Array
    half_width: Array
    z: Array
    height: Array
    orthogonal_shear: Array
    shear: Array
    von_mises: Array
    counted: NDArray[np.bool_]
    reference: Exposure | None
    sharp: tuple[float, ...]

    def density(self, model: VolumeModel) -> Array:
        """Return the integral over the depth of ``<s - s_u>^k / z^h`` [MPa^k mm^(1-h)] at every station."""
        if not isinstance(model, VolumeModel):
            raise InputError("model", model, "be an integral over the volume", "give a VolumeModel")
        counted = np.where(self.counted, getattr(self, model.stress), 0.0)
        return integrate_over_depth(model, counted, self.z, self.height)

    def damage(self, model: VolumeModel) -> float:
        """Return the integral over y and z of ``<s - s_u>^k / z^h`` [MPa^k mm^(2-h)]."""
        return float(self.width @ self.density(model))


def integrate_over_depth(model: VolumeModel, stresses: Array, z: Array, height: Array) -> Array:
    """Return the integral of ``<s - s_u>^k / z^h`` [MPa^k mm^(1-h)] over depths z with their weights, the last axis."""
    suffered = np.maximum(stresses - model.fatigue_limit, 0.0) ** model.exponent
    return np.asarray(np.sum(suffered * height * z**-model.depth_exponent, axis=-1))


@cache
def depths() -> tuple[Array, Array]:
    """Return depths over the half-width, and their weights in an integral."""
    nodes, weights = np.polynomial.legendre.leggauss(10)
    half = 0.5 * np.diff(PANELS)[:, None]
    middle = PANELS[:-1, None] + half
    return (middle + half * nodes).ravel(), (half * weights).ravel()


@cache
def levels() -> tuple[Array, Array]:
    """Return the depths over the half-width at which stresses are evaluated, and the matrix to all `depths`."""
    root = np.linspace(np.sqrt(SHALLOWEST), np.sqrt(PANELS[-1]), LEVELS)
    from scipy.interpolate import CubicSpline

    return root**2, np.asarray(CubicSpline(root, np.eye(LEVELS))(np.sqrt(depths()[0])))


def exposure(solution: Solved, *, body: BodyName = "a", **options: Unpack[Running]) -> Exposure:
    """Return the stresses throughout the volume of one body over a pass of a solved contact.

    Parameters
    ----------
    solution : Solution or PatchSolution
        A solved contact.
    body : {"a", "b"}
        The body that fatigues.
    **options
        ``threads`` and ``callback`` as in `nonhertz.subsurface.stress`.

    Returns
    -------
    Exposure

    Raises
    ------
    InputError
        If nothing is in contact, ``body`` is neither, or a dent is in the contact, which rolls on.
    """
    refuse_options("exposure", options, Running)
    refuse_rolling_on(solution)
    inside = Inside.of(solution, body)
    bends = inside.wall is not None
    y, width, half_width = _stations(solution, inside.body.faces, TO_FACES if bends else 0)
    thickness = inside.extent.thickness(y)[:, None]
    # No stress beyond the material of a thin wall.
    scale = np.minimum(half_width[:, None], thickness / PANELS[-1])
    evaluated, fill = levels()
    depth = scale * evaluated
    z, height = (scale * values for values in depths())
    if bends:
        from scipy.linalg import block_diag

        node, weight = np.polynomial.legendre.leggauss(DEEP)
        half = 0.5 * (thickness - scale * PANELS[-1])
        deep = thickness - half * (1.0 - node)
        depth, z, height = np.hstack([depth, deep]), np.hstack([z, deep]), np.hstack([height, half * weight])
        fill = block_diag(fill, np.eye(DEEP))
    seen = (revolution if bends else passage)(solution, y[:, None], depth, body=body, **options)
    amplitudes = {name: np.maximum(getattr(seen, name) @ fill.T, 0.0) for name in QUANTITIES}
    return _make_exposure(solution, body, (y, width, half_width, z, height), amplitudes)


def section_exposure(solution: Solved, *, body: BodyName = "a") -> Exposure:
    """Return the exposure with every cross-section in plane strain under its own pressure, which is very cheap.

    Sections differ only in pressure and half-width. Where these change along the contact, the orthogonal shear at a
    point is a mean over nearby sections: a unit of line load at the distance r from its line contributes in proportion
    to r^4 / (r^2 + y^2)^(5/2), where y is the distance along the line. With r^2 = z^2 + b^2 / 4, since the pressure is
    distributed across, damage by orthogonal shear is within 1 % of the whole field, for smooth pressures and at the
    peak of a roller's corner. The other stresses have no such kernel: they are those of the section itself, and too
    large at a peak narrower than a half-width.
    """
    inside = Inside.of(solution, body)
    if inside.wall is not None:
        return exposure(solution, body=body)
    y, width, half_width = _stations(solution, inside.body.faces)
    touching = solution.line_load > 0.0
    pressure = np.interp(y, solution.y[touching], solution.largest_across[touching])
    low, high = solution.edges[np.flatnonzero(touching)[[0, -1]] + [0, 1]]
    pressure[(y < low) | (y > high)] = 0.0
    plane = _plane_strain(inside.body.material.poisson)
    amplitudes = {name: pressure[:, None] * amplitude for name, amplitude in plane.items()}
    amplitudes["orthogonal_shear"] = _from_nearby(solution, y, half_width, plane["orthogonal_shear"])
    z, height = (half_width[:, None] * values for values in depths())
    return _make_exposure(solution, body, (y, width, half_width, z, height), amplitudes)


def _from_nearby(solution: Solved, y: Array, half_width: Array, plane: Array) -> Array:
    """Return the orthogonal shear at stations and depths as a mean over nearby sections in plane strain."""
    touching = np.flatnonzero(solution.line_load > 0.0)
    pressure = solution.largest_across[touching]
    across = solution.extent_across[1][touching]
    edges = solution.edges[np.append(touching, touching[-1] + 1)]
    depth, (evaluated, fill) = depths()[0], levels()
    amplitude = np.empty((y.size, evaluated.size))
    for i, (station, b) in enumerate(zip(y, half_width, strict=True)):
        z = b * evaluated[:, None]
        reach = np.sqrt(z**2 + (SPREAD * b) ** 2)
        first = max(int(np.searchsorted(edges, station - NEARBY * b)) - 1, 0)
        last = min(int(np.searchsorted(edges, station + NEARBY * b)), touching.size)
        near = slice(first, last)
        relative = z / across[near]
        # It vanishes on the surface; far below, that of a line load falls with the distance.
        shear = np.interp(relative, np.append(0.0, depth), np.append(0.0, plane))
        shear *= np.minimum(1.0, depth[-1] / relative)
        share = np.diff(_share_below((edges[first : last + 1] - station) / reach), axis=1)
        amplitude[i] = np.sum(share * pressure[near] * shear, axis=1)
    return np.maximum(amplitude @ fill.T, 0.0)


def _share_below(distance: Array) -> Array:
    """Return the integral of 3/4 (1 + t^2)^(-5/2), which is 1 over all t, from 0 to relative distances."""
    sine = distance / np.sqrt(1.0 + distance**2)
    return np.asarray(0.75 * (sine - sine**3 / 3.0))


@cache
def _plane_strain(poisson: float) -> dict[str, Array]:
    """Return the largest stresses over a pass of Hertz's line contact over its pressure, at all `depths`."""
    line = line_contact(line_load=1.0, radius=1.0, compliance=1.0)
    depth, fill = levels()
    passage = plane_strain_passage(line, depth * line.half_width, poisson)
    return {name: fill @ values / line.max_pressure for name, values in passage.items()}


def _make_exposure(
    solution: Solved,
    body: BodyName,
    points: tuple[Array, Array, Array, Array, Array],
    amplitudes: dict[str, Array],
) -> Exposure:
    """Return the exposure from stresses at points; points too near to sharp ends do not count."""
    y, _, _, z, _ = points
    sharp = tuple(end.y for end in solution.singular_ends)
    away = [np.hypot(y[:, None] - end, z) >= LEFT_OUT * solution.max_half_width for end in sharp]
    counted = np.logical_and.reduce([np.ones(z.shape, dtype=bool), *away])
    reference = even_exposure(solution.contact, solution.load, body)
    return Exposure(body, *points, **amplitudes, counted=counted, reference=reference, sharp=sharp)


def _stations(solution: Solved, faces: tuple[float, float], to_faces: int = 0) -> tuple[Array, Array, Array]:
    """Return stations over and beyond the contact, their widths in an integral, and the half-widths there.

    ``to_faces`` is the number of intervals from where the field of the contact becomes negligible to either face.
    """
    edges = _edges_in_contact(solution)
    half_width = across_at(solution, 0.5 * (edges[1:] + edges[:-1]))[1]
    below = np.maximum(edges[0] - half_width[0] * BEYOND[1:], faces[0])[::-1]
    above = np.minimum(edges[-1] + half_width[-1] * BEYOND[1:], faces[1])
    outside = [
        np.linspace(face, float(last), to_faces + 1)
        for face, last in zip(faces, (below[0], above[-1]), strict=True)
        if to_faces
    ]
    edges = np.unique(np.concatenate([below, edges, above, *outside]))
    middle, half = 0.5 * (edges[1:] + edges[:-1]), 0.5 * np.diff(edges)
    # One Gauss point suffices for a strip that is narrow compared with the half-width.
    wide = 2.0 * half > NARROW * across_at(solution, middle)[1]
    apart = half[wide] / np.sqrt(3.0)
    y = np.concatenate([middle[~wide], middle[wide] - apart, middle[wide] + apart])
    width = np.concatenate([2.0 * half[~wide], half[wide], half[wide]])
    order = y.argsort()
    return y[order], width[order], across_at(solution, y[order])[1]


def _edges_in_contact(solution: Solved) -> Array:
    """Return the edges along y of the strips in contact, or of groups of rows of a plane grid."""
    first, last = np.flatnonzero(solution.line_load > 0.0)[[0, -1]]
    edges: Array = solution.edges[first : last + 2]
    if not isinstance(solution, PatchSolution):
        return edges
    fewer: Array = edges[np.unique(np.linspace(0, edges.size - 1, MOST_ROWS + 1).astype(int))]
    return fewer


def even_exposure(
    contact: Contact, load: float, body: BodyName, span: tuple[float, float] | None = None
) -> Exposure | None:
    """Return the exposure under Hertz's line contact, a load uniform over a span or the effective length [mm].

    None where that length is unlimited.
    """
    low, high = contact.land if span is None else span
    if not np.isfinite(high - low):
        return None
    edges = np.linspace(low, high, 2 if _is_even(contact) else 65)
    y, width = 0.5 * (edges[1:] + edges[:-1]), np.diff(edges)
    poisson = contact.bodies[body].material.poisson
    lines = [
        line_contact(line_load=load / (high - low), radius=1.0 / float(curvature), compliance=contact.compliance)
        for curvature in contact.curvature(y)
    ]
    half_width = np.array([line.half_width for line in lines])
    pressure = np.array([line.max_pressure for line in lines])
    amplitudes = {name: pressure[:, None] * amplitude for name, amplitude in _plane_strain(poisson).items()}
    z, height = (half_width[:, None] * values for values in depths())
    counted = np.ones(z.shape, dtype=bool)
    return Exposure(body, y, width, half_width, z, height, **amplitudes, counted=counted, reference=None, sharp=())


def _is_even(contact: Contact) -> bool:
    """Return whether the curvature is constant along y."""
    low, high = contact.interval
    curvature = contact.curvature(np.linspace(low, high, 65))
    return bool(np.ptp(curvature) == 0.0)
