"""Machine code on disk, found by a digest of all that it was made from.

Numba's own cache looks at the file of a function, but not at those of the functions that it calls; it needs a writable
folder before anything is compiled; a damaged file ends the process, and a full disk leaves an old answer behind.
"""

from __future__ import annotations

import functools
import hashlib
import os
import pickle
import sys
from importlib.metadata import version
from types import CodeType, ModuleType
from typing import Any

import numba
import numpy as np
from numba.core.caching import CompileResultCacheImpl
from numba.core.runtime import rtsys  # type: ignore[attr-defined]
from numba.core.serialize import dumps

from nonhertz.compiled import OPTIONS, WHEN_COMPILING, Compiled
from nonhertz.compiled.files import log_once, read, write


class Cache(CompileResultCacheImpl):
    """The machine code of one function, for any types of arguments: what Numba asks of a cache."""

    def __init__(self, function: Any) -> None:
        self._function = function  # Numba's own constructor looks for a folder

    def load_overload(self, signature: Any, target: Any) -> Any:
        """Return what was compiled for a signature, or None if it is missing, damaged or made from something else."""
        content = read(*self._place(signature, target.codegen()))
        if content is not None:
            rtsys.initialize(target)
            return CompileResultCacheImpl.rebuild(self, target, pickle.loads(content))
        for call in WHEN_COMPILING:
            call()
        if hasattr(sys, "ps1") or (sys.stderr is not None and sys.stderr.isatty()):  # in a notebook or at a terminal
            log_once("The first solve on a machine compiles the solver: a minute, or two for a whole bearing.")
        return None

    def save_overload(self, signature: Any, result: Any) -> None:
        """Write what was compiled."""
        write(*self._place(signature, result.codegen), dumps(CompileResultCacheImpl.reduce(self, result)))

    def _place(self, signature: Any, codegen: Any) -> tuple[str, bytes]:
        ours = sorted(each for each in os.environ.items() if each[0].startswith("NUMBA_") and "_DIR" not in each[0])
        versions = sys.version, np.__version__, numba.__version__, version("llvmlite"), codegen.magic_tuple()
        key = repr((stamp(self._function), signature, OPTIONS, ours, versions)).encode()
        # Of any number of versions, the one that was used last and has the same first digit is kept.
        kind = hashlib.sha256(repr(signature).encode()).hexdigest()[:8] + hashlib.sha256(key).hexdigest()[0]
        return f"{self._function.__module__}.{self._function.__name__.strip('<>')}-{kind}", key


@functools.cache
def stamp(function: Any) -> str:
    """Return a digest of a function, of all that it calls, and of the constants and named tuples that they know."""
    # As they are in memory: a file may have been edited since it was imported.
    functions, found = [function], []
    for each in functions:
        codes = [each.__code__]
        for code in codes:
            codes += [part for part in code.co_consts if isinstance(part, CodeType)]
            numbers = tuple(part for part in code.co_consts if not isinstance(part, CodeType))
            names = *code.co_names, *each.__annotations__.values()
            known = tuple(each.__globals__[name] for name in names if name in each.__globals__)
            known += tuple(cell.cell_contents for cell in each.__closure__ or ())
            functions += [one.py_func for one in known if isinstance(one, Compiled) and one.py_func not in functions]
            found.append((code.co_code, code.co_names, code.co_varnames, _text(numbers), _text(known)))
    return hashlib.sha256(repr(found).encode()).hexdigest()


def _text(value: Any) -> object:
    """Return what tells a constant, a type or a function from others, in any process."""
    if isinstance(value, tuple):
        return [_text(each) for each in value]
    if isinstance(value, np.ndarray):
        return value.dtype.str, value.shape, value.tobytes()
    # A module by its name: its text holds the folder, and an environment may be reached by several.
    name = value.__name__ if isinstance(value, ModuleType) else getattr(value, "__qualname__", None)
    return name or repr(value), getattr(value, "_fields", ())
