"""The input for one key of a case file, with its value in it."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from typing import Any, Final

from nonhertz.errors import InputError
from nonhertz.inputs.units import in_unit
from nonhertz.io.mistakes import Place, path_of
from nonhertz.result.reading import chosen
from nonhertz.web.form.fields import FormField, Option, Slider, text_of
from nonhertz.web.form.keys import Schema, alternatives, default_of, is_quantity, meaning_of, unit_of, words_for
from nonhertz.web.form.ranges import range_of
from nonhertz.web.form.units import units_of

ABSENT: Final = object()
"""Stands for the value of a missing key."""

_LONG_LIST: Final = 24
_LONG_TEXT: Final = 1000


def input_for(part: Schema, value: Any, place: Place) -> FormField:
    """Return the input for a value other than a table."""
    name = str(place[-1])
    kinds = alternatives(part)
    first = kinds[0]
    words = words_for(name, part)
    made = FormField(path_of(place), label_of(place), "text", "", meaning_of(part), default=default_of(part))
    if first.get("type") == "array":
        made = replace(made, kind="list", unit=unit_of(first.get("items", {})), options=options_of(words))
    elif any(kind.get("type") == "boolean" for kind in kinds):
        alone = len(kinds) == 1
        made = replace(made, kind="boolean" if alone else "json", options=options_of(("true", "false", *words)))
    elif len(kinds) == 1 and not is_quantity(first):
        made = replace(made, kind="choice" if words else "text", options=options_of(words))
    elif all(is_quantity(kind) for kind in kinds):
        made = replace(made, kind="quantity", unit=unit_of(part))
    else:
        made = replace(made, kind="integer-or-word", unit=unit_of(part), options=options_of(words))
    return _filled(made, value, part.get("range", name))


def _filled(made: FormField, value: Any, name: str) -> FormField:
    """Return an input with a value in it, changed to another kind if it cannot hold the value."""
    if made.kind in {"quantity", "integer-or-word"}:
        made = _with_units(replace(made, slider=_slider(name, made.unit, value)), value, name)
    if value is ABSENT or made.value:
        return made
    text = text_of(made.kind, value)
    if text is None:
        return replace(made, kind="json", value=json.dumps(value), options=(), slider=None, units=())
    if _is_long(made.kind, value):
        return replace(made, kind="hidden-json", value=json.dumps(value))
    if made.kind == "choice" and text not in [option.value for option in made.options]:
        return replace(made, value=text, options=(*made.options, Option(text, text)))
    return replace(made, value=text)


def _with_units(made: FormField, value: Any, name: str) -> FormField:
    """Return an input with the units to choose from, and the number in the one in which it is shown."""
    if text_of(made.kind, value) is None and value is not ABSENT:
        return made
    text, units = units_of(made.unit, name, None if value is ABSENT else value)
    word = next((unit.word for unit in units if unit.chosen), "")
    if _is_number(made.default) and word != made.unit:
        made = replace(made, default=chosen()(f"{made.default} {made.unit}"))
    made = replace(made, units=units)
    if text is None:
        return made
    stands_for = "" if value == (float(text) if word == made.unit else f"{text} {word}") else json.dumps(value)
    return replace(made, value=text, stands_for=stands_for)


def _is_number(text: str) -> bool:
    try:
        return float(text) != 0.0
    except ValueError:
        return False


def _is_long(kind: str, value: Any) -> bool:
    of_list = kind == "list" and isinstance(value, list) and len(value) > _LONG_LIST
    return of_list or (isinstance(value, str) and len(value) > _LONG_TEXT)


def _slider(name: str, unit: str, value: Any) -> Slider | None:
    """Return the slider for a quantity, at its present value."""
    absent = value is ABSENT
    try:
        number = 0.0 if absent else in_unit(name, value, unit)
    except InputError:
        return None
    if not isinstance(number, float) or not math.isfinite(number):  # a file may hold NaN
        return None
    found = range_of(name, None if absent else number)
    if found is None:
        return None
    return Slider(found, found.position(found.start if absent else number))


def options_of(words: tuple[str, ...]) -> tuple[Option, ...]:
    """Return words as choices or suggestions."""
    return tuple(Option(word, word) for word in words)


def stray(value: Any, place: Place) -> FormField:
    """Return a field for an unknown key with its value, which can be edited or removed."""
    return FormField(path_of(place), label_of(place), "json", json.dumps(value), removable=True)


def as_it_is(part: Schema, value: Any, place: Place) -> FormField:
    """Return a field for a value in the place of a table."""
    return replace(stray(value, place), help=meaning_of(part))


def label_of(place: Place) -> str:
    """Return the label of a field: its key, and the number of a list entry."""
    last = place[-1] if place else ""
    if isinstance(last, int):
        return f"{label_of(place[:-1])} {last}"
    return f"body {last}" if place[:-1] == ("body",) else str(last).replace("_", " ")
