"""Answers in the form that the page reads: JSON with a flag, and sentences with their fields."""

from __future__ import annotations

import functools
import json
import time
import warnings
from collections.abc import Callable, Iterable
from typing import Any, Concatenate, ParamSpec, TypeVar

import numpy as np
from starlette.responses import Response

from nonhertz.errors import CaseError, ConvergenceError, InputError
from nonhertz.files.results import plain
from nonhertz.show.key_numbers import KeyNumber
from nonhertz.verdict import Verdict

First = TypeVar("First")
More = ParamSpec("More")

_UNHEARD = (403, 408, 413, 415, 431)
#: Where the form shows errors about both bodies.
_FIELDS = {"profile": "body.a.profile"}


class Refusal(bytes):
    """JSON of mistakes, in place of an answer or a file."""


def job(make: Callable[Concatenate[First, More], Any]) -> Callable[Concatenate[First, More], bytes]:
    """Return a job that sends the result of a function: bytes unchanged, an answer as JSON, mistakes as a refusal.

    Warnings, such as those about overflow, are kept off the terminal: the answer shows their effect.
    """

    @functools.wraps(make)
    def done(document: First, /, *more: More.args, **named: More.kwargs) -> bytes:
        begun = time.perf_counter()
        with warnings.catch_warnings(), np.errstate(all="ignore"):
            warnings.simplefilter("ignore")
            try:
                made = make(document, *more, **named)
            except CaseError as error:
                return Refusal(as_bytes(misfit(error)))
            except ConvergenceError as error:
                return Refusal(as_bytes(broken([("load", str(error))])))
            except InputError as error:
                return Refusal(as_bytes(broken([("", str(error))])))
        if isinstance(made, bytes):
            return made
        if not made["ok"]:
            return Refusal(as_bytes(made))
        return as_bytes(made | {"ms": round(1e3 * (time.perf_counter() - begun), 1)})

    return done


def as_bytes(value: Any) -> bytes:
    """Return JSON without blanks; raise for a non-finite number, which would be a bug."""
    return json.dumps(value, allow_nan=False, separators=(",", ":")).encode()


def reply(value: Any, status: int = 200, headers: dict[str, str] | None = None) -> Response:
    """Return a JSON answer."""
    return Response(as_bytes(value), status, headers, "application/json")


def refusal(status: int, sentence: str) -> Response:
    """Return an answer of one sentence that is not about any field.

    If the request may be repeated, the answer says when. An answer given before the request was fully read closes the
    connection, so that the rest need not be read.
    """
    headers = {"Retry-After": "1"} if status == 503 else {"Connection": "close"} if status in _UNHEARD else None
    return reply(broken([("", sentence)]), status, headers)


def verdict_seen(verdict: Verdict | None) -> dict[str, str] | None:
    """Return a verdict for a page; None if there is none."""
    if verdict is None:
        return None
    return {
        "level": verdict.level.name.lower(),
        "words": verdict.words,
        "sentence": verdict.sentence,
    }


def number_seen(number: KeyNumber) -> dict[str, Any]:
    """Return a key figure for a page: as text, and as a number in its own unit for differences."""
    value, unit = number.shown
    shown = {"name": number.name, "value": value, "unit": unit, "where": number.where}
    return shown | {"number": plain(number.amount.values[0]), "under": number.under}


def broken(mistakes: Iterable[tuple[str, str]]) -> dict[str, Any]:
    """Return the answer that a case cannot be solved, from pairs of a field's path and a sentence."""
    return {"ok": False, "mistakes": [{"path": path, "sentence": sentence} for path, sentence in mistakes]}


def misfit(error: CaseError) -> dict[str, Any]:
    """Return the mistakes in a case, each with its field."""
    return broken(
        (_FIELDS.get(place, place), sentence) for place, sentence in zip(error.places, error.mistakes, strict=True)
    )
