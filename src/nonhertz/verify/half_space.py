"""Rollers on half-spaces against converged results of another method: uniform rectangles on a plane grid."""

from __future__ import annotations

import functools
import math
from collections.abc import Iterator
from dataclasses import dataclass

from nonhertz.model.body import Plate, Roller
from nonhertz.model.contact import Contact
from nonhertz.model.material import STEEL
from nonhertz.model.profile import Profile, crown, straight
from nonhertz.result.solution import Solution
from nonhertz.solver.one import solve
from nonhertz.verify.claim import Claim, Evidence, in_middle, pressures, series, solved

TITLE = "Rollers on half-spaces"
SOURCE = "uniform rectangles, extrapolated"
JUDGED_TO = 9.5  # mm: closer to the end than one half-width the pressure across is not a semi-ellipse


@dataclass(frozen=True)
class Reference:
    """A case, and the results of the other program."""

    name: str
    profile: Profile
    load: float
    tilt: float
    approach: float
    pressure: float
    half_width: float
    tolerance: float
    moment: float | None = None
    strength: float | None = None
    inwards: tuple[tuple[float, float], ...] = ()
    """Positions [mm] and pressures [MPa] towards the sharp end."""


REFERENCES = (
    Reference(
        "tilted crown", crown(4000.0), 3000.0, -0.5e-3, 0.008110877926920768, 1008.3656928162496, 0.1771221103260539,
        tolerance=1e-4, moment=-6000.0,
    ),
    Reference(
        "flat crown", crown(4000.0), 20000.0, 0.0, 0.032192419785281, 2039.162368630195, 0.3581713384284778,
        tolerance=1e-3, strength=519.65668923665,
        inwards=((5.0, 1919.7077), (9.0, 1671.4055), (9.5, 1685.8013), (9.9, 2160.3937)),
    ),
    Reference(
        "straight", straight(), 20000.0, 0.0, 0.02741221026671631, 1797.524086773164, 0.3160655726010909,
        tolerance=1e-3, strength=812.2881555201532,
        inwards=((5.0, 1828.1434), (9.0, 2018.2763), (9.5, 2168.5957), (9.9, 3120.7061)),
    ),
)  # fmt: skip


@solved
def on_strips(reference: Reference) -> Solution:
    """Return a case solved on strips."""
    roller = Roller(
        diameter=20.0, length=20.0, profile=reference.profile, material=STEEL, side_faces="none", depth="none"
    )
    # At sharp ends strips have an error of their own, which more of them do not remove.
    accuracy = 1e-5 if reference.strength is None else None
    return solve(Contact(roller, Plate(material=STEEL)), load=reference.load, tilt=reference.tilt, accuracy=accuracy)


def claims() -> Iterator[Claim]:
    """Yield the claims."""
    for reference in REFERENCES:
        yield from _of_case(reference)


def _of_case(reference: Reference) -> Iterator[Claim]:
    tolerance, places = reference.tolerance, [place for place, _ in reference.inwards]
    of = Evidence(reference.name, SOURCE, functools.partial(on_strips, reference))
    pressure, half_width = in_middle("centre_pressure"), in_middle("half_width")
    yield of.claim("approach", "approach", tolerance, "mm", expected=reference.approach)
    yield of.claim("centre pressure", pressure, tolerance, "MPa", expected=reference.pressure)
    yield of.claim("centre half-width", half_width, tolerance, "mm", expected=reference.half_width)
    if reference.moment is not None:
        yield of.claim("moment", "moment", 3e-4, "N mm", expected=reference.moment)
    yield from series(
        [f"{of.name}: pressure at y = {place:g} mm" for place in places], SOURCE,
        [pressure for _, pressure in reference.inwards], lambda: pressures(of.found(), places),
        [1e-2 if place <= JUDGED_TO else None for place in places], "MPa",
    )  # fmt: skip
    if reference.strength is not None:
        yield of.claim(
            "K at the end", lambda found: found.edge_pressure[1].strength or math.nan, 3e-3, "MPa mm^0.5",
            expected=reference.strength,
            why="that of the references changes by 0.15 % with the way it is extrapolated",
        )  # fmt: skip
