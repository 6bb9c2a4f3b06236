"""Columns of numbers as CSV, for other programs."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray


def heading(name: str, unit: str) -> str:
    """Return the head of a column: name and unit.

    Examples
    --------
    >>> heading("load", "N"), heading("exponent", "")
    ('load [N]', 'exponent')
    """
    return f"{name} [{unit}]" if unit else name


def as_csv(columns: Mapping[str, NDArray[np.float64]]) -> str:
    """Return columns as CSV, their names in the first line, with ten significant digits.

    Examples
    --------
    >>> print(as_csv({"y [mm]": np.array([0.0, 0.1]), "force_y [N]": np.array([0.0, 1234.5])}), end="")
    y [mm],force_y [N]
    0,0
    0.1,1234.5
    """
    rows = np.transpose([np.ravel(column) for column in columns.values()]).tolist()
    return csv_text(columns, ([f"{value:.10g}" for value in row] for row in rows))


def csv_text(head: Iterable[str], rows: Iterable[Iterable[Any]]) -> str:
    """Return a table as CSV; None is an empty cell, and numbers have all their digits.

    Examples
    --------
    >>> print(csv_text(["title", "load [N]"], [["a, b", 20000.0], ["c", None]]), end="")
    title,load [N]
    "a, b",20000.0
    c,
    """
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(head)
    writer.writerows(rows)
    return text.getvalue()
