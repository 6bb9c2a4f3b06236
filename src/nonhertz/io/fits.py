"""Bearings with the clearance that fits, temperatures and speed leave."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from nonhertz.bearing.bearings import Paired, RollerBearing, TaperedRollerBearing
from nonhertz.bearing.clearance import OperatingClearance, axial_expansion, operating_clearance

#: Keywords of `nonhertz.bearing.operating_clearance`, but for the bearing and the speed, which is that of the load.
FIT = (
    *("shaft", "housing", "inner_temperature", "roller_temperature", "outer_temperature"),
    *("ring_expansion", "roller_expansion", "ring_density"),
)


def operating(row: RollerBearing, fit: Mapping[str, Any], speed: float | None) -> OperatingClearance:
    """Return what fits, temperatures and speed leave of the clearance of a row.

    Raises
    ------
    InputError
        If a seat does not fit the rings, or the bearing has no such clearance.
    """
    return operating_clearance(row, **fit, speed=abs(speed or 0.0))


def expanded(bearing: RollerBearing | Paired, fit: Mapping[str, Any]) -> float:
    """Return by how much temperatures widen the clearance between rows of rollers [mm]; 0 of a single row."""
    names = ("inner_temperature", "outer_temperature", "ring_expansion")
    given = {name: fit[name] for name in names if name in fit}
    return axial_expansion(bearing, **given) if isinstance(bearing, Paired) else 0.0


def mounted(bearing: RollerBearing | Paired, fit: Mapping[str, Any], speed: float | None) -> RollerBearing | Paired:
    """Return a bearing with the clearance that is left; rows of a pair have the same seats, and move apart when warm.

    Raises
    ------
    InputError
        As `operating` does, or if what is left is not a clearance that a bearing can have.
    """
    if isinstance(bearing, Paired):
        rows = tuple(_mounted(row, fit, speed) for row in bearing.bearings)
        return replace(bearing, bearings=rows, clearance=bearing.clearance + expanded(bearing, fit))
    return _mounted(bearing, fit, speed)


def _mounted(row: RollerBearing, fit: Mapping[str, Any], speed: float | None) -> RollerBearing:
    found = operating(row, fit, speed)
    left = found.axial(row.nominal_angle) if isinstance(row, TaperedRollerBearing) else found.clearance
    return replace(row, clearance=left)  # type: ignore[call-arg]
