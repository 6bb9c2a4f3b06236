"""Several results side by side: rows of numbers in one unit, with their differences from the first result."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import Amount, format_digits, format_input, percent
from nonhertz.result.quantities import Quantity
from nonhertz.show.sections import Cell, Table

Cells = Sequence[str | Cell]
ABSENT = "–"
MOST_LISTED = 12  # results that are listed one by one
_NOTICED = 5e-6  # relative difference; smaller ones are rounding


@dataclass(frozen=True)
class Compared:
    """One number of several results.

    Attributes
    ----------
    name : str
        Name of the number.
    amount : Amount
        A value for each result, NaN if it has none.
    absolute : bool
        Whether differences are in the unit of the amount instead of per cent, as for positions.
    """

    name: str
    amount: Amount
    absolute: bool = False

    @property
    def head(self) -> str:
        """Name and unit."""
        unit = self.amount.scale[1]
        return f"{self.name} [{unit}]" if unit else self.name

    @property
    def cells(self) -> list[Cell]:
        """A cell for each result, with its difference from the first as a remark."""
        # Trailing zeros are dropped for counts and ratios, where they mean nothing.
        write, factor = (format_digits if self.amount.unit else format_input), self.amount.scale[0]
        texts = (write(factor * value, 5) if math.isfinite(value) else ABSENT for value in self.amount.values)
        return [*map(Cell, texts, self._differences if self.absolute else changes(self.amount.values))]

    @property
    def _differences(self) -> list[str]:
        first, *others = self.amount.values
        shown = (replace(self.amount, values=(value - first,)) for value in others)
        signed = (f"{'+' * (difference.values[0] > 0.0)}{difference:.2g}" for difference in shown)
        return ["", *(words if math.isfinite(value) else "" for words, value in zip(signed, others, strict=True))]


def changes(values: Sequence[float], scale: float | None = None) -> list[str]:
    """Return differences from the first value in per cent of it, or of ``scale``; empty for the first and for NaN.

    Examples
    --------
    >>> changes([2.0, 2.2, 2.0, math.nan]), changes([0.0, 1.0]), changes([0.0, 1.0], scale=5.0)
    (['', '+10 %', '0 %', ''], ['', ''], ['', '+20 %'])
    """
    first, *others = values
    scale = abs(first) if scale is None else scale
    relative = [(value - first) / scale if scale else math.nan for value in others]
    words = (percent(change, 3) if abs(change) >= _NOTICED else "0 %" for change in relative)
    return ["", *(word if math.isfinite(change) else "" for word, change in zip(words, relative, strict=True))]


def shared_quantities(quantities: Iterable[Quantity], results: Sequence[Mapping[str, float]]) -> list[Compared]:
    """Return the quantities of results, given by name, that at least one result has and that are not all zero."""
    rows = ((quantity, [values.get(quantity.name, math.nan) for values in results]) for quantity in quantities)
    return [
        Compared(quantity.label, quantity.amount(*values))
        for quantity, values in rows
        if any(value and math.isfinite(value) for value in values)
    ]


def extremes_table(numbers: Iterable[tuple[Quantity, tuple[float, float]]]) -> Table:
    """Return the smallest and the largest number of every quantity."""
    rows = []
    for quantity, extremes in numbers:
        (low, high), unit = quantity.amount(*extremes).apart()
        rows.append((quantity.label, low, high, unit))
    return Table(rows, ("", "smallest", "largest", ""), (0, 3))


def numbers_table(counted: str, numbers: Sequence[tuple[Quantity, NDArray[np.float64]]]) -> Table:
    """Return all numbers of few results, or the smallest and the largest of many; without quantities that are all zero.

    Parameters
    ----------
    counted : str
        What a result is called.
    numbers : sequence of (Quantity, ndarray)
        A value for each result, NaN where it has none.
    """
    some = [(quantity, values) for quantity, values in numbers if np.any(np.nan_to_num(values))]
    count = numbers[0][1].size
    if count > MOST_LISTED:
        return extremes_table((quantity, (np.nanmin(values), np.nanmax(values))) for quantity, values in some)
    heads = (counted, *map(str, range(count)), "")
    return Table([number_row(quantity, values.tolist()) for quantity, values in some], heads, (0, len(heads) - 1))


def number_row(quantity: Quantity, values: Sequence[float]) -> tuple[str, ...]:
    """Return label, values and unit of a quantity of several results, blank where one has none."""
    texts, unit = quantity.amount(*values).apart()
    cells = ("" if math.isnan(value) else text for value, text in zip(values, texts, strict=True))
    return quantity.label, *cells, unit


def beside(rows: Iterable[Compared | Cells], labels: Iterable[str], name: str = "") -> Table:
    """Return results side by side, a row for each number and a column for each result.

    Parameters
    ----------
    rows : iterable of Compared or of sequences of str and Cell
        Numbers, or cells of words.
    labels : iterable of str
        Names of the results.
    name : str
        Heading of the column of names.
    """
    cells: Iterable[Cells] = ((row.head, *row.cells) if isinstance(row, Compared) else row for row in rows)
    return Table([*cells], (name, *labels), (0,), remarks="difference")
