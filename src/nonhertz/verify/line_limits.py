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
from nonhertz.verify.claim import Claim, Evidence, in_middle, solved

TITLE = "Line contact: limits of both elements (paper, Eqs. 59, 61, 62)"
STEEL = Material(206000.0, 0.3)
DIAMETER, LINE_LOAD = 20.0, 1000.0  # mm, N/mm
LENGTH = 4000.0  # mm, some ten thousand half-widths
TWICE = 2.0 * STEEL.compliance
ELEMENTS = (SEMI_ELLIPTIC, PARABOLIC)
VERY_LONG, LONG = 1e4, 100.0  # half a strip's length, in its half-widths
PRESSURE_FACTOR = 4.0 * math.sqrt(6.0) / (3.0 * math.pi)
_SHORT = "a strip from -t to t lacks 1/t^2 of its line factor"


def claims() -> Iterator[Claim]:
    """Yield the claims."""
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
            yield from _contacts(element, grid, strips)


def line_factor(element: Element, t: float = VERY_LONG) -> float:
    """Return a^2 / (K q rho) of a single strip from -t to t half-widths."""
    return 2.0 * float(element.functions(t)[2])


def _short_of_limit(element: Element) -> float:
    return LONG**2 * (element.line_factor - line_factor(element, LONG))


@solved
def _solution(element: Element, strips: int | None) -> Solution:
    roller = Roller(diameter=DIAMETER, length=LENGTH, material=STEEL, side_faces="none", depth="none")
    contact = Contact(roller, Plate(material=STEEL))
    return solve(contact, load=LINE_LOAD * LENGTH, element=element, strips=strips)


def _contacts(element: Element, grid: str, strips: int | None) -> Iterator[Claim]:
    solution = functools.partial(_solution, element, strips)
    of = Evidence(f"{element.name}, {grid}", "Hertz's line contact", solution)
    half_width, pressure, c, line_load = map(
        in_middle, ("half_width", "centre_pressure", "element_half_width", "line_load")
    )

    def hertz() -> LineContact:
        # The sharp ends attract load; what is left in the middle decides.
        return line_contact(line_load=line_load(solution()), radius=0.5 * DIAMETER, compliance=TWICE)

    def by_summit() -> float:
        a = c(solution())
        return PRESSURE_FACTOR * (0.75 * line_load(solution()) / a**3) * a**2

    yield of.claim("half-width b", half_width, 1e-7, "mm", expected=lambda: hertz().half_width)
    yield of.claim("pressure p0", pressure, 1e-7, "MPa", expected=lambda: hertz().max_pressure)
    if element is PARABOLIC and strips == 1:
        yield of.claim(
            "c", c, 1e-7, "mm", source="sqrt(6 K q rho), from Eq. (59)",
            expected=lambda: math.sqrt(6.0 * TWICE * line_load(solution()) * 0.5 * DIAMETER),
        )  # fmt: skip
        by_c = math.sqrt(2.0 / 3.0)
        yield of.claim(
            "b of c", half_width, 1e-12, "mm", expected=lambda: by_c * c(solution()), source="paper, Eq. (61)"
        )
        yield of.claim("p0 of s and c", pressure, 1e-12, "MPa", expected=by_summit, source="paper, Eq. (62)")
