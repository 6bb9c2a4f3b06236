"""The commands and their arguments.

``--help`` prints the docstrings.
"""

from __future__ import annotations

import contextlib
import contextvars
import itertools
import os
import re
import sys
import warnings
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Annotated, Literal, NoReturn

from cyclopts import App, CycloptsError, Parameter, UnusedCliTokensError

from nonhertz import __version__
from nonhertz.cli import BAD_INPUT, FINE, NOT_CONVERGED, NOT_KEPT, NOT_VERIFIED
from nonhertz.errors import CaseError, ConvergenceError, InputError

Changes = Annotated[
    tuple[str, ...],
    Parameter(
        name="--set",
        negative="",
        show_default=False,
        allow_leading_hyphen=True,
        help="A path and a value in place of that in the file, such as load.load=5kN or body.a.profile.drop=12um; or "
        "several. Without a value, the key is taken out of the file.",
    ),
]
Excel = Annotated[
    bool,
    Parameter(name="--excel", negative="", help="Write the rows as rows.xlsx, too, with the inputs on a second sheet."),
]
UnitsRead = Annotated[
    Literal["si", "us"],
    Parameter(
        name="--units",
        help="Units of what is shown: us for in, lbf and ksi. Options, JSON, CSV and other files stay in mm, N, MPa.",
    ),
]


_CHANGE = re.compile(r"[A-Za-z][\w.\[\]-]*=")

app = App(
    name="nonhertz",
    help="Elastic contact of rollers, raceways, gear teeth and wheels whose shape no Hertz formula fits.",
    help_epilogue="Exit codes: 0 success, 1 not converged or not verified, 2 bad input, 3 internal error.",
    version=__version__,
    exit_on_error=False,
    print_error=False,
    suppress_keyboard_interrupt=False,
    result_action="return_value",
)


def run(words: Sequence[str]) -> int:
    """Run one command and return its exit code."""
    if ("--out", "") in itertools.pairwise(words) or "--out=" in words:
        raise InputError("--out", "", "name a directory or a file", "write --out . for the current directory")
    try:
        with _plain_warnings():
            # In a context of its own, which ends with what the command has chosen.
            code = contextvars.copy_context().run(app, _each_with_option(words))
    except UnusedCliTokensError as error:
        unused = ", ".join(repr(word) for word in error.unused_tokens or ())
        print(f"This command takes no {unused}; see 'nonhertz --help'.", file=sys.stderr)
        return BAD_INPUT
    except CycloptsError as error:
        print(f"{' '.join(str(error).split()).rstrip('.')}; see 'nonhertz --help'.", file=sys.stderr)
        return BAD_INPUT
    return code if isinstance(code, int) else FINE


def _show_in(units: str, as_json: bool = False) -> None:
    """Choose the units of what is shown in the rest of the command; JSON is in SI units."""
    from nonhertz.amounts import choose_units

    choose_units("si" if as_json else units)


def _each_with_option(words: Sequence[str]) -> list[str]:
    """Return the words of a command line, with ``--set`` again before each further change that follows one."""
    found: list[str] = []
    after = False  # a change, so that another may follow
    for word in words:
        is_change = _CHANGE.match(word) is not None and not Path(word).exists()
        if after and is_change:
            found.append("--set")
        after = is_change and found[-1:] == ["--set"]
        found.append(word)
    return found


@contextlib.contextmanager
def _plain_warnings() -> Iterator[None]:
    """Show warnings, such as those about a measured profile, as sentences without source lines."""
    with warnings.catch_warnings():
        warnings.showwarning = lambda message, *_, **__: _complain(f"warning: {message}")
        yield


def _complain(sentence: object) -> None:
    """Print a sentence about what was solved on standard error."""
    print(sentence, file=sys.stderr)


@app.command
def solve(
    case: Path,
    /,
    *more: Path,
    changes: Changes = (),
    out: Path | None = None,
    units: UnitsRead = "si",
    as_json: Annotated[bool, Parameter(name="--json", negative="")] = False,
) -> int:
    """Solve case files and print a summary, or a table of several.

    Parameters
    ----------
    case : Path
        The case file; see 'nonhertz new'.
    more : tuple of Path
        More case files. One that fails does not stop the others.
    out : Path
        Directory for result.json, table.csv and the figures; created if it does not exist. Of several cases each has a
        folder in it, beside the table of all, cases.csv. A file .xlsx or .csv for the table alone.
    as_json : bool
        Print one JSON object with all numbers instead of the summary, or a list of them.
    """
    from nonhertz.cli.solve import is_table, report_one, report_several
    from nonhertz.files.changes import changes_in

    _show_in(units, as_json)
    if not more and not (out is not None and is_table(out)):
        return report_one(case, changes_in(changes), out, as_json)
    return report_several((case, *more), changes_in(changes), out, as_json)


@app.command
def bearing(
    file: Path,
    /,
    *,
    changes: Changes = (),
    compare: Annotated[bool, Parameter(negative="")] = False,
    contact: Annotated[tuple[int, str] | None, Parameter(negative="", show_default=False)] = None,
    out: Path | None = None,
    units: UnitsRead = "si",
    as_json: Annotated[bool, Parameter(name="--json", negative="")] = False,
) -> int:
    """Solve a bearing file and print loads, pressures and life of the whole bearing.

    Parameters
    ----------
    file : Path
        The bearing file; see 'nonhertz new --bearing'.
    compare : bool
        Solve it by strips and by the slices of ISO/TS 16281, and print both side by side.
    contact : tuple of int and str
        ROLLER, counted from 0, and RING, inner or outer: print a case file of this contact alone, with its load and its
        tilt in the bearing, for the commands that take a case.
    out : Path
        Directory for result.json, rollers.csv, lines.csv and the figures, with --compare for comparison.json and
        comparison.csv; created if it does not exist.
    as_json : bool
        Print one JSON object with all numbers instead of the tables.
    """
    from nonhertz.cli.bearing import print_contact, report_bearing, report_comparison
    from nonhertz.files.bearingfile import read_bearing
    from nonhertz.files.changes import changes_in
    from nonhertz.files.folder import refuse_unwritable

    _show_in(units, as_json)
    if contact is not None and (compare or as_json or out is not None):
        remedy = "send the case file that it prints to a file with >"
        raise InputError("--contact", contact, "be given without --compare, --json and --out", remedy)
    problem = read_bearing(file, changes_in(changes))
    if contact is not None:
        return print_contact(problem, *contact)
    if out is not None:
        refuse_unwritable(out)
    return (report_comparison if compare else report_bearing)(problem, out, as_json)


@app.command
def compare(
    case: Path,
    /,
    *,
    changes: Changes = (),
    out: Path | None = None,
    cells: Annotated[tuple[int, int] | None, Parameter(negative="", show_default=False)] = None,
    units: UnitsRead = "si",
    as_json: Annotated[bool, Parameter(name="--json", negative="")] = False,
) -> int:
    """Solve a case file with strips of both elements and on a plane grid, and compare them.

    The plane grid assumes nothing about how the pressure is distributed across the contact. Where it and the strips
    differ by more than 1 % is printed. This takes a few seconds.

    Parameters
    ----------
    case : Path
        The case file; its solver.element has no effect, solver.strips applies to both elements.
    out : Path
        Directory for comparison.json, comparison.csv and the figure; created if it does not exist.
    cells : tuple of int
        Cells of the plane grid, ACROSS and ALONG; 128 512 if left out.
    as_json : bool
        Print one JSON object with all numbers instead of the table.
    """
    from nonhertz.cli.compare import compared, comparison_written
    from nonhertz.cli.printing import print_result
    from nonhertz.files.casefile import read_case
    from nonhertz.files.changes import changes_in
    from nonhertz.files.comparisons import as_json as json_text
    from nonhertz.files.folder import refuse_unwritable
    from nonhertz.show.comparison import sections

    _show_in(units, as_json)
    problem = read_case(case, changes_in(changes))
    if out is not None:
        refuse_unwritable(out)
    try:
        found = compared(problem, cells)
    except ConvergenceError as error:
        _complain(error)
        return NOT_CONVERGED
    written = comparison_written(out, found, problem.title) if out is not None else ()
    if as_json:
        print(json_text(found, problem.title))
        return FINE
    print_result(problem.title, sections(found), warnings=found.warnings, written=written)
    return FINE


@app.command
def stress(
    case: Path,
    /,
    *,
    changes: Changes = (),
    station: float | None = None,
    body: str = "a",
    out: Path | None = None,
    units: UnitsRead = "si",
    as_json: Annotated[bool, Parameter(name="--json", negative="")] = False,
) -> int:
    """Solve a case file and find the largest stresses below the surface.

    Size and position of the largest von Mises, maximum shear and orthogonal shear stress, in the whole body and in one
    cross-section of it.

    Parameters
    ----------
    case : Path
        The case file.
    station : float
        Position of the cross-section along the contact [mm]; by default where the von Mises stress is largest.
    body : str
        The body to examine, a or b. Both bear the same pressure.
    out : Path
        Directory for stress.json, tables and figures of two planes; created if it does not exist.
    as_json : bool
        Print one JSON object instead of the table.
    """
    from nonhertz.cli.solve import solved_or_not
    from nonhertz.cli.stress import checked_body, report_stresses
    from nonhertz.files.casefile import read_case
    from nonhertz.files.changes import changes_in
    from nonhertz.files.folder import refuse_unwritable

    _show_in(units, as_json)
    name = checked_body(station, body)
    problem = read_case(case, changes_in(changes))
    if out is not None:
        refuse_unwritable(out)
    solution, complaint = solved_or_not(problem)
    if complaint:
        _complain(complaint)
        return NOT_CONVERGED
    report_stresses(solution, problem.title, station, name, out, as_json)
    return FINE


@app.command
def life(
    case: Path,
    /,
    *,
    changes: Changes = (),
    model: Annotated[tuple[str, ...], Parameter(consume_multiple=True, negative="", show_default=False)] = (),
    compared: Annotated[Path | None, Parameter(name="--compare")] = None,
    out: Path | None = None,
    units: UnitsRead = "si",
    as_json: Annotated[bool, Parameter(name="--json", negative="")] = False,
) -> int:
    """Solve a case file and assess how long both bodies last by several fatigue models.

    Lives are relative to those of the same bodies under an ideal pressure, Hertz's line pressure with the load spread
    evenly. This takes a few seconds per load.

    Parameters
    ----------
    case : Path
        The case file; its table life has the number of rollers, model parameters, and a load spectrum.
    model : tuple of str
        Names of the models: lundberg-palmgren, ioannides-harris, zaretsky, weibull, iso-16281. By default those in the
        file, or all of them.
    compared : Path
        Another case file to compare with, by the same models: how much longer the first one lasts.
    out : Path
        Directory for life.json, tables and the figure; created if it does not exist.
    as_json : bool
        Print one JSON object instead of the table.
    """
    from nonhertz.cli.life import check_models, report_lives
    from nonhertz.files.casefile import read_case
    from nonhertz.files.changes import changes_in
    from nonhertz.files.folder import refuse_unwritable
    from nonhertz.files.held import named

    _show_in(units, as_json)
    check_models(model)
    problems = [read_case(case, changes_in(changes))]
    if compared is not None:
        with named(compared):
            problems.append(read_case(compared, changes_in(changes)))
    if out is not None:
        refuse_unwritable(out)
    return report_lives(problems, model, out, as_json)


@app.command
def report(
    *cases: Path,
    changes: Changes = (),
    out: Path | None = None,
    life: bool | None = None,
    stress: bool = True,
    compare: Annotated[bool, Parameter(negative="")] = False,
    project: str = "",
    author: str = "",
    date: str = "",
    units: UnitsRead = "si",
) -> int:
    """Solve case files or bearing files and write one HTML report that anyone can open in a browser.

    It contains inputs, assumptions and whether they hold, results, figures, references and the files themselves, and
    loads nothing from elsewhere. Several cases, or several bearings, are compared with the first.

    Parameters
    ----------
    cases : tuple of Path
        The case files, or the bearing files, at least one.
    out : Path
        The file to write; an older report is overwritten, any other file is not. By default the first case file's name
        with '-report.html', in the current directory.
    life : bool
        Whether to assess lives, which takes a few seconds per load; by default only for cases with a table life.
        Bearings are rated in any case but --no-life.
    stress : bool
        Search for the largest stresses below the surface, of case files.
    compare : bool
        Set strips beside the slices of ISO/TS 16281, of bearing files.
    project : str
        Project in the head of the report; like the options below, it takes precedence over the first file's table
        report.
    author : str
        Author in the head of the report.
    date : str
        Date in the head of the report.
    """
    from nonhertz.cli.report import composed, read_cases, target, title_block, write
    from nonhertz.files.changes import changes_in
    from nonhertz.files.folder import refuse_unwritable

    _show_in(units)
    if not cases:
        raise InputError("CASE", "", "be given", "name one case file or bearing file, or more")
    block = title_block(project=project, author=author, date=date)
    path = target(out, cases)
    read = read_cases(cases, changes_in(changes))
    refuse_unwritable(path.parent)
    text, complaints = composed(read, life, stress, compare, block)
    write(path, text)
    print(f"wrote {path}")
    if complaints:
        sys.stdout.flush()
        for complaint in complaints:
            _complain(complaint)
    return NOT_CONVERGED if complaints else FINE


@app.command
def profile(
    file: Path,
    /,
    *,
    position_unit: str | None = None,
    height_unit: str | None = None,
    position_column: str | None = None,
    height_column: str | None = None,
    sense: str | None = None,
    level: Annotated[bool | None, Parameter(show_default=False)] = None,
    align: str | None = None,
    trim: str | None = None,
    corner: str | None = None,
    outliers: str | None = None,
    smooth: str | None = None,
    cutoff: str | None = None,
    slope: str | None = None,
    points: str | None = None,
    fit: str | None = None,
    out: Path | None = None,
    units: UnitsRead = "si",
    as_json: Annotated[bool, Parameter(name="--json", negative="")] = False,
) -> int:
    """Prepare a measured profile step by step, and say what each step did.

    Parameters
    ----------
    file : Path
        The measuring machine's file: text in columns, a MarWin text export, .smd, .prf or .x3p.
    position_unit : str
        Unit of the positions in a text file; by default what the file states, or mm.
    height_unit : str
        Unit of the heights in a text file, such as um; by default what the file states, or mm.
    position_column : str
        Column of the positions, by number from 1 or by name.
    height_column : str
        Column of the heights.
    sense : str
        height (positive where there is material) or drop (positive where material is removed).
    level : bool
        Remove the tilt at which the body lay in the machine; --no-level keeps it.
    align : str
        How to find the middle of the body: ends, symmetry or no.
    trim : str
        What is kept: auto for the land and its corners, a length, or no for all.
    corner : str
        keep the corners that the trace holds, or cut them off.
    outliers : str
        Robust standard deviations beyond which points are removed, 5 by default, or no.
    smooth : str
        Filter: gaussian, spline or no.
    cutoff : str
        Wavelength at which the filter transmits 50 %; by default 0.8 mm, or a fifth of a shorter land.
    slope : str
        Slope at which a chamfer begins, 0.05 by default.
    points : str
        How many points to keep: auto, a number, or no for all.
    fit : str
        A kind of profile to fit, such as crown, or best to compare all.
    out : Path
        Directory for profile.csv, profile.json, profile.toml and the figure; created if it does not exist.
    as_json : bool
        Print one JSON object instead of the tables.
    """
    from nonhertz.cli import profile as of_profile
    from nonhertz.files.folder import refuse_unwritable
    from nonhertz.files.prepared import as_json as json_text

    _show_in(units, as_json)
    if out is not None:
        refuse_unwritable(out)
    values = of_profile.options(
        position_unit=position_unit, height_unit=height_unit, position_column=position_column,
        height_column=height_column, sense=sense, level=level, align=align, trim=trim, corner=corner,
        outliers=outliers, smooth=smooth, cutoff=cutoff, slope=slope, points=points,
    )  # fmt: skip
    measured = of_profile.prepared(file, values)
    fits = of_profile.fitted(measured, fit)
    written = of_profile.written(out, file, values, measured, fits) if out is not None else ()
    if as_json:
        print(json_text(measured, fits))
        return FINE
    of_profile.print_profile(measured, fits)
    for path in written:
        print(f"wrote {path}")
    return FINE


@app.command(name="map")
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
    as_json: Annotated[bool, Parameter(name="--json", negative="")] = False,
) -> int:
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
    as_json : bool
        Print one JSON object with the range and the sampled errors instead of the summary.
    """
    from nonhertz.cli.map import as_json as json_text
    from nonhertz.cli.map import made, print_map, requested, write
    from nonhertz.files.casefile import read_case
    from nonhertz.files.changes import changes_in
    from nonhertz.files.folder import refuse_unwritable

    _show_in(units, as_json)
    problem = read_case(case, changes_in(changes))
    asked = requested(approach, load, tilt, accuracy, out)
    if out is not None:
        refuse_unwritable(out.parent)
    found = made(problem, asked)
    written = write(out, found, asked) if out is not None else ()
    if as_json:
        print(json_text(found, problem.title))
        return FINE
    print_map(found, problem.title)
    for path in written:
        print(f"wrote {path}")
    return FINE


@app.command
def nodes(
    case: Path,
    nodes: Path,
    /,
    *,
    changes: Changes = (),
    out: Path | None = None,
    units: UnitsRead = "si",
    as_json: Annotated[bool, Parameter(name="--json", negative="")] = False,
) -> int:
    """Solve a case file and find pressures and forces at the nodes of a finite element mesh.

    Pressures are those of the contact at each node. Forces add up to the load, whatever the mesh.

    Parameters
    ----------
    case : Path
        The case file.
    nodes : Path
        Text in columns, with a head that names x and y, with units: 'node; x [mm]; y [mm]'. Other columns are kept.
    out : Path
        The CSV file to write; by default the name of the file of nodes with '-pressure.csv', in the current directory.
    as_json : bool
        Print one JSON object with the sums and all nodes instead of the sentences.
    """
    from nonhertz.cli.nodes import report_nodes, target
    from nonhertz.cli.solve import solved_or_not
    from nonhertz.files.casefile import read_case
    from nonhertz.files.changes import changes_in
    from nonhertz.files.folder import refuse_unwritable
    from nonhertz.files.nodes import read_nodes

    _show_in(units, as_json)
    path = target(out, nodes)
    problem = read_case(case, changes_in(changes))
    found = read_nodes(nodes)
    refuse_unwritable(path.parent)
    solution, complaint = solved_or_not(problem)
    if complaint:
        _complain(complaint)
        return NOT_CONVERGED
    report_nodes(solution, problem.title, found, path, as_json)
    return FINE


@app.command
def design(
    plan: Path,
    /,
    *,
    changes: Changes = (),
    starts: int | None = None,
    front: int | None = None,
    out: Path | None = None,
    workers: int | None = None,
    units: UnitsRead = "si",
    as_json: Annotated[bool, Parameter(name="--json", negative="")] = False,
) -> int:
    """Find the profile or the dimensions with the least largest pressure, or the longest life.

    Parameters
    ----------
    plan : Path
        The plan file, with tables vary and design.
    starts : int
        Number of searches, each from another place; by default that of the plan, or 5.
    front : int
        In place of a goal, so many points of the Pareto front of the largest pressures under the loads without tilt and
        under those with tilt.
    out : Path
        Directory for case.toml (the case as it is best), profile.csv, design.json and the figures, or of a front for
        front.csv, front.json, a case file for each point and the figure; by default the file's name with '-design', in
        the current directory.
    workers : int
        Number of processes; by default one for each core.
    as_json : bool
        Print one JSON object instead of the tables.
    """
    from nonhertz.cli.design import as_json as json_text
    from nonhertz.cli.design import designed, directory_for, print_design, written
    from nonhertz.files.changes import changes_in
    from nonhertz.files.folder import refuse_unwritable

    _show_in(units, as_json)
    directory = directory_for(plan) if out is None else out
    refuse_unwritable(directory)
    if front is not None:
        from nonhertz.cli.front import as_json as front_json
        from nonhertz.cli.front import print_front, searched, written_front

        points = searched(plan, changes_in(changes), front, starts, workers)
        files = written_front(points, directory)
        if as_json:
            print(front_json(points, files))
        else:
            print_front(points, files)
        return FINE
    found = designed(plan, changes_in(changes), starts, workers)
    files = written(found, directory)
    if as_json:
        print(json_text(found, files))
    else:
        print_design(found, files)
    return FINE


@app.command(name="sweep")
def sweep_plan(
    plan: Path,
    /,
    *,
    changes: Changes = (),
    over: Annotated[tuple[str, ...], Parameter(consume_multiple=True, negative="", show_default=False)] = (),
    quantities: Annotated[tuple[str, ...], Parameter(consume_multiple=True, negative="", show_default=False)] = (),
    out: Path | None = None,
    workers: int | None = None,
    scheduler: str | None = None,
    excel: Excel = False,
    units: UnitsRead = "si",
    as_json: Annotated[bool, Parameter(name="--json", negative="")] = False,
) -> int:
    """Solve a case or a bearing for many values of what its file holds.

    Rows are kept as they are solved. A sweep that was stopped, however it was, goes on when the same command is given
    again. A row that fails holds the sentence that says why, and does not stop the others.

    Parameters
    ----------
    plan : Path
        The plan file; or a case file or a bearing file, with --over.
    over : tuple of str
        A path of the file and what it runs over, such as load.load=5kN:40kN:8 for eight values, load.tilt=0,0.5mrad for
        two, or 'body.b.diameter=normal(80mm,5um)' for samples; may be given several times.
    quantities : tuple of str
        Names of the numbers of a row, such as max_pressure life; by default the usual ones.
    out : Path
        Directory for the rows, rows.csv, rows.parquet (where polars is installed) and the figures; by default the
        file's name with '-sweep', in the current directory.
    workers : int
        Number of processes; by default one for each core.
    scheduler : str
        Address of a Dask scheduler whose workers solve the rows, such as tcp://10.0.0.1:8786.
    as_json : bool
        Print one JSON object instead of the tables.
    """
    from nonhertz.cli.sweep import as_json as json_text
    from nonhertz.cli.sweep import directory_for, planned, print_sweep, swept, written
    from nonhertz.files.changes import changes_in
    from nonhertz.files.workbooks import refuse_missing_writer

    _show_in(units, as_json)
    if excel:
        refuse_missing_writer()
    asked = planned(plan, over, quantities, "over", changes_in(changes))
    directory = directory_for(plan, "sweep") if out is None else out
    found = swept(asked, directory, workers, scheduler)
    files = written(found, directory, excel)
    if as_json:
        print(json_text(found, files))
    else:
        print_sweep(found, files)
    return FINE


@app.command(name="tolerance")
def study_tolerance(
    plan: Path,
    /,
    *,
    changes: Changes = (),
    over: Annotated[tuple[str, ...], Parameter(consume_multiple=True, negative="", show_default=False)] = (),
    quantities: Annotated[tuple[str, ...], Parameter(consume_multiple=True, negative="", show_default=False)] = (),
    samples: int | None = None,
    seed: int | None = None,
    out: Path | None = None,
    workers: int | None = None,
    scheduler: str | None = None,
    excel: Excel = False,
    units: UnitsRead = "si",
    as_json: Annotated[bool, Parameter(name="--json", negative="")] = False,
) -> int:
    """Find how results are distributed when dimensions and loads are, and which tolerance matters.

    Rows are kept as those of 'nonhertz sweep' are, and the same command goes on where it was stopped.

    Parameters
    ----------
    plan : Path
        The plan file, with a table tolerance; or a case file or a bearing file, with --over.
    over : tuple of str
        A path of the file and its distribution, such as 'body.b.diameter=normal(nominal,5um)'; may be given several
        times.
    quantities : tuple of str
        Names of the numbers that matter, such as max_pressure life; by default the usual ones.
    samples : int
        How many rows at most, 10000 if neither this nor the plan says it.
    seed : int
        The same seed draws the same samples; 0 if neither this nor the plan says it.
    out : Path
        Directory for the rows, rows.csv, rows.parquet (where polars is installed), tolerance.json and the figures; by
        default the file's name with '-tolerance', in the current directory.
    workers : int
        Number of processes; by default one for each core.
    scheduler : str
        Address of a Dask scheduler whose workers solve the rows.
    as_json : bool
        Print one JSON object instead of the tables.
    """
    from nonhertz.cli.sweep import directory_for, planned
    from nonhertz.cli.tolerance import as_json as json_text
    from nonhertz.cli.tolerance import print_tolerance, studied, written
    from nonhertz.files.changes import changes_in
    from nonhertz.files.workbooks import refuse_missing_writer

    _show_in(units, as_json)
    if excel:
        refuse_missing_writer()
    asked = planned(plan, over, quantities, "tolerance", changes_in(changes))
    directory = directory_for(plan, "tolerance") if out is None else out
    found = studied(asked, samples, seed, directory, workers, scheduler)
    files = written(found, directory, excel)
    if as_json:
        print(json_text(found, files))
    else:
        print_tolerance(found, files)
    return FINE


@app.command
def check(file: Path, /, *, changes: Changes = ()) -> int:
    """List all mistakes in a case file, a bearing file or a plan.

    Parameters
    ----------
    file : Path
        The file.
    """
    from nonhertz.cli.check import checked
    from nonhertz.files.changes import changes_in

    try:
        fine = checked(file, changes_in(changes))
    except CaseError as error:
        for number, mistake in enumerate(error.mistakes, start=1):
            print(f"{number}. {mistake}")
        return BAD_INPUT
    print(fine)
    return FINE


@app.command
def materials(
    name: str | None = None,
    /,
    *,
    units: UnitsRead = "si",
    as_json: Annotated[bool, Parameter(name="--json", negative="")] = False,
) -> int:
    """List the materials that a case file may name, with what they bear.

    Parameters
    ----------
    name : str
        One of them, with the source of its numbers and what limits their use; by default all.
    as_json : bool
        Print one JSON object with all numbers, sources and notes instead of the table.
    """
    from nonhertz.cli.materials import report_materials

    _show_in(units, as_json)
    report_materials(name, as_json)
    return FINE


@app.command
def new(
    path: Path | None = None,
    /,
    *,
    template: str | None = None,
    bearing: Annotated[bool, Parameter(negative="")] = False,
    plan: Annotated[bool, Parameter(negative="")] = False,
    case: Path | None = None,
) -> int:
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
    """
    from nonhertz.cli.options import named_as
    from nonhertz.files.bearingfile import starting_bearing
    from nonhertz.files.casefile import starting_case
    from nonhertz.files.held import write_new
    from nonhertz.files.planfile import read_any, starting_plan
    from nonhertz.inputs.files import seen_from

    if plan and template is not None:
        raise InputError("--template", template, "not be given with --plan", "leave one out")
    if bearing and plan:
        raise InputError("--plan", True, "not be given with --bearing", "write one file after the other")
    if case is not None and not plan:
        raise InputError("--case", str(case), "be given with --plan", "add that, or leave it out")
    folder = Path() if path is None else path.parent
    file = folder / "case.toml" if case is None else case
    with named_as(template="--template"):
        if case is not None:
            read_any(case)
            text = starting_plan(seen_from(folder, case).as_posix())
        else:
            text = starting_bearing(template) if bearing else starting_plan() if plan else starting_case(template)
    if path is None:
        print(text, end="")
    else:
        write_new(text, path)
        way_on = f"solve it with: nonhertz {'bearing' if bearing else 'solve'} {path}"
        if plan:
            made_for = f"for {file}" + (" as 'nonhertz new' writes it" if case is None else "")
            command = "design" if case is None else "check"
            way_on = f"{made_for}; try it with: nonhertz {command} {path}"
        print(f"wrote {path}{',' if plan else ';'} {way_on}")
    return FINE


@app.command
def schema(kind: str, /, *, out: Path | None = None) -> int:
    """Print the JSON schema of case, bearing, plan or result files, by which editors and other programs check them.

    Parameters
    ----------
    kind : str
        case, bearing, plan or result.
    out : Path
        The file to write it to instead; an existing one is replaced.
    """
    from nonhertz.files.folder import write_files
    from nonhertz.files.schemas import KINDS, schema_text

    if kind not in KINDS:
        raise InputError("KIND", kind, "be a kind of file that has a schema", f"choose from {', '.join(KINDS)}")
    if out is None:
        print(schema_text(kind), end="")
        return FINE
    for path in write_files(out.parent, {out.name: schema_text(kind)}):
        print(f"wrote {path}")
    return FINE


@app.command
def serve(
    case: Path | None = None,
    /,
    *,
    port: int = 8765,
    browser: bool = True,
) -> NoReturn:
    """Open a page in the browser on which to change a case or a bearing and see it solved as you type.

    The page is served to this machine only, and no data leave it. Ctrl-C stops it.

    Parameters
    ----------
    case : Path
        The case file or bearing file to start with; by default the case that 'nonhertz new' writes. The page reads no
        files: a profile from a file starts with its points.
    port : int
        Port on which the page is served; 0 for any free port.
    browser : bool
        Whether to open the page in a browser.
    """
    from nonhertz.cli.serve import starting_document
    from nonhertz.web.server.serving import serve as serve_page

    start = starting_document(case)
    for note in start.notes:
        print(note)

    def announce(address: str) -> None:
        print(f"The page is at {address} until you press Ctrl-C here.", flush=True)

    serve_page(start.document, port, browser=browser, announce=announce, text=start.text)


@app.command
def warm() -> int:
    """Compile everything now, so that no later command has to: for containers and CI.

    What is compiled is kept on disk for this version, processor and compiler; run it again after an upgrade. The exit
    code is 1 if nothing can be written where it is kept.
    """
    from nonhertz.cli.verify import Progress
    from nonhertz.cli.warm import PARTS, warm_up
    from nonhertz.compiled.files import folders, read, write

    progress = Progress(len(PARTS))
    try:
        seconds = warm_up(progress.announce)
    finally:
        progress.wipe()
    for name, taken in seconds.items():
        print(f"{name}: {taken:.1f} s")
    for folder in filter(Path.is_dir, folders()):
        print(f"machine code: {sum(each.stat().st_size for each in folder.iterdir()) / 1e6:.1f} MB in {folder}")
    # Where nothing can be written a warning says so, and what to do.
    now = os.urandom(8)
    write("warm", b"", now)
    return FINE if read("warm", b"") == now else NOT_KEPT


@app.command
def verify(
    *,
    out: Path | None = None,
    only: Annotated[tuple[str, ...], Parameter(consume_multiple=True, negative="", show_default=False)] = (),
    as_json: Annotated[bool, Parameter(name="--json", negative="")] = False,
) -> int:
    """Compare with publications, exact solutions and other methods.

    Every number is recomputed and set beside its reference value; the exit code is 1 if one is off by more than its
    tolerance. This takes less than two minutes.

    Parameters
    ----------
    out : Path
        Directory for validation.md and verify.json, tables of all claims; created if it does not exist.
    only : tuple of str
        Names of the sections to run, such as 'half-space plane-strain'; by default all of them.
    as_json : bool
        Print a JSON list of all checks instead of the tables.
    """
    from nonhertz.cli.verify import Progress, print_section
    from nonhertz.files.folder import refuse_unwritable
    from nonhertz.verify import chosen, sections
    from nonhertz.verify.page import as_json as json_text
    from nonhertz.verify.page import summary, tally, write_page

    names = chosen(only)
    if out is not None:
        refuse_unwritable(out)
    found = []
    progress = Progress(len(names))
    try:
        for section in sections(names, progress.announce):
            progress.wipe()
            found.append(section)
            if not as_json:
                print_section(section)
    finally:
        progress.wipe()
    command = " ".join(["nonhertz verify --out DIR", *(["--only", *names] if only else [])])
    written = write_page(out, found, command) if out is not None else ()
    if as_json:
        print(json_text(found))
    else:
        for path in written:
            print(f"wrote {path}")
        print(summary(found))
    return NOT_VERIFIED if tally(found)["FAIL"] else FINE
