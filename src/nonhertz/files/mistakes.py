"""Mistakes in a file, each with its place: sentences in the form of `InputError`, as a Python call gets them."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any, TypeVar

from nonhertz.errors import CaseError, InputError
from nonhertz.files.bounds import MISTAKES, walk

Place = tuple[str | int, ...]
Read = TypeVar("Read")

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
        return f"{len(self.mistakes)} mistakes"


def one_by_one(entries: Iterable[Any], read: Callable[[int, Any], Read]) -> list[Read]:
    """Return what is read of the entries of a list, each given with its number from 1.

    Raises
    ------
    TableError
        With the mistakes of all of them.
    """
    found: list[Read] = []
    mistakes: list[Mistake] = []
    for number, entry in enumerate(entries, start=1):
        try:
            found.append(read(number, entry))
        except TableError as error:
            mistakes += (mistake.within((number,)) for mistake in error.mistakes)
    if mistakes:
        raise TableError(mistakes)
    return found


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
    numbers = {place: number for number, (place, _) in enumerate(walk(document))}

    def position(mistake: Mistake) -> list[float]:
        return [numbers.get(mistake.place[:length], math.inf) for length in range(1, len(mistake.place) + 1)]

    return sorted(mistakes, key=position)


def missing(place: Place, remedy: str) -> Mistake:
    """Return the mistake of leaving out a required key."""
    return Mistake(place, InputError("", None, "be given", remedy), absent=True)
