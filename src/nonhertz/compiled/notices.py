"""What users are told about compiling: what to do if they would wait for it every time."""

from __future__ import annotations

import logging

_UNKEPT = (
    "The compiled solver cannot be kept, so every process compiles it again, which takes about half a minute: "
    "nothing can be written in %s. Set NUMBA_CACHE_DIR to a folder that can be written."
)

_said: set[str] = set()


def tell_unkept(places: str) -> None:
    """Log once that machine code cannot be written in ``places``; unless logging is set up, standard error shows it."""
    if _UNKEPT not in _said:
        _said.add(_UNKEPT)
        logging.getLogger("nonhertz").warning(_UNKEPT, places)
