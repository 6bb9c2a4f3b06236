"""``nonhertz new``: files to start from."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from nonhertz.cli.options import Words, rename_fields, split_assignments
from nonhertz.errors import InputError
from nonhertz.files.catalogue import guess_of_catalogue, text_of_guess
from nonhertz.files.geometries import bearing_of_designation
from nonhertz.files.planfile import read_any, starting_plan
from nonhertz.files.starting import starting_bearing, starting_case
from nonhertz.files.toml import write_new

_OPTIONS = {name: f"--{name}" for name in ("template", "component", "rexs", "catalogue", "designation", "geometries")}


def new(
    path: Path | None = None,
    /,
    *,
    template: str | None = None,
    bearing: Annotated[bool, Parameter(negative="")] = False,
    plan: Annotated[bool, Parameter(negative="")] = False,
    case: Path | None = None,
    catalogue: Words = (),
    designation: str | None = None,
    geometries: Path | None = None,
    rexs: Path | None = None,
    component: int | None = None,
) -> None:
    """Write a commented case file, bearing file or plan to start from.

    Parameters
    ----------
    path : Path
        The file to write; an existing file is never overwritten. By default the text is printed.
    template : str
        A machine element: cylindrical, tapered, spherical, needle, wheel-on-rail, gear-flank or cam; with --bearing a
        bearing: cylindrical, needle, tapered-pair, spherical or thrust. By default a roller on a plate, or a NU 206,
        with every key that such a file may have.
    bearing : bool
        Write a bearing file instead.
    plan : bool
        Write a plan instead, for sweep, tolerance and design.
    case : Path
        With --plan, the case file or bearing file of the plan; by default case.toml.
    catalogue : tuple of str
        With --bearing, catalogue data from which the rollers are estimated: d=30 D=62 B=16 C=44kN C0=36.5kN, for other
        kinds kind=needle or kind=tapered with e, Y or alpha, and, if known, raceway diameters F and E, number Z and
        length L of the rollers, and clearance.
    designation : str
        With --bearing, the designation of a cylindrical roller bearing whose raceways are in catalogues: "NU 206".
    geometries : Path
        With --designation, a CSV file of your own geometries, with columns designation,d,D,B,C,C0,F,E,Z,L,source.
    rexs : Path
        With --bearing, a REXS file (1.4 or later, XML or JSON) with the bearing.
    component : int
        With --rexs, the number of the bearing in a model of several.
    """
    sources = {
        "--template": template, "--catalogue": " ".join(catalogue), "--designation": designation,
        "--rexs": None if rexs is None else str(rexs),
    }  # fmt: skip
    _refuse_together(sources, bearing, plan)
    _refuse_alone("--case", case, "--plan", plan)
    _refuse_alone("--component", component, "--rexs", rexs is not None)
    _refuse_alone("--geometries", geometries, "--designation", designation is not None)
    with rename_fields(**_OPTIONS):
        if rexs is not None:
            from nonhertz.files.rexs import bearing_file_of_rexs  # loaded for it alone

            text = bearing_file_of_rexs(rexs, component)
        elif catalogue:
            text = text_of_guess(guess_of_catalogue(split_assignments(catalogue, "d=30", "--catalogue")))
        elif designation is not None:
            text = bearing_of_designation(designation, geometries)
        elif bearing:
            text = starting_bearing(template)
        else:
            text = _plan(path, case) if plan else starting_case(template)
    if path is None:
        print(text, end="")
    else:
        write_new(text, path)
        print(f"wrote {path}{',' if plan else ';'} {_way_on(path, case, text, bearing, plan)}")


def _plan(path: Path | None, case: Path | None) -> str:
    return starting_plan() if case is None else starting_plan(read_any(case), Path() if path is None else path.parent)


def _way_on(path: Path, case: Path | None, text: str, bearing: bool, plan: bool) -> str:
    if not plan:
        return f"solve it with: nonhertz {'bearing' if bearing else 'solve'} {path}"
    file = path.parent / "case.toml" if case is None else case
    first = "" if file.exists() else f"nonhertz new {file}, then "
    return f"for {file}; try it with: {first}nonhertz {'design' if '[design]' in text else 'check'} {path}"


def _refuse_together(sources: Mapping[str, str | None], bearing: bool, plan: bool) -> None:
    """Refuse more than one source of the file to write, and sources of bearings without ``--bearing``."""
    if bearing and plan:
        raise InputError("--plan", True, "not be given with --bearing", "write one file after the other")
    (name, value), *others = (*((name, value) for name, value in sources.items() if value), ("", ""))
    rival = "--plan" if plan else others[0][0] if len(others) > 1 else ""
    if name and rival:
        raise InputError(name, value, f"not be given with {rival}", "leave one out")
    if name not in ("", "--template") and not bearing:
        raise InputError(name, value, "be given with --bearing", "write a bearing file")


def _refuse_alone(name: str, value: Path | int | None, other: str, present: bool) -> None:
    if value is not None and not present:
        shown = value if isinstance(value, int) else str(value)
        raise InputError(name, shown, f"be given with {other}", "add that, or leave it out")
