"""Notices about compiling: why the first solve is slow, and what to do if every one would be."""

from __future__ import annotations

import contextlib
import sys
import threading
from collections.abc import Iterator

_SILENCE = 2.0  # s, before the first progress notice
_WAIT = "The first solve on a machine compiles the solver: half a minute for a contact, another for a whole bearing."
_UNKEPT = (
    "The compiled solver cannot be kept, so every process compiles it again, which takes about half a minute: "
    "nothing can be written in %s. Set NUMBA_CACHE_DIR to a writable folder."
)

_said: set[str] = set()
_waiting = threading.local()


@contextlib.contextmanager
def patience() -> Iterator[None]:
    """Say once, at a terminal or in a notebook, why the first solve takes so long."""
    if _WAIT in _said or getattr(_waiting, "now", False) or not _watched():
        yield
        return
    notice = threading.Timer(_SILENCE, _tell_why)
    notice.daemon = True
    notice.start()
    _waiting.now = True
    try:
        yield
    finally:
        notice.cancel()
        _waiting.now = False


def warn_unkept(places: str) -> None:
    """Log once that machine code cannot be written in ``places``; unless logging is set up, standard error shows it."""
    if _UNKEPT not in _said:
        import logging

        _said.add(_UNKEPT)
        logging.getLogger("nonhertz").warning(_UNKEPT, places)


def is_unkept() -> bool:
    """Return whether machine code could not be written in this process."""
    return _UNKEPT in _said


def _watched() -> bool:
    # A notebook's standard error is not a terminal, but its interpreter has a prompt.
    return hasattr(sys, "ps1") or (sys.stderr is not None and sys.stderr.isatty())


def _tell_why() -> None:
    _said.add(_WAIT)
    # The stream may have been closed in the meantime.
    with contextlib.suppress(OSError, ValueError):
        print(_WAIT, file=sys.stderr, flush=True)
