"""``nonhertz sweep``: many values of the inputs of a file."""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any

from nonhertz.cli.answer import Answer
from nonhertz.cli.options import (
    NONE,
    Changes,
    Excel,
    Scheduler,
    Words,
    Workers,
    default_output_path,
    figure_writer,
    rename_fields,
    split_assignment,
)
from nonhertz.cli.printing import Update, progress_bar
from nonhertz.errors import InputError, UnknownKeyError
from nonhertz.files.planfile import Plan, parse_case_or_bearing
from nonhertz.files.studies import SWEEP, as_text
from nonhertz.files.toml import is_plan, load_document
from nonhertz.files.workbooks import refuse_missing_writer
from nonhertz.plot.drawer import sheets_of
from nonhertz.show.studies import sweep_sections
from nonhertz.study.figures import sweep_figures
from nonhertz.study.sweeps import Progress, sweep

WORTH_SAYING = 10.0  # s


def sweep_plan(
    plan: Path,
    /,
    *,
    changes: Changes = NONE,
    over: Words = (),
    quantities: Words = (),
    out: Path | None = None,
    workers: Workers = None,
    scheduler: Scheduler = None,
    excel: Excel = False,
) -> Answer:
    """Solve a case or a bearing for many values of its inputs.

    Rows are saved as they are solved; the same command continues a sweep that was interrupted. A row that fails records
    the reason and does not stop the others.

    Parameters
    ----------
    plan : Path
        The plan file; or a case file or a bearing file, with --over.
    over : tuple of str
        A path in the file and its values, such as load.load=5kN:40kN:8 for eight values, load.tilt=0,0.5mrad for two,
        or 'body.b.diameter=normal(80mm,5um)' for samples; may be given several times.
    quantities : tuple of str
        Names of the quantities in each row, such as max_pressure life; by default the usual ones.
    out : Path
        Directory for the rows, rows.csv, rows.parquet (where polars is installed) and the figures; by default the
        file's name with '-sweep', in the current directory.
    """
    if excel:
        refuse_missing_writer()
    study_plan = load_plan(plan, over, quantities, "over", changes)
    directory = default_output_path(plan, "-sweep", out)
    with progress_bar("rows") as update, rename_fields(threads="--workers", over="--over"):
        results = sweep(study_plan, out=directory, workers=workers, scheduler=scheduler, callback=report_rows(update))
    write_figures = figure_writer(lambda: sheets_of(sweep_figures(results), results.plan.title))
    made = results.save(directory, write_figures, excel=excel)
    text = partial(as_text, SWEEP, made, sweep=results)
    return Answer(results.plan.title, sweep_sections(results), text, verdict=results.verdict, written=made)


def load_plan(
    file: Path, over: Sequence[str], quantities: Sequence[str], table: str, changes: Mapping[str, Any]
) -> Plan:
    """Return the plan in a file, which varies the inputs in ``table``; or a plan for a case, which varies ``over``.

    ``changes`` are values in place of those in the case file, by path.

    Raises
    ------
    CaseError
        If the file has mistakes.
    InputError
        If an option cannot be read, named as on the command line.
    """
    document, _, text = load_document(file, "plan", "case", "bearing")
    if not is_plan(document):
        plan = Plan(parse_case_or_bearing(document, file, text, changes), path=file)
    elif over:
        remedy = "write it into the plan, or give the case file in place of the plan"
        raise InputError("--over", over[0], "vary a case file", remedy)
    else:
        plan = Plan.of(document, file, text, changes, table)
    try:
        return plan.changed(over=dict(map(split_assignment, over)) or None, quantities=tuple(quantities) or None)
    except UnknownKeyError:
        raise
    except InputError as error:
        option = "--quantities" if error.field == "quantities" else f"--over {error.field}".rstrip()
        raise error.about(option, error.value) from None


def report_rows(update: Update | None) -> Callable[[Progress], object]:
    """Return a callback that prints before the first row how many there are and their duration, then shows progress."""

    def announce(come: Progress) -> None:
        if come.done == come.resumed:
            complete = f"all {come.total} rows had been solved before" if come.resumed == come.total else ""
            notices = [complete or f"continuing from {come.resumed} of {come.total} rows"] if come.resumed else []
            if come.seconds is not None and come.seconds >= WORTH_SAYING:
                notices.append(f"{come.total - come.resumed} rows, {round_time(come.seconds)}")
            if notices:
                print("; ".join(notices), file=sys.stderr, flush=True)
        if update is not None:
            update(come.done, come.total, come.resumed)

    return announce


def round_time(seconds: float) -> str:
    """Return a rough time in words.

    Examples
    --------
    >>> round_time(43.0), round_time(236.0), round_time(9000.0)
    ('about 40 seconds', 'about 4 minutes', 'about 2.5 hours')
    """
    for unit, size, most in (("seconds", 1.0, 90.0), ("minutes", 60.0, 90.0)):
        if seconds < most * size:
            return f"about {float(f'{seconds / size:.1g}'):g} {unit}"
    return f"about {seconds / 3600.0:.2g} hours"
