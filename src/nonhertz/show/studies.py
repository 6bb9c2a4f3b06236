"""Studies in rows: what was varied, between which numbers the results lie, and why rows have failed."""

from __future__ import annotations

import math

from nonhertz.io.spreads import Distribution, Spread
from nonhertz.result.numerals import digits, given
from nonhertz.show.summary import Row
from nonhertz.study.sweeps import Sweep
from nonhertz.study.tolerances import Tolerance

QUANTILE_COLUMNS = ("", "share", "below", "", "95 % certain between")
INDEX_COLUMNS = ("share of the variance due to", "alone", "in total", "")
SWEEP_COLUMNS = ("", "smallest", "largest", "")


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
            low, high = (digits(quantity.factor * end) for end in ends)
            rows.append((quantity.label, low, high, quantity.shown_unit))
    return rows


def quantile_rows(found: Tolerance) -> list[tuple[str, ...]]:
    """Return the cells of `QUANTILE_COLUMNS`: several rows for every quantity that has numbers."""
    rows: list[tuple[str, ...]] = []
    for quantity in found.sweep.quantities:
        if found.sweep.extremes(quantity.name) is None:
            continue
        label = quantity.label
        for each in found.quantiles(quantity.name):
            low, value, high = (quantity.factor * number for number in (each.low, each.value, each.high))
            between = f"{digits(low)} to {digits(high)}" if math.isfinite(low + high) else "too few samples to say"
            rows.append((label, f"{100.0 * each.share:g} %", digits(value), quantity.shown_unit, between))
            label = ""
    return rows


def index_rows(found: Tolerance) -> list[tuple[str, list[tuple[str, str, str, str]]]]:
    """Return for every quantity that varies its label and the cells of `INDEX_COLUMNS`, most important first."""
    sections = []
    for quantity in found.sweep.quantities:
        indices = found.indices(quantity.name) if found.sweep.extremes(quantity.name) is not None else ()
        rows = [
            (each.path, _share(each.first, each.first_error), _share(each.total, each.total_error), "")
            for each in indices
        ]
        if rows:
            rows[0] = (*rows[0][:3], "tighten this first")
            sections.append((quantity.label, rows))
    return sections


def _share(value: float, error: float) -> str:
    return f"{100.0 * value:.1f} +- {100.0 * error:.1f} %"


def failure_rows(sweep: Sweep) -> list[str]:
    """Return why rows have failed, a sentence for each reason, the commonest first."""
    failed = sweep.failed
    if not failed:
        return []
    shown = [
        f"{times} {'rows' if times > 1 else 'row'}, the first {first}: {sentence}"
        for sentence, times, first in sweep.reasons()
    ]
    rest = failed - sum(times for _, times, _ in sweep.reasons())
    return [*shown, f"{rest} more rows for other reasons."] if rest else shown


def in_words(distribution: Distribution, unit: str) -> str:
    """Return a distribution as it is written in a plan, with its numbers in the base unit."""
    numbers = ", ".join(f"{given(number)} {unit}".rstrip() for number in distribution.numbers)
    within = distribution.within
    limits = "" if within is None else f" within {given(within[0])} : {given(within[1])} {unit}".rstrip()
    return f"{distribution.kind}({numbers}){limits}"


def _ends(spread: Spread, unit: str) -> str:
    assert not isinstance(spread, Distribution)
    if any(isinstance(value, str | bool) for value in spread):
        return ", ".join(map(str, spread))
    if len(spread) == 1:
        return f"{given(float(spread[0]))} {unit}".rstrip()
    return f"{given(float(spread[0]))} to {given(float(spread[-1]))} {unit}".rstrip()
