"""The few conditions that inputs are held to, each ending in one sentence.

Every number is bounded: no length, load or modulus comes near the bounds, and with them products, squares and quotients
of two inputs stay within double precision, so that nothing overflows in silence further down.
"""

from __future__ import annotations

import math
import os
from numbers import Integral

from nonhertz.errors import InputError

LEAST, MOST = 1e-100, 1e100


def above_zero(field: str, value: float, remedy: str) -> None:
    """Refuse anything that is not a positive finite number, and leave its bounds to a caller who knows better ones."""
    _number(field, value, remedy)
    if value <= 0.0:
        raise InputError(field, value, "be positive", remedy)


def _number(field: str, value: float, remedy: str) -> None:
    if isinstance(value, bool) or not _is_number(value) or not math.isfinite(value):
        raise InputError(field, value, "be a finite number", remedy)


def finite(field: str, value: float, remedy: str) -> None:
    """Refuse anything that is not a finite number within bounds."""
    _number(field, value, remedy)
    if abs(float(value)) > MOST:
        raise InputError(field, value, f"not exceed {MOST:g} in size", remedy)


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


def one_of(field: str, value: object, allowed: tuple[str, ...], remedy: str) -> None:
    """Refuse a word that is not on the list."""
    if value not in allowed:
        raise InputError(field, value, "be one of " + ", ".join(repr(word) for word in allowed), remedy)


def thread_count(threads: int | None) -> int:
    """Return a number of threads: that of the cores for None. Refuse anything that is not a whole number above zero."""
    if threads is None:
        return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    if isinstance(threads, bool) or not isinstance(threads, Integral) or threads < 1:
        raise InputError("threads", threads, "be a whole number of at least 1", "leave it out for all cores")
    return int(threads)


def _is_number(value: object) -> bool:
    try:
        float(value)  # type: ignore[arg-type]
    except (TypeError, ValueError, OverflowError):
        return False
    return not isinstance(value, str)
