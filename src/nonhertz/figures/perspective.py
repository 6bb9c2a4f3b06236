"""The pressures of all rollers unrolled and in perspective: each is a ridge at its angle, along y into the depth.

The projection is oblique: places along y go to the right and up, so that angles and pressures stay to scale.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from nonhertz.amounts import mm, mpa
from nonhertz.bearing.section import RINGS
from nonhertz.bearing.solution import BearingSolution
from nonhertz.figures.angles import around, loaded_middle, turn_axis
from nonhertz.figures.forces import conditions
from nonhertz.figures.roller import STYLES
from nonhertz.figures.unrolled import ring_heading
from nonhertz.figures.value import Axis, Figure, Line, Panel
from nonhertz.result.along import contact_lines

#: Offset of the back ends of ridges from their front ends, over the pitch of the rollers and the maximum pressure.
ASIDE, ABOVE = 0.85, 0.3
ROOM = 1.05
HEIGHT = 130  # pixel


def pressure_ridges(solution: BearingSolution) -> Figure:
    """Return the pressure of all rollers in perspective, a panel for each row and ring.

    Parameters
    ----------
    solution : BearingSolution
        A loaded bearing, solved by strips.

    Raises
    ------
    InputError
        If the bearing was solved by slices.
    """
    rollers = [row.bearing.rollers for row in solution.bearing.rows]
    along = turn_axis(loaded_middle(solution))
    assert along.range is not None
    shown = along.range[0] - 180.0 / max(rollers), along.range[1] + 360.0 * ASIDE / min(rollers)
    panels = [_panel(solution, row, ring) for row in range(len(rollers)) for ring in RINGS]
    caption = (
        "Pressure of all rollers on the centre lines of their contacts, in perspective: each stands at its angle, with "
        "the end of negative y in front."
    )
    return Figure(replace(along, range=shown), panels, conditions(solution), caption)


def _panel(solution: BearingSolution, row: int, ring: str) -> Panel:
    top = float(solution.max_pressure.max()) or 1.0
    heading = f"{ring_heading(solution, ring, row)} in perspective"
    return Panel(
        f"ridges-{ring}",
        heading,
        Axis("Pressure", "p₀", "MPa", range=(0.0, (ROOM + ABOVE) * top)),
        [*_ridges(solution, row, ring, top)],
        f"{heading}, of all rollers.",
        height=HEIGHT,
    )


def _ridges(solution: BearingSolution, row: int, ring: str, top: float) -> Iterator[Line]:
    """Yield the line on which each roller stands, and its pressure above that, from the left; the first has a name."""
    these, half = solution.rollers_of(row), 0.5 * solution.bearing.rows[row].bearing.roller_length
    angle = around(np.degrees(solution.angle[these]), loaded_middle(solution))
    behind = np.array([360.0 * ASIDE / angle.size, ABOVE * top])
    largest = mpa(float(solution.max_pressure[these, RINGS.index(ring)].max()))
    words = f"{ring} ring, largest {largest:.4g}, from y = {mm(-half):.3g} in front to {mm(half):.3g} behind"
    for roller in np.argsort(angle).tolist():
        yield Line(angle[roller] + [0.0, behind[0]], np.array([0.0, behind[1]]), colour="faint")
        contact = solution.contact(these.start + roller, ring)
        if contact is not None:
            lines = contact_lines(contact)
            depth = 0.5 * (1.0 + lines.y / half)
            # Strips at singular ends have no converged values: what is above the largest is cut.
            ridge = behind[1] * depth + np.minimum(lines.pressure, ROOM * top)
            yield Line(angle[roller] + behind[0] * depth, ridge, name=words, colour=STYLES[ring]["colour"])
            words = ""
