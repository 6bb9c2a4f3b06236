"""Mistakes in a file: errors whose fields are paths in it, such as ``body.a.profile[1].radius``."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterable, Mapping
from types import MappingProxyType
from typing import Any

from nonhertz.errors import CaseError, InputError, UnknownKeyError
from nonhertz.files.bounds import MISTAKES, walk

#: Keys from the outside in; positions in lists count from 1.
Place = tuple[str | int, ...]

_LONGEST_KEY = 60
_BARE_KEY = re.compile(r"[A-Za-z0-9_-]+")
_PARTS = re.compile(r'("(?:[^"\\]|\\.)*")|\[(\d+)\]|([^.\[\], ]+)')  # of a path: a key in quotes, a position, a key


def case_error(mistakes: Iterable[InputError], document: Mapping[str, Any] = MappingProxyType({})) -> CaseError:
    """Return one error for several mistakes, each with its key; beyond the limit they are only counted.

    Text of the ``document``, such as ``"5 kN"``, is shown as it is written there.
    """
    written = {place: text for place, text in walk(document) if isinstance(text, str)}
    named = [mistake.about(mistake.field, written.get(place_of(mistake.field), mistake.value)) for mistake in mistakes]
    listed, rest = named[:MISTAKES], len(named) - MISTAKES
    sentences, places = [describe_mistake(mistake) for mistake in listed], [mistake.field for mistake in listed]
    if rest > 0:
        sentences.append(f"There are {rest} more mistakes." if rest > 1 else "There is one more mistake.")
        places.append("")
    return CaseError(sentences, places)


def describe_mistake(mistake: InputError) -> str:
    """Return the sentence on a mistake; a missing key has no value to show, since TOML has no null."""
    wordless = mistake.value is None and not isinstance(mistake, UnknownKeyError)
    return f"{mistake.field} must {mistake.condition}: {mistake.remedy}." if wordless else str(mistake)


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
        else:
            shown = part if len(part) <= _LONGEST_KEY else part[: _LONGEST_KEY - 3] + "..."
            path += ("." if path else "") + (shown if _BARE_KEY.fullmatch(shown) else json.dumps(shown))
    return path


def sort_by_place(mistakes: Iterable[InputError], document: dict[str, Any]) -> list[InputError]:
    """Return mistakes in the order of their places in the file; missing keys come after those present."""
    numbers = {place: number for number, (place, _) in enumerate(walk(document))}

    def position(mistake: InputError) -> list[float]:
        place = place_of(mistake.field)
        return [numbers.get(place[:length], math.inf) for length in range(1, len(place) + 1)]

    return sorted(mistakes, key=position)


def place_of(path: str) -> Place:
    """Return the keys and positions of a path.

    Examples
    --------
    >>> place_of("life.spectrum[2].axial")
    ('life', 'spectrum', 2, 'axial')
    """
    parts = _PARTS.findall(path)
    return tuple(json.loads(quoted) if quoted else int(number) if number else key for quoted, number, key in parts)


def missing_key_error(path: str, remedy: str) -> InputError:
    """Return the mistake of leaving out a required key."""
    return InputError(path, None, "be given", remedy)
