"""The largest stresses below a contact, and planes of stress, as text and as files."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from nonhertz.files import results
from nonhertz.files.results import Key, within
from nonhertz.findings import Finding
from nonhertz.model.body import BodyName
from nonhertz.result.solution import Solution
from nonhertz.result.tables import csv_text
from nonhertz.strength import Strength
from nonhertz.subsurface import Extremes, Field
from nonhertz.verdict import judge_contact

#: Names of the stresses whose largest values are searched.
LARGEST: Final = {"von_mises": "von Mises", "shear": "maximum shear", "orthogonal_shear": "orthogonal shear"}
_EXTREME: Final = (
    Key("max", "the largest", "MPa"),
    Key("x", "position across the contact", "mm"),
    Key("y", "position along it", "mm"),
    Key("z", "depth below the surface", "mm"),
    Key("at_bore", "whether that is on the bore of a hollow roller", holds="boolean"),
)
_LARGEST: Final = tuple(Key(name, f"largest {words}", holds=_EXTREME) for name, words in LARGEST.items())
_BORE: Final = Key(
    "bore", "largest von Mises stress on the bore of a hollow roller", holds=_EXTREME,
    applies=lambda largest: largest.bore is not None,
)  # fmt: skip
_STRENGTH: Final = (
    Key("criterion", "criterion of yielding", holds="string"),
    Key("verdict", "fine, over or not known", get=lambda strength: str(strength.verdict), holds="string"),
    Key("static_safety", "(pressure limit / maximum pressure)^2; null if unknown"),
    Key(
        "checks", "by name, each with verdict, ratio (a limit is exceeded above 1) and sentence", holds="object",
        get=lambda strength: {
            check.name: {"verdict": str(check.verdict), "ratio": check.ratio, "sentence": check.sentence}
            for check in strength.checks
        },
    ),
)  # fmt: skip


def _at_section(name: str) -> results.Get:
    return lambda stress: at_station(stress.solution, getattr(stress.solution, name), stress.section.von_mises.y)


#: Keys of the file of stresses.
STRESSES: Final = (
    Key("title", "title of the case", holds="string"),
    Key("status", "how the solve ended", get="solution.status.label", holds="string"),
    Key("body", "the body in which stresses were searched, a or b", get="overall.body", holds="string"),
    Key("poisson", "its Poisson's ratio", get=lambda stress: poisson(stress.solution, stress.overall.body)),
    Key("max_pressure", "maximum pressure of the contact", "MPa", "solution.max_pressure"),
    Key("overall", "largest stresses in the body", holds=(*_LARGEST, _BORE)),
    Key(
        "section", "largest stresses in a cross-section", get=lambda stress: stress,
        holds=(
            Key("y", "where it is", "mm", "section.von_mises.y"),
            Key("centre_pressure", "p0 there", "MPa", _at_section("centre_pressure")),
            Key("half_width", "half-width there", "mm", _at_section("half_width")),
            *within("section", *_LARGEST),
            replace(_BORE, get="section.bore", applies=lambda stress: stress.section.bore is not None),
        ),
    ),
    Key("strength", "whether the body withstands them", holds=_STRENGTH),
    results.verdict_key(lambda stress: judge_contact(stress.solution, (stress.strength,))),
    *results.warning_keys(lambda stress: all_findings(stress.solution, stress.overall, stress.section)),
    results.UNITS,
)  # fmt: skip
_POINT: Final = ("x", "y", "z")
_STRESSES: Final = ("sigma_x", "sigma_y", "sigma_z", "tau_yz", "tau_xz", "tau_xy", "von_mises", "max_shear")


def as_object(
    solution: Solution, overall: Extremes, section: Extremes, strength: Strength, title: str
) -> dict[str, Any]:
    """Return the largest stresses, and whether the body withstands them, as plain numbers, text and lists."""
    return results.document(
        STRESSES, title=title, solution=solution, overall=overall, section=section, strength=strength
    )


def at_station(solution: Solution, values: NDArray[np.float64], y: float) -> float:
    """Return a quantity of the strips interpolated at a station, zero outside the contact."""
    touching = any(low <= y <= high for low, high in solution.contact_y)
    return float(np.interp(y, solution.y, values)) if touching else 0.0


def as_table(field: Field) -> str:
    """Return the points of a field and the stress there as CSV with a header of names and units."""
    columns = [getattr(field, name).ravel() for name in (*_POINT, *_STRESSES)]
    # More digits than those of the quadrature would only lengthen the file.
    rows = ([f"{value:.7g}" if np.isfinite(value) else "" for value in row] for row in np.transpose(columns))
    return csv_text([*(f"{name} [mm]" for name in _POINT), *(f"{name} [MPa]" for name in _STRESSES)], rows)


def files(text: str, planes: Mapping[str, Field]) -> dict[str, str]:
    """Return the texts of stress.json, as text, and of a table for each plane, by file name."""
    return {"stress.json": text + "\n", **{f"{name}.csv": as_table(field) for name, field in planes.items()}}


def poisson(solution: Solution, body: BodyName) -> float:
    """Return Poisson's ratio of body ``"a"`` or ``"b"``, on which the stress along the contact depends."""
    return float(solution.contact.bodies[body].material.poisson)


def all_findings(solution: Solution, *stresses: Extremes) -> tuple[Finding, ...]:
    """Return the findings on a solution and on its stresses, without repeats."""
    return tuple(
        dict.fromkeys([*solution.findings, *(finding for largest in stresses for finding in largest.findings)])
    )
