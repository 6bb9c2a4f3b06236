"""``nonhertz compare``: strips beside a plane grid."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from nonhertz import comparison as methods
from nonhertz import plot
from nonhertz.cli.answer import Answer
from nonhertz.cli.options import NONE, Changes, refuse_unwritable_out, write_outputs
from nonhertz.cli.printing import Progress
from nonhertz.errors import InputError
from nonhertz.files.casefile import read_case, with_file_path
from nonhertz.files.comparisons import as_object, files
from nonhertz.files.results import key_by_key
from nonhertz.show.comparison import sections
from nonhertz.verdict import judge_contact

_METHODS = 3


def compare(
    case: Path,
    /,
    *,
    changes: Changes = NONE,
    out: Path | None = None,
    cells: Annotated[tuple[int, int] | None, Parameter(negative="", show_default=False)] = None,
) -> Answer:
    """Compare the strips of both elements with a plane grid.

    The plane grid assumes nothing about the distribution of the pressure across the contact. Places where its pressure
    differs from that of the strips by more than 1 % are listed. This takes a few seconds.

    Parameters
    ----------
    case : Path
        The case file; its solver.element has no effect, solver.strips applies to both elements.
    out : Path
        Directory for comparison.json, comparison.csv and the figure; created if it does not exist.
    cells : tuple of int
        Cells of the plane grid, ACROSS and ALONG; 128 512 if left out.
    """
    read = read_case(case, changes)
    refuse_unwritable_out(out)
    options = {name: value for name, value in read.solver.keywords.items() if name != "element"}
    try:
        with Progress(_METHODS) as progress:
            comparison = methods.compare(
                read.contact, **read.prescribed.keywords, **options, cells=cells, callback=progress.announce
            )
    except InputError as error:
        if error.field == "cells":
            raise InputError("--cells", error.value, error.condition, "give two whole numbers such as 64 256") from None
        raise with_file_path(error, read.document) from None
    title = read.title
    made = write_outputs(
        out, lambda: files(comparison, title), lambda: {"comparison": plot.comparison(comparison, title)}
    )
    verdict, text = judge_contact(comparison.semi_elliptic), lambda: key_by_key(as_object(comparison, title))
    return Answer(title, sections(comparison), text, verdict, comparison.warnings, made)
