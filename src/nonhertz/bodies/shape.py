"""Constants of the pressure across a contact that determine the effect of loads far away and at depth."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Protocol


class Shape(Protocol):
    """The far-field constants of a pressure distribution across the contact: a strip element, or `HERTZ`."""

    @property
    def far_constant(self) -> float:
        """-int phi ln|xi| of the shape phi, whose integral is 1, over its half-width."""

    @property
    def hertz_ratio(self) -> float:
        """Half-width of the Hertz line contact of equal load over that of the shape."""


@dataclass(frozen=True)
class _Hertz:
    far_constant: float = math.log(2.0) + 0.5
    hertz_ratio: float = 1.0


#: The semi-ellipse of a line contact.
HERTZ: Shape = _Hertz()
