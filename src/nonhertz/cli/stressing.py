"""What ``nonhertz stress`` evaluates, and what it prints for people."""

from __future__ import annotations

import math
import sys
from dataclasses import replace

from rich.console import Console
from rich.table import Table
from rich.text import Text

from nonhertz.cli.summary import digits
from nonhertz.cli.verification import Progress
from nonhertz.errors import InputError
from nonhertz.io.stresses import all_warnings, poisson, there
from nonhertz.singular import singular_ends
from nonhertz.solution import Solution
from nonhertz.subsurface import Extreme, Extremes, extremes

WIDTH = 100  # of what is piped
_COLUMNS = ("", "largest [MPa]", "of p0 there", "x [mm]", "y [mm]", "z [mm]")
_NAMES = {"von_mises": "von Mises", "shear": "maximum shear", "orthogonal_shear": "orthogonal shear"}
_STATION_REMEDY = "choose a place in the body, or leave it out for the cross-section of the largest von Mises stress"


def check_request(station: float | None, body: str) -> None:
    """Refuse what no solution is needed to see.

    Raises
    ------
    InputError
    """
    if body not in {"a", "b"}:
        raise InputError("--body", body, "be one of the two bodies", "write a or b")
    if station is not None and not math.isfinite(station):
        raise InputError("--station", station, "be finite", "give a place along the contact in mm")


def searched(solution: Solution, station: float | None, body: str, progress: Progress) -> tuple[Extremes, Extremes]:
    """Return the largest stresses in a body and in a cross-section of it.

    Raises
    ------
    InputError
        If the cross-section does not lie in the body.
    """
    if station is not None:
        _check_station(solution, station, body)
    progress.announce("whole body")
    overall = extremes(solution, body=body)
    progress.announce("cross-section")
    y = overall.von_mises.y if station is None else station
    section = extremes(solution, y, body=body)
    return overall, replace(section, warnings=(*section.warnings, *_near_sharp_ends(solution, y)))


def print_stresses(solution: Solution, overall: Extremes, section: Extremes, title: str) -> None:
    """Print the largest stresses and where they are, what a pass of the load does, and warnings."""
    console = Console(highlight=False, width=None if sys.stdout.isatty() else WIDTH)
    console.print(Text(title, style="bold"))
    table = Table(box=None, pad_edge=False, padding=(0, 2, 0, 0), header_style="dim")
    for position, name in enumerate(_COLUMNS):
        # As text: rich would take [mm] for markup.
        table.add_column(Text(name), justify="right" if position else "left", no_wrap=bool(position))
    for row in stress_rows(solution, overall, section):
        table.add_row(*map(Text, row))
    console.print(table)
    for sentence in sentences(solution, section):
        console.print(Text(sentence), soft_wrap=True)
    for warning in all_warnings(solution, overall, section):
        console.print(Text(f"warning: {warning}", style="yellow"), soft_wrap=True)


def stress_rows(solution: Solution, overall: Extremes, section: Extremes) -> list[tuple[str, ...]]:
    """Return name, largest value, its share of the pressure p0 above it, and its place, for each quantity."""
    places = {f"in body {overall.body}": overall, f"at y = {section.von_mises.y:.5g} mm": section}
    rows = []
    for where, found in places.items():
        rows.append((where, *[""] * (len(_COLUMNS) - 1)))
        rows += [_row(solution, f"  {name}", getattr(found, key)) for key, name in _NAMES.items()]
    return rows


def sentences(solution: Solution, section: Extremes) -> list[str]:
    """Return what has to be known of the body and of the cross-section to read the numbers."""
    y, shear = section.von_mises.y, section.orthogonal_shear
    pressure, half_width = (there(solution, each, y) for each in (solution.peak_pressure, solution.half_width))
    contact = f"p0 = {digits(pressure)} MPa and the half-width is {digits(half_width)} mm"
    return [
        f"Body {section.body} has a Poisson's ratio of {poisson(solution, section.body):g}. At y = {y:.5g} mm "
        f"{contact if pressure > 0.0 else 'there is no contact'}.",
        f"While the load rolls over it there, tau_xz at z = {digits(shear.z)} mm goes through a range of "
        f"{digits(2.0 * shear.max)} MPa.",
    ]


def _row(solution: Solution, name: str, found: Extreme) -> tuple[str, ...]:
    pressure = there(solution, solution.peak_pressure, found.y)
    share = f"{found.max / pressure:.4f}" if pressure > 0.0 else ""
    # The field of strips is symmetric about x = 0.
    x = f"+-{digits(found.x, 4)}" if found.x > 0.0 else "0"
    return name, digits(found.max), share, x, digits(found.y, 4), digits(found.z, 4)


def _check_station(solution: Solution, station: float, body: str) -> None:
    low, high = (solution.contact.a if body == "a" else solution.contact.b).faces
    if not low <= station <= high:
        condition = f"lie between the side faces of body {body}, {low:.6g} and {high:.6g} mm"
        raise InputError("--station", station, condition, _STATION_REMEDY)


def _near_sharp_ends(solution: Solution, y: float) -> list[str]:
    """Return a sentence for each singular end within a half-width."""
    half_widths = dict(zip(solution.edge_pressure, solution.half_width[[0, -1]], strict=True))
    return [
        f"The cross-section at y = {y:.5g} mm is within a half-width of the sharp end at y = {end.y:.5g} mm, "
        "towards which the stress has no limit: its largest values depend on the strips."
        for end in singular_ends(solution)
        if abs(y - end.y) <= half_widths[end]
    ]
