"""Finer strips than a solution has, for the field right below them.

The solution gives a load and a half-width at the centre of every strip. Between the strips they jump, which the
approach or the load do not feel, but a place does that lies nearer to the surface than a strip is wide. What the solver
solves for, the square of the half-width m = b^2 and r = q / b^2, is smooth, also where a contact runs out: there m
falls linearly to zero. So monotone cubics through both give the pressure between the centres, and each strip is cut
where it changes. The pressure at the centres stays what it is. The load does not to the last digit: to hold strips to
theirs would cost more at a run-out, where a strip bears for what lies beyond the contact, than it gains.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import PchipInterpolator

from nonhertz.solution import Solution

Array = NDArray[np.float64]
Integers = NDArray[np.int64]

# Pieces differ by so much, or are so narrow in half-widths, that the depth evens them out; at most so many a strip.
CHANGE, NARROW, MOST = 0.004, 0.06, 12
FEW = 4  # strips of a contact that all count
# Bounds to what the values of the last strip are continued to at a sharp end.
LOWEST, HIGHEST = 0.5, 2.0


@dataclass(frozen=True, eq=False)
class Lamination:
    """The strips in contact, and after them all their pieces.

    Attributes
    ----------
    low, high : ndarray, shape (strips + pieces,)
        Their ends [mm]. Where a contact runs out, its last strip ends with it.
    line_load, half_width : ndarray, shape (strips + pieces,)
        q [N/mm], and the half-width b [mm] of the semi-ellipse of that load.
    first : ndarray of int, shape (strips + 1,)
        Where the pieces of each strip begin.
    """

    low: Array
    high: Array
    line_load: Array
    half_width: Array
    first: Integers


def laminated(solution: Solution) -> Lamination:
    """Return the strips of a solution and their pieces.

    Parameters
    ----------
    solution : Solution
        A solved contact.

    Returns
    -------
    Lamination
        Strips out of contact are left out.
    """
    touching = np.flatnonzero(solution.line_load > 0.0)
    runs = np.split(touching, np.flatnonzero(np.diff(touching) > 1) + 1) if touching.size else []
    strips: list[tuple[Array, ...]] = [(np.empty(0),) * 4]
    pieces: list[tuple[Array, ...]] = [(np.empty(0),) * 4]
    counts: list[Integers] = [np.empty(0, dtype=np.int64)]
    for run, ends in zip(runs, solution.contact_y, strict=True):
        of_strips, of_pieces, count = _cut(solution, run, ends)
        strips.append(of_strips)
        pieces.append(of_pieces)
        counts.append(count)
    low, high, line_load, half_width = (np.concatenate(column) for column in zip(*strips, *pieces, strict=True))
    first = np.cumsum(np.concatenate([[touching.size], *counts]), dtype=np.int64)
    return Lamination(low, high, line_load, half_width, first)


def _cut(
    solution: Solution, run: Integers, ends: tuple[float, float]
) -> tuple[tuple[Array, ...], tuple[Array, ...], Integers]:
    """Return neighbours in contact between two ends, their pieces, and how many of these each has."""
    y, q, a = solution.y[run], solution.line_load[run], solution.half_width[run]
    edges = solution.edges[run[0] : run[-1] + 2].copy()
    runs_out = edges[[0, -1]] != ends
    edges[[0, -1]] = ends
    if run.size == 1:
        return (edges[:-1], edges[1:], q, a), (edges[:-1], edges[1:], q, a), np.ones(1, dtype=np.int64)
    # At a run-out the last strip is the least certain one: the contact may end anywhere in it.
    kept = np.ones(run.size, dtype=bool)
    if run.size > FEW:
        kept[[0, -1]] = ~runs_out
    square, ratio = (
        _between(y[kept], value[kept], edges, runs_out, there) for value, there in ((a**2, 0.0), (q / a**2, 1.0))
    )
    change = np.abs(np.diff(np.sqrt(np.maximum(square(edges), 0.0)) * ratio(edges))) / (q / a)
    count = np.clip(np.ceil(np.minimum(change / CHANGE, np.diff(edges) / (NARROW * a))), 1, MOST).astype(np.int64)
    strip = np.repeat(np.arange(run.size), count)
    width = (np.diff(edges) / count)[strip]
    low = edges[strip] + width * (np.arange(strip.size) - (np.cumsum(count) - count)[strip])
    # Neighbours share their edge to the last digit: a point must not fall between them.
    high = np.append(low[1:], edges[-1])
    centre = low + 0.5 * width
    load = ratio(centre) * square(centre)
    # A strip bears from afar what its pieces bear from near.
    of_strips = np.bincount(strip, load * (high - low)) / np.diff(edges)
    return (edges[:-1], edges[1:], of_strips, a), (low, high, load, np.sqrt(square(centre))), count


def _between(y: Array, value: Array, edges: Array, runs_out: NDArray[np.bool_], at_run_out: float) -> PchipInterpolator:
    """Return a positive quantity along neighbours in contact.

    Where they run out it ends with ``at_run_out`` times the value of the last strip, at a sharp end with what the last
    two strips lead to.
    """
    led = value[[0, -1]] + (edges[[0, -1]] - y[[0, -1]]) * (value[[0, -1]] - value[[1, -2]]) / (y[[0, -1]] - y[[1, -2]])
    bounded = np.clip(led, LOWEST * value[[0, -1]], HIGHEST * value[[0, -1]])
    low, high = np.where(runs_out, at_run_out * value[[0, -1]], bounded)
    return PchipInterpolator(np.concatenate([edges[:1], y, edges[-1:]]), np.concatenate([[low], value, [high]]))
