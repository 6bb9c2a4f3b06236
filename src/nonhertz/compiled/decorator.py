"""The decorator of the numerical core: a function is compiled when its machine code is needed, not before.

Importing Numba takes longer than solving a contact. So a decorated function only holds its Python function until it is
called from Python, or until Numba meets it while compiling another function.
"""

from __future__ import annotations

import functools
import os
import threading
from collections.abc import Callable
from typing import Any, TypeVar, cast

Function = TypeVar("Function", bound=Callable[..., object])

ENTRIES = "nonhertz"
"""Numba's name for what entries are compiled for."""

_lock = threading.RLock()


def compiled(function: Function) -> Function:
    """Compile ``function`` to machine code when it is first called, and keep the result on disk.

    Multiplications and additions may be fused; nothing else about floating point is relaxed. The global
    interpreter lock is released, so that many solves can share a process.
    """
    return function if is_disabled() else cast(Function, Compiled(function))


def is_disabled() -> bool:
    """Return whether ``NUMBA_DISABLE_JIT`` lets all functions run in Python, as when measuring coverage."""
    return os.environ.get("NUMBA_DISABLE_JIT", "0") not in {"", "0"}


class Compiled:
    """A function with machine code that is made when it is needed.

    Parameters
    ----------
    function : callable
        The function in Python.
    """

    py_func: Callable[..., Any]

    def __init__(self, function: Callable[..., Any]) -> None:
        functools.update_wrapper(self, function)
        self.py_func = function
        self._dispatchers: dict[str, Any] = {}

    def __call__(self, *arguments: Any) -> Any:
        """Run the machine code, with arguments of any types that Numba knows."""
        return self._dispatcher("cpu")(*arguments)

    def __getattr__(self, name: str) -> Any:
        # What is asked of all objects, such as whether they are arrays, must not import Numba.
        if name.startswith("_"):
            raise AttributeError(name)
        return getattr(self._dispatcher("cpu"), name)

    @property
    def _numba_type_(self) -> Any:
        """Tell Numba what a function that it compiles calls here."""
        from numba.core.target_extension import current_target

        return self._dispatcher(current_target())._numba_type_

    def _dispatcher(self, target: str) -> Any:
        found = self._dispatchers.get(target)
        if found is None:
            with _lock:
                found = self._dispatchers.setdefault(target, self._made(target))
        return found

    def _made(self, target: str) -> Any:
        if target == ENTRIES:
            from nonhertz.compiled.target import part

            return part(self.py_func)
        from nonhertz.compiled.dispatching import dispatcher

        return dispatcher(self.py_func)
