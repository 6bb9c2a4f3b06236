"""A comparison of strips and plane grid as text and as files."""

from __future__ import annotations

from operator import itemgetter
from typing import Any, Final

import numpy as np

from nonhertz.comparison import Comparison
from nonhertz.figures.comparison import compared_methods
from nonhertz.files import results
from nonhertz.files.results import Get, Key, ListOf, key_by_key, plain, quantity_keys, within
from nonhertz.result.quantities import ALONG
from nonhertz.result.tables import csv_text

_ELEMENTS: Final = {"semi_elliptic": "semi-elliptic strips", "parabolic": "parabolic strips"}
_COLUMNS = ("element", "y [mm]", "strip_width [mm]", "centre_pressure [MPa]", "patch_pressure [MPa]", "difference")


_QUANTITY: Final = (
    Key("name", "name of the quantity", holds="string"),
    Key("unit", "its unit", holds="string"),
    Key("patch", "by the plane grid"),
    *(Key(name, f"by {strips}") for name, strips in _ELEMENTS.items()),
    Key("absolute", "whether differences are in its unit; else relative to the plane grid", holds="boolean"),
    Key("remark", "remark", get=lambda quantity: quantity.remark or "", holds="string"),
    Key(
        "differences", "from the plane grid",
        holds=tuple(Key(name, f"of {strips}", get=itemgetter(k)) for k, (name, strips) in enumerate(_ELEMENTS.items())),
    ),
)  # fmt: skip
_STRETCH: Final = (
    Key("element", "element of the strips", holds="string"),
    Key("low", "outer edge at low y", "mm"),
    Key("high", "outer edge at high y", "mm"),
    Key("largest", "largest difference; null where the plane grid has no contact"),
    Key("at", "centre of the strip that has it", "mm"),
)
_SECONDS: Final = (
    *(Key(name, f"a solve by {strips}") for name, strips in _ELEMENTS.items()),
    Key("patch", "a solve on the plane grid"),
    Key("runs", "solves by strips, of whose times these are the medians", holds="integer"),
)
_STRIPS: Final = (
    *within(
        itemgetter(0),
        Key("strips", "number of strips", holds="integer"),
        *quantity_keys((ALONG[name] for name in ("y", "strip_width", "centre_pressure", "half_width")), ListOf()),
    ),
    Key("difference", "pressure less that of the plane grid, relative to it", get=itemgetter(1), holds=ListOf()),
)
_PATCH: Final = (
    Key("y", "centres of rows of cells", "mm", holds=ListOf()),
    *quantity_keys((ALONG[name] for name in ("centre_pressure", "half_width", "line_load")), ListOf()),
)


def _strips(name: str) -> Get:
    return lambda file: (strips := getattr(file.compared, name), file.compared.along(strips))


#: Keys of the file of a comparison.
COMPARISON: Final = (
    Key("title", "title of the case", holds="string"),
    *within(
        "compared",
        Key("cells", "cells of the plane grid, across and along", get="patch.cells", holds=ListOf("integer", 2)),
        Key("quantities", "numbers by all methods", holds=ListOf(_QUANTITY)),
        Key("stretches", "where pressures on the centre line differ by more than 1 %", holds=ListOf(_STRETCH)),
        Key("seconds", "times", "s", holds=_SECONDS),
        Key(
            "stations", "stations at which the pressure across is compared",
            holds=ListOf((Key("y", "where", "mm"), Key("reason", "reason for the station", holds="string"))),
        ),
        Key("warnings", "warnings that strain the models, a sentence each", holds=ListOf("string")),
    ),
    results.UNITS,
    *(Key(name, strips, get=_strips(name), holds=_STRIPS) for name, strips in _ELEMENTS.items()),
    Key("patch", "the plane grid", get="compared.patch", holds=_PATCH),
)  # fmt: skip


def as_object(compared: Comparison, title: str) -> dict[str, Any]:
    """Return a comparison as plain numbers, text, lists and dictionaries."""
    return results.document(COMPARISON, compared=compared, title=title)


def as_table(compared: Comparison) -> str:
    """Return all strips, and the plane grid at their centres, as CSV with a header of names and units."""
    rows = []
    for solution in compared.strips:
        of_patch = np.interp(solution.y, compared.patch.y, compared.patch.centre_pressure)
        columns = (solution.y, solution.strip_width, solution.centre_pressure, of_patch, compared.along(solution))
        rows += [[solution.element.name, *row] for row in zip(*map(plain, columns), strict=True)]
    return csv_text(_COLUMNS, rows)


def files(compared: Comparison, title: str) -> dict[str, str]:
    """Return the texts of comparison.json, comparison.csv and the numbers of the figure, by file name."""
    return {
        "comparison.json": key_by_key(as_object(compared, title)) + "\n",
        "comparison.csv": as_table(compared),
        "comparison-figure.csv": compared_methods(compared).to_csv(),
    }
