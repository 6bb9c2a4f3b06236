"""The summary that ``nonhertz solve`` prints for people."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray
from rich.console import Console
from rich.table import Table
from rich.text import Text

from nonhertz.solution import EdgeKind, EdgePressure, Solution


def print_summary(solution: Solution, title: str) -> None:
    """Print what a solve found, with the errors that it estimates of itself."""
    console = Console(highlight=False)
    console.print(Text(title, style="bold"))
    table = Table(box=None, show_header=False, pad_edge=False, padding=(0, 2, 0, 0))
    for row in summary_rows(solution):
        table.add_row(*(Text(cell) for cell in row))
    console.print(table)
    for warning in solution.warnings:
        console.print(Text(f"warning: {warning}", style="yellow"), soft_wrap=True)


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
    """Return the maximum pressure and where it is, or at which singular end it has no limit."""
    at_end = _near_singular_ends(solution)
    if not at_end[solution.peak_pressure.argmax()]:
        remark = _error(solution.error_estimate.max_pressure, "no limit, as at a sharp end or corner")
        return [
            ("maximum pressure", f"{digits(solution.max_pressure)} MPa", remark),
            ("", f"at y = {digits(solution.max_pressure_y)} mm", ""),
        ]
    singular = [edge for edge in solution.edge_pressure if edge.kind is EdgeKind.SINGULAR]
    highest = min(singular, key=lambda edge: abs(edge.y - solution.max_pressure_y))
    places = " and ".join(f"{edge.y:.5g}" for edge in singular)
    rows = [
        ("maximum pressure", "no limit", f"singular at y = {places} mm"),
        ("", "", f"p ~ K / s^{highest.exponent:.3g}, {_strength(highest)}"),
    ]
    if not np.all(at_end):
        pressure = np.where(at_end, 0.0, solution.peak_pressure)
        highest_at = int(pressure.argmax())
        rows += [
            ("away from the ends", f"{digits(float(pressure[highest_at]))} MPa", ""),
            ("", f"at y = {digits(float(solution.y[highest_at]))} mm", ""),
        ]
    return rows


def _near_singular_ends(solution: Solution) -> NDArray[np.bool_]:
    """Return which strips lie within a half-width of an end where the pressure is singular."""
    near = np.zeros(solution.strips, dtype=bool)
    for edge, half_width in zip(solution.edge_pressure, solution.half_width[[0, -1]], strict=True):
        if edge.kind is EdgeKind.SINGULAR:
            near |= np.abs(solution.y - edge.y) <= half_width
    return near


def _convention(edge: EdgePressure) -> tuple[str, str]:
    match edge.kind:
        case EdgeKind.RUN_OUT:
            return "runs out", ""
        case EdgeKind.FINITE:
            return f"{digits(edge.pressure)} MPa", "finite, faces freed"
        case EdgeKind.SINGULAR:
            return "singular", f"{_strength(edge)}, s^-{edge.exponent:.3g}"


def _strength(edge: EdgePressure) -> str:
    if edge.strength is None:
        return "K unknown on so few strips"
    return f"K = {edge.strength:.4g} MPa mm^{edge.exponent:.3g}"


def _rounded(value: float, scale: float) -> float:
    """Return zero for what is rounding of a sum of terms of the size of ``scale``, as symmetry leaves it."""
    return value if abs(value) > 1e-12 * abs(scale) else 0.0


def _error(relative: float, endless: str = "error unknown") -> str:
    if not math.isfinite(relative):
        return endless
    # A load that is prescribed, say, is met to rounding.
    return f"error about {100.0 * relative:.1g} %" if relative > 1e-12 else ""
