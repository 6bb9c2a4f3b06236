"""What side faces and thickness add to two half-spaces.

A side face at y = f is freed of shear by the image of every strip about it, for the body that ends there and for
its share of the compliance alone. With two faces the images have images: one chain begins at either face, and its
links alternate between both. The first image of a face may weigh more than 1, to make up for the normal stress that
mirroring leaves on the face; further images only cancel the shear of earlier ones, for which 1 is right.

The weight that governs a sharp end is kappa, the sum over the bodies that end there of image weight times share of
the compliance. Up to kappa = 1 the pressure goes with the distance s from the end like s^-alpha, cos(pi alpha) =
kappa; beyond, the equations have no solution that refinement converges to, so weights are lowered to kappa = 1.

Everything that acts beside the load itself is a *term*: a row (sign, offset, weight) that sends what lies at y to
``sign * y + offset`` and counts ``weight`` times. The direct effect is the term (1, 0, 1); a mirror image about a face
at f is (-1, 2 f, weight). Displacements are measured against points at depth, which move themselves: a load lifts a
point at depth d below the centre line by a function of its distance along y over d alone, line loads that is.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from nonhertz.compiled import compiled
from nonhertz.errors import InputError
from nonhertz.model.body import Body
from nonhertz.model.contact import Contact
from nonhertz.model.finite import SERIES

Array = NDArray[np.float64]

APART = 0.02  # of the combined radius: about the half-width of a heavily loaded contact of metals
TOGETHER = 1.0 - 1e-4
SEPARATE_LINKS, ALL_LINKS = 16, 1000  # of a series: told apart, and summed one by one
NO_WEIGHT = 1e-12
# kappa from which on the pressure counts as finite up to an end: alpha is below 0.015 there, less than 10 % of pressure
# in three decades of distance.
FINITE_FROM = 0.999
_DIRECT = (1.0, 0.0)

#: The direct effect alone, as `Influence.terms`: two half-spaces.
HALF_SPACE = np.array([[1.0, 0.0, 1.0]])


class Shape(Protocol):
    """What matters, far away, of how the pressure is distributed across the contact: a strip element, or `HERTZ`."""

    @property
    def far_constant(self) -> float:
        """-int phi ln|xi| of the shape phi, whose integral is 1, over its half-width."""

    @property
    def hertz_ratio(self) -> float:
        """Half-width of the Hertz line contact of equal load over that of the shape."""


@dataclass(frozen=True)
class _Hertz:
    far_constant: float = math.log(2.0) + 0.5
    hertz_ratio: float = 1.0


#: The semi-ellipse of a line contact.
HERTZ: Shape = _Hertz()


@dataclass(frozen=True)
class Depth:
    """How loads on the surface of one body move the points that its displacement is measured against.

    Attributes
    ----------
    below : callable
        y [mm] -> depth d of the point below the surface [mm].
    poisson_factor : float
        1 / (2 (1 - nu)).
    terms : ndarray, shape (terms, 3)
        Rows as for the surface, of this body alone, its share of the compliance in the weights.
    far : callable or None
        y [mm] -> what images too far away to be told apart add to the surface's displacement, per unit of load.
    """

    below: Callable[[Array], Array]
    poisson_factor: float
    terms: Array
    far: Callable[[Array], Array] | None = None

    def displacement(self, y: Array, edges: Array) -> Array:
        """Return the displacement at depth under ``y`` per unit of K q of each strip, shape (places, strips)."""
        result = np.diff(_at_depth(y, self.below(y), edges, self.poisson_factor, self.terms), axis=1)
        if self.far is not None:
            result -= self.far(y)[:, None] * np.diff(edges)
        return np.ascontiguousarray(result)


@dataclass(frozen=True)
class End:
    """A place where one body or both have a free side face, with image weights that have a solution.

    Attributes
    ----------
    y : float
        Where [mm].
    side : int
        -1 at the low, 1 at the high end of the bodies.
    weights : tuple of float
        Weights of the images of body a and b about this face, at most such that ``image_weight`` is 1.
    wanted : float
        kappa of the weights that were asked for on this side, near faces of the other body counted in.
    image_weight : float
        kappa of this face alone with the weights used.
    """

    y: float
    side: int
    weights: tuple[float, float]
    wanted: float
    image_weight: float


@dataclass(frozen=True)
class Influence:
    """How strips act on the centre line: on both surfaces, and on the points at depth of each body that has any.

    Attributes
    ----------
    terms : ndarray, shape (terms, 3)
        Rows (sign, offset, weight); see the module.
    depths : tuple of Depth
        Of the bodies that have one.
    ends : tuple of End
        The free side faces that the images in ``terms`` are about.
    """

    terms: Array
    depths: tuple[Depth, ...] = ()
    ends: tuple[End, ...] = ()

    def at_depth(self, y: Array, edges: Array) -> Array:
        """Return the displacement of the points at depth per unit of K q, shape (places, strips)."""
        if not self.depths:
            return np.zeros((y.size, edges.size - 1))
        return sum((depth.displacement(y, edges) for depth in self.depths[1:]), self.depths[0].displacement(y, edges))

    def shallowest(self, y: Array) -> Array:
        """Return the lesser depth of both bodies under the places ``y``, infinite where neither has one."""
        shallowest = np.full(y.shape, np.inf)
        for depth in self.depths:
            shallowest = np.minimum(shallowest, depth.below(y))
        return shallowest


def ends(contact: Contact) -> tuple[End, ...]:
    """Return the free side faces of both bodies, those at one place together."""
    found: list[End] = []
    shares = _shares(contact)
    for index, side in enumerate((-1, 1)):
        faces = contact.a.faces[index], contact.b.faces[index]
        asked = contact.a.face_weights[index], contact.b.face_weights[index]
        kappa = asked[0] * shares[0], asked[1] * shares[1]
        together = _nearness(contact, faces)
        wanted = kappa[0] + together * kappa[1], kappa[1] + together * kappa[0]
        by = 1.0 / max(wanted[0], 1.0), 1.0 / max(wanted[1], 1.0)
        if together == 1.0:
            weights = by[0] * asked[0], by[0] * asked[1]
            found.append(End(0.5 * (faces[0] + faces[1]), side, weights, wanted[0], by[0] * wanted[0]))
        else:
            found.append(End(faces[0], side, (by[0] * asked[0], 0.0), wanted[0], by[0] * kappa[0]))
            found.append(End(faces[1], side, (0.0, by[1] * asked[1]), wanted[1], by[1] * kappa[1]))
    return tuple(end for end in found if end.image_weight > 0.0)


def _nearness(contact: Contact, faces: tuple[float, float]) -> float:
    """Return 1 for faces at one place, falling to 0 at a distance of APART.

    Faces much nearer to each other than the half-width act as one on all the contact but the last bit of it. The
    measure is continuous so that the approach does not jump where they meet, and geometrical, not of the load, so that
    twice the load is still a change of the load alone.
    """
    if not np.all(np.isfinite(faces)):
        return 0.0
    place = np.clip(0.5 * (faces[0] + faces[1]), *contact.interval)
    radius = 1.0 / float(contact.curvature(np.array([place]))[0])
    nearness = 1.0 - abs(faces[0] - faces[1]) / (APART * radius)
    return 1.0 if nearness > TOGETHER else max(0.0, nearness)


def _shares(contact: Contact) -> tuple[float, float]:
    return (contact.a.material.compliance / contact.compliance, contact.b.material.compliance / contact.compliance)


def influence_of(contact: Contact, shape: Shape) -> Influence:
    """Return how strips between two bodies act, with their side faces and depths."""
    found = ends(contact)
    terms, depths = {_DIRECT: 1.0}, []
    for which in (0, 1):
        images, depth = _of_body(contact, shape, found, which)
        for place, weight in images.items():
            terms[place] = terms.get(place, 0.0) + weight
        if depth is not None:
            depths.append(depth)
    return Influence(_rows(terms), tuple(depths), found)


def influence_within(contact: Contact, shape: Shape, which: int) -> tuple[Array, Depth | None]:
    """Return how loads act within one body alone: the terms, and the points its displacement is measured against.

    Parameters
    ----------
    contact : Contact
        The two bodies.
    shape : Shape
        How the pressure is distributed across.
    which : int
        0 for body a, 1 for body b.

    Returns
    -------
    tuple of ndarray, shape (terms, 3), and Depth or None
        Rows (sign, offset, weight), the weight 1 for the load itself; None where the points are far away.
    """
    images, depth = _of_body(contact, shape, ends(contact), which)
    terms = _rows({_DIRECT: 1.0, **images})
    terms[1:, 2] /= _shares(contact)[which]
    return terms, depth


def _of_body(
    contact: Contact, shape: Shape, found: tuple[End, ...], which: int
) -> tuple[dict[tuple[float, float], float], Depth | None]:
    """Return (sign, offset) -> weight of the images of one body, its share of the compliance in it, and its depth."""
    body, share = (contact.a, contact.b)[which], _shares(contact)[which]
    weights = {end.side: end.weights[which] for end in found if end.weights[which] > 0.0}
    images = _images(body, (weights.get(-1, 0.0), weights.get(1, 0.0)), share)
    below = depth_below(body, shape)
    if below is None:
        return images, None
    factor = 1.0 / (2.0 * (1.0 - body.material.poisson))
    far = _far_images(body, weights, share, below, factor) if body.images == SERIES else None
    return images, Depth(below, factor, _rows({_DIRECT: share, **images}), far)


def _rows(terms: dict[tuple[float, float], float]) -> Array:
    """Return rows (sign, offset, weight)."""
    return np.array([(*place, weight) for place, weight in terms.items()])


def _images(body: Body, weights: tuple[float, float], share: float) -> dict[tuple[float, float], float]:
    """Return (sign, offset) -> weight of one body's images."""
    count = SEPARATE_LINKS if body.images == SERIES else 2 * int(body.images) - 1
    found: dict[tuple[float, float], float] = {}
    for first in (0, 1):
        sign, offset, weight = 1.0, 0.0, share
        for link in range(count):
            at = (first + link) % 2
            weight *= weights[at] if link == 0 else min(weights[at], 1.0)
            if weight < NO_WEIGHT * share:
                break
            sign, offset = -sign, 2.0 * body.faces[at] - offset
            # The chains that begin at either face meet in no place, but their numbers may.
            found[sign, offset] = found.get((sign, offset), 0.0) + weight
    return found


def _far_images(
    body: Body, weights: dict[int, float], share: float, below: Callable[[Array], Array], factor: float
) -> Callable[[Array], Array] | None:
    """Return what the images of a series add that are too far away to be told apart.

    They are line loads at multiples of the length L: from a distance s, surface less depth, 1/s - 1/sqrt(s^2 + d^2)
    - d^2 / (2 (1 - nu) (s^2 + d^2)^(3/2)) per unit of load. Those beyond the last link come as the integral.
    """
    if len(weights) < 2 or body.length is None:  # one mirror alone makes one image
        return None
    length, link = body.length, np.arange(SEPARATE_LINKS, ALL_LINKS, dtype=np.float64)
    distance, beyond = length * (link + 1.0), length * (ALL_LINKS + 0.5)
    weight: Array = np.zeros(link.size)
    for first, other in ((-1, 1), (1, -1)):
        again = min(weights[first], 1.0) ** (link // 2) * min(weights[other], 1.0) ** ((link + 1) // 2)
        weight += share * weights[first] * again

    # Partial functions rather than nested ones, so that what holds them can be pickled.
    return partial(_added_from_afar, below, factor, distance, weight, beyond, length)


def _added_from_afar(
    below: Callable[[Array], Array],
    factor: float,
    distance: Array,
    weight: Array,
    beyond: float,
    length: float,
    y: Array,
) -> Array:
    depth, back = np.unique(below(y), return_inverse=True)
    square = distance**2 + depth[:, None] ** 2
    kernel = 1.0 / distance - (1.0 + factor * depth[:, None] ** 2 / square) / np.sqrt(square)
    u = beyond / depth
    remainder = np.arcsinh(u) - np.log(2.0 * u) + factor * (u / np.hypot(1.0, u) - 1.0)
    total: Array = kernel @ weight + remainder / length * weight[-1]
    return total[back.ravel()]


def depth_below(body: Body, shape: Shape) -> Callable[[Array], Array] | None:
    """Return y [mm] -> depth [mm] below the surface of the point that displacement is measured against.

    In plane strain the displacement of a strip of infinite length against depth d is 2 K q (ln(d / a) + C - 1 /
    (2 (1 - nu))), C the element's constant; a long cylinder is compressed by K q (2 ln(2 D / b) - 1). Both agree at
    d = 2 D (a / b) exp(1 / (2 (1 - nu)) - C - 1/2), in which the load cancels.
    """
    if body.depth == "none":
        return None
    if not isinstance(body.depth, str):
        return partial(_even_depth, float(body.depth))
    factor = 1.0
    if body.depth == "plane-strain":
        factor = plane_strain_depth(shape, body.material.poisson)

    return partial(_depth_in_diameters, body, factor)


def _even_depth(depth: float, y: Array) -> Array:
    return np.full(y.shape, depth)


def _depth_in_diameters(body: Body, factor: float, y: Array) -> Array:
    curvature = body.curvature(y)
    if np.any(curvature <= 0.0):
        remedy = "give the thickness of the body in mm, or write 'none'"
        raise InputError("depth", body.depth, "only be asked of a body that is convex everywhere", remedy)
    depth: Array = 2.0 * factor / curvature
    return depth


def plane_strain_depth(shape: Shape, poisson: float) -> float:
    """Return depth / diameter at which a long cylinder's compression is that of plane strain.

    Examples
    --------
    >>> from nonhertz.strip.element import SEMI_ELLIPTIC
    >>> round(plane_strain_depth(SEMI_ELLIPTIC, 0.3), 4)
    0.7515
    """
    exponent = 1.0 / (2.0 * (1.0 - poisson)) - shape.far_constant - 0.5
    return 2.0 / shape.hertz_ratio * math.exp(exponent)


@compiled
def _at_depth(y: Array, depth: Array, edges: Array, poisson_factor: float, terms: Array) -> Array:
    """Return what a load from the far left up to each edge does at depth under each place, up to a constant."""
    out = np.zeros((y.size, edges.size))
    for i in range(y.size):
        inverse = 1.0 / depth[i]
        for k in range(terms.shape[0]):
            sign, offset, weight = terms[k, 0], terms[k, 1] - y[i], terms[k, 0] * terms[k, 2]
            for e in range(edges.size):
                u = (sign * edges[e] + offset) * inverse
                root = math.sqrt(1.0 + u * u)
                value = math.log(abs(u) + root)
                out[i, e] += weight * (math.copysign(value, u) + poisson_factor * u / root)
    return out
