"""Figure of the loads of all rollers of a row, around the bearing's axis."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import newton
from nonhertz.bearing.solution import BearingSolution
from nonhertz.figures.forces import NO_FORCE, conditions
from nonhertz.figures.value import Arrow, Axis, Bars, Colour, Dash, Figure, Mark, Panel, Points, Words

Array = NDArray[np.float64]

BAR_SHARE, WIDEST_BAR = 0.38, math.radians(8.0)
"""Width of the two bars of a roller over its pitch, and what few rollers are limited to."""
TOPS = {1.0: 0.2, 1.5: 0.5, 2.0: 0.5, 3.0: 1.0, 4.0: 1.0, 5.0: 1.0, 6.0: 2.0, 8.0: 2.0, 10.0: 2.0}
"""Round numbers up to which loads are drawn, the same over much of a drag so that bars grow; and between rings."""
RINGS: tuple[tuple[str, Colour, Dash], ...] = (("inner", "first", "solid"), ("outer", "second", "dashed"))
SPOKES = 8
SLIGHT = 1e-3  # of the largest load: smaller loads of neighbours do not affect the position of numbers


def roller_loads(solution: BearingSolution) -> Figure:
    """Return the loads of all rollers at both rings, a round panel for each row, to the same scale."""
    spokes = [(2.0 * math.pi * k / SPOKES, f"{360 * k // SPOKES}°") for k in range(SPOKES)]
    spokes[0], spokes[SPOKES // 4] = (0.0, "0° (+y)"), (0.5 * math.pi, "90° (+z)")
    along = Axis("Angle of the roller, from +y towards +z", "angle", "rad", ticks=tuple(spokes))
    panels = [_panel(solution, row) for row in range(len(solution.bearing.rows))]
    return Figure(along, panels, conditions(solution), "Loads of all rollers around the bearing's axis.")


def _panel(solution: BearingSolution, row: int) -> Panel:
    these = solution.rollers_of(row)
    angle, load = solution.angle[these], solution.load[these]
    largest = float(solution.load.max()) or 1.0
    factor, _ = newton(largest).scale
    power = 10.0 ** math.floor(math.log10(factor * largest))
    top = next(top for top in (*TOPS, 10.0) if top * power >= (1.0 - 1e-9) * factor * largest)
    rings = power / factor * np.arange(TOPS[top], top + 1e-9, TOPS[top])
    at = _emptiest(angle, load)
    bar = min(BAR_SHARE * 2.0 * math.pi / angle.size, WIDEST_BAR)
    marks: list[Mark] = [
        Bars(angle, load[:, column], bar, side * bar, name=f"load at the {ring} ring", colour=colour, dash=dash)
        for column, (side, (ring, colour, dash)) in enumerate(zip((-0.5, 0.5), RINGS, strict=True))
    ]
    loaded = load[:, 0] > 0.0
    # At speed all rollers press on the outer ring.
    without = "roller not loaded by the inner ring" if load[~loaded].any() else "roller without load"
    for which, symbol, name in ((loaded, "dot", ""), (~loaded, "circle", without)):
        if which.any():
            zeros = np.zeros(int(np.count_nonzero(which)))
            marks.append(Points(angle[which], zeros, symbol=symbol, name=name, colour="ink"))  # type: ignore[arg-type]
    marks += [Words(at, ring, f"{newton(ring):.4g}") for ring in rings.tolist()]
    marks.append(_force(solution))
    several = f", row {row + 1}" if len(solution.bearing.rows) > 1 else ""
    words = f"{np.count_nonzero(loaded)} of {angle.size} rollers loaded, "
    words += f"load zone {math.degrees(solution.load_zone[row]):.3g}°{_largest(angle, load)}"
    circles = tuple((ring, "") for ring in rings.tolist())
    return Panel(
        f"loads{row + 1}",
        f"Loads of all rollers{several}",
        Axis("Load", "load", "N", range=(0.0, top * power / factor), ticks=circles),
        marks,
        f"Loads of the rollers around the axis{several}: {words}.",
        words,
        round=True,
    )


def _largest(angle: Array, load: Array) -> str:
    if not load.any():
        return ""
    most = int(load.max(axis=1).argmax())
    return f"; largest {newton(float(load[most].max())):.4g} at {math.degrees(angle[most]):.4g}°"


def _emptiest(angle: Array, load: Array) -> float:
    """Return the angle between the two least loaded neighbours, the uppermost of such places."""
    between, pair = angle + math.pi / angle.size, load.sum(axis=1) + np.roll(load.sum(axis=1), -1)
    return float(between[(pair + SLIGHT * float(load.max()) * np.cos(between)).argmin()] if load.any() else math.pi)


def _force(solution: BearingSolution) -> Mark:
    """Return the radial force on the inner ring, on all rows together."""
    along_y, along_z = solution.force[1:3].tolist()
    radial = math.hypot(along_y, along_z)
    if radial <= NO_FORCE * float(solution.load.sum()):
        return Arrow(math.nan, "no radial\nforce", colour="faint")
    return Arrow(math.atan2(along_z, along_y), f"{newton(radial):.4g}", colour="ink")
