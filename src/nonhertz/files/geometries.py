"""Bearing files from a designation, with raceways from catalogues (geometries.csv) or your own geometries."""

from __future__ import annotations

import csv
import difflib
import re
from collections.abc import Mapping
from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import Any, Final

from nonhertz.bearing.ribs import DESIGNS
from nonhertz.errors import InputError, join_words
from nonhertz.files.catalogue import SYMBOLS, guess_of_catalogue, text_of_guess
from nonhertz.inputs.files import read_input_file

LARGEST: Final = 1_000_000  # bytes
_NEAR: Final = 3
_HEAD: Final = ("designation", "kind", *SYMBOLS, "source")
_EXAMPLE: Final = "begin it with a line such as designation,d,D,B,C,C0,F,E,Z,L,source"
# A size, with a design before it and manufacturers' suffixes behind it.
_SIZE: Final = re.compile(rf"({'|'.join(sorted(DESIGNS, key=len, reverse=True))})?(\d{{3,4}})(?!\d)")


def bearing_of_designation(designation: str, own: Path | None = None) -> str:
    """Return the text of a bearing file for a designation, with its source and what is guessed as comments.

    Parameters
    ----------
    designation : str
        Such as ``"NU 206"``. Suffixes behind the size, as in ``"NJ 2310 ECP"``, are ignored.
    own : Path, optional
        A CSV file of your own geometries, which take precedence over those of the library and may be of any kind that
        `nonhertz.files.catalogue.guess_of_catalogue` knows. Its header has ``designation``, symbols and ``source``.

    Raises
    ------
    InputError
        If the designation is unknown, the file is not such a table, or a row describes an impossible bearing.
    """
    rows = {} if own is None else _own_geometries(own)
    row = rows.get(_plain(designation))
    if row is None:
        return _published_bearing(designation, rows)
    return text_of_guess(guess_of_catalogue(_symbols(row)), designation.strip(), source=f"geometry: {row['source']}")


def _published_bearing(designation: str, rows: Mapping[str, Any]) -> str:
    matched = _SIZE.match(_plain(designation))
    design, size = matched.groups() if matched else (None, "")
    row = published_geometries().get(size)
    if row is None:
        condition = f"be a known cylindrical roller bearing, such as {join_words(_near(designation, size, rows), 'or')}"
        raise InputError(
            "designation", designation, condition, "give its catalogue data, or geometries with a row of it"
        )
    bearing = {"design": design or "NU", "series": size[:-2]}
    source = f"dimensions, ratings and raceways F and E of size {size}: {row['source']}"
    return text_of_guess(guess_of_catalogue(_symbols(row)), designation.strip(), bearing, source)


@cache
def published_geometries() -> dict[str, dict[str, str]]:
    """Return the rows of the library by size."""
    text = files(__package__).joinpath("geometries.csv").read_text(encoding="utf-8")
    return {row["designation"]: row for row in _rows(text)}


def _own_geometries(path: Path) -> dict[str, dict[str, str]]:
    """Return the rows of a file by designation."""
    data, name = read_input_file("geometries", path, LARGEST)
    try:
        rows = _rows(data.decode("utf-8-sig"))
    except (UnicodeDecodeError, csv.Error):
        rows = []
    columns = tuple(rows[0]) if rows else ()
    if not {"designation", "source"} <= set(columns) or not set(columns) <= set(_HEAD):
        condition = f"be a comma-separated table of {join_words(_HEAD)}"
        raise InputError("geometries", name, condition, _EXAMPLE)
    if any(None in row.values() for row in rows):
        raise InputError("geometries", name, "have as many values in each row as in its header", "complete the rows")
    return {_plain(row["designation"]): row for row in rows}


def _rows(text: str) -> list[dict[str, str]]:
    return list(csv.DictReader(line for line in text.splitlines() if not line.startswith("#")))


def _symbols(row: Mapping[str, str]) -> dict[str, str]:
    return {name: value for name, value in row.items() if value and name not in ("designation", "source")}


def _plain(designation: str) -> str:
    return re.sub(r"[\s./-]", "", designation).upper()


def _near(designation: str, size: str, rows: Mapping[str, Mapping[str, str]]) -> list[str]:
    """Return similar designations of a user's own rows, and the nearest sizes, if possible of the same series."""
    own = difflib.get_close_matches(_plain(designation), rows)
    number = int(size or "206")
    sizes = sorted(published_geometries(), key=lambda name: (name[:-2] != size[:-2], abs(int(name) - number)))
    return [*(rows[name]["designation"] for name in own), *(f"NU {name}" for name in sizes[:_NEAR])]
