"""Studies in rows: the varied inputs, the ranges of the results, and why rows have failed."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import Amount, amount, error_words, format_digits, format_input, mpa, of_dimension, um
from nonhertz.bearing.assessed import NO_OIL
from nonhertz.bearing.quantities import LIVES
from nonhertz.files.spreads import Distribution, Spread
from nonhertz.result.quantities import Quantity
from nonhertz.show.beside import MOST_LISTED, extremes_table, number_row
from nonhertz.show.sections import Block, Notes, Row, Section, Table, assumed_rows, summary
from nonhertz.study.design import Design, Front
from nonhertz.study.diagrams import Diagram
from nonhertz.study.figures import in_words
from nonhertz.study.sweeps import Sweep
from nonhertz.study.tolerances import Tolerance, is_operating_load

#: Of the loads of a front.
GROUPS = ("under the first loads", "under the second loads")
STEPS_LISTED = 10  # between the rows of a diagram that are listed


def sweep_sections(sweep: Sweep) -> list[Section]:
    """Return the sections on a sweep: its inputs, all rows if they are few, else their extremes, and failures."""
    results = _each_row(sweep) if 1 < len(sweep) <= MOST_LISTED else extremes_table(_numbers(sweep))
    return [
        Section("", [Notes([_count_rows(sweep)])]),
        Section("", [summary([*_list_varied(sweep), *assumed_rows(sweep.assumed)])]),
        Section("", [results, Notes(_failures(sweep), "warning")]),
    ]


def _each_row(sweep: Sweep) -> Table:
    """Return a column for every row of a sweep: the values of its inputs, and its results, blank if it has failed."""
    rows: list[tuple[str, ...]] = []
    for path in sweep.paths:
        values = sweep[path].ravel().tolist()
        words = any(isinstance(value, str | bool) for value in values)
        texts, unit = ([*map(str, values)], "") if words else of_dimension(values, sweep.unit(path)).apart("g")
        rows.append((path, *texts, unit))
    results = [quantity for quantity, _ in _numbers(sweep) if f"load.{quantity.name}" not in sweep.paths]
    rows += [number_row(quantity, sweep[quantity.name].ravel().tolist()) for quantity in results]
    heads = ("row", *map(str, range(len(sweep))), "")
    return Table(rows, heads, (0, len(heads) - 1))


def diagram_sections(diagram: Diagram) -> list[Section]:
    """Return the sections on a diagram: where the life is longest, and some of its rows."""
    sweep, unit = diagram.sweep, diagram.sweep.unit(diagram.path)
    rows: list[Row] = [(diagram.path, f"{of_dimension(diagram.values[[0, -1]].tolist(), unit):g}", _count_rows(sweep))]
    if diagram.present is not None:
        rows.append(("in the file", f"{of_dimension([diagram.present], unit):g}", ""))
    if diagram.longest_life is not None:
        value, life = diagram.longest_life
        end = ", at the end of the range" if value in diagram.values[[0, -1]] else ""
        rows.append(("longest life", f"{of_dimension([value], unit):.3g}", f"{amount(life, *LIVES):4}{end}"))
    some = np.unique([*range(0, len(sweep), max(1, round((len(sweep) - 1) / STEPS_LISTED))), len(sweep) - 1])
    numbers = [of_dimension(diagram.values.tolist(), unit)]
    numbers += [quantity.amount(*sweep[quantity.name].tolist()) for quantity in diagram.quantities]
    heads = [in_words(diagram.path).lower(), *(quantity.label for quantity in diagram.quantities)]
    columns = [_column(values, some) for values in numbers]
    units = [values.scale[1] for values in numbers]
    titles = [f"{head} [{read}]" if read else head for head, read in zip(heads, units, strict=True)]
    table = Table([*zip(*columns, strict=True)], titles, ())
    return [
        Section("", [summary([*rows, *assumed_rows(sweep.assumed)])]),
        Section("", [table, Notes(_failures(sweep), "warning")]),
    ]


def _column(numbers: Amount, rows: NDArray[np.intp]) -> list[str]:
    """Return the numbers of some rows, in the unit that suits all rows; blank where there is none."""
    chosen = np.asarray(numbers.values)[rows] * numbers.scale[0]
    return ["" if math.isnan(value) else format_input(value, 4) for value in chosen.tolist()]


def tolerance_sections(study: Tolerance) -> list[Section]:
    """Return the sections on a tolerance study: distributions, quantiles, influences, and why rows have failed."""
    sweep = study.sweep
    shown = [quantity for quantity, _ in _numbers(sweep) if quantity in study.main]
    others = [
        quantity.label
        for quantity, (low, high) in _numbers(sweep)
        if quantity not in study.main and quantity in study.results and low < high
    ]
    tables = [
        Table([*(row[:2] for row in _list_varied(sweep)), *assumed_rows(sweep.assumed)]),
        _quantiles(study, shown),
        _capabilities(study),
        *_indices(study, [quantity for quantity in shown if quantity in study.results]),
        Table(list(_list_strained(sweep))),
    ]
    blocks: list[list[Block]] = [[study_table] for study_table in tables if study_table.rows]
    words: Block = Notes([f"{_count_rows(sweep)}; {study.independent.size} independent samples"])
    if others:
        blocks.append([Notes([f"Also calculated: {', '.join(others)}."])])
    blocks[-1:] = [[*blocks[-1], Notes(_failures(sweep), "warning")]]
    return [Section("", section_blocks) for section_blocks in [[words], *blocks]]


def design_sections(design: Design) -> list[Section]:
    """Return the sections on a design: the goal before and after, the optimum and how flat it is, and the searches."""

    def read(path: str, value: float) -> str:
        return f"{of_dimension([value], design.units.get(path, '')):4}"

    def all_of(values: Mapping[str, Any]) -> str:
        return ", ".join(read(path, value) for path, value in values.items() if isinstance(value, float))

    bands = [
        (f"{100.0 * band.cost:g} %", read(band.path, band.low), read(band.path, band.high), band.path)
        for band in design.bands
    ]
    starts = []
    for start in design.starts:
        value = str(amount(start.value, "MPa" if design.goal == "pressure" else ""))
        value += "" if start.meets else ", limits not met"
        value = value if math.isfinite(start.value) else f"failed: {start.failure}"
        starts.append((value, f"{len(start.history)} points", all_of(start.begun), all_of(start.ended)))
    tables = [
        summary(_best(design, read)),
        Table(bands, ("equally good within", "from", "to", "")),
        Table(starts, ("searches", "evaluations", "from", "to")),
    ]
    return [Section("", [study_table]) for study_table in tables if study_table.rows]


def front_sections(front: Front, groups: tuple[str, str] = GROUPS) -> list[Section]:
    """Return the points of a front: a column for the maximum pressure under each group of loads, and for each path."""
    heads, columns = ["point"], []
    for name, (values, unit) in front_columns(front, groups).items():
        cells, read = of_dimension(values, unit).apart()
        heads.append(f"{name} [{read}]" if read else name)
        columns.append(cells)
    rows = [(str(number), *cells) for number, cells in enumerate(zip(*columns, strict=True), start=1)]
    return [Section("", [Table(rows, heads)])]


def front_columns(front: Front, groups: tuple[str, str]) -> dict[str, tuple[Sequence[float], str]]:
    """Return the numbers of the points by name, with their unit; free profiles are in the case files."""
    pressures = zip(groups, (front.first, front.second), strict=True)
    paths = [path for path, value in front.values[0].items() if isinstance(value, float)]
    return {
        **{f"maximum pressure {group}": (values, "MPa") for group, values in pressures},
        **{path: ([values[path] for values in front.values], front.units.get(path, "")) for path in paths},
    }


def _numbers(sweep: Sweep) -> Iterator[tuple[Quantity, tuple[float, float]]]:
    """Yield the quantities that have numbers, with the smallest and the largest."""
    for quantity in sweep.quantities:
        extremes = sweep.extremes(quantity.name)
        if extremes is not None:
            yield quantity, extremes


def _count_rows(sweep: Sweep) -> str:
    rows = "row" if len(sweep) == 1 else "rows"
    return f"{len(sweep)} {rows}{f', {sweep.failed} of them failed' if sweep.failed else ''}"


def _list_varied(sweep: Sweep) -> Iterator[Row]:
    """Yield path and range as in a plan, in readable units, and the number of values."""
    for path, spread in sweep.plan.spreads.items():
        unit = sweep.unit(path)
        if isinstance(spread, Distribution):
            written = sweep.plan.over[path]
            if not isinstance(written, str):
                numbers = ", ".join(f"{of_dimension([number], unit):g}" for number in spread.numbers)
                limits = "" if spread.within is None else f" within {of_dimension(spread.within, unit, ' : '):g}"
                written = f"{spread.kind}({numbers}){limits}"
            yield path, written, f"{sweep.shape[-1]} samples"
        else:
            yield path, _ends(spread, unit), f"{len(spread)} values" if len(spread) > 1 else "1 value"


def _quantiles(study: Tolerance, spread: Sequence[Quantity]) -> Table:
    """Return quantiles with their intervals, several rows for every quantity."""
    rows: list[tuple[str, ...]] = []
    for quantity in spread:
        label, quantiles = quantity.label, study.quantiles(quantity.name)
        numbers = [number for quantile in quantiles for number in (quantile.low, quantile.value, quantile.high)]
        texts, unit = quantity.amount(*numbers).apart()
        for k, quantile in enumerate(quantiles):
            low, value, high = texts[3 * k : 3 * k + 3]
            between = f"{low} to {high}" if math.isfinite(quantile.low + quantile.high) else "too few samples"
            rows.append((label, f"{100.0 * quantile.probability:g} %", value, unit, between))
            label = ""
    return Table(rows, ("", "fraction", "below", "", "95 % confidence interval"), (0, 3, 4))


def _capabilities(study: Tolerance) -> Table:
    """Return a row for every limit: the fraction beyond it with its interval, Cpk, and the fraction if normal."""
    labels, rows = {quantity.name: quantity for quantity in study.main}, []
    for capability in study.capabilities:
        quantity = labels[capability.quantity]
        share, low, high, normal = (
            f"{format_input(100.0 * number, 2)} %"
            for number in (capability.fraction, capability.low, capability.high, capability.normal_fraction)
        )
        limit = f"{capability.kind} {quantity.amount(capability.limit):g}"
        rows.append((quantity.label, limit, share, f"{low} to {high}", f"{capability.cpk:.2f}", normal))
    return Table(rows, ("limit", "", "beyond", "95 % confidence interval", "Cpk", "beyond if normal"), (0, 1, 3))


def _list_strained(sweep: Sweep) -> Iterator[Row]:
    """Yield the estimated errors and strained conditions of the rows."""
    for quantity, (_, largest) in _numbers(sweep):
        if quantity.name == "error" and error_words(largest):
            yield "approach or load", error_words(largest), "at most"
        elif quantity.name == "warnings" and largest > 0.0:
            yield quantity.label, format_input(largest), "at most; a sweep over the same samples shows which"


def _indices(study: Tolerance, results: Sequence[Quantity]) -> Iterator[Table]:
    """Yield the influences on the variance of every result, largest first, and which tolerance to tighten."""
    for quantity in results:
        first = study.tightened_first.get(quantity.name, ())
        mark = "tighten this first" if len(first) == 1 else "tighten one of these first"
        rows: list[tuple[str, ...]] = []
        for index in study.indices(quantity.name):
            alone, total = (
                f"{100.0 * share:.0f} % ({100.0 * low:.0f} to {100.0 * high:.0f})"
                for share, low, high in (
                    (index.first, index.first_low, index.first_high),
                    (index.total, index.total_low, index.total_high),
                )
            )
            remark = "operating load" if is_operating_load(index.path) else mark if index.path in first else ""
            rows.append((index.path, alone, total, remark))
        yield Table(rows, (f"variance of {quantity.label}", "alone", "in total", ""), (0, 3))


def _failures(sweep: Sweep) -> list[str]:
    """Return why rows have failed, a sentence for each reason, the commonest first."""
    reasons = sweep.reasons()
    shown = [
        f"{times} {'rows' if times > 1 else 'row'}, the first {first}: {sentence}" for sentence, times, first in reasons
    ]
    rest = sweep.failed - sum(times for _, times, _ in reasons)
    if rest:
        shown.append(f"{rest} more rows for other reasons.")
    if "modified_life" in [quantity.name for quantity in sweep.quantities] and sweep.extremes("modified_life") is None:
        shown.append(f"No modified life: {NO_OIL}.")
    return shown


def _ends(spread: Spread, unit: str) -> str:
    assert not isinstance(spread, Distribution)
    if any(isinstance(value, str | bool) for value in spread):
        return ", ".join(map(str, spread))
    return f"{of_dimension((spread[0], spread[-1])[: len(spread)], unit):g}"


def _best(design: Design, read: Callable[[str, float], str]) -> Iterator[Row]:
    """Yield the goal before and after, the best values, and the worst load."""
    if design.goal == "pressure":
        before = f"{mpa(design.before)}" if math.isfinite(design.before) else "no solution"
        yield "maximum pressure", f"{mpa(design.value)}", f"before: {before}"
    else:
        yield "life", f"{format_digits(design.value)} times that before", ""
    for path, value in design.values.items():
        if isinstance(value, float):
            yield path, read(path, value), ""
        else:
            yield path, "free", f"{len(value)} steps, up to {um(float(np.nanmax(design.relief[1])))}"
    yield "worst load", design.worst, ""
    yield "searches that agree", f"{design.agreeing} of {len(design.starts)}", "within 1 %"
