"""``nonhertz map``: a stand-in for a contact, for other programs."""

from __future__ import annotations

import dataclasses
import json
import warnings
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any

from cyclopts import Parameter

from nonhertz.cli.options import AsJson, Changes, UnitsRead, named_as, refuse_unwritable_out
from nonhertz.cli.printing import Progress, print_result
from nonhertz.errors import InputError
from nonhertz.files.casefile import Case, read_case
from nonhertz.files.changes import changes_in
from nonhertz.files.folder import write_files
from nonhertz.files.spreads import number_in, range_in
from nonhertz.maps import ContactMap, MapPoint
from nonhertz.maps import contact_map as map_of
from nonhertz.maps.value import ROWS, TILTS
from nonhertz.show.sections import Said, Section
from nonhertz.strip.element import SEMI_ELLIPTIC

Range = tuple[float, float]

_SUFFIXES = (".csv", ".mat", ".npz")


@dataclass(frozen=True)
class Request:
    """The range of a map, and the rows of its table.

    Attributes
    ----------
    name : str
        ``"load"`` or ``"approach"``.
    pressed : tuple of float
        Its lowest and highest value [N or mm].
    rows : int or None
        Number of them in the table.
    tilt : tuple of float or float or None
        Range of tilts, or a single one [rad]; None for that of the case.
    tilts : int or None
        Number of them in the table.
    accuracy : float
    """

    name: str
    pressed: Range
    rows: int | None
    tilt: Range | float | None
    tilts: int | None
    accuracy: float


def contact_map(
    case: Path,
    /,
    *,
    changes: Changes = (),
    approach: Annotated[str | None, Parameter(allow_leading_hyphen=True)] = None,
    load: Annotated[str | None, Parameter(allow_leading_hyphen=True)] = None,
    tilt: Annotated[str | None, Parameter(allow_leading_hyphen=True)] = None,
    accuracy: float = 1e-4,
    out: Path | None = None,
    units: UnitsRead = "si",
    as_json: AsJson = False,
) -> None:
    """Make a map of a case: load, moment and stiffness over approach and tilt, for other programs.

    A map is a stand-in for the contact, a thousand times as fast as solving it, with errors sampled at points of
    their own. It takes hundreds of solves.

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
        The file to write: .csv or .mat for a table, .npz for the map itself, which nonhertz.ContactMap.load reads. An
        existing file is replaced.
    """
    read = read_case(case, changes_in(changes))
    asked = _requested(approach, load, tilt, accuracy, out)
    refuse_unwritable_out(None if out is None else out.parent)
    found = _made(read, asked)
    made = () if out is None else _written(out, found, asked)
    if as_json:
        print(_as_json(found, read.title))
    else:
        words = [line.strip() for line in repr(found).splitlines()[1:]]
        print_result(read.title, [Section("", [Said(words)])], written=made)


def _requested(approach: str | None, load: str | None, tilt: str | None, accuracy: float, out: Path | None) -> Request:
    """Return what the options ask for.

    Raises
    ------
    InputError
        If an option is missing or cannot be read, named as on the command line.
    """
    if (approach is None) == (load is None):
        raise InputError("--load", load, "be given where --approach is not, and only there", "write --load 0:20kN")
    if out is not None and (out.suffix.lower() not in _SUFFIXES or out.is_dir()):
        remedy = "name a .csv or .mat file for a table, or a .npz file for the map itself"
        raise InputError("--out", str(out), f"be a file ending in {', '.join(_SUFFIXES)}", remedy)
    if approach is not None:
        name, (low, high, rows) = "approach", range_in("--approach", approach, "mm", "-5um:40um")
    else:
        assert load is not None
        name, (low, high, rows) = "load", range_in("--load", load, "N", "0:40kN")
    if tilt is None:
        return Request(name, (low, high), rows, None, None, accuracy)
    if ":" not in tilt:
        return Request(name, (low, high), rows, number_in("--tilt", tilt, "rad"), 1, accuracy)
    lowest, highest, tilts = range_in("--tilt", tilt, "rad", "-2mrad:2mrad")
    return Request(name, (low, high), rows, (lowest, highest), tilts, accuracy)


def _made(case: Case, request: Request) -> ContactMap:
    """Return the map of a case; what it warns of is printed.

    Raises
    ------
    InputError
        If no map can be made.
    """
    tilt = float(case.prescribed.get("tilt", 0.0)) if request.tilt is None else request.tilt
    pressed: dict[str, Any] = {request.name: request.pressed}
    options = {name: f"--{name}" for name in ("load", "approach", "tilt", "accuracy")}
    with named_as(**options), Progress(None) as progress, warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        found = map_of(
            case.contact,
            **pressed,
            tilt=tilt,
            accuracy=request.accuracy,
            element=case.solver.get("element", SEMI_ELLIPTIC),
            announce=progress.announce,
        )
    for each in caught:
        warnings.warn_explicit(each.message, each.category, each.filename, each.lineno)
    return found


def _table(found: ContactMap, request: Request) -> MapPoint:
    """Return the points of the table of a map."""
    tilts = request.tilts if isinstance(request.tilt, tuple) else 1
    return found.grid(request.rows or ROWS, tilts or TILTS)


def _written(path: Path, found: ContactMap, request: Request) -> tuple[Path, ...]:
    """Write a map, or a table of it, and return the file.

    Raises
    ------
    InputError
        If its directory cannot be written to.
    """
    if path.suffix.lower() == ".csv":
        return write_files(path.parent, {path.name: found.csv(_table(found, request))})

    def draft(folder: Path) -> None:
        if path.suffix.lower() == ".npz":
            found.save(folder / path.name)
        else:
            found.to_mat(folder / path.name, _table(found, request))

    return write_files(path.parent, {}, draft)


def _as_json(found: ContactMap, title: str) -> str:
    """Return the range and the sampled errors of a map as JSON text."""
    content = {
        "title": title,
        "description": found.description,
        found.given: found.pressed,
        "tilt": found.tilt_range,
        "most_load": found.most_load,
        "accuracy": found.accuracy,
        "sampled_error": dataclasses.asdict(found.sampled_error),
        "cases": found.cases,
        "failed": found.failed,
        "stations": found.stations.tolist(),
        "units": {"load": "N", "approach": "mm", "tilt": "rad", "most_load": "N", "stations": "mm"},
    }
    return json.dumps(content, indent=2)
