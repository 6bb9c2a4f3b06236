"""The parts of a verification: checks with a verdict, in sections with a text and pictures."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True)
class Check:
    """One number compared with its expected value.

    Attributes
    ----------
    claim : str
        What the number is, in words.
    source : str
        Source of the expected value: publication with equation, or the law it follows from.
    expected, computed : float
        Both values.
    tolerance : float or None
        Largest allowed difference; None if the difference is shown but not judged.
    unit : str
        Unit of both values, empty for a ratio.
    absolute : bool
        Whether difference and tolerance are absolute, in ``unit``; else relative to the expected value.
    """

    claim: str
    source: str
    expected: float
    computed: float
    tolerance: float | None
    unit: str = ""
    absolute: bool = False

    @property
    def difference(self) -> float:
        """Computed less expected, relative unless ``absolute``."""
        difference = float(self.computed - self.expected)
        if self.absolute or difference == 0.0:
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
class Picture:
    """A figure, drawn on demand.

    Attributes
    ----------
    name : str
        File name without extension.
    caption : str
        What it shows, one or two sentences.
    draw : callable
        Draws into an empty matplotlib figure.
    height : float
        Height of the figure [inch].
    """

    name: str
    caption: str
    draw: Callable[[Figure], None]
    height: float = 3.4


@dataclass(frozen=True)
class Section:
    """Checks that belong together.

    Attributes
    ----------
    title : str
        What is verified.
    text : str
        Markdown: what is compared with what, and what is found.
    checks : tuple of Check
        The numbers.
    pictures : tuple of Picture
        The figures.
    """

    title: str
    text: str
    checks: tuple[Check, ...]
    pictures: tuple[Picture, ...] = ()

    @property
    def failed(self) -> int:
        """Number of failed checks."""
        return sum(check.passed is False for check in self.checks)
