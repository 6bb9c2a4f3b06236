"""The form of a document: fields and groups, made from the case file's schema.

The keys of a case file are not repeated here. What the schema says about a key decides which field it gets, so a key
added to case files, or a profile added to the catalogue, appears in the form at once. An invalid value that its field
cannot hold is shown as JSON, and so is an unknown key: the form shows the whole document, which can be rebuilt from it.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Any, Final

from nonhertz.io.bounds import FORMAT
from nonhertz.io.casefile import schema
from nonhertz.io.mistakes import Place, TableError, path_of
from nonhertz.io.profiles import required_keys
from nonhertz.io.reading import read
from nonhertz.model.body import Body
from nonhertz.web.form.fields import Edits, FormField, FormGroup, Option, text_of
from nonhertz.web.form.inputs import ABSENT, as_it_is, input_for, label_of, stray
from nonhertz.web.form.keys import (
    Schema,
    alternatives,
    is_table,
    kinds_made_of_numbers,
    meaning_of,
    profile_kinds,
    words_for,
)
from nonhertz.web.form.ranges import start, start_list

#: One of each pair is given; the form shows the first unless the document has the other.
ALTERNATIVES: Final = (("load", "approach"), ("tilt", "moment"))
#: Keys that all kinds of profile have, kept when the kind is changed.
COMMON: Final = ("shift", "scale", "flip")
#: Keys that most cases leave at their defaults, folded away.
FOLDED: Final = (
    *("effective_length", "corner_radius", "chamfer", "position", "side_faces", "images", "depth", "bore"),
    *("case_depth", "yield_strength", "core_yield_strength", "hardness", "pressure_limit"),
    *("drop", "at", *COMMON),
    *("solver", "life", "report"),
)
#: Keys that are a number in the form, unless a file has a table in their place.
MOSTLY_NUMBERS: Final = ("bore",)
#: The most frequently changed keys come first; the rest in the order of the schema.
UNREAD: Final = "file"
FIRST: Final = ("title", "kind", "load", "body", "diameter", "length", "profile", "material")


def form(document: dict[str, Any]) -> FormGroup:
    """Return the form of a document, valid or not, without a field for the format number."""
    whole = schema()
    asked = {name: part for name, part in whole["properties"].items() if name != "format"}
    given = {name: value for name, value in document.items() if name != "format" or value != FORMAT}
    return _group({**whole, "properties": asked}, given, (), "Case")


def _table(part: Schema, value: Any, place: Place, legend: str) -> FormGroup | FormField:
    """Return the form of a table, or of another value in its place."""
    if value is not ABSENT and not isinstance(value, dict):
        return as_it_is(part, value, place)
    return _group(part, value if isinstance(value, dict) else {}, place, legend, there=value is not ABSENT)


def _group(part: Schema, given: dict[str, Any], place: Place, legend: str, *, there: bool = True) -> FormGroup:
    """Return the form of a table, with unknown keys as JSON; ``there`` says whether the document has the table."""
    known = part["properties"]
    pairs = _pairs(part)
    hidden = _unchosen(pairs, given)
    members: list[FormField | FormGroup] = [*_switches(pairs, given, place)]
    folded: list[FormField | FormGroup] = []
    # Points are pasted or dropped: the page reads no files.
    hidden |= {UNREAD} - set(given)
    for name in sorted(set(known) - hidden, key=_rank(known)):
        entry = _member(name, known[name], given.get(name, ABSENT), (*place, name), given)
        (folded if name in FOLDED else members).append(entry)
    members += [stray(entry, (*place, name)) for name, entry in given.items() if name not in known]
    base = "{}" if there and place else ""
    return FormGroup(path_of(place), legend, tuple(members), meaning_of(part), tuple(folded), base)


def _rank(known: Schema) -> Callable[[str], int]:
    """Return the sort key for the keys of a table."""
    order = [*FIRST, *known]
    return order.index


def _member(name: str, part: Schema, value: Any, place: Place, table: dict[str, Any]) -> FormField | FormGroup:
    """Return the form of one key of a table."""
    kinds = alternatives(part)
    meaning = meaning_of(part)
    if name == "kind":
        return _kind(part, value, place, table)
    rows = [kind for kind in kinds if kind.get("type") == "array" and is_table(alternatives(kind["items"])[0])]
    if rows:
        tables = list(profile_kinds().values()) if name == "profile" else alternatives(rows[0]["items"])
        return _list(tables, value, place, meaning)
    tables = [kind for kind in kinds if is_table(kind)]
    if name in MOSTLY_NUMBERS and not isinstance(value, dict):
        tables, part = [], _plain(part)
    if tables and (len(kinds) == 1 or name in MOSTLY_NUMBERS):
        return _table(tables[0] | {"description": meaning}, value, place, label_of(place))
    if tables:
        return _value_or_table(tables[0], part, value, place)
    pairs = [kind for kind in kinds if kind.get("type") == "array" and kind.get("maxItems") == 2]
    if pairs and len(kinds) > 1:
        return _one_or_two(part, value, place, "length" in table)
    made = input_for(part, value, place)
    return replace(made, default=_usual_depth(table)) if name == "depth" else made


def _usual_depth(body: dict[str, Any]) -> str:
    """Return the depth of a body that gives none; nothing where it has mistakes."""
    given = {name: value for name, value in body.items() if name not in ("depth", "profile", "chamfer")}
    try:
        return read(Body, given).behind.word
    except TableError:
        return ""


def _kind(part: Schema, value: Any, place: Place, table: dict[str, Any]) -> FormField:
    """Return the choice of the kind of a body or profile, on which the other keys depend."""
    if "enum" in part:
        options = tuple(Option(word, word, _body_edits(word, place, table)) for word in part["enum"])
    else:
        options = tuple(
            Option(kind, kind, [(path_of(place[:-1]), _new_profile(kind, table))]) for kind in kinds_made_of_numbers()
        )
    text = text_of("choice", value) if value is not ABSENT else ""
    made = FormField(path_of(place), "kind", "choice", text or "", meaning_of(part), structural=True)
    if text is None:
        return replace(made, kind="json", value=json.dumps(value), structural=False)
    known = [option.value for option in options]
    return replace(made, options=options if not text or text in known else (*options, Option(text, text)))


def _body_edits(word: str, place: Place, body: dict[str, Any]) -> Edits:
    """Return the edits that give a body the keys its new kind needs and remove those it must not have."""
    within = place[:-1]
    edits: Edits = [(path_of(place), word)]
    if word == "plate":
        return [*edits, (path_of((*within, "diameter")), None)]
    needed = ("diameter", "length") if word == "roller" else ("diameter",)
    return edits + [(path_of((*within, name)), start(name)) for name in needed if name not in body]


def _new_profile(kind: str, before: dict[str, Any] | None = None) -> dict[str, Any]:
    """Return a profile of a kind, with the common keys of the previous one."""
    part = profile_kinds()[kind]
    keys = part["properties"]
    kept = {name: value for name, value in (before or {}).items() if name in COMMON}
    # Lists have to be given, unless a file replaces them.
    needed = [name for name in keys if name in required_keys(part) or keys[name].get("type") == "array"]
    new = {
        name: start_list(name) if keys[name].get("type") == "array" else start(keys[name].get("range", name))
        for name in needed
        if name != "kind"
    }
    return {"kind": kind} | new | kept


def _list(tables: list[Schema], value: Any, place: Place, meaning: str) -> FormGroup | FormField:
    """Return the form of a list of tables, or of a single table in place of a list of one."""
    if isinstance(value, dict):
        return _entry(tables, value, place)
    if value is not ABSENT and not isinstance(value, list):
        return as_it_is({"description": meaning}, value, place)
    entries = value if isinstance(value, list) else []
    members = tuple(_entry(tables, entry, (*place, number)) for number, entry in enumerate(entries, start=1))
    base = "" if value is ABSENT else "[]"
    return FormGroup(path_of(place), label_of(place), members, meaning, (), base, additions=_additions(tables))


def _entry(tables: list[Schema], entry: Any, place: Place) -> FormGroup | FormField:
    if not isinstance(entry, dict):
        return stray(entry, place)
    kinds = {table["properties"].get("kind", {}).get("const"): table for table in tables}
    kind = entry.get("kind")
    part = kinds.get(kind) if isinstance(kind, str) or len(tables) == 1 else None
    part = tables[0] if len(tables) == 1 else part
    if part is None:  # an unknown kind: its keys are unknown too
        part = {"properties": {"kind": {"description": "kind of profile"}}}
    legend = f"{label_of(place)}: {kind}" if isinstance(kind, str) else label_of(place)
    return replace(_group(part, entry, place, legend), removable=isinstance(place[-1], int))


def _additions(tables: list[Schema]) -> tuple[Option, ...]:
    if len(tables) == 1:
        row = {name: start(name) for name in tables[0]["required"]}
        return (Option("row", "row", [("", row)]),)
    return tuple(Option(kind, kind, [("", _new_profile(kind))]) for kind in kinds_made_of_numbers())


def _value_or_table(table: Schema, part: Schema, value: Any, place: Place) -> FormGroup:
    """Return the form of a key that may hold one value or a table of several."""
    name, path = str(place[-1]), path_of(place)
    tabular = isinstance(value, dict)
    simple: Any = words_for(name, part)[0] if words_for(name, part) else start(name)
    several = {
        key: start_list(key) if inner.get("type") == "array" else start(key)
        for key, inner in table["properties"].items()
        if key in table["required"]
    }
    keys = " and ".join(several)
    options = (
        Option("value", "name" if isinstance(simple, str) else "one number", [(path, simple)]),
        Option("table", keys, [(path, several)]),
    )
    shape = _switch(path, f"{label_of(place)} by", options, "table" if tabular else "value")
    if tabular:
        inner = _group(table | {"description": meaning_of(part)}, value, place, label_of(place))
        return replace(inner, members=(shape, *inner.members))
    return FormGroup(path, label_of(place), (shape, input_for(_plain(part), value, place)))


def _plain(part: Schema) -> Schema:
    """Return a key without the tables that may stand in it."""
    kept = {key: entry for key, entry in part.items() if key != "anyOf"}
    return kept | {"anyOf": [kind for kind in alternatives(part) if not is_table(kind)]}


def _one_or_two(part: Schema, value: Any, place: Place, ends: bool) -> FormGroup | FormField:
    """Return the form of a key with one value for both ends of a body, or two; a body without ends gets no switch."""
    path = path_of(place)
    is_pair = isinstance(value, list) and len(value) == 2
    first = value[0] if is_pair else (Body.side_faces if value is ABSENT else value)
    options = (
        Option("value", "one for both ends", [(path, first)]),
        Option("pair", "one for each end", [(path, value if is_pair else [first, first])]),
    )
    shape = _switch(path, f"{label_of(place)}:", options, "pair" if is_pair else "value")
    words = {"anyOf": [kind for kind in alternatives(part) if kind.get("type") != "array"]}
    words |= {key: entry for key, entry in part.items() if key != "anyOf"}
    if not is_pair:
        single = input_for(words, value, place)
        return FormGroup(path, label_of(place), (shape, single)) if ends else single
    members = tuple(
        replace(input_for(words, entry, (*place, number)), label=f"at {end} y")
        for number, (end, entry) in enumerate(zip(("low", "high"), value, strict=True), start=1)
    )
    return FormGroup(path, label_of(place), (shape, *members), base="[]")


def _pairs(part: Schema) -> list[tuple[str, str]]:
    """Return the pairs of keys in a table of which one is given, the usual one first."""
    found = [pair for pair in ALTERNATIVES if set(pair) <= set(part["properties"])]
    return found + [(each["required"][0], "drop") for each in part.get("oneOf", ())[:1]]


def _switches(pairs: list[tuple[str, str]], given: dict[str, Any], place: Place) -> Iterator[FormField]:
    """Yield a choice for each pair of alternative keys."""
    for pair in pairs:
        paths = {name: path_of((*place, name)) for name in pair}
        options = tuple(
            Option(name, name, [(paths[name], start(name)), *((paths[other], None) for other in pair if other != name)])
            for name in pair
        )
        chosen = next((name for name in pair if name in given), pair[0])
        yield _switch(path_of(place), " or ".join(pair), options, chosen)


def _unchosen(pairs: list[tuple[str, str]], given: dict[str, Any]) -> set[str]:
    """Return the keys to hide: the alternatives not chosen, those a plate must not have, and files."""
    aside: set[str] = set()
    for pair in pairs:
        shown = [name for name in pair if name in given] or [pair[0]]
        aside |= {name for name in pair if name not in shown}
    if given.get("kind") == "plate" and "diameter" not in given:
        aside.add("diameter")
    return aside


def _switch(path: str, label: str, options: tuple[Option, ...], chosen: str) -> FormField:
    """Return a choice that is not a key of the document."""
    return FormField(path, label, "switch", chosen, options=options, structural=True)
