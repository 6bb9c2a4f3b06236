"""Where along a contact its bodies fatigue: damage per length by several models."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from nonhertz.amounts import Amount, mrad, newton
from nonhertz.figures.contact import conditions
from nonhertz.life import Life, Overrolled, VolumeModel
from nonhertz.life.overrolling import outer
from nonhertz.model.body import BODIES, BodyName
from nonhertz.plot.axes import OWN, Artist, Axes, Figure, along, drawing, key_above, measure, open_frame
from nonhertz.plot.axial import draw_body_ends, mark_unlimited, number, written
from nonhertz.plot.sheets import sheet, stacked
from nonhertz.plot.style import COLOUR_MAP, FAINT_INK, FIRST, HAIR, INK, LINE, PALETTE, THIN, sheet_style
from nonhertz.result.along import axial_range
from nonhertz.result.solution import Solution

Spectrum = Sequence[tuple[Solution, float]]

# Inches: above each panel its name and rows of the legend.
HEAD, NAME, ROW, HIGH, HIGH_OF_TWO, BETWEEN = 0.06, 0.22, 0.17, 2.6, 2.0, 0.35
COLUMNS, COLUMNS_COMPARED = 3, 2  # of the legend: the labels of compared lines are longer
DENT_HIGH = 2.7
MODELS = ("lundberg-palmgren", "ioannides-harris", "zaretsky", "weibull")
LINES: dict[str, tuple[str, Any]] = {**dict(zip(MODELS, PALETTE, strict=False)), "iso-16281": (INK, "-")}
OTHER_COLOUR, OTHER_WIDTH = "#9A9A9A", 1.8
PEAKED = 6.0  # times the ideal: above this the axis is logarithmic
FAINTEST = 1e-2  # of the ideal: lower end of a logarithmic axis
ROOM = 1.1
ALIKE = 0.05  # of the life: if the bodies differ by less, only one is drawn


@drawing
def life_density(spectrum: Spectrum, lives: Sequence[Life], ax: Axes = OWN, *, compared: Sequence[Life] = ()) -> Axes:
    """Draw where a body fatigues: damage per length against y, over its mean under the ideal pressure.

    1, the thin line, is Hertz's line pressure with the load spread evenly. The laminae of ISO/TS 16281 are steps. If
    the damage by any model exceeds six times the ideal somewhere, the axis is logarithmic, from a hundredth. The legend
    gives the lives.

    Parameters
    ----------
    spectrum : sequence of pairs
        Solutions and their shares of the revolutions.
    lives : sequence of Life
        Lives of one body by several models.
    compared : sequence of Life
        Lives of that body in another case; only the first is drawn, as a broad grey line.
    """
    widest = max((solution for solution, _ in spectrum), key=lambda solution: float(np.ptp(axial_range(solution))))
    spans = [axial_range(solution) for solution, _ in spectrum]
    span = min(low for low, _ in spans), max(high for _, high in spans)
    entries = [_draw(life, ax) for life in lives]
    entries += [_draw(life, ax, compared=True) for life in compared[:1]]
    ax.axhline(1.0, color=FAINT_INK, linewidth=HAIR, zorder=1.0)
    _scale([*lives, *compared[:1]], ax)
    along(ax, span)
    draw_body_ends(widest, ax)
    ax.set_ylabel("Damage per length\nover the ideal [-]")
    open_frame(ax)
    if any(np.isnan(life.reference) for life in lives):
        words = "The bodies can touch over an unlimited length:\nthere is no ideal pressure to compare with."
        ax.text(0.5, 0.6, words, transform=ax.transAxes, ha="center", va="center")
    elif any(solution.singular_ends for solution, _ in spectrum):
        mark_unlimited([solution for solution, _ in spectrum], ax)
    handles, labels = zip(*entries, strict=True)
    columns = COLUMNS_COMPARED if compared else COLUMNS
    key_above(ax, handles, labels, columns=columns, handlelength=2.6, labelspacing=0.35)
    ax.set_title(f"body {lives[0].body}", loc="left", pad=_key_points(_rows(lives, bool(compared))))
    return ax


def life_figure(
    spectrum: Spectrum,
    lives: Mapping[BodyName, Sequence[Life]],
    title: str = "",
    compared: Mapping[BodyName, Sequence[Life]] | None = None,
) -> Figure:
    """Return a finished figure of `life_density`, a panel per body, or only for b if their lives are within 5 %.

    Parameters
    ----------
    spectrum : sequence of pairs
        Solutions and their shares of the revolutions.
    lives : mapping of str to sequence of Life
        One life per model for each body, ``"a"`` and ``"b"``.
    title : str
        Heading; none if empty.
    compared : mapping of str to sequence of Life, optional
        Those of another case.

    Returns
    -------
    matplotlib.figure.Figure
        `save` writes it.
    """
    other = compared or {}
    bodies = BODIES[1:] if _alike(lives) and _alike(other) else BODIES
    rows = _rows(lives["b"], bool(other))
    heads = [room + NAME + ROW * rows for room in (HEAD, BETWEEN)[: len(bodies)]]
    heights = [HIGH] if len(bodies) == 1 else [HIGH_OF_TWO] * 2
    with sheet_style():
        figure, panels = stacked(heads, heights, title, [_conditions(spectrum)])
        shown = [life for body in bodies for life in (*lives[body], *other.get(body, ())[:1])]
        for body, axes in zip(bodies, panels, strict=True):
            life_density(spectrum, lives[body], axes, compared=other.get(body, ()))
            _scale(shown, axes)
            if len(bodies) == 1:
                none = all(np.isnan(life.relative_life) for life in lives["b"])
                words = "bodies a and b" if none else f"body b; lives of body a are within {100.0 * ALIKE:g} %"
                axes.set_title(words, loc="left", pad=_key_points(rows))
            elif body == "a":
                axes.set_xlabel("")
    return figure


def dent_figure(found: Overrolled, model: VolumeModel, title: str = "") -> Figure:
    """Return a figure of what a dent that is rolled over does to its surroundings, by one model.

    On the left the largest value of the model's stress over the passage and the depth; on the right the share of the
    added damage that lies within a distance of the middle, in either direction. Thin lines are the bowl and the rim.

    Parameters
    ----------
    found : Overrolled
        The dent, rolled over.
    model : VolumeModel
        A model of `nonhertz.life`.
    title : str
        Heading; none if empty.

    Returns
    -------
    matplotlib.figure.Figure
        `save` writes it.
    """
    rim = 0.5 * outer(found.dent)
    length, stress = measure("mm"), measure("MPa")
    with sheet_style():
        figure = sheet(DENT_HIGH)
        figure.set_layout_engine("constrained")
        area, share = figure.subplots(1, 2, width_ratios=(1.2, 1.0))
        largest = getattr(found, model.stress).max(axis=-1)
        places = length(found.y), length(found.x)
        field = area.pcolormesh(*places, stress(largest), cmap=COLOUR_MAP, shading="nearest", rasterized=True)
        around = np.linspace(0.0, 2.0 * np.pi, 181)
        for radius in {rim, 0.5 * found.dent.diameter}:
            circle = found.dent.y + radius * np.cos(around), radius * np.sin(around)
            area.plot(*(length(each) for each in circle), color="white", linewidth=HAIR)
        area.set(xlabel=length.label("Axial position $y$"), aspect="equal")
        area.set_ylabel(length.label("By the middle of the dent $x$"))
        area.locator_params(nbins=5)
        figure.colorbar(field, ax=area, label=stress.label(f"Largest {model.stress.replace('_', ' ')}"), shrink=0.8)
        reach = np.linspace(0.0, found.x[-1], 60)[1:]
        excess = np.array([found.excess(model, each) for each in reach])
        share.axvline(length.factor * rim, color=FAINT_INK, linewidth=HAIR)
        share.plot(length(reach), excess / (excess[-1] or 1.0), color=FIRST, linewidth=LINE)
        share.set_xlabel(length.label("Up to this distance from the middle"))
        share.set_ylabel("Share of the added damage [-]")
        share.set_xlim(0.0, length.factor * reach[-1])
        open_frame(share)
        if title:
            figure.suptitle(title, x=0.01, ha="left")
    return figure


def _draw(life: Life, ax: Axes, *, compared: bool = False) -> tuple[Artist, str]:
    """Draw the damage by a model, that of another case as a broad grey line; return its entry of the legend."""
    colour, dashes = LINES[life.model.name]
    y, density = measure("mm")(life.y), np.where(np.isfinite(life.density), life.density, np.nan)
    drawn: Artist
    if compared:
        (drawn,) = ax.plot(y, density, color=OTHER_COLOUR, linewidth=OTHER_WIDTH, zorder=2.0)
    elif life.model.name == "iso-16281":
        edges = 0.5 * (y[1:] + y[:-1])
        ends = 2.0 * y[[0, -1]] - edges[[0, -1]]
        edges = np.concatenate([ends[:1], edges, ends[1:]])
        drawn = ax.stairs(density, edges, baseline=None, color=colour, linewidth=THIN, zorder=2.5)
    else:
        (drawn,) = ax.plot(y, density, color=colour, linewidth=LINE, linestyle=dashes, zorder=3.0)
    words = f"life {number(life.relative_life, 3)}" if np.isfinite(life.relative_life) else "no damage"
    words = "no ideal life" if np.isnan(life.relative_life) and np.isnan(life.reference) else words
    return drawn, f"{life.model.name}{', other case' * compared}: {words}"


def _scale(lives: Sequence[Life], ax: Axes) -> None:
    """Choose the axis: linear from zero, or logarithmic if the damage peaks."""
    finite = np.concatenate([life.density[np.isfinite(life.density)] for life in lives])
    highest = max(1.0, float(finite.max(initial=0.0)))
    if highest <= PEAKED:
        ax.set_ylim(0.0, ROOM * highest)
        return
    ax.set_yscale("log")
    ax.set_ylim(FAINTEST, 2.0 * highest)


def _rows(lives: Sequence[Life], compared: bool) -> int:
    """Return how many rows the legend has."""
    return math.ceil((len(lives) + compared) / (COLUMNS_COMPARED if compared else COLUMNS))


def _key_points(rows: int) -> float:
    return 6.0 + 72.0 * ROW * rows


def _alike(lives: Mapping[BodyName, Sequence[Life]]) -> bool:
    """Return whether both bodies last equally long by all models."""
    a, b = ([life.relative_life for life in lives.get(body, ())] for body in BODIES)
    return bool(np.allclose(a, b, rtol=ALIKE, atol=0.0, equal_nan=True))


def _conditions(spectrum: Spectrum) -> str:
    """Return the line that says what was solved."""
    if len(spectrum) == 1:
        return conditions(spectrum[0][0])
    loads, tilts = ([getattr(solution, name) for solution, _ in spectrum] for name in ("load", "tilt"))
    return f"Spectrum of {len(loads)} loads, {_span(newton, loads)}, tilt {_span(mrad, tilts)}"


def _span(kind: Callable[..., Amount], values: Sequence[float]) -> str:
    ends = kind(min(values), max(values), between=" to ")
    factor, _ = ends.scale
    same = number(factor * ends.values[0]) == number(factor * ends.values[1])
    return written(kind(max(values)) if same else ends)
