"""Drawings of studies: numbers against one or two parameters, and how they are distributed.

They take plain arrays and labels, so that numbers of any origin can be drawn.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from nonhertz.amounts import format_input
from nonhertz.plot.axes import OWN, Axes, drawing, measure, note, open_frame
from nonhertz.plot.style import (
    COLOUR_MAP,
    END_DASHES,
    FAINT_INK,
    FIRST,
    HAIR,
    INK,
    LINE,
    PALE,
    SECOND,
    SMALL_SIZE,
    THIN,
)

LEVELS, BINS_AT_MOST = 10, 60
WIDE = 30.0
LONG_TAIL = 10.0
LETTER = 0.03  # width of a small letter, in shares of the narrowest axes
FEW_MARKED = 30  # values on a line that are marked one by one
DASHES: tuple[Any, ...] = ("-", (0, (5, 1.5)), (0, (6, 1.2, 1.2, 1.2)), (0, (1.2, 1.2)), (0, (9, 2)), (0, (3, 3)))


@drawing
def study_lines(
    x: ArrayLike, lines: Mapping[str, ArrayLike], ax: Axes = OWN, *, x_label: str, y_label: str, key: str = ""
) -> Axes:
    """Draw numbers against one parameter, a line for each name; a gap where there is no number.

    If the largest is more than thirty times the smallest, as lives are, the axis is logarithmic.

    Parameters
    ----------
    x : array_like, shape (n,)
        Values of the parameter: numbers, or words.
    lines : mapping of str to array_like, shape (n,)
        Numbers by what the line is called; a single line needs no name.
    x_label, y_label : str
        Names of the axes, with units.
    key : str
        Heading of the names.
    """
    places = np.asarray(x)
    words = places.dtype.kind not in "iuf"
    at = np.arange(places.size) if words else places
    shades = _shades(len(lines))
    for number, (name, values) in enumerate(lines.items()):
        numbers = np.asarray(values, dtype=float)
        alone = at.size <= FEW_MARKED or np.count_nonzero(np.isfinite(numbers)) == 1
        style = "" if words else DASHES[number % len(DASHES)]
        mark = "o" if alone else ""
        ax.plot(at, numbers, linestyle=style, color=shades[number], lw=LINE, label=name, marker=mark, ms=2.5)
    if words:
        ax.set_xticks(at, [str(word) for word in places.tolist()])
    ax.set(xlabel=x_label, ylabel=y_label)
    open_frame(ax)
    every = np.concatenate([np.asarray(values, dtype=float) for values in lines.values()])
    every = every[np.isfinite(every)]
    if every.size and every.min() > 0.0 and every.max() > WIDE * every.min():
        ax.set_yscale("log")
    if len(lines) > 1:
        ax.legend(fontsize=SMALL_SIZE, frameon=False, title=key, title_fontsize=SMALL_SIZE)
    return ax


@drawing
def study_map(
    x: ArrayLike, y: ArrayLike, values: ArrayLike, ax: Axes = OWN, *, x_label: str, y_label: str, label: str
) -> Axes:
    """Draw numbers over two parameters as a map with contours; white where there is no number.

    Parameters
    ----------
    x, y : array_like, shape (m,), (n,)
        Values of the parameters.
    values : array_like, shape (n, m)
        The numbers.
    ax : matplotlib.axes.Axes, optional
        Where to draw; a colour bar is put beside it; if left out, in a figure of its own, ``ax.figure``.
    x_label, y_label, label : str
        Names of the axes and of the numbers, with units.
    """
    numbers = np.ma.masked_invalid(np.asarray(values, dtype=float))
    ax.set(xlabel=x_label, ylabel=y_label)
    if not numbers.count() or np.ptp(numbers.compressed()) <= 1e-9 * np.abs(numbers).max():
        value = f"{numbers.compressed()[0]:.5g} everywhere" if numbers.count() else "no row has a number"
        return _instead(ax, f"{label}:\n{value}", fontsize=SMALL_SIZE)
    field = ax.contourf(x, y, numbers, levels=LEVELS, cmap=COLOUR_MAP)
    levels = np.asarray(field.levels)
    inks = ["white" if level < np.median(levels) else INK for level in levels]
    lines = ax.contour(x, y, numbers, levels=levels, colors=inks, linewidths=HAIR)
    ax.clabel(lines, levels[1::2], fontsize=SMALL_SIZE - 1.0)
    ax.figure.colorbar(field, ax=ax, label=label)
    return ax


@drawing
def histogram(
    values: ArrayLike,
    ax: Axes = OWN,
    *,
    label: str,
    quantiles: Mapping[float, tuple[float, float]] | None = None,
    limits: Sequence[float] = (),
) -> Axes:
    """Draw how numbers are distributed, with quantiles and the intervals in which they surely lie.

    If the largest is more than ten times the smallest, the axis is logarithmic. Else single numbers far beyond the
    others, by as much as those between 1 % and 99 % differ, are counted and not drawn.

    Parameters
    ----------
    values : array_like
        The numbers; those that are not finite are left out.
    label : str
        Name of the numbers, with their unit.
    quantiles : mapping of float to pair of float, optional
        Intervals by share, such as ``{0.5: (1990.0, 2010.0)}``.
    limits : sequence of float
        Limits that the numbers are to keep.
    """
    numbers = np.asarray(values, dtype=float).ravel()
    numbers = numbers[np.isfinite(numbers)]
    ax.set(xlabel=label, ylabel="Samples")
    open_frame(ax)
    if not numbers.size:
        return _instead(ax, "no sample has a number")
    bins = min(BINS_AT_MOST, max(5, round(2.0 * numbers.size ** (1.0 / 3.0))))
    edges: Any = bins
    low_end, high_end = np.quantile(numbers, (0.01, 0.99))
    far = np.abs(numbers - 0.5 * (low_end + high_end)) > 1.5 * (high_end - low_end)
    if numbers.min() > 0.0 and numbers.max() > LONG_TAIL * numbers.min():
        ax.set_xscale("log")
        edges = np.geomspace(numbers.min(), numbers.max(), bins + 1)
    elif far.any() and high_end > low_end:
        ends = dict.fromkeys(format_input(end) for end in (numbers[far].min(), numbers[far].max()))
        words = f"{np.count_nonzero(far)} beyond: {' to '.join(ends)}"
        ax.text(0.98, 0.95, words, transform=ax.transAxes, ha="right", va="top", fontsize=SMALL_SIZE)
        numbers = numbers[~far]
    ax.hist(numbers, bins=edges, color=PALE, edgecolor=FAINT_INK, linewidth=HAIR)
    marks: list[tuple[float, str, str, Any]] = []
    for share, (low, high) in (quantiles or {}).items():
        ax.axvspan(low, high, color=SECOND, alpha=0.25, linewidth=0.0)
        marks.append((0.5 * (low + high), f"{100.0 * share:g} %", SECOND, "-"))
    marks += [(limit, "limit", INK, END_DASHES) for limit in limits]
    for place, _, ink, dashes in marks:
        ax.axvline(place, color=ink, linewidth=THIN, linestyle=dashes)
    _above(ax, [(place, words) for place, words, *_ in marks])
    return ax


def _above(ax: Axes, marks: Sequence[tuple[float, str]]) -> None:
    """Write words above the axes at places along them, on a further line where they would overlap."""
    ends: list[float] = []  # of the words on each line, in shares of the axes
    for place, words in sorted(marks):
        at = float(ax.transAxes.inverted().transform(ax.transData.transform((place, 0.0)))[0])
        half = 0.5 * LETTER * len(words)
        line = next((number for number, end in enumerate(ends) if end <= at - half), len(ends))
        ends[line : line + 1] = [at + half]
        note(ax, words, (place, 1.0), "center", above=2.0 + 1.2 * SMALL_SIZE * line, across=True)


@drawing
def tornado(
    names: Sequence[str],
    first: ArrayLike,
    total: ArrayLike,
    ax: Axes = OWN,
    *,
    intervals: tuple[ArrayLike, ArrayLike] | None = None,
) -> Axes:
    """Draw Sobol's indices as bars, the first name on top: the first index inside the total one.

    Parameters
    ----------
    names : sequence of str
        The parameters.
    first, total : array_like, shape (n,)
        Their indices, from 0 to 1.
    intervals : pair of array_like, shape (2, n), optional
        Of both, the lower and the upper ends of the intervals in which they lie.
    """
    places = -np.arange(len(names), dtype=float)
    line: dict[str, Any] = {"fmt": "none", "capsize": 2.0, "linewidth": THIN}
    first, total = np.asarray(first, dtype=float), np.asarray(total, dtype=float)
    ax.barh(places, total, height=0.62, color=PALE, edgecolor=FAINT_INK, linewidth=HAIR, label="total")
    ax.barh(places, first, height=0.34, color=FIRST, label="alone")
    for values, ends, place, ink in zip((first, total), intervals or (), (0.0, 0.24), (INK, FAINT_INK), strict=False):
        xerr = np.abs(np.asarray(ends, dtype=float) - values)
        ax.errorbar(values, places + place, xerr=xerr, ecolor=ink, **line)
    ax.set_yticks(places, list(names))
    ax.set_xlabel("Share of the variance")
    ax.set_xlim(0.0, 1.0)
    ax.legend(fontsize=SMALL_SIZE, frameon=False, loc="lower right")
    open_frame(ax)
    return ax


@drawing
def profile_band(
    y: ArrayLike, nominal: ArrayLike, band: tuple[ArrayLike, ArrayLike], ax: Axes = OWN, *, label: str
) -> Axes:
    """Draw a profile with the band in which most of its samples lie; relief grows downwards, as material is taken away.

    Parameters
    ----------
    y : array_like, shape (n,)
        Positions along the body [mm].
    nominal : array_like, shape (n,)
        Relief of the nominal profile [mm].
    band : pair of array_like, shape (n,)
        Lowest and highest relief of the band [mm].
    label : str
        What the band is.
    """
    length, depth = measure("mm"), measure("mm", "um")
    low, high = depth(band[0]), depth(band[1])
    ax.fill_between(length(y), low, high, color=SECOND, alpha=0.25, linewidth=0.0, label=label)
    ax.plot(length(y), depth(nominal), color=INK, linewidth=LINE, label="nominal")
    ax.invert_yaxis()
    ax.set(xlabel=length.label("Axial position $y$"), ylabel=depth.label("Relief"))
    ax.legend(fontsize=SMALL_SIZE, frameon=False, loc="lower center")
    open_frame(ax)
    return ax


def _instead(ax: Axes, words: str, **style: Any) -> Axes:
    """Write words in place of a drawing."""
    ax.text(0.5, 0.5, words, transform=ax.transAxes, ha="center", va="center", **style)
    return ax


def _shades(count: int) -> Sequence[Any]:
    """Return colours of lines: the usual ones of two, and shades from the map of more."""
    if count <= 2:
        return (FIRST, SECOND)[:count]
    import matplotlib as mpl

    return [mpl.colormaps[COLOUR_MAP](share) for share in np.linspace(0.0, 0.85, count)]
