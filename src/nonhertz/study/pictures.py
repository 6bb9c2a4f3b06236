"""Finished figures of studies."""

from __future__ import annotations

import contextlib
import functools
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import describe_load, format_input, of_dimension
from nonhertz.errors import NonhertzError, without_accuracy_warnings
from nonhertz.files.spreads import Distribution
from nonhertz.plot.axes import ROUND, Measure, measure
from nonhertz.plot.sheets import WIDTH
from nonhertz.plot.studies import histogram, profile_band, study_lines, study_map, tornado
from nonhertz.plot.style import sheet_style
from nonhertz.result.quantities import Quantity
from nonhertz.solver.one import solve
from nonhertz.study.design import Design, Front
from nonhertz.study.sweeps import Sweep
from nonhertz.study.tolerances import Index, Tolerance

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

PANELS, PANEL_HEIGHT = 6, 2.3  # in
MOST_TICKS = 5  # of an axis whose numbers may be long
FEW = 6  # lines in one panel; of more values a map is drawn
MOST_DRAWN = 100_000  # rows
LAND = 0.94  # of the length, on which a relief is looked at for the height of its drawing
LEAST_BAND = 0.02  # of the height of a drawing: what is thinner is no band to look at
BAND, PLACES, MOST_PROFILES = (0.025, 0.975), 401, 400
_SECTIONS = ("load", "bearing", "solver", "life")  # of a file, which go without saying
_PICTURED = {"approach", "load", "max_pressure", "max_half_width", "max_load", "reference_life", "modified_life"}


def sweep_figures(sweep: Sweep) -> dict[str, Figure]:
    """Return figures of a sweep by name: lines against one path, maps over two, histograms of samples.

    Of more than two paths, and of more than 100,000 rows, there is none.
    """
    drawing = _drawing(sweep)
    if drawing is None or len(sweep) > MOST_DRAWN:
        return {}
    shown = [quantity for quantity in _pictured(sweep) if sweep.extremes(quantity.name) is not None][:PANELS]
    return (
        {"sweep": panels([functools.partial(drawing, quantity) for quantity in shown], sweep.plan.title)}
        if shown
        else {}
    )


def tolerance_figures(found: Tolerance) -> dict[str, Figure]:
    """Return figures of a tolerance study by name: how results are distributed, what matters, the band of profiles."""
    sweep = found.sweep
    shown = [each for each in found.main if sweep.extremes(each.name) is not None][:PANELS]
    if not shown or len(sweep) > MOST_DRAWN:
        return {}
    figures = {"distribution": panels([_distribution(found, each) for each in shown], sweep.plan.title)}
    indices = [(each, found.indices(each.name)) for each in shown if each in found.results]
    bars = [_indices(each, of_each) for each, of_each in indices if of_each]
    if bars:
        figures["indices"] = panels(bars, sweep.plan.title)
    bands = _bands(sweep)
    if bands:
        figures["profiles"] = panels(bands, sweep.plan.title)
    return figures


def _distribution(found: Tolerance, quantity: Quantity) -> Callable[[Axes], object]:
    intervals = {each.share: (each.low, each.high) for each in found.quantiles(quantity.name)}
    certain = {share: ends for share, ends in intervals.items() if np.all(np.isfinite(ends))}
    limits = [each.limit for each in found.capabilities if each.quantity == quantity.name]
    return lambda ax: _samples(found.samples(quantity.name), quantity, ax, certain, limits)


def _samples(
    values: NDArray[Any],
    quantity: Quantity,
    ax: Axes,
    quantiles: dict[float, tuple[float, float]] | None = None,
    limits: Sequence[float] = (),
) -> object:
    """Draw samples of a quantity, quantiles of them, and limits."""
    drawn = _drawn(quantity, values)
    ends = {share: (float(drawn(low)), float(drawn(high))) for share, (low, high) in (quantiles or {}).items()}
    label = drawn.label(_capital(quantity.label))
    return histogram(drawn(values), ax, label=label, quantiles=ends, limits=[float(drawn(each)) for each in limits])


def _indices(quantity: Quantity, indices: Sequence[Index]) -> Callable[[Axes], object]:
    ends = [[each.first_low, each.first_high, each.total_low, each.total_high] for each in indices]
    first, total, limits = [each.first for each in indices], [each.total for each in indices], np.array(ends).T

    def draw(ax: Axes) -> None:
        tornado([in_words(each.path) for each in indices], first, total, ax, intervals=(limits[:2], limits[2:]))
        ax.set_title(_capital(quantity.label), loc="left")

    return draw


def _bands(sweep: Sweep) -> list[Callable[[Axes], object]]:
    """Return a drawing of the profiles of each body that is varied, those of a contact."""
    template = sweep.plan.template
    if template.is_bearing:
        return []
    found = []
    for name in ("a", "b"):
        mine = [path for path in sweep.paths if path.startswith(f"body.{name}.")]
        if mine:
            found += _band(sweep, name, mine)
    return found


def _band(sweep: Sweep, name: str, paths: Sequence[str]) -> list[Callable[[Axes], object]]:
    template = sweep.plan.template
    nominal = getattr(sweep.plan.case.contact, name)  # type: ignore[union-attr]
    if nominal.length is None:
        return []
    low_end, high_end = nominal.faces
    y = np.linspace(float(low_end), float(high_end), PLACES)
    step = max(1, len(sweep) // MOST_PROFILES)
    columns = [sweep[path].ravel()[::step].tolist() for path in paths]
    reliefs = []
    for values in zip(*columns, strict=True):
        with contextlib.suppress(NonhertzError):
            body = getattr(template.case(dict(zip(paths, values, strict=True))).contact, name)  # type: ignore[union-attr]
            reliefs.append(body.relief(y))
    if not reliefs:
        return []
    samples = np.where(np.isfinite(reliefs), reliefs, np.nan)
    seen = np.all(np.isfinite(samples), axis=0) & np.isfinite(nominal.relief(y))
    low, high = np.quantile(samples[:, seen], BAND, axis=0)
    deepest = _deepest(y[seen], high)
    if np.max((high - low)[_inner(y[seen])]) < LEAST_BAND * deepest:
        return []
    label = f"{100 * (BAND[1] - BAND[0]):g} % of the profiles of body {name}"

    def draw(ax: Axes) -> None:
        profile_band(y[seen], nominal.relief(y[seen]), (low, high), ax, label=label)
        ax.set_ylim(*measure("mm", "um")((deepest, -0.05 * deepest)))

    return [draw]


def _inner(y: NDArray[Any]) -> NDArray[np.bool_]:
    """Return what is not near the ends, where corners are many times as deep as a profile."""
    return np.asarray(np.abs(y - y.mean()) < LAND * 0.5 * np.ptp(y))


def _deepest(y: NDArray[Any], *reliefs: NDArray[Any]) -> float:
    """Return the lower end of an axis of reliefs [mm]."""
    return 1.5 * float(np.nanmax(np.stack(reliefs)[:, _inner(y)]))


def design_figures(found: Design) -> dict[str, Figure]:
    """Return figures of a design by name: pressure and relief before and after, and how the searches went."""
    numbers = _worst_loads(found)
    drawings: list[Callable[[Axes], object]] = [_before_and_after(found, number) for number in numbers]
    y, best, was = found.relief
    deepest = _deepest(y, best, was)

    def relief(ax: Axes) -> None:
        depth = measure("mm", "um")
        _along(y, {"designed": depth(best), "before": depth(was)}, ax, depth.label("Relief"))
        ax.set_ylim(*depth((deepest, -0.05 * deepest)))

    def convergence(ax: Axes) -> None:
        lines = {f"start {k}": start.history for k, start in enumerate(found.starts, start=1) if start.history}
        longest = max(len(values) for values in lines.values())
        padded = {name: np.pad(values, (0, longest - len(values)), mode="edge") for name, values in lines.items()}
        drawn = measure("MPa") if found.goal == "pressure" else measure("")
        label = drawn.label("Largest pressure" if found.goal == "pressure" else "Life over that before")
        padded = {name: drawn(values) for name, values in padded.items()}
        study_lines(np.arange(1, longest + 1), padded, ax, x_label="Points looked at", y_label=label)

    return {"design": panels([*drawings, relief, convergence], found.was.title)}


def front_figure(found: Front, labels: tuple[str, str] = ("first loads", "second loads")) -> Figure:
    """Return a figure of a Pareto front."""
    stress = measure("MPa")
    names = [stress.label(f"Largest pressure, {label}") for label in labels]

    def draw(ax: Axes) -> None:
        study_lines(stress(found.first), {"": stress(found.second)}, ax, x_label=names[0], y_label=names[1])

    return panels([draw], "")


def _worst_loads(found: Design) -> list[int]:
    """Return the numbers of the largest load without tilt, if there is one, and of the largest with the most tilt."""
    upright = [k for k, load in enumerate(found.loads) if load.tilt == 0.0]
    largest = [max(upright, key=lambda k: found.loads[k].load)] if upright else []
    tilted = max(range(len(found.loads)), key=lambda k: (abs(found.loads[k].tilt), found.loads[k].load))
    return [*largest, *([tilted] if tilted not in largest else [])]


def _before_and_after(found: Design, number: int) -> Callable[[Axes], object]:
    load = found.loads[number]

    def draw(ax: Axes) -> None:
        with without_accuracy_warnings():
            after = solve(found.case.contact, load=load.load, tilt=load.tilt, **found.case.solver.keywords)
            lines = {"designed": (after.y, after.centre_pressure)}
            with contextlib.suppress(NonhertzError):
                before = solve(found.was.contact, load=load.load, tilt=load.tilt, **found.was.solver.keywords)
                lines["before"] = (before.y, before.centre_pressure)
        y = np.unique(np.concatenate([each for each, _ in lines.values()]))
        stress = measure("MPa")
        values = {name: stress(np.interp(y, *each, left=0.0, right=0.0)) for name, each in lines.items()}
        _along(y, values, ax, stress.label("Centre-line pressure $p_0$"))
        ax.set_ylim(bottom=0.0)
        ax.set_title(describe_load(load.load, load.tilt), loc="left")

    return draw


def _along(y: NDArray[Any], lines: dict[str, NDArray[Any]], ax: Axes, label: str) -> None:
    """Draw lines along a contact, on an axis from zero."""
    length = measure("mm")
    study_lines(length(y), lines, ax, x_label=length.label("Axial position $y$"), y_label=label)
    ax.set_yscale("linear")


def panels(drawings: Sequence[Callable[[Axes], object]], title: str) -> Figure:
    """Return a figure of several drawings, two side by side; the last of an odd number has the whole width."""
    from matplotlib.figure import Figure
    from matplotlib.ticker import AutoLocator, MaxNLocator

    columns = min(2, len(drawings))
    rows = -(-len(drawings) // columns)
    with sheet_style():
        figure = Figure(figsize=(WIDTH, 0.4 + PANEL_HEIGHT * rows), layout="constrained")
        figure.suptitle(title, x=0.01, ha="left", fontsize=10)
        grid = figure.add_gridspec(rows, columns)
        for number, draw in enumerate(drawings):
            row, column = divmod(number, columns)
            alone = number == len(drawings) - 1 and column == 0
            axes = figure.add_subplot(grid[row, :] if alone else grid[row, column])
            draw(axes)
            for axis in (axes.xaxis, axes.yaxis):
                if isinstance(axis.get_major_locator(), AutoLocator):
                    axis.set_major_locator(MaxNLocator(10 if alone else MOST_TICKS, steps=ROUND))
        # Laid out while the style holds.
        figure.draw_without_rendering()
    return figure


def in_words(path: str) -> str:
    """Return what people call the value at a path.

    Examples
    --------
    >>> in_words("load.load"), in_words("body.a.profile[1].drop"), in_words("bearing.axial_clearance")
    ('Load', 'Body a, profile 1, drop', 'Axial clearance')
    """
    keys = path.replace("body.", "body ").replace("[", " ").replace("]", "").replace("_", " ").split(".")
    return _capital(", ".join(keys[1:] if keys[0] in _SECTIONS and len(keys) > 1 else keys))


def _capital(words: str) -> str:
    return words if words.startswith("d ") else words[:1].upper() + words[1:]  # a derivative is written small


def scaled(path: str, unit: str, values: NDArray[Any]) -> tuple[NDArray[Any], str]:
    """Return values of a path as they are drawn, and the label of their axis."""
    if values.dtype.kind not in "iuf":
        return values, in_words(path)
    drawn = Measure(*of_dimension(values.tolist(), unit).scale)
    return drawn(values), drawn.label(in_words(path))


def _drawn(quantity: Quantity, values: NDArray[Any]) -> Measure:
    """Return how numbers of a quantity are drawn: in the unit that suits the largest of them."""
    return Measure(*quantity.amount(*values[np.isfinite(values)].tolist()).scale)


def _pictured(sweep: Sweep) -> tuple[Quantity, ...]:
    """Return the quantities that are drawn: those asked for by name, or the main ones that are not given."""
    if sweep.plan.quantities:
        return sweep.quantities
    return tuple(each for each in sweep.quantities if each.name in _PICTURED - sweep.given)


def _drawing(sweep: Sweep) -> Callable[[Quantity, Axes], object] | None:
    """Return what draws a quantity; None if there is no picture of so many paths."""
    if any(isinstance(spread, Distribution) for spread in sweep.plan.spreads.values()):
        if len(sweep.shape) > 1:
            return None
        return lambda quantity, ax: _samples(sweep[quantity.name], quantity, ax)
    lists = [np.asarray(sweep.plan.spreads[path]) for path in sweep.paths]
    longer = [(path, values) for path, values in zip(sweep.paths, lists, strict=True) if values.size > 1]
    if len(longer) == 1:
        return _of_one(sweep, *longer[0])
    return _of_two(sweep, longer) if len(longer) == 2 else None


def _of_one(sweep: Sweep, path: str, values: NDArray[Any]) -> Callable[[Quantity, Axes], object]:
    x, label = scaled(path, sweep.unit(path), values)

    def draw(quantity: Quantity, ax: Axes) -> object:
        numbers = sweep[quantity.name].ravel()
        drawn = _drawn(quantity, numbers)
        return study_lines(x, {"": drawn(numbers)}, ax, x_label=label, y_label=drawn.label(_capital(quantity.label)))

    return draw


def _of_two(sweep: Sweep, axes: Sequence[tuple[str, NDArray[Any]]]) -> Callable[[Quantity, Axes], object]:
    (first, one), (second, other) = axes
    sizes = one.size, other.size
    words = [values.dtype.kind not in "iuf" for values in (one, other)]
    # Lines are named by the path with few values or words, the other is the axis below.
    by_first = words[0] or (sizes[0] <= FEW and not words[1] and sizes[0] <= sizes[1])
    named, below = ((first, one), (second, other)) if by_first else ((second, other), (first, one))
    x, x_label = scaled(below[0], sweep.unit(below[0]), below[1])
    y, y_label = scaled(named[0], sweep.unit(named[0]), named[1])

    def draw(quantity: Quantity, ax: Axes) -> object:
        drawn = _drawn(quantity, sweep[quantity.name])
        numbers, label = drawn(sweep[quantity.name]).reshape(sizes), drawn.label(_capital(quantity.label))
        numbers = numbers if by_first else numbers.T
        if named[1].size > FEW and not any(words):
            return study_map(x, y, numbers, ax, x_label=x_label, y_label=y_label, label=label)
        key, _, unit = y_label.partition(" [")
        unit = unit.rstrip("]")
        names = [
            str(value) if isinstance(value, str | bool) else f"{format_input(value)} {unit}".rstrip()
            for value in y.tolist()
        ]
        lines = dict(zip(names, numbers, strict=True))
        return study_lines(x, lines, ax, x_label=x_label, y_label=label, key=key)

    return draw
