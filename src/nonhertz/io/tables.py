"""Tables as text: one place for how CSV is written."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Sequence
from typing import Any


def csv_text(head: Sequence[str], rows: Iterable[Iterable[Any]]) -> str:
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
