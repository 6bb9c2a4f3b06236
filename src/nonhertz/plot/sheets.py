"""Sheets for figures, laid out for the width of a page, and writing them to disk."""

from __future__ import annotations

import io
import math
import textwrap
import warnings
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Literal
from weakref import WeakKeyDictionary

from nonhertz.figures.value import Figure as Values
from nonhertz.plot.axes import Axes, Figure
from nonhertz.plot.style import SIZE, TITLE_SIZE, sheet_style

# All lengths in inches; the width is that of a journal page, 170 mm.
WIDTH = 6.7
LEFT, BOTTOM, MARGIN = 0.75, 0.55, 0.15
# Above: a line of the title, the first line of conditions and each further one; letters of a line as wide as the page.
TITLE, CONDITIONS, LINE, TITLE_LETTERS = 0.22, 0.24, 0.14, 80
HIGHEST_PANEL, HIGHEST_STRETCHED = 3.2, 1.9
BAR, BAR_GAP, BAR_ROOM = 0.11, 0.12, 0.95

STRETCHES = tuple(step * decade for decade in (1, 10, 100, 1000) for step in (1, 1.5, 2, 2.5, 3, 4, 5, 6, 8))

PNG_DPI = 220

NUMBERS: WeakKeyDictionary[Figure, Values] = WeakKeyDictionary()
"""What is drawn on a sheet."""


def stretch_of(natural: float) -> float:
    """Return by how much a panel of that height [inch] is drawn higher; less than 1 if it would be too high."""
    if natural > HIGHEST_PANEL:
        return 1.0 / min((step for step in STRETCHES if natural / step <= HIGHEST_PANEL), default=STRETCHES[-1])
    return max((step for step in STRETCHES if step * natural <= HIGHEST_STRETCHED), default=1.0)


def save(figure: Figure, stem: str | Path) -> tuple[Path, Path]:
    """Write a figure as ``stem``.svg and ``stem``.png and return both paths.

    The same figure gives the same SVG file every time: it contains no date and no random identifiers.

    Parameters
    ----------
    figure : matplotlib.figure.Figure
        One of `figures`, or any other.
    stem : str or Path
        Path of the files without extension; a full stop in it is kept.
    """
    stem = Path(stem)
    svg, png = (stem.with_name(stem.name + ending) for ending in (".svg", ".png"))
    with sheet_style():
        figure.savefig(svg, dpi=PNG_DPI, metadata={"Date": None})
        figure.savefig(png, dpi=PNG_DPI)
    return svg, png


def save_all(figures: Mapping[str, Figure], folder: Path) -> None:
    """Write figures into a folder under their names, as `save` does, and the numbers of their marks as ``name``.csv.

    A table of that name that is there already stays, as it has them.
    """
    for name, figure in figures.items():
        save(figure, folder / name)
        path = folder / f"{name}.csv"
        if not path.exists() and (values := NUMBERS.get(figure)):
            path.write_text(values.to_csv(), encoding="utf-8", newline="\n")


def image(figure: Figure, kind: Literal["svg", "png"], dots: int = PNG_DPI) -> bytes:
    """Return what `save` writes as one of its two files, with so many dots per inch."""
    written = io.BytesIO()
    with sheet_style(), warnings.catch_warnings():
        # A file's name may have letters that the font lacks; the number beside it identifies it anyway.
        warnings.filterwarnings("ignore", "Glyph .* missing")
        figure.savefig(written, format=kind, dpi=dots, metadata={"Date": None} if kind == "svg" else None)
    return written.getvalue()


def sheet(height: float, title: str = "", conditions: Sequence[str] = (), left: float = LEFT) -> Figure:
    """Return a sheet of page width with room of a height [inch], above which are a title and lines of conditions."""
    from matplotlib.figure import Figure

    titles = textwrap.wrap(title, round(TITLE_LETTERS * (WIDTH - left) / WIDTH))
    head = TITLE * len(titles) + (CONDITIONS + LINE * (len(conditions) - 1) if conditions else 0.0)
    whole = height + head
    figure = Figure(figsize=(WIDTH, whole))
    if titles:
        # User text: a dollar sign must not start mathtext.
        words = "\n".join(titles)
        place = left / WIDTH, (whole - 0.08) / whole
        figure.text(*place, words, va="top", weight="bold", fontsize=TITLE_SIZE, parse_math=False)
    if conditions:
        below = whole - 0.08 - TITLE * len(titles)
        figure.text(left / WIDTH, below / whole, "\n".join(conditions), va="top")
    return figure


def stack_panels(
    heads: Sequence[float],
    heights: Sequence[float],
    title: str = "",
    conditions: Sequence[str] = (),
    *,
    left: float = LEFT,
    right: float = MARGIN,
    bottom: float = BOTTOM,
) -> tuple[Figure, list[Axes]]:
    """Return a sheet of panels one below the other, all lengths in inches, and the panels.

    Above each is the room of its head, below all of them the bottom; title and conditions begin where the panels do.
    """
    at = sum(heads) + sum(heights) + bottom
    figure, panels = sheet(at, title, conditions, left), []
    for head, height in zip(heads, heights, strict=True):
        at -= head + height
        panels.append(panel(figure, left, at, WIDTH - left - right, height))
    return figure, panels


def bar_beside(*panels: Axes, most: float = math.inf) -> Axes:
    """Return axes for a colour bar beside panels, of their height, up to the most [inch]."""
    figure, boxes = panels[0].get_figure(root=True), [panel.get_position() for panel in panels]
    assert figure is not None
    low, high = min(box.y0 for box in boxes), max(box.y1 for box in boxes)
    height = min(high - low, most / figure.get_figheight())
    return figure.add_axes((boxes[0].x1 + BAR_GAP / WIDTH, 0.5 * (low + high - height), BAR / WIDTH, height))


def panel(figure: Figure, left: float, bottom: float, width: float, height: float, kind: str | None = None) -> Axes:
    """Return axes on a sheet, all lengths in inches."""
    whole = figure.get_figheight()
    axes = figure.add_axes((left / WIDTH, bottom / whole, width / WIDTH, height / whole), projection=kind)
    # Ticks are laid out when the figure is drawn, by then perhaps under other settings.
    axes.tick_params(labelsize=SIZE)
    return axes
