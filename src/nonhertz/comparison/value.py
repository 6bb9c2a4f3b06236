"""The result of a comparison: the three solutions and their differences."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import Amount, amount, mm, percent
from nonhertz.errors import InputError
from nonhertz.findings import Finding
from nonhertz.model.contact import Contact
from nonhertz.patch.solution import PatchSolution
from nonhertz.result.brief import HasHtml, plain_text
from nonhertz.result.quantities import QUANTITIES
from nonhertz.result.solution import Solution

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]

NOTABLE = 0.01  # relative difference of pressures along the line
_READ = {quantity.label: quantity.shown_unit for quantity in QUANTITIES.values()}


@dataclass(frozen=True)
class ComparedQuantity:
    """One result by all three methods.

    Attributes
    ----------
    what : str
        Name of the quantity.
    unit : str
        Its unit.
    patch, semi_elliptic, parabolic : float
        Values by the plane grid and by strips of both elements; NaN if there is none.
    absolute : bool
        Whether differences are in ``unit``, as for positions; else relative to ``patch``.
    remark : Finding or None
        A remark.
    at : float or None
        Its position y [mm]; None for a quantity of the whole contact.
    """

    what: str
    unit: str
    patch: float
    semi_elliptic: float
    parabolic: float
    absolute: bool = False
    remark: Finding | None = None
    at: float | None = None

    @property
    def name(self) -> str:
        """Name and position."""
        return self.what if self.at is None else f"{self.what} at y = {mm(self.at):.5g}"

    @property
    def amount(self) -> Amount:
        """The values by the plane grid, by semi-elliptic and by parabolic strips, for display."""
        values = self.patch, self.semi_elliptic, self.parabolic
        return amount(values, self.unit, _READ.get(self.what, ""))

    @property
    def differences(self) -> tuple[float, float]:
        """Semi-elliptic and parabolic strips less the plane grid; NaN if relative to zero."""
        scale = 1.0 if self.absolute else abs(self.patch) or math.nan
        return (self.semi_elliptic - self.patch) / scale, (self.parabolic - self.patch) / scale


@dataclass(frozen=True)
class Seconds:
    """Wall-clock times [s], excluding compilation.

    Attributes
    ----------
    semi_elliptic, parabolic : float
        Median of ``runs`` solves on strips.
    patch : float
        One solve on the plane grid.
    runs : int
        Number of solves on strips.
    """

    semi_elliptic: float
    parabolic: float
    patch: float
    runs: int


@dataclass(frozen=True)
class Stretch:
    """A piece of the centre line on which strips differ from the plane grid by more than `NOTABLE`.

    Attributes
    ----------
    element : str
        Name of the strips' element.
    low, high : float
        Outer edges of its strips [mm].
    largest : float
        The largest difference there, relative to the plane grid; infinite where the plane grid has no contact.
    at : float
        Centre of the strip with this difference [mm].
    """

    element: str
    low: float
    high: float
    largest: float
    at: float


@dataclass(frozen=True)
class Station:
    """A station at which the pressure across is compared.

    Attributes
    ----------
    y : float
        Position [mm].
    reason : str
        Reason for its choice.
    """

    y: float
    reason: str


@dataclass(frozen=True, eq=False, repr=False)
class Comparison(HasHtml):
    """Strips of both elements and a plane grid on one case.

    Attributes
    ----------
    semi_elliptic, parabolic : Solution
        The strips.
    patch : PatchSolution
        The plane grid.
    seconds : Seconds
        Run time of each.
    quantities : tuple of ComparedQuantity
        Results side by side.
    stations : tuple of three Station
        Stations at which the pressure across is compared.
    """

    semi_elliptic: Solution
    parabolic: Solution
    patch: PatchSolution
    seconds: Seconds
    quantities: tuple[ComparedQuantity, ...]
    stations: tuple[Station, ...]

    def __repr__(self) -> str:
        across, along = self.patch.cells
        strips = [f"{solution.strips} {solution.element.name} strips" for solution in self.strips]
        sentences = [f"plane grid of {across} x {along} cells; {' and '.join(strips)}"]
        for quantity in map(self.quantity, ("approach", "load", "maximum pressure")):
            if any(map(percent, quantity.differences)):  # given quantities have none
                differences = zip(self.strips, map(percent, quantity.differences), strict=True)
                by = ", ".join(f"{solution.element.name} {words or '0'}" for solution, words in differences)
                sentences.append(f"{quantity.name} {replace(quantity.amount, values=(quantity.patch,))}, {by}")
        count = len(self.stretches)
        differing = f"over 1 % on {count} stretch{'es' * (count > 1)}" if count else "less than 1 % everywhere"
        return plain_text("Comparison", [*sentences, f"along the line, pressures differ by {differing}"])

    @property
    def contact(self) -> Contact:
        """The contact that was solved."""
        return self.patch.contact

    @property
    def strips(self) -> tuple[Solution, Solution]:
        """Both solutions on strips."""
        return self.semi_elliptic, self.parabolic

    @property
    def warnings(self) -> tuple[str, ...]:
        """Warnings of the semi-elliptic strips and of the plane grid."""
        return (*self.semi_elliptic.warnings, *(f"On the plane grid: {warning}" for warning in self.patch.warnings))

    @property
    def stretches(self) -> tuple[Stretch, ...]:
        """Where along the line strips differ from the plane grid by over 1 %; those of semi-elliptic strips first."""
        return tuple(stretch for solution in self.strips for stretch in _stretches(solution, self.along(solution)))

    def quantity(self, name: str) -> ComparedQuantity:
        """Return the first quantity whose name starts with ``name``.

        Raises
        ------
        KeyError
            If there is none.
        """
        for compared in self.quantities:
            if isinstance(name, str) and name and compared.name.startswith(name):
                return compared
        raise KeyError(name)

    def along(self, solution: Solution) -> Array:
        """Return the difference of each strip from the plane grid; see `differences`."""
        if not isinstance(solution, Solution):
            raise InputError("solution", solution, "be a solution on strips", "give one of those compared")
        return differences(solution, self.patch)


def differences(solution: Solution, patch: PatchSolution) -> Array:
    """Return the pressure of each strip less that of the plane grid at its centre, relative to the latter.

    Parameters
    ----------
    solution : Solution
        Solution on strips; its pressure is p0 = 2 q / (pi b), also for a parabola.
    patch : PatchSolution
        Solution on the plane grid; its pressure at x = 0 is linear between cells.

    Returns
    -------
    ndarray, shape (strips,)
        NaN where neither has contact, infinite where only the strip has contact, and -1 where only the plane grid has,
        in the cell there and in both adjacent ones: on the grid a contact may end up to one cell too late.
    """
    expected = np.interp(solution.y, patch.y, patch.centre_pressure)
    pressure = solution.centre_pressure
    relative = np.full(pressure.size, np.nan)
    relative[pressure > 0.0] = np.inf
    compared = (expected > 0.0) & ((pressure > 0.0) | _well_inside(patch, solution.y))
    relative[compared] = pressure[compared] / expected[compared] - 1.0
    return relative


def _stretches(solution: Solution, relative: Array) -> Iterator[Stretch]:
    """Yield stretches of strips that differ, joined if less than the largest half-width apart."""
    differ = np.flatnonzero(np.abs(np.nan_to_num(relative, nan=0.0)) > NOTABLE)
    apart = solution.edges[differ[1:]] - solution.edges[differ[:-1] + 1] > solution.max_half_width
    for strips in np.split(differ, np.flatnonzero(apart) + 1) if differ.size else ():
        worst = strips[np.abs(relative[strips]).argmax()]
        low, high = solution.edges[strips[0]], solution.edges[strips[-1] + 1]
        yield Stretch(solution.element.name, *map(float, (low, high, relative[worst], solution.y[worst])))


def _well_inside(patch: PatchSolution, y: Array) -> Flags:
    rows = np.pad(patch.footprint.any(axis=0), 1)
    inside = rows[:-2] & rows[1:-1] & rows[2:]
    cell = np.floor((y - patch.y[0]) / patch.dy + 0.5).astype(int)
    covered: Flags = (cell >= 0) & (cell < patch.y.size)
    covered[covered] = inside[cell[covered]]
    return covered
