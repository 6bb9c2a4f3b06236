"""Mistakes in a case file, each with its place, in the package's own wording.

pydantic walks a file's tables and collects what its validators reject; here its findings become sentences in
the form of `InputError`, so that a file and a Python call get the same messages.
"""

from __future__ import annotations

import difflib
import json
import re
import sys
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any, get_args

from pydantic import BaseModel, ValidationError

from nonhertz.errors import CaseError, InputError
from nonhertz.io.bounds import MISTAKES

Place = tuple[str | int, ...]

_LONGEST_KEY = 60
_BARE_KEY = re.compile(r"[A-Za-z0-9_-]+")


class InFile(str):
    """A place inside a file that a key names; not a key itself."""

    __slots__ = ()


@dataclass(frozen=True)
class Mistake:
    """One thing that is wrong, at a place in the file.

    Parameters
    ----------
    place : tuple of str and int
        Keys from the outside in; positions in lists count from 1.
    error : InputError
        The error. Its field name is replaced by the place.
    absent : bool
        Whether there is no value to show, because the key is missing.
    """

    place: Place
    error: InputError
    absent: bool = False

    def within(self, place: Place) -> Mistake:
        """Return the same mistake with its place inside ``place``."""
        return Mistake((*place, *self.place), self.error, self.absent)

    @property
    def sentence(self) -> str:
        """What the user reads."""
        path = path_of(self.place)
        if self.absent:
            return f"{path} must {self.error.condition}: {self.error.remedy}."
        return str(InputError(path, self.error.value, self.error.condition, self.error.remedy))


class TableError(ValueError):
    """Several mistakes in one part of a file, raised by a validator that found more than one."""

    def __init__(self, mistakes: Iterable[Mistake]) -> None:
        self.mistakes = tuple(mistakes)
        super().__init__(self.mistakes)

    def __str__(self) -> str:
        # pydantic calls this at every level of the file but never shows it, so the values are not formatted.
        return f"{len(self.mistakes)} mistakes"


def case_error(mistakes: Iterable[Mistake]) -> CaseError:
    """Return one error for several mistakes, each with its key; beyond the limit they are only counted."""
    found = tuple(mistakes)
    listed, rest = found[:MISTAKES], len(found) - MISTAKES
    sentences, places = [mistake.sentence for mistake in listed], [path_of(mistake.place) for mistake in listed]
    if rest > 0:
        sentences.append(f"There are {rest} more mistakes." if rest > 1 else "There is one more mistake.")
        places.append("")
    return CaseError(sentences, places)


def path_of(place: Place) -> str:
    """Return a place as a readable path.

    Examples
    --------
    >>> path_of(("body", "a", "profile", 1, "radius"))
    'body.a.profile[1].radius'
    """
    path = ""
    for part in place:
        if isinstance(part, int):
            path += f"[{part}]"
        elif isinstance(part, InFile):
            path += f", {part}"
        else:
            shown = part if len(part) <= _LONGEST_KEY else part[: _LONGEST_KEY - 3] + "..."
            path += ("." if path else "") + (shown if _BARE_KEY.fullmatch(shown) else json.dumps(shown))
    return path


def in_order(mistakes: Iterable[Mistake], document: dict[str, Any]) -> list[Mistake]:
    """Return mistakes in the order of their places in the file; missing keys come after those present."""
    # Each table is numbered once: searching it for every key would take quadratic time.
    numbered: dict[int, dict[str, int]] = {}

    def position(mistake: Mistake) -> tuple[int, ...]:
        positions: list[int] = []
        value: Any = document
        for part in mistake.place:
            if isinstance(value, dict) and part in value:
                if id(value) not in numbered:
                    numbered[id(value)] = {key: number for number, key in enumerate(value)}
                positions.append(numbered[id(value)][str(part)])
                value = value[part]
            elif isinstance(value, list) and isinstance(part, int):
                positions.append(part)
                value = value[part - 1]
            else:
                return (*positions, sys.maxsize)
        return tuple(positions)

    return sorted(mistakes, key=position)


def nearest(word: str, known: Iterable[str]) -> str | None:
    """Return the known word closest to ``word``, None if none is close."""
    spelled = {name.lower(): name for name in known}
    begun = [name for name in spelled if len(word) > 2 and name.startswith(word.lower())]
    matches = difflib.get_close_matches(word.lower(), spelled, n=1) or (begun if len(begun) == 1 else [])
    return spelled[matches[0]] if matches else None


def unknown(
    field: str, value: object, what: str, word: object, known: Iterable[str], otherwise: str = ""
) -> InputError:
    """Return the error for a word, or another value in its place, that is not known; it suggests the closest match.

    Where there is none it lists all that are known, or says ``otherwise`` where these are too many.
    """
    known = tuple(known)
    match = nearest(word, known) if isinstance(word, str) else None
    others = otherwise or "choose from " + ", ".join(f"'{name}'" for name in known)
    remedy = f"the nearest is '{match}'" if match else others
    return InputError(field, value, f"be a known {what}", remedy)


def missing(place: Place, remedy: str) -> Mistake:
    """Return the mistake of leaving out a required key."""
    return Mistake(place, InputError("", None, "be given", remedy), absent=True)


def mistake_in(field: str, error: InputError, value: object) -> Mistake:
    """Return the mistake found by a field's own check, with text shown as the user wrote it."""
    shown = value if isinstance(value, str) else error.value
    place = (field,) if error.field == field else (field, error.field)
    # TOML has no null, so None means that the key is missing.
    return Mistake(place, InputError(error.field, shown, error.condition, error.remedy), absent=shown is None)


def mistakes_in(error: ValidationError, table: type[BaseModel]) -> list[Mistake]:
    """Return what pydantic found wrong with a table, in the package's wording.

    A missing key is not reported where an unknown one looks like it: that is one mistake, not two.
    """
    found: list[Mistake] = []
    misspelled: set[Place] = set()
    for item in error.errors(include_url=False):
        place: Place = tuple(part + 1 if isinstance(part, int) else part for part in item["loc"])
        if item["type"] == "missing":
            found.append(missing(place, _way_out(table, place)))
        elif item["type"] == "extra_forbidden":
            known = _table_at(table, place[:-1]).model_fields
            word = str(place[-1])
            found.append(Mistake(place, unknown(word, item["input"], "key", word, known)))
            misspelled.add((*place[:-1], nearest(word, known) or word))
        else:
            found.extend(_from_pydantic(item, place))
    return [mistake for mistake in found if not (mistake.absent and mistake.place in misspelled)]


def _from_pydantic(item: Any, place: Place) -> list[Mistake]:
    value = item["input"]
    match item["type"]:
        case "model_type" | "model_attributes_type" | "dict_type":
            remedy = f"write it under a heading [{path_of(place)}]"
            return [Mistake(place, InputError("", value, "be a section", remedy))]
        case "string_type":
            return [Mistake(place, InputError("", value, "be text", "put it in quotes"))]
    raised = item.get("ctx", {}).get("error")
    if isinstance(raised, TableError):
        return [mistake.within(place) for mistake in raised.mistakes]
    if isinstance(raised, InputError):
        if place and raised.field == place[-1]:
            return [mistake_in(raised.field, raised, value).within(place[:-1])]
        return [Mistake((*place, raised.field), raised)]
    raise AssertionError(f"no words for pydantic's {item['type']!r} at {path_of(place)}")


def _table_at(table: type[BaseModel], place: Place) -> type[BaseModel]:
    for part in place:
        (table,) = _tables_in(table.model_fields[str(part)].annotation)
    return table


def _way_out(table: type[BaseModel], place: Place) -> str:
    field = _table_at(table, place[:-1]).model_fields[str(place[-1])]
    if not _tables_in(field.annotation):
        return f"give {field.description}"
    inner = _table_at(table, place).model_fields
    needed = [name for name, each in inner.items() if each.is_required() and _tables_in(each.annotation)]
    headings = [f"[{path_of((*place, name))}]" for name in needed]
    return "write it under a heading " + (" and ".join(headings) or f"[{path_of(place)}]")


def _tables_in(annotation: object) -> list[type[BaseModel]]:
    """Return the class of a table that may be given, in a list that is empty if this is none."""
    kinds = get_args(annotation) or (annotation,)  # of a table that may be left out, or None
    return [kind for kind in kinds if isinstance(kind, type) and issubclass(kind, BaseModel)]
