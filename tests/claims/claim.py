"""Claims: what a number should be, by which source and how nearly, and the function that finds it."""

from __future__ import annotations

import functools
import math
import operator
import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, ParamSpec, TypeVar, cast

import numpy as np
from numpy.typing import NDArray

from nonhertz.errors import NonhertzError

if TYPE_CHECKING:
    from nonhertz.model.contact import Contact
    from nonhertz.patch.solution import PatchSolution
    from nonhertz.result.solution import Solution

Array = NDArray[np.float64]
Value = float | Callable[[], float]
Values = Sequence[float] | Array
P = ParamSpec("P")
T = TypeVar("T")

_FORGET: list[Callable[[], None]] = []


@dataclass(frozen=True, eq=False)
class Claim:
    """One number and what it should be.

    Attributes
    ----------
    quantity : str
        What the number is, in words.
    source : str
        Source of the expected value: publication with equation, or the law it follows from.
    expected : float or callable
        The expected value, or a function that returns it.
    found : callable
        Returns the computed value.
    tolerance : float, callable or None
        Largest allowed difference; None if the difference is shown but not judged.
    unit : str
        Unit of both values, empty for a ratio.
    absolute : bool
        Whether difference and tolerance are absolute, in ``unit``; else relative to the expected value. They are where
        the expected number is zero.
    why : str
        Reason for the tolerance, where it is not that of the source.
    id : str
        Name of the claim, ``section/quantity`` in lower case with hyphens; set by `named`.
    """

    quantity: str
    source: str
    expected: Value
    found: Callable[[], float]
    tolerance: Value | None
    unit: str = ""
    absolute: bool = False
    why: str = ""
    id: str = ""

    def __post_init__(self) -> None:
        """Take a difference from zero as it is."""
        object.__setattr__(self, "absolute", self.absolute or self.expected == 0.0)

    def check(self) -> Check:
        """Return the claim with its numbers; a computation that fails gives NaN and the reason."""
        try:
            tolerance = None if self.tolerance is None else _number(self.tolerance)
            return Check(self, _number(self.expected), float(self.found()), tolerance)
        except (NonhertzError, ValueError, ArithmeticError) as error:
            return Check(self, math.nan, math.nan, 0.0, str(error))


@dataclass(frozen=True, eq=False)
class Check:
    """A claim with its numbers.

    Attributes
    ----------
    claim : Claim
        The claim.
    expected, computed : float
        Both values, in the claim's unit.
    tolerance : float or None
        Largest allowed difference; None if it is not judged.
    error : str
        Why there are no numbers; empty if there are.
    """

    claim: Claim
    expected: float
    computed: float
    tolerance: float | None
    error: str = ""

    @property
    def difference(self) -> float:
        """Computed less expected, relative unless the claim is absolute."""
        difference = self.computed - self.expected
        if self.claim.absolute or difference == 0.0:
            return difference
        return difference / abs(self.expected) if self.expected else math.inf

    @property
    def passed(self) -> bool | None:
        """Whether the difference is within the tolerance; None if it is not judged."""
        if self.tolerance is None:
            return None
        return math.isfinite(self.difference) and abs(self.difference) <= self.tolerance

    @property
    def verdict(self) -> str:
        """``"pass"``, ``"FAIL"`` or ``"shown"``."""
        return {True: "pass", False: "FAIL", None: "shown"}[self.passed]


@dataclass(frozen=True)
class Evidence:
    """What several claims are about: a result, and its counterpart by another way if numbers are read from both.

    Attributes
    ----------
    name : str
        Words before each quantity, if any.
    source : str
        That of its claims, unless they have their own.
    found, expected : callable
        Return the result and its counterpart. Without one a claim says what it expects, unless that is zero.
    """

    name: str
    source: str
    found: Callable[[], Any]
    expected: Callable[[], Any] | None = None

    def claim(
        self,
        quantity: str,
        measure: str | Callable[[Any], float],
        tolerance: Value | None,
        unit: str = "",
        *,
        expected: Value | None = None,
        source: str = "",
        absolute: bool = False,
        why: str = "",
    ) -> Claim:
        """Return a claim about an attribute of the result, or about what a function finds in it."""
        of = operator.attrgetter(measure) if isinstance(measure, str) else measure
        counterpart, words = self.expected, f"{self.name}: {quantity}" if self.name else quantity
        if expected is None:
            expected = 0.0 if counterpart is None else lambda: of(counterpart())
        return Claim(words, source or self.source, expected, lambda: of(self.found()), tolerance, unit, absolute, why)

    def each(
        self,
        quantities: Iterable[str],
        tolerance: float | Sequence[float | None] | None,
        unit: str | Sequence[str] = "",
        *,
        expected: Values | None = None,
        absolute: bool = False,
        why: str = "",
    ) -> Iterator[Claim]:
        """Yield a claim about each of the numbers that the result consists of; sequences have an entry for each."""
        for place, quantity in enumerate(quantities):
            within = tolerance[place] if isinstance(tolerance, Sequence) else tolerance
            by, of = None if expected is None else expected[place], unit if isinstance(unit, str) else unit[place]
            yield self.claim(quantity, operator.itemgetter(place), within, of, expected=by, absolute=absolute, why=why)


@dataclass(frozen=True, eq=False)
class Case:
    """A contact and what is prescribed; ``sharp`` if it reaches sharp ends."""

    name: str
    contact: Contact
    given: dict[str, Any]
    sharp: bool = False


@dataclass(frozen=True)
class Section:
    """The checks of a topic: its name, its title and the claims with their numbers."""

    name: str
    title: str
    checks: tuple[Check, ...]


def named(section: str, claims: Iterable[Claim]) -> tuple[Claim, ...]:
    """Return claims with their ids; quantities that repeat are numbered."""
    counts: dict[str, int] = {}
    found = []
    for claim in claims:
        words = "-".join(re.findall(r"[a-z0-9.]+", claim.quantity.lower()))
        counts[words] = number = counts.get(words, 0) + 1
        found.append(replace(claim, id=f"{section}/{words}" + (f"-{number}" if number > 1 else "")))
    return tuple(found)


def in_middle(quantity: str) -> Callable[[Solution], float]:
    """Return what reads a quantity of the strip in the middle of a contact."""
    return lambda solution: float(getattr(solution, quantity)[int(np.argmin(np.abs(solution.y)))])


def pressures(solution: Solution | PatchSolution, y: Sequence[float] | NDArray[np.float64]) -> list[float]:
    """Return pressures on the centre line at places y [MPa]."""
    return list(np.interp(y, solution.y, solution.centre_pressure))


def solved(function: Callable[P, T]) -> Callable[P, T]:
    """Let a function remember what it returned for the same arguments, until `forget`."""
    remembering = functools.cache(function)
    _FORGET.append(remembering.cache_clear)
    return cast("Callable[P, T]", remembering)


def forget() -> None:
    """Forget all solved cases."""
    for clear in _FORGET:
        clear()


def _number(value: Value) -> float:
    return float(value() if callable(value) else value)
