"""``nonhertz bearing --over``: numbers of a bearing over one of its inputs."""

from __future__ import annotations

from functools import partial
from pathlib import Path

from nonhertz.cli.answer import Answer
from nonhertz.cli.options import rename_fields, split_assignment
from nonhertz.cli.printing import progress_bar
from nonhertz.cli.sweep import report_rows
from nonhertz.errors import InputError, UnknownKeyError
from nonhertz.files.bearingfile import BearingCase
from nonhertz.files.studies import DIAGRAM, as_text
from nonhertz.show.studies import diagram_sections
from nonhertz.study.diagrams import diagram


def solve_diagram(case: BearingCase, over: str, workers: int | None, out: Path | None) -> Answer:
    """Return life, pressure and stiffness of a bearing over one of its inputs, and write them into a directory, if any.

    Raises
    ------
    InputError
        If the input or its range is refused, named as on the command line.
    """
    path, values = split_assignment(over, "--over clearance=0:60um", "--over")
    with progress_bar("rows") as update, rename_fields(threads="--workers", over="--over"):
        try:
            bearing_diagram = diagram(case, path, values, workers=workers, callback=report_rows(update))
        except UnknownKeyError:
            raise
        except InputError as error:
            raise error.about(f"--over {error.field}", values) from None
    made = () if out is None else bearing_diagram.save(out)
    as_json = partial(as_text, DIAGRAM, made, diagram=bearing_diagram, sweep=bearing_diagram.sweep)
    return Answer(case.title, diagram_sections(bearing_diagram), as_json, bearing_diagram.sweep.verdict, written=made)
