"""A solution as text and on disk: one JSON object, one table, and whatever figures the caller draws."""

from __future__ import annotations

import contextlib
import csv
import io
import json
import math
import os
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from nonhertz.errors import InputError
from nonhertz.io.drafts import drafts_in
from nonhertz.io.written import FORMAT, document
from nonhertz.result.quantities import ALONG, QUANTITIES
from nonhertz.result.solution import EdgePressure, Solution

if TYPE_CHECKING:
    from nonhertz.io.casefile import Case

# The stiffness is written as the matrix that it is.
_NUMBERS = tuple(name for name in QUANTITIES if "_by_" not in name)

#: Units of the numbers in a result; what has no unit is left out.
UNITS: dict[str, Any] = {
    **{name: QUANTITIES[name].unit for name in _NUMBERS},
    "contact_y": "mm",
    "edge_pressure": {
        "y": "mm",
        "pressure": "MPa",
        "strip_width": "mm",
        "strength": "MPa mm^exponent",
        "correction": "mm^(-2 exponent)",
    },
    "singular_ends": {"y": "mm"},
    "stiffness": [["N/mm", "N/rad"], ["N mm/mm", "N mm/rad"]],
    **ALONG,
    "edges": "mm",
    "element_half_width": "mm",
}
_OUT_REMEDY = "give a directory to write to"


def as_object(solution: Solution, case: Case) -> dict[str, Any]:
    """Return a solution as plain numbers, text, lists and dictionaries, with the case that it is of.

    `nonhertz.io.resultfile.read_result` reads it back.

    Numbers are as the solver has them; one that is not finite is None, since JSON has no infinity. Such is the error
    estimate of a maximum pressure at a corner of the profile.
    """
    return {
        "format": FORMAT,
        "title": case.title,
        "status": solution.status.label,
        "element": solution.element.name,
        **{name: plain(QUANTITIES[name].get(solution)) for name in _NUMBERS},
        "contact_y": plain(solution.contact_y),
        "edge_pressure": [_edge_object(edge) for edge in solution.edge_pressure],
        "singular_ends": [{"y": plain(end.y), "kind": end.kind.label} for end in solution.singular_ends],
        "stiffness": plain(solution.stiffness),
        "peaks_at_corner": solution.peaks_at_corner,
        "iterations": int(solution.iterations),
        "strips": solution.strips,
        "error_estimate": {name: plain(value) for name, value in vars(solution.error_estimate).items()},
        "warnings": list(solution.warnings),
        "units": UNITS,
        **{name: plain(column) for name, column in solution.table().items()},
        "edges": plain(solution.edges),
        "element_half_width": plain(solution.element_half_width),
        "case": document(case),
    }


def plain(value: Any) -> Any:
    """Return a number, or numbers nested in arrays, lists and tuples, as JSON has them.

    Examples
    --------
    >>> plain(np.array([1.0, np.inf])), plain(None)
    ([1.0, None], None)
    """
    if value is None:
        return None
    if isinstance(value, np.ndarray):
        return plain(value.tolist())
    if isinstance(value, list | tuple):
        return [plain(entry) for entry in value]
    number = float(value)
    return number if math.isfinite(number) else None


def as_json(solution: Solution, case: Case) -> str:
    """Return `as_object` as JSON text, one key to a line."""
    return key_by_key(as_object(solution, case))


def key_by_key(entries: dict[str, Any]) -> str:
    """Return an object as JSON text, one of its keys to a line.

    Examples
    --------
    >>> print(key_by_key({"load": 1.0, "y": [0.0, 1.0]}))
    {
      "load": 1.0,
      "y": [0.0, 1.0]
    }
    """
    lines = (f"  {json.dumps(key)}: {json.dumps(value, allow_nan=False)}" for key, value in entries.items())
    return "{\n" + ",\n".join(lines) + "\n}"


def as_table(solution: Solution) -> str:
    """Return the strips as comma-separated values, a line of names and units first."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(f"{name} [{unit}]" for name, unit in ALONG.items())
    writer.writerows(zip(*(column.tolist() for column in solution.table().values()), strict=True))
    return text.getvalue()


def write_results(
    directory: str | Path, solution: Solution, case: Case, draw: Callable[[Path], object] | None = None
) -> tuple[Path, ...]:
    """Write result.json, table.csv and what ``draw`` writes into a directory, all of them or none.

    Parameters
    ----------
    directory : str or Path
        Where to; made if it does not exist. Files of the same names are replaced.
    solution : Solution
        What to write.
    case : Case
        What was solved.
    draw : callable or None
        Writes further files, figures that is, into the directory that it is given.

    Returns
    -------
    tuple of Path
        The files.

    Raises
    ------
    InputError
        If the directory cannot be written to.
    """

    def write(folder: Path) -> None:
        (folder / "result.json").write_text(as_json(solution, case) + "\n", encoding="utf-8")
        (folder / "table.csv").write_text(as_table(solution), encoding="utf-8")
        if draw is not None:
            draw(folder)

    return write_files(directory, write)


def write_files(directory: str | Path, write: Callable[[Path], object]) -> tuple[Path, ...]:
    """Put into a directory what ``write`` writes, all files or none.

    Parameters
    ----------
    directory : str or Path
        Where to; made if it does not exist. Files of the same names are replaced.
    write : callable
        Writes the files into the directory that it is given, where they are drafts until it returns.

    Returns
    -------
    tuple of Path
        The files.

    Raises
    ------
    InputError
        If the directory cannot be written to.
    """
    directory = Path(directory)
    try:
        with _directory(directory), drafts_in(directory) as drafts:
            write(drafts)
            return _moved(drafts, directory)
    except OSError as error:
        raise _unwritable(directory, error) from None


def refuse_unwritable(directory: Path) -> None:
    """Refuse what is no directory to write to: `write_files` would, but only when all the work is done.

    The directory is tried and left as it was.

    Raises
    ------
    InputError
        If the directory cannot be written to.
    """
    made = _missing(directory)
    try:
        with _directory(directory), drafts_in(directory):
            pass
    except OSError as error:
        raise _unwritable(directory, error) from None
    _take_away(made)


def _unwritable(directory: Path, error: OSError) -> InputError:
    reason = (error.strerror or str(error)).lower()
    return InputError("--out", str(directory), f"be a directory to write to ({reason})", "choose another")


@contextlib.contextmanager
def _directory(directory: Path) -> Iterator[None]:
    """Make a directory, and take it away again if what follows fails."""
    if directory.exists() and not directory.is_dir():
        raise InputError("--out", str(directory), "be a directory, not a file", _OUT_REMEDY)
    made = _missing(directory)
    try:
        directory.mkdir(parents=True, exist_ok=True)
        yield
    except BaseException:
        _take_away(made)
        raise


def _missing(directory: Path) -> list[Path]:
    """Return what has to be made for a directory to be there, the innermost first."""
    return [path for path in (directory, *directory.parents) if not path.exists()]


def _take_away(made: list[Path]) -> None:
    for path in made:
        with contextlib.suppress(OSError):
            path.rmdir()


def _moved(drafts: Path, directory: Path) -> tuple[Path, ...]:
    files = [(draft, directory / draft.name) for draft in sorted(drafts.iterdir())]
    for _, target in files:
        if target.is_dir():
            raise InputError("--out", str(directory), f"not hold a directory named {target.name}", _OUT_REMEDY)
    for draft, target in files:
        os.replace(draft, target)  # noqa: PTH105  (says that it replaces)
    return tuple(target for _, target in files)


def _edge_object(edge: EdgePressure) -> dict[str, Any]:
    return {
        "y": plain(edge.y),
        "kind": edge.kind.label,
        "pressure": plain(edge.pressure),
        "strip_width": plain(edge.strip_width),
        "image_weight": plain(edge.image_weight),
        "exponent": plain(edge.exponent),
        "strength": plain(edge.strength),
        "correction": plain(edge.correction),
        "convention": edge.convention,
        "converges": edge.converges,
    }
