"""The free side faces of two bodies in contact, and the number that governs a sharp end.

The number is kappa, the sum of image weight times share of the compliance over the bodies that end there. Up to kappa
= 1 the pressure varies with the distance s from the end as s^-alpha, cos(pi alpha) = kappa; above 1 refinement does
not converge to any solution, so weights are lowered to kappa = 1.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from nonhertz.model.contact import Contact

APART = 0.02  # of the combined radius: about the half-width of a heavily loaded contact of metals
TOGETHER = 1.0 - 1e-4
# kappa at and above which the pressure counts as finite up to an end: alpha is below 0.015 there, a change of less than
# 10 % in pressure over three decades of distance.
FINITE_FROM = 0.999
_HALVINGS = 60
# Exponents alpha of the pressures s^-alpha to which the weights of a corner are fitted.
_FITTED = (-0.4, -0.3, -0.2, -0.1, 0.05, 0.1, 0.15, 0.226, 0.3)
# Measured: plane strain gives 70 to 80 % of the weight that matches finite elements of whole rollers, for all angles,
# lengths and Poisson's ratios. It determines the slope at the corner; the displacement there is three-dimensional.
IN_SPACE = 1.35
_ANY_POISSON = 0.3


@dataclass(frozen=True)
class End:
    """Position at which one or both bodies have a free side face, with image weights for which a solution exists.

    Attributes
    ----------
    y : float
        Position [mm].
    side : int
        -1 at the low, 1 at the high end of the bodies.
    weights : tuple of float
        Weights of the images of body a and b about this face, limited so that ``image_weight`` is at most 1.
    requested : float
        kappa of the weights requested on this side, including nearby faces of the other body.
    image_weight : float
        kappa of this face alone with the weights used, in plane strain.
    free : float
        The part of ``image_weight`` of faces that are also free of normal stress.
    """

    y: float
    side: int
    weights: tuple[float, float]
    requested: float
    image_weight: float
    free: float


def edge_exponent(kappa: float, free: float = 0.0) -> float:
    """Return alpha of a pressure that varies with the distance s from an end as s^-alpha.

    Parameters
    ----------
    kappa : float
        Sum over the bodies that end there of image weight times share of the compliance.
    free : float
        The part of it of faces that are also free of normal stress. The loads on both faces are then those of a wedge:
        a pressure s^-alpha causes mu s^-alpha on the other face, so that the sum of all reflections is 1 / (1 - mu^2)
        times the pressure. It does not depend on Poisson's ratio.

    Examples
    --------
    >>> edge_exponent(0.0), edge_exponent(1.0)  # a half-space ends, and a mirrored end that both bodies share
    (0.5, 0.0)
    >>> round(edge_exponent(0.5, free=0.5), 5)  # a free end on a long body of the same material
    0.22599
    """
    mirrored = math.acos(min(kappa, 1.0)) / math.pi
    # The normal stress that images leave on the side face presses it outwards: the end is softer, and alpha smaller.
    return _zero_between(0.0, mirrored, kappa, free) if free > 0.0 and kappa < 1.0 else mirrored


@lru_cache
def edge_powers(kappa: float, free: float = 0.0) -> tuple[float, float, float]:
    """Return the first three powers of the distance from an end whose pressures displace its surface smoothly.

    The first is -alpha; arguments as for `edge_exponent`.
    """
    alpha = edge_exponent(kappa, free)
    if not free > 0.0:
        return -alpha, alpha, 2.0 - alpha
    return -alpha, -_zero_between(0.0, -1.0, kappa, free), -_zero_between(-2.0, -1.0, kappa, free)


def _zero_between(positive: float, negative: float, kappa: float, free: float) -> float:
    """Return the exponent at which `wedge_slope` is zero, between one where it is positive and one where negative."""
    for _ in range(_HALVINGS):
        middle = 0.5 * (positive + negative)
        if wedge_slope(middle, kappa, free) > 0.0:
            positive = middle
        else:
            negative = middle
    return 0.5 * (positive + negative)


def wedge_slope(alpha: float, kappa: float, free: float) -> float:
    """Return the slope that a pressure s^-alpha leaves on the surfaces of two wedges; zero for that of an end."""
    cosine = math.cos(math.pi * alpha)
    brought = (1.0 - alpha) / math.cos(0.5 * math.pi * alpha)
    return cosine - kappa - free * (1.0 - cosine) * brought**2 / (1.0 - brought**2)


@lru_cache
def corner_weights(angle: float) -> tuple[float, float]:
    """Return the excess over 1 of the weights of image and free face at a corner that is not a right angle.

    They are fitted to the slopes of the wedge in plane strain, minus those at 90 degrees, under powers of the distance.

    Parameters
    ----------
    angle : float
        Between surface and side face, within the body [rad].

    Examples
    --------
    >>> corner_weights(0.5 * math.pi)
    (0.0, 0.0)
    """
    if angle == 0.5 * math.pi:
        return 0.0, 0.0
    wanted = [slope_of_wedge(alpha, angle) - slope_of_wedge(alpha, 0.5 * math.pi) for alpha in _FITTED]
    image = [-math.pi / math.sin(math.pi * alpha) for alpha in _FITTED]
    extra = [wedge_slope(alpha, 0.0, 0.0) - wedge_slope(alpha, 0.0, 1.0) for alpha in _FITTED]
    basis = np.stack([np.ones(len(_FITTED)), extra], axis=-1)
    weights = np.linalg.lstsq(basis, np.divide(wanted, image), rcond=None)[0]
    return float(weights[0]), float(weights[1])


def slope_of_wedge(alpha: float, angle: float) -> float:
    """Return the slope over 2 K of one face of a wedge in plane strain under a pressure s^-alpha on it, at s = 1.

    Airy's function is s^m times cos and sin of m theta and of (2 - m) theta, m = 2 - alpha (J. R. Barber, Elasticity,
    chapter 11); the other face is free of normal and shear stress. It does not depend on Poisson's ratio.
    """
    m, n = 2.0 - alpha, -alpha

    def of(theta: float) -> list[list[float]]:
        values = [math.cos(m * theta), math.sin(m * theta), math.cos(n * theta), math.sin(n * theta)]
        slopes = [-m * values[1], m * values[0], -n * values[3], n * values[2]]
        return [[m * (m - 1.0) * value for value in values], slopes]

    amplitudes = np.linalg.solve([*of(0.0), *of(angle)], [-1.0, 0.0, 0.0, 0.0])
    across = -m * amplitudes[1] - (4.0 - 4.0 * _ANY_POISSON + n) * amplitudes[3]
    return float((1.0 - alpha) * across * math.pi / (2.0 * (1.0 - _ANY_POISSON)))


def shares(contact: Contact) -> tuple[float, float]:
    """Return the shares of both bodies in the compliance of the contact."""
    return (contact.a.material.compliance / contact.compliance, contact.b.material.compliance / contact.compliance)


def ends(contact: Contact) -> tuple[End, ...]:
    """Return the free side faces of both bodies, coincident ones combined."""
    candidates: list[End] = []
    share = shares(contact)
    for index, side in enumerate((-1, 1)):
        faces = contact.a.faces[index], contact.b.faces[index]
        requested_weights = contact.a.face_weights[index], contact.b.face_weights[index]
        kappa = requested_weights[0] * share[0], requested_weights[1] * share[1]
        free = contact.a.free_faces[index] * share[0], contact.b.free_faces[index] * share[1]
        together = _nearness(contact, faces)
        requested = kappa[0] + together * kappa[1], kappa[1] + together * kappa[0]
        by = 1.0 / max(requested[0], 1.0), 1.0 / max(requested[1], 1.0)
        corner = [corner_weights(body.corner_angles[index]) for body in (contact.a, contact.b)]
        weights = [by[k] * requested_weights[k] * (1.0 + IN_SPACE * corner[k][0]) for k in (0, 1)]
        # The exponent is the one in plane strain.
        images = [by[k] * kappa[k] * (1.0 + corner[k][0]) for k in (0, 1)]
        extra = [free[k] * (1.0 + corner[k][1]) for k in (0, 1)]
        if together == 1.0:
            place = 0.5 * (faces[0] + faces[1])
            candidates.append(End(place, side, (weights[0], weights[1]), requested[0], sum(images), sum(extra)))
        else:
            candidates.append(End(faces[0], side, (weights[0], 0.0), requested[0], images[0], extra[0]))
            candidates.append(End(faces[1], side, (0.0, weights[1]), requested[1], images[1], extra[1]))
    return tuple(end for end in candidates if end.image_weight > 0.0)


def _nearness(contact: Contact, faces: tuple[float, float]) -> float:
    """Return 1 for coincident faces, falling to 0 at a distance of APART combined radii.

    Faces much closer to each other than the half-width act as one on all but a tiny part of the contact. The measure
    is continuous, so that the approach does not jump where they meet, and depends on geometry, not on the load, so that
    results scale with the load.
    """
    if not np.all(np.isfinite(faces)):
        return 0.0
    place = np.clip(0.5 * (faces[0] + faces[1]), *contact.interval)
    radius = 1.0 / float(contact.curvature(np.array([place]))[0])
    nearness = 1.0 - abs(faces[0] - faces[1]) / (APART * radius)
    return 1.0 if nearness > TOGETHER else max(0.0, nearness)
