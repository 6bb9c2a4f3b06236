"""JSON schemas of the files that are read and written, for editors and for other programs.

Those of case, bearing and plan files are made by the tables that check these files. That of results is written here:
every key of a result is in it, and no other.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Mapping
from functools import partial
from typing import Any

from nonhertz.files.bearing_document import BearingFile
from nonhertz.files.bounds import FORMAT
from nonhertz.files.keys import Key, Table, table_of
from nonhertz.files.plan_document import PlanDocument
from nonhertz.files.profiles import KINDS as KINDS_OF_PROFILES
from nonhertz.files.results import NUMBERS
from nonhertz.files.sections import CaseDocument
from nonhertz.inputs.fields import Part, Several, text_of
from nonhertz.model.body import BODIES
from nonhertz.result.quantities import ALONG, QUANTITIES
from nonhertz.result.solution import EdgeKind, Status
from nonhertz.strip.element import ELEMENTS

Schema = dict[str, Any]

DRAFT = "https://json-schema.org/draft/2020-12/schema"
_NUMBER = {"type": "number"}
_NUMBER_OR_NULL = {"type": ["number", "null"]}
_TEXT = {"type": "string"}


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
    """Return the reference to the JSON schema of a table, which is put into ``tables``."""
    if table.name not in tables:
        tables[table.name] = {}  # so that it may refer to itself
        word = {"kind": {"enum": list(table.kinds), "description": table.meaning_of_kind}} if table.kinds else {}
        keys = {name: _of_key(key, tables) for name, key in table.keys.items()}
        has_usual = any(each.name == table.name for each in table.kinds.values())
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
    """Return the JSON schema of what a key holds."""
    each, usual = key.each, key.usual
    inner = [_of_table(one, tables) if one.name else _of_profile(one) for one in key.tables]
    if isinstance(each, Several) and inner:
        found = each.schema() | {"items": inner[0]}
    elif key.several:
        found = {"anyOf": [{"anyOf": inner}, {"type": "array", "items": {"anyOf": inner}}]}
    elif isinstance(each, Part) and not each.named:
        found = inner[0]
    else:
        found = {"anyOf": [each.schema(), *inner]} if inner else each.schema()
    if isinstance(each, Part) and each.named:
        usual = next((word for word, known in each.named.items() if known == usual), usual)
    # TOML has neither null nor, to all programs, infinity.
    plain = isinstance(usual, str | int | float) and usual != math.inf
    return found | {"description": text_of(each)} | ({"default": usual} if plain else {})


def result_schema() -> Schema:
    """Return the JSON schema of ``result.json``, which is what ``nonhertz solve --json`` prints."""
    case = _of_file(CaseDocument)
    numbers = {name: _described(_NUMBER_OR_NULL, QUANTITIES[name].label, QUANTITIES[name].unit) for name in NUMBERS}
    columns = {name: _described(_list(_NUMBER_OR_NULL), f"{name} of each strip", unit) for name, unit in ALONG.items()}
    errors = dict.fromkeys(("approach", "load", "max_pressure", "moment", "tilt"), _NUMBER_OR_NULL)
    properties = {
        "format": {"const": FORMAT, "description": "format of the file"},
        "title": {"type": "string", "description": "title of the case"},
        "status": {"enum": [each.label for each in Status], "description": "how the solve ended"},
        "element": {"enum": list(ELEMENTS), "description": "the strip element"},
        "models": _table(dict.fromkeys(BODIES, _TEXT), "side faces and depth of both bodies, as they were used"),
        **numbers,
        "contact_y": _described(_list(_pair(_NUMBER)), "the intervals in contact", "mm"),
        "edge_pressure": _pair(_edge()) | {"description": "the pressure at the low and at the high end"},
        "singular_ends": _list(
            _table({"y": _NUMBER, "kind": _kinds()}, "an end towards which the pressure has no limit")
        ),
        "stiffness": _pair(_pair(_NUMBER_OR_NULL))
        | {"description": "d(load, moment) / d(approach, tilt) [[N/mm, N/rad], [N mm/mm, N mm/rad]]"},
        "peaks_at_corner": {"type": "boolean", "description": "whether the largest pressure is at a corner"},
        "iterations": {"type": "integer", "minimum": 0, "description": "Newton steps"},
        "strips": {"type": "integer", "minimum": 1, "description": "number of strips"},
        "error_estimate": _table(errors, "estimated discretisation errors, relative; null where there is none"),
        "warnings": _list(_TEXT) | {"description": "what strains the model, a sentence each"},
        "assumed": _list({"type": "object"}) | {"description": "what is assumed where the file leaves something out"},
        "verdict": {"type": ["object", "null"], "description": "whether limits are met: level, and what decides it"},
        "findings": _list({"type": "object"}) | {"description": "the same, by kind, with numbers and their units"},
        "remarks": _list({"type": "object"}) | {"description": "what is noticed and strains nothing, if anything is"},
        "units": {"type": "object", "description": "units of all these; dimensionless numbers are left out"},
        **columns,
        "edges": _described(_list(_NUMBER), "edges of the strips", "mm"),
        "element_half_width": _described(_list(_NUMBER), "half-width of the element's own pressure", "mm"),
        "case": {key: value for key, value in case.items() if key != "$defs"},
    }
    required = [name for name in properties if name != "remarks"]
    return _table(properties, "A solved contact.") | {"required": required, "$defs": case["$defs"]}


#: What there are schemas of, and the functions that return them.
KINDS: dict[str, Callable[[], Mapping[str, Any]]] = {
    "case": partial(_of_file, CaseDocument),
    "bearing": partial(_of_file, BearingFile),
    "plan": partial(_of_file, PlanDocument),
    "result": result_schema,
}


def _table(properties: Schema, description: str) -> Schema:
    return {
        "type": "object",
        "description": description,
        "properties": properties,
        "required": list(properties),
        "additionalProperties": False,
    }


def _list(entry: Schema) -> Schema:
    return {"type": "array", "items": entry}


def _pair(entry: Schema) -> Schema:
    return _list(entry) | {"minItems": 2, "maxItems": 2}


def _described(schema: Schema, what: str, unit: str) -> Schema:
    return schema | {"description": f"{what} [{unit}]", "unit": unit}


def _kinds() -> Schema:
    return {"enum": [kind.label for kind in EdgeKind]}


def _edge() -> Schema:
    numbers = dict.fromkeys(
        ("y", "pressure", "strip_width", "image_weight", "exponent", "correction_exponent"), _NUMBER
    )
    unknown = dict.fromkeys(("strength", "correction"), _NUMBER_OR_NULL)
    rest: Schema = {"kind": _kinds(), "convention": _TEXT, "converges": {"type": "boolean"}}
    return _table(numbers | unknown | rest, "the pressure at an end of the contact, in mm and MPa")


def _for_older_programs(schema: Any) -> Any:
    """Return a schema that says its constants in the words of draft 4, too: what Taplo knows."""
    if isinstance(schema, dict):
        found = {key: _for_older_programs(value) for key, value in schema.items()}
        return found | ({"enum": [found["const"]]} if "const" in found and not isinstance(found["const"], dict) else {})
    return [_for_older_programs(each) for each in schema] if isinstance(schema, list) else schema
