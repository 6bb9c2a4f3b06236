"""Reference points of a body's displacement, and how they move under the loads on its surface.

The displacement of the surface of a half-space under a line load is measured against a point at depth, which also
moves: a load displaces a point at depth d below the centre line by a function of its distance along y over d only. The
displacement of a body that deforms as a whole is measured against its axis.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Final, Protocol

import numpy as np
from numpy.typing import NDArray

from nonhertz.bodies import endless_cylinder
from nonhertz.bodies.formulas import apply_to_whole_arrays, curvature_of
from nonhertz.bodies.images import FarImages, Images
from nonhertz.bodies.quarter_space import free_face
from nonhertz.bodies.shape import Shape
from nonhertz.bodies.whole_roller import WholeRoller, whole_roller
from nonhertz.errors import InputError
from nonhertz.model.body import Body
from nonhertz.native import core

Array = NDArray[np.float64]


InCore = core.PointsAtDepth | core.AxisOfCylinder | core.AxisOfRoller | core.OtherReference


class Reference(Protocol):
    """Reference of the displacement of one body in contact with another.

    A reference with a ``core``, like those below, is computed in C++; any other is called in Python.
    """

    @property
    def below(self) -> Callable[[Array], Array]:
        """Y [mm] -> depth below the surface [mm], compared with which half-widths must be small."""

    def displacement(self, y: Array, edges: Array) -> Array:
        """Return its displacement under ``y`` per unit of K q of each strip, shape (places, strips)."""


class _WorkedOutInCore:
    """A reference computed in C++."""

    @property
    def core(self) -> core.PointsAtDepth | core.AxisOfCylinder | core.AxisOfRoller:
        """The same in C++."""
        raise NotImplementedError

    def displacement(self, y: Array, edges: Array) -> Array:
        """Return its displacement under ``y`` per unit of K q of each strip, shape (places, strips)."""
        return self.core.displacement(y, edges)


@dataclass(frozen=True)
class EvenDepth:
    """A depth [mm] that is constant along the body."""

    depth: float

    def __call__(self, y: Array) -> Array:
        """Return the depth [mm] at positions."""
        return np.full(y.shape, self.depth)

    @property
    def core(self) -> float:
        """The depth [mm]."""
        return float(self.depth)


@dataclass(frozen=True)
class DepthInDiameters:
    """A depth proportional to the body's diameter at each position; refuses a body that is not convex there."""

    body: Body
    diameters: float

    def __call__(self, y: Array) -> Array:
        """Return the depth [mm] at positions [mm]."""
        curvature = self.body.curvature(y)
        if np.any(curvature <= 0.0):
            remedy = "give the thickness of the body in mm, or write 'none'"
            raise InputError(
                "depth", self.body.behind.word, "only be used for a body that is convex everywhere", remedy
            )
        depth: Array = 2.0 * self.diameters / curvature
        return depth

    @property
    def core(self) -> core.DepthInDiameters | float:
        """The same in C++; a number where the diameter is one."""
        if callable(self.body.diameter):
            return core.DepthInDiameters(self.diameters, curvature_of(self.body), apply_to_whole_arrays(self))
        return float(self(np.zeros(1))[0])


Depth = EvenDepth | DepthInDiameters


def depth_below(body: Body, shape: Shape) -> Depth | None:
    """Return y [mm] -> depth of the reference below the surface [mm]; None if it is far away.

    The returned function raises InputError where a body with a depth in diameters is not convex.
    """
    behind = body.behind
    if behind.whole:  # the diameter or the wall
        outline, radius = body.outline
        return EvenDepth(radius * (outline.wall if outline.bored else 2.0))
    if behind.of_diameter:
        plane_strain = behind.word == "plane-strain"
        return DepthInDiameters(body, plane_strain_depth(shape, body.material.poisson) if plane_strain else 1.0)
    return EvenDepth(behind.thickness) if math.isfinite(behind.thickness) else None


def plane_strain_depth(shape: Shape, poisson: float) -> float:
    """Return the depth / diameter at which a long cylinder has the compression of plane strain.

    In plane strain the displacement of a strip of infinite length relative to depth d is 2 K q (ln(d / a) + C - 1 /
    (2 (1 - nu))), C being the element's constant; a long cylinder is compressed by K q (2 ln(2 D / b) - 1). The two
    agree at d = 2 D (a / b) exp(1 / (2 (1 - nu)) - C - 1/2), which does not depend on the load.

    Examples
    --------
    >>> from nonhertz.strip.element import SEMI_ELLIPTIC
    >>> round(plane_strain_depth(SEMI_ELLIPTIC, 0.3), 4)
    0.7515
    """
    exponent = 1.0 / (2.0 * (1.0 - poisson)) - shape.far_constant - 0.5
    return 2.0 / shape.hertz_ratio * math.exp(exponent)


@dataclass(frozen=True)
class PointsAtDepth(_WorkedOutInCore):
    """Displacement of points below the centre line of a body under loads on its surface.

    Attributes
    ----------
    below : Depth
        y [mm] -> depth d of the point below the surface [mm].
    poisson_factor : float
        1 / (2 (1 - nu)).
    terms : ndarray, shape (terms, 3)
        Rows (sign, offset, weight) as for the surface, for this body alone; weights include its share of the
        compliance.
    far : FarImages or None
        Distant images of a series, which act as line loads.
    faces : ndarray, shape (faces, 3)
        Rows (place, side, weight) of the side faces that are also free of normal stress.
    over_image : ndarray
        Far-field correction of such a face over the effect of the image; see `nonhertz.bodies.quarter_space`. The
        correction moves a point at depth by this ratio times the effect of the image.
    """

    below: Depth
    poisson_factor: float
    terms: Array
    far: FarImages | None = None
    faces: Array = field(default_factory=lambda: np.zeros((0, 3)))
    over_image: Array = field(default_factory=lambda: np.zeros(0))

    @classmethod
    def of(cls, body: Body, shape: Shape, images: Images) -> PointsAtDepth | None:
        """Return the points of a body with these mirror images; None if they are far away."""
        below = depth_below(body, shape)
        if below is None:
            return None
        poisson = body.material.poisson
        factor = 1.0 / (2.0 * (1.0 - poisson))
        over_image = free_face(poisson).over_image if images.free.size else np.zeros(0)
        return cls(below, factor, images.with_direct(), images.far, images.free, over_image)

    @property
    def core(self) -> core.PointsAtDepth:
        """The same in C++."""
        far = None if self.far is None else self.far.core
        faces = [core.FreeFace(*face) for face in self.faces.tolist()]
        return core.PointsAtDepth(
            self.below.core, self.poisson_factor, terms_of(self.terms), far, faces, np.array(self.over_image)
        )


@dataclass(frozen=True)
class AxisOfCylinder(_WorkedOutInCore):
    """Displacement of a flat body minus that of a solid cylinder of infinite length.

    A uniform load compresses the cylinder as in plane strain, and further because it is free to extend. Side faces can
    be mirrored: that is the model of Chiu and Hartnett with mirrored ends. For a body with free faces the compression
    would be off by 22 %, because their far field does not include the cylinder's curvature: use a whole roller.

    Attributes
    ----------
    below : Depth
        y [mm] -> the diameter [mm].
    poisson : float
        Poisson's ratio.
    terms : ndarray, shape (terms, 3)
        Rows (sign, offset, weight) as for the surface, for this body alone; weights include its share of the
        compliance. More distant images of a series have no effect.
    """

    below: Depth
    poisson: float
    terms: Array

    @classmethod
    def of(cls, body: Body, shape: Shape, images: Images) -> AxisOfCylinder:
        """Return the reference of a body with these mirror images."""
        return cls(DepthInDiameters(body, 1.0), body.material.poisson, images.with_direct())

    @property
    def core(self) -> core.AxisOfCylinder:
        """The same in C++."""
        return core.AxisOfCylinder(self.below.core, endless_cylinder.smooth_part(self.poisson), terms_of(self.terms))


@dataclass(frozen=True)
class AxisOfRoller(_WorkedOutInCore):
    """Displacement of a flat body with free ends minus that of a whole roller.

    The roller is solid or has a bore, and its diameter may vary along the axis, as in a tapered roller. Differences
    from spectral finite elements for a roller as long as its diameter: 0.03 % of the compression under a uniform load,
    0.01 % of the tilting compliance, and 0.4 % of the peak under a load half as long as the contact is wide, since the
    effect of the width is assigned to its own strip. Profile and rounded corners are neglected, and the load on the
    opposite side is taken to be the same. Where the diameter varies, y runs along the surface, diameters are those in
    the plane normal to it, and the load is normal to it; side faces are square to the axis. Up to a half-angle of 15
    degrees the displacement under a strip at an end is within 1 % of finite elements. The resultant of the load's axial
    component is taken up by a rib or the raceways. The bending of a wall is included in its stress, except for bores
    with steps.

    Attributes
    ----------
    below : Depth
        y [mm] -> the diameter, or the wall thickness [mm].
    whole : WholeRoller
        The difference, for a radius of 1.
    radius, middle : float
        Radius, and axial position of the middle [mm].
    share : float
        The body's share of the compliance of the contact.
    """

    below: Depth
    whole: WholeRoller
    radius: float
    middle: float
    share: float

    @classmethod
    def of(cls, body: Body, shape: Shape, images: Images) -> AxisOfRoller:
        """Return the reference of a body with these mirror images."""
        outline, radius = body.outline
        below, whole = depth_below(body, shape), whole_roller(outline, body.material.poisson)
        assert below is not None
        return cls(below, whole, radius, body.position, images.share)

    def by_width(self, y: Array, ratio: float) -> Array:
        """Return the effect of half-widths, ``ratio`` times Hertz's, on strips at ``y``; see `WholeRoller.by_width`."""
        return self.core.by_width(y, ratio)

    @property
    def core(self) -> core.AxisOfRoller:
        """The same in C++."""
        assert isinstance(self.below, EvenDepth)
        return core.AxisOfRoller(self.below.core, self.whole.core, self.radius, self.middle, self.share)


def in_core(reference: Reference) -> InCore:
    """Return a reference in C++, or a function that calls it."""
    converted: InCore | None = getattr(reference, "core", None)
    if converted is not None:
        return converted

    def displacement(y: Array, edges: Array) -> Array:
        return np.ascontiguousarray(reference.displacement(y, edges), dtype=float)

    return core.OtherReference(apply_to_whole_arrays(reference.below), displacement)


def terms_of(rows: Array) -> list[core.Term]:
    """Return rows (sign, offset, weight) as objects of the core."""
    return [core.Term(*row) for row in rows.tolist()]


#: References with a matrix of their own instead of that of points at depth, by the word of the depth.
REFERENCES: Final[dict[str, Callable[[Body, Shape, Images], Reference]]] = {
    "cylinder": AxisOfCylinder.of,
    "finite": AxisOfRoller.of,
}


def reference_of(body: Body, shape: Shape, images: Images) -> Reference | None:
    """Return the reference of a body with these mirror images; None if it is far away."""
    return REFERENCES.get(body.behind.word, PointsAtDepth.of)(body, shape, images)
