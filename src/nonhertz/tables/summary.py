"""What a solve found, in rows of name, value and remark."""

from __future__ import annotations

import math

import numpy as np

from nonhertz.result.ends import at_corner, largest_away, singular_ends
from nonhertz.result.solution import EdgeKind, EdgePressure, Solution


def summary_rows(solution: Solution) -> list[tuple[str, str, str]]:
    """Return name, value and remark of everything in the summary."""
    estimate = solution.error_estimate
    reach = float(np.max(np.abs(solution.y)))
    by_approach, by_tilt, moment_by_approach, moment_by_tilt = solution.stiffness.ravel().tolist()
    touching = "; ".join(f"{digits(low)} to {digits(high)}" for low, high in solution.contact_y)
    return [
        ("status", solution.status.label, ""),
        ("approach", f"{digits(solution.approach)} mm", _error(estimate.approach)),
        ("", f"{digits(1e3 * solution.approach)} um", ""),
        ("tilt", f"{digits(1e3 * solution.tilt)} mrad", ""),
        ("load", f"{digits(solution.load)} N", _error(estimate.load)),
        ("moment", f"{digits(_rounded(solution.moment, solution.load * reach))} N mm", ""),
        *_pressure_rows(solution),
        ("largest half-width", f"{digits(float(solution.half_width.max()))} mm", ""),
        ("contact along y", f"{touching} mm" if touching else "none", ""),
        *((f"edge at y = {edge.y:.5g} mm", *_convention(edge)) for edge in solution.edge_pressure if touching),
        ("d load / d approach", f"{digits(by_approach)} N/mm", ""),
        ("d load / d tilt", f"{digits(_rounded(by_tilt, by_approach * reach))} N/rad", ""),
        (
            "d moment / d approach",
            f"{digits(_rounded(moment_by_approach, by_approach * reach))} N mm/mm",
            "",
        ),
        ("d moment / d tilt", f"{digits(moment_by_tilt)} N mm/rad", ""),
        ("strips", f"{solution.strips}, {solution.element.name}", ""),
        ("Newton steps", str(solution.iterations), ""),
    ]


def digits(value: float, significant: int = 5) -> str:
    """Return a number with so many significant digits, without an exponent where that can be read.

    Examples
    --------
    >>> digits(0.0322131), digits(20000.0), digits(1.23456789e9), digits(0.0)
    ('0.032213', '20000', '1.2346e+09', '0')
    """
    if value == 0.0 or not math.isfinite(value):
        return f"{value:g}".replace("-0", "0")
    decade = math.floor(math.log10(abs(value)))
    if not -4 <= decade < 8:
        return f"{value:.{significant - 1}e}"
    return f"{value:.{max(0, significant - 1 - decade)}f}"


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


def _rounded(value: float, scale: float) -> float:
    """Return zero for what is rounding of a sum of terms of the size of ``scale``, as symmetry leaves it."""
    return value if abs(value) > 1e-12 * abs(scale) else 0.0


def _error(relative: float) -> str:
    if not math.isfinite(relative):
        return "error unknown"
    # A load that is prescribed, say, is met to rounding.
    return f"error about {100.0 * relative:.1g} %" if relative > 1e-12 else ""
