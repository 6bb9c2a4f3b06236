"""Samples of the gap: where the undeformed bodies are closest, and where they would overlap beyond the region.

A gap is known only by its values, so it is sampled: evenly along bodies that end, elsewhere evenly near the middle and
at growing distances away from it, and again over every `Dent`. A gap with user functions may have bumps anywhere,
and is also scanned in nested windows, each four times the size of the previous one. The lowest sample is refined by
windows an eighth of the size each. A bump between the samples is not detected; docs/explain/patch.md gives their
spacing.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nonhertz.bodies.influence import FreeSide
from nonhertz.errors import InputError
from nonhertz.patch.cascade import Outcome, PatchProblem
from nonhertz.patch.features import Dent
from nonhertz.patch.free_faces import at_points, merge_faces
from nonhertz.patch.grid import Grid, Span
from nonhertz.patch.kernel import rectangles
from nonhertz.patch.surface import Gap, Surface

Array = NDArray[np.float64]
Lumps = tuple[Array, Array, Array, float]

EVENLY, EVEN_REACH = 65, 8.0  # samples, and the half-widths they reach to either side
APART, NEAREST = 64, 1e-3  # geometrically spaced samples, and the half-widths at which they start
ALONG, OVER_DENT, CLOSER = 257, 17, 17
MOST_CLOSER = 24
# Samples in each direction of a scan window, and how much larger each window is than the previous one: at a distance s
# from the middle of a scan, samples are at most s / 48 apart.
SCANNED, MOST_SCANNED, LARGER = 385, 2049, 4.0
SCANNED_AT_ONCE = 2**17
LUMPS, SMALL_LUMPS = (12, 48), (24, 96)
# Overlaps as fractions of the largest displacement: worth a closer look, worth enlarging the region, worth a warning.
SUSPECT, SEEN, CLEAR = 0.03, 0.003, 0.01
# Cells from the border within which lumps of cells are too coarse for small overlaps, and overlaps still seen there.
NEAR, SEEN_NEAR = 2.0, 0.015
MOST_SUSPECTS = 100
AT_ONCE = 2**15  # distances
PER_DISTANCE = 16  # numbers that the correction for free side faces needs for each


@dataclass(frozen=True, eq=False)
class Window:
    """A grid of samples: all pairs of x and y [mm], each ascending."""

    x: Array
    y: Array

    def of(self, gap: Gap, tilt: float) -> Array:
        """Return gap - tilt y [mm] at all samples, shape (nx, ny)."""
        nearness: Array = gap(self.x[:, None], self.y[None, :]) - tilt * self.y
        return nearness


@dataclass(frozen=True)
class Lowest:
    """The point where gap - tilt y is smallest: x, y and the value [mm]."""

    x: float
    y: float
    value: float


@dataclass(frozen=True)
class Overlap:
    """Overlap of the deformed bodies beyond the region: the deepest point, and a rectangle around all overlaps."""

    x: float
    y: float
    depth: float
    x_span: Span
    y_span: Span


def windows(surface: Surface, width: float, reach: float) -> tuple[Window, ...]:
    """Return windows in which to sample bodies for a contact about 2 ``width`` wide."""
    interval = surface.contact.interval
    y = np.linspace(*interval, ALONG) if np.all(np.isfinite(interval)) else _spread(width, 1e4 * width + reach)
    near_edges = [Window(_spread(width, reach), np.unique(np.clip(np.append(y, 0.0), *interval)))]
    for dent in surface.features:
        if isinstance(dent, Dent):
            half = 0.5 * float(dent.shoulder_diameter or dent.diameter)
            x, y = (np.linspace(middle - half, middle + half, OVER_DENT) for middle in (dent.x, dent.y))
            near_edges.append(Window(x, np.unique(np.clip(y, *interval))))
    return tuple(near_edges)


def scan(grid: Grid, reach: tuple[float, float]) -> Iterator[Window]:
    """Yield nested windows about the region of a grid; the first is twice its size, with two samples per cell.

    Windows are split into parts that take little memory; each shares its last row of samples with the next. ``reach``
    is the distance to scan from the middle, across and along [mm].
    """
    x_half, y_half = float(np.ptp(grid.x_span)), float(np.ptp(grid.y_span))
    x, y, interval = 0.5 * sum(grid.x_span), 0.5 * sum(grid.y_span), grid.interval
    samples = [min(max(4 * n + 1, SCANNED), MOST_SCANNED) for n in grid.cells]
    while True:
        low, high = max(y - min(y_half, reach[1]), interval[0]), min(y + min(y_half, reach[1]), interval[1])
        wide, long = x_half >= reach[0], y_half >= reach[1] or (low, high) == interval
        x_half = min(x_half, reach[0])
        across, along = np.linspace(x - x_half, x + x_half, samples[0]), np.linspace(low, high, samples[1])
        step = max(SCANNED_AT_ONCE // along.size, 2)
        for start in range(0, across.size - 1, step):
            yield Window(across[start : start + step + 1], along)
        if wide and long:
            return
        x_half, y_half, samples = LARGER * x_half, LARGER * y_half, [SCANNED, SCANNED]


def find_lowest(gap: Gap, tilt: float, several: Iterable[Window]) -> Lowest:
    """Return the lowest point, refined from the lowest sample."""
    place, window = min((_lowest_sample(gap, tilt, window) for window in several), key=lambda sample: sample[0].value)
    for _ in range(MOST_CLOSER):
        closer, window = _lowest_sample(gap, tilt, window)
        place = closer if closer.value < place.value else place
        if max(np.ptp(window.x), np.ptp(window.y)) < 1e-12:
            break
    return place


def penetration(gap: Gap, grid: Grid, approach: float, tilt: float) -> float:
    """Return the largest interference of the undeformed bodies within the region [mm]."""
    y = np.concatenate([grid.y_span[:1], grid.y, grid.y_span[1:]])
    return approach - find_lowest(gap, tilt, (Window(grid.x, y),)).value


def extent(gap: Gap, tilt: float, approach: float, at: Lowest, several: tuple[Window, ...]) -> tuple[Span, Span]:
    """Return a rectangle that contains the undeformed overlap around the lowest point, and all overlapping samples."""
    low, high = several[0].y[0], several[0].y[-1]
    steps = np.geomspace(1e-9, 1.0, 240)
    x_reach, y_reach = float(np.ptp(several[0].x)), float(high - low)
    ends = []
    for sign, along in ((-1.0, False), (1.0, False), (-1.0, True), (1.0, True)):
        x = at.x + sign * x_reach * steps if not along else np.array([at.x])
        y = np.clip(at.y + sign * y_reach * steps, low, high) if along else np.array([at.y])
        over = (gap(x[:, None], y[None, :]) - tilt * y).ravel() < approach
        last = steps.size - 1 if over.all() else int(np.argmin(over))
        ends.append(float((y if along else x)[last]))
    x_span, y_span = (ends[0], ends[1]), (ends[2], ends[3])
    for window in several:
        over = window.of(gap, tilt) < approach
        if over.any():
            x_over, y_over = window.x[over.any(axis=1)], window.y[over.any(axis=0)]
            x_span = min(x_span[0], float(x_over[0])), max(x_span[1], float(x_over[-1]))
            y_span = min(y_span[0], float(y_over[0])), max(y_span[1], float(y_over[-1]))
    return x_span, y_span


def finite_rows(gap: Gap, several: Iterable[Window]) -> tuple[Array, Span]:
    """Return the y at which a gap is finite for some sampled x, ascending, and the next samples beyond them [mm].

    Raises
    ------
    InputError
        If the gap is finite nowhere.
    """
    rows = [(window.y, np.isfinite(window.of(gap, 0.0)).any(axis=0)) for window in several]
    sampled = np.unique(np.concatenate([y for y, _ in rows]))
    rows_known = np.unique(np.concatenate([y[known] for y, known in rows]))
    if not rows_known.size:
        remedy = "let it return a gap in mm near x = 0, y = 0, or give a region around the place where it does"
        raise InputError("gap", np.inf, "be finite somewhere", remedy)
    first, last = np.searchsorted(sampled, rows_known[[0, -1]])
    return rows_known, (float(sampled[max(first - 1, 0)]), float(sampled[min(last + 1, sampled.size - 1)]))


def least_closing_approach(gap: Gap, window: Window) -> float:
    """Return the approach [mm] at which bodies that are free to tilt begin to touch without a moment.

    It is where the lower convex hull of the gap over y crosses the line y = 0: below it, some tilt keeps them apart.
    """
    y, least = window.y, np.min(window.of(gap, 0.0), axis=0)
    at_zero = least[y == 0.0]
    below, above = y < 0.0, y > 0.0
    values = [float(at_zero.min(initial=np.inf))]
    if below.any() and above.any():
        y_low, y_high = y[below][:, None], y[above][None, :]
        with np.errstate(invalid="ignore"):
            crossing = (least[below][:, None] * y_high - least[above][None, :] * y_low) / (y_high - y_low)
        values.append(float(np.min(crossing)))
    return min(values)


def find_overlap(
    problem: PatchProblem, outcome: Outcome, several: Iterable[Window], *, smooth: bool, region_given: bool = False
) -> Overlap | None:
    """Return the sampled overlap of the deformed bodies beyond the region of a solution.

    The pressure is first replaced by point forces on lumps of cells; at suspect points, by uniform pressure on smaller
    lumps. Close to the border only large overlaps count, and none of ``smooth`` bodies, which would overlap within the
    region as well; a region given by the user (``region_given``) tolerates a larger overlap.
    """
    grid, state, surface = outcome.grid, outcome.state, problem.gap
    if not state.pressure.any():
        return None
    largest = outcome.largest_displacement(surface(*grid.centres))
    overlaps: list[Overlap] = []
    least, margin = CLEAR if region_given else SEEN, NEAR if smooth else 0.0
    coarse, (terms, faces) = (
        _lumps(grid, state.pressure),
        (problem.influence.terms, merge_faces(problem.influence.faces)),
    )
    images = terms[(terms[:, :2] != (1.0, 0.0)).any(axis=1)]
    for window in several:
        gap = window.of(surface, state.rigid[1]) - state.rigid[0] - _sink(problem, grid, state.pressure, window.y)
        at = np.argwhere(_outside(window, grid, margin) & (gap < 0.0))
        if not at.size:
            continue
        x, y = window.x[at[:, 0]], window.y[at[:, 1]]
        gap = gap[tuple(at.T)]
        separation = gap + _displacement(terms, (), coarse, x, y)
        # Free faces only increase the displacement, and take longer.
        suspects = np.flatnonzero(separation < SUSPECT * largest)
        separation[suspects] += _displacement(terms[:0], faces, coarse, x[suspects], y[suspects])
        chosen = _choose_suspects(at, separation, suspects[separation[suspects] < SUSPECT * largest])
        at, x, y = at[chosen], x[chosen], y[chosen]
        separation = (
            gap[chosen] + _displacement(images, faces, coarse, x, y) + _displacement_nearby(grid, state.pressure, x, y)
        )
        far = _outside(window, grid, NEAR)
        for i, j, depth in zip(*at.T, -separation, strict=True):
            if depth > (least if far[i, j] else SEEN_NEAR) * largest:
                around = _neighbours(window.x, i), _neighbours(window.y, j)
                overlaps.append(Overlap(float(window.x[i]), float(window.y[j]), float(depth), *around))
    if not overlaps:
        return None
    deepest = max(overlaps, key=lambda candidate: candidate.depth)
    x_span = min(candidate.x_span[0] for candidate in overlaps), max(candidate.x_span[1] for candidate in overlaps)
    y_span = min(candidate.y_span[0] for candidate in overlaps), max(candidate.y_span[1] for candidate in overlaps)
    return Overlap(deepest.x, deepest.y, deepest.depth, x_span, y_span)


def _choose_suspects(at: NDArray[np.intp], separation: Array, suspects: NDArray[np.intp]) -> NDArray[np.intp]:
    """Return the suspects to examine: the lowest, and the outermost, which decide the extent of the region."""
    if suspects.size <= MOST_SUSPECTS:
        return suspects
    most = MOST_SUSPECTS // 2, MOST_SUSPECTS // 8
    x, y = at[suspects].T
    several = [np.argsort(separation[suspects])[: most[0]]]
    several += [
        order[part] for order in (np.argsort(x), np.argsort(y)) for part in (np.s_[: most[1]], np.s_[-most[1] :])
    ]
    return suspects[np.unique(np.concatenate(several))]


def _spread(width: float, reach: float) -> Array:
    """Return places evenly spaced about zero, then at growing distances up to a reach."""
    away = np.geomspace(NEAREST * width, max(reach, 2.0 * EVEN_REACH * width), APART)
    return np.unique(np.concatenate([-away, np.linspace(-EVEN_REACH * width, EVEN_REACH * width, EVENLY), away]))


def _lowest_sample(gap: Gap, tilt: float, window: Window) -> tuple[Lowest, Window]:
    """Return the lowest sample of a window, and the window that its neighbours enclose."""
    values = window.of(gap, tilt)
    i, j = divmod(int(np.argmin(values)), window.y.size)
    place = Lowest(float(window.x[i]), float(window.y[j]), float(values[i, j]))
    x, y = _neighbours(window.x, i), _neighbours(window.y, j)
    return place, Window(np.linspace(*x, CLOSER), np.linspace(*y, CLOSER))


def _neighbours(places: Array, index: int) -> Span:
    return float(places[max(index - 1, 0)]), float(places[min(index + 1, places.size - 1)])


def _outside(window: Window, grid: Grid, cells: float) -> NDArray[np.bool_]:
    """Return which samples of a window are more than so many cells beyond a region, shape (nx, ny)."""
    across, along = (
        (places < span[0] - cells * side) | (places > span[1] + cells * side)
        for places, span, side in ((window.x, grid.x_span, grid.dx), (window.y, grid.y_span, grid.dy))
    )
    return np.asarray(across[:, None] | along)


def _starts(grid: Grid, most: tuple[int, int]) -> list[NDArray[np.int64]]:
    """Return the first cell of every lump of cells, for each direction."""
    return [
        np.linspace(0, n, min(n, m), endpoint=False).astype(np.int64) for n, m in zip(grid.cells, most, strict=True)
    ]


def _lumps(grid: Grid, pressure: Array) -> Lumps:
    """Return forces times K that replace the pressure, shape (lumps,), their positions, and the lump size [mm]."""
    starts = _starts(grid, LUMPS)

    def summed(field: Array) -> Array:
        total: Array = np.add.reduceat(np.add.reduceat(field, starts[0], axis=0), starts[1], axis=1).ravel()
        return total

    force = summed(pressure)
    acting = force > 0.0
    force = force[acting]
    x = summed(pressure * grid.x[:, None])[acting] / force
    y = summed(pressure * grid.y)[acting] / force
    size = max(grid.dx * grid.cells[0] / starts[0].size, grid.dy * grid.cells[1] / starts[1].size)
    return force * grid.dx * grid.dy, x, y, size


def _displacement(terms: Array, faces: tuple[FreeSide, ...], lumps: Lumps, x: Array, y: Array) -> Array:
    """Return the displacement at places by forces with their images and free side faces, shape (places,)."""
    force, x_force, y_force, size = lumps
    total: Array = np.zeros(x.size)
    block = max(AT_ONCE // ((PER_DISTANCE if faces else 1) * force.size), 1)
    for start in range(0, x.size, block):
        at = slice(start, start + block)
        for sign, offset, weight in terms.tolist():
            squared = np.square(x[at, None] - x_force)
            squared += np.square(y[at, None] - (sign * y_force + offset))
            np.maximum(squared, (0.25 * size) ** 2, out=squared)
            np.sqrt(squared, out=squared)
            np.reciprocal(squared, out=squared)
            total[at] += weight * (squared @ force)
        if faces:
            total[at] += at_points(faces, x[at], y[at], x_force, y_force) @ force
    return total


def _displacement_nearby(grid: Grid, pressure: Array, x: Array, y: Array) -> Array:
    """Return the displacement at places without images, under uniform pressure on small lumps, shape (places,)."""
    starts = _starts(grid, SMALL_LUMPS)
    x_at, y_at = (np.append(start, n) for start, n in zip(starts, grid.cells, strict=True))
    mean = np.add.reduceat(np.add.reduceat(pressure, starts[0], axis=0), starts[1], axis=1)
    mean /= np.diff(x_at)[:, None] * np.diff(y_at)
    x_edges, y_edges = grid.x_span[0] + grid.dx * x_at, grid.y_edges[y_at]
    return np.array([np.vdot(rectangles(x_edges - a, y_edges - b), mean) for a, b in zip(x, y, strict=True)])


def _sink(problem: PatchProblem, grid: Grid, pressure: Array, y: Array) -> Array:
    """Return the displacement of the points at depth, shape (places,)."""
    if not problem.influence.references:
        return np.zeros(y.size)
    starts = np.linspace(0, grid.cells[1], min(grid.cells[1], 64), endpoint=False).astype(int)
    edges = grid.y_edges[np.append(starts, grid.cells[1])]
    load = np.add.reduceat(pressure.sum(axis=0), starts) * grid.dx * grid.dy / np.diff(edges)
    sunk: Array = problem.influence.at_depth(y, edges) @ load
    return sunk
