"""How the finite length and thickness of a body are asked for: weights of images, number of images, depth.

A side face of a half-space is freed of shear by an image of the pressure behind it. The image doubles the normal
stress on the face instead of removing it, so the end is still too stiff; a weight above 1 makes up for part of that.
"""

from __future__ import annotations

import math
from numbers import Real

import numpy as np

from nonhertz.errors import InputError
from nonhertz.inputs.checks import not_negative, positive

FaceRule = str | float
DepthRule = str | float

FEWEST_IMAGES = 1
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
        Poisson's ratio nu [-]. Linear between the fitted values; outside 0 to 0.4, where nothing was fitted, the
        outermost weight is held.

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
        If ``rule`` is neither one of the words nor a number of at least zero, nor a pair of these.
    """
    pair = rule if isinstance(rule, (tuple, list)) else (rule, rule)
    if len(pair) != 2:
        raise InputError("side_faces", rule, "be one rule, or a pair of rules", _FACE_REMEDY)
    low, high = (_face_weight(single, poisson) for single in pair)
    return low, high


def _face_weight(rule: FaceRule, poisson: float) -> float:
    if rule == "mirror":
        return 1.0
    if rule == "calibrated":
        return calibrated_weight(poisson)
    if rule == "none":
        return 0.0
    if isinstance(rule, bool) or not isinstance(rule, Real):
        raise InputError("side_faces", rule, "be one of 'mirror', 'calibrated', 'none' or a weight", _FACE_REMEDY)
    not_negative("side_faces", rule, _FACE_REMEDY)
    return float(rule)


def check_depth(rule: DepthRule, convex: bool) -> None:
    """Refuse a depth that is neither one of the words nor a positive length, or a diameter the body lacks."""
    words = ("none", "plane-strain", "diameter")
    if isinstance(rule, bool) or not (isinstance(rule, Real) or rule in words):
        raise InputError("depth", rule, "be one of 'none', 'plane-strain', 'diameter' or a length", _DEPTH_REMEDY)
    if not isinstance(rule, str):
        positive("depth", rule, _DEPTH_REMEDY)
    elif rule != "none" and not convex:
        remedy = "give the thickness of a ring or plate in mm, or write 'none'"
        raise InputError("depth", rule, "only be asked of a convex body, which has a diameter to go by", remedy)


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
    whole = (
        isinstance(images, Real) and not isinstance(images, bool) and math.isfinite(images) and images == int(images)
    )
    if not whole or not FEWEST_IMAGES <= images <= MOST_IMAGES:
        raise InputError("images", images, f"be a whole number from {FEWEST_IMAGES} to {MOST_IMAGES}", _IMAGES_REMEDY)
