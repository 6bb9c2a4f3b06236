"""The result of a solve on a plane grid: a read-only value and all quantities derived from it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import mm
from nonhertz.bodies.ends import FINITE_FROM, ends
from nonhertz.bodies.shape import HERTZ, Shape
from nonhertz.errors import InputError
from nonhertz.findings import Finding
from nonhertz.inputs.checks import finite
from nonhertz.model.contact import Contact
from nonhertz.model.profile.base import SAME_PLACE, at_ends
from nonhertz.patch.grid import half_widths, interpolation
from nonhertz.patch.resources import memory
from nonhertz.result import brief
from nonhertz.result.edges import SingularEnd
from nonhertz.result.ends import corner_ends, ends_in_words, singular_ends
from nonhertz.result.read_only import freeze
from nonhertz.result.solved import Solved
from nonhertz.result.status import ErrorEstimate, Status

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]


@dataclass(frozen=True, eq=False, repr=False)
class PatchSolution(Solved):
    """A contact solved on a plane grid.

    Attributes
    ----------
    contact : Contact
        The two bodies.
    status : Status
        Outcome of the solve.
    approach : float
        delta [mm], how far the bodies moved together on the line y = 0 from where their gap is zero: with the gap g0
        the undeformed bodies overlap by delta + gamma y - g0.
    penetration : float
        The largest interference of the undeformed bodies within the region [mm]: the approach beyond first touch.
    tilt : float
        gamma [rad] about x; positive tilt loads the side of positive y. The bodies cannot rotate about y.
    load : float
        Q [N], sum of the pressures times the area of a cell.
    moment : float
        T [N mm], the sum of the same times y.
    x : ndarray, shape (nx,)
        Centres of the cells across [mm].
    y : ndarray, shape (ny,)
        Centres of the cells along [mm].
    dx, dy : float
        Sides of a cell [mm].
    pressure : ndarray, shape (nx, ny)
        Pressure [MPa], uniform in each cell; ``pressure[i, j]`` is at ``x[i]``, ``y[j]``.
    gap : ndarray, shape (nx, ny)
        Deformed gap at the centre of each cell [mm]; in contact zero to within ``residual``.
    iterations : int
        Convolutions on the finest grid.
    residual : float
        Largest gap in contact or overlap elsewhere, over the largest elastic displacement [-].
    error_estimate : ErrorEstimate
        Relative errors of discretisation, from the coarser grids.
    findings : tuple of Finding
        Strains of the model in this case; empty if there are none.
    rolls_on : bool
        Whether a feature such as a dent changes across the contact: when the surfaces roll, it moves to another x.
    """

    contact: Contact
    status: Status
    approach: float
    penetration: float
    tilt: float
    load: float
    moment: float
    x: Array
    y: Array
    dx: float
    dy: float
    pressure: Array
    gap: Array
    iterations: int
    residual: float
    error_estimate: ErrorEstimate
    findings: tuple[Finding, ...]
    rolls_on: bool = False

    def _said(self) -> list[str]:
        singular = [str(ends_in_words([end])).removeprefix("the ") for end in self.singular_ends]
        return brief.lines(self, f"{self.cells[0]} x {self.cells[1]} cells", singular or ["no singular end"])

    @property
    def cells(self) -> tuple[int, int]:
        """Number of cells (across, along)."""
        return self.x.size, self.y.size

    @property
    def memory(self) -> int:
        """Peak memory of the solve in bytes; see `nonhertz.patch.memory`."""
        return memory(self.cells, self.contact)

    @cached_property
    def footprint(self) -> Mask:
        """Mask of the cells in contact, shape (nx, ny)."""
        return freeze(self.pressure > 0.0)

    @property
    def contact_area(self) -> float:
        """Area of the cells that touch [mm^2]."""
        return float(np.count_nonzero(self.footprint)) * self.dx * self.dy

    @property
    def max_pressure_x(self) -> float:
        """Position of the maximum pressure across the contact [mm]; nan where nothing touches."""
        if not self.footprint.any():
            return math.nan
        row = int(np.abs(self.y - self.max_pressure_y).argmin())
        return float(self.x[self.pressure[:, row].argmax()])

    @property
    def peaks_at_corner(self) -> bool:
        """Whether the maximum pressure is at a corner of the profile: always False, since cells cannot show it."""
        return False

    @cached_property
    def edges(self) -> Array:
        """Edges of the rows of cells along the contact [mm], ascending, shape (ny + 1,)."""
        return freeze(np.append(self.y - 0.5 * self.dy, self.y[-1] + 0.5 * self.dy))

    @property
    def contact_y(self) -> tuple[tuple[float, float], ...]:
        """The intervals [mm] along y of rows in contact, ascending."""
        touching = np.concatenate([[0], self.footprint.any(axis=0), [0]]).astype(int)
        change = np.diff(touching)
        first, beyond = np.flatnonzero(change > 0), np.flatnonzero(change < 0)
        return tuple(zip(self.edges[first].tolist(), self.edges[beyond].tolist(), strict=True))

    @cached_property
    def singular_ends(self) -> tuple[SingularEnd, ...]:
        """The ends at which the pressure is singular, ascending."""
        if not self.contact_y:
            return ()
        faces, length = ends(self.contact), float(np.ptp(self.edges))
        reached = self.contact_y[0][0], self.contact_y[-1][1]
        sharp = [
            limit
            for at, limit in zip(reached, self.contact.interval, strict=True)
            if abs(at - limit) <= SAME_PLACE * length
            and sum(end.image_weight for end in faces if abs(end.y - limit) < 0.5 * self.dy) < FINITE_FROM
        ]
        corners = corner_ends(self.contact, self.edges, self.largest_across, self.half_width)
        return singular_ends(sharp, corners, length)

    @property
    def shape(self) -> Shape:
        """Shape of the pressure across assumed for distant images and depths: Hertz's."""
        return HERTZ

    @cached_property
    def largest_across(self) -> Array:
        """Maximum pressure across the contact [MPa] at every ``y``."""
        return freeze(self.pressure.max(axis=0))

    @cached_property
    def extent_across(self) -> tuple[Array, Array]:
        """Middle of the footprint across and half of its extent [mm] at every ``y``, zero off contact."""
        touching = self.footprint.any(axis=0)
        first, last = self.x[self.footprint.argmax(axis=0)], self.x[::-1][self.footprint[::-1].argmax(axis=0)]
        middle, half = 0.5 * (first + last), 0.5 * (last - first + self.dx)
        return freeze(np.where(touching, middle, 0.0)), freeze(np.where(touching, half, 0.0))

    @property
    def symmetric_across(self) -> bool:
        """Whether the pressure is the same at x and at -x: with a user-given gap it need not be."""
        return False

    @cached_property
    def line_load(self) -> Array:
        """Load per unit length q [N/mm] at every ``y``."""
        return freeze(self.pressure.sum(axis=0) * self.dx)

    @cached_property
    def half_width(self) -> Array:
        """Half of the distance [mm] between the outermost edges of the footprint at every ``y``, zero off contact.

        Towards an edge the pressure falls as the square root of the distance, so its square falls linearly to zero. The
        line through the two outermost cells reaches zero slightly too early, since the last one also carries the
        pressure beyond it; the line through the next two slightly too late, since the square is curved. The mean of
        both is within a sixth of a cell for Hertz's ellipse. Where the square does not fall from cell to cell, or there
        are fewer than three, whole cells are counted.
        """
        return freeze(half_widths(self.pressure, self.dx))

    @cached_property
    def centre_pressure(self) -> Array:
        """Pressure on the line x = 0 [MPa] at every ``y``: a cubic through the four nearest cells."""
        if not self.x[0] <= 0.0 <= self.x[-1]:
            return freeze(np.zeros(self.y.size))
        middle = interpolation(-self.x[:1] / self.dx, self.x.size, 4)
        return freeze(np.maximum((middle @ self.pressure)[0], 0.0))

    def across(self, y: float) -> tuple[Array, Array]:
        """Return positions x [mm] and the pressures there [MPa] at a station y, linear between rows of cells.

        Raises
        ------
        InputError
            If ``y`` lies outside the region.
        """
        finite("y", y, "give a position along the contact in mm")
        low, high = self.edges[[0, -1]]
        if not low <= float(at_ends(y, (low, high))) <= high:
            condition = f"lie between {mm(low, high, between=' and '):g}"
            raise InputError("y", y, condition, "choose a station within the region")
        place = np.clip([(y - self.y[0]) / self.dy], 0.0, self.y.size - 1.0)
        return self.x, freeze(self.pressure @ interpolation(place, self.y.size, 2).toarray()[0])
