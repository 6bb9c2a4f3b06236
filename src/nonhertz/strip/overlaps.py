"""Where the surfaces overlap although no strip is in contact: another contact that the strips have missed.

Contact conditions are enforced only at strip centres. So the bodies are sampled again along their whole length,
including every crest of the profiles and the vertices of parabolas through the samples.
"""

from __future__ import annotations

import math

import numpy as np

from nonhertz.compiled import compiled
from nonhertz.strip.grid import intervals
from nonhertz.strip.influence import displacements
from nonhertz.strip.problem import Problem
from nonhertz.strip.records import CONVERGED, Array, Flags, States

SAMPLES = 600  # along the bodies
BESIDE = 0.02  # of an interval in contact: an overlap this close to it only shows where the contact ends
NOTICED = 1e-9  # of the deepest interference; a smaller overlap is rounding
STRIPS_PER_OVERLAP = 5.0


def runs(flags: Flags) -> list[tuple[int, int]]:
    """Return the first and last index of every run of true flags."""
    change = (np.flatnonzero(flags[1:] != flags[:-1]) + 1).tolist()
    if flags[0]:
        change.insert(0, 0)
    if flags[-1]:
        change.append(flags.size)
    return [(first, beyond - 1) for first, beyond in zip(change[::2], change[1::2], strict=True)]


def suspects(problem: Problem, states: States, interval: tuple[float, float]) -> Flags:
    """Return which cases may touch where no strip is in contact: where the undeformed surfaces overlap most.

    Away from a contact the displacement falls, so that another one needs a summit of the undeformed overlap, or the
    end of the bodies.
    """
    return _suspected(states, *problem.model.surveyed(*interval, SAMPLES))


@compiled
def _suspected(states: States, y: Array, h: Array) -> Flags:
    found = np.empty(states.status.size, np.bool_)
    for case in range(found.size):
        row = 0 if states.edges.shape[0] == 1 else case
        n = states.counts[row]
        contact = intervals(states.edges[row, : n + 1], states.m[case, :n])
        found[case] = states.status[case] == CONVERGED and _has_summit_apart(contact, states.rigid[case], y, h)
    return found


@compiled
def _has_summit_apart(contact: Array, rigid: Array, y: Array, h: Array) -> bool:
    """Return whether the undeformed surfaces overlap, more than beside it, at some place apart from the contact."""
    last = y.size - 1
    for i in range(last + 1):
        here = rigid[0] + rigid[1] * y[i] - h[i]
        before = rigid[0] + rigid[1] * y[i - 1] - h[i - 1] if i > 0 else -np.inf
        after = rigid[0] + rigid[1] * y[i + 1] - h[i + 1] if i < last else -np.inf
        if not (here >= before and here >= after):
            continue
        highest = here
        if 0 < i < last and math.isfinite(before) and math.isfinite(after):
            # No parabola through the three places rises higher above the middle one than this.
            highest += 0.125 * (2.0 * here - before - after)
        if highest > 0.0:
            apart = True
            for k in range(contact.shape[0]):
                margin = BESIDE * (contact[k, 1] - contact[k, 0])
                apart = apart and (y[i] < contact[k, 0] - margin or y[i] > contact[k, 1] + margin)
            if apart:
                return True
    return False


def overlaps(problem: Problem, state: States, interval: tuple[float, float]) -> list[tuple[float, float]]:
    """Return the midpoints of intervals where the surfaces overlap between strips out of contact, and widths for them.

    A wide strip out of contact sees the gap only at its centre; there may be another contact off centre.
    """
    y, overlap = overlapping(problem, state, interval)
    if not np.any(overlap > 0.0):
        return []
    step = (interval[1] - interval[0]) / SAMPLES
    found = []
    for i, j in runs(overlap > 0.0):
        # No wider than the neighbouring places without overlap allow: crests may be much closer together than the
        # samples, and much narrower.
        low, high = _reach(y, overlap, i, -1), _reach(y, overlap, j, 1)
        extent = max(float(y[j] - y[i]), min(step, low + float(y[j] - y[i]) + high))
        found.append((float(0.5 * (y[i] + y[j])), extent / STRIPS_PER_OVERLAP))
    return found


def _reach(y: Array, overlap: Array, at: int, side: int) -> float:
    """Return how far an overlap may extend beyond its last place: twice as far as a straight line to the next."""
    beside = at + side
    if not 0 <= beside < y.size:
        return 0.0
    distance = abs(float(y[beside] - y[at]))
    falls = -math.inf < overlap[beside] < 0.0
    share = overlap[at] / (overlap[at] - overlap[beside]) if falls else 1.0
    return distance * min(2.0 * float(share), 0.5)


def summits_of(y: Array, depth: Array) -> Array:
    """Return the vertices of parabolas through three neighbouring places each, where they are deeper than zero."""
    left, here, right = depth[:-2], depth[1:-1], depth[2:]
    at = np.flatnonzero((here >= left) & (here > right) & np.isfinite(left) & np.isfinite(right)) + 1
    before, after = ((depth[to] - depth[of]) / (y[to] - y[of]) for of, to in ((at - 1, at), (at, at + 1)))
    bend = (after - before) / (y[at + 1] - y[at - 1])
    place = 0.5 * (y[at - 1] + y[at]) - 0.5 * before / bend
    highest = depth[at] - bend * (place - y[at]) ** 2
    found: Array = place[(highest > 0.0) & (place > y[at - 1]) & (place < y[at + 1])]
    return found


def overlapping(problem: Problem, state: States, interval: tuple[float, float]) -> tuple[Array, Array]:
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
    contact = intervals(state.edges, state.m)
    margin = BESIDE * (contact[:, 1:] - contact[:, :1])
    if len(contact) == 1 and contact[0, 0] - margin[0] <= interval[0] and contact[0, 1] + margin[0] >= interval[1]:
        return np.zeros(0), np.zeros(0)
    y, h = problem.model.surveyed(*interval, SAMPLES)
    depth = state.rigid[0] + state.rigid[1] * y - h
    summits = summits_of(y, depth)
    if summits.size:
        # A bump may touch between two places where the surfaces are apart.
        h = np.concatenate([h, problem.model.separation(summits)])
        y, first = np.unique(np.concatenate([y, summits]), return_index=True)
        depth = state.rigid[0] + state.rigid[1] * y - h[first]
    apart = np.all((y < contact[:, :1] - margin) | (y > contact[:, 1:] + margin), axis=0)
    overlap = np.where(apart & (depth <= 0.0), depth, 0.0)
    suspect = np.flatnonzero(apart & (depth > 0.0))
    if suspect.size:
        lift = displacements(problem.model.influence, y[suspect], state.edges, state.r, state.m, problem.model.element)
        overlap[suspect] = depth[suspect] - lift
    overlap[(overlap > 0.0) & (overlap < NOTICED * np.max(depth))] = 0.0
    return y, overlap
