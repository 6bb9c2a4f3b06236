"""What happens between the strip centres, where a solution does not look.

Contact conditions are enforced only at strip centres. A profile that is rough within a strip, or an overlap off the
centre of a wide strip out of contact, shows in none of them, nor in a comparison with coarser grids, which sample even
fewer places. So the bodies are sampled again: at several places within each strip in contact, for how far the
separation departs from a parabola; and along the whole bodies, including every crest of the profiles, for overlaps
where no strip is in contact.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nonhertz.strip.influence import displacements
from nonhertz.strip.state import Problem, State

Array = NDArray[np.float64]

SAMPLES = 600  # along the bodies
WITHIN = 9  # places in a strip
BESIDE = 0.02  # of an interval in contact: an overlap this close to it only shows where the contact ends
NOTICED = 1e-9  # of the deepest interference; a smaller overlap is rounding
_PLACES = (np.arange(WITHIN) + 0.5) / WITHIN - 0.5
_PARABOLA = np.linalg.qr(np.vander(_PLACES, 3))[0]


def within(problem: Problem, edges: Array) -> tuple[Array, Array]:
    """Return places within each strip and the separation there, shape (strips, places) each."""
    y = 0.5 * (edges[1:] + edges[:-1])[:, None] + np.diff(edges)[:, None] * _PLACES
    return y, problem.separation(y.ravel()).reshape(y.shape)


def departures(separation: Array) -> Array:
    """Return the root mean square departure of the separation `within` each strip from a parabola [mm].

    Zero where the separation is infinite in part of a strip, where it is undefined.
    """
    finite = np.all(np.isfinite(separation), axis=1)
    h = np.where(finite[:, None], separation, 0.0)
    left = h - (h @ _PARABOLA) @ _PARABOLA.T
    departure: Array = np.sqrt(np.mean(left**2, axis=1))
    return departure


def roughness(departure: Array, width: Array, load: Array) -> tuple[Array, Array]:
    """Return the roughness that strips do not resolve, for one case or many.

    Parameters
    ----------
    departure, width : ndarray, shape (strips,)
        See `departures`; widths [mm].
    load : ndarray, shape (..., strips)
        Load of each strip, in any unit.

    Returns
    -------
    tuple of ndarray, shape (...), and ndarray, shape (strips,)
        Mean over the contact [mm], each strip weighted by its load; and the pressure ripple needed to flatten each
        strip, as K q / a. A wave of amplitude A and length l takes pi E* A / l = A / (K l), and within a strip l is at
        most the strip's width.
    """
    mean = load @ departure / np.sum(load, axis=-1)
    # q / a is pi / 2 times the pressure.
    return mean, 0.5 * np.pi * np.sqrt(2.0) * departure / width


def _summits(y: Array, depth: Array) -> Array:
    """Return the vertices of parabolas through three neighbouring places each, where they are deeper than zero."""
    left, here, right = depth[:-2], depth[1:-1], depth[2:]
    at = np.flatnonzero((here >= left) & (here > right) & np.isfinite(left) & np.isfinite(right)) + 1
    before, after = ((depth[to] - depth[of]) / (y[to] - y[of]) for of, to in ((at - 1, at), (at, at + 1)))
    bend = (after - before) / (y[at + 1] - y[at - 1])
    place = 0.5 * (y[at - 1] + y[at]) - 0.5 * before / bend
    highest = depth[at] - bend * (place - y[at]) ** 2
    found: Array = place[(highest > 0.0) & (place > y[at - 1]) & (place < y[at + 1])]
    return found


def overlapping(problem: Problem, state: State, interval: tuple[float, float]) -> tuple[Array, Array]:
    """Return places, and by how much the surfaces overlap there although no strip is in contact.

    Parameters
    ----------
    problem, state
        The problem, and a solution of it.
    interval : tuple of float
        Where the bodies can touch [mm], finite.

    Returns
    -------
    tuple of two ndarray, shape (places,)
        Places [mm], ascending, and depths [mm]: zero in contact and beside it, negative where the undeformed surfaces
        are apart.
    """
    contact = np.array(state.contact)
    margin = BESIDE * (contact[:, 1:] - contact[:, :1])
    if len(contact) == 1 and contact[0, 0] - margin[0] <= interval[0] and contact[0, 1] + margin[0] >= interval[1]:
        return np.zeros(0), np.zeros(0)
    y, h = problem.surveyed(*interval, SAMPLES)
    depth = state.rigid[0] + state.rigid[1] * y - h
    summits = _summits(y, depth)
    if summits.size:
        # A bump may touch between two places where the surfaces are apart.
        h = np.concatenate([h, problem.separation(summits)])
        y, first = np.unique(np.concatenate([y, summits]), return_index=True)
        depth = state.rigid[0] + state.rigid[1] * y - h[first]
    apart = np.all((y < contact[:, :1] - margin) | (y > contact[:, 1:] + margin), axis=0)
    overlap = np.where(apart & (depth <= 0.0), depth, 0.0)
    suspect = np.flatnonzero(apart & (depth > 0.0))
    if suspect.size:
        table = problem.element.table
        lift = displacements(problem.influence, y[suspect], state.edges, state.r, state.m, table)
        overlap[suspect] = depth[suspect] - lift
    overlap[(overlap > 0.0) & (overlap < NOTICED * np.max(depth))] = 0.0
    return y, overlap
