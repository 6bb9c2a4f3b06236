"""The largest stresses below a contact, in rows of name, value and position."""

from __future__ import annotations

from nonhertz.files.stresses import poisson, there
from nonhertz.result.numerals import digits
from nonhertz.result.solution import Solution
from nonhertz.subsurface import Extreme, Extremes

COLUMNS = ("", "largest [MPa]", "of p0 there", "x [mm]", "y [mm]", "z [mm]")
#: Names of the quantities in tables.
NAMES = {"von_mises": "von Mises", "shear": "maximum shear", "orthogonal_shear": "orthogonal shear"}


def stress_rows(solution: Solution, overall: Extremes, section: Extremes) -> list[tuple[str, ...]]:
    """Return name, largest value, its ratio to the pressure p0 above it, and its position, for each quantity."""
    places = {f"in body {overall.body}": overall, f"at y = {section.von_mises.y:.5g} mm": section}
    rows = []
    for where, found in places.items():
        rows.append((where, *[""] * (len(COLUMNS) - 1)))
        rows += [_row(solution, f"  {name}", getattr(found, key)) for key, name in NAMES.items()]
        if found.bore is not None and not found.von_mises.at_bore:
            rows.append(_row(solution, "  von Mises", found.bore))
    return rows


def sentences(solution: Solution, section: Extremes) -> list[str]:
    """Return what the reader needs to know about the body and the cross-section to interpret the numbers."""
    y, shear = section.von_mises.y, section.orthogonal_shear
    pressure, half_width = (there(solution, each, y) for each in (solution.centre_pressure, solution.half_width))
    contact = f"p0 = {digits(pressure)} MPa and the half-width is {digits(half_width)} mm"
    return [
        f"Body {section.body} has a Poisson's ratio of {poisson(solution, section.body):g}. At y = {y:.5g} mm "
        f"{contact if pressure > 0.0 else 'there is no contact'}.",
        f"While the load rolls over it there, tau_xz at z = {digits(shear.z)} mm goes through a range of "
        f"{digits(2.0 * shear.max)} MPa.",
    ]


def _row(solution: Solution, name: str, found: Extreme) -> tuple[str, ...]:
    pressure = there(solution, solution.centre_pressure, found.y)
    share = f"{found.max / pressure:.4f}" if pressure > 0.0 else ""
    # The stress field of the strips is symmetric about x = 0.
    x = f"+-{digits(found.x, 4)}" if found.x > 0.0 else "0"
    name += ", at the bore" * found.at_bore
    return name, digits(found.max), share, x, digits(found.y, 4), digits(found.z, 4)
