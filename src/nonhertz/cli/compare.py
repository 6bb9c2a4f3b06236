"""What ``nonhertz compare`` runs, writes and prints."""

from __future__ import annotations

from pathlib import Path

from nonhertz import comparison as methods
from nonhertz.cli.verify import Progress
from nonhertz.comparison import Comparison
from nonhertz.errors import InputError
from nonhertz.files.casefile import Case, placed

_METHODS = 3


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
