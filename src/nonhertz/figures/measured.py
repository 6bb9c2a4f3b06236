"""Figure of a measured profile: a panel for every step from the raw trace to the relief, to the scale of the land."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import amount, um
from nonhertz.figures.value import Across, Axis, Figure, Level, Line, Mark, Panel, Range
from nonhertz.figures.value import Points as Dots
from nonhertz.measured import Measured, Points, ProfileFit, StepResult

Array = NDArray[np.float64]

COLUMNS = 400
"""Of a line with more points, in each of which the lowest and the highest are drawn: print resolves no more."""
MILLIMETRES_FROM, MICROMETRES_FROM = 0.5, 1e-5
"""mm: greater ranges of heights are read in mm, and in um."""
CUT = 4.0
"""Times the range of the land: where the trace goes down further, the axis is cut."""
ROOM, ROOM_BELOW, ASIDE = 0.12, 0.36, 0.01
"""Beside what is drawn, of its range: above, below a relief, where corners begin, and to the sides."""
FLAT = 1e-6
"""mm: a perfectly flat line still needs a range."""
BESIDE_CORNER = 0.2
"""Of the width of a corner: how much of the land is drawn beside it."""
HEIGHT = 130


def measured_steps(measured: Measured, fit: ProfileFit | None = None) -> Figure:
    """Return the steps of a measured profile, from the raw trace to the relief.

    Each step but the thinning has a panel with its sentence: heights before and after, and what was removed. Then come
    the relief, with a fitted profile and its residual if there is one, and each corner that was kept, with its points
    before smoothing. Axes are those of the land, dashed lines its ends. Of a line with too many points, the lowest and
    highest in each of 400 columns are there.

    Parameters
    ----------
    measured : Measured
        The trace and its steps.
    fit : ProfileFit, optional
        A profile of the catalogue to draw beside the relief.
    """
    panels: list[Panel] = []
    for before, after in pairwise(measured.states):
        if after.name != "thin":
            panels += [_step(before, after), *_roughness(after)]
    panels += [_relief(measured, fit), *_residual(measured, fit), *_corners(measured)]
    panels = [replace(panel, beside=place % 2 == 1) for place, panel in enumerate(panels)]
    points = measured.points
    source = measured.trace.name and f" of {measured.trace.name}"
    caption = f"From the measured points{source} to the profile, step by step."
    return Figure(_along(points.y[0], points.y[-1]), panels, measured.states[0].words.rstrip("."), caption)


def _step(before: StepResult, after: StepResult) -> Panel:
    heights, cut = _range_of(before, after)
    marks: list[Mark] = [
        *_ends(after),
        Line(*_thin(before.y, before.height), name="before", colour="faint", thin=True),
        Line(*_thin(after.y, after.height), name="after", thin=True),
    ]
    if after.name == "align":
        marks.append(Across(0.0, colour="second", dash="dashed"))
    if after.removed is not None and after.removed[0].size:
        look: dict[str, Any] = {"symbol": "dot"} if after.name == "trim" else {}
        marks.append(Dots(*_thin(*after.removed), name="removed", colour="second", **look))
    axis = Axis("Height", "height", "mm", _read(heights), heights, cut=bool(cut))
    description = f"Heights before and after the step {after.name}. {after.words}"
    along = _along(min(before.y[0], after.y[0]), max(before.y[-1], after.y[-1]))
    return _panel(after.name, after.name.capitalize(), axis, marks, description, along, after.words.rstrip("."), cut)


def _range_of(before: StepResult, after: StepResult) -> tuple[Range, str]:
    """Return the range of heights that is drawn [mm], and that it is cut where corners would flatten the rest."""
    land_before, land = _on_land(before.points, after, after.numbers.get("shift", 0.0)), _on_land(after.points, after)
    low, high = float(land.min()), float(land.max())
    room, deepest, cut = max(high - low, FLAT), float(before.height.min()), ""
    if high - deepest <= CUT * room:
        low, high = min(low, deepest), max(high, float(before.height.max()))
    else:
        low, high = min(low, float(land_before.min())) - 0.5 * room, max(high, float(land_before.max()))
        cut = f"axis cut, heights to {amount(deepest, 'mm', _read((low, high))):.3g}"
    beside = max(ROOM * (high - low), FLAT, 1e-6 * abs(high))
    return (low - beside, high + beside), cut


def _on_land(points: Points, after: StepResult, shift: float = 0.0) -> Array:
    """Return the heights of points, shifted, on the land that a step knows [mm], or of their middle nine tenths."""
    ends = _land_of(after)
    if not ends:
        return points.height_between_corners
    y = points.y + shift
    return points.height[(ends[0] <= y) & (y <= ends[1])]


def _land_of(after: StepResult) -> tuple[float, ...]:
    """Return the ends of the land that a step found, or that are known since [mm]."""
    return after.points.land or tuple(after.numbers[name] for name in ("low", "high") if name in after.numbers)


def _ends(after: StepResult) -> Iterator[Across]:
    for end in _land_of(after):
        if after.y[0] < end < after.y[-1]:
            yield Across(end, colour="faint", dash="dashed")


def _roughness(after: StepResult) -> Iterator[Panel]:
    """Yield the roughness that smoothing removed, to the scale of the land."""
    if after.name != "smooth" or after.removed_height is None:
        return
    on_land = after.removed_height[~np.logical_or(*after.points.beyond_land)]
    heights = _about_zero(on_land)
    axis = Axis("Removed", "removed", "mm", _read(heights), heights, cut=True)
    marks = [*_ends(after), Line(*_thin(after.y, after.removed_height), colour="second", thin=True)]
    description = f"Heights that smoothing removed, on the land {um(after.numbers['rms']):.3g} root mean square."
    yield _panel("roughness", "Roughness removed", axis, marks, description, _along(after.y[0], after.y[-1]))


def _relief(measured: Measured, fit: ProfileFit | None) -> Panel:
    points, last = measured.points, measured.states[-1]
    land = points.on_land
    deepest = float(points.height.max() - land.height.min())
    below = ROOM if points.land is None else ROOM_BELOW
    depths = (max((1.0 + below) * deepest, FLAT), -max(ROOM * deepest, FLAT))
    axis = Axis("Relief", "relief", "mm", _read(depths), depths, cut=points.land is not None)
    marks: list[Mark] = [*_ends(last), Line(*_thin(points.y, measured.relief), name="measured", thin=True)]
    words = [last.words.rstrip(".")] if last.name == "thin" else []
    if fit is not None:
        marks.append(Line(*_thin(land.y, fit.relief(land.y)), name=fit.kind, colour="second", dash="dashed"))
        words += [f"{name} {amount(value, fit.unit_of(name)):.5g}" for name, value in fit.parameters.items()]
    description = f"Relief of {len(points)} points, on the land up to {um(deepest):.3g}."
    return _panel("profile", "Relief", axis, marks, description, _along(points.y[0], points.y[-1]), *words)


def _residual(measured: Measured, fit: ProfileFit | None) -> Iterator[Panel]:
    """Yield the residual of a fitted profile on the land."""
    if fit is None:
        return
    points, land = measured.points, measured.points.on_land
    residual = points.height.max() - land.height - fit.relief(land.y)
    heights = _about_zero(residual)
    axis = Axis("Residual", "residual", "mm", _read(heights), heights)
    marks = [Level(0.0, colour="faint"), Line(*_thin(land.y, residual), thin=True)]
    words = f"{um(fit.rms):.2g} root mean square of the points before smoothing"
    along = _along(points.y[0], points.y[-1])
    yield _panel("residual", f"Relief less {fit.kind}", axis, marks, f"Relief less {fit.kind}: {words}.", along, words)


def _corners(measured: Measured) -> Iterator[Panel]:
    """Yield each corner that was kept, with its points before smoothing."""
    points, highest = measured.points, float(measured.points.height.max())
    rough = next((b for b, a in pairwise(measured.states) if a.name in {"smooth", "thin"}), measured.states[-1])
    for side, corner in zip(("low", "high"), points.beyond_land, strict=True):
        if not corner.any():
            continue
        low, high = float(points.y[corner][0]), float(points.y[corner][-1])
        beside = BESIDE_CORNER * (high - low)
        low, high = (low, high + beside) if side == "low" else (low - beside, high)
        inside, before = ((low <= y) & (y <= high) for y in (points.y, rough.y))
        relief = measured.relief[inside]
        room = max(ROOM * float(np.ptp(relief)), FLAT)
        axis = Axis("Relief", "relief", "mm", "um", (float(relief.max()) + room, float(relief.min()) - room))
        dots = _thin(rough.y[before], highest - rough.height[before])
        marks = [
            *_ends(measured.states[-1]),
            Dots(*dots, "dot", name="before smoothing", colour="faint"),
            Line(points.y[inside], relief, name="after", thin=True),
        ]
        name = f"Corner at the {side} end"
        description = f"{name}, {um(float(relief.max())):.3g} deep."
        yield _panel(f"corner-{side}", name, axis, marks, description, _along(low, high))


def _panel(
    name: str, heading: str, upright: Axis, marks: Sequence[Mark], description: str, along: Axis, *words: str
) -> Panel:
    return Panel(name, heading, upright, marks, description, "; ".join(filter(None, words)), HEIGHT, along=along)


def _about_zero(values: Array) -> Range:
    most = (1.0 + ROOM) * max(float(np.abs(values).max()), FLAT)
    return -most, most


def _along(low: float, high: float) -> Axis:
    beside = ASIDE * (high - low)
    return Axis("Axial position y", "y", "mm", range=(float(low - beside), float(high + beside)))


def _read(heights: Range) -> str:
    """Return the unit in which heights of a range are shown; their own if empty."""
    height = abs(heights[1] - heights[0])
    return "" if height > MILLIMETRES_FROM else "um" if height > MICROMETRES_FROM else "nm"


def _thin(y: Array, height: Array) -> tuple[Array, Array]:
    """Return a line as it is drawn: all points, or the lowest and highest in each of many columns."""
    if len(y) <= 2 * COLUMNS:
        return y, height
    share = -(-len(y) // COLUMNS)
    count = len(y) // share * share
    columns = height[:count].reshape(-1, share)
    first = np.arange(0, count, share)
    extremes = first + columns.argmin(axis=1), first + columns.argmax(axis=1)
    places = np.unique(np.concatenate([*extremes, np.arange(count, len(y))]))
    return y[places], height[places]
