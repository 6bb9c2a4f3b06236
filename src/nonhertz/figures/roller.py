"""Figure of one roller of a loaded bearing: pressure and line load along it at both rings, and its relief."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import mm, mpa, mrad, newton, per_mm, um
from nonhertz.bearing.section import RINGS
from nonhertz.bearing.solution import BearingSolution
from nonhertz.bearing.standard import LAMINAE, slice_loads
from nonhertz.figures.contact import land_ends
from nonhertz.figures.forces import conditions
from nonhertz.figures.profile import relief_between
from nonhertz.figures.value import Across, Axis, Bar, Figure, Level, Line, Mark, Panel, Points, Range, Words
from nonhertz.result.along import contact_lines
from nonhertz.result.maximum import places_of_largest
from nonhertz.result.solution import Solution

Array = NDArray[np.float64]

STYLES: dict[str, dict[str, Any]] = {"inner": {"colour": "first"}, "outer": {"colour": "second", "dash": "dashed"}}
ROOM, BEYOND = 1.15, 1.6
"""Ratio of the upper end of an axis to the largest value, and with an unbounded pressure."""
MARGIN = 0.02
"""Of a roller's length, beyond its ends."""
AT_ENDS, DEEP, SHALLOWEST = 1.3, 0.2, 1e-3
"""The relief is drawn up to this multiple of what it is in contact, at least up to this of the penetration [mm]."""
BARS = 1.08, 1.15
"""Of that depth, where the contacts are drawn."""
NO_TILT = 1e-9  # rad


@dataclass(frozen=True)
class _Loaded:
    """Line load [N/mm] of a roller at places along it [mm], and where it touches the ring; by slices no solution."""

    y: Array
    line_load: Array
    touching: tuple[Range, ...]
    solution: Solution | None = None


def roller_lines(solution: BearingSolution, roller: int | None = None, laminae: int = LAMINAE) -> Figure:
    """Return pressure, line load and relief of a roller at both rings.

    By slices there is no pressure, and line loads are steps. The relief is the separation of the undeformed, untilted
    bodies, cut where it is far larger than the elastic deformation; bars below it are the contacts.

    Parameters
    ----------
    solution : BearingSolution
        A loaded bearing.
    roller : int, optional
        Its index, from 0; the most loaded one if left out.
    laminae : int
        Slices that the bearing was solved by.

    Raises
    ------
    InputError
        If there is no such roller.
    """
    most = int(solution.load.max(axis=1).argmax())
    number = most if roller is None else roller
    place = solution.place_of(number)
    among = next(row for row in solution.bearing.rows if number < row.rollers.stop)
    half = 0.5 * among.bearing.roller_length
    by = {ring: _find_line_load(solution, number, ring, laminae) for ring in RINGS}
    loaded = {ring: line for ring, line in by.items() if line}
    ends = [Across(end, colour="faint", dash="dotted") for end in (-half, half)]
    idle: list[Mark] = [] if loaded else [Words(0.0, 0.5, "no load", colour="faint")]
    panels = [] if solution.method == "slices" else [_pressure(loaded, [*ends, *idle])]
    panels.append(_line_load(solution, number, loaded, [*ends, *idle]))
    panels.append(_relief(among.bearing.contacts, loaded, half, ends))
    reach = half * (1.0 + 2.0 * MARGIN)
    what = place[0].upper() + place[1:] + (", the most loaded" if number == most and loaded else "")
    along = Axis("Axial position y", "y", "mm", range=(-reach, reach))
    caption = f"{what}: pressure and line load along it at both rings, and the relief before loading."
    return Figure(along, panels, f"{what}; {conditions(solution)}", caption)


def _find_line_load(solution: BearingSolution, roller: int, ring: str, laminae: int) -> _Loaded | None:
    """Return the line load of a roller at a ring; None if it is not loaded."""
    if solution.method == "strips":
        contact = solution.contact(roller, ring)
        if contact is None:
            return None
        lines = contact_lines(contact)
        return _Loaded(lines.y, lines.line_load, contact.contact_y, contact)
    row = next(k for k, row in enumerate(solution.bearing.rows) if roller < row.rollers.stop)
    slices, loads = slice_loads(solution, laminae)[row]
    load = loads[roller - solution.bearing.rows[row].rollers.start, RINGS.index(ring)]
    if not load.any():
        return None
    width = float(slices.y[1] - slices.y[0])
    edges = np.append(slices.y - 0.5 * width, slices.y[-1] + 0.5 * width)
    pressed = np.concatenate([[False], load > 0.0, [False]])
    starts, stops = (np.flatnonzero(end) for end in (pressed[1:] & ~pressed[:-1], pressed[:-1] & ~pressed[1:]))
    touching = tuple(zip(edges[starts].tolist(), edges[stops].tolist(), strict=True))
    steps = np.concatenate([[0.0], np.repeat(load / width, 2), [0.0]])
    return _Loaded(np.repeat(edges, 2), steps, touching)


def _pressure(loaded: dict[str, _Loaded], around: Sequence[Mark]) -> Panel:
    contacts = {ring: line.solution for ring, line in loaded.items() if line.solution}
    cut = any(contact.singular_ends for contact in contacts.values())
    top = (BEYOND if cut else ROOM) * max((contact.max_pressure for contact in contacts.values()), default=1.0)
    marks, words = [*around], []
    for ring, contact in contacts.items():
        lines, style, places = contact_lines(contact), STYLES[ring], places_of_largest(contact)
        largest = f"{mpa(contact.max_pressure):.4g}"
        marks.append(Line(lines.y, lines.pressure, name=f"{ring} ring, largest {largest}", **style))
        marks.append(Points(np.array(places), np.full(len(places), contact.max_pressure), colour=style["colour"]))
        words.append(f"at most {largest} at the {ring} ring")
    # Words at both contacts would cross.
    for contact in sorted(contacts.values(), key=lambda contact: contact.max_pressure)[-1:]:
        marks += land_ends(contact)
    return Panel(
        "pressure",
        "Pressure on the centre line",
        Axis("Pressure p₀", "p₀", "MPa", range=(0.0, top), cut=cut),
        marks,
        f"Pressure along the roller: {', '.join(words)}." if words else "The roller is not loaded.",
        "axis cut: unbounded at an end" if cut else "",
        190,
    )


def _line_load(solution: BearingSolution, roller: int, loaded: dict[str, _Loaded], around: Sequence[Mark]) -> Panel:
    top = max((float(np.nanmax(line.line_load)) for line in loaded.values()), default=0.0)
    loads = dict(zip(RINGS, solution.load[roller].tolist(), strict=True))
    lines = [
        Line(line.y, line.line_load, name=f"{ring} ring, {newton(loads[ring]):.4g}", **STYLES[ring])
        for ring, line in loaded.items()
    ]
    words = f"Line load along the roller by {solution.method}, largest {per_mm(top):.4g}."
    return Panel(
        "line",
        "Line load",
        Axis("Line load q", "q", "N/mm", range=(0.0, ROOM * top or 1.0)),
        [*around, *lines],
        words if loaded else "The roller is not loaded.",
        "by slices" if solution.method == "slices" else "",
        120,
    )


def _relief(contacts: Any, loaded: dict[str, _Loaded], half: float, ends: Sequence[Mark]) -> Panel:
    deepest, lines, bars = 0.0, list[Mark](), list[Mark]()
    for ring, contact in zip(RINGS, contacts, strict=True):
        low, high = max(-half, contact.interval[0]), min(half, contact.interval[1])
        y, relief = relief_between(low, high, contact.separation_at)
        name, line = f"{ring} ring", loaded.get(ring)
        if line:
            within = np.any([(y >= pair[0]) & (y <= pair[1]) for pair in line.touching], axis=0)
            deepest = max(deepest, AT_ENDS * float(np.nanmax(relief[within], initial=0.0)))
            if line.solution:
                tilt = line.solution.tilt if abs(line.solution.tilt) > NO_TILT else 0.0
                name += f", tilt {mrad(tilt):.3g}".replace("-", "−")
                deepest = max(deepest, DEEP * line.solution.penetration)
        elif not loaded:
            deepest = max(deepest, 0.5 * float(np.nanmedian(relief)))
        lines.append(Line(y, relief, name=name, **STYLES[ring]))
    deepest = max(deepest, SHALLOWEST)
    for (ring, line), at in zip(loaded.items(), BARS, strict=False):
        bars += [Bar(*pair, at * deepest, colour=STYLES[ring]["colour"]) for pair in line.touching]
    # Downwards, as material is taken away.
    axis = Axis("Joint relief", "relief", "mm", "um", (1.22 * deepest, -0.06 * deepest))
    return Panel(
        "relief",
        "Relief of roller and ring",
        axis,
        [*ends, Level(0.0, colour="faint"), *lines, *bars],
        f"Relief of the roller and each ring together along the roller, drawn to a depth of {um(deepest):.3g} over "
        f"{mm(2.0 * half):.4g}.",
        "bars: where they touch" if loaded else "",
        150,
    )
