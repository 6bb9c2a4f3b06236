"""JSON schemas of the files that are read and written, for editors and for other programs.

Schemas of case, bearing and plan files come from the tables that check these files, those of results from the tables of
keys that write them: they have every key and no other.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterable, Mapping
from functools import partial
from typing import Any

from nonhertz.files import bearing_results
from nonhertz.files.bearing_document import BearingFile
from nonhertz.files.comparisons import COMPARISON
from nonhertz.files.contact_results import CONTACT
from nonhertz.files.keys import Key, Table, table_of
from nonhertz.files.lives import LIVES
from nonhertz.files.map_results import MAP
from nonhertz.files.materials import MATERIALS
from nonhertz.files.nodes import NODES
from nonhertz.files.plan_document import PlanDocument
from nonhertz.files.prepared import PROFILE
from nonhertz.files.profiles import KINDS as KINDS_OF_PROFILES
from nonhertz.files.results import Key as ResultKey
from nonhertz.files.results import schema_of as schema_of_keys
from nonhertz.files.sections import CaseDocument
from nonhertz.files.stresses import STRESSES
from nonhertz.files.studies import DESIGN, DIAGRAM, FRONT, SWEEP, TOLERANCE
from nonhertz.inputs.descriptions import Part, Several, describe_field

Schema = dict[str, Any]

DRAFT = "https://json-schema.org/draft/2020-12/schema"


def schema_of(kind: str) -> Schema:
    """Return the JSON schema of a kind of file: one of `KINDS`."""
    return {"$schema": DRAFT, **_for_older_programs(KINDS[kind]()), "title": f"nonhertz {kind} file"}


def schema_text(kind: str) -> str:
    """Return the JSON schema of a kind of file as text."""
    return json.dumps(schema_of(kind), indent=2) + "\n"


def _of_file(cls: Any) -> Schema:
    """Return the JSON schema of a kind of file, with those of its tables as definitions."""
    tables: dict[str, Schema] = {}
    _of_table(table_of(cls), tables)
    whole = tables.pop(cls.__name__)
    return whole | {"$defs": tables}


def _of_table(table: Table, tables: dict[str, Schema]) -> Schema:
    """Return a reference to the JSON schema of a table, put into ``tables``; for profiles the schema itself."""
    if not table.name:
        return _of_profile(table)
    if table.name not in tables:
        tables[table.name] = {}  # so that it may refer to itself
        word = {"kind": {"enum": list(table.kinds), "description": table.meaning_of_kind}} if table.kinds else {}
        keys = {name: _of_key(key, tables) for name, key in table.keys.items()}
        has_usual = any(kind.name == table.name for kind in table.kinds.values())
        needed = sorted([*table.required, *([] if has_usual else word)])
        tables[table.name] = _table(word | keys, table.meaning) | {"title": table.name, "required": needed}
    return {"$ref": f"#/$defs/{table.name}"}


def _of_profile(table: Table) -> Schema:
    """Return the JSON schema of a kind of profile."""
    sized = [name for name in table.required if name in KINDS_OF_PROFILES[table.word].by_drop]
    drop = {"required": ["drop"]}
    properties = {"kind": {"const": table.word}} | {name: _of_key(key, {}) for name, key in table.keys.items()}
    needed = ["kind", *(name for name in table.required if name not in sized)]
    either = {"oneOf": [{"required": sized, "not": drop}, drop]} if sized else {}
    return _table(properties, table.meaning) | {"title": table.word, "required": needed} | either


def _of_key(key: Key, tables: dict[str, Schema]) -> Schema:
    """Return the JSON schema of the value of a key."""
    description, usual = key.description, key.usual
    named = getattr(description, "named", {})
    inner = [_of_table(one, tables) for one in key.tables]
    if isinstance(description, Several) and inner:
        schema = description.schema() | {"items": inner[0]}
    elif key.several:
        schema = {"anyOf": [{"anyOf": inner}, {"type": "array", "items": {"anyOf": inner}}]}
    else:
        own = [] if isinstance(description, Part) and not named else [description.schema()]
        schema = _any_of([*own, *inner])
    usual = next((word for word, known in named.items() if known == usual), usual)
    # TOML has neither null nor, to all programs, infinity.
    plain = isinstance(usual, str | int | float) and usual != math.inf
    return schema | {"description": describe_field(description)} | ({"default": usual} if plain else {})


def _of_result(meaning: str, keys: Iterable[ResultKey], inputs: Any) -> Schema:
    """Return the JSON schema of a file of a result; its ``case``, if it has one, is a file of the inputs."""
    schema = schema_of_keys(keys) | {"description": meaning}
    if inputs is not None:
        schema["properties"]["case"] = _of_file(inputs)
        schema["$defs"] = schema["properties"]["case"].pop("$defs")
    return schema


#: Files written as JSON: meaning, keys, and the class of their ``case``, if they have one.
RESULTS: dict[str, tuple[str, tuple[ResultKey, ...], Any]] = {
    "result": ("A solved contact.", CONTACT, CaseDocument),
    "bearing-result": ("A loaded bearing.", bearing_results.keys(), BearingFile),
    "stress": ("The largest stresses below a contact.", STRESSES, None),
    "life": ("The lives of the bodies of a contact.", LIVES, None),
    "profile": ("A prepared measured profile.", PROFILE, None),
    "map": ("A map of a contact: its range and its errors.", MAP, None),
    "comparison": ("Strips compared with a plane grid.", COMPARISON, None),
    "bearing-comparison": ("A bearing by strips and by slices.", bearing_results.comparison_keys(), None),
    "sweep": ("The results of a sweep.", SWEEP, None),
    "diagram": ("Numbers of a bearing over one of its inputs.", DIAGRAM, None),
    "tolerance": ("The distributions of results, and the tolerances to tighten.", TOLERANCE, None),
    "design": ("The best profile or dimensions.", DESIGN, None),
    "front": ("The Pareto front of a design.", FRONT, None),
    "materials": ("The library of materials.", MATERIALS, None),
    "nodes": ("Pressures and forces of a contact at the nodes of a mesh.", NODES, None),
}
#: Kinds of files, and the functions that return their schemas.
KINDS: dict[str, Callable[[], Mapping[str, Any]]] = {
    "case": partial(_of_file, CaseDocument),
    "bearing": partial(_of_file, BearingFile),
    "plan": partial(_of_file, PlanDocument),
    **{kind: partial(_of_result, *result) for kind, result in RESULTS.items()},
}


def _any_of(schemas: list[Schema]) -> Schema:
    return schemas[0] if len(schemas) == 1 else {"anyOf": schemas}


def _table(properties: Schema, description: str) -> Schema:
    return {
        "type": "object",
        "description": description,
        "properties": properties,
        "required": list(properties),
        "additionalProperties": False,
    }


def _for_older_programs(schema: Any) -> Any:
    """Return a schema whose constants are also in the terms of draft 4, which Taplo knows."""
    if isinstance(schema, dict):
        translated = {key: _for_older_programs(value) for key, value in schema.items()}
        constant = translated.get("const", {})
        return translated if isinstance(constant, dict) else translated | {"enum": [constant]}
    return [_for_older_programs(entry) for entry in schema] if isinstance(schema, list) else schema
