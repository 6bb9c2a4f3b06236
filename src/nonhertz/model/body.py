"""One of the two bodies in contact."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import field
from functools import cached_property
from typing import Annotated, Any, ClassVar, Final, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.amounts import mm
from nonhertz.errors import InputError, shown
from nonhertz.inputs.assumed import Assumed
from nonhertz.inputs.checks import LEAST, finite, not_negative, positive
from nonhertz.inputs.descriptions import Count, OneOrTwo, Part, Quantity
from nonhertz.inputs.fields import Input, cross_check, input_class
from nonhertz.model.corner import Chamfer, Cornered, Rounded
from nonhertz.model.depths import DEPTH_REMEDY, DEPTHS, THICKNESS, Depth, DepthRule, depth_of
from nonhertz.model.diameter import (
    DIAMETER_REMEDY,
    Diameter,
    TabulatedDiameter,
    check_bore,
    check_diameter,
    convex,
)
from nonhertz.model.material import STEEL
from nonhertz.model.materials import NamedMaterial
from nonhertz.model.outline import Outline, can_be_whole, outline_of
from nonhertz.model.profile import Profile, Straight
from nonhertz.model.profile.base import moved_back, places
from nonhertz.model.side_faces import (
    FACE_REMEDY,
    FEWEST_IMAGES,
    IMAGES_REMEDY,
    MOST_IMAGES,
    SERIES,
    SIDE_FACES,
    WEIGHT,
    FaceRule,
    SideFace,
    side_faces,
)

Array = NDArray[np.float64]
#: Names of the two bodies of a contact.
BodyName = Literal["a", "b"]
BODIES: Final[tuple[BodyName, BodyName]] = ("a", "b")

_TOUCHING_REMEDY = "give the length that can touch in mm, or leave it out for the whole body"
_DEPTH_MEANING = (
    "reference point of the elastic displacement; by default 'finite' for a roller with free side faces, "
    f"'plane-strain' for other rollers and 'none' for other bodies; as a number, {THICKNESS}"
)
_LENGTH_REMEDY = "give the distance between the side faces in mm, or leave it out for an unbounded body"
_FACELESS_REMEDY = "give the distance between the side faces in mm, or leave out side_faces"
# Values allowed for a body without side faces: today's default and that of the paper.
_OF_NO_FACE: Final = ("free", "mirror")


@input_class(kw_only=True)
class Body(Input):
    """A body with, in every plane of constant y, a constant radius of curvature across the contact.

    A ``diameter`` may also be a function that takes positions y [mm] from the middle of the body and returns diameters
    [mm]. A recess in an end is a bore that closes (diameter 0) within a short length.

    Raises
    ------
    InputError
        If a value is out of range or values are inconsistent.

    Examples
    --------
    >>> Body(diameter=20.0, length=20.0).interval
    (-10.0, 10.0)
    """

    meaning_of_kind: ClassVar[str] = (
        "'roller', 'ring' or 'plate': the sign of the diameter, and the default of the depth; 'body' for any; left "
        "out, a body with a positive diameter and a length is a roller"
    )
    apart: ClassVar[tuple[tuple[str, ...], ...]] = (("corner_radius", "chamfer", "effective_length"),)

    material: Annotated[NamedMaterial, Assumed("steel of no grade", "pressures and displacements")] = STEEL
    diameter: Annotated[
        Diameter,
        Quantity(
            "mm",
            "diameter across the contact, negative where concave, or a table of y and diameter; a flat body has none",
            check_diameter,
            DIAMETER_REMEDY,
        ),
    ] = None
    bore: Annotated[
        float | TabulatedDiameter | None,
        Quantity(
            "mm",
            "diameter of the bore of a hollow roller, or a table of y and diameter; a solid one has none",
            check_bore,
            "give the diameter of the bore in mm, or leave it out for a solid body",
        ),
    ] = None
    length: Annotated[
        float | None,
        Quantity("mm", "distance between the side faces; an unbounded body has none", positive, _LENGTH_REMEDY),
        Assumed("no side faces", "the approach", lambda body: body.behind.shown == "none"),
    ] = None
    profile: Annotated[
        Profile,
        Part("relief along the axis; profiles in a list add up", Profile, "make one with nonhertz.profile"),
    ] = field(default_factory=Straight)
    effective_length: Annotated[
        float | None,
        Quantity(
            "mm",
            "length in the middle that can touch; the rest is taken up by chamfers or undercuts",
            positive,
            _TOUCHING_REMEDY,
        ),
    ] = None
    corner_radius: Annotated[
        float | None,
        Quantity(
            "mm",
            "radius of the corners between surface and side faces, which the length includes; the profile ends where "
            "they begin",
            positive,
            "give the radius in mm, or leave it out for a sharp end",
        ),
    ] = None
    chamfer: Annotated[
        Chamfer | None, Part("chamfers in place of a corner radius", Chamfer, "make one with nonhertz.Chamfer")
    ] = None
    position: Annotated[
        float,
        Quantity(
            "mm",
            "axial position of the middle of the body",
            finite,
            "give the axial position of the body's middle in mm",
        ),
    ] = 0.0
    side_faces: Annotated[
        FaceRule | tuple[FaceRule, FaceRule],
        OneOrTwo(
            Quantity("", WEIGHT, not_negative, FACE_REMEDY, SIDE_FACES),
            "how the side faces are made free, or two of these, for low and high y",
            ("at low y", "at high y"),
        ),
    ] = "free"
    images: Annotated[
        int | Literal["series"],
        Count(
            "number of mirror images per side face",
            FEWEST_IMAGES,
            MOST_IMAGES,
            IMAGES_REMEDY,
            {SERIES: "all of them, which needs a depth"},
        ),
    ] = FEWEST_IMAGES
    depth: Annotated[
        DepthRule | None,
        Quantity(
            "mm",
            _DEPTH_MEANING,
            positive,
            DEPTH_REMEDY,
            DEPTHS,
        ),
        Assumed("half-space", "displacements", lambda body: body.behind.shown == "none"),
    ] = None
    case_depth: Annotated[
        float | None,
        Quantity(
            "mm",
            "depth to which the body is case-hardened or surface-hardened, such as the case-hardening depth CHD of ISO "
            "18203 (to 550 HV), below which the core's strength counts; it changes no solution",
            positive,
            "give the depth of the case in mm, or leave it out",
        ),
    ] = None

    roughness: Annotated[
        float | None,
        Quantity(
            "mm",
            "root mean square roughness Rq of its surface, by which films of oil in bearings are judged; it changes no "
            "solution",
            positive,
            "give Rq in mm, 0.0001 is 0.1 um",
        ),
    ] = None

    @cross_check("length", "effective_length")
    def _check_effective_length(self) -> None:
        if self.length is not None and self.effective_length is not None and self.effective_length > self.length:
            condition = f"not exceed the length of {mm(self.length):g}"
            raise InputError("effective_length", self.effective_length, condition, _TOUCHING_REMEDY)

    @cross_check("length", "corner_radius", "chamfer", "profile")
    def _check_corner(self) -> None:
        for name in ("chamfer", "corner_radius"):
            if getattr(self, name) is None:
                continue
            if self.length is None:
                remedy = "give the distance between the faces in mm"
                raise InputError("length", None, f"be given where {name} is", remedy)
            if self.profile.joints is not None:
                ends = mm(*self.profile.joints, between=" and ")
                condition = f"not be given with a profile that holds the corners, beyond y = {ends:.5g}"
                raise InputError(name, getattr(self, name), condition, "leave it out, or give the trace corner = 'cut'")
        _ = self.surface

    @cross_check("length", "side_faces", "material")
    def _check_faces(self) -> None:
        weights = [side.image_weight(self.material.poisson) for side in self.sides]
        if self.length is None and self.side_faces not in _OF_NO_FACE and max(weights) > 0.0:
            raise InputError("length", None, f"be given where side_faces = {shown(self.side_faces)}", _FACELESS_REMEDY)

    @cross_check("diameter", "length", "side_faces", "images", "material", "depth", "bore")
    def _check_depth(self) -> None:
        if self.bore is not None and not self.behind.whole:
            words = " or ".join(repr(depth.word) for depth in DEPTHS.values() if depth.whole)
            condition = f"only be given where depth = {words}"
            raise InputError("bore", self.bore, condition, f"write depth = {words}, or leave out the bore")
        if self.images == SERIES and self.behind.word == "none" and math.prod(self.face_weights) > 0.0:
            condition = "only be used for a body with a depth: without one the sum of its images does not converge"
            raise InputError("images", self.images, condition, "give the body a depth, or a number of images")
        self.behind.refuse(self)

    @classmethod
    def likely(cls, values: Mapping[str, Any]) -> type[Body]:
        """Return the class of a body without a kind: a roller if it is convex and has a length, else this one."""
        is_roller = cls is Body and values.get("length") is not None and convex(values.get("diameter"))
        return Roller if is_roller else cls

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

    def __getstate__(self) -> dict[str, Any]:
        # Values derived from the fields are computed again.
        return {name: getattr(self, name) for name in self.descriptions}

    @cached_property
    def sides(self) -> tuple[SideFace, SideFace]:
        """Treatment of the side faces at low and high y, if there are any."""
        return side_faces(self.side_faces)

    @cached_property
    def behind(self) -> Depth:
        """Reference point of the displacement."""
        return depth_of(self._usual_depth if self.depth is None else self.depth, convex(self.diameter))

    @property
    def _usual_depth(self) -> DepthRule:
        """The depth of a body without one."""
        return "none"

    @property
    def model(self) -> str:
        """Treatment of side faces and depth, in the words of a case file.

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

    @cached_property
    def face_weights(self) -> tuple[float, float]:
        """Weights of the images about the side faces; zero where a face is not freed or does not exist."""
        if self.length is None:
            return 0.0, 0.0
        low, high = (side.image_weight(self.material.poisson) for side in self.sides)
        return low, high

    @cached_property
    def free_faces(self) -> tuple[bool, bool]:
        """Whether the side faces at low and high y are also free of normal stress."""
        low, high = (self.length is not None and side.exact for side in self.sides)
        return low, high

    @cached_property
    def outline(self) -> tuple[Outline, float]:
        """The outline of a roller, and the radius of its surface in the middle [mm], which is its unit."""
        return outline_of(self)

    @cached_property
    def corner_angles(self) -> tuple[float, float]:
        """Angles between surface and side faces at low and high y, within the body [rad].

        Right angles, except for a whole roller with a surface inclined to its axis, whose side faces are square to the
        axis.
        """
        if self.behind.whole and callable(self.diameter):
            return self.outline[0].corner_angles
        return 0.5 * math.pi, 0.5 * math.pi

    @property
    def bends(self) -> tuple[float, ...]:
        """Axial positions [mm] where the relief bends."""
        return tuple(self.position + bend for bend in self.surface.bends)

    @property
    def crests(self) -> tuple[float, ...]:
        """Axial positions [mm] at which the relief may have a peak between sampled positions."""
        return tuple(self.position + crest for crest in self.surface.crests)

    def relief(self, y: ArrayLike) -> Array:
        """Return the relief [mm] at the positions ``y`` [mm], an array of the same shape."""
        return self.relief_at(places(y))

    def relief_at(self, y: Array) -> Array:
        """Return the relief at positions that are known to be finite numbers."""
        return self.surface.relief_at(moved_back(y, self.position, self.surface.extent))

    def curvature(self, y: ArrayLike) -> Array:
        """Return the curvature 1/R [1/mm] across the contact at ``y`` [mm], an array of its shape; negative if concave.

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
                "diameter", self.diameter, "return a finite diameter other than zero for every y", DIAMETER_REMEDY
            )
        return 2.0 / diameter


@input_class(kw_only=True)
class Roller(Body):
    """A convex body of finite length: `Body` with a positive ``diameter`` and a ``length``.

    By default both side faces are free and it deforms as a whole. If its side faces are not free, or its length exceeds
    10 diameters, its depth is that of a long cylinder in plane strain.

    Examples
    --------
    >>> Roller(diameter=20, length=20).interval
    (-10.0, 10.0)
    """

    @cross_check("diameter")
    def _check_convex(self) -> None:
        if self.diameter is None or not convex(self.diameter):
            raise InputError("diameter", self.diameter, "be positive", "give the roller's diameter in mm")

    @cross_check("length")
    def _check_bounded(self) -> None:
        if self.length is None:
            raise InputError("length", self.length, "be given", "give the roller's length in mm")

    @cached_property
    def _usual_depth(self) -> DepthRule:
        """The whole roller; plane strain where it cannot deform as a whole."""
        return "finite" if can_be_whole(self) else "plane-strain"


@input_class(kw_only=True)
class Ring(Body):
    """A raceway: `Body` with a ``diameter``, positive on an inner ring, negative (concave) on an outer ring.

    With a ``length``, its width, it has two free side faces; without one it is unbounded.

    Examples
    --------
    >>> float(Ring(diameter=-120).curvature(0.0)) < 0
    True
    """

    @cross_check("diameter")
    def _check_curved(self) -> None:
        if self.diameter is None:
            remedy = "give the raceway's diameter in mm, negative for an outer ring"
            raise InputError("diameter", self.diameter, "be given", remedy)


@input_class(kw_only=True)
class Plate(Body):
    """A flat body: `Body` without a ``diameter``.

    Examples
    --------
    >>> float(Plate().curvature(0.0))
    0.0
    """

    @cross_check("diameter")
    def _check_flat(self) -> None:
        if self.diameter is not None:
            remedy = "make a curved one a roller or a ring, or leave its kind open"
            raise InputError("diameter", self.diameter, "be left out", remedy)


Body.kinds = {"roller": Roller, "ring": Ring, "plate": Plate, "body": Body}
