"""The search for the balance of rollers and rings, in machine code, one step at a time.

`go_on` takes what the contacts of rollers answered where they were asked, and moves rollers and ring to where they are
to be asked next. Laws in a book answer in machine code too, and whole states are found without leaving it
(`balance_all`); strips answer from outside. In the first phase, near the balance, ring and rollers step together; where
such steps do not lead on, they step in turn, and the ring waits until every roller has ended its steps. The method is
that of `nonhertz.bearing.equilibrium`, and docs/explain/theory.md tells it.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from nonhertz.bearing.laws import ANSWER, OVERLAP, Book, answered
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
MOST_ROUNDS = 10_000  # of questions to books: of 5,000 random bearings none took 2,000
MOST_STRAY = 0.4  # of the rollers, that may first have to come near to it by themselves
#: In place of a law's number, where a roller has no such contact, or its law answers outside.
NOT_IN_BOOK = -1
#: How ring and rollers step.
TOGETHER, IN_TURN = 0, 1


class Parts(NamedTuple):
    """Rollers and their contacts as arrays, one row a roller."""

    ring: Array  # motion at each roller per motion of the inner ring, shape (rollers, 3, 5)
    motion: Array  # approach and tilt of each contact per motion of ring against roller, (rollers, columns, 2, 3)
    gap: Array  # what the approach of a centred ring and roller is short of contact [mm], (rollers, columns)
    inner: Flags  # whether the other body is the inner ring, (rollers, columns)
    law: Indices  # which law of the book, or `NOT_IN_BOOK`, (rollers, columns)
    book: Book
    load: Array  # on every roller, (rollers, 3)
    scale: Array  # lengths that make rotations of rollers comparable with displacements: 1, 1 and a lever [mm]
    reach: Array  # the same of the ring, (5,)
    stiffness: float  # about the load on a roller per deflection to the power `STIFFENING`, see `nonhertz.life.lamina`


class Tries(NamedTuple):
    """Steps that are tried and shortened, of the ring or of every roller."""

    slope: Array  # along the step at its beginning
    share: Array  # how much of it is tried
    shortened: Indices  # how often this step was
    steps: Indices  # how many were taken
    searching: Flags  # whether a step is under way


class Ring(NamedTuple):
    """The inner ring."""

    motion: Array  # (5,)
    before: Array  # where its step began
    step: Array  # the whole step
    force: Array  # on it
    stiffness: Array  # derivatives of the forces with rollers that follow in balance, (5, 5)
    off: Array  # what is left of its balance
    tries: Tries  # arrays of length 1


class Rollers(NamedTuple):
    """The rollers."""

    motion: Array  # (rollers, 3)
    before: Array  # where their own steps began
    step: Array  # the whole steps
    resting: Array  # where they were when the ring's step began
    follows: Array  # how they follow the whole of it
    pose: Array  # approach and tilt at which contacts are asked, (rollers, columns, 2)
    answer: Array  # what they answer, (rollers, columns, ANSWER)
    off: Array  # what is left of their balance, (rollers, 3)
    on_ring: Array  # forces of the inner ring on them, (rollers, 3)
    left: Array  # the largest of what is left [N], (rollers,)
    whole: Array  # stiffness of all contacts of a roller, (rollers, 3, 3)
    of_ring: Array  # and of those with the inner ring
    asked: Flags  # whose contacts are asked
    tries: Tries


class Search(NamedTuple):
    """How far the search for one state has come; arrays of length 1 are numbers that change."""

    ring: Ring
    rollers: Rollers
    phase: Indices  # `TOGETHER` or `IN_TURN`
    limit: Array  # what may be left of the balance, over the loads, for the next step of ring and rollers together
    left: Array  # what is left, over the loads

    @classmethod
    def blank(cls, rollers: int, columns: int) -> Search:
        """Return what a search needs."""

        def tries(count: int) -> Tries:
            shortened, steps = np.zeros((2, count), dtype=np.int64)
            return Tries(np.zeros(count), np.zeros(count), shortened, steps, np.zeros(count, dtype=np.bool_))

        of_ring: list[Any] = [np.zeros(shape) for shape in [*[(5,)] * 4, (5, 5), (5,)]]
        shapes = [(3,)] * 5 + [(columns, 2), (columns, ANSWER), (3,), (3,), (), (3, 3), (3, 3)]
        of_rollers: list[Any] = [np.zeros((rollers, *shape)) for shape in shapes]
        of_ring.append(tries(1))
        of_rollers += [np.zeros(rollers, dtype=np.bool_), tries(rollers)]
        return cls(Ring(*of_ring), Rollers(*of_rollers), np.zeros(1, dtype=np.int64), np.zeros(1), np.zeros(1))


class Conditions(NamedTuple):
    """What is given, and how well it is to be met."""

    by_force: Flags  # of which motions of the ring the force or moment is given, (5,)
    depth: float  # a penetration of the size to be expected [mm]
    tolerance: float  # what may be left of the balance of the ring, over the loads
    steps: int  # the most that the ring takes, and a roller for each of them


class States(NamedTuple):
    """States of a bearing, a row each."""

    ring: Array  # motion of the inner ring, (states, 5)
    force: Array  # forces and moments on it that hold it there, (states, 5)
    stiffness: Array  # d(force) / d(ring), (states, 5, 5)
    residual: Array  # what is left of the balance of ring and rollers, over the loads, (states,)
    steps: Indices  # Newton steps of the ring, (states,)
    motion: Array  # of the rollers along x and r [mm] and about the tangent [rad], (states, rollers, 3)
    pose: Array  # approach and tilt of their contacts [mm, rad], (states, rollers, columns, 2)
    answer: Array  # what contacts answer, (states, rollers, columns, ANSWER)

    @classmethod
    def blank(cls, states: int, rollers: int, columns: int) -> States:
        """Return room for states."""
        of_ring = np.zeros((states, 5)), np.zeros((states, 5)), np.zeros((states, 5, 5)), np.zeros(states)
        of_contacts = (np.zeros((states, rollers, columns, size)) for size in (2, ANSWER))
        return cls(*of_ring, np.zeros(states, dtype=np.int64), np.zeros((states, rollers, 3)), *of_contacts)

    def portion(self, which: slice | Indices) -> States:
        """Return some of the states, which may be filled in if they are a slice."""
        parts: list[Any] = [each[which] for each in self]
        return States(*parts)

    @property
    def load(self) -> Array:
        """Loads of contacts [N], shape (states, rollers, columns)."""
        return self.answer[..., 0]

    def settled(self, tolerance: float) -> Flags:
        """Return which states are balanced, their loads and motions finite."""
        numbers = np.column_stack([self.ring, self.force, self.load.reshape(len(self.ring), -1)])
        settled: Flags = (self.residual <= tolerance) & np.all(np.isfinite(numbers), axis=1)
        return settled


@compiled
def balance_all(
    parts: Parts, search: Search, conditions: Conditions, target: Array, start: Array, motion: Array, found: States
) -> None:
    """Find states whose contacts all have laws in the book; arrays have a row for each."""
    for k in range(target.shape[0]):
        begin(parts, search, start[k], motion[k])
        for _ in range(MOST_ROUNDS):
            ask_book(parts, search.rollers)
            if not go_on(parts, search, conditions, target[k]):
                break
        keep(search, found, k)


@compiled
def begin(parts: Parts, search: Search, start: Array, motion: Array) -> None:
    """Begin the search for a state at motions of ring and rollers; where these are NaN, as equal springs would go."""
    ring, rollers = search.ring, search.rollers
    ring.motion[:] = start
    _follow_alike(parts, ring, rollers)
    for j in range(motion.shape[0]):
        if not math.isnan(motion[j, 0]):
            rollers.motion[j] = motion[j]
    ring.tries.searching[0], ring.tries.steps[0] = False, 0
    rollers.tries.searching[:] = False
    search.phase[0], search.limit[0], search.left[0] = TOGETHER, CLOSE, np.inf
    _ask_all(parts, ring, rollers)


@compiled
def keep(search: Search, found: States, k: int) -> None:
    """Write down a state."""
    ring, rollers = search.ring, search.rollers
    found.ring[k], found.force[k], found.stiffness[k] = ring.motion, ring.force, ring.stiffness
    found.residual[k], found.steps[k] = search.left[0], ring.tries.steps[0]
    found.motion[k], found.pose[k], found.answer[k] = rollers.motion, rollers.pose, rollers.answer


@compiled
def ask_book(parts: Parts, rollers: Rollers) -> None:
    """Let all laws of the book answer that are asked."""
    for j in range(rollers.asked.size):
        for c in range(parts.law.shape[1]):
            if rollers.asked[j] and parts.law[j, c] >= 0:
                approach, tilt = rollers.pose[j, c, 0], rollers.pose[j, c, 1]
                answered(parts.book, parts.law[j, c], approach, tilt, rollers.answer[j, c])


@compiled
def go_on(parts: Parts, search: Search, conditions: Conditions, target: Array) -> bool:
    """Take the answers, and move to where contacts are to be asked next.

    Returns
    -------
    bool
        Whether any are asked; else the balance is found, or no step is left.
    """
    ring, rollers = search.ring, search.rollers
    for j in range(rollers.asked.size):
        if rollers.asked[j]:
            _add_up(parts, rollers, j)
    size = _size(parts, rollers, conditions, target)
    if search.phase[0] == TOGETHER:
        enough, stepped = OF_ROLLER * search.limit[0] * size, ring.tries.steps[0] > 0
        # Few rollers that leave or enter the load zone are no reason to give up what suits all others.
        if not stepped or np.sum(rollers.left > enough) <= MOST_STRAY * rollers.left.size:
            if _rollers_step(parts, search, conditions, enough):
                return True
            of_ring, of_rollers, loads = _condense(parts, search, conditions, target, size)
            left = max(of_ring, of_rollers / OF_ROLLER)
            balanced = left <= conditions.tolerance
            if balanced or (left <= search.limit[0] and ring.tries.steps[0] < conditions.steps):
                if not balanced:
                    _step_together(parts, search, conditions, loads)
                    search.limit[0] = min(CLOSE, LEADS_ON * left)
                return not balanced
        search.phase[0] = IN_TURN
        if stepped:
            # The last step did not lead on.
            rollers.tries.searching[:] = False
            _move_along(parts, ring, rollers, 0.0)
            return True
    if _rollers_step(parts, search, conditions, OF_ROLLER * conditions.tolerance * size):
        return True
    _, _, loads = _condense(parts, search, conditions, target, size)
    if not _shortened(ring.tries, 0, ring.off, ring.step, ring.stiffness):
        done = search.left[0] <= conditions.tolerance or not np.any(conditions.by_force)
        if done or ring.tries.steps[0] >= conditions.steps:
            return False
        _follow_ring(parts, search, conditions, loads)
        _try(ring.tries, 0, ring.off, ring.step)
    _move_along(parts, ring, rollers, ring.tries.share[0])
    return True


@compiled
def _ask(parts: Parts, ring: Ring, rollers: Rollers, j: int) -> None:
    """Ask the contacts of a roller where it and the ring are."""
    rollers.asked[j] = True
    for c in range(parts.law.shape[1]):
        approach, tilt = -parts.gap[j, c], 0.0
        for a in range(3):
            moved = -rollers.motion[j, a]
            if parts.inner[j, c]:
                for b in range(5):
                    moved += parts.ring[j, a, b] * ring.motion[b]
            approach += parts.motion[j, c, 0, a] * moved
            tilt += parts.motion[j, c, 1, a] * moved
        rollers.pose[j, c, 0], rollers.pose[j, c, 1] = approach, tilt


@compiled
def _ask_all(parts: Parts, ring: Ring, rollers: Rollers) -> None:
    for j in range(rollers.asked.size):
        rollers.tries.steps[j] = 0
        _ask(parts, ring, rollers, j)


@compiled
def _add_up(parts: Parts, rollers: Rollers, j: int) -> None:
    """Add up forces on a roller, and stiffness."""
    off, on_ring, whole, of_ring = rollers.off[j], rollers.on_ring[j], rollers.whole[j], rollers.of_ring[j]
    off[:], on_ring[:], whole[:], of_ring[:] = parts.load[j], 0.0, 0.0, 0.0
    for c in range(parts.law.shape[1]):
        m, answer, inner = parts.motion[j, c], rollers.answer[j, c], parts.inner[j, c]
        for a in range(3):
            force = m[0, a] * answer[0] + m[1, a] * answer[1]
            off[a] += force
            if inner:
                on_ring[a] += force
            load_by, moment_by = m[0, a] * answer[2] + m[1, a] * answer[4], m[0, a] * answer[3] + m[1, a] * answer[5]
            for b in range(3):
                stiff = load_by * m[0, b] + moment_by * m[1, b]
                whole[a, b] += stiff
                if inner:
                    of_ring[a, b] += stiff
    rollers.left[j] = _largest(parts, off)


@compiled
def _largest(parts: Parts, forces: Array) -> float:
    """Return the largest of the forces and the moment on a roller [N]."""
    most = 0.0
    for a in range(3):
        most = max(most, abs(forces[a]) / parts.scale[a])
    return most


@compiled
def _size(parts: Parts, rollers: Rollers, conditions: Conditions, target: Array) -> float:
    """Return the load of a roller [N] beside which what is left of its balance is judged."""
    size = 0.0
    for b in range(5):
        if conditions.by_force[b]:
            size = max(size, abs(target[b]) / parts.reach[b] / rollers.asked.size)
    for j in range(rollers.asked.size):
        borne = 0.0
        for c in range(parts.law.shape[1]):
            borne += rollers.answer[j, c, 0]
        size = max(size, borne, _largest(parts, parts.load[j]))
    return size


@compiled
def _follow_alike(parts: Parts, ring: Ring, rollers: Rollers) -> None:
    """Move rollers as if all contacts were alike, half-way between the rings; barrels turn with the inner ring."""
    for j in range(rollers.asked.size):
        rollers.answer[j] = 0.0
        rollers.answer[j, :, 2], rollers.answer[j, :, 5] = 1.0, parts.scale[2] ** 2 / 3.0
        _add_up(parts, rollers, j)
        rollers.answer[j] = 0.0
        rollers.motion[j] = _following(parts, rollers, j, ring.motion)


@compiled
def _following(parts: Parts, rollers: Rollers, j: int, motion: Array) -> Array:
    """Return how a roller follows a motion of the ring if its contacts keep their stiffness."""
    at_roller = np.zeros((3, 1))
    for a in range(3):
        for b in range(5):
            at_roller[a, 0] += parts.ring[j, a, b] * motion[b]
    pushed = _product(rollers.of_ring[j], at_roller)
    _solve(rollers.whole[j].copy(), pushed, parts.scale)
    return pushed[:, 0]


@compiled
def _rollers_step(parts: Parts, search: Search, conditions: Conditions, enough: float) -> bool:
    """Move the rollers whose balance is short of what is enough [N]; return whether there are any."""
    rollers, tries = search.rollers, search.rollers.tries
    for j in range(rollers.asked.size):
        rollers.asked[j] = True
        if not _shortened(tries, j, rollers.off[j], rollers.step[j], rollers.whole[j]):
            if rollers.left[j] <= enough or tries.steps[j] >= conditions.steps:
                rollers.asked[j] = False
                continue
            rollers.before[j], rollers.step[j] = rollers.motion[j], _roller_step(parts, rollers, conditions, j)
            _try(tries, j, rollers.off[j], rollers.step[j])
        for a in range(3):
            rollers.motion[j, a] = rollers.before[j, a] + tries.share[j] * rollers.step[j, a]
        _ask(parts, search.ring, rollers, j)
    return bool(np.any(rollers.asked))


@compiled
def _roller_step(parts: Parts, rollers: Rollers, conditions: Conditions, j: int) -> Array:
    """Return a step of a roller towards its balance, the ring at rest, shape (3,)."""
    # As for the ring: where nothing resists, a roller goes where it is pushed, and not far at once.
    held = HELD_BACK * rollers.left[j] / conditions.depth
    matrix, right = rollers.whole[j].copy(), np.empty((3, 1))
    for a in range(3):
        right[a, 0] = rollers.off[j, a]
        matrix[a, a] += held * parts.scale[a] ** 2
    _solve(matrix, right, parts.scale)
    step = right[:, 0].copy()
    if _is_let_go(parts, rollers, j, step):
        step *= LETS_GO
    step *= _cautious(step * parts.scale, _deepest(rollers, conditions, j))
    step *= _share_of_step(parts, rollers, j, step)
    return step


@compiled
def _deepest(rollers: Rollers, conditions: Conditions, j: int) -> float:
    """Return how deep the contacts of a roller are, or are expected to be [mm]."""
    deepest = conditions.depth
    for c in range(rollers.pose.shape[1]):
        deepest = max(deepest, rollers.answer[j, c, OVERLAP])
    return deepest


@compiled
def _cautious(step: Array, deepest: float) -> float:
    """Return the share of a step [mm] that presses nothing much deeper than so deep [mm]."""
    moved = np.max(np.abs(step))
    return 1.0 if moved <= CAUTION * deepest else CAUTION * deepest / moved


@compiled
def _is_let_go(parts: Parts, rollers: Rollers, j: int, step: Array) -> bool:
    """Return whether a step leaves a roller that nothing loads without any contact: it is to end clear of the rings.

    A load that grows with a power of the penetration falls only to a certain part of itself in every step to zero.
    """
    if np.any(parts.load[j] != 0.0):
        return False
    now, then = 0.0, 0.0
    for c in range(parts.law.shape[1]):
        answer = rollers.answer[j, c]
        closer, turned = _closer(parts, j, c, step)
        now += answer[0]
        then += max(answer[0] + answer[2] * closer + answer[3] * turned, 0.0)
    return bool(then <= NOTHING_LEFT * now)


@compiled
def _closer(parts: Parts, j: int, c: int, step: Array) -> tuple[float, float]:
    """Return what a step of a roller adds to approach and tilt of a contact."""
    closer, turned = 0.0, 0.0
    for a in range(3):
        closer -= parts.motion[j, c, 0, a] * step[a]
        turned -= parts.motion[j, c, 1, a] * step[a]
    return closer, turned


@compiled
def _share_of_step(parts: Parts, rollers: Rollers, j: int, step: Array) -> float:
    """Return how much of a roller's step presses none of its contacts much deeper than what is left would press it.

    Rollers that only speed loads cross the clearance of the bearing, and are to arrive as lightly as they are loaded:
    contacts hundreds of times too deep take long to solve.
    """
    share = 1.0
    expected = (rollers.left[j] / parts.stiffness) ** (1.0 / STIFFENING)
    for c in range(parts.law.shape[1]):
        closer, turned = _closer(parts, j, c, step)
        # What bears deepens where it bears, as far as its stiffness reaches; what is apart, at an end of the roller.
        middle, reach, answer = 0.0, parts.scale[2], rollers.answer[j, c]
        if answer[2] > 0.0:
            middle = answer[3] / answer[2]
            reach = math.sqrt(3.0 * max(answer[5] / answer[2] - middle**2, 0.0))
        now = answer[OVERLAP]
        then, most = now + closer + middle * turned + reach * abs(turned), CAUTION * max(now, expected)
        if then > most:
            share = min(share, (most - now) / (then - now))
    return share


@compiled
def _condense(
    parts: Parts, search: Search, conditions: Conditions, target: Array, size: float
) -> tuple[float, float, float]:
    """Add up forces on the ring, and its stiffness with rollers that follow it in balance.

    Returns
    -------
    tuple of float
        What is left of the balance of the ring over the loads, and of rollers over ``size``; and the loads [N].
    """
    ring, rollers = search.ring, search.rollers
    ring.force[:], ring.stiffness[:], most = 0.0, 0.0, 0.0
    for j in range(rollers.asked.size):
        most = max(most, _largest(parts, rollers.on_ring[j]))
    for j in range(rollers.asked.size):
        # Slices resist with the ninth root of their overlap: one of 1e-19 mm, which is rounding, by a percent and more.
        if _largest(parts, rollers.on_ring[j]) <= NO_LOAD * most:
            continue
        follows = rollers.of_ring[j].copy()
        _solve(rollers.whole[j].copy(), follows, parts.scale)
        turned = _product(rollers.of_ring[j] - _product(rollers.of_ring[j], follows), parts.ring[j])
        for b in range(5):
            for a in range(3):
                ring.force[b] += parts.ring[j, a, b] * rollers.on_ring[j, a]
                for d in range(5):
                    ring.stiffness[b, d] += parts.ring[j, a, b] * turned[a, d]
    left, loads = 0.0, max(np.finfo(np.float64).tiny, np.sum(np.abs(rollers.on_ring[:, :2])))
    for b in range(5):
        ring.off[b] = target[b] - ring.force[b] if conditions.by_force[b] else 0.0
        if conditions.by_force[b]:
            loads, left = max(loads, abs(target[b]) / parts.reach[b]), max(left, abs(ring.off[b]) / parts.reach[b])
    of_rollers = np.max(rollers.left) / size if size > 0.0 else 0.0
    search.left[0] = max(left / loads, of_rollers)
    return left / loads, of_rollers, loads


@compiled
def _step_together(parts: Parts, search: Search, conditions: Conditions, loads: float) -> None:
    """Move ring and rollers at once, near the balance."""
    ring, rollers = search.ring, search.rollers
    # Where the rollers would go if the ring stayed, and what that does to it.
    for j in range(rollers.asked.size):
        rollers.step[j] = _roller_step(parts, rollers, conditions, j)
        pushed = _product(rollers.of_ring[j], rollers.step[j].reshape(3, 1))
        for a in range(3):
            for b in range(5):
                if conditions.by_force[b]:
                    ring.off[b] += parts.ring[j, a, b] * pushed[a, 0]
    _follow_ring(parts, search, conditions, loads)
    rollers.follows[:] += rollers.step
    ring.tries.steps[0] += 1
    _move_along(parts, ring, rollers, 1.0)


@compiled
def _follow_ring(parts: Parts, search: Search, conditions: Conditions, loads: float) -> None:
    """Find a step of the ring, and how rollers follow it."""
    ring, rollers, by_force = search.ring, search.rollers, conditions.by_force
    ring.before[:], rollers.resting[:] = ring.motion, rollers.motion
    # A small stiffness against all motions, so that a ring that touches nothing goes where it is pushed.
    held = HELD_BACK * min(search.left[0], 1.0) * loads / conditions.depth
    matrix, right = np.zeros((5, 5)), np.zeros((5, 1))
    for a in range(5):
        right[a, 0] = ring.off[a]
        for b in range(5):
            matrix[a, b] = ring.stiffness[a, b] if by_force[a] and by_force[b] else 0.0
        matrix[a, a] += held * parts.reach[a] ** 2 if by_force[a] else 1.0
    _solve(matrix, right, np.ones(5))
    ring.step[:] = right[:, 0]
    deepest, moved = conditions.depth, np.zeros((rollers.asked.size, 2))
    for j in range(rollers.asked.size):
        deepest = max(deepest, _deepest(rollers, conditions, j))
        rollers.follows[j] = _following(parts, rollers, j, ring.step)
        for a in range(2):
            for b in range(5):
                moved[j, a] += parts.ring[j, a, b] * ring.step[b]
    # No step presses anything much deeper than it is or is expected to be.
    share = _cautious(moved, deepest)
    ring.step[:] *= share
    for j in range(rollers.asked.size):
        # A roller that little holds would be flung about.
        rollers.follows[j] *= share
        rollers.follows[j] *= _cautious(rollers.follows[j] * parts.scale, deepest)


@compiled
def _move_along(parts: Parts, ring: Ring, rollers: Rollers, share: float) -> None:
    """Move the ring to a share of its step, and the rollers with it."""
    ring.motion[:] = ring.before + share * ring.step
    rollers.motion[:] = rollers.resting + share * rollers.follows
    _ask_all(parts, ring, rollers)


@compiled
def _try(tries: Tries, j: int, off: Array, step: Array) -> None:
    """Begin to try a step, the whole of it first."""
    tries.slope[j] = 0.0
    for a in range(step.size):
        tries.slope[j] += off[a] * step[a]
    tries.share[j], tries.shortened[j], tries.searching[j] = 1.0, 0, True
    tries.steps[j] += 1


@compiled
def _shortened(tries: Tries, j: int, off: Array, step: Array, stiffness: Array) -> bool:
    """Shorten a step that is tried, if the slope at its end points backwards; return whether it did, or end the step.

    A step that falls short is good enough: the next goes on from there. A first slope below zero is rounding. Loads
    grow faster the deeper bodies are pressed: a line through both slopes is zero before the best share, often where
    the bodies are apart again, and the tangent at the end behind it.
    """
    first, slope, bend = tries.slope[j], 0.0, 0.0
    for a in range(step.size):
        slope += off[a] * step[a]
        for b in range(step.size):
            bend += step[a] * stiffness[a, b] * step[b]
    backwards = slope < -OVERSHOT * first and first > 0.0
    if not (tries.searching[j] and backwards and tries.shortened[j] < SHORTENINGS):
        tries.searching[j] = False
        return False
    tangent = 1.0 + slope / (bend * tries.share[j]) if bend > 0.0 else 0.0
    tries.share[j] *= min(max(first / (first - slope), tangent, 0.1), 0.9)
    tries.shortened[j] += 1
    return True


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
    """Solve linear equations in place, by elimination; a motion that nothing resists is left alone.

    With three unknowns this is quicker than any call. Stiffness is positive definite, and nearly symmetric: no pivot is
    looked for.
    """
    n = matrix.shape[0]
    size = 0.0
    for a in range(n):
        size = max(size, abs(matrix[a, a]) / scale[a] ** 2)
    for a in range(n):
        matrix[a, a] += (RIDGE * size if size > 0.0 else 1.0) * scale[a] ** 2
    for k in range(n):
        for a in range(k + 1, n):
            part = matrix[a, k] / matrix[k, k]
            matrix[a, k + 1 :] -= part * matrix[k, k + 1 :]
            right[a] -= part * right[k]
    for k in range(n - 1, -1, -1):
        for a in range(k + 1, n):
            right[k] -= matrix[k, a] * right[a]
        right[k] /= matrix[k, k]
