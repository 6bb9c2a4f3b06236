"""Machine code that was compiled before, loaded and called without Numba.

Importing Numba takes longer than solving a contact. An object file of LLVM needs only LLVM's loader, which puts it in
memory and links it with the C library. It holds one function, which takes all arrays as one tuple of Python and finds
their elements itself, since asking NumPy for each takes longer than many a call; the numbers follow.
"""

from __future__ import annotations

import ctypes
import functools
import pickle
import threading
from collections.abc import Sequence
from typing import Any, NamedTuple

import llvmlite.binding as llvm

from nonhertz.compiled.arguments import SCALARS

OTHER_TYPES = -1
"""What machine code returns instead of running, if an array is not of the type that it was compiled for."""

_lock = threading.Lock()
_PASSED_AS: dict[type, Any] = {float: ctypes.c_double, int: ctypes.c_int64, bool: ctypes.c_bool}


class ObjectCode(NamedTuple):
    """What the compiler made.

    Attributes
    ----------
    symbol : str
        Name of the function, unique among all that one process loads.
    result : str
        What it returns: the name of one of `SCALARS`, or "None".
    needs : tuple of str
        Names of functions from elsewhere that it calls.
    code : bytes
        Object file.
    """

    symbol: str
    result: str
    needs: tuple[str, ...]
    code: bytes

    def to_bytes(self) -> bytes:
        """Return all in one, for a file."""
        return " ".join((self.symbol, self.result, *self.needs)).encode() + b"\n" + self.code

    @classmethod
    def from_bytes(cls, content: bytes) -> ObjectCode:
        """Return what was stored."""
        head, _, code = content.partition(b"\n")
        symbol, result, *needs = head.decode().split()
        return cls(symbol, result, tuple(needs), code)


class Outcome(ctypes.Structure):
    """What machine code leaves: its result, and where an exception is described."""

    _fields_ = (
        ("result", ctypes.c_byte * 8), ("description", ctypes.c_void_p), ("size", ctypes.c_int32),
    )  # fmt: skip


class Native:
    """Loaded machine code of one function for certain types of arguments.

    Parameters
    ----------
    made : ObjectCode
        What the compiler made.
    classes : sequence of type
        The classes of the numbers among its arguments.
    """

    def __init__(self, made: ObjectCode, classes: Sequence[type]) -> None:
        numbers = (_PASSED_AS[each] for each in classes)
        # Such a function releases the interpreter's lock.
        kind = ctypes.CFUNCTYPE(ctypes.c_int32, ctypes.POINTER(Outcome), ctypes.py_object, *numbers)
        self._call = kind(_address(made))
        self._result = {each.__name__: _PASSED_AS[each] for each in SCALARS}.get(made.result)

    def __call__(self, arrays: Sequence[Any], numbers: Sequence[Any]) -> tuple[bool, Any]:
        """Return whether the arrays were of the right types, and if so the result."""
        outcome = Outcome()
        status = self._call(outcome, tuple(arrays), *numbers)
        if status == OTHER_TYPES:
            return False, None
        if status:
            raise _exception(outcome)
        return True, None if self._result is None else self._result.from_buffer(outcome).value


def _exception(outcome: Outcome) -> BaseException:
    """Return the exception that was raised in machine code."""
    try:
        kind, arguments, *_ = pickle.loads(ctypes.string_at(outcome.description, outcome.size))
        return kind(*(arguments or ()))  # type: ignore[no-any-return]
    except Exception:  # noqa: BLE001  (an exception with a text made at run time is described in another way)
        return RuntimeError("Machine code has raised an exception.")


def _address(made: ObjectCode) -> int:
    with _lock:
        engine = _engine()  # LLVM looks through the process when it makes the first
        _supply(made.needs)
        engine.add_object_file(llvm.ObjectFileRef.from_data(made.code))
        engine.finalize_object()
        address: int = engine.get_function_address(made.symbol)
    return address


@functools.cache
def _engine() -> Any:
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    machine = llvm.Target.from_default_triple().create_target_machine()
    return llvm.create_mcjit_compiler(llvm.parse_assembly(""), machine)


def _supply(needs: tuple[str, ...]) -> None:
    """Make known where functions are that LLVM does not find itself; it would end the process."""
    missing = [name for name in needs if llvm.address_of_symbol(name) is None]
    if missing:
        # It knows more of them, at the price of an import.
        from numba.core.registry import cpu_target

        cpu_target.target_context.refresh()
        missing = [name for name in missing if llvm.address_of_symbol(name) is None]
    if missing:
        raise RuntimeError(f"Machine code needs {', '.join(missing)}, which is nowhere in this process.")
