"""Functions through which Python enters machine code, without importing Numba if it was compiled before.

Each is compiled as a whole, with all that it calls. Its machine code is kept under a digest of everything that it was
made from.
"""

from __future__ import annotations

import hashlib
import threading
from collections.abc import Callable
from typing import Any, cast

from nonhertz.compiled.arguments import canonical, flatten, text, type_of
from nonhertz.compiled.decorator import Compiled, Function, is_disabled
from nonhertz.compiled.folders import UnwritableError, read, write
from nonhertz.compiled.meaning import lasting_meaning
from nonhertz.compiled.notices import patience, warn_unkept


def entry(function: Function) -> Function:
    """Let Python call the machine code of ``function``, in a process that may never have imported Numba.

    The function takes contiguous arrays of float64, int64 or bool, single floats, integers and truth values, and
    (nested) tuples of these. It fills arrays that it is given, and returns nothing or one number. Functions
    that are `compiled` may call it, too. Settings of the compiler are those of `compiled`.
    """
    return function if is_disabled() else cast(Function, Entry(function))


class Entry(Compiled):
    """A function whose machine code is found on disk, or else compiled and kept there.

    Parameters
    ----------
    function : callable
        The function in Python.
    """

    def __init__(self, function: Callable[..., Any]) -> None:
        super().__init__(function)
        self._lock = threading.Lock()
        self._natives: dict[str, Any] = {}
        # By the classes of all parts, which are quicker to find out than their types.
        self._latest: dict[tuple[type | None, ...], Any] = {}

    def __call__(self, *arguments: Any) -> Any:
        """Run the machine code.

        Raises
        ------
        TypeError
            If an argument is not of a type that it takes.
        """
        arrays: list[Any] = []
        numbers: list[Any] = []
        classes: list[type | None] = []
        flatten(arguments, arrays, numbers, classes)
        key = tuple(classes)
        native = self._latest.get(key)
        if native is not None:
            done, result = native(arrays, numbers)
            if done:
                return result
        native = self._native(arguments, [type(each) for each in numbers])
        done, result = native([canonical(each) for each in arrays], numbers)
        if not done:
            raise RuntimeError("Machine code does not recognise the arrays of this version of NumPy.")
        self._latest[key] = native
        return result

    def _native(self, arguments: tuple[Any, ...], classes: list[type]) -> Any:
        types = tuple(type_of(each) for each in arguments)
        named = ",".join(text(each) for each in types)
        with self._lock:
            if named not in self._natives:
                self._natives[named] = self._obtained(types, named, classes)
            return self._natives[named]

    def _obtained(self, types: tuple[Any, ...], named: str, classes: list[type]) -> Any:
        """Return machine code from disk, or compile it and keep it."""
        from nonhertz.compiled.native import Native, ObjectCode
        from nonhertz.compiled.origin import origin

        meaning = lasting_meaning(self.py_func)
        key = None if meaning is None else repr((meaning, named, origin())).encode()
        name = f"{self.__module__}.{self.__qualname__}".replace("<", "").replace(">", "")
        name += "" if key is None else f"-{hashlib.sha256(key).hexdigest()[:32]}"
        content = None if key is None else read(name, key)
        if content is not None:
            return Native(ObjectCode.from_bytes(content), classes)
        from nonhertz.compiled.target import build

        with patience():
            made = build(self, types, name)
        native = Native(made, classes)
        if key is not None:
            try:
                write(name, key, made.to_bytes())
            except UnwritableError as error:
                warn_unkept(str(error))
        return native
