"""Strips beside the plane grid: results, run times, and where they differ."""

from __future__ import annotations

import math

from nonhertz.amounts import amount, digits, mm, percent
from nonhertz.comparison import ComparedQuantity, Comparison, Stretch
from nonhertz.comparison.quantities import LARGEST
from nonhertz.errors import joined
from nonhertz.show.sections import Said, Section, Table

COLUMNS = ("", "plane grid", "semi-elliptic", "difference", "parabolic", "difference")


def sections(found: Comparison) -> list[Section]:
    """Return what is shown of a comparison: results side by side, run times, and where the methods differ."""
    seconds, (across, along) = found.seconds, found.patch.cells
    semi, parabolic = (f"{each.strips} strips" for each in found.strips)
    times = [
        f"{1e3 * each:.3g} ms" if each < 0.9995 else f"{each:.3g} s"
        for each in (seconds.patch, seconds.semi_elliptic, seconds.parabolic)
    ]
    rows = [_row(each) for each in found.quantities]
    rows += [
        ("size", f"{across} x {along} cells", semi, "", parabolic, ""),
        ("time", times[0], times[1], "", times[2], ""),
    ]
    return [Section("", [Table(rows, COLUMNS, (0,)), Said(_sentences(found))])]


def _sentences(found: Comparison) -> list[str]:
    """Return how times were taken, remarks on quantities, and every stretch that differs."""
    lines = [f"Times: one solve on the plane grid, the median of {found.seconds.runs} on strips."]
    remarks: dict[str, list[str]] = {}
    for each in found.quantities:
        if each.remark is not None:
            remarks.setdefault(str(each.remark), []).append(each.name)
    lines += [f"{joined(names)}: {remark}." for remark, names in remarks.items()]
    if not found.stretches:
        return [*lines, "Along the line, strips and plane grid differ by less than 1 % everywhere."]
    lines.append("Along the line, they differ by more than 1 % of the pressure there, most where it says in brackets:")
    lines += [f"- {_sentence(each)}" for each in found.stretches]
    (most,) = (each.y for each in found.stations if each.reason == LARGEST)
    return [*lines, f"In MPa and away from the ends they differ most at y = {mm(most):.5g}."]


def _row(each: ComparedQuantity) -> tuple[str, ...]:
    of_semi, of_parabola = (_difference(value, each) for value in each.differences)
    values = each.patch, each.semi_elliptic, each.parabolic
    factor, unit = amount(values, each.unit).scale
    patch, semi, parabola = (digits(factor * value, 6) if math.isfinite(value) else "none" for value in values)
    return each.name, f"{patch} {unit}" if math.isfinite(each.patch) else patch, semi, of_semi, parabola, of_parabola


def _difference(value: float, each: ComparedQuantity) -> str:
    if not math.isfinite(value):
        return ""
    if each.absolute:
        return f"{'+' * (value > 0.0)}{amount(value, each.unit):.2g}" if value else "0"
    return percent(value) or "0"


def _sentence(each: Stretch) -> str:
    worst = percent(each.largest) if math.isfinite(each.largest) else "the plane grid has no contact"
    where = mm(each.low, each.high, between=" to ")
    return f"{each.element} strips, y = {where:.5g} ({worst} at {mm(each.at):.5g})."
