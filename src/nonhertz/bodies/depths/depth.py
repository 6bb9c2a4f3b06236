"""The interface of a choice of depth, and how the points that displacement is measured against move.

The displacement of the surface of a half-space under a line load is measured against a point at depth, which moves
too: a load displaces a point at depth d below the centre line by a function of its distance along y over d alone.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, ClassVar, Protocol

import numpy as np
from numpy.typing import NDArray

from nonhertz.bodies.quarter_space import free_face
from nonhertz.compiled import compiled, plain_array

if TYPE_CHECKING:
    from nonhertz.bodies.images import Images
    from nonhertz.bodies.solid import Shape, Solid

Array = NDArray[np.float64]

# Widths over depths below which a strip's effect is integrated to 2e-11 by Gauss's rule of three points.
NARROW = 0.06
MIDDLE_WEIGHT, SIDE_WEIGHT, SIDE = 8.0 / 9.0, 5.0 / 9.0, math.sqrt(0.6)


class Reference(Protocol):
    """What the displacement of one body is measured against, in contact with another."""

    @property
    def below(self) -> Callable[[Array], Array]:
        """Y [mm] -> depth below the surface [mm], compared with which half-widths must be small."""

    def displacement(self, y: Array, edges: Array) -> Array:
        """Return its displacement under ``y`` per unit of K q of each strip, shape (..., places, strips).

        ``y`` has the shape (..., places), ``edges`` (..., strips + 1): strips of many cases, a case in each row.
        """


class Depth(ABC):
    """What the displacement of a body is measured against.

    Attributes
    ----------
    word : str
        Its keyword in files and Python; empty if given as a number.
    meaning : str
        Where that is, as it follows the word in descriptions of case files.
    of_diameter : bool
        Whether only a body that is convex everywhere can have it.
    bored : bool
        Whether a bore is taken into account.
    """

    word: ClassVar[str]
    meaning: ClassVar[str]
    of_diameter: ClassVar[bool] = False
    bored: ClassVar[bool] = False

    @property
    def shown(self) -> str:
        """What a file gives for it."""
        return self.word

    def corner_angles(self, body: Solid) -> tuple[float, float]:
        """Return the angles between surface and side faces at low and high y, within the body [rad]: right ones."""
        return 0.5 * math.pi, 0.5 * math.pi

    @property
    @abstractmethod
    def place(self) -> str:
        """The reference, as it follows "is measured against"."""

    @abstractmethod
    def below(self, body: Solid, shape: Shape) -> Callable[[Array], Array] | None:
        """Return y [mm] -> depth of the point below the surface [mm]; None if it is far away."""

    def refuse(self, body: Solid) -> None:
        """Refuse a body that cannot have it.

        Raises
        ------
        InputError
        """
        return

    def reference(self, body: Solid, shape: Shape, images: Images) -> Reference | None:
        """Return what the displacement of a body with these mirror images is measured against; None if far away."""
        below = self.below(body, shape)
        if below is None:
            return None
        poisson = body.material.poisson
        factor = 1.0 / (2.0 * (1.0 - poisson))
        far = None if images.far is None else images.far.less_depth(below, factor)
        over_image = free_face(poisson).over_image() if images.free.size else np.zeros(0)
        return PointsAtDepth(below, factor, images.with_direct(), far, images.free, over_image)


@dataclass(frozen=True)
class PointsAtDepth:
    """How loads on the surface of one body move points below its centre line.

    Attributes
    ----------
    below : callable
        y [mm] -> depth d of the point below the surface [mm].
    poisson_factor : float
        1 / (2 (1 - nu)).
    terms : ndarray, shape (terms, 3)
        Rows (sign, offset, weight) as for the surface, for this body alone; weights include its share of the
        compliance.
    far : callable or None
        y [mm] -> displacement that the far images add at the surface relative to depth, per unit of load.
    faces : ndarray, shape (faces, 3)
        Rows (place, side, weight) of the side faces that are free of normal stress, too.
    over_image : ndarray
        What such a face adds far away over what the image does; see `nonhertz.bodies.quarter_space`. A point at depth
        is moved by as many times its image.
    """

    below: Callable[[Array], Array]
    poisson_factor: float
    terms: Array
    far: Callable[[Array], Array] | None = None
    faces: Array = field(default_factory=lambda: np.zeros((0, 3)))
    over_image: Array = field(default_factory=lambda: np.zeros(0))

    def displacement(self, y: Array, edges: Array) -> Array:
        """Return the displacement at depth under ``y`` per unit of K q of each strip, shape (..., places, strips)."""
        shape = (*y.shape, edges.shape[-1] - 1)
        places, ends = (plain_array(each).reshape(-1, each.shape[-1]) for each in (y, edges))
        depth = self.below(places.ravel()).reshape(places.shape)
        found = _at_depth(places, depth, ends, self.poisson_factor, self.terms)
        if self.faces.size:
            _at_depth_by_faces(places, depth, ends, self.poisson_factor, self.faces, self.over_image, found)
        if self.far is not None:
            found -= self.far(places.ravel()).reshape(places.shape)[..., None] * np.diff(ends)[:, None, :]
        return found.reshape(shape)


@compiled
def _at_depth(y: Array, depth: Array, edges: Array, poisson_factor: float, terms: Array) -> Array:
    """Return the displacement at depth under each place by a unit line load between neighbouring edges."""
    out = np.empty((y.shape[0], y.shape[1], edges.shape[1] - 1))
    for row in range(y.shape[0]):
        widest = 0.0
        for e in range(1, edges.shape[1]):
            widest = max(widest, edges[row, e] - edges[row, e - 1])
        for i in range(y.shape[1]):
            if widest < NARROW * depth[row, i]:
                _by_quadrature(y[row, i], depth[row, i], edges[row], poisson_factor, terms, out[row, i])
            else:
                _by_closed_form(y[row, i], depth[row, i], edges[row], poisson_factor, terms, out[row, i])
    return out


@compiled
def _at_depth_by_faces(
    y: Array, depth: Array, edges: Array, poisson_factor: float, faces: Array, over_image: Array, out: Array
) -> None:
    """Add what free side faces add to the displacement at depth, by Gauss's rule of three points on each strip."""
    for k in range(faces.shape[0]):
        place, side, weight = faces[k, 0], faces[k, 1], faces[k, 2]
        for row in range(y.shape[0]):
            for i in range(y.shape[1]):
                u = max(side * (place - y[row, i]), 0.0)
                for e in range(out.shape[2]):
                    half = 0.5 * (edges[row, e + 1] - edges[row, e])
                    middle = side * (place - 0.5 * (edges[row, e + 1] + edges[row, e]))
                    total = 0.0
                    for part, share in ((-SIDE, SIDE_WEIGHT), (0.0, MIDDLE_WEIGHT), (SIDE, SIDE_WEIGHT)):
                        v = max(middle + part * half, 0.0)
                        total += share * _by_face(u, v, depth[row, i], poisson_factor, over_image)
                    out[row, i, e] += weight * half * total


@compiled
def _by_face(u: float, v: float, depth: float, poisson_factor: float, over_image: Array) -> float:
    """Return what a free side face adds to the displacement at a depth below ``u`` by a unit load at ``v``."""
    distance = u + v
    if distance == 0.0:
        return 0.0
    aside = (u - v) / distance
    x, ratio = 2.0 * aside * aside - 1.0, 0.0
    for c in over_image:
        ratio = ratio * x + c
    return ratio * _kernel(distance / depth, poisson_factor) / depth


@compiled
def _by_quadrature(y: float, depth: float, edges: Array, poisson_factor: float, terms: Array, out: Array) -> None:
    """By Gauss's rule of three points, which for strips this narrow is as good and vectorises."""
    inverse = 1.0 / depth
    for e in range(out.size):
        out[e] = 0.0
    for k in range(terms.shape[0]):
        sign, offset, weight = terms[k, 0], terms[k, 1] - y, terms[k, 2]
        for e in range(out.size):
            half = 0.5 * (edges[e + 1] - edges[e]) * inverse
            middle = (sign * 0.5 * (edges[e + 1] + edges[e]) + offset) * inverse
            total = MIDDLE_WEIGHT * _kernel(middle, poisson_factor)
            total += SIDE_WEIGHT * _kernel(middle - SIDE * half, poisson_factor)
            total += SIDE_WEIGHT * _kernel(middle + SIDE * half, poisson_factor)
            out[e] += weight * half * total


@compiled
def _kernel(u: float, poisson_factor: float) -> float:
    """Return the displacement at depth 1 by a unit load at distance ``u``."""
    over = 1.0 / (1.0 + u * u)
    return float(math.sqrt(over) * (1.0 + poisson_factor * over))


@compiled
def _by_closed_form(y: float, depth: float, edges: Array, poisson_factor: float, terms: Array, out: Array) -> None:
    inverse, before = 1.0 / depth, 0.0
    for e in range(edges.size):
        # By a load from the far left up to the edge, to a constant.
        total = 0.0
        for k in range(terms.shape[0]):
            sign, offset = terms[k, 0], terms[k, 1] - y
            u = (sign * edges[e] + offset) * inverse
            root = math.sqrt(1.0 + u * u)
            value = math.copysign(math.log(abs(u) + root), u) + poisson_factor * u / root
            total += sign * terms[k, 2] * value
        if e > 0:
            out[e - 1] = total - before
        before = total
