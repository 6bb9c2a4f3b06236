"""Building a map: cases are chosen and solved, splines fitted and refined by independent points, errors sampled."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nonhertz.errors import InputError, without_accuracy_warnings
from nonhertz.maps.evaluation import QUANTILES
from nonhertz.maps.fitting import Samples, Shape, fit_surfaces, table
from nonhertz.maps.misses import SAFETY, Misses
from nonhertz.maps.spline import jumps
from nonhertz.maps.spread import spread
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
    """Inputs from which a map is built.

    Attributes
    ----------
    contact : Contact
    element : Element
    threads : int or None
    stations : ndarray
        Edges of the strips whose loads are stored [mm].
    checks : int
        Number of points at which errors are sampled.
    """

    contact: Contact
    element: Element
    threads: int | None
    stations: Array
    checks: int

    def solve(self, name: str, values: Array, tilt: Array) -> Solutions:
        """Solve cases under loads or approaches, without warnings of their solutions."""
        with without_accuracy_warnings():
            prescribed: dict[str, Any] = {name: values}
            return solve_many(self.contact, **prescribed, tilt=tilt, element=self.element, threads=self.threads)

    def sample(self, load: Array, tilt: Array) -> Samples:
        """Solve cases under loads [N] and at tilts [rad]; those that fail are left out."""
        solutions = self.solve("load", load, tilt)
        good = np.flatnonzero(solutions.converged)
        spreads = [spread(self.contact, *solutions.line_load(int(number)), self.stations) for number in good]
        return Samples(
            solutions.load[good], solutions.tilt[good], solutions.approach[good], solutions.moment[good],
            solutions.stiffness[good], solutions.max_pressure[good], solutions.max_half_width[good],
            np.array([places for places, _ in spreads]).reshape(good.size, QUANTILES),
            np.array([loads for _, loads in spreads]).reshape(good.size, self.stations.size - 1),
        )  # fmt: skip


def build_surfaces(
    building: Building, shape: Shape, relief: Relief, accuracy: float, callback: Callable[[str], None]
) -> dict[str, Any]:
    """Solve, fit, check and refine until load and moment are accurate enough or refinement no longer helps.

    Check points are used to build the next surrogate, which is checked at new ones.

    Returns
    -------
    dict
        The fields of a `ContactMap` that result.

    Raises
    ------
    InputError
        If more cases fail than have a solution.
    """
    random = np.random.default_rng(_SEED)
    known: set[tuple[float, float]] = set()
    tried: list[tuple[Misses, Shape]] = []
    samples: Samples | None = None
    failed = 0

    def checked(count: int) -> tuple[Samples, Misses]:
        nonlocal failed
        checks = building.sample(*_check_points(shape, random, count))
        failed += count - checks.load.size
        return checks, Misses.of(shape, table(shape.counted, shape.breaks, *coefficients), building.stations, checks)

    while True:
        load, tilt = _new_nodes(shape, known)
        callback(f"{load.size + (samples.load.size if samples else 0)} cases")
        fresh = building.sample(load, tilt)
        failed += load.size - fresh.load.size
        samples = samples.joined(fresh) if samples else fresh
        if failed > samples.load.size:
            condition = f"not exceed the number of cases with one, {samples.load.size}"
            raise InputError("cases without a solution", failed, condition, "narrow the range of the map")
        coefficients = fit_surfaces(shape, samples, _touch(shape, relief))
        for count in (min(_ROUND_POINTS, building.checks), building.checks):
            checks, misses = checked(count)
            if SAFETY * misses.worst > accuracy:
                break
        else:
            break
        tried.append((misses, shape))
        refined = _refine(shape, coefficients[0], checks, misses.combined, accuracy / SAFETY)
        samples = samples.joined(checks)
        if refined is None or _is_scattered(tried) or samples.load.size > _MOST_CASES:
            shape = _coarsest(tried)
            coefficients = fit_surfaces(shape, samples, _touch(shape, relief))
            _, misses = checked(building.checks)
            break
        shape = refined
    return {
        "numbers": shape.counted, "breaks": np.concatenate(shape.breaks), "half_length": shape.half_length,
        "mean_approach": coefficients[0], "others": coefficients[1],
        "sampled_error": misses.sampled(), "cases": samples.load.size, "failed": failed,
    }  # fmt: skip


def _coarsest(tried: list[tuple[Misses, Shape]]) -> Shape:
    """Return the first shape that is about as good as the best."""
    least = min(misses.typical for misses, _ in tried)
    return next(shape for misses, shape in tried if misses.typical <= _AS_GOOD * least)


def _is_scattered(tried: list[tuple[Misses, Shape]]) -> bool:
    """Return whether the remaining error is the scatter of the solutions: uniform, and no smaller on finer cells."""
    typical = [misses.typical for misses, _ in tried]
    idle = len(typical) > _IDLE_ROUNDS and min(typical[-_IDLE_ROUNDS:]) > _PROGRESS * min(typical[:-_IDLE_ROUNDS])
    return idle and tried[-1][0].worst < _EVEN * float(np.median(tried[-1][0].combined))


def _new_nodes(shape: Shape, known: set[tuple[float, float]]) -> tuple[Array, Array]:
    """Return load and tilt at the nodes of the cells that are not yet in ``known``, and add them to it."""
    x, z = _nodes(shape.breaks[0])[1:], _nodes(shape.breaks[1])
    x[0] = max(x[0], _LEAST_X)
    new = [node for node in ((float(a), float(b)) for a in x for b in z) if node not in known]
    known.update(new)
    places = np.array(new).reshape(-1, 2)
    return shape.prescribed(places[:, 0], places[:, 1])


def _nodes(breaks: Array) -> Array:
    """Return the borders of cells, and the middle of the first and the last."""
    return np.unique([*breaks, 0.5 * (breaks[0] + breaks[1]), 0.5 * (breaks[-2] + breaks[-1])])


def _check_points(shape: Shape, random: np.random.Generator, count: int) -> tuple[Array, Array]:
    """Return random loads and tilts: half of them uniform over the range, half uniform over the cells."""
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


def _touch(shape: Shape, relief: Relief) -> tuple[Array, Array]:
    """Return tilts, four to a cell, and the approaches of first touch at them."""
    borders = shape.breaks[1]
    count = _TOUCH_POINTS * (borders.size - 1)
    z = np.interp(np.arange(count + 1) / _TOUCH_POINTS, np.arange(borders.size), borders)
    _, tilt = shape.prescribed(np.zeros(z.size), z)
    return tilt, relief.touched(tilt)


def _refine(shape: Shape, mean_approach: Array, checks: Samples, errors: Array, permitted: float) -> Shape | None:
    """Return a shape with cells halved around the worst points, in the direction of the larger error.

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
    if max(knots.size for knots in halved) > _MOST_CELLS + 1:
        return None
    return replace(shape, breaks=(halved[0], halved[1]))
