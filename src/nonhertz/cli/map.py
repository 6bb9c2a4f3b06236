"""``nonhertz map``: a stand-in for a contact, for other programs."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Annotated, Any

from cyclopts import Parameter

from nonhertz import InputError, read_case
from nonhertz.cli.answer import Answer
from nonhertz.cli.options import NONE, Changes, refuse_unwritable_out, rename_fields
from nonhertz.cli.printing import Progress
from nonhertz.errors import without_accuracy_warnings
from nonhertz.files.folder import write_files
from nonhertz.files.map_results import as_object
from nonhertz.files.spreads import parse_number, parse_range
from nonhertz.maps import contact_map as map_of
from nonhertz.maps.value import ROWS, TILTS
from nonhertz.show.maps import sections

_SUFFIXES = (".csv", ".npz")
_OPTIONS = {name: f"--{name}" for name in ("load", "approach", "tilt", "accuracy")}
_EXAMPLES = {"approach": ("mm", "-5um:40um"), "load": ("N", "0:40kN")}


def contact_map(
    case: Path,
    /,
    *,
    changes: Changes = NONE,
    approach: Annotated[str | None, Parameter(allow_leading_hyphen=True)] = None,
    load: Annotated[str | None, Parameter(allow_leading_hyphen=True)] = None,
    tilt: Annotated[str | None, Parameter(allow_leading_hyphen=True)] = None,
    accuracy: float = 1e-4,
    out: Path | None = None,
) -> Answer:
    """Tabulate load, moment and stiffness of a case over approach and tilt.

    A map replaces the contact in other programs: it is a thousand times as fast as solving, with errors checked at
    independent points. Making one takes hundreds of solves.

    Parameters
    ----------
    case : Path
        The case file; its load, approach and solver.strips have no effect.
    approach : str
        Lowest and highest approach with units, such as -5um:40um; with a third part, such as -5um:40um:46, the number
        of rows of the table per tilt. Give this or --load.
    load : str
        Lowest and highest load, such as 0:40kN or 0:40kN:41.
    tilt : str
        Lowest and highest tilt, such as -2mrad:2mrad or -2mrad:2mrad:21, or a single one; by default that of the case.
    accuracy : float
        Largest error of load and moment, relative.
    out : Path
        The file to write: .csv for a table, .npz for the map itself, which nonhertz.ContactMap.read reads. An
        existing file is replaced.
    """
    read = read_case(case, changes)
    pressing = {name: word for name, word in (("approach", approach), ("load", load)) if word is not None}
    if len(pressing) != 1:
        raise InputError("--load", load, "be given if --approach is not, and only then", "write --load 0:20kN")
    if out is not None and (out.suffix.lower() not in _SUFFIXES or out.is_dir()):
        remedy = "name a .csv file for a table, or a .npz file for the map itself"
        raise InputError("--out", str(out), f"be a file ending in {', '.join(_SUFFIXES)}", remedy)
    ((name, word),) = pressing.items()
    low, high, rows = parse_range(_OPTIONS[name], word, *_EXAMPLES[name])
    pressed: dict[str, Any] = {name: (low, high)}
    turned, tilts = _parse_tilt(tilt, read.prescribed.tilt)
    refuse_unwritable_out(out, file=True)
    with rename_fields(**_OPTIONS), Progress(None) as progress, without_accuracy_warnings():
        fitted_map = map_of(
            read.contact, **pressed, tilt=turned, accuracy=accuracy, element=read.solver.element,
            callback=progress.announce,
        )  # fmt: skip
    made: tuple[Path, ...] = ()
    if out is not None:
        is_table = out.suffix.lower() == ".csv"
        texts = {out.name: fitted_map.csv(fitted_map.grid(rows or ROWS, tilts))} if is_table else {}
        made = write_files(out.parent, texts, None if is_table else lambda folder: fitted_map.save(folder / out.name))
    shown, text = sections(fitted_map), lambda: json.dumps(as_object(fitted_map, read.title), indent=2)
    return Answer(read.title, shown, text, warnings=fitted_map.findings, written=made)


def _parse_tilt(text: str | None, usual: float | None) -> tuple[float | tuple[float, float], int]:
    """Return a range of tilts, or a single tilt, and how many of them a table has."""
    if text is None:
        return usual or 0.0, 1
    if ":" not in text:
        return parse_number("--tilt", text, "rad"), 1
    low, high, count = parse_range("--tilt", text, "rad", "-2mrad:2mrad")
    return (low, high), count or TILTS
