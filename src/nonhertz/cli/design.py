"""What ``nonhertz design`` reads, prints and writes."""

from __future__ import annotations

import contextlib
import json
import math
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from nonhertz.cli.options import named_as
from nonhertz.cli.printing import print_result
from nonhertz.files.folder import write_files
from nonhertz.files.held import as_toml
from nonhertz.files.planfile import read_design
from nonhertz.inputs.files import legible
from nonhertz.result.tables import csv_text
from nonhertz.show.sections import Said, Section
from nonhertz.show.studies import design_sections
from nonhertz.study.design import Design, best


def designed(plan: Path, changes: Mapping[str, Any], starts: int | None, workers: int | None) -> Design:
    """Return the design of a plan, whose case has other values by path, with progress on a terminal.

    Raises
    ------
    CaseError
        If the plan has mistakes.
    InputError
        If an option is refused, named as on the command line.
    """
    case, given = read_design(plan, changes)
    given |= {} if starts is None else {"starts": starts}
    with _progress() as announce, named_as(threads="--workers", starts="--starts"):
        return best(case, **given, workers=workers, announce=announce)


def directory_for(plan: Path) -> Path:
    """Return where a design is written if nothing else is said."""
    return Path(f"{legible(plan.stem)}-design")


def written(found: Design, out: Path) -> tuple[Path, ...]:
    """Write the case as it is best, its profile, all numbers and the figures; return the files."""
    from nonhertz.plot import save
    from nonhertz.study.pictures import design_figures

    def draw(folder: Path) -> None:
        for name, figure in design_figures(found).items():
            save(figure, folder / name)

    texts = {
        "case.toml": as_toml(found.case.document_in(out) | {"title": f"{found.was.title}, designed"}),
        "profile.csv": _profile(found),
        "design.json": as_json(found, ()) + "\n",
    }
    return write_files(out, texts, draw)


def as_json(found: Design, files: Sequence[Path]) -> str:
    """Return what `print_design` prints as JSON text."""
    content: dict[str, Any] = {
        "title": found.was.title,
        "goal": found.goal,
        "values": found.values,
        "value": _finite(found.value),
        "before": _finite(found.before),
        "worst": found.worst,
        "agreeing_starts": found.agreeing,
        "starts": [
            vars(start) | {"value": _finite(start.value), "history": [_finite(value) for value in start.history]}
            for start in found.starts
        ],
        "bands": [vars(band) for band in found.bands],
        "loads": [vars(load) for load in found.loads],
        "files": [str(path) for path in files],
        "units": found.units | {"value": "MPa" if found.goal == "pressure" else ""},
    }
    return json.dumps(content, indent=2, allow_nan=False)


def print_design(found: Design, files: Sequence[Path]) -> None:
    """Print the goal before and after, what is best, how flat that is, the searches, and the files."""
    print_result(found.was.title, [*design_sections(found), Section("", [Said([f"wrote {path}" for path in files])])])


def _profile(found: Design) -> str:
    """Return the relief of both bodies together as CSV, as it is best and as it was."""
    rows = np.column_stack(found.relief).tolist()
    cells = ([f"{y:.9g}", *("" if math.isnan(each) else f"{each:.9f}" for each in rest)] for y, *rest in rows)
    return csv_text(["y [mm]", "relief [mm]", "relief before [mm]"], cells)


def _finite(value: float) -> float | None:
    return value if math.isfinite(value) else None


@contextlib.contextmanager
def _progress() -> Iterator[Callable[[int, int], object] | None]:
    """Show how many searches have ended, on a terminal."""
    if not sys.stderr.isatty():
        yield None
        return
    from rich.console import Console
    from rich.progress import Progress

    with Progress(console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task("searches", total=None)
        yield lambda ended, starts: bar.update(task, completed=ended, total=starts)
