"""Functions that Numba compiles when they are called from Python, for any types of arguments.

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
from typing import Any

import numba
import numba.core.config
from numba.core.codegen import JITCodeLibrary
from numba.core.compiler_lock import global_compiler_lock

from nonhertz.compiled.kept import Kept
from nonhertz.compiled.notices import patience

OPTIONS: dict[str, Any] = {"nogil": True, "fastmath": {"contract"}, "error_model": "numpy"}
"""What the compiler may do: multiplications and additions may be fused, and divisions by zero give infinities."""


def dispatcher(function: Callable[..., object]) -> Any:
    """Return Numba's dispatcher of ``function``, which keeps machine code on disk."""
    made: Any = numba.njit(**OPTIONS)(function)
    if not hasattr(made, "compile"):  # disabled by Numba's own configuration file
        return made
    made._cache = Kept(function)
    compile_plainly = made.compile

    def compile_alone(signature: Any) -> Any:
        with _settings(made.targetctx.codegen()), patience():
            return compile_plainly(signature)

    made.compile = compile_alone
    return made


@contextlib.contextmanager
def slp_vectorised() -> Iterator[None]:
    """Enable SLP vectorisation; under the compiler's lock, because the setting is global."""
    settings: Any = numba.core.config
    with global_compiler_lock:
        # Numba reads its environment again while it compiles, if that has changed, and would forget what is set here.
        settings.reload_config()
        before = settings.SLP_VECTORIZE
        settings.SLP_VECTORIZE = 1
        try:
            yield
        finally:
            settings.SLP_VECTORIZE = before


@contextlib.contextmanager
def _settings(codegen: Any) -> Iterator[None]:
    """Enable SLP vectorisation and private copies."""
    with slp_vectorised():
        before = codegen._library_class
        codegen._library_class = _OwnCopies
        try:
            yield
        finally:
            codegen._library_class = before


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
