"""Arguments of functions that are refused, named as the options that people type."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator

from nonhertz.errors import InputError


@contextlib.contextmanager
def named_as(**options: str) -> Iterator[None]:
    """Name refused arguments by their options, such as ``threads="--workers"``; others keep their names."""
    try:
        yield
    except InputError as error:
        if error.field not in options:
            raise
        raise InputError(options[error.field], error.value, error.condition, error.remedy) from None
