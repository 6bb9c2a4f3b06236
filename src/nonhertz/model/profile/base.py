"""Profiles: relief along the axis, with sum, shift, scale and flip."""

from __future__ import annotations

import copy
from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.inputs.checks import finite, numbers
from nonhertz.inputs.fields import call_repr

Array = NDArray[np.float64]


def places(y: ArrayLike) -> Array:
    """Return axial positions [mm] as an array; refuse anything but finite numbers."""
    return numbers("y", y, "give positions along the axis in mm")


SAME_PLACE = 1e-9
"""Fraction of a body's length: positions closer to its end than this count as at the end."""


def at_ends(y: ArrayLike, ends: tuple[float, float]) -> Array:
    """Return positions along the axis [mm], those within rounding of an end of a body moved to that end.

    Positions written as decimals, or computed from others, differ from the computed ends by rounding.

    Parameters
    ----------
    y : array_like
        Positions [mm].
    ends : tuple of float
        Ends of the body, or of the overlap of two bodies [mm], ascending; infinite ones leave positions unchanged.
    """
    places, (low, high) = np.asarray(y, dtype=float), ends
    room = SAME_PLACE * (high - low)
    if not np.isfinite(room):
        return places
    return np.where(np.abs(places - low) <= room, low, np.where(np.abs(places - high) <= room, high, places))


class Profile(ABC):
    """Relief along the axis of a body; `nonhertz.profile` has the catalogue."""

    # Kind and parameters in the catalogue; None if not from it. Not a field, so that equal reliefs compare equal.
    _called: tuple[str, dict[str, Any]] | None = None
    _call = ""  # as a user would type it

    def with_entry(self, kind: str, parameters: object) -> Profile:
        """Return this profile with the kind and parameters, if not None, that describe it in a case file."""
        named = copy.copy(self)
        described = {name: value for name, value in vars(parameters).items() if value is not None}
        object.__setattr__(named, "_called", (kind, described))
        object.__setattr__(named, "_call", repr(parameters))
        return named

    @property
    def catalogue_entry(self) -> tuple[str, dict[str, Any]] | None:
        """Kind and parameters of a profile of the catalogue; None for any other."""
        return self._called

    @abstractmethod
    def relief(self, y: ArrayLike) -> Array:
        """Return the relief [mm] at the axial positions ``y`` [mm], an array of the same shape."""

    def relief_at(self, y: Array) -> Array:
        """Return the relief [mm] at positions known to be finite numbers; the solver calls this repeatedly."""
        return self.relief(y)

    @property
    def bends(self) -> tuple[float, ...]:
        """Axial positions [mm] where slope or curvature of the relief jumps."""
        return ()

    @property
    def crests(self) -> tuple[float, ...]:
        """Axial positions [mm] at which the relief may have a peak between sampled positions."""
        return self.bends

    @property
    def extent(self) -> tuple[float, float]:
        """The interval [mm] on which the relief is defined; infinite for most kinds."""
        return (-np.inf, np.inf)

    @property
    def joints(self) -> tuple[float, float] | None:
        """Positions [mm] where corners or chamfers contained in the profile begin at either end; None without them."""
        return None

    def shifted(self, by: float) -> Profile:
        """Return this profile moved by ``by`` [mm] towards positive y."""
        finite("by", by, "give the shift in mm")
        return self.moved(shift=float(by))

    def scaled(self, by: float) -> Profile:
        """Return this profile with its relief multiplied by ``by``; infinite relief stays infinite."""
        finite("by", by, "give a factor")
        return self.moved(scale=float(by))

    def flipped(self) -> Profile:
        """Return this profile mirrored about y = 0."""
        return self.moved(flip=True)

    def moved(self, *, scale: float = 1.0, shift: float = 0.0, flip: bool = False) -> Profile:
        """Return this profile with its relief multiplied, then shifted [mm], then flipped."""
        return Transformed(self, scale, shift, flip) if (scale, shift, flip) != (1.0, 0.0, False) else self

    def __add__(self, other: Profile) -> Profile:
        if not isinstance(other, Profile):
            return NotImplemented
        parts = (*_parts(self), *_parts(other))
        return parts[0] if len(parts) == 1 else Sum(parts)


def _parts(profile: Profile) -> tuple[Profile, ...]:
    if isinstance(profile, Sum):
        return profile.parts
    return () if isinstance(profile, Straight) else (profile,)


class Formula(Profile):
    """A profile of this package; it computes its relief at positions that have been checked once."""

    def __init_subclass__(cls) -> None:
        if "__repr__" not in vars(cls):
            cls.__repr__ = cls._show  # type: ignore[assignment, method-assign]  # not the dataclass's own
        # A class that defines one of the two gets the other from it: from its own, not from that of a derived class,
        # so that either may call its base class.
        if "relief" in vars(cls) and "relief_at" not in vars(cls):
            cls.relief_at = cls.relief  # type: ignore[method-assign]
        elif "relief_at" in vars(cls) and "relief" not in vars(cls):
            cls.relief = lambda self, y: cls.relief_at(self, places(y))  # type: ignore[method-assign]

    def _show(self) -> str:
        """Return the call that makes this profile."""
        return self._call or call_repr(self)

    def relief(self, y: ArrayLike) -> Array:
        """Return the relief [mm] at the axial positions ``y`` [mm], an array of the same shape."""
        return self.relief_at(places(y))

    @abstractmethod
    def relief_at(self, y: Array) -> Array:
        """Return the relief at positions that are known to be finite numbers."""


@dataclass(frozen=True)
class Straight(Formula):
    """No relief."""

    def relief_at(self, y: Array) -> Array:
        """Return zeros."""
        return np.zeros_like(y)


@dataclass(frozen=True)
class Sum(Formula):
    """Several profiles on top of one another."""

    parts: tuple[Profile, ...]

    def _show(self) -> str:
        return self._call or " + ".join(map(repr, self.parts))

    def relief_at(self, y: Array) -> Array:
        """Return the sum of the parts' reliefs."""
        total = np.zeros_like(y)
        for part in self.parts:
            total += part.relief_at(y)
        return total

    @property
    def crests(self) -> tuple[float, ...]:
        """The crests of all parts."""
        return tuple(sorted({crest for part in self.parts for crest in part.crests}))

    @property
    def bends(self) -> tuple[float, ...]:
        """The bends of all parts."""
        return tuple(sorted({bend for part in self.parts for bend in part.bends}))

    @property
    def extent(self) -> tuple[float, float]:
        """The interval on which every part is defined."""
        extents = [part.extent for part in self.parts]
        return (max((e[0] for e in extents), default=-np.inf), min((e[1] for e in extents), default=np.inf))

    @property
    def joints(self) -> tuple[float, float] | None:
        """Joints of the first part that contains corners."""
        return next((part.joints for part in self.parts if part.joints is not None), None)


@dataclass(frozen=True)
class Transformed(Formula):
    """A profile with its relief multiplied, then shifted along the axis, then flipped.

    Where the relief is infinite there is no body, whatever the factor.
    """

    profile: Profile
    scale: float
    shift: float
    flip: bool

    def _show(self) -> str:
        if self._call:
            return self._call
        text = f"({self.profile!r})" if isinstance(self.profile, Sum) else repr(self.profile)
        text += f".scaled({self.scale:.15g})" if self.scale != 1.0 else ""
        return text + (f".shifted({self.shift:.15g})" if self.shift else "") + ".flipped()" * self.flip

    def moved(self, *, scale: float = 1.0, shift: float = 0.0, flip: bool = False) -> Profile:
        """Return this profile multiplied, shifted and flipped again; without a name, all are merged into one."""
        if self.catalogue_entry is not None:
            return super().moved(scale=scale, shift=shift, flip=flip)
        # A flipped profile is shifted the other way.
        way = -1.0 if self.flip else 1.0
        return self.profile.moved(scale=scale * self.scale, shift=self.shift + way * shift, flip=self.flip != flip)

    def relief_at(self, y: Array) -> Array:
        """Return the factor times the relief of the profile at the positions moved back."""
        relief = self.profile.relief_at(moved_back(-y if self.flip else y, self.shift, self.profile.extent))
        if self.scale == 1.0:
            return relief
        # A plain product would turn "no body here" into NaN (factor 0) or an infinite peak (factor < 0).
        present = np.isfinite(relief)
        return np.where(present, self.scale * np.where(present, relief, 0.0), np.inf)

    @property
    def crests(self) -> tuple[float, ...]:
        """The profile's crests, moved."""
        return self._move_positions(self.profile.crests)

    @property
    def bends(self) -> tuple[float, ...]:
        """The profile's bends, moved."""
        return self._move_positions(self.profile.bends)

    @property
    def extent(self) -> tuple[float, float]:
        """The profile's extent, moved."""
        low, high = self._move_positions(self.profile.extent)
        return low, high

    @property
    def joints(self) -> tuple[float, float] | None:
        """The profile's joints, moved."""
        if self.profile.joints is None:
            return None
        low, high = self._move_positions(self.profile.joints)
        return low, high

    def _move_positions(self, positions: tuple[float, ...]) -> tuple[float, ...]:
        """Return the moved positions along the axis [mm], ascending."""
        moved = [position + self.shift for position in positions]
        return tuple(-position for position in reversed(moved)) if self.flip else tuple(moved)


def moved_back(y: Array, by: float, extent: tuple[float, float]) -> Array:
    """Return positions [mm] moved back ``by``; the ends of a moved ``extent`` return exactly to its ends.

    With a plain difference an end could fall outside the body by rounding.
    """
    return y if by == 0.0 else at_ends(y - by, extent)
