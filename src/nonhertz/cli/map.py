"""What ``nonhertz map`` makes of a case, what it prints and writes."""

from __future__ import annotations

import dataclasses
import json
import warnings
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from nonhertz.cli.printing import Printed
from nonhertz.errors import InputError
from nonhertz.files.casefile import Case
from nonhertz.files.folder import write_files
from nonhertz.files.ranges import number_in, range_in
from nonhertz.maps import ContactMap, MapPoint, contact_map
from nonhertz.maps.value import ROWS, TILTS
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


def requested(approach: str | None, load: str | None, tilt: str | None, accuracy: float, out: Path | None) -> Request:
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


def made(case: Case, request: Request) -> ContactMap:
    """Return the map of a case; what it warns of is printed.

    Raises
    ------
    InputError
        If no map can be made.
    """
    from nonhertz.cli.verify import Progress

    tilt = float(case.prescribed.get("tilt", 0.0)) if request.tilt is None else request.tilt
    pressed: dict[str, Any] = {request.name: request.pressed}
    progress = Progress(None)
    try:
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            found = contact_map(
                case.contact,
                **pressed,
                tilt=tilt,
                accuracy=request.accuracy,
                element=case.solver.get("element", SEMI_ELLIPTIC),
                announce=progress.announce,
            )
    except InputError as error:
        if error.field in {"load", "approach", "tilt", "accuracy"}:
            raise InputError("--" + error.field, error.value, error.condition, error.remedy) from None
        raise
    finally:
        progress.wipe()
    for each in caught:
        warnings.warn_explicit(each.message, each.category, each.filename, each.lineno)
    return found


def table(found: ContactMap, request: Request) -> MapPoint:
    """Return the points of the table of a map."""
    tilts = request.tilts if isinstance(request.tilt, tuple) else 1
    return found.grid(request.rows or ROWS, tilts or TILTS)


def write(path: Path, found: ContactMap, request: Request) -> tuple[Path, ...]:
    """Write a map, or a table of it, and return the file.

    Raises
    ------
    InputError
        If its directory cannot be written to.
    """
    if path.suffix.lower() == ".csv":
        return write_files(path.parent, {path.name: found.csv(table(found, request))})

    def draft(folder: Path) -> None:
        if path.suffix.lower() == ".npz":
            found.save(folder / path.name)
        else:
            found.to_mat(folder / path.name, table(found, request))

    return write_files(path.parent, {}, draft)


def as_json(found: ContactMap, title: str) -> str:
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


def print_map(found: ContactMap, title: str) -> None:
    """Print the title and the summary of a map."""
    Printed(title).say(*(line.strip() for line in repr(found).splitlines()[1:]))
