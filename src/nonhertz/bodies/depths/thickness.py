"""A number: a depth below the surface in mm, such as the thickness of a ring."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import mm
from nonhertz.bodies.depths.depth import Depth

if TYPE_CHECKING:
    from nonhertz.bodies.solid import Shape, Solid

Array = NDArray[np.float64]


class Thickness(Depth):
    """Displacement against a point at the same depth everywhere.

    Parameters
    ----------
    depth : float
        Depth below the surface [mm].
    """

    word = ""
    meaning = "a depth below the surface [mm], such as the thickness of a ring"

    def __init__(self, depth: float) -> None:
        self.depth = depth

    @property
    def shown(self) -> str:
        """The depth."""
        return f"{mm(self.depth):.6g}"

    @property
    def place(self) -> str:
        """A point at the given depth."""
        return f"a point {mm(self.depth):.6g} below the surface"

    def below(self, body: Solid, shape: Shape) -> Callable[[Array], Array]:
        """Return y [mm] -> depth [mm]."""
        return partial(_even, self.depth)


def _even(depth: float, y: Array) -> Array:
    return np.full(y.shape, depth)
