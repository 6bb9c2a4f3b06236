"""The common parts of all axes: a figure of their own, the unit of their numbers, frame, words and legend."""

from __future__ import annotations

import functools
import inspect
from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, ParamSpec, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.amounts import amount
from nonhertz.plot.style import SMALL_SIZE, sheet_style

# matplotlib is imported only when something is drawn.
if TYPE_CHECKING:
    from matplotlib import artist, axes, figure
    from matplotlib.legend import Legend

    Artist = artist.Artist
    Axes = axes.Axes
    Figure = figure.Figure
else:
    Artist = Axes = Figure = Any

Array = NDArray[np.float64]
P = ParamSpec("P")
T = TypeVar("T")
Alignment = Literal["left", "center", "right"]

#: Default of ``ax``: a drawing then makes a figure of its own.
OWN: Any = None
OWN_SIZE = 6.7, 3.7  # inch

ROUND = (1, 2, 5, 10)
"""The steps between ticks, times a power of ten."""


def drawing(draw: Callable[P, T], projection: str | None = None) -> Callable[P, T]:
    """Let a function that draws on ``ax`` do so in a figure of its own, in the style of the sheets, if it has none.

    That ``ax`` is optional, and returned, is the same for all, and said by `nonhertz.plot`; docstrings say what is
    particular.
    """
    signature = inspect.signature(draw)

    @functools.wraps(draw)
    def drawn(*args: P.args, **kwargs: P.kwargs) -> T:
        bound = signature.bind(*args, **kwargs)
        if bound.arguments.get("ax") is not None:
            return draw(*args, **kwargs)
        from matplotlib.figure import Figure

        with sheet_style():
            bound.arguments["ax"] = Figure(figsize=OWN_SIZE, layout="constrained").add_subplot(projection=projection)
            return draw(*bound.args, **bound.kwargs)

    return drawn


class Measure(NamedTuple):
    """The scale of numbers of one unit: a factor, and the unit with which the axis is labelled.

    Examples
    --------
    >>> from nonhertz.amounts import display_units
    >>> measure("mm", "um").label("Relief"), measure("N", values=[20000.0])([20000.0]).tolist()
    ('Relief [µm]', [20.0])
    >>> with display_units("us"):
    ...     measure("mm").label("Axial position")
    'Axial position [in]'
    """

    factor: float
    unit: str

    def __call__(self, values: ArrayLike) -> Array:
        """Return numbers as they are drawn."""
        return self.factor * np.asarray(values, dtype=float)

    def label(self, words: str) -> str:
        """Return the label of an axis."""
        return f"{words} [{self.unit}]" if self.unit else words


def measure(unit: str, read: str = "", values: Iterable[float] = ()) -> Measure:
    """Return the scale of numbers in a unit of the program, shown in ``read`` or in a unit that suits ``values``."""
    return Measure(*amount(values, unit, read).scale)


def key_above(
    ax: Axes,
    handles: Sequence[Artist] | None = None,
    labels: Sequence[str] | None = None,
    *,
    columns: int,
    **options: Any,
) -> Legend:
    """Put the legend above the axes, where it cannot cover a curve: of these artists, else of those with a label."""
    entries: dict[str, Any] = {"handles": handles, "labels": labels} if handles is not None else {}
    usual: dict[str, Any] = {"borderaxespad": 0.2, "borderpad": 0.2, "handlelength": 2.4, "columnspacing": 1.6}
    place: dict[str, Any] = {"loc": "lower left", "bbox_to_anchor": (0.0, 1.0), "ncols": columns}
    return ax.legend(**entries, frameon=False, fontsize=SMALL_SIZE, **place | usual | options)


def note(
    ax: Axes,
    words: str,
    at: tuple[float, float],
    side: Alignment,
    aside: float = 0.0,
    above: float = 0.0,
    *,
    across: bool = False,
    **style: Any,
) -> None:
    """Write small words at a point, or offset to their side and above it [points].

    Words with a ``side`` "left" begin there. The second number of a point is a share of the axes if it is ``across``.
    """
    offset = {"left": aside, "center": 0.0, "right": -aside}[side], above
    ax.annotate(
        words, at, xycoords=ax.get_xaxis_transform() if across else ax.transData, xytext=offset,
        textcoords="offset points", ha=side, fontsize=SMALL_SIZE, **style,
    )  # fmt: skip
