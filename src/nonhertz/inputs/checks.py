"""The few conditions that inputs must meet, each with one sentence for the error.

Every number is bounded: no real length, load or modulus comes near the bounds, and within them products, squares and
quotients of two inputs stay within double precision, so that no later calculation overflows.
"""

from __future__ import annotations

import math
import os
import unicodedata
from collections.abc import Callable, Iterable, Mapping
from numbers import Integral
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.errors import InputError, nearest

LEAST, MOST = 1e-100, 1e100


def above_zero(field: str, value: float, remedy: str) -> None:
    """Refuse anything but a positive finite number; the caller checks tighter bounds."""
    _number(field, value, remedy)
    if value <= 0.0:
        raise InputError(field, value, "be positive", remedy)


def _number(field: str, value: float, remedy: str) -> None:
    if not is_number(value) or not math.isfinite(value):
        raise InputError(field, value, "be a finite number", remedy)


def finite(field: str, value: float, remedy: str) -> None:
    """Refuse anything that is not a finite number within bounds."""
    _number(field, value, remedy)
    if abs(float(value)) > MOST:
        raise InputError(field, value, f"not exceed {MOST:g} in magnitude", remedy)


def positive(field: str, value: float, remedy: str) -> None:
    """Refuse anything that is not a positive finite number."""
    above_zero(field, value, remedy)
    finite(field, value, remedy)
    if float(value) < LEAST:
        raise InputError(field, value, f"be at least {LEAST:g}", remedy)


def not_negative(field: str, value: float, remedy: str) -> None:
    """Refuse anything that is not a finite number of at least zero."""
    finite(field, value, remedy)
    if value < 0.0:
        raise InputError(field, value, "not be negative", remedy)


def number_that(
    holds: Callable[[float], bool], condition: str, first: Callable[[str, float, str], object] = finite
) -> Callable[[str, float, str], None]:
    """Return a check that refuses numbers for which a condition is false or which another check refuses."""

    def check(field: str, value: float, remedy: str) -> None:
        first(field, value, remedy)
        if not holds(value):
            raise InputError(field, value, condition, remedy)

    return check


def whole(field: str, value: int, least: int, most: float, remedy: str) -> int:
    """Return a whole number between two others, or refuse anything else."""
    finite(field, value, remedy)
    if value != int(value) or not least <= value <= most:
        bounds = f"from {least} to {most:g}" if math.isfinite(most) else f"of at least {least}"
        raise InputError(field, value, f"be a whole number {bounds}", remedy)
    return int(value)


def numbers(
    field: str, value: ArrayLike, remedy: str, most: float = MOST, unit: str = "in magnitude"
) -> NDArray[np.float64]:
    """Return real numbers as an array; refuse text, booleans, complex numbers, None and anything not finite."""
    try:
        array = np.asarray(value)
    except ValueError:  # nested lists of unequal length
        array = np.asarray(None)
    if array.dtype.kind not in "iuf" or np.ma.isMaskedArray(value):
        raise InputError(field, value, "be real numbers", remedy)
    if not np.all(np.isfinite(array)):
        raise InputError(field, value, "be finite", remedy)
    largest = max(float(array.max()), -float(array.min())) if array.size else 0.0
    if largest > most:
        raise InputError(field, largest, f"not exceed {most:g} {unit}", remedy)
    return array.astype(float, copy=False)


def flag(field: str, value: object, remedy: str) -> None:
    """Refuse anything that is neither True nor False."""
    if not isinstance(value, bool | np.bool_):
        raise InputError(field, value, "be True or False", remedy)


def text(field: str, value: object, remedy: str) -> None:
    """Refuse anything that is not text."""
    if not isinstance(value, str):
        raise InputError(field, value, "be text", remedy)


def check_callback(value: object) -> None:
    """Refuse anything that is neither None nor callable."""
    if value is not None and not callable(value):
        raise InputError("callback", value, "be a function", "give a function, or leave it out")


def check_list(field: str, value: Iterable[Any], condition: str, remedy: str) -> list[Any]:
    """Return the members of a list or another iterable, or refuse anything else, text and mappings included."""
    try:
        return list(None if isinstance(value, str | Mapping) else value)  # type: ignore[arg-type]
    except TypeError:
        raise InputError(field, value, condition, remedy) from None


def one_of(field: str, value: object, allowed: tuple[str, ...], remedy: str) -> None:
    """Refuse a word that is not on the list."""
    if not isinstance(value, str) or value not in allowed:
        match = nearest(value, allowed)
        remedy = f"did you mean '{match}'?" if match else remedy
        raise InputError(field, value, "be one of " + ", ".join(repr(word) for word in allowed), remedy)


def thread_count(threads: int | None) -> int:
    """Return a number of threads, all cores for None; refuse anything that is not a whole number above zero."""
    if threads is None:
        return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    if isinstance(threads, bool) or not isinstance(threads, Integral) or threads < 1:
        raise InputError("threads", threads, "be a whole number of at least 1", "leave it out for all cores")
    return int(threads)


def one_line(field: str, value: Any, remedy: str) -> None:
    """Refuse anything but text without control characters and line breaks, which no table, figure or page can show."""
    text(field, value, "put it in quotes")
    if any(unicodedata.category(character) in {"Cc", "Cs", "Zl", "Zp"} for character in value):
        raise InputError(field, value, "be one line of text without control characters", remedy)


def broadcast(remedy: str, *places: NDArray[np.float64]) -> tuple[NDArray[np.float64], ...]:
    """Return arrays broadcast against each other, read-only; refuse shapes that cannot be broadcast."""
    try:
        shape = np.broadcast_shapes(*(place.shape for place in places))
        return tuple(np.broadcast_to(place, shape) for place in places)
    except ValueError:
        shapes = tuple(place.shape for place in places)
        raise InputError("shapes of the coordinates", shapes, "broadcast against each other", remedy) from None


def is_number(value: object) -> bool:
    """Return whether a value is a number, finite or not, and neither text nor a truth value."""
    if isinstance(value, bool | str):
        return False
    if isinstance(value, np.ndarray) and (value.ndim > 0 or value.dtype.kind not in "iuf"):
        return False  # older NumPy converts some of them to numbers, with a warning
    try:
        float(value)  # type: ignore[arg-type]
    except (TypeError, ValueError, OverflowError):
        return False
    return True
