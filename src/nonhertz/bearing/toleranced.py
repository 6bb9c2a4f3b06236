"""Ranges of a bearing's results by the limits of its classes: interferences, clearance and dependent results."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from types import SimpleNamespace
from typing import Final

from nonhertz.bearing.assessed import BearingLife
from nonhertz.bearing.fits import Range
from nonhertz.bearing.operating import ClearanceRanges
from nonhertz.bearing.quantities import QUANTITIES
from nonhertz.bearing.solution import BearingSolution
from nonhertz.result.brief import HasHtml

_LIVES: Final = ("reference_life", "modified_life")
#: Results given at the least, the likely and the greatest clearance.
AT_LIMITS: Final = ("max_pressure", *_LIVES)
#: Their values at one of these.
Numbers = Mapping[str, float]


@dataclass(frozen=True)
class Tolerances(HasHtml):
    """A bearing at the limits of its classes.

    Attributes
    ----------
    clearance : ClearanceRanges
        Interferences and clearance of a row.
    results : mapping of str to Range
        By quantity: its values at the least, the likely and the greatest clearance, the smaller limit first; NaN if it
        has none.
    """

    clearance: ClearanceRanges
    results: Mapping[str, Range]

    @classmethod
    def of(cls, clearance: ClearanceRanges, least: Numbers, likely: Numbers, greatest: Numbers) -> Tolerances:
        """Return the tolerances with results at the three clearances."""
        return cls(clearance, {name: Range(least[name], likely[name], greatest[name]) for name in AT_LIMITS})


def numbers_of(solution: BearingSolution | None, life: BearingLife | None) -> Numbers:
    """Return these results of a loaded bearing; NaN where there is none."""
    pressed = math.nan
    if solution is not None:
        pressed = float(QUANTITIES["max_pressure"].get(SimpleNamespace(solution=solution)))
    return {"max_pressure": pressed} | {name: math.nan if life is None else getattr(life, name) for name in _LIVES}
