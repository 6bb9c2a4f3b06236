"""What all drawings along the axis share: the range of y, the bodies' ends, the heading and number formatting."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from nonhertz.amounts import Amount, given, mm, mpa, mrad, newton
from nonhertz.plot.axes import Alignment, Artist, Axes, key_above, measure, note
from nonhertz.plot.style import BACKING, END_DASHES, FAINT_INK, INK, SMALL_SIZE, THIN
from nonhertz.result.solution import EdgeKind, EdgePressure, Solution, Status

LETTER = 0.55 * SMALL_SIZE / 72.0
"""Mean width of a small letter [inch]."""

RISE = 1.05
"""Of the pressure at the end of a land over the least before it, from which on it is said."""

MARGIN = 0.06
"""Fraction of the drawn range left free at each side, for the names of the bodies' ends."""


def axial_range(solution: Solution) -> tuple[float, float]:
    """Return the range of y [mm] to draw.

    It is that of the strips, including the bodies' ends if these are near. Where the contact is a small part of
    the strips it is the contact's neighbourhood, so that the contact is legible.
    """
    low, high = float(solution.edges[0]), float(solution.edges[-1])
    if solution.contact_y:
        first, last = solution.contact_y[0][0], solution.contact_y[-1][1]
        if last - first < 0.25 * (high - low):
            reach = last - first
            low, high = max(low, first - reach), min(high, last + reach)
    near = 0.25 * (high - low)
    ends = [end for end, _ in body_ends(solution) if low - near < end < high + near]
    low, high = min([low, *ends]), max([high, *ends])
    margin = MARGIN * (high - low)
    return (low - margin, high + margin)


def body_ends(solution: Solution) -> list[tuple[float, str]]:
    """Return where a body ends along y [mm] and the name of the body, ascending."""
    bodies = {"a": solution.contact.a, "b": solution.contact.b}
    kinds = [type(body).__name__.lower() for body in bodies.values()]
    distinct = kinds[0] != kinds[1] and "body" not in kinds
    ends = []
    for (letter, body), kind in zip(bodies.items(), kinds, strict=True):
        name = kind if distinct else f"body {letter}"
        faces = () if body.length is None else tuple(body.position + s * body.length for s in (-0.5, 0.5))
        for end in body.interval:
            if np.isfinite(end):
                # An effective length, or the end of a profile's definition, ends the contact before the face.
                is_face = any(np.isclose(end, face) for face in faces)
                ends.append((float(end), f"end of {name}" if is_face else f"usable end of {name}"))
    return sorted(ends)


def draw_body_ends(solution: Solution, ax: Axes, *, named: bool = True) -> None:
    """Draw a dash-dot line where a body ends, its name beside it on the side away from the contact."""
    low, high = axial_range(solution)
    middle, length = 0.5 * (low + high), measure("mm")
    drawn = [(end, name) for end, name in body_ends(solution) if low < end < high]
    for end in dict.fromkeys(end for end, _ in drawn):
        ax.axvline(float(length(end)), color=FAINT_INK, linewidth=THIN, linestyle=END_DASHES, zorder=1.5)
    if not named:
        return
    for side in (-1.0, 1.0):
        here = [(end, name) for end, name in drawn if side * (end - middle) > 0.0]
        if len(here) == 2 and here[1][0] - here[0][0] < 0.03 * (high - low):
            # So close together that two names would overlap.
            (first, one), (last, other) = here
            here = [(first if side < 0.0 else last, f"{one}, {other}")]
        for where, name in here:
            at, aligned = (float(length(where)), 0.5), _side(side > 0.0)
            note(ax, name, at, aligned, 3.0, across=True, rotation=90.0, va="center", color=FAINT_INK)


def land_end_peaks(solution: Solution) -> list[tuple[float, float]]:
    """Return place [mm] and pressure [MPa] where it rises again by 5 % towards an end, where the land of a body ends.

    That is the first peak from an end, within half a half-width of there. There is none at ends where the pressure has
    no limit.
    """
    pressed = solution.line_load > 0.0
    if not pressed.any():
        return []
    y, pressure, reach = solution.y[pressed], solution.centre_pressure[pressed], 0.5 * solution.half_width[pressed]
    lands = [end for body in (solution.contact.a, solution.contact.b) for end in body.land if np.isfinite(end)]
    unlimited = [edge.y for edge in unlimited_ends(solution)]
    found = []
    for inwards in (slice(None), slice(None, None, -1)):
        rises = np.diff(pressure[inwards]) > 0.0
        peak = int(np.argmin(np.append(rises, False)))
        valley = peak + int(np.argmax(np.append(rises[peak:], True)))
        place, top, near = (float(each[inwards][peak]) for each in (y, pressure, reach))
        is_one = valley < rises.size and top > RISE * float(pressure[inwards][valley])
        at_land_end = any(abs(place - end) < near for end in lands)
        if is_one and at_land_end and all(abs(place - end) > 2.0 * near for end in unlimited):
            found.append((place, top))
    return found


def mark_land_ends(solution: Solution, ax: Axes, colour: str = INK) -> None:
    """Write "land end" and the pressure where it rises again towards an end, on the side of the contact."""
    middle = 0.5 * sum(axial_range(solution))
    for y, pressure in land_end_peaks(solution):
        at = float(measure("mm")(y)), float(measure("MPa")(pressure))
        words = f"land end, {written(mpa(pressure))}"
        note(ax, words, at, _side(y < middle), 3.0, 4.0, va="bottom", color=colour, bbox=BACKING)


def unlimited_ends(solution: Solution) -> tuple[EdgePressure, ...]:
    """Return the ends of the contact where the pressure has no limit: sharp ones, and corners of the profile."""
    return tuple(edge for edge in solution.edge_pressure if edge.kind in {EdgeKind.SINGULAR, EdgeKind.CORNER})


def mark_unlimited(solutions: Sequence[Solution], ax: Axes, colours: Sequence[str] = ()) -> None:
    """Write "no limit" at every end where the pressure has none, on the side of the contact.

    With colours, one for each solution, what concerns a single one has its colour.
    """
    ends: dict[tuple[float, bool], list[str]] = {}
    for solution, colour in zip(solutions, colours or [INK] * len(solutions), strict=True):
        for edge in unlimited_ends(solution):
            ends.setdefault((round(edge.y, 6), edge is solution.edge_pressure[0]), []).append(colour)
    for (y, low), found in ends.items():
        at, colour = (float(measure("mm")(y)), 0.98), found[0] if len(found) == 1 else INK
        note(ax, "no limit", at, _side(low), 6.0, across=True, va="top", color=colour, bbox=BACKING)


def _side(to_the_right: bool) -> Alignment:
    return "left" if to_the_right else "right"


def conditions(solution: Solution) -> str:
    """Return the line that says what was solved: load, tilt, and whatever is out of the ordinary."""
    words = [f"Load {written(newton(solution.load))}", f"tilt {written(mrad(solution.tilt))}"]
    if solution.element.name != "semi-elliptic":
        words.append(f"{solution.element.name} strips")
    if solution.status is not Status.CONVERGED:
        words.append("NOT CONVERGED")
    return ", ".join(words)


def head(solution: Solution, ax: Axes, handles: Sequence[Artist], labels: Sequence[str], *, remark: str = "") -> None:
    """Write the conditions and, below them, the legend above the axes, where neither can cover a curve."""
    key_above(ax, handles, labels, columns=len(labels), handlelength=2.2)
    words = conditions(solution)
    ax.set_title(f"{words}; {remark}" if remark else words, loc="left", pad=18.0)


def number(value: float, digits: int = 4) -> str:
    """Return ``value`` to a number of significant digits, with a true minus sign.

    Examples
    --------
    >>> number(-8.31249), number(2431.7), number(0.0)
    ('−8.312', '2432', '0')
    """
    return given(value, digits).replace("-", "−").replace("inf", "∞")


def written(found: Amount, digits: int = 4) -> str:
    """Return numbers to so many significant digits with their unit, as `number` writes them.

    Examples
    --------
    >>> written(newton(20000.0)), written(mm(-1.5, 0.25, between=" and "))
    ('20 kN', '−1.5 and 0.25 mm')
    """
    return f"{found:.{digits}g}".replace("-", "−")


def place(span: tuple[float, float], *y: float, between: str = " and ") -> str:
    """Return positions [mm] with as many decimals as the drawn ``span`` can show, and their unit."""
    factor, unit = mm().scale
    decimals = max(0, 2 - int(np.floor(np.log10(factor * (span[1] - span[0])))) + 1)
    texts = (f"{factor * each:.{decimals}f}" for each in y)
    shown = ((text[1:] if float(text) == 0.0 and text.startswith("-") else text).replace("-", "−") for text in texts)
    return f"{between.join(shown)} {unit}"


def alignment(ax: Axes, y: float, span: tuple[float, float], words: str) -> Alignment:
    """Return how to align small ``words`` at ``y`` so that they stay inside the axes."""
    # Measuring a text needs a renderer, which axes lack before they are drawn; an average letter width will do.
    width = ax.bbox.width / ax.figure.dpi
    half = 0.5 * len(words) * LETTER / width
    share = (y - span[0]) / (span[1] - span[0])
    if share < half:
        return "left"
    return "right" if share > 1.0 - half else "center"
