"""What a solve found, in rows of name, value and remark."""

from __future__ import annotations

import math

import numpy as np

from nonhertz.result.ends import at_corner, largest_away, singular_ends
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
    """Return the maximum pressure and where it is, or at which singular ends it has no limit."""
    singular = singular_ends(solution)
    if not singular:
        return _largest("maximum pressure", solution, _error(solution.error_estimate.max_pressure))
    highest = max(singular, key=lambda edge: edge.pressure)
    places = " and ".join(f"{edge.y:.5g}" for edge in singular)
    return [
        ("maximum pressure", "no limit", f"singular at y = {places} mm"),
        ("", "", f"p ~ K / s^{highest.exponent:.3g}, {_strength(highest)}"),
        *_largest("away from the ends", solution, ""),
    ]


def _largest(name: str, solution: Solution, remark: str) -> list[tuple[str, str, str]]:
    """Return the largest pressure away from singular ends and where it is."""
    strips = largest_away(solution)
    if not strips:
        return []
    at = strips[0]
    edge = solution.edge_pressure[0 if solution.y[at] < np.mean(solution.edges[[0, -1]]) else 1]
    if at_corner(solution, at):
        remark = "no limit, at a corner of the profile"
    elif edge.kind is EdgeKind.CUT_OFF and at in {0, solution.strips - 1}:
        remark = "cut off by the strips"
    places = " and ".join(digits(y) for y in solution.y[list(strips)].tolist())
    return [
        (name, f"{digits(float(solution.centre_pressure[at]))} MPa", remark),
        ("", f"at y = {places} mm", ""),
    ]


def _convention(edge: EdgePressure) -> tuple[str, str]:
    match edge.kind:
        case EdgeKind.RUN_OUT:
            return "runs out", ""
        case EdgeKind.FINITE:
            return f"{digits(edge.pressure)} MPa", "finite; the true end is lower"
        case EdgeKind.SINGULAR:
            return "singular", f"{_strength(edge)}, s^-{edge.exponent:.3g}"
        case EdgeKind.CORNER:
            return "no limit", "at a corner of the profile"
        case EdgeKind.CUT_OFF:
            return f"{digits(edge.pressure)} MPa", "cut off by the strips"


def _strength(edge: EdgePressure) -> str:
    return "K unknown" if edge.strength is None else f"K = {edge.strength:.4g} MPa mm^{edge.exponent:.3g}"


def _error(relative: float) -> str:
    if not math.isfinite(relative):
        return "error unknown"
    # A load that is prescribed, say, is met to rounding.
    return f"error about {100.0 * relative:.1g} %" if relative > 1e-12 else ""
