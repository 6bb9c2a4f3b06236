"""Line contacts: the limits of both elements, Eqs. (59), (61) and (62) of the paper."""

from __future__ import annotations

import functools
import math
from collections.abc import Iterator

from nonhertz.hertz import LineContact, line_contact
from nonhertz.model.body import Plate, Roller
from nonhertz.model.contact import Contact
from nonhertz.model.material import Material
from nonhertz.result.solution import Solution
from nonhertz.solver.one import solve
from nonhertz.strip.element import PARABOLIC, SEMI_ELLIPTIC, Element
from nonhertz.verify.claim import Claim, middle, solved

TITLE = "Line contact: limits of both elements (paper, Eqs. 59, 61, 62)"
STEEL = Material(206000.0, 0.3)
DIAMETER, LINE_LOAD = 20.0, 1000.0  # mm, N/mm
LENGTH = 4000.0  # mm, some ten thousand half-widths
ELEMENTS = (SEMI_ELLIPTIC, PARABOLIC)
VERY_LONG, LONG = 1e4, 100.0  # half a strip's length, in its half-widths
PRESSURE_FACTOR = 4.0 * math.sqrt(6.0) / (3.0 * math.pi)
_LACK = 0.5 + math.log(2.0) + 0.5 * math.log(1.5) - 4.0 / 3.0
_HERTZ, _SHORT = "Hertz's line contact", "a strip from -t to t lacks 1/t^2 of its line factor"


def claims() -> Iterator[Claim]:
    """Yield the claims."""
    yield from _functions()
    for element in ELEMENTS:
        for grid, strips in (("one strip", 1), ("41 strips", 41), ("automatic grid", None)):
            yield from _contacts(element, grid, strips)


def line_factor(element: Element, t: float) -> float:
    """Return a^2 / (K q rho) of a single strip from -t to t half-widths."""
    return 2.0 * float(element.functions(t)[2])


def _functions() -> Iterator[Claim]:
    c = 0.3
    yield Claim(
        f"curvature coefficient of a parabolic strip with c = {c:g} mm, two steel bodies", "paper, Eq. (59)",
        8.0 * (1.0 - STEEL.poisson) * c / (math.pi * STEEL.shear_modulus),
        lambda: 2.0 * STEEL.compliance * (4.0 / 3.0) * c * line_factor(PARABOLIC, VERY_LONG), 1e-8, "mm^3/N",
        why=_SHORT,
    )  # fmt: skip
    for element, source in ((SEMI_ELLIPTIC, "Hertz"), (PARABOLIC, "paper, Eqs. (32), (59)")):
        yield _limit(element, source)
    for element in ELEMENTS:
        yield _short_of_it(element)
    yield Claim(
        "displacement of the semi-ellipse less that of the parabola of equal load, over 2 q K",
        "1/2 + ln 2 + ln(3/2)/2 - 4/3", _LACK,
        lambda: 0.5 * (2.0 * float(SEMI_ELLIPTIC.functions(VERY_LONG)[0])
                       - 2.0 * float(PARABOLIC.functions(VERY_LONG * PARABOLIC.hertz_ratio)[0])),
        1e-7,
    )  # fmt: skip


def _limit(element: Element, source: str) -> Claim:
    return Claim(
        f"{element.name}: a^2/(K q rho)", source, element.line_factor, lambda: line_factor(element, VERY_LONG), 1e-8,
        why=_SHORT,
    )  # fmt: skip


def _short_of_it(element: Element) -> Claim:
    return Claim(
        f"{element.name}: what a^2/(K q rho) is short of its limit at t = {LONG:g}, times t^2",
        "leading term of the series for large t", 1.0,
        lambda: LONG**2 * (element.line_factor - line_factor(element, LONG)), 1e-4,
    )  # fmt: skip


@solved
def _solution(element: Element, strips: int | None) -> Solution:
    roller = Roller(diameter=DIAMETER, length=LENGTH, material=STEEL, side_faces="none", depth="none")
    contact = Contact(roller, Plate(material=STEEL))
    return solve(contact, load=LINE_LOAD * LENGTH, element=element, strips=strips)


def _contacts(element: Element, grid: str, strips: int | None) -> Iterator[Claim]:
    case, twice = f"{element.name}, {grid}", 2.0 * STEEL.compliance

    def of(quantity: str) -> float:
        return middle(_solution(element, strips), quantity)

    def hertz() -> LineContact:
        # The sharp ends attract load; what is left in the middle decides.
        return line_contact(line_load=of("line_load"), radius=0.5 * DIAMETER, compliance=twice)

    def by_summit() -> float:
        a = of("element_half_width")
        return PRESSURE_FACTOR * (0.75 * of("line_load") / a**3) * a**2

    b, p0, c = (functools.partial(of, name) for name in ("half_width", "centre_pressure", "element_half_width"))
    yield Claim(f"{case}: half-width b", _HERTZ, lambda: hertz().half_width, b, 1e-7, "mm")
    yield Claim(f"{case}: pressure p0", _HERTZ, lambda: hertz().max_pressure, p0, 1e-7, "MPa")
    if element is PARABOLIC and strips == 1:
        yield Claim(
            f"{case}: c", "sqrt(6 K q rho), from Eq. (59)",
            lambda: math.sqrt(6.0 * twice * of("line_load") * 0.5 * DIAMETER), c, 1e-7, "mm",
        )  # fmt: skip
        yield Claim(f"{case}: b of c", "paper, Eq. (61)", lambda: math.sqrt(2.0 / 3.0) * c(), b, 1e-12, "mm")
        yield Claim(f"{case}: p0 of s and c", "paper, Eq. (62)", by_summit, p0, 1e-12, "MPa")
