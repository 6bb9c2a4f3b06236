"""Speeds of cage and rollers, and over-rolling frequencies of rings and rollers.

Rollers roll on both rings without sliding, at least in the middle of their length. With the speeds n_i and n_e of the
rings, the roller diameter D, the pitch diameter d and the contact angle alpha,

    n_c = [n_i (1 - g) + n_e (1 + g)] / 2        n_r = (n_e - n_i) (1 - g^2) d / (2 D)        g = D cos(alpha) / d

are the speeds of the cage, and of a roller about its own axis relative to the cage. Z rollers pass a point of a ring at
the rate Z |n - n_c|, and a point of a roller meets the rings at 2 |n_r|. Real rollers slide slightly, most where few of
them are loaded, so that measured frequencies are lower by some per cent.

References
----------
Harris, Kotzalas: Essential Concepts of Bearing Technology, 5th ed. (2006), section 10; Randall, Antoni: Rolling element
bearing diagnostics - a tutorial, Mech. Syst. Signal Process. 25 (2011) 485.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

from nonhertz.errors import InputError
from nonhertz.inputs.checks import finite
from nonhertz.inputs.short_repr import ShortRepr
from nonhertz.result.brief import HasHtml

PER_MINUTE: Final = math.pi / 30.0  # rad/s of 1/min
_SPEED = "give the speed of the ring in 1/min, negative for the opposite direction"


def cage_speed(inner: float, outer: float, ratio: float) -> float:
    """Return n_c for the speeds of both rings and g, in their unit."""
    return 0.5 * (inner * (1.0 - ratio) + outer * (1.0 + ratio))


def roller_speed(inner: float, outer: float, ratio: float, size: float) -> float:
    """Return n_r for the speeds of both rings, g and D / d, in their unit."""
    return 0.5 * (outer - inner) * (1.0 - ratio**2) / size


@dataclass(frozen=True, repr=False)
class Kinematics(ShortRepr, HasHtml):
    """The speeds in a row of rollers, and the frequencies of over-rolling; made by `RollerBearing.kinematics`.

    Attributes
    ----------
    inner_speed, outer_speed : float
        Speeds of the rings [1/min].
    cage_speed : float
        Speed of the cage, and of the rollers about the bearing's axis [1/min].
    roller_speed : float
        Speed of a roller about its own axis relative to the cage [1/min]; positive in the same direction as the rings.
    rollers : int
        Number of rollers.
    """

    inner_speed: float
    outer_speed: float
    cage_speed: float
    roller_speed: float
    rollers: int

    @property
    def inner_frequency(self) -> float:
        """Frequency at which rollers pass a point of the inner ring [Hz]; BPFI."""
        return self.rollers * abs(self.inner_speed - self.cage_speed) / 60.0

    @property
    def outer_frequency(self) -> float:
        """Frequency at which rollers pass a point of the outer ring [Hz]; BPFO."""
        return self.rollers * abs(self.outer_speed - self.cage_speed) / 60.0

    @property
    def roller_frequency(self) -> float:
        """Frequency at which a point of a roller meets a ring [Hz]: twice per revolution, 2 BSF."""
        return abs(self.roller_speed) / 30.0

    @property
    def shaft_frequency(self) -> float:
        """Rotational frequency of the inner ring, or of the outer one if only it turns [Hz], to which orders refer."""
        return abs(self.inner_speed or self.outer_speed) / 60.0


def make_kinematics(rollers: int, size: float, ratio: float, inner_speed: float, outer_speed: float) -> Kinematics:
    """Return the kinematics for a number of rollers, D / d, g, and the speeds of the rings [1/min].

    Raises
    ------
    InputError
        If a speed is not finite, or both are equal, so that nothing rolls.

    Examples
    --------
    >>> found = make_kinematics(16, 0.331 / 2.815, 0.331 / 2.815 * 0.96515, 2000.0, 0.0)  # Rexnord ZA-2115
    >>> round(found.outer_frequency, 1), round(found.inner_frequency, 1), round(found.roller_frequency, 1)
    (236.4, 296.9, 279.8)
    """
    for name, speed in (("inner_speed", inner_speed), ("outer_speed", outer_speed)):
        finite(name, speed, _SPEED)
    if inner_speed == outer_speed:
        raise InputError("inner_speed", inner_speed, "differ from that of the outer ring", _SPEED)
    speeds = float(inner_speed), float(outer_speed)
    return Kinematics(*speeds, cage_speed(*speeds, ratio), roller_speed(*speeds, ratio, size), rollers)
