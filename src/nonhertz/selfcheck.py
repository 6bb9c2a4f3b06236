"""Check of an installation: some numbers of every part against publications, closed forms and other methods.

The whole validation, hundreds of such claims, is in tests/claims of the source distribution.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from nonhertz import bearing, contact_map, hertz, life, measured, patch, subsurface
from nonhertz.bodies.influence import HALF_SPACE, Influence, influence_of
from nonhertz.errors import without_accuracy_warnings
from nonhertz.life import Raceway
from nonhertz.life.lamina import edge_function
from nonhertz.model.body import Body, Plate, Ring, Roller
from nonhertz.model.contact import Contact
from nonhertz.model.material import Material
from nonhertz.model.profile import Profile, crown, straight
from nonhertz.result.solution import Solution
from nonhertz.solver.one import solve
from nonhertz.strip.element import PARABOLIC, SEMI_ELLIPTIC, Element
from nonhertz.strip.influence import displacements

STEEL = Material(206000.0, 0.3)
AS_HALF_SPACE: dict[str, Any] = {"side_faces": "none", "depth": "none"}
_GRID = "plane grid, extrapolated"
_STANDARD = "ISO 281 by other programs"


@dataclass(frozen=True)
class Claim:
    """A number with its source, expected value and tolerance, and the function that computes it.

    The tolerance is relative; absolute where the expected value is 0.
    """

    quantity: str
    source: str
    expected: float
    tolerance: float
    compute: Callable[[], float]

    def difference(self, computed: float) -> float:
        """Return the relative difference of a number from the expected value; the absolute one from 0."""
        return computed - self.expected if self.expected == 0.0 else computed / self.expected - 1.0


@dataclass(frozen=True)
class Check:
    """A claim with the number that was computed for it."""

    section: str
    claim: Claim
    computed: float

    @property
    def difference(self) -> float:
        """Difference from the expected value, as in `Claim.difference`."""
        return self.claim.difference(self.computed)

    @property
    def passed(self) -> bool:
        """Whether it is within the tolerance."""
        return abs(self.difference) <= self.claim.tolerance


def run(announce: Callable[[str], object] | None = None) -> Iterator[Check]:
    """Compute the numbers section by section; `announce` is called with the name of each before it begins."""
    for section, claims in SECTIONS.items():
        if announce is not None:
            announce(section)
        with without_accuracy_warnings():
            computed = [Check(section, claim, float(claim.compute())) for claim in claims()]
        yield from computed


def middle(solution: Solution, name: str) -> float:
    """Return an attribute of the solution at the strip in the middle of the contact."""
    return float(getattr(solution, name)[np.abs(solution.y).argmin()])


def _elements() -> Iterator[Claim]:
    # From the curvature in the middle of a long strip, to which each edge contributes half.
    def factor(element: Element) -> float:
        return 2.0 * float(element.functions(1e4)[2])

    for element, expected, source in ((SEMI_ELLIPTIC, 4.0, "Hertz"), (PARABOLIC, 6.0, "de Mul 1998, Eq. (59)")):
        words = f"{element.name}: a^2 / (K q rho)"
        yield Claim(words, source, expected, 1e-8, functools.partial(factor, element))


def _hertz() -> Iterator[Claim]:
    contact = Contact(Body(diameter=20.0, profile=crown(100.0)), Body())
    ellipse = hertz.point_contact(load=1000.0, radius_x=10.0, radius_y=100.0, compliance=contact.compliance)
    solution = functools.cache(lambda: solve(contact, load=1000.0))
    yield Claim("ellipse: approach [mm]", "Hertz", ellipse.approach, 2e-4, lambda: solution().approach)
    yield Claim("ellipse: pressure [MPa]", "Hertz", ellipse.max_pressure, 2e-4, lambda: solution().max_pressure)


def _roller(profile: Profile) -> Contact:
    return Contact(Roller(diameter=20.0, length=20.0, profile=profile, **AS_HALF_SPACE), Plate())


def _half_space() -> Iterator[Claim]:
    tilted = functools.cache(lambda: solve(_roller(crown(4000.0)), load=3000.0, tilt=-0.5e-3))
    sharp = functools.cache(lambda: solve(_roller(straight()), load=20000.0))
    for words, expected, within, compute in (
        ("tilted crown: approach [mm]", 0.008110877926920768, 1e-4, lambda: tilted().approach),
        ("tilted crown: pressure [MPa]", 1008.3656928162496, 2e-4, lambda: middle(tilted(), "centre_pressure")),
        ("tilted crown: half-width [mm]", 0.1771221103260539, 2e-4, lambda: middle(tilted(), "half_width")),
        ("tilted crown: moment [N mm]", -6000.0, 3e-4, lambda: tilted().moment),
        ("sharp end: K of K / s^0.5", 812.2881555201532, 3e-3, lambda: sharp().edge_pressure[1].strength or 0.0),
    ):
        yield Claim(words, _GRID, expected, within, compute)


def _ends() -> Iterator[Claim]:
    def pair() -> Solution:
        roller = Roller(diameter=10.0, length=10.0, material=STEEL, side_faces="mirror", images="series")
        return solve(Contact(roller, roller), load=10e3)

    line = hertz.line_contact(line_load=1e3, radius=2.5, compliance=2.0 * STEEL.compliance)
    yield Claim(
        "two cylinders: approach [mm]", "Johnson 1985, Eq. (5.57)",
        2.0 * hertz.plane_strain_cylinder_compression(line, diameter=10.0, material=STEEL), 1e-5,
        lambda: pair().approach,
    )  # fmt: skip
    free = Roller(diameter=20.0, length=20.0, material=STEEL, side_faces="free", depth="none")
    contact = Contact(free, Ring(diameter=80.0, material=STEEL))
    yield Claim(
        "free ends: pressure [MPa]", "two half-spaces, Hetenyi", 2098.9, 1e-3,
        lambda: middle(solve(contact, load=20e3), "centre_pressure"),
    )  # fmt: skip
    for words, y, expected in (("in the middle", 0.0, 7.9174), ("at the end", 10.0, 9.6815)):
        yield Claim(
            f"whole roller: w / (K q) {words}", "finite elements in 3D", expected, 1e-3,
            functools.partial(_displacement, y),
        )  # fmt: skip


def _displacement(y: float) -> float:
    """Return w / (K q) of the surface of a solid roller under uniform line loads on two opposite sides."""
    roller = Roller(diameter=20.0, length=20.0, material=STEEL, side_faces="free", depth="finite")
    plate = Plate(material=STEEL, **AS_HALF_SPACE)
    outer = 10.0 - np.geomspace(0.005, 0.12, 14)
    edges = np.unique(np.concatenate([np.linspace(-10.0, 10.0, 161), outer, -outer]))
    square = np.full(edges.size - 1, 0.5**2)
    both, half_spaces = (
        displacements(influence, np.array([y]), edges, 1.0 / square, square, SEMI_ELLIPTIC)
        for influence in (influence_of(Contact(roller, plate), SEMI_ELLIPTIC), Influence(HALF_SPACE))
    )
    # Both bodies are of one material: each has half of the contact's compliance.
    return float(2.0 * both[0] - half_spaces[0])


def _plane_grid() -> Iterator[Claim]:
    ball = Contact(Body(diameter=20.0, profile=crown(10.0)), Body())
    exact = hertz.point_contact(load=50.0, radius_x=10.0, radius_y=10.0, compliance=ball.compliance)
    solution = functools.cache(lambda: patch.solve(ball, load=50.0))
    yield Claim("ball: pressure [MPa]", "Hertz", exact.max_pressure, 1e-3, lambda: solution().max_pressure)
    yield Claim("ball: approach [mm]", "Hertz", exact.approach, 5e-4, lambda: solution().approach)


def _stress() -> Iterator[Claim]:
    roller = Roller(diameter=20.0, length=10.0, material=STEEL, side_faces="mirror", images="series")
    contact = Contact(roller, roller)
    line = hertz.line_contact(line_load=1e3, radius=5.0, compliance=contact.compliance)
    largest = functools.cache(lambda: subsurface.extremes(solve(contact, load=10e3, strips=5), 0.0))
    for words, expected, within, compute in (
        ("von Mises / p0", 0.557516, 2e-4, lambda: largest().von_mises.max / line.max_pressure),
        ("depth of that / b", 0.704292, 1e-3, lambda: largest().von_mises.z / line.half_width),
        ("maximum shear / p0", 0.300283, 2e-4, lambda: largest().shear.max / line.max_pressure),
        ("orthogonal shear / p0", 0.25, 2e-4, lambda: largest().orthogonal_shear.max / line.max_pressure),
    ):
        yield Claim(f"line: {words}", "McEwen's closed form", expected, within, compute)


def _life() -> Iterator[Claim]:
    inner = Raceway(10.0, 9.6, 65.0, True)
    yield Claim("C_r of 14 rollers 10 x 9.6 [N]", _STANDARD, 48416.8, 1e-5, lambda: inner.load_rating(14))
    yield Claim("Q_ci of their inner ring [N]", _STANDARD, 11449.57, 1e-5, lambda: inner.capacity(14))
    yield Claim("edge stress, lamina 1 of 30", _STANDARD, 2.3283, 3e-5, lambda: float(edge_function(30)[0]))

    def relative() -> float:
        roller = Roller(diameter=10.0, length=10.0, material=STEEL, side_faces="mirror", images="series")
        solution = solve(Contact(roller, roller), load=10e3, strips=(-5.0, -4.95, 4.95, 5.0))
        return life.assess(solution, "zaretsky", body="b")[0].relative_life

    yield Claim("line: life over the ideal", "Hertz", 1.0, 1e-3, relative)


def _bearing() -> Iterator[Claim]:
    """Yield claims on the example of ISO/TS 16281: 14 straight rollers of 10 x 9.6 mm, recomputed independently."""
    row = bearing.CylindricalRollerBearing(
        roller=Roller(diameter=10.0, length=9.6), inner=Ring(diameter=55.0), outer=Ring(diameter=-75.0), rollers=14,
        clearance=0.0406,
    )  # fmt: skip
    solution = functools.cache(lambda: bearing.solve(row, radial=4450.0, method="slices"))
    source = "ISO/TS 16281, recomputed"
    yield Claim("14 rollers: displacement [mm]", source, 0.0322223, 1e-5, lambda: float(solution().displacement[1]))
    yield Claim("14 rollers: largest load [N]", source, 1956.26, 1e-5, lambda: float(solution().load.max()))
    yield Claim(
        "14 rollers: L10r [10^6 rev]", source, 3244.1, 1e-4,
        lambda: bearing.assess(solution(), edge_stress="standard").reference_life,
    )  # fmt: skip
    yield Claim(
        "a_ISO(kappa 1, e_C C_u/P 0.1)", "five other programs", 0.399, 1.5e-3,
        lambda: bearing.life_factor(1.0, 0.1),
    )  # fmt: skip


def _maps_and_profiles() -> Iterator[Claim]:
    crowned = _roller(crown(4000.0))

    def interpolated() -> float:
        mapped = contact_map(crowned, load=(0.0, 5000.0), tilt=(-1e-3, 1e-3))
        return float(mapped.under(load=3000.0, tilt=-0.5e-3).approach)

    yield Claim("tilted crown: approach [mm]", _GRID, 0.008110877926920768, 2e-4, interpolated)
    y = np.linspace(-5.0, 5.0, 201)
    points = measured.Points(y, np.sqrt(1000.0**2 - y**2) - 1000.0)
    yield Claim(
        "crown fitted to R = 1 m [mm]", "closed form", 1000.0, 1e-6,
        lambda: measured.fit(points, "crown").parameters["radius"],
    )  # fmt: skip


#: Claims by section, in the order in which they are computed.
SECTIONS: dict[str, Callable[[], Iterator[Claim]]] = {
    "Strip elements": _elements,
    "Elliptical contact": _hertz,
    "Rollers on half-spaces": _half_space,
    "Ends of rollers": _ends,
    "Plane grid": _plane_grid,
    "Stress below the surface": _stress,
    "Life": _life,
    "Bearings": _bearing,
    "Maps and measured profiles": _maps_and_profiles,
}
