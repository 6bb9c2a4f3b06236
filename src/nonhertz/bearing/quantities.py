"""The quantities of a loaded bearing, each defined once: name, label, symbol, units, and function.

Columns of sweeps and tolerance studies and rows of comparisons are made from these. Quantities that are not part of an
array or another part of a result also have a row in summaries, reports and on the page, and a key in JSON.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property, partial
from typing import Any, Final, Protocol

import numpy as np

from nonhertz.bearing.assessed import BearingLife
from nonhertz.bearing.film import Films
from nonhertz.bearing.operating import OperatingClearance
from nonhertz.bearing.section import DISPLACEMENTS, FORCES, RINGS
from nonhertz.bearing.solution import BearingSolution
from nonhertz.errors import NonhertzError
from nonhertz.findings import Finding, sentences
from nonhertz.result.quantities import Quantity

LIVES: Final = ("10^6 revolutions", "million revolutions")


class Rated(Protocol):
    """A bearing with the data for its life, such as a `BearingCase`."""

    @property
    def operating_clearance(self) -> OperatingClearance | None:
        """Its operating clearance; None without fits."""

    def assess(self, solution: BearingSolution) -> BearingLife:
        """Return its life; refuse if it has no rating."""

    def films(self, solution: BearingSolution) -> Films | None:
        """Return its oil films; None without a speed or an oil."""

    def verdict(self, solution: BearingSolution, life: BearingLife | None = None) -> Any:
        """Return whether limits are met: a `nonhertz.verdict.Verdict`, which cannot be imported here."""


@dataclass(frozen=True)
class SolvedBearing:
    """A bearing case and its solution, from which the numbers of a row are taken."""

    case: Rated
    solution: BearingSolution

    @cached_property
    def life(self) -> BearingLife:
        """Its life.

        Raises
        ------
        InputError
            If such a bearing has no rating.
        """
        return self.case.assess(self.solution)

    @cached_property
    def films(self) -> Films | None:
        """The oil films; None without a speed or an oil."""
        return self.case.films(self.solution)

    @property
    def life_or_none(self) -> BearingLife | None:
        """Its life; None if such a bearing has no rating."""
        try:
            return self.life
        except NonhertzError:
            return None

    @property
    def findings(self) -> tuple[Finding, ...]:
        """Findings on the bearing, on its fits if it has any, and on its life if it has one."""
        parts = self.solution, self.case.operating_clearance, self.life_or_none
        return tuple(finding for part in parts if part is not None for finding in part.findings)


def _quantities() -> Iterator[Quantity]:
    def of(name: str, label: str, unit: str, within: str, get: Callable[[BearingSolution], float]) -> Quantity:
        return Quantity(name, label, "", unit, lambda solved: get(solved.solution), within=within)

    def part(name: str, label: str, unit: str, shown: str, within: str, at: int | tuple[int, int]) -> Quantity:
        return Quantity(name, label, "", unit, lambda s: getattr(s.solution, within)[at], shown, within=within)

    def life(name: str, label: str, symbol: str, unit: str = LIVES[0], shown: str = LIVES[1]) -> Quantity:
        return Quantity(name, label, symbol, unit, lambda solved: getattr(solved.life, name), shown, within="life")

    yield of("max_load", "largest load of a contact", "N", "load", lambda solution: solution.load.max())
    yield of("max_pressure", "maximum pressure", "MPa", "max_pressure", _pressure)
    for k, ring in enumerate(RINGS):
        label = f"maximum pressure at the {ring} ring"
        yield of(f"max_pressure_{ring}", label, "MPa", "max_pressure", partial(_pressure, ring=k))
    yield of("max_rib_load", "largest rib load", "N", "rib_load", lambda solution: solution.rib_load.max(initial=0.0))
    yield of("loaded_rollers", "loaded rollers", "", "load", lambda solution: np.sum(solution.load.min(axis=1) > 0.0))
    shown = {"mm": "um", "rad": "mrad"}
    for within, named in (("displacement", DISPLACEMENTS), ("force", FORCES)):
        for k, (name, unit) in enumerate(named.items()):
            kind, _, axis = name.partition("_")
            yield part(
                name, f"{kind} about {axis}" if k > 2 else f"{kind} {axis}", unit, shown.get(unit, ""), within, k
            )
    for k, axis in enumerate("xyz"):
        yield part(f"stiffness_{axis}", f"stiffness {axis}", "N/mm", "N/um", "stiffness", (k, k))
    for k, axis in enumerate("yz", 3):
        yield part(f"tilting_stiffness_{axis}", f"stiffness about {axis}", "N mm/rad", "N m/mrad", "stiffness", (k, k))
    yield life("basic_life", "life L10", "L10")
    yield life("reference_life", "reference life", "L10r")
    yield life("modified_life", "modified life", "Lnmr")
    yield life("rated_hours", "rated life in hours", "Lnmh", "h", "")
    yield life("static_safety", "static safety", "S0", "", "")
    least, smallest = partial(_least, name="least_film"), partial(_least, name="film_parameter")
    yield Quantity("least_film", "least film", "h_min", "mm", least, "um", within="film")
    for k, ring in enumerate(RINGS):
        label, at = f"least film at the {ring} ring", partial(least, ring=k)
        yield Quantity(f"least_film_{ring}", label, "h_min", "mm", at, "um", within="film")
    yield Quantity("film_parameter", "film parameter", "lambda", "", smallest, within="film")
    yield Quantity("warnings", "warnings", "", "", lambda solved: len(sentences(solved.findings)), within="warnings")


def _pressure(solution: BearingSolution, ring: int | slice = slice(None)) -> float:
    return float(solution.max_pressure[:, ring].max()) if solution.method == "strips" else math.nan


def _least(solved: SolvedBearing, name: str, ring: int | slice = slice(None)) -> float:
    values = getattr(solved.films, name, None)
    return math.nan if values is None else float(np.fmin.reduce(values[:, ring], axis=None))


#: All numbers of a bearing, by name.
QUANTITIES: dict[str, Quantity] = {quantity.name: quantity for quantity in _quantities()}


def further(solved: SolvedBearing) -> Iterator[tuple[Quantity, float]]:
    """Yield the available quantities that are not part of an array or another part of a result."""
    for quantity in QUANTITIES.values():
        if not quantity.within:
            try:
                yield quantity, float(quantity.get(solved))
            except NonhertzError:
                continue
