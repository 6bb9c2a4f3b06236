"""Profile tables of a case file: from ``{ kind = "crown", radius = 4000.0 }`` to a `Profile`.

The parameters of a kind come from its function in the catalogue, so that a kind added there works in files at once.
"""

from __future__ import annotations

import inspect
import math
import re
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Annotated, Any, ClassVar, Final

from nonhertz.amounts import mm
from nonhertz.errors import InputError, InputsError
from nonhertz.files.bounds import PROFILES
from nonhertz.files.measured import KIND, MeasuredProfile
from nonhertz.files.mistakes import missing_key_error, place_of
from nonhertz.files.reading import INVALID, ReadContext, TableReader
from nonhertz.inputs.checks import text
from nonhertz.inputs.descriptions import Description, Flag, Quantity, Word, collect_errors, unknown_word_error
from nonhertz.inputs.fields import Input, cross_check, input_class
from nonhertz.model.diameter import TabulatedDiameter
from nonhertz.model.profile import CATALOGUE, PARAMETERS, Profile, ProfileKind, from_file, with_drop
from nonhertz.model.profile.base import at_ends
from nonhertz.model.profile.drop import AT_REMEDY, off_the_middle, parameter_from_drop, scaled_to_drop
from nonhertz.model.profile.table import Interpolation

_LIST_REMEDY = "write a list of tables such as [{ kind = 'crown', radius = 4000.0 }]"
_FEWER_REMEDY = "add them up in one of kind 'tabulated'"
_UPLOAD_REMEDY = "give y and relief, or upload the measured profile"
_TABULATED: Final = "tabulated"


@input_class(kw_only=True)
class Moves(Input):
    """Changes of a whole profile of any kind."""

    shift: Annotated[float | None, Quantity("mm", "how far to move the profile towards positive y")] = None
    scale: Annotated[float | None, Quantity("", "factor on the relief")] = None
    flip: Annotated[bool, Flag("whether to mirror the profile about the middle of the body, after its shift")] = False

    def of(self, profile: Profile) -> Profile:
        """Return a profile that is scaled, then shifted, then flipped."""
        return profile.moved(scale=1.0 if self.scale is None else self.scale, shift=self.shift or 0.0, flip=self.flip)


@input_class(kw_only=True)
class Changes(Moves):
    """Keys of the table of a kind of the catalogue in addition to its parameters."""

    drop: Annotated[
        float | None,
        Quantity(
            "mm",
            "relief at a position less that in the middle of the body; replaces the parameter that it determines, or "
            "the scale",
        ),
    ] = None
    at: Annotated[
        float | None,
        Quantity(
            "mm",
            "position of the drop, from the middle of the body; the end of the land if left out",
            off_the_middle,
            AT_REMEDY,
        ),
    ] = None
    apart: ClassVar[tuple[tuple[str, ...], ...]] = (("scale", "drop"),)

    @cross_check("drop", "at")
    def _check_place(self) -> None:
        if self.at is not None and self.drop is None:
            raise InputError("at", self.at, "not be given without drop", "give both or neither")


@input_class(kw_only=True)
class PointsFile(ProfileKind):
    """A profile through points in a file."""

    file: Annotated[
        str,
        Word(
            "text file of two columns, y and relief [mm], instead of the lists; its path is relative to the case file",
            "name it in quotes",
            condition=text,
        ),
    ]
    interpolation: Annotated[Interpolation, PARAMETERS[_TABULATED].descriptions["interpolation"]] = "pchip"

    instead: ClassVar[Mapping[str, str]] = {"y": "file", "relief": "file"}

    def profile(self, folder: Path) -> Profile:
        """Return the profile in the file; its name is relative to a folder."""
        return from_file(folder / self.file, self.interpolation)


def _add_changes(cls: type[ProfileKind]) -> type[ProfileKind]:
    """Return the class of the table of a kind: its parameters, and the keys that all kinds have."""
    around = Moves if cls is MeasuredProfile else Changes
    made: type[ProfileKind] = input_class(kw_only=True)(type(cls.__name__, (around, cls), {"__doc__": cls.__doc__}))
    made.cross_checks = cls.cross_checks + around.cross_checks
    return made


#: The classes of the tables of each kind.
KINDS: Final = {word: _add_changes(cls) for word, cls in {**PARAMETERS, KIND: MeasuredProfile}.items()}
_OF_FILE: Final = _add_changes(PointsFile)


def read_profile(value: Any, body: Mapping[str, Any], file: ReadContext) -> Profile:
    """Return the sum of the profiles in a list of tables, or the profile of one table.

    Parameters
    ----------
    value : object
        Value in the case file.
    body : mapping
        The keys of the body that have been read so far; an invalid one is absent.
    file : ReadContext
        Directory to which file names are relative, and the combined radius.

    Raises
    ------
    InputError
        All mistakes, with fields relative to ``value``.
    """
    sizes = _dimensions(body, file.radius)
    if isinstance(value, dict):
        return _read_table(value, sizes, file)
    if not isinstance(value, list):
        raise InputError("", value, "be a list of tables", _LIST_REMEDY)
    if len(value) > PROFILES:
        raise InputError("", value, f"have at most {PROFILES} profiles", _FEWER_REMEDY)
    return sum(collect_errors("", value, lambda _, table: _read_table(table, sizes, file)), CATALOGUE["straight"]())


def profile_tables(body: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Return the profiles of a body's table as a list, even if the file has none or a single table."""
    value = body.get("profile", [])
    return [value] if isinstance(value, dict) else list(value)


def keys_of(kind: str) -> dict[str, Description]:
    """Return the keys that a table of a kind may have, except its kind."""
    file = {"file": PointsFile.descriptions["file"]} if kind == _TABULATED else {}
    return {**KINDS[kind].descriptions, **file}


def needed_keys(kind: str) -> list[str]:
    """Return the keys that a table of a kind must have, unless a drop replaces one of them."""
    cls = KINDS[kind]
    return [
        name for name in cls.descriptions if name in cls.without_default - cls.of_body.keys() and kind != _TABULATED
    ]


def meaning_of(kind: str) -> str:
    """Return the meaning of a kind of profile, from the docstring of its function."""
    return re.sub(
        r"^(Return )?(the|an?) ", "", (inspect.getdoc(KINDS[kind]) or "").partition("\n")[0], flags=re.IGNORECASE
    )


def _dimensions(body: Mapping[str, Any], radius: Any) -> dict[str, Any]:
    """Return the dimensions of a body that its profiles may need: each a number, None where it has none, or `INVALID`.

    Parameters
    ----------
    body : mapping
        The keys of the body that have been read so far; an invalid one is absent.
    radius : object
        Combined radius of both bodies across the contact [mm], None or `INVALID`.

    Returns
    -------
    dict
        ``length`` and ``diameter`` of the body, the length of its ``land`` between corners or within its effective
        length, the combined ``radius``, and ``at``, the end of its land, all in mm.
    """
    length, diameter = body.get("length", INVALID), body.get("diameter", INVALID)
    across = _diameter_normal_to_cone(diameter, length) if isinstance(diameter, TabulatedDiameter) else diameter
    at = _land_end(body)
    land = 2.0 * at if isinstance(at, float) else at
    return {"length": length, "land": land, "diameter": across, "radius": radius, "at": at}


def _diameter_normal_to_cone(diameter: TabulatedDiameter, length: Any) -> float:
    """Return the diameter [mm] in the middle of a body, normal to the axis of its cone.

    A table holds twice the radius of curvature in the plane normal to the line of contact, which is the diameter
    normal to the axis over the cosine of the angle between axis and surface. Half its slope is the tangent.
    """
    half = 0.5 * length if isinstance(length, float) else math.inf
    low, high = max(-half, diameter.y[0]), min(half, diameter.y[-1])
    ends = diameter([low, high])
    tangent = float(ends[1] - ends[0]) / (2.0 * (high - low)) if high > low else 0.0
    return float(diameter(0.0)) / math.hypot(1.0, tangent)


def _land_end(body: Mapping[str, Any]) -> Any:
    """Return the position [mm] at which the corners of a body begin or, without any, its effective length ends."""
    names = ("length", "effective_length", "corner_radius", "chamfer")
    length, effective, corner, chamfer = (body.get(name, INVALID) for name in names)
    if any(size is INVALID for size in (length, effective, corner, chamfer)):
        return INVALID
    whole = length if effective is None else effective
    if whole is None:
        return None
    taken = corner or (0.0 if chamfer is None else chamfer.length)
    # Corners that leave no land are a mistake in the body.
    return 0.5 * whole - taken if 0.5 * whole > taken else INVALID


def _read_table(table: Any, body: Mapping[str, Any], file: ReadContext) -> Profile:
    if not isinstance(table, dict):
        raise InputError("", table, "be a table", _LIST_REMEDY)
    if "kind" not in table:
        raise missing_key_error("kind", "name the profile, such as kind = 'crown'")
    kind = table["kind"]
    if not isinstance(kind, str) or kind not in KINDS:
        raise unknown_word_error("kind", kind, "profile", KINDS)
    return _ProfileReader(kind, table, body, file).build_profile()


class _ProfileReader(TableReader):
    """A table that is being read; some parameters may come from the body, and one from a drop."""

    cls: type[ProfileKind]

    def __init__(self, kind: str, table: Mapping[str, Any], body: Mapping[str, Any], file: ReadContext) -> None:
        cls = _OF_FILE if kind == _TABULATED and "file" in table else KINDS[kind]
        known = tuple(name for name in cls.instead if name not in cls.descriptions)
        super().__init__(cls, {name: table[name] for name in table if name != "kind"}, file, (), known=known)
        self.by_drop = "drop" in self.table and "drop" in self.fields
        # A drop at the end of the land is finite, so that its logarithm must end farther out.
        self.kind, self.body = kind, {**body, "land": body["length"]} if self.by_drop else body
        #: The parameter that a drop determines.
        self.free = (
            parameter_from_drop(kind, {*self.table, *self.wrong}) if self.by_drop or "drop" in self.wrong else None
        )

    @property
    def own(self) -> dict[str, Any]:
        """The valid parameters of the kind."""
        return {name: value for name, value in self.values.items() if name not in Changes.descriptions}

    def build_profile(self) -> Profile:
        """Return the profile, or raise `InputsError`."""
        self.read_fields()
        self.run_cross_checks(self.cls)
        at = self._place_of_drop() if self.by_drop else None
        points = self._catch_mistake(self._read_points) if "file" in self.values else None
        wrong = self.wrong | {place_of(mistake.field)[0] for mistake in self.mistakes}
        blocked = wrong - {self.free, *Moves.descriptions} or at is INVALID
        profile = None if blocked else self._catch_mistake(lambda: self._make_profile(points, at))
        if profile is None or self.mistakes:
            raise InputsError(self.mistakes)
        return Moves(**{name: self.values[name] for name in Moves.descriptions if name in self.values}).of(profile)

    def read_fields(self) -> None:
        """Read every parameter that is given, and take the others from the body."""
        super().read_fields()
        straight, length = self.values.get("straight", 0.0), self.values.get("length")
        # The curved part of a logarithmic profile is the body's land less the straight middle.
        if "length" not in self.table and length is not None and 0.0 <= straight < length:
            self.values["length"] = length - straight

    def note_missing(self, name: str) -> None:
        """Take a parameter from the body if that has it."""
        # Fujiwara and Kawase need a radius only if the relief at the end is not given.
        needed = name in self.cls.of_body and not (name == "radius" and (self.free == "zm" or "zm" in self.table))
        own = self.body.get(self.cls.of_body[name]) if needed else None
        if name == self.free or own is INVALID:
            self.wrong.add(name)
        elif own is None:
            super().note_missing(name)
        else:
            try:
                self.values[name] = self.cls.descriptions[name].validate(name, own)
            except InputError as error:
                self.note(error)

    def hint(self, name: str) -> str:
        """Return the remedy for a missing parameter."""
        if self.kind == _TABULATED:
            return "give the lists y and relief, or a file"
        has = "both bodies together have" if name == "radius" else "the body has"
        remedy = str(getattr(self.cls.descriptions[name], "remedy", ""))
        return remedy + (f", unless {has} one" if name in self.cls.of_body else "")

    def _catch_mistake(self, make: Callable[[], Profile | None]) -> Profile | None:
        """Return the result of ``make``, or note the mistake and return None."""
        try:
            return make()
        except InputError as error:
            self.note(error)
        return None

    def _make_profile(self, points: Profile | None, at: Any) -> Profile:
        if at is None:
            return points or CATALOGUE[self.kind](**self.own)
        drop = self.values["drop"]
        if points is not None:
            return scaled_to_drop(points, self.kind, drop, at)
        return with_drop(self.kind, drop, at, **self.own)

    def _read_points(self) -> Profile | None:
        name, measured = self.values["file"], self.kind == KIND
        if self.file.folder is None:
            raise InputError("file", name, "not be read here", _UPLOAD_REMEDY)
        if measured and any(place_of(mistake.field)[0] not in Moves.descriptions for mistake in self.mistakes):
            return None
        try:
            return {KIND: MeasuredProfile}.get(self.kind, PointsFile)(**self.own).profile(self.file.folder)
        except InputError as error:
            if error.field in self.fields:
                raise
            if error.field == "path" or measured:
                raise error.about("file", name) from None
            raise error.about(f"file, {error.field}", error.value) from None
        except ValueError:  # not a valid file name, such as one with a null character
            raise InputError("file", name, "be the name of a file", "correct it") from None

    def _place_of_drop(self) -> Any:
        """Return the position of the drop [mm]; `INVALID` if it is unknown."""
        if self.free is None:
            condition = f"not be given together with {' and '.join(self.cls.by_drop)}"
            self.note(InputError("drop", self.table["drop"], condition, "leave one out"))
        length, at = self.body.get("length"), self.values.get("at", self.body.get("at"))
        if "at" in self.wrong:
            return INVALID
        if at is None:
            remedy = "give the position of the drop in mm, because the body has no length"
            self.mistakes.append(missing_key_error("at", remedy))
            return INVALID
        if isinstance(length, float) and isinstance(at, float):
            half = 0.5 * length
            at = float(at_ends(at, (-half, half)))
            if abs(at) > half:
                condition = f"lie on the body, which ends {mm(half):g} from its middle"
                self.note(InputError("at", at, condition, AT_REMEDY))
        return at
