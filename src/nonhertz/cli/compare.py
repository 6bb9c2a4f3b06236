"""What ``nonhertz compare`` runs, writes and prints."""

from __future__ import annotations

import math
from pathlib import Path

from rich.table import Table
from rich.text import Text

from nonhertz import comparison as methods
from nonhertz.cli.printing import console, print_table, words
from nonhertz.cli.verify import Progress
from nonhertz.comparison import ComparedQuantity, Comparison, Stretch
from nonhertz.errors import InputError
from nonhertz.files.casefile import Case, placed
from nonhertz.result.numerals import digits
from nonhertz.result.reading import chosen

_METHODS = 3
_COLUMNS = ("", "plane grid", "semi-elliptic", "difference", "parabolic", "difference")


def compared(case: Case, cells: tuple[int, int] | None) -> Comparison:
    """Return the comparison of strips of both elements and the plane grid for a case.

    Raises
    ------
    CaseError, ConvergenceError
    """
    progress = Progress(_METHODS)
    try:
        return methods.compare(
            case.contact,
            **case.prescribed,
            strips=case.solver["strips"],
            accuracy=case.solver["accuracy"],
            cells=cells,
            announce=progress.announce,
        )
    except InputError as error:
        if error.field == "cells":
            raise InputError("--cells", error.value, error.condition, "give two whole numbers such as 64 256") from None
        raise placed(error) from None
    finally:
        progress.wipe()


def comparison_written(directory: Path, found: Comparison, title: str) -> tuple[Path, ...]:
    """Write a comparison with its figure, and return the files."""
    from nonhertz.files.comparisons import files
    from nonhertz.files.folder import write_files
    from nonhertz.plot import comparison, save

    return write_files(
        directory, files(found, title), lambda folder: save(comparison(found, title), folder / "comparison")
    )


def print_comparison(found: Comparison, title: str) -> None:
    """Print results side by side, run times, where the methods differ, and warnings."""
    printing = console()
    printing.print(Text(title, style="bold"))
    table = Table(box=None, pad_edge=False, padding=(0, 2, 0, 0), header_style="dim")
    for position, name in enumerate(_COLUMNS):
        table.add_column(name, justify="right" if position else "left", no_wrap=bool(position))
    for row in comparison_rows(found):
        table.add_row(*map(Text, chosen().row(row)))
    print_table(printing, table)
    for sentence in sentences(found):
        printing.print(words(sentence), soft_wrap=True)
    for warning in found.warnings:
        printing.print(words(f"warning: {warning}", "yellow"), soft_wrap=True)


def comparison_rows(found: Comparison) -> list[tuple[str, ...]]:
    """Return name, value on the plane grid, and value and difference for both strip elements, for each quantity."""
    rows = [_row(each) for each in found.quantities]
    seconds = found.seconds
    times = [_time(each) for each in (seconds.patch, seconds.semi_elliptic, seconds.parabolic)]
    across, along = found.patch.cells
    sizes = [f"{across} x {along} cells", *(f"{each.strips} strips" for each in found.strips)]
    return [*rows, ("size", sizes[0], sizes[1], "", sizes[2], ""), ("time", times[0], times[1], "", times[2], "")]


def sentences(found: Comparison) -> list[str]:
    """Return how times were taken, remarks on quantities, and every stretch that differs."""
    lines = [
        f"Times: one solve on the plane grid, the median of {found.seconds.runs} on strips; compilation is not counted."
    ]
    remarks: dict[str, list[str]] = {}
    for each in found.quantities:
        remarks.setdefault(each.remark, []).append(each.name)
    lines += [f"{' and '.join(names)}: {remark}." for remark, names in remarks.items() if remark]
    if not found.stretches:
        return [*lines, "Along the line, strips and plane grid differ by less than 1 % everywhere."]
    lines.append("Along the line, they differ by more than 1 % of the pressure there:")
    lines += [f"- {_sentence(each)}" for each in found.stretches]
    return lines


def _row(each: ComparedQuantity) -> tuple[str, ...]:
    of_semi, of_parabola = (_difference(value, each) for value in each.differences)
    patch, semi, parabola = (_value(value) for value in (each.patch, each.semi_elliptic, each.parabolic))
    unit = f" {each.unit}" if math.isfinite(each.patch) else ""
    return each.name, patch + unit, semi, of_semi, parabola, of_parabola


def _value(value: float) -> str:
    return digits(value, 6) if math.isfinite(value) else "none"


def _difference(value: float, each: ComparedQuantity) -> str:
    if not math.isfinite(value):
        return ""
    if each.absolute:
        return f"{value:+.2g} {each.unit}" if value else "0"
    # A prescribed load, for example, is met to rounding error.
    return _percent(value) if abs(value) > 1e-10 else "0"


def _percent(relative: float) -> str:
    percent = 100.0 * relative
    return f"{percent:+.0f} %" if abs(percent) >= 10.0 else f"{percent:+.2g} %"


def _time(seconds: float) -> str:
    return f"{1e3 * seconds:.3g} ms" if seconds < 0.9995 else f"{seconds:.3g} s"


def _sentence(each: Stretch) -> str:
    worst = _percent(each.largest) if math.isfinite(each.largest) else "the plane grid has no contact"
    return f"{each.element} strips, y = {each.low:.5g} to {each.high:.5g} mm ({worst} at {each.at:.5g} mm)."
