"""What a solve found, in rows of name, value and remark."""

from __future__ import annotations

import math

from nonhertz.result.brief import where_largest
from nonhertz.result.numerals import digits
from nonhertz.result.quantities import QUANTITIES
from nonhertz.result.solution import EdgeKind, EdgePressure, Solution


def summary_rows(solution: Solution) -> list[tuple[str, str, str]]:
    """Return name, value and remark of everything in the summary."""
    estimate = solution.error_estimate
    touching = "; ".join(f"{digits(low)} to {digits(high)}" for low, high in solution.contact_y)
    return [
        ("status", solution.status.label, ""),
        ("approach", f"{digits(solution.approach)} mm", _error(estimate.approach)),
        ("", QUANTITIES["approach"].text(solution), ""),
        _row("tilt", solution),
        _row("load", solution, _error(estimate.load)),
        _row("moment", solution),
        *_pressure_rows(solution),
        _row("max_half_width", solution),
        ("contact along y", f"{touching} mm" if touching else "none", ""),
        *((f"edge at y = {edge.y:.5g} mm", *_convention(edge)) for edge in solution.edge_pressure if touching),
        *(_row(f"{force}_by_{motion}", solution) for force in ("load", "moment") for motion in ("approach", "tilt")),
        ("strips", f"{solution.strips}, {solution.element.name}", ""),
        ("Newton steps", str(solution.iterations), ""),
    ]


def _row(name: str, solution: Solution, remark: str = "") -> tuple[str, str, str]:
    quantity = QUANTITIES[name]
    return quantity.label, quantity.text(solution), remark


def _pressure_rows(solution: Solution) -> list[tuple[str, str, str]]:
    """Return the maximum pressure and where it is."""
    if not solution.contact_y:
        return []
    remark = _error(solution.error_estimate.max_pressure)
    if solution.peaks_at_corner:
        remark = "no limit, at a corner of the profile"
    elif any(edge.kind is EdgeKind.CUT_OFF and _at(edge, solution) for edge in solution.edge_pressure):
        remark = "cut off by the strips"
    where, _, away = where_largest(solution).partition(", ")
    return [_row("max_pressure", solution, remark), ("", where, away)]


def _at(edge: EdgePressure, solution: Solution) -> bool:
    return abs(edge.y - solution.max_pressure_y) <= edge.strip_width


def _convention(edge: EdgePressure) -> tuple[str, str]:
    match edge.kind:
        case EdgeKind.RUN_OUT:
            return "runs out", ""
        case EdgeKind.FINITE:
            return f"{digits(edge.pressure)} MPa", "finite; the true end is lower"
        case EdgeKind.SINGULAR:
            return "singular", edge.law
        case EdgeKind.CORNER:
            return "no limit", "at a corner of the profile"
        case EdgeKind.CUT_OFF:
            return f"{digits(edge.pressure)} MPa", "cut off by the strips"


def _error(relative: float) -> str:
    if not math.isfinite(relative):
        return "error unknown"
    # A load that is prescribed, say, is met to rounding.
    return f"error about {100.0 * relative:.1g} %" if relative > 1e-12 else ""
