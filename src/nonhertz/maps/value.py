"""A map as a value: evaluated, inverted, printed, tabulated and saved."""

from __future__ import annotations

import math
import os
from collections.abc import Iterator
from dataclasses import astuple, dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.amounts import format_digits, mm, mrad, newton, um
from nonhertz.errors import InputError
from nonhertz.findings import Finding, HasFindings, finding
from nonhertz.inputs.checks import broadcast, numbers, whole
from nonhertz.maps import files, fitting
from nonhertz.maps.evaluation import MOST_LOAD, TILT_HIGH, TILT_LOW
from nonhertz.maps.misses import SAFETY, SampledErrors
from nonhertz.native import core
from nonhertz.result.brief import HasHtml, plain_text
from nonhertz.result.quantities import QUANTITIES
from nonhertz.result.read_only import ReadOnly
from nonhertz.result.tables import as_csv

Array = NDArray[np.float64]

#: Columns of tables for other programs; `QUANTITIES` has their units.
COLUMNS = (
    "approach", "tilt", "load", "moment", "load_by_approach", "load_by_tilt", "moment_by_approach", "moment_by_tilt",
    "max_pressure", "max_half_width",
)  # fmt: skip
ROWS, TILTS = 41, 21
#: Code of the finding on a map whose loads or moments miss the requested accuracy.
INACCURATE = "inaccurate-map"
BESIDE = 0.02  # error of other quantities than load and moment without a warning
_TILT_ROUNDING = 1e-12  # of the range
_OF = {
    "load": "of the load",
    "moment": "of load times half-length",
    "stiffness": "of the stiffness",
    "max_pressure": "of the maximum pressure",
    "max_half_width": "of the half-width",
    "strip_loads": "of the load on each of {strips} strips",
}


@dataclass(frozen=True, eq=False, repr=False)
class MapPoint(ReadOnly):
    """State of a map at one point, or at many of shape (...).

    Attributes
    ----------
    approach, tilt, load, moment : float or ndarray, shape (...)
        As in `nonhertz.Solution` [mm, rad, N, N mm].
    stiffness : ndarray, shape (..., 2, 2)
        d(load, moment) / d(approach, tilt), the exact derivative of the surrogate; symmetric.
    max_pressure, max_half_width : float or ndarray, shape (...)
        [MPa], [mm].
    """

    approach: Any
    tilt: Any
    load: Any
    moment: Any
    stiffness: Array
    max_pressure: Any
    max_half_width: Any

    @property
    def load_by_approach(self) -> Any:
        """D load / d approach [N/mm]."""
        return self.stiffness[..., 0, 0]

    @property
    def load_by_tilt(self) -> Any:
        """D load / d tilt [N/rad]."""
        return self.stiffness[..., 0, 1]

    @property
    def moment_by_approach(self) -> Any:
        """D moment / d approach [N mm/mm]."""
        return self.stiffness[..., 1, 0]

    @property
    def moment_by_tilt(self) -> Any:
        """D moment / d tilt [N mm/rad]."""
        return self.stiffness[..., 1, 1]


@dataclass(frozen=True, eq=False, repr=False)
class ContactMap(HasFindings, ReadOnly, HasHtml):
    """A fast surrogate of a contact with sampled errors; made by `nonhertz.maps.contact_map`.

    Attributes
    ----------
    description : str
        The bodies and the strip element in words.
    given : str
        ``"load"`` or ``"approach"``: the quantity in which the range was given.
    pressed : tuple of float
        Lowest and highest load [N] or approach [mm], as given.
    numbers, breaks, mean_approach, others : ndarray
        Range, cells and coefficients of the splines.
    stations : ndarray, shape (stations + 1,)
        Edges of the strips along the contact [mm] whose loads the map contains.
    half_length : float
        Lever arm [mm] to which errors of the moment are relative.
    accuracy : float
        The requested accuracy.
    sampled_error : SampledErrors
        Differences from the solver at its check points.
    cases : int
        Number of solved cases from which it was built, without the check points of ``sampled_error``.
    failed : int
        Number of cases without a solution, check points included.
    """

    description: str
    given: str
    pressed: tuple[float, float]
    numbers: Array
    breaks: Array
    mean_approach: Array
    others: Array
    stations: Array
    half_length: float
    accuracy: float
    sampled_error: SampledErrors
    cases: int
    failed: int

    def __repr__(self) -> str:
        error = self.sampled_error
        pressed = (newton if self.given == "load" else um)(*self.pressed, between=" to ")
        tilts = mrad(*self.tilt_range, between=" to ")
        failures = f"; {self.failed} had no solution" if self.failed else ""
        errors = ", ".join(" ".join(part) for part in self.errors_in_words)
        lines = [
            self.description,
            f"{self.given} {pressed:.4g}, tilt {tilts:.4g}, loads up to {newton(self.max_load)}",
            f"built from {self.cases} cases{failures}",
            f"largest of {error.points} sampled errors, times {SAFETY:g}, not a bound: {errors}",
        ]
        return plain_text("ContactMap", lines)

    @property
    def errors_in_words(self) -> list[tuple[str, str]]:
        """Each sampled error, and the quantity to which it is relative."""
        strips = self.stations.size - 1
        return [(in_share(getattr(self.sampled_error, name)), of.format(strips=strips)) for name, of in _OF.items()]

    @cached_property
    def findings(self) -> tuple[Finding, ...]:  # type: ignore[override]
        """Inaccuracies of the map."""
        return tuple(self._inaccuracies())

    def _inaccuracies(self) -> Iterator[Finding]:
        reached = max(self.sampled_error.load, self.sampled_error.moment)
        if reached > self.accuracy:
            words = "The map is accurate to {reached:.2g}, not to the requested {accuracy:g}; see its sampled_error."
            yield finding(INACCURATE, words, reached=reached, accuracy=self.accuracy)
        permitted = max(self.accuracy, BESIDE)
        beside = zip(self.errors_in_words[2:], astuple(self.sampled_error)[2:-1], strict=True)
        if off := [" ".join(words) for words, error in beside if error > permitted]:
            sentence = (
                "Errors of the map exceed {percent:g} %: {off}. Where these matter, take them from nonhertz.solve_many."
            )
            yield finding("inaccurate-beside", sentence, percent=100.0 * permitted, off=" and ".join(off))

    @property
    def max_load(self) -> float:
        """The largest load of the map [N]."""
        return float(self.numbers[MOST_LOAD])

    @property
    def tilt_range(self) -> tuple[float, float]:
        """Lowest and highest tilt of the map [rad]."""
        return float(self.numbers[TILT_LOW]), float(self.numbers[TILT_HIGH])

    @cached_property
    def table(self) -> Array:
        """All numbers in one row, the argument of C functions such as `nonhertz.maps.AT_APPROACH`."""
        count = self.breaks.size - int(self.numbers[-1]) - 1
        return fitting.table(self.numbers, (self.breaks[:count], self.breaks[count:]), self.mean_approach, self.others)

    def at(self, *, approach: ArrayLike, tilt: ArrayLike = 0.0) -> MapPoint:
        """Return load, moment, stiffness and the rest at approaches and tilts.

        Parameters
        ----------
        approach : array_like
            delta [mm]; out of contact all results are zero.
        tilt : array_like
            gamma [rad]; broadcast against ``approach``.

        Returns
        -------
        MapPoint
            Floats for two numbers, else arrays.

        Raises
        ------
        InputError
            If a point is outside the map.
        """
        return self._found("approach", approach, tilt)

    def under(self, *, load: ArrayLike, tilt: ArrayLike = 0.0) -> MapPoint:
        """Return approach, moment, stiffness and the rest under loads [N] and at tilts [rad].

        Under no load the approach is that of first touch, and all other results are zero.

        Parameters
        ----------
        load, tilt : array_like
            Q [N] and gamma [rad]; they broadcast.

        Returns
        -------
        MapPoint

        Raises
        ------
        InputError
            If a point is outside the map.
        """
        return self._found("load", load, tilt)

    def _found(self, name: str, value: ArrayLike, tilt: ArrayLike) -> MapPoint:
        unit = QUANTITIES[name].unit
        remedy = f"give the {name} in {unit} and the tilt in rad"
        values, tilts = broadcast(remedy, numbers(name, value, remedy), numbers("tilt", tilt, remedy))
        shape = values.shape
        first, second = values.ravel(), self._within(tilts).ravel()
        states = core.map_states(self.table, name == "load", first, second)
        outside = np.flatnonzero(states[:, 7] == 0.0)
        if outside.size:
            self._refuse(name, float(first[outside[0]]), float(second[outside[0]]))
        stiffness = states[:, [4, 5, 5, 6]].reshape(*shape, 2, 2)
        plain = [column.reshape(shape) if shape else float(column[0]) for column in states.T]
        return MapPoint(*plain[:4], stiffness, *plain[8:])  # type: ignore[call-arg, arg-type]

    def strip_loads(self, point: MapPoint, stations: ArrayLike | None = None) -> Array:
        """Return the loads on strips along the contact at points.

        Parameters
        ----------
        point : MapPoint
            Points of this map.
        stations : array_like, shape (strips + 1,), optional
            Edges of the strips [mm], ascending; by default ``stations``, for which errors are sampled.

        Returns
        -------
        ndarray, shape (..., strips)
            Load on each strip [N]; where the strips cover the contact, their sum is the load.

        Raises
        ------
        InputError
            If the stations are not ascending numbers.
        """
        _refuse_others(point)
        remedy = "give ascending edges of strips in mm"
        edges = self.stations if stations is None else numbers("stations", stations, remedy)
        if edges.ndim != 1 or edges.size < 2 or np.any(np.diff(edges) <= 0.0):
            raise InputError("stations", stations, "be ascending", remedy)
        load, tilt = (np.asarray(values, dtype=float).ravel() for values in (point.load, point.tilt))
        loads = core.map_shares(self.table, load, tilt, np.ascontiguousarray(edges))
        return loads.reshape(*np.shape(point.load), -1)

    def _within(self, tilt: Array) -> Array:
        """Return tilts, with those outside the range by rounding moved to its end."""
        low, high = self.tilt_range
        slack = _TILT_ROUNDING * (high - low)
        inside = np.clip(tilt, low, high)
        moved: Array = np.where(np.abs(tilt - inside) <= slack, inside, tilt)
        return moved

    def _refuse(self, name: str, value: float, tilt: float) -> None:
        low, high = self.tilt_range
        remedy = "make a map of a wider range"
        if not low <= tilt <= high:
            raise InputError("tilt", tilt, f"lie in the range of the map, {low:.6g} to {high:.6g} rad", remedy)
        if name == "load":
            most = newton(0.0, self.max_load, between=" to ")
            raise InputError("load", value, f"lie in the range of the map, {most:g}", remedy)
        last = self.under(load=self.max_load, tilt=tilt).approach
        condition = f"not exceed {mm(last):.6g} at a tilt of {tilt:.6g} rad, where the map ends"
        raise InputError("approach", value, condition, remedy)

    def grid(self, rows: int = ROWS, tilts: int = TILTS) -> MapPoint:
        """Return the map on a grid over its range, of shape (rows, tilts).

        Parameters
        ----------
        rows : int
            Number of approaches or loads, whichever the range was given in.
        tilts : int
            Number of tilts; 1 for the middle one.

        Raises
        ------
        InputError
            If these are not whole numbers of at least 1.
        """
        count = whole("rows", rows, 1, math.inf, "give the number of approaches or loads")
        across = whole("tilts", tilts, 1, math.inf, "give the number of tilts")
        low, high = self.tilt_range
        tilt = np.linspace(low, high, across) if across > 1 else np.array([0.5 * (low + high)])
        values = np.linspace(*self.pressed, count)[:, None]
        return self.at(approach=values, tilt=tilt) if self.given == "approach" else self.under(load=values, tilt=tilt)

    def csv(self, point: MapPoint | None = None) -> str:
        """Return points as CSV with a header of names and units, by default those of `grid`.

        Parameters
        ----------
        point : MapPoint, optional
            Points of this map.
        """
        point = self.grid() if point is None else point
        _refuse_others(point)
        return as_csv({f"{name} [{QUANTITIES[name].unit}]": getattr(point, name) for name in COLUMNS})

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the map into an NPZ file, from which `read` returns it to the last bit.

        Parameters
        ----------
        path : str or os.PathLike
            The file, usually named ``.npz``; an existing one is overwritten.
        """
        files.save(path, self)

    @classmethod
    def read(cls, path: str | os.PathLike[str]) -> ContactMap:
        """Return the map in a file that `save` wrote.

        Raises
        ------
        InputError
            If the file cannot be read, was not written by `save`, is of another version, or damaged.
        """
        return cls(**files.load(path))


def _refuse_others(point: object) -> None:
    if not isinstance(point, MapPoint):
        raise InputError("point", point, "be points of a map", "give what ContactMap.at, under or grid returns")


def in_share(error: float) -> str:
    """Return a relative error in ppm where it is small, else in per cent."""
    return f"{format_digits(1e6 * error, 2)} ppm" if error < 1e-3 else f"{format_digits(100.0 * error, 2)} %"
