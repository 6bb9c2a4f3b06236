"""Load against compression of a roller on a ring and of a needle on a cylinder, like Figs. 8 and 9 of the paper.

The measurements of the paper are not available as numbers: two pairs of that kind are set beside what practice computes
with, formulas for steel that know neither diameters nor profiles nor thickness, and beside plane strain.
"""

from __future__ import annotations

import functools
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from nonhertz.hertz import line_contact, plane_strain_cylinder_compression
from nonhertz.model.body import Ring, Roller
from nonhertz.model.contact import Contact
from nonhertz.model.profile import Profile, iso_logarithmic, partial_crown, straight
from nonhertz.result.solution import Solution
from nonhertz.solver.one import solve
from nonhertz.strip.element import SEMI_ELLIPTIC, Element
from nonhertz.verify.claim import Claim, Evidence, in_middle, solved
from nonhertz.verify.profiled_roller import ARC, DIAMETER, LENGTH, LOAD, RING_DIAMETER, RING_WIDTH, STEEL, STRAIGHT

TITLE = "Load and compression (paper, Figs. 8 and 9)"
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


def claims() -> Iterator[Claim]:
    """Yield the claims."""
    for pair in (ROLLER, NEEDLE):
        for load in pair.loads:
            yield from _by_formulas(pair, load)
    for load in NEEDLE.loads:
        yield from _in_plane_strain(NEEDLE, load)


def _ordered(pair: Pair, load: float) -> int:
    none, plane, diameter = (on_strips(pair, load, depth).approach for depth in DEPTHS)
    return (none > diameter) + (diameter > plane)


def _by_formulas(pair: Pair, load: float) -> Iterator[Claim]:
    of = Evidence(
        f"{pair.name}, {1e-3 * load:g} kN", "the nearer the stiffer",
        functools.partial(on_strips, pair, load, "plane-strain"),
    )  # fmt: skip
    yield of.claim(
        "depths in the order none > one diameter > plane strain", lambda _: _ordered(pair, load), 0.0, expected=2.0
    )
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
