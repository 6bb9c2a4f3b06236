"""Relief along the axis: how much material is taken away at each y.

A profile is a function of the axial coordinate y [mm], measured from the middle of its body, whose value is
the relief [mm], positive where material is taken away. Profiles are values: they add (``crown(...) +
chamfer(...)``), shift along the axis and scale, and each change makes a new one. Beside its function a profile
knows its *bends*, the places where slope or curvature jump, because the strips must be refined there.

The lower-case functions at the end are the catalogue: what engineers call a profile by, each with its source.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.errors import InputError
from nonhertz.model.checks import finite, not_negative, positive

Array = NDArray[np.float64]


class Profile(ABC):
    """Relief along the axis of a body; see the module's functions for the catalogue."""

    @abstractmethod
    def relief(self, y: ArrayLike) -> Array:
        """Return the relief [mm] at the axial positions ``y`` [mm], an array of the same shape."""

    @property
    def bends(self) -> tuple[float, ...]:
        """Axial positions [mm] where slope or curvature of the relief jump."""
        return ()

    @property
    def extent(self) -> tuple[float, float]:
        """The interval [mm] on which the relief is defined; infinite for most kinds."""
        return (-np.inf, np.inf)

    def shifted(self, by: float) -> Profile:
        """Return this profile moved by ``by`` [mm] towards positive y."""
        finite("by", by, "give the shift in mm")
        return Shifted(self, float(by))

    def scaled(self, by: float) -> Profile:
        """Return this profile with its relief multiplied by ``by``."""
        finite("by", by, "give a factor")
        return Scaled(self, float(by))

    def __add__(self, other: Profile) -> Profile:
        if not isinstance(other, Profile):
            return NotImplemented
        return Sum((*_parts(self), *_parts(other)))


def _parts(profile: Profile) -> tuple[Profile, ...]:
    if isinstance(profile, Sum):
        return profile.parts
    return () if isinstance(profile, Straight) else (profile,)


@dataclass(frozen=True)
class Straight(Profile):
    """No relief."""

    def relief(self, y: ArrayLike) -> Array:
        """Return zeros."""
        return np.zeros_like(np.asarray(y, dtype=float))


@dataclass(frozen=True)
class Sum(Profile):
    """Several profiles on top of one another."""

    parts: tuple[Profile, ...]

    def relief(self, y: ArrayLike) -> Array:
        """Return the sum of the parts' reliefs."""
        y = np.asarray(y, dtype=float)
        total = np.zeros_like(y)
        for part in self.parts:
            total += part.relief(y)
        return total

    @property
    def bends(self) -> tuple[float, ...]:
        """The bends of all parts."""
        return tuple(sorted({bend for part in self.parts for bend in part.bends}))

    @property
    def extent(self) -> tuple[float, float]:
        """The interval on which every part is defined."""
        extents = [part.extent for part in self.parts]
        return (max((e[0] for e in extents), default=-np.inf), min((e[1] for e in extents), default=np.inf))


@dataclass(frozen=True)
class Shifted(Profile):
    """A profile moved along the axis."""

    profile: Profile
    by: float

    def relief(self, y: ArrayLike) -> Array:
        """Return the relief of the profile ``by`` further back."""
        return self.profile.relief(np.asarray(y, dtype=float) - self.by)

    @property
    def bends(self) -> tuple[float, ...]:
        """The profile's bends, moved."""
        return tuple(bend + self.by for bend in self.profile.bends)

    @property
    def extent(self) -> tuple[float, float]:
        """The profile's extent, moved."""
        low, high = self.profile.extent
        return (low + self.by, high + self.by)


@dataclass(frozen=True)
class Scaled(Profile):
    """A profile with its relief multiplied."""

    profile: Profile
    by: float

    def relief(self, y: ArrayLike) -> Array:
        """Return ``by`` times the profile's relief."""
        return self.by * self.profile.relief(y)

    @property
    def bends(self) -> tuple[float, ...]:
        """The profile's bends."""
        return self.profile.bends

    @property
    def extent(self) -> tuple[float, float]:
        """The profile's extent."""
        return self.profile.extent


@dataclass(frozen=True)
class Logarithmic(Profile):
    """Relief ``amplitude * ln(1 / (1 - (2 fraction y' / length)^2))``, y' measured past a straight middle.

    ``y' = max(0, |y| - straight / 2)``; ``length`` is the length of the curved part, both ends together.
    Beyond the place where the argument of the logarithm would reach zero the relief is infinite.
    """

    amplitude: float
    length: float
    fraction: float
    straight: float = 0.0

    def relief(self, y: ArrayLike) -> Array:
        """Return the relief [mm]; infinite at and beyond the pole of the logarithm."""
        past = np.maximum(np.abs(np.asarray(y, dtype=float)) - 0.5 * self.straight, 0.0)
        rest = 1.0 - (2.0 * self.fraction * past / self.length) ** 2
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.where(rest > 0.0, -self.amplitude * np.log(np.where(rest > 0.0, rest, 1.0)), np.inf)

    @property
    def bends(self) -> tuple[float, ...]:
        """Both ends of the straight middle, if there is one."""
        return (-0.5 * self.straight, 0.5 * self.straight) if self.straight > 0.0 else ()


def straight() -> Profile:
    """Return a straight profile: no relief anywhere.

    Examples
    --------
    >>> float(straight().relief(3.0))
    0.0
    """
    return Straight()


def logarithmic(amplitude: float, length: float, fraction: float = 1.0, straight: float = 0.0) -> Profile:
    """Return a general logarithmic profile.

    Relief = ``amplitude * ln(1 / (1 - (2 y fraction / length)^2))``, with y counted from the end of the
    straight middle if there is one.

    Parameters
    ----------
    amplitude : float
        A [mm], not negative.
    length : float
        Length over which the profile is drawn [mm], positive; the straight middle not counted.
    fraction : float
        Share of the half-length at which the end of the roller sits on the curve, in (0, 1]; at 1 the relief
        at the end is infinite, just below 1 it is large but finite.
    straight : float
        Length of a straight middle [mm], not negative.

    Raises
    ------
    InputError
        If a value is out of range.

    References
    ----------
    G. Lundberg, Elastische Beruehrung zweier Halbraeume, Forschung auf dem Gebiete des Ingenieurwesens 10
    (1939) 201-211, doi:10.1007/BF02584950; the general amplitude and length after P. M. Johns and R. Gohar,
    Roller bearings under radial and eccentric loads, Tribology International 14 (1981) 131-136,
    doi:10.1016/0301-679X(81)90086-0.

    Examples
    --------
    >>> profile = logarithmic(amplitude=0.005, length=20, fraction=0.9999)
    >>> round(float(profile.relief(10.0)), 6)
    0.042586
    """
    not_negative("amplitude", amplitude, "give the amplitude of the logarithm in mm")
    positive("length", length, "give the length over which the profile is drawn in mm")
    _fraction("fraction", fraction)
    not_negative("straight", straight, "give the length of the straight middle in mm, 0 for none")
    return Logarithmic(amplitude, length, fraction, straight)


def _fraction(field: str, value: float) -> None:
    finite(field, value, "give a share between 0 and 1")
    if not 0.0 < value <= 1.0:
        raise InputError(field, value, "lie in (0, 1]", "give a share of the half-length")
