"""The axes of finished figures in the units in which people read results, with ticks that are round in these.

Everything is drawn in the program's own units. Ticks are chosen and written by what an axis already has for that, which
is given the numbers of the other unit; nothing that was drawn moves.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from nonhertz.amounts import Units, chosen

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.axis import Axis
    from matplotlib.figure import Figure

_IN_BRACKETS: Final = re.compile(r"\[([^\]]+)\]")
_APART: Final = 1e-3  # of the figure: axes that begin closer together are below or beside each other


def rewrite_units(figure: Figure) -> None:
    """Put the axes of a figure into the units chosen in this context; what is written in it is in them already."""
    units = chosen()
    if units.code == "si":
        return
    for axis, unit in list(_with_units(figure, units)):
        _rescale(axis, units.of(unit)[1])
        axis.set_label_text(axis.get_label_text().replace(f"[{unit}]", f"[{units.of(unit)[0]}]"))


def _with_units(figure: Figure, units: Units) -> Iterator[tuple[Axis, str]]:
    """Yield the axes whose unit changes: that in their label, or in that of the axes below or beside them."""
    for which in (0, 1):
        pairs = [(axes, (axes.xaxis, axes.yaxis)[which]) for axes in figure.axes if axes.name != "polar"]
        named = [(axes, _unit(axis)) for axes, axis in pairs if axis.get_label_text()]
        for axes, axis in pairs:
            unit = _unit(axis)
            if not axis.get_label_text() and axis.get_visible():
                beside = (unit for other, unit in named if unit and _aligned(axes, other, which))
                unit = next(beside, "")
            if units.of(unit)[1] != 1.0:
                yield axis, unit


def _unit(axis: Axis) -> str:
    found = _IN_BRACKETS.search(axis.get_label_text())
    return found[1] if found else ""


def _aligned(one: Axes, other: Axes, which: int) -> bool:
    """Return whether axes have the same place across: x axes from left to right, y axes from below."""
    ends = zip(one.get_position().get_points()[:, which], other.get_position().get_points()[:, which], strict=True)
    return all(abs(here - there) < _APART for here, there in ends)


def _rescale(axis: Axis, factor: float) -> None:
    """Have the ticks of an axis chosen and written in another unit, of which ``factor`` make one of its own."""
    from matplotlib.ticker import FixedLocator, Formatter, Locator

    class Scaled:
        """An axis as it is in the other unit."""

        def __getattr__(self, name: str) -> Any:
            return getattr(axis, name)

        def get_view_interval(self) -> Any:
            return factor * np.asarray(axis.get_view_interval())

        def get_data_interval(self) -> Any:
            return factor * np.asarray(axis.get_data_interval())

    class Places(Locator):
        def __init__(self, own: Locator) -> None:
            self.own = own
            own.axis = Scaled()  # type: ignore[assignment]

        def __call__(self) -> Any:
            return self.tick_values(*axis.get_view_interval())

        def tick_values(self, vmin: float, vmax: float) -> Any:
            return np.asarray(self.own.tick_values(factor * vmin, factor * vmax)) / factor

    class Numbers(Formatter):
        def __init__(self, own: Formatter) -> None:
            self.own = own
            own.axis = Scaled()  # type: ignore[assignment]

        def __call__(self, x: float, pos: int | None = None) -> str:
            return self.own(factor * x, pos)

        def format_ticks(self, values: Sequence[float]) -> list[str]:
            return self.own.format_ticks([factor * value for value in values])

        def set_locs(self, locs: Any) -> None:
            self.own.set_locs([factor * each for each in locs])

        def get_offset(self) -> str:
            return self.own.get_offset()

    locator, formatter = axis.get_major_locator(), axis.get_major_formatter()
    if not isinstance(locator, FixedLocator):  # else of places that are round already
        axis.set_major_locator(Places(locator))
    axis.set_major_formatter(Numbers(formatter))
