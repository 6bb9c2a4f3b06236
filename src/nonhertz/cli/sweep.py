"""What ``nonhertz sweep`` reads, solves, prints and writes."""

from __future__ import annotations

import contextlib
import json
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from nonhertz.cli.options import named_as
from nonhertz.cli.printing import print_result
from nonhertz.errors import InputError
from nonhertz.files.held import holds_plan, opened
from nonhertz.files.planfile import Plan, case_or_bearing_in
from nonhertz.inputs.files import legible
from nonhertz.show.studies import sweep_sections
from nonhertz.study.sweeps import Progress, Sweep, sweep


def planned(file: Path, over: Sequence[str], quantities: Sequence[str], table: str, changes: Mapping[str, Any]) -> Plan:
    """Return the plan of a file, what it varies in one of its tables; or of a case, what the command line varies.

    ``changes`` are values in place of those in the case file, by path.

    Raises
    ------
    CaseError
        If the file has mistakes.
    InputError
        If an option cannot be read, named as on the command line.
    """
    document, _, text = opened(file, "plan", "case", "bearing")
    if not holds_plan(document):
        plan = Plan(case_or_bearing_in(document, file, text, changes), path=file)
    elif over:
        remedy = "write it into the plan, or give the case file in place of the plan"
        raise InputError("--over", over[0], "vary a case file", remedy)
    else:
        plan = Plan.of(document, file, text, changes, table)
    try:
        return plan.changed(over=dict(map(_path_and_values, over)) or None, quantities=tuple(quantities) or None)
    except InputError as error:
        option = "--quantities" if error.field == "quantities" else f"--over {error.field}"
        raise InputError(option, error.value, error.condition, error.remedy) from None


def directory_for(file: Path, study: str) -> Path:
    """Return where the rows of a study of a plan are kept if nothing else is said."""
    return Path(f"{legible(file.stem)}-{study}")


def swept(plan: Plan, out: Path, workers: int | None, scheduler: str | None) -> Sweep:
    """Return the sweep of a plan, with progress on a terminal.

    Raises
    ------
    InputError
        If an option is refused, named as on the command line.
    """
    with progress() as announce, named_as(threads="--workers", over="--over"):
        return sweep(plan, out=out, workers=workers, scheduler=scheduler, announce=announce)


def written(found: Sweep, out: Path, excel: bool) -> tuple[Path, ...]:
    """Write the rows and the figures, and return the files."""
    from nonhertz.plot import save
    from nonhertz.study.pictures import sweep_figures

    def draw(folder: Path) -> None:
        for name, figure in sweep_figures(found).items():
            save(figure, folder / name)

    return found.write(out, draw, excel=excel)


def as_json(found: Sweep, files: Sequence[Path]) -> str:
    """Return what `print_sweep` prints as JSON text."""
    ends = {quantity.name: found.extremes(quantity.name) for quantity in found.quantities}
    content: dict[str, Any] = {
        "title": found.plan.title,
        "rows": len(found),
        "failed": found.failed,
        "over": list(found.paths),
        "shape": list(found.shape),
        "extremes": ends,
        "failures": [{"sentence": why, "rows": times, "first": first} for why, times, first in found.reasons()],
        "files": [str(path) for path in files],
        "units": {name: found.unit(name) for name in (*found.paths, *ends)},
    }
    return json.dumps(content, indent=2)


def print_sweep(found: Sweep, files: Sequence[Path]) -> None:
    """Print what was varied, between which numbers the results lie, why rows failed, and the files."""
    print_result(found.plan.title, sweep_sections(found), written=files)


def _path_and_values(word: str) -> tuple[str, str]:
    path, equals, values = word.partition("=")
    if not equals or not path.strip():
        remedy = "write path and values, such as --over load.load=5kN:40kN:8"
        raise InputError("", word, "have an equals sign between path and values", remedy)
    return path.strip(), values.strip()


@contextlib.contextmanager
def progress() -> Iterator[Callable[[Progress], object] | None]:
    """Show a bar with the time to go, on a terminal."""
    if not sys.stderr.isatty():
        yield None
        return
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, TextColumn, TimeRemainingColumn
    from rich.progress import Progress as Bar

    columns = TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn()
    with Bar(*columns, console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task("rows", total=None)

        def announce(come: Progress) -> None:
            if bar.tasks[0].total is None:
                # What was there before took no time.
                bar.reset(task, total=come.total, completed=come.found)
            bar.update(task, completed=come.done)

        yield announce
