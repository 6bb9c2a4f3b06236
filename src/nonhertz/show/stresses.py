"""The largest stresses below a contact, in rows of name, value and position."""

from __future__ import annotations

from collections.abc import Iterable

from nonhertz.amounts import format_digits, mm, mpa
from nonhertz.files.stresses import LARGEST, at_station, poisson
from nonhertz.result.solution import Solution
from nonhertz.show.sections import Notes, Section, Table
from nonhertz.strength import Strength
from nonhertz.subsurface import Extreme, Extremes


def sections(solution: Solution, overall: Extremes, section: Extremes, strengths: Iterable[Strength]) -> list[Section]:
    """Return the section on the largest stresses, and whether the bodies withstand them."""
    borne = [sentence for strength in strengths for sentence in strength.sentences]
    blocks = [
        stress_table(solution, overall, section),
        Notes(sentences(solution, section)),
        Notes(borne, "bullets"),
    ]
    return [Section("Stress below the surface", blocks)]


def stress_table(solution: Solution, overall: Extremes, section: Extremes) -> Table:
    """Return name, largest value, its ratio to the pressure p0 above it, and its position, for each quantity."""
    (stress, of_stress), (length, of_length) = mpa(overall.von_mises.max).scale, mm().scale

    def row(name: str, extreme: Extreme) -> tuple[str, ...]:
        pressure = at_station(solution, solution.centre_pressure, extreme.y)
        share = f"{extreme.max / pressure:.4f}" if pressure > 0.0 else ""
        x, y, z = (format_digits(length * coordinate, 4) for coordinate in (extreme.x, extreme.y, extreme.z))
        # The stress field of the strips is symmetric about x = 0.
        x = f"+-{x}" if extreme.x > 0.0 else "0"
        return f"  {name}{', at the bore' * extreme.at_bore}", format_digits(stress * extreme.max), share, x, y, z

    heads = ("", f"largest [{of_stress}]", "of p0 there", *(f"{axis} [{of_length}]" for axis in "xyz"))
    places = {f"in body {overall.body}": overall, f"at y = {mm(section.von_mises.y):.5g}": section}
    rows: list[tuple[str, ...]] = []
    for where, extremes in places.items():
        rows.append((where,))
        rows += [row(name, getattr(extremes, key)) for key, name in LARGEST.items()]
        if extremes.bore is not None and not extremes.von_mises.at_bore:
            rows.append(row("von Mises", extremes.bore))
    return Table(rows, heads, (0,))


def sentences(solution: Solution, section: Extremes) -> list[str]:
    """Return notes on the body and the cross-section for the interpretation of the numbers."""
    y, shear = section.von_mises.y, section.orthogonal_shear
    pressure, half_width = (
        at_station(solution, values, y) for values in (solution.centre_pressure, solution.half_width)
    )
    contact = f"p0 = {mpa(pressure)} and the half-width is {mm(half_width)}"
    return [
        f"Body {section.body} has a Poisson's ratio of {poisson(solution, section.body):g}. At y = {mm(y):.5g} "
        f"{contact if pressure > 0.0 else 'there is no contact'}.",
        f"During a pass of the load, tau_xz there at z = {mm(shear.z)} has a range of {mpa(2.0 * shear.max)}.",
    ]
