"""How deep a long cylinder is: the depth at which it is compressed as in plane strain (paper, section 6).

The depth is found by root finding, without any formula for it, and set beside the closed forms.
"""

from __future__ import annotations

from collections.abc import Iterator

from scipy.optimize import brentq

from nonhertz.bodies.depths.plane_strain import plane_strain_depth
from nonhertz.hertz import line_contact, plane_strain_cylinder_compression
from nonhertz.model.body import Roller
from nonhertz.model.contact import Contact
from nonhertz.model.material import Material
from nonhertz.solver.one import solve
from nonhertz.strip.element import PARABOLIC, SEMI_ELLIPTIC, Element
from nonhertz.verify.claim import Claim

TITLE = "Plane strain: how deep a cylinder is (paper, section 6)"
MODULUS = 206000.0
LENGTH = 100.0  # diameters
STRIPS = 11
JOHNSON = "Johnson 1985, Eq. (5.57): q K (2 ln(4R/b) - 1)"
# Diameter [mm] and load per length [N/mm].
SIZES = ((1.0, 10.0), (10.0, 1e3), (100.0, 1e5), (10.0, 1e4))


def compression(diameter: float, line_load: float, poisson: float) -> float:
    """Return the approach of two equal cylinders in plane strain [mm]."""
    material = Material(MODULUS, poisson)
    line = line_contact(line_load=line_load, radius=0.25 * diameter, compliance=2.0 * material.compliance)
    return 2.0 * plane_strain_cylinder_compression(line, diameter=diameter, material=material)


def approach(element: Element, diameter: float, line_load: float, poisson: float, depth: float | str) -> float:
    """Return the approach on strips, measured against a depth [mm]."""
    length, material = LENGTH * diameter, Material(MODULUS, poisson)
    roller = Roller(diameter=diameter, length=length, material=material, side_faces="mirror", depth=depth)
    return solve(Contact(roller, roller), load=line_load * length, element=element, strips=STRIPS).approach


def depth_found(element: Element, diameter: float, line_load: float, poisson: float) -> float:
    """Return the depth at which the approach is that of plane strain [mm]."""
    exact = compression(diameter, line_load, poisson)

    def off(ratio: float) -> float:
        return approach(element, diameter, line_load, poisson, ratio * diameter) - exact

    return float(brentq(off, 0.2, 5.0, xtol=1e-7)) * diameter


def claims() -> Iterator[Claim]:
    """Yield the claims."""
    for element in (SEMI_ELLIPTIC, PARABOLIC):
        for poisson in (0.0, 0.15, 0.3, 0.45):
            for diameter, line_load in SIZES:
                yield from _of_case(element, diameter, line_load, poisson)


def _of_case(element: Element, diameter: float, line_load: float, poisson: float) -> Iterator[Claim]:
    case = f"{element.name}, nu {poisson:g}, D {diameter:g} mm, {line_load:g} N/mm"
    given = (element, diameter, line_load, poisson)
    yield Claim(
        f"approach with the default depth: {case}", JOHNSON, compression(*given[1:]),
        lambda: approach(*given, "plane-strain"), 1e-3, "mm",
    )  # fmt: skip
    yield Claim(
        f"depth over diameter: {case}", "closed form above", lambda: plane_strain_depth(element, poisson),
        lambda: depth_found(*given) / diameter, 1e-3,
    )  # fmt: skip
