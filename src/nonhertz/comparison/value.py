"""What a comparison returns: the three solutions and everything that was found of them."""

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
class Quantity:
    """One result of all three methods.

    Attributes
    ----------
    name : str
        What it is, in words.
    unit : str
        Its unit.
    patch, semi_elliptic, parabolic : float
        What the plane grid and the strips of either element say; not a number where there is none.
    absolute : bool
        Whether differences are in ``unit``, as for positions; else relative to ``patch``.
    remark : str
        What has to be known of it; empty if nothing has.
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
        """Semi-elliptic and parabolic strips less the plane grid; not a number relative to zero."""
        scale = 1.0 if self.absolute else abs(self.patch) or math.nan
        return (self.semi_elliptic - self.patch) / scale, (self.parabolic - self.patch) / scale


@dataclass(frozen=True)
class Seconds:
    """Wall-clock times [s], compilation not counted.

    Attributes
    ----------
    semi_elliptic, parabolic : float
        Median of ``runs`` solves on strips.
    patch : float
        One solve on the plane grid.
    runs : int
        How many solves on strips.
    """

    semi_elliptic: float
    parabolic: float
    patch: float
    runs: int


@dataclass(frozen=True)
class Reason:
    """Why strips and plane grid differ, and by how much that can make them differ.

    Attributes
    ----------
    sentence : str
        What the solutions tell, without a full stop.
    size : float
        The largest difference that comes of it, relative to the plane grid; infinite where it can be all of it.
    """

    sentence: str
    size: float

    def __str__(self) -> str:
        size = f"{percent(self.size)} at most" if math.isfinite(self.size) else "any difference"
        return f"{self.sentence}: {size}."


def percent(relative: float) -> str:
    """Return a share in per cent, two digits or a whole number."""
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
        The largest difference there, relative to the plane grid; infinite where that has no contact.
    at : float
        Centre of the strip that has it [mm].
    reasons : tuple of Reason
        What the solutions tell of why, with sizes at ``at``, or at ``unexplained_at`` where something is left.
    unexplained : float
        The most by which a difference exceeds the sum of its reasons' sizes at the same strip; zero where none does.
    unexplained_at : float
        Centre of the strip where that is [mm], or ``at``.
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
        """Whether the reasons together are as large as the difference, at every strip."""
        return self.unexplained == 0.0


@dataclass(frozen=True)
class Station:
    """A place to look across the contact.

    Attributes
    ----------
    y : float
        Position [mm].
    reason : str
        Why there.
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
        What each took.
    quantities : tuple of Quantity
        Results side by side.
    stretches : tuple of Stretch
        Where along the line they differ by more than 1 %, and why; of semi-elliptic strips first.
    stations : tuple of three Station
        Where to look across.
    """

    semi_elliptic: Solution
    parabolic: Solution
    patch: PatchSolution
    seconds: Seconds
    quantities: tuple[Quantity, ...]
    stretches: tuple[Stretch, ...]
    stations: tuple[Station, ...]

    @property
    def contact(self) -> Contact:
        """What was solved."""
        return self.patch.contact

    @property
    def strips(self) -> tuple[Solution, Solution]:
        """Both solutions on strips."""
        return self.semi_elliptic, self.parabolic

    @property
    def warnings(self) -> tuple[str, ...]:
        """What strains the models, as semi-elliptic strips and the plane grid say it."""
        return (*self.semi_elliptic.warnings, *(f"On the plane grid: {each}" for each in self.patch.warnings))

    def quantity(self, name: str) -> Quantity:
        """Return the quantity whose name begins so.

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
        """Return how far each strip is from the plane grid; see `differences`."""
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
        Not a number where neither has contact, infinite where only the strip has, and -1 where only the plane grid
        has it, in the cell there and in both beside it: the last cell of a contact may end it up to a cell late.
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
        <x^4> / (2 <x^2>^2) - 1 about the middle, and the pressure on x = 0 over that of the semi-ellipse, less 1; not a
        number with fewer than `FEWEST_ACROSS` cells in contact, or where the half-width changes by more than
        `MOST_CHANGE` of itself from cell to cell: a cell along then holds semi-ellipses of unlike widths, whose mean is
        none.
    """
    pressure, load, width = patch.pressure, patch.pressure.sum(axis=0), patch.half_width
    fourth_excess, peak_excess = np.full(patch.y.size, np.nan), np.full(patch.y.size, np.nan)
    steps = np.abs(np.diff(width))
    change = np.maximum(np.append(steps, 0.0), np.insert(steps, 0, 0.0))
    wide = (patch.footprint.sum(axis=0) >= FEWEST_ACROSS) & (change < MOST_CHANGE * width)
    share = pressure[:, wide] / load[wide]
    away = patch.x[:, None] - patch.x @ share
    # Each cell's pressure is uniform: its own moments about its middle belong to it.
    cell = patch.dx**2 / 12.0
    second = np.sum(share * away**2, axis=0) + cell
    fourth = np.sum(share * (away**4 + 6.0 * cell * away**2), axis=0) + patch.dx**4 / 80.0
    fourth_excess[wide] = fourth / (2.0 * second**2) - 1.0
    peak_excess[wide] = patch.centre_pressure[wide] / (patch.line_load[wide] / (np.pi * np.sqrt(second))) - 1.0
    return fourth_excess, peak_excess
