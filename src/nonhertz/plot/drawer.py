"""Any figure that is a value, drawn with matplotlib: on axes that there are, or on a sheet of its own."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Mapping, Sequence
from itertools import chain, zip_longest
from operator import attrgetter
from typing import TYPE_CHECKING, Any, Final

from nonhertz.figures.value import (
    Across,
    Area,
    Axis,
    Figure,
    Line,
    Panel,
    Points,
)
from nonhertz.plot import style
from nonhertz.plot.axes import ROUND, Axes, key_above
from nonhertz.plot.axes import Figure as Sheet
from nonhertz.plot.axial import LETTER, number, write_above
from nonhertz.plot.contours import label_contours
from nonhertz.plot.marks import Pen, colour_scale, draw_mark, typeset
from nonhertz.plot.round import round_sheet
from nonhertz.plot.sheets import (
    BAR_ROOM,
    HIGHEST_PANEL,
    LEFT,
    LINE,
    MARGIN,
    NUMBERS,
    WIDTH,
    bar_beside,
    sheet,
    stack_panels,
    stretch_of,
)
from nonhertz.plot.style import COLOURS

if TYPE_CHECKING:
    from matplotlib.axis import XAxis, YAxis

LOWEST: Final = 0.5  # inch, of a panel in true proportions
HEADS: Final = 0.24, 0.6  # inch, above such a panel and the stretched one below it
TITLE_ABOVE, ROW_OF_KEY, SAMPLE = 7.0, 11.5, 7  # points above a legend, and of a row of it; letters that a sample takes
DOTS: Final = 100.0  # of a screen, in an inch
HEAD: Final = 0.36  # inch, above each panel, for its legend
EDGE, AROUND = 0.1, 0.75  # inch: to the left of a title over rows of panels, and for what is around the panels of a row
LINEAR_PART: Final = 0.9  # decades, that each half of the linear part of an axis takes
TICKS = 10  # at most, of a panel that is as wide as the page
WITHIN_DECADES: Final = {1e2: (1.0, 2.0, 5.0), 1e3: (1.0, 3.0)}  # numbers at an axis whose ends have that ratio at most
FLAT: Final = 150  # pixel, below which a panel has room for half as many ticks
LETTERS: Final = 96  # of the conditions, that fit in a line
APART: Final = 1.7  # by which a second panel on the same axes is drawn lower


def sheet_of(figure: Figure, title: str = "") -> Sheet:
    """Return a sheet with the panels of a figure, round ones side by side, all others one below the other."""
    sheet = _make_sheet(figure, title)
    NUMBERS[sheet] = figure
    return sheet


def sheets_of(figures: Mapping[str, Figure], title: str = "") -> dict[str, Sheet]:
    """Return sheets of figures by their names, in the style of the sheets."""
    with style.sheet_style():
        return {name: sheet_of(figure, title) for name, figure in figures.items()}


def _make_sheet(figure: Figure, title: str) -> Sheet:
    first = figure.panels[0]
    if first.round:
        return round_sheet(figure, title, _lines(figure.conditions))
    if any(panel.beside or panel.along for panel in figure.panels):
        return _sheet_of_rows(figure, title)
    if first.proportional:
        return _proportional_sheet(figure, title)
    return _stack_sheet(figure, title)


def _stack_sheet(figure: Figure, title: str) -> Sheet:
    """Return a sheet of panels one below the other, those of colours with one bar beside them."""
    first, keys = figure.panels[0], _keys(figure.panels)
    heights = [panel.height / DOTS for panel in figure.panels]
    if first.colours:
        sheet, axes = stack_panels([HEAD] * len(heights), heights, title, _lines(figure.conditions), right=BAR_ROOM)
        draw_colour_bar(first, axes[-1], cax=bar_beside(*axes, most=2.0 * heights[0] + HEAD))
    else:
        words = "; ".join(filter(None, [figure.conditions, *(panel.remark for panel in figure.panels)]))
        rows = [max(_rows_of_key(key, WIDTH - LEFT - MARGIN), 1) for key in keys]
        sheet, axes = stack_panels(
            [HEAD + ROW_OF_KEY / 72.0 * (row - 1) for row in rows], heights, title, _lines(words)
        )
    for ax, panel in zip(axes, figure.panels, strict=True):
        draw_panel(panel, figure, ax, last=ax is axes[-1])
        if panel.colours:
            entitle(panel, ax)
    for place, key in enumerate(keys):
        draw_key(key, *axes[place:])
    return sheet


def entitle(panel: Panel, ax: Axes) -> None:
    """Write the heading of a panel to the left and its remark to the right above it."""
    ax.set_title(panel.heading, loc="left", fontsize=style.SMALL_SIZE, pad=3.0)
    ax.set_title(typeset(panel.remark), loc="right", fontsize=style.SMALL_SIZE, pad=3.0)


def _lines(words: str) -> list[str]:
    """Return parts of words in lines that are not too long, none of which begins within a part."""
    parts = [part for part in typeset(words).split("; ") if part]
    lines = parts[:1]
    for part in parts[1:]:
        joined = f"{lines[-1]}; {part}"
        lines[-1:] = [joined] if len(joined) <= LETTERS else [lines[-1], part]
    return lines


def _rows(panels: Sequence[Panel]) -> list[list[Panel]]:
    """Return panels by rows: a panel beside another is in its row."""
    rows: list[list[Panel]] = []
    for panel in panels:
        if panel.beside:
            rows[-1].append(panel)
        else:
            rows.append([panel])
    return rows


def _sheet_of_rows(figure: Figure, title: str) -> Sheet:
    """Return a sheet of rows of panels beside each other; what is around them decides how large they are."""
    from matplotlib.layout_engine import ConstrainedLayoutEngine

    rows = _rows(figure.panels)
    heights = [max(map(attrgetter("height"), row)) / DOTS for row in rows]
    keys = dict(zip(figure.panels, _keys(figure.panels), strict=True))
    lines = [max(_rows_of_key(keys[panel], (WIDTH - AROUND) / len(row)) for panel in row) for row in rows]
    further = sum(max(_wrap(panel.remark, WIDTH / len(row) - AROUND).count("\n") for panel in row) for row in rows)
    height = sum(heights) + AROUND * len(rows) + ROW_OF_KEY / 72.0 * sum(lines) + LINE * further
    drawn = sheet(height, title, _lines(figure.conditions), EDGE)
    layout = ConstrainedLayoutEngine(rect=(0.0, 0.0, 1.0, height / drawn.get_figheight()))
    drawn.set_layout_engine(layout)
    several = _draw_rows(rows, heights, figure, drawn)
    # Legends and headings fit into the width that is left to the panels.
    layout.execute(drawn)
    for place, (panel, key) in enumerate(keys.items()):
        _frame(panel, figure, key, *several[place:])
    return drawn


def _draw_rows(rows: Sequence[Sequence[Panel]], heights: Sequence[float], figure: Figure, drawn: Sheet) -> list[Axes]:
    """Draw rows of panels on a sheet, and return their axes."""
    columns = math.lcm(*map(len, rows))
    grid = drawn.add_gridspec(len(rows), columns, height_ratios=heights)
    several: list[Axes] = []
    for place, row in enumerate(rows):
        width = columns // len(row)
        # An axis along is labelled where the row below has another.
        last = row is rows[-1] or rows[place + 1][0].along is not row[0].along
        for column, panel in enumerate(row):
            several.append(drawn.add_subplot(grid[place, width * column : width * (column + 1)]))
            draw_panel(panel, figure, several[-1], last=last, most=TICKS // (2 if panel.height < FLAT else len(row)))
            if column and panel.upright.title() == row[0].upright.title():
                several[-1].set_ylabel("")
    return several


def _wrap(remark: str, width: float) -> str:
    """Return a remark in lines that are at most so wide [inch]."""
    return textwrap.fill(remark, round(width / LETTER * style.SMALL_SIZE / style.SIZE))


def draw_framed(panel: Panel, figure: Figure, ax: Axes, *, most: int | None = None) -> Axes:
    """Draw a panel with all that belongs to it around it: heading, legend, remark below and colour bar beside."""
    draw_panel(panel, figure, ax, most=most)
    return _frame(panel, figure, [panel], ax)


def _frame(panel: Panel, figure: Figure, key: Sequence[Panel], *several: Axes) -> Axes:
    """Draw what is around a panel on the first axes; its legend is of these panels on all axes."""
    ax = several[0]
    # Ticks are laid out when the figure is drawn, by then perhaps under other settings.
    ax.tick_params(labelsize=style.SIZE)
    if panel.remark:
        ax.set_xlabel(f"{ax.get_xlabel()}\n{typeset(_wrap(panel.remark, ax.bbox.width / ax.figure.dpi))}")
    factor = (panel.along or figure.along).scale[0]
    above = [(factor * mark.x, mark.words) for mark in panel.marks if isinstance(mark, Across) and mark.above]
    rows = draw_key(key, *several) + write_above(above, ax, ROW_OF_KEY)
    if panel.heading:
        ax.set_title(typeset(panel.heading), loc="left", pad=TITLE_ABOVE + ROW_OF_KEY * rows)
    if panel.colours:
        draw_colour_bar(panel, ax, ax=ax)
    return ax


def _proportional_sheet(figure: Figure, title: str) -> Sheet:
    """Return a sheet with a panel in true proportions, or stretched where that would be a thin band.

    A roller's contact may be 50 times as long as wide; a thin area is drawn both ways. The panels' shapes are computed
    here, so that the axes' limits need not be widened to fit them.
    """
    (panel,) = figure.panels
    assert panel.upright.range is not None
    assert figure.along.range is not None
    tall, wide = (abs(high - low) for low, high in (panel.upright.range, figure.along.range))
    width = WIDTH - LEFT - BAR_ROOM
    # Narrower rather than squeezed, down to half of the width.
    width *= min(max(HIGHEST_PANEL * wide / (width * tall), 0.5), 1.0)
    natural = width * tall / wide
    stretch = stretch_of(natural)
    heights = {stretch: stretch * natural}
    area = any(isinstance(mark, Area) for mark in panel.marks)
    if area and stretch >= 2.0:
        heights = {1.0: max(natural, LOWEST)} | heights
    rows = _rows_of_key([panel], width)
    heads = HEADS[: len(heights)] if area else [(TITLE_ABOVE + ROW_OF_KEY * (rows + 1.5)) / 72.0]
    right = WIDTH - LEFT - width
    sheet, several = stack_panels(heads, [*heights.values()], title, _lines(figure.conditions), right=right)
    for ax, times in zip(several, heights, strict=True):
        draw_panel(panel, figure, ax, last=ax is several[-1], stretch=times)
        draw_key([panel], ax)
        words = proportions(panel, times, "" if area else panel.heading)
        ax.set_title(words, loc="left", fontsize=style.SMALL_SIZE, pad=TITLE_ABOVE + ROW_OF_KEY * rows)
    draw_colour_bar(panel, several[-1], cax=bar_beside(several[-1]))
    return sheet


def draw_on(figure: Figure, ax: Axes) -> Axes:
    """Draw the first panel of a figure on axes, and a second one on a twin of these with its axis to the right."""
    first, *more = figure.panels
    draw_panel(first, figure, ax)
    several = [ax]
    for panel in more:
        twin = ax.twinx()
        draw_panel(panel, figure, twin)
        # In a line contact both curves have the same shape.
        twin.set_ylim(0.0, APART * twin.get_ylim()[1])
        twin.spines[["right"]].set_visible(True)
        for axes, of in ((ax, first), (twin, panel)):
            axes.yaxis.label.set_color(COLOURS[next(mark.colour for mark in of.marks if isinstance(mark, Line))])
        several.append(twin)
    rows = draw_key(figure.panels, *several)
    words = typeset(figure.conditions)
    ax.set_title(f"{words}; {first.remark}" if first.remark else words, loc="left", pad=TITLE_ABOVE + ROW_OF_KEY * rows)
    return ax


def draw_proportional(figure: Figure, ax: Axes, *, stretch: float = 1.0, bar: Axes | None = None) -> Axes:
    """Draw the only panel of a figure on axes, which are made smaller to fit its shape, with its colour bar."""
    (panel,) = figure.panels
    draw_panel(panel, figure, ax, stretch=stretch)
    rows = draw_key([panel], ax)
    words = f"{typeset(figure.conditions)}; {proportions(panel, stretch, panel.heading[0].lower() + panel.heading[1:])}"
    ax.set_title(words, loc="left", pad=TITLE_ABOVE + ROW_OF_KEY * rows)
    draw_colour_bar(panel, ax, **({"ax": ax} if bar is None else {"cax": bar}))
    return ax


def draw_panel(
    panel: Panel, figure: Figure, ax: Axes, *, last: bool = True, stretch: float = 1.0, most: int | None = None
) -> None:
    """Draw a panel of a figure on axes, with at most so many ticks; ``stretch`` is that of a proportional panel."""
    along, upright = panel.along or figure.along, panel.upright
    pen = Pen(ax, along.scale[0], upright.scale[0], along.range, panel)
    for mark in panel.marks:
        draw_mark(mark, pen)
    across, up = (upright, along) if panel.sideways else (along, upright)
    ax.set_xlabel(across.title() * last)
    ax.set_ylabel(up.title())
    _limit_ticks(panel, most, ax)
    auto = panel.proportional or None
    _set_axis(across, "x", ax, auto=auto)
    _set_axis(up, "y", ax, auto=auto)
    if panel.proportional:
        # The limits of an area are widened; all else fills its axes.
        area = any(isinstance(mark, Area) for mark in panel.marks)
        ax.set_aspect(stretch, adjustable="datalim" if area else "box")
    for mark, lines in pen.contours:
        label_contours(lines, mark, pen.along(mark.x), pen.upright(mark.y), panel, ax)
    ax.tick_params(labelbottom=last or panel.proportional)
    ax.spines[["top", "right"]].set_visible(panel.colours is not None)


def _limit_ticks(panel: Panel, most: int | None, ax: Axes) -> None:
    options: dict[str, Any] = {"steps": ROUND} | ({"nbins": most} if most else {})
    ax.locator_params("both" if panel.colours or most else "x", **options)


def _set_axis(axis: Axis, letter: str, ax: Axes, *, auto: bool | None) -> None:
    """Set the scale, the limits and the ticks of the x or the y axis."""
    factor, words = axis.scale[0], axis.categories
    drawn: XAxis | YAxis = getattr(ax, f"{letter}axis")
    if axis.logarithmic:
        ax.set(**{f"{letter}scale": "log"})
        _tick_decades(axis, drawn)
    if axis.linear:
        getattr(ax, f"set_{letter}scale")("symlog", linthresh=factor * axis.linear, linscale=LINEAR_PART)
        drawn.set_major_formatter(lambda value, _: number(value))
    if words:
        ends = -0.5, len(words) - 0.5
        ax.set(**{f"{letter}ticks": range(len(words)), f"{letter}ticklabels": words})
        ax.set(**{f"{letter}lim": ends if letter == "x" else ends[::-1]})
    elif axis.range is not None:
        # Automatic limits stay on where matplotlib is to widen them, or it would warn that it does.
        getattr(ax, f"set_{letter}lim")(*(factor * end for end in axis.range), auto=auto)
    if axis.ticks and letter == "x":
        ax.set_xticks(*zip(*((factor * place, words) for place, words in axis.ticks), strict=True))


def _tick_decades(axis: Axis, drawn: XAxis | YAxis) -> None:
    """Write numbers within decades, too, at a short logarithmic axis."""
    from matplotlib.ticker import LogLocator, NullFormatter

    ratio = axis.range[1] / axis.range[0] if axis.range else math.inf
    steps = next((steps for most, steps in WITHIN_DECADES.items() if ratio <= most), None)
    if steps is not None:
        drawn.set_major_locator(LogLocator(subs=steps))
        drawn.set_major_formatter(lambda value, _: number(value))
        drawn.set_minor_formatter(NullFormatter())


def proportions(panel: Panel, stretch: float, heading: str = "") -> str:
    """Return a heading with how a proportional panel is stretched, and what else is to be known of it."""
    symbol, times = (panel.upright.symbol, stretch) if stretch > 1.0 else ("y", 1.0 / stretch)
    true = "true proportions" if heading else "True proportions"
    words = [heading, true if stretch == 1.0 else f"{symbol} stretched {number(times)} times", panel.remark]
    return typeset("; ".join(part for part in words if part))


def draw_colour_bar(panel: Panel, ax: Axes, /, **where: Any) -> None:
    """Draw what the colours of a panel on axes stand for, with an arrow if there are values beyond."""
    from matplotlib.cm import ScalarMappable
    from matplotlib.contour import ContourSet

    colours = panel.colours
    assert colours is not None
    bands = next((drawn for drawn in ax.collections if isinstance(drawn, ContourSet) and drawn.filled), None)
    if bands is not None:
        ax.figure.colorbar(bands, label=colours.title(), **where)
        return
    bar = ScalarMappable(colour_scale(colours), style.COLOUR_MAP)
    ax.figure.colorbar(bar, label=colours.title(), extend="max" if colours.cut else "neither", **where)


def _keys(panels: Sequence[Panel]) -> list[Sequence[Panel]]:
    """Return the panels that each one's legend is of: all of them in the first if that has all names."""
    first, *others = [{mark.name for mark in panel.marks if mark.name} for panel in panels]
    if all(first >= names for names in others):
        return [panels, *[()] * len(others)]
    return [[panel] for panel in panels]


def draw_key(panels: Sequence[Panel], *several: Axes) -> int:
    """Write the legend of panels, drawn on these axes, above the first of them; return its rows."""
    from matplotlib.lines import Line2D

    ax, drawn = several[0], _samples(panels, several)
    # Beside bars there is room above the names, too.
    sideways = bool(panels) and panels[0].sideways
    room = (ax.get_tightbbox() if sideways else None) or ax.bbox
    columns = _columns_of_key(panels, room.width / ax.figure.dpi)
    rows = max(map(len, columns), default=0)
    if not rows:
        return 0
    # A legend is filled column by column: blanks make all equally long.
    words = [*chain.from_iterable(zip(*zip_longest(*columns, fillvalue=""), strict=True))]
    samples = [drawn.get(entry) or Line2D([], [], linestyle="none") for entry in words]
    narrow = {"borderaxespad": 0.4, "handlelength": 1.8, "handletextpad": 0.5, "columnspacing": 1.4}
    key = panels[0].key
    title = {"title": key, "title_fontsize": style.SMALL_SIZE, "alignment": "left"} if key else {}
    title |= {"loc": "lower right", "bbox_to_anchor": (1.0, 1.0)} if sideways else {}
    key_above(ax, samples, words, columns=len(columns), **title, **({"handlelength": 2.2} if rows == 1 else narrow))
    return rows + bool(key)


def _samples(panels: Sequence[Panel], several: Sequence[Axes]) -> dict[str, Any]:
    """Return by name what is drawn of panels on axes: lines and points of the same name one on the other."""
    drawn: dict[str, dict[Any, Any]] = {}
    for panel, ax in zip(panels, several, strict=False):
        artists = dict(zip(*reversed(ax.get_legend_handles_labels()), strict=True))
        for name, kind in ((typeset(mark.name), isinstance(mark, Points)) for mark in panel.marks if mark.name):
            if name in artists:
                drawn.setdefault(name, {}).setdefault(kind, artists[name])
    several_of = {name: tuple(kinds[kind] for kind in sorted(kinds)) for name, kinds in drawn.items()}
    return {name: artists if len(artists) > 1 else artists[0] for name, artists in several_of.items()}


def _columns_of_key(panels: Sequence[Panel], width: float) -> list[list[str]]:
    """Return the entries of a legend in as many columns as fit into a width [inch], or points beside all else."""
    points = {typeset(mark.name): isinstance(mark, Points) for panel in panels for mark in panel.marks if mark.name}
    entries = [*points]
    if _key_width(alone := _split(entries, 1)) <= width:
        return alone
    if len({*points.values()}) == 2:
        return [[words for words, point in points.items() if point is first] for first in (True, False)]
    splits = (_split(entries, rows) for rows in range(2, len(entries) + 1))
    return next((split for split in splits if _key_width(split) <= width), [entries])


def _split(entries: list[str], rows: int) -> list[list[str]]:
    return [entries[at : at + rows] for at in range(0, len(entries), rows)]


def _rows_of_key(panels: Sequence[Panel], width: float) -> int:
    """Return how many rows the legend of panels has in a width [inch]."""
    return max(map(len, _columns_of_key(panels, width)), default=0) + any(panel.key for panel in panels)


def _key_width(columns: Sequence[Sequence[str]]) -> float:
    """Return the width [inch] of a legend of columns."""
    return LETTER * sum(max(len(words) + SAMPLE for words in column) for column in columns)
