"""Contacts with closed forms: ellipses and lines, by both elements.

Ellipses are set against Hertz (paper, Fig. 3), and the parabola's bias against a second program; lines against the
limits of both elements, Eqs. (59), (61) and (62) of the paper.
"""

from __future__ import annotations

import functools
import math
import operator
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from claims.claim import Array, Claim, Evidence, in_middle, pressures, solved
from nonhertz import PARABOLIC, SEMI_ELLIPTIC, Body, Contact, Material, Plate, Roller, Solution, solve
from nonhertz.hertz import LineContact, PointContact, line_contact, point_contact
from nonhertz.model.profile import Profile
from nonhertz.strip.element import Element

STEEL = Material(206000.0, 0.3)
ELEMENTS = (SEMI_ELLIPTIC, PARABOLIC)
RADIUS_X, RADIUS_Y, LOAD = 10.0, 100.0, 1000.0
EQUAL_STRIPS, REACH = 41, 1.3  # the latter: half the length of the body, in half-lengths of the contact
INSIDE = 0.9  # of the half-length: strips at the end carry a mean over their width
QUANTITIES, UNITS = ("greatest pressure", "greatest half-width", "approach"), ("MPa", "mm", "mm")
# What refinement does not remove from parabolic strips in this contact, in pressure, half-width and approach.
PARABOLIC_BIAS = (0.0061, 0.0065, -0.0143)

# The paper's element in a separate program: Rx 10, 2000 N, 41 strips over 1.35 half-lengths to either side.
# Ellipticity a/b and Ry [mm]; errors of pressure, half-width and approach against Hertz [%].
SECOND, SECOND_LOAD, SECOND_REACH = "a second, separate implementation", 2000.0, 1.35
SECOND_ERRORS = (
    (3, 53.0, (0.72, 0.79, -1.64)),
    (5, 118.3, (0.60, 0.63, -1.39)),
    (10, 365.4, (0.47, 0.47, -1.13)),
    (20, 1176.5, (0.38, 0.37, -0.95)),
    (50, 5810.0, (0.29, 0.29, -0.79)),
)
# Pressure over Hertz's greatest at places over the half-length, with a/b = 10.
SHAPE = {0.4: 0.9191, 0.6: 0.7993, 0.8: 0.5920, 0.9: 0.4159}


@dataclass(frozen=True)
class Parabola(Profile):
    """The relief of Hertz's theory, y^2 / (2 R); a circle differs from it by more than the tolerances here."""

    radius: float

    def relief(self, y: ArrayLike) -> Array:
        """Return the relief [mm]."""
        return np.asarray(np.asarray(y, dtype=float) ** 2 / (2.0 * self.radius))


def ellipse(radius_y: float = RADIUS_Y, load: float = LOAD) -> PointContact:
    """Return the exact solution."""
    return point_contact(radius_x=RADIUS_X, radius_y=radius_y, load=load, compliance=2.0 * STEEL.compliance)


@solved
def on_strips(exact: PointContact, element: Element, reach: float, strips: int | None) -> Solution:
    """Return the same contact on equal strips, or on the automatic grid (None)."""
    body = Body(
        diameter=2.0 * exact.radius_x, length=2.0 * reach * exact.half_length, profile=Parabola(exact.radius_y),
        material=STEEL, side_faces="none", depth="none",
    )  # fmt: skip
    accuracy = 1e-5 if strips is None else None
    contact = Contact(body, Plate(material=STEEL))
    return solve(contact, load=exact.load, element=element, strips=strips, accuracy=accuracy)


def found(solution: Solution) -> tuple[float, float, float]:
    """Return pressure, half-width and approach."""
    return solution.max_pressure, float(solution.half_width.max()), solution.approach


def errors(solution: Solution, exact: PointContact) -> Array:
    """Return their relative differences from Hertz."""
    return np.asarray(np.array(found(solution)) / (exact.max_pressure, exact.half_width, exact.approach) - 1.0)


def off(solution: Solution, exact: PointContact) -> tuple[Array, Array, Array]:
    """Return positions inside [mm], and the differences of pressure and half-width there over Hertz's maxima."""
    inside = np.abs(solution.y) < INSIDE * exact.half_length
    y = solution.y[inside]
    pressure = (solution.centre_pressure[inside] - exact.pressure(y)) / exact.max_pressure
    return y, pressure, (solution.half_width[inside] - exact.half_width_at(y)) / exact.half_width


def ellipses() -> Iterator[Claim]:
    """Yield the claims about elliptical contacts."""
    for element in ELEMENTS:
        yield from _against_hertz(element, EQUAL_STRIPS, f"{EQUAL_STRIPS} equal strips", 2e-4, 3e-3)
        yield from _against_hertz(element, None, "automatic grid", 5e-5, 5e-4)
    for ellipticity, radius_y, expected in SECOND_ERRORS:
        of = Evidence(f"parabolic, a/b = {ellipticity}", SECOND, functools.partial(_second_errors, radius_y))
        names, why = [f"{name} over Hertz's" for name in QUANTITIES], "two decimals are given"
        yield from of.each(names, 0.006, "%", expected=expected, absolute=True, why=why)
    yield from Evidence("parabolic, a/b = 10", SECOND, _shape).each(
        [f"pressure at y/a = {place:g} over Hertz's greatest" for place in SHAPE], 2e-4, expected=[*SHAPE.values()],
        absolute=True, why="between strip centres the pressure is interpolated linearly, as in the other program",
    )  # fmt: skip


def _against_hertz(
    element: Element, strips: int | None, grid: str, within: float, along_within: float
) -> Iterator[Claim]:
    exact, biased = ellipse(), element is PARABOLIC
    solution = functools.partial(on_strips, exact, element, REACH, strips)
    of = Evidence(f"{element.name}, {grid}", "Hertz", lambda: found(solution()))
    targets = exact.max_pressure, exact.half_width, exact.approach
    if biased:
        for place, (name, bias) in enumerate(zip(QUANTITIES, PARABOLIC_BIAS, strict=True)):
            yield of.claim(
                name, operator.itemgetter(place), 3e-4, UNITS[place], expected=targets[place] * (1.0 + bias),
                source=f"Hertz {100.0 * bias:+.2f} %, the element's bias", why="41 strips add 2e-4 to the bias",
            )  # fmt: skip
    else:
        yield from of.each(QUANTITIES, within, UNITS, expected=targets)
    yield Evidence(of.name, of.source, solution).claim(
        f"largest difference of pressure within {INSIDE:g} half-lengths, of the greatest",
        lambda solved: np.max(np.abs(off(solved, exact)[1])), None if biased else along_within,
    )  # fmt: skip


def _second_errors(radius_y: float) -> Array:
    exact = ellipse(radius_y, SECOND_LOAD)
    return 100.0 * errors(on_strips(exact, PARABOLIC, SECOND_REACH, EQUAL_STRIPS), exact)


def _shape() -> Array:
    exact = ellipse(365.4, SECOND_LOAD)
    solution = on_strips(exact, PARABOLIC, SECOND_REACH, EQUAL_STRIPS)
    return np.array(pressures(solution, np.array(list(SHAPE)) * exact.half_length)) / exact.max_pressure


# Lines

LINE_DIAMETER, LINE_LOAD = 20.0, 1000.0  # mm, N/mm
LINE_LENGTH = 4000.0  # mm, some ten thousand half-widths
TWICE = 2.0 * STEEL.compliance
VERY_LONG, LONG = 1e4, 100.0  # half a strip's length, in its half-widths
PRESSURE_FACTOR = 4.0 * math.sqrt(6.0) / (3.0 * math.pi)
_SHORT = "a strip from -t to t lacks 1/t^2 of its line factor"


def lines() -> Iterator[Claim]:
    """Yield the claims about line contacts."""
    c = 0.3
    yield Claim(
        f"curvature coefficient of a parabolic strip with c = {c:g} mm, two steel bodies", "paper, Eq. (59)",
        8.0 * (1.0 - STEEL.poisson) * c / (math.pi * STEEL.shear_modulus),
        lambda: TWICE * (4.0 / 3.0) * c * line_factor(PARABOLIC), 1e-8, "mm^3/N", why=_SHORT,
    )  # fmt: skip
    for element, source in ((SEMI_ELLIPTIC, "Hertz"), (PARABOLIC, "paper, Eqs. (32), (59)")):
        found = functools.partial(line_factor, element)
        yield Claim(f"{element.name}: a^2/(K q rho)", source, element.line_factor, found, 1e-8, why=_SHORT)
    for element in ELEMENTS:
        yield Claim(
            f"{element.name}: what a^2/(K q rho) is short of its limit at t = {LONG:g}, times t^2",
            "leading term of the series for large t", 1.0, functools.partial(_short_of_limit, element), 1e-4,
        )  # fmt: skip
    yield Claim(
        "displacement of the semi-ellipse less that of the parabola of equal load, over 2 q K",
        "1/2 + ln 2 + ln(3/2)/2 - 4/3", 0.5 + math.log(2.0) + 0.5 * math.log(1.5) - 4.0 / 3.0,
        lambda: 0.5 * (2.0 * float(SEMI_ELLIPTIC.functions(VERY_LONG)[0])
                       - 2.0 * float(PARABOLIC.functions(VERY_LONG * PARABOLIC.hertz_ratio)[0])),
        1e-7,
    )  # fmt: skip
    for element in ELEMENTS:
        for grid, strips in (("one strip", 1), ("41 strips", 41), ("automatic grid", None)):
            yield from _of_lines(element, grid, strips)


def line_factor(element: Element, t: float = VERY_LONG) -> float:
    """Return a^2 / (K q rho) of a single strip from -t to t half-widths."""
    return 2.0 * float(element.functions(t)[2])


def _short_of_limit(element: Element) -> float:
    return LONG**2 * (element.line_factor - line_factor(element, LONG))


@solved
def _long(element: Element, strips: int | None) -> Solution:
    roller = Roller(diameter=LINE_DIAMETER, length=LINE_LENGTH, material=STEEL, side_faces="none", depth="none")
    contact = Contact(roller, Plate(material=STEEL))
    return solve(contact, load=LINE_LOAD * LINE_LENGTH, element=element, strips=strips)


def _of_lines(element: Element, grid: str, strips: int | None) -> Iterator[Claim]:
    solution = functools.partial(_long, element, strips)
    of = Evidence(f"{element.name}, {grid}", "Hertz's line contact", solution)
    names = "half_width", "centre_pressure", "element_half_width", "line_load"
    half_width, pressure, c, line_load = map(in_middle, names)

    def by_load() -> LineContact:
        # The sharp ends attract load; what is left in the middle decides.
        return line_contact(line_load=line_load(solution()), radius=0.5 * LINE_DIAMETER, compliance=TWICE)

    def by_summit() -> float:
        a = c(solution())
        return PRESSURE_FACTOR * (0.75 * line_load(solution()) / a**3) * a**2

    yield of.claim("half-width b", half_width, 1e-7, "mm", expected=lambda: by_load().half_width)
    yield of.claim("pressure p0", pressure, 1e-7, "MPa", expected=lambda: by_load().max_pressure)
    if element is PARABOLIC and strips == 1:
        yield of.claim(
            "c", c, 1e-7, "mm", source="sqrt(6 K q rho), from Eq. (59)",
            expected=lambda: math.sqrt(6.0 * TWICE * line_load(solution()) * 0.5 * LINE_DIAMETER),
        )  # fmt: skip
        by_c = math.sqrt(2.0 / 3.0)
        yield of.claim(
            "b of c", half_width, 1e-12, "mm", expected=lambda: by_c * c(solution()), source="paper, Eq. (61)"
        )
        yield of.claim("p0 of s and c", pressure, 1e-12, "MPa", expected=by_summit, source="paper, Eq. (62)")
