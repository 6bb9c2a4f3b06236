"""Side faces and depth in their limits and against a second program, and how deep a long cylinder is."""

from __future__ import annotations

import functools
from collections.abc import Iterator
from typing import Any

import numpy as np
from scipy.optimize import brentq

from claims.claim import Claim, Evidence, solved
from nonhertz import PARABOLIC, SEMI_ELLIPTIC, Body, Contact, EdgeKind, Material, Plate, Roller, Solution, solve
from nonhertz.bodies.depths import plane_strain_depth
from nonhertz.hertz import LineContact, line_contact, plane_strain_cylinder_compression
from nonhertz.model.profile import crown
from nonhertz.strip.element import Element

MODULUS = 206000.0
STEEL = Material(MODULUS, 0.3)
DIAMETER, LOAD = 10.0, 10000.0  # of the coincident pair, with a length of one diameter
FAR = 1e7  # mm
# Approach [um] of the pair with the parabola, by number of images, from an independently written program.
SECOND_PROGRAM = {1: 24.1905, 2: 24.1098, 4: 24.0871, 10: 24.0813, 40: 24.0804}


def line() -> LineContact:
    """Return Hertz's contact of the pair."""
    return line_contact(line_load=LOAD / DIAMETER, radius=0.25 * DIAMETER, compliance=2.0 * STEEL.compliance)


@solved
def pair(element: Element = SEMI_ELLIPTIC, strips: int | None = None, **rules: Any) -> Solution:
    """Return two equal straight rollers whose ends coincide."""
    roller = Roller(diameter=DIAMETER, length=DIAMETER, material=STEEL, **{"side_faces": "mirror"} | rules)
    return solve(Contact(roller, roller), load=LOAD, element=element, strips=strips)


def limits() -> Iterator[Claim]:
    """Yield the claims about side faces and depth."""
    yield from _far_away("faces far away", length=FAR, side_faces="mirror", depth="none")
    yield from _far_away("depth far away", length=None, side_faces="none", depth=FAR)
    for element in (SEMI_ELLIPTIC, PARABOLIC):
        for grid, strips in (("41 strips", 41), ("automatic strips", None)):
            for images, words in ((1, "one image per face"), ("series", "all images")):
                of = Evidence(
                    f"coincident ends, {element.name}, {grid}, {words}", "Hertz's line contact",
                    functools.partial(pair, element, strips, images=images),
                )  # fmt: skip
                hertz = line().max_pressure
                yield of.claim("pressure at the worst strip", _worst_pressure, 1e-3, "MPa", expected=hertz)
    yield Claim(
        "coincident ends, all images: approach", "plane strain",
        2.0 * plane_strain_cylinder_compression(line(), diameter=DIAMETER, material=STEEL),
        lambda: pair(images="series").approach, 1e-5, "mm",
    )  # fmt: skip
    for images, approach in SECOND_PROGRAM.items():
        of = Evidence(
            f"coincident ends, parabolic, 41 strips, {images} images per face", "a second program",
            functools.partial(pair, PARABOLIC, 41, images=images),
        )  # fmt: skip
        yield of.claim(
            "approach", lambda found: 1e3 * found.approach, 0.6e-4, "um", expected=approach, absolute=True,
            why="its last digit",
        )  # fmt: skip
    yield Claim(
        "faces of a roller a thousand times stiffer than the plate: approach", "share of the compliance",
        lambda: _stiff("none").approach, lambda: _stiff("mirror").approach, 1e-3, "mm",
    )  # fmt: skip
    # Image weights of more than kappa = 1, which have no solution, are lowered, with warnings.
    of = Evidence(
        "kappa 1.6 at both ends", "that of weight 1", lambda: pair(side_faces="calibrated"),
        lambda: pair(side_faces="mirror"),
    )  # fmt: skip
    yield of.claim(
        "warnings", lambda found: sum("weights were lowered" in sentence for sentence in found.warnings), 0.0,
        expected=2.0, source="one for each end",
    )  # fmt: skip
    yield of.claim(
        "ends reported as finite", lambda found: sum(edge.kind is EdgeKind.FINITE for edge in found.edge_pressure), 0.0,
        expected=2.0, source="kappa lowered to 1",
    )  # fmt: skip
    yield of.claim("end pressure", lambda found: found.edge_pressure[1].pressure, 1e-9, "MPa")


@solved
def _crowned(**extent: Any) -> Solution:
    body = Body(diameter=20.0, effective_length=20.0, profile=crown(4000.0), material=STEEL, **extent)
    return solve(Contact(body, Plate(material=STEEL)), load=3000.0)


def _far_away(name: str, **extent: Any) -> Iterator[Claim]:
    near = functools.partial(_crowned, length=None, side_faces="none", depth="none")

    def change(far: Solution) -> float:
        highest = near().max_pressure
        return float(np.max(np.abs(far.centre_pressure / highest - near().centre_pressure / highest)))

    of = Evidence(name, "nothing changes", functools.partial(_crowned, **extent), near)
    yield of.claim("approach", "approach", 1e-6, "mm")
    yield of.claim("largest change of pressure, of the maximum", change, 1e-6, expected=0.0)
    yield of.claim("stiffness", lambda found: found.stiffness[0, 0], 1e-6, "N/mm")


def _worst_pressure(solution: Solution) -> float:
    """Return the pressure that differs most from Hertz's, were it higher."""
    hertz = line().max_pressure
    return hertz * (1.0 + float(np.max(np.abs(solution.centre_pressure / hertz - 1.0))))


def _stiff(faces: str) -> Solution:
    stiff = Material(1e3 * STEEL.modulus, STEEL.poisson)
    roller = Roller(diameter=20.0, length=20.0, material=stiff, side_faces=faces, depth="none")
    return solve(Contact(roller, Plate(material=STEEL)), load=20000.0)


# The depth at which a long cylinder is compressed as in plane strain (paper, section 6): found without any formula for
# it, and set beside the closed forms.

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


def plane_strain() -> Iterator[Claim]:
    """Yield the claims about long cylinders."""
    for element in (SEMI_ELLIPTIC, PARABOLIC):
        for poisson in (0.0, 0.15, 0.3, 0.45):
            for diameter, line_load in SIZES:
                yield from _of_size(element, diameter, line_load, poisson)


def _of_size(element: Element, diameter: float, line_load: float, poisson: float) -> Iterator[Claim]:
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
