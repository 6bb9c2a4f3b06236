"""Every key of a case file or a bearing file in tables, from the schema that the program itself checks files with."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from docutils.statemachine import StringList
from sphinx.util.docutils import SphinxDirective

from nonhertz.io.bearingfile import bearing_schema
from nonhertz.io.casefile import schema
from nonhertz.io.profiles import KINDS, Changes, keys_of, meaning_of, needed_keys

if TYPE_CHECKING:
    from docutils import nodes
    from sphinx.application import Sphinx

Schema = dict[str, Any]

NAMES = {"number": "number", "integer": "whole number", "string": "text", "array": "list", "object": "table"}
# Tables that are alike stand once.
_OF_BOTH = {"body.a": "[body.a] and [body.b]", "roller": "[roller], [inner] and [outer]"}
EVERY_PROFILE = tuple(Changes.descriptions)


class CaseFileKeys(SphinxDirective):
    """``.. case-file-keys::``: a section for every table, with a row for every key."""

    def run(self) -> list[nodes.Node]:
        """Return the sections."""
        whole = schema()
        return self.parsed([*_sections(whole), *self._of_profiles()])

    def parsed(self, lines: list[str]) -> list[nodes.Node]:
        """Return the sections in lines of reST."""
        source = StringList(lines, source=self.get_source_info()[0])
        return self.parse_text_to_nodes(source, allow_section_headings=True)

    def _of_profiles(self) -> list[str]:
        head = [
            "Profiles",
            "--------",
            "",
            "What ``profile`` may list; those of the catalogue may have "
            + ", ".join(f"``{key}``" for key in Changes.descriptions)
            + " too.",
            "",
        ]
        return head + _profiles()


class BearingFileKeys(CaseFileKeys):
    """``.. bearing-file-keys::``: the same of a bearing file, whose profiles are those of case files."""

    def run(self) -> list[nodes.Node]:
        """Return the sections."""
        return self.parsed(_sections(bearing_schema()))


def _sections(whole: Schema) -> list[str]:
    lines: list[str] = []
    for heading, table in tables(whole):
        lines += [heading, "-" * len(heading), "", sentence(table.get("description", "")), "", *_keys(table), ""]
    return lines


def tables(whole: Schema) -> Iterator[tuple[str, Schema]]:
    """Yield the heading and the schema of every table of a case file, those in it after those around it."""
    seen: set[str] = set()
    waiting = [("", whole)]
    while waiting:
        place, table = waiting.pop(0)
        if place != "body":  # there are only the two bodies in it
            yield _heading(place), table
        for key, value in table["properties"].items():
            if "properties" in value.get("items", {}):
                waiting.append((f"[{place}.{key}]", value["items"]))
            path = f"{place}.{key}".lstrip(".")
            for name in _tables_in(value):
                if name not in seen and name in whole["$defs"]:
                    seen.add(name)
                    waiting.append((f"[{path}]" if value.get("type") == "array" else path, whole["$defs"][name]))


def _heading(place: str) -> str:
    if not place:
        return "The file"
    return _OF_BOTH.get(place, f"[{place}]")


def _tables_in(value: Any) -> Iterator[str]:
    """Yield the names of the tables that a value refers to, at any depth."""
    if isinstance(value, dict):
        if "$ref" in value:
            yield value["$ref"].rpartition("/")[2]
        for each in value.values():
            yield from _tables_in(each)
    elif isinstance(value, list):
        for each in value:
            yield from _tables_in(each)


def _keys(table: Schema) -> list[str]:
    required = table.get("required", ())
    rows = [
        (f"``{key}``", kind(value), unit(value), _default(value, key in required), value.get("description", ""))
        for key, value in table["properties"].items()
    ]
    return list_table(("key", "value", "unit", "default", "meaning"), rows)


def _profiles() -> list[str]:
    rows = []
    for name in KINDS:
        needed, keys = needed_keys(name), [key for key in keys_of(name) if key not in EVERY_PROFILE]
        must, may = ([f"``{key}``" for key in keys if (key in needed) == wanted] for wanted in (True, False))
        rows.append((f"``{name}``", " ".join(must), " ".join(may), meaning_of(name)))
    return list_table(("kind", "must have", "may have", "meaning"), rows)


def kind(value: Schema) -> str:
    """Return in words what may stand for a key."""
    if "anyOf" in value:
        alternatives = [each for each in value["anyOf"] if each.get("type") != "null"]
        types = {each.get("type") for each in alternatives}
        if unit(value) and types >= {"number", "string"}:
            return "quantity or list of two" if "array" in types else "quantity"
        return " or ".join(dict.fromkeys(kind(each) for each in alternatives))
    if "const" in value:
        return f'``"{value["const"]}"``'
    if "enum" in value:
        return ", ".join(f'``"{each}"``' for each in value["enum"])
    return "table" if "$ref" in value else NAMES.get(value.get("type", ""), "")


def unit(value: Schema) -> str:
    """Return the unit of a plain number, if the schema knows one."""
    return str(value.get("unit") or next((each["unit"] for each in value.get("anyOf", ()) if "unit" in each), ""))


def _default(value: Schema, required: bool) -> str:
    default = value.get("default")
    if required:
        return "must be there"
    if isinstance(default, dict):
        known = {key: each for key, each in default.items() if each is not None}
        return "{ " + ", ".join(f"{key} = {each:g}" for key, each in known.items()) + " }"
    return "" if default in (None, "", []) else f"``{default}``"


def sentence(text: str) -> str:
    """Return a description that begins with a capital and ends with a full stop."""
    return f"{text[:1].upper()}{text[1:].rstrip('.')}."


def list_table(head: tuple[str, ...], rows: list[tuple[str, ...]]) -> list[str]:
    """Return a table in reST."""
    lines = [".. list-table::", "   :header-rows: 1", ""]
    for row in (head, *rows):
        for number, cell in enumerate(row):
            lines.append(f"   {'  ' if number else '* '}- {cell}")
    return lines


def setup(app: Sphinx) -> dict[str, bool]:
    """Add the directive."""
    app.add_directive("case-file-keys", CaseFileKeys)
    app.add_directive("bearing-file-keys", BearingFileKeys)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
