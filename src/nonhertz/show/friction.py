"""Friction of a bearing, its thermal speed rating, and what its ribs may bear, in rows."""

from __future__ import annotations

from nonhertz.amounts import digits, newton_mm
from nonhertz.bearing.solution import BearingSolution
from nonhertz.errors import joined
from nonhertz.files.bearingfile import BearingCase
from nonhertz.show.sections import Row

_EMPIRICAL = "empirical, after Palmgren: real ones may differ considerably"
_NO_RIBS = "; without the rubbing of ribs, for which only a chart is published"


def friction_rows(case: BearingCase, solution: BearingSolution) -> list[Row]:
    """Return name, value and remark of torque, power and thermal speed; what is missing if they are not known."""
    row = case.bearing.rows[0].bearing
    missing = [f"bearing.{name}" for name in ("series", "bore", "outside_diameter") if getattr(row, name) is None]
    missing += [] if case.prescribed.speed else ["load.speed"]
    missing += [] if case.lubrication.in_place.viscosity else ["an oil in [lubrication]"]
    found, limit = case.friction(solution), case.thermal_speed
    rows = [("friction torque", "not known", f"give {joined(missing)}" if missing else "none published for such rows")]
    if found is not None:
        parts = newton_mm(found.speed_torque), newton_mm(found.load_torque)
        rows = [
            (
                "friction torque",
                f"{newton_mm(found.torque):3}",
                f"{parts[0]:3} by speed and oil, {parts[1]:3} by load{_NO_RIBS if found.axial else ''}",
            ),
            ("power loss", f"{digits(found.power, 3)} W", _EMPIRICAL),
        ]
    if limit is not None:
        rows.append(("thermal speed", f"{digits(limit, 3)} 1/min", "speed rating of ISO 15312: 70 °C under 0.05 C0"))
    elif not missing and row.width is None:
        rows.append(("thermal speed", "not known", "give bearing.width"))
    return rows
