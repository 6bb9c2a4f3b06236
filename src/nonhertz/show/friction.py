"""Friction of a bearing, its thermal speed rating, and the limits that manufacturers publish, in rows."""

from __future__ import annotations

from nonhertz.amounts import format_digits, newton_mm
from nonhertz.bearing.friction import Friction
from nonhertz.bearing.solution import BearingSolution
from nonhertz.errors import join_words
from nonhertz.files.bearingfile import BearingCase
from nonhertz.show.sections import Row, Section, summary

_NAMES = {
    "rib-limit": "axial load on ribs",
    "least-load": "minimum load",
    "hoop-stress": "hoop stress of rings",
    "speed": "speed",
    "preload-lost": "preload",
    "additives": "additives",
}


def friction_rows(case: BearingCase, solution: BearingSolution) -> list[Row]:
    """Return name, value and remark of torque, power and thermal speed; if unknown, the missing inputs."""
    row = case.bearing.rows[0].bearing
    missing = [f"bearing.{name}" for name in ("series", "bore", "outside_diameter") if getattr(row, name) is None]
    missing += [] if case.prescribed.speed else ["load.speed"]
    missing += [] if case.lubrication.in_place.viscosity else ["an oil in [lubrication]"]
    friction, limit = case.friction(solution), case.thermal_speed
    rows = [("friction torque", "not known", f"give {join_words(missing)}" if missing else "no published factors")]
    if friction is not None:
        rows = _torque_rows(friction)
    if limit is not None:
        rows.append(("thermal speed", f"{format_digits(limit, 3)} 1/min", "rating of ISO 15312"))
    elif not missing and row.width is None:
        rows.append(("thermal speed", "not known", "give bearing.width"))
    return rows


def sections(friction: Friction) -> list[Section]:
    """Return the sections on the friction of a bearing."""
    return [Section("Friction", [summary(_torque_rows(friction))])]


def _torque_rows(friction: Friction) -> list[Row]:
    return [
        ("friction torque", f"{newton_mm(friction.torque):3}", "empirical, after Palmgren"),
        ("", f"{newton_mm(friction.speed_torque):3}", "by speed and oil, M0"),
        ("", f"{newton_mm(friction.load_torque):3}", "by load, M1"),
        *([("", "not known", "by ribs, M2: published as a chart")] if friction.axial else []),
        ("power loss", f"{format_digits(friction.power, 3)} W", ""),
    ]


def limit_rows(case: BearingCase, solution: BearingSolution) -> list[Row]:
    """Return the limits of manufacturers: name, whether the limit is met, and the sentence."""
    words = {True: "met", False: "not met", None: "not judged"}
    return [(_NAMES[limit.kind], words[met], str(limit)) for met, limit in case.limits(solution)]
