"""Tables of the keys of result files, from which JSON, its units, its schema and its reference are made.

A new number of a result is an entry in the table of its file.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from operator import attrgetter
from types import SimpleNamespace
from typing import Any, Final

import numpy as np

from nonhertz.amounts import display_units
from nonhertz.files.bounds import FORMAT
from nonhertz.findings import Finding, as_warnings
from nonhertz.inputs import descriptions
from nonhertz.inputs.fields import Input
from nonhertz.result.quantities import Quantity
from nonhertz.verdict import Verdict, verdict_to_object

Get = Callable[[Any], Any]

#: JSON has neither infinity nor NaN: such numbers are null.
NUMBER: Final = ("number", "null")


@dataclass(frozen=True)
class ListOf:
    """A list in JSON: the type of its entries, as in `Key.holds`, and their number, if it is the same in all files."""

    entry: Any = NUMBER
    count: int | None = None


@dataclass(frozen=True)
class MapOf:
    """An object in JSON whose names differ from file to file: the type of its values, as in `Key.holds`."""

    entry: Any = NUMBER


@dataclass(frozen=True)
class Key:
    """A key of a JSON object.

    Attributes
    ----------
    name : str
        The key.
    meaning : str
        Its meaning.
    unit : str, list, mapping or None
        Unit of its number or numbers; a list or a mapping by name if each has its own. If None, the keys of the objects
        in it have units; if empty, they have those of the enclosing object.
    get : callable or str
        Returns its value in the result; or the dotted path of an attribute, by default its name.
    holds : str, tuple of str, list of str, mapping, tuple of Key, ListOf or MapOf
        The type of its value in JSON, such as ``"string"``; a tuple of possible types; a list of possible words; a
        schema; the keys of an object; a list of any of these, or any of these by name.
    nullable : bool
        Whether it may be null; numbers always may.
    applies : callable or None
        Whether a result has the key; if None, all have it.
    """

    name: str
    meaning: str
    unit: Any = None
    get: Get | str = ""
    holds: Any = NUMBER
    nullable: bool = False
    applies: Get | None = None

    @property
    def keys(self) -> tuple[Key, ...]:
        """The keys of the object, or of the objects, in it."""
        return _keys(self.holds)

    def value(self, result: Any) -> Any:
        """Return its value in a result."""
        return (self.get if callable(self.get) else attrgetter(self.get or self.name))(result)

    def json(self, result: Any) -> Any:
        """Return its value as JSON can represent it."""
        return _json(self.holds, self.value(result))

    @property
    def schema(self) -> dict[str, Any]:
        """Its JSON schema."""
        schema = _schema(self.holds)
        if self.nullable:
            schema["type"] = [schema["type"], "null"]
        unit = f" [{self.unit}]" if isinstance(self.unit, str) and self.unit else ""
        return schema | {"description": self.meaning + unit} | ({"unit": self.unit} if self.unit else {})


def within(get: Get | str, *keys: Key) -> tuple[Key, ...]:
    """Return the keys of a part of a result as keys of the result; ``get`` returns the part, or is its path."""
    part = get if callable(get) else attrgetter(get)

    def moved(key: Key) -> Key:
        return replace(key, get=lambda result: key.value(part(result)))

    return tuple(map(moved, keys))


def quantity_keys(quantities: Iterable[Quantity], holds: Any = NUMBER) -> tuple[Key, ...]:
    """Return the keys of quantities of a solution."""
    return tuple(Key(q.name, q.meaning or q.label, q.unit, q.get, holds) for q in quantities)


def input_keys(inputs: type[Input], path: str = "") -> tuple[Key, ...]:
    """Return the keys of all fields of an input; ``path`` is its path in a result, and ends in a full stop."""

    def key(name: str, described: Any) -> Key:
        numeric = isinstance(described, descriptions.Quantity)
        holds = NUMBER if numeric else ("string", "null")
        return Key(name, described.meaning, described.unit or None if numeric else None, f"{path}{name}", holds)

    return tuple(key(name, described) for name, described in inputs.descriptions.items())


@display_units("si")
def document(keys: Iterable[Key], **parts: Any) -> dict[str, Any]:
    """Return a result as plain numbers, text, lists and dictionaries; keys find their values in its parts, by name."""
    return object_of(keys, SimpleNamespace(**parts))


def object_of(keys: Iterable[Key], result: Any) -> dict[str, Any]:
    """Return the values of keys in a result, or in a part of one."""
    return {
        key.name: units_of(keys) if key is UNITS else key.json(result)
        for key in keys
        if key.applies is None or key.applies(result)
    }


def units_of(keys: Iterable[Key]) -> dict[str, Any]:
    """Return the units of numbers by their keys; keys without units are left out."""
    units = {key.name: units_of(key.keys) if key.unit is None else key.unit for key in keys}
    return {name: unit for name, unit in units.items() if unit}


def schema_of(keys: Iterable[Key]) -> dict[str, Any]:
    """Return the JSON schema of an object with these keys and no others."""
    return {
        "type": "object",
        "properties": {key.name: key.schema for key in keys},
        "required": [key.name for key in keys if key.applies is None],
        "additionalProperties": False,
    }


def _keys(holds: Any) -> tuple[Key, ...]:
    match holds:
        case ListOf(entry) | MapOf(entry):
            return _keys(entry)
        case (Key(), *_):
            return tuple(holds)
    return ()


def _json(holds: Any, value: Any) -> Any:
    """Return a value as JSON can represent it."""
    if value is None or not _keys(holds):
        return plain(value)
    match holds:
        case ListOf(entry):
            return [_json(entry, part) for part in value]
        case MapOf(entry):
            return {name: _json(entry, part) for name, part in value.items()}
    return object_of(holds, value)


def _schema(holds: Any) -> dict[str, Any]:
    match holds:
        case MapOf(entry):
            return {"type": "object", "additionalProperties": _schema(entry)}
        case ListOf(entry, count):
            return {"type": "array", "items": _schema(entry)} | (
                {"minItems": count, "maxItems": count} if count else {}
            )
        case Mapping():
            return dict(holds)
        case list():
            return {"enum": holds}
    return schema_of(holds) if _keys(holds) else {"type": holds if isinstance(holds, str) else [*holds]}


# Keys of several files

FORMAT_KEY: Final = Key("format", "format of the file", get=lambda _: FORMAT, holds={"const": FORMAT})
#: Its value follows from the other keys.
UNITS: Final = Key("units", "units of all these; dimensionless numbers are left out", holds="object")


def verdict_key(verdict: Callable[[Any], Verdict | None]) -> Key:
    """Return the key of the verdict on a result."""
    meaning = (
        "whether limits are met: level (met, strained, not-judged, unlimited or not-met), and the findings that decide "
        "it, worst first; where names the one of several; null without a verdict"
    )
    return Key("verdict", meaning, get=lambda result: verdict_to_object(verdict(result)), holds="object", nullable=True)


def models_key(get: Get | str, bodies: Mapping[str, str]) -> Key:
    """Return the key of the models of bodies, by attribute and name."""
    keys = tuple(Key(name, f"of {body}", get=f"{name}.model", holds="string") for name, body in bodies.items())
    return Key("models", "side faces and depth as used", get=get, holds=keys)


def findings_key(name: str, meaning: str, path: str, **options: Any) -> Key:
    """Return a key of findings with kind, sentence and numbers."""
    findings = attrgetter(path)
    objects = lambda result: [finding.as_object() for finding in findings(result)]  # noqa: E731
    return Key(name, meaning, get=objects, holds=ListOf("object"), **options)


def assumed_key(path: str) -> Key:
    """Return the key of assumptions."""
    meaning = (
        "assumptions for inputs that the file leaves out and that change a key figure by more than 5 %: kind, "
        "sentence, and numbers with default, keys and the results that they decide"
    )
    return findings_key("assumed", meaning, path)


def warning_keys(findings: Callable[[Any], Iterable[Finding]], notes: Get = lambda _: ()) -> tuple[Key, Key]:
    """Return the keys of warnings, after any notes."""

    def get(name: str) -> Get:
        return lambda result: as_warnings(findings(result), notes(result))[name]

    meaning = "the same by kind, with value and unit of each number"
    return (
        Key("warnings", "warnings, a sentence each", get=get("warnings"), holds=ListOf("string")),
        Key("findings", meaning, get=get("findings"), holds=ListOf("object")),
    )


# Text


def plain(value: Any) -> Any:
    """Return a number, or numbers nested in arrays, lists, tuples and mappings, in a form that JSON can represent.

    Text, truth values and whole numbers stay as they are, and findings become text.

    Examples
    --------
    >>> plain(np.array([1.0, np.inf])), plain({"load": 1.5, "kind": "finite", "strips": 3})
    ([1.0, None], {'load': 1.5, 'kind': 'finite', 'strips': 3})
    """
    match value:
        case None | str() | int():
            return value
        case Finding():
            return str(value)
        case Mapping():
            return {name: plain(entry) for name, entry in value.items()}
        case np.ndarray() | np.generic():
            # Far faster, and most are finite.
            return value.tolist() if value.dtype.kind == "f" and np.isfinite(value).all() else plain(value.tolist())
        case list() | tuple():
            return list(map(plain, value))
    number = float(value)
    return number if math.isfinite(number) else None


def key_by_key(entries: dict[str, Any]) -> str:
    """Return an object as JSON text, one of its keys per line.

    Examples
    --------
    >>> print(key_by_key({"load": 1.0, "y": [0.0, 1.0]}))
    {
      "load": 1.0,
      "y": [0.0, 1.0]
    }
    """
    lines = (f"  {json.dumps(key)}: {json.dumps(value, allow_nan=False)}" for key, value in entries.items())
    return "{\n" + ",\n".join(lines) + "\n}"
