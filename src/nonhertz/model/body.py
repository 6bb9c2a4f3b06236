"""One of the two bodies in contact."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.errors import InputError
from nonhertz.model.checks import finite, one_of, positive
from nonhertz.model.material import STEEL, Material
from nonhertz.model.profile import Profile, Straight

Array = NDArray[np.float64]

_LENGTH_REMEDY = "give the distance between the side faces in mm, or leave it out for an unbounded body"
_DIAMETER_REMEDY = "give the diameter in mm, negative for a concave surface, or leave it out for a flat one"


@dataclass(frozen=True)
class TabulatedDiameter:
    """A diameter that changes along the axis, linear between points.

    Parameters
    ----------
    y : tuple of float
        Axial positions [mm] from the middle of the body, ascending, at least two.
    diameter : tuple of float
        Diameter there [mm], of one sign, negative = concave.

    Examples
    --------
    >>> tapered = TabulatedDiameter(y=(-10.0, 10.0), diameter=(18.0, 20.0))
    >>> float(tapered(0.0))
    19.0
    """

    y: tuple[float, ...]
    diameter: tuple[float, ...]

    def __post_init__(self) -> None:
        object.__setattr__(self, "y", tuple(float(v) for v in self.y))
        object.__setattr__(self, "diameter", tuple(float(v) for v in self.diameter))
        if len(self.y) != len(self.diameter) or len(self.y) < 2:
            raise InputError("y", self.y, "hold as many points as diameter, two at least", "give both lists")
        if not np.all(np.isfinite(self.y)) or not np.all(np.diff(self.y) > 0.0):
            raise InputError("y", self.y, "be finite and ascend", "sort the points along the axis")
        signs = np.sign(self.diameter)
        if not np.all(np.isfinite(self.diameter)) or signs[0] == 0.0 or np.any(signs != signs[0]):
            raise InputError("diameter", self.diameter, "be finite and of one sign", _DIAMETER_REMEDY)

    def __call__(self, y: ArrayLike) -> Array:
        """Return the diameter [mm] at ``y`` [mm]; constant beyond the outer points."""
        diameter: Array = np.interp(np.asarray(y, dtype=np.float64), self.y, self.diameter)
        return diameter


@dataclass(frozen=True, kw_only=True)
class Body:
    """A body with, in every plane of constant y, a constant radius of curvature across the contact.

    Parameters
    ----------
    material : Material
        Elastic constants; steel if left out.
    diameter : float or callable or None
        Diameter across the contact [mm]: positive convex, negative concave, None flat. A callable takes
        positions y [mm] from the middle of the body and returns diameters [mm]; see `TabulatedDiameter`.
    length : float or None
        Distance between the side faces [mm]; None for an unbounded body.
    profile : Profile
        Relief along the axis, positive where material is taken away.
    effective_length : float or None
        Length in the middle of the body that can touch [mm], where chamfers or undercuts take the rest away;
        at most ``length``; None for all of it.
    position : float
        Axial position y of the middle of the body [mm].
    side_faces, depth : str
        Corrections for finite length and thickness. Only ``"none"`` so far: both bodies answer as half-spaces.

    Raises
    ------
    InputError
        If a value is out of range.

    Examples
    --------
    >>> Body(diameter=20.0, length=20.0).interval
    (-10.0, 10.0)
    """

    material: Material = STEEL
    diameter: float | Callable[[Array], ArrayLike] | None = None
    length: float | None = None
    profile: Profile = field(default_factory=Straight)
    effective_length: float | None = None
    position: float = 0.0
    side_faces: str = "none"
    depth: str = "none"

    def __post_init__(self) -> None:
        if not isinstance(self.material, Material):
            raise InputError("material", self.material, "be a Material", "use nonhertz.Material(modulus, poisson)")
        if not isinstance(self.profile, Profile):
            raise InputError("profile", self.profile, "be a Profile", "make one with nonhertz.profile")
        if self.diameter is not None and not callable(self.diameter):
            finite("diameter", self.diameter, _DIAMETER_REMEDY)
            if self.diameter == 0.0:
                raise InputError("diameter", self.diameter, "not be zero", _DIAMETER_REMEDY)
        if self.length is not None:
            positive("length", self.length, _LENGTH_REMEDY)
        if self.effective_length is not None:
            self._check_effective_length(self.effective_length)
        finite("position", self.position, "give the axial position of the body's middle in mm")
        remedy = "leave it out or write 'none'; other choices are not available in this version"
        one_of("side_faces", self.side_faces, ("none",), remedy)
        one_of("depth", self.depth, ("none",), remedy)

    def _check_effective_length(self, effective_length: float) -> None:
        remedy = "give the length that can touch in mm, or leave it out for all of the body"
        positive("effective_length", effective_length, remedy)
        if self.length is not None and effective_length > self.length:
            raise InputError("effective_length", effective_length, f"not exceed the length of {self.length} mm", remedy)

    @property
    def interval(self) -> tuple[float, float]:
        """The axial interval [mm] on which the body can touch; infinite for an unbounded body."""
        length = self.effective_length if self.effective_length is not None else self.length
        low, high = (-np.inf, np.inf) if length is None else (-0.5 * length, 0.5 * length)
        defined = self.profile.extent
        return (self.position + max(low, defined[0]), self.position + min(high, defined[1]))

    @property
    def bends(self) -> tuple[float, ...]:
        """Axial positions [mm] where the relief bends."""
        return tuple(self.position + bend for bend in self.profile.bends)

    def relief(self, y: ArrayLike) -> Array:
        """Return the relief [mm] at the positions ``y`` [mm]."""
        return self.profile.relief(np.asarray(y, dtype=float) - self.position)

    def curvature(self, y: ArrayLike) -> Array:
        """Return the curvature 1/R [1/mm] across the contact at ``y`` [mm], negative where concave.

        Raises
        ------
        InputError
            If a diameter that varies along y is zero or not finite somewhere.
        """
        y = np.asarray(y, dtype=float)
        if self.diameter is None:
            return np.zeros_like(y)
        if not callable(self.diameter):
            return np.full_like(y, 2.0 / self.diameter)
        diameter = np.asarray(self.diameter(y - self.position), dtype=float)
        if diameter.shape != y.shape or not np.all(np.isfinite(diameter)) or np.any(diameter == 0.0):
            raise InputError(
                "diameter", self.diameter, "return a finite diameter other than zero for every y", _DIAMETER_REMEDY
            )
        return 2.0 / diameter


@dataclass(frozen=True, kw_only=True)
class Roller(Body):
    """A convex body of finite length: `Body` with a positive ``diameter`` and a ``length``.

    Examples
    --------
    >>> Roller(diameter=20, length=20).interval
    (-10.0, 10.0)
    """

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.diameter is None or (not callable(self.diameter) and self.diameter <= 0.0):
            raise InputError("diameter", self.diameter, "be positive", "give the roller's diameter in mm")
        if self.length is None:
            raise InputError("length", self.length, "be given", "give the roller's length in mm")


@dataclass(frozen=True, kw_only=True)
class Ring(Body):
    """A raceway: `Body` with a ``diameter``, positive on an inner ring, negative (concave) on an outer ring.

    Examples
    --------
    >>> float(Ring(diameter=-120).curvature(0.0)) < 0
    True
    """

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.diameter is None:
            raise InputError(
                "diameter", self.diameter, "be given", "give the raceway's diameter in mm, negative for an outer ring"
            )


@dataclass(frozen=True, kw_only=True)
class Plate(Body):
    """A flat body: `Body` without a ``diameter``.

    Examples
    --------
    >>> float(Plate().curvature(0.0))
    0.0
    """

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.diameter is not None:
            raise InputError("diameter", self.diameter, "be left out", "use Roller, Ring or Body for a curved one")
