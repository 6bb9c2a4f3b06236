"""Numba's compiler behind a typed decorator, so that the numerical core stays fully typed.

Four polynomials of one variable are evaluated by one vector instruction where the compiler may gather such operations.
Numba leaves that off unless an environment variable says otherwise; it is switched on here while functions of this
package are compiled, and for them alone. It makes the influence coefficients three times as fast.
"""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterator
from typing import Any, TypeVar, cast

import numba
import numba.core.config
from numba.core.compiler_lock import global_compiler_lock

from nonhertz.compiled.kept import Kept

Function = TypeVar("Function", bound=Callable[..., object])


def compiled(function: Function) -> Function:
    """Compile ``function`` to machine code at its first call and keep the result on disk.

    Multiplications and additions may be fused; nothing else about floating point is relaxed. The global
    interpreter lock is released, so that many solves can share a process.
    """
    made: Any = numba.njit(nogil=True, fastmath={"contract"}, error_model="numpy")(function)
    if not hasattr(made, "compile"):  # compilation is switched off, as for measuring coverage
        return cast(Function, made)
    made._cache = Kept(function)
    compile_plainly = made.compile

    def compile_gathering(signature: Any) -> Any:
        with _operations_gathered():
            return compile_plainly(signature)

    made.compile = compile_gathering
    return cast(Function, made)


@contextlib.contextmanager
def _operations_gathered() -> Iterator[None]:
    """Let the compiler gather like operations of straight code; under its lock, since the setting is for all."""
    settings: Any = numba.core.config
    with global_compiler_lock:
        before = settings.SLP_VECTORIZE
        settings.SLP_VECTORIZE = 1
        try:
            yield
        finally:
            settings.SLP_VECTORIZE = before
