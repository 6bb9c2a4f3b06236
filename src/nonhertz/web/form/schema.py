"""The JSON schema of a file for the page: that for editors, with hints for a form."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from typing import Any, Final

from nonhertz.bearing.series import series_table
from nonhertz.files.bearing_document import BearingFile
from nonhertz.files.keys import Key, Table, table_of
from nonhertz.files.schemas import schema_of
from nonhertz.files.sections import CaseDocument
from nonhertz.files.starting import BEARING_TEMPLATES, starting_bearing
from nonhertz.files.toml import parse
from nonhertz.inputs.descriptions import OneOrTwo, Part

Schema = dict[str, Any]

#: The keys that a kind of body needs; a diameter if it is not listed.
_NEEDED: Final = {"roller": ("diameter", "length"), "plate": ()}
#: The tables of a bearing file that do not change with the kind of bearing.
_OF_ALL_BEARINGS: Final = ("format", "solver", "report")


@cache
def form_schema(file: str) -> Schema:
    """Return the JSON schema of a case file or a bearing file with hints.

    In a table, ``x-pairs`` lists pairs of keys of which one replaces the other, ``x-apart`` groups of keys of which at
    most one is given, and ``x-kinds`` has for each kind its keys, those that it needs, and the words that its keys may
    have. In a key, ``x-words`` are names that may replace its value, ``x-names`` names its two values, and ``x-single``
    is the number of the one that a single value stands for. The schema of a bearing has documents of all kinds in
    ``x-examples``.
    """
    schema = schema_of(file)
    for table, place in _tables(table_of(_whole(file)), schema, schema["$defs"], set()):
        place["x-pairs"], place["x-apart"] = list(table.pairs), list(table.apart)
        if table.kinds:
            place["x-kinds"] = {word: _of_kind(word, kind) for word, kind in table.kinds.items()}
        for name, key in table.keys.items():
            place["properties"][name] |= _hints(key)
    return schema | ({"x-examples": _examples()} if file == "bearing" else {})


def _whole(file: str) -> Any:
    return CaseDocument if file == "case" else BearingFile


def _tables(table: Table, place: Schema, definitions: Schema, seen: set[str]) -> Iterator[tuple[Table, Schema]]:
    """Yield the table of a file and all tables within it, each with its schema."""
    yield table, place
    for name, key in table.keys.items():
        inner = list(_objects(place["properties"][name]))
        for kind in key.tables:
            if kind.name and kind.name not in seen:
                seen.add(kind.name)
                yield from _tables(kind, definitions[kind.name], definitions, seen)
            if not kind.name:
                yield from ((kind, one) for one in inner if one.get("title") == kind.word)


def _objects(place: Schema) -> Iterator[Schema]:
    """Yield the schemas of the tables that a place may have, alone or in a list, except references."""
    if "properties" in place:
        yield place
        return
    for one in (*place.get("anyOf", ()), *([place["items"]] if "items" in place else ())):
        yield from _objects(one)


def _of_kind(word: str, kind: Table) -> Schema:
    of_body = "diameter" in kind.keys
    words = {"series": [*series_table()[word]]} if "series" in kind.keys else {}
    needed = _NEEDED.get(word, ("diameter",)) if of_body else kind.required
    return {"keys": list(kind.keys), "needed": needed, "words": words}


def _hints(key: Key) -> Schema:
    """Return the hints that are missing in the schema of a key."""
    match key.description:
        case OneOrTwo(names=names, single=single):
            return {"x-names": names, "x-single": single}
        case Part(named=named) if named:
            return {"x-words": list(named)}
    return {}


def _examples() -> dict[str, dict[str, Any]]:
    """Return by kind of bearing the tables that turn any bearing into an example of it."""
    documents = [parse(starting_bearing(name), name) for name in BEARING_TEMPLATES]
    names = [name for name in BearingFile.descriptions if name not in _OF_ALL_BEARINGS]
    return {document["bearing"]["kind"]: {name: document.get(name) for name in names} for document in documents}
