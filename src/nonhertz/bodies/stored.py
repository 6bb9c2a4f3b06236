"""Arrays that take seconds to compute, cached between processes."""

from __future__ import annotations

import hashlib
import io
import sys
from collections.abc import Callable, Hashable
from functools import lru_cache, wraps
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from nonhertz.bodies.files import read, write

Array = NDArray[np.float64]

#: Number of materials or shapes that a process keeps in memory; the others are on disk.
MOST = 16


def cache_on_disk(*modules: str) -> Callable[[Callable[..., Array]], Callable[..., Array]]:
    """Cache the results of a function, in this process and on disk.

    Parameters
    ----------
    *modules : str
        Names of the modules that the result depends on: if their source changes, it is computed again.

    Returns
    -------
    callable
        A decorator for functions of numbers, text and frozen values of these that return an array, which is read-only.
    """

    def decorate(make: Callable[..., Array]) -> Callable[..., Array]:
        @lru_cache(MOST)
        @wraps(make)
        def stored_or_made(*arguments: Hashable) -> Array:
            key = repr((make.__module__, make.__qualname__, arguments, np.__version__, _texts(modules))).encode()
            # At most 4,096 shapes are stored on disk.
            name = f"{make.__module__}.{make.__qualname__}-{hashlib.sha256(key).hexdigest()[:3]}"
            content = read(name, key)
            if content is not None:
                array: Array = np.load(io.BytesIO(content), allow_pickle=False)
            else:
                array = make(*arguments)
                file = io.BytesIO()
                np.save(file, array, allow_pickle=False)
                write(name, key, file.getvalue())
            array.flags.writeable = False
            return array

        return stored_or_made

    return decorate


def _texts(modules: tuple[str, ...]) -> str:
    """Return a digest of the sources of modules."""
    digest = hashlib.sha256()
    for name in modules:
        path = sys.modules[name].__file__
        assert path is not None
        digest.update(hashlib.sha256(Path(path).read_bytes()).digest())
    return digest.hexdigest()
