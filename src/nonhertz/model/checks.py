"""The few conditions that inputs are held to, each ending in one sentence."""

from __future__ import annotations

import math
import os
from numbers import Integral

from nonhertz.errors import InputError


def finite(field: str, value: float, remedy: str) -> None:
    """Refuse anything that is not a finite number."""
    if isinstance(value, bool) or not _is_number(value) or not math.isfinite(value):
        raise InputError(field, value, "be a finite number", remedy)


def positive(field: str, value: float, remedy: str) -> None:
    """Refuse anything that is not a positive finite number."""
    finite(field, value, remedy)
    if value <= 0.0:
        raise InputError(field, value, "be positive", remedy)


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
