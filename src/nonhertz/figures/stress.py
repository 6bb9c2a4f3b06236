"""Figures of the stress below the surface: in a plane along a contact, and in one across it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from nonhertz.amounts import mm, mpa
from nonhertz.figures.contact import conditions
from nonhertz.figures.value import Across, Axis, Bar, Contours, Figure, Mark, Panel, Points, Range, Symbol
from nonhertz.result.along import body_ends
from nonhertz.result.area import element_peak
from nonhertz.result.solution import Solution
from nonhertz.subsurface import Extreme, Extremes, Field
from nonhertz.subsurface.evaluation import across_at

LARGEST: Mapping[str, tuple[Symbol, str]] = {
    "von_mises": ("circle", "max. von Mises"),
    "shear": ("diamond", "max. shear"),
    "orthogonal_shear": ("triangle", "max. |τ_xz|"),
}
"""What is marked, with its symbol and label."""
BEYOND = 0.02
"""Of the range along, left blank beyond a side face."""
ABOVE = 1.01
"""Over the last colour, of stresses that are said to lie beyond it."""


def along_contact(
    solution: Solution, field: Field, largest: Mapping[str, Extreme], station: float | None = None
) -> Figure:
    """Return the figure of `nonhertz.plot.axial_stress`.

    The largest stresses given by their names in `nonhertz.subsurface.Extremes` are marked; that of von Mises must be
    among them.
    """
    span = _with_room(solution, field)
    ends = {end: name for end, name in body_ends(solution) if span[0] < end < span[1]}
    marks = [
        *(Across(end, name=name, colour="faint", dash="ends") for end, name in ends.items()),
        *([] if station is None else [Across(station, name=_station(station), colour="ink", dash="dashed")]),
        *_bars(solution.contact_y, "contact"),
        *(
            Points(np.array([extreme.y]), np.array([_drawn(extreme, field)]), name=words, colour="ink", symbol=symbol)
            for extreme, symbol, words in _largest(largest, along=True)
        ),
    ]
    heading = f"Along the contact, body {field.body}, x = {mm(float(field.x[0, 0])):.4g}"
    worst = largest["von_mises"]
    description = (
        f"Von Mises stress along the contact in body {field.body}: largest {mpa(worst.max):.4g} {worst.site}"
        f"y = {mm(worst.y):.4g}, {mm(worst.z):.4g} deep."
    )
    axis = Axis("Axial position y", "y", "mm", range=span)
    contours = Contours(field.y[:, 0], field.z[0], field.von_mises)
    panel = _panel("axial", heading, [contours, *marks], description, _colours(solution, field, worst))
    caption = f"Von Mises stress in body {field.body} below the centre line, along the contact."
    return Figure(axis, (panel,), conditions(solution), caption)


def across_contact(solution: Solution, field: Field, largest: Mapping[str, Extreme]) -> Figure:
    """Return the figure of `nonhertz.plot.section_stress`, with largest stresses as for `along_contact`."""
    x, y = field.x[:, 0], float(field.y[0, 0])
    middle, half_width = (float(number) for number in across_at(solution, np.asarray(y)))
    marks = [
        *_bars([(middle - half_width, middle + half_width)], f"contact, half-width {mm(half_width):.3g}"),
        *(
            Points(_both_sides(extreme.x), np.full(_both_sides(extreme.x).size, _drawn(extreme, field)), name=words,
                   colour="ink", symbol=symbol)
            for extreme, symbol, words in _largest(largest, along=False)
        ),
    ]  # fmt: skip
    worst = largest["von_mises"]
    description = (
        f"Von Mises stress across the contact in body {field.body} at y = {mm(y):.4g}: largest {mpa(worst.max):.4g}, "
        f"{mm(worst.z):.4g} deep."
    )
    axis = Axis("Across x", "x", "mm", range=(float(x[0]), float(x[-1])))
    heading = f"Across the contact, body {field.body}, y = {mm(y):.3g}"
    contours = Contours(x, field.z[0], field.von_mises)
    panel = _panel("section", heading, [contours, *marks], description, _colours(solution, field, worst))
    caption = f"Von Mises stress in the cross-section at y = {mm(y):.4g}."
    return Figure(axis, (panel,), conditions(solution), caption)


def extremes_by_name(overall: Extremes) -> dict[str, Extreme]:
    """Return the largest stresses of a body or a cross-section that figures mark."""
    return {name: getattr(overall, name) for name in LARGEST}


def _panel(name: str, heading: str, marks: Sequence[Mark], description: str, colours: Axis) -> Panel:
    deepest = max(mark.y[-1] for mark in marks if isinstance(mark, Contours))
    depth = Axis("Depth z", "z", "mm", range=(float(deepest), 0.0))
    return Panel(name, heading, depth, marks, description, height=270, colours=colours, proportional=True)


def _colours(solution: Solution, field: Field, worst: Extreme) -> Axis:
    """Return the axis of colours: up to the largest stress, unless that is an artefact of a step between strips."""
    limit = min(worst.max, element_peak(solution)) or 1.0
    # On the surface itself the stress is also unbounded at a step of the pressure from strip to strip.
    below = field.von_mises[:, field.z[0] > 0.0]
    beyond = bool(np.nanmax(below, initial=0.0) > ABOVE * limit)
    return Axis("Von Mises stress", "σ", "MPa", range=(0.0, limit), cut=beyond)


def _with_room(solution: Solution, field: Field) -> Range:
    """Return the range of y [mm] to draw: that of the field, and a little more where it reaches the end of the body."""
    low, high = float(field.y[0, 0]), float(field.y[-1, 0])
    room = BEYOND * (high - low)
    faces = solution.contact.bodies[field.body].faces
    return low - room * bool(np.isclose(low, faces[0])), high + room * bool(np.isclose(high, faces[1]))


def _bars(intervals: list[Range] | tuple[Range, ...], name: str) -> Iterator[Mark]:
    """Yield the contact on the surface."""
    for number, (low, high) in enumerate(intervals):
        yield Bar(low, high, 0.0, name="" if number else name, colour="second")


def _largest(largest: Mapping[str, Extreme], *, along: bool) -> Iterator[tuple[Extreme, Symbol, str]]:
    """Yield largest stresses with symbol and words."""
    for name, (symbol, label) in LARGEST.items():
        if name not in largest:
            continue
        extreme = largest[name]
        places = [f"x = ±{mm(extreme.x):.3g}"] if extreme.x > 0.0 else []
        places += [f"y = {mm(extreme.y):.3g}"] if along else []
        where = ", ".join([*places, f"z = {mm(extreme.z):.3g}"])
        yield extreme, symbol, f"{label} {mpa(extreme.max):.4g} {extreme.site}{where}"


def _drawn(extreme: Extreme, field: Field) -> float:
    """Return the depth of a largest stress [mm], nan if it is further down than is drawn."""
    return float("nan") if extreme.z > field.z.max() else extreme.z


def _both_sides(x: float) -> np.ndarray:
    # The stress field of the strips is symmetric about x = 0.
    return np.array([-x, x] if x > 0.0 else [0.0])


def _station(y: float) -> str:
    return f"cross-section, y = {mm(y):.3g}"
