"""A comparison of strips and plane grid as text and as files."""

from __future__ import annotations

from typing import Any

import numpy as np

from nonhertz.amounts import read_in
from nonhertz.comparison import ComparedQuantity, Comparison
from nonhertz.files.results import key_by_key, plain
from nonhertz.result.solution import Solution
from nonhertz.result.tables import csv_text

#: Units of the numbers in a comparison; quantities carry their own, and dimensionless numbers are left out.
UNITS: dict[str, Any] = {
    "seconds": "s",
    "stretches": {"low": "mm", "high": "mm", "at": "mm"},
    "stations": {"y": "mm"},
    "strips": {"y": "mm", "strip_width": "mm", "centre_pressure": "MPa", "half_width": "mm"},
    "patch": {"y": "mm", "centre_pressure": "MPa", "half_width": "mm", "line_load": "N/mm"},
}
_STRIPS = ("semi_elliptic", "parabolic")
_COLUMNS = ("element", "y [mm]", "strip_width [mm]", "centre_pressure [MPa]", "patch_pressure [MPa]", "difference")


@read_in("si")
def as_object(found: Comparison, title: str) -> dict[str, Any]:
    """Return a comparison as plain numbers, text, lists and dictionaries; a number that is not finite is None."""
    patch = found.patch
    return {
        "title": title,
        "cells": list(patch.cells),
        "quantities": [_quantity(each) for each in found.quantities],
        "stretches": [plain(vars(each)) for each in found.stretches],
        "seconds": plain(vars(found.seconds)) | {"runs": found.seconds.runs},
        "stations": [plain(vars(each)) for each in found.stations],
        "warnings": list(found.warnings),
        "units": UNITS,
        "semi_elliptic": _strips(found, found.semi_elliptic),
        "parabolic": _strips(found, found.parabolic),
        "patch": {name: plain(getattr(patch, name)) for name in UNITS["patch"]},
    }


def as_table(found: Comparison) -> str:
    """Return all strips, and the plane grid at their centres, as CSV with a header of names and units."""
    rows = []
    for solution in found.strips:
        of_patch = np.interp(solution.y, found.patch.y, found.patch.centre_pressure)
        columns = (solution.y, solution.strip_width, solution.centre_pressure, of_patch, found.along(solution))
        rows += [[solution.element.name, *row] for row in zip(*map(plain, columns), strict=True)]
    return csv_text(_COLUMNS, rows)


@read_in("si")
def files(found: Comparison, title: str) -> dict[str, str]:
    """Return the texts of comparison.json and comparison.csv, by file name."""
    return {"comparison.json": key_by_key(as_object(found, title)) + "\n", "comparison.csv": as_table(found)}


def _quantity(each: ComparedQuantity) -> dict[str, Any]:
    numbers = {name: value for name, value in vars(each).items() if name not in {"what", "at"}}
    differences = dict(zip(_STRIPS, each.differences, strict=True))
    found: dict[str, Any] = plain({"name": each.name} | numbers | {"differences": differences})
    return found | {"remark": str(each.remark or "")}


def _strips(found: Comparison, solution: Solution) -> dict[str, Any]:
    return {
        "strips": solution.strips,
        **{name: plain(getattr(solution, name)) for name in UNITS["strips"]},
        "difference": plain(found.along(solution)),
    }
