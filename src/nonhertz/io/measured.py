"""A measured profile in a case file: ``{ kind = "measured", file = "roller.txt", height_unit = "um" }``.

The file stays as the machine wrote it; the table says, key by key, how to process it, which is done afresh each time.
"""

from __future__ import annotations

import math
import warnings
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from nonhertz.errors import AccuracyWarning, InputError
from nonhertz.inputs.fields import nearest, unknown
from nonhertz.inputs.files import special
from nonhertz.inputs.units import in_unit
from nonhertz.io.mistakes import Mistake, TableError, missing
from nonhertz.io.traces import read_trace
from nonhertz.measured import Measured, Trace, prepare
from nonhertz.model.profile import Profile

#: The kind's name.
KIND = "measured"
#: Keys that describe the columns of the file.
READING = ("position_unit", "height_unit", "position_column", "height_column", "sense")
#: Keys that say how to process the points.
PREPARING = ("level", "align", "trim", "corner", "outliers", "smooth", "cutoff", "slope", "points")

_UPLOAD_REMEDY = "give y and relief, or upload the measured profile"
_TEXT: dict[str, Any] = {"type": "string"}
_NUMBER: dict[str, Any] = {"type": "number"}
_SWITCH: dict[str, Any] = {"type": "boolean"}
_LENGTH: dict[str, Any] = {"anyOf": [_NUMBER, _TEXT], "unit": "mm"}
_COLUMN: dict[str, Any] = {"anyOf": [{"type": "integer", "minimum": 1}, _TEXT]}
_KINDS = {"string": str, "boolean": bool, "number": int | float, "integer": int | float}
_IN_WORDS = {"string": "text", "number": "a number", "boolean": "true or false", "integer": "a whole number"}

#: JSON schema of each key, with what it means.
KEYS: dict[str, dict[str, Any]] = {
    "file": _TEXT | {"description": "The measured file; its path is relative to the case file."},
    "position_unit": _TEXT | {"description": "Unit of the positions; what the file states, or mm, if left out."},
    "height_unit": _TEXT | {"description": "Unit of the heights; what the file states, or mm, if left out."},
    "position_column": _COLUMN | {"description": "Column of the positions, by number from 1 or by name."},
    "height_column": _COLUMN | {"description": "Column of the heights, by number from 1 or by name."},
    "sense": {
        "enum": ["height", "drop"],
        "description": "Whether the column is positive where material is, or where it is taken away.",
    },
    "level": _SWITCH | {"description": "Whether to take off the tilt at which the body lay in the machine."},
    "align": {
        "anyOf": [_SWITCH, {"enum": ["ends", "symmetry"]}],
        "description": "How the middle of the body is found; false leaves y as it is.",
    },
    "trim": {
        "anyOf": [_SWITCH, {"const": "auto"}, _LENGTH],
        "description": "'auto' finds the land and its corners, a length is kept about y = 0, false keeps all.",
    },
    "corner": {
        "enum": ["keep", "cut"],
        "description": "Whether corners that the trace holds are kept, smoothed apart from the land, or cut off.",
    },
    "outliers": {
        "anyOf": [_SWITCH, _NUMBER],
        "description": "Robust standard deviations beyond which points are taken out; true for 5, false for none.",
    },
    "smooth": {
        "anyOf": [_SWITCH, {"enum": ["gaussian", "spline"]}],
        "description": "The filter that takes roughness off, or false.",
    },
    "cutoff": _LENGTH | {"description": "Wavelength of which the filter lets half through."},
    "slope": _NUMBER | {"description": "Slope at which a chamfer begins."},
    "points": {
        "anyOf": [_SWITCH, {"const": "auto"}, {"type": "integer", "minimum": 5}],
        "description": "How many points to keep; 'auto' for eight per cutoff, false for all.",
    },
    "interpolation": {
        "enum": ["pchip", "linear", "cubic"],
        "description": "The curve through the points; 'cubic' for smoothed ones, else 'pchip', if left out.",
    },
    "shift": _LENGTH | {"description": "How far to move the profile towards positive y."},
    "scale": _NUMBER | {"description": "Factor on the relief."},
    "flip": _SWITCH | {"description": "Whether to mirror the profile about the middle of the body, after its shift."},
}
_LENGTHS = {"trim", "cutoff", "shift"}


def read_measured(table: Mapping[str, Any], folder: Path | None) -> Profile:
    """Return the profile of a table of this kind.

    Parameters
    ----------
    table : mapping
        What the case file holds.
    folder : Path or None
        Directory that file names are relative to; None where no file may be read.

    Returns
    -------
    Profile
        The measured profile after all steps.

    Raises
    ------
    TableError
        All mistakes, with places relative to the table.

    Warns
    -----
    AccuracyWarning
        Limitations to know before solving with the profile, such as roughness that strips cannot resolve.
    """
    mistakes: list[Mistake] = []
    values = {}
    for name, value in table.items():
        if name == "kind":
            continue
        try:
            values[name] = checked(name, value)
        except InputError as error:
            mistakes.append(Mistake((name,), error))
    misspelled = {nearest(name, KEYS) for name in table if name not in KEYS and name != "kind"}
    if "file" not in table and "file" not in misspelled:
        mistakes.append(missing(("file",), "name the measured file"))
    elif folder is None and "file" in values:
        refused = InputError("file", values["file"], "not be read here", _UPLOAD_REMEDY)
        mistakes.append(Mistake(("file",), refused))
    if mistakes or folder is None:
        raise TableError(mistakes)
    try:
        return _made(values, folder)
    except InputError as error:
        raise TableError([_placed(error, table)]) from None


def checked(name: str, value: Any) -> Any:
    """Return the value of a key, lengths in mm.

    Raises
    ------
    InputError
        If the key is unknown or its value has the wrong type.
    """
    if name not in KEYS:
        raise unknown(name, value, f"parameter of '{KIND}'", name, KEYS)
    choices = KEYS[name].get("anyOf", [KEYS[name]])
    if isinstance(value, str) and any(value in each.get("enum", [each.get("const")]) for each in choices):
        return value
    if name in _LENGTHS and isinstance(value, str | int | float) and not isinstance(value, bool):
        return in_unit(name, value, "mm")
    taken = [kinds for word, kinds in _KINDS.items() if any(each.get("type") == word for each in choices)]
    if any(isinstance(value, kinds) and isinstance(value, bool) == (kinds is bool) for kinds in taken):
        # An integer too large for a float becomes infinite, which the steps reject.
        number = in_unit(name, value, "mm") if isinstance(value, int) else value
        return number if isinstance(number, float) and math.isinf(number) else value
    meaning = str(KEYS[name]["description"]).rstrip(".")
    raise InputError(name, value, f"be {_expected(choices)}", meaning[0].lower() + meaning[1:])


def measured_from(trace: Trace, values: Mapping[str, Any]) -> Measured:
    """Return a trace processed by the steps that the checked values specify.

    Raises
    ------
    InputError
        If a value is out of range.
    """
    return prepare(trace, **{name: values[name] for name in PREPARING if name in values})


def trace_from(source: Path | bytes, values: Mapping[str, Any], name: str | None = None) -> Trace:
    """Return the trace in a file, with its columns read as the checked values specify.

    Raises
    ------
    InputError
        If it cannot be read.
    """
    return read_trace(source, name, **{key: values[key] for key in READING if key in values})


def measured_schema() -> dict[str, Any]:
    """Return the JSON schema of a table of this kind."""
    return {
        "type": "object",
        "title": KIND,
        "description": "measured profile, prepared step by step",
        "properties": {"kind": {"const": KIND}, **KEYS},
        "required": ["kind", "file"],
        "additionalProperties": False,
    }


def _expected(choices: Sequence[Mapping[str, Any]]) -> str:
    """Return in words which values a key takes."""
    words: list[str] = []
    for choice in choices:
        if "enum" in choice or "const" in choice:
            words += map(repr, choice.get("enum") or [choice["const"]])
        else:
            words.append("a length" if "anyOf" in choice else _IN_WORDS[choice["type"]])
    return ", ".join(words[:-1]) + (" or " if words[1:] else "") + words[-1]


def _made(values: Mapping[str, Any], folder: Path) -> Profile:
    if special(folder / values["file"]):
        raise InputError("file", values["file"], "be a file, not a device or a pipe", "save the measured points in one")
    measured = measured_from(trace_from(folder / values["file"], values), values)
    for sentence in measured.warnings:
        warnings.warn(sentence, AccuracyWarning, stacklevel=2)
    profile = measured.profile(values.get("interpolation"))
    for name, change in (("scale", Profile.scaled), ("shift", Profile.shifted)):
        if name in values:
            try:
                profile = change(profile, values[name])
            except InputError as error:
                raise InputError(name, error.value, error.condition, error.remedy) from None
    return profile.flipped() if values.get("flip") else profile


def _placed(error: InputError, table: Mapping[str, Any]) -> Mistake:
    """Return an error as a mistake at its key, with the value the user wrote there."""
    field = error.field if error.field in KEYS else "file"
    if field not in table:
        # A default that does not suit this file, such as a cutoff longer than the line.
        return Mistake((field,), InputError(field, error.value, error.condition, error.remedy))
    return Mistake((field,), InputError(field, table[field], error.condition, error.remedy))
