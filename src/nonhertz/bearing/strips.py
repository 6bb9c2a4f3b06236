"""Contacts of rollers by the strip-element method, each on strips that are kept from one step to the next."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import mrad, um
from nonhertz.bearing.laws import ANSWER, OVERLAP
from nonhertz.errors import ConvergenceError
from nonhertz.model.contact import Contact
from nonhertz.solver.one import posed
from nonhertz.strip.element import SEMI_ELLIPTIC, Element
from nonhertz.strip.influence import Remote, blank_remote
from nonhertz.strip.levels import ACCURACY, equal_grids, on_automatic_strips
from nonhertz.strip.newton import TOLERANCE
from nonhertz.strip.problem import row_of
from nonhertz.strip.records import CONVERGED, BoundaryConditions, Grids, States
from nonhertz.strip.solving import follow, solve_on_strips

Array = NDArray[np.float64]
Indices = NDArray[np.int64]
Pose = tuple[float, float]

SAMPLES, LOOKS, CLOSER_LOOKS = 256, 33, 4
# Digits, relative to the largest, in which contacts are the same, as those on both sides of a load are.
SAME = 12
# By what factor the penetration may differ from that which strips were laid for, on the way to the balance.
ON_THE_WAY = 3.0
# Near it: what may be added to the penetration anywhere, and taken from it, over the deepest. Measured on crowned
# rollers: with the second the error of the load stays below the accuracy of the strips; contacts that outgrow their
# strips by a tenth are in error by three times as much.
DEEPER, SHALLOWER = 0.02, 0.12
LIGHT = 0.1  # of the deepest contact of all rollers: what is less deep bears too little to be judged by itself
# Of the deepest contact: an overlap with a load that the balance does not resolve.
UNRESOLVED = 1e-10
KEPT_REMOTE = 64  # each of them takes about half a megabyte


@dataclass
class _Kept:
    """A solved contact: its strips, what they were laid for, where it was asked last, and what it answered."""

    grids: Grids
    states: States
    laid_for: Pose
    depth: float
    asked: Pose
    answer: Array


class StripLaw:
    """How a contact answers by strips.

    Parameters
    ----------
    contact : Contact
        Roller and ring.
    strips : int or None
        About so many, nearly equal and laid once, which is fast; or None: those of the automatic grid, laid when a
        contact is first asked for, and again when its penetration has become another one.
    element : Element
        The strip element.
    """

    def __init__(self, contact: Contact, strips: int | None = None, element: Element = SEMI_ELLIPTIC) -> None:
        self.contact = contact
        self._problem = posed(
            contact, element, np.zeros(2, dtype=np.bool_), np.zeros(2), ACCURACY, accuracy_given=False
        )
        self._given = self._problem.prescribed
        few = equal_grids(self._problem, SAMPLES)[0]
        self._low, self._high = float(few[0]), float(few[-1])
        self._y, self._h = self._problem.model.surveyed(self._low, self._high, SAMPLES)
        self._half = 0.5 * (self._high - self._low)
        self._other: StripLaw | None = None
        self._few: Grids | None = None
        self._ahead: dict[int, Pose] = {}
        self._kept: dict[int, _Kept] = {}
        self._remote: dict[int, tuple[Remote, Array]] = {}
        self._near = False
        self._depth: dict[int, float] = {}
        if strips is not None:
            self._lay_few(strips)

    def on_few_strips(self, strips: int) -> StripLaw:
        """Return the law of the same contact on few strips, which are nearly equal."""
        other = object.__new__(StripLaw)
        other.__dict__.update(self.__dict__)
        other._other, other._ahead, other._kept, other._remote, other._depth = None, {}, {}, {}, {}
        other._lay_few(strips)
        return other

    def beside(self, other: StripLaw) -> None:
        """Let both contacts of rollers use the same strips, if the bodies are as far apart in both."""
        if np.array_equal(self._y, other._y) and np.allclose(self._h, other._h, rtol=1e-9, atol=0.0):
            self._other, other._other = other, self

    def penetration(self, approach: Array, tilt: Array) -> Array:
        """Return how deep the undeformed bodies overlap where they do most [mm]."""
        rows, most = np.arange(approach.size), np.full(approach.size, -np.inf)
        y, h = self._y[None], self._h[None]
        # A law that overlooked the overlap between two places would jump from no load to some: closer and closer.
        for _ in range(CLOSER_LOOKS):
            overlap = approach[:, None] + tilt[:, None] * y - h
            k = np.argmax(overlap, axis=1)
            most = np.maximum(most, overlap[rows, k])
            y = np.broadcast_to(y, overlap.shape)
            y = np.linspace(y[rows, np.maximum(k - 1, 0)], y[rows, np.minimum(k + 1, y.shape[1] - 1)], LOOKS, axis=1)
            h = self._problem.model.separation(y.ravel()).reshape(y.shape)
        return most

    def lay_anew(self) -> None:
        """From now on lay strips anew for contacts that are not nearly those which they were laid for."""
        self._near = True

    def expect(self, rows: Indices, approach: Array, tilt: Array) -> None:
        """Take note of contacts that are about to be asked."""
        self._ahead = dict(zip(rows.tolist(), zip(approach.tolist(), tilt.tolist(), strict=True), strict=True))

    def pressed(self, rows: Indices, approach: Array, tilt: Array) -> Array:
        """Return the answers of contacts, shape (n, ANSWER).

        Raises
        ------
        ConvergenceError
            If one of them has no solution.
        """
        answers = np.zeros((rows.size, ANSWER))
        depth = self.penetration(approach, tilt)
        self._depth.update(zip(rows.tolist(), depth.tolist(), strict=True))
        digits = SAME - np.floor(np.log10(np.max(np.abs(approach), initial=1e-300))).astype(int)
        known: dict[Pose, int] = {}
        asked: dict[int, tuple[Pose, float]] = {}
        twins: list[tuple[int, int]] = []
        for at in np.flatnonzero(depth > UNRESOLVED * max(self._depth.values())).tolist():
            pose = float(approach[at]), float(tilt[at])
            twin = known.setdefault((round(pose[0], int(digits)), round(pose[1], int(digits))), at)
            if twin == at:
                asked[int(rows[at])] = pose, float(depth[at])
            twins.append((at, int(rows[twin])))
        missing = {row: each for row, each in asked.items() if not self._known(row, *each)}
        if missing:
            self._find(missing)
        for at, row in twins:
            kept = self._kept[int(rows[at])] = self._kept[row]
            answers[at, :OVERLAP] = kept.answer / self.contact.compliance
        answers[:, OVERLAP] = depth
        return answers

    def edges(self, row: int) -> Array:
        """Return the edges of the strips on which a contact was solved last [mm], shape (strips + 1,)."""
        grids = self._kept[row].grids
        return grids.edges[0, : grids.counts[0] + 1]

    def _lay_few(self, strips: int) -> None:
        even = np.linspace(self._low, self._high, strips + 1)
        width = even[1] - even[0]
        # Where corners begin, or else at the ends, in parts: a roller that tips over may have to bear close to there.
        bends = [bend for bend in self.contact.bends if self._low < bend < self._high]
        low = max((bend for bend in bends if bend < even[1]), default=self._low)
        high = min((bend for bend in bends if bend > even[-2]), default=self._high)
        parts = width * np.array([0.0, 1 / 16, 1 / 4])
        edges = np.unique(np.concatenate([even, low + parts, high - parts]))
        self._few = self._laid(*row_of(edges))

    def _laid(self, count: Indices, edges: Array) -> Grids:
        return self._problem.model.deep(self._problem.model.grids(count, edges))

    def _known(self, row: int, pose: Pose, depth: float) -> bool:
        """Bring a contact to where it is asked, on the strips that it has; return whether that can be done."""
        kept = self._kept.get(row)
        if kept is None or not self._fits(kept, pose, depth):
            return False
        return kept.asked == pose or self._follows(row, kept, pose) or self._settles(kept, pose)

    def _fits(self, kept: _Kept, pose: Pose, depth: float) -> bool:
        """Return whether the strips of a contact still suit it."""
        if self._few is not None:
            return True
        if not self._near:
            return max(depth / kept.depth, kept.depth / depth) <= ON_THE_WAY
        nearer, turned = pose[0] - kept.laid_for[0], self._half * abs(pose[1] - kept.laid_for[1])
        beside = max(kept.depth, LIGHT * max(self._depth.values(), default=0.0))
        return turned + nearer <= DEEPER * beside and turned - nearer <= SHALLOWER * beside

    def _follows(self, row: int, kept: _Kept, pose: Pose) -> bool:
        """Let a contact follow on its strips; return whether it could."""
        remote, widest = self._remote_of(row, kept.grids)
        given = BoundaryConditions(self._given, np.array([pose]))
        followed = follow(kept.grids, given, self._problem.model.kernel, remote, widest, kept.states, kept.answer)
        kept.asked = pose if followed else kept.asked
        return followed

    def _settles(self, kept: _Kept, pose: Pose) -> bool:
        """Solve a contact on its strips from the start; return whether it has a solution there."""
        given = BoundaryConditions(self._given, np.array([pose]))
        states = States.unsolved(kept.grids.counts, kept.grids.edges, 1)
        solve_on_strips(kept.grids, given, self._problem.model.kernel, kept.states, states, TOLERANCE, False)
        if states.status[0] != CONVERGED:
            return False
        kept.states, kept.asked, kept.answer = states, pose, _answer(states)
        return True

    def _remote_of(self, row: int, grids: Grids) -> tuple[Remote, Array]:
        """Return what the strips of a contact do far away, as it was left."""
        row = row if self._few is None else 0
        found = self._remote.get(row)
        if found is None or found[0].powers.shape[0] != grids.counts[0]:
            if len(self._remote) >= KEPT_REMOTE:
                self._remote.clear()
            found = self._remote[row] = blank_remote(int(grids.counts[0]), self._problem.model.kernel), np.zeros(1)
        return found

    def _find(self, missing: dict[int, tuple[Pose, float]]) -> None:
        """Solve contacts that have no strips that suit them."""
        if self._few is not None:
            for row, (pose, depth) in missing.items():
                states = States.unsolved(self._few.counts, self._few.edges, 1)
                given = BoundaryConditions(self._given, np.array([pose]))
                solve_on_strips(self._few, given, self._problem.model.kernel, States.none(), states, TOLERANCE, False)
                self._kept[row] = _Kept(self._few, states, pose, depth, pose, _answer(states))
            missing = {row: each for row, each in missing.items() if self._kept[row].states.status[0] != CONVERGED}
        else:
            self._let_other_lay(missing)
            missing = {row: each for row, each in missing.items() if not self._takes(row, *each)}
        self._lay(missing)

    def _let_other_lay(self, missing: dict[int, tuple[Pose, float]]) -> None:
        """Let the contact with the other ring have strips laid where it is deeper: they suit both."""
        other, theirs = self._other, {}
        if other is None:
            return
        for row, (_, depth) in missing.items():
            pose = other._ahead.get(row)
            if pose is not None and pose[0] > -np.inf:
                there = float(self.penetration(np.array([pose[0]]), np.array([pose[1]]))[0])
                if there > depth and not other._known(row, pose, there):
                    theirs[row] = pose, there
        other._lay(theirs)

    def _takes(self, row: int, pose: Pose, depth: float) -> bool:
        """Solve a contact on the strips of the other one of the same roller, if they suit it."""
        kept = self._other._kept.get(row) if self._other is not None else None
        if kept is None:
            return False
        near = self._near
        self._near = True
        fits = self._fits(kept, pose, depth)
        self._near = near
        if not fits:
            return False
        grids = self._laid(kept.grids.counts, kept.grids.edges)
        # Under the same load half-widths are as the roots of the radii, and r as the curvature.
        sharper = grids.curvature / kept.grids.curvature
        states = kept.states._replace(
            r=kept.states.r * sharper, m=kept.states.m / sharper, rigid=kept.states.rigid.copy(),
            gap=kept.states.gap.copy(), stiffness=kept.states.stiffness.copy(),
        )  # fmt: skip
        taken = _Kept(grids, states, kept.laid_for, kept.depth, kept.asked, np.zeros(OVERLAP))
        self._remote.pop(row, None)
        if not self._follows(row, taken, pose):
            return False
        self._kept[row] = taken
        return True

    def _lay(self, missing: dict[int, tuple[Pose, float]]) -> None:
        """Solve contacts on strips that are laid for them."""
        if not missing:
            return
        rows, poses = list(missing), np.array([pose for pose, _ in missing.values()])
        for solved in on_automatic_strips(self._problem, poses):
            for k, case in enumerate(solved.cases.tolist()):
                row, states = rows[case], solved.states[0].one(k).row()
                pose, depth = missing[row]
                if states.status[0] != CONVERGED:
                    at = f"an approach of {um(pose[0]):.6g} and a tilt of {mrad(pose[1]):.6g}"
                    raise ConvergenceError(f"The contact of a roller at {at} has no solution.", None)
                grids = self._laid(states.counts, states.edges)
                self._remote.pop(row, None)
                self._kept[row] = _Kept(grids, states, pose, depth, pose, _answer(states))


def _answer(states: States) -> Array:
    """Return what a solved contact answers, times K."""
    return np.concatenate([states.scaled_load, states.scaled_moment, states.stiffness.ravel()])
