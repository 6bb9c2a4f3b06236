"""The result of a comparison: the three solutions and how they differ."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nonhertz.errors import InputError
from nonhertz.model.contact import Contact
from nonhertz.patch.solution import PatchSolution
from nonhertz.result.solution import Solution

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]

FEWEST_ACROSS, MOST_CHANGE = 12, 0.1


@dataclass(frozen=True)
class ComparedQuantity:
    """One result by all three methods.

    Attributes
    ----------
    name : str
        What it is, in words.
    unit : str
        Its unit.
    patch, semi_elliptic, parabolic : float
        Values by the plane grid and by strips of either element; NaN where there is none.
    absolute : bool
        Whether differences are in ``unit``, as for positions; else relative to ``patch``.
    remark : str
        What to know about it; may be empty.
    """

    name: str
    unit: str
    patch: float
    semi_elliptic: float
    parabolic: float
    absolute: bool = False
    remark: str = ""

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
class Reason:
    """Why strips and plane grid differ, and how large a difference that can explain.

    Attributes
    ----------
    sentence : str
        The reason, without a full stop.
    size : float
        The largest difference it can cause, relative to the plane grid; infinite if it can be any difference.
    """

    sentence: str
    size: float

    def __str__(self) -> str:
        size = f"{percent(self.size)} at most" if math.isfinite(self.size) else "any difference"
        return f"{self.sentence}: {size}."


def percent(relative: float) -> str:
    """Return a fraction in per cent, to two digits or as a whole number."""
    return f"{100.0 * relative:.0f} %" if relative >= 0.995 else f"{100.0 * relative:.2g} %"


@dataclass(frozen=True)
class Stretch:
    """A piece of the centre line on which strips differ from the plane grid by more than 1 %.

    Attributes
    ----------
    element : str
        Name of the strips' element.
    low, high : float
        Outer edges of its strips [mm].
    largest : float
        The largest difference there, relative to the plane grid; infinite where the plane grid has no contact.
    at : float
        Centre of the strip that has it [mm].
    reasons : tuple of Reason
        The reasons found, with sizes at ``at``, or at ``unexplained_at`` if something is left unexplained.
    unexplained : float
        The most by which a difference exceeds the sum of its reasons' sizes at the same strip; zero if none does.
    unexplained_at : float
        Centre of that strip [mm], or ``at``.
    """

    element: str
    low: float
    high: float
    largest: float
    at: float
    reasons: tuple[Reason, ...]
    unexplained: float
    unexplained_at: float

    @property
    def explained(self) -> bool:
        """Whether the reasons together are at least as large as the difference, at every strip."""
        return self.unexplained == 0.0


@dataclass(frozen=True)
class Station:
    """A station at which to look across the contact.

    Attributes
    ----------
    y : float
        Position [mm].
    reason : str
        Why it was chosen.
    """

    y: float
    reason: str


@dataclass(frozen=True, eq=False)
class Comparison:
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
    stretches : tuple of Stretch
        Where along the line they differ by more than 1 %, and why; those of semi-elliptic strips first.
    stations : tuple of three Station
        Where to look across the contact.
    """

    semi_elliptic: Solution
    parabolic: Solution
    patch: PatchSolution
    seconds: Seconds
    quantities: tuple[ComparedQuantity, ...]
    stretches: tuple[Stretch, ...]
    stations: tuple[Station, ...]

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
        return (*self.semi_elliptic.warnings, *(f"On the plane grid: {each}" for each in self.patch.warnings))

    def quantity(self, name: str) -> ComparedQuantity:
        """Return the first quantity whose name starts with ``name``.

        Raises
        ------
        KeyError
            If there is none.
        """
        for each in self.quantities:
            if isinstance(name, str) and name and each.name.startswith(name):
                return each
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
        On strips; its pressure is p0 = 2 q / (pi b), for a parabola too.
    patch : PatchSolution
        Its pressure on x = 0, linear between cells.

    Returns
    -------
    ndarray, shape (strips,)
        NaN where neither has contact, infinite where only the strip has, and -1 where only the plane grid has it, in
        the cell there and in both adjacent ones: on the grid a contact may end up to a cell too late.
    """
    expected = np.interp(solution.y, patch.y, patch.centre_pressure)
    found = solution.centre_pressure
    relative = np.full(found.size, np.nan)
    relative[found > 0.0] = np.inf
    compared = (expected > 0.0) & ((found > 0.0) | _well_inside(patch, solution.y))
    relative[compared] = found[compared] / expected[compared] - 1.0
    return relative


def _well_inside(patch: PatchSolution, y: Array) -> Flags:
    rows = np.pad(patch.footprint.any(axis=0), 1)
    inside = rows[:-2] & rows[1:-1] & rows[2:]
    cell = np.floor((y - patch.y[0]) / patch.dy + 0.5).astype(int)
    covered: Flags = (cell >= 0) & (cell < patch.y.size)
    covered[covered] = inside[cell[covered]]
    return covered


def excess_of_fourth_moment(patch: PatchSolution) -> Array:
    """Return how far the pressure across is from a semi-ellipse, by its fourth moment; see `excess_of_moments`."""
    return excess_of_moments(patch)[0]


def excess_of_moments(patch: PatchSolution) -> tuple[Array, Array]:
    """Return how far the pressure across is from a semi-ellipse, by its fourth moment and by its peak.

    A semi-ellipse of any load and width has <x^4> = 2 <x^2>^2, a rectangle 1.8 and a triangle 2.4. On x = 0 its
    pressure is q / (pi sqrt(<x^2>)).

    Parameters
    ----------
    patch : PatchSolution
        The plane grid.

    Returns
    -------
    tuple of ndarray, shape (ny,)
        <x^4> / (2 <x^2>^2) - 1 about the middle, and the pressure on x = 0 over that of the semi-ellipse, less 1; NaN
        with fewer than `FEWEST_ACROSS` cells in contact, or where the half-width changes by more than `MOST_CHANGE` of
        itself from cell to cell: a cell then averages over semi-ellipses of different widths, which does not give a
        semi-ellipse.
    """
    pressure, load, width = patch.pressure, patch.pressure.sum(axis=0), patch.half_width
    fourth_excess, peak_excess = np.full(patch.y.size, np.nan), np.full(patch.y.size, np.nan)
    steps = np.abs(np.diff(width))
    change = np.maximum(np.append(steps, 0.0), np.insert(steps, 0, 0.0))
    wide = (patch.footprint.sum(axis=0) >= FEWEST_ACROSS) & (change < MOST_CHANGE * width)
    share = pressure[:, wide] / load[wide]
    away = patch.x[:, None] - patch.x @ share
    # Each cell's pressure is uniform, so its moments about its own middle are included.
    cell = patch.dx**2 / 12.0
    second = np.sum(share * away**2, axis=0) + cell
    fourth = np.sum(share * (away**4 + 6.0 * cell * away**2), axis=0) + patch.dx**4 / 80.0
    fourth_excess[wide] = fourth / (2.0 * second**2) - 1.0
    peak_excess[wide] = patch.centre_pressure[wide] / (patch.line_load[wide] / (np.pi * np.sqrt(second))) - 1.0
    return fourth_excess, peak_excess
