"""The slider range of each quantity, and the initial value of a key when it is added."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

SLIDER_STEPS: Final = 1000


@dataclass(frozen=True)
class Range:
    """Range of a slider.

    Attributes
    ----------
    low, high : float
        Its ends, in the unit of the quantity.
    scale : str
        ``"linear"`` or ``"log"``; the latter has ends of one sign.
    start : float
        Initial value of a key when it is added.
    """

    low: float
    high: float
    scale: str
    start: float

    def mirrored(self) -> Range:
        """Return the range of values of the other sign."""
        return Range(-self.low, -self.high, self.scale, -self.start)

    def position(self, value: float) -> int:
        """Return the position of a value on the slider, from 0 to `SLIDER_STEPS`.

        Examples
        --------
        >>> Range(1.0, 100.0, "log", 10.0).position(10.0)
        500
        """
        low, high, at = self.low, self.high, value
        if self.scale == "log":
            if value / low <= 0.0:
                return 0
            low, high, at = 0.0, math.log(high / low), math.log(value / low)
        return round(SLIDER_STEPS * min(max((at - low) / (high - low), 0.0), 1.0))


LENGTH: Final = Range(0.5, 500.0, "log", 20.0)
#: By key, which denotes the same quantity throughout a case file; except that the radius of a profile for a design load
#: is the one across the contact.
RANGES: Final[dict[str, Range]] = {
    "amplitude": Range(1e-4, 0.1, "log", 0.005),
    "angle": Range(1e-4, 1.0, "log", 0.001),
    "approach": Range(1e-4, 1.0, "log", 0.02),
    "at": Range(0.25, 250.0, "log", 9.0),
    "blend_radius": Range(0.0, 20.0, "linear", 1.0),
    "case_depth": Range(0.05, 20.0, "log", 1.0),
    "centre": Range(-20.0, 20.0, "linear", 0.0),
    "compliance": Range(1e-7, 1e-4, "log", 2.8e-6),
    "bore": Range(0.5, 500.0, "log", 8.0),
    "core_yield_strength": Range(10.0, 5000.0, "log", 800.0),
    "corner_radius": Range(0.05, 10.0, "log", 0.5),
    "depth": LENGTH,
    "diameter": Range(1.0, 2000.0, "log", 20.0),
    "drop": Range(1e-4, 1.0, "log", 0.02),
    "effective_length": LENGTH,
    "end_radius": Range(1.0, 1e5, "log", 200.0),
    "fatigue_limit": Range(0.0, 1000.0, "linear", 360.0),
    "fraction": Range(0.5, 0.99999, "linear", 0.9999),
    "k1": Range(0.1, 10.0, "log", 1.0),
    "k2": Range(0.1, 1.0, "linear", 1.0),
    "length": LENGTH,
    "load": Range(10.0, 1e6, "log", 20000.0),
    "middle": LENGTH,
    "modulus": Range(1e3, 1e6, "log", 207000.0),
    "moment": Range(-1e5, 1e5, "linear", 0.0),
    "poisson": Range(0.0, 0.5, "linear", 0.3),
    "position": Range(-20.0, 20.0, "linear", 0.0),
    "pressure_limit": Range(10.0, 10000.0, "log", 4000.0),
    "radius": Range(10.0, 1e6, "log", 4000.0),
    "radius across": Range(0.5, 1000.0, "log", 10.0),
    "scale": Range(0.0, 3.0, "linear", 1.0),
    "share": Range(0.0, 1.0, "linear", 1.0),
    "shift": Range(-10.0, 10.0, "linear", 0.0),
    "slope": Range(0.2, 5.0, "linear", 1.125),
    "straight": Range(0.0, 100.0, "linear", 10.0),
    "tilt": Range(-0.005, 0.005, "linear", 0.0),
    "width": Range(0.01, 10.0, "log", 0.5),
    "yield_strength": Range(10.0, 5000.0, "log", 1500.0),
    "zm": Range(1e-4, 1.0, "log", 0.01),
}
# Initial values of lists, which have no sliders.
ENDS: Final[dict[str, list[float]]] = {
    "y": [-10.0, 0.0, 10.0],
    "relief": [0.01, 0.0, 0.01],
    "diameter": [20.0, 20.0, 20.0],
}


def range_of(name: str, value: float | None = None) -> Range | None:
    """Return the range of a key whose current value is ``value``; None for a key without a slider."""
    found = RANGES.get(name)
    if found is None or value is None or found.scale == "linear" or value >= 0.0:
        return found
    return found.mirrored()


def start(name: str) -> float | list[float]:
    """Return the initial value of a required number."""
    return RANGES[name].start


def start_list(name: str) -> list[float]:
    """Return the initial value of a required list."""
    return list(ENDS[name])
