"""The form of a document: fields and groups, made from the case file's schema.

Nothing of a case file's keys is repeated here. What the schema says of a key decides what field it gets, so that a key
that is added to case files, or a profile to the catalogue, is in the form at once. A value that its field cannot hold,
because it is mistaken, is shown as it is, and so is a key that nobody knows: a form shows all of a document, and the
document can be made of it again.
"""

from __future__ import annotations

import functools
import json
import math
import re
from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Any, Final

from nonhertz.errors import InputError
from nonhertz.io.casefile import schema
from nonhertz.io.mistakes import Place, path_of
from nonhertz.io.units import in_unit
from nonhertz.web.fields import Edits, Field, Group, Option, Slider, number_or_words, text_of
from nonhertz.web.ranges import range_of, start, start_list

Schema = dict[str, Any]

ABSENT: Final = object()
_LONG_LIST: Final = 24
_WRITTEN_UNIT: Final = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?\s*(\S.*)")
_QUOTED: Final = re.compile(r"""['"`]([a-z][a-z0-9-]*)['"`]""")

#: Of each pair one is given; the form shows the first unless the document has another.
ALTERNATIVES: Final = (("load", "approach"), ("tilt", "moment"))
#: What all kinds of profile have; it stays when the kind is changed.
COMMON: Final = ("shift", "scale")
#: Keys that most cases leave alone, folded away.
FOLDED: Final = (
    *("effective_length", "position", "side_faces", "images", "depth"),
    *COMMON,
    *("solver", "life"),
)
#: What one changes most comes first; the rest in the order of the schema.
FIRST: Final = ("title", "kind", "load", "body", "diameter", "length", "profile", "material")


def form(document: dict[str, Any]) -> Group:
    """Return the form of a document, mistaken or not."""
    return _group(_schema(), document, (), "Case")


@functools.cache
def _schema() -> Schema:
    return schema()


def _resolved(part: Schema) -> Schema:
    """Return a part of the schema with its reference followed and what stands for "left out" taken away."""
    if "$ref" in part:
        name = part["$ref"].rpartition("/")[2]
        part = _schema()["$defs"][name] | {key: value for key, value in part.items() if key != "$ref"}
    kinds = [kind for kind in part.get("anyOf", ()) if kind != {"type": "null"}]
    if len(kinds) == 1:
        return _resolved(kinds[0] | {key: value for key, value in part.items() if key != "anyOf"})
    return part


def _alternatives(part: Schema) -> list[Schema]:
    """Return what a value may be, lists of possibilities within one another laid flat."""
    part = _resolved(part)
    if "anyOf" not in part or _is_quantity(part):
        return [part]
    return [flat for kind in part["anyOf"] if kind != {"type": "null"} for flat in _alternatives(kind)]


def _is_table(part: Schema) -> bool:
    return part.get("type") == "object"


def _is_quantity(part: Schema) -> bool:
    """Return whether a value is a number, or text of a number and a unit, and no word."""
    if part.get("type") in {"number", "integer"}:
        return True
    return "unit" in part and not any("enum" in kind or "const" in kind for kind in part["anyOf"])


def _table(part: Schema, value: Any, place: Place, legend: str) -> Group | Field:
    """Return the form of a table, or of what stands where one should."""
    if value is not ABSENT and not isinstance(value, dict):
        return _as_it_is(part, value, place)
    return _group(part, value if isinstance(value, dict) else {}, place, legend, there=value is not ABSENT)


def _group(part: Schema, given: dict[str, Any], place: Place, legend: str, *, there: bool = True) -> Group:
    """Return the form of a table, unknown keys as they are; ``there`` tells whether the document has it."""
    known = part["properties"]
    hidden = _unchosen(known, given)
    members: list[Field | Group] = [*_switches(known, given, place)]
    folded: list[Field | Group] = []
    for name in sorted(set(known) - hidden, key=_rank(known)):
        entry = _member(name, known[name], given.get(name, ABSENT), (*place, name), given)
        (folded if name in FOLDED else members).append(entry)
    members += [_stray(entry, (*place, name)) for name, entry in given.items() if name not in known]
    base = "{}" if there and place else ""
    return Group(path_of(place), legend, tuple(members), _meaning(part), tuple(folded), base)


def _rank(known: Schema) -> Callable[[str], int]:
    """Return by what the keys of a table are sorted."""
    order = [*FIRST, *known]
    return order.index


def _member(name: str, part: Schema, value: Any, place: Place, table: dict[str, Any]) -> Field | Group:
    """Return the form of one key of a table."""
    kinds = _alternatives(part)
    meaning = _meaning(part)
    if name == "kind":
        return _kind(part, value, place, table)
    rows = [kind for kind in kinds if kind.get("type") == "array" and _is_table(_alternatives(kind["items"])[0])]
    if rows:
        tables = list(_profile_kinds().values()) if name == "profile" else _alternatives(rows[0]["items"])
        return _list(tables, value, place, meaning)
    tables = [kind for kind in kinds if _is_table(kind)]
    if tables and len(kinds) == 1:
        return _table(tables[0] | {"description": meaning}, value, place, _label(place))
    if tables:
        return _value_or_table(tables[0], part, value, place)
    pairs = [kind for kind in kinds if kind.get("type") == "array" and kind.get("maxItems") == 2]
    if pairs and len(kinds) > 1:
        return _one_or_two(part, value, place, "length" in table)
    return _field(part, value, place)


def _field(part: Schema, value: Any, place: Place) -> Field:
    """Return the input for a value that is no table."""
    name = str(place[-1])
    kinds = _alternatives(part)
    first = kinds[0]
    words = _words(name, part)
    made = Field(path_of(place), _label(place), "text", "", _meaning(part), default=_default(part))
    if first.get("type") == "array":
        made = replace(made, kind="list", unit=_unit(first.get("items", {})), options=_options(words))
    elif any(kind.get("type") == "boolean" for kind in kinds):
        made = replace(made, kind="boolean" if len(kinds) == 1 else "json", options=_options(("true", "false", *words)))
    elif len(kinds) == 1 and not _is_quantity(first):
        made = replace(made, kind="choice" if words else "text", options=_options(words))
    elif all(_is_quantity(kind) for kind in kinds):
        made = replace(made, kind="quantity", unit=_unit(part))
    else:
        made = replace(made, kind="integer-or-word", unit=_unit(part), options=_options(words))
    return _filled(made, value, part.get("range", name))


def _filled(made: Field, value: Any, name: str) -> Field:
    """Return an input with a value in it, as another kind where it cannot hold the value."""
    if made.kind in {"quantity", "integer-or-word"}:
        made = replace(made, slider=_slider(name, made.unit, value))
    if value is ABSENT:
        return made
    text = text_of(made.kind, value)
    if text is None:
        return replace(made, kind="json", value=json.dumps(value), options=(), slider=None)
    if made.kind == "list" and isinstance(value, list) and len(value) > _LONG_LIST:
        return replace(made, kind="hidden-json", value=json.dumps(value))
    if made.kind == "choice" and text not in [option.value for option in made.options]:
        return replace(made, value=text, options=(*made.options, Option(text, text)))
    return replace(made, value=text)


def _slider(name: str, unit: str, value: Any) -> Slider | None:
    """Return what moves a quantity, where it stands now, and how it is written."""
    try:
        number = math.nan if value is ABSENT else in_unit(name, value, unit)
    except InputError:
        return None
    if isinstance(number, bool) or not isinstance(number, float) or math.isinf(number):
        return None
    found = range_of(name, None if math.isnan(number) else number)
    if found is None:
        return None
    if value is ABSENT:
        return Slider(found, found.position(found.start))
    written = _WRITTEN_UNIT.fullmatch(value) if isinstance(value, str) else None
    if written is None:
        return Slider(found, found.position(number))
    return Slider(found, found.position(number), in_unit(name, f"1 {written[1]}", unit), written[1])


def _kind(part: Schema, value: Any, place: Place, table: dict[str, Any]) -> Field:
    """Return the choice of what a body or a profile is; the other keys go with it."""
    if "enum" in part:
        options = tuple(Option(word, word, _body_edits(word, place, table)) for word in part["enum"])
    else:
        options = tuple(
            Option(kind, kind, [(path_of(place[:-1]), _new_profile(kind, table))]) for kind in _made_of_numbers()
        )
    text = text_of("choice", value) if value is not ABSENT else ""
    made = Field(path_of(place), "kind", "choice", text or "", _meaning(part), structural=True)
    if text is None:
        return replace(made, kind="json", value=json.dumps(value), structural=False)
    known = [option.value for option in options]
    return replace(made, options=options if not text or text in known else (*options, Option(text, text)))


def _body_edits(word: str, place: Place, body: dict[str, Any]) -> Edits:
    """Return what a body needs, or must not have, to be of a kind."""
    within = place[:-1]
    edits: Edits = [(path_of(place), word)]
    if word == "plate":
        return [*edits, (path_of((*within, "diameter")), None)]
    needed = ("diameter", "length") if word == "roller" else ("diameter",)
    return edits + [(path_of((*within, name)), start(name)) for name in needed if name not in body]


@functools.cache
def _profile_kinds() -> dict[str, Schema]:
    """Return the schema of each kind of profile."""
    body = _schema()["$defs"]["BodyTable"]["properties"]["profile"]
    tables = [kind for kind in _alternatives(body) if _is_table(kind)]
    return {table["properties"]["kind"]["const"]: _told_apart(table) for table in tables}


def _told_apart(table: Schema) -> Schema:
    """Return a kind of profile with its radius marked as that across the contact where it has a design load."""
    keys = table["properties"]
    if "load" in keys and "radius" in keys:
        keys = keys | {"radius": keys["radius"] | {"range": "radius across"}}
    return table | {"properties": keys}


def _made_of_numbers() -> Iterator[str]:
    """Yield the kinds of profile that need no file; the page reads none by its name."""
    yield from (kind for kind, part in _profile_kinds().items() if "file" not in part["required"])


def _new_profile(kind: str, before: dict[str, Any] | None = None) -> dict[str, Any]:
    """Return a profile of a kind, with what it has in common with another."""
    part = _profile_kinds()[kind]
    keys = part["properties"]
    kept = {name: value for name, value in (before or {}).items() if name in COMMON}
    # Lists have to be given, though a file could stand for them; a radius has, unless something rarer stands for it.
    needed = [
        name for name in keys if name in part["required"] or name == "radius" or keys[name].get("type") == "array"
    ]
    new = {
        name: start_list(name) if keys[name].get("type") == "array" else start(keys[name].get("range", name))
        for name in needed
        if name != "kind"
    }
    return {"kind": kind} | new | kept


def _list(tables: list[Schema], value: Any, place: Place, meaning: str) -> Group | Field:
    """Return the form of a list of tables, or of one table that stands for a list of one."""
    if isinstance(value, dict):
        return _entry(tables, value, place)
    if value is not ABSENT and not isinstance(value, list):
        return _as_it_is({"description": meaning}, value, place)
    entries = value if isinstance(value, list) else []
    members = tuple(_entry(tables, entry, (*place, number)) for number, entry in enumerate(entries, start=1))
    base = "" if value is ABSENT else "[]"
    return Group(path_of(place), _label(place), members, meaning, (), base, additions=_additions(tables))


def _entry(tables: list[Schema], entry: Any, place: Place) -> Group | Field:
    if not isinstance(entry, dict):
        return _stray(entry, place)
    kinds = {table["properties"].get("kind", {}).get("const"): table for table in tables}
    kind = entry.get("kind")
    part = kinds.get(kind) if isinstance(kind, str) or len(tables) == 1 else None
    part = tables[0] if len(tables) == 1 else part
    if part is None:  # nobody knows what keys it may have
        part = {"properties": {"kind": {"description": "what profile it is"}}}
    legend = f"{_label(place)}: {kind}" if isinstance(kind, str) else _label(place)
    return replace(_group(part, entry, place, legend), removable=isinstance(place[-1], int))


def _additions(tables: list[Schema]) -> tuple[Option, ...]:
    if len(tables) == 1:
        row = {name: start(name) for name in tables[0]["required"]}
        return (Option("row", "row", [("", row)]),)
    return tuple(Option(kind, kind, [("", _new_profile(kind))]) for kind in _made_of_numbers())


def _value_or_table(table: Schema, part: Schema, value: Any, place: Place) -> Group:
    """Return the form of a key that may hold one value or a table of several."""
    name, path = str(place[-1]), path_of(place)
    is_table = isinstance(value, dict)
    simple: Any = _words(name, part)[0] if _words(name, part) else start(name)
    several = {
        key: start_list(key) if inner.get("type") == "array" else start(key)
        for key, inner in table["properties"].items()
    }
    keys = " and ".join(several)
    options = (
        Option("value", "name" if isinstance(simple, str) else "one number", [(path, simple)]),
        Option("table", keys, [(path, several)]),
    )
    shape = _switch(path, f"{_label(place)} by", options, "table" if is_table else "value")
    if is_table:
        inner = _group(table | {"description": _meaning(part)}, value, place, _label(place))
        return replace(inner, members=(shape, *inner.members))
    plain = {key: entry for key, entry in part.items() if key != "anyOf"} | {
        "anyOf": [kind for kind in _alternatives(part) if not _is_table(kind)]
    }
    return Group(path, _label(place), (shape, _field(plain, value, place)))


def _one_or_two(part: Schema, value: Any, place: Place, ends: bool) -> Group | Field:
    """Return the form of a key that holds one value for both ends of a body, or two; without ends it needs none."""
    path = path_of(place)
    is_pair = isinstance(value, list) and len(value) == 2
    first = value[0] if is_pair else ("mirror" if value is ABSENT else value)
    options = (
        Option("value", "one for both ends", [(path, first)]),
        Option("pair", "one for each end", [(path, value if is_pair else [first, first])]),
    )
    shape = _switch(path, f"{_label(place)}:", options, "pair" if is_pair else "value")
    words = {"anyOf": [kind for kind in _alternatives(part) if kind.get("type") != "array"]}
    words |= {key: entry for key, entry in part.items() if key != "anyOf"}
    if not is_pair:
        single = _field(words, value, place)
        return Group(path, _label(place), (shape, single)) if ends else single
    members = tuple(
        replace(_field(words, entry, (*place, number)), label=f"at {end} y")
        for number, (end, entry) in enumerate(zip(("low", "high"), value, strict=True), start=1)
    )
    return Group(path, _label(place), (shape, *members), base="[]")


def _switches(known: Schema, given: dict[str, Any], place: Place) -> Iterator[Field]:
    """Yield the choices between keys of which one is to be given."""
    for pair in ALTERNATIVES:
        if not set(pair) <= set(known):
            continue
        paths = {name: path_of((*place, name)) for name in pair}
        options = tuple(
            Option(name, name, [(paths[name], start(name)), *((paths[other], None) for other in pair if other != name)])
            for name in pair
        )
        chosen = next((name for name in pair if name in given), pair[0])
        yield _switch("", " or ".join(pair), options, chosen)


def _unchosen(known: Schema, given: dict[str, Any]) -> set[str]:
    """Return the keys that stand aside for another, and what a plate must not have."""
    aside: set[str] = set()
    for pair in ALTERNATIVES:
        if set(pair) <= set(known):
            shown = [name for name in pair if name in given] or [pair[0]]
            aside |= {name for name in pair if name not in shown}
    if given.get("kind") == "plate" and "diameter" not in given:
        aside.add("diameter")
    return aside


def _switch(path: str, label: str, options: tuple[Option, ...], chosen: str) -> Field:
    """Return a choice that is no key of the document."""
    return Field(path, label, "switch", chosen, options=options, structural=True)


def _stray(value: Any, place: Place) -> Field:
    """Return an unknown key with its value, which can be changed or taken away."""
    return Field(path_of(place), _label(place), "json", json.dumps(value), removable=True)


def _as_it_is(part: Schema, value: Any, place: Place) -> Field:
    """Return a value that stands where a table should."""
    return replace(_stray(value, place), help=_meaning(part))


def _label(place: Place) -> str:
    last = place[-1] if place else ""
    if isinstance(last, int):
        return f"{_label(place[:-1])} {last}"
    return f"body {last}" if place[:-1] == ("body",) else str(last).replace("_", " ")


def _meaning(part: Schema) -> str:
    """Return what the schema says of a key, without the marks that are for documentation."""
    return str(part.get("description", "")).replace("`", "")


def _words(name: str, part: Schema) -> tuple[str, ...]:
    """Return the words that a key may hold, as far as the schema or the key's meaning names them."""
    if name == "material":
        from nonhertz.model.material import MATERIALS  # noqa: PLC0415

        return tuple(MATERIALS)
    if name == "models":
        from nonhertz.life import MODELS  # noqa: PLC0415  (brings the compiler along)

        return tuple(MODELS)
    listed = [
        word for kind in _alternatives(part) for word in kind.get("enum", [kind["const"]] if "const" in kind else [])
    ]
    takes_text = any(kind.get("type") == "string" and "unit" not in kind for kind in _alternatives(part))
    return tuple(listed) or (tuple(dict.fromkeys(_QUOTED.findall(part.get("description", "")))) if takes_text else ())


def _options(words: tuple[str, ...]) -> tuple[Option, ...]:
    return tuple(Option(word, word) for word in words)


def _unit(part: Schema) -> str:
    units = [part.get("unit", ""), *(kind.get("unit", "") for kind in _alternatives(part))]
    return next((unit for unit in units if unit), "")


def _default(part: Schema) -> str:
    default = part.get("default")
    return default if isinstance(default, str) else number_or_words(default) or ""
