"""Tables as Excel workbooks: numbers are numbers, units stand in the head, and a second sheet has the inputs."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

from nonhertz.errors import InputError
from nonhertz.files.bounds import walk
from nonhertz.files.mistakes import path_of
from nonhertz.inputs.files import printable_name

#: Rows of a sheet, its head included.
MOST_ROWS = 1_048_576
INPUTS = "inputs"
_WIDTH = 14.0  # of a column, in digits
_INPUTS_HEAD = ("case", "path", "value")

Table = tuple[Sequence[str], Iterable[Iterable[Any]]]


def refuse_missing_writer() -> None:
    """Raise, before the work starts, the error that `write_workbook` would raise at its end.

    Raises
    ------
    ModuleNotFoundError
        If openpyxl is not installed.
    """
    import openpyxl  # noqa: F401


def refuse_too_many(option: str, rows: int) -> None:
    """Refuse more rows than a sheet has.

    Raises
    ------
    InputError
    """
    if rows >= MOST_ROWS:
        condition = f"have at most {MOST_ROWS - 1:,} rows, the limit of a sheet"
        raise InputError(option, f"{rows:,} rows", condition, "use the CSV file or the Parquet file")


def write_workbook(path: Path, sheets: Mapping[str, Table]) -> None:
    """Write tables as the sheets of a workbook.

    Parameters
    ----------
    path : Path
        The file; one of the same name is overwritten.
    sheets : mapping of str to (head, rows)
        Head and rows of each sheet by its name. Numbers that are not finite are empty cells, as None is.

    Raises
    ------
    ModuleNotFoundError
        If openpyxl is not installed.
    """
    import openpyxl
    from openpyxl.cell import WriteOnlyCell
    from openpyxl.styles import Alignment, Font
    from openpyxl.utils import get_column_letter

    def cell(sheet: Any, value: Any) -> Any:
        if not isinstance(value, str):
            return value if not isinstance(value, float) or math.isfinite(value) else None
        made = WriteOnlyCell(sheet, printable_name(value))
        made.data_type = "s"  # text that begins with an equals sign is not a formula
        return made

    book = openpyxl.Workbook(write_only=True)
    for name, (head, rows) in sheets.items():
        sheet = book.create_sheet(name)
        sheet.freeze_panes = "A2"
        for column in range(1, len(head) + 1):
            sheet.column_dimensions[get_column_letter(column)].width = _WIDTH
        titles = [cell(sheet, title) for title in head]
        for title in titles:
            title.font, title.alignment = Font(bold=True), Alignment(wrap_text=True, vertical="top")
        sheet.append(titles)
        for row in rows:
            sheet.append([cell(sheet, value) for value in row])
    book.save(path)


def inputs_table(documents: Iterable[tuple[str, Mapping[str, Any]]]) -> Table:
    """Return the values of documents by their dotted paths, as a table; each document comes with a name."""
    return _INPUTS_HEAD, (
        (name, path_of(place), value if isinstance(value, str | int | float) else str(value))
        for name, whole in documents
        for place, value in walk(whole)
        if _fills_a_cell(place, value)
    )


def _fills_a_cell(place: tuple[str | int, ...], value: Any) -> bool:
    """Return whether a value of a document fills one cell: a number, a word, or a list of these."""
    if isinstance(value, list):
        return not any(isinstance(entry, dict | list) for entry in value)
    return not isinstance(value, dict) and isinstance(place[-1], str)
