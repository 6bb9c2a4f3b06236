"""Every key of a case file or a bearing file in tables, from what the fields of inputs say."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import MISSING
from typing import TYPE_CHECKING

from docutils.statemachine import StringList
from sphinx.util.docutils import SphinxDirective

from nonhertz.files.bearing_document import BearingFile
from nonhertz.files.keys import Key, Table, profile_kinds, table_of, unit_of
from nonhertz.files.profiles import Changes
from nonhertz.files.sections import CaseDocument
from nonhertz.inputs.descriptions import (
    Count,
    Custom,
    Flag,
    OneOrTwo,
    Part,
    Quantities,
    Quantity,
    Several,
    Word,
    describe_field,
)

if TYPE_CHECKING:
    from docutils import nodes
    from sphinx.application import Sphinx

# Tables that are alike stand once.
_OF_BOTH = {"body.a": "[body.a] and [body.b]", "roller": "[roller], [inner] and [outer]"}
EVERY_PROFILE = tuple(Changes.descriptions)


class CaseFileKeys(SphinxDirective):
    """``.. case-file-keys::``: a section for every table, with a row for every key."""

    def run(self) -> list[nodes.Node]:
        """Return the sections."""
        return self.parsed([*_sections(table_of(CaseDocument)), *self._of_profiles()])

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
        return self.parsed(_sections(table_of(BearingFile)))


def _sections(whole: Table) -> list[str]:
    lines: list[str] = []
    for heading, table in tables(whole):
        lines += [heading, "-" * len(heading), "", sentence(table.meaning), "", *_keys(table), ""]
    return lines


def tables(whole: Table) -> Iterator[tuple[str, Table]]:
    """Yield the heading of every table of a file and what it may hold, those in it after those around it."""
    seen: set[str] = set()
    waiting = [("", whole)]
    while waiting:
        place, table = waiting.pop(0)
        if place != "body":  # there are only the two bodies in it
            yield _heading(place), table
        for name, key in table.keys.items():
            path = f"{place.strip('[]')}.{name}".lstrip(".")
            for each in key.tables:
                if name != "profile" and each.meaning not in seen:
                    seen.add(each.meaning)
                    waiting.append((f"[{path}]" if key.several and len(key.tables) == 1 else path, each))


def _heading(place: str) -> str:
    if not place:
        return "The file"
    return _OF_BOTH.get(place, f"[{place}]")


def _keys(table: Table) -> list[str]:
    usual = any(each.meaning == table.meaning for each in table.kinds.values())
    head = [("``kind``", _words(table.kinds), "", "" if usual else "must be there", table.meaning_of_kind)]
    rows = [
        (f"``{name}``", kind(key), "" if key.several else unit_of(key), _default(key), describe_field(key.description))
        for name, key in table.keys.items()
    ]
    return list_table(("key", "value", "unit", "default", "meaning"), [*(head if table.kinds else []), *rows])


def _profiles() -> list[str]:
    rows = []
    for table in profile_kinds():
        keys = [name for name in table.keys if name not in EVERY_PROFILE]
        must, may = (
            " ".join(f"``{name}``" for name in keys if (name in table.required) == wanted) for wanted in (True, False)
        )
        rows.append((f"``{table.word}``", must, may, table.meaning))
    return list_table(("kind", "must have", "may have", "meaning"), rows)


def kind(key: Key) -> str:
    """Return in words what may stand for a key."""
    one = key.description.item if isinstance(key.description, OneOrTwo) else key.description
    match one:
        case Quantity() if key.several:
            found = []
        case Quantity():
            found = ["quantity"] if one.unit else [_words(one.words), "number"]
        case Count():
            found = [_words(one.words), "whole number"]
        case Word():
            found = [_words(one.words) or "text"]
        case Quantities():
            found = ["list"]
        case Several():
            found = [] if one.of else ["list"]
        case Flag():
            found = ["``true``, ``false``"]
        case Custom():
            types = [{"string": "text"}.get(each["type"], each["type"]) for each in one.json.get("anyOf", ())]
            found = types or [f"``{one.json['const']}``"]
        case _:
            found = ["text"] if getattr(one, "named", ()) else []
    found += ["table"] if key.tables and not isinstance(one, Several) else []
    found += ["list"] if key.several else []
    found += ["list of two"] if one is not key.description else []
    return " or ".join(filter(None, found))


def _words(words: Iterable[str]) -> str:
    return ", ".join(f'``"{word}"``' for word in words)


def _default(key: Key) -> str:
    if key.usual is MISSING:
        return "must be there"
    named = key.description.named if isinstance(key.description, Part) else {}
    usual = next((word for word, known in named.items() if known == key.usual), key.usual)
    plain = isinstance(usual, str | int | float) and usual not in ("", math.inf)
    return f"``{usual}``" if plain else ""


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
