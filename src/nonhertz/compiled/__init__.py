"""How Numba is used: one decorator for all functions that are compiled to machine code.

What Python calls is compiled with all that it calls, and kept on disk. Numba, whose import takes longer than solving a
contact, is imported when the first function is called.
"""

from __future__ import annotations

import functools
import os
import threading
from collections.abc import Callable
from typing import Any, TypeVar, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

Function = TypeVar("Function", bound=Callable[..., object])

#: Nothing is fused: what is depends on the module around it, and last digits on whether it was compiled or loaded.
OPTIONS: dict[str, Any] = {"nogil": True, "error_model": "numpy"}
#: What to call before a function is compiled, which takes a minute for all of them: whoever waits may be told.
WHEN_COMPILING: list[Callable[[], None]] = []
_lock = threading.RLock()


def compiled(function: Function, inline: str = "never") -> Function:
    """Compile ``function`` to machine code when it is first called, unless ``NUMBA_DISABLE_JIT`` is set."""
    disabled = os.environ.get("NUMBA_DISABLE_JIT", "0") not in {"", "0"}
    return function if disabled else cast(Function, Compiled(function, inline))


def inlined(function: Function) -> Function:
    """As `compiled`, for a long function called in one place: it would be optimised again with each caller above."""
    return compiled(function, "always")


def plain_array(values: ArrayLike) -> NDArray[np.float64]:
    """Return numbers as an array in C order that can be written to, a copy only if they are none.

    Functions are compiled once for such arrays, and for half a minute more for each other kind that comes from Python.
    """
    return np.require(values, np.float64, ["C", "W"])


class Compiled:
    """A function that waits for Numba until it is called."""

    def __init__(self, function: Callable[..., Any], inline: str) -> None:
        functools.update_wrapper(self, function)
        self.py_func, self.targetoptions = function, {"inline": inline}  # by their names in Numba, which looks for them
        self._made: dict[str, Any] = {}

    def __call__(self, *arguments: Any) -> Any:
        """Run the machine code."""
        made = self._made.get("Python")
        return (made or self.dispatcher("Python"))(*arguments)

    def dispatcher(self, caller: str) -> Any:
        """Return Numba's function for calls from Python, or from compiled functions."""
        with _lock:
            if caller not in self._made:
                wrapped = caller == "Python"
                more = {"no_cpython_wrapper": not wrapped, "no_cfunc_wrapper": not wrapped}
                self._made[caller] = numba_for_us().njit(**OPTIONS, **more)(self.py_func)
                if wrapped:
                    from nonhertz.compiled.cache import Cache

                    self._made[caller]._cache = Cache(self.py_func)
            return self._made[caller]


@functools.cache
def numba_for_us() -> Any:
    """Return Numba, set for this package; from now on it compiles calls of `Compiled` functions, whoever calls them."""
    # Four polynomials in one variable become one vector instruction a step, which makes influence three times as fast.
    os.environ.setdefault("NUMBA_SLP_VECTORIZE", "1")
    import numba
    from numba.extending import typeof_impl

    typeof_impl.register(Compiled)(lambda function, context: typeof_impl(function.dispatcher("Numba"), context))
    return numba
