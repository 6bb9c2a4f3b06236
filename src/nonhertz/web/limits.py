"""Limits on what the page accepts, so that an answer never takes long, and their messages."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any, Final

from nonhertz.errors import InputError
from nonhertz.files.bounds import walk
from nonhertz.files.mistakes import Place, case_error, path_of
from nonhertz.files.toml import OF_BEARINGS

DOCUMENT_BYTES: Final = 256 * 1024
UPLOAD_BYTES: Final = 2 * 1024 * 1024
UPLOAD_POINTS: Final = 30_000
"""Points of a measured file, before its steps; neighbours are averaged if there are more."""
HEADER_BYTES: Final = 32 * 1024

STRIPS: Final = 300
IMAGES: Final = 10
"""At both limits above, a case takes a quarter of a second; the time grows as strips cubed and linearly with images."""
PROFILES: Final = 20
SPECTRUM: Final = 30
POINTS: Final = 2000
KEYS: Final = 40

ROLLERS: Final = 100
"""Rollers in a row of a bearing."""
LAMINAE: Final = 200

ANSWER_SECONDS: Final = 60.0
"""Time limit of an answer; the page shows that it is waiting, and answers for closed pages are given up."""
GRACE_SECONDS: Final = 6.0
"""Time after which a quick answer that nobody waits for is given up: a roller of a new shape takes two seconds."""
CURVE_SECONDS: Final = 0.5
"""Time after which no further point of a curve is started."""
CURVE_POINTS: Final = 12
"""Points of a curve in one request."""
HEAD_SECONDS: Final = 20.0
"""Time limit for the headers of a request to arrive."""
BODY_SECONDS: Final = 10.0
REPORT_SECONDS: Final = 120.0
"""Time limit of a report or a picture, which has a process of its own."""
WAITING_SECONDS: Final = 60.0
WAITING_REQUESTS: Final = 8
"""Time that requests wait for a process, and the largest number of requests that wait."""

_MOST_BITS: Final = 1023
_ELSEWHERE = "use the command line for more"
_BODIES: Final = (("body", "a"), ("body", "b"), *((name,) for name in OF_BEARINGS[1:]))
#: The largest numbers, and the longest lists with the names of their items.
_BOUNDS: Final[Mapping[Place, int]] = {
    ("solver", "strips"): STRIPS,
    ("bearing", "rollers"): ROLLERS,
    **dict.fromkeys((("solver", "laminae"), ("life", "laminae")), LAMINAE),
    **{(*body, "images"): IMAGES for body in _BODIES},
}
_LISTS: Final[Mapping[Place, tuple[int, str]]] = {
    ("life", "spectrum"): (SPECTRUM, "rows"),
    **{(*body, "profile"): (PROFILES, "profiles") for body in _BODIES},
}


def refuse(mistakes: list[InputError]) -> None:
    """Raise `CaseError` if there are mistakes."""
    if mistakes:
        raise case_error(mistakes)


def unfit(document: dict[str, Any]) -> list[InputError]:
    """Return errors on more entries than the page accepts, and on null, which exists in JSON but not in TOML."""
    absent = (place for place, value in walk(document) if value is None)
    return [
        *too_long(document),
        *(
            InputError(path_of(missing), None, "be a number, text or a table", "leave the key out")
            for missing in absent
        ),
    ]


def too_slow(document: dict[str, Any]) -> list[InputError]:
    """Return errors on inputs of a valid case or bearing that make the page too slow."""
    errors, values = [], dict(walk(document))
    for place, most in _BOUNDS.items():
        value = values.get(place)
        cheap = place[-1] == "laminae" and "bearing" not in document  # in a single contact
        if isinstance(value, int | float) and value > most and not cheap:
            errors.append(InputError(path_of(place), value, f"be at most {most} on the page", _ELSEWHERE))
    return errors


def too_long(document: dict[str, Any]) -> list[InputError]:
    """Return errors on lists with more entries than a form can show."""
    errors = []
    for place, entry in walk(document):
        most, what = (KEYS, "keys") if isinstance(entry, dict) else (POINTS, "entries")
        if isinstance(entry, list) and len(entry) <= POINTS:
            most, what = _LISTS.get(place, (POINTS, what))
        if isinstance(entry, dict | list) and len(entry) > most:
            # The whole document has no name to begin the sentence with.
            path, condition = path_of(place or ("case",)), f"have at most {most} {what} on the page"
            errors.append(InputError(path, entry, condition, _ELSEWHERE))
    return errors


def is_number(value: int | float) -> bool:
    """Return whether a number is finite and, if an integer, fits into a float."""
    return value.bit_length() <= _MOST_BITS if isinstance(value, int) else math.isfinite(value)
