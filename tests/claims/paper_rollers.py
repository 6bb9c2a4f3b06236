"""Rollers of the kind of Figs. 6 to 9 of the paper: a profiled one on an inner ring, and load against compression.

The profile measured in the paper is not published as numbers: a stand-in with a straight middle and tangential arcs is
judged by laws. Compared digit by digit is the same roller with the profile of ISO 16281, with a second program.
Measurements of load and compression are not available as numbers, either: two pairs of that kind, a roller on a ring
and a needle on a cylinder, are set beside what practice computes with, formulas for steel that know neither diameters
nor profiles nor thickness, and beside plane strain.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from claims.claim import Claim, Evidence, in_middle, solved
from nonhertz import PARABOLIC, SEMI_ELLIPTIC, Contact, EdgeKind, Material, Ring, Roller, Solution, solve
from nonhertz.hertz import LineContact, line_contact, plane_strain_cylinder_compression
from nonhertz.model.profile import Profile, iso_logarithmic, partial_crown, straight
from nonhertz.strip.element import Element

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


def profiled() -> Iterator[Claim]:
    """Yield the claims about the profiled roller."""
    yield from _stand_in()
    for tilt in SECOND_PROGRAM:
        yield from _by_second_program(tilt)


def _hertz() -> LineContact:
    curvature = 2.0 / DIAMETER + 2.0 / RING_DIAMETER
    line_load = in_middle("line_load")(stand_in())
    return line_contact(line_load=line_load, radius=1.0 / curvature, compliance=2.0 * STEEL.compliance)


def _stand_in() -> Iterator[Claim]:
    """Yield laws, what the other element finds, and what a tilt does."""
    of = Evidence("stand-in", "Hertz's line contact under the line load there", stand_in)
    why = "were the rollers cut off at the end of the contact, 26 half-widths away, the half-width would be 2e-4 less"
    yield of.claim(
        "load that the strips carry", lambda found: np.sum(found.line_load * found.strip_width), 1e-9, "N",
        expected=LOAD, source="equilibrium",
    )  # fmt: skip
    yield of.claim("moment", "moment", 1e-6, "N mm", source="symmetry")
    yield of.claim(
        "largest difference of p(y) and p(-y), of the greatest pressure",
        lambda found: np.max(np.abs(found.centre_pressure - found.centre_pressure[::-1])) / found.max_pressure, 1e-9,
        source="symmetry",
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
    of = Evidence("stand-in, parabolic", "semi-elliptic strips", lambda: stand_in(PARABOLIC), stand_in)
    why = (
        "the parabola's bias in an elliptical contact as slender is 0.4 % of pressure and 1 % of approach; in the "
        "middle of a line contact there is none"
    )
    yield of.claim("approach", "approach", 1e-2, "mm", why=why)
    yield of.claim("greatest pressure", "max_pressure", 4e-3, "MPa", why=why)
    yield of.claim("pressure in the middle", in_middle("centre_pressure"), 2e-3, "MPa", why=why)
    yield of.claim("half-width in the middle", in_middle("half_width"), 2e-3, "mm", why=why)
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


# Load and compression

DEPTHS = ("none", "plane-strain", "diameter")


@dataclass(frozen=True)
class Pair:
    """A roller on a solid cylinder [mm], and the loads [N] to examine, ascending."""

    name: str
    diameter: float
    length: float
    profile: Profile
    ring_diameter: float
    ring_width: float
    loads: tuple[float, float, float]

    def contact(self, depth: str, images: int | str = 1, **changed: Any) -> Contact:
        """Return the pair with faces mirrored and one depth on both bodies, or with another profile or ring width."""
        both: dict[str, Any] = {"material": STEEL, "depth": depth, "side_faces": "mirror", "images": images}
        profile, width = changed.get("profile", self.profile), changed.get("ring_width", self.ring_width)
        roller = Roller(diameter=self.diameter, length=self.length, profile=profile, **both)
        return Contact(roller, Ring(diameter=self.ring_diameter, length=width, **both))

    def palmgren(self, load: float) -> float:
        """Return Palmgren's compression of one contact [mm]."""
        return float(3.84e-5 * load**0.9 / self.length**0.8)

    def iso(self, load: float) -> float:
        """Return half of the compression between two raceways after ISO/TS 16281 [mm]."""
        return 0.5 * float((load / (35948.0 * self.length ** (8.0 / 9.0))) ** 0.9)

    def plane_strain(self, load: float) -> float:
        """Return the compression [mm] of both bodies in plane strain under ``load`` spread over the length."""
        curvature = 2.0 / self.diameter + 2.0 / self.ring_diameter
        line = line_contact(line_load=load / self.length, radius=1.0 / curvature, compliance=2.0 * STEEL.compliance)
        return sum(
            plane_strain_cylinder_compression(line, diameter=diameter, material=STEEL)
            for diameter in (self.diameter, self.ring_diameter)
        )


ROLLER = Pair(
    "roller", diameter=DIAMETER, length=LENGTH, profile=partial_crown(ARC, STRAIGHT), ring_diameter=RING_DIAMETER,
    ring_width=RING_WIDTH, loads=(1e3, 5e3, LOAD),
)  # fmt: skip
NEEDLE = Pair(
    "needle", diameter=3.0, length=15.8, profile=iso_logarithmic(diameter=3.0, length=15.8), ring_diameter=25.0,
    ring_width=20.0, loads=(500.0, 2e3, 6e3),
)  # fmt: skip


@solved
def on_strips(pair: Pair, load: float, depth: str, element: Element = SEMI_ELLIPTIC) -> Solution:
    """Return a pair under a load [N]."""
    return solve(pair.contact(depth), load=load, element=element)


def compression() -> Iterator[Claim]:
    """Yield the claims about load and compression."""
    for pair in (ROLLER, NEEDLE):
        for load in pair.loads:
            yield from _by_formulas(pair, load)
    for load in NEEDLE.loads:
        yield from _in_plane_strain(NEEDLE, load)


def _by_formulas(pair: Pair, load: float) -> Iterator[Claim]:
    of = Evidence(
        f"{pair.name}, {1e-3 * load:g} kN", "the nearer the stiffer",
        functools.partial(on_strips, pair, load, "plane-strain"),
    )  # fmt: skip

    def ordered(_: Solution) -> int:
        none, plane, diameter = (on_strips(pair, load, depth).approach for depth in DEPTHS)
        return (none > diameter) + (diameter > plane)

    yield of.claim("depths in the order none > one diameter > plane strain", ordered, 0.0, expected=2.0)
    for source, formula in (("Palmgren", pair.palmgren), ("ISO/TS 16281, half", pair.iso)):
        yield of.claim(
            "compression, depth of plane strain", lambda found: 1e3 * found.approach, None, "um",
            expected=1e3 * formula(load), source=source,
        )  # fmt: skip
    yield of.claim(
        "exponent of load over compression", lambda found: found.stiffness[0, 0] * found.approach / found.load, None,
        expected=10.0 / 9.0, source="10/9 of both formulas",
    )  # fmt: skip


def _in_plane_strain(pair: Pair, load: float) -> Iterator[Claim]:
    case, source = f"{pair.name}, {1e-3 * load:g} kN", "Johnson 1985, Eq. (5.57), both cylinders"

    def cut_out(images: int | str) -> Solution:
        contact = pair.contact("plane-strain", images, profile=straight(), ring_width=pair.length)
        return solve(contact, load=load)

    def uniform() -> float:
        return 1e3 * pair.plane_strain(in_middle("line_load")(on_strips(pair, load, "plane-strain")) * pair.length)

    for images, words, tolerance in ((1, "one image per face", 5e-3), ("series", "all images", 1e-5)):
        of = Evidence(
            f"{case}, straight, on a cylinder of its length, {words}", source, functools.partial(cut_out, images)
        )
        yield of.claim(
            "compression", lambda found: 1e3 * found.approach, tolerance, "um", expected=1e3 * pair.plane_strain(load),
            why="one image per face leaves the other face's image uncancelled; the series leaves 1e-7",
        )  # fmt: skip
    yield Claim(
        f"{case}, as in the table: compression", f"{source}, line load of the middle", uniform,
        lambda: 1e3 * on_strips(pair, load, "plane-strain").approach, 2.5e-2, "um",
        why="relieved ends, and a cylinder only 0.8 diameters long: not quite plane strain",
    )  # fmt: skip
