"""Ranges as people write them: ``"0 : 40 kN : 41"``, lowest, highest and how many."""

from __future__ import annotations

import math
from typing import NamedTuple

from nonhertz.amounts import digits
from nonhertz.errors import InputError
from nonhertz.inputs.units import in_unit

MOST_VALUES = 10_000


class Range(NamedTuple):
    """A range of a quantity, in the base unit.

    Attributes
    ----------
    low, high : float
    number : int or None
        How many values there are, if that is written.
    """

    low: float
    high: float
    number: int | None


def range_in(field: str, text: str, unit: str, example: str) -> Range:
    """Return the range that a text stands for.

    Parameters
    ----------
    field : str
        Name of the input, for the message.
    text : str
        Lowest and highest with units, and perhaps how many, with colons between them. Zero needs no unit.
    unit : str
        As for `nonhertz.inputs.units.in_unit`.
    example : str
        A range without a count, for the message.

    Raises
    ------
    InputError
        If the text is no range, is empty, or has too many values.

    Examples
    --------
    >>> range_in("load", "0 : 40 kN : 41", "N", "0:40kN")
    Range(low=0.0, high=40000.0, number=41)
    """
    parts = text.split(":")
    what = "with units, such as" if unit else "such as"
    remedy = f"write lowest and highest {what} {example}, and if you like how many values, {example}:21"
    if len(parts) not in {2, 3}:
        raise InputError(field, text, "be a range", remedy)
    low, high = (number_in(field, part, unit) for part in parts[:2])
    if not low < high:
        condition = f"ascend, not go from {digits(low)} to {digits(high)} {unit}".rstrip()
        raise InputError(field, text, condition, remedy)
    if len(parts) == 2:
        return Range(low, high, None)
    count = parts[2].strip()
    if not count.isascii() or not count.isdigit() or not 2 <= int(count[:9]) <= MOST_VALUES:
        raise InputError(field, text, f"have a whole number from 2 to {MOST_VALUES} as its third part", remedy)
    return Range(low, high, int(count))


def number_in(field: str, text: str, unit: str) -> float:
    """Return a quantity that is written without quotes, in a unit; zero needs none, nor does a plain number.

    Raises
    ------
    InputError
        If it is no such quantity.
    """
    try:
        number = float(text)
    except ValueError:
        number = math.nan
    if number == 0.0:
        return 0.0
    if unit == "":
        if not math.isfinite(number):
            raise InputError(field, text.strip(), "be a plain number", "write it without a unit")
        return number
    try:
        return float(in_unit(field, text, unit))
    except InputError as error:
        # Nothing is in quotes here.
        remedy = f"append a unit, such as {text.strip()}{'mrad' if unit == 'rad' else unit}"
        raise InputError(
            field, text, error.condition, remedy if error.condition == "have a unit" else error.remedy
        ) from None
