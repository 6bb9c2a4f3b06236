"""Profiles made of straight lines: straight, conical, tapered ends, chamfer."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from nonhertz.amounts import mm
from nonhertz.errors import InputError
from nonhertz.inputs.checks import not_negative, number_that, positive
from nonhertz.inputs.descriptions import Quantity
from nonhertz.model.profile.base import Array, Formula, Profile, Straight
from nonhertz.model.profile.kind import kind

_ANGLE_REMEDY = "give the angle in rad, 1 degree is 0.01745"


@dataclass(frozen=True)
class Conical(Formula):
    """A relief that grows along the whole axis at a constant angle."""

    angle: float

    def relief_at(self, y: Array) -> Array:
        """Return ``tan(angle) * y`` [mm]."""
        return np.asarray(math.tan(self.angle) * y)


@dataclass(frozen=True)
class TaperedEnds(Formula):
    """A straight middle and two conical ends."""

    straight: float
    angle: float

    def relief_at(self, y: Array) -> Array:
        """Return the relief [mm], zero in the straight middle."""
        past = np.maximum(np.abs(y) - 0.5 * self.straight, 0.0)
        return np.asarray(math.tan(self.angle) * past)

    @property
    def bends(self) -> tuple[float, ...]:
        """Both ends of the straight middle."""
        if self.angle == 0.0:
            return ()
        return (-0.5 * self.straight, 0.5 * self.straight) if self.straight > 0.0 else (0.0,)


BEARS_NOTHING = 0.05
"""Drop [mm] at the end beyond which no contact reaches: surfaces deflect by tens of micrometres at most."""


@dataclass(frozen=True)
class Chamfers(TaperedEnds):
    """Tapered ends too steep to carry load, such as those of a roller beyond its effective length."""

    @property
    def joints(self) -> tuple[float, float]:
        """Positions where the chamfers begin [mm]."""
        return -0.5 * self.straight, 0.5 * self.straight


@kind()
def straight() -> Profile:
    """Return a straight profile: no relief anywhere.

    Examples
    --------
    >>> float(straight().relief(3.0))
    0.0
    """
    return Straight()


_less_than_upright = number_that(lambda angle: abs(angle) < 0.5 * math.pi, "lie in (-pi/2, pi/2)")
_acute = number_that(lambda angle: 0.0 <= angle < 0.5 * math.pi, "lie in [0, pi/2)")


@kind(by_drop=("angle",))
def conical(
    angle: Annotated[
        float,
        Quantity(
            "rad",
            "the angle of the surface to its nominal direction; positive if thinner towards positive y",
            _less_than_upright,
            _ANGLE_REMEDY,
        ),
    ],
) -> Profile:
    """Return a conical profile: a taper over the whole length, such as a grinding error.

    Relief = tan(angle) y. It is zero in the middle of the body, which keeps its nominal diameter, and
    negative on the side where the body is thicker.

    References
    ----------
    Geometry. In a contact, a taper is the same as a tilt by ``-tan(angle)``.

    Examples
    --------
    >>> round(float(conical(angle=0.5e-3).relief(10.0)), 9)
    0.005
    """
    return Conical(angle)


@kind(by_drop=("angle", "straight"))
def tapered_ends(
    straight: Annotated[
        float,
        Quantity(
            "mm",
            "the length of the straight middle",
            not_negative,
            "give the length of the straight middle in mm, 0 for none",
        ),
    ],
    angle: Annotated[float, Quantity("rad", "the angle of the ends to the middle, below pi/2", _acute, _ANGLE_REMEDY)],
) -> Profile:
    """Return a profile with a straight middle and tapered (conical) ends.

    Relief = tan(angle) (abs(y) - straight / 2) outside the straight middle.

    References
    ----------
    "Tapered-end" roller profile in J. V. Poplawski, S. M. Peters and E. V. Zaretsky, Effect of roller profile
    on cylindrical roller bearing life prediction, NASA/TM-2000-210368 (2000).

    Examples
    --------
    >>> round(float(tapered_ends(straight=10, angle=1e-3).relief(-8.0)), 9)
    0.003000001
    """
    return TaperedEnds(straight, angle)


def _on_the_body(length: float, width: float) -> None:
    if 2.0 * width > length:
        condition = f"not exceed half of the length of {mm(length):g}"
        raise InputError("width", width, condition, "give the length of one chamfer in mm")


@kind(by_drop=("angle", "width"), of_body={"length": "length"}, cross_checks=(_on_the_body,))
def chamfer(
    length: Annotated[
        float,
        Quantity("mm", "the length of the body, chamfers included", positive, "give the length of the body in mm"),
    ],
    width: Annotated[
        float,
        Quantity(
            "mm",
            "the length of one chamfer along the axis, at most half of the body's",
            positive,
            "give the length of one chamfer along the axis in mm",
        ),
    ],
    angle: Annotated[
        float, Quantity("rad", "the angle of the chamfer to the axis, below pi/2", _acute, _ANGLE_REMEDY)
    ] = 0.25 * math.pi,
) -> Profile:
    """Return the chamfers at both ends of a body, to be added to the profile between them.

    Relief = tan(angle) (abs(y) - length / 2 + width) over the last ``width`` before each end.

    References
    ----------
    Geometry. Contact ends where a chamfer begins: the surfaces deflect by micrometres there, while the chamfer
    drops by tenths of a millimetre.

    Examples
    --------
    >>> profile = conical(angle=1e-4) + chamfer(length=20, width=0.5)
    >>> profile.bends
    (-9.5, 9.5)
    """
    ends = Chamfers if width * math.tan(angle) > BEARS_NOTHING else TaperedEnds
    return ends(length - 2.0 * width, angle)
