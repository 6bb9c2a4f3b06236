"""Workbooks: the sheet with the most rows of numbers, as lines of text whose cells are separated by tabs."""

from __future__ import annotations

import io
from collections.abc import Iterable
from typing import Any

from nonhertz.errors import InputError
from nonhertz.files.traces.line import MOST_POINTS, Request
from nonhertz.files.traces.text import LONGEST_HEAD, value_in
from nonhertz.files.traces.x3p import describe_reason, repack

_OLE, _ZIP = b"\xd0\xcf\x11\xe0", b"PK"
# Members of an archive by which its kind is known; .xlsb, .ods and .numbers can only be converted.
_XLSX, _OTHERS = b"xl/workbook.xml", (b"xl/workbook.bin", b"opendocument.spreadsheet", b"Index/Document.iwa")
_MOST_COLUMNS = 100
_AS_CSV = "save it as CSV"


def is_workbook(data: bytes) -> bool:
    """Return whether a file is a workbook of Excel or of another program, in any of their formats."""
    return data.startswith(_OLE) or (data.startswith(_ZIP) and any(name in data for name in (_XLSX, *_OTHERS)))


def lines_of_workbook(data: bytes, request: Request) -> tuple[list[str], tuple[str, ...]]:
    """Return the rows of a workbook as lines, and notes.

    Raises
    ------
    InputError
        If it cannot be read, or openpyxl is not installed.
    """
    if _XLSX not in data or not data.startswith(_ZIP):
        raise request.error("be a file that can be read (this is a workbook)", _AS_CSV)
    try:
        import openpyxl
    except ModuleNotFoundError:
        remedy = f"{_AS_CSV}, or install what reads it with: pip install openpyxl"
        raise request.error("be a file that can be read (this is a workbook)", remedy) from None
    try:
        content = repack(data, request)
        if b"<!DOCTYPE" in content:
            raise request.error("be a workbook without definitions of its own (DOCTYPE)", _AS_CSV)
        book = openpyxl.load_workbook(io.BytesIO(content), read_only=True, data_only=True)
        most = {"max_row": MOST_POINTS + LONGEST_HEAD, "max_col": _MOST_COLUMNS, "values_only": True}
        sheets = {sheet.title: list(map(_line, sheet.iter_rows(**most))) for sheet in book.worksheets}
    except InputError:
        raise
    except Exception as error:  # noqa: BLE001  (zip, XML and openpyxl raise a dozen kinds of errors over damaged files)
        raise request.error(f"be an intact workbook ({describe_reason(error)})", _AS_CSV) from None
    # A sheet of heights alone has one number per row.
    rows = {name: [count for _, count in sheet] for name, sheet in sheets.items()}
    name = max(rows, key=lambda name: (sum(n > 1 for n in rows[name]), sum(map(bool, rows[name]))), default="")
    if not name:
        raise request.error("be a workbook with a sheet of cells", _AS_CSV)
    others = f", one of {len(sheets)}," if len(sheets) > 1 else ""
    return [line for line, _ in sheets[name]], (f"The sheet {name!r}{others} was read from a workbook.",)


def _line(row: Iterable[Any]) -> tuple[str, int]:
    """Return a row as text, and how many numbers it has."""
    cells = ["" if cell is None else " ".join(str(cell).split()) for cell in row]
    return "\t".join(cells).rstrip("\t"), sum(
        cell != "" and value_in(cell.replace(",", ".")) is not None for cell in cells
    )
