"""Strips beside the plane grid: results, run times, and where they differ."""

from __future__ import annotations

import math

from nonhertz.amounts import mm, percent
from nonhertz.comparison import Comparison, Stretch
from nonhertz.comparison.quantities import LARGEST
from nonhertz.errors import joined
from nonhertz.show.beside import Cells, Compared, beside
from nonhertz.show.sections import Said, Section


def sections(found: Comparison) -> list[Section]:
    """Return what is shown of a comparison: results side by side, run times, and where the methods differ."""
    seconds, (across, along) = found.seconds, found.patch.cells
    semi, parabolic = (f"{each.strips} strips" for each in found.strips)
    times = [
        f"{1e3 * each:.3g} ms" if each < 0.9995 else f"{each:.3g} s"
        for each in (seconds.patch, seconds.semi_elliptic, seconds.parabolic)
    ]
    rows: list[Compared | Cells] = [
        *(Compared(each.name, each.amount, absolute=each.absolute) for each in found.quantities),
        ("size", f"{across} x {along} cells", semi, parabolic),
        ("time", *times),
    ]
    return [Section("", [beside(rows, ("plane grid", "semi-elliptic", "parabolic")), Said(_sentences(found))])]


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


def _sentence(each: Stretch) -> str:
    worst = percent(each.largest) if math.isfinite(each.largest) else "the plane grid has no contact"
    where = mm(each.low, each.high, between=" to ")
    return f"{each.element} strips, y = {where:.5g} ({worst} at {mm(each.at):.5g})."
