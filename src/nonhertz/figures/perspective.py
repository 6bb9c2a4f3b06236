"""The pressures of all rollers unrolled and in perspective: each is a ridge at its angle, along y into the depth.

The projection is oblique: places along y go to the right and up, so that angles and pressures stay to scale.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import mm, mpa
from nonhertz.bearing.solution import BearingSolution, UnrolledPressure
from nonhertz.figures.angles import around, loaded_middle, turn_axis
from nonhertz.figures.forces import conditions
from nonhertz.figures.roller import STYLES
from nonhertz.figures.unrolled import ring_heading, unrolled_pressures
from nonhertz.figures.value import Axis, Figure, Line, Panel

Array = NDArray[np.float64]

#: Of the pitch of the rollers and of the largest pressure, how far the back ends of ridges are off their front ends.
ASIDE, ABOVE = 0.85, 0.3
ROOM = 1.05
HEIGHT = 130  # pixel
POINTS = 81
"""Places along a ridge."""


def pressure_ridges(solution: BearingSolution, points: int = POINTS) -> Figure:
    """Return the pressure of all rollers in perspective, a panel for each row and ring.

    Parameters
    ----------
    solution : BearingSolution
        A loaded bearing, solved by strips.
    points : int
        Places along the rollers.

    Raises
    ------
    InputError
        If the bearing was solved by slices.
    """
    middle, most = loaded_middle(solution), max(row.bearing.rollers for row in solution.bearing.rows)
    along = turn_axis(middle)
    assert along.range is not None
    least = min(row.bearing.rollers for row in solution.bearing.rows)
    shown = along.range[0] - 180.0 / most, along.range[1] + 360.0 * ASIDE / least
    top = float(solution.max_pressure.max()) or 1.0
    panels = []
    for both in unrolled_pressures(solution, points):
        panels += [_panel(solution, unrolled, middle, top) for unrolled in both]
    caption = (
        "Pressure of all rollers on the centre lines of their contacts, in perspective: each stands at its angle, with "
        "the end of negative y in front."
    )
    return Figure(replace(along, range=shown), panels, conditions(solution), caption)


def _panel(solution: BearingSolution, unrolled: UnrolledPressure, middle: float, top: float) -> Panel:
    ring, heading = unrolled.ring, ring_heading(solution, unrolled)
    largest, half = float(unrolled.pressure.max()), float(unrolled.y[-1])
    words = f"{heading.removeprefix('Pressure at the ')}, from y = {mm(-half):.3g} in front to {mm(half):.3g} behind"
    return Panel(
        f"ridges-{ring}",
        heading,
        Axis("Pressure", "p₀", "MPa", range=(0.0, (ROOM + ABOVE) * top)),
        [*_ridges(unrolled, middle, top, words)],
        f"{heading} in perspective, up to {mpa(largest):.4g}, of all rollers.",
        height=HEIGHT,
    )


def _ridges(unrolled: UnrolledPressure, middle: float, top: float, words: str) -> Iterator[Line]:
    """Yield the line on which each roller stands, and its pressure above that, from the left; the first has a name."""
    angle = around(np.degrees(unrolled.angle), middle)
    depth = np.linspace(0.0, 1.0, unrolled.y.size)
    aside, base = 360.0 * ASIDE / angle.size * depth, ABOVE * top * depth
    for roller in np.argsort(angle).tolist():
        pressure = unrolled.pressure[roller]
        place = angle[roller] + aside
        yield Line(place[[0, -1]], base[[0, -1]], colour="faint")
        if pressure.any():
            # Strips at singular ends have no converged values: what is above the largest is cut.
            ridge = base + np.minimum(pressure, ROOM * top)
            yield Line(place, ridge, name=words, colour=STYLES[unrolled.ring]["colour"])
            words = ""
