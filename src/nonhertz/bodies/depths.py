"""What the displacement of a body is measured against, and how it moves under the loads on its surface.

The displacement of the surface of a half-space under a line load is measured against a point at depth, which moves
too: a load displaces a point at depth d below the centre line by a function of its distance along y over d alone. A
body that deforms as a whole is measured against its axis.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial
from typing import Final, Protocol

import numpy as np
from numpy.typing import NDArray

from nonhertz.bodies import endless_cylinder
from nonhertz.bodies.images import Images
from nonhertz.bodies.quarter_space import free_face
from nonhertz.bodies.shape import Shape
from nonhertz.bodies.whole_roller import WholeRoller, whole_roller
from nonhertz.compiled import compiled, plain_array
from nonhertz.compiled.tiles import TILE, polynomial
from nonhertz.errors import InputError
from nonhertz.model.body import Body
from nonhertz.model.outline import outline_of

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


def depth_below(body: Body, shape: Shape) -> Callable[[Array], Array] | None:
    """Return y [mm] -> depth of the reference below the surface [mm]; None if it is far away.

    The returned function raises InputError where a body whose depth is of its diameter is not convex.
    """
    # Partial functions rather than nested ones, so that their holders can be pickled.
    behind = body.behind
    if behind.whole:  # the diameter or the wall
        outline, radius = outline_of(body)
        return partial(_even, radius * (outline.wall if outline.bored else 2.0))
    if behind.of_diameter:
        plane_strain = behind.word == "plane-strain"
        return partial(_in_diameters, body, plane_strain_depth(shape, body.material.poisson) if plane_strain else 1.0)
    return partial(_even, behind.thickness) if math.isfinite(behind.thickness) else None


def _even(value: float, y: Array) -> Array:
    return np.full(y.shape, value)


def _in_diameters(body: Body, diameters: float, y: Array) -> Array:
    curvature = body.curvature(y)
    if np.any(curvature <= 0.0):
        remedy = "give the thickness of the body in mm, or write 'none'"
        raise InputError("depth", body.behind.word, "only be used for a body that is convex everywhere", remedy)
    depth: Array = 2.0 * diameters / curvature
    return depth


def plane_strain_depth(shape: Shape, poisson: float) -> float:
    """Return depth / diameter at which a long cylinder's compression is that of plane strain.

    In plane strain the displacement of a strip of infinite length relative to depth d is 2 K q (ln(d / a) + C - 1 /
    (2 (1 - nu))), C being the element's constant; a long cylinder is compressed by K q (2 ln(2 D / b) - 1). The two
    agree at d = 2 D (a / b) exp(1 / (2 (1 - nu)) - C - 1/2), in which the load cancels.

    Examples
    --------
    >>> from nonhertz.strip.element import SEMI_ELLIPTIC
    >>> round(plane_strain_depth(SEMI_ELLIPTIC, 0.3), 4)
    0.7515
    """
    exponent = 1.0 / (2.0 * (1.0 - poisson)) - shape.far_constant - 0.5
    return 2.0 / shape.hertz_ratio * math.exp(exponent)


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

    @classmethod
    def of(cls, body: Body, shape: Shape, images: Images, _: bool = False) -> PointsAtDepth | None:
        """Return how those of a body with these mirror images move; None if they are far away."""
        below = depth_below(body, shape)
        if below is None:
            return None
        poisson = body.material.poisson
        factor = 1.0 / (2.0 * (1.0 - poisson))
        far = None if images.far is None else images.far.less_depth(below, factor)
        over_image = free_face(poisson).over_image() if images.free.size else np.zeros(0)
        return cls(below, factor, images.with_direct(), far, images.free, over_image)

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
    n = out.shape[2]
    room = (3 * n + TILE - 1) // TILE * TILE
    v, share, added, work = np.zeros(room), np.empty(3 * n), np.empty(room), np.empty(room)
    for k in range(faces.shape[0]):
        place, side, weight = faces[k, 0], faces[k, 1], faces[k, 2]
        for row in range(y.shape[0]):
            for e in range(n):
                half = 0.5 * (edges[row, e + 1] - edges[row, e])
                middle = side * (place - 0.5 * (edges[row, e + 1] + edges[row, e]))
                for part in range(3):
                    v[3 * e + part] = max(middle + (part - 1) * SIDE * half, 0.0)
                    share[3 * e + part] = weight * half * (MIDDLE_WEIGHT if part == 1 else SIDE_WEIGHT)
            for i in range(y.shape[1]):
                u = max(side * (place - y[row, i]), 0.0)
                _fill_by_face(u, v, depth[row, i], poisson_factor, over_image, work, added)
                for e in range(n):
                    for part in range(3):
                        out[row, i, e] += share[3 * e + part] * added[3 * e + part]


@compiled
def _fill_by_face(
    u: float, v: Array, depth: float, poisson_factor: float, over_image: Array, work: Array, added: Array
) -> None:
    """Fill in what a free side face adds to the displacement at a depth below ``u`` by unit loads at ``v``."""
    for j in range(v.size):
        distance = u + v[j]
        aside = (u - v[j]) / distance if distance > 0.0 else 0.0
        work[j] = 2.0 * aside * aside - 1.0
    polynomial(work, over_image, added)
    for j in range(v.size):
        distance = u + v[j]
        added[j] *= _kernel(distance / depth, poisson_factor) / depth if distance > 0.0 else 0.0


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


@dataclass(frozen=True)
class AxisOfCylinder:
    """What the displacement of a solid cylinder of infinite length is less than that of a flat body.

    A uniform load compresses it as in plane strain, and by what the cylinder is free to grow longer. Side faces can be
    mirrored: that is the model of Chiu and Hartnett with mirrored ends. Of a body with free faces it is 22 % off the
    compression, because what these add far away knows no girth: a whole roller is for those.

    Attributes
    ----------
    below : callable
        y [mm] -> the diameter [mm].
    poisson : float
        Poisson's ratio.
    terms : ndarray, shape (terms, 3)
        Rows (sign, offset, weight) as for the surface, for this body alone; weights include its share of the
        compliance. Images of a series that are further away move nothing.
    """

    below: Callable[[Array], Array]
    poisson: float
    terms: Array

    @classmethod
    def of(cls, body: Body, shape: Shape, images: Images, _: bool = False) -> AxisOfCylinder:
        """Return that of a body with these mirror images."""
        return cls(partial(_in_diameters, body, 1.0), body.material.poisson, images.with_direct())

    def displacement(self, y: Array, edges: Array) -> Array:
        """Return it under ``y`` per unit of K q of each strip, shape (..., places, strips)."""
        radius = 0.5 * self.below(y.ravel()).reshape(y.shape)[..., None]
        found = np.zeros((*y.shape, edges.shape[-1] - 1))
        for sign, offset, weight in self.terms:
            distance = (sign * edges[..., None, :] + offset - y[..., None]) / radius
            found -= sign * weight * np.diff(endless_cylinder.displacement(distance, self.poisson), axis=-1)
        return found


@dataclass(frozen=True)
class AxisOfRoller:
    """What the displacement of a whole roller is less than that of a flat body with free ends.

    The roller is solid or has a bore, and its diameter may vary along the axis, as that of a tapered roller does.
    Against spectral finite elements of a roller as long as its diameter: 0.03 % of the compression under a uniform
    load, 0.01 % of the compliance against tilting, and 0.4 % of the peak under a load half as long as the contact
    is wide, since what the width changes all counts on its strip. Profile and rounded corners are neglected, and
    the load on the opposite side is taken to be the same. Where the diameter varies, y runs along the surface,
    diameters are those in the plane normal to it, and the load is normal to it; side faces are square to the axis.
    Up to a half-angle of 15 degrees the displacement under a strip at an end is within 1 % of finite elements. The
    sum of the load's axial part is left to a rib or the raceways. The bending of a wall is in its stress, but for
    bores with steps.

    Attributes
    ----------
    below : callable
        y [mm] -> the diameter, or the wall [mm].
    whole : WholeRoller
        The difference, for a radius of 1.
    radius, middle : float
        Radius, and axial position of the middle [mm].
    share : float
        Share of the body in the compliance of the contact.
    """

    below: Callable[[Array], Array]
    whole: WholeRoller
    radius: float
    middle: float
    share: float

    @classmethod
    def of(cls, body: Body, shape: Shape, images: Images, interpolated: bool = False) -> AxisOfRoller:
        """Return that of a body with these mirror images, interpolated between shapes or its own."""
        outline, radius = outline_of(body)
        below, whole = depth_below(body, shape), whole_roller(outline, body.material.poisson, interpolated)
        assert below is not None
        return cls(below, whole, radius, body.position, images.share)

    def displacement(self, y: Array, edges: Array) -> Array:
        """Return it under ``y`` per unit of K q of each strip, shape (..., places, strips)."""
        places, ends = ((each - self.middle) / self.radius for each in (y, edges))
        return -self.share * self.whole.displacement(places, ends)

    def by_width(self, y: Array, ratio: float) -> Array:
        """Return what half-widths, times ``ratio`` Hertz's, change on strips at ``y``; see `WholeRoller.by_width`."""
        girths = self.whole.outline.girths((y - self.middle) / self.radius)
        return self.share * self.whole.by_width(self.radius / ratio * girths)


#: What brings a matrix of its own in place of that of points at depth, by the word of the depth.
REFERENCES: Final[dict[str, Callable[[Body, Shape, Images, bool], Reference]]] = {
    "cylinder": AxisOfCylinder.of,
    "finite": AxisOfRoller.of,
}


def reference_of(body: Body, shape: Shape, images: Images, interpolated: bool) -> Reference | None:
    """Return what the displacement of a body with these mirror images is measured against; None if far away.

    Rollers that deform as a whole are interpolated between shapes or each by itself.
    """
    return REFERENCES.get(body.behind.word, PointsAtDepth.of)(body, shape, images, interpolated)
