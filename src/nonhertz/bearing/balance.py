"""The search for the balance of rollers and rings, in machine code, one step at a time.

`go_on` takes what the contacts of rollers answered where they were asked, and moves rollers and ring to where they are
to be asked next. Laws that are tables answer in machine code too, and whole states are found without leaving it
(`balance_all`); strips answer from outside. The method is that of `nonhertz.bearing.equilibrium`: near the balance,
ring and rollers step together; where such steps do not lead on, there is a search of the ring, each step of which waits
until every roller has ended its own.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from nonhertz.bearing.laws import ANSWER, OVERLAP, answered
from nonhertz.compiled import compiled
from nonhertz.life.lamina import STIFFENING

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]
Indices = NDArray[np.int64]

# What may be left of the balance of a roller, over the ring's tolerance.
OF_ROLLER = 0.1
SHORTENINGS = 30
NO_LOAD = 1e-8  # of the largest: what is left of the balance of a roller that has lifted off
RIDGE = 1e-13  # of the stiffness, where nothing resists
OVERSHOT = 0.5  # of the slope along a step, by which it may point backwards at its end
HELD_BACK = 1e-3  # of loads over the penetration to be expected
# By how much a step is longer that is to end beyond the contact, more than the power of any law, where less than the
# second of the loads would be left.
LETS_GO, NOTHING_LEFT = 2.0, 0.1
CAUTION = 8.0  # penetrations that a step may add
# Ring and rollers step together while what is left of the balance, over the loads, is below the first, and every step
# leaves no more than this share of it.
CLOSE, LEADS_ON = 0.5, 0.3
MOST_ROUNDS = 10_000  # of questions to tables: of 5,000 random bearings none took 2,000
MOST_STRAY = 0.4  # of the rollers, that may first have to come near to it by themselves
#: What stands in place of a table: nothing, where a roller has no such contact, or a law that is asked from outside.
ABSENT, OUTSIDE = -2, -1


class Parts(NamedTuple):
    """Rollers and their contacts as arrays.

    Attributes
    ----------
    ring : ndarray, shape (rollers, 3, 5)
        Motion at each roller per motion of the inner ring.
    motion : ndarray, shape (rollers, columns, 2, 3)
        Approach and tilt of each contact per motion of ring against roller.
    gap : ndarray, shape (rollers, columns)
        What the approach of a centred ring and roller is short of contact [mm].
    inner : ndarray of bool, shape (rollers, columns)
        Whether the other body is the inner ring.
    law : ndarray of int, shape (rollers, columns)
        Where in the book the table of its law begins; or `ABSENT`, or `OUTSIDE`.
    book : ndarray
        Tables of laws, one after the other.
    load : ndarray, shape (rollers, 3)
        Load on every roller.
    scale : ndarray, shape (3,)
        Lengths by which rotations of rollers are made comparable with displacements: 1, 1 and a lever [mm].
    reach : ndarray, shape (5,)
        The same of the ring.
    stiffness : float
        About the load on a roller per deflection to the power `STIFFENING`, see `nonhertz.life.lamina`.
    """

    ring: Array
    motion: Array
    gap: Array
    inner: Flags
    law: Indices
    book: Array
    load: Array
    scale: Array
    reach: Array
    stiffness: float


class Work(NamedTuple):
    """How far the search for one state has come.

    The last row of ``slope``, ``share``, ``tries``, ``steps`` and ``searching`` is that of the ring.

    Attributes
    ----------
    ring, ring_before, ring_step : ndarray, shape (5,)
        Motion of the inner ring, where its step began, and the whole step.
    force, stiffness : ndarray, shape (5,) and (5, 5)
        Forces on it, and their derivatives, once the rollers are in balance.
    left : ndarray, shape (1,)
        What is left of the balance of ring and rollers, over the loads.
    motion, before, step, resting, follows : ndarray, shape (rollers, 3)
        Motions of rollers, where their steps began, and the whole steps; where they were in balance before the ring's
        step, and how they would follow the whole of it.
    pose, answer : ndarray, shape (rollers, columns, 2) and (rollers, columns, ANSWER)
        Approach and tilt at which contacts are asked, and what they answer.
    off, on_ring : ndarray, shape (rollers, 3)
        What is left of the balance of rollers, and the forces of the inner ring on them.
    whole, of_ring : ndarray, shape (rollers, 3, 3)
        Stiffness of all contacts of a roller, and of those with the inner ring.
    slope, share : ndarray, shape (rollers + 1,)
        Slope along a step at its beginning, and how much of it is tried.
    tries, steps : ndarray of int, shape (rollers + 1,)
        How often this step was shortened, and how many were taken.
    searching : ndarray of bool, shape (rollers + 1,)
        Who is within a step.
    asked : ndarray of bool, shape (rollers,)
        Which rollers' contacts are asked.
    together : ndarray, shape (1,)
        What was left when ring and rollers last stepped together; none such step is taken any more if it is zero.
    """

    ring: Array
    ring_before: Array
    ring_step: Array
    force: Array
    stiffness: Array
    left: Array
    motion: Array
    before: Array
    step: Array
    resting: Array
    follows: Array
    pose: Array
    answer: Array
    off: Array
    on_ring: Array
    whole: Array
    of_ring: Array
    slope: Array
    share: Array
    tries: Indices
    steps: Indices
    searching: Flags
    asked: Flags
    together: Array

    @classmethod
    def blank(cls, rollers: int, columns: int) -> Work:
        """Return what a search needs."""
        by_roller = [(rollers, 3)] * 5 + [(rollers, columns, 2), (rollers, columns, ANSWER)]
        by_roller += [(rollers, 3)] * 2 + [(rollers, 3, 3)] * 2
        shapes: list[tuple[int, ...]] = [(5,)] * 4 + [(5, 5), (1,), *by_roller, (rollers + 1,), (rollers + 1,)]
        arrays: list[Any] = [np.zeros(shape) for shape in shapes]
        arrays += [np.zeros(rollers + 1, dtype=np.int64) for _ in range(2)]
        arrays += [np.zeros(count, dtype=np.bool_) for count in (rollers + 1, rollers)]
        arrays.append(np.zeros(1))
        return cls(*arrays)


class Given(NamedTuple):
    """What is given, and how well it is to be met.

    Attributes
    ----------
    by_force : ndarray of bool, shape (5,)
        Of which motions of the ring the force or moment is given.
    depth : float
        A penetration of the size to be expected [mm].
    tolerance : float
        What may be left of the balance of the ring, over the loads.
    steps : int
        The most steps that the ring takes, and a roller for each of them.
    """

    by_force: Flags
    depth: float
    tolerance: float
    steps: int


class Found(NamedTuple):
    """States, a row each.

    Attributes
    ----------
    ring, force : ndarray, shape (states, 5)
        Motion of the inner ring, and forces and moments on it.
    stiffness : ndarray, shape (states, 5, 5)
        Their derivatives.
    left : ndarray, shape (states,)
        What is left of the balance.
    steps : ndarray of int, shape (states,)
        Steps of the ring.
    motion : ndarray, shape (states, rollers, 3)
        Of the rollers.
    pose : ndarray, shape (states, rollers, columns, 2)
        Approach and tilt of contacts.
    borne : ndarray, shape (states, rollers, columns, ANSWER)
        What contacts answer.
    """

    ring: Array
    force: Array
    stiffness: Array
    left: Array
    steps: Indices
    motion: Array
    pose: Array
    borne: Array

    @classmethod
    def blank(cls, states: int, rollers: int, columns: int) -> Found:
        """Return room for states."""
        steps = np.zeros(states, dtype=np.int64)
        of_contacts = [np.zeros((states, rollers, columns, size)) for size in (2, ANSWER)]
        of_ring = np.zeros((states, 5)), np.zeros((states, 5)), np.zeros((states, 5, 5)), np.zeros(states)
        return cls(*of_ring, steps, np.zeros((states, rollers, 3)), *of_contacts)

    def portion(self, first: int, last: int) -> Found:
        """Return some of the states, to be filled in."""
        parts: list[Any] = [each[first:last] for each in self]
        return Found(*parts)


@compiled
def balance_all(
    parts: Parts, work: Work, given: Given, target: Array, start: Array, motion: Array, found: Found
) -> None:
    """Find states whose contacts all have tables; arrays have a row for each, or ``motion`` none at all."""
    for k in range(target.shape[0]):
        begin(parts, work, start[k], motion[k] if motion.shape[0] else work.motion[:0])
        for _ in range(MOST_ROUNDS):
            ask_tables(parts, work)
            if not go_on(parts, work, given, target[k]):
                break
        keep(work, found, k)


@compiled
def begin(parts: Parts, work: Work, ring: Array, motion: Array) -> None:
    """Begin the search for a state at motions of ring and rollers; where these are NaN, as equal springs would go."""
    work.ring[:] = ring
    _follow_alike(parts, work)
    for j in range(motion.shape[0]):
        if not math.isnan(motion[j, 0]):
            work.motion[j] = motion[j]
    work.searching[:] = False
    work.steps[-1] = 0
    work.together[0] = work.left[0] = np.inf
    _ask_all(parts, work)


@compiled
def keep(work: Work, found: Found, k: int) -> None:
    """Write down a state."""
    found.ring[k], found.force[k], found.stiffness[k] = work.ring, work.force, work.stiffness
    found.left[k], found.steps[k] = work.left[0], work.steps[-1]
    found.motion[k], found.pose[k] = work.motion, work.pose
    found.borne[k] = work.answer


@compiled
def ask_tables(parts: Parts, work: Work) -> None:
    """Let all tables answer that are asked."""
    for j in range(work.asked.size):
        if work.asked[j]:
            for c in range(parts.law.shape[1]):
                if parts.law[j, c] >= 0:
                    answered(parts.book, parts.law[j, c], work.pose[j, c, 0], work.pose[j, c, 1], work.answer[j, c])


@compiled
def go_on(parts: Parts, work: Work, given: Given, target: Array) -> bool:
    """Take the answers, and move to where contacts are to be asked next.

    Returns
    -------
    bool
        Whether any are asked; else the balance is found, or no step is left.
    """
    for j in range(work.asked.size):
        if work.asked[j]:
            _add_up(parts, work, j)
    size = _size(parts, work, given, target)
    if work.together[0] > 0.0:
        # Few rollers that leave or enter the load zone are no reason to give up what suits all others.
        enough = OF_ROLLER * min(CLOSE, LEADS_ON * work.together[0]) * size
        if work.together[0] < np.inf and _strays(parts, work, enough) > MOST_STRAY * work.asked.size:
            _step_back(parts, work)
            return True
        if _rollers_move(parts, work, given, enough):
            return True
        if _step_together(parts, work, given, target, size):
            return True
        if work.together[0] > 0.0:
            return False
    if _rollers_move(parts, work, given, OF_ROLLER * given.tolerance * size):
        return True
    _condense(parts, work)
    return _ring_moves(parts, work, given, target, _left_of_rollers(parts, work) / size if size > 0.0 else 0.0)


@compiled
def _follow_alike(parts: Parts, work: Work) -> None:
    """Move rollers as if all contacts were alike, half-way between the rings; barrels turn with the inner ring."""
    for j in range(work.asked.size):
        at_roller, whole, of_ring = np.zeros((3, 1)), np.zeros((3, 3)), np.zeros((3, 3))
        for a in range(3):
            for b in range(5):
                at_roller[a, 0] += parts.ring[j, a, b] * work.ring[b]
        for c in range(parts.law.shape[1]):
            if parts.law[j, c] == ABSENT:
                continue
            for a in range(3):
                for b in range(3):
                    m = parts.motion[j, c]
                    stiff = m[0, a] * m[0, b] + parts.scale[2] ** 2 / 3.0 * m[1, a] * m[1, b]
                    whole[a, b] += stiff
                    if parts.inner[j, c]:
                        of_ring[a, b] += stiff
        pushed = _product(of_ring, at_roller)
        _solve(whole, pushed, parts.scale)
        work.motion[j] = pushed[:, 0]


@compiled
def _ask(parts: Parts, work: Work, j: int) -> None:
    """Ask the contacts of a roller where it and the ring are."""
    work.asked[j] = True
    for c in range(parts.law.shape[1]):
        if parts.law[j, c] == ABSENT:
            continue
        approach, tilt = -parts.gap[j, c], 0.0
        for a in range(3):
            moved = -work.motion[j, a]
            if parts.inner[j, c]:
                for b in range(5):
                    moved += parts.ring[j, a, b] * work.ring[b]
            approach += parts.motion[j, c, 0, a] * moved
            tilt += parts.motion[j, c, 1, a] * moved
        work.pose[j, c, 0], work.pose[j, c, 1] = approach, tilt


@compiled
def _ask_all(parts: Parts, work: Work) -> None:
    for j in range(work.asked.size):
        work.steps[j] = 0
        _ask(parts, work, j)


@compiled
def _add_up(parts: Parts, work: Work, j: int) -> None:
    """Add up forces on a roller, and stiffness."""
    work.off[j] = parts.load[j]
    work.on_ring[j], work.whole[j], work.of_ring[j] = 0.0, 0.0, 0.0
    for c in range(parts.law.shape[1]):
        if parts.law[j, c] == ABSENT:
            continue
        m, answer = parts.motion[j, c], work.answer[j, c]
        for a in range(3):
            force = m[0, a] * answer[0] + m[1, a] * answer[1]
            work.off[j, a] += force
            if parts.inner[j, c]:
                work.on_ring[j, a] += force
            load_by, moment_by = m[0, a] * answer[2] + m[1, a] * answer[4], m[0, a] * answer[3] + m[1, a] * answer[5]
            for b in range(3):
                stiff = load_by * m[0, b] + moment_by * m[1, b]
                work.whole[j, a, b] += stiff
                if parts.inner[j, c]:
                    work.of_ring[j, a, b] += stiff


@compiled
def _size(parts: Parts, work: Work, given: Given, target: Array) -> float:
    """Return the load of a roller [N] beside which what is left of its balance is judged."""
    size = 0.0
    for b in range(5):
        if given.by_force[b]:
            size = max(size, abs(target[b]) / parts.reach[b] / work.asked.size)
    for j in range(work.asked.size):
        borne = 0.0
        for c in range(parts.law.shape[1]):
            borne += work.answer[j, c, 0]
        size = max(size, borne)
        for a in range(3):
            size = max(size, abs(parts.load[j, a]) / parts.scale[a])
    return size


@compiled
def _rollers_move(parts: Parts, work: Work, given: Given, enough: float) -> bool:
    """Move the rollers whose balance is short of what is enough [N]; return whether there are any."""
    moving = False
    for j in range(work.asked.size):
        if work.searching[j]:
            slope = float(np.dot(work.off[j], work.step[j]))
            work.searching[j] = _shortened(work, j, slope, _along(work.whole[j], work.step[j]))
        if not work.searching[j]:
            work.asked[j] = _roller_steps(parts, work, given, j, enough)
            if not work.asked[j]:
                continue
        for a in range(3):
            work.motion[j, a] = work.before[j, a] + work.share[j] * work.step[j, a]
        _ask(parts, work, j)
        moving = True
    return moving


@compiled
def _roller_steps(parts: Parts, work: Work, given: Given, j: int, enough: float) -> bool:
    """Give a roller a step if it is not in balance."""
    if _largest(parts, work.off[j]) <= enough or work.steps[j] >= given.steps:
        return False
    step = _roller_step(parts, work, given, j)
    slope = 0.0
    for a in range(3):
        work.step[j, a] = step[a, 0]
        work.before[j, a] = work.motion[j, a]
        slope += work.off[j, a] * work.step[j, a]
    work.steps[j] += 1
    _search(work, j, slope)
    return True


@compiled
def _roller_step(parts: Parts, work: Work, given: Given, j: int) -> Array:
    """Return a step of a roller towards its balance, the ring at rest, shape (3, 1)."""
    # As for the ring: where nothing resists, a roller goes where it is pushed, and not far at once.
    held = HELD_BACK * _largest(parts, work.off[j]) / given.depth
    matrix, right = work.whole[j].copy(), np.empty((3, 1))
    for a in range(3):
        right[a, 0] = work.off[j, a]
        matrix[a, a] += held * parts.scale[a] ** 2
    _solve(matrix, right, parts.scale)
    if _is_let_go(parts, work, j, right):
        right *= LETS_GO
    right *= _cautious(parts, _deepest(work, given, j), right[:, 0])
    right *= _share_of_step(parts, work, j, right)
    return right


@compiled
def _deepest(work: Work, given: Given, j: int) -> float:
    """Return how deep the contacts of a roller are, or are expected to be [mm]."""
    deepest = given.depth
    for c in range(work.pose.shape[1]):
        deepest = max(deepest, work.answer[j, c, OVERLAP])
    return deepest


@compiled
def _cautious(parts: Parts, deepest: float, step: Array) -> float:
    """Return the share of a roller's step that presses nothing much deeper than so deep [mm]."""
    moved = 0.0
    for a in range(3):
        moved = max(moved, abs(step[a]) * parts.scale[a])
    return _share_within(moved, deepest)


@compiled
def _share_within(moved: float, deepest: float) -> float:
    """Return the share of a step that moves so far [mm] that is not far beside penetrations [mm]."""
    return 1.0 if moved <= CAUTION * deepest else CAUTION * deepest / moved


@compiled
def _is_let_go(parts: Parts, work: Work, j: int, step: Array) -> bool:
    """Return whether a step leaves a roller that nothing loads without any contact: it is to end clear of the rings.

    A load that grows with a power of the penetration falls only to a certain part of itself in every step to zero.
    """
    for a in range(3):
        if parts.load[j, a] != 0.0:
            return False
    now, then = 0.0, 0.0
    for c in range(parts.law.shape[1]):
        if parts.law[j, c] == ABSENT:
            continue
        load = work.answer[j, c, 0]
        now += load
        for a in range(3):
            by_step = work.answer[j, c, 2] * parts.motion[j, c, 0, a] + work.answer[j, c, 3] * parts.motion[j, c, 1, a]
            load -= by_step * step[a, 0]
        then += max(load, 0.0)
    return bool(then <= NOTHING_LEFT * now)


@compiled
def _share_of_step(parts: Parts, work: Work, j: int, step: Array) -> float:
    """Return how much of a roller's step presses none of its contacts much deeper than what is left would press it.

    Rollers that only speed loads cross the clearance of the bearing, and are to arrive as lightly as they are loaded:
    contacts hundreds of times too deep take long to solve.
    """
    share = 1.0
    expected = (_largest(parts, work.off[j]) / parts.stiffness) ** (1.0 / STIFFENING)
    for c in range(parts.law.shape[1]):
        if parts.law[j, c] == ABSENT:
            continue
        closer, turned = 0.0, 0.0
        for a in range(3):
            closer -= parts.motion[j, c, 0, a] * step[a, 0]
            turned -= parts.motion[j, c, 1, a] * step[a, 0]
        # What bears deepens where it bears, as far as its stiffness reaches; what is apart, at an end of the roller.
        middle, reach, answer = 0.0, parts.scale[2], work.answer[j, c]
        if answer[2] > 0.0:
            middle = answer[3] / answer[2]
            reach = math.sqrt(3.0 * max(answer[5] / answer[2] - middle**2, 0.0))
        now = answer[OVERLAP]
        then, most = now + closer + middle * turned + reach * abs(turned), CAUTION * max(now, expected)
        if then > most:
            share = min(share, (most - now) / (then - now))
    return share


@compiled
def _condense(parts: Parts, work: Work) -> None:
    """Add up forces on the ring, and its stiffness with rollers that follow it in balance."""
    work.force[:], work.stiffness[:], most = 0.0, 0.0, 0.0
    for j in range(work.asked.size):
        most = max(most, _largest(parts, work.on_ring[j]))
    for j in range(work.asked.size):
        # Slices resist with the ninth root of their overlap: one of 1e-19 mm, which is rounding, by a percent and more.
        if _largest(parts, work.on_ring[j]) <= NO_LOAD * most:
            continue
        follows = work.of_ring[j].copy()
        _solve(work.whole[j].copy(), follows, parts.scale)
        condensed = work.of_ring[j] - _product(work.of_ring[j], follows)
        turned = _product(condensed, parts.ring[j])
        for b in range(5):
            for a in range(3):
                work.force[b] += parts.ring[j, a, b] * work.on_ring[j, a]
                for d in range(5):
                    work.stiffness[b, d] += parts.ring[j, a, b] * turned[a, d]


@compiled
def _step_together(parts: Parts, work: Work, given: Given, target: Array, size: float) -> bool:
    """Move ring and rollers at once, near the balance, or back if that did not lead on; return whether they were moved.

    If not, the balance is found, or else ``work.together`` is zero from now on.
    """
    row = work.asked.size
    _condense(parts, work)
    off = np.zeros(5)
    most, loads = _off_ring(parts, work, given, target, off)
    of_rollers = _left_of_rollers(parts, work) / size if size > 0.0 else 0.0
    work.left[0] = max(most / loads, of_rollers)
    left = max(most / loads, of_rollers / OF_ROLLER)
    if left <= given.tolerance:
        return False
    if not left <= min(CLOSE, LEADS_ON * work.together[0]) or work.steps[row] >= given.steps:
        stepped = bool(work.together[0] < np.inf)
        if stepped:
            _step_back(parts, work)
        work.together[0] = 0.0
        return stepped
    work.together[0] = left
    work.ring_before[:], work.resting[:] = work.ring, work.motion
    work.steps[row] += 1
    # Where the rollers would go if the ring stayed, and what that does to it.
    for j in range(row):
        rest = _roller_step(parts, work, given, j)
        pushed = _product(work.of_ring[j], rest)
        for a in range(3):
            work.before[j, a] = rest[a, 0]
            for b in range(5):
                if given.by_force[b]:
                    off[b] += parts.ring[j, a, b] * pushed[a, 0]
    _follow_ring(parts, work, given, off, loads)
    for b in range(5):
        work.ring[b] += work.ring_step[b]
    for j in range(row):
        for a in range(3):
            work.motion[j, a] += work.follows[j, a] + work.before[j, a]
    _ask_all(parts, work)
    return True


@compiled
def _step_back(parts: Parts, work: Work) -> None:
    """Take back the last step of ring and rollers together, which are to step one after the other from now on."""
    work.together[0] = 0.0
    work.searching[:] = False
    work.ring[:], work.motion[:] = work.ring_before, work.resting
    _ask_all(parts, work)


@compiled
def _strays(parts: Parts, work: Work, enough: float) -> int:
    """Return how many rollers are off balance by more than is enough [N]."""
    count = 0
    for j in range(work.asked.size):
        if _largest(parts, work.off[j]) > enough:
            count += 1
    return count


@compiled
def _left_of_rollers(parts: Parts, work: Work) -> float:
    """Return what is left of the balance of rollers [N]."""
    off = 0.0
    for j in range(work.asked.size):
        off = max(off, _largest(parts, work.off[j]))
    return off


@compiled
def _largest(parts: Parts, forces: Array) -> float:
    """Return the largest of the forces and the moment on a roller [N]."""
    most = 0.0
    for a in range(3):
        most = max(most, abs(forces[a]) / parts.scale[a])
    return most


@compiled
def _ring_moves(parts: Parts, work: Work, given: Given, target: Array, of_rollers: float) -> bool:
    """Move the ring if it, or a roller, is not in balance; return whether it was moved."""
    row = work.asked.size
    if work.searching[row]:
        slope = 0.0
        for b in range(5):
            if given.by_force[b]:
                slope += (target[b] - work.force[b]) * work.ring_step[b]
        if _shortened(work, row, slope, _along(work.stiffness, work.ring_step)):
            _try(parts, work)
            return True
        work.searching[row] = False
        work.steps[row] += 1
    off = np.zeros(5)
    most, loads = _off_ring(parts, work, given, target, off)
    work.left[0] = max(most / loads, of_rollers)
    if not np.any(given.by_force) or work.left[0] <= given.tolerance or work.steps[row] >= given.steps:
        return False
    _ring_steps(parts, work, given, off, loads)
    _try(parts, work)
    return True


@compiled
def _off_ring(parts: Parts, work: Work, given: Given, target: Array, off: Array) -> tuple[float, float]:
    """Fill in what is left of the balance of the ring; return the most of it and the loads, as forces [N]."""
    most, loads = 0.0, np.finfo(np.float64).tiny
    for j in range(work.asked.size):
        loads += abs(work.on_ring[j, 0]) + abs(work.on_ring[j, 1])
    for b in range(5):
        if given.by_force[b]:
            off[b] = target[b] - work.force[b]
            loads = max(loads, abs(target[b]) / parts.reach[b])
            most = max(most, abs(off[b]) / parts.reach[b])
    return most, loads


@compiled
def _ring_steps(parts: Parts, work: Work, given: Given, off: Array, loads: float) -> None:
    """Give the ring a step, and let the rollers follow."""
    _follow_ring(parts, work, given, off, loads)
    work.ring_before[:], work.resting[:] = work.ring, work.motion
    slope = 0.0
    for b in range(5):
        slope += off[b] * work.ring_step[b]
    _search(work, work.asked.size, slope)


@compiled
def _follow_ring(parts: Parts, work: Work, given: Given, off: Array, loads: float) -> None:
    """Find the ring's step, and how rollers would follow if the contacts kept their stiffness."""
    free = np.flatnonzero(given.by_force)
    matrix, right = np.empty((free.size, free.size)), np.empty((free.size, 1))
    # A small stiffness against all motions, so that a ring that touches nothing goes where it is pushed.
    held = HELD_BACK * min(work.left[0], 1.0) * loads / given.depth
    for a in range(free.size):
        right[a, 0] = off[free[a]]
        for b in range(free.size):
            matrix[a, b] = work.stiffness[free[a], free[b]]
        matrix[a, a] += held * parts.reach[free[a]] ** 2
    _solve(matrix, right, np.ones(free.size))
    work.ring_step[:] = 0.0
    for a in range(free.size):
        work.ring_step[free[a]] = right[a, 0]
    deepest, moved = given.depth, 0.0
    for j in range(work.asked.size):
        at_roller = np.zeros((3, 1))
        deepest = max(deepest, _deepest(work, given, j))
        for a in range(3):
            for b in range(5):
                at_roller[a, 0] += parts.ring[j, a, b] * work.ring_step[b]
        moved = max(moved, abs(at_roller[0, 0]), abs(at_roller[1, 0]))
        pushed = _product(work.of_ring[j], at_roller)
        _solve(work.whole[j].copy(), pushed, parts.scale)
        work.follows[j] = pushed[:, 0]
    # No step presses anything much deeper than it is or is expected to be.
    share = _share_within(moved, deepest)
    work.ring_step[:] = share * work.ring_step
    for j in range(work.asked.size):
        # A roller that little holds would be flung about.
        work.follows[j] *= share
        work.follows[j] *= _cautious(parts, deepest, work.follows[j])


@compiled
def _try(parts: Parts, work: Work) -> None:
    """Move the ring along its step, and the rollers with it."""
    share = work.share[work.asked.size]
    for b in range(5):
        work.ring[b] = work.ring_before[b] + share * work.ring_step[b]
    for j in range(work.asked.size):
        for a in range(3):
            work.motion[j, a] = work.resting[j, a] + share * work.follows[j, a]
    _ask_all(parts, work)


@compiled
def _search(work: Work, row: int, slope: float) -> None:
    """Begin to try a step, the whole of it first."""
    work.slope[row], work.share[row], work.tries[row], work.searching[row] = slope, 1.0, 0, True


@compiled
def _shortened(work: Work, row: int, slope: float, bend: float) -> bool:
    """Shorten a step if the slope at its end points backwards; return whether it did.

    A step that falls short is good enough: the next goes on from there. A first slope below zero is rounding. Loads
    grow faster the deeper bodies are pressed: a line through both slopes is zero before the best share, often where
    the bodies are apart again, and the tangent at the end behind it.
    """
    first = work.slope[row]
    if slope >= -OVERSHOT * first or first <= 0.0 or work.tries[row] == SHORTENINGS:
        return False
    tangent = 1.0 + slope / (bend * work.share[row]) if bend > 0.0 else 0.0
    work.share[row] *= min(max(first / (first - slope), tangent, 0.1), 0.9)
    work.tries[row] += 1
    return True


@compiled
def _along(stiffness: Array, step: Array) -> float:
    """Return how the slope along a step changes."""
    found = 0.0
    for a in range(step.size):
        for b in range(step.size):
            found += step[a] * stiffness[a, b] * step[b]
    return found


@compiled
def _product(left: Array, right: Array) -> Array:
    found = np.zeros((left.shape[0], right.shape[1]))
    for a in range(left.shape[0]):
        for b in range(right.shape[1]):
            for k in range(left.shape[1]):
                found[a, b] += left[a, k] * right[k, b]
    return found


@compiled
def _solve(matrix: Array, right: Array, scale: Array) -> None:
    """Solve linear equations in place, by elimination with row pivoting; a motion that nothing resists is left alone.

    With three unknowns this is quicker than any call.
    """
    n = matrix.shape[0]
    size = 0.0
    for a in range(n):
        size = max(size, abs(matrix[a, a]) / scale[a] ** 2)
    for a in range(n):
        matrix[a, a] += (RIDGE * size if size > 0.0 else 1.0) * scale[a] ** 2
    for k in range(n):
        top = k + int(np.argmax(np.abs(matrix[k:, k])))
        if top != k:
            _swap(matrix, k, top)
            _swap(right, k, top)
        for a in range(k + 1, n):
            part = matrix[a, k] / matrix[k, k]
            matrix[a, k + 1 :] -= part * matrix[k, k + 1 :]
            right[a] -= part * right[k]
    for k in range(n - 1, -1, -1):
        for a in range(k + 1, n):
            right[k] -= matrix[k, a] * right[a]
        right[k] /= matrix[k, k]


@compiled
def _swap(rows: Array, one: int, other: int) -> None:
    for b in range(rows.shape[1]):
        rows[one, b], rows[other, b] = rows[other, b], rows[one, b]
