"""The input for one key of a file, with its value in it."""

from __future__ import annotations

import contextlib
import json
import math
from dataclasses import MISSING, replace
from typing import Any, Final

from nonhertz.amounts import amount
from nonhertz.errors import InputError
from nonhertz.files.keys import Key
from nonhertz.files.mistakes import Place, path_of
from nonhertz.inputs.fields import (
    Count,
    Custom,
    Described,
    Flag,
    OrFlag,
    Part,
    Quantities,
    Quantity,
    Several,
    Word,
    text_of,
)
from nonhertz.inputs.units import in_unit
from nonhertz.web.form.fields import FormField, Option, number_or_words, options_of, text_in
from nonhertz.web.form.ranges import Range
from nonhertz.web.form.units import units_of

ABSENT: Final = object()
"""Stands for the value of a missing key."""

_LONG_LIST: Final = 24
_LONG_TEXT: Final = 1000


def input_for(key: Key, value: Any, place: Place, range_: Range | None) -> FormField:
    """Return the input for a value other than a table, with a slider of a range if it is a quantity."""
    each = key.each
    made = FormField(path_of(place), label_of(place), "text", "", text_of(each), default=_default(key))
    words = options_of(_words(each))
    match each:
        case Word() | Part() if words:
            made = replace(made, kind="choice", options=words)
        case Flag():
            made = replace(made, kind="boolean", options=options_of(("true", "false")))
        case Several() | Quantities():
            made = replace(made, kind="list", unit=getattr(each, "unit", ""), options=words)
        case OrFlag():
            made = replace(made, kind="json", options=options_of(("true", "false", *_words(each.each))))
        case Custom():
            made = replace(made, kind="json")
        case Quantity() | Count():
            made = replace(
                made, kind="integer-or-word" if words else "quantity", unit=getattr(each, "unit", ""), options=words
            )
    return _filled(made, value, range_, next(str(part) for part in reversed(place) if isinstance(part, str)))


def _words(each: Described) -> tuple[str, ...]:
    """Return the words that may stand for a value."""
    one = each.each if isinstance(each, Several) else each
    return tuple(one.named if isinstance(one, Part) else getattr(one, "words", ()))


def _default(key: Key) -> str:
    """Return the default of a key as text; empty if there is no single value."""
    named = key.each.named if isinstance(key.each, Part) else {}
    usual = next((word for word, known in named.items() if known == key.usual), key.usual)
    if usual is MISSING:
        return ""
    return usual if isinstance(usual, str) else number_or_words(usual) or ""


def _filled(made: FormField, value: Any, range_: Range | None, name: str) -> FormField:
    """Return an input with a value in it, changed to another kind if it cannot hold the value."""
    if made.kind in {"quantity", "integer-or-word"}:
        made = _with_units(replace(made, slider=_slider(made, value, range_)), value, name)
    if value is ABSENT or made.value:
        return made
    text = text_in(made.kind, value)
    if text is None:
        return replace(made, kind="json", value=json.dumps(value), options=(), slider=None, units=())
    of_list = made.kind == "list" and isinstance(value, list) and len(value) > _LONG_LIST
    if of_list or (isinstance(value, str) and len(value) > _LONG_TEXT):
        return replace(made, kind="hidden-json", value=json.dumps(value))
    if made.kind == "choice" and text not in [option.value for option in made.options]:
        return replace(made, value=text, options=(*made.options, Option(text, text)))
    return replace(made, value=text)


def _with_units(made: FormField, value: Any, name: str) -> FormField:
    """Return an input with the units to choose from, and the number in the one in which it is shown."""
    if text_in(made.kind, value) is None and value is not ABSENT:
        return made
    text, word, units = units_of(made.unit, name, None if value is ABSENT else value)
    with contextlib.suppress(ValueError):  # a word
        if word != made.unit and float(made.default):
            made = replace(made, default=f"{amount(float(made.default), made.unit):g}")
    made = replace(made, units=units, word=word)
    if text is None:
        return made
    stands_for = "" if value == (float(text) if word == made.unit else f"{text} {word}") else json.dumps(value)
    return replace(made, value=text, stands_for=stands_for)


def _slider(made: FormField, value: Any, found: Range | None) -> Range | None:
    """Return the range of the slider for a quantity; None where it has none, or no number."""
    if found is None:
        return None
    try:
        number = found.start if value is ABSENT else in_unit(made.path, value, made.unit)
    except InputError:
        return None
    if not isinstance(number, float) or not math.isfinite(number):  # a file may hold NaN
        return None
    found = found.as_read(made.unit)
    return found.mirrored() if found.scale == "log" and number < 0.0 < found.low else found


def stray(value: Any, place: Place) -> FormField:
    """Return a field for an unknown key with its value, which can be edited or removed."""
    return FormField(path_of(place), label_of(place), "json", json.dumps(value), removable=True)


def label_of(place: Place) -> str:
    """Return the label of a field: its key, and the number of a list entry."""
    last = place[-1] if place else ""
    if isinstance(last, int):
        return f"{label_of(place[:-1])} {last}"
    return f"body {last}" if place[:-1] == ("body",) else str(last).replace("_", " ")
