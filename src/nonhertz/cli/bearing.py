"""``nonhertz bearing``: a whole bearing."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from nonhertz.cli.options import AsJson, Changes, UnitsRead, named_as, refuse_unwritable_out, saved, written
from nonhertz.cli.printing import print_result
from nonhertz.errors import InputError, without_accuracy_warnings
from nonhertz.files.bearing_results import comparison_files, comparison_object
from nonhertz.files.bearingfile import BearingCase, placed, read_bearing
from nonhertz.files.changes import changes_in
from nonhertz.files.resultfile import Result
from nonhertz.files.results import key_by_key
from nonhertz.show.bearing import compared_sections, sections
from nonhertz.verdict import findings_of, of_bearing


def bearing(
    file: Path,
    /,
    *,
    changes: Changes = (),
    compare: Annotated[bool, Parameter(negative="")] = False,
    contact: Annotated[tuple[int, str] | None, Parameter(negative="", show_default=False)] = None,
    out: Path | None = None,
    units: UnitsRead = "si",
    as_json: AsJson = False,
) -> None:
    """Solve a whole bearing: loads, pressures and life.

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
    """
    if contact is not None and (compare or as_json or out is not None):
        remedy = "send the case file that it prints to a file with >"
        raise InputError("--contact", contact, "be given without --compare, --json and --out", remedy)
    case = read_bearing(file, changes_in(changes))
    refuse_unwritable_out(out)
    if compare:
        _compare(case, out, as_json)
        return
    with without_accuracy_warnings():  # which are printed with the results
        solution = case.solve()
    if contact is not None:
        with named_as(roller="--contact", ring="--contact"):
            print(case.contact_case(solution, *contact).text, end="")
        return
    try:
        life, reason = case.rated(solution)
    except InputError as error:  # of a contact, when its pressure is solved
        raise placed(error) from None
    found = Result(case, solution, (life, reason))
    made = saved(found, out)
    if as_json:
        print(found.to_json())
        return
    print_result(
        case.title,
        sections(case, solution, life, reason),
        verdict=of_bearing(solution, life, case.operating_clearance),
        warnings=findings_of(solution, life),
        written=made,
    )


def _compare(case: BearingCase, out: Path | None, as_json: bool) -> None:
    """Solve a bearing by strips and by slices, write and print both."""
    strips, slices = case.solve("strips"), case.solve("slices")
    made = written(out, lambda: comparison_files(strips, slices, case.title))
    if as_json:
        print(key_by_key(comparison_object(strips, slices, case.title)))
    else:
        print_result(case.title, compared_sections(case, strips, slices), written=made)
