"""``nonhertz new``: files to start from."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from nonhertz.cli.options import Words, named_as, path_and_value
from nonhertz.errors import InputError
from nonhertz.files.bearingfile import starting_bearing
from nonhertz.files.casefile import starting_case
from nonhertz.files.catalogue import guess_of_catalogue, text_of_guess
from nonhertz.files.documents import write_new
from nonhertz.files.planfile import read_any, starting_plan


def new(
    path: Path | None = None,
    /,
    *,
    template: str | None = None,
    bearing: Annotated[bool, Parameter(negative="")] = False,
    plan: Annotated[bool, Parameter(negative="")] = False,
    case: Path | None = None,
    catalogue: Words = (),
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
        with all that such a file may hold.
    bearing : bool
        Write a bearing file instead.
    plan : bool
        Write a plan instead, for sweep, tolerance and design.
    case : Path
        With --plan, the case file or bearing file that the plan is for; by default case.toml.
    catalogue : tuple of str
        With --bearing, numbers of a catalogue, from which the rollers are guessed: d=30 D=62 B=16 C=44kN C0=36.5kN,
        for other kinds kind=needle or kind=tapered with e, Y or alpha, and if known raceways F and E, and clearance.
    rexs : Path
        With --bearing, a file in REXS, version 1.4 or later, XML or JSON, with the bearing.
    component : int
        With --rexs, the number of the bearing in a model of several.
    """
    _refuse_beside_rexs(rexs, component, bearing and not (plan or catalogue or template is not None))
    if catalogue and (plan or template is not None or not bearing):
        option = "--plan" if plan else "--template"
        condition = "be given with --bearing" if not bearing and not plan else f"not be given with {option}"
        raise InputError("--catalogue", " ".join(catalogue), condition, "write one file")
    if plan and template is not None:
        raise InputError("--template", template, "not be given with --plan", "leave one out")
    if bearing and plan:
        raise InputError("--plan", True, "not be given with --bearing", "write one file after the other")
    if case is not None and not plan:
        raise InputError("--case", str(case), "be given with --plan", "add that, or leave it out")
    folder = Path() if path is None else path.parent
    file = folder / "case.toml" if case is None else case
    with named_as(template="--template", component="--component", rexs="--rexs", catalogue="--catalogue"):
        if rexs is not None:
            from nonhertz.files.rexs import bearing_file_of_rexs  # loaded for it alone

            text = bearing_file_of_rexs(rexs, component)
        elif catalogue:
            data = dict(path_and_value(word, "d=30", "--catalogue") for word in catalogue)
            text = text_of_guess(guess_of_catalogue(data))
        elif case is not None:
            text = starting_plan(read_any(case), folder)
        else:
            text = starting_bearing(template) if bearing else starting_plan() if plan else starting_case(template)
    if path is None:
        print(text, end="")
    else:
        write_new(text, path)
        way_on = f"solve it with: nonhertz {'bearing' if bearing else 'solve'} {path}"
        if plan:
            first = "" if file.exists() else f"nonhertz new {file}, then "
            way_on = f"for {file}; try it with: {first}nonhertz {'design' if '[design]' in text else 'check'} {path}"
        print(f"wrote {path}{',' if plan else ';'} {way_on}")


def _refuse_beside_rexs(rexs: Path | None, component: int | None, alone: bool) -> None:
    """Refuse options that do not go with a file in REXS."""
    if rexs is not None and not alone:
        condition = "be given with --bearing, and without --plan, --template and --catalogue"
        raise InputError("--rexs", str(rexs), condition, "write one bearing file")
    if component is not None and rexs is None:
        raise InputError("--component", component, "be given with --rexs", "add that, or leave it out")
