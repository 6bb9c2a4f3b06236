"""The displacement of the inner ring under more and less than a bearing's load."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from nonhertz import bearing
from nonhertz.amounts import um
from nonhertz.bearing.equilibrium import drop_tilt_rounding
from nonhertz.errors import ConvergenceError, InputError, without_accuracy_warnings
from nonhertz.figures.forces import NO_FORCE, conditions, directions
from nonhertz.figures.value import Axis, Figure, Line, Mark, Panel, Points

if TYPE_CHECKING:
    from nonhertz.bearing import BearingMaps, BearingSolution

Array = NDArray[np.float64]

# Multiples of the load: close together where clearance makes the curve steep.
MULTIPLES = 1.5 * (np.arange(1, 7) / 6.0) ** 2
POINTS = 201
TANGENT = 0.5  # of the load, to both sides
ROOM = 1.08  # upper end of the axis over the largest displacement


def displacement_against_load(solution: BearingSolution, maps: BearingMaps | None = None) -> Figure:
    """Return the figure of `nonhertz.plot.displacement_against_load`."""
    from scipy.interpolate import CubicHermiteSpline

    ways = directions(solution)
    if not ways:
        raise InputError("solution", "without force", "have a force on the inner ring", "give a radial or an axial one")
    load = float(np.linalg.norm(solution.force[:3]))
    multiples, curve = _curve(solution, maps)
    reached = np.isfinite(curve[0, :, 0])
    others = reached & (multiples != 1.0)
    fine = np.linspace(multiples[reached][0], multiples[reached][-1], POINTS) if reached.sum() > 1 else multiples[:0]
    by = "maps" if maps is not None else solution.method
    slope = _slope(solution.stiffness, solution.force)
    marks: list[Mark] = []
    words, highest, lowest = [], 0.0, 0.0
    for (label, way), second in zip(ways.items(), (False, True), strict=False):
        at, rise = float(solution.displacement[:3] @ way), TANGENT * float(slope @ way)
        moved, rising = curve @ way
        style: dict[str, Any] = {"colour": "second" if second else "first"}
        if fine.size:
            # Smooth, with the slopes of the states that were solved.
            line = CubicHermiteSpline(multiples[reached], moved[reached], rising[reached])(fine)
            style_of_line = style | {"dash": "dashed" if second else "solid"}
            marks.append(Line(load * fine, line, name=f"{label} by {by}", **style_of_line))
            marks.append(Points(load * multiples[others], moved[others], symbol="dot", **style))
            highest, lowest = max(highest, float(line.max())), min(lowest, float(line.min()))
        ends = load * np.array([1.0 - TANGENT, 1.0 + TANGENT])
        tangent = "" if second else "tangent: stiffness of the state"
        marks.append(Line(ends, np.array([at - rise, at + rise]), name=tangent, colour="ink", dash="dotted"))
        marks.append(
            Points(np.array([load]), np.array([at]), name=f"{label}, {um(at):.4g} by {solution.method}", **style)
        )
        highest, lowest = max(highest, at), min(lowest, at)
        words.append(f"{label} {um(at):.4g}")
    panel = Panel(
        "displacement",
        "Displacement against load",
        Axis("Displacement of the inner ring", "displacement", "mm", "um", (ROOM * lowest, ROOM * highest)),
        marks,
        f"Displacement of the inner ring under up to 1.5 times the load: {' and '.join(words)} under the load itself.",
        height=260,
    )
    along = Axis("Force on the inner ring", "force", "N", range=(0.0, 1.04 * float(MULTIPLES[-1]) * load))
    caption = "Displacement of the inner ring along the force under up to 1.5 times the load."
    return Figure(along, (panel,), conditions(solution), caption)


def _curve(solution: BearingSolution, maps: BearingMaps | None) -> tuple[Array, Array]:
    """Return multiples of the forces, and displacements and their derivatives by the multiple, (2, multiples, 3) [mm].

    They are NaN where no solution was found.
    """
    forces = _forces(solution)
    rotation = drop_tilt_rounding(solution.displacement[3:])
    how: dict[str, Any] = {
        "method": solution.method if maps is None else maps,
        "speed": solution.speed,
        "turning": solution.turning,
        "tilt": tuple(rotation.tolist()),
    }
    states = {multiple: _one(solution, {k: multiple * v for k, v in forces.items()}, how) for multiple in MULTIPLES}
    if maps is None:
        states[1.0] = solution
    multiples = np.array(sorted(states))
    moved = np.full((2, multiples.size, 3), np.nan)
    for place, multiple in enumerate(multiples):
        if (state := states[multiple]) is not None:
            moved[:, place] = state.displacement[:3], _slope(state.stiffness, state.force) / multiple
    return multiples, moved


def _forces(solution: BearingSolution) -> dict[str, Any]:
    """Return the axial and the radial force on the inner ring, if its rows support them."""
    rows = [row.bearing for row in solution.bearing.rows]
    least = NO_FORCE * float(solution.load.sum())
    force = np.where(np.abs(solution.force[:3]) > least, solution.force[:3], 0.0)
    axial = {"axial": force[0]} if any(any(row.bears_axially) for row in rows) else {}
    return axial | ({"radial": force[1:]} if any(row.bears_radially for row in rows) else {})


def _one(solution: BearingSolution, forces: dict[str, Any], how: dict[str, Any]) -> BearingSolution | None:
    with without_accuracy_warnings():
        try:
            return bearing.solve(solution.bearing, **forces, **how)
        except ConvergenceError:
            return None
        except InputError:
            if not isinstance(how["method"], str):
                raise
            return None  # half as much load more may be beyond the model


def _slope(stiffness: Array, force: Array) -> Array:
    """Return the displacement of the ring under its forces by its tangent stiffness [mm], with its rotation fixed."""
    stiffness, force = stiffness[:3, :3], force[:3]
    supported = np.diag(stiffness) > 1e-12 * float(np.max(np.diag(stiffness)))
    slope = np.zeros(3)
    slope[supported] = np.linalg.lstsq(stiffness[np.ix_(supported, supported)], force[supported], rcond=1e-12)[0]
    return slope
