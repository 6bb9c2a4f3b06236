"""What ``nonhertz map`` makes of a case, what it prints and writes."""

from __future__ import annotations

import dataclasses
import json
import warnings
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from rich.text import Text

from nonhertz.cli.printing import console
from nonhertz.errors import InputError
from nonhertz.io.casefile import Case
from nonhertz.io.folder import write_files
from nonhertz.io.units import in_unit
from nonhertz.maps import ContactMap, MapPoint, contact_map
from nonhertz.maps.value import ROWS, TILTS
from nonhertz.result.numerals import digits
from nonhertz.strip.element import SEMI_ELLIPTIC

Range = tuple[float, float]

MOST_ROWS = 10_000
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
        name, (low, high), rows = "approach", *_range("--approach", approach, "mm", "-5um:40um")
    else:
        assert load is not None
        name, (low, high), rows = "load", *_range("--load", load, "N", "0:40kN")
    if tilt is None:
        return Request(name, (low, high), rows, None, None, accuracy)
    if ":" not in tilt:
        return Request(name, (low, high), rows, _number("--tilt", tilt, "rad"), 1, accuracy)
    return Request(name, (low, high), rows, *_range("--tilt", tilt, "rad", "-2mrad:2mrad"), accuracy)


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
    """Return the range and the bounds of a map as JSON text."""
    content = {
        "title": title,
        "description": found.description,
        found.given: found.pressed,
        "tilt": found.tilt_range,
        "most_load": found.most_load,
        "accuracy": found.accuracy,
        "bound": dataclasses.asdict(found.bound),
        "cases": found.cases,
        "failed": found.failed,
        "stations": found.stations.tolist(),
        "units": {"load": "N", "approach": "mm", "tilt": "rad", "most_load": "N", "stations": "mm"},
    }
    return json.dumps(content, indent=2, ensure_ascii=False)


def print_map(found: ContactMap, title: str) -> None:
    """Print the title and the summary of a map."""
    printing = console()
    printing.print(Text(title, style="bold"))
    for line in repr(found).splitlines()[1:]:
        printing.print(Text(line.strip()), soft_wrap=True)


def _range(option: str, text: str, unit: str, example: str) -> tuple[Range, int | None]:
    parts = text.split(":")
    remedy = f"write lowest and highest with units, such as {example}, and if you like a number of rows, {example}:21"
    if len(parts) not in {2, 3}:
        raise InputError(option, text, "be a range", remedy)
    low, high = (_number(option, part, unit) for part in parts[:2])
    if not low < high:
        condition = f"ascend, not go from {digits(low)} to {digits(high)} {unit}"
        raise InputError(option, text, condition, remedy)
    if len(parts) == 2:
        return (low, high), None
    if not parts[2].isascii() or not parts[2].isdigit() or not 2 <= int(parts[2][:9]) <= MOST_ROWS:
        raise InputError(option, text, f"have a whole number of rows from 2 to {MOST_ROWS} as its third part", remedy)
    return (low, high), int(parts[2])


def _number(option: str, text: str, unit: str) -> float:
    """Return a quantity in a unit; zero needs none."""
    try:
        if float(text) == 0.0:
            return 0.0
    except ValueError:
        pass
    try:
        return float(in_unit(option, text, unit))
    except InputError as error:
        # Nothing is in quotes on a command line.
        remedy = f"append a unit, such as {text.strip()}{'mrad' if unit == 'rad' else unit}"
        raise InputError(
            option, text, error.condition, remedy if error.condition == "have a unit" else error.remedy
        ) from None
