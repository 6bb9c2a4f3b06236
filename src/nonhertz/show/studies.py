"""Studies in rows: what was varied, between which numbers the results lie, and why rows have failed."""

from __future__ import annotations

from nonhertz.io.spreads import Distribution, Spread
from nonhertz.result.numerals import digits, given
from nonhertz.show.summary import Row
from nonhertz.study.sweeps import Sweep

SWEEP_COLUMNS = ("", "smallest", "largest", "")


def varied_rows(sweep: Sweep) -> list[Row]:
    """Return path, what it runs over, and how many values that are."""
    found = []
    for path, spread in sweep.plan.spreads.items():
        unit = sweep.unit(path)
        if isinstance(spread, Distribution):
            found.append((path, in_words(spread, unit), f"{sweep.plan.samples.count} samples"))
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
