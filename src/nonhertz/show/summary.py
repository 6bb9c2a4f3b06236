"""The result of a solve, in rows of name, value and remark."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from nonhertz.amounts import error_words, format_digits, mm, mpa, worth_reading
from nonhertz.patch.solution import PatchSolution
from nonhertz.result.brief import where_largest
from nonhertz.result.edges import EdgeKind, EdgePressure
from nonhertz.result.ends import leaves_stress
from nonhertz.result.penetration import is_noticeable
from nonhertz.result.quantities import QUANTITIES
from nonhertz.result.solution import Solution
from nonhertz.result.solved import Solved
from nonhertz.show.beside import numbers_table
from nonhertz.show.sections import Notes, Row, Section, Table, assumed_rows, summary

if TYPE_CHECKING:
    from nonhertz.files.casefile import Case
    from nonhertz.files.several import Attempt
    from nonhertz.solver.solutions import Solutions

MOST_FAILURES = 3  # of many solutions, which are listed one by one
_TITLE = 30  # columns, at least, for a title
#: The first quantities of a summary, in order; the others follow.
_FIRST = ("max_pressure", "contact_length", "max_half_width", "load", "tilt", "approach", "penetration", "moment")
_OVERVIEW = ("load", "max_pressure", "approach", "max_half_width", "contact_length")


def sections(solution: Solved, case: Case | None = None) -> list[Section]:
    """Return the sections on a solution, on strips or on a plane grid."""
    return [Section("Results", [summary(summary_rows(solution, case))])]


def many_sections(solutions: Solutions) -> list[Section]:
    """Return the sections on many solutions: all of few, the extremes of many, and failures."""
    failures = [f"Case {number}: {error}" for number, error in solutions.failures.items()]
    table = numbers_table("case", [(quantity, solutions.column(name).ravel()) for name, quantity in QUANTITIES.items()])
    more = [f"{len(failures) - MOST_FAILURES} more cases have failed."] if len(failures) > MOST_FAILURES else []
    counted = f"{len(solutions) - len(failures)} of {len(solutions)} cases converged"
    return [Section("", [Notes([counted]), table, Notes([*failures[:MOST_FAILURES], *more], "warning")])]


def summary_rows(solution: Solved, case: Case | None = None) -> list[Row]:
    """Return name, value and remark of a summary: key figures first, the method last; given quantities are marked."""
    shows_penetration = is_noticeable(solution.approach, solution.penetration)
    remarks = _remarks(solution, case, shows_penetration)
    rows, on_strips = [("status", solution.status.label, "")], isinstance(solution, Solution)
    for name in (*_FIRST, *(name for name in QUANTITIES if name not in _FIRST)):
        quantity = QUANTITIES[name]
        if name in _ROWS:
            rows += _ROWS[name](solution)
        elif (shows_penetration or name != "penetration") and (on_strips or quantity.within != "stiffness"):
            remark, spec = remarks.get(name, ("", ""))
            rows.append((quantity.label, quantity.text(solution, spec), remark))
    for name, body in solution.contact.bodies.items():
        rows.append((f"body {name}", type(body).__name__.lower(), body.model))
    if isinstance(solution, Solution):
        rows.append(("strips", f"{solution.strips}, {solution.element.name}", ""))
        rows.append(("Newton steps", str(solution.iterations), ""))
        rows += assumed_rows((case or solution).assumed)
    elif isinstance(solution, PatchSolution):
        rows.append(("plane grid", f"{solution.cells[0]} x {solution.cells[1]} cells", ""))
        rows.append(("convolutions", str(solution.iterations), "on this grid"))
    return rows


def _remarks(solution: Solved, case: Case | None, shows_penetration: bool) -> dict[str, tuple[str, str]]:
    """Return remark and format of quantities, by name."""
    estimate = solution.error_estimate
    # The error is that of the penetration; if that is not shown, it nearly equals the approach.
    errors = {"penetration" if shows_penetration else "approach": estimate.approach, "load": estimate.load}
    remarks = {name: (error_words(error), worth_reading(error)) for name, error in errors.items()}
    remarks |= dict.fromkeys(case.prescribed.keywords if case else (), ("given", "g"))
    return remarks | ({"max_half_width": ("away from singular ends", "")} if solution.singular_ends else {})


def overview_table(attempts: Sequence[Attempt]) -> Table:
    """Return file, title, main quantities and remarks of each case."""
    solved = [attempt.solution for attempt in attempts]
    heads, columns = [], []
    for name in _OVERVIEW:
        quantity = QUANTITIES[name]
        values = [None if solution is None else float(quantity.clean(solution)) for solution in solved]
        factor, unit = quantity.amount().scale
        heads.append(f"{quantity.label} [{unit}]")
        columns.append(["" if value is None else format_digits(factor * value) for value in values])
    rows = [
        (attempt.name, attempt.title, *cells, _remark(attempt))
        for attempt, *cells in zip(attempts, *columns, strict=True)
    ]
    return Table(rows, ("case", "title", *heads, ""), (0, 1, len(heads) + 2), room=_TITLE)


def _remark(attempt: Attempt) -> str:
    number = 0 if attempt.solution is None else len(attempt.solution.warnings)
    warnings = f"{number} warning{'s' if number > 1 else ''}" if number else ""
    status = attempt.status.replace("-", " ") if attempt.complaints else ""
    verdict = "" if attempt.verdict is None else attempt.verdict.level.value
    return ", ".join(filter(None, (status, verdict, warnings)))


def _contact_rows(solution: Solved) -> list[Row]:
    """Return where the bodies touch, and the pressure at the ends."""
    if not solution.contact_y:
        return [("contact along y", "none", "")]
    edges = solution.edge_pressure if isinstance(solution, Solution) else ()
    ends = [(f"edge at y = {mm(edge.y):.5g}", *end_words(edge, solution)) for edge in edges]
    places = "; ".join(str(mm(*ends, between=" to ")) for ends in solution.contact_y)
    return [("contact along y", places, " ".join(map(str, solution.remarks))), *ends]


def _pressure_rows(solution: Solved) -> list[Row]:
    """Return the maximum pressure and where it is."""
    if not solution.contact_y:
        return []
    error = solution.error_estimate.max_pressure
    remark, spec = error_words(error), worth_reading(error)
    if solution.peaks_at_corner:
        remark = "unbounded, at a corner of the profile"
    elif isinstance(solution, Solution) and any(
        edge.kind is EdgeKind.CUT_OFF and abs(edge.y - solution.max_pressure_y) <= edge.strip_width
        for edge in solution.edge_pressure
    ):
        remark = "cut off by the strips"
    where, _, away = where_largest(solution).partition(", ")
    quantity = QUANTITIES["max_pressure"]
    return [(quantity.label, quantity.text(solution, spec), remark), ("", where, away)]


def end_words(edge: EdgePressure, solution: Solved) -> tuple[str, str]:
    """Return the pressure at an end of a contact, and a remark."""
    match edge.kind:
        case EdgeKind.RUN_OUT:
            return "runs out", ""
        case EdgeKind.FINITE:
            remark = "finite; the true end is lower" if leaves_stress(solution.contact, edge) else "finite"
            return f"{mpa(edge.pressure)}", remark
        case EdgeKind.SINGULAR:
            return "singular", edge.law
        case EdgeKind.CORNER:
            return "unbounded", "at a corner of the profile"
        case EdgeKind.CUT_OFF:
            return f"{mpa(edge.pressure)}", "cut off by the strips"


# Quantities with more than one row, or covered by another row.
_ROWS: dict[str, Callable[[Solved], list[Row]]] = {
    "max_pressure": _pressure_rows,
    "max_pressure_y": lambda _: [],
    "contact_length": _contact_rows,
}
