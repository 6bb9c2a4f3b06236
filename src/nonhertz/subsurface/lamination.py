"""Subdividing the strips of a solution, for the field close below them.

The solution gives a load q and a half-width b at the centre of every strip. Between strips they jump, which hardly
affects approach or load, but does affect a point closer to the surface than a strip is wide. The unknowns of the
solver, m = b^2 and r = q / b^2, are smooth even where a contact runs out: there m falls linearly to zero. So monotone
cubics (PCHIP) through the centres give both at the edges between strips. At either end of a contact they are
extrapolated linearly from the last two centres to the edge of the last strip, m limited to between zero and twice, r to
between half and twice the last value: m is near zero at a run-out, but not at a side face or a corner of the profile.
Within a strip, t from -1 to 1, load and m follow

    q(t) / q = 1 + alpha t + epsilon t^2 (5 t^2 - 3) / 2

with the values of the cubics at both edges, that of the solution at the centre, and the load of the strip: the last
term has zero mean. Where it would be negative, alpha and epsilon are reduced together until it is not.

Where a contact runs out, in the last strip or short of the centre of the next one, the load falls linearly through
the last centre to zero there. Such a line carries a different load from the strip, because to the solver a strip
touches over its whole length or not at all. The line is followed only as far as all ends together add no more than
LOAD_SHARE of the load and MOMENT_SHARE of the moment; all loads are then scaled to the sum over the strips.

Finer strips would also have the moment that alpha adds about the centre of a strip. Where strips are so coarse that it
exceeds MOMENT_SHARE, all alphas are reduced. No piece has a higher pressure than the centre or the edges of its strip.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from nonhertz.result.solution import Solution

Array = NDArray[np.float64]
Integers = NDArray[np.int64]
Columns = tuple[Array, Array, Array, Array]  # low, high, line load, half-width

# Pieces are divided until they differ by at most CHANGE, or are at most NARROW half-widths long, so that their steps
# are smoothed out with depth; at most MOST per strip. Odd numbers, so that a piece is centred on the strip.
CHANGE, NARROW, MOST = 0.003, 0.06, 129
STEEPER = 3.0  # weight of the curved part, which is steeper at the edge than its change from the centre suggests
SAMPLES = 53  # along a strip, to check where its load would be negative
HIGHEST, LOWEST_RATIO = 2.0, 0.5  # of the last value: limits for extrapolating m and r to an end of the contact
LEAST_SQUARE = 1e-4  # of the m of a strip: a narrower piece carries a negligible load
BEYOND = 5  # pieces between the last strip and where the contact runs out
LOAD_SHARE = 2e-4  # of the load
# Over the load times half the length of the contact: the moment that slopes may add, and the total error allowed.
MOMENT_SHARE, MOMENT_TOLERANCE = 2.5e-4, 1e-3
ROUNDING = 1e-9


class Lamination(NamedTuple):
    """The strips in contact, followed by all their pieces.

    Attributes
    ----------
    low, high : ndarray, shape (strips + pieces,)
        Ends of strips and pieces [mm]. A strip beyond whose end the contact runs out extends to the run-out.
    line_load, half_width : ndarray, shape (strips + pieces,)
        q [N/mm], and the half-width b [mm] of the semi-ellipse of that load.
    first : ndarray of int, shape (strips + 1,)
        Index of the first piece of each strip.
    """

    low: Array
    high: Array
    line_load: Array
    half_width: Array
    first: Integers


@dataclass(frozen=True, eq=False)
class LoadedStrips:
    """Strips in contact, and the values at their edges interpolated from their neighbours.

    Attributes
    ----------
    low, high, line_load, half_width : ndarray, shape (strips,)
        As in `Lamination`.
    load_edges, square_edges : ndarray, shape (2, strips)
        Load and m at the low and at the high edge, over the values at the centre.
    run_out : ndarray, shape (strips,)
        Position t where the contact runs out; infinite where it does not.
    """

    low: Array
    high: Array
    line_load: Array
    half_width: Array
    load_edges: Array
    square_edges: Array
    run_out: Array

    @classmethod
    def of(cls, solution: Solution) -> LoadedStrips:
        """Return the strips of a solution that are in contact."""
        touching = np.flatnonzero(solution.line_load > 0.0)
        runs = np.split(touching, np.flatnonzero(np.diff(touching) > 1) + 1)
        square, ratio = solution.half_width**2, np.zeros_like(solution.line_load)
        ratio[touching] = solution.line_load[touching] / square[touching]
        m, r = (
            np.concatenate([_at_edges(solution, run, values, least) for run in runs], axis=1)
            for values, least in ((square, 0.0), (ratio, LOWEST_RATIO))
        )
        run_out = np.concatenate(
            [_run_outs(solution, *stretch) for stretch in zip(runs, solution.contact_y, strict=True)]
        )
        low, high = solution.edges[:-1][touching], solution.edges[1:][touching]
        return cls(low, high, solution.line_load[touching], solution.half_width[touching], m * r, m, run_out)

    @cached_property
    def load(self) -> Array:
        """Load of each strip [N]."""
        return self.line_load * (self.high - self.low)

    @cached_property
    def added(self) -> Array:
        """Load [N] by which the line to the run-out exceeds the load of the strip."""
        t = self.falling_to
        return self.load * np.nan_to_num((1.0 - t) ** 2 / (4.0 * t))

    @cached_property
    def turned(self) -> Array:
        """Moment [N mm] about the centre of the strip of the line to the run-out."""
        t = self.falling_to
        return self.load * (self.high - self.low) * np.nan_to_num((1.0 + t) ** 2 * (2.0 - t) / (24.0 * t))

    @property
    def falling_to(self) -> Array:
        """Distance from the centre to the run-out, in half strips; NaN where there is none."""
        return np.where(np.isfinite(self.run_out), np.abs(self.run_out), np.nan)

    @cached_property
    def pressure_edges(self) -> Array:
        """Pressure at the low and at the high edge, over that at the centre."""
        return self.load_edges / np.sqrt(np.maximum(self.square_edges, LEAST_SQUARE))

    @property
    def unit_of_moment(self) -> float:
        """Load times half the length [N mm]."""
        return 0.5 * float(self.load.sum()) * float(self.high[-1] - self.low[0])


def laminate(solution: Solution) -> Lamination:
    """Return the strips of a solution and their pieces, which together carry its load.

    Parameters
    ----------
    solution : Solution
        A solved contact.

    Returns
    -------
    Lamination
        Strips out of contact are left out.
    """
    if not np.any(solution.line_load > 0.0):
        nothing = np.empty(0)
        return Lamination(nothing, nothing, nothing, nothing, np.zeros(1, dtype=np.int64))
    strips = LoadedStrips.of(solution)
    with np.errstate(over="ignore", invalid="ignore"):  # the result is checked
        lamination = cut_into_pieces(strips)
    if carries_load(lamination, strips):
        return lamination
    each_one = (strips.low, strips.high, strips.line_load, strips.half_width)
    return _join(each_one, each_one, np.arange(strips.low.size + 1))


def carries_load(lamination: Lamination, strips: LoadedStrips) -> bool:
    """Return whether the pieces are valid and carry the load of the strips and, within tolerance, their moment."""
    low, high, line_load, half_width = (
        values[lamination.first[0] :]
        for values in (lamination.low, lamination.high, lamination.line_load, lamination.half_width)
    )
    valid = np.isfinite(half_width) & (half_width > 0.0) & (line_load >= 0.0) & (high > low)
    load = line_load * (high - low)
    whole, middle = float(strips.load.sum()), 0.5 * (strips.low[0] + strips.high[-1])
    moment = load @ (0.5 * (low + high) - middle) - strips.load @ (0.5 * (strips.low + strips.high) - middle)
    return bool(
        np.all(valid)
        and abs(load.sum() - whole) <= ROUNDING * whole
        and abs(moment) <= MOMENT_TOLERANCE * strips.unit_of_moment
    )


def _at_edges(solution: Solution, run: Integers, values: Array, least: float) -> Array:
    """Return a quantity at the low and high edges of a run of strips in contact, over its values at their centres."""
    y, value, edges = solution.y[run], values[run], solution.edges[run[0] : run[-1] + 2]
    if run.size == 1:
        return np.ones((2, 1))
    inwards = np.array([1, -2])
    slope = (value[inwards] - value[[0, -1]]) / (y[inwards] - y[[0, -1]])
    led = value[[0, -1]] + slope * (edges[[0, -1]] - y[[0, -1]])
    low, high = np.clip(led, least * value[[0, -1]], HIGHEST * value[[0, -1]])
    places = np.concatenate([edges[:1], y, edges[-1:]])
    from scipy.interpolate import PchipInterpolator

    curve = PchipInterpolator(places, np.concatenate([[low], value, [high]]))
    at_edges = np.maximum(curve(edges), 0.0)  # rounding at a run-out
    return np.stack([at_edges[:-1], at_edges[1:]]) / value


def _run_outs(solution: Solution, run: Integers, ends: tuple[float, float]) -> Array:
    """Return the t at which a run of strips in contact runs out; infinite for the strips in the middle.

    An end at the edge of a strip is not a run-out, nor is one at the centre of the next: there the surfaces separate
    without m having vanished.
    """
    run_outs = np.full(run.size, np.inf)
    for at, end, outwards in ((0, ends[0], -1), (-1, ends[1], 1)):
        edge = solution.edges[run[at] + (outwards > 0)]
        beyond = run[at] + outwards
        limit = solution.y[beyond] if 0 <= beyond < solution.y.size else edge
        if run.size > 1 and end not in {edge, limit, solution.y[run[at]]}:
            run_outs[at] = (end - solution.y[run[at]]) / (0.5 * solution.strip_width[run[at]])
    return run_outs


def cut_into_pieces(strips: LoadedStrips) -> Lamination:
    """Return the strips and their pieces."""
    strip, begin, end = _divide(strips)
    load, square = _means(strips, strip, begin, end)
    # Fraction to which lines to run-outs are followed: fully, or less if they add too much load or moment.
    added = float(strips.added.sum()) / (LOAD_SHARE * float(strips.load.sum()))
    turned = float(strips.turned.sum()) / (MOMENT_SHARE * strips.unit_of_moment)
    line, followed = _fall_to_edge(strips.run_out[strip], begin, end), 1.0 / max(1.0, added, turned)
    on_line = np.isfinite(strips.run_out[strip])
    load, square = (np.where(on_line, followed * line + (1.0 - followed) * values, values) for values in (load, square))
    highest = np.where(on_line, np.inf, np.maximum(strips.pressure_edges.max(axis=0), 1.0)[strip])
    square = np.maximum(square, np.maximum((load / highest) ** 2, LEAST_SQUARE))
    low, high = _places(strips, strip, begin), _places(strips, strip, end)
    first = np.append(np.flatnonzero(np.diff(strip, prepend=-1)), strip.size)
    total = float(strips.load.sum())
    borne = strips.line_load[strip] * load * (total / (total + followed * float(strips.added.sum())))
    # A strip in the far field carries the same load as its pieces in the near field.
    ends = low[first[:-1]], high[first[1:] - 1]
    whole = np.add.reduceat(borne * (high - low), first[:-1]) / (ends[1] - ends[0])
    of_strips, of_pieces = (
        (*ends, whole, strips.half_width),
        (low, high, borne, strips.half_width[strip] * np.sqrt(square)),
    )
    return _join(of_strips, of_pieces, first)


def _join(of_strips: Columns, of_pieces: Columns, first: Integers) -> Lamination:
    """Return strips, then pieces; ``first`` counts only the pieces."""
    low, high, line_load, half_width = (np.concatenate(pair) for pair in zip(of_strips, of_pieces, strict=True))
    return Lamination(low, high, line_load, half_width, first + first.size - 1)


def _divide(strips: LoadedStrips) -> tuple[Integers, Array, Array]:
    """Return the strip of each piece, and the t at which it begins and ends."""
    edges = np.stack([strips.pressure_edges, strips.load_edges])
    # The curved part is steepest at the edges.
    change = (np.abs(edges - 1.0).sum(axis=1) + STEEPER * np.abs(edges.sum(axis=1) - 2.0)).max(axis=0)
    required = np.minimum(change / CHANGE, (strips.high - strips.low) / (NARROW * strips.half_width))
    # If the contact ran out within the middle piece, that piece would not have the load of the centre.
    required = np.maximum(required, np.nan_to_num(1.0 / strips.falling_to))
    count = np.clip(np.ceil(required), 1, MOST).astype(np.int64) | 1
    cuts = [np.linspace(-1.0, 1.0, n + 1) for n in count]
    for k in np.flatnonzero(np.isfinite(strips.run_out) & (np.abs(strips.run_out) > 1.0 + ROUNDING)):
        beyond = np.linspace(np.sign(strips.run_out[k]), strips.run_out[k], BEYOND + 1)[1:]
        cuts[k] = np.sort(np.concatenate([cuts[k], beyond]))
    strip = np.repeat(np.arange(count.size), [cut.size - 1 for cut in cuts])
    return strip, np.concatenate([cut[:-1] for cut in cuts]), np.concatenate([cut[1:] for cut in cuts])


def _places(strips: LoadedStrips, strip: Integers, t: Array) -> Array:
    """Return the positions [mm] where pieces begin or end.

    Neighbours share their edges to the last digit, so that no point falls between them.
    """
    low, high = strips.low[strip], strips.high[strip]
    return np.where(t == -1.0, low, np.where(t == 1.0, high, 0.5 * (low + high) + t * (0.5 * (high - low))))


def _means(strips: LoadedStrips, strip: Integers, begin: Array, end: Array) -> tuple[Array, Array]:
    """Return the means of load and m over pieces, relative to their strips, interpolated from the edges."""
    (slope, bend), (square_slope, square_bend) = (
        (0.5 * (high - low), 0.5 * (high + low) - 1.0) for low, high in (strips.load_edges, strips.square_edges)
    )
    t = np.linspace(-1.0, 1.0, SAMPLES)[:, None]
    lowest = np.min(slope * t + bend * t**2 * (2.5 * t**2 - 1.5), axis=0)
    bends = 1.0 / np.maximum(1.0, -lowest)
    moment = abs(float(np.sum(strips.load * bends * slope * (strips.high - strips.low)))) / 6.0
    allowed = MOMENT_SHARE * strips.unit_of_moment
    slopes = bends * (allowed / moment if moment > allowed else 1.0)
    along, curved = 0.5 * (begin + end), _curve_loads(begin, end)
    load = (slopes * slope)[strip] * along + (bends * bend)[strip] * curved
    square = (slopes * square_slope)[strip] * along + (bends * square_bend)[strip] * curved
    within = np.abs(along) <= 1.0
    # Between the samples it may still be slightly negative.
    lowest = np.minimum.reduceat(np.where(within, load, 0.0), np.flatnonzero(np.diff(strip, prepend=-1)))
    share = (1.0 / np.maximum(1.0, -lowest))[strip]
    load, square = (np.where(within, np.maximum(1.0 + share * values, 0.0), 0.0) for values in (load, square))
    return load, square


def _curve_loads(begin: Array, end: Array) -> Array:
    """Return the means of t^2 (5 t^2 - 3) / 2 over pieces, but zero for the middle piece.

    The mean of the middle piece is distributed over the others: the sum remains zero, and the pressure at the centre
    equals that of the solution.
    """
    count = np.maximum(np.round(2.0 / (end - begin)), 1.0)
    middle = np.abs(begin + end) < ROUNDING
    mean = 0.5 * (end**5 - begin**5 - end**3 + begin**3) / (end - begin)
    of_middle = 0.5 / count**4 - 0.5 / count**2
    return np.where(middle, 0.0, mean + of_middle / np.maximum(count - 1.0, 1.0))


def _fall_to_edge(run_out: Array, begin: Array, end: Array) -> Array:
    """Return the means over pieces of a line from 1 at the centre to 0 at the run-out."""
    first = np.where(run_out < 0.0, np.maximum(begin, run_out), begin)
    last = np.where(run_out > 0.0, np.minimum(end, run_out), end)
    return np.asarray(np.maximum(last - first, 0.0) * (1.0 - 0.5 * (first + last) / run_out) / (end - begin))
