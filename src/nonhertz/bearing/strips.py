"""Contacts of rollers by the strip-element method, each on strips that are kept from one step to the next."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import mrad, um
from nonhertz.bearing.laws import ANSWER, OVERLAP
from nonhertz.errors import ConvergenceError
from nonhertz.model.contact import Contact
from nonhertz.native import core
from nonhertz.solver.one import posed
from nonhertz.strip.element import SEMI_ELLIPTIC, Element
from nonhertz.strip.levels import ACCURACY, equal_grids, on_automatic_strips
from nonhertz.strip.problem import row_of
from nonhertz.strip.records import CONVERGED, Grids, States
from nonhertz.strip.solving import TOLERANCE, solve_on_strips

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
KEPT_LOOPS = 32  # for each contact; each of them takes about half a megabyte


@dataclass(frozen=True, eq=False)
class LaidContact:
    """A contact solved on strips."""

    grids: Grids
    laid_for: Pose  # the approach and tilt that the strips were laid for [mm, rad]
    depth: float  # and the penetration there [mm]
    pose: Pose  # approach and tilt at which it is solved
    states: States
    answer: Array  # load, moment and their derivatives, times K, shape (OVERLAP,)


class StrippedContact:
    """A contact between roller and ring with what does not depend on approach and tilt.

    Parameters
    ----------
    contact : Contact
        Roller and ring.
    element : Element
        The strip element.
    """

    def __init__(self, contact: Contact, element: Element = SEMI_ELLIPTIC) -> None:
        self.contact = contact
        self.problem = posed(contact, element, np.zeros(2, dtype=np.bool_), np.zeros(2), ACCURACY, accuracy_given=False)
        self.model = self.problem.model
        low, *_, high = equal_grids(self.problem, SAMPLES)[0].tolist()
        self.low, self.high, self.half = low, high, 0.5 * (high - low)
        self.y, self.h = self.model.surveyed(low, high, SAMPLES)
        # Loops on strips, by the identity of their grids, which are beside them.
        self._loops: dict[int, tuple[Grids, core.Following]] = {}

    def penetration(self, pose: Array) -> Array:
        """Return how deep the undeformed bodies overlap where they do most [mm], at poses of shape (n, 2)."""
        rows, most = np.arange(len(pose)), np.full(len(pose), -np.inf)
        y, h = self.y[None], self.h[None]
        # A law that overlooked the overlap between two places would jump from no load to some: closer and closer.
        for _ in range(CLOSER_LOOKS):
            overlap = pose[:, :1] + pose[:, 1:] * y - h
            k = np.argmax(overlap, axis=1)
            most = np.maximum(most, overlap[rows, k])
            y = np.broadcast_to(y, overlap.shape)
            y = np.linspace(y[rows, np.maximum(k - 1, 0)], y[rows, np.minimum(k + 1, y.shape[1] - 1)], LOOKS, axis=1)
            h = self.model.separation(y.ravel()).reshape(y.shape)
        return most

    def even(self, strips: int) -> Grids:
        """Return about so many strips, nearly equal."""
        even = np.linspace(self.low, self.high, strips + 1)
        # Where corners begin, or else at the ends, in parts: a roller that tips over may have to bear close to there.
        bends = [bend for bend in self.contact.bends if self.low < bend < self.high]
        low = max((bend for bend in bends if bend < even[1]), default=self.low)
        high = min((bend for bend in bends if bend > even[-2]), default=self.high)
        parts = (even[1] - even[0]) * np.array([0.0, 1 / 16, 1 / 4])
        return self._grids(*row_of(np.unique(np.concatenate([even, low + parts, high - parts]))))

    def _grids(self, count: Indices, edges: Array) -> Grids:
        return self.model.deep(self.model.grids(count, edges))

    def laid(self, poses: Mapping[int, Pose]) -> dict[int, LaidContact]:
        """Return contacts of rollers at poses, each solved on strips of the automatic grid.

        Raises
        ------
        ConvergenceError
            If one of them has no solution.
        """
        found: dict[int, LaidContact] = {}
        rows, targets = list(poses), np.array(list(poses.values())).reshape(-1, 2)
        depths = self.penetration(targets).tolist()
        for solved in on_automatic_strips(self.problem, targets) if poses else ():
            for k, case in enumerate(solved.cases.tolist()):
                states, pose = solved.states[0].one(k).row(), poses[rows[case]]
                if states.status[0] != CONVERGED:
                    at = f"an approach of {um(pose[0]):.6g} and a tilt of {mrad(pose[1]):.6g}"
                    said = f"The contact of a roller at {at} has no solution: is a load too large?"
                    raise ConvergenceError(said, None)
                grids = self._grids(states.counts, states.edges)
                found[rows[case]] = LaidContact(grids, pose, depths[case], pose, states, _answer(states))
        return found

    def solved(self, laid: LaidContact, pose: Pose) -> LaidContact | None:
        """Return a contact solved elsewhere on its strips, beginning with what it was; None if it has no solution."""
        states = States.unsolved(laid.grids.counts, laid.grids.edges, 1)
        given, kernel = self.problem.prescribed, self.model.kernel
        solve_on_strips(laid.grids, given, np.array([pose]), kernel, laid.states, states, TOLERANCE, False)
        return replace(laid, pose=pose, states=states, answer=_answer(states)) if states.converged[0] else None

    def followed(self, laid: LaidContact, pose: Pose) -> LaidContact | None:
        """Return a contact led elsewhere on its strips; None if it got lost. It is quicker than `solved`."""
        if id(laid.grids) not in self._loops:
            if len(self._loops) >= KEPT_LOOPS:
                self._loops.clear()
            self._loops[id(laid.grids)] = laid.grids, core.Following(laid.grids, self.model.kernel)
        _, loop = self._loops[id(laid.grids)]
        states = laid.states
        copies = {name: getattr(states, name).copy() for name in ("r", "m", "rigid", "gap", "stiffness")}
        states = states._replace(**copies)
        resultant = loop.follow(pose, states)
        if resultant is None:
            return None
        return replace(laid, pose=pose, states=states, answer=np.concatenate([resultant, states.stiffness.ravel()]))

    def on_strips_of(self, other: LaidContact) -> LaidContact:
        """Return a guess of this contact, with the other ring, from one on strips that suit both."""
        grids = self._grids(other.grids.counts, other.grids.edges)
        # Under the same load half-widths are as the roots of the radii, and r as the curvature.
        sharper = grids.curvature / other.grids.curvature
        states = other.states._replace(r=other.states.r * sharper, m=other.states.m / sharper)
        return replace(other, grids=grids, states=states)


class StripLaw:
    """How the contacts of rollers answer by strips.

    Parameters
    ----------
    contacts : sequence of StrippedContact
        Those of a roller, with both rings. If the bodies are as far apart in both, both use the same strips.
    strips : int or None
        About so many, nearly equal and laid once, which is fast; or None: those of the automatic grid, laid when a
        contact is first asked for, and again when its penetration has become another one.
    """

    def __init__(self, contacts: Sequence[StrippedContact], strips: int | None = None) -> None:
        self._contacts, self._near = tuple(contacts), False
        self._few = () if strips is None else tuple(each.even(strips) for each in contacts)
        one, other = contacts[0], contacts[-1]
        alike = np.array_equal(one.y, other.y) and np.allclose(one.h, other.h, rtol=1e-9, atol=0.0)
        self._alike = strips is None and len(contacts) == 2 and alike
        # Of each contact, by roller.
        self._laid: tuple[dict[int, LaidContact], ...] = tuple({} for _ in contacts)
        self._depths: tuple[dict[int, float], ...] = tuple({} for _ in contacts)

    def lay_anew(self) -> None:
        """From now on lay strips anew for contacts that are not nearly those which they were laid for."""
        self._near = True

    def answer(self, rows: Indices, pose: Array) -> Array:
        """Return the answers of contacts, shape (n, contacts, ANSWER); ``pose`` has the shape (n, contacts, 2).

        Raises
        ------
        ConvergenceError
            If one of them has no solution.
        """
        answers = np.zeros((*pose.shape[:2], ANSWER))
        numbers = rows.tolist()
        poses = [dict(zip(numbers, map(tuple, each), strict=True)) for each in pose.swapaxes(0, 1).tolist()]
        for c, contact in enumerate(self._contacts):
            depth, depths = contact.penetration(pose[:, c]), self._depths[c]
            depths.update(zip(numbers, depth.tolist(), strict=True))
            answers[:, c, OVERLAP] = depth
            digits = SAME - int(np.floor(np.log10(np.max(np.abs(pose[:, c, 0]), initial=1e-300))))
            alike: dict[Pose, list[int]] = {}
            for at in np.flatnonzero(depth > UNRESOLVED * max(depths.values())).tolist():
                approach, tilt = poses[c][numbers[at]]
                alike.setdefault((round(approach, digits), round(tilt, digits)), []).append(at)
            asked = [numbers[at] for at, *_ in alike.values()]
            missing = [row for row in asked if not self._moves(c, row, poses[c][row], depths[row])]
            if self._alike:
                # The contact that is deeper has strips laid: they suit both.
                other = poses[1 - c]
                deep = self._contacts[1 - c].penetration(np.array([other[row] for row in missing]).reshape(-1, 2))
                there = dict(zip(missing, deep.tolist(), strict=True))
                deeper = [row for row in missing if there[row] > depths[row]]
                met = {r: other[r] for r in deeper if not self._moves(1 - c, r, other[r], there[r])}
                self._laid[1 - c].update(self._contacts[1 - c].laid(met))
            left = {row: poses[c][row] for row in missing if not self._takes(c, row, poses[c][row], depths[row])}
            self._laid[c].update(contact.laid(left))
            for places in alike.values():
                laid = self._laid[c][numbers[places[0]]]
                self._laid[c].update((numbers[at], laid) for at in places)
                answers[places, c, :OVERLAP] = laid.answer / contact.contact.compliance
        return answers

    def edges(self, row: int, contact: int = 0) -> Array:
        """Return the edges of the strips on which a contact was solved last [mm], shape (strips + 1,)."""
        grids = self._laid[contact][row].grids
        return grids.edges[0, : grids.counts[0] + 1]

    def _moves(self, c: int, row: int, pose: Pose, depth: float) -> bool:
        """Bring a contact to where it is asked, on the strips that it has; return whether that can be done."""
        laid, contact = self._laid[c].get(row), self._contacts[c]
        if laid is None or not (self._few or self._suits(c, laid, pose, depth, self._near)):
            return False
        same = laid.pose == pose
        return self._keeps(c, row, laid if same else contact.followed(laid, pose) or contact.solved(laid, pose))

    def _takes(self, c: int, row: int, pose: Pose, depth: float) -> bool:
        """Solve a contact on few strips, or on those of the other one of the same roller if they suit it."""
        contact = self._contacts[c]
        if self._few:
            unsolved = LaidContact(self._few[c], pose, depth, pose, States.none(), np.zeros(OVERLAP))
            return self._keeps(c, row, contact.solved(unsolved, pose))
        laid = self._laid[1 - c].get(row) if self._alike else None
        if laid is None or not self._suits(c, laid, pose, depth, near=True):
            return False
        return self._keeps(c, row, contact.followed(contact.on_strips_of(laid), pose))

    def _suits(self, c: int, laid: LaidContact, pose: Pose, depth: float, near: bool) -> bool:
        """Return whether strips still suit a contact, on the way to the balance or near it."""
        if not near:
            return max(depth / laid.depth, laid.depth / depth) <= ON_THE_WAY
        nearer, turned = pose[0] - laid.laid_for[0], self._contacts[c].half * abs(pose[1] - laid.laid_for[1])
        beside = max(laid.depth, LIGHT * max(self._depths[c].values(), default=0.0))
        return bool(turned + nearer <= DEEPER * beside and turned - nearer <= SHALLOWER * beside)

    def _keeps(self, c: int, row: int, found: LaidContact | None) -> bool:
        if found is not None:
            self._laid[c][row] = found
        return found is not None


def _answer(states: States) -> Array:
    """Return what a solved contact answers, times K."""
    return np.concatenate([states.scaled_load, states.scaled_moment, states.stiffness.ravel()])
