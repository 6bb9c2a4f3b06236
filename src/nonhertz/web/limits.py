"""Limits on what the page accepts, so that an answer never takes long, and their messages."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, Final

from nonhertz.errors import InputError
from nonhertz.files.held import OF_BEARINGS
from nonhertz.files.mistakes import Place, case_error, path_of

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

ANSWER_SECONDS: Final = 60.0
"""Time limit of an answer: the page says that it waits, and nothing is worked out for one who has gone."""
GRACE_SECONDS: Final = 6.0
"""After which a quick answer is given up for which nobody waits: a roller of a new shape takes two seconds."""
CURVE_SECONDS: Final = 0.5
"""After which no further point of a curve is begun."""
CURVE_POINTS: Final = 12
"""In one request."""
HEAD_SECONDS: Final = 20.0
"""Time limit for the headers of a request to arrive."""
BODY_SECONDS: Final = 10.0
REPORT_SECONDS: Final = 120.0
"""Time limit of a report or a picture, which has a process of its own."""
WAITING_SECONDS: Final = 0.5
WAITING_REQUESTS: Final = 8

_ELSEWHERE = "use the command line for more"
_BODIES: Final = (("body", "a"), ("body", "b"), *((name,) for name in OF_BEARINGS[1:]))
_BOUNDS: Final[Mapping[Place, int]] = {
    ("solver", "strips"): STRIPS,
    ("bearing", "rollers"): ROLLERS,
    **dict.fromkeys((("solver", "laminae"), ("life", "laminae")), LAMINAE),
    **{(*body, "images"): IMAGES for body in _BODIES},
}


def refuse(mistakes: list[InputError]) -> None:
    """Raise `CaseError` if there are mistakes."""
    if mistakes:
        raise case_error(mistakes)


def unfit(document: dict[str, Any]) -> list[InputError]:
    """Return where a document has more entries than the page accepts, or values that no file can hold."""
    return [*too_long(document), *_absent(document, ())]


def too_slow(document: dict[str, Any]) -> list[InputError]:
    """Return where a valid case or bearing asks for more work than the page does while the user waits."""
    found = []
    for place, most in _BOUNDS.items():
        value = _at(document, *place)
        cheap = place[-1] == "laminae" and "bearing" not in document  # those of a single contact
        if isinstance(value, int | float) and value > most and not cheap:
            found.append(InputError(path_of(place), value, f"be at most {most} on the page", _ELSEWHERE))
    return found


def too_long(document: dict[str, Any]) -> list[InputError]:
    """Return where a document has more entries than a form can show."""
    found = [*_long_tables(document, ())]
    lists = {(*body, "profile"): (PROFILES, "profiles") for body in _BODIES} | {
        ("life", "spectrum"): (SPECTRUM, "rows")
    }
    for place, (most, what) in lists.items():
        entries = _at(document, *place)
        if isinstance(entries, list) and most < len(entries) <= POINTS:
            found.append(_too_long(place, entries, most, what))
    return found


def _long_tables(value: Any, place: Place) -> Iterator[InputError]:
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


def _absent(value: Any, place: Place) -> Iterator[InputError]:
    """Yield a mistake for each null, which exists in JSON but not in TOML."""
    if value is None:
        yield InputError(path_of(place), None, "be a number, text or a table", "leave the key out")
    elif isinstance(value, dict):
        for name, entry in value.items():
            yield from _absent(entry, (*place, name))
    elif isinstance(value, list):
        for number, entry in enumerate(value, start=1):
            yield from _absent(entry, (*place, number))


def _at(value: Any, *names: str | int) -> Any:
    for name in names:
        value = value.get(name) if isinstance(value, dict) else None
    return value


def _too_long(place: Place, value: Any, most: int, what: str) -> InputError:
    # The whole document has no name to begin the sentence with.
    return InputError(path_of(place or ("case",)), value, f"have at most {most} {what} on the page", _ELSEWHERE)
