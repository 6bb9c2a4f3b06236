"""What the machine code of a function is made from, as content digests.

The compiler reads the bytecode of a function, the constants in it, and whatever its global names refer to: other
compiled functions, numbers, modules. Digests of all these reflect every change, even one that a file's time does not
show or that was made while the program ran; and they need no list of files.
"""

from __future__ import annotations

import hashlib
import weakref
from collections.abc import Callable, Iterator
from types import BuiltinFunctionType, CodeType, ModuleType
from typing import Any

import numpy as np

_RECURSIVE = "itself"
# Digests of functions when they were first compiled or read in this process. The compiler never looks at them again.
_first_meanings: weakref.WeakKeyDictionary[Callable[..., object], str] = weakref.WeakKeyDictionary()


def lasting_meaning(function: Callable[..., object]) -> str | None:
    """Return a digest of all that ``function`` is made from, or None if a part of it was compiled and then changed."""
    found = meanings(function)
    changed = [each for each, meaning in found.items() if _first_meanings.setdefault(each, meaning) != meaning]
    return None if changed else found[function]


def meanings(function: Callable[..., object]) -> dict[Callable[..., object], str]:
    """Return digests of all compiled functions that ``function`` reaches, and last its own.

    Raises
    ------
    TypeError
        If one of them reads a global name whose contents cannot be determined.
    """
    found: dict[Callable[..., object], str] = {}
    _examine(function, found)
    return {each: found[each] for each in [*(other for other in found if other is not function), function]}


def _examine(function: Any, found: dict[Callable[..., object], str]) -> str:
    if function not in found:
        found[function] = _RECURSIVE
        values = {name: _contents(name, value, function, found) for name, value in _globals(function)}
        parts = (_code(function.__code__), repr(function.__defaults__), sorted(values.items()))
        found[function] = hashlib.sha256(repr(parts).encode()).hexdigest()
    return found[function]


def _globals(function: Any) -> Iterator[tuple[str, object]]:
    """Yield what the names of a function refer to; attribute names among them do no harm."""
    for name in sorted(set(_names(function.__code__))):
        if name in function.__globals__:
            yield name, function.__globals__[name]
    for name, cell in zip(function.__code__.co_freevars, function.__closure__ or (), strict=True):
        yield name, cell.cell_contents


def _names(code: CodeType) -> Iterator[str]:
    yield from code.co_names
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from _names(constant)


def _code(code: CodeType) -> tuple[object, ...]:
    """Return all of a function's code except its location in a file."""
    constants = [_code(each) if isinstance(each, CodeType) else (type(each), each) for each in code.co_consts]
    return (
        code.co_code, code.co_exceptiontable, code.co_flags, code.co_argcount, code.co_kwonlyargcount,
        code.co_names, code.co_varnames, code.co_freevars, code.co_cellvars, constants,
    )  # fmt: skip


def _contents(name: str, value: Any, function: Any, found: dict[Callable[..., object], str]) -> object:
    if hasattr(value, "py_func"):
        return _examine(value.py_func, found)
    if isinstance(value, tuple):
        return [_contents(name, each, function, found) for each in value]
    if isinstance(value, np.ndarray | np.generic) and not value.dtype.hasobject:
        return str(value.dtype), value.shape, value.tobytes()
    if value is None or isinstance(value, int | float | complex | str | bytes):
        return type(value).__name__, repr(value)
    if isinstance(value, type | BuiltinFunctionType | np.ufunc):
        return getattr(value, "__module__", ""), value.__name__
    # The contents of a module of this package may change while its name stays the same.
    if isinstance(value, ModuleType) and not _akin(value.__name__, function.__module__):
        return value.__name__
    raise TypeError(
        f"{function.__module__}.{function.__qualname__} is compiled and reads {name}, "
        f"a {type(value).__name__}: have it read only numbers, arrays and compiled functions."
    )


def _akin(one: str, other: str) -> bool:
    return one.partition(".")[0] == other.partition(".")[0]
