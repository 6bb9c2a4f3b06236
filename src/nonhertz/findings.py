"""Findings about a result as values: a kind and its numbers, from which a sentence is made where it is shown."""

from __future__ import annotations

import re
import warnings
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from nonhertz.amounts import Amount, EndStrength, display_units
from nonhertz.errors import AccuracyWarning


@dataclass(frozen=True, repr=False)
class Finding:
    """One finding about a result: a warning, a remark, a verdict.

    As text it is a sentence, with its numbers in the units chosen for display.

    Attributes
    ----------
    kind : str
        Code of the finding: the same for all findings that differ only in their numbers.
    words : str
        The sentence, with the names of the numbers in braces, as `str.format` has them.
    numbers : tuple of pairs
        Name and value of each number, and of words and findings inserted into the sentence.

    Examples
    --------
    >>> from nonhertz.amounts import display_units, mm
    >>> found = finding("cut-off", "The strips end at y = {y:.6g}.", y=mm(9.5))
    >>> found
    Finding(kind='cut-off', sentence='The strips end at y = 9.5 mm.')
    >>> with display_units("us"):
    ...     str(found)
    'The strips end at y = 0.374 in.'
    """

    kind: str
    words: str
    numbers: tuple[tuple[str, Any], ...] = ()

    @classmethod
    def from_text(cls, sentence: str, kind: str = "") -> Finding:
        """Return a finding that consists of a sentence only."""
        return cls(kind, "{sentence}", (("sentence", sentence),))

    def __repr__(self) -> str:
        return f"Finding(kind={self.kind!r}, sentence={str(self)!r})"

    def __str__(self) -> str:
        return self.words.format(**dict(self.numbers))

    @property
    def headline(self) -> str:
        """Its first sentence, which a warning says; the whole text has the details.

        Examples
        --------
        >>> finding("wide", "It is {width:.1f} times as wide as long. Compare with the grid.", width=1.5).headline
        'It is 1.5 times as wide as long.'
        """
        return re.split(r"(?<=[.!?]) (?=[A-Z(])", str(self), maxsplit=1)[0]

    def as_object(self) -> dict[str, Any]:
        """Return kind, sentence and numbers for programs: in mm, N, MPa and rad."""
        with display_units("si"):
            return {"kind": self.kind, "sentence": str(self), "numbers": dict(self._plain())}

    def _plain(self) -> Iterator[tuple[str, Any]]:
        for name, value in self.numbers:
            if isinstance(value, Finding):
                yield from value._plain()
            elif isinstance(value, Amount | EndStrength):
                values = list(value.values) if len(value.values) != 1 else value.values[0]
                yield name, {"value": values, "unit": value.unit}
            else:
                yield name, value.item() if isinstance(value, np.generic) else value


class HasFindings:
    """Mixin for results with a field ``findings``."""

    findings: tuple[Finding, ...]

    @property
    def warnings(self) -> tuple[str, ...]:
        """The findings as sentences."""
        return sentences(self.findings)


def finding(kind: str, words: str, /, **numbers: Any) -> Finding:
    """Return a finding; see `Finding`."""
    return Finding(kind, words, tuple(numbers.items()))


def sentences(findings: Iterable[Finding]) -> tuple[str, ...]:
    """Return the sentences of findings, without repeats."""
    return tuple(dict.fromkeys(map(str, findings)))


def as_warnings(findings: Iterable[Finding], notes: Iterable[str] = ()) -> dict[str, Any]:
    """Return findings as files store them: notes and sentences, and kinds with their numbers."""
    objects = [entry.as_object() for entry in dict.fromkeys(findings)]
    return {"warnings": list(dict.fromkeys((*notes, *(item.pop("sentence") for item in objects)))), "findings": objects}


def warn(findings: Iterable[Finding], stacklevel: int = 2) -> None:
    """Issue the first sentence of each finding as an `AccuracyWarning`."""
    for entry in findings:
        warnings.warn(entry.headline, AccuracyWarning, stacklevel=stacklevel + 1)
