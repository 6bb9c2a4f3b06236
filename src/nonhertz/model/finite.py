"""How the finite length and thickness of a body are asked for: weights of images, number of images, depth.

A side face of a half-space is freed of shear by an image of the pressure behind it. The image doubles the normal
stress on the face instead of removing it, so the end is still too stiff; a weight above 1 makes up for part of that.
"""

from __future__ import annotations

import math

import numpy as np

from nonhertz.errors import InputError
from nonhertz.model.checks import finite, not_negative, positive

FaceRule = str | float
DepthRule = str | float

FIRST_IMAGE = 1
MOST_IMAGES = 100
SERIES = "series"

# Weights that bring the pressure from a quarter of the half-width inwards within 2 % of the exact quarter-space,
# fitted to three-dimensional solutions of a roller that ends on a long body and of two coincident ends.
_CALIBRATED_POISSON = (0.0, 0.2, 0.25, 0.28, 0.3, 0.33, 0.4)
_CALIBRATED_WEIGHT = (1.10, 1.35, 1.45, 1.50, 1.60, 1.65, 1.95)

_FACE_REMEDY = "write 'mirror', 'calibrated', 'none' or a weight of the images, or a pair for low and high y"
_DEPTH_REMEDY = "write 'none', 'plane-strain', 'diameter' or a depth in mm such as the thickness of a ring"
_IMAGES_REMEDY = f"give 1 to {MOST_IMAGES}, or 'series' for all of them"


def calibrated_weight(poisson: float) -> float:
    """Return the weight of a single image that comes nearest to a free side face.

    Parameters
    ----------
    poisson : float
        Poisson's ratio nu [-]. Linear between the fitted values, constant outside 0 to 0.4.

    Examples
    --------
    >>> calibrated_weight(0.3)
    1.6
    """
    return float(np.interp(poisson, _CALIBRATED_POISSON, _CALIBRATED_WEIGHT))


def face_weights(rule: FaceRule | tuple[FaceRule, FaceRule], poisson: float) -> tuple[float, float]:
    """Return the weights of the images about the faces at low and high y.

    Raises
    ------
    InputError
        If ``rule`` is none of the words, a number of at least zero, or a pair of these.
    """
    pair = rule if isinstance(rule, (tuple, list)) else (rule, rule)
    if len(pair) != 2:
        raise InputError("side_faces", rule, "be one rule or two", _FACE_REMEDY)
    low, high = (_face_weight(single, poisson) for single in pair)
    return low, high


def _face_weight(rule: FaceRule, poisson: float) -> float:
    if rule == "mirror":
        return 1.0
    if rule == "calibrated":
        return calibrated_weight(poisson)
    if rule == "none":
        return 0.0
    if isinstance(rule, str):
        raise InputError("side_faces", rule, "be one of 'mirror', 'calibrated', 'none' or a weight", _FACE_REMEDY)
    not_negative("side_faces", rule, _FACE_REMEDY)
    return float(rule)


def check_depth(rule: DepthRule, convex: bool) -> None:
    """Refuse a depth that is none of the words or a positive length, or asks a diameter of a body without one."""
    if isinstance(rule, str):
        if rule not in ("none", "plane-strain", "diameter"):
            raise InputError("depth", rule, "be one of 'none', 'plane-strain', 'diameter' or a length", _DEPTH_REMEDY)
        if rule != "none" and not convex:
            remedy = "give the thickness of a ring or plate in mm, or write 'none'"
            raise InputError("depth", rule, "only be asked of a convex body, which has a diameter to go by", remedy)
        return
    positive("depth", rule, _DEPTH_REMEDY)


def check_images(images: int | str, weights: tuple[float, float], depth: DepthRule) -> None:
    """Refuse a number of images out of range, or a series that has no sum."""
    if isinstance(images, str):
        if images != SERIES:
            raise InputError("images", images, f"be a whole number or {SERIES!r}", _IMAGES_REMEDY)
        if depth == "none" and math.prod(weights) > 0.0:
            remedy = "give the body a depth, or a number of images"
            raise InputError(
                "images", images, "only be asked of a body with a depth, without which it has no sum", remedy
            )
        return
    finite("images", images, _IMAGES_REMEDY)
    if images != int(images) or not FIRST_IMAGE <= images <= MOST_IMAGES:
        raise InputError("images", images, f"be a whole number from {FIRST_IMAGE} to {MOST_IMAGES}", _IMAGES_REMEDY)
