"""``nonhertz bearing``: a whole bearing."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from nonhertz.cli.answer import Answer
from nonhertz.cli.options import (
    NONE,
    AsJson,
    Changes,
    Workers,
    refuse_together,
    refuse_unwritable_out,
    rename_fields,
    save_result,
    write_outputs,
)
from nonhertz.errors import InputError, without_accuracy_warnings
from nonhertz.files.bearing_results import comparison_files, comparison_object
from nonhertz.files.bearingfile import BearingCase, read_bearing
from nonhertz.files.resultfile import Result
from nonhertz.files.results import key_by_key
from nonhertz.inputs.checks import whole
from nonhertz.show.bearing import compared_sections, sections
from nonhertz.verdict import collect_findings


def bearing(
    file: Path,
    /,
    *,
    changes: Changes = NONE,
    compare: Annotated[bool, Parameter(negative="")] = False,
    contact: Annotated[tuple[int, str] | None, Parameter(negative="", show_default=False)] = None,
    over: Annotated[str, Parameter(show_default=False)] = "",
    workers: Workers = None,
    out: Path | None = None,
    rexs: Path | None = None,
    as_json: AsJson = False,
) -> Answer | None:
    """Solve a whole bearing: loads, pressures and life.

    Parameters
    ----------
    file : Path
        The bearing file; see 'nonhertz new --bearing'.
    compare : bool
        Solve by strips and by the slices of ISO/TS 16281, and print both side by side.
    contact : tuple of int and str
        ROLLER, counted from 1, and RING, inner or outer: print a case file of this contact alone, with its load and
        misalignment in the bearing, for the commands that take a case.
    over : str
        An input and its range, such as clearance=0:60um, load=5kN:20kN:16 or tilt=0:1mrad: print life, pressure and
        stiffness over it as a table, and with --out draw them in one figure.
    out : Path
        Directory for result.json, rollers.csv, lines.csv and the figures, with --compare for comparison.json and
        comparison.csv, with --over for diagram.json, rows.csv and the figure; created if it does not exist.
    rexs : Path
        REXS 1.4 file to write, with the bearing and its results: XML if the name ends in .rexs or .rexs.xml, JSON if it
        ends in .rexsj or .rexs.json.
    """
    answers = {"--compare": compare, "--contact": contact, "--over": over}
    refuse_together(answers, "give one of them")
    if rexs is not None:
        from nonhertz.files.rexs.writing import form_of, write_rexs  # loaded for it alone

        with rename_fields(path="--rexs"):
            form_of(rexs)
        refuse_together(answers | {"--rexs": str(rexs)}, "leave one out")
    if contact is not None and (as_json or out is not None):
        remedy = "redirect the case file that is printed, with >"
        raise InputError("--contact", contact, "be given without --json and --out", remedy)
    case = read_bearing(file, changes)
    refuse_unwritable_out(out)
    with rename_fields(folder="--rexs", out="--rexs"):
        refuse_unwritable_out(rexs, file=True)
    if compare:
        return _compare(case, out)
    if over:
        from nonhertz.cli.diagram import solve_diagram  # studies are loaded for it alone

        return solve_diagram(case, over, workers, out)
    with without_accuracy_warnings():  # which are printed with the results
        solution = case.solve()
    if contact is not None:
        number, ring = contact
        whole("--contact", number, 1, solution.angle.size, "count from 1")
        try:
            alone = case.contact_case(solution, number - 1, ring)
        except InputError as error:
            raise error.about("--contact", {"roller": number}.get(error.field, ring)) from None
        print(alone.text, end="")
        return None
    life, reason = case.rated(solution)
    result = Result(case, solution, (life, reason))
    judged = solution, life, case.operating_clearance
    shown = sections(case, solution, life, reason)
    made = save_result(result, out)
    if rexs is not None:
        made += (write_rexs(rexs, case, solution, life),)
    return Answer(
        case.title,
        shown,
        result.to_json,
        case.verdict(solution, life),
        collect_findings(*judged),
        made,
    )


def _compare(case: BearingCase, out: Path | None) -> Answer:
    """Return a bearing solved by strips and by slices."""
    both = case.solve("strips"), case.solve("slices")
    made = write_outputs(out, lambda: comparison_files(*both, case.title))
    shown, text = compared_sections(case, *both), lambda: key_by_key(comparison_object(*both, case.title))
    return Answer(case.title, shown, text, written=made)
