"""``"none"``: a point far away, in a half-space of infinite depth."""

from __future__ import annotations

from typing import TYPE_CHECKING

from nonhertz.bodies.depths.depth import Depth

if TYPE_CHECKING:
    from nonhertz.bodies.solid import Shape, Solid


class Endless(Depth):
    """Displacement against a point far away."""

    word = "none"
    meaning = "far away"
    place = "a point far away: it is a half-space of infinite depth"

    def below(self, body: Solid, shape: Shape) -> None:
        """Return None: far away."""
        return
