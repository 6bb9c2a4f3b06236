"""Contacts of rollers by the strip-element method, each on strips that are kept from one step to the next."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nonhertz.bearing.laws import Answer
from nonhertz.errors import ConvergenceError
from nonhertz.model.contact import Contact
from nonhertz.solver.one import posed
from nonhertz.strip.element import SEMI_ELLIPTIC, Element
from nonhertz.strip.levels import ACCURACY, equal_grids, on_automatic_strips
from nonhertz.strip.newton import TOLERANCE
from nonhertz.strip.problem import row_of
from nonhertz.strip.records import CONVERGED, Given, Grids, States
from nonhertz.strip.settle import settle_all

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

SAMPLES = 256
# Digits, relative to the largest, in which contacts are the same, as those on both sides of a load are.
SAME = 12
# Ratios up to which a penetration may differ from that which the strips were laid for, on the way to the balance and
# near it.
ON_THE_WAY, NEAR = 3.0, 1.1


class StripLaw:
    """How a contact answers by strips.

    Parameters
    ----------
    contact : Contact
        Roller and ring.
    strips : int or None
        A number of equal strips, which is fast; or None: those of the automatic grid, laid when a contact is first
        asked for, and again when its penetration has become another one.
    element : Element
        The strip element.
    """

    def __init__(self, contact: Contact, strips: int | None = None, element: Element = SEMI_ELLIPTIC) -> None:
        self.contact = contact
        self._problem = posed(contact, element, np.zeros(2, dtype=np.bool_), np.zeros(2), ACCURACY, asked=False)
        self._given = self._problem.prescribed
        few = equal_grids(self._problem, contact.interval, strips or SAMPLES)[0]
        self._y, self._h = self._problem.surveyed(float(few[0]), float(few[-1]), SAMPLES)
        self._equal = None if strips is None else self._problem.grids(*row_of(few))
        self._kept: dict[int, tuple[Grids, States, float]] = {}
        self._ratio = ON_THE_WAY

    def penetration(self, approach: Array, tilt: Array) -> Array:
        """Return how deep the undeformed bodies overlap where they do most [mm]."""
        found: Array = np.max(approach[:, None] + tilt[:, None] * self._y - self._h, axis=1)
        return found

    def lay_anew(self) -> None:
        """From now on lay strips anew for contacts that are not nearly those which they were laid for."""
        self._ratio = NEAR

    def pressed(self, rows: Indices, approach: Array, tilt: Array) -> Answer:
        """Return the answer of contacts.

        Raises
        ------
        ConvergenceError
            If one of them has no solution.
        """
        load, moment, stiffness = np.zeros(rows.size), np.zeros(rows.size), np.zeros((rows.size, 2, 2))
        depth = self.penetration(approach, tilt)
        known: dict[tuple[float, float], int] = {}
        digits = SAME - np.floor(np.log10(np.max(np.abs(approach), initial=1e-300))).astype(int)
        for at in np.flatnonzero(depth > 0.0):
            pose = (float(np.round(approach[at], digits)), float(np.round(tilt[at], digits)))
            twin = known.setdefault(pose, int(at))
            if twin != at:
                self._kept[int(rows[at])] = self._kept[int(rows[twin])]
                load[at], moment[at], stiffness[at] = load[twin], moment[twin], stiffness[twin]
                continue
            state = self._solved(int(rows[at]), np.array([[approach[at], tilt[at]]]), float(depth[at]))
            load[at], moment[at], stiffness[at] = state.load[0], state.moment[0], state.stiffness[0]
        compliance = self._problem.compliance
        return Answer(load / compliance, moment / compliance, stiffness / compliance)

    def _solved(self, row: int, pose: Array, depth: float) -> States:
        kept = self._kept.get(row)
        if kept is not None and self._equal is None and max(depth / kept[2], kept[2] / depth) > self._ratio:
            kept = None
        if kept is None and self._equal is not None:
            kept = (self._equal, States.none(), depth)
        if kept is not None:
            grids, near, laid_for = kept
            states = States.unsolved(grids.counts, grids.edges, 1)
            settle_all(grids, Given(self._given, pose), self._problem.law, near, states, TOLERANCE, False)
            if states.status[0] == CONVERGED:
                self._kept[row] = (grids, states, laid_for)
                return states
        return self._laid(row, pose, depth)

    def _laid(self, row: int, pose: Array, depth: float) -> States:
        """Solve a contact on strips that are laid for it."""
        ((_, levels),) = on_automatic_strips(self._problem, self.contact.interval, self.contact.bends, pose)
        states = levels[0]
        if states.status[0] != CONVERGED:
            at = f"an approach of {1e3 * pose[0, 0]:.6g} um and a tilt of {1e3 * pose[0, 1]:.6g} mrad"
            raise ConvergenceError(f"The contact of a roller at {at} has no solution.", None)
        if self._equal is None:
            self._kept[row] = (self._problem.grids(states.counts, states.edges), states, depth)
        return states
