"""A profiled roller on an inner ring, of the kind of Figs. 6 and 7 of the paper, and the complete model elsewhere.

The profile measured in the paper is not published as numbers: a stand-in with a straight middle and tangential arcs is
judged by laws. Compared digit by digit is the same roller with the profile of ISO 16281, with a second program.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from nonhertz.hertz import LineContact, line_contact
from nonhertz.model.body import Ring, Roller
from nonhertz.model.contact import Contact
from nonhertz.model.material import Material
from nonhertz.model.profile import Profile, iso_logarithmic, partial_crown
from nonhertz.result.solution import EdgeKind, Solution
from nonhertz.solver.one import solve
from nonhertz.strip.element import PARABOLIC, SEMI_ELLIPTIC, Element
from nonhertz.verify.claim import Claim, Evidence, in_middle, solved

TITLE = "A profiled roller on an inner ring (paper, Figs. 6 and 7)"
STEEL = Material(206000.0, 0.3)
DIAMETER, LENGTH = 15.0, 16.0  # of the roller [mm]
RING_DIAMETER, RING_WIDTH = 60.0, 24.0
STRAIGHT, ARC = 8.0, 300.0  # length of the straight middle and radius of the arcs beside it [mm]
LOAD, TILT = 20e3, 3e-4


# What the second program gives, by tilt [rad]; of strips by their number. The summit s of a strip is
# p = s (c^2 - x^2), so that q = 4/3 s c^3. All digits are met.
SECOND_PROGRAM = {
    0.0: (
        ("approach", None, "36.073143"),
        ("summit s", 20, "19837.238"), ("c", 20, "0.3736208"), ("line load", 20, "1379.4721"),
        ("summit s", 10, "20169.573"), ("c", 10, "0.3676501"),
        ("summit s", 0, "37338.522"), ("c", 0, "0.1897751"), ("line load", 0, "340.262"),
        ("summit s", 40, "37338.522"), ("c", 40, "0.1897751"), ("line load", 40, "340.262"),
    ),
    5e-4: (
        ("approach", None, "36.050388"),
        ("summit s", 0, "53698.568"), ("c", 0, "0.1285860"),
        ("summit s", 20, "19846.241"), ("c", 20, "0.3734516"),
        ("summit s", 40, "30321.068"), ("c", 40, "0.2391015"),
        ("moment", None, "8942.016"),
    ),
}  # fmt: skip
QUANTITIES: dict[str, tuple[str, Callable[..., Any]]] = {
    "approach": ("um", lambda found, i: 1e3 * found.approach),
    "moment": ("N mm", lambda found, i: found.moment),
    "summit s": ("N/mm^4", lambda found, i: 0.75 * found.line_load[i] / found.element_half_width[i] ** 3),
    "c": ("mm", lambda found, i: found.element_half_width[i]),
    "line load": ("N/mm", lambda found, i: found.line_load[i]),
}
TILTED_MAX_PRESSURE = 2932.827  # MPa, by the second program at the larger tilt
_STRIPS = 41


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
    for tilt in SECOND_PROGRAM:
        yield from _by_second_program(tilt)


def _hertz() -> LineContact:
    curvature = 2.0 / DIAMETER + 2.0 / RING_DIAMETER
    line_load = in_middle("line_load")(stand_in())
    return line_contact(line_load=line_load, radius=1.0 / curvature, compliance=2.0 * STEEL.compliance)


def _asymmetry(solution: Solution) -> float:
    pressure = solution.centre_pressure
    return float(np.max(np.abs(pressure - pressure[::-1]))) / solution.max_pressure


def _laws() -> Iterator[Claim]:
    of = Evidence("stand-in", "Hertz's line contact under the line load there", stand_in)
    why = "were the rollers cut off at the end of the contact, 26 half-widths away, the half-width would be 2e-4 less"
    yield of.claim(
        "load that the strips carry", lambda found: np.sum(found.line_load * found.strip_width), 1e-9, "N",
        expected=LOAD, source="equilibrium",
    )  # fmt: skip
    yield of.claim("moment", "moment", 1e-6, "N mm", expected=0.0, source="symmetry", absolute=True)
    yield of.claim(
        "largest difference of p(y) and p(-y), of the greatest pressure", _asymmetry, 1e-9, expected=0.0,
        source="symmetry", absolute=True,
    )  # fmt: skip
    yield of.claim(
        "half-width in the middle", in_middle("half_width"), 5e-4, "mm", expected=lambda: _hertz().half_width, why=why
    )
    yield of.claim(
        "pressure in the middle", in_middle("centre_pressure"), 5e-4, "MPa", expected=lambda: _hertz().max_pressure,
        why=why,
    )  # fmt: skip
    yield of.claim(
        "ends where the pressure runs out", lambda found: sum(e.kind is EdgeKind.RUN_OUT for e in found.edge_pressure),
        0.0, expected=2.0, source="the stand-in is made so",
    )  # fmt: skip
    yield of.claim(
        "distance of the greatest pressure from the middle", lambda found: abs(found.max_pressure_y), 0.5, "mm",
        expected=0.5 * STRAIGHT, source="where the arcs begin", absolute=True,
    )  # fmt: skip


def _both_elements() -> Iterator[Claim]:
    of = Evidence("stand-in, parabolic", "semi-elliptic strips", lambda: stand_in(PARABOLIC), stand_in)
    why = (
        "the parabola's bias in an elliptical contact as slender is 0.4 % of pressure and 1 % of approach; in the "
        "middle of a line contact there is none"
    )
    yield of.claim("approach", "approach", 1e-2, "mm", why=why)
    yield of.claim("greatest pressure", "max_pressure", 4e-3, "MPa", why=why)
    yield of.claim("pressure in the middle", in_middle("centre_pressure"), 2e-3, "MPa", why=why)
    yield of.claim("half-width in the middle", in_middle("half_width"), 2e-3, "mm", why=why)


def _tilted() -> Iterator[Claim]:
    tilted, mirrored = (functools.partial(stand_in, SEMI_ELLIPTIC, sign * TILT) for sign in (1.0, -1.0))
    of = Evidence(f"stand-in, {1e3 * TILT:g} mrad", "that of the opposite tilt", tilted, mirrored)

    def carried() -> float:
        return float(np.sum(tilted().line_load * tilted().strip_width * tilted().y))

    yield of.claim("moment of the strips", "moment", 1e-9, "N mm", expected=carried, source="equilibrium")
    yield of.claim("approach", "approach", 1e-9, "mm")
    yield of.claim("moment", "moment", 1e-6, "N mm", expected=lambda: -mirrored().moment, source=f"{of.source}, turned")


def half_digit(printed: str) -> float:
    """Return half of the last digit of a printed number, and a little for binary rounding."""
    return 0.501 * 10.0 ** -len(printed.partition(".")[2])


def _by_second_program(tilt: float) -> Iterator[Claim]:
    source = "a second implementation, complete model"
    of = Evidence(f"ISO profile, {1e3 * tilt:g} mrad", source, functools.partial(_elsewhere, tilt))
    for name, strip, printed in SECOND_PROGRAM[tilt]:
        unit, measure = QUANTITIES[name]
        place = "" if strip is None else f" at y = {(strip - _STRIPS // 2) * LENGTH / _STRIPS:.4f} mm"
        yield of.claim(
            name + place, functools.partial(measure, i=strip), half_digit(printed), unit, expected=float(printed),
            absolute=True,
        )  # fmt: skip
    if tilt:
        yield of.claim(
            "greatest pressure", "max_pressure", 5e-6, "MPa", expected=TILTED_MAX_PRESSURE,
            why="it has 1.0396 for 4 sqrt(6) / (3 pi), 4e-6 more",
        )  # fmt: skip
