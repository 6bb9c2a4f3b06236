"""Numba's compiler behind a typed decorator, so that the numerical core stays fully typed.

Numba keeps machine code on disk, but asks only whether the file of a function itself has changed since. Code that
calls into another file would go on with that file's old functions; so all kept code goes as soon as any file with
compiled functions is younger.

Four polynomials of one variable are evaluated by one vector instruction where the compiler may gather such operations.
Numba leaves that off unless an environment variable says otherwise; it is switched on here while functions of this
package are compiled, and for them alone. It makes the influence coefficients three times as fast.
"""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, TypeVar, cast

import numba
import numba.core.config
from numba.core.compiler_lock import global_compiler_lock

# The files with compiled functions.
_COMPILED = (
    "compiled.py",
    "finite.py",
    "strip/*.py",
    *(f"subsurface/{name}.py" for name in ("inside", "rectangles", "strips", "tails")),
)

Function = TypeVar("Function", bound=Callable[..., object])


def compiled(function: Function) -> Function:
    """Compile ``function`` to machine code at its first call and keep the result on disk.

    Multiplications and additions may be fused; nothing else about floating point is relaxed. The global
    interpreter lock is released, so that many solves can share a process.
    """
    made: Any = numba.njit(cache=True, nogil=True, fastmath={"contract"}, error_model="numpy")(function)
    if not hasattr(made, "compile"):  # compilation is switched off, as for measuring coverage
        return cast(Function, made)
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


def _discard_outdated() -> None:
    package = Path(__file__).parent
    # Another process may discard the same files, and an installed package may not be writable.
    with contextlib.suppress(OSError):
        youngest = max(source.stat().st_mtime for pattern in _COMPILED for source in package.glob(pattern))
        kept = list(package.rglob("__pycache__/*.nb[ic]"))
        if any(file.stat().st_mtime < youngest for file in kept):
            for file in kept:
                file.unlink(missing_ok=True)


_discard_outdated()
