"""Measured profiles: points along the axis, given or read from a file, and a curve through them."""

from __future__ import annotations

import errno
import os
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Annotated, Any, Literal, get_args

import numpy as np

from nonhertz.amounts import mm
from nonhertz.errors import InputError
from nonhertz.inputs.descriptions import Quantities, Word
from nonhertz.inputs.files import is_special_file, printable_name, read_bytes
from nonhertz.model.profile.base import Array, Formula, Profile
from nonhertz.model.profile.kind import kind

#: The curve through tabulated points.
Interpolation = Literal["pchip", "linear", "cubic"]
_MOST_BENDS, _MOST_CRESTS = 20, 5000
_CLOSEST = 1e-12  # of the largest position: a smaller spacing would be lost in rounding
LARGEST_FILE = 5_000_000  # bytes
MOST_POINTS = 100_000  # strips resolve some hundreds
_FEWER_POINTS = "export fewer points; a few thousand are enough"
_COLUMNS = "write one point per line, y and relief in mm"
_SMALL_UNIT = re.compile(r"(?<![a-z])(um|µm|μm|nm|microns?|micromet(?:er|re)s?)(?![a-z])", re.IGNORECASE)


@dataclass(frozen=True)
class Tabulated(Formula):
    """A curve through given points; outside them there is no body."""

    y: tuple[float, ...]
    values: tuple[float, ...]
    interpolation: Interpolation = "pchip"
    # Not compared: a case file stores only points and curve.
    joints: tuple[float, float] | None = field(default=None, compare=False)

    @property
    def catalogue_entry(self) -> tuple[str, dict[str, Any]]:
        """The kind and the points, whatever their origin."""
        return "tabulated", {"y": self.y, "relief": self.values, "interpolation": self.interpolation}

    def relief_at(self, y: Array) -> Array:
        """Return the relief [mm]; infinite outside the table."""
        inside = (y >= self.y[0]) & (y <= self.y[-1])
        return np.where(inside, self.curve(np.where(inside, y, self.y[0])), np.inf)

    @property
    def bends(self) -> tuple[float, ...]:
        """The kinks of a linear interpolation: where the slope jumps by more than a tenth of its whole range.

        A densely sampled smooth curve has none. Where more than twenty points qualify, the table is rough
        rather than kinked, and no point is treated specially.
        """
        if self.interpolation != "linear" or len(self.y) < 3:
            return ()
        slopes = np.diff(self.values) / np.diff(self.y)
        kinks = np.flatnonzero(np.abs(np.diff(slopes)) > 0.1 * np.ptp(slopes)) + 1
        return tuple(self.y[kink] for kink in kinks) if len(kinks) <= _MOST_BENDS else ()

    @cached_property
    def crests(self) -> tuple[float, ...]:
        """The points at which the slope of the relief increases; if very many, the lowest of every few."""
        relief, y = np.array(self.values), np.array(self.y)
        slopes = np.diff(relief) / np.diff(y)
        rising = np.flatnonzero(np.diff(slopes) > 0.0) + 1
        several = -(-rising.size // _MOST_CRESTS)
        if several > 1:
            padded = np.append(rising, np.full(-rising.size % several, rising[-1])).reshape(-1, several)
            rising = padded[np.arange(padded.shape[0]), relief[padded].argmin(axis=1)]
        return tuple(y[rising].tolist())

    @property
    def extent(self) -> tuple[float, float]:
        """The interval that the points span."""
        return (self.y[0], self.y[-1])

    @cached_property
    def curve(self) -> Any:
        """The relief as a function of positions between the outermost points; a smooth one is scipy's ``PPoly``."""
        if self.interpolation == "linear":
            return _Polyline(np.array(self.y), np.array(self.values))
        # Imported here, because importing scipy.interpolate takes half a second.
        from scipy.interpolate import CubicSpline, PchipInterpolator

        make = PchipInterpolator if self.interpolation == "pchip" else CubicSpline
        with np.errstate(over="ignore"):  # pchip divides by slopes; an overflow there stands for zero
            curve: Callable[[Array], Array] = make(np.array(self.y), np.array(self.values))
        return curve


@dataclass(frozen=True, eq=False)
class _Polyline:
    y: Array
    values: Array

    def __call__(self, y: Array) -> Array:
        return np.asarray(np.interp(y, self.y, self.values))


def _one_relief_per_position(y: Sequence[float], relief: Sequence[float]) -> None:
    if len(y) != len(relief):
        raise InputError("relief", relief, f"hold as many numbers as y, {len(y)}", "give one relief per position")


def _apart(y: Sequence[float]) -> None:
    if len(y) < 2:
        raise InputError("y", y, "hold at least two positions", "give the measured points in mm")
    positions = np.sort(y)
    gaps, room = np.diff(positions), _CLOSEST * float(np.abs(positions).max())
    close = np.flatnonzero((gaps <= 0.0) | (gaps < room))
    if len(close):
        near, far = positions[close[0] : close[0] + 2].tolist()
        apart = f"keep its points {mm(room):.2g} apart, farther than {near} and {far}"
        condition = f"not hold {near} twice" if near == far else apart
        raise InputError("y", y, condition, "keep one point per position")


@kind(cross_checks=(_one_relief_per_position, _apart))
def tabulated(
    y: Annotated[
        Sequence[float],
        Quantities("mm", "the axial positions from the middle of the body, at least two, all different, in any order"),
    ],
    relief: Annotated[Sequence[float], Quantities("mm", "the relief there, positive where material is removed")],
    interpolation: Annotated[
        Interpolation,
        Word(
            "the curve through the points: 'pchip', a smooth one that never overshoots them; 'linear'; or 'cubic', the "
            "spline with continuous curvature, which may overshoot",
            "choose the curve through the points",
            get_args(Interpolation),
        ),
    ] = "pchip",
) -> Profile:
    """Return a profile through given points, such as a measured one.

    Returns
    -------
    Profile
        The profile, defined between the outermost points; contact cannot extend beyond them.

    References
    ----------
    F. N. Fritsch and J. Butland, A method for constructing local monotone piecewise cubic interpolants, SIAM
    Journal on Scientific and Statistical Computing 5 (1984) 300-304, doi:10.1137/0905021, for ``"pchip"``.

    Examples
    --------
    >>> profile = tabulated(y=[-10, 0, 10], relief=[0.01, 0.0, 0.01], interpolation="linear")
    >>> float(profile.relief(5.0)), profile.extent
    (0.005, (-10.0, 10.0))
    """
    order = np.argsort(y, kind="stable")
    positions, reliefs = np.array(y)[order], np.array(relief)[order]
    return Tabulated(tuple(positions.tolist()), tuple(reliefs.tolist()), interpolation)


def from_file(path: str | os.PathLike[str], interpolation: Interpolation = "pchip") -> Profile:
    r"""Return a profile read from a text file of two columns, y and relief, both in mm.

    Columns are separated by semicolons, tabs, commas or blanks; with semicolons or tabs the decimal sign may be a
    comma. Blank lines, anything after a ``#``, and one line of column names at the top are skipped.

    Parameters
    ----------
    path : str or os.PathLike
        The file, in UTF-8.
    interpolation : {"pchip", "cubic", "linear"}
        The curve through the points, as in `tabulated`.

    Returns
    -------
    Profile
        The profile, with y = 0 at the middle of the body. ``.scaled(-0.001)`` turns heights in micrometres into a
        relief in mm, and ``.shifted`` moves the middle into place.

    Raises
    ------
    InputError
        If the file cannot be read, is a device or a pipe, is larger than 5 MB, holds more than 100,000 points, or a
        line is not two numbers; the message names file and line.

    References
    ----------
    See `tabulated`.

    Examples
    --------
    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     path = Path(folder, "roller.csv")
    ...     _ = path.write_text("y, relief  # mm\n-5, 0.01\n0, 0\n5, 0.01\n")
    ...     float(from_file(path).relief(5.0))
    0.01
    """
    if not isinstance(path, str | os.PathLike):
        raise InputError("path", path, "be the name of a file", "give a string or a pathlib.Path")
    path = Path(path)
    points = _read(path)
    if len(points) < 2:
        content = f"{printable_name(path.name)} holds {'only one point' if points else 'no data'}"
        raise InputError("path", str(path), f"name a file of at least two points ({content})", _COLUMNS)
    y, relief = zip(*points, strict=True)
    try:
        return tabulated(y, relief, interpolation)
    except InputError as error:
        raise error.within(printable_name(path.name)) from None


def _read(path: Path) -> list[tuple[float, float]]:
    if is_special_file(path):
        raise InputError("path", str(path), "name a file, not a device or a pipe", "save the points in a file")
    try:
        # Line endings of any system.
        lines = read_bytes(path, LARGEST_FILE).decode("utf-8-sig").replace("\r\n", "\n").replace("\r", "\n").split("\n")
    except OSError as error:
        why = error.strerror or "unreadable"
        reason = f"{printable_name(path.name)}: {why[:1].lower()}{why[1:]}"
        remedy = _FEWER_POINTS if error.errno == errno.EFBIG else "check it"
        raise InputError("path", str(path), f"name a file that can be read ({reason})", remedy) from None
    except ValueError:  # not text, or an impossible file name
        raise InputError("path", str(path), "name a text file in UTF-8", "export the points as CSV") from None
    points: list[tuple[float, float]] = []
    header_allowed = True
    for number, line in enumerate(lines, start=1):
        written = line.split("#", 1)[0].strip()
        if not written:
            continue
        cells = _cells(written)
        values = [_value(cell) for cell in cells]
        place = f"line {number} of {printable_name(path.name)}"
        if header_allowed and all(value is None for value in values):
            _check_header(place, written)
        elif len(points) < MOST_POINTS:
            points.append(_point(place, written, values))
        else:
            raise InputError("path", str(path), f"name a file of at most {MOST_POINTS} points", _FEWER_POINTS)
        header_allowed = False
    return points


def _cells(content: str) -> list[str]:
    for separator in (";", "\t"):
        if separator in content:
            return content.replace(",", ".").rstrip(separator + " ").split(separator)
    return content.rstrip(", ").split(",") if "," in content else content.split()


def _value(cell: str) -> float | None:
    try:
        return float(cell)
    except ValueError:
        return None


def _point(place: str, content: str, values: list[float | None]) -> tuple[float, float]:
    match values:
        case [float(y), float(relief)] if np.isfinite(y) and np.isfinite(relief):
            return y, relief
    raise InputError(place, content, "hold two finite numbers", _COLUMNS)


def _check_header(place: str, content: str) -> None:
    # Micrometres read as millimetres would make the relief a thousand times too large, and no later check could tell.
    if _SMALL_UNIT.search(content):
        remedy = "convert both columns to mm, delete the line, or use kind = 'measured', which reads units"
        raise InputError(place, content, "name mm as the unit", remedy)
