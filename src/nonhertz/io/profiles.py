"""Profile tables of a case file: from ``{ kind = "crown", radius = 4000.0 }`` to a `Profile`.

The catalogue's functions define which parameters a kind takes, their defaults and their meaning; none of that
is repeated here, so that a profile added to the catalogue works in case files at once.
"""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from typing import Any, Final

from nonhertz.errors import InputError
from nonhertz.inputs.fields import nearest, unknown
from nonhertz.inputs.units import in_unit
from nonhertz.io.bounds import PROFILES
from nonhertz.io.dimensions import BROKEN
from nonhertz.io.measured import KEYS, KIND, measured_schema, read_measured
from nonhertz.io.mistakes import InFile, Mistake, TableError, missing, mistake_in
from nonhertz.model.profile import CATALOGUE, PARAMETER_UNITS, Profile, from_file, with_drop
from nonhertz.model.profile.catalogue import BY_DROP
from nonhertz.model.profile.drop import SCALE, determined, scaled_to_drop

_LIST_REMEDY = "write a list of tables such as [{ kind = 'crown', radius = 4000.0 }]"
# Keys that every table may have in addition to the parameters of its kind.
_FEWER_REMEDY = "add them up in one of kind 'tabulated'"
_UPLOAD_REMEDY = "give y and relief, or upload the measured profile"
_FILE_MEANING = "Text file of two columns, y and relief [mm]; its path is relative to the case file."
# If a table leaves them out, they are taken from the body, or from both; a radius only where it is the one across.
_OF_THE_BODY = {"length": "the body has one", "diameter": "the body has one", "radius": "both bodies together have one"}
#: Keys that every kind of the catalogue may have beside its parameters: unit, None for a switch, and meaning.
COMMON: Final[dict[str, tuple[str | None, str]]] = {
    "drop": (
        "mm",
        "How much more relief there is at a place than in the middle of the body [mm], in place of the parameter that "
        "this determines, or of the scale.",
    ),
    "at": ("mm", "The place of the drop, from the middle of the body [mm]; the end of the land if left out."),
    "shift": ("mm", "How far to move the profile towards positive y [mm]."),
    "scale": ("", "Factor on the relief."),
    "flip": (None, str(KEYS["flip"]["description"])),
}
_BY_DROP_SCHEMA = {"required": ["drop"]}
# Harmless values in place of missing or invalid parameters, to find out whether the others are valid.
_STAND_INS = (0.5, 1e-3, 7.0, 1e4)


def read_profile(value: Any, body: Mapping[str, Any], folder: Path | None) -> Profile:
    """Return the sum of the profiles in a list of tables, or the profile of one table.

    Parameters
    ----------
    value : object
        What the case file holds.
    body : mapping
        Its `nonhertz.io.dimensions.dimensions`.
    folder : Path or None
        Directory that file names are relative to; None where no file may be read.

    Returns
    -------
    Profile
        The sum.

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
    total: Profile = CATALOGUE["straight"]()
    mistakes: list[Mistake] = []
    for position, table in enumerate(value, start=1):
        try:
            total += _read_table(table, body, folder)
        except TableError as found:
            mistakes += (mistake.within((position,)) for mistake in found.mistakes)
    if mistakes:
        raise TableError(mistakes)
    return total


def profile_tables(body: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Return the profiles of a body's table as a list, even where the file gives none or a single table."""
    value = body.get("profile", [])
    return [value] if isinstance(value, dict) else list(value)


def profile_schema() -> dict[str, Any]:
    """Return the JSON schema of what `read_profile` accepts."""
    tables = {"anyOf": [*(_kind_schema(kind) for kind in CATALOGUE), measured_schema()]}
    return {"anyOf": [tables, {"type": "array", "items": tables}]}


def quantity_schema(unit: str) -> dict[str, Any]:
    """Return the JSON schema of a quantity in ``unit``."""
    if not unit:
        return {"type": "number"}
    return {"anyOf": [{"type": "number"}, {"type": "string"}], "unit": unit}


def _read_table(table: Any, body: Mapping[str, Any], folder: Path | None) -> Profile:
    if not isinstance(table, dict):
        raise TableError([Mistake((), InputError("", table, "be a table", _LIST_REMEDY))])
    if "kind" not in table:
        raise TableError([missing(("kind",), "name the profile, such as kind = 'crown'")])
    kind = table["kind"]
    if kind == KIND:
        return read_measured(table, folder)
    if not isinstance(kind, str) or kind not in CATALOGUE:
        raise TableError([Mistake(("kind",), unknown("kind", kind, "profile", kind, (*CATALOGUE, KIND)))])
    return _Reader(kind, table, body, folder).read()


class _Reader:
    """Reads one table, continuing after a mistake as far as possible."""

    def __init__(self, kind: str, table: Mapping[str, Any], body: Mapping[str, Any], folder: Path | None) -> None:
        self.kind = kind
        self.table = {key: value for key, value in table.items() if key != "kind"}
        self.body = body
        self.folder = folder
        self.parameters = inspect.signature(CATALOGUE[kind]).parameters
        self.values: dict[str, Any] = {}
        self.mistaken: set[str] = set()
        self.mistakes: list[Mistake] = []
        self.free: str | None = None  # what the drop determines
        self.stated: tuple[float, float] | None = None  # the drop and its place

    def read(self) -> Profile:
        """Return the profile, or raise `TableError`."""
        self._take_values()
        from_points = self.kind == "tabulated" and "file" in self.table
        if from_points:
            self._refuse_points_beside_file()
        self._take_drop()
        if not from_points:
            self._take_from_body()
        changes = {name: self.values.pop(name) for name in COMMON if name in self.values}
        scale, shift, flip = (
            changes.get(name, other) for name, other in (("scale", 1.0), ("shift", 0.0), ("flip", False))
        )
        profile = self._from_file() if from_points else self._made()
        profile = self._changed(profile, "scale", Profile.scaled, scale)
        profile = self._changed(profile, "shift", Profile.shifted, shift)
        profile = profile.flipped() if flip else profile
        if self.mistakes:
            raise TableError(self.mistakes)
        return profile

    def _changed(self, profile: Profile, name: str, change: Callable[[Profile, Any], Profile], by: Any) -> Profile:
        if name not in self.table:
            return profile
        try:
            return change(profile, by)
        except InputError as error:
            self._note(name, InputError(name, error.value, error.condition, error.remedy))
            return profile

    def _note(self, name: str, error: InputError) -> None:
        self.mistaken.add(name)
        self.values.pop(name, None)
        self.mistakes.append(mistake_in(name, error, self.table.get(name)))

    def _take_values(self) -> None:
        known = _known_keys(self.kind)
        for name, value in self.table.items():
            if name not in known:
                error = unknown(name, value, f"parameter of '{self.kind}'", name, known)
                self.mistakes.append(Mistake((name,), error))
                # Someone who writes "radus" has not forgotten the radius.
                self.mistaken |= {nearest(name, known) or name}
                continue
            try:
                self.values[name] = self._value(name, value)
            except InputError as error:
                self._note(name, error)

    def _value(self, name: str, value: Any) -> Any:
        unit = COMMON[name][0] if name in COMMON else PARAMETER_UNITS.get(name)
        if unit is not None:
            if isinstance(value, list):
                return [in_unit(name, entry, unit) for entry in value]
            return in_unit(name, value, unit)
        if name in COMMON or isinstance(self._default(name), bool):
            if not isinstance(value, bool):
                raise InputError(name, value, "be true or false", "write it without quotes")
        elif not isinstance(value, str):
            raise InputError(name, value, "be text", "put it in quotes")
        return value

    def _default(self, name: str) -> Any:
        return self.parameters[name].default if name in self.parameters else None

    def _refuse_points_beside_file(self) -> None:
        for name in ("y", "relief"):
            if name in self.values:
                self._note(name, InputError(name, self.table[name], "not be given together with file", "keep one"))

    def _take_drop(self) -> None:
        if "drop" not in self.table and "drop" not in self.mistaken:
            if "at" in self.values:
                self._note(
                    "at", InputError("at", self.table["at"], "not be given without drop", "give both or neither")
                )
            return
        self.free = determined(self.kind, {*self.values, *self.mistaken})
        if "drop" not in self.table:  # but a key that looks like it
            return
        at = self._place()
        if self.free is None:
            self._refuse_with("drop", " and ".join(BY_DROP[self.kind]))
        elif "scale" in self.table:
            self._refuse_with("scale", "drop")
        elif "drop" in self.values and at is not BROKEN:
            self.stated = (self.values["drop"], at)

    def _refuse_with(self, name: str, other: str) -> None:
        self._note(name, InputError(name, self.table[name], f"not be given together with {other}", "leave one out"))

    def _place(self) -> Any:
        """Return where the drop is [mm]; `BROKEN` if that is not known."""
        remedy = "give a place in mm from the middle"
        length, at = self.body.get("length"), self.values.get("at", self.body.get("at"))
        if at is BROKEN or "at" in self.mistaken:
            return BROKEN
        if at is None:
            self.mistakes.append(missing(("at",), "give the place of the drop in mm, because the body has no length"))
            return BROKEN
        if not isinstance(at, float):
            self._note("at", InputError("at", at, "be a finite number", remedy))
            return BROKEN
        if isinstance(length, float) and abs(at) > 0.5 * length:
            condition = f"lie on the body, which ends {0.5 * length:g} mm from its middle"
            self._note("at", InputError("at", at, condition, remedy))
            return BROKEN
        return at

    def _take_from_body(self) -> None:
        for name, parameter in self.parameters.items():
            if name in self.values or name in self.mistaken or name == self.free:
                continue
            own = self.body.get(name) if _is_of_the_body(self.kind, name) else None
            if parameter.default is parameter.empty:
                self._take(name, own)
            elif own is not None and self.free != "zm" and "zm" not in self.table:
                # Fujiwara and Kawase need a radius only where the relief at the end is not given.
                self._take(name, own)
                self.mistaken |= {"zm"} if own is BROKEN else set()

    def _take(self, name: str, own: Any) -> None:
        """Take a parameter from the body if that has it."""
        if own is BROKEN:
            self.mistaken.add(name)
        elif isinstance(own, float):
            # The curved part of a logarithmic profile is the body's length less the straight middle.
            straight = self.values.get("straight") if name == "length" else 0.0
            fits = isinstance(straight, float) and 0.0 <= straight < own
            self.values[name] = own - float(straight or 0.0) if fits else own
        else:
            self.mistaken.add(name)
            if self.kind != "tabulated" or name == "y" or "y" in self.table:
                self.mistakes.append(missing((name,), self._way_out(name)))

    def _way_out(self, name: str) -> str:
        if self.kind == "tabulated":
            return "give the lists y and relief, or a file"
        unit = PARAMETER_UNITS.get(name)
        here = f"'{self.kind}' needs it" + (f", in {unit}" if unit else "")
        return f"{here}, unless {_OF_THE_BODY[name]}" if _is_of_the_body(self.kind, name) else here

    def _from_file(self) -> Profile:
        options = {name: self.values[name] for name in ("interpolation",) if name in self.values}
        name = self.values.get("file")
        if name is None:
            return CATALOGUE["straight"]()
        if self.folder is None:
            self._note("file", InputError("file", name, "not be read here", _UPLOAD_REMEDY))
            return CATALOGUE["straight"]()
        try:
            profile = from_file(self.folder / name, **options)
            return profile if self.stated is None else scaled_to_drop(profile, self.kind, *self.stated)
        except InputError as error:
            if error.field == "path":
                self._note("file", InputError("file", name, error.condition, error.remedy))
            elif error.field in (*options, "at"):
                self._note(error.field, error)
            else:
                self.mistakes.append(Mistake(("file", InFile(error.field)), error))
        except ValueError:  # not a valid file name, such as one with a null character
            self._note("file", InputError("file", name, "be the name of a file", "correct it"))
        return CATALOGUE["straight"]()

    def _made(self) -> Profile:
        # Each round finds one more invalid parameter, whose value is not used in the next.
        for _ in range(len(self.parameters) + 3):
            made = self._attempt(self._maker())
            if isinstance(made, Profile):
                return made
            if made is None:
                break
            self._note(made.field, made)
        return CATALOGUE["straight"]()

    def _maker(self) -> Callable[..., Profile]:
        if self.stated is None or self.mistakes or self.mistaken:
            # Any size does for finding out whether the others are valid.
            if self.free is not None and self.free != SCALE:
                self.mistaken.add(self.free)
            return CATALOGUE[self.kind]
        return partial(with_drop, self.kind, *self.stated)

    def _attempt(self, make: Callable[..., Profile]) -> Profile | InputError | None:
        """Return the profile, or an error about a parameter not yet reported; None if neither.

        With invalid parameters replaced by stand-ins, an error counts only if it occurs with every stand-in:
        it is then about a value that the user gave, not about how that value goes with a stand-in.
        """
        open_names = [
            name
            for name, parameter in self.parameters.items()
            if name in self.mistaken and parameter.default is parameter.empty
        ]
        complaints: list[InputError] = []
        for stand_in in _STAND_INS if open_names else (0.0,):
            try:
                return make(**self.values, **dict.fromkeys(open_names, stand_in))
            except InputError as error:
                complaints.append(error)
            except (ArithmeticError, TypeError, ValueError):
                if not open_names:
                    raise
        about = [error for error in complaints if error.field not in self.mistaken]
        return about[0] if about and all(error.field == about[0].field for error in about) else None


def _is_of_the_body(kind: str, name: str) -> bool:
    # The radius of a profile for a design load is the one across the contact.
    across = name == "radius" and "load" in inspect.signature(CATALOGUE[kind]).parameters
    return name in ("length", "diameter") or across


def _known_keys(kind: str) -> tuple[str, ...]:
    parameters = inspect.signature(CATALOGUE[kind]).parameters
    return (*parameters, *COMMON, *(("file",) if kind == "tabulated" else ()))


def _kind_schema(kind: str) -> dict[str, Any]:
    function = CATALOGUE[kind]
    meanings = _meanings(function)
    properties: dict[str, Any] = {"kind": {"const": kind}}
    required = ["kind"]
    for name, parameter in inspect.signature(function).parameters.items():
        properties[name] = _parameter_schema(name, parameter) | {"description": meanings.get(name, "")}
        if parameter.default is parameter.empty and not _is_of_the_body(kind, name) and kind != "tabulated":
            required.append(name)
    for name, (unit, meaning) in COMMON.items():
        properties[name] = ({"type": "boolean"} if unit is None else quantity_schema(unit)) | {"description": meaning}
    if kind == "tabulated":
        properties["file"] = {"type": "string", "description": _FILE_MEANING}
    sized = [name for name in required if name in BY_DROP.get(kind, ())]
    return {
        "type": "object",
        "title": kind,
        "description": re.sub(r"^Return (the|an?) ", "", (inspect.getdoc(function) or "").partition("\n")[0]),
        "properties": properties,
        "required": [name for name in required if name not in sized],
        **({"oneOf": [{"required": sized, "not": _BY_DROP_SCHEMA}, _BY_DROP_SCHEMA]} if sized else {}),
        "additionalProperties": False,
    }


def required_keys(schema: Mapping[str, Any]) -> list[str]:
    """Return the keys that a profile of a schema needs where no drop is given."""
    return [*schema["required"], *(schema["oneOf"][0]["required"] if "oneOf" in schema else ())]


def _parameter_schema(name: str, parameter: inspect.Parameter) -> dict[str, Any]:
    if name not in PARAMETER_UNITS:
        return {"type": "boolean" if isinstance(parameter.default, bool) else "string"}
    schema = quantity_schema(PARAMETER_UNITS[name])
    return {"type": "array", "items": schema} if "Sequence" in str(parameter.annotation) else schema


def _meanings(function: Callable[..., Any]) -> dict[str, str]:
    """Return what a function's docstring says about each parameter."""
    section = re.search(r"^Parameters\n-+\n(.*?)(?:\n\n|\Z)", inspect.getdoc(function) or "", re.DOTALL | re.MULTILINE)
    entries = re.findall(r"^(\w+) : .*\n((?:    .*\n?)+)", section[1] if section else "", re.MULTILINE)
    return {name: " ".join(text.split()) for name, text in entries}
