"""What the limits of classes leave open of a bearing: its interferences, its clearance, and what follows from that."""

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
#: The numbers of a result that are known at the least, the likely and the greatest clearance.
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
        By the names of quantities: what it is at the least, the likely and the greatest clearance, whichever is larger;
        NaN where there is none.
    """

    clearance: ClearanceRanges
    results: Mapping[str, Range]

    @classmethod
    def of(cls, clearance: ClearanceRanges, least: Numbers, likely: Numbers, greatest: Numbers) -> Tolerances:
        """Return them with results at the three clearances."""
        return cls(clearance, {name: Range(least[name], likely[name], greatest[name]) for name in AT_LIMITS})


def numbers_of(solution: BearingSolution | None, life: BearingLife | None) -> Numbers:
    """Return these numbers of a loaded bearing; NaN where there is none."""
    pressed = math.nan
    if solution is not None:
        pressed = float(QUANTITIES["max_pressure"].get(SimpleNamespace(solution=solution)))
    return {"max_pressure": pressed} | {name: math.nan if life is None else getattr(life, name) for name in _LIVES}
