"""Profiles made of straight lines: straight, conical, tapered ends, chamfer."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from nonhertz.errors import InputError, shown
from nonhertz.inputs.checks import finite, not_negative, positive
from nonhertz.model.profile.base import Array, Formula, Profile, Straight

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
"""Drop [mm] of an end that no contact reaches: surfaces deflect by tens of micrometres at most."""


@dataclass(frozen=True)
class Chamfers(TaperedEnds):
    """The same where the ends are too steep to bear, as those of a roller beyond its effective length."""

    @property
    def joints(self) -> tuple[float, float]:
        """Where the chamfers begin [mm]."""
        return -0.5 * self.straight, 0.5 * self.straight


def straight() -> Profile:
    """Return a straight profile: no relief anywhere.

    Examples
    --------
    >>> float(straight().relief(3.0))
    0.0
    """
    return Straight().called("straight")


def conical(angle: float) -> Profile:
    """Return a conical profile: a taper over the whole length, such as a grinding error.

    Relief = tan(angle) y. It is zero in the middle of the body, which keeps its nominal diameter, and
    negative on the side where the body is thicker.

    Parameters
    ----------
    angle : float
        Angle of the surface to its nominal direction [rad], in (-pi/2, pi/2); positive: thinner towards
        positive y.

    Raises
    ------
    InputError
        If ``angle`` is out of range.

    References
    ----------
    Geometry. In a contact, a taper is the same as a tilt by ``-tan(angle)``.

    Examples
    --------
    >>> round(float(conical(angle=0.5e-3).relief(10.0)), 9)
    0.005
    """
    finite("angle", angle, _ANGLE_REMEDY)
    if abs(angle) >= 0.5 * math.pi:
        raise InputError("angle", angle, "lie in (-pi/2, pi/2)", _ANGLE_REMEDY)
    return Conical(float(angle)).called("conical", angle=angle)


def tapered_ends(straight: float, angle: float) -> Profile:
    """Return a profile with a straight middle and tapered (conical) ends.

    Relief = tan(angle) (abs(y) - straight / 2) outside the straight middle.

    Parameters
    ----------
    straight : float
        Length of the straight middle [mm], not negative.
    angle : float
        Angle of the ends to the middle [rad], in [0, pi/2).

    References
    ----------
    "Tapered-end" roller profile in J. V. Poplawski, S. M. Peters and E. V. Zaretsky, Effect of roller profile
    on cylindrical roller bearing life prediction, NASA/TM-2000-210368 (2000).

    Examples
    --------
    >>> round(float(tapered_ends(straight=10, angle=1e-3).relief(-8.0)), 9)
    0.003000001
    """
    not_negative("straight", straight, "give the length of the straight middle in mm, 0 for none")
    _acute(angle)
    return TaperedEnds(float(straight), float(angle)).called("tapered-ends", straight=straight, angle=angle)


def chamfer(length: float, width: float, angle: float = 0.25 * math.pi) -> Profile:
    """Return the chamfers at both ends of a body, to be added to the profile between them.

    Relief = tan(angle) (abs(y) - length / 2 + width) over the last ``width`` before each end.

    Parameters
    ----------
    length : float
        Length of the body, chamfers included [mm], positive.
    width : float
        Length of one chamfer along the axis [mm], positive, at most half of ``length``.
    angle : float
        Angle of the chamfer to the axis [rad], in [0, pi/2); 45 degrees if left out.

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
    positive("length", length, "give the length of the body in mm")
    positive("width", width, "give the length of one chamfer along the axis in mm")
    if 2.0 * width > length:
        raise InputError(
            "width",
            width,
            f"not exceed half of the length of {shown(length)} mm",
            "give the length of one chamfer in mm",
        )
    _acute(angle)
    kind = Chamfers if float(width) * math.tan(angle) > BEARS_NOTHING else TaperedEnds
    ends = kind(float(length) - 2.0 * float(width), float(angle))
    return ends.called("chamfer", length=length, width=width, angle=angle)


def _acute(angle: float) -> None:
    finite("angle", angle, _ANGLE_REMEDY)
    if not 0.0 <= angle < 0.5 * math.pi:
        raise InputError("angle", angle, "lie in [0, pi/2)", _ANGLE_REMEDY)
