"""Figures of a solved contact."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from nonhertz.amounts import EndStrength, mm, mpa, mrad, newton, um
from nonhertz.figures.value import (
    Across,
    Area,
    Axis,
    Band,
    Colour,
    Dimension,
    Figure,
    Level,
    Line,
    Mark,
    Panel,
    Points,
    Side,
    Span,
    Steps,
    Words,
)
from nonhertz.result.along import (
    axial_range,
    contact_lines,
    distance_range,
    distances,
    ends_in_sight,
    land_end_peaks,
    unlimited_ends,
)
from nonhertz.result.area import element_peak, outlines
from nonhertz.result.brief import where_largest
from nonhertz.result.edges import EdgePressure
from nonhertz.result.maximum import places_of_largest
from nonhertz.result.solution import Solution
from nonhertz.result.status import Status
from nonhertz.strip.element import PARABOLIC

BEYOND = 1.6
"""Ratio of the upper end of an axis to the maximum pressure if the pressure is unbounded at an end."""
ROOM, ROOM_ABOVE = 1.12, 1.32
"""Ratio of the upper end of an axis to the largest value, without and with words above the curve."""
REACH = 1.15
"""Ends of an axis across over the largest half-width."""
ROUNDING = 1e-9
"""Relative, by which a pressure may exceed the last colour."""
DIMENSION = 0.92
"""Fraction of the height of the axes for the length in contact."""
SINGULAR = 0.72
"""Fraction of the height of the axes for words on an unbounded pressure."""


def pressure(solution: Solution) -> Figure:
    """Return the pressure on the centre line along a contact and, below it, the half-width.

    Lines run through the centres of the strips to the ends of the contact; the pale steps are the strips themselves.
    Where the pressure is unbounded the axis is cut, with exponent and strength at that end; the maximum pressure is
    that more than a half-width from such ends.

    Parameters
    ----------
    solution : Solution
        A solved contact.
    """
    lines = contact_lines(solution)
    cut = bool(solution.singular_ends)
    top = (BEYOND if cut else ROOM_ABOVE) * solution.max_pressure or 1.0
    marks = [
        *ends_of_bodies(solution),
        Steps(solution.edges, solution.centre_pressure),
        Line(lines.y, lines.pressure, name="pressure p₀"),
        *_contact(solution, top),
        *_largest(solution),
        *(unlimited_pressure(solution, edge, top) for edge in unlimited_ends(solution)),
    ]
    upper = Panel(
        "pressure",
        "Pressure on the centre line",
        Axis("Pressure p₀", "p₀", "MPa", range=(0.0, top), cut=cut),
        marks,
        f"Pressure on the centre line along y: largest {mpa(solution.max_pressure):4} {where_largest(solution, 3)}.",
        "axis cut: unbounded at an end" if cut else "",
        236,
    )
    widest = float(solution.half_width.max())
    lower = Panel(
        "half-width",
        "Half-width",
        Axis("Half-width b", "b", "mm", range=(0.0, ROOM * widest or 1.0)),
        [
            *ends_of_bodies(solution, named=False),
            Line(lines.y, lines.half_width, name="half-width b", colour="second", dash="dashed"),
        ],
        f"Half-width along y: at most {mm(widest):3}.",
        height=112,
    )
    caption = "Pressure on the centre line and half-width along the contact."
    if cut:
        caption += " Where the pressure is unbounded the axis is cut, with exponent and strength beside it."
    return Figure(_along(solution), (upper, lower), conditions(solution), caption)


def footprint(solution: Solution) -> Figure:
    """Return the contact area as `nonhertz.plot.footprint` draws it."""
    pieces, limit = outlines(solution), element_peak(solution)
    parabolic = solution.element.name == PARABOLIC.name
    marks: list[Mark] = [Level(0.0, colour="faint", dash="ends"), *ends_of_bodies(solution, named=False)]
    for piece in pieces:
        marks.append(Area(piece.y, piece.half_width, piece.pressure, 1.0 if parabolic else 0.5))
        if parabolic:
            hertz = PARABOLIC.hertz_ratio * piece.half_width
            marks += (Line(piece.y, sign * hertz, colour="paper", dash="dotted") for sign in (-1.0, 1.0))
    widest = float(solution.element_half_width.max())
    reach = REACH * widest or 1.0
    beyond = any(piece.pressure.max() > (1.0 + ROUNDING) * limit for piece in pieces)
    words = "There is no contact."
    if pieces:
        along = mm(pieces[0].y[0], pieces[-1].y[-1], between=" to ")
        words = f"Footprint seen from above: from y = {along:4}, at most {mm(2.0 * widest):3} wide."
    panel = Panel(
        "footprint",
        "Footprint",
        Axis("Across x", "x", "mm", range=(-reach, reach)),
        marks,
        words,
        "the parabolic strips' own width; dotted: Hertz half-width b" if parabolic else "",
        height=74,
        colours=Axis("Pressure p", "p", "MPa", range=(0.0, limit), cut=beyond),
        proportional=True,
    )
    caption = f"Contact area, coloured by its pressure{' (the dotted line is the half-width)' if parabolic else ''}."
    return Figure(_along(solution), (panel,), conditions(solution), caption)


def distance(solution: Solution) -> Figure:
    """Return the surfaces' distance on the centre line, undeformed and deformed.

    Undeformed it is negative where the bodies would overlap; deformed it is the gap, zero in contact. The band between
    them is the elastic displacement of both surfaces. Where the relief is far larger than the interference the axis is
    cut, and the remark has the largest distance.

    Parameters
    ----------
    solution : Solution
        A solved contact.
    """
    before, after = distances(solution)
    low, high = distance_range(before, after) if np.isfinite(before).any() else (0.0, 1.0)
    span = axial_range(solution)
    largest = float(-solution.interference[(solution.y >= span[0]) & (solution.y <= span[1])].min())
    cut, remark = largest > high, ""
    if np.isinf(largest):
        remark = "axis cut, the relief is infinite at an end"
    elif cut:
        remark = f"axis cut, undeformed up to {um(largest):3}"
    overlap = max(0.0, -float(np.nanmin(before, initial=0.0)))
    marks = [
        *(
            Span(*ends, name="" if number else "in contact", colour="faint")
            for number, ends in enumerate(solution.contact_y)
        ),
        Level(0.0, colour="faint"),
        *ends_of_bodies(solution),
        Line(solution.y, before, name="undeformed", colour="second", dash="dashed"),
        Line(solution.y, after, name="deformed"),
        Band(solution.y, before, after, name="elastic displacement"),
    ]
    panel = Panel(
        "gap",
        "Distance of the surfaces",
        Axis("Distance of the surfaces", "distance", "mm", "um", (low, high), cut),
        marks,
        f"Distance of the surfaces along y: undeformed they would overlap by up to {um(overlap):3}; deformed it is "
        "zero in contact.",
        remark,
    )
    caption = "Distance of both surfaces on the centre line before and after loading."
    return Figure(_along(solution), (panel,), conditions(solution), caption)


def figures_of(solution: Solution) -> dict[str, Figure]:
    """Return all figures of a solved contact by the names of their files."""
    return {"pressure": pressure(solution), "footprint": footprint(solution), "profile": distance(solution)}


def conditions(solution: Solution) -> str:
    """Return the line on what was solved: load, tilt, and anything unusual."""
    words = [f"Load {newton(solution.load):.4g}", f"tilt {mrad(solution.tilt):.4g}".replace("-", "−")]
    if solution.element.name != "semi-elliptic":
        words.append(f"{solution.element.name} strips")
    if solution.status is not Status.CONVERGED:
        words.append("NOT CONVERGED")
    return ", ".join(words)


def _along(solution: Solution) -> Axis:
    return Axis("Axial position y", "y", "mm", range=axial_range(solution))


def ends_of_bodies(solution: Solution, *, named: bool = True) -> Iterator[Mark]:
    """Yield a line at each end of a body that is near."""
    for end, name in ends_in_sight(solution).items():
        yield Across(end, name if named else "", colour="faint", dash="ends")


def _contact(solution: Solution, top: float) -> Iterator[Mark]:
    """Yield a dimension line for every interval in contact; the first one names their positions."""
    intervals = solution.contact_y
    several = " and ".join(f"{mm(*ends, between=' to '):4}" for ends in intervals[:2])
    words = f"contact {several}"
    if len(intervals) > 2:
        between = mm(intervals[0][0], intervals[-1][1], between=" and ")
        words = f"contact on {len(intervals)} intervals between {between:4}"
    for number, (low, high) in enumerate(intervals):
        yield Dimension(low, high, DIMENSION * top, "" if number else words, colour="faint")


def _largest(solution: Solution) -> Iterator[Mark]:
    """Yield the maximum pressure, and peaks at the ends of lands."""
    places, largest = places_of_largest(solution), solution.max_pressure
    peaks = land_end_peaks(solution)
    at_land_end = any(abs(y - place) < solution.max_half_width for y, _ in peaks for place in places)
    if places:
        yield Points(np.array(places), np.full(len(places), largest))
        remark = (
            " (corner: rises with refinement)" if solution.peaks_at_corner else " (land end)" if at_land_end else ""
        )
        where = mm(*places, between=" and ")
        yield Words(sum(places) / len(places), largest, f"{mpa(largest):4} at y = {where:3}{remark}")
    if not at_land_end:
        yield from land_ends(solution)


def land_ends(solution: Solution, colour: Colour = "ink") -> Iterator[Mark]:
    """Yield words at peaks of the pressure at the ends of lands."""
    middle = 0.5 * sum(axial_range(solution))
    for y, value in land_end_peaks(solution):
        side: Side = "left" if y < middle else "right"
        yield Words(y, value, f"land end, {mpa(value):.4g}", side, clear=True, colour=colour)


def no_limits(solutions: Sequence[Solution], at: float, colours: Sequence[Colour] = ()) -> Iterator[Mark]:
    """Yield "unbounded", at that value, at every end where a pressure is; in the colour of a single one."""
    ends: dict[tuple[float, bool], list[Colour]] = {}
    inks: Sequence[Colour] = colours or ["ink"] * len(solutions)
    for solution, colour in zip(solutions, inks, strict=True):
        for edge in unlimited_ends(solution):
            ends.setdefault((round(edge.y, 6), edge is solution.edge_pressure[0]), []).append(colour)
    for (y, low), several in ends.items():
        yield Words(y, at, "unbounded", "left" if low else "right", colour=several[0] if len(several) == 1 else "ink")


def unlimited_pressure(solution: Solution, edge: EdgePressure, top: float) -> Mark:
    """Return words on the growth of the pressure towards an end where it is unbounded, clear of the curve."""
    words = "unbounded at a corner"
    if edge.law:
        words = f"unbounded, p ∼ K / s^{edge.exponent:.3g}"
        if edge.strength is not None:
            words += f"\nK = {EndStrength(edge.strength, edge.exponent)}"
    below = solution.y[solution.centre_pressure < SINGULAR * top]
    foot = float(below[np.abs(below - edge.y).argmin()]) if below.size else edge.y
    return Words(foot, SINGULAR * top, words, "left" if edge is solution.edge_pressure[0] else "right")
