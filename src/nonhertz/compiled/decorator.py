"""Numba's compiler behind a typed decorator, so that the numerical core stays fully typed.

Two settings of the compiler are changed while functions of this package are compiled, and for them alone.

*Gathered operations.* Four polynomials of one variable are evaluated by one vector instruction where the compiler may
gather such operations. Numba leaves that off unless an environment variable says otherwise. It makes the influence
coefficients three times as fast.

*Nothing shared.* Numba copies whatever a function calls into its module, optimises it there once more, and lets the
copies of all modules share one name. When they are loaded, calls go to the copy that happened to come first. Copies
differ in which multiplication is fused with which addition, so last digits would depend on what the process had
compiled or loaded before. Here each module calls its own copies.
"""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterator
from typing import Any, TypeVar, cast

import numba
import numba.core.config
from numba.core.codegen import JITCodeLibrary
from numba.core.compiler_lock import global_compiler_lock

from nonhertz.compiled.kept import Kept
from nonhertz.compiled.notices import patience

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

    def compile_alone(signature: Any) -> Any:
        with _settings(made.targetctx.codegen()), patience():
            return compile_plainly(signature)

    made.compile = compile_alone
    return cast(Function, made)


@contextlib.contextmanager
def _settings(codegen: Any) -> Iterator[None]:
    """Let the compiler gather and share nothing; under its lock, since the settings are for all."""
    settings: Any = numba.core.config
    with global_compiler_lock:
        before = settings.SLP_VECTORIZE, codegen._library_class
        settings.SLP_VECTORIZE, codegen._library_class = 1, _OwnCopies
        try:
            yield
        finally:
            settings.SLP_VECTORIZE, codegen._library_class = before


class _OwnCopies(JITCodeLibrary):
    """A module whose copies of other functions are its own, and not one of many by the same name."""

    def _finalize_final_module(self) -> None:
        # One that is read from disk comes without functions, but with what others link.
        if self._shared_module is None:
            self._shared_module = _relinked(self._final_module.clone(), "external", "linkonce_odr")
            _relinked(self._final_module, "linkonce_odr", "internal")
        parent: Any = super()
        parent._finalize_final_module()


def _relinked(module: Any, before: str, after: str) -> Any:
    for function in module.functions:
        if not function.is_declaration and function.linkage.name == before:
            function.linkage = after
    return module
