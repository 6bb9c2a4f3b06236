"""What all axes share: the unit in which their numbers are drawn, their frame, and the key above them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.amounts import amount
from nonhertz.plot.style import SMALL_SIZE

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

ROUND = (1, 2, 5, 10)
"""What the steps between ticks are, times a power of ten."""


class Measure(NamedTuple):
    """How numbers of one unit are drawn: times a factor, on an axis that is labelled with the unit that people read.

    Examples
    --------
    >>> from nonhertz.amounts import read_in
    >>> measure("mm", "um").label("Relief"), measure("N", values=[20000.0])([20000.0]).tolist()
    ('Relief [µm]', [20.0])
    >>> with read_in("us"):
    ...     measure("mm").label("Axial position")
    'Axial position [in]'
    """

    factor: float
    unit: str

    def __call__(self, values: ArrayLike) -> NDArray[np.float64]:
        """Return numbers as they are drawn."""
        return self.factor * np.asarray(values, dtype=float)

    def label(self, words: str) -> str:
        """Return the label of an axis."""
        return f"{words} [{self.unit}]" if self.unit else words


def measure(unit: str, read: str = "", values: Iterable[float] = ()) -> Measure:
    """Return how numbers in a unit of the program are drawn, that people read in another, or in one that suits some."""
    return Measure(*amount(values, unit, read).scale)


def open_frame(*several: Axes) -> None:
    """Leave out the lines above and to the right."""
    for axes in several:
        axes.spines[["top", "right"]].set_visible(False)


def along(ax: Axes, span: tuple[float, float], *, labelled: bool = True, labelpad: float | None = None) -> None:
    """Set the axis along a contact to a range of y [mm]."""
    drawn = measure("mm")
    ax.locator_params(axis="x", steps=ROUND)
    ax.set_xlim(*drawn(span))
    if labelled:
        ax.set_xlabel(drawn.label("Axial position $y$"), labelpad=labelpad)


def key_above(
    ax: Axes,
    handles: Sequence[Artist] | None = None,
    labels: Sequence[str] | None = None,
    *,
    columns: int,
    **options: Any,
) -> None:
    """Put the legend above the axes, where it cannot cover a curve: of these artists, else of those with a label."""
    given: dict[str, Any] = {"handles": handles, "labels": labels} if handles is not None else {}
    usual: dict[str, Any] = {"borderaxespad": 0.2, "borderpad": 0.2, "handlelength": 2.4, "columnspacing": 1.6}
    place: dict[str, Any] = {"loc": "lower left", "bbox_to_anchor": (0.0, 1.0), "ncols": columns}
    ax.legend(**given, **place, frameon=False, fontsize=SMALL_SIZE, **usual | options)
