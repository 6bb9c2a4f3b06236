"""Figures of studies."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import describe_load, format_input, of_dimension
from nonhertz.errors import NonhertzError, without_accuracy_warnings
from nonhertz.figures.studies import (
    Array,
    distribution,
    fit_axis,
    lines_over,
    map_over,
    profile_band,
    variance_shares,
)
from nonhertz.figures.value import Axis, Figure, Panel
from nonhertz.files.casefile import Case
from nonhertz.files.spreads import Distribution
from nonhertz.life import ContactLoadCase
from nonhertz.result.quantities import Quantity
from nonhertz.solver.one import solve
from nonhertz.study.design import Design, Front
from nonhertz.study.objective import PRESSURE
from nonhertz.study.sweeps import Sweep
from nonhertz.study.tolerances import Tolerance

MOST_PANELS = 6
FEW = 6  # lines in one panel; more values are drawn as a map, of more searches only the best
MOST_DRAWN = 100_000  # rows
LAND = 0.94  # of the length: the part of a relief that determines the height of its drawing
LEAST_BAND = 0.02  # of the height of a drawing: thinner bands are not drawn
BAND, PLACES, MOST_PROFILES = (0.025, 0.975), 401, 400
_SECTIONS = ("load", "bearing", "solver", "life")  # of a file; omitted in labels
_PICTURED = {"approach", "load", "max_pressure", "max_half_width", "max_load", "reference_life", "modified_life"}
_ALONG = Axis("Axial position y", "y", "mm")
_PRESSURE = Axis("Centre-line pressure p₀", "p₀", "MPa")


def sweep_figures(sweep: Sweep) -> dict[str, Figure]:
    """Return figures of a sweep by name: lines against one path, maps over two, histograms of samples.

    There is none for more than two paths, or more than 100,000 rows.
    """
    panel_of = _panel_of(sweep)
    if panel_of is None or len(sweep) > MOST_DRAWN:
        return {}
    shown = [quantity for quantity in _quantities_drawn(sweep) if sweep.extremes(quantity.name) is not None][
        :MOST_PANELS
    ]
    over = " and ".join(in_words(path).lower() for path in sweep.paths)
    return _figure("sweep", [panel_of(quantity) for quantity in shown], f"Results over {over}.")


def tolerance_figures(tolerance: Tolerance) -> dict[str, Figure]:
    """Return figures of a tolerance study by name: distributions, influences, and the band of profiles."""
    sweep = tolerance.sweep
    shown = [quantity for quantity in tolerance.main if sweep.extremes(quantity.name) is not None][:MOST_PANELS]
    if not shown or len(sweep) > MOST_DRAWN:
        return {}
    results = [quantity for quantity in shown if quantity in tolerance.results and tolerance.indices(quantity.name)]
    captions = (
        "Distributions of results: quantiles with confidence intervals, and limits.",
        "Share of the variance due to each input, alone and in total, with confidence intervals.",
        "Profiles of the samples.",
    )
    return {
        **_figure("distribution", [_distribution(tolerance, quantity) for quantity in shown], captions[0]),
        **_figure("indices", [_indices(tolerance, quantity) for quantity in results], captions[1]),
        **_figure("profiles", _bands(sweep), captions[2]),
    }


def design_figures(design: Design) -> dict[str, Figure]:
    """Return figures of a design by name: pressure and relief before and after, and the progress of the searches."""
    y, best, before = design.relief
    relief = lines_over(_ALONG, y, {"designed": best, "before": before}, Axis("Relief", "relief", "mm", "um"))
    panels = [*(_before_and_after(design, load) for load in _worst_loads(design)), _on_land(relief, y, best, before)]
    panels.append(_convergence(design))
    return _figure("design", panels, "Pressure and relief of the design and of the case before, and its searches.")


def front_figures(front: Front, groups: tuple[str, str] = ("first loads", "second loads")) -> dict[str, Figure]:
    """Return the figure of a Pareto front, ``"front"``: one pressure over the other, under both groups of loads."""
    along, upright = (Axis(f"Maximum pressure, {group}", group, "MPa") for group in groups)
    panel = lines_over(along, np.array(front.first), {"": np.array(front.second)}, upright)
    words = f"No design has less pressure under {groups[0]} without more under {groups[1]}."
    return _figure("front", [replace(panel, name="front", height=260)], words)


def _figure(name: str, panels: Sequence[Panel], caption: str) -> dict[str, Figure]:
    """Return a figure of panels, two beside each other, by its name; none of none."""
    if not panels:
        return {}
    along = panels[0].along
    assert along is not None
    beside = [replace(panel, beside=number % 2 == 1) for number, panel in enumerate(panels)]
    return {name: Figure(along, beside, caption=caption)}


def _distribution(tolerance: Tolerance, quantity: Quantity) -> Panel:
    ends = {quantile.probability: (quantile.low, quantile.high) for quantile in tolerance.quantiles(quantity.name)}
    certain = {share: interval for share, interval in ends.items() if np.all(np.isfinite(interval))}
    limits = [capability.limit for capability in tolerance.capabilities if capability.quantity == quantity.name]
    return distribution(axis_of(quantity), tolerance.samples(quantity.name), certain, limits)


def _indices(tolerance: Tolerance, quantity: Quantity) -> Panel:
    indices = tolerance.indices(quantity.name)
    names = ("first", "total", "first_low", "first_high", "total_low", "total_high")
    first, total, *ends = np.array([[getattr(index, name) for name in names] for index in indices]).T
    intervals = np.array(ends[:2]), np.array(ends[2:])
    panel = variance_shares([in_words(index.path) for index in indices], first, total, intervals)
    return replace(panel, name=quantity.name, heading=_capital(quantity.label))


def _bands(sweep: Sweep) -> list[Panel]:
    """Return the profiles of each body that is varied, those of a contact."""
    if not isinstance(sweep.plan.case, Case):
        return []
    varied = {name: [path for path in sweep.paths if path.startswith(f"body.{name}.")] for name in ("a", "b")}
    panels = (_band(sweep, name, paths) for name, paths in varied.items() if paths)
    return [panel for panel in panels if panel is not None]


def _band(sweep: Sweep, name: str, paths: Sequence[str]) -> Panel | None:
    """Return the band of most profiles of a body; None if it is too thin to draw."""
    nominal = getattr(sweep.plan.case.contact, name)  # type: ignore[union-attr]
    if nominal.length is None:
        return None
    y = np.linspace(float(nominal.faces[0]), float(nominal.faces[1]), PLACES)
    step = max(1, len(sweep) // MOST_PROFILES)
    columns = [sweep[path].ravel()[::step].tolist() for path in paths]
    reliefs = []
    for values in zip(*columns, strict=True):
        with contextlib.suppress(NonhertzError):
            case = sweep.plan.template.case(dict(zip(paths, values, strict=True)))
            reliefs.append(getattr(case.contact, name).relief(y))  # type: ignore[union-attr]
    if not reliefs:
        return None
    samples = np.where(np.isfinite(reliefs), reliefs, np.nan)
    seen = np.all(np.isfinite(samples), axis=0) & np.isfinite(nominal.relief(y))
    low, high = np.quantile(samples[:, seen], BAND, axis=0)
    if np.max((high - low)[_inner(y[seen])]) < LEAST_BAND * _deepest(y[seen], high):
        return None
    label = f"{100 * (BAND[1] - BAND[0]):g} % of the profiles of body {name}"
    panel = profile_band(y[seen], nominal.relief(y[seen]), (low, high), label=label)
    return replace(_on_land(panel, y[seen], high), name=f"profile-{name}")


def _inner(y: Array) -> NDArray[np.bool_]:
    """Return which positions are away from the ends, where corners are many times as deep as a profile."""
    return np.asarray(np.abs(y - y.mean()) < LAND * 0.5 * np.ptp(y))


def _deepest(y: Array, *reliefs: Array) -> float:
    """Return the lower end of an axis of reliefs [mm]."""
    return 1.5 * float(np.nanmax(np.stack(reliefs)[:, _inner(y)]))


def _on_land(panel: Panel, y: Array, *reliefs: Array) -> Panel:
    """Return a panel of reliefs whose axis points down and ends where the land does."""
    deepest = _deepest(y, *reliefs)
    return replace(panel, upright=replace(panel.upright, range=(deepest, -0.05 * deepest), logarithmic=False, cut=True))


def _worst_loads(design: Design) -> list[ContactLoadCase]:
    """Return the largest load without tilt, if there is one, and the largest with the most tilt."""
    upright = [load for load in design.loads if load.tilt == 0.0]
    largest = [max(upright, key=lambda load: load.load)] if upright else []
    tilted = max(design.loads, key=lambda load: (abs(load.tilt), load.load))
    return [*largest, *([tilted] if tilted not in largest else [])]


def _before_and_after(design: Design, load: ContactLoadCase) -> Panel:
    pressures: dict[str, tuple[Array, Array]] = {}
    with without_accuracy_warnings():
        for name, case in (("designed", design.case), ("before", design.was)):
            with contextlib.nullcontext() if case is design.case else contextlib.suppress(NonhertzError):
                solution = solve(case.contact, load=load.load, tilt=load.tilt, **case.solver.keywords)
                pressures[name] = solution.y, solution.centre_pressure
    y = np.unique(np.concatenate([places for places, _ in pressures.values()]))
    lines = {name: np.interp(y, *line, left=0.0, right=0.0) for name, line in pressures.items()}
    panel = lines_over(_ALONG, y, lines, _PRESSURE)
    top = 1.05 * max(float(values.max()) for values in lines.values())
    words = describe_load(load.load, load.tilt)
    return replace(panel, name=words, heading=words, upright=replace(_PRESSURE, range=(0.0, top)))


def _convergence(design: Design) -> Panel:
    some = [start for start in design.starts if start.history][:FEW]
    lines = {f"start {k}": np.array(start.history) for k, start in enumerate(some, start=1)}
    longest = max(values.size for values in lines.values())
    lines = {name: np.pad(values, (0, longest - values.size), mode="edge") for name, values in lines.items()}
    of_pressure = design.goal == PRESSURE
    upright = Axis("Maximum pressure", "p", "MPa") if of_pressure else Axis("Life relative to original", "life")
    panel = lines_over(Axis("Evaluations", "evaluations"), np.arange(1.0, longest + 1.0), lines, upright)
    remark = f"the best {len(some)} of {len(design.starts)} starts" if len(design.starts) > len(some) else ""
    return replace(panel, name="searches", remark=remark)


def in_words(path: str) -> str:
    """Return the value at a path in words.

    Examples
    --------
    >>> in_words("load.load"), in_words("body.a.profile[1].drop"), in_words("bearing.axial_clearance")
    ('Load', 'Body a, profile 1, drop', 'Axial clearance')
    """
    keys = path.replace("body.", "body ").replace("[", " ").replace("]", "").replace("_", " ").split(".")
    return _capital(", ".join(keys[1:] if keys[0] in _SECTIONS and len(keys) > 1 else keys))


def _capital(words: str) -> str:
    return words if words.startswith("d ") else words[:1].upper() + words[1:]  # derivatives keep their small letter


def axis_of(quantity: Quantity) -> Axis:
    """Return the axis of a quantity."""
    return Axis(_capital(quantity.label), quantity.name, quantity.unit, quantity.shown_unit)


def axis_over(path: str, unit: str, values: NDArray[Any]) -> tuple[Axis, Array]:
    """Return the axis of the values at a path, and their places on it."""
    if values.dtype.kind not in "iuf":
        words = tuple(map(str, values.tolist()))
        return Axis(in_words(path), path, categories=words), np.arange(float(values.size))
    amount = of_dimension(values.tolist(), unit)
    return fit_axis(Axis(in_words(path), path, amount.unit, amount.read), values), values.astype(float)


def _quantities_drawn(sweep: Sweep) -> tuple[Quantity, ...]:
    """Return the quantities that are drawn: those requested by name, or the main ones that are not given."""
    if sweep.plan.quantities:
        return sweep.quantities
    return tuple(quantity for quantity in sweep.quantities if quantity.name in _PICTURED - sweep.given)


def _panel_of(sweep: Sweep) -> Callable[[Quantity], Panel] | None:
    """Return a function that makes the panel of a quantity; None if the varied inputs cannot be drawn."""
    spreads = [sweep.plan.spreads[path] for path in sweep.paths]
    if any(isinstance(spread, Distribution) for spread in spreads):
        sampled = all(isinstance(spread, Distribution) for spread in spreads)
        return (lambda quantity: distribution(axis_of(quantity), sweep[quantity.name])) if sampled else None
    lists = {path: np.asarray(spread) for path, spread in zip(sweep.paths, spreads, strict=True)}
    longer = {path: values for path, values in lists.items() if values.size > 1}
    if len(longer) == 1:
        ((path, values),) = longer.items()
        along, x = axis_over(path, sweep.unit(path), values)
        return lambda quantity: lines_over(along, x, {"": sweep[quantity.name].ravel()}, axis_of(quantity))
    return _over_two(sweep, longer) if len(longer) == 2 else None


def _over_two(sweep: Sweep, lists: Mapping[str, NDArray[Any]]) -> Callable[[Quantity], Panel]:
    """Return a function that makes lines over one path, named by the values of the other; or maps over both."""
    axes = [axis_over(path, sweep.unit(path), values) for path, values in lists.items()]
    (first, a), (second, b) = axes
    by_first = bool(first.categories) or (a.size <= FEW and not second.categories and a.size <= b.size)
    (named, y), (along, x) = axes if by_first else axes[::-1]
    as_maps = y.size > FEW and not (*first.categories, *second.categories)

    def panel_of(quantity: Quantity) -> Panel:
        numbers = np.moveaxis(sweep[quantity.name].reshape(a.size, b.size), int(not by_first), 0)
        if as_maps:
            return map_over(along, x, named, y, numbers.T, axis_of(quantity))
        factor, unit = named.scale
        names = named.categories or [f"{format_input(factor * value, 4)} {unit}".rstrip() for value in y.tolist()]
        return lines_over(along, x, dict(zip(names, numbers, strict=True)), axis_of(quantity), key=named.label)

    return panel_of
