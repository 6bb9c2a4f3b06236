"""Figure of the damage per length along a contact by several fatigue models."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import Amount, format_input, mrad, newton
from nonhertz.figures.contact import conditions, no_limits
from nonhertz.figures.value import SERIES, Across, Axis, Colour, Dash, Figure, Level, Line, Mark, Panel, Range, Words
from nonhertz.life import Life
from nonhertz.model.body import BODIES, BodyName
from nonhertz.result.along import axial_range, ends_in_sight
from nonhertz.result.solution import Solution

Array = NDArray[np.float64]
Spectrum = Sequence[tuple[Solution, float]]

MODELS = ("lundberg-palmgren", "ioannides-harris", "zaretsky", "weibull")
LOOKS: Mapping[str, tuple[Colour, Dash]] = dict(zip(MODELS, SERIES, strict=False)) | {"iso-16281": ("ink", "solid")}
PEAKED = 6.0
"""Times the ideal, above which the axis is logarithmic."""
FAINTEST = 1e-2
"""Of the ideal: lower end of a logarithmic axis."""
ROOM, LOG_ROOM = 1.1, 2.0
NO_LIMIT = 0.8
"""Fraction of the upper end of the axis for words on an end with unbounded pressure."""
ALIKE = 0.05
"""Relative difference of lives below which only one body is drawn."""
HIGH, HIGH_OF_TWO = 260, 200


def life_densities(
    spectrum: Spectrum,
    lives: Mapping[BodyName, Sequence[Life]],
    compared: Mapping[BodyName, Sequence[Life]] | None = None,
) -> Figure:
    """Return the figure of `nonhertz.plot.life_figure`: a panel per body, or only b if their lives are within 5 %.

    Parameters
    ----------
    spectrum : sequence of pairs
        Solutions and their shares of the revolutions.
    lives : mapping of str to sequence of Life
        One life per model for each body that is to be shown.
    compared : mapping of str to sequence of Life, optional
        Lives of another case, of which the first is drawn.
    """
    other = {body: several[:1] for body, several in (compared or {}).items()}
    alone = len(lives) == len(BODIES) and _alike(lives, other)
    drawn = {body: (lives[body], other.get(body, ())) for body in (BODIES[1:] if alone else lives)}
    span = _range(life for several, others in drawn.values() for life in (*several, *others))
    height = (HIGH, HIGH_OF_TWO)[len(drawn) - 1]
    panels = [_panel(body, *several, span, spectrum, height) for body, several in drawn.items()]
    panels[0] = replace(panels[0], remark=_remark(lives, alone))
    lows, highs = np.transpose([axial_range(solution) for solution, _ in spectrum])
    along = Axis("Axial position y", "y", "mm", range=(float(lows.min()), float(highs.max())))
    caption = "Fatigue along the contact: damage per length over its mean under the ideal pressure."
    return Figure(along, panels, _solutions_of(spectrum), caption)


def _range(lives: Iterable[Life]) -> Range:
    """Return the range of the damage: logarithmic down to `FAINTEST` if it is peaked, else from zero."""
    finite = np.concatenate([life.density[np.isfinite(life.density)] for life in lives])
    highest = max(1.0, float(finite.max(initial=0.0)))
    return (FAINTEST, LOG_ROOM * highest) if highest > PEAKED else (0.0, ROOM * highest)


def _panel(
    body: BodyName, lives: Sequence[Life], others: Sequence[Life], span: Range, spectrum: Spectrum, height: int
) -> Panel:
    lines = [*map(_line, lives), *(_line(life, other=True) for life in others)]
    peaked = span[0] > 0.0
    axis = Axis(f"Damage over ideal, body {body}", "damage", range=span, logarithmic=peaked)
    marks = [Level(1.0, colour="faint"), *lines, *_around(spectrum, lives, span, peaked)]
    description = f"Damage per length along body {body}: {'; '.join(line.name for line in lines)}."
    return Panel(f"life-{body}", f"Damage of body {body}", axis, marks, description, height=height)


def _remark(lives: Mapping[BodyName, Sequence[Life]], alone: bool) -> str:
    """Return the definition of the damage, and how a single panel stands for both bodies."""
    remark = "damage per length over its mean under the ideal pressure"
    if not alone:
        return remark
    none = all(np.isnan(life.relative_life) for life in lives["b"])
    return remark + ("; of both bodies" if none else f"; lives of body a are within {100.0 * ALIKE:g} %")


def _line(life: Life, *, other: bool = False) -> Line:
    """Return the damage by a model, laminae as steps; that of another case as a grey line."""
    colour, dash = ("faint", "solid") if other else LOOKS[life.model.name]
    y, density = life.y, np.where(np.isfinite(life.density), life.density, np.nan)
    if life.model.name == "iso-16281" and not other:
        edges = 0.5 * (y[1:] + y[:-1])
        ends = 2.0 * y[[0, -1]] - edges[[0, -1]]
        y, density = np.repeat(np.concatenate([ends[:1], edges, ends[1:]]), 2)[1:-1], np.repeat(density, 2)
    words = f"life {format_input(life.relative_life, 3)}" if np.isfinite(life.relative_life) else "no damage"
    words = "no ideal life" if np.isnan(life.relative_life) and np.isnan(life.reference) else words
    name = f"{life.model.name}{', other case' * other}: {words}"
    return Line(y, density, name=name, colour=colour, dash=dash)  # type: ignore[arg-type]


def _around(spectrum: Spectrum, lives: Sequence[Life], span: tuple[float, float], peaked: bool) -> Iterator[Mark]:
    """Yield the ends of the bodies, and words if there is no ideal pressure or the pressure is unbounded."""
    widest = max((solution for solution, _ in spectrum), key=lambda solution: float(np.ptp(axial_range(solution))))
    for end, name in ends_in_sight(widest).items():
        yield Across(end, name, colour="faint", dash="ends")
    low, high = span
    if any(np.isnan(life.reference) for life in lives):
        words = "The bodies can touch over an unlimited length:\nthere is no ideal pressure for comparison."
        yield Words(0.5 * sum(axial_range(widest)), float(np.sqrt(low * high)) if peaked else 0.5 * high, words)
        return
    at = high * (low / high) ** (1.0 - NO_LIMIT) if peaked else NO_LIMIT * high
    yield from no_limits([solution for solution, _ in spectrum], at)


def _alike(*cases: Mapping[BodyName, Sequence[Life]]) -> bool:
    """Return whether both bodies last equally long by all models, in every case that has lives."""
    pairs = ([[life.relative_life for life in lives.get(body, ())] for body in BODIES] for lives in cases if lives)
    return all(np.allclose(a, b, rtol=ALIKE, atol=0.0, equal_nan=True) for a, b in pairs)


def _solutions_of(spectrum: Spectrum) -> str:
    """Return what was solved."""
    if len(spectrum) == 1:
        return conditions(spectrum[0][0])
    loads, tilts = ([getattr(solution, name) for solution, _ in spectrum] for name in ("load", "tilt"))
    return f"Spectrum of {len(loads)} loads, {_span(newton, loads)}, tilt {_span(mrad, tilts)}"


def _span(kind: Callable[..., Amount], values: Sequence[float]) -> str:
    ends = kind(min(values), max(values), between=" to ")
    factor, _ = ends.scale
    same = format_input(factor * ends.values[0], 4) == format_input(factor * ends.values[1], 4)
    return f"{kind(max(values)) if same else ends:.4g}"
