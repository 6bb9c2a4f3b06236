"""Strips beside the plane grid: results, run times, and where they differ."""

from __future__ import annotations

import math

from nonhertz.amounts import mm, percent
from nonhertz.comparison import Comparison, Stretch
from nonhertz.comparison.quantities import LARGEST
from nonhertz.errors import join_words
from nonhertz.show.beside import Cells, Compared, beside
from nonhertz.show.sections import Notes, Section


def sections(comparison: Comparison) -> list[Section]:
    """Return the sections on a comparison: results side by side, run times, and where the methods differ."""
    seconds, (across, along) = comparison.seconds, comparison.patch.cells
    semi, parabolic = (f"{strip_solution.strips} strips" for strip_solution in comparison.strips)
    times = [
        f"{1e3 * seconds_taken:.3g} ms" if seconds_taken < 0.9995 else f"{seconds_taken:.3g} s"
        for seconds_taken in (seconds.patch, seconds.semi_elliptic, seconds.parabolic)
    ]
    rows: list[Compared | Cells] = [
        *(Compared(quantity.name, quantity.amount, absolute=quantity.absolute) for quantity in comparison.quantities),
        ("size", f"{across} x {along} cells", semi, parabolic),
        ("time", *times),
    ]
    return [Section("", [beside(rows, ("plane grid", "semi-elliptic", "parabolic")), Notes(_sentences(comparison))])]


def _sentences(comparison: Comparison) -> list[str]:
    """Return how times were measured, remarks on quantities, and every stretch that differs."""
    lines = [f"Times: one solve on the plane grid, the median of {comparison.seconds.runs} by strips."]
    remarks: dict[str, list[str]] = {}
    for quantity in comparison.quantities:
        if quantity.remark is not None:
            remarks.setdefault(str(quantity.remark), []).append(quantity.name)
    lines += [f"{join_words(names)}: {remark}." for remark, names in remarks.items()]
    if not comparison.stretches:
        return [*lines, "Along the centre line, strips and plane grid differ by less than 1 % everywhere."]
    lines.append("Along the centre line, they differ by more than 1 % of the local pressure (in brackets: at most):")
    lines += [f"- {_sentence(stretch)}" for stretch in comparison.stretches]
    (most,) = (station.y for station in comparison.stations if station.reason == LARGEST)
    return [*lines, f"Away from the ends, the largest difference in MPa is at y = {mm(most):.5g}."]


def _sentence(stretch: Stretch) -> str:
    worst = percent(stretch.largest) if math.isfinite(stretch.largest) else "the plane grid has no contact"
    where = mm(stretch.low, stretch.high, between=" to ")
    return f"{stretch.element} strips, y = {where:.5g} ({worst} at {mm(stretch.at):.5g})."
