"""The numbers of a loaded bearing, each defined once: name, label, symbol, units, and how to get it.

Columns of sweeps and tolerance studies and rows of comparisons are made from these. Those that are no element of an
array, or a rating, that results have otherwise are in summaries, reports, on the page and in JSON by themselves.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Final, Protocol

import numpy as np

from nonhertz.bearing.assessed import BearingLife
from nonhertz.bearing.frames import RINGS
from nonhertz.bearing.solution import BearingSolution
from nonhertz.errors import NonhertzError
from nonhertz.result.quantities import Quantity

LIVES: Final = ("10^6 revolutions", "million revolutions")


class Rated(Protocol):
    """A bearing with what is known of its life, such as a `BearingCase`."""

    def assess(self, solution: BearingSolution) -> BearingLife:
        """Return how long it lasts; refuse if it has no rating."""


@dataclass(frozen=True)
class SolvedBearing:
    """A bearing case and its solution, from which the numbers of a row are taken."""

    case: Rated
    solution: BearingSolution

    @cached_property
    def life(self) -> BearingLife:
        """How long it lasts.

        Raises
        ------
        InputError
            If such a bearing has no rating.
        """
        return self.case.assess(self.solution)


def _quantities() -> tuple[Quantity, ...]:
    def motion(name: str, label: str, unit: str, shown: str, factor: float, index: int) -> Quantity:
        return Quantity(name, label, "", unit, lambda solved: solved.solution.displacement[index], shown, factor)

    def force(name: str, label: str, unit: str, index: int) -> Quantity:
        return Quantity(name, label, "", unit, lambda solved: solved.solution.force[index], unit)

    def stiffness(name: str, label: str, unit: str, index: int) -> Quantity:
        shown = ("N/um", 1e-3) if unit == "N/mm" else ("N m/mrad", 1e-6)
        return Quantity(name, label, "", unit, lambda solved: solved.solution.stiffness[index, index], *shown)

    def life(name: str, label: str, symbol: str) -> Quantity:
        return Quantity(name, label, symbol, LIVES[0], lambda solved: getattr(solved.life, name), LIVES[1])

    return (
        Quantity("max_load", "largest load of a contact", "", "N", lambda s: s.solution.load.max(), "N"),
        Quantity("max_pressure", "maximum pressure", "", "MPa", _pressure, "MPa"),
        *(
            Quantity(f"max_pressure_{ring}", f"maximum pressure at the {ring} ring", "", "MPa", _pressure_at(k), "MPa")
            for k, ring in enumerate(RINGS)
        ),
        Quantity("max_rib_load", "largest rib load", "", "N", lambda s: s.solution.rib_load.max(initial=0.0), "N"),
        Quantity("loaded_rollers", "loaded rollers", "", "", lambda s: np.sum(s.solution.load.min(axis=1) > 0.0), ""),
        *(motion(f"displacement_{axis}", f"displacement {axis}", "mm", "um", 1e3, k) for k, axis in enumerate("xyz")),
        *(motion(f"tilt_{axis}", f"tilt about {axis}", "rad", "mrad", 1e3, k) for k, axis in enumerate("yz", 3)),
        *(force(f"force_{axis}", f"force {axis}", "N", k) for k, axis in enumerate("xyz")),
        *(force(f"moment_{axis}", f"moment about {axis}", "N mm", k) for k, axis in enumerate("yz", 3)),
        *(stiffness(f"stiffness_{axis}", f"stiffness {axis}", "N/mm", k) for k, axis in enumerate("xyz")),
        *(stiffness(f"tilting_stiffness_{a}", f"stiffness about {a}", "N mm/rad", k) for k, a in enumerate("yz", 3)),
        life("basic", "life L10", "L10"),
        life("reference", "reference life", "L10r"),
        life("modified", "modified life", "Lnmr"),
        Quantity("static_safety", "static safety", "S0", "", lambda solved: solved.life.static_safety, ""),
        Quantity("warnings", "warnings", "", "", lambda solved: len(solved.solution.warnings), ""),
    )


def _pressure(solved: SolvedBearing) -> float:
    return float(solved.solution.max_pressure.max()) if solved.solution.method == "strips" else math.nan


def _pressure_at(ring: int) -> Callable[[SolvedBearing], float]:
    return lambda s: s.solution.max_pressure[:, ring].max() if s.solution.method == "strips" else math.nan


#: All numbers of a bearing, by name.
QUANTITIES: dict[str, Quantity] = {each.name: each for each in _quantities()}
_SHOWN_OTHERWISE: Final = frozenset(
    {
        *("max_load", "max_pressure", *(f"max_pressure_{ring}" for ring in RINGS), "max_rib_load", "loaded_rollers"),
        *(f"{what}_{axis}" for what in ("displacement", "force", "stiffness") for axis in "xyz"),
        *(f"{what}_{axis}" for what in ("tilt", "moment", "tilting_stiffness") for axis in "yz"),
        *("basic", "reference", "modified", "static_safety", "warnings"),
    }
)


def further(solved: SolvedBearing) -> Iterator[tuple[Quantity, float]]:
    """Yield the numbers that no array, rating or row of a result has otherwise, as far as there are any."""
    for name, quantity in QUANTITIES.items():
        if name not in _SHOWN_OTHERWISE:
            try:
                yield quantity, float(quantity.get(solved))
            except NonhertzError:
                continue
