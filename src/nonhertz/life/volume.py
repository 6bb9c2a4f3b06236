"""The stresses at every point below a contact while the load rolls over it, which all volume models share.

The stresses over a pass are evaluated at one or two Gauss points along every strip, and beyond both ends of the
contact, at equal steps of the square root of the depth, in which the amplitude of the orthogonal shear stress is smooth
up to the surface. A spline through them gives the stress at many more depths, so that tenth powers and fatigue limits
are integrated as accurately as the stress itself.

Towards a sharp end, or a corner of the profile where the contact ends, the stress grows without bound, and so fast that
its tenth power is not integrable. The volume around such an end is left out, to a tenth of the largest half-width: the
strip model says nothing about it either.
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
from nonhertz.life.lamina import LEFT_OUT
from nonhertz.model.body import BodyName
from nonhertz.patch.solution import PatchSolution
from nonhertz.result.protocol import Solved
from nonhertz.result.solution import ReadOnly
from nonhertz.subsurface.evaluation import Running, across_at, refuse_options
from nonhertz.subsurface.inside import Inside
from nonhertz.subsurface.rolling import QUANTITIES, passage, plane_strain_passage

Array = NDArray[np.float64]

LEVELS = 32
# Between these depths, in half-widths, ten Gauss points each; the volume below contributes less than 1e-4.
PANELS = np.array([0.0, 0.05, 0.15, 0.3, 0.45, 0.6, 0.8, 1.0, 1.25, 1.6, 2.2, 3.0, 4.0])
SHALLOWEST = 1e-6  # half-widths: on the surface itself quadrature across breaks down
NARROW = 0.25  # half-widths
BEYOND = np.array([0.0, 0.1, 0.25, 0.5, 1.0, 2.0])  # distances beyond the contact's ends, in half-widths
MOST_ROWS = 128  # of a plane grid


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
        Half-width that scales the depths [mm].
    orthogonal_shear, shear, von_mises : ndarray, shape (stations, depths)
        Largest values over a pass [MPa] at the depths ``half_width * depth``.
    counted : ndarray of bool, shape (stations, depths)
        False within a tenth of the largest half-width of an end in ``sharp``.
    reference : Exposure or None
        That of the same contact under an ideal pressure: Hertz's line contact everywhere, the load per unit length the
        same from end to end. None where the bodies can touch over an unlimited length.
    sharp : tuple of float
        Where the contact has an end towards which the stress has no limit [mm]: a sharp end of a body, or a corner of
        the profile.
    """

    body: BodyName
    y: Array
    width: Array
    half_width: Array
    orthogonal_shear: Array
    shear: Array
    von_mises: Array
    counted: NDArray[np.bool_]
    reference: Exposure | None
    sharp: tuple[float, ...]

    @property
    def depth(self) -> Array:
        """Depths over the half-width [-], shape (depths,)."""
        return depths()[0]

    def density(self, model: VolumeModel) -> Array:
        """Return the integral over the depth of ``<s - s_u>^k / z^h`` [MPa^k mm^(1-h)] at every station."""
        if not isinstance(model, VolumeModel):
            raise InputError("model", model, "be an integral over the volume", "give a VolumeModel")
        depth, weight = depths()
        suffered = np.maximum(getattr(self, model.stress) - model.fatigue_limit, 0.0) ** model.exponent
        over_depth = np.where(self.counted, suffered, 0.0) @ (weight * depth**-model.depth_exponent)
        return np.asarray(over_depth * self.half_width ** (1.0 - model.depth_exponent))

    def damage(self, model: VolumeModel) -> float:
        """Return the integral over y and z of ``<s - s_u>^k / z^h`` [MPa^k mm^(2-h)]."""
        return float(self.width @ self.density(model))


@cache
def depths() -> tuple[Array, Array]:
    """Return depths over the half-width, and their weights in an integral."""
    nodes, weights = np.polynomial.legendre.leggauss(10)
    half = 0.5 * np.diff(PANELS)[:, None]
    middle = PANELS[:-1, None] + half
    return (middle + half * nodes).ravel(), (half * weights).ravel()


@cache
def _levels() -> tuple[Array, Array]:
    """Return the depths over the half-width at which stresses are evaluated, and the matrix to all `depths`."""
    root = np.linspace(np.sqrt(SHALLOWEST), np.sqrt(PANELS[-1]), LEVELS)
    from scipy.interpolate import CubicSpline

    return root**2, np.asarray(CubicSpline(root, np.eye(LEVELS))(np.sqrt(depths()[0])))


def exposure(solution: Solved, body: BodyName = "a", **options: Unpack[Running]) -> Exposure:
    """Return the stresses throughout the volume of one body over a pass of a solved contact.

    Parameters
    ----------
    solution : Solution or PatchSolution
        A solved contact.
    body : {"a", "b"}
        Which body.
    **options
        ``threads`` and ``announce`` as in `nonhertz.subsurface.stress`.

    Returns
    -------
    Exposure

    Raises
    ------
    InputError
        If nothing is in contact, or ``body`` is neither.
    """
    refuse_options("exposure", options, Running)
    inside = Inside.of(solution, body)
    y, width, half_width = _stations(solution, inside.body.faces)
    levels, fill = _levels()
    seen = passage(solution, y[:, None], half_width[:, None] * levels, body=body, **options)
    amplitudes = {name: np.maximum(getattr(seen, name) @ fill.T, 0.0) for name in QUANTITIES}
    sharp = tuple(end.y for end in solution.singular_ends)
    counted = np.ones(amplitudes["shear"].shape, dtype=bool)
    left_out = LEFT_OUT * solution.max_half_width
    for end in sharp:
        counted &= np.hypot(y[:, None] - end, half_width[:, None] * depths()[0]) >= left_out
    return Exposure(
        body, y, width, half_width, **amplitudes, counted=counted, reference=_ideal(solution, body), sharp=sharp
    )


def _stations(solution: Solved, faces: tuple[float, float]) -> tuple[Array, Array, Array]:
    """Return stations over and beyond the contact, their widths in an integral, and the half-widths there."""
    edges = _edges_in_contact(solution)
    half_width = across_at(solution, 0.5 * (edges[1:] + edges[:-1]))[1]
    below = np.maximum(edges[0] - half_width[0] * BEYOND[1:], faces[0])[::-1]
    above = np.minimum(edges[-1] + half_width[-1] * BEYOND[1:], faces[1])
    edges = np.unique(np.concatenate([below, edges, above]))
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


def _ideal(solution: Solved, body: BodyName) -> Exposure | None:
    """Return the exposure under Hertz's line contact, the load spread evenly over the length of possible contact."""
    contact = solution.contact
    low, high = contact.interval
    if not np.isfinite(high - low):
        return None
    edges = np.linspace(low, high, 2 if _even(solution) else 65)
    y, width = 0.5 * (edges[1:] + edges[:-1]), np.diff(edges)
    poisson = (contact.a if body == "a" else contact.b).material.poisson
    levels, fill = _levels()
    half_width = np.empty(y.size)
    amplitudes = {name: np.empty((y.size, fill.shape[0])) for name in QUANTITIES}
    for i, curvature in enumerate(contact.curvature(y)):
        line = line_contact(
            line_load=solution.load / (high - low), radius=1.0 / float(curvature), compliance=contact.compliance
        )
        half_width[i] = line.half_width
        for name, values in plane_strain_passage(line, levels * line.half_width, poisson).items():
            amplitudes[name][i] = fill @ values
    counted = np.ones(amplitudes["shear"].shape, dtype=bool)
    return Exposure(body, y, width, half_width, **amplitudes, counted=counted, reference=None, sharp=())


def _even(solution: Solved) -> bool:
    """Return whether the curvature is constant along y."""
    low, high = solution.contact.interval
    curvature = solution.contact.curvature(np.linspace(low, high, 65))
    return bool(np.ptp(curvature) == 0.0)
