"""The numbers in C++: the module that was built for this processor, as `core`."""

from __future__ import annotations

import importlib
import importlib.util
from typing import TYPE_CHECKING

from numpy._core._multiarray_umath import (  # type: ignore[import-not-found, unused-ignore]
    __cpu_features__ as features,
)

if TYPE_CHECKING:
    from nonhertz import _core as core
else:
    fast = features.get("AVX2") and features.get("FMA3") and importlib.util.find_spec("nonhertz._core_v3")
    core = importlib.import_module("nonhertz._core_v3" if fast else "nonhertz._core")

__all__ = ["core"]
