"""The largest stresses below a contact, and planes of stress, as text and as files."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import read_in
from nonhertz.files.results import plain
from nonhertz.findings import Finding, as_warnings
from nonhertz.model.body import BodyName
from nonhertz.result.solution import Solution
from nonhertz.result.tables import csv_text
from nonhertz.strength import Strength
from nonhertz.subsurface import Extreme, Extremes, Field
from nonhertz.verdict import given_verdict, of_contact

_EXTREME = {"max": "MPa", "x": "mm", "y": "mm", "z": "mm"}
_QUANTITIES = ("von_mises", "shear", "orthogonal_shear")
_UNITS_OF_ALL = dict.fromkeys(_QUANTITIES, _EXTREME)

#: Units of the numbers; dimensionless ones are left out.
UNITS: dict[str, Any] = {
    "max_pressure": "MPa",
    "overall": _UNITS_OF_ALL,
    "section": {"y": "mm", "centre_pressure": "MPa", "half_width": "mm", **_UNITS_OF_ALL},
}
_COORDINATES = ("x", "y", "z")
_STRESSES = ("sigma_x", "sigma_y", "sigma_z", "tau_yz", "tau_xz", "tau_xy", "von_mises", "max_shear")


@read_in("si")
def as_object(
    solution: Solution, overall: Extremes, section: Extremes, strength: Strength, title: str
) -> dict[str, Any]:
    """Return the largest stresses, and whether the body bears them, as plain numbers, text, lists and dictionaries.

    Non-finite numbers are None.
    """
    y = section.von_mises.y
    return {
        "title": title,
        "status": solution.status.label,
        "body": overall.body,
        "poisson": plain(poisson(solution, overall.body)),
        "max_pressure": plain(solution.max_pressure),
        "overall": _largest(overall),
        "section": {
            "y": plain(y),
            "centre_pressure": plain(there(solution, solution.centre_pressure, y)),
            "half_width": plain(there(solution, solution.half_width, y)),
            **_largest(section),
        },
        "strength": _strength(strength),
        "verdict": given_verdict(of_contact(solution, (strength,))),
        **as_warnings(all_findings(solution, overall, section)),
        "units": UNITS,
    }


def there(solution: Solution, values: NDArray[np.float64], y: float) -> float:
    """Return a quantity of the strips interpolated at a station, zero outside the contact."""
    touching = any(low <= y <= high for low, high in solution.contact_y)
    return float(np.interp(y, solution.y, values)) if touching else 0.0


def as_table(field: Field) -> str:
    """Return the points of a field and the stress there as CSV with a header of names and units."""
    columns = [getattr(field, name).ravel() for name in (*_COORDINATES, *_STRESSES)]
    # More digits than the quadrature has would only make the file longer.
    rows = ([f"{value:.7g}" if np.isfinite(value) else "" for value in row] for row in np.transpose(columns))
    return csv_text([*(f"{name} [mm]" for name in _COORDINATES), *(f"{name} [MPa]" for name in _STRESSES)], rows)


def files(text: str, planes: Mapping[str, Field]) -> dict[str, str]:
    """Return the texts of stress.json, as text, and of a table for each plane, by file name."""
    return {"stress.json": text + "\n", **{f"{name}.csv": as_table(field) for name, field in planes.items()}}


def poisson(solution: Solution, body: BodyName) -> float:
    """Return Poisson's ratio of body ``"a"`` or ``"b"``, on which the stress along the contact depends."""
    return float({"a": solution.contact.a, "b": solution.contact.b}[body].material.poisson)


def all_findings(solution: Solution, *found: Extremes) -> tuple[Finding, ...]:
    """Return what is found of a solution and of the stresses in it, without repeats."""
    return tuple(dict.fromkeys([*solution.findings, *(one for each in found for one in each.findings)]))


def _strength(found: Strength) -> dict[str, Any]:
    checks = {
        each.name: {"verdict": str(each.verdict), "ratio": plain(each.ratio), "sentence": each.sentence}
        for each in found.checks
    }
    return {
        "criterion": found.criterion,
        "verdict": str(found.verdict),
        "static_safety": plain(found.static_safety),
        "checks": checks,
    }


def _largest(found: Extremes) -> dict[str, Any]:
    bore = {} if found.bore is None else {"bore": _extreme(found.bore)}
    return {**{name: _extreme(getattr(found, name)) for name in _QUANTITIES}, **bore}


def _extreme(found: Extreme) -> dict[str, Any]:
    return {**{name: plain(getattr(found, name)) for name in _EXTREME}, "at_bore": found.at_bore}
