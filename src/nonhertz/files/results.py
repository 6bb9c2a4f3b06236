"""A solution as text and as files: one JSON object, one table, and whatever figures the caller draws."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from nonhertz.amounts import read_in
from nonhertz.files.bounds import FORMAT
from nonhertz.findings import Finding, as_warnings
from nonhertz.model.body import BODIES
from nonhertz.result.quantities import ALONG, QUANTITIES
from nonhertz.result.solution import Solution
from nonhertz.result.tables import csv_text
from nonhertz.verdict import given_verdict, of_contact

if TYPE_CHECKING:
    from nonhertz.files.casefile import Case

#: Quantities that are written as single numbers; the stiffness is written as a matrix.
NUMBERS = tuple(name for name, quantity in QUANTITIES.items() if not quantity.within)

#: Units of the numbers in a result; dimensionless ones are left out.
UNITS: dict[str, Any] = {
    **{name: QUANTITIES[name].unit for name in NUMBERS},
    "contact_y": "mm",
    "edge_pressure": {
        "y": "mm",
        "pressure": "MPa",
        "strip_width": "mm",
        "strength": "MPa mm^exponent",
        "correction": "mm^-correction_exponent",
    },
    "singular_ends": {"y": "mm"},
    "stiffness": [["N/mm", "N/rad"], ["N mm/mm", "N mm/rad"]],
    **ALONG,
    "edges": "mm",
    "element_half_width": "mm",
}


@read_in("si")
def as_object(solution: Solution, case: Case) -> dict[str, Any]:
    """Return a solution as plain numbers, text, lists and dictionaries, with the case it belongs to.

    `nonhertz.files.resultfile.read_result` reads it back.

    Numbers are unrounded; a non-finite one, such as the error estimate of a maximum pressure at a corner of the
    profile, is None, since JSON has no infinity.
    """
    return {
        "format": FORMAT,
        "title": case.title,
        "status": solution.status.label,
        "element": solution.element.name,
        "models": {name: getattr(solution.contact, name).model for name in BODIES},
        **{name: plain(QUANTITIES[name].get(solution)) for name in NUMBERS},
        "contact_y": plain(solution.contact_y),
        "edge_pressure": [
            plain(vars(edge) | {"kind": edge.kind.label, "converges": edge.converges})
            for edge in solution.edge_pressure
        ],
        "singular_ends": [{"y": plain(end.y), "kind": end.kind.label} for end in solution.singular_ends],
        "stiffness": plain(solution.stiffness),
        "peaks_at_corner": solution.peaks_at_corner,
        "iterations": int(solution.iterations),
        "strips": solution.strips,
        "error_estimate": plain(vars(solution.error_estimate)),
        "verdict": given_verdict(of_contact(solution)),
        "assumed": [each.as_object() for each in case.assumed],
        **as_warnings(solution.findings),
        **({"remarks": [each.as_object() for each in solution.remarks]} if solution.remarks else {}),
        "units": UNITS,
        **{name: plain(column) for name, column in solution.table().items()},
        "edges": plain(solution.edges),
        "element_half_width": plain(solution.element_half_width),
        "case": case.own_document,
    }


def plain(value: Any) -> Any:
    """Return a number, or numbers nested in arrays, lists, tuples and mappings, in a form that JSON can represent.

    Text and truth values stay as they are, and findings become text.

    Examples
    --------
    >>> plain(np.array([1.0, np.inf])), plain({"load": 1, "kind": "finite"})
    ([1.0, None], {'load': 1.0, 'kind': 'finite'})
    """
    if value is None or isinstance(value, str | bool):
        return value
    if isinstance(value, Finding):
        return str(value)
    if isinstance(value, Mapping):
        return {name: plain(entry) for name, entry in value.items()}
    if isinstance(value, np.ndarray):
        # Far faster, and most are finite.
        return value.tolist() if value.dtype.kind == "f" and np.isfinite(value).all() else plain(value.tolist())
    if isinstance(value, list | tuple):
        return [plain(entry) for entry in value]
    number = float(value)
    return number if math.isfinite(number) else None


def key_by_key(entries: dict[str, Any]) -> str:
    """Return an object as JSON text, one of its keys per line.

    Examples
    --------
    >>> print(key_by_key({"load": 1.0, "y": [0.0, 1.0]}))
    {
      "load": 1.0,
      "y": [0.0, 1.0]
    }
    """
    lines = (f"  {json.dumps(key)}: {json.dumps(value, allow_nan=False)}" for key, value in entries.items())
    return "{\n" + ",\n".join(lines) + "\n}"


def as_table(solution: Solution) -> str:
    """Return the strips as CSV with a header of names and units."""
    columns = (column.tolist() for column in solution.table().values())
    return csv_text((f"{name} [{unit}]" for name, unit in ALONG.items()), zip(*columns, strict=True))


@read_in("si")
def files(solution: Solution, case: Case) -> dict[str, str]:
    """Return the texts of result.json and table.csv, by file name."""
    return {"result.json": key_by_key(as_object(solution, case)) + "\n", "table.csv": as_table(solution)}
