"""Where along the line strips and plane grid differ by more than 1 %, and the reasons found in the solutions.

Nothing about a case is known beforehand. Each possible reason is a question put to the solutions: is an end at which
the pressure has no limit, or at which the contact runs out, within a half-width; do semi-elliptic and parabolic strips
have different half-widths there; does the pressure vary steeply compared with strips and cells; is the pressure across
not a semi-ellipse; are the methods' own error estimates large.

A reason explains no more than its size: the difference that it can make at a strip, relative to the plane grid,
estimated without using the difference itself. Sizes of several reasons are bounds and not independent errors, so they
are simply added. A stretch is explained if at every one of its strips the sum is at least the difference.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nonhertz.comparison.value import (
    Flags,
    Reason,
    Stretch,
    differences,
    excess_of_moments,
    percent,
)
from nonhertz.patch.solution import PatchSolution
from nonhertz.result.ends import away_from_ends
from nonhertz.result.maximum import places_of_largest
from nonhertz.result.solution import EdgeKind, Solution

Array = NDArray[np.float64]
Indices = NDArray[np.intp]

NOTABLE = 0.01
LEAST = 1e-3  # of the pressure: smaller reasons are not given
UNLIKE = 0.005  # of the fourth moment: discretisation by cells alone changes that of a semi-ellipse by 0.001
# How far apart along y strips and cells may place the same pressure, in strips and in cells. Over 20 cases the
# largest shifts at run-outs were 0.04 strips with fine cells, and 0.38 cells with fine strips.
OF_STRIP, OF_CELL = 0.05, 0.4
# Of a parabola's bias in the half-width, to which that of the pressure is proportional (p0 = b / (2 K rho)) except
# where the contact runs out.
OF_WIDTH = 1.25
# Error of the pressure in the last cell at an end, relative to it if it has no limit there, and if it has, to how much
# it changes from the cell before; cells further inside have less.
OF_LAST_CELL = 0.1
# How much more the pressure may change from the middle of the last row of cells to the end than from the row before:
# where free faces of both bodies coincide it falls as s ln s, on cells of 0.7 half-widths 2.5 times as much.
STEEPENS = 2.5
BETWEEN = 0.25  # of the change between the last two rows: how far off a straight line between them may be
AT_CORNER = 0.5  # exponent where a contact ends at a corner: that of a sharp end, where the surface also bends away


@dataclass(frozen=True)
class _Cause:
    """A reason with its size at each strip of a place."""

    sentence: str
    sizes: Array


@dataclass(frozen=True)
class _Limitless:
    """An end of the contact at which the pressure has no limit."""

    y: float
    exponent: float
    correction: float
    correction_exponent: float
    half_width: float
    words: str

    def mean(self, distance: Array, width: Array | float) -> Array:
        """Return the mean of s^-alpha (1 + c s^beta) over a width about each distance s from the end."""
        first, second = -self.exponent, self.correction_exponent - self.exponent
        powers = _mean_of_power(distance, width, first), _mean_of_power(distance, width, second)
        return powers[0] + self.correction * powers[1]


@dataclass(frozen=True)
class _Place:
    """A group of strips that differ, and everything needed to find the reasons."""

    solution: Solution
    semi: Solution
    patch: PatchSolution
    members: Indices
    relative: Array

    @property
    def worst(self) -> int:
        return int(np.abs(self.differences).argmax())

    @property
    def differences(self) -> Array:
        return self.relative[self.members]

    @property
    def y(self) -> Array:
        return self.solution.y[self.members]

    @property
    def strip_width(self) -> Array:
        return self.solution.strip_width[self.members]

    @property
    def expected(self) -> Array:
        return np.interp(self.y, self.patch.y, self.patch.centre_pressure)

    @property
    def shift(self) -> Array:
        """Distance along y by which the methods may shift the same pressure [mm]."""
        return OF_STRIP * self.strip_width + OF_CELL * self.patch.dy

    @property
    def cells(self) -> Indices:
        """The rows of the plane grid that contain the middles of these strips."""
        cell = np.floor((self.y - self.patch.y[0]) / self.patch.dy + 0.5).astype(np.intp)
        within: Indices = np.clip(cell, 0, self.patch.y.size - 1)
        return within


def stretches(semi: Solution, parabola: Solution, patch: PatchSolution) -> tuple[Stretch, ...]:
    """Return every stretch of the line on which strips differ by more than 1 %, those of semi-elliptic strips first.

    Arguments are the solutions on semi-elliptic and parabolic strips and on the plane grid.
    """
    return tuple(
        _stretch(_Place(solution, semi, patch, members, relative))
        for solution in (semi, parabola)
        for relative in (differences(solution, patch),)
        for members in _groups(solution, relative)
    )


def _groups(solution: Solution, relative: Array) -> list[Indices]:
    """Return the strips that differ, grouped where less than a half-width apart.

    Strips within a half-width of a sharp end form separate groups.
    """
    found = np.flatnonzero(np.abs(np.nan_to_num(relative, nan=0.0)) > NOTABLE)
    if found.size == 0:
        return []
    apart = solution.edges[found[1:]] - solution.edges[found[:-1] + 1] > solution.max_half_width
    border = np.diff(away_from_ends(solution, solution.y[found]))
    return np.split(found, np.flatnonzero(apart | border) + 1)


def _stretch(place: _Place) -> Stretch:
    solution, worst = place.solution, place.worst
    causes = _causes(place)
    together = _together(causes, place)
    bounded = np.isfinite(together)
    short = np.where(bounded, np.maximum(np.abs(place.differences) - np.where(bounded, together, 0.0), 0.0), 0.0)
    decisive = int(short.argmax()) if short.any() else worst
    return Stretch(
        element=solution.element.name,
        low=float(solution.edges[place.members[0]]),
        high=float(solution.edges[place.members[-1] + 1]),
        largest=float(place.differences[worst]),
        at=float(place.y[worst]),
        reasons=tuple(
            Reason(cause.sentence, float(cause.sizes[decisive])) for cause in causes if cause.sizes[decisive] >= LEAST
        ),
        unexplained=float(short[decisive]),
        unexplained_at=float(place.y[decisive]),
    )


def carried(solution: Solution, semi: Solution, patch: PatchSolution, strips: Indices) -> Array:
    """Return the sum of the sizes of all reasons at adjacent strips, relative to the plane grid.

    Parameters
    ----------
    solution, semi : Solution
        The strips, and the semi-elliptic ones, which may be the same.
    patch : PatchSolution
        On the plane grid.
    strips : ndarray of int, shape (n,)
        Which strips.

    Returns
    -------
    ndarray, shape (n,)
    """
    place = _Place(solution, semi, patch, strips, differences(solution, patch))
    return _together(_causes(place), place)


def _causes(place: _Place) -> list[_Cause]:
    asked = (_limitless_end, _own_bias, _end_of_contact, _steep, _finite_end, _shape, _own_doubt, _doubt_of_grid)
    return [cause for ask in asked for cause in ask(place)]


def _together(causes: list[_Cause], place: _Place) -> Array:
    return sum((cause.sizes for cause in causes), np.zeros(place.members.size))


def _limitless_end(place: _Place) -> Iterator[_Cause]:
    """Yield how differently strips and cells represent a pressure that grows as a power of the distance from an end."""
    for end in _limitless_ends(place.solution):
        inwards = math.copysign(1.0, float(np.mean(place.solution.edges)) - end.y)
        distance = inwards * (place.y - end.y)
        near = (distance > 0.0) & (distance <= end.half_width)
        if not near.any():
            continue
        cells = inwards * (place.patch.y - end.y)
        of_cells = np.where(cells > 0.0, end.mean(cells, place.patch.dy), 0.0)
        of_strips = end.mean(distance, place.strip_width)
        expected = np.interp(place.y, place.patch.y, of_cells)
        ratio = np.divide(of_strips, expected, out=np.full(near.shape, np.inf), where=expected > 0.0)
        faded = np.minimum(place.patch.dy / np.where(near, distance, np.inf), 1.0)
        yield _Cause(
            f"It lies within {float(distance[near].max()) / end.half_width:.2g} half-widths of {end.words}, where the "
            f"pressure has no limit: strips of {float(place.strip_width[near].min()):.2g} mm and cells of "
            f"{place.patch.dy:.2g} mm bear different means of it",
            np.where(near, np.abs(ratio - 1.0) + OF_LAST_CELL * ratio * faded**2, 0.0),
        )


def _limitless_ends(solution: Solution) -> list[_Limitless]:
    """Return the sharp ends, and the corners of the profile at which the contact ends with rising pressure."""
    found = [
        _Limitless(
            edge.y,
            edge.exponent,
            edge.correction or 0.0,
            edge.correction_exponent,
            width,
            f"the sharp end at y = {edge.y:.5g} mm",
        )
        for edge, width in zip(solution.edge_pressure, solution.half_width[[0, -1]].tolist(), strict=True)
        if edge.kind is EdgeKind.SINGULAR
    ]
    touching = np.flatnonzero(solution.line_load > 0.0)
    for last, inner in (touching[:2], touching[:-3:-1]) if touching.size > 1 else ():
        rises = solution.centre_pressure[last] > solution.centre_pressure[inner]
        corner = _bend_beside(solution, int(last))
        if rises and corner is not None and all(abs(corner - end.y) > solution.strip_width[last] for end in found):
            words = f"the corner at y = {corner:.5g} mm, where the contact ends"
            found.append(_Limitless(corner, AT_CORNER, 0.0, 0.0, float(solution.half_width[inner]), words))
    return found


def _bend_beside(solution: Solution, strip: int) -> float | None:
    """Return the bend of the profile within a strip's width of a strip's middle, if there is one."""
    nearest = min(solution.contact.bends, key=lambda bend: abs(bend - solution.y[strip]), default=math.inf)
    return nearest if abs(nearest - solution.y[strip]) <= solution.strip_width[strip] else None


def _mean_of_power(distance: Array, width: Array | float, exponent: float) -> Array:
    """Return the mean of a power of the distance over a width around each; beyond the end it is zero."""
    rise = 1.0 + exponent
    low, high = np.maximum(distance - 0.5 * width, 0.0), np.maximum(distance + 0.5 * width, 0.0)
    mean: Array = (high**rise - low**rise) / (rise * width)
    return mean


def _own_bias(place: _Place) -> Iterator[_Cause]:
    """Yield how far a parabola's half-width is from that of semi-elliptic strips; its pressure is off in proportion."""
    if place.solution is place.semi:
        return
    from scipy.interpolate import PchipInterpolator

    # The square of the half-width is smooth up to where the contact runs out; straight lines between the strips would
    # be off by a share of the bias itself.
    of_semi = np.sqrt(PchipInterpolator(place.semi.y, place.semi.half_width**2)(place.y, extrapolate=False))
    of_semi = np.nan_to_num(of_semi, nan=0.0)
    own = place.solution.half_width[place.members]
    bias = np.abs(np.divide(own, of_semi, out=np.ones(own.size), where=of_semi > 0.0) - 1.0)
    median = float(np.median(bias))
    yield _Cause(
        f"It is the parabola's own: its half-width there is {percent(median)} off that of semi-elliptic strips in the "
        "median, and its pressure with it",
        OF_WIDTH * bias,
    )


def _end_of_contact(place: _Place) -> Iterator[_Cause]:
    """Yield the effect of a slightly shifted run-out: the pressure falls as the square root of the distance from it."""
    solution = place.solution
    near, distance, nearest = _run_out(place)
    if not near.any():
        return
    inside = np.maximum(distance - place.shift, 0.0)
    root = np.sqrt(np.divide(distance, inside, out=np.full(inside.shape, np.inf), where=inside > 0.0)) - 1.0
    # Close to it a curve through few strips or cells is inaccurate; farther away the pressure may have stopped rising.
    poorer, better = _shifted(place)
    sizes = np.minimum(root, np.where(distance > 2.0 * place.shift, better, poorer))
    away = float(distance[place.worst]) / solution.max_half_width
    yield _Cause(
        f"The contact runs out at y = {nearest:.5g} mm, {abs(away):.2g} half-widths from where they differ most, and "
        f"strips and cells may place that {float(place.shift.max()):.2g} mm apart",
        np.where(near, sizes, 0.0),
    )


def _run_out(place: _Place) -> tuple[Flags, Array, float]:
    """Return which strips are within a half-width of the nearest run-out, how far inside it all are, and its y."""
    solution = place.solution
    limitless = [end.y for end in _limitless_ends(solution)]
    kinds = {edge.y: edge.kind for edge in solution.edge_pressure}
    ends = [
        (end, side)
        for low, high in solution.contact_y
        for end, side in ((low, 1.0), (high, -1.0))
        if kinds.get(end, EdgeKind.RUN_OUT) is EdgeKind.RUN_OUT
        and all(abs(end - other) > place.patch.dy for other in limitless)
    ]
    none = np.zeros(place.y.size, dtype=bool)
    if not ends:
        return none, np.full(place.y.size, np.inf), math.nan
    end, side = min(ends, key=lambda each: abs(each[0] - place.y[place.worst]))
    distance = side * (place.y - end)
    return np.abs(distance) < solution.max_half_width, distance, end


def _steep(place: _Place) -> Iterator[_Cause]:
    """Yield how far the pressure is from a straight line over strips and cells, away from all ends."""
    free = ~_run_out(place)[0] & away_from_ends(place.solution, place.y)
    if free.any():
        yield _Cause(
            f"The pressure bends there within strips of {float(place.strip_width[free].max()):.2g} mm and cells of "
            f"{place.patch.dy:.2g} mm",
            np.where(free, _bent(place), 0.0),
        )


def _finite_end(place: _Place) -> Iterator[_Cause]:
    """Yield what rows of cells make of the strips' pressure near an end where it is finite.

    Near is within a half-width or two rows. Between rows the grid's pressure is a straight line, beyond the middle of
    the last it is that of the row.
    """
    patch, solution = place.patch, place.solution
    steps = np.abs(np.diff(patch.centre_pressure)[[0, -1]]).tolist()
    for edge, row, step in zip(solution.edge_pressure, patch.y[[0, -1]].tolist(), steps, strict=True):
        distance = np.abs(place.y - edge.y)
        near = distance <= max(solution.max_half_width, 2.0 * patch.dy)
        if edge.kind is not EdgeKind.FINITE or abs(edge.y - row) > patch.dy or not near.any():
            continue
        faded = np.minimum(patch.dy / np.maximum(distance, 0.5 * patch.dy), 1.0) ** 2
        missed = [
            np.abs(np.interp(place.y, patch.y, np.interp(patch.y, *one)) - np.interp(place.y, *one))
            for one in _curves(place)[1:]
        ]
        # No more than the grid's own slope allows: a step in the strips is the very thing to be explained.
        most = step * np.maximum(STEEPENS * (1.0 - 2.0 * distance / patch.dy), BETWEEN)
        change = np.minimum(np.min(missed, axis=0), most) + OF_LAST_CELL * step * faded
        sizes = np.divide(change, place.expected, out=np.zeros(near.shape), where=place.expected > 0.0)
        yield _Cause(
            f"It lies within {float(distance[near].max()):.2g} mm of the end at y = {edge.y:.5g} mm, towards which the "
            f"pressure goes on changing within the last row of cells of {patch.dy:.2g} mm",
            np.where(near, sizes, 0.0),
        )


def _bent(place: _Place) -> Array:
    """Return the deviation of the pressure from a straight line over a strip and a cell, by the straightest curve.

    That is an eighth of the second difference of a curve over the step; two methods may miss that much either way.
    """
    reach = 0.5 * place.strip_width + place.patch.dy
    bends = [
        0.25
        * np.abs(sum(weight * np.interp(place.y + by * reach, *curve) for by, weight in ((-1, 1), (0, -2), (1, 1))))
        for curve in _curves(place)
    ]
    size: Array = np.divide(
        np.min(bends, axis=0), place.expected, out=np.zeros(place.y.size), where=place.expected > 0.0
    )
    return size


def _curves(place: _Place) -> list[tuple[Array, Array]]:
    """Return the pressures along y of all solutions.

    A step in only one of them is not a steep pressure but the very thing to be explained.
    """
    strips = [(one.y, one.centre_pressure) for one in (place.solution, place.semi)]
    return [(place.patch.y, place.patch.centre_pressure), *strips]


def _shifted(place: _Place) -> tuple[Array, Array]:
    """Return the change of the pressure by a shift along y, by the steepest and the least steep of the solutions.

    Where either method has no contact, the first is infinite and the second zero.
    """
    ways = -place.shift, place.shift
    changes = [
        np.max([np.abs(np.interp(place.y + by, *curve) - np.interp(place.y, *curve)) for by in ways], axis=0)
        for curve in _curves(place)
    ]
    both = (place.expected > 0.0) & (place.solution.line_load[place.members] > 0.0)
    steepest, flattest = (
        np.divide(change, place.expected, out=np.full(change.size, np.inf), where=both)
        for change in (np.max(changes, axis=0), np.min(changes, axis=0))
    )
    return steepest, np.where(both, flattest, 0.0)


def _shape(place: _Place) -> Iterator[_Cause]:
    """Yield how much the pressure across differs from a semi-ellipse with the same load and second moment."""
    fourth, peak = (each[place.cells] for each in excess_of_moments(place.patch))
    unlike = np.isfinite(fourth) & (np.abs(np.nan_to_num(fourth)) > UNLIKE)
    if unlike.any():
        worst = float(fourth[unlike][np.abs(fourth[unlike]).argmax()])
        yield _Cause(
            f"Across, the pressure is no semi-ellipse there: its fourth moment is {percent(abs(worst))} "
            f"{'above' if worst > 0.0 else 'below'} that of one with its load and second moment, and its peak is off",
            np.where(unlike, np.abs(np.nan_to_num(peak)), 0.0),
        )


def _own_doubt(place: _Place) -> Iterator[_Cause]:
    own = place.solution.error_estimate
    doubt = max(own.approach, own.load)
    if math.isfinite(doubt):
        yield _Cause("The strips are few for this contact by their own estimate", np.full(place.y.size, doubt))


def _doubt_of_grid(place: _Place) -> Iterator[_Cause]:
    patch = place.patch
    doubt = patch.error_estimate.max_pressure
    here = np.any([np.abs(place.y - y) <= 2.0 * patch.dy for y in places_of_largest(patch)], axis=0)
    if here.any() and math.isfinite(doubt):
        yield _Cause("The plane grid doubts its own maximum, which is here", np.where(here, doubt, 0.0))
