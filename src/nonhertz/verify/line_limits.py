"""Eqs. (59), (61) and (62) of the paper: the limits of both elements in a line contact."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import TYPE_CHECKING

import numpy as np

from nonhertz.hertz import LineContact, line_contact
from nonhertz.model.body import Plate, Roller
from nonhertz.model.contact import Contact
from nonhertz.model.material import Material
from nonhertz.plot.style import FAINT_INK, FIRST, SECOND
from nonhertz.result.solution import Solution
from nonhertz.solver.one import solve
from nonhertz.strip.element import PARABOLIC, SEMI_ELLIPTIC, Element
from nonhertz.verify.claim import Check, Picture, Section

if TYPE_CHECKING:
    from matplotlib.figure import Figure

STEEL = Material(206000.0, 0.3)
DIAMETER, LINE_LOAD = 20.0, 1000.0  # mm, N/mm
LENGTH = 4000.0  # mm, some ten thousand half-widths
ELEMENTS = (SEMI_ELLIPTIC, PARABOLIC)
VERY_LONG, LONG = 1e4, 100.0  # half a strip's length, in its half-widths
PRESSURE_FACTOR = 4.0 * math.sqrt(6.0) / (3.0 * math.pi)
_LACK = 0.5 + math.log(2.0) + 0.5 * math.log(1.5) - 4.0 / 3.0
_TEXT = """\
A strip that is long against its width is a line contact, and there both elements have closed forms. For two bodies
with the compliances $`K_a + K_b = K`$, a load $q$ per unit length and the combined radius $\\rho$:

- **Curvature, Eq. (59).** A parabola $p = s(c^2 - x^2)$, $q = \\frac43 s c^3$, curves two like surfaces by
  $8(1-\\nu)c/(\\pi G)$ per unit of $s$. So $a^2 = 6 K q \\rho$. For the semi-ellipse $a^2 = 4 K q \\rho$, which is
  Hertz. The numbers 6 and 4 are the elements' line factors.
- **Conversion, Eqs. (61) and (62).** At equal load $b = \\sqrt{{2/3}} c$ and $`p_0 = 4\\sqrt6/(3\\pi)\\, s c^2`$, with
  $s = 3q/(4c^3)$: the half-width and pressure reported for a parabola are those of Hertz, while its own pressure in the
  middle is {own:.1f} % lower and its base {wider:.1f} % wider.

They are compared with the elements' influence functions, and with solved contacts: a straight roller, diameter
{diameter:g} mm, on a plate, {line_load:g} N/mm, {length:g} mm long, without side faces or depth.

**Found.** Both elements have their limits to $10^{{{functions}}}$ for a strip {very_long:g} times as long as wide. A
shorter one falls short like $1/t^2$, $t$ its half-length over its half-width: {short_ellipse:.1f} % of the line factor
is missing at $t$ = 3 with the semi-ellipse and {short_parabola:.1f} % with the parabola. In the middle of the solved
rollers half-width and pressure are Hertz's to $10^{{{solved}}}$, on one strip and on many, with either element. The
parabola's displacement is smaller than that of the semi-ellipse of equal load by $2qK \\cdot {lack:.5f}$; this is why
its approach on half-spaces is a little too small.
"""


def section() -> Section:
    """Return the limits of both elements' functions and of solved contacts."""
    of_functions, of_contacts = _functions(), [check for element in ELEMENTS for check in _contacts(element)]
    short = {element.name: 100.0 * (1.0 - _line_factor(element, 3.0) / element.line_factor) for element in ELEMENTS}
    text = _TEXT.format(
        own=100.0 * (1.0 - 1.0 / PRESSURE_FACTOR),
        wider=100.0 * (1.0 / PARABOLIC.hertz_ratio - 1.0),
        diameter=DIAMETER,
        line_load=LINE_LOAD,
        length=LENGTH,
        very_long=VERY_LONG,
        functions=_power(check for check in of_functions if check.tolerance == 1e-8),
        short_ellipse=short[SEMI_ELLIPTIC.name],
        short_parabola=short[PARABOLIC.name],
        solved=_power(of_contacts),
        lack=_LACK,
    )
    picture = Picture(
        "line-limits",
        "Left: how the curvature under a strip comes to that of a line contact as the strip gets longer; the thin "
        "lines are the asymptotes. Right: pressure across a line contact, both elements with the same load.",
        _draw,
    )
    title = "Line contact: limits of both elements (paper, Eqs. 59, 61, 62)"
    return Section(title, text, (*of_functions, *of_contacts), (picture,))


def _power(checks: Iterable[Check]) -> int:
    """Return the smallest power of ten that no difference exceeds."""
    return math.ceil(math.log10(max(abs(check.difference) for check in checks)))


def _line_factor(element: Element, t: float) -> float:
    """Return a^2 / (K q rho) of a single strip from -t to t half-widths."""
    return 2.0 * float(element.functions(t)[2])


def _functions() -> list[Check]:
    # A strip from -t to t lacks 1/t^2 of its line factor: a tolerance of 1e-8 is that of t = 1e4.
    half_width = 0.3
    curvature = 2.0 * STEEL.compliance * (4.0 / 3.0) * half_width * _line_factor(PARABOLIC, VERY_LONG)
    expected = 8.0 * (1.0 - STEEL.poisson) * half_width / (math.pi * STEEL.shear_modulus)
    claim = f"curvature coefficient of a parabolic strip with c = {half_width:g} mm, two steel bodies"
    checks = [Check(claim, "paper, Eq. (59)", expected, curvature, 1e-8, "mm^3/N")]
    for element in ELEMENTS:
        claim = f"{element.name}: a^2/(K q rho)"
        source = "Hertz" if element is SEMI_ELLIPTIC else "paper, Eqs. (32), (59)"
        checks.append(Check(claim, source, element.line_factor, _line_factor(element, VERY_LONG), 1e-8))
    for element in ELEMENTS:
        missing = LONG**2 * (element.line_factor - _line_factor(element, LONG))
        claim = f"{element.name}: what a^2/(K q rho) is short of its limit at t = {LONG:g}, times t^2"
        checks.append(Check(claim, "leading term of the series for large t", 1.0, missing, 1e-4))
    ellipse = 2.0 * float(SEMI_ELLIPTIC.functions(VERY_LONG)[0])
    parabola = 2.0 * float(PARABOLIC.functions(VERY_LONG * PARABOLIC.hertz_ratio)[0])
    claim = "displacement of the semi-ellipse less that of the parabola of equal load, over 2 q K"
    checks.append(Check(claim, "1/2 + ln 2 + ln(3/2)/2 - 4/3", _LACK, 0.5 * (ellipse - parabola), 1e-7))
    return checks


def _contacts(element: Element) -> list[Check]:
    checks = []
    for name, strips in (("one strip", 1), ("41 strips", 41), ("automatic grid", None)):
        solution = _solve(element, strips)
        middle = int(np.argmin(np.abs(solution.y)))
        # The sharp ends attract load; what is left in the middle decides.
        line_load, a = float(solution.line_load[middle]), float(solution.element_half_width[middle])
        half_width, pressure = float(solution.half_width[middle]), float(solution.centre_pressure[middle])
        hertz = _hertz(line_load)
        case = f"{element.name}, {name}"
        checks += [
            Check(f"{case}: half-width b", "Hertz's line contact", hertz.half_width, half_width, 1e-7, "mm"),
            Check(f"{case}: pressure p0", "Hertz's line contact", hertz.max_pressure, pressure, 1e-7, "MPa"),
        ]
        if element is PARABOLIC and strips == 1:
            of_summit = PRESSURE_FACTOR * (0.75 * line_load / a**3) * a**2
            limit = math.sqrt(6.0 * 2.0 * STEEL.compliance * line_load * 0.5 * DIAMETER)
            checks += [
                Check(f"{case}: c", "sqrt(6 K q rho), from Eq. (59)", limit, a, 1e-7, "mm"),
                Check(f"{case}: b of c", "paper, Eq. (61)", math.sqrt(2.0 / 3.0) * a, half_width, 1e-12, "mm"),
                Check(f"{case}: p0 of s and c", "paper, Eq. (62)", of_summit, pressure, 1e-12, "MPa"),
            ]
    return checks


def _solve(element: Element, strips: int | None) -> Solution:
    roller = Roller(diameter=DIAMETER, length=LENGTH, material=STEEL, side_faces="none", depth="none")
    contact = Contact(roller, Plate(material=STEEL))
    return solve(contact, load=LINE_LOAD * LENGTH, element=element, strips=strips)


def _hertz(line_load: float) -> LineContact:
    return line_contact(line_load=line_load, radius=0.5 * DIAMETER, compliance=2.0 * STEEL.compliance)


def _draw(figure: Figure) -> None:
    left, right = figure.subplots(1, 2)
    t = np.geomspace(0.1, 100.0, 301)
    x = np.sin(np.linspace(-0.5 * np.pi, 0.5 * np.pi, 301))  # of the element's half-width
    shapes = {SEMI_ELLIPTIC.name: np.sqrt(1.0 - x**2), PARABOLIC.name: (1.0 - x**2) / PRESSURE_FACTOR}
    for element, colour, dashes in zip(ELEMENTS, (FIRST, SECOND), ("-", "--"), strict=True):
        b = element.functions(t)[2]
        left.semilogx(t, 2.0 * b / element.line_factor, color=colour, linestyle=dashes, label=element.name)
        far = t[t > 0.7]
        left.semilogx(far, 1.0 - 1.0 / (element.line_factor * far**2), color=colour, linestyle=":", linewidth=0.7)
        right.plot(x / element.hertz_ratio, shapes[element.name], color=colour, linestyle=dashes, label=element.name)
    left.axhline(1.0, color=FAINT_INK, linewidth=0.5)
    left.set(
        xlabel="half-length / half-width of the strip", ylabel="curvature / that of a line", xlim=(0.1, 100.0),
        ylim=(0.0, 1.08),
    )  # fmt: skip
    right.set(xlabel="x / b", ylabel="pressure / $p_0$ of Hertz", ylim=(0.0, 1.08))
    left.legend(loc="lower right")
    right.legend(loc="lower center")
