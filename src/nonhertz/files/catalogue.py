"""A bearing file from the data in a catalogue, with comments on what is estimated."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Mapping, Sequence
from typing import Any, Final

from nonhertz.bearing.bearings import TaperedRollerBearing
from nonhertz.bearing.catalogue import CatalogueGuess, from_catalogue
from nonhertz.bearing.prescribed import BearingLoad
from nonhertz.errors import InputError, join_words
from nonhertz.files.bearingfile import BearingCase
from nonhertz.files.spreads import parse_number
from nonhertz.files.toml import to_toml
from nonhertz.inputs.descriptions import unknown_word_error

#: Symbols of catalogues: the argument of `from_catalogue`, the unit of a plain number, and the meaning.
SYMBOLS: Final = {
    "d": ("bore", "mm", "bore d"),
    "D": ("outside_diameter", "mm", "outside diameter D"),
    "B": ("width", "mm", "width B"),
    "C": ("dynamic", "N", "dynamic load rating C"),
    "C0": ("static", "N", "static load rating C0"),
    "F": ("inner_raceway", "mm", "inner raceway F"),
    "E": ("outer_raceway", "mm", "outer raceway E"),
    "Z": ("rollers", "", "number of rollers Z"),
    "L": ("roller_length", "mm", "roller length L"),
    "alpha": ("contact_angle", "rad", "contact angle"),
    "e": ("limiting_ratio", "", "factor e"),
    "Y": ("axial_factor", "", "factor Y"),
    "clearance": ("clearance", "mm", "clearance"),
}
NEEDED: Final = ("d", "D", "B", "C", "C0")
_ALIKE: Final = {"T": "B"}  # the width of a tapered bearing
_KEPT: Final = ("material", "diameter", "length", "profile", "depth")  # keys of bodies; others have their defaults
_EXAMPLE: Final = "d=30 D=62 B=16 C=44kN C0=36.5kN"
_STEEL, _OF_LOAD, _SPEED, _DIGITS, _COLUMNS = "100Cr6", 0.1, 1000.0, 6, 100


def guess_of_catalogue(stated: Mapping[str, str]) -> CatalogueGuess:
    """Return the bearing that is estimated from the data in a catalogue.

    Parameters
    ----------
    stated : mapping of str to str
        Values by their `SYMBOLS`, with units or in mm, N and rad: d, D, B (T for tapered bearings), C and C0 are
        needed. ``kind`` is ``"cylindrical"`` (default), ``"needle"`` or ``"tapered"``.

    Raises
    ------
    InputError
        If a symbol is unknown, missing or out of range, or no rollers that fit have these ratings.
    """
    stated = {_ALIKE.get(symbol, symbol): value for symbol, value in stated.items()}
    absent = [symbol for symbol in NEEDED if symbol not in stated]
    values = dict(_argument(symbol, value) for symbol, value in stated.items())
    if absent:
        shown = " ".join(f"{symbol}={value}" for symbol, value in stated.items())
        raise InputError("catalogue", shown, f"include {join_words(absent)}", f"add them, as in {_EXAMPLE}")
    try:
        return from_catalogue(**values)
    except InputError as error:
        symbols = {name: symbol for symbol, (name, _, _) in SYMBOLS.items()}
        raise error.about(symbols.get(error.field, error.field), error.value) from None


def _argument(symbol: str, text: str) -> tuple[str, Any]:
    """Return name and value of the argument for a symbol of a catalogue."""
    if symbol == "kind":
        return symbol, text
    if symbol not in SYMBOLS:
        raise unknown_word_error("catalogue", symbol, "symbol", (*SYMBOLS, "kind"))
    name, unit, _ = SYMBOLS[symbol]
    try:
        return name, int(text) if name == "rollers" else float(text)
    except ValueError:
        return name, parse_number(symbol, text, unit)


def text_of_guess(
    guess: CatalogueGuess, title: str = "", bearing: Mapping[str, Any] | None = None, source: str = ""
) -> str:
    """Return the text of a bearing file for a guess; ``bearing`` has further keys of the table of that name."""
    first, *others = guess.sentences
    others += [source] if source else []
    words = [f"For 'nonhertz bearing': {first}. Replace what you know.", *(f"- {sentence}" for sentence in others)]
    words.append(f"- load ({100.0 * _OF_LOAD:g} % of C) and speed are examples: put yours in their place")
    document = guessed_document(guess)
    document["bearing"] |= bearing or {}
    return add_comments(words, document | ({"title": title} if title else {}))


def add_comments(words: Sequence[str], document: Mapping[str, Any]) -> str:
    """Return a bearing file below comments: a sentence, and items that begin with a hyphen."""
    wrapped = (
        line
        for word in (*words, "Numbers are in mm, N, rad and 1/min.")
        for line in textwrap.wrap(word, _COLUMNS, subsequent_indent="  " * (word[0] == "-"))
    )
    return "".join(f"# {line}\n" for line in wrapped) + "\n" + to_toml(dict(document))


def guessed_document(guess: CatalogueGuess) -> dict[str, Any]:
    """Return the contents of the file: values other than defaults, with as many digits as on a drawing."""
    load = {"radial": _OF_LOAD * guess.dynamic, "speed": _SPEED}
    if isinstance(guess.bearing, TaperedRollerBearing):
        # Twice the axial load that keeps the row in contact.
        load["axial"] = 2.0 * math.tan(guess.bearing.nominal_angle) * load["radial"]
    document = BearingCase(
        guess.bearing, BearingLoad(**load), title=guess.sentences[0].partition(" of a ")[2]
    ).own_document
    for name in ("roller", "inner", "outer"):
        body = {key: document[name][key] for key in _KEPT if key in document[name]} | {"material": _STEEL}
        if "profile" in body:
            # Its diameter and length are those of the roller.
            body["profile"] = [{"kind": profile["kind"]} for profile in body["profile"]]
        document[name] = body
    tables = {name: document[name] for name in ("title", "bearing", "roller", "inner", "outer", "load")}
    rounded: dict[str, Any] = _round(tables | {"life": {"dynamic": guess.dynamic, "static": guess.static}})
    return rounded


def _round(value: Any) -> Any:
    if isinstance(value, Mapping):
        return {name: _round(entry) for name, entry in value.items()}
    if isinstance(value, list | tuple):
        return [_round(entry) for entry in value]
    return float(f"{value:.{_DIGITS}g}") if isinstance(value, float) else value
