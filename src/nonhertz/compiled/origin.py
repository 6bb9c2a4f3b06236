"""What machine code depends on besides its function: the compiler, its settings, the processor, and how we compile."""

from __future__ import annotations

import functools
import hashlib
import os
import platform
from importlib import util
from pathlib import Path

import llvmlite.binding as llvm
import numpy as np

_OTHER_MATTERS = {"NUMBA_CACHE_DIR", "NUMBA_NUM_THREADS", "NUMBA_DISABLE_JIT"}


@functools.cache
def origin() -> tuple[object, ...]:
    """Return what tells apart machine code of one function that may differ; Numba need not be imported."""
    settings = {name: value for name, value in os.environ.items() if name.startswith("NUMBA_")}
    return (
        platform.python_implementation(), platform.python_version(), np.__version__,
        llvmlite_version(), llvm.llvm_version_info, _numba(), ourselves(),
        llvm.get_process_triple(), llvm.get_host_cpu_name(), llvm.get_host_cpu_features().flatten(),
        sorted(item for item in settings.items() if item[0] not in _OTHER_MATTERS),
    )  # fmt: skip


def llvmlite_version() -> str:
    """Return the version of llvmlite."""
    import llvmlite

    version: str = llvmlite.__version__
    return version


@functools.cache
def ourselves() -> str:
    """Return a digest of this subpackage's own sources: how we compile."""
    sources = {each.name: each.read_bytes() for each in Path(__file__).parent.iterdir() if each.is_file()}
    return hashlib.sha256(repr(sorted(sources.items())).encode()).hexdigest()


def _numba() -> tuple[bytes, ...]:
    """Return Numba's version, and its settings in the working directory, as the files in which they are."""
    found = util.find_spec("numba")
    package = Path(found.origin).parent if found is not None and found.origin is not None else Path()
    files = package / "_version.py", Path(".numba_config.yaml")
    return tuple(file.read_bytes() if file.is_file() else b"" for file in files)
