"""Studies in rows: what was varied, between which numbers the results lie, and why rows have failed."""

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
from nonhertz.show.sections import Block, Row, Said, Section, Table, assumed_rows, summary
from nonhertz.study.design import Design
from nonhertz.study.diagrams import Diagram
from nonhertz.study.pictures import in_words
from nonhertz.study.sweeps import Sweep
from nonhertz.study.tolerances import Tolerance, is_operating_load

MOST_LISTED = 12  # rows of a sweep that are listed one by one
STEPS_LISTED = 10  # from row to row of a diagram


def sweep_sections(sweep: Sweep) -> list[Section]:
    """Return what is shown of a sweep: what was varied, all rows if they are few, else their extremes, and failures."""
    results = _each_row(sweep) if 1 < len(sweep) <= MOST_LISTED else _extremes(sweep)
    return [
        Section("", [Said([_counted(sweep)])]),
        Section("", [summary([*_varied(sweep), *assumed_rows(sweep.assumed)])]),
        Section("", [results, Said(_failures(sweep), "warning")]),
    ]


def _extremes(sweep: Sweep) -> Table:
    """Return the smallest and the largest number of every quantity."""
    rows = []
    for quantity, extremes in _numbers(sweep):
        (low, high), unit = quantity.amount(*extremes).apart()
        rows.append((quantity.label, low, high, unit))
    return Table(rows, ("", "smallest", "largest", ""), (0, 3))


def _each_row(sweep: Sweep) -> Table:
    """Return a column for every row of a sweep: the values of its paths, and its numbers, blank where it has failed."""
    rows: list[tuple[str, ...]] = []
    for path in sweep.paths:
        values = sweep[path].ravel().tolist()
        words = any(isinstance(value, str | bool) for value in values)
        texts, unit = ([*map(str, values)], "") if words else of_dimension(values, sweep.unit(path)).apart("g")
        rows.append((path, *texts, unit))
    for quantity in (each for each, _ in _numbers(sweep) if f"load.{each.name}" not in sweep.paths):
        values = sweep[quantity.name].ravel().tolist()
        texts, unit = quantity.amount(*values).apart()
        rows.append(
            (
                quantity.label,
                *("" if math.isnan(value) else text for value, text in zip(values, texts, strict=True)),
                unit,
            )
        )
    heads = ("row", *map(str, range(len(sweep))), "")
    return Table(rows, heads, (0, len(heads) - 1))


def diagram_sections(diagram: Diagram) -> list[Section]:
    """Return what is shown of a diagram: where the life is longest, and some of its rows."""
    sweep, unit = diagram.sweep, diagram.sweep.unit(diagram.path)
    rows: list[Row] = [(diagram.path, f"{of_dimension(diagram.values[[0, -1]].tolist(), unit):g}", _counted(sweep))]
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
    columns = [_column(each, some) for each in numbers]
    units = [each.scale[1] for each in numbers]
    titles = [f"{head} [{read}]" if read else head for head, read in zip(heads, units, strict=True)]
    table = Table([*zip(*columns, strict=True)], titles, ())
    return [
        Section("", [summary([*rows, *assumed_rows(sweep.assumed)])]),
        Section("", [table, Said(_failures(sweep), "warning")]),
    ]


def _column(numbers: Amount, rows: NDArray[np.intp]) -> list[str]:
    """Return some of many numbers, in the unit that suits all of them; blank where there is none."""
    chosen = np.asarray(numbers.values)[rows] * numbers.scale[0]
    return ["" if math.isnan(value) else format_input(value, 4) for value in chosen.tolist()]


def tolerance_sections(found: Tolerance) -> list[Section]:
    """Return what is shown of a tolerance study: what is distributed, quantiles, what matters, and why rows failed."""
    sweep = found.sweep
    shown = [quantity for quantity, _ in _numbers(sweep) if quantity in found.main]
    others = [
        quantity.label
        for quantity, (low, high) in _numbers(sweep)
        if quantity not in found.main and quantity in found.results and low < high
    ]
    tables = [
        Table([*(row[:2] for row in _varied(sweep)), *assumed_rows(sweep.assumed)]),
        _quantiles(found, shown),
        _capabilities(found),
        *_indices(found, [quantity for quantity in shown if quantity in found.results]),
        Table(list(_strained(sweep))),
    ]
    blocks: list[list[Block]] = [[each] for each in tables if each.rows]
    words: Block = Said([f"{_counted(sweep)}; {found.independent.size} independent samples"])
    if others:
        blocks.append([Said([f"In tolerance.json, too: {', '.join(others)}."])])
    blocks[-1:] = [[*blocks[-1], Said(_failures(sweep), "warning")]]
    return [Section("", each) for each in [[words], *blocks]]


def design_sections(found: Design) -> list[Section]:
    """Return what is shown of a design: the goal before and after, what is best, how flat that is, and the searches."""

    def read(path: str, value: float) -> str:
        return f"{of_dimension([value], found.units.get(path, '')):4}"

    def all_of(values: Mapping[str, Any]) -> str:
        return ", ".join(read(path, value) for path, value in values.items() if isinstance(value, float))

    bands = [
        (f"{100.0 * band.cost:g} %", read(band.path, band.low), read(band.path, band.high), band.path)
        for band in found.bands
    ]
    starts = []
    for start in found.starts:
        value = str(amount(start.value, "MPa" if found.goal == "pressure" else ""))
        value += "" if start.meets else ", limits not met"
        value = value if math.isfinite(start.value) else f"failed: {start.failure}"
        starts.append((value, f"{len(start.history)} points", all_of(start.begun), all_of(start.ended)))
    tables = [
        summary(_best(found, read)),
        Table(bands, ("as good within", "from", "to", "")),
        Table(starts, ("searches", "looked at", "from", "to")),
    ]
    return [Section("", [each]) for each in tables if each.rows]


def _numbers(sweep: Sweep) -> Iterator[tuple[Quantity, tuple[float, float]]]:
    """Yield the quantities that have numbers, with the smallest and the largest."""
    for quantity in sweep.quantities:
        extremes = sweep.extremes(quantity.name)
        if extremes is not None:
            yield quantity, extremes


def _counted(sweep: Sweep) -> str:
    rows = "row" if len(sweep) == 1 else "rows"
    return f"{len(sweep)} {rows}{f', {sweep.failed} of them failed' if sweep.failed else ''}"


def _varied(sweep: Sweep) -> Iterator[Row]:
    """Yield path, what it runs over as a plan has it in units that people read, and how many values those are."""
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


def _quantiles(found: Tolerance, spread: Sequence[Quantity]) -> Table:
    """Return several rows for every quantity."""
    rows: list[tuple[str, ...]] = []
    for quantity in spread:
        label, quantiles = quantity.label, found.quantiles(quantity.name)
        numbers = [number for each in quantiles for number in (each.low, each.value, each.high)]
        texts, unit = quantity.amount(*numbers).apart()
        for k, each in enumerate(quantiles):
            low, value, high = texts[3 * k : 3 * k + 3]
            between = f"{low} to {high}" if math.isfinite(each.low + each.high) else "too few samples to say"
            rows.append((label, f"{100.0 * each.share:g} %", value, unit, between))
            label = ""
    return Table(rows, ("", "share", "below", "", "95 % certain between"), (0, 3, 4))


def _capabilities(found: Tolerance) -> Table:
    """Return a row for every limit: the share beyond it with its interval, Cpk, and the share if it were normal."""
    labels, rows = {quantity.name: quantity for quantity in found.main}, []
    for each in found.capabilities:
        quantity = labels[each.quantity]
        share, low, high, normal = (
            f"{format_input(100.0 * number, 2)} %" for number in (each.share, each.low, each.high, each.normal_share)
        )
        limit = f"{each.kind} {quantity.amount(each.limit):g}"
        rows.append((quantity.label, limit, share, f"{low} to {high}", f"{each.cpk:.2f}", normal))
    return Table(rows, ("limit", "", "beyond", "95 % certain between", "Cpk", "beyond if normal"), (0, 1, 3))


def _strained(sweep: Sweep) -> Iterator[Row]:
    """Yield how far the rows are to be trusted."""
    for quantity, (_, largest) in _numbers(sweep):
        if quantity.name == "error" and error_words(largest):
            yield "approach or load", error_words(largest), "at most"
        elif quantity.name == "warnings" and largest > 0.0:
            yield quantity.label, format_input(largest), "at most; a sweep over the same samples says which"


def _indices(found: Tolerance, results: Sequence[Quantity]) -> Iterator[Table]:
    """Yield for every result what its variance is due to, most important first, and which tolerance to tighten."""
    for quantity in results:
        first = found.tightened_first.get(quantity.name, ())
        mark = "tighten this first" if len(first) == 1 else "tighten one of these first"
        rows: list[tuple[str, ...]] = []
        for each in found.indices(quantity.name):
            alone, total = (
                f"{100.0 * share:.0f} % ({100.0 * low:.0f} to {100.0 * high:.0f})"
                for share, low, high in (
                    (each.first, each.first_low, each.first_high),
                    (each.total, each.total_low, each.total_high),
                )
            )
            remark = "operating load" if is_operating_load(each.path) else mark if each.path in first else ""
            rows.append((each.path, alone, total, remark))
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
    if "modified_life" in [each.name for each in sweep.quantities] and sweep.extremes("modified_life") is None:
        shown.append(f"No modified life: {NO_OIL}.")
    return shown


def _ends(spread: Spread, unit: str) -> str:
    assert not isinstance(spread, Distribution)
    if any(isinstance(value, str | bool) for value in spread):
        return ", ".join(map(str, spread))
    return f"{of_dimension((spread[0], spread[-1])[: len(spread)], unit):g}"


def _best(found: Design, read: Callable[[str, float], str]) -> Iterator[Row]:
    """Yield the goal before and after, what is best, and the worst load."""
    if found.goal == "pressure":
        before = f"{mpa(found.before)}" if math.isfinite(found.before) else "no solution"
        yield "largest pressure", f"{mpa(found.value)}", f"before: {before}"
    else:
        yield "life", f"{format_digits(found.value)} times that before", ""
    for path, value in found.values.items():
        if isinstance(value, float):
            yield path, read(path, value), ""
        else:
            yield path, "free", f"{len(value)} steps, up to {um(float(np.nanmax(found.relief[1])))}"
    yield "worst load", found.worst, ""
    yield "searches that agree", f"{found.agreeing} of {len(found.starts)}", "within 1 %"
