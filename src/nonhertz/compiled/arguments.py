"""Arguments of machine code: what they consist of, and which of them are types that it takes.

A (nested) tuple is passed as the sequence of its parts. They are arrays of floats, integers or truth values, and single
ones.
"""

from __future__ import annotations

from typing import Any, NamedTuple, TypeAlias

import numpy as np

SCALARS = float, int, bool
ELEMENTS = "float64", "int64", "bool"


class ArrayType(NamedTuple):
    """The type of an array, which is contiguous, with the last index varying fastest."""

    element: str
    dimensions: int


class TupleType(NamedTuple):
    """The type of a tuple: its class, and the types of what it holds."""

    form: type
    parts: tuple[Type, ...]


Type: TypeAlias = "ArrayType | TupleType | type[float] | type[int] | type[bool]"


def flatten(values: Any, arrays: list[Any], numbers: list[Any], classes: list[type | None]) -> None:
    """Append the arrays and the numbers in a tuple, and the classes of all; None stands where a tuple within ends."""
    for value in values:
        kind = type(value)
        classes.append(kind)
        if kind is np.ndarray:
            arrays.append(value)
        elif kind in SCALARS:
            numbers.append(value)
        elif issubclass(kind, tuple):
            flatten(value, arrays, numbers, classes)
            classes.append(None)
        else:
            plain = _plain(value)
            (arrays if isinstance(plain, np.ndarray) else numbers).append(plain)


def type_of(value: Any) -> Type:
    """Return the type that the compiler is told of an argument.

    Raises
    ------
    TypeError
        If machine code cannot take such a value.
    """
    if isinstance(value, tuple):
        return TupleType(type(value), tuple(type_of(each) for each in value))
    value = _plain(value)
    if not isinstance(value, np.ndarray):
        return next(each for each in SCALARS if type(value) is each)
    if value.dtype.name not in ELEMENTS or not value.dtype.isnative:
        raise TypeError(f"Machine code takes arrays of {', '.join(ELEMENTS)}, not of {value.dtype}: convert it.")
    if not (value.flags.c_contiguous and value.flags.aligned):
        raise TypeError(f"Machine code takes contiguous arrays; shape {value.shape}, strides {value.strides}: copy it.")
    return ArrayType(value.dtype.name, value.ndim)


def canonical(array: Any) -> Any:
    """Return an array with the one type number that its elements have: there may be two integers of 64 bits."""
    return array.view(np.dtype(array.dtype.name))


def text(kind: Type) -> str:
    """Return a text that tells types apart, in any process."""
    if isinstance(kind, ArrayType):
        return f"{kind.element}[{kind.dimensions}]"
    if isinstance(kind, TupleType):
        names = getattr(kind.form, "_fields", ("",) * len(kind.parts))
        parts = ",".join(f"{name}:{text(part)}" for name, part in zip(names, kind.parts, strict=True))
        return f"{kind.form.__module__}.{kind.form.__qualname__}({parts})"
    return kind.__name__


def _plain(value: Any) -> Any:
    """Return the same number as one of Python, and the same array without what its class adds."""
    if type(value) is np.ndarray or type(value) in SCALARS:
        return value
    if isinstance(value, np.ndarray):
        return value.view(np.ndarray)
    if isinstance(value, np.float64 | np.integer | np.bool_):
        return value.item()
    raise TypeError(f"Machine code takes arrays, numbers and tuples of these, not a {type(value).__name__}.")
