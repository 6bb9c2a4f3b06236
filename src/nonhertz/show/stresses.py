"""The largest stresses below a contact, in rows of name, value and position."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Final

from nonhertz.amounts import format_digits, mm, mpa
from nonhertz.files.stresses import LARGEST, at_station, poisson
from nonhertz.result.solution import Solution
from nonhertz.show.sections import Notes, Section, Table, summary
from nonhertz.strength import Strength
from nonhertz.subsurface import Extreme, Extremes

_OF_STRESS: Final = "Stress below the surface"


def sections(solution: Solution, overall: Extremes, section: Extremes, strengths: Iterable[Strength]) -> list[Section]:
    """Return the section on the largest stresses, and whether the bodies withstand them."""
    borne = [sentence for strength in strengths for sentence in strength.sentences]
    blocks = [
        stress_table(solution, overall, section),
        Notes(sentences(solution, section)),
        Notes(borne, "bullets"),
    ]
    return [Section(_OF_STRESS, blocks)]


def strength_sections(strength: Strength) -> list[Section]:
    """Return whether one body bears its stresses, check by check, and the largest of them."""
    checks = summary((check.name, str(check.verdict), check.sentence) for check in strength.checks)
    return [Section(f"Strength of body {strength.body}", [checks]), *extremes_sections(strength.largest)]


def extremes_sections(extremes: Extremes) -> list[Section]:
    """Return the largest stresses of one body, or of one cross-section of it."""
    return [Section(_OF_STRESS, [_table({f"in body {extremes.body}": extremes}, lambda extreme: "")])]


def stress_table(solution: Solution, overall: Extremes, section: Extremes) -> Table:
    """Return name, largest value, its ratio to the pressure p0 above it, and its position, for each quantity."""

    def share(extreme: Extreme) -> str:
        pressure = at_station(solution, solution.centre_pressure, extreme.y)
        return f"{extreme.max / pressure:.4f}" if pressure > 0.0 else ""

    return _table({f"in body {overall.body}": overall, f"at y = {mm(section.von_mises.y):.5g}": section}, share)


def _table(places: Mapping[str, Extremes], share: Callable[[Extreme], str]) -> Table:
    (stress, of_stress), (length, of_length) = mpa(next(iter(places.values())).von_mises.max).scale, mm().scale

    def row(name: str, extreme: Extreme) -> tuple[str, ...]:
        x, y, z = (format_digits(length * coordinate, 4) for coordinate in (extreme.x, extreme.y, extreme.z))
        # The stress field of the strips is symmetric about x = 0.
        x = f"+-{x}" if extreme.x > 0.0 else "0"
        name = f"  {name}{', at the bore' * extreme.at_bore}"
        return name, format_digits(stress * extreme.max), share(extreme), x, y, z

    heads = ("", f"largest [{of_stress}]", "of p0 there", *(f"{axis} [{of_length}]" for axis in "xyz"))
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
