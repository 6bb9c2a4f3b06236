"""Rollers on half-spaces, and how the pressure grows towards sharp ends.

The rollers are set against converged results of another method: uniform rectangles on a plane grid.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from scipy.optimize import minimize_scalar

from claims.claim import Array, Claim, Evidence, in_middle, pressures, solved
from nonhertz import Contact, Material, Plate, Roller, Solution, solve
from nonhertz.model.material import STEEL
from nonhertz.model.profile import Profile, crown, straight

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


def rollers() -> Iterator[Claim]:
    """Yield the claims about rollers."""
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
    yield from Evidence(of.name, SOURCE, lambda: pressures(of.found(), places)).each(
        [f"pressure at y = {place:g} mm" for place in places],
        [1e-2 if place <= JUDGED_TO else None for place in places], "MPa",
        expected=[pressure for _, pressure in reference.inwards],
    )  # fmt: skip
    if reference.strength is not None:
        yield of.claim(
            "K at the end", lambda found: found.edge_pressure[1].strength or math.nan, 3e-3, "MPa mm^0.5",
            expected=reference.strength,
            why="that of the references changes by 0.15 % with the way it is extrapolated",
        )  # fmt: skip


# Sharp ends, for several image weights and pairs of materials. Close to the end p ~ K / s^alpha with
# cos(pi alpha) = kappa, the weight of the roller's images times its share of the compliance. The exponent appears only
# very close to the end: at a tenth of the half-width the slope of ln p is still far from it. So the strips narrow
# geometrically, and the exponent is that of the fit
#
#     ln p = ln K - alpha ln s + c1 s^(2 alpha) + c2 s
#
# from some strips off the end to a fraction of the half-width, which is independent of the formula.

LENGTH, LOAD, MODULUS = 20.0, 20000.0, 207000.0
# Weight of the roller's images, and modulus of the plate over that of the roller.
CASES = ((0.0, 1.0), (0.5, 1.0), (1.0, 1.0), (1.0, 0.4), (1.0, 2.277), (1.39, 1.0), (1.6, 1.0))
NARROWEST, GROWTH, WIDEST = 3e-5, 1.15, 0.6  # mm, from strip to strip, mm
BIASED_STRIPS, FIT_REACH = 9, 0.3  # the latter in half-widths


@dataclass(frozen=True, eq=False)
class End:
    """Kappa of an end, and the pressure at distances from it in half-widths."""

    kappa: float
    distance: Array
    pressure: Array

    @property
    def expected(self) -> float:
        """The exponent of the formula."""
        return math.acos(self.kappa) / math.pi

    def extrapolated(self) -> float:
        """Return the exponent of the fit."""
        near = (np.arange(self.distance.size) >= BIASED_STRIPS) & (self.distance < FIT_REACH)
        s, log_pressure = self.distance[near], np.log(self.pressure[near])

        def misfit(exponent: float) -> float:
            shape = np.column_stack([np.ones(s.size), s ** (2.0 * exponent), s])
            target = log_pressure + exponent * np.log(s)
            return float(np.sum((shape @ np.linalg.lstsq(shape, target, rcond=None)[0] - target) ** 2))

        return float(minimize_scalar(misfit, bounds=(0.05, 0.7), method="bounded", options={"xatol": 1e-6}).x)


@solved
def end(weight: float, ratio: float) -> End:
    """Return the end of a roller on a plate that goes on beyond it."""
    roller = Roller(diameter=20.0, length=LENGTH, material=Material(MODULUS, 0.3), side_faces=weight, depth="none")
    plate = Plate(material=Material(ratio * MODULUS, 0.3))
    edges = graded_edges(LENGTH, NARROWEST, GROWTH, WIDEST)
    solution = solve(Contact(roller, plate), load=LOAD, strips=edges)
    inwards = slice(None, None, -1)
    distance = (0.5 * LENGTH - solution.y[inwards]) / solution.half_width[-1]
    return End(solution.edge_pressure[1].image_weight, distance, solution.centre_pressure[inwards])


def graded_edges(length: float, narrowest: float, growth: float, widest: float) -> Array:
    """Return the edges of strips over a length, narrowing geometrically towards both ends."""
    widths = [narrowest]
    while widths[-1] < widest and sum(widths) < 0.4 * length:
        widths.append(widths[-1] * growth)
    outer = np.concatenate([[0.0], np.cumsum(widths)])
    inner = np.linspace(outer[-1], 0.5 * length, math.ceil((0.5 * length - outer[-1]) / widths[-1]) + 1)
    from_end = np.concatenate([outer, inner[1:]])
    return np.concatenate([from_end - 0.5 * length, (0.5 * length - from_end)[-2::-1]])


def exponents() -> Iterator[Claim]:
    """Yield the claims about the exponents of sharp ends."""
    for weight, ratio in CASES:
        yield _exponent(weight, ratio)


def _exponent(weight: float, ratio: float) -> Claim:
    kappa = weight * ratio / (1.0 + ratio)
    return Claim(
        f"exponent, image weight {weight:g}, modulus of plate / roller {ratio:g}: kappa {kappa:.3f}",
        "cos(pi alpha) = kappa", lambda: end(weight, ratio).expected, lambda: end(weight, ratio).extrapolated(), 0.03,
        absolute=True,
    )  # fmt: skip
