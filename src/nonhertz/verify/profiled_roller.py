"""A profiled roller on an inner ring, of the kind of Figs. 6 and 7 of the paper, and the complete model elsewhere.

The profile measured in the paper is not published as numbers: a stand-in with a straight middle and tangential arcs is
judged by laws. Compared digit by digit is the same roller with the profile of ISO 16281, with a second program.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from nonhertz.hertz import LineContact, line_contact
from nonhertz.model.body import Ring, Roller
from nonhertz.model.contact import Contact
from nonhertz.model.material import Material
from nonhertz.model.profile import Profile, iso_logarithmic, partial_crown
from nonhertz.result.solution import EdgeKind, Solution
from nonhertz.solver.one import solve
from nonhertz.strip.element import PARABOLIC, SEMI_ELLIPTIC, Element
from nonhertz.verify.claim import Claim, middle, solved

TITLE = "A profiled roller on an inner ring (paper, Figs. 6 and 7)"
STEEL = Material(206000.0, 0.3)
DIAMETER, LENGTH = 15.0, 16.0  # of the roller [mm]
RING_DIAMETER, RING_WIDTH = 60.0, 24.0
STRAIGHT, ARC = 8.0, 300.0  # length of the straight middle and radius of the arcs beside it [mm]
LOAD, TILT = 20e3, 3e-4


@dataclass(frozen=True)
class Strip:
    """One strip of the second program: summit s [N/mm^4], c [mm] and q [N/mm]."""

    index: int
    summit: float
    c: float
    line_load: float | None = None


@dataclass(frozen=True)
class Reference:
    """What the second program gives for one tilt [rad]: approach [um], moment [N mm], greatest p0 [MPa]."""

    tilt: float
    approach: float
    strips: tuple[Strip, ...]
    moment: float | None = None
    max_pressure: float | None = None


REFERENCES = (
    Reference(
        0.0, 36.073143,
        (Strip(20, 19837.238, 0.3736208, 1379.4721), Strip(10, 20169.573, 0.3676501),
         Strip(0, 37338.522, 0.1897751, 340.262), Strip(40, 37338.522, 0.1897751, 340.262)),
    ),
    Reference(
        5e-4, 36.050388,
        (Strip(0, 53698.568, 0.1285860), Strip(20, 19846.241, 0.3734516), Strip(40, 30321.068, 0.2391015)),
        moment=8942.016, max_pressure=2932.827,
    ),
)  # fmt: skip
_STRIPS = 41
_HALF_DIGIT = 0.501  # a half, and a little for binary rounding
_SECOND_PROGRAM = "a second implementation, complete model"


def contact(profile: Profile | None = None, depth: str = "plane-strain") -> Contact:
    """Return the roller on its ring, by default with the stand-in profile."""
    shape = profile or partial_crown(ARC, STRAIGHT)
    finite = {"material": STEEL, "side_faces": "mirror", "depth": depth}
    roller = Roller(diameter=DIAMETER, length=LENGTH, profile=shape, **finite)  # type: ignore[arg-type]
    return Contact(roller, Ring(diameter=RING_DIAMETER, length=RING_WIDTH, **finite))  # type: ignore[arg-type]


@solved
def stand_in(element: Element = SEMI_ELLIPTIC, tilt: float = 0.0) -> Solution:
    """Return the stand-in solved."""
    return solve(contact(), load=LOAD, element=element, tilt=tilt)


@solved
def _elsewhere(tilt: float) -> Solution:
    with_logarithm = contact(iso_logarithmic(diameter=DIAMETER, length=LENGTH), "diameter")
    return solve(with_logarithm, load=LOAD, tilt=tilt, element=PARABOLIC, strips=_STRIPS)


def claims() -> Iterator[Claim]:
    """Yield the claims."""
    yield from _laws()
    yield from _both_elements()
    yield from _tilted()
    for reference in REFERENCES:
        yield from _second_program(reference)


def _hertz() -> LineContact:
    curvature = 2.0 / DIAMETER + 2.0 / RING_DIAMETER
    line_load = middle(stand_in(), "line_load")
    return line_contact(line_load=line_load, radius=1.0 / curvature, compliance=2.0 * STEEL.compliance)


def _laws() -> Iterator[Claim]:
    def asymmetry() -> float:
        pressure = stand_in().centre_pressure
        return float(np.max(np.abs(pressure - pressure[::-1]))) / stand_in().max_pressure

    name, source = "stand-in", "Hertz's line contact under the line load there"
    why = "were the rollers cut off at the end of the contact, 26 half-widths away, the half-width would be 2e-4 less"
    yield Claim(
        f"{name}: load that the strips carry", "equilibrium", LOAD,
        lambda: float(np.sum(stand_in().line_load * stand_in().strip_width)), 1e-9, "N",
    )  # fmt: skip
    yield Claim(f"{name}: moment", "symmetry", 0.0, lambda: stand_in().moment, 1e-6, "N mm", absolute=True)
    yield Claim(
        f"{name}: largest difference of p(y) and p(-y), of the greatest pressure", "symmetry", 0.0, asymmetry, 1e-9,
        absolute=True,
    )  # fmt: skip
    yield Claim(
        f"{name}: half-width in the middle", source, lambda: _hertz().half_width,
        lambda: middle(stand_in(), "half_width"), 5e-4, "mm", why=why,
    )  # fmt: skip
    yield Claim(
        f"{name}: pressure in the middle", source, lambda: _hertz().max_pressure,
        lambda: middle(stand_in(), "centre_pressure"), 5e-4, "MPa", why=why,
    )  # fmt: skip
    yield Claim(
        f"{name}: ends where the pressure runs out", "the stand-in is made so", 2.0,
        lambda: sum(edge.kind is EdgeKind.RUN_OUT for edge in stand_in().edge_pressure), 0.0,
    )  # fmt: skip
    yield Claim(
        f"{name}: distance of the greatest pressure from the middle", "where the arcs begin", 0.5 * STRAIGHT,
        lambda: abs(stand_in().max_pressure_y), 0.5, "mm", absolute=True,
    )  # fmt: skip


def _both_elements() -> Iterator[Claim]:
    def claim(what: str, quantity: str, tolerance: float, unit: str, *, in_middle: bool = False) -> Claim:
        def of(element: Element) -> float:
            solution = stand_in(element)
            return middle(solution, quantity) if in_middle else float(getattr(solution, quantity))

        return Claim(
            f"stand-in, parabolic: {what}", "semi-elliptic strips", lambda: of(SEMI_ELLIPTIC), lambda: of(PARABOLIC),
            tolerance, unit,
            why="the parabola's bias in an elliptical contact as slender is 0.4 % of pressure and 1 % of approach; in "
            "the middle of a line contact there is none",
        )  # fmt: skip

    yield claim("approach", "approach", 1e-2, "mm")
    yield claim("greatest pressure", "max_pressure", 4e-3, "MPa")
    yield claim("pressure in the middle", "centre_pressure", 2e-3, "MPa", in_middle=True)
    yield claim("half-width in the middle", "half_width", 2e-3, "mm", in_middle=True)


def _tilted() -> Iterator[Claim]:
    def tilted(sign: float = 1.0) -> Solution:
        return stand_in(SEMI_ELLIPTIC, sign * TILT)

    def carried() -> float:
        return float(np.sum(tilted().line_load * tilted().strip_width * tilted().y))

    name, mirrored = f"stand-in, {1e3 * TILT:g} mrad", "that of the opposite tilt"
    yield Claim(f"{name}: moment of the strips", "equilibrium", carried, lambda: tilted().moment, 1e-9, "N mm")
    yield Claim(f"{name}: approach", mirrored, lambda: tilted(-1.0).approach, lambda: tilted().approach, 1e-9, "mm")
    yield Claim(
        f"{name}: moment", f"{mirrored}, turned", lambda: -tilted(-1.0).moment, lambda: tilted().moment, 1e-6, "N mm"
    )


def _second_program(reference: Reference) -> Iterator[Claim]:
    case = f"ISO profile, {1e3 * reference.tilt:g} mrad"

    def claim(name: str, expected: float, found: Callable[[], float], decimals: int, unit: str) -> Claim:
        tolerance = _HALF_DIGIT * 10.0**-decimals
        return Claim(f"{case}: {name}", _SECOND_PROGRAM, expected, found, tolerance, unit, absolute=True)

    def of_strip(strip: Strip) -> Iterator[Claim]:
        def q() -> float:
            return float(_elsewhere(reference.tilt).line_load[strip.index])

        def c() -> float:
            return float(_elsewhere(reference.tilt).element_half_width[strip.index])

        place = f"at y = {(strip.index - _STRIPS // 2) * LENGTH / _STRIPS:.4f} mm"
        yield claim(f"summit s {place}", strip.summit, lambda: 0.75 * q() / c() ** 3, 3, "N/mm^4")
        yield claim(f"c {place}", strip.c, c, 7, "mm")
        if strip.line_load is not None:
            yield claim(f"line load {place}", strip.line_load, q, 4 if strip.index == 20 else 3, "N/mm")

    yield claim("approach", reference.approach, lambda: 1e3 * _elsewhere(reference.tilt).approach, 6, "um")
    for strip in reference.strips:
        yield from of_strip(strip)
    if reference.moment is not None:
        yield claim("moment", reference.moment, lambda: _elsewhere(reference.tilt).moment, 3, "N mm")
    if reference.max_pressure is not None:
        yield Claim(
            f"{case}: greatest pressure", _SECOND_PROGRAM, reference.max_pressure,
            lambda: _elsewhere(reference.tilt).max_pressure, 5e-6, "MPa",
            why="it has 1.0396 for 4 sqrt(6) / (3 pi), 4e-6 more",
        )  # fmt: skip
