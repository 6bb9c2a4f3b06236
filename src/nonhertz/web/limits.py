"""Limits on what the page accepts, so that an answer never takes long, and their messages."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, Final

from nonhertz.errors import InputError
from nonhertz.files.held import OF_BEARINGS
from nonhertz.files.mistakes import Mistake, Place

DOCUMENT_BYTES: Final = 256 * 1024
UPLOAD_BYTES: Final = 2 * 1024 * 1024
UPLOAD_POINTS: Final = 30_000
"""Of a measured file, before its steps; if there are more, neighbours are averaged."""
HEADER_BYTES: Final = 32 * 1024

STRIPS: Final = 300
IMAGES: Final = 10
"""At both limits above, a case takes a quarter of a second; the time grows as strips cubed and linearly with images."""
PROFILES: Final = 20
SPECTRUM: Final = 30
POINTS: Final = 2000
KEYS: Final = 40

ROLLERS: Final = 100
"""In a row of a bearing."""
LAMINAE: Final = 200

LIVE_SECONDS: Final = 6.0
"""Time limit of a case: a roller of a new shape takes two seconds, on a busy machine twice that."""
CURVE_SECONDS: Final = 0.5
"""After which no further point of a curve is begun; two points take less than the time limit of a case."""
CURVE_POINTS: Final = 12
"""In one request."""
UPLOAD_SECONDS: Final = 1.5
HEAD_SECONDS: Final = 20.0
"""Time limit for the headers of a request to arrive."""
BODY_SECONDS: Final = 10.0
PATIENT_SECONDS: Final = 120.0
STRIPS_SECONDS: Final = 60.0
"""Time limit of a bearing by strips, which are asked for when a slider rests."""
STRENGTH_SECONDS: Final = 60.0
"""Time limit of the search for the largest stresses of a whole body, which is asked for when a slider rests."""
WAITING_SECONDS: Final = 0.5
WAITING_REQUESTS: Final = 8

_ELSEWHERE = "use the command line for more"


def unfit(document: dict[str, Any]) -> list[Mistake]:
    """Return where a document has more entries than the page accepts, or values that no case file can hold."""
    return [*oversizes(document), *_absent(document, ())]


def slow(document: dict[str, Any]) -> list[Mistake]:
    """Return where a valid document asks for more work than the page does while the user waits."""
    bounds: dict[tuple[str, ...], int] = {
        ("solver", "strips"): STRIPS,
        ("body", "a", "images"): IMAGES,
        ("body", "b", "images"): IMAGES,
    }
    return _above(document, bounds)


def slow_bearing(document: dict[str, Any]) -> list[Mistake]:
    """Return the same of a valid bearing file."""
    bounds: dict[tuple[str, ...], int] = {(name, "images"): IMAGES for name in OF_BEARINGS[1:]}
    bounds |= {("bearing", "rollers"): ROLLERS, ("solver", "laminae"): LAMINAE, ("life", "laminae"): LAMINAE}
    return _above(document, bounds)


def _above(document: dict[str, Any], bounds: Mapping[tuple[str, ...], int]) -> list[Mistake]:
    found = []
    for place, most in bounds.items():
        value = _at(document, *place)
        if isinstance(value, int | float) and value > most:
            found.append(Mistake(place, InputError("", value, f"be at most {most} on the page", _ELSEWHERE)))
    return found


def oversizes(document: dict[str, Any]) -> list[Mistake]:
    """Return where a document has more entries than a form can show."""
    found = [*_long_tables(document, ())]
    bodies = [("body", "a"), ("body", "b"), *((name,) for name in OF_BEARINGS[1:])]
    lists = {(*body, "profile"): (PROFILES, "profiles") for body in bodies}
    lists["life", "spectrum", ""] = (SPECTRUM, "rows")
    for names, (most, what) in lists.items():
        place = tuple(filter(None, names))
        entries = _at(document, *place)
        if isinstance(entries, list) and most < len(entries) <= POINTS:
            found.append(_too_long(place, entries, most, what))
    return found


def _long_tables(value: Any, place: Place) -> Iterator[Mistake]:
    if isinstance(value, dict):
        if len(value) > KEYS:
            yield _too_long(place, value, KEYS, "keys")
            return
        for name, entry in value.items():
            yield from _long_tables(entry, (*place, name))
    elif isinstance(value, list):
        if len(value) > POINTS:
            yield _too_long(place, value, POINTS, "entries")
            return
        for number, entry in enumerate(value, start=1):
            yield from _long_tables(entry, (*place, number))


def _absent(value: Any, place: Place) -> Iterator[Mistake]:
    """Yield a mistake for each null, which exists in JSON but not in TOML."""
    if value is None:
        yield Mistake(place, InputError("", None, "be a number, text or a table", "leave the key out"))
    elif isinstance(value, dict):
        for name, entry in value.items():
            yield from _absent(entry, (*place, name))
    elif isinstance(value, list):
        for number, entry in enumerate(value, start=1):
            yield from _absent(entry, (*place, number))


def _at(value: Any, *names: str) -> Any:
    for name in names:
        value = value.get(name) if isinstance(value, dict) else None
    return value


def _too_long(place: Place, value: Any, most: int, what: str) -> Mistake:
    # The whole document has no name to begin the sentence with.
    return Mistake(place or ("case",), InputError("", value, f"have at most {most} {what} on the page", _ELSEWHERE))
