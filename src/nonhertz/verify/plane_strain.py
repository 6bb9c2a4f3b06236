"""Section 6 of the paper: the depth at which a long cylinder is compressed as in plane strain."""

from __future__ import annotations

import functools
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from nonhertz.bodies.depths.plane_strain import plane_strain_depth
from nonhertz.hertz import line_contact, plane_strain_cylinder_compression
from nonhertz.model.body import Roller
from nonhertz.model.contact import Contact
from nonhertz.model.material import Material
from nonhertz.solver.one import solve
from nonhertz.strip.element import PARABOLIC, SEMI_ELLIPTIC, Element
from nonhertz.verify.claim import Check, Picture, Section

if TYPE_CHECKING:
    from matplotlib.figure import Figure

MODULUS = 206000.0
LENGTH = 100.0  # diameters
STRIPS = 11
ELEMENTS = (SEMI_ELLIPTIC, PARABOLIC)
CASES = tuple(
    (diameter, line_load * diameter, poisson)
    for poisson in (0.0, 0.15, 0.3, 0.45)
    for diameter, line_load in ((1.0, 10.0), (10.0, 100.0), (100.0, 1000.0), (10.0, 1000.0))
)
_JOHNSON = "Johnson 1985, Eq. (5.57): q K (2 ln(4R/b) - 1)"
_TEXT = """\
A long solid cylinder, loaded along a line and along the line opposite, is compressed from its centre to the contact
by $q K (2 \\ln(4R/b) - 1)$ in plane strain. The paper measures the displacement of a half-space against a point at
depth $d$ and takes $d = D$, the diameter; de Mul and van Engelenburg had 3/4 of it. Here two equal cylinders, 100
diameters long and with free ends, are pressed together. The depth at which their approach is exactly that of plane
strain is found by root finding, without any formula for it, and set beside the closed forms

- semi-elliptic: $d = D \\exp(-1/2 + \\nu/(2(1-\\nu)))$
- parabolic: $d = \\sqrt 6 D \\exp(-11/6 + 1/(2(1-\\nu)))$

**Found.** The depth is proportional to the diameter and independent of the load, as the closed forms say. It depends
on Poisson's ratio and on the element: {low:.3f} to {high:.3f} D. At $\\nu$ = 0.3 it is {ellipse:.4f} D for the
semi-ellipse, so 3/4 D is right for steel and that element, and {parabola:.4f} D for the parabola. The paper's $d = D$
makes a steel cylinder too soft: in the cases below the approach comes out {soft_low:.1f} to {soft_high:.1f} % too
large with the semi-ellipse, {parabolic_low:.1f} to {parabolic_high:.1f} % with the parabola.

| element | nu | D (mm) | q (N/mm) | depth found / D | closed form / D | approach with D | approach with 3/4 D |
|---|---:|---:|---:|---:|---:|---:|---:|
{table}
"""


@dataclass(frozen=True)
class _Found:
    """The results of one case."""

    element: Element
    diameter: float
    line_load: float
    poisson: float
    depth: float
    by_default: float
    by_diameter: float
    by_three_quarters: float
    exact: float


def section() -> Section:
    """Return the comparison for several diameters, loads and Poisson's ratios, and both elements."""
    found = [_find(element, *case) for element in ELEMENTS for case in CASES]
    checks = [check for one in found for check in _checks(one)]
    ratios = [one.depth / one.diameter for one in found]
    steel = [one for one in found if one.poisson == 0.3]
    soft = {
        element.name: [100.0 * (one.by_diameter / one.exact - 1.0) for one in steel if one.element is element]
        for element in ELEMENTS
    }
    text = _TEXT.format(
        table="\n".join(_row(one) for one in found),
        low=min(ratios),
        high=max(ratios),
        ellipse=plane_strain_depth(SEMI_ELLIPTIC, 0.3),
        parabola=plane_strain_depth(PARABOLIC, 0.3),
        soft_low=min(soft["semi-elliptic"]),
        soft_high=max(soft["semi-elliptic"]),
        parabolic_low=min(soft["parabolic"]),
        parabolic_high=max(soft["parabolic"]),
    )
    picture = Picture(
        "plane-strain-depth",
        "Depth over diameter that makes a long cylinder's compression that of plane strain: found numerically "
        "(dots), closed forms (lines), the paper's D and the 3/4 D of de Mul and van Engelenburg.",
        functools.partial(_draw, found),
    )
    return Section("Plane strain: how deep a cylinder is (paper, section 6)", text, tuple(checks), (picture,))


def _find(element: Element, diameter: float, line_load: float, poisson: float) -> _Found:
    from scipy.optimize import brentq

    material = Material(MODULUS, poisson)
    line = line_contact(line_load=line_load, radius=0.25 * diameter, compliance=2.0 * material.compliance)
    exact = 2.0 * plane_strain_cylinder_compression(line, diameter=diameter, material=material)

    def approach(depth: float | str) -> float:
        roller = Roller(
            diameter=diameter, length=LENGTH * diameter, material=material, side_faces="mirror", depth=depth
        )
        load = line_load * LENGTH * diameter
        return solve(Contact(roller, roller), load=load, element=element, strips=STRIPS).approach

    depth = brentq(lambda ratio: approach(ratio * diameter) - exact, 0.2, 5.0, xtol=1e-7)
    return _Found(
        element, diameter, line_load, poisson, depth * diameter,
        by_default=approach("plane-strain"), by_diameter=approach("diameter"),
        by_three_quarters=approach(0.75 * diameter), exact=exact,
    )  # fmt: skip


def _checks(found: _Found) -> list[Check]:
    case = f"{found.element.name}, nu {found.poisson:g}, D {found.diameter:g} mm, {found.line_load:g} N/mm"
    closed = plane_strain_depth(found.element, found.poisson)
    return [
        Check(f"approach with the default depth: {case}", _JOHNSON, found.exact, found.by_default, 1e-3, "mm"),
        Check(f"depth over diameter: {case}", "closed form above", closed, found.depth / found.diameter, 1e-3),
    ]


def _row(found: _Found) -> str:
    cells = (
        found.element.name,
        f"{found.poisson:g}",
        f"{found.diameter:g}",
        f"{found.line_load:g}",
        f"{found.depth / found.diameter:.4f}",
        f"{plane_strain_depth(found.element, found.poisson):.4f}",
        f"{100.0 * (found.by_diameter / found.exact - 1.0):+.1f} %",
        f"{100.0 * (found.by_three_quarters / found.exact - 1.0):+.1f} %",
    )
    return "| " + " | ".join(cells) + " |"


def _draw(found: list[_Found], figure: Figure) -> None:
    axes = figure.add_subplot()
    poisson = np.linspace(0.0, 0.5, 101)
    for element, colour, marker in zip(ELEMENTS, ("#0072B2", "#D55E00"), ("o", "s"), strict=True):
        closed = [plane_strain_depth(element, float(nu)) for nu in poisson]
        axes.plot(poisson, closed, color=colour, label=f"{element.name}, closed form")
        dots = [(one.poisson, one.depth / one.diameter) for one in found if one.element is element]
        axes.plot(*zip(*dots, strict=True), marker, color=colour, mfc="none", label=f"{element.name}, found")
    axes.axhline(1.0, color="#777777", linestyle="--", label="paper: D")
    axes.axhline(0.75, color="#777777", linestyle=":", label="de Mul and van Engelenburg: 3/4 D")
    axes.set(xlabel="Poisson's ratio", ylabel="depth / diameter", xlim=(0.0, 0.5))
    axes.legend()
