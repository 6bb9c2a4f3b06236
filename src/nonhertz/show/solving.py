"""From a case to its solution.

Shared by the command line, reports and the page. Errors name the key of the case file. Python warnings are suppressed,
since the solution contains them as sentences.
"""

from __future__ import annotations

from nonhertz.errors import ConvergenceError, without_accuracy_warnings
from nonhertz.files.casefile import Case
from nonhertz.result.solution import Solution


def solve_case(case: Case) -> Solution:
    """Return the solution of a case.

    Raises
    ------
    CaseError
        If the solver rejects the case.
    ConvergenceError
        If it stops short of a solution.
    """
    with without_accuracy_warnings():
        return case.solve()


def try_solve(case: Case) -> tuple[Solution, str]:
    """Return the solution of a case and "", or the state in which the solver stopped and the reason.

    Raises
    ------
    CaseError
        If the solver rejects the case.
    """
    try:
        return solve_case(case), ""
    except ConvergenceError as error:
        return error.solution, str(error)
