"""What side faces and thickness add to two half-spaces.

A side face at y = f is freed of shear by the image of every strip about it, for the body that ends there and for
its share of the compliance alone. With two faces the images have images: one chain begins at either face, and its
links alternate between both. The first image of a face may weigh more than 1, to make up for the normal stress that
mirroring leaves on the face; further images only cancel the shear of earlier ones, for which 1 is right.

The weight that governs a sharp end is kappa, the sum over the bodies that end there of image weight times share of
the compliance. Up to kappa = 1 the pressure goes with the distance s from the end like s^-alpha, cos(pi alpha) =
kappa; beyond, the equations have no solution that refinement converges to, so weights are lowered to kappa = 1.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from nonhertz.errors import InputError
from nonhertz.model.body import Body
from nonhertz.model.contact import Contact
from nonhertz.model.finite import SERIES
from nonhertz.strip.element import Element
from nonhertz.strip.influence import Depth, End, Influence

Array = NDArray[np.float64]

APART = 0.02  # of the combined radius: about the half-width of a heavily loaded contact of metals
TOGETHER = 1.0 - 1e-4
SEPARATE_LINKS, ALL_LINKS = 16, 1000  # of a series: told apart, and summed one by one
NO_WEIGHT = 1e-12


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


def influence_of(contact: Contact, element: Element) -> Influence:
    """Return how strips between two bodies act, with their side faces and depths."""
    found, direct = ends(contact), (1.0, 0.0)
    terms, depths = {direct: 1.0}, []
    for which, (body, share) in enumerate(zip((contact.a, contact.b), _shares(contact), strict=True)):
        weights = {end.side: end.weights[which] for end in found if end.weights[which] > 0.0}
        images = _images(body, (weights.get(-1, 0.0), weights.get(1, 0.0)), share)
        for place, weight in images.items():
            terms[place] = terms.get(place, 0.0) + weight
        below = depth_below(body, element)
        if below is not None:
            factor = 1.0 / (2.0 * (1.0 - body.material.poisson))
            far = _far_images(body, weights, share, below, factor) if body.images == SERIES else None
            depths.append(Depth(below, factor, _rows({direct: share, **images}), far))
    return Influence(_rows(terms), tuple(depths), found)


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
    length, link = body.length, np.arange(SEPARATE_LINKS, ALL_LINKS)
    distance, beyond = length * (link + 1.0), length * (ALL_LINKS + 0.5)
    weight = np.zeros(link.size)
    for first, other in ((-1, 1), (1, -1)):
        again = min(weights[first], 1.0) ** (link // 2) * min(weights[other], 1.0) ** ((link + 1) // 2)
        weight += share * weights[first] * again

    def added(y: Array) -> Array:
        depth, back = np.unique(below(y), return_inverse=True)
        square = distance**2 + depth[:, None] ** 2
        kernel = 1.0 / distance - (1.0 + factor * depth[:, None] ** 2 / square) / np.sqrt(square)
        u = beyond / depth
        remainder = np.arcsinh(u) - np.log(2.0 * u) + factor * (u / np.hypot(1.0, u) - 1.0)
        total: Array = kernel @ weight + remainder / length * weight[-1]
        return total[back.ravel()]

    return added


def depth_below(body: Body, element: Element) -> Callable[[Array], Array] | None:
    """Return y [mm] -> depth [mm] below the surface of the point that displacement is measured against.

    In plane strain the displacement of a strip of infinite length against depth d is 2 K q (ln(d / a) + C - 1 /
    (2 (1 - nu))), C the element's constant; a long cylinder is compressed by K q (2 ln(2 D / b) - 1). Both agree at
    d = 2 D (a / b) exp(1 / (2 (1 - nu)) - C - 1/2), in which the load cancels.
    """
    if body.depth == "none":
        return None
    if not isinstance(body.depth, str):
        depth = float(body.depth)
        return lambda y: np.full(y.shape, depth)
    factor = 1.0
    if body.depth == "plane-strain":
        factor = plane_strain_depth(element, body.material.poisson)

    def below(y: Array) -> Array:
        curvature = body.curvature(y)
        if np.any(curvature <= 0.0):
            remedy = "give the thickness of the body in mm, or write 'none'"
            raise InputError("depth", body.depth, "only be asked of a body that is convex everywhere", remedy)
        depth: Array = 2.0 * factor / curvature
        return depth

    return below


def plane_strain_depth(element: Element, poisson: float) -> float:
    """Return depth / diameter at which a long cylinder's compression is that of plane strain.

    Examples
    --------
    >>> from nonhertz.strip.element import SEMI_ELLIPTIC
    >>> round(plane_strain_depth(SEMI_ELLIPTIC, 0.3), 4)
    0.7515
    """
    exponent = 1.0 / (2.0 * (1.0 - poisson)) - element.far_constant - 0.5
    return 2.0 / element.hertz_ratio * math.exp(exponent)
