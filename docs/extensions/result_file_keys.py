"""Every key of the JSON of results in tables, from the tables of keys that write it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

from case_file_keys import CaseFileKeys, list_table

from nonhertz.files.results import Key, ListOf, MapOf
from nonhertz.files.schemas import RESULTS

if TYPE_CHECKING:
    from docutils import nodes
    from sphinx.application import Sphinx

_WORDS = {"boolean": "``true``, ``false``", "integer": "whole number", "string": "text"}
_SEVERAL = {"integer": "whole numbers", "string": "texts", "object": "objects"}


class ResultFileKeys(CaseFileKeys):
    """``.. result-file-keys::``: a section for every result, with a row for every key."""

    def run(self) -> list[nodes.Node]:
        """Return the sections."""
        lines: list[str] = []
        for kind, (meaning, keys, _) in RESULTS.items():
            heading = kind.capitalize().replace("-", " ")
            lines += [heading, "-" * len(heading), "", f"{meaning} ``nonhertz schema {kind}`` prints its schema.", ""]
            for paths, inner in tables(keys):
                lines += [f"In {', '.join(f'``{path}``' for path in paths)}:", ""] if paths else []
                lines += [*list_table(("key", "value", "meaning [unit]"), [*map(row, inner)]), ""]
        return self.parsed(lines)


def tables(keys: tuple[Key, ...]) -> Iterator[tuple[list[str], tuple[Key, ...]]]:
    """Yield the paths of objects that have the same keys, and these keys, outer ones first; of the whole no path."""
    places: dict[tuple[str, ...], tuple[list[str], tuple[Key, ...]]] = {}
    waiting = [("", keys)]
    for place, inner in waiting:
        known = tuple(f"{key.name}: {key.meaning}" for key in inner)
        if known not in places:
            waiting += [(f"{place}.{key.name}".lstrip("."), key.keys) for key in inner if key.keys and key.unit != ""]
        places.setdefault(known, ([], inner))[0].extend([place] if place else [])
    return iter(places.values())


def row(key: Key) -> tuple[str, ...]:
    """Return the row of a key."""
    unit = ", ".join(dict.fromkeys(units(key.unit)))
    value = f"{words(key.holds)}{' or ``null``' * key.nullable}"
    return f"``{key.name}``", value, f"{key.meaning}{f' [{unit}]' if unit else ''}"


def words(holds: Any, *, several: bool = False) -> str:
    """Return in words what a key holds; of numbers null is not told."""
    match holds:
        case ListOf(entry, count):
            return f"list{'s' * several} of {'' if count is None else f'{count} '}{words(entry, several=True)}"
        case MapOf(entry):
            return f"{words('object', several=several)} of {words(entry, several=True)}"
        case {"const": value}:
            return f"``{value}``"
        case list():
            return ", ".join(f'``"{word}"``' for word in holds)
    word = holds if isinstance(holds, str) else "object" if isinstance(holds[0], Key) else "number"
    return (_SEVERAL if several else _WORDS).get(word, "numbers" if several else word)


def units(unit: Any) -> Iterator[str]:
    """Yield the units of a key."""
    if isinstance(unit, Mapping):
        yield from (f"{name}: {word}" for name, word in unit.items())
    elif isinstance(unit, list):
        for part in unit:
            yield from units(part)
    else:
        yield unit or ""


def setup(app: Sphinx) -> dict[str, bool]:
    """Add the directive."""
    app.add_directive("result-file-keys", ResultFileKeys)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
