"""A map built: cases chosen and solved, splines fitted and refined where points of their own say so, errors sampled."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nonhertz.errors import InputError, without_accuracy_warnings
from nonhertz.maps.evaluation import QUANTILES, Tables
from nonhertz.maps.fitting import Samples, Shape, Touch, fitted, tables
from nonhertz.maps.misses import SAFETY, Misses, SampledErrors
from nonhertz.maps.spline import jumps
from nonhertz.maps.spread import Spread
from nonhertz.maps.touch import Relief
from nonhertz.model.contact import Contact
from nonhertz.solver.many import solve_many
from nonhertz.solver.solutions import Solutions
from nonhertz.strip.element import Element

Array = NDArray[np.float64]

FIRST_CELLS = 4, 6
_MOST_CELLS = 60  # in each direction
_MOST_CASES = 3000
_ROUND_POINTS = 60
_IDLE_ROUNDS, _PROGRESS, _AS_GOOD = 2, 0.7, 1.3
_EVEN = 8.0  # the largest of many scattered errors over their median
# Fractions of the largest error, of the permitted one, and of the estimate in the other direction.
_WORST, _NEARLY, _DIRECTION = 0.3, 0.7, 0.3
_TOUCH_POINTS = 4  # per cell
_SEED = 20240229
_LEAST_X = 0.02


@dataclass(frozen=True)
class Building:
    """What a map is built of.

    Attributes
    ----------
    contact : Contact
    element : Element
    threads : int or None
    stations : ndarray
        Edges of the strips whose loads are kept [mm].
    checks : int
        Number of points that errors are sampled at.
    """

    contact: Contact
    element: Element
    threads: int | None
    stations: Array
    checks: int

    def pressed(self, name: str, values: Array, tilt: Array) -> Solutions:
        """Solve cases under loads or approaches; what their solutions warn of is left to single solves."""
        with without_accuracy_warnings():
            given: dict[str, Any] = {name: values}
            return solve_many(self.contact, **given, tilt=tilt, element=self.element, threads=self.threads)

    def solved(self, load: Array, tilt: Array) -> Samples:
        """Solve cases under loads [N] and at tilts [rad]; those that fail are left out."""
        if load.size == 0:
            none = np.empty(0)
            along = np.empty((0, QUANTILES)), np.empty((0, self.stations.size - 1))
            return Samples(none, none, none, none, np.empty((0, 2, 2)), none, none, *along)
        found = self.pressed("load", load, tilt)
        good = np.flatnonzero(found.converged)
        spreads = [Spread.of(self.contact, *found.line_load(int(number))) for number in good]
        return Samples(
            found.load[good], found.tilt[good], found.approach[good], found.moment[good], found.stiffness[good],
            found.max_pressure[good], found.max_half_width[good],
            np.array([each.places for each in spreads]).reshape(good.size, -1),
            np.array([each.loads_between(self.stations) for each in spreads]).reshape(good.size, -1),
        )  # fmt: skip


@dataclass(frozen=True)
class Built:
    """A stand-in with what is known about it."""

    shape: Shape
    mean_approach: Array
    others: Array
    tables: Tables
    sampled_error: SampledErrors
    cases: int
    failed: int


def built(building: Building, shape: Shape, relief: Relief, accuracy: float, announce: Callable[[str], None]) -> Built:
    """Solve, fit, check and refine until load and moment are accurate enough or refinement no longer helps.

    Points that a check was made on are used to build the next stand-in, which is checked on new ones.

    Raises
    ------
    InputError
        If fewer cases have a solution than have none.
    """
    random = np.random.default_rng(_SEED)
    asked: set[tuple[float, float]] = set()
    samples = building.solved(np.empty(0), np.empty(0))
    tried: list[tuple[Misses, Shape]] = []
    failed = 0
    while True:
        load, tilt = _new_nodes(shape, asked)
        announce(f"{samples.load.size + load.size} cases")
        fresh = building.solved(load, tilt)
        failed += load.size - fresh.load.size
        samples = samples.joined(fresh)
        _refuse_too_few(samples.load.size, failed)
        found, made = _fit(shape, samples, relief)
        for count in (min(_ROUND_POINTS, building.checks), building.checks):
            checks = building.solved(*_check_points(shape, random, count))
            failed += count - checks.load.size
            misses = Misses.of(shape, made, building.stations, checks)
            if SAFETY * misses.worst > accuracy:
                break
        else:
            return Built(shape, *found, made, misses.sampled(), samples.load.size, failed)
        tried.append((misses, shape))
        refined = _refined(shape, found[0], checks, misses.combined, accuracy / SAFETY)
        samples = samples.joined(checks)
        if refined is None or _scattered(tried) or samples.load.size > _MOST_CASES:
            break
        shape = refined
    least = min(misses.typical for misses, _ in tried)
    shape = next(each for misses, each in tried if misses.typical <= _AS_GOOD * least)
    found, made = _fit(shape, samples, relief)
    checks = building.solved(*_check_points(shape, random, building.checks))
    failed += building.checks - checks.load.size
    return Built(
        shape, *found, made, Misses.of(shape, made, building.stations, checks).sampled(), samples.load.size, failed
    )


def _fit(shape: Shape, samples: Samples, relief: Relief) -> tuple[tuple[Array, Array], Tables]:
    found = fitted(shape, samples, _touch(shape, relief))
    return found, tables(shape.counted, shape.breaks, *found)


def _refuse_too_few(solved: int, failed: int) -> None:
    if failed > solved:
        condition = f"not exceed the number of cases with one, {solved}"
        raise InputError("cases without a solution", failed, condition, "narrow the range of the map")


def _scattered(tried: list[tuple[Misses, Shape]]) -> bool:
    """Return whether what is left is the scatter of the solutions: as large everywhere, and no less on finer cells."""
    typical = [misses.typical for misses, _ in tried]
    idle = len(typical) > _IDLE_ROUNDS and min(typical[-_IDLE_ROUNDS:]) > _PROGRESS * min(typical[:-_IDLE_ROUNDS])
    return idle and tried[-1][0].worst < _EVEN * float(np.median(tried[-1][0].combined))


def _new_nodes(shape: Shape, asked: set[tuple[float, float]]) -> tuple[Array, Array]:
    """Return load and tilt at the nodes of the cells that were not asked for before, which are added to ``asked``."""
    x, z = _nodes(shape.loads)[1:], _nodes(shape.tilts)
    x[0] = max(x[0], _LEAST_X)
    new = [node for node in ((float(a), float(b)) for a in x for b in z) if node not in asked]
    asked.update(new)
    places = np.array(new).reshape(-1, 2)
    return shape.prescribed(places[:, 0], places[:, 1])


def _nodes(breaks: Array) -> Array:
    """Return the borders of cells, and the middle of the first and the last."""
    return np.unique([*breaks, 0.5 * (breaks[0] + breaks[1]), 0.5 * (breaks[-2] + breaks[-1])])


def _check_points(shape: Shape, random: np.random.Generator, count: int) -> tuple[Array, Array]:
    """Return random loads and tilts: half of them even over the range, half even over the cells."""
    half = count // 2
    even = random.random((2, half))
    load = shape.max_load * np.maximum(even[0], _LEAST_X**3)
    low, high = shape.tilt_range
    places = [
        np.interp(random.random(count - half) * (breaks.size - 1), np.arange(breaks.size), breaks)
        for breaks in shape.breaks
    ]
    of_cells = shape.prescribed(np.maximum(places[0], _LEAST_X), places[1])
    return np.concatenate([load, of_cells[0]]), np.concatenate([low + (high - low) * even[1], of_cells[1]])


def _touch(shape: Shape, relief: Relief) -> Touch:
    """Return the first touch at tilts four to a cell."""
    count = _TOUCH_POINTS * (shape.tilts.size - 1)
    z = np.interp(np.arange(count + 1) / _TOUCH_POINTS, np.arange(shape.tilts.size), shape.tilts)
    _, tilt = shape.prescribed(np.zeros(z.size), z)
    return Touch(tilt, relief.touched(tilt)[0])


def _refined(shape: Shape, mean_approach: Array, checks: Samples, errors: Array, permitted: float) -> Shape | None:
    """Return a shape with cells halved around the worst points, in the direction that matters there.

    None if no cell can be halved further.
    """
    worst = np.flatnonzero(errors >= min(max(_WORST * errors.max(), _NEARLY * permitted), errors.max()))
    x, z = shape.coordinates(checks.load[worst], checks.tilt[worst])
    by_load, by_tilt = jumps(shape.breaks, mean_approach, (x, z[0]))
    halved = []
    for breaks, place, own, other in zip(shape.breaks, (x, z[0]), (by_load, by_tilt), (by_tilt, by_load), strict=True):
        cells = np.clip(np.searchsorted(breaks, place, side="right") - 1, 0, breaks.size - 2)
        chosen = np.unique(cells[own >= _DIRECTION * other])
        middles = 0.5 * (breaks[chosen] + breaks[chosen + 1])
        halved.append(np.unique(np.concatenate([breaks, middles])))
    if max(each.size for each in halved) > _MOST_CELLS + 1:
        return None
    return replace(shape, loads=halved[0], tilts=halved[1])
