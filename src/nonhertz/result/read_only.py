"""Results whose arrays cannot be written to."""

from __future__ import annotations

from dataclasses import fields
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from nonhertz.inputs.short_repr import ShortRepr

Values = TypeVar("Values", bound=NDArray[Any])


class ReadOnly(ShortRepr):
    """A frozen dataclass whose arrays are read-only too, even after unpickling, which drops the flag; a short repr."""

    def __post_init__(self) -> None:
        _freeze_value(vars(self))

    def __getstate__(self) -> dict[str, object]:
        # Cached properties are computed again.
        return {field.name: getattr(self, field.name) for field in fields(self)}  # type: ignore[arg-type]

    def __setstate__(self, state: dict[str, object]) -> None:
        self.__dict__.update(state)
        _freeze_value(state)


def _freeze_value(values: dict[str, object]) -> None:
    for value in values.values():
        if isinstance(value, np.ndarray):
            freeze(value)


def freeze(array: Values) -> Values:
    """Return the array, no longer writeable."""
    array.flags.writeable = False
    return array
