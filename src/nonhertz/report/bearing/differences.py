"""Several bearings side by side: how their results differ from those of the first."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np

from nonhertz.amounts import Amount, amount, mpa, mrad, newton, newton_mm, um
from nonhertz.bearing.assessed import BearingLife
from nonhertz.bearing.balance import NO_LOAD
from nonhertz.bearing.solution import BearingSolution
from nonhertz.report.bearing.results import BearingResults
from nonhertz.report.differences import ABSENT, Row, compared
from nonhertz.show.bearing import carrying

# What is rounding beside the largest is zero.


def _stiffness(*values: float) -> Amount:
    return amount(values, "N/mm", "N/um")


def _tilting(*values: float) -> Amount:
    return amount(values, "N mm/rad", "N m/mrad")


def _moved(found: BearingSolution, axis: int) -> float:
    return _beside(float(found.displacement[axis]), float(np.max(np.abs(found.displacement[:3]))))


def _tilt(found: BearingSolution, axis: int) -> float:
    pitch = found.bearing.rows[0].bearing.pitch
    return _beside(float(found.displacement[axis]), float(np.max(np.abs(found.displacement[:3]))) / pitch)


def _moment_about_z(found: BearingSolution) -> float:
    pitch = found.bearing.rows[0].bearing.pitch
    return _beside(float(found.force[4]), float(np.max(np.abs(found.force[:3]))) * pitch)


def _beside(value: float, largest: float) -> float:
    return value if abs(value) > NO_LOAD * largest else 0.0


_OF_SOLUTION: dict[str, tuple[Callable[..., Amount], Callable[[BearingSolution], float]]] = {
    "largest load": (newton, lambda found: float(found.load.max())),
    "displacement along x": (um, lambda found: _moved(found, 0)),
    "displacement along y": (um, lambda found: _moved(found, 1)),
    "displacement along z": (um, lambda found: _moved(found, 2)),
    "tilt about y": (mrad, lambda found: _tilt(found, 3)),
    "tilt about z": (mrad, lambda found: _tilt(found, 4)),
    "moment about z": (newton_mm, _moment_about_z),
    "stiffness along x": (_stiffness, lambda found: float(found.stiffness[0, 0])),
    "stiffness along y": (_stiffness, lambda found: float(found.stiffness[1, 1])),
    "stiffness about z": (_tilting, lambda found: float(found.stiffness[4, 4])),
    "largest load of a rib": (newton, lambda found: float(found.rib_load.max(initial=0.0))),
}
_OF_LIFE: dict[str, tuple[str, Callable[[BearingLife], float]]] = {
    "static safety S0": ("", lambda life: life.static_safety),
    "L10": ("10^6 revolutions", lambda life: life.basic),
    "L10r": ("10^6 revolutions", lambda life: life.reference),
    "modified life": ("10^6 revolutions", lambda life: life.modified),
}


def bearing_differences(found: Sequence[BearingResults]) -> list[Row]:
    """Return the results of all bearings, with differences from the first; what none has is left out."""
    rows = [
        compared(f"maximum pressure, {ring} ring", mpa(*(_pressure(each.solution, k) for each in found)))
        for k, ring in enumerate(("inner", "outer"))
    ]
    rows.append(_loaded(found))
    for name, (kind, of_solution) in _OF_SOLUTION.items():
        values = [math.nan if each.solution is None else of_solution(each.solution) for each in found]
        rows += [compared(name, kind(*values))] if any(value and math.isfinite(value) for value in values) else []
    for name, (unit, of_life) in _OF_LIFE.items():
        values = [math.nan if each.life is None else of_life(each.life) for each in found]
        rows.append(compared(name, amount(values, unit)))
    return [row for row in rows if len(set(row.values)) > 1 or ABSENT not in row.values]


def _pressure(solution: BearingSolution | None, ring: int) -> float:
    if solution is None or solution.method != "strips":
        return math.nan
    return float(solution.max_pressure[:, ring].max())


def _loaded(found: Sequence[BearingResults]) -> Row:
    counts = [None if each.solution is None else int(np.count_nonzero(carrying(each.solution))) for each in found]
    return Row("loaded rollers", tuple(ABSENT if count is None else str(count) for count in counts))
