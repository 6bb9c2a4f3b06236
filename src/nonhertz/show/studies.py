"""Studies in rows: what was varied, between which numbers the results lie, and why rows have failed."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from nonhertz.amounts import amount, digits, error_words, mpa, of_dimension, um
from nonhertz.files.spreads import Distribution, Spread
from nonhertz.result.quantities import Quantity
from nonhertz.show.sections import Block, Row, Said, Section, Table, summary
from nonhertz.study.design import Design
from nonhertz.study.sweeps import Sweep
from nonhertz.study.tolerances import Tolerance

QUANTILE_COLUMNS = ("", "share", "below", "", "95 % certain between")
INDEX_COLUMNS = ("share of the variance due to", "alone", "in total", "")
BAND_COLUMNS = ("as good within", "from", "to", "")
START_COLUMNS = ("searches", "looked at", "from", "to")
SWEEP_COLUMNS = ("", "smallest", "largest", "")
_SAME = 1e-9  # relative: numbers that differ by less are one number
_HOW_GOOD = ("error", "warnings")  # of a row, which are not what comes out of it


def sweep_sections(sweep: Sweep) -> list[Section]:
    """Return what is shown of a sweep: what was varied, between which numbers the results lie, and why rows failed."""
    return [
        Section("", [Said([_counted(sweep)])]),
        Section("", [summary(varied_rows(sweep))]),
        Section("", [Table(sweep_rows(sweep), SWEEP_COLUMNS, (0, 3)), Said(failure_rows(sweep), "warning")]),
    ]


def tolerance_sections(found: Tolerance) -> list[Section]:
    """Return what is shown of a tolerance study: what is distributed, quantiles, what matters, and why rows failed."""
    sweep = found.sweep
    tables = [
        Table([row[:2] for row in varied_rows(sweep)]),
        Table(quantile_rows(found), QUANTILE_COLUMNS, (0, 3, 4)),
        Table(alike_rows(found)),
        *(Table(rows, (label, *INDEX_COLUMNS[1:]), (0, 3)) for label, rows in index_rows(found)),
    ]
    blocks: list[list[Block]] = [[each] for each in tables if each.rows]
    words: Block = Said([f"{_counted(sweep)}; {found.independent.size} independent samples"])
    blocks[-1:] = [[*blocks[-1], Said(failure_rows(sweep), "warning")]]
    return [Section("", each) for each in [[words], *blocks]]


def design_sections(found: Design) -> list[Section]:
    """Return what is shown of a design: the goal before and after, what is best, how flat that is, and the searches."""
    tables = [
        summary(design_rows(found)),
        Table(band_rows(found), BAND_COLUMNS),
        Table(start_rows(found), START_COLUMNS),
    ]
    return [Section("", [each]) for each in tables if each.rows]


def _counted(sweep: Sweep) -> str:
    rows = "row" if len(sweep) == 1 else "rows"
    return f"{len(sweep)} {rows}{f', {sweep.failed} of them failed' if sweep.failed else ''}"


def varied_rows(sweep: Sweep) -> list[Row]:
    """Return path, what it runs over, and how many values that are."""
    found = []
    for path, spread in sweep.plan.spreads.items():
        unit = sweep.unit(path)
        if isinstance(spread, Distribution):
            written = sweep.plan.over[path]
            words = written if isinstance(written, str) else in_words(spread, unit)
            found.append((path, words, f"{sweep.shape[-1]} samples"))
        else:
            found.append((path, _ends(spread, unit), f"{len(spread)} values" if len(spread) > 1 else "1 value"))
    return found


def sweep_rows(sweep: Sweep) -> list[tuple[str, str, str, str]]:
    """Return the cells of `SWEEP_COLUMNS` of every quantity that has numbers."""
    rows = []
    for quantity in sweep.quantities:
        ends = sweep.extremes(quantity.name)
        if ends is not None:
            (low, high), unit = quantity.amount(*ends).apart()
            rows.append((quantity.label, low, high, unit))
    return rows


def quantile_rows(found: Tolerance) -> list[tuple[str, ...]]:
    """Return the cells of `QUANTILE_COLUMNS`: several rows for every quantity that has numbers."""
    rows: list[tuple[str, ...]] = []
    for quantity in _spread(found):
        label, quantiles = quantity.label, found.quantiles(quantity.name)
        numbers = [number for each in quantiles for number in (each.low, each.value, each.high)]
        texts, unit = quantity.amount(*numbers).apart()
        for k, each in enumerate(quantiles):
            low, value, high = texts[3 * k : 3 * k + 3]
            between = f"{low} to {high}" if math.isfinite(each.low + each.high) else "too few samples to say"
            rows.append((label, f"{100.0 * each.share:g} %", value, unit, between))
            label = ""
    return rows


def alike_rows(found: Tolerance) -> list[Row]:
    """Return the results that are the same in all rows, and how far the rows are to be trusted."""
    sweep, rows = found.sweep, []
    for quantity in sweep.quantities:
        ends = sweep.extremes(quantity.name)
        if ends is None or quantity in _spread(found):
            continue
        largest = max(ends)
        if quantity.name not in _HOW_GOOD:
            rows.append((quantity.label, str(quantity.amount(largest)), "in all rows"))
        elif quantity.name == "error" and error_words(ends[1]):
            rows.append(("approach or load", error_words(ends[1]), "at most"))
        elif largest > 0.0:
            rows.append((quantity.label, digits(largest), "at most; a sweep over the same samples says which"))
    return rows


def _spread(found: Tolerance) -> list[Quantity]:
    """Return the quantities that are asked for by name, or else the results that are not the same in all rows."""
    sweep = found.sweep
    spread = []
    for quantity in sweep.quantities:
        ends = sweep.extremes(quantity.name)
        if ends is None:
            continue
        asked = quantity.name in sweep.plan.quantities
        varies = ends[1] - ends[0] > _SAME * max(map(abs, ends)) and quantity.name not in _HOW_GOOD
        if asked or varies:
            spread.append(quantity)
    return spread


def index_rows(found: Tolerance) -> list[tuple[str, list[tuple[str, str, str, str]]]]:
    """Return for every quantity that varies its label and the cells of `INDEX_COLUMNS`, most important first."""
    sections = []
    for quantity in _spread(found):
        rows = [
            (each.path, _share(each.first, each.first_error), _share(each.total, each.total_error), "")
            for each in found.indices(quantity.name)
        ]
        if rows:
            rows[0] = (*rows[0][:3], "tighten this first")
            sections.append((quantity.label, rows))
    return sections


def _share(value: float, error: float) -> str:
    return f"{100.0 * value:.1f} +- {100.0 * error:.1f} %"


def failure_rows(sweep: Sweep) -> list[str]:
    """Return why rows have failed, a sentence for each reason, the commonest first."""
    reasons = sweep.reasons()
    shown = [
        f"{times} {'rows' if times > 1 else 'row'}, the first {first}: {sentence}" for sentence, times, first in reasons
    ]
    rest = sweep.failed - sum(times for _, times, _ in reasons)
    return [*shown, f"{rest} more rows for other reasons."] if rest else shown


def in_words(distribution: Distribution, unit: str) -> str:
    """Return a distribution as it is written in a plan, with its numbers in the units in which people write them."""
    numbers = ", ".join(f"{of_dimension([number], unit):g}" for number in distribution.numbers)
    limits = "" if distribution.within is None else f" within {of_dimension(distribution.within, unit, ' : '):g}"
    return f"{distribution.kind}({numbers}){limits}"


def _ends(spread: Spread, unit: str) -> str:
    assert not isinstance(spread, Distribution)
    if any(isinstance(value, str | bool) for value in spread):
        return ", ".join(map(str, spread))
    return f"{of_dimension((spread[0], spread[-1])[: len(spread)], unit):g}"


def design_rows(found: Design) -> list[Row]:
    """Return the goal before and after, what is best, and the worst load."""
    if found.goal == "pressure":
        before = f"{mpa(found.before)}" if math.isfinite(found.before) else "no solution"
        rows = [("largest pressure", f"{mpa(found.value)}", f"before: {before}")]
    else:
        rows = [("life", f"{digits(found.value)} times that before", "")]
    for path, value in found.values.items():
        if isinstance(value, float):
            rows.append((path, _of_path(found, path, value), ""))
        else:
            deepest = float(np.nanmax(found.relief[1]))
            rows.append((path, "free", f"{len(value)} steps, up to {um(deepest)}"))
    agreeing = f"{found.agreeing} of {len(found.starts)}"
    return [*rows, ("worst load", found.worst, ""), ("searches that agree", agreeing, "within 1 %")]


def band_rows(found: Design) -> list[tuple[str, ...]]:
    """Return the cells of `BAND_COLUMNS`: between which values each variable may lie at a cost."""
    return [
        (
            f"{100.0 * band.cost:g} %",
            _of_path(found, band.path, band.low),
            _of_path(found, band.path, band.high),
            band.path,
        )
        for band in found.bands
    ]


def start_rows(found: Design) -> list[tuple[str, ...]]:
    """Return the cells of `START_COLUMNS`: what every search has found, from where, and in how many points."""
    unit = "MPa" if found.goal == "pressure" else ""
    rows: list[tuple[str, ...]] = []
    for start in found.starts:
        value = str(amount(start.value, unit)) if math.isfinite(start.value) else f"failed: {start.failure}"
        short = "" if start.meets or not math.isfinite(start.value) else ", limits not met"
        rows.append(
            (value + short, f"{len(start.history)} points", _values(found, start.begun), _values(found, start.ended))
        )
    return rows


def _values(found: Design, values: Mapping[str, Any]) -> str:
    return ", ".join(_of_path(found, path, value) for path, value in values.items() if isinstance(value, float))


def _of_path(found: Design, path: str, value: float) -> str:
    return f"{of_dimension([value], found.units.get(path, '')):4}"
