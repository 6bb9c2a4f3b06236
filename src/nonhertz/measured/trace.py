"""A measured line: positions, heights, and where nothing was measured."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.errors import InputError
from nonhertz.inputs.checks import check_list, numbers, text
from nonhertz.inputs.short_repr import ShortRepr

Array = NDArray[np.float64]

FEWEST_POINTS = 5
# In usual steps: in an evenly spaced line a longer step contains a hole; where the file marks a point as not measured,
# a step longer than one and a half does. A shorter step is as well measured as the rest of the line.
_HOLE, _DROPOUT = 2.5, 1.5
# A line is evenly spaced if many of its steps equal the usual one within a tenth, and few lie between that and a hole.
_EVEN, _UNEVEN, _TENTH = 0.25, 0.02, 0.1
FARTHEST = 1e6  # mm; no machine measures a kilometre
LONGEST = 1e3  # mm; few measure more than a metre, and a file in um taken for mm looks that long

_INNER = 0.9  # of a trace: the part without its corners


@dataclass(frozen=True, eq=False, repr=False)
class Points(ShortRepr):
    """Heights along a line, sorted by position.

    Parameters
    ----------
    y : array_like, shape (n,)
        Positions [mm], strictly ascending.
    height : array_like, shape (n,)
        Heights [mm], positive where there is material.
    gaps : tuple of (float, float)
        Intervals [mm] without points in which something should have been measured.
    land : (float, float) or None
        Ends [mm] of the land where points beyond it belong to corners; None where all points are one land.

    Raises
    ------
    InputError
        If there are fewer than five points, they are not finite or positions do not ascend.
    """

    y: Array
    height: Array
    gaps: tuple[tuple[float, float], ...] = ()
    land: tuple[float, float] | None = field(default=None, kw_only=True)

    def __post_init__(self) -> None:
        y, height = _read_only("y", self.y), _read_only("height", self.height)
        if len(y) != len(height):
            condition = f"have {len(y)} numbers, as y has, not {len(height)}"
            raise InputError("height", height, condition, "give one per position")
        if len(y) < FEWEST_POINTS:
            condition = f"be at least {FEWEST_POINTS}"
            raise InputError("points", len(y), condition, "measure more of the line or cut less away")
        if np.any(np.diff(y) <= 0.0):
            place = float(y[int(np.argmax(np.diff(y) <= 0.0)) + 1])
            raise InputError("y", place, "be greater than the position before it", "sort the points, each once")
        object.__setattr__(self, "gaps", _check_intervals("gaps", self.gaps))
        if self.land is not None:
            object.__setattr__(self, "land", _check_intervals("land", [self.land])[0])
        object.__setattr__(self, "y", y)
        object.__setattr__(self, "height", height)
        if self.gaps and not np.any(self.weights):
            condition = "leave two neighbouring points that were measured"
            raise InputError("gaps", self.gaps, condition, "leave out gaps that are no wider than the usual step")

    def __len__(self) -> int:
        return len(self.y)

    @property
    def span(self) -> float:
        """Distance between the outermost points [mm]."""
        return float(self.y[-1] - self.y[0])

    @cached_property
    def weights(self) -> Array:
        """Length [mm] that each point represents, half-way to its neighbours; gaps belong to no point."""
        steps = np.where(self.in_gap, 0.0, np.diff(self.y))
        weights = np.zeros(len(self.y))
        weights[:-1] += 0.5 * steps
        weights[1:] += 0.5 * steps
        weights.setflags(write=False)
        return weights

    @cached_property
    def in_gap(self) -> NDArray[np.bool_]:
        """Whether the interval from each point but the last to the next lies in a gap or contains one."""
        inside = np.zeros(len(self.y) - 1, dtype=bool)
        for low, high in self.gaps:
            first, after = np.searchsorted(self.y[1:], low, side="right"), np.searchsorted(self.y[:-1], high)
            inside[first:after] = True
        inside.setflags(write=False)
        return inside

    def kept(self, inside: NDArray[np.bool_]) -> Points:
        """Return the points selected by a mask, with the gaps that still lie between them."""
        y = self.y[inside]
        gaps = tuple(gap for gap in self.gaps if len(y) and y[0] < gap[1] and y[-1] > gap[0])
        return Points(y, self.height[inside], gaps, land=self.land)

    def lifted(self, height: Array) -> Points:
        """Return the points at other heights [mm]."""
        return Points(self.y, height, self.gaps, land=self.land)

    @property
    def beyond_land(self) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
        """Which points belong to the corners at low and high y."""
        low, high = (-np.inf, np.inf) if self.land is None else self.land
        return self.y < low, self.y > high

    @cached_property
    def on_land(self) -> Points:
        """The points of the land alone."""
        if self.land is None:
            return self
        low, high = self.beyond_land
        return replace(self.kept(~(low | high)), land=None)

    @property
    def height_between_corners(self) -> Array:
        """Heights of the land [mm], or of the middle nine tenths before it is known: the range of drawings."""
        if self.land is not None:
            return self.on_land.height
        from_middle = np.abs(self.y - 0.5 * (self.y[0] + self.y[-1]))
        inner: Array = self.height[from_middle <= 0.5 * _INNER * np.ptp(self.y)]
        return inner


@dataclass(frozen=True, eq=False, repr=False)
class Trace(Points):
    """A raw measurement, as the machine left it except for units, sign and order.

    Parameters
    ----------
    y, height, gaps
        As in `Points`.
    name : str
        Its name, such as that of the file it came from.
    notes : tuple of str
        How it was brought into this form, a sentence each.

    Raises
    ------
    InputError
        As in `Points`.

    Examples
    --------
    >>> trace = Trace([0.0, 1.0, 2.0, 3.0, 4.0], [0.0, 0.01, 0.012, 0.01, 0.0], name="roller")
    >>> len(trace), trace.span
    (5, 4.0)
    """

    name: str = field(default="measured profile", kw_only=True)
    notes: tuple[str, ...] = field(default=(), kw_only=True)

    def __post_init__(self) -> None:
        super().__post_init__()
        text("name", self.name, "give the name of the file, say")
        for note in check_list("notes", self.notes, "be a list of sentences", "leave them out"):
            text("notes", note, "give a sentence for each")
        object.__setattr__(self, "notes", tuple(self.notes))


def usual_step(y: Array) -> float:
    """Return the 90 % quantile of the steps [mm] of ascending positions; several points may share a position.

    Where two strokes overlap, their points lie arbitrarily close to each other. The nominal step of a stroke is among
    the longest steps, and steps over missing points are longer still.
    """
    steps = np.diff(y)
    steps = steps[steps > 0.0]
    return float(np.quantile(steps, 0.9, method="lower")) if len(steps) else 0.0


def holes(y: Array) -> tuple[tuple[float, float], ...]:
    """Return the gaps [mm] of a line that is evenly spaced elsewhere; empty for a line that is not.

    Parameters
    ----------
    y : array, shape (n,)
        Positions [mm], strictly ascending, from one stroke or from several.
    """
    steps, usual = np.diff(y), usual_step(y)
    between = (steps > (1.0 + _TENTH) * usual) & (steps <= _HOLE * usual)
    if np.mean(np.abs(steps - usual) <= _TENTH * usual) < _EVEN or np.mean(between) > _UNEVEN:
        return ()
    return _between(y, np.flatnonzero(steps > _HOLE * usual))


def dropouts(y: Array, places: Array, pairs: Array) -> tuple[tuple[float, float], ...]:
    """Return the gaps [mm] around positions at which a measurement failed.

    Only measured points decide: where another stroke, or a later line of the file, has points there, there is no gap;
    elsewhere it extends from one measured neighbour to the other.

    Parameters
    ----------
    y : array, shape (n,)
        Measured positions [mm], strictly ascending.
    places : array, shape (m,)
        Positions [mm] that were not measured, in any order.
    pairs : array, shape (k, 2)
        Two measured positions each, with a failed one somewhere between them.
    """
    after = np.searchsorted(y, places)
    inside = (after > 0) & (after < len(y))
    after, places = after[inside], places[inside]
    steps = after[y[after] != places] - 1
    ends = np.sort(np.searchsorted(y, pairs, side="right") - 1, axis=1)
    steps = np.union1d(steps, ends[np.diff(ends, axis=1)[:, 0] == 1, 0])
    return _between(y, steps[np.diff(y)[steps] > _DROPOUT * usual_step(y)])


def _between(y: Array, steps: NDArray[np.intp]) -> tuple[tuple[float, float], ...]:
    return tuple((float(y[k]), float(y[k + 1])) for k in steps)


def _read_only(name: str, values: ArrayLike) -> Array:
    remedy = "leave out what was not measured"
    row = numbers(name, values, remedy, FARTHEST, "mm").copy()
    if row.ndim != 1:
        raise InputError(name, f"an array of shape {row.shape}", "be a list of finite numbers", remedy)
    row.setflags(write=False)
    return row


def _check_intervals(name: str, intervals: Iterable[tuple[float, float]]) -> tuple[tuple[float, float], ...]:
    remedy = "give intervals in mm, low end first"
    pairs = [numbers(name, pair, remedy) for pair in check_list(name, intervals, "be a list of intervals", remedy)]
    if not all(pair.shape == (2,) and pair[0] <= pair[1] for pair in pairs):
        raise InputError(name, intervals, "be pairs of ends that ascend", remedy)
    return tuple((float(low), float(high)) for low, high in pairs)
