"""A cache of machine code between processes, in place of Numba's own.

Numba checks whether the file of a function has changed, but not the files of the functions that it calls; it needs a
writable folder before anything is compiled; and a damaged file crashes the program. Here anything missing, stale or
damaged is recompiled and replaced.
"""

from __future__ import annotations

import hashlib
import pickle
import platform
from collections.abc import Callable
from typing import Any

import llvmlite
import llvmlite.binding
import numba.core.config
import numpy as np
from numba.core.compiler import CompileResult
from numba.core.serialize import dumps
from numba.core.types import Callable as CallableType

from nonhertz.compiled.folders import UnwritableError, folders, read, write
from nonhertz.compiled.meaning import lasting_meaning
from nonhertz.compiled.notices import warn_unkept
from nonhertz.compiled.origin import ourselves

# Numba settings that change machine code.
_SETTINGS = (
    "OPT", "LOOP_VECTORIZE", "BOUNDSCHECK", "DEBUGINFO_DEFAULT", "ENABLE_AVX", "USING_SVML", "LLVM_REFPRUNE_PASS",
    "LLVM_REFPRUNE_FLAGS",
)  # fmt: skip

# The keys of the symbols loaded in this process. A second symbol of the same name would never be called.
_symbols: dict[str, bytes] = {}


class Kept:
    """The machine code of one function, for any argument types; implements the interface of a Numba cache.

    Parameters
    ----------
    function : callable
        The function in Python.
    """

    def __init__(self, function: Callable[..., object]) -> None:
        self._function = function
        self._keys: dict[Any, bytes] = {}

    @property
    def cache_path(self) -> str:
        """The first folder tried for writing machine code."""
        return str(folders()[0])

    def load_overload(self, signature: Any, target: Any) -> Any:
        """Return what was compiled for a signature, or None if it is missing or damaged."""
        target.refresh()
        key = self._key(signature, target)
        if key is None:
            return None
        self._keys[signature] = key
        content = read(self._name(key), key)
        return None if content is None else _revived(content, key, target)

    def save_overload(self, signature: Any, result: Any) -> None:
        """Write what was compiled for a signature, or log once that it cannot be written."""
        key = self._keys.get(signature)
        if key is None or result.library.has_dynamic_globals:
            return
        _symbols[result.fndesc.llvm_func_name] = key
        try:
            write(self._name(key), key, dumps(result._reduce()))
        except UnwritableError as error:
            warn_unkept(str(error))

    def flush(self) -> None:
        """Do nothing: recompiling replaces what is there."""

    def _name(self, key: bytes) -> str:
        function = f"{self._function.__module__}.{self._function.__qualname__}".replace("<", "").replace(">", "")
        return f"{function}-{hashlib.sha256(key).hexdigest()[:32]}"

    def _key(self, signature: Any, target: Any) -> bytes | None:
        """Return the unique key of this machine code, or None if it cannot be determined."""
        meaning = lasting_meaning(self._function)
        if meaning is None or any(isinstance(each, CallableType) for each in signature):
            return None
        codegen: Any = target.codegen()
        return repr((meaning, signature, codegen.magic_tuple(), _compiler())).encode()


def _compiler() -> tuple[object, ...]:
    settings: Any = numba.core.config
    return (
        platform.python_implementation(), platform.python_version(), np.__version__, numba.__version__,
        llvmlite.__version__, llvmlite.binding.llvm_version_info, ourselves(),
        *(str(getattr(settings, name, None)) for name in _SETTINGS),
    )  # fmt: skip


def _revived(content: bytes, key: bytes, target: Any) -> Any:
    try:
        parts = pickle.loads(content)
        if _symbols.setdefault(parts[1].llvm_func_name, key) != key:
            return None
        return CompileResult._rebuild(target, *parts)
    except Exception:  # noqa: BLE001  (another build of Numba may have written it)
        return None
