"""Treatments of a side face, one row for each; a new row appears in Python, case files and web form.

An image of the pressure behind a side face of a half-space removes the shear stress on the face. The image doubles the
normal stress there instead of removing it, so the end is still too stiff; a weight above 1 compensates for part of
that, the correction for an elastic quarter-space (`nonhertz.bodies.quarter_space`) for all of it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

FaceRule = str | float

FEWEST_IMAGES, MOST_IMAGES = 1, 100
SERIES: Final = "series"
IMAGES_REMEDY: Final = f"give {FEWEST_IMAGES} to {MOST_IMAGES}, or {SERIES!r} for all of them"

# Weights with which the pressure is within 2 % of the exact quarter-space from a quarter of the half-width inwards,
# fitted to three-dimensional solutions of a roller that ends on a long body and of two coincident ends.
_POISSON: Final = (0.0, 0.2, 0.25, 0.28, 0.3, 0.33, 0.4)
_WEIGHT: Final = (1.10, 1.35, 1.45, 1.50, 1.60, 1.65, 1.95)


@dataclass(frozen=True)
class SideFace:
    """Treatment of one side face: how, and how far, it is freed of stress.

    Attributes
    ----------
    word : str
        Its keyword in files and Python; empty if given as a number.
    meaning : str
        Its effect, as it follows the word in descriptions of case files.
    weight : float or None
        Weight of the first mirror image about the face, zero for no image; None for the weight that comes closest to a
        free face.
    exact : bool
        Whether the normal stress that an image leaves is removed as well.
    of_body : bool
        Whether the body ends there, so that its field below the surface is free of stress on the face, however the
        pressure was computed.
    """

    word: str
    meaning: str
    weight: float | None
    exact: bool = False
    of_body: bool = True

    def image_weight(self, poisson: float) -> float:
        """Return the weight of the image: this face's part of kappa, which governs a sharp end.

        A fitted weight is linear between Poisson's ratios and constant outside the range of the fit, 0 to 0.4.

        Examples
        --------
        >>> SIDE_FACES["calibrated"].image_weight(0.3)
        1.6
        """
        return float(np.interp(poisson, _POISSON, _WEIGHT)) if self.weight is None else self.weight


#: Treatments by their keywords.
SIDE_FACES: Final = {
    face.word: face
    for face in (
        SideFace("free", "exactly, of shear and of normal stress", 1.0, exact=True),
        SideFace("mirror", "by images of the pressure", 1.0, of_body=False),
        SideFace("calibrated", "by images of the weight that comes nearest to a free face", None),
        SideFace("none", "not at all", 0.0, of_body=False),
    )
}
WEIGHT: Final = "a weight of the images"
FACE_REMEDY: Final = f"write {', '.join(map(repr, SIDE_FACES))} or {WEIGHT}, or a pair for low and high y"


def side_faces(rule: FaceRule | tuple[FaceRule, FaceRule]) -> tuple[SideFace, SideFace]:
    """Return the treatments of the faces at low and high y by a rule, or a pair of them."""
    low, high = (
        SIDE_FACES[face_rule] if isinstance(face_rule, str) else SideFace("", WEIGHT, float(face_rule))
        for face_rule in (rule if isinstance(rule, tuple) else (rule, rule))
    )
    return low, high
