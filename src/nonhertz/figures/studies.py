"""Panels of studies: numbers over one input or two, distributions, and shares of the variance."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import amount
from nonhertz.figures.value import (
    SERIES,
    Across,
    Axis,
    Band,
    Bars,
    Contours,
    Line,
    Mark,
    Panel,
    Span,
    Whiskers,
    Words,
)

Array = NDArray[np.float64]
Bounds = tuple[float, float]

FEW_MARKED = 30
"""Values on a line that are marked one by one."""
WIDE, LONG_TAIL = 30.0, 10.0
"""Ratio of the largest number to the smallest, beyond which an axis is logarithmic: of lines, and of a distribution."""
MARGIN = 0.05
"""Of an axis, beyond what is drawn."""
MOST_BINS, FEWEST_BINS = 60, 5
TAILS = (0.01, 0.99)
"""Shares between which most of a distribution lies."""
FAR = 1.5
"""Times the width between the tails, from its middle: numbers beyond it are not drawn."""
THICK, SLIM, ASIDE = 0.62, 0.34, -0.24
"""Of bars, and of the upper of two whiskers on them, over the distance between them."""
HIGH, PER_NAME, AROUND_NAMES = 170, 24, 40


def fit_axis(axis: Axis, values: Array, ratio: float = math.inf, margin: float = MARGIN) -> Axis:
    """Return an axis on which values fit, logarithmic if the largest is more than that many times the smallest."""
    finite = values[np.isfinite(values)]
    if axis.categories or not finite.size:
        return axis
    low, high = float(finite.min()), float(finite.max())
    if low > 0.0 and high > ratio * low:
        room = (high / low) ** margin
        return replace(axis, range=(low / room, high * room), logarithmic=True)
    room = margin * (high - low or abs(high) or 1.0)
    return replace(axis, range=(low - room, high + room))


def lines_over(along: Axis, x: Array, lines: Mapping[str, Array], upright: Axis, *, key: str = "") -> Panel:
    """Return numbers over an input, shape (n,), a line for each name; points alone if the input has categories.

    If the largest is more than thirty times the smallest, as lives are, the axis is logarithmic.
    """
    values = np.concatenate(list(lines.values()))
    marks = list[Mark]()
    for number, (name, numbers) in enumerate(lines.items()):
        colour, dash = SERIES[number % len(SERIES)][0], SERIES[(number + number // len(SERIES)) % len(SERIES)][1]
        marked = x.size <= FEW_MARKED or np.count_nonzero(np.isfinite(numbers)) == 1
        dash = "none" if along.categories else dash
        marks.append(Line(x, numbers, name=name, colour=colour, dash=dash, marked=marked))
    words = f"{upright.label} over {_small(along.label)}: {_span(upright, values)}."
    along, upright = fit_axis(along, x), fit_axis(upright, values, WIDE)
    return Panel(upright.symbol, "", upright, marks, words, height=HIGH, along=along, key=key)


def map_over(along: Axis, x: Array, upright: Axis, y: Array, values: Array, colours: Axis) -> Panel:
    """Return numbers, shape (m, n), over two inputs as contours; words instead if all are equal."""
    span = _span(colours, values)
    words = f"{colours.label} over {_small(along.label)} and {_small(upright.label)}: {span}."
    scales = ((along, x), (upright, y), (colours, values))
    along, upright, colours = (fit_axis(axis, numbers, margin=0.0) for axis, numbers in scales)
    finite = values[np.isfinite(values)]
    if finite.size and np.ptp(finite) > 1e-9 * np.abs(finite).max():
        marks: list[Mark] = [Contours(x, y, values)]
        return Panel(colours.symbol, "", upright, marks, words, height=HIGH, colours=colours, along=along)
    instead = f"{colours.label}:\n{span} everywhere" if finite.size else f"{colours.label}:\nno row has a number"
    marks = [Words(float(np.mean(x)), float(np.mean(y)), instead)]
    return Panel(colours.symbol, "", upright, marks, words, height=HIGH, along=along)


def distribution(
    axis: Axis, values: Array, quantiles: Mapping[float, Bounds] | None = None, limits: Sequence[float] = ()
) -> Panel:
    """Return the distribution of numbers, with intervals of quantiles by probability, and limits.

    If the largest is more than ten times the smallest, the axis is logarithmic. Else single numbers far beyond the
    others, by as much as those between 1 % and 99 % differ, are counted and not drawn.
    """
    upright = Axis("Samples", "samples", range=(0.0, 1.0))
    numbers = np.sort(values[np.isfinite(values)], axis=None)
    if not numbers.size:
        words = "no sample has a number"
        along = replace(axis, range=(0.0, 1.0))
        return Panel(axis.symbol, "", upright, [Words(0.5, 0.5, words)], words, height=HIGH, along=along)
    logarithmic = bool(0.0 < LONG_TAIL * numbers[0] < numbers[-1])
    drawn, edges = _bins(numbers, logarithmic=logarithmic)
    counts = np.histogram(drawn, edges)[0].astype(float)
    middles = 0.5 * (edges[1:] + edges[:-1])
    marks: list[Mark] = [Bars(middles, counts, np.diff(edges), colour="faint", dash="dotted")]
    for share, (least, most) in (quantiles or {}).items():
        middle = math.sqrt(least * most) if logarithmic else 0.5 * (least + most)
        marks.append(Span(least, most, colour="second"))
        marks.append(Across(middle, f"{100.0 * share:g} %", above=True, colour="second"))
    marks += [Across(limit, "limit", above=True, colour="ink", dash="ends") for limit in limits]
    shown = np.array([*drawn, *limits, *(end for ends in (quantiles or {}).values() for end in ends)])
    along = fit_axis(axis, shown, 0.0 if logarithmic else math.inf)
    words = f"{numbers.size} samples of {_small(axis.label)}: {_span(axis, numbers)}."
    upright = replace(upright, range=(0.0, (1.0 + MARGIN) * float(counts.max())))
    return Panel(axis.symbol, "", upright, marks, words, _beyond(axis, numbers, drawn), HIGH, along=along)


def _bins(numbers: Array, *, logarithmic: bool) -> tuple[Array, Array]:
    """Return the sorted numbers that are drawn, and the edges of their bins."""
    bins = min(MOST_BINS, max(FEWEST_BINS, round(2.0 * numbers.size ** (1.0 / 3.0))))
    if logarithmic:
        return numbers, np.geomspace(numbers[0], numbers[-1], bins + 1)
    low, high = np.quantile(numbers, TAILS)
    near = np.abs(numbers - 0.5 * (low + high)) <= FAR * (high - low)
    drawn = numbers[near] if high > low else numbers
    return drawn, np.histogram_bin_edges(drawn, bins)


def _beyond(axis: Axis, numbers: Array, drawn: Array) -> str:
    """Return in words the share of sorted numbers that are not drawn, and their range."""
    below, above = np.count_nonzero(numbers < drawn[0]), np.count_nonzero(numbers > drawn[-1])
    tails = [("below", below, drawn[0], "down", numbers[0]), ("above", above, drawn[-1], "up", numbers[-1])]
    return "; ".join(
        f"{100.0 * count / numbers.size:.2g} % {side} {_amount(axis, end)}, {way} to {_amount(axis, last)}"
        for side, count, end, way, last in tails
        if count
    )


def variance_shares(
    names: Sequence[str], first: Array, total: Array, intervals: tuple[Array, Array] | None = None
) -> Panel:
    """Return Sobol's indices as bars beside names: the first index, shape (n,), inside the total one.

    The intervals of both, shape (2, n), are lower and upper ends.
    """
    places = np.arange(len(names), dtype=float)
    marks: list[Mark] = [
        Bars(places, total, THICK, name="in total", colour="faint", dash="dotted"),
        Bars(places, first, SLIM, name="alone"),
    ]
    if intervals is not None:
        (low, high), (least, most) = intervals
        marks.append(Whiskers(places, low, high, name="interval, alone", colour="ink"))
        marks.append(Whiskers(places, least, most, ASIDE, name="interval, in total", colour="faint"))
    alone = "; ".join(
        f"{name} {one:.2g}, in total {every:.2g}" for name, one, every in zip(names, first, total, strict=True)
    )
    upright = Axis("Share of the variance", "share", range=(0.0, 1.0))
    along = Axis("", "input", categories=tuple(names))
    return Panel("indices", "", upright, marks, f"Shares of the variance: {alone}.", sideways=True, along=along,
                 height=max(HIGH, AROUND_NAMES + PER_NAME * len(names)))  # fmt: skip


def profile_band(y: Array, nominal: Array, band: tuple[Array, Array], *, label: str) -> Panel:
    """Return the relief of a profile [mm] with a band in which most samples lie; material is taken away downwards."""
    low, high = band
    marks = [
        Band(y, low, high, colour="second"),
        Line(y, low, name="least", colour="second", dash="dotted"),
        Line(y, nominal, name="nominal", colour="ink"),
        Line(y, high, name="most", colour="second", dash="dashed"),
    ]
    values = np.concatenate([low, high, nominal])
    axis = fit_axis(Axis("Relief", "relief", "mm", "um"), values)
    least, most = axis.range or (0.0, 1.0)
    upright, along = replace(axis, range=(most, least)), fit_axis(Axis("Axial position y", "y", "mm"), y)
    words = f"Relief along y, nominal and {label}: {_span(axis, values)}."
    return Panel("profile", "", upright, marks, words, height=HIGH, along=along, key=label)


def _small(words: str) -> str:
    return words[:1].lower() + words[1:]


def _amount(axis: Axis, *values: float) -> str:
    return f"{amount(values, axis.unit, axis.read, ' to '):.4g}"


def _span(axis: Axis, values: Array) -> str:
    """Return the range of values in words."""
    finite = values[np.isfinite(values)]
    if not finite.size:
        return "no number"
    return _amount(axis, *dict.fromkeys((float(finite.min()), float(finite.max()))))
