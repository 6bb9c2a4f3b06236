"""One of the two bodies in contact."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property
from numbers import Real
from typing import Final, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.bodies.depths import DEPTHS, DepthRule, depth_of
from nonhertz.bodies.depths.depth import Depth
from nonhertz.bodies.depths.endless import Endless
from nonhertz.bodies.depths.finite import whole
from nonhertz.bodies.images import FEWEST_IMAGES, check_images
from nonhertz.bodies.sides import FaceRule, side_faces
from nonhertz.bodies.sides.side_face import SideFace
from nonhertz.errors import InputError, shown
from nonhertz.inputs.checks import LEAST, finite, numbers, positive
from nonhertz.model.corner import Chamfer, Cornered, Rounded
from nonhertz.model.material import STEEL, Material
from nonhertz.model.profile import Profile, Straight
from nonhertz.model.profile.base import moved_back, places

Array = NDArray[np.float64]
#: Which of the two bodies of a contact.
BodyName = Literal["a", "b"]
BODIES: Final[tuple[BodyName, BodyName]] = ("a", "b")

Diameter = float | Callable[[Array], ArrayLike] | None

_LENGTH_REMEDY = "give the distance between the side faces in mm, or leave it out for an unbounded body"
_FACELESS_REMEDY = "give the distance between the side faces in mm, or leave out side_faces"
# What a body may say that has no side faces: the default of today, and of the paper.
_OF_NO_FACE: Final = ("free", "mirror")
_DIAMETER_REMEDY = "give the diameter in mm, negative for a concave surface, or leave it out for a flat one"


@dataclass(frozen=True)
class TabulatedDiameter:
    """A diameter that changes along the axis, linear between points.

    Parameters
    ----------
    y : tuple of float
        Axial positions [mm] from the middle of the body, ascending, at least two.
    diameter : tuple of float
        Diameter there [mm], all of one sign, negative = concave; 0 only in a bore, where there is none.

    Examples
    --------
    >>> tapered = TabulatedDiameter(y=(-10.0, 10.0), diameter=(18.0, 20.0))
    >>> float(tapered(0.0))
    19.0
    """

    y: tuple[float, ...]
    diameter: tuple[float, ...]

    def __post_init__(self) -> None:
        for name in ("y", "diameter"):
            row = numbers(name, getattr(self, name), "give a list of numbers in mm")
            if row.ndim != 1:
                raise InputError(name, getattr(self, name), "be a row of numbers", "give a list of numbers in mm")
            object.__setattr__(self, name, tuple(row.tolist()))
        if len(self.y) != len(self.diameter) or len(self.y) < 2:
            raise InputError("y", self.y, "hold as many points as diameter, at least two", "give both lists")
        if not np.all(np.diff(self.y) > 0.0):
            raise InputError("y", self.y, "be finite and ascending", "sort the points along the axis")
        low, high = min(self.diameter), max(self.diameter)
        if low * high < 0.0 or low == high == 0.0:
            raise InputError("diameter", self.diameter, "be finite and of one sign", _DIAMETER_REMEDY)

    def __call__(self, y: ArrayLike) -> Array:
        """Return the diameter [mm] at ``y`` [mm]; constant beyond the outermost points."""
        diameter: Array = np.interp(numbers("y", y, "give positions in mm"), self.y, self.diameter)
        return diameter


def convex(diameter: Diameter) -> bool:
    """Return whether a diameter is positive, as far as is known before the place of contact is."""
    if isinstance(diameter, TabulatedDiameter):
        return max(diameter.diameter) > 0.0
    return callable(diameter) or (isinstance(diameter, Real) and diameter > 0.0)


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
    bore : float or TabulatedDiameter or None
        Diameter of the bore of a hollow roller [mm], which may vary along the axis, even in steps: a recess in an end
        is a bore that closes (diameter 0) within a short length; None for a solid one. It needs
        ``depth`` = ``"finite"``.
    length : float or None
        Distance between the side faces [mm]; None for an unbounded body.
    profile : Profile
        Relief along the axis, positive where material is removed.
    effective_length : float or None
        Length in the middle of the body that can touch [mm], where chamfers or undercuts remove the rest;
        at most ``length``; None for all of it. Not together with a corner.
    corner_radius : float or None
        Radius of the corners between surface and side faces [mm]. The length includes them; the profile ends where they
        begin, and they go on with its slope. None for sharp ends, or a ``chamfer``.
    chamfer : Chamfer or None
        What takes the corners away instead of a radius.
    position : float
        Axial position y of the middle of the body [mm].
    side_faces : str or float or pair of them
        How the side faces are freed of stress: exactly (``"free"``, the default), by images of the pressure with weight
        1 (``"mirror"``), with the weight that comes closest to the exact free face (``"calibrated"``) or with a weight
        given as a number, or not at all (``"none"``). A pair is for the faces at low and high y. A body without a
        length has none.
    images : int or str
        Mirror images per face: 1; or n, with the n - 1 shifted images that mirrors of mirrors make between them; or
        ``"series"`` for all of them, which needs a depth, without which their sum diverges.
    depth : str or float or None
        The point that the displacement is measured against: far away (``"none"``), where it makes the compression
        of a long cylinder that of plane strain (``"plane-strain"``), a diameter below the
        surface (``"diameter"``), at a given depth [mm], such as the thickness of a ring; or the axis of a solid
        cylinder of infinite length (``"cylinder"``), or of a roller that deforms as a whole (``"finite"``), whose side
        faces are ``"free"``. None for what suits the body: ``"none"``, and of a roller the last of these.
    case_depth : float or None
        Depth below the surface [mm] to which the body is case-hardened or surface-hardened, such as the case-hardening
        depth CHD of ISO 18203 (to 550 HV); None for one that is alike throughout. It changes no solution; see
        `nonhertz.strength.assess`.

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
    diameter: Diameter = None
    bore: float | TabulatedDiameter | None = None
    length: float | None = None
    profile: Profile = field(default_factory=Straight)
    effective_length: float | None = None
    corner_radius: float | None = None
    chamfer: Chamfer | None = None
    position: float = 0.0
    side_faces: FaceRule | tuple[FaceRule, FaceRule] = "free"
    images: int | Literal["series"] = FEWEST_IMAGES
    depth: DepthRule | None = None
    case_depth: float | None = None

    def __post_init__(self) -> None:
        if not isinstance(self.material, Material):
            raise InputError("material", self.material, "be a Material", "use nonhertz.Material(modulus, poisson)")
        if not isinstance(self.profile, Profile):
            raise InputError("profile", self.profile, "be a Profile", "make one with nonhertz.profile")
        if self.diameter is not None and not callable(self.diameter):
            finite("diameter", self.diameter, _DIAMETER_REMEDY)
            if abs(self.diameter) < LEAST:
                condition = f"be at least {LEAST:g} in magnitude" if self.diameter else "not be zero"
                raise InputError("diameter", self.diameter, condition, _DIAMETER_REMEDY)
        elif isinstance(self.diameter, TabulatedDiameter) and 0.0 in self.diameter.diameter:
            raise InputError("diameter", self.diameter.diameter, "not be zero", _DIAMETER_REMEDY)
        if self.bore is not None:
            self._check_bore(self.bore)
        if self.length is not None:
            positive("length", self.length, _LENGTH_REMEDY)
        if self.effective_length is not None:
            self._check_effective_length(self.effective_length)
        self._check_corner()
        if self.case_depth is not None:
            positive("case_depth", self.case_depth, "give the depth of the case in mm, or leave it out")
        finite("position", self.position, "give the axial position of the body's middle in mm")
        if isinstance(self.side_faces, list) or (isinstance(self.side_faces, np.ndarray) and self.side_faces.ndim):
            object.__setattr__(self, "side_faces", tuple(self.side_faces))
        asked = [side.image_weight(self.material.poisson) for side in self.sides]
        if self.length is None and self.side_faces not in _OF_NO_FACE and max(asked) > 0.0:
            raise InputError("length", None, f"be given where side_faces = {shown(self.side_faces)}", _FACELESS_REMEDY)
        check_images(self.images, self.face_weights, isinstance(self.behind, Endless))
        self.behind.refuse(self)

    def _check_bore(self, bore: float | TabulatedDiameter) -> None:
        remedy = "give the diameter of the bore in mm, or leave it out for a solid body"
        if not isinstance(bore, TabulatedDiameter):
            positive("bore", bore, remedy)
        elif min(bore.diameter) < 0.0:
            raise InputError("bore", bore.diameter, "be positive", remedy)
        if not self.behind.bored:
            words = " or ".join(repr(depth.word) for depth in DEPTHS.values() if depth.bored)
            condition = f"only be given where depth = {words}"
            raise InputError("bore", bore, condition, f"write depth = {words}, or leave out the bore")

    def _check_effective_length(self, effective_length: float) -> None:
        remedy = "give the length that can touch in mm, or leave it out for all of the body"
        positive("effective_length", effective_length, remedy)
        if self.length is not None and effective_length > self.length:
            raise InputError(
                "effective_length", effective_length, f"not exceed the length of {shown(self.length)} mm", remedy
            )

    def _check_corner(self) -> None:
        for name, remedy in (("chamfer", "make one with nonhertz.Chamfer"), ("corner_radius", "give it in mm")):
            if getattr(self, name) is None:
                continue
            for other in ("effective_length", "chamfer"):
                if name != other and getattr(self, other) is not None:
                    raise InputError(name, getattr(self, name), f"not be given together with {other}", "leave one out")
            if self.length is None:
                raise InputError(
                    "length", None, f"be given where {name} is", "give the distance between the faces in mm"
                )
            if self.profile.joints is not None:
                low, high = self.profile.joints
                condition = (
                    f"not be given with a profile that holds the corners, beyond y = {low:.5g} and {high:.5g} mm"
                )
                raise InputError(name, getattr(self, name), condition, "leave it out, or give the trace corner = 'cut'")
            if name == "chamfer" and not isinstance(self.chamfer, Chamfer):
                raise InputError(name, self.chamfer, "be a Chamfer", remedy)
        _ = self.surface

    @cached_property
    def surface(self) -> Profile:
        """The profile with the corners."""
        corner = self.chamfer if self.corner_radius is None else Rounded(self.corner_radius)
        if corner is None or self.length is None:
            return self.profile
        return Cornered(self.profile, 0.5 * self.length, corner)

    @property
    def interval(self) -> tuple[float, float]:
        """The axial interval [mm] on which the body can touch; infinite for an unbounded body."""
        length = self.effective_length if self.effective_length is not None else self.length
        low, high = (-np.inf, np.inf) if length is None else (-0.5 * length, 0.5 * length)
        defined = self.surface.extent
        return (self.position + max(low, defined[0]), self.position + min(high, defined[1]))

    @property
    def land(self) -> tuple[float, float]:
        """The part of ``interval`` [mm] between the corners or chamfers."""
        (low, high), joints = self.interval, self.surface.joints
        return (
            (low, high)
            if joints is None
            else (max(low, self.position + joints[0]), min(high, self.position + joints[1]))
        )

    @property
    def faces(self) -> tuple[float, float]:
        """Axial positions [mm] of the side faces, free or not; infinite for an unbounded body."""
        half = np.inf if self.length is None else 0.5 * self.length
        return (self.position - half, self.position + half)

    @property
    def sides(self) -> tuple[SideFace, SideFace]:
        """How the side faces at low and high y are treated, if there are any."""
        return side_faces(self.side_faces)

    @property
    def behind(self) -> Depth:
        """What displacement is measured against."""
        return depth_of(self._usual_depth if self.depth is None else self.depth, convex(self.diameter))

    @property
    def _usual_depth(self) -> DepthRule:
        """The depth of a body without one."""
        return "none"

    @property
    def model(self) -> str:
        """How its side faces and its depth are treated, in the words of a case file.

        Examples
        --------
        >>> Body(diameter=20.0, length=20.0, side_faces=("free", 1.2)).model
        'ends free and 1.2, depth none'
        """
        depth = f"depth {self.behind.shown}"
        if self.length is None:
            return depth
        faces = self.side_faces if isinstance(self.side_faces, tuple) else (self.side_faces,)
        return f"ends {' and '.join(str(face) for face in faces)}, {depth}"

    @property
    def face_weights(self) -> tuple[float, float]:
        """Weights of the images about the side faces; zero where a face is not freed or does not exist."""
        if self.length is None:
            return 0.0, 0.0
        low, high = (side.image_weight(self.material.poisson) for side in self.sides)
        return low, high

    @property
    def free_faces(self) -> tuple[bool, bool]:
        """Whether the side faces at low and high y are free of normal stress, too."""
        low, high = (self.length is not None and side.exact for side in self.sides)
        return low, high

    @property
    def corner_angles(self) -> tuple[float, float]:
        """Angles between surface and side faces at low and high y, within the body [rad]."""
        return self.behind.corner_angles(self)

    @property
    def bends(self) -> tuple[float, ...]:
        """Axial positions [mm] where the relief bends."""
        return tuple(self.position + bend for bend in self.surface.bends)

    @property
    def crests(self) -> tuple[float, ...]:
        """Axial positions [mm] at which the relief may stand out between sampled places."""
        return tuple(self.position + crest for crest in self.surface.crests)

    def relief(self, y: ArrayLike) -> Array:
        """Return the relief [mm] at the positions ``y`` [mm]."""
        return self.relief_at(places(y))

    def relief_at(self, y: Array) -> Array:
        """Return the relief at positions that are known to be finite numbers."""
        return self.surface.relief_at(moved_back(y, self.position, self.surface.extent))

    def curvature(self, y: ArrayLike) -> Array:
        """Return the curvature 1/R [1/mm] across the contact at ``y`` [mm], negative where concave.

        Raises
        ------
        InputError
            If a diameter that varies along y is zero or not finite somewhere.
        """
        return self.curvature_at(places(y))

    def curvature_at(self, y: Array) -> Array:
        """Return the curvature at positions that are known to be finite numbers."""
        if self.diameter is None:
            return np.zeros_like(y)
        if not callable(self.diameter):
            return np.full_like(y, 2.0 / self.diameter)
        diameter = np.asarray(self.diameter(y - self.position), dtype=float)
        if diameter.shape != y.shape or not np.all(np.isfinite(diameter)) or np.any(np.abs(diameter) < LEAST):
            raise InputError(
                "diameter", self.diameter, "return a finite diameter other than zero for every y", _DIAMETER_REMEDY
            )
        return 2.0 / diameter


@dataclass(frozen=True, kw_only=True)
class Roller(Body):
    """A convex body of finite length: `Body` with a positive ``diameter`` and a ``length``.

    By default both its side faces are free and it deforms as a whole. Where that is not to be had, its side faces not
    being free or its length over 10 diameters, its depth is that of a long cylinder in plane strain.

    Examples
    --------
    >>> Roller(diameter=20, length=20).interval
    (-10.0, 10.0)
    """

    def __post_init__(self) -> None:
        # Checked first, because the default depth needs a diameter too.
        if self.diameter is None or not convex(self.diameter):
            raise InputError("diameter", self.diameter, "be positive", "give the roller's diameter in mm")
        if self.length is None:
            raise InputError("length", self.length, "be given", "give the roller's length in mm")
        super().__post_init__()

    @cached_property
    def _usual_depth(self) -> DepthRule:
        """The roller itself; in plane strain where it cannot be whole."""
        return "finite" if whole(self) else "plane-strain"


@dataclass(frozen=True, kw_only=True)
class Ring(Body):
    """A raceway: `Body` with a ``diameter``, positive on an inner ring, negative (concave) on an outer ring.

    With a ``length``, its width, it has two free side faces; without one it is unbounded.

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
            raise InputError(
                "diameter", self.diameter, "be left out", "make a curved one a roller or a ring, or leave its kind open"
            )
