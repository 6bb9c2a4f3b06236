"""The free side faces of two bodies in contact, and the number that governs a sharp end.

It is kappa, the sum over the bodies that end there of image weight times share of the compliance. Up to kappa = 1 the
pressure varies with the distance s from the end as s^-alpha, cos(pi alpha) = kappa; above 1 refinement does not
converge to any solution, so weights are lowered to kappa = 1.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from nonhertz.bodies.solid import Pair

APART = 0.02  # of the combined radius: about the half-width of a heavily loaded contact of metals
TOGETHER = 1.0 - 1e-4
# kappa at and above which the pressure counts as finite up to an end: alpha is below 0.015 there, a change of less than
# 10 % in pressure over three decades of distance.
FINITE_FROM = 0.999


@dataclass(frozen=True)
class End:
    """A place where one body or both have a free side face, with image weights for which a solution exists.

    Attributes
    ----------
    y : float
        Where [mm].
    side : int
        -1 at the low, 1 at the high end of the bodies.
    weights : tuple of float
        Weights of the images of body a and b about this face, limited so that ``image_weight`` is at most 1.
    requested : float
        kappa of the weights requested on this side, including nearby faces of the other body.
    image_weight : float
        kappa of this face alone with the weights used.
    """

    y: float
    side: int
    weights: tuple[float, float]
    requested: float
    image_weight: float


def edge_exponent(kappa: float) -> float:
    """Return alpha of a pressure that varies with the distance s from an end as s^-alpha.

    Examples
    --------
    >>> edge_exponent(0.0), edge_exponent(1.0)  # a half-space ends, and a mirrored end that both bodies share
    (0.5, 0.0)
    """
    return math.acos(kappa) / math.pi


def shares(contact: Pair) -> tuple[float, float]:
    """Return the shares of both bodies in the compliance of the contact."""
    return (contact.a.material.compliance / contact.compliance, contact.b.material.compliance / contact.compliance)


def ends(contact: Pair) -> tuple[End, ...]:
    """Return the free side faces of both bodies, coincident ones combined."""
    found: list[End] = []
    share = shares(contact)
    for index, side in enumerate((-1, 1)):
        faces = contact.a.faces[index], contact.b.faces[index]
        asked = contact.a.face_weights[index], contact.b.face_weights[index]
        kappa = asked[0] * share[0], asked[1] * share[1]
        together = _nearness(contact, faces)
        requested = kappa[0] + together * kappa[1], kappa[1] + together * kappa[0]
        by = 1.0 / max(requested[0], 1.0), 1.0 / max(requested[1], 1.0)
        if together == 1.0:
            weights = by[0] * asked[0], by[0] * asked[1]
            found.append(End(0.5 * (faces[0] + faces[1]), side, weights, requested[0], by[0] * requested[0]))
        else:
            found.append(End(faces[0], side, (by[0] * asked[0], 0.0), requested[0], by[0] * kappa[0]))
            found.append(End(faces[1], side, (0.0, by[1] * asked[1]), requested[1], by[1] * kappa[1]))
    return tuple(end for end in found if end.image_weight > 0.0)


def _nearness(contact: Pair, faces: tuple[float, float]) -> float:
    """Return 1 for coincident faces, falling to 0 at a distance of APART combined radii.

    Faces much closer to each other than the half-width act as one on all but the last bit of the contact. The
    measure is continuous, so that the approach does not jump where they meet, and depends on geometry rather than load,
    so that doubling the load changes nothing but the load.
    """
    if not np.all(np.isfinite(faces)):
        return 0.0
    place = np.clip(0.5 * (faces[0] + faces[1]), *contact.interval)
    radius = 1.0 / float(contact.curvature(np.array([place]))[0])
    nearness = 1.0 - abs(faces[0] - faces[1]) / (APART * radius)
    return 1.0 if nearness > TOGETHER else max(0.0, nearness)
