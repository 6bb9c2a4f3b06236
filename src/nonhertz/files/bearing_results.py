"""A loaded bearing as text and as files: one JSON object, a table of rollers, and one of lines of contact."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any

from nonhertz.amounts import read_in
from nonhertz.bearing.bearings import TaperedRollerBearing
from nonhertz.bearing.quantities import SolvedBearing, further
from nonhertz.bearing.section import FORCES, MOTIONS, RINGS
from nonhertz.bearing.solution import CONTACT_UNITS, BearingSolution, slice_loads
from nonhertz.files.bounds import FORMAT
from nonhertz.files.results import key_by_key, plain
from nonhertz.findings import as_warnings
from nonhertz.result.tables import csv_text
from nonhertz.verdict import findings_of, given_verdict, of_bearing

if TYPE_CHECKING:
    from nonhertz.bearing.assessed import BearingLife
    from nonhertz.files.bearingfile import BearingCase

_FORCE, _MOMENT = "N", "N mm"
_OF_FIT = {
    **dict.fromkeys(("mounted_pressure", "pressure", "seat_stress", "raceway_stress"), "MPa"),
    "loosening_speed": "1/min",
    "temperature_step": "K",
}
_LOST = "lost_to_inner_fit", "lost_to_outer_fit", "lost_to_temperatures", "lost_to_speed"
_OF_CLEARANCE = ("unmounted", *_LOST, "clearance")
#: Units of the numbers in a result; dimensionless ones are left out.
UNITS: dict[str, Any] = {
    **CONTACT_UNITS,
    "each_rib_load": _FORCE,
    "roller_load": [_FORCE, _FORCE, _MOMENT],
    "displacement": list(MOTIONS.values()),
    "force": list(FORCES.values()),
    "stiffness": [[f"{force}/{motion}" for motion in MOTIONS.values()] for force in FORCES.values()],
    "edge_stiffness": "N/mm",
    "x": "mm",
    "operating_clearance": {
        **dict.fromkeys((*_OF_CLEARANCE, "axial", "expansion"), "mm"),
        **dict.fromkeys(RINGS, _OF_FIT),
    },
    "life": {
        "rating": dict.fromkeys(("dynamic", "static", "inner", "outer", "fatigue_limit"), _FORCE),
        "equivalent_load": _FORCE,
        "static_load": _FORCE,
        **dict.fromkeys(("basic_life", "reference_life", "modified_life", "rated_life"), "10^6 revolutions"),
    },
}
_OF_RING = ("roller_load", "displacement", "force", "stiffness", "edge_rollers", "edge_stiffness", "residual")
_OF_CONTACTS = ("load", "moment", "approach", "tilt", "contact_angle")
_OF_LIFE = (
    *(
        "equivalent_load",
        "static_load",
        "basic_life",
        "reference_life",
        "viscosity_ratio",
        "contamination",
        "life_factor",
    ),
    *("reliability_factor", "modified_life", "rated_life", "static_safety"),
)


@read_in("si")
def as_object(solution: BearingSolution, case: BearingCase, life: BearingLife | None, reason: str) -> dict[str, Any]:
    """Return a loaded bearing as plain numbers, text, lists and dictionaries, with the case it belongs to.

    `nonhertz.files.resultfile.read_result` reads it back.

    Numbers are unrounded; a non-finite one, such as the life of a bearing without load, is None, since JSON has no
    infinity.
    """
    bearing = solution.bearing.rows[0].bearing
    pressures = solution.method == "strips"
    return {
        "format": FORMAT,
        "title": case.title,
        "method": solution.method,
        "models": {name: getattr(bearing, name).model for name in ("roller", *RINGS)},
        "operating_clearance": _clearance(case),
        "row": [k for k, row in enumerate(solution.bearing.rows, start=1) for _ in range(row.bearing.rollers)],
        "x": [row.x for row in solution.bearing.rows for _ in range(row.bearing.rollers)],
        **{name: plain(getattr(solution, name)) for name in ("angle", *_OF_CONTACTS, "rib_load", "each_rib_load")},
        **{name: plain(getattr(solution, name)) if pressures else None for name in ("max_pressure", "max_pressure_y")},
        **{name: plain(getattr(solution, name)) for name in _OF_RING},
        **{each.name: plain(value) for each, value in further(SolvedBearing(case, solution))},
        "iterations": solution.iterations,
        "life": None if life is None else _life(life),
        "life_reason": reason,
        "assumed": [each.as_object() for each in case.assumed],
        "verdict": given_verdict(of_bearing(solution, life, case.operating_clearance)),
        **as_warnings(findings_of(solution, life, case.operating_clearance)),
        "units": UNITS,
        "case": case.own_document,
    }


def _clearance(case: BearingCase) -> dict[str, Any] | None:
    """Return what is left of the clearance of a row, and what took it; None without fits."""
    found = case.operating_clearance
    if found is None or case.fit is None:
        return None
    row = case.bearing.rows[0].bearing
    numbers = {name: plain(getattr(found, name)) for name in _OF_CLEARANCE}
    axial = {"axial": plain(found.axial(row.nominal_angle))} if isinstance(row, TaperedRollerBearing) else {}
    fits = {ring: plain(vars(getattr(found, ring))) for ring in RINGS}
    return numbers | axial | {"expansion": case.fit.expansion(case.bearing)} | fits


def _life(found: BearingLife) -> dict[str, Any]:
    rating = plain(dataclasses.asdict(found.rating))
    parts = [{"share": plain(share)} | _life(part) for part, share in found.parts]
    numbers = {name: plain(getattr(found, name)) for name in _OF_LIFE}
    return {
        "rating": rating,
        **numbers,
        "no_reference": found.no_reference,
        "no_modified": found.no_modified,
        "parts": parts,
    }


def rollers_table(solution: BearingSolution) -> str:
    """Return the rollers as CSV with a header of names and units; cells without a number are empty."""
    names = [*_OF_CONTACTS, *(("max_pressure", "max_pressure_y") if solution.method == "strips" else ())]
    head = ["roller", "row", "angle [rad]", *(f"{name}_{ring} [{UNITS[name]}]" for name in names for ring in RINGS)]
    columns = [getattr(solution, name)[:, k] for name in names for k in range(len(RINGS))]
    rows = [k for k, row in enumerate(solution.bearing.rows, start=1) for _ in range(row.bearing.rollers)]
    cells = zip(range(solution.angle.size), rows, solution.angle, *columns, *solution.rib_load.T, strict=True)
    ribs = [f"rib_load_{ring} [N]" for ring in RINGS]
    return csv_text([*head, *ribs], (map(_cell, each) for each in cells))


def lines_table(solution: BearingSolution, laminae: int) -> str:
    """Return line load and pressure along all loaded contacts as CSV with a header of names and units.

    Parameters
    ----------
    solution : BearingSolution
        The loaded bearing.
    laminae : int
        Number of slices, where it was solved by them; they have no pressure.
    """
    if solution.method == "strips":
        head = ["roller", "ring", "y [mm]", "strip_width [mm]", "line_load [N/mm]"]
        return csv_text([*head, "centre_pressure [MPa]", "half_width [mm]"], _strips(solution))
    return csv_text(["roller", "ring", "y [mm]", "strip_width [mm]", "line_load [N/mm]"], _slices(solution, laminae))


def _strips(solution: BearingSolution) -> Iterator[Iterable[Any]]:
    for j in range(solution.angle.size):
        for ring in RINGS:
            contact = solution.contact(j, ring)
            if contact is not None:
                columns = (
                    contact.y, contact.strip_width, contact.line_load, contact.centre_pressure, contact.half_width
                )  # fmt: skip
                for numbers in zip(*(column.tolist() for column in columns), strict=True):
                    yield j, ring, *numbers


def _slices(solution: BearingSolution, laminae: int) -> Iterator[Iterable[Any]]:
    for row, (slices, loads) in zip(solution.bearing.rows, slice_loads(solution, laminae), strict=True):
        width = float(slices.y[1] - slices.y[0])
        for j, of_roller in enumerate(loads.tolist(), start=row.first):
            for k, ring in enumerate(RINGS):
                if solution.load[j, k] > 0.0:
                    for y, load in zip(slices.y.tolist(), of_roller[k], strict=True):
                        yield j, ring, y, width, load / width


@read_in("si")
def files(solution: BearingSolution, case: BearingCase, life: BearingLife | None, reason: str) -> dict[str, str]:
    """Return the texts of result.json, rollers.csv and lines.csv, by file name."""
    return {
        "result.json": key_by_key(as_object(solution, case, life, reason)) + "\n",
        "rollers.csv": rollers_table(solution),
        "lines.csv": lines_table(solution, case.solver.laminae),
    }


@read_in("si")
def comparison_object(strips: BearingSolution, slices: BearingSolution, title: str) -> dict[str, Any]:
    """Return both methods' loads and motions, and how far slices are from strips, as plain numbers."""
    names = ("load", "moment", "displacement", "force")
    return {
        "title": title,
        "angle": plain(strips.angle),
        **{each.method: {name: plain(getattr(each, name)) for name in names} for each in (strips, slices)},
        "differences": {name: plain(getattr(slices, name) - getattr(strips, name)) for name in names},
        "units": {name: UNITS[name] for name in ("angle", *names)},
    }


def comparison_table(strips: BearingSolution, slices: BearingSolution) -> str:
    """Return both methods' loads as CSV with a header of names and units."""
    head = [
        "roller",
        "angle [rad]",
        *(f"load_{ring}_{method} [N]" for ring in RINGS for method in ("strips", "slices")),
    ]
    columns = [each.load[:, k] for k in range(len(RINGS)) for each in (strips, slices)]
    cells = zip(range(strips.angle.size), strips.angle, *columns, strict=True)
    return csv_text(head, (map(_cell, each) for each in cells))


@read_in("si")
def comparison_files(strips: BearingSolution, slices: BearingSolution, title: str) -> dict[str, str]:
    """Return the texts of comparison.json and comparison.csv, by file name."""
    return {
        "comparison.json": key_by_key(comparison_object(strips, slices, title)) + "\n",
        "comparison.csv": comparison_table(strips, slices),
    }


def _cell(value: Any) -> Any:
    return value if isinstance(value, int) else plain(value)
