"""A figure as a value: panels of marks, in units of the program, that matplotlib and the page draw alike.

A result has one function for each of its figures. Drawing depends on lines, bands, points and words only, not on
contacts; for readers who cannot see a figure, there are a table of its numbers and a description in words.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import MISSING, dataclass, field, fields
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import amount
from nonhertz.result.tables import csv_text, heading

Array = NDArray[np.float64]
Colour = Literal["first", "second", "third", "fourth", "fifth", "ink", "faint", "paper"]
Dash = Literal["solid", "dashed", "chain", "dotted", "long", "mixed", "ends", "none"]
Side = Literal["left", "center", "right"]
Symbol = Literal["circle", "diamond", "triangle", "cross", "dot"]
Range = tuple[float, float]

SERIES: tuple[tuple[Colour, Dash], ...] = (
    ("first", "solid"), ("second", "dashed"), ("third", "chain"), ("fourth", "dotted"), ("ink", "long"),
    ("fifth", "mixed"),
)  # fmt: skip
"""Looks of several lines; each has its own dashes, for printing in grey."""


@dataclass(frozen=True, eq=False, kw_only=True)
class Mark:
    """An element of a drawing; places and values are in the units of the axes.

    Attributes
    ----------
    name : str
        Entry in the legend; none if empty.
    colour : {"first", "second", "third", "fourth", "fifth", "ink", "faint", "paper"}
        Five colours for any colour vision, that of text, of thin lines, or of the background, for fine lines.
    dash : {"solid", "dashed", "chain", "dotted", "long", "mixed", "ends", "none"}
        ``"ends"`` is the dash-dot line of engineering drawings; with ``"none"`` only points are drawn.
    """

    name: str = ""
    colour: Colour = "first"
    dash: Dash = "solid"

    @property
    def numbers(self) -> tuple[Array, ...]:
        """Its columns in a table, equally long: places along, upright values, values of colours; may be empty."""
        return ()


@dataclass(frozen=True, eq=False)
class Line(Mark):
    """A line through points, shape (n,) each, which may be marked; interrupted at nan. A thin one shows more detail."""

    x: Array
    y: Array
    marked: bool = False
    thin: bool = False

    @property
    def numbers(self) -> tuple[Array, ...]:
        """Its points."""
        return self.x, self.y


@dataclass(frozen=True, eq=False)
class Steps(Mark):
    """Pale steps from zero up to values, shape (n,), between edges, shape (n + 1,)."""

    edges: Array
    y: Array


@dataclass(frozen=True, eq=False)
class Band(Mark):
    """The pale area between two lines, shape (n,) each; interrupted at nan."""

    x: Array
    low: Array
    high: Array


@dataclass(frozen=True, eq=False)
class Area(Mark):
    """An outlined area from a line, shape (n,), to its mirror image below zero, coloured by values.

    The values, shape (n,), are those in its middle; across they fall to its edge as a power of 1 - (y / half_height)^2.
    """

    x: Array
    half_height: Array
    values: Array
    power: float

    @property
    def numbers(self) -> tuple[Array, ...]:
        """Its outline, of which the mirror image is left out, and the values in its middle."""
        return self.x, self.half_height, self.values


@dataclass(frozen=True, eq=False)
class Cells(Mark):
    """Coloured cells of values, shape (m, n), between edges, shapes (m + 1,) and (n + 1,); blank at nan."""

    x: Array
    y: Array
    values: Array

    @property
    def numbers(self) -> tuple[Array, ...]:
        """The middles of all cells."""
        x, y = (0.5 * (edges[1:] + edges[:-1]) for edges in (self.x, self.y))
        return _list_grid(x, y, self.values)


@dataclass(frozen=True, eq=False)
class Contours(Mark):
    """Bands between lines of equal values, shape (m, n), at m places along and n upright; blank at nan."""

    x: Array
    y: Array
    values: Array

    @property
    def numbers(self) -> tuple[Array, ...]:
        """All places."""
        return _list_grid(self.x, self.y, self.values)


@dataclass(frozen=True, eq=False)
class Points(Mark):
    """Points, shape (n,) each, with a symbol."""

    x: Array
    y: Array
    symbol: Symbol = "circle"

    @property
    def numbers(self) -> tuple[Array, ...]:
        """The points, if the legend has them; others mark places on lines."""
        return (self.x, self.y) if self.name else ()


@dataclass(frozen=True, eq=False)
class Span(Mark):
    """A pale background from one place along to another."""

    low: float
    high: float


@dataclass(frozen=True, eq=False)
class Across(Mark):
    """A thin line at a place along, from bottom to top, with words beside it, or above the panel."""

    x: float
    words: str = ""
    above: bool = False


@dataclass(frozen=True, eq=False)
class Level(Mark):
    """A thin line at a value, from side to side."""

    y: float


@dataclass(frozen=True, eq=False)
class Bar(Mark):
    """A thick line at a value, from one place along to another."""

    low: float
    high: float
    y: float


@dataclass(frozen=True, eq=False)
class Dimension(Mark):
    """A dimension line at a value, with arrows at its ends and words over its middle."""

    low: float
    high: float
    y: float
    words: str = ""


@dataclass(frozen=True, eq=False)
class Bars(Mark):
    """Bars from zero up to values, shape (n,), around or beside places, shape (n,); hatched or pale if not solid.

    Their width is one number, or shape (n,).
    """

    x: Array
    y: Array
    width: float | Array
    aside: float = 0.0

    @property
    def numbers(self) -> tuple[Array, ...]:
        """The ends of the bars."""
        return self.x, self.y


@dataclass(frozen=True, eq=False)
class Whiskers(Mark):
    """Thin lines with caps from lower to higher values, shape (n,), beside places, shape (n,)."""

    x: Array
    low: Array
    high: Array
    aside: float = 0.0

    @property
    def numbers(self) -> tuple[Array, ...]:
        """All lower ends, then all higher ones."""
        return np.tile(self.x, 2), np.concatenate([self.low, self.high])


@dataclass(frozen=True, eq=False)
class Arrow(Mark):
    """An arrow through the middle of a round panel towards a place along, with words; these alone at nan."""

    x: float
    words: str


@dataclass(frozen=True, eq=False)
class Words(Mark):
    """Words above a point; they begin there if their side is ``"left"``, and end there if it is ``"right"``.

    Clear ones stand above all lines of the panel that they would cross.
    """

    x: float
    y: float
    words: str
    side: Side = "center"
    clear: bool = field(default=False, kw_only=True)
    colour: Colour = field(default="ink", kw_only=True)


@dataclass(frozen=True, eq=False)
class Axis:
    """The quantity of an axis, and its range.

    Attributes
    ----------
    label : str
        Words, without the unit.
    symbol : str
        Symbol before numbers that are read from the drawing.
    unit : str
        Unit of the numbers, that of the program.
    read : str
        The unit in which they are shown by default; that of the numbers if empty.
    range : tuple of float, optional
        The range that is drawn; automatic if left out.
    cut : bool
        Whether values beyond the range are cut off.
    ticks : tuple of (float, str)
        Places with their words; automatic if left out.
    logarithmic : bool
        Whether equal lengths are equal ratios.
    linear : float
        Value up to which an axis is linear on both sides of zero, and logarithmic beyond; zero for an ordinary axis.
    categories : tuple of str
        Words in place of the numbers 0, 1, 2 and so on.
    """

    label: str
    symbol: str = ""
    unit: str = ""
    read: str = ""
    range: Range | None = None
    cut: bool = False
    ticks: tuple[tuple[float, str], ...] = ()
    logarithmic: bool = False
    linear: float = 0.0
    categories: tuple[str, ...] = ()

    @property
    def scale(self) -> tuple[float, str]:
        """The factor to the numbers that are shown, and their unit."""
        return amount(self.range or (), self.unit, self.read).scale

    def title(self) -> str:
        """Return the label with the unit that is shown.

        Examples
        --------
        >>> Axis("Relief", unit="mm", read="um").title(), Axis("Share").title()
        ('Relief [µm]', 'Share')
        """
        unit = "" if self.ticks else self.scale[1]
        return f"{self.label} [{unit}]" if unit else self.label


@dataclass(frozen=True, eq=False)
class Panel:
    """Marks over an axis along, which a figure's panels share if they have none of their own, and an upright one.

    Attributes
    ----------
    name : str
        Identifier of the panel.
    heading : str
        Title of the panel.
    upright : Axis
        The vertical axis.
    marks : sequence of Mark
        From the back to the front.
    description : str
        Its contents in words, for readers who cannot see it.
    remark : str
        A note on the drawing, such as that an axis is cut.
    height : int
        On a screen [pixel]; on paper in that proportion to the other panels. The least one of a proportional panel.
    colours : Axis, optional
        The quantity of colours, from zero, dark, to the end of its range, bright; cut if there are values beyond.
    proportional : bool
        Whether both axes have the same scale; if there is no room for it, the drawing says by how much one is
        stretched.
    round : bool
        Whether places along are angles [rad] around a circle, from the bottom counter-clockwise, and values rise from
        that circle outwards.
    along : Axis, optional
        An axis along of its own.
    key : str
        Heading of the legend.
    beside : bool
        Whether it stands to the right of the panel before, not below it.
    sideways : bool
        Whether places run down and values to the right, as names beside bars do.
    """

    name: str
    heading: str
    upright: Axis
    marks: Sequence[Mark]
    description: str
    remark: str = ""
    height: int = 240
    colours: Axis | None = None
    proportional: bool = False
    round: bool = False
    along: Axis | None = None
    key: str = ""
    beside: bool = False
    sideways: bool = False

    def rows(self, along: Axis, over: Sequence[str], *, coloured: bool) -> Iterator[list[Any]]:
        """Yield the rows of `Figure.to_csv`, in whose figure some panel is coloured or none."""
        for mark in self.marks:
            # Points on a circle mark rollers.
            if not (self.round and isinstance(mark, Points)):
                yield from self._rows_of(mark, along, over, coloured=coloured)

    def _rows_of(self, mark: Mark, along: Axis, over: Sequence[str], *, coloured: bool) -> Iterator[list[Any]]:
        flat = len(mark.numbers) == 2
        axis = self.colours if self.colours and not flat else self.upright
        unit = None if self.colours and flat else axis.unit
        for row in zip(*(values.tolist() for values in mark.numbers), strict=True):
            x, *rest = _plain(row)
            if flat and coloured:
                rest.insert(1 if self.colours else 0, None)
            place = along.categories[int(x)] if along.categories else x
            yield [self.name, mark.name or axis.symbol, *over, place, *rest, unit]


@dataclass(frozen=True, eq=False)
class Figure:
    """Panels one below the other, over one axis along.

    Attributes
    ----------
    along : Axis
        The horizontal axis.
    panels : sequence of Panel
        From the top.
    conditions : str
        Case or bearing and its load, in parts separated by semicolons.
    caption : str
        A sentence on the contents, to be placed below.
    """

    along: Axis
    panels: Sequence[Panel]
    conditions: str = ""
    caption: str = ""

    @property
    def description(self) -> str:
        """The contents of all panels in words, for readers who cannot see them."""
        return " ".join(panel.description for panel in self.panels)

    def to_csv(self) -> str:
        """Return the numbers of a figure as CSV, in units of the program: a row for each point of each mark.

        The columns are panel, name or symbol, place along, value and its unit. Where colours stand for values, the
        upright place comes before these: of cells their middles, of contours the points that they run between, of an
        area half its height beside the value in its middle; lines and points have no value there. Where panels have
        different axes along, a column "over" says of what the place is. What is not finite is an empty cell.
        """
        upright = next((panel.upright for panel in self.panels if panel.colours), None)
        several = [panel.along or self.along for panel in self.panels]
        heads = [heading(axis.symbol, axis.unit) for axis in several]
        same = len(set(heads)) == 1
        rows = (
            row
            for panel, along, head in zip(self.panels, several, heads, strict=True)
            for row in panel.rows(along, () if same else (head,), coloured=upright is not None)
        )
        places = [heads[0]] if same else ["over", "place"]
        places += [heading(upright.symbol, upright.unit)] if upright else []
        return csv_text(["panel", "line", *places, "value", "unit"], rows)

    def to_json(self) -> dict[str, Any]:
        """Return the figure for the page, as plain numbers; null for non-finite ones, defaults left out."""
        sent: dict[str, Any] = _plain(self)
        return sent


def _list_grid(x: Array, y: Array, values: Array) -> tuple[Array, ...]:
    """Return a grid of values as a list of both places and a value each."""
    along, upright = np.meshgrid(x, y, indexing="ij")
    return along.ravel(), upright.ravel(), values.ravel()


def _plain(value: Any) -> Any:
    if isinstance(value, np.ndarray):
        value = _short(value)
        # Entry by entry only where there is something to replace: a drag waits for it.
        return value.tolist() if np.isfinite(value).all() else [_plain(entry) for entry in value.tolist()]
    if isinstance(value, tuple | list):
        return [_plain(entry) for entry in value]
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    return _attributes(value) if isinstance(value, Figure | Panel | Axis | Mark) else value


def _attributes(value: Figure | Panel | Axis | Mark) -> dict[str, Any]:
    values = ((attribute, getattr(value, attribute.name)) for attribute in fields(value))
    shown = {
        attribute.name: _plain(content)
        for attribute, content in values
        if attribute.default is MISSING or content != attribute.default
    }
    if isinstance(value, Mark):
        shown["kind"] = type(value).__name__.lower()
    if isinstance(value, Axis):
        factor, unit = value.scale
        shown |= {"title": value.title(), "factor": factor, "unit": unit}
    return shown


def _short(values: Array) -> Array:
    """Return a table of numbers rounded to the fifth digit of the largest: more than colours show, and less to send."""
    largest = np.nanmax(np.abs(values), initial=0.0)
    if values.ndim < 2 or not 0.0 < largest < np.inf:
        return values
    step = 10.0 ** (np.floor(np.log10(largest)) - 4.0)
    rounded: Array = np.round(values / step) * step
    return rounded
