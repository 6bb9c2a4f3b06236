"""``nonhertz tolerance``: how results are distributed."""

from __future__ import annotations

from functools import partial
from pathlib import Path

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
    split_assignments,
)
from nonhertz.cli.printing import progress_bar
from nonhertz.cli.sweep import load_plan, report_rows
from nonhertz.files.studies import TOLERANCE, as_text
from nonhertz.files.workbooks import refuse_missing_writer
from nonhertz.plot.drawer import sheets_of
from nonhertz.show.studies import tolerance_sections
from nonhertz.study.figures import tolerance_figures
from nonhertz.study.tolerances import tolerance


def study_tolerance(
    plan: Path,
    /,
    *,
    changes: Changes = NONE,
    over: Words = (),
    quantities: Words = (),
    limits: Words = (),
    samples: int | None = None,
    seed: int | None = None,
    out: Path | None = None,
    workers: Workers = None,
    scheduler: Scheduler = None,
    excel: Excel = False,
) -> Answer:
    """Propagate tolerances to results, and rank their influence.

    Rows are saved as they are solved; the same command continues a study that was interrupted.

    Parameters
    ----------
    plan : Path
        The plan file, with a table tolerance; or a case file or a bearing file, with --over.
    over : tuple of str
        A path in the file and its distribution, such as 'body.b.diameter=normal(nominal,5um)'; may be given several
        times.
    quantities : tuple of str
        Names of the quantities to study, such as max_pressure life; by default the usual ones.
    limits : tuple of str
        A quantity and its limit, such as 'max_pressure=at most 3800 MPa': the fraction beyond it and Cpk are printed;
        may be given several times. They replace the limits of the plan.
    samples : int
        Largest number of rows, by default that of the plan, or 2000; more give narrower confidence intervals.
    seed : int
        Seed of the samples, by default that of the plan, or 0; the same seed draws the same samples.
    out : Path
        Directory for the rows, rows.csv, rows.parquet (where polars is installed), tolerance.json and the figures; by
        default the file's name with '-tolerance', in the current directory.
    """
    if excel:
        refuse_missing_writer()
    study_plan = load_plan(plan, over, quantities, "tolerance", changes)
    directory = default_output_path(plan, "-tolerance", out)
    bounds = split_assignments(limits, "max_pressure='at most 3800 MPa'", "--limits") or None
    options = {"threads": "--workers", "count": "--samples", "seed": "--seed", "over": "--over"}
    with progress_bar("rows") as update, rename_fields(**options):
        study = tolerance(
            study_plan, samples=samples, seed=seed, limits=bounds, out=directory, workers=workers, scheduler=scheduler,
            callback=report_rows(update),
        )  # fmt: skip

    as_json = partial(as_text, TOLERANCE, tolerance=study, sweep=study.sweep)

    def draw(folder: Path) -> None:
        (folder / "tolerance.json").write_text(as_json() + "\n", encoding="utf-8")
        figure_writer(lambda: sheets_of(tolerance_figures(study), study.sweep.plan.title))(folder)

    made = study.sweep.save(directory, draw, excel=excel)
    title, shown = study.sweep.plan.title, tolerance_sections(study)
    return Answer(title, shown, partial(as_json, made), verdict=study.verdict, written=made)
