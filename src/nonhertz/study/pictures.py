"""Finished figures of studies."""

from __future__ import annotations

import contextlib
import warnings
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import SI, given
from nonhertz.errors import AccuracyWarning, NonhertzError
from nonhertz.files.spreads import Distribution
from nonhertz.plot.sheets import WIDTH
from nonhertz.plot.studies import histogram, profile_band, study_lines, study_map, tornado
from nonhertz.plot.style import sheet_style
from nonhertz.result.quantities import Quantity
from nonhertz.solver.one import solve
from nonhertz.study.design import Design, Front
from nonhertz.study.objective import named_loads
from nonhertz.study.sweeps import Sweep
from nonhertz.study.tolerances import Index, Tolerance

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

PANELS, PANEL_HEIGHT = 6, 2.3  # in
FEW = 6  # lines in one panel; of more values a map is drawn
MOST_DRAWN = 100_000  # rows
LAND = 0.94  # of the length, on which a relief is looked at for the height of its drawing
BAND, PLACES, MOST_PROFILES = (0.025, 0.975), 401, 400
_PICTURED = {"approach", "load", "max_pressure", "max_half_width", "max_load", "reference", "modified"}
_SMALL = 0.5  # mm, below which people read micrometres
_THOUSANDS = {"N": "kN", "N mm": "N m", "MPa": "GPa"}


def sweep_figures(sweep: Sweep) -> dict[str, Figure]:
    """Return figures of a sweep by name: lines against one path, maps over two, histograms of samples.

    Of more than two paths, and of more than 100,000 rows, there is none.
    """
    drawing = _drawing(sweep)
    if drawing is None or len(sweep) > MOST_DRAWN:
        return {}
    shown = [quantity for quantity in _pictured(sweep) if sweep.extremes(quantity.name) is not None][:PANELS]
    return {"sweep": panels([_panel(drawing, quantity) for quantity in shown], sweep.plan.title)} if shown else {}


def tolerance_figures(found: Tolerance) -> dict[str, Figure]:
    """Return figures of a tolerance study by name: how results are distributed, what matters, the band of profiles."""
    sweep = found.sweep
    shown = [each for each in _pictured(sweep) if sweep.extremes(each.name) is not None][:PANELS]
    if not shown or len(sweep) > MOST_DRAWN:
        return {}
    figures = {"distribution": panels([_distribution(found, each) for each in shown], sweep.plan.title)}
    indices = [(each, found.indices(each.name)) for each in shown]
    bars = [_indices(each, of_each) for each, of_each in indices if of_each]
    if bars:
        figures["indices"] = panels(bars, sweep.plan.title)
    bands = _bands(sweep)
    if bands:
        figures["profiles"] = panels(bands, sweep.plan.title)
    return figures


def _distribution(found: Tolerance, quantity: Quantity) -> Callable[[Axes], object]:
    factor = quantity.factor
    intervals = {each.share: (factor * each.low, factor * each.high) for each in found.quantiles(quantity.name)}
    certain = {share: ends for share, ends in intervals.items() if np.all(np.isfinite(ends))}
    values = factor * found.samples(quantity.name)
    return lambda ax: histogram(values, ax, label=quantity_label(quantity), quantiles=certain)


def _indices(quantity: Quantity, indices: Sequence[Index]) -> Callable[[Axes], object]:
    columns = np.array([(each.first, each.total, each.first_error, each.total_error) for each in indices]).T
    first, total, *errors = columns

    def draw(ax: Axes) -> None:
        tornado([each.path for each in indices], first, total, ax, errors=(errors[0], errors[1]))
        ax.set_title(quantity.label, loc="left")

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
    if np.ptp(high - low) <= 0.0 and not np.any(high > low):
        return []
    label = f"{100 * (BAND[1] - BAND[0]):g} % of the profiles of body {name}"
    return [lambda ax: profile_band(y[seen], nominal.relief(y[seen]), (low, high), ax, label=label)]


def design_figures(found: Design) -> dict[str, Figure]:
    """Return figures of a design by name: pressure and relief before and after, and how the searches went."""
    numbers = _worst_loads(found)
    drawings: list[Callable[[Axes], object]] = [_before_and_after(found, number) for number in numbers]
    y, best, was = found.relief
    # Corners are many times as deep as a profile.
    inner = np.abs(y - y.mean()) < LAND * 0.5 * np.ptp(y)
    deepest = 1.5e3 * float(np.nanmax(np.stack([best, was])[:, inner]))

    def relief(ax: Axes) -> None:
        lines = {"designed": 1e3 * best, "before": 1e3 * was}
        study_lines(y, lines, ax, x_label="y [mm]", y_label="Relief [µm]")
        ax.set_yscale("linear")
        ax.set_ylim(deepest, -0.05 * deepest)

    def convergence(ax: Axes) -> None:
        lines = {
            f"start {k}": np.fmin.accumulate(start.history)
            if found.goal == "pressure"
            else np.fmax.accumulate(start.history)
            for k, start in enumerate(found.starts, start=1)
            if start.history
        }
        longest = max(len(values) for values in lines.values())
        padded = {name: np.pad(values, (0, longest - len(values)), mode="edge") for name, values in lines.items()}
        label = "Largest pressure [MPa]" if found.goal == "pressure" else "Life over that before"
        study_lines(np.arange(1, longest + 1), padded, ax, x_label="Points looked at", y_label=label)

    return {"design": panels([*drawings, relief, convergence], found.was.title)}


def front_figure(found: Front, labels: tuple[str, str] = ("first loads", "second loads")) -> Figure:
    """Return a figure of a Pareto front."""
    names = [f"Largest pressure, {label} [MPa]" for label in labels]

    def draw(ax: Axes) -> None:
        study_lines(found.first, {"": found.second}, ax, x_label=names[0], y_label=names[1])

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
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", AccuracyWarning)
            after = solve(found.case.contact, load=load.load, tilt=load.tilt, **found.case.solver)
            lines = {"designed": (after.y, after.centre_pressure)}
            with contextlib.suppress(NonhertzError):
                before = solve(found.was.contact, load=load.load, tilt=load.tilt, **found.was.solver)
                lines["before"] = (before.y, before.centre_pressure)
        y = np.unique(np.concatenate([each for each, _ in lines.values()]))
        values = {name: np.interp(y, *each, left=0.0, right=0.0) for name, each in lines.items()}
        study_lines(y, values, ax, x_label="y [mm]", y_label="Pressure [MPa]")
        ax.set_yscale("linear")
        ax.set_ylim(bottom=0.0)
        ax.set_title(named_loads([load])[0], loc="left")

    return draw


def panels(drawings: Sequence[Callable[[Axes], object]], title: str) -> Figure:
    """Return a figure of several drawings, two side by side."""
    from matplotlib.figure import Figure

    columns = min(2, len(drawings))
    rows = -(-len(drawings) // columns)
    with sheet_style():
        figure = Figure(figsize=(WIDTH, 0.4 + PANEL_HEIGHT * rows), layout="constrained")
        figure.suptitle(title, x=0.01, ha="left", fontsize=10)
        for number, draw in enumerate(drawings, start=1):
            draw(figure.add_subplot(rows, columns, number))
        # Laid out while the style holds.
        figure.draw_without_rendering()
    return figure


def scaled(name: str, unit: str, values: NDArray[Any]) -> tuple[NDArray[Any], str]:
    """Return values of a path in a unit that people read them in, and the label of their axis."""
    if values.dtype.kind not in "iuf":
        return values, name
    largest = float(np.nanmax(np.abs(values), initial=0.0))
    factor, shown = 1.0, unit
    if unit == "mm" and largest < _SMALL:
        factor, shown = 1e3, "um"
    elif unit == "rad" and largest < 1.0:
        factor, shown = 1e3, "mrad"
    elif unit in _THOUSANDS and largest >= 1e4:
        factor, shown = 1e-3, _THOUSANDS[unit]
    return factor * values, f"{name} [{shown}]" if shown else name


def quantity_label(quantity: Quantity) -> str:
    """Return the label of a quantity's axis."""
    label = quantity.label[:1].upper() + quantity.label[1:]
    unit = SI.of(quantity.shown_unit)[0]
    return f"{label} [{unit}]" if unit else label


def _panel(drawing: Callable[[Quantity, Axes], object], quantity: Quantity) -> Callable[[Axes], object]:
    return lambda ax: drawing(quantity, ax)


def _pictured(sweep: Sweep) -> tuple[Quantity, ...]:
    """Return the quantities that are drawn: those asked for by name, or the main ones that are not given."""
    if sweep.plan.quantities:
        return sweep.quantities
    given_ones = {path.partition(".")[2] for path in sweep.paths if path.startswith("load.")}
    given_ones |= set(sweep.plan.template.document.get("load", {}))
    return tuple(each for each in sweep.quantities if each.name in _PICTURED - given_ones)


def _drawing(sweep: Sweep) -> Callable[[Quantity, Axes], object] | None:
    """Return what draws a quantity; None if there is no picture of so many paths."""
    if any(isinstance(spread, Distribution) for spread in sweep.plan.spreads.values()):
        if len(sweep.shape) > 1:
            return None
        return lambda quantity, ax: histogram(
            quantity.factor * sweep[quantity.name], ax, label=quantity_label(quantity)
        )
    lists = [np.asarray(sweep.plan.spreads[path]) for path in sweep.paths]
    longer = [(path, values) for path, values in zip(sweep.paths, lists, strict=True) if values.size > 1]
    if len(longer) == 1:
        return _of_one(sweep, *longer[0])
    return _of_two(sweep, longer) if len(longer) == 2 else None


def _of_one(sweep: Sweep, path: str, values: NDArray[Any]) -> Callable[[Quantity, Axes], object]:
    x, label = scaled(path, sweep.unit(path), values)

    def draw(quantity: Quantity, ax: Axes) -> object:
        numbers = quantity.factor * sweep[quantity.name].ravel()
        return study_lines(x, {"": numbers}, ax, x_label=label, y_label=quantity_label(quantity))

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
        numbers = quantity.factor * sweep[quantity.name].reshape(sizes)
        numbers = numbers if by_first else numbers.T
        if named[1].size > FEW and not any(words):
            return study_map(x, y, numbers, ax, x_label=x_label, y_label=y_label, label=quantity_label(quantity))
        key, _, unit = y_label.partition(" [")
        unit = unit.rstrip("]")
        names = [
            str(value) if isinstance(value, str | bool) else f"{given(value)} {unit}".rstrip() for value in y.tolist()
        ]
        lines = dict(zip(names, numbers, strict=True))
        return study_lines(x, lines, ax, x_label=x_label, y_label=quantity_label(quantity), key=key)

    return draw
