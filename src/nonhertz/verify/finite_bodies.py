"""Side faces and depth in their limits, and against a second program."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from nonhertz.hertz import LineContact, line_contact, plane_strain_cylinder_compression
from nonhertz.model.body import Body, Plate, Roller
from nonhertz.model.contact import Contact
from nonhertz.model.material import Material
from nonhertz.model.profile import crown
from nonhertz.result.solution import EdgeKind, Solution
from nonhertz.solver.one import solve
from nonhertz.strip.element import PARABOLIC, SEMI_ELLIPTIC, Element
from nonhertz.verify.claim import Claim, solved

TITLE = "Side faces and depth: limits"
STEEL = Material(206000.0, 0.3)
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


def claims() -> Iterator[Claim]:
    """Yield the claims."""
    yield from _far_away("faces far away", length=FAR, side_faces="mirror", depth="none")
    yield from _far_away("depth far away", length=None, side_faces="none", depth=FAR)
    for element in (SEMI_ELLIPTIC, PARABOLIC):
        for grid, strips in (("41 strips", 41), ("automatic strips", None)):
            for images, words in ((1, "one image per face"), ("series", "all images")):
                yield _uniform(f"coincident ends, {element.name}, {grid}, {words}", element, strips, images)
    yield Claim(
        "coincident ends, all images: approach", "plane strain",
        2.0 * plane_strain_cylinder_compression(line(), diameter=DIAMETER, material=STEEL),
        lambda: pair(images="series").approach, 1e-5, "mm",
    )  # fmt: skip
    for number, approach in SECOND_PROGRAM.items():
        yield _as_elsewhere(number, approach)
    yield Claim(
        "faces of a roller a thousand times stiffer than the plate: approach", "share of the compliance",
        lambda: _stiff("none").approach, lambda: _stiff("mirror").approach, 1e-3, "mm",
    )  # fmt: skip
    yield from _too_heavy()


@solved
def _crowned(**extent: Any) -> Solution:
    body = Body(diameter=20.0, effective_length=20.0, profile=crown(4000.0), material=STEEL, **extent)
    return solve(Contact(body, Plate(material=STEEL)), load=3000.0)


def _far_away(name: str, **extent: Any) -> Iterator[Claim]:
    def near() -> Solution:
        return _crowned(length=None, side_faces="none", depth="none")

    def far() -> Solution:
        return _crowned(**extent)

    def change() -> float:
        highest = near().max_pressure
        return float(np.max(np.abs(far().centre_pressure / highest - near().centre_pressure / highest)))

    source = "nothing changes"
    yield Claim(f"{name}: approach", source, lambda: near().approach, lambda: far().approach, 1e-6, "mm")
    yield Claim(f"{name}: largest change of pressure, of the maximum", source, 0.0, change, 1e-6, absolute=True)
    yield Claim(
        f"{name}: stiffness", source, lambda: near().stiffness[0, 0], lambda: far().stiffness[0, 0], 1e-6, "N/mm"
    )


def _uniform(case: str, element: Element, strips: int | None, images: int | str) -> Claim:
    hertz = line().max_pressure

    def worst() -> float:
        off = np.abs(pair(element, strips, images=images).centre_pressure / hertz - 1.0)
        return hertz * (1.0 + float(np.max(off)))

    return Claim(f"{case}: pressure at the worst strip", "Hertz's line contact", hertz, worst, 1e-3, "MPa")


def _as_elsewhere(images: int, approach: float) -> Claim:
    return Claim(
        f"coincident ends, parabolic, 41 strips, {images} images per face: approach", "a second program", approach,
        lambda: 1e3 * pair(PARABOLIC, 41, images=images).approach, 0.6e-4, "um", absolute=True, why="its last digit",
    )  # fmt: skip


def _stiff(faces: str) -> Solution:
    stiff = Material(1e3 * STEEL.modulus, STEEL.poisson)
    roller = Roller(diameter=20.0, length=20.0, material=stiff, side_faces=faces, depth="none")
    return solve(Contact(roller, Plate(material=STEEL)), load=20000.0)


def _too_heavy() -> Iterator[Claim]:
    """Yield that image weights of more than kappa = 1, which have no solution, are lowered, with warnings."""

    def heavy() -> Solution:
        return pair(side_faces="calibrated")

    case = "kappa 1.6 at both ends"
    yield Claim(
        f"{case}: warnings", "one for each end", 2.0,
        lambda: sum("weights were lowered" in sentence for sentence in heavy().warnings), 0.0,
    )  # fmt: skip
    yield Claim(
        f"{case}: ends reported as finite", "kappa lowered to 1", 2.0,
        lambda: sum(edge.kind is EdgeKind.FINITE for edge in heavy().edge_pressure), 0.0,
    )  # fmt: skip
    yield Claim(
        f"{case}: end pressure", "that of weight 1", lambda: pair(side_faces="mirror").edge_pressure[1].pressure,
        lambda: heavy().edge_pressure[1].pressure, 1e-9, "MPa",
    )  # fmt: skip
