"""Grids solved from coarse to fine, each solution providing the start and the grading of the next.

On strips that are wide compared with the half-width the Newton loop converges from springs; on narrow ones it needs a
start that has the shape of the contact, which a coarser level provides. An automatic grid is made in the same way:
equal strips find the contact, a rough graded grid locates its ends and bends, and the final grid is solved
with half its strips and with all. The levels also give an error estimate: see `Levels.difference`.

Every level is taken for all cases before the next; a single case is a batch of one.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import product
from typing import NamedTuple

import numpy as np

from nonhertz.compiled import compiled, plain_array
from nonhertz.errors import InputError
from nonhertz.strip.acceptance import steadily
from nonhertz.strip.feasible import (
    FINE_STRIPS,
    feasible,
    refuse_arm_outside,
    refuse_endless_relief,
    refuse_infeasible,
    refuse_no_contact,
)
from nonhertz.strip.grid import Fineness, Surface, intervals, lay_all, reaching, uniform
from nonhertz.strip.overlaps import SAMPLES, overlaps, suspects
from nonhertz.strip.problem import Problem, padded_rows, solved_on, winkler_state
from nonhertz.strip.records import Array, Flags, Grids, Indices, States
from nonhertz.strip.solving import ROUGH_TOLERANCE, TOLERANCE
from nonhertz.strip.summit import CUSP, is_cusp, is_summit, largest_summit_errors, sagitta

Interval = tuple[float, float]

STRIP_LIMIT = 40  # of an automatic grid of coarseness 1 on one interval of contact
COARSE_STRIPS = 24
COARSEST_LEVEL = 5
MORE_STRIPS = (1, 5, 25)  # times as many to begin with, in case fewer miss the contact
FEWER_STRIPS = (1.0, 0.94, 0.88, 0.82, 0.76)  # tried in turn where a grid has no solution
# Fractions of the strips: a rough grid that grades the final one, then half of the final one before all of it; and so
# often again, if the solution shows that another contact was missed or strips are too wide.
ROUGH, HALF, REPEATS = 0.4, 0.5, 2
WELL_FILLED = 0.4  # fraction of the region that the contact must fill before a grid is graded from it
# Measured on 300 random contacts of the usual profiles: at a coarseness of COARSENESS the error of the approach is
# below ACCURACY; it falls with about the power ORDER of the width, on coarser grids faster and less regularly, and is
# mostly less than this share of the change from half the strips.
ACCURACY, COARSENESS, ORDER, ORDER_COARSER, LEFT_OF_CHANGE = 1e-4, 0.28, 2.2, 3.0, 0.4
LEAST_FINER, MARGIN = 0.4, 0.95
FULL = 0.97
# The change of the largest pressure is to be so much less than its accuracy, and its sagitta in a strip so many times.
OF_PRESSURE, PER_SAGITTA = 0.7, 8.0
# At the largest pressure: its sagitta in a strip over the accuracy, how much narrower strips may become at once, below
# which share of their width they are solved again, and by what share of it another may be less and yet count as the
# largest.
POINTED, LEAST_AT_PEAK, TOO_WIDE, ALIKE, AT_KINK = 5.0, 0.2, 0.7, 0.01, 3.0


class Solved(NamedTuple):
    """Cases that took the same number of levels.

    Attributes
    ----------
    cases : ndarray of int, shape (cases,)
        Their numbers.
    states : sequence of States
        Their states on every level, finest first. Those of a case that has not converged on some grid are left so.
    grids : Grids
        The finest strips.
    """

    cases: Indices
    states: Sequence[States]
    grids: Grids

    def only(self, cases: Flags) -> Solved:
        """Return some of the cases."""
        rows = np.flatnonzero(cases)
        return Solved(self.cases[rows], [level.only(rows) for level in self.states], self.grids.only(rows))


@dataclass(frozen=True)
class Levels:
    """The solution and those on coarser grids, finest first; coarser ones that did not converge are left out."""

    states: tuple[States, ...]
    accuracy: float | None = None
    """What the grid aims for, if the last two are a grid with its edges on the ends of the contact, and half of it."""

    @property
    def finest(self) -> States:
        """The state on the grid of the result."""
        return self.states[0]


def levels_from(problem: Problem, states: list[States]) -> Levels:
    """Return the levels of one case, without coarser ones that have no solution."""
    finest, *coarser = states
    solved = tuple(state for state in coarser if state.converged)
    regular = bool(coarser) and bool(coarser[0].converged)
    return Levels((finest, *solved), problem.accuracy if regular else None)


def equal_grids(problem: Problem, count: int) -> list[Array]:
    """Return the edges of ``count`` equal strips where the bodies can touch, and of half as many down to a few."""
    low, high = bounded(problem)

    def made() -> list[Array]:
        counts = [count]
        while counts[-1] // 2 >= COARSEST_LEVEL or (len(counts) == 1 and count > 1):
            counts.append(counts[-1] // 2)
        return [uniform(low, high, level) for level in counts]

    return problem.model.kept(("equal", low, high, count), made)


def given_grids(edges: Array) -> list[Array]:
    """Return given edges, and coarser grids that leave out every other one."""
    grids = [edges]
    while grids[-1].size // 2 > COARSEST_LEVEL or (len(grids) == 1 and edges.size > 2):
        grids.append(np.unique(np.concatenate([grids[-1][:-1:2], edges[-1:]])))
    return grids


def on_given_strips(problem: Problem, levels: Sequence[Array], targets: Array) -> Solved:
    """Return the states of all cases on strips between several rows of edges, finest first."""
    found: list[States] = []
    for edges in reversed(levels):
        grids, last = problem.model.kept_grid(edges), edges is levels[0]
        tolerance = TOLERANCE if last else ROUGH_TOLERANCE
        near = found[0] if found else None
        found.insert(0, solved_on(problem, grids, targets, near, tolerance=tolerance, patient=last))
    return Solved(np.arange(len(targets)), found, grids)


def on_automatic_strips(problem: Problem, targets: Array) -> list[Solved]:
    """Return the states of cases on graded grids; ``targets`` as `Problem.target`, shape (cases, 2)."""
    accuracy, bends = problem.accuracy or ACCURACY, problem.contact.bends
    finite = bounded(problem)
    edges = uniform(*finite, COARSE_STRIPS)
    y = 0.5 * (edges[1:] + edges[:-1])
    refuse_endless_relief(y, problem.model.separation(y))
    kinks = problem.model.kinks(tuple(bend for bend in bends if finite[0] < bend < finite[1]), finite[1] - finite[0])
    order = ORDER_COARSER if accuracy > ACCURACY else ORDER
    coarseness = np.full(len(targets), COARSENESS * (accuracy / ACCURACY) ** (1.0 / order))
    learning = Refinement(problem, finite, kinks, targets, coarseness)
    # The equal strips that find the contact are too few to say anything about the error.
    located = _located(problem, finite, targets)
    rough, _ = learning.finer(located, located, ROUGH)
    half, full, grids = learning.halves(rough)
    solved, groups = Solved(np.arange(len(targets)), (full, half, rough), grids), []
    for _ in range(REPEATS):
        finer, again = learning.wanting(solved.states)
        groups.append(solved.only(~again))
        solved, learning = solved.only(again), learning.only(again, finer)
        if not solved.cases.size:
            break
        half, full, grids = learning.halves(solved.states[0])
        solved = Solved(solved.cases, (full, half, *solved.states), grids)
    return [each for each in (*groups, solved) if each.cases.size]


@dataclass(frozen=True)
class Refinement:
    """Cases whose grids are learnt from coarser solutions."""

    problem: Problem
    finite: Interval
    kinks: tuple[Array, Array]
    targets: Array
    coarseness: Array

    def only(self, cases: Flags, finer: Array) -> Refinement:
        """Return what is known of some cases, whose strips are to be narrower by these shares."""
        return replace(self, targets=self.targets[cases], coarseness=(self.coarseness * finer)[cases])

    def halves(self, learnt_from: States) -> tuple[States, States, Grids]:
        """Return solutions on half of the strips of a graded grid and on all, and the grids with all."""
        half, _ = self.finer(learnt_from, learnt_from, HALF)
        return half, *self.finer(learnt_from, half, 1.0)

    def wanting(self, levels: Sequence[States]) -> tuple[Array, Flags]:
        """Return by what share strips have to be narrower, and which cases are worth another grid."""
        finest, finer = levels[0], self.finer_wanted(levels)
        missing = finest.converged & (self.incomplete(finest) | self.pointed(finest))
        return finer, ~self.too_thin(finest) & ((finer < 1.0) | missing)

    def finer_wanted(self, levels: Sequence[States]) -> Array:
        """Return by what share strips have to be narrower for the accuracy to be met; 1 where it is or cannot be."""
        (finest, half), problem = levels[:2], self.problem
        samples, h = self.problem.model.sampled(*self.finite, SAMPLES)
        by_load = problem.prescribed[0]
        fine, coarse = (finest.rigid[:, 0], half.rigid[:, 0]) if by_load else (finest.scaled_load, half.scaled_load)
        with np.errstate(divide="ignore", invalid="ignore"):  # a case that has not converged may be infinite
            pressed = np.max(finest.rigid[:, :1] + finest.rigid[:, 1:] * samples - h, axis=1)
            error = LEFT_OF_CHANGE * np.abs(fine - coarse) / (np.abs(pressed) if by_load else fine)
            missing = error / (problem.accuracy or ACCURACY)
            if problem.pressure_accuracy is not None:
                of_pressure = largest_summit_errors(finest, half, problem.model.element.hertz_ratio)
                missing = np.maximum(missing, of_pressure / (OF_PRESSURE * problem.pressure_accuracy))
            finer = np.maximum(LEAST_FINER, MARGIN * missing ** (-1.0 / ORDER))
        met = ~(missing > 1.0) | ~(finest.converged & half.converged)
        # More strips than the limit are not laid, whatever is asked for.
        spent = finest.counts >= FULL * STRIP_LIMIT / np.minimum(self.coarseness, 1.0)
        return np.where(met | spent, 1.0, finer)

    def finer(self, states: States, near: States, share: float) -> tuple[States, Grids]:
        """Return solutions on graded grids, or on slightly coarser ones where these have none, and the grids.

        Cases that had not converged before are left as they were.

        Where a blunt contact ends just at the edge of a strip, that strip can be unable to carry load (its neighbours
        alone curve the surface more than the bodies do) and yet overlap without it. The next grid has its edges
        elsewhere. It is also tried when the solution found is unstable, as spurious ones are in contacts several times
        as wide as long.
        """
        left, found, model = (
            np.flatnonzero(states.converged),
            near if np.any(states.converged) else states,
            self.problem.model,
        )
        surface, extras, grids = self._surface(states), self._extras(states), None
        for fewer in FEWER_STRIPS if left.size else ():
            laid = states.only(left)
            fineness = Fineness(self.coarseness[left], fewer * share, STRIP_LIMIT)
            count, edges = lay_all(laid, surface.only(left), extras[left], fineness)
            grids = model.deep(model.grids(count, plain_array(edges[:, : count.max() + 1])))
            tried = solved_on(
                self.problem, grids, self.targets[left], near.only(left),
                tolerance=TOLERANCE if share == 1.0 else ROUGH_TOLERANCE, patient=fewer == FEWER_STRIPS[-1],
            )  # fmt: skip
            found = found.replaced(left, tried)
            left = left[~(tried.converged & steadily(tried))]
            if not left.size:
                break
        if grids is None or found.edges is not grids.edges:  # of several tries
            grids = model.deep(model.grids(found.counts, found.edges))
        return found, grids

    def incomplete(self, states: States) -> Flags:
        """Return which cases end where the bodies do not, or overlap where no strip is in contact."""
        (low, high), ends = self.problem.contact.interval, states.edges
        missing: Flags = np.any(reaching(states) & np.stack([ends[:, 0] > low, ends[:, -1] < high], axis=1), axis=1)
        for row in np.flatnonzero(suspects(self.problem, states, self.finite) & ~missing):
            missing[row] = bool(overlaps(self.problem, states.one(int(row)), self.finite))
        return missing

    def too_thin(self, states: States) -> Flags:
        """Return in which cases a body is thinner than its contact is wide; no number of strips saves them."""
        if not self.problem.model.influence.references:
            return np.zeros(states.status.size, dtype=bool)
        y = states.y
        min_depth = self.problem.model.influence.min_depth(y.ravel()).reshape(y.shape)
        thin: Flags = np.any(min_depth < self.problem.model.element.hertz_ratio * np.sqrt(states.m), axis=1)
        return thin

    def pointed(self, states: States) -> Flags:
        """Return in which cases the largest pressure is far too pointed for its strips."""
        peaks = _peaks(states, self.kinks[0], self._sagitta)
        pointed: Flags = np.any(peaks[:, 1] < TOO_WIDE * peaks[:, 2], axis=1)
        return pointed

    @property
    def _sagitta(self) -> float:
        """By what share of itself the largest pressure may bend within a strip."""
        of_pressure = (self.problem.pressure_accuracy or math.inf) / PER_SAGITTA
        return min(POINTED * (self.problem.accuracy or ACCURACY), of_pressure)

    def _surface(self, states: States) -> Surface:
        low, high = np.broadcast_to(states.edges[:, [0, -1]], (states.status.size, 2)).T
        if np.all(low == self.finite[0]) and np.all(high == self.finite[1]):
            row, samples = (
                np.zeros(low.size, dtype=np.int64),
                self.problem.model.sampled(*self.finite, SAMPLES)[1][None],
            )
        else:
            regions, row = np.unique(np.stack([low, high]), axis=1, return_inverse=True)
            places = np.linspace(regions[0], regions[1], SAMPLES + 1, axis=1)
            samples = self.problem.model.separation(places.ravel()).reshape(places.shape)
        return Surface(*self.finite, *self.kinks, low.copy(), high.copy(), row.ravel(), samples)

    def _extras(self, states: States) -> Array:
        suspected = suspects(self.problem, states, self.finite).tolist()
        found = [overlaps(self.problem, states.one(row), self.finite) if it else [] for row, it in enumerate(suspected)]
        extras = np.full((len(found), 2, 2 + max(map(len, found))), np.nan)
        extras[..., :2] = _peaks(states, self.kinks[0], self._sagitta)[:, :2]
        for row, places in enumerate(found):
            extras[row, :, 2 : 2 + len(places)] = np.array(places).reshape(-1, 2).T
        return extras


@compiled
def _peaks(states: States, kinks: Array, allowed: float) -> Array:
    """Return where the largest pressure is too pointed for its strips, and widths, shape (cases, 3, 2).

    Places, the widths wanted there, and those that the strips have. What a strip bears is the mean over it: a sagitta
    of the pressure within it, of which a share of the pressure is ``allowed``, is missing from the maximum. On either
    side of y = 0, where pressures are equal that mirror each other; a strip on y = 0 is on both.
    """
    found = np.full((states.status.size, 3, 2), np.nan)
    for case in range(found.shape[0]):
        row = 0 if states.edges.shape[0] == 1 else case
        n, edges = states.counts[row], states.edges[row]
        pressure, highest = np.empty(n), 0.0
        for i in range(n):
            pressure[i] = states.r[case, i] * math.sqrt(states.m[case, i])
            highest = max(highest, pressure[i])
        for side in range(2):
            at, reached = -1, (1.0 - ALIKE) * highest
            for i in range(1, n - 1):
                # A lower summit may be the largest pressure, if it is more pointed than its strips can tell.
                if (edges[i + 1] > 0.0) if side == 1 else (edges[i] < 0.0):
                    sagittas = CUSP if is_cusp(pressure, i) else 1.0
                    reach = pressure[i] * (1.0 + sagittas * max(0.0, sagitta(pressure, i)))
                    if reach > reached and is_summit(pressure, i):
                        at, reached = i, reach
            if at > 0:
                bend, place = sagitta(pressure, at), 0.5 * (edges[at] + edges[at + 1])
                wide, pointed = edges[at + 1] - edges[at], bend > allowed
                for kink in kinks:  # there it has no limit
                    pointed = pointed and not abs(place - kink) < AT_KINK * wide
                if pointed:
                    wanted = wide * max(math.sqrt(allowed / bend), LEAST_AT_PEAK)
                    found[case, 0, side], found[case, 1, side], found[case, 2, side] = place, wanted, wide
    return found


def _located(problem: Problem, finite: Interval, targets: Array) -> States:
    """Return solutions on equal strips of regions that the contacts fill well, searching from ``finite`` inwards."""
    count, edges = padded_rows([_first_strips(problem.of(target), finite) for target in targets])
    if np.all(edges == edges[0]):
        count, edges = count[:1], edges[:1]
    model = problem.model
    states = solved_on(problem, model.deep(model.grids(count, edges)), targets, tolerance=ROUGH_TOLERANCE)
    rows = np.flatnonzero(states.converged)
    for _ in range(40):
        narrower = {row: _narrower(states.one(row), problem.contact.interval) for row in rows.tolist()}
        grids = {row: region for row, region in narrower.items() if region is not None}
        if not grids:
            break
        rows = np.array(list(grids))
        narrow = model.grids(*padded_rows([uniform(*region, COARSE_STRIPS) for region in grids.values()]))
        found = solved_on(problem, model.deep(narrow), targets[rows], tolerance=ROUGH_TOLERANCE)
        states = states.replaced(rows, found)
        rows = rows[found.converged]
    return states


def _narrower(state: States, interval: Interval) -> Interval | None:
    """Return where to look again for a contact that fills little of its strips or is cut off; None if it need not."""
    contact = intervals(state.edges, state.m)
    first, last = float(contact[0, 0]), float(contact[-1, 1])
    low, high = float(state.edges[0]), float(state.edges[-1])
    cut = (state.m[0] > 0.0 and low > interval[0]) or (state.m[-1] > 0.0 and high < interval[1])
    if not cut and last - first > WELL_FILLED * (high - low):
        return None
    margin = max(0.3 * (last - first), 2.0 * float(np.min(state.width))) * (4.0 if cut else 1.0)
    return max(first - margin, interval[0]), min(last + margin, interval[1])


def _first_strips(problem: Problem, finite: Interval) -> Array:
    """Return equal strips that can meet what is prescribed: all along the bodies, or near where they touch."""
    edges = uniform(*finite, COARSE_STRIPS)
    # Where the load is given and the moment is not, any strips will do.
    if problem.prescribed[0] and not problem.prescribed[1]:
        return edges
    # A prescribed approach may bring only a tiny spot into contact, a moment only the very end.
    if problem.prescribed[0] and feasible(problem, edges):
        return edges
    refuse_arm_outside(problem, finite)
    regions = [_neighbourhood(problem, *finite)]
    if np.all(problem.prescribed):  # at one end of the bodies, centred on the resultant of load and moment
        (low, high), arm = finite, float(problem.target[1] / problem.target[0])
        at_high = high - arm < arm - low
        regions.append((max(low, 2.0 * arm - high), high) if at_high else (low, min(high, 2.0 * arm - low)))
    for region, more in product(regions, MORE_STRIPS):
        edges = uniform(*region, more * COARSE_STRIPS)
        if feasible(problem, edges):
            break
    refuse_infeasible(problem, edges, chosen=False)
    return edges


def _neighbourhood(problem: Problem, low: float, high: float) -> tuple[float, float]:
    """Return the interval in which springs find contact, with a margin."""
    for _ in range(3):
        fine = winkler_state(problem, uniform(low, high, FINE_STRIPS))
        touching = np.flatnonzero(fine.m > 0.0)
        margin = float(high - low) / FINE_STRIPS
        if touching.size:
            first, last = float(fine.edges[touching[0]]), float(fine.edges[touching[-1] + 1])
            margin += 0.3 * (last - first)
            return max(low, first - margin), min(high, last + margin)
        nearest = float(fine.y[np.argmax(fine.rigid[0] + fine.rigid[1] * fine.y - problem.model.separation(fine.y))])
        low, high = max(low, nearest - 2.0 * margin), min(high, nearest + 2.0 * margin)
    return low, high


def bounded(problem: Problem) -> Interval:
    """Return the interval in which to look for the contact; finite even where the bodies are unbounded."""
    low, high = problem.contact.interval
    if math.isfinite(low) and math.isfinite(high):
        return low, high
    scale = 1.0 / float(np.max(problem.contact.curvature_at(np.zeros(1))))
    edge = np.concatenate([[0.0], scale * np.geomspace(1e-9, 1e4, 130)])
    edges = np.unique(np.clip(np.concatenate([-edge[::-1], edge]), low, high))
    if np.all(problem.prescribed) and not np.all(np.isfinite(problem.model.separation(edges))):
        low, high = _finite_part(problem, edges)
        edges = np.unique(np.clip(edges, low, high))
        refuse_arm_outside(problem, (low, high))
    touching = np.flatnonzero(winkler_state(problem, edges).m > 0.0)
    if touching.size == 0 and not problem.prescribed[0]:
        refuse_no_contact(problem, edges, chosen=False)
    if touching.size == 0:
        return _finite_part(problem, edges)
    first, last = touching[0], touching[-1] + 1
    if (first == 0 and not math.isfinite(low)) or (last == edges.size - 1 and not math.isfinite(high)):
        remedy = "give one of the bodies a length, or a profile that falls away"
        raise InputError("length", None, "be given where nothing else ends the contact", remedy)
    reach = 0.5 * float(edges[last] - edges[first])
    return max(low, float(edges[first]) - reach), min(high, float(edges[last]) + reach)


def _finite_part(problem: Problem, edges: Array) -> Interval:
    """Return the interval around y = 0 on which the separation is finite, as if the bodies ended there."""
    ends = []
    for beyond in (edges[edges <= 0.0][::-1], edges[edges >= 0.0]):
        finite = np.isfinite(problem.model.separation(beyond))
        first = int(np.argmin(finite)) if not np.all(finite) else 0
        inside, outside = (float(beyond[max(first - 1, 0)]), float(beyond[first]))
        for _ in range(100):
            middle = 0.5 * (inside + outside)
            if np.isfinite(problem.model.separation(np.array([middle]))[0]):
                inside = middle
            else:
                outside = middle
        ends.append(outside)
    return ends[0], ends[1]
