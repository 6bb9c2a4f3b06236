"""The opening sentence on what was solved, the key figures, and quantities derived from the dimensions."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from operator import attrgetter

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import Amount, amount, format_input, mm, mpa, mrad, newton, newton_mm, um
from nonhertz.bearing.bearings import CylindricalThrustBearing, RollerBearing, TaperedRollerBearing
from nonhertz.bearing.pairs import Paired
from nonhertz.bearing.section import RINGS
from nonhertz.errors import join_words
from nonhertz.files.bearingfile import BearingCase
from nonhertz.model.body import Body
from nonhertz.model.materials import name_of
from nonhertz.report.results import BearingResults, CaseResults, Results
from nonhertz.result.brief import sizes
from nonhertz.show.key_numbers import bearing_numbers, contact_numbers, stress_number
from nonhertz.show.sections import Row

Array = NDArray[np.float64]

SAMPLES = 401  # points on the interval in which both bodies can touch
FARTHEST = 1e3  # mm; cuts an unbounded interval
NEAR_ENDS = 0.9  # of the length that can touch: at its very end some bodies have no relief
PARTS = ("roller", *RINGS)
_PRESCRIBED: dict[str, tuple[str, Callable[..., Amount]]] = {
    "radial": ("a radial force of", newton),
    "axial": ("an axial force of", newton),
    "load": ("a load of", newton),
    "approach": ("an approach of", um),
    "moment": ("a moment of", newton_mm),
    "radial_displacement": ("a radial displacement of", um),
    "axial_displacement": ("an axial displacement of", um),
    "tilt": ("a tilt of", mrad),
}


def key_numbers(result: Results) -> list[Row]:
    """Return name, value and remark of the key figures."""
    if isinstance(result, BearingResults):
        numbers = [] if result.solution is None else bearing_numbers(result.case, result.solution, result.life)
    else:
        numbers = contact_numbers(result.case, result.solution, result.complaint)
        if result.stress:
            numbers.append(stress_number(result.stress[0].body, result.stress[0].von_mises, searched=True))
    return [(number.name, " ".join(filter(None, number.shown)), number.where) for number in numbers]


def opening_sentence(result: Results) -> str:
    """Return one sentence on what was solved."""
    prescribed = result.case.prescribed.keywords
    acting = [
        f"{words} {kind(*np.atleast_1d(prescribed[name]).tolist(), between=' and '):.5g}"
        for name, (words, kind) in _PRESCRIBED.items()
        if name in prescribed and prescribed[name] != 0.0
    ]
    under = f"under {join_words(acting)}" if acting else "without a load"
    if isinstance(result, CaseResults):
        a, b = _describe_body(result.solution.contact.a, "a"), _describe_body(result.solution.contact.b, "b")
        return f"{a[0].upper()}{a[1:]} and {b} {under}."
    case = result.case
    row, rows = case.bearing.rows[0].bearing, len(case.bearing.rows)
    size = f"{mm(row.roller_diameter, row.roller_length, between=' x '):.5g}"
    what = f"{row.kind}{f' of {rows} rows' if rows > 1 else ''}".capitalize()
    per_row = " in each row" if rows > 1 else ""
    speed = f" at {format_input(float(prescribed['speed']))} 1/min" if prescribed.get("speed") else ""
    circle = f"on a pitch circle of {mm(row.pitch):.5g}"
    return f"{what}, {row.rollers} rollers of {size}{per_row} {circle}, {under}{speed}."


def _describe_body(body: Body, letter: str) -> str:
    kind, material = type(body).__name__.lower(), name_of(body.material) or f"E = {mpa(body.material.modulus):g}"
    described = ", ".join([*([] if body.diameter is not None else ["flat"]), *sizes(body), material])
    return f"{f'body {letter}' if kind == 'body' else f'a {kind}'} ({described})"


def derived_quantities(result: Results) -> list[tuple[str, str]]:
    """Return name and value of quantities derived from the dimensions."""
    if isinstance(result, BearingResults):
        return list(_bearing_quantities(result.case))
    contact = result.solution.contact
    low, high = contact.interval
    y = np.linspace(max(low, -FARTHEST), min(high, FARTHEST), SAMPLES)
    pieces = result.solution.contact_y
    if not math.isfinite(high - low) and pieces:
        y = np.linspace(pieces[0][0], pieces[-1][1], SAMPLES)
    curvature, relief = contact.curvature(y), contact.separation(y)
    rows = [
        ("interval in which the bodies can touch", _interval(low, high)),
        ("combined radius of curvature across", _span(1.0 / curvature, "mm")),
        ("combined curvature across", _span(curvature, "1/mm")),
    ]
    if np.isfinite(relief[[0, -1]]).all():
        where = f"{mm(y[0], y[-1], between=' and '):g}"
        ends = um(*relief[[0, -1]], between=" and ")
        rows.append((f"separation (both reliefs) at y = {where}", f"{ends:4}"))
    return [*rows, ("contact modulus, 1/E* = sum of (1 - ν²) / E", f"{mpa(1.0 / (math.pi * contact.compliance))}")]


def _interval(low: float, high: float) -> str:
    if math.isinf(low) and math.isinf(high):
        return "everywhere"
    numbers, unit = mm(low, high).apart("g")
    ends = (word if math.isfinite(y) else "no end" for y, word in zip((low, high), numbers, strict=True))
    return f"{' to '.join(ends)} {unit}"


def _span(values: Array, unit: str) -> str:
    low, high = sorted((float(values.min()), float(values.max())), key=abs)
    same = math.isclose(low, high, rel_tol=1e-9)
    return f"{amount((low,) if same else sorted((low, high)), unit, between=' to '):.5g}"


# Bearings only


def _bearing_quantities(case: BearingCase) -> Iterator[tuple[str, str]]:
    row = case.bearing.rows[0].bearing
    between = row.pitch * math.sin(math.pi / row.rollers) - row.roller_diameter
    yield "pitch diameter", f"{mm(row.pitch):g}"
    yield "distance between neighbouring rollers", f"{mm(between):4}" if row.rollers > 1 else "no neighbour"
    if row.nominal_angle and not isinstance(row, CylindricalThrustBearing):
        yield "contact angles at inner and outer ring", _degrees(*row.contact_angles)
    if isinstance(row, TaperedRollerBearing):
        yield "half cone angle of the rollers", _degrees(row.half_cone_angle)
    if isinstance(case.bearing, Paired):
        places = mm(*map(attrgetter("x"), case.bearing.rows), between=" and ")
        yield "rows at x =", f"{places:g}"
    for ring, contact in zip(RINGS, row.contacts, strict=True):
        yield f"combined radius across, {ring} ring", f"{mm(1.0 / float(contact.curvature(np.zeros(1))[0]))}"
    ribs = {rib.ring: rib for rib in reversed(row.rib_contacts)}
    for ring in sorted(ribs, key=RINGS.index):
        radii = mm(ribs[ring].radius_around, ribs[ring].radius_along, between=" and ")
        yield f"combined radii on the ribs, {ring} ring, around and along the flank", f"{radii:4}"
    yield from _reliefs(row)
    if row.roller_density is not None:
        yield "mass of a roller", f"{amount(1e6 * row.inertia.mass, 'g'):.4g}"


def _reliefs(row: RollerBearing) -> Iterator[tuple[str, str]]:
    y = NEAR_ENDS * np.array(row.contacts[0].interval)
    where = mm(*y, between=" and ")
    for name in PARTS:
        relief = getattr(row, name).relief(y)  # without arcs of barrels
        if np.any(relief != 0.0):
            part = f"{name}{' ring' * (name in RINGS)}"
            yield f"relief of the {part} at y = {where:.4g}", f"{um(*relief, between=' and '):3}"


def _degrees(*angles: float) -> str:
    return f"{' and '.join(format_input(math.degrees(angle), 5) for angle in angles)} degrees"
