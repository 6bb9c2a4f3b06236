"""The most loaded roller of a bearing: its pressure at both rings, and the profile that it has there."""

from __future__ import annotations

import math

import numpy as np

from nonhertz.amounts import mpa, mrad, newton
from nonhertz.bearing import BearingSolution
from nonhertz.bearing.section import RINGS
from nonhertz.errors import InputError
from nonhertz.plot.axes import OWN, Axes, along, drawing, key_above, measure, open_frame
from nonhertz.plot.axial import mark_land_ends, number, written
from nonhertz.plot.style import FAINT_INK, FIRST, HAIR, LINE, SECOND, SMALL_SIZE, THIN
from nonhertz.result.maximum import places_of_largest
from nonhertz.result.solution import Solution

COLOURS = {"inner": (FIRST, "-"), "outer": (SECOND, "--")}
POINTS = 801
ROOM = 1.12
NO_TILT = 1e-9  # rad
MARGIN = 0.02  # of a roller's length beyond its ends
# The relief is drawn up to this multiple of what it is at the ends of the contact, at least up to this of the deepest
# penetration: that of a straight roller is zero.
AT_ENDS, DEEP = 1.3, 0.2


def _most_loaded(solution: BearingSolution) -> tuple[int, int, float, list[tuple[str, Solution]]]:
    """Return the number of the most loaded roller, its row, half its length, and its contacts by ring."""
    roller = int(solution.load.max(axis=1).argmax())
    both = [(ring, solution.contact(roller, ring)) for ring in RINGS]
    contacts = [(ring, contact) for ring, contact in both if contact is not None]
    if not contacts:
        raise InputError("solution", "without load", "have a loaded roller", "load the bearing")
    row = next(row for row in range(len(solution.bearing.rows)) if roller < solution.rollers_of(row).stop)
    return roller, row, 0.5 * solution.bearing.rows[row].bearing.roller_length, contacts


@drawing
def most_loaded_roller(solution: BearingSolution, ax: Axes = OWN) -> Axes:
    """Draw the centre-line pressure of the most loaded roller at both rings against y.

    Lines run through the centres of the strips; the maximum pressures are marked. The pressure at a sharp end, which
    has no limit, may leave the axes.

    Parameters
    ----------
    solution : BearingSolution
        A loaded bearing, solved by strips.

    Raises
    ------
    InputError
        If no roller is loaded, or the bearing was solved by slices.
    """
    roller, row, half, contacts = _most_loaded(solution)
    length, stress = measure("mm"), measure("MPa")
    for ring, contact in contacts:
        colour, dashes = COLOURS[ring]
        words = f"{ring} ring, {written(newton(contact.load))}: largest {written(mpa(contact.max_pressure))}"
        # To where the contact ends, not to the next strip beyond.
        y = np.unique(np.concatenate([contact.y, np.ravel(contact.contact_y)]))
        pressure = stress(contact.pressure(0.0, y))
        ax.plot(length(y), pressure, color=colour, linestyle=dashes, linewidth=LINE, label=words)
        places = places_of_largest(contact)
        tops = stress([contact.max_pressure] * len(places))
        ax.plot(length(places), tops, "o", markersize=4.0, color=colour, markerfacecolor="white")
        mark_land_ends(contact, ax, colour)
    _lay(half, ax, labelled=False)
    ax.set_ylim(0.0, stress.factor * ROOM * max(contact.max_pressure for _, contact in contacts))
    ax.set_ylabel(stress.label("Centre-line\npressure $p_0$"))
    several = f"row {row + 1}, " if len(solution.bearing.rows) > 1 else ""
    where = number(math.degrees(solution.angle[roller]), 4)
    words = f"Most loaded roller: {several}number {roller - solution.rollers_of(row).start + 1} at {where}°"
    if any(contact.singular_ends for _, contact in contacts):
        words += "; pressure has no limit at sharp ends"
    ax.set_title(words, loc="left", fontsize=SMALL_SIZE, pad=18.0)
    key_above(ax, columns=2, handlelength=2.6)
    return ax


@drawing
def roller_relief(solution: BearingSolution, ax: Axes = OWN) -> Axes:
    """Draw the relief of the most loaded roller and each ring together against y, and where they are in contact.

    That is the separation of the undeformed, untilted bodies: profiles and corners of both. The axis is cut where the
    relief is far larger than what the load presses flat. Bars at the bottom are the contacts.

    Parameters
    ----------
    solution : BearingSolution
        A loaded bearing, solved by strips.

    Raises
    ------
    InputError
        If no roller is loaded, or the bearing was solved by slices.
    """
    _, _, half, contacts = _most_loaded(solution)
    shown, length, depth = 0.0, measure("mm"), measure("mm", "um")
    for ring, contact in contacts:
        colour, dashes = COLOURS[ring]
        low, high = max(-half, contact.contact.interval[0]), min(half, contact.contact.interval[1])
        # Strictly inside: a profile may be infinite at its very end.
        y = np.linspace(low, high, POINTS)[1:-1]
        relief = np.array(contact.contact.separation_at(y))
        relief[~np.isfinite(relief)] = np.nan
        words = f"{ring} ring, tilt {written(mrad(contact.tilt if abs(contact.tilt) > NO_TILT else 0.0), 3)}"
        ax.plot(length(y), depth(relief), color=colour, linestyle=dashes, linewidth=LINE, label=words)
        touching = [end for pair in contact.contact_y for end in pair]
        at_ends = np.nanmax(np.interp(touching, y, relief))
        shown = max(shown, DEEP * contact.penetration, AT_ENDS * float(at_ends))
        for pair in contact.contact_y:
            at = 0.03 + 0.05 * RINGS.index(ring)
            ax.plot(length(pair), [at, at], transform=ax.get_xaxis_transform(), color=colour, linewidth=2.0 * LINE,
                    solid_capstyle="butt")  # fmt: skip
    _lay(half, ax, labelled=True)
    # Downwards, as material is taken away; room for the bars below the deepest that is drawn.
    ax.set_ylim(*depth([1.15 * shown, -0.08 * shown]))
    ax.axhline(0.0, color=FAINT_INK, linewidth=HAIR, zorder=1.0)
    ax.set_ylabel(depth.label("Relief of roller\nand ring"))
    key_above(ax, columns=2, handlelength=2.6)
    return ax


def _lay(half: float, ax: Axes, *, labelled: bool) -> None:
    """Set the axis along a roller of half a length, and mark its ends."""
    for end in (-half, half):
        ax.axvline(measure("mm").factor * end, color=FAINT_INK, linewidth=THIN, linestyle=":", zorder=1.0)
    along(ax, (-half * (1.0 + 2.0 * MARGIN), half * (1.0 + 2.0 * MARGIN)), labelled=labelled)
    open_frame(ax)
