"""Profile tables of a case file: from ``{ kind = "crown", radius = 4000.0 }`` to a `Profile`.

The functions of the catalogue say which parameters a kind takes; none of that is repeated here, so that a kind added to
the catalogue works in files at once.
"""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Annotated, Any, ClassVar, Final

from nonhertz.amounts import mm
from nonhertz.errors import InputError
from nonhertz.files.bounds import PROFILES
from nonhertz.files.dimensions import BROKEN
from nonhertz.files.measured import KIND, MeasuredProfile
from nonhertz.files.mistakes import InFile, Mistake, TableError, missing, one_by_one
from nonhertz.files.reading import Reading, Surroundings
from nonhertz.inputs.checks import text
from nonhertz.inputs.fields import Flag, Input, Quantity, Word, described, together, unknown
from nonhertz.model.profile import CATALOGUE, PARAMETERS, Profile, ProfileKind, from_file, with_drop
from nonhertz.model.profile.drop import AT_REMEDY, determined, off_the_middle, scaled_to_drop
from nonhertz.model.profile.table import Interpolation

_LIST_REMEDY = "write a list of tables such as [{ kind = 'crown', radius = 4000.0 }]"
_FEWER_REMEDY = "add them up in one of kind 'tabulated'"
_UPLOAD_REMEDY = "give y and relief, or upload the measured profile"
_TABULATED = PARAMETERS["tabulated"]
#: What the tables of each kind hold.
KINDS: Final[dict[str, type[ProfileKind]]] = {**PARAMETERS, KIND: MeasuredProfile}


@described(kw_only=True)
class Moves(Input):
    """How a profile is changed as a whole, whatever its kind."""

    shift: Annotated[float | None, Quantity("mm", "how far to move the profile towards positive y")] = None
    scale: Annotated[float | None, Quantity("", "factor on the relief")] = None
    flip: Annotated[bool, Flag("whether to mirror the profile about the middle of the body, after its shift")] = False

    def of(self, profile: Profile) -> Profile:
        """Return a profile that is scaled, then shifted, then flipped."""
        profile = profile if self.scale is None else profile.scaled(self.scale)
        profile = profile if self.shift is None else profile.shifted(self.shift)
        return profile.flipped() if self.flip else profile


@described(kw_only=True)
class Changes(Moves):
    """What the table of a kind of the catalogue may have beside its parameters."""

    drop: Annotated[
        float | None,
        Quantity(
            "mm",
            "how much more relief there is at a place than in the middle of the body, in place of the parameter that "
            "this determines, or of the scale",
        ),
    ] = None
    at: Annotated[
        float | None,
        Quantity(
            "mm",
            "the place of the drop, from the middle of the body; the end of the land if left out",
            off_the_middle,
            AT_REMEDY,
        ),
    ] = None
    instead: ClassVar[Mapping[str, str]] = {"scale": "drop"}

    @together("drop", "at")
    def _check_place(self) -> None:
        if self.at is not None and self.drop is None:
            raise InputError("at", self.at, "not be given without drop", "give both or neither")


@described(kw_only=True)
class PointsFile(ProfileKind):
    """A profile through points in a file."""

    file: Annotated[
        str,
        Word(
            "text file of two columns, y and relief [mm], in place of the lists; its path is relative to the case file",
            "name it in quotes",
            condition=text,
        ),
    ]
    interpolation: Annotated[Interpolation, _TABULATED.descriptions["interpolation"]] = "pchip"

    instead: ClassVar[Mapping[str, str]] = {"y": "file", "relief": "file"}

    def profile(self, folder: Path) -> Profile:
        """Return the profile in the file, whose name is relative to a folder."""
        return from_file(folder / self.file, self.interpolation)


def read_profile(value: Any, body: Mapping[str, Any], folder: Path | None) -> Profile:
    """Return the sum of the profiles in a list of tables, or the profile of one table.

    Parameters
    ----------
    value : object
        What the case file holds.
    body : mapping
        Its `nonhertz.files.dimensions.dimensions`.
    folder : Path or None
        Directory that file names are relative to; None where no file may be read.

    Raises
    ------
    TableError
        All mistakes, with places relative to ``value``.
    """
    if isinstance(value, dict):
        return _read_table(value, body, folder)
    if not isinstance(value, list):
        raise InputError("profile", value, "be a list of tables", _LIST_REMEDY)
    if len(value) > PROFILES:
        raise InputError("profile", value, f"have at most {PROFILES} profiles", _FEWER_REMEDY)
    return sum(one_by_one(value, lambda _, table: _read_table(table, body, folder)), CATALOGUE["straight"]())


def profile_tables(body: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Return the profiles of a body's table as a list, even where the file gives none or a single table."""
    value = body.get("profile", [])
    return [value] if isinstance(value, dict) else list(value)


def keys_of(kind: str) -> dict[str, type[Input]]:
    """Return the keys that a table of a kind may have beside that, each with the class that describes it."""
    cls = KINDS[kind]
    keys: dict[str, type[Input]] = {name: each for each in (cls, _around(cls)) for name in each.descriptions}
    return keys | ({"file": PointsFile} if cls is _TABULATED else {})


def needed_keys(kind: str) -> list[str]:
    """Return those of them that a table must have, if it gives no drop in place of one of them."""
    cls = KINDS[kind]
    return [name for name in cls.descriptions if name in cls.required - {*cls.of_body} and cls is not _TABULATED]


def meaning_of(kind: str) -> str:
    """Return what a kind of profile is, as its function says it."""
    return re.sub(
        r"^(Return )?(the|an?) ", "", (inspect.getdoc(KINDS[kind]) or "").partition("\n")[0], flags=re.IGNORECASE
    )


def _around(cls: type[ProfileKind]) -> type[Moves]:
    return Moves if cls is MeasuredProfile else Changes


def _read_table(table: Any, body: Mapping[str, Any], folder: Path | None) -> Profile:
    if not isinstance(table, dict):
        raise TableError([Mistake((), InputError("", table, "be a table", _LIST_REMEDY))])
    if "kind" not in table:
        raise TableError([missing(("kind",), "name the profile, such as kind = 'crown'")])
    kind = table["kind"]
    if not isinstance(kind, str) or kind not in KINDS:
        raise TableError([Mistake(("kind",), unknown("kind", kind, "profile", kind, KINDS))])
    return _Table(kind, table, body, Surroundings(folder)).profile()


class _Table:
    """A table that is being read: the parameters of its kind beside what every kind may have."""

    def __init__(self, kind: str, table: Mapping[str, Any], body: Mapping[str, Any], file: Surroundings) -> None:
        self.kind, self.body, self.folder = kind, body, file.folder
        cls = PointsFile if kind == _TABULATED.__name__ and "file" in table else KINDS[kind]
        self.around = _around(cls)
        changes = {name: value for name, value in table.items() if name in self.around.descriptions}
        self.changes = Reading(self.around, changes, file, ())
        own = {name: value for name, value in table.items() if name not in changes and name != "kind"}
        self.own = _Parameters(cls, own, file, tuple(self.around.descriptions), body)
        if "drop" in changes or "drop" in self.own.wrong:
            self.own.free = determined(kind, {*own, *self.own.wrong})

    def profile(self) -> Profile:
        """Return the profile, or raise `TableError`."""
        changes, own = self.changes, self.own
        for reading in (changes, own):
            reading.take_fields()
            reading.check_together(reading.cls)
        at = self._place() if "drop" in changes.table else None
        points = self._noting(self._points) if "file" in own.values else None
        blocked = own.mistakes or own.wrong - {own.free} or {"drop", "at"} & changes.wrong or at is BROKEN
        profile = None if blocked else self._noting(lambda: self._made(points, at))
        if profile is None or changes.mistakes:
            raise TableError(changes.mistakes + own.mistakes)
        return self.around(**changes.values).of(profile)

    def _noting(self, make: Callable[[], Profile | None]) -> Profile | None:
        """Return what is made, or note the mistake and return None."""
        try:
            return make()
        except TableError as error:
            self.own.mistakes += error.mistakes
        except InputError as error:
            (self.changes if error.field in self.around.descriptions else self.own).note(error)
        return None

    def _made(self, points: Profile | None, at: Any) -> Profile:
        if at is None:
            return points or CATALOGUE[self.kind](**self.own.values)
        drop = self.changes.values["drop"]
        if points is not None:
            return scaled_to_drop(points, self.kind, drop, at)
        return with_drop(self.kind, drop, at, **self.own.values)

    def _points(self) -> Profile | None:
        name, measured = self.own.values["file"], self.own.cls is MeasuredProfile
        if self.folder is None:
            raise InputError("file", name, "not be read here", _UPLOAD_REMEDY)
        if measured and self.own.mistakes:
            return None
        try:
            made = self.own.cls(**self.own.values)
            assert isinstance(made, MeasuredProfile | PointsFile)
            return made.profile(self.folder)
        except InputError as error:
            if error.field in self.own.fields:
                raise
            if error.field == "path" or measured:
                raise InputError("file", name, error.condition, error.remedy) from None
            raise TableError([Mistake(("file", InFile(error.field)), error)]) from None
        except ValueError:  # not a valid file name, such as one with a null character
            raise InputError("file", name, "be the name of a file", "correct it") from None

    def _place(self) -> Any:
        """Return where the drop is [mm]; `BROKEN` if that is not known."""
        changes = self.changes
        if self.own.free is None:
            others = " and ".join(self.own.cls.by_drop)
            condition = f"not be given together with {others}"
            changes.note(InputError("drop", changes.table["drop"], condition, "leave one out"))
        length, at = self.body.get("length"), changes.values.get("at", self.body.get("at"))
        if "at" in changes.wrong:
            return BROKEN
        if at is None:
            remedy = "give the place of the drop in mm, because the body has no length"
            changes.mistakes.append(missing(("at",), remedy))
            return BROKEN
        if isinstance(length, float) and isinstance(at, float) and abs(at) > 0.5 * length:
            condition = f"lie on the body, which ends {mm(0.5 * length):g} from its middle"
            changes.note(InputError("at", at, condition, AT_REMEDY))
        return at


class _Parameters(Reading):
    """The parameters of a kind, of which some are taken from the body and one may be determined by a drop."""

    cls: type[ProfileKind]

    def __init__(
        self,
        cls: type[ProfileKind],
        table: dict[str, Any],
        file: Surroundings,
        around: tuple[str, ...],
        body: Mapping[str, Any],
    ) -> None:
        super().__init__(cls, table, file, (), known=(*around, *cls.instead))
        self.body = body
        #: What a drop determines.
        self.free: str | None = None

    def take_fields(self) -> None:
        """Read every parameter that is given, and take the others from the body."""
        super().take_fields()
        straight, length = self.values.get("straight", 0.0), self.body.get("length")
        # The curved part of a logarithmic profile is the body's length less the straight middle.
        if "length" not in self.table and "length" in self.values and 0.0 <= straight < length:
            self.values["length"] = length - straight

    def absent(self, name: str) -> None:
        """Take a parameter from the body if that has it."""
        # Fujiwara and Kawase need a radius only where the relief at the end is not given.
        needed = name in self.cls.of_body and not (name == "radius" and (self.free == "zm" or "zm" in self.table))
        own = self.body.get(name) if needed else None
        if name == self.free or own is BROKEN:
            self.wrong.add(name)
        elif own is None:
            super().absent(name)
        else:
            try:
                self.values[name] = self.cls.descriptions[name].take(name, own)
            except InputError as error:
                self.note(error)

    def way_out(self, name: str) -> str:
        """Return what to do where a parameter is missing."""
        if self.cls is _TABULATED:
            return "give the lists y and relief, or a file"
        has = "both bodies together have" if name == "radius" else "the body has"
        remedy = str(getattr(self.cls.descriptions[name], "remedy", ""))
        return remedy + (f", unless {has} one" if name in self.cls.of_body else "")
