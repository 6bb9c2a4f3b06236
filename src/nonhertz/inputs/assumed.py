"""Assumptions made where an input is left out, reported with every result that depends on them.

A field is marked `Assumed` beside its description if a usual value instead of its default changes a headline number by
more than 5 %: a pressure, an approach or displacement, the load of a roller, a life or the static safety. A bore,
corner or profile that is left out does not exist; that is not an assumption.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, fields
from typing import Any

from nonhertz.errors import join_words
from nonhertz.findings import Finding, finding

_KIND = "assumed"
_WORDS = "Assumed: {default}. Give {keys} if that is not so: it decides {decides}."


@dataclass(frozen=True)
class Assumed:
    """The assumption made where a field is left out.

    Attributes
    ----------
    default : str
        The default in words.
    decides : str
        The headline numbers that it changes.
    where : callable
        Whether it changes them in this input; may depend on other fields.
    """

    default: str
    decides: str
    where: Callable[[Any], bool] = lambda inputs: True


def collect_assumptions(parts: Mapping[str, Any], document: Mapping[str, Any] | None = None) -> tuple[Finding, ...]:
    """Return the assumptions made in inputs; the same one in several inputs is listed once.

    Parameters
    ----------
    parts : mapping of str to Input
        The inputs by their places, such as ``"body.a"``.
    document : mapping, optional
        Contents of a file: a value in it is not assumed, even if it equals the default.
    """
    keys: dict[tuple[str, str], list[str]] = {}
    for place, part in parts.items():
        table = _table_at(document or {}, place)
        for field in fields(part):
            mark = part.assumptions.get(field.name)
            if mark and field.name not in table and getattr(part, field.name) == field.default and mark.where(part):
                keys.setdefault((mark.default, mark.decides), []).append(f"{place}.{field.name}".removeprefix("."))
    return tuple(
        finding(_KIND, _WORDS, default=default, keys=join_words(names), decides=decides)
        for (default, decides), names in keys.items()
    )


def restore_assumptions(objects: Iterable[Mapping[str, Any]]) -> tuple[Finding, ...]:
    """Return the findings of `collect_assumptions` from a result file."""
    return tuple(finding(_KIND, _WORDS, **entry["numbers"]) for entry in objects)


def _table_at(document: Mapping[str, Any], place: str) -> Mapping[str, Any]:
    """Return the table of a document at a place; an empty one if there is none."""
    table: Any = document
    for name in filter(None, place.split(".")):
        table = table.get(name, {}) if isinstance(table, Mapping) else {}
    return table if isinstance(table, Mapping) else {}
