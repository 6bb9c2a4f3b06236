"""What ``nonhertz bearing`` solves, writes and prints."""

from __future__ import annotations

import sys
from pathlib import Path

from nonhertz.bearing.solution import BearingSolution
from nonhertz.cli import FINE, NOT_CONVERGED
from nonhertz.cli.options import named_as
from nonhertz.cli.printing import print_result
from nonhertz.errors import ConvergenceError, InputError, without_accuracy_warnings
from nonhertz.files.bearing_results import as_json, as_object, comparison_files, comparison_object, files
from nonhertz.files.bearingfile import BearingCase, placed
from nonhertz.files.folder import write_files
from nonhertz.show.bearing import compared_sections, sections
from nonhertz.verdict import of_bearing

WIDTH = 120  # of piped output


def report_bearing(case: BearingCase, out: Path | None, json: bool) -> int:
    """Solve a bearing, write results if requested, print them; return the exit code."""
    try:
        solution = _solved(case)
        life, reason = case.rated(solution)
        strained = solution.findings
    except ConvergenceError as error:
        print(error, file=sys.stderr)
        return NOT_CONVERGED
    except InputError as error:  # of a contact, when its pressure is solved
        raise placed(error) from None
    found = life, reason, strained
    written = (
        () if out is None else write_files(out, files(solution, case, *found), lambda to: _draw(solution, case, to))
    )
    if json:
        print(as_json(as_object(solution, case, *found)))
        return FINE
    shown = sections(case, solution, life, reason)
    verdict = of_bearing(solution, life)
    print_result(case.title, shown, verdict=verdict, warnings=strained, written=written, piped=WIDTH)
    return FINE


def report_comparison(case: BearingCase, out: Path | None, json: bool) -> int:
    """Solve a bearing by strips and by slices, write and print both; return the exit code."""
    try:
        strips, slices = case.solve("strips"), case.solve("slices")
    except ConvergenceError as error:
        print(error, file=sys.stderr)
        return NOT_CONVERGED
    written = () if out is None else write_files(out, comparison_files(strips, slices, case.title))
    if json:
        print(as_json(comparison_object(strips, slices, case.title)))
        return FINE
    print_result(case.title, compared_sections(strips, slices), written=written, piped=WIDTH)
    return FINE


def print_contact(case: BearingCase, roller: int, ring: str) -> int:
    """Solve a bearing and print the case file of one of its contacts; return the exit code."""
    try:
        solution = _solved(case)
    except ConvergenceError as error:
        print(error, file=sys.stderr)
        return NOT_CONVERGED
    with named_as(roller="--contact", ring="--contact"):
        print(case.contact_case(solution, roller, ring).text, end="")
    return FINE


def _solved(case: BearingCase) -> BearingSolution:
    """Return the solution, whose warnings are printed with the results."""
    with without_accuracy_warnings():
        return case.solve()


def _draw(solution: BearingSolution, case: BearingCase, folder: Path) -> None:
    """Write the figures of a bearing."""
    from nonhertz import plot

    for name, figure in plot.bearing_figures(solution, case.title).items():
        plot.save(figure, folder / name)
