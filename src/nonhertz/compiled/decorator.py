"""Numba's compiler behind a typed decorator, so that the numerical core stays fully typed.

Two compiler settings are changed while functions of this package are compiled, and only then.

*SLP vectorisation.* The four polynomials of one variable are evaluated by single vector instructions if the compiler
may combine such operations. Numba disables that unless an environment variable enables it. It makes the influence
coefficients three times as fast.

*Private copies.* Numba copies whatever a function calls into its module, optimises it there again, and gives the
copies in all modules the same name. At load time, calls are linked to whichever copy came first. Copies
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
    if not hasattr(made, "compile"):  # compilation is disabled, as when measuring coverage
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
    """Enable SLP vectorisation and private copies; under the compiler's lock, because the settings are global."""
    settings: Any = numba.core.config
    with global_compiler_lock:
        before = settings.SLP_VECTORIZE, codegen._library_class
        settings.SLP_VECTORIZE, codegen._library_class = 1, _OwnCopies
        try:
            yield
        finally:
            settings.SLP_VECTORIZE, codegen._library_class = before


class _OwnCopies(JITCodeLibrary):
    """A module whose copies of other functions are private, not linked with those of other modules by name."""

    def _finalize_final_module(self) -> None:
        # A module read from disk has no functions, but has its shared module already.
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
