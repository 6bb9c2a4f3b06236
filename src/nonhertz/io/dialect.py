"""How CSV files are written: with decimal points and commas between cells, or as a spreadsheet in German reads them.

Tables are made with decimal points. Where files are put into place, `nonhertz.io.folder` has them rewritten, so that no
table has to know.
"""

from __future__ import annotations

import csv
import re
from contextvars import ContextVar
from pathlib import Path

_DECIMAL_COMMAS: ContextVar[bool] = ContextVar("decimal_commas", default=False)
_NUMBER = re.compile(r"[-+]?\d+(?:\.\d*)?(?:[eE][-+]?\d+)?")


def choose_decimal_commas(chosen: bool) -> None:
    """Choose how CSV files are written from here on, in this context (see `contextvars`)."""
    _DECIMAL_COMMAS.set(chosen)


def rewrite_tables(folder: Path) -> None:
    """Rewrite the CSV files in a folder of drafts, if decimal commas have been chosen."""
    if not _DECIMAL_COMMAS.get():
        return
    for path in folder.glob("*.csv"):
        rewritten = path.with_name(path.name + ".rewritten")
        # With a byte order mark, without which spreadsheets take UTF-8 for another encoding.
        with (
            path.open(encoding="utf-8", newline="") as source,
            rewritten.open("w", encoding="utf-8-sig", newline="") as target,
        ):
            writer = csv.writer(target, delimiter=";", lineterminator="\n")
            writer.writerows(map(_with_comma, row) for row in csv.reader(source))
        rewritten.replace(path)


def _with_comma(cell: str) -> str:
    return cell.replace(".", ",") if _NUMBER.fullmatch(cell) else cell
