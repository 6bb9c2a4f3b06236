"""Dimension series of bearings, and the factors published for them."""

from __future__ import annotations

import tomllib
from functools import cache
from importlib.resources import files
from typing import Any

from nonhertz.errors import InputError
from nonhertz.inputs.checks import one_of

REMEDY = "give the series of the designation: 2 for NU 206, 22 for NU 2206"


@cache
def series_table() -> dict[str, dict[str, dict[str, Any]]]:
    """Return the factors of each series, by the kind of bearing as named in files."""
    return tomllib.loads(files(__package__).joinpath("friction.toml").read_text(encoding="utf-8"))


def check_series(kind: str, series: str | None) -> None:
    """Refuse a series that does not exist for a kind of bearing."""
    known = tuple(series_table().get(kind, ()))
    if series is not None and not known:
        raise InputError("series", series, "be left out for such a bearing", "leave it out")
    if series is not None:
        one_of("series", series, known, REMEDY)
