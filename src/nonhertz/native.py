"""The compiled C++ module that suits this processor, as `core`."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from nonhertz import _core as core
else:
    # The faster one first: it does not load on a processor that lacks its instructions.
    reasons = []
    for name in ("_core_v3", "_core"):
        try:
            core = importlib.import_module(f"nonhertz.{name}")
            break
        except ImportError as error:
            reasons.append(f"nonhertz.{name}: {error}")
    else:
        raise ImportError(
            "The compiled core of nonhertz was not built for this Python and processor: run `pip install .` in its "
            f"folder, or `make core` in a checkout ({'; '.join(reasons)})"
        )

__all__ = ["core"]
