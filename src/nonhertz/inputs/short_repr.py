"""Values of results as they print: arrays by shape and range, long values by their beginning."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np

from nonhertz.amounts import format_digits

WIDEST = 60  # characters in a value


def shorten(text: str) -> str:
    """Return a text of at most `WIDEST` characters, cut at a word boundary."""
    return text if len(text) <= WIDEST else (text[:WIDEST].rpartition(" ")[0] or text[:WIDEST]) + " ..."


class ShortRepr:
    """A dataclass whose repr has shape and range of arrays, numbers to five digits and long values shortened."""

    def __repr__(self) -> str:
        shown = (field.name for field in dataclasses.fields(self) if field.repr)  # type: ignore[arg-type]
        return f"{type(self).__name__}({', '.join(f'{name}={_field(getattr(self, name))}' for name in shown)})"


def _field(value: Any) -> str:
    if isinstance(value, np.ndarray):
        return _array(value)
    if isinstance(value, float):
        return format_digits(value)
    if isinstance(value, dict):
        return f"{{{', '.join(f'{key!r}: {_field(entry)}' for key, entry in value.items())}}}"
    named = getattr(value, "name", None)
    text = repr(named if isinstance(named, str) and dataclasses.is_dataclass(value) else value)
    first, _, further = text.partition("\n")
    return f"<{first}>" if further else _shorten_value(value, text)


def _shorten_value(value: Any, text: str) -> str:
    """Return the repr of a value without a bracket that does not close."""
    if isinstance(value, ShortRepr) or len(text) <= WIDEST:
        return text
    if dataclasses.is_dataclass(value):
        return f"{type(value).__name__}(...)"
    if isinstance(value, tuple) and dataclasses.is_dataclass(value[0]):
        return f"<{len(value)} {type(value[0]).__name__}>"
    return shorten(text)


def _array(value: Any) -> str:
    shape = " x ".join(map(str, value.shape))
    if value.dtype == bool or not value.size:
        return f"<{shape} {value.dtype}>"
    if not value.ndim:
        return format_digits(float(value))
    known = value[np.isfinite(value)]
    ends = " to ".join(format_digits(float(end), 4) for end in (known.min(), known.max())) if known.size else ""
    return f"<{shape}: {ends}>" if ends else "<nan>"
