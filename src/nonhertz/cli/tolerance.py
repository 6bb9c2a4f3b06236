"""What ``nonhertz tolerance`` prints and writes."""

from __future__ import annotations

import dataclasses
import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from rich.table import Table
from rich.text import Text

from nonhertz.cli.options import named_as
from nonhertz.cli.printing import console, print_table, words
from nonhertz.cli.sweep import progress
from nonhertz.files.planfile import Plan
from nonhertz.result.reading import chosen
from nonhertz.show.studies import (
    INDEX_COLUMNS,
    QUANTILE_COLUMNS,
    alike_rows,
    failure_rows,
    index_rows,
    quantile_rows,
    varied_rows,
)
from nonhertz.study.tolerances import Tolerance, tolerance


def studied(
    plan: Plan, samples: int | None, seed: int | None, out: Path, workers: int | None, scheduler: str | None
) -> Tolerance:
    """Return the study of a plan, with progress on a terminal.

    Raises
    ------
    InputError
        If an option is refused, named as on the command line.
    """
    with progress() as announce, named_as(threads="--workers", count="--samples", seed="--seed", over="--over"):
        return tolerance(
            plan, samples=samples, seed=seed, out=out, workers=workers, scheduler=scheduler, announce=announce
        )


def written(found: Tolerance, out: Path, excel: bool) -> tuple[Path, ...]:
    """Write the rows, quantiles and indices, and the figures; return the files."""
    from nonhertz.plot import save
    from nonhertz.study.pictures import tolerance_figures

    def draw(folder: Path) -> None:
        (folder / "tolerance.json").write_text(as_json(found, ()) + "\n", encoding="utf-8")
        for name, figure in tolerance_figures(found).items():
            save(figure, folder / name)

    return found.sweep.write(out, draw, excel=excel)


def as_json(found: Tolerance, files: Sequence[Path]) -> str:
    """Return what `print_tolerance` prints as JSON text."""
    sweep = found.sweep
    content: dict[str, Any] = {
        "title": sweep.plan.title,
        "rows": len(sweep),
        "independent_samples": found.independent.size,
        "failed": sweep.failed,
        "quantiles": {
            each.name: [_finite(dataclasses.asdict(one)) for one in found.quantiles(each.name)]
            for each in sweep.quantities
        },
        "indices": {
            each.name: [dataclasses.asdict(one) for one in found.indices(each.name)] for each in sweep.quantities
        },
        "failures": [{"sentence": why, "rows": times, "first": first} for why, times, first in sweep.reasons()],
        "files": [str(path) for path in files],
        "units": {name: sweep.unit(name) for name in (*sweep.paths, *(each.name for each in sweep.quantities))},
    }
    return json.dumps(content, indent=2, allow_nan=False)


def print_tolerance(found: Tolerance, files: Sequence[Path]) -> None:
    """Print what is distributed, quantiles, what matters, why rows failed, and the files."""
    sweep, printing = found.sweep, console()
    printing.print(Text(sweep.plan.title, style="bold"))
    failed = f", {sweep.failed} of them failed" if sweep.failed else ""
    printing.print(Text(f"{len(sweep)} rows{failed}; {found.independent.size} independent samples"))
    _print(printing, None, [row[:2] for row in varied_rows(sweep)], left=(0, 1))
    _print(printing, QUANTILE_COLUMNS, quantile_rows(found), left=(0, 3, 4))
    _print(printing, None, alike_rows(found), left=(0, 1, 2))
    for label, rows in index_rows(found):
        _print(printing, (label, *INDEX_COLUMNS[1:]), rows, left=(0, 3))
    for sentence in failure_rows(sweep):
        printing.print(words(sentence, "yellow"), soft_wrap=True)
    for path in files:
        print(f"wrote {path}")


def _print(printing: Any, head: Sequence[str] | None, rows: Sequence[Sequence[str]], left: Sequence[int]) -> None:
    if not rows:
        return
    table = Table(box=None, pad_edge=False, padding=(0, 2, 0, 0), show_header=head is not None, header_style="dim")
    for column, name in enumerate(head or [""] * len(rows[0])):
        table.add_column(Text(name), justify="left" if column in left else "right")
    for row in rows:
        table.add_row(*map(Text, chosen().row(row)))
    printing.print()
    print_table(printing, table)


def _finite(numbers: dict[str, float]) -> dict[str, float | None]:
    return {name: value if abs(value) < float("inf") else None for name, value in numbers.items()}
