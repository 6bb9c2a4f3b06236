"""Stress below the surface: von Mises stress along and across the contact, with the largest stresses marked."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from nonhertz.amounts import mm, mpa
from nonhertz.figures.contact import conditions
from nonhertz.plot.axes import OWN, ROUND, Array, Axes, Figure, drawing, key_above, measure
from nonhertz.plot.axial import number, place, written
from nonhertz.plot.contact_area import colour_limit
from nonhertz.plot.sheets import BAR_ROOM, LEFT, WIDTH, bar_beside, stacked, stretch_of
from nonhertz.plot.style import COLOUR_MAP, END_DASHES, FAINT_INK, HAIR, INK, SECOND, SMALL_SIZE, THIN, sheet_style
from nonhertz.result.along import body_ends
from nonhertz.result.solution import Solution
from nonhertz.subsurface import Extreme, Extremes, Field, axial_plane, cross_section
from nonhertz.subsurface.evaluation import DEEPEST, WIDEST, across_at, axial_range

if TYPE_CHECKING:
    from matplotlib.contour import ContourSet
    from matplotlib.lines import Line2D

Entry = tuple["Line2D", str]

# The first is drawn last: it may lie on the second, which is larger.
MARKS = {
    "von_mises": ("o", 3.0, "max. von Mises"),
    "shear": ("D", 5.0, "max. shear"),
    "orthogonal_shear": ("^", 4.0, r"max. $|\tau_{xz}|$"),
}

BANDS = 10  # of colour, at most
BEYOND = 0.02  # of the drawn range, left white beyond a side face
HEAD, HEAD_POINTS = 0.82, 45.0  # room above the axes for heading and legend [inch], and for the legend alone [points]
# Points of the planes: denser near the surface and near both ends, where lines would have kinks.
ALONG, ACROSS, LEVELS, CROWDING = 201, 121, 81, 1.5
ACROSS_WIDTH = 4.25  # inch
APART = 0.17  # inches: least distance of a contour label from the next, and from markers
SHARES = (0.5, 0.35, 0.65, 0.22, 0.78)  # of the contact: candidate positions for the column of contour labels


@drawing
def axial_stress(
    solution: Solution,
    field: Field,
    overall: Extremes,
    ax: Axes = OWN,
    *,
    station: float | None = None,
    stretch: float = 1.0,
    bar: Axes | None = None,
) -> Axes:
    """Draw the von Mises stress in a plane along the contact, y to the right and z downwards.

    The positions of the largest stresses are marked; one that lies off the plane is projected onto it, as the legend
    says. The thick line on the surface is the contact. Where a sharp end makes the stress singular it has the last
    colour, which is that of the largest stress away from there, and the colour bar ends in an arrow.

    Parameters
    ----------
    solution : Solution
        A solved contact.
    field : Field, shape (m, n)
        What `nonhertz.subsurface.axial_plane` returned.
    overall : Extremes
        The largest stresses in that body.
    ax : matplotlib.axes.Axes, optional
        Where to draw; made smaller to fit the shape of the plane; if left out, in a figure of its own, ``ax.figure``.
    station : float, optional
        Where a cross-section lies along y [mm], drawn as a thin line.
    stretch : float
        Factor by which depth is drawn larger than y; the heading says so unless it is 1.
    bar : matplotlib.axes.Axes, optional
        Where to draw the colour bar; if left out, beside ``ax``, which shrinks to make room.
    """
    y = field.y[:, 0]
    span = _framed(solution, field)
    _frame(ax, span, float(field.z.max()), stretch)
    ends, section = _draw_ends(solution, span, ax), []
    if station is not None:
        line = ax.axvline(measure("mm").factor * station, color=INK, linewidth=THIN, linestyle="--", zorder=1.5)
        section = [(line, f"cross-section, $y$ = {_station(station, span)}")]
    contact = _draw_surface(solution.contact_y, "contact", ax)
    landmarks = [_mark(name, getattr(overall, name), span, ax) for name in MARKS]
    lines = _draw_contours(solution, field, y, overall, ax, bar)
    _label(lines, field, y, _calm_column(solution, y, overall, station), overall, ax)
    ax.set_xlabel(measure("mm").label("Axial position $y$"))
    plane = f"body {field.body} at $x$ = {written(mm(field.x[0, 0]))}"
    if stretch != 1.0:
        plane += f", ${'z' if stretch > 1.0 else 'y'}$ stretched {number(max(stretch, 1.0 / stretch))} times"
    _head(solution, plane, landmarks, [*contact, *section, *ends], ax)
    return ax


@drawing
def section_stress(
    solution: Solution,
    field: Field,
    section: Extremes,
    ax: Axes = OWN,
    *,
    bar: Axes | None = None,
) -> Axes:
    """Draw the von Mises stress in a cross-section in true proportions, x to the right and z downwards.

    The positions of the largest stresses in it are marked, on either side of the middle. The thick line on the surface
    is the contact.

    Parameters
    ----------
    solution : Solution
        A solved contact.
    field : Field, shape (m, n)
        What `nonhertz.subsurface.cross_section` returned.
    section : Extremes
        The largest stresses in that cross-section.
    ax : matplotlib.axes.Axes, optional
        Where to draw; made smaller to fit the shape of the plane; if left out, in a figure of its own, ``ax.figure``.
    bar : matplotlib.axes.Axes, optional
        Where to draw the colour bar; if left out, beside ``ax``, which shrinks to make room.
    """
    x, y = field.x[:, 0], float(field.y[0, 0])
    middle, half_width = (float(each) for each in across_at(solution, np.asarray(y)))
    _frame(ax, (float(x[0]), float(x[-1])), float(field.z.max()), 1.0)
    label = f"contact, half-width {written(mm(half_width), 3)}"
    contact = _draw_surface(((middle - half_width, middle + half_width),), label, ax)
    landmarks = [_mark(name, getattr(section, name), None, ax) for name in MARKS]
    lines = _draw_contours(solution, field, x, section, ax, bar)
    _label(lines, field, x, int(np.abs(x - middle).argmin()), section, ax)
    ax.set_xlabel(measure("mm").label("Across $x$"))
    ends = solution.contact_y[0][0], solution.contact_y[-1][1]
    _head(solution, f"body {field.body} at $y$ = {_station(y, ends)}", landmarks, contact, ax)
    return ax


def stress_planes(solution: Solution, section: Extremes) -> dict[str, Field]:
    """Return the stress in both planes that `stress_figures` draws, at points dense enough for smooth lines.

    Parameters
    ----------
    solution : Solution
        A solved contact.
    section : Extremes
        The largest stresses in a cross-section of a body.

    Returns
    -------
    dict of str to Field
        Keys ``"axial-plane"``, of shape (201, 81), and ``"cross-section"``, of shape (121, 81).
    """
    body, y = section.body, section.von_mises.y
    low, high = axial_range(solution, body)[[0, -1]]
    stations = 0.5 * (low + high) - 0.5 * (high - low) * np.cos(np.linspace(0.0, np.pi, ALONG))
    depths = DEEPEST * np.linspace(0.0, 1.0, LEVELS) ** CROWDING
    middle, half_width = across_at(solution, np.asarray(y))
    x = middle + WIDEST * half_width * np.linspace(-1.0, 1.0, ACROSS)
    return {
        "axial-plane": axial_plane(solution, stations, solution.max_half_width * depths, body=body),
        "cross-section": cross_section(solution, y, x, half_width * depths, body=body),
    }


def stress_figures(
    solution: Solution,
    overall: Extremes,
    section: Extremes,
    title: str = "",
    planes: Mapping[str, Field] | None = None,
) -> dict[str, Figure]:
    """Return one finished figure each of the plane under the centre line and of a cross-section.

    Parameters
    ----------
    solution : Solution
        A solved contact.
    overall, section : Extremes
        The largest stresses in a body and in a cross-section of it, as `nonhertz.subsurface.extremes` returned them.
    title : str
        Heading of every figure; none if empty.
    planes : mapping of str to Field, optional
        What `stress_planes` returned; evaluated if left out.

    Returns
    -------
    dict of str to matplotlib.figure.Figure
        Keys ``"axial-plane"`` and ``"cross-section"``; `save` writes them.
    """
    planes = stress_planes(solution, section) if planes is None else planes
    along, across = planes["axial-plane"], planes["cross-section"]
    with sheet_style():
        low, high = _framed(solution, along)
        width = WIDTH - LEFT - BAR_ROOM
        natural = width * float(along.z.max()) / (high - low)
        stretch = stretch_of(natural)
        axial, (axes,) = stacked([HEAD], [stretch * natural], title, right=BAR_ROOM)
        station, bar = section.von_mises.y, bar_beside(axes)
        axial_stress(solution, along, overall, axes, station=station, stretch=stretch, bar=bar)
        height = ACROSS_WIDTH * float(across.z.max()) / float(np.ptp(across.x))
        cross, (axes,) = stacked([HEAD], [height], title, right=WIDTH - LEFT - ACROSS_WIDTH)
        section_stress(solution, across, section, axes, bar=bar_beside(axes))
        return {"axial-plane": axial, "cross-section": cross}


def _framed(solution: Solution, field: Field) -> tuple[float, float]:
    """Return the range of y [mm] to draw: that of the field, and a little more where it reaches the end of the body."""
    low, high = float(field.y[0, 0]), float(field.y[-1, 0])
    room = BEYOND * (high - low)
    faces = {"a": solution.contact.a, "b": solution.contact.b}[field.body].faces
    return low - room * bool(np.isclose(low, faces[0])), high + room * bool(np.isclose(high, faces[1]))


def _frame(ax: Axes, span: tuple[float, float], depth: float, stretch: float) -> None:
    length = measure("mm")
    ax.locator_params(steps=ROUND)
    ax.locator_params(axis="y", nbins=6)
    ax.set_xlim(*length(span))
    ax.set_ylim(length.factor * depth, 0.0)
    ax.set_aspect(stretch, adjustable="box")
    ax.set_ylabel(length.label("Depth $z$"))


def _draw_contours(
    solution: Solution, field: Field, along: Array, found: Extremes, ax: Axes, bar: Axes | None
) -> ContourSet:
    """Fill bands of von Mises stress, draw the lines between them and the colour bar; return the lines."""
    from matplotlib.ticker import MaxNLocator

    length, drawn = measure("mm"), measure("MPa")
    # The last colour is that of the largest stress, unless that is an artefact of a step between strips.
    limit = min(found.von_mises.max, colour_limit(solution))
    levels = MaxNLocator(BANDS, steps=[1, 2, 2.5, 5, 10]).tick_values(0.0, drawn.factor * (limit or 1.0))
    stress, depths = np.ma.masked_invalid(drawn(field.von_mises.T)), length(field.z[0])
    # On the surface itself the stress is also unbounded at a step of the pressure from strip to strip.
    extend = "max" if float(stress[depths > 0.0].max()) > levels[-1] else "neither"
    shown = stress if extend == "max" else np.minimum(stress, levels[-1])
    bands = ax.contourf(length(along), depths, shown, levels, cmap=COLOUR_MAP, extend=extend, zorder=0.5)
    # The colour map goes from dark to bright.
    colours = ["white" if level < 0.5 * levels[-1] else INK for level in levels[1:]]
    lines = ax.contour(length(along), depths, stress, levels[1:], colors=colours, linewidths=HAIR, zorder=0.8)
    where: dict[str, Any] = {"ax": ax} if bar is None else {"cax": bar}
    ax.figure.colorbar(bands, label=drawn.label("Von Mises stress"), **where)
    return lines


def _label(lines: ContourSet, field: Field, along: Array, column: int, found: Extremes, ax: Axes) -> None:
    """Label contour lines where they cross a column below the largest stress, far enough apart."""
    ax.apply_aspect()
    length, stress = measure("mm"), measure("MPa")
    low, high = ax.get_ylim()[1] / length.factor, ax.get_ylim()[0] / length.factor
    apart = APART * (high - low) * ax.figure.dpi / ax.bbox.height
    near = 2.0 * float(np.ptp(along)) / along.size
    horizontal = "y" if np.ptp(field.y) > 0.0 else "x"
    marked = [getattr(found, name) for name in MARKS]
    taken = [each.z for each in marked if abs(getattr(each, horizontal) - along[column]) < near] + [0.0, high]
    places = []
    for level in np.asarray(lines.levels)[::-1].tolist():
        depth = _crossing(stress(field.von_mises[column]), field.z[0], level, apart)
        if depth is not None and all(abs(depth - other) > apart for other in taken):
            taken.append(depth)
            places.append((float(length(along[column])), float(length(depth))))
    if places:
        ax.clabel(lines, manual=places, fmt="%.4g", fontsize=SMALL_SIZE, inline_spacing=2.0)


def _crossing(stress: Array, depths: Array, level: float, apart: float) -> float | None:
    """Return the greatest depth at which the stress falls below a level; None if nowhere, or just below its rise."""
    above = np.flatnonzero(stress >= level)
    # At the tip of a contour the label would lie across it.
    if above.size == 0 or above[-1] == stress.size - 1 or depths[above[-1]] - depths[above[0]] < apart:
        return None
    k = above[-1]
    return float(np.interp(level, [stress[k + 1], stress[k]], [depths[k + 1], depths[k]]))


def _calm_column(solution: Solution, y: Array, overall: Extremes, station: float | None) -> int:
    """Return the column of the plane where labels are farthest from markers and from the cross-section."""
    taken = [getattr(overall, name).y for name in MARKS] + ([] if station is None else [station])
    low, high = solution.contact_y[0][0], solution.contact_y[-1][1]
    places = [low + share * (high - low) for share in SHARES]
    # Among equally good positions the first, which is nearest to the middle.
    best = max(places, key=lambda y: min(round(min(abs(y - other) for other in taken), 9), 0.2 * (high - low)))
    return int(np.abs(y - best).argmin())


def _mark(name: str, found: Extreme, span: tuple[float, float] | None, ax: Axes) -> Entry:
    """Mark where a stress is largest, along the ``span`` or across, and return its legend entry."""
    marker, size, words = MARKS[name]
    # The stress field of the strips is symmetric about x = 0.
    sideways = [found.y] if span else [-found.x, found.x] if found.x > 0.0 else [0.0]
    length = measure("mm")
    depth = length.factor * found.z
    depth = np.nan if found.at_bore and depth > ax.get_ylim()[0] else depth  # further down than is drawn
    (mark,) = ax.plot(
        length(sideways), [depth] * len(sideways), marker, markersize=size, color=INK, markerfacecolor="white",
        markeredgewidth=THIN, clip_on=False, zorder=4.0 - 0.1 * size,
    )  # fmt: skip
    at = [f"$x$ = ±{written(mm(found.x), 3)}"] if found.x > 0.0 else []
    at += [f"$y$ = {_station(found.y, span)}"] if span else []
    return mark, f"{words} {written(mpa(found.max))} {found.site}{', '.join([*at, f'$z$ = {written(mm(found.z), 3)}'])}"


def _draw_surface(intervals: tuple[tuple[float, float], ...], label: str, ax: Axes) -> list[Entry]:
    style: dict[str, Any] = {"color": SECOND, "linewidth": 2.4, "solid_capstyle": "butt", "zorder": 2.5}
    drawn = [ax.plot(measure("mm")(pair), [0.0, 0.0], clip_on=False, **style) for pair in intervals]
    return [(drawn[0][0], label)] if drawn else []


def _station(y: float, span: tuple[float, float]) -> str:
    words = place(span, y)
    return words if float(words.split()[0].replace("−", "-")) else f"0 {words.split()[1]}"


def _draw_ends(solution: Solution, span: tuple[float, float], ax: Axes) -> list[Entry]:
    """Draw a line where a body ends, and return a legend entry that names the bodies."""
    entries: dict[str, Line2D] = {}
    for end, name in body_ends(solution):
        if span[0] < end < span[1]:
            at = measure("mm").factor * end
            entries[name] = ax.axvline(at, color=FAINT_INK, linewidth=THIN, linestyle=END_DASHES, zorder=1.5)
    return [(next(iter(entries.values())), ", ".join(entries))] if entries else []


def _head(solution: Solution, plane: str, landmarks: list[Entry], others: list[Entry], ax: Axes) -> None:
    """Write conditions, plane and legend above the axes: markers in the first column, the rest in the second."""
    from matplotlib.lines import Line2D

    # A legend is filled column by column, so blanks must fill up the second one.
    blank_entry = (Line2D([], [], linestyle="none"), "")
    entries = [*landmarks, *others, *[blank_entry] * (len(landmarks) - len(others))]
    handles, labels = zip(*entries, strict=True)
    spacing = {"borderaxespad": 0.4, "handlelength": 1.8, "handletextpad": 0.5, "columnspacing": 1.4}
    key_above(ax, handles, labels, columns=2, **spacing)
    ax.set_title(f"{conditions(solution)}; {plane}", loc="left", pad=HEAD_POINTS)
