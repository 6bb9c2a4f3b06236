"""The overview of a solution: what was solved, the key numbers, the geometry, and the ends, in words."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from nonhertz.amounts import Amount, amount, mm, mpa, mrad, newton, newton_mm, um
from nonhertz.model.body import Body, TabulatedDiameter
from nonhertz.model.materials import MATERIALS
from nonhertz.report.results import CaseResults
from nonhertz.result.brief import where_largest
from nonhertz.result.maximum import largest_half_width, singular_y
from nonhertz.result.penetration import is_noticeable
from nonhertz.result.solution import EdgeKind, EdgePressure, Solution

SAMPLES = 401  # points on the interval in which both bodies can touch
FARTHEST = 1e3  # mm; cuts an unbounded interval


@dataclass(frozen=True)
class Key:
    """A number that the reader looks for first.

    Attributes
    ----------
    name : str
        What it is.
    value, unit : str
        The number, or a word where there is none.
    remark : str
        Where it is, or what it is instead.
    """

    name: str
    value: str
    unit: str
    remark: str = ""

    @classmethod
    def of(cls, name: str, found: Amount, remark: str = "", spec: str = "") -> Key:
        """Return a number in the units that are read."""
        (value,), unit = found.apart(spec)
        return cls(name, value, unit, remark)


def opening(found: CaseResults) -> str:
    """Return one sentence on what was solved."""
    solution, prescribed = found.solution, found.case.prescribed
    a, b = solution.contact.a, solution.contact.b
    load = prescribed.get("load")
    pressed = _by_approach(prescribed["approach"]) if load is None else f"with {newton(load):g}"
    turned = ""
    if prescribed.get("tilt"):
        turned = f" and tilted by {mrad(prescribed['tilt']):.4g}"
    elif "moment" in prescribed:
        turned = f" under a moment of {newton_mm(prescribed['moment']):g}"
    return f"{_body(a, 'a')} and {_body(b, 'b')} are pressed together {pressed}{turned}."


def keys(found: CaseResults) -> list[Key]:
    """Return the key numbers."""
    solution = found.solution
    if not solution.contact_y:
        return [Key("contact", "none", "")]
    half_width, widest = largest_half_width(solution.y, solution.half_width, singular_y(solution))
    shown = [
        *_pressures(solution),
        Key.of("approach", um(solution.approach)),
        *_penetration(solution),
        Key.of("largest half-width", mm(float(half_width)), _at(float(widest))),
    ]
    if "load" not in found.case.prescribed:
        shown.append(Key.of("load", newton(solution.load)))
    if found.stress:
        largest = found.stress[0].von_mises
        where = f"{largest.site}y = {mm(largest.y):4}, z = {mm(largest.z):3}"
        shown.append(Key.of(f"largest von Mises stress in body {found.stress[0].body}", mpa(largest.max), where))
    return shown


def _penetration(solution: Solution) -> list[Key]:
    if not is_noticeable(solution.approach, solution.penetration):
        return []
    return [Key.of("penetration", um(solution.penetration), "approach beyond first touch")]


def geometry(solution: Solution) -> list[tuple[str, str, str]]:
    """Return name, value and unit of quantities derived from the inputs alone."""
    contact = solution.contact
    low, high = contact.interval
    y = np.linspace(max(low, -FARTHEST), min(high, FARTHEST), SAMPLES)
    if not math.isfinite(high - low) and solution.contact_y:
        y = np.linspace(solution.contact_y[0][0], solution.contact_y[-1][1], SAMPLES)
    radius = 1.0 / contact.curvature(y)
    relief = contact.separation(y)
    shown = [
        ("both bodies can touch", *_interval(low, high)),
        ("combined radius of curvature across", *_span(radius, "mm")),
        ("combined curvature across", *_span(1.0 / radius, "1/mm")),
    ]
    if np.isfinite(relief[[0, -1]]).all():
        where = f"{mm(y[0], y[-1], between=' and '):g}"
        ends, unit = um(*relief[[0, -1]]).apart("4")
        shown.append((f"separation (both reliefs) at y = {where}", " and ".join(ends), unit))
    modulus = 1.0 / (math.pi * contact.compliance)
    shown.append(("contact modulus, 1/E* = sum of (1 - ν²) / E", *_one(mpa(modulus))))
    return shown


def ends_in_words(solution: Solution) -> list[str]:
    """Return, for both ends of the contact, what kind of number the pressure is there."""
    return [_end_in_words(edge) for edge in solution.edge_pressure] if solution.contact_y else []


def _end_in_words(edge: EdgePressure) -> str:
    shown = f"At y = {mm(edge.y):.5g}: {edge.kind.value[0].lower()}{edge.kind.value[1:]}"
    match edge.kind:
        case EdgeKind.RUN_OUT | EdgeKind.CORNER:
            return shown
        case EdgeKind.SINGULAR:
            return f"{shown} With the distance s it varies as {edge.law} ({edge.convention})."
        case _:
            return f"{shown} It is {mpa(edge.pressure)} ({edge.convention})."


def _pressures(solution: Solution) -> list[Key]:
    remark = "no limit, at a corner of the profile" if solution.peaks_at_corner else where_largest(solution, 4)
    shown = [Key.of("maximum pressure", mpa(solution.max_pressure), remark)]
    sharp = [edge for edge in solution.edge_pressure if edge.law]
    if sharp:
        highest = max(sharp, key=lambda edge: edge.pressure)
        shown.append(Key("pressure at the sharp end", "no limit", "", f"{highest.law}, at y = {mm(highest.y):.5g}"))
    return shown


def _body(body: Body, letter: str) -> str:
    kind = type(body).__name__.lower()
    words = (
        f"{'A' if letter == 'a' else 'a'} {kind}" if kind != "body" else f"{'B' if letter == 'a' else 'b'}ody {letter}"
    )
    sizes = []
    if isinstance(body.diameter, float | int):
        sizes.append(f"diameter {mm(float(abs(body.diameter))):g}{', concave' if body.diameter < 0.0 else ''}")
    elif isinstance(body.diameter, TabulatedDiameter):
        sizes.append(f"diameter {' '.join(_span(np.array(body.diameter.diameter), 'mm'))}")
    else:
        sizes.append("flat")
    if body.length is not None:
        sizes.append(f"length {mm(body.length):g}")
    name = next((name for name, known in MATERIALS.items() if known == body.material), "")
    sizes.append(name or f"E = {mpa(body.material.modulus):g}")
    return f"{words} ({', '.join(sizes)})"


def _by_approach(approach: float) -> str:
    return f"until they have approached by {um(approach):g}"


def _at(y: float) -> str:
    return f"at y = {mm(y):4}"


def _interval(low: float, high: float) -> tuple[str, str]:
    if math.isinf(low) and math.isinf(high):
        return "everywhere", ""
    numbers, unit = mm(low, high).apart("g")
    ends = (word if math.isfinite(y) else "no end" for y, word in zip((low, high), numbers, strict=True))
    return " to ".join(ends), unit


def _one(found: Amount) -> tuple[str, str]:
    (number,), unit = found.apart()
    return number, unit


def _span(values: np.ndarray[tuple[int, ...], np.dtype[np.float64]], unit: str) -> tuple[str, str]:
    low, high = float(values.min()), float(values.max())
    numbers, unit = amount((low,) if math.isclose(low, high, rel_tol=1e-9) else (low, high), unit).apart(".5g")
    return " to ".join(numbers), unit
