"""The search for the region of an unknown contact: where to start, what to refuse, and how to verify the result.

It solves coarsely and adjusts the region to the result: a region that the contact fills to its border is extended by
its own length on that side, one that is mostly empty is cut down to the cells in contact; a solve on a thousand cells
costs very little. For a prescribed approach the start is the undeformed overlap (`nonhertz.patch.nearness`): where no
cell touches, the contact is smaller than a cell, and the region shrinks about its lowest point.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from concurrent.futures import Executor
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import mm
from nonhertz.bodies.shape import HERTZ
from nonhertz.errors import InputError
from nonhertz.model.contact import Contact
from nonhertz.model.prescription import Prescription
from nonhertz.patch import nearness
from nonhertz.patch.cascade import Outcome, PatchProblem, refuse_beyond, solve_on
from nonhertz.patch.features import Dent
from nonhertz.patch.grid import Grid, widest_run
from nonhertz.patch.nearness import Lowest, Overlap, Window
from nonhertz.result.checks import LEAST_OF_ALL, refuse_thin_bodies
from nonhertz.result.status import Status

Array = NDArray[np.float64]

CELLS, ROUGHLY = (24, 48), 1e-3  # of the coarse solves, and their tolerance
FILLED = 0.75  # fraction of each side of a suitable region that is in contact
MOST_MOVES, MOST_FAILURES = 60, 3
CLOSER = 0.25  # of a region in which no cell touches
MOST_SOLVES, ENLARGEMENT = 16, 0.15
EMPTY = 0.6  # fraction of a side of an enlarged region: with less than this in contact it is cut down, once
LEAST_GUESS, MOST_GUESS = 1e-3, 0.1  # of the radius: bounds on the first half-width where no load is given
MOST_RADII = 30.0  # that a region may extend to either side: far beyond the size of any body
FLAT_REACH = 1e4  # mm, for gaps of bodies without a radius
LEAST_RUN = 6  # cells
DIGITS = 12  # of an approach at which bodies begin to touch


@dataclass(frozen=True, eq=False)
class Search:
    """The search for a region, and the problem that it works on."""

    problem: PatchProblem

    @property
    def contact(self) -> Contact:
        """The bodies."""
        return self.problem.contact

    @property
    def prescribed(self) -> Prescription:
        """The prescribed load or approach, and tilt or moment."""
        return self.problem.prescribed

    @property
    def tilt(self) -> float:
        """The prescribed tilt [rad], zero if there is none."""
        return self.prescribed.tilt or 0.0

    @property
    def gap_given(self) -> bool:
        """Whether the gap is a user function rather than the bodies' own."""
        return self.problem.gap.gap is not None

    @property
    def reach(self) -> float:
        """Distance from the line x = 0 up to which the surfaces are sampled [mm]."""
        return FLAT_REACH if self.gap_given else self.radius

    @property
    def radius(self) -> float:
        """The combined radius in the middle of the bodies [mm], infinite if they are flat or conforming."""
        y = np.clip(0.0, *self.contact.interval)
        curvature = float(self.contact.a.curvature(y) + self.contact.b.curvature(y))
        return 1.0 / curvature if curvature > 0.0 else math.inf

    @property
    def own_gap(self) -> bool:
        """Whether the gap is that of the bodies with dents only, and so has no unknown bumps."""
        return not self.gap_given and all(isinstance(feature, Dent) for feature in self.problem.gap.features)

    def windows(self, grid: Grid | None = None) -> Iterator[Window]:
        """Yield windows in which the gap is sampled: along the bodies, and around the region if it may have bumps.

        Without a grid, these are the windows in which a contact is searched first.
        """
        width, interval = self.width(), self.contact.interval
        yield from nearness.windows(self.problem.gap, width, self.reach)
        if self.own_gap:
            return
        if grid is None:
            low, high = map(float, np.clip((-width, width), *interval))
            grid = Grid((-width, width), (low, high) if low < high else interval, CELLS, interval)
        yield from nearness.scan(grid, (min(self.reach, FLAT_REACH), FLAT_REACH))

    def width(self) -> float:
        """Return a first guess of the half-width [mm]: that of a Hertz line contact where the bodies define one."""
        radius, (low, high) = self.radius, self.contact.interval
        load, approach = self.prescribed.load, self.prescribed.approach
        if approach is not None:
            scale = min(radius, FLAT_REACH)
            guess = math.sqrt(2.0 * scale * abs(approach))
            return min(max(guess, LEAST_GUESS * scale), MOST_GUESS * scale)
        assert load is not None
        if not math.isfinite(radius):
            return self._width_of_gap(load)
        if math.isfinite(high - low):
            return 2.0 * math.sqrt(self.contact.compliance * load / (high - low) * radius)
        return math.cbrt(self.contact.compliance * load * radius)

    def _width_of_gap(self, load: float) -> float:
        """Return the distance from its lowest point at which the gap has risen by the indentation under the load."""
        lowest = self._lowest(nearness.windows(self.problem.gap, 1.0, self.reach))
        away = np.geomspace(1e-6, FLAT_REACH, 200)
        x, y = lowest.x + np.concatenate([-away, away]), np.clip(lowest.y, *self.contact.interval)
        across = self.problem.gap(x[:, None], np.array([[y]]))[:, 0].reshape(2, -1).min(axis=0) - self.tilt * y
        pressed = self.contact.compliance * load / away
        return float(away[int(np.argmax(across - lowest.value > pressed))])

    def _lowest(self, windows: Iterable[Window]) -> Lowest:
        return nearness.find_lowest(self.problem.gap, self.tilt, windows)

    def refuse_apart(self, windows: tuple[Window, ...]) -> Lowest:
        """Return the point where the bodies are closest, after refusing an approach at which nothing touches.

        Raises
        ------
        InputError
        """
        lowest = self._lowest(windows)
        needed, approach = lowest.value, self.prescribed.approach
        if self.prescribed.moment is not None:
            # Tilting can produce any nonzero moment, but zero moment needs an approach at which no tilt separates them.
            needed = (
                -math.inf
                if self.prescribed.moment != 0.0
                else nearness.least_closing_approach(self.problem.gap, windows[0])
            )
        needed = round(needed, DIGITS) + 0.0 if math.isfinite(needed) else needed
        if approach is not None and approach <= needed:
            condition = f"exceed {mm(needed):.6g}, where the bodies begin to touch"
            raise InputError("approach", approach, condition, "raise it, or prescribe the load")
        return lowest

    def found(self, cells: tuple[int, int], tolerance: float, pool: Executor | None) -> tuple[Outcome, Overlap | None]:
        """Find a region and solve in it, enlarging it where the contact extends further.

        Returns
        -------
        Outcome
        Overlap or None
            An overlap that could not be included.
        """
        windows, arm = tuple(self.windows()), self.prescribed.arm
        grid, towards = self._start(windows)
        if not self.own_gap:
            rows, ends = nearness.finite_rows(self.problem.gap, windows)
            bearing = float(rows[0]), float(rows[-1])
            where = "where the gap is finite"
            refuse_beyond(self.prescribed, ends, where, "give the region of the contact", bearing)
            if arm is not None:
                # Otherwise the search may end with a contact on only one side of the moment's lever arm.
                at = int(np.searchsorted(rows, arm))
                low, high = float(rows[max(at - 1, 0)]), float(rows[min(at, rows.size - 1)])
                grid = grid.joined(grid.x_span, (1.5 * low - 0.5 * high, 1.5 * high - 0.5 * low))
        self._refuse_spans(grid)
        grid = replace(self._roughly(grid, towards), cells=cells)
        enlarged = shrunk = False
        for _ in range(MOST_SOLVES):
            outcome = solve_on(self.problem, grid, tolerance, pool)
            touching = outcome.state.pressure > 0.0
            cut, overlap = grid.cut(touching), None
            if np.any(cut):
                self._refuse_huge(outcome)
                grid = grid.widened(cut, ENLARGEMENT)
                continue
            overlap = nearness.find_overlap(self.problem, outcome, self.windows(grid), smooth=self.own_gap)
            if overlap is not None:
                grid, enlarged = grid.joined(overlap.x_span, overlap.y_span), True
                continue
            if not enlarged or shrunk or not touching.any() or grid.filled(touching) >= EMPTY:
                break
            # Only once: other cells may miss a small contact, which is then found again outside the region.
            grid, shrunk = grid.around(touching), True
        return outcome, overlap

    def _roughly(self, grid: Grid, towards: tuple[float, float]) -> Grid:
        """Return the region of the contact, with a small margin where it does not end with the bodies.

        ``towards`` is the point x, y [mm] to zoom in on if no cell touches.
        """
        failures = 0
        for _ in range(MOST_MOVES):
            outcome = solve_on(self.problem, grid, ROUGHLY, rough=True)
            touching = outcome.state.pressure > 0.0
            failures = 0 if outcome.state.status is Status.CONVERGED else failures + 1
            if failures == MOST_FAILURES:
                break
            if not touching.any():
                halves = 0.5 * CLOSER * np.ptp(grid.x_span), 0.5 * CLOSER * np.ptp(grid.y_span)
                grid = grid.over([(at - half, at + half) for at, half in zip(towards, halves, strict=True)])
                continue
            cut = grid.cut(touching)
            if np.any(cut):
                self._refuse_huge(outcome)
                # Not cut down at the same time: the contact will change once the region no longer cuts it.
                grid = grid.widened(cut, 1.0)
                continue
            done = grid.filled(touching) >= FILLED
            grid = grid.around(touching)
            if done:
                break
        return grid

    def _start(self, windows: tuple[Window, ...]) -> tuple[Grid, tuple[float, float]]:
        """Return a grid to begin with, and the point to zoom in on."""
        low, high = interval = self.contact.interval
        width, approach = self.width(), self.prescribed.approach
        if approach is not None:
            at = self.refuse_apart(windows)
            if self.prescribed.moment is None:
                spans = nearness.extent(self.problem.gap, self.tilt, approach, at, windows)
                return Grid(*spans, CELLS, interval), (at.x, at.y)
        middle, across = float(np.clip(self.prescribed.arm or 0.0, low, high)), 0.0
        if not math.isfinite(self.radius) or not np.isfinite(
            self.problem.gap(np.zeros((1, 1)), np.full((1, 1), middle))
        ):
            at = self._lowest(windows)
            across, middle = at.x, at.y if self.prescribed.moment is None else middle
        bounded = math.isfinite(high - low)
        y_span = interval if bounded else (max(low, middle - 10.0 * width), min(high, middle + 10.0 * width))
        return Grid((across - 2.0 * width, across + 2.0 * width), y_span, CELLS, interval), (across, middle)

    def _refuse_huge(self, outcome: Outcome) -> None:
        """Refuse a contact that is wider than the bodies, or unbounded.

        Raises
        ------
        InputError
        """
        grid = outcome.grid
        run = widest_run(outcome.state.pressure > 0.0)
        # The width of a contact only a few cells wide is not resolved.
        if run.max() >= LEAST_RUN:
            refuse_thin_bodies(self.contact, HERTZ, grid.y, 0.5 * grid.dx * run, LEAST_OF_ALL, self.prescribed.pressed)
        self._refuse_spans(grid)

    def _refuse_spans(self, grid: Grid) -> None:
        x_most = FLAT_REACH if self.gap_given else MOST_RADII * self.radius
        y_most = max(FLAT_REACH, 1e3 * x_most)
        wide, long = np.ptp(grid.x_span) > 2.0 * x_most, np.ptp(grid.y_span) > 2.0 * y_most
        if (wide or long) and self.gap_given:
            condition = f"rise away from the contact, which is over {mm(x_most if wide else y_most):.3g} wide"
            remedy = "let it rise in both directions, or give a region to solve in"
            raise InputError("gap", self.problem.gap.gap, condition, remedy)
        if long:
            remedy = "give one of the bodies a length, or a profile that falls away"
            raise InputError("length", None, "be given where nothing else ends the contact", remedy)
        if wide:
            condition = f"keep the contact narrower than {MOST_RADII:g} radii of the bodies"
            raise InputError(*self.prescribed.pressed, condition, "reduce it")
