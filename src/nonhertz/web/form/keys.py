"""What the case file's schema says about its keys: what a value may be, in which unit, and what it means."""

from __future__ import annotations

import functools
import re
from collections.abc import Iterator
from dataclasses import asdict
from typing import Any, Final

from nonhertz.io.casefile import schema
from nonhertz.model.materials import MATERIALS
from nonhertz.web.form.fields import number_or_words

Schema = dict[str, Any]

_QUOTED: Final = re.compile(r"""['"`]([a-z][a-z0-9-]*)['"`]""")


def _resolved(part: Schema) -> Schema:
    """Return a part of the schema with its reference resolved and the null alternative removed."""
    if "$ref" in part:
        name = part["$ref"].rpartition("/")[2]
        part = schema()["$defs"][name] | {key: value for key, value in part.items() if key != "$ref"}
    kinds = [kind for kind in part.get("anyOf", ()) if kind != {"type": "null"}]
    if len(kinds) == 1:
        return _resolved(kinds[0] | {key: value for key, value in part.items() if key != "anyOf"})
    return part


def alternatives(part: Schema) -> list[Schema]:
    """Return what a value may be, with nested alternatives flattened."""
    part = _resolved(part)
    if "anyOf" not in part or is_quantity(part):
        return [part]
    return [flat for kind in part["anyOf"] if kind != {"type": "null"} for flat in alternatives(kind)]


def is_table(part: Schema) -> bool:
    """Return whether a value is a table of keys."""
    return part.get("type") == "object"


def is_quantity(part: Schema) -> bool:
    """Return whether a value is a number, or text of a number and a unit, but not a word."""
    if part.get("type") in {"number", "integer"}:
        return True
    return "unit" in part and not any("enum" in kind or "const" in kind for kind in part["anyOf"])


def words_for(name: str, part: Schema) -> tuple[str, ...]:
    """Return the words that a key may hold, as far as the schema or the key's description names them."""
    if name == "material":
        return tuple(MATERIALS)
    if name == "models":
        from nonhertz.life import MODELS

        return tuple(MODELS)
    listed = [
        word for kind in alternatives(part) for word in kind.get("enum", [kind["const"]] if "const" in kind else [])
    ]
    takes_text = any(kind.get("type") == "string" and "unit" not in kind for kind in alternatives(part))
    return tuple(listed) or (tuple(dict.fromkeys(_QUOTED.findall(part.get("description", "")))) if takes_text else ())


def unit_of(part: Schema) -> str:
    """Return the unit of a plain number; empty if it has none."""
    units = [part.get("unit", ""), *(kind.get("unit", "") for kind in alternatives(part))]
    return next((unit for unit in units if unit), "")


def default_of(part: Schema) -> str:
    """Return the default of a key as text; empty if there is no single value."""
    default = part.get("default")
    if isinstance(default, dict):
        return next((name for name, material in MATERIALS.items() if asdict(material) == default), "")
    return default if isinstance(default, str) else number_or_words(default) or ""


def meaning_of(part: Schema) -> str:
    """Return what the schema says about a key, without documentation markup."""
    return str(part.get("description", "")).replace("`", "")


@functools.cache
def profile_kinds() -> dict[str, Schema]:
    """Return the schema of each kind of profile."""
    body = schema()["$defs"]["Body"]["properties"]["profile"]
    tables = [kind for kind in alternatives(body) if is_table(kind)]
    return {table["properties"]["kind"]["const"]: _told_apart(table) for table in tables}


def _told_apart(table: Schema) -> Schema:
    """Return a kind of profile; if it has a design load, its radius is marked as the one across the contact."""
    keys = table["properties"]
    if "load" in keys and "radius" in keys:
        keys = keys | {"radius": keys["radius"] | {"range": "radius across"}}
    return table | {"properties": keys}


def kinds_made_of_numbers() -> Iterator[str]:
    """Yield the kinds of profile that need no file, since the page reads no files by name."""
    yield from (kind for kind, part in profile_kinds().items() if "file" not in part["required"])
