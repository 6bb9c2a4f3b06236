"""Figs. 6 and 7 of the paper: a profiled roller on an inner ring, and the complete model by a second program."""

from __future__ import annotations

import functools
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from nonhertz.hertz import line_contact
from nonhertz.model.body import Ring, Roller
from nonhertz.model.contact import Contact
from nonhertz.model.material import Material
from nonhertz.model.profile import Profile, iso_logarithmic, partial_crown
from nonhertz.plot.contact_area import footprint
from nonhertz.plot.style import FIRST, SECOND, SMALL_SIZE
from nonhertz.result.solution import EdgeKind, Solution
from nonhertz.solver.one import solve
from nonhertz.strip.element import PARABOLIC, SEMI_ELLIPTIC
from nonhertz.verify.claim import Check, Picture, Section

if TYPE_CHECKING:
    from matplotlib.figure import Figure

STEEL = Material(206000.0, 0.3)
DIAMETER, LENGTH = 15.0, 16.0  # of the roller [mm]
RING_DIAMETER, RING_WIDTH = 60.0, 24.0
STRAIGHT, ARC = 8.0, 300.0  # length of the straight middle and radius of the arcs beside it [mm]
LOAD, TILT = 20e3, 3e-4
STRETCH = 6.0
TO_GPA, TO_TENTHS = 1e-3, 10.0


@dataclass(frozen=True)
class _Strip:
    """One strip of the second program: summit s [N/mm^4], c [mm] and q [N/mm], and half their last digits."""

    index: int
    summit: float
    c: float
    line_load: float | None = None


@dataclass(frozen=True)
class _Reference:
    """What the second program gives for one tilt [rad]: approach [um], moment [N mm], greatest p0 [MPa]."""

    tilt: float
    approach: float
    strips: tuple[_Strip, ...]
    moment: float | None = None
    max_pressure: float | None = None


_REFERENCES = (
    _Reference(
        0.0, 36.073143,
        (_Strip(20, 19837.238, 0.3736208, 1379.4721), _Strip(10, 20169.573, 0.3676501),
         _Strip(0, 37338.522, 0.1897751, 340.262), _Strip(40, 37338.522, 0.1897751, 340.262)),
    ),
    _Reference(
        5e-4, 36.050388,
        (_Strip(0, 53698.568, 0.1285860), _Strip(20, 19846.241, 0.3734516), _Strip(40, 30321.068, 0.2391015)),
        moment=8942.016, max_pressure=2932.827,
    ),
)  # fmt: skip
_STRIPS = 41
_HALF_DIGIT = 0.501  # a half, and a little for binary rounding
_SECOND_PROGRAM = "a second implementation, complete model"
_TEXT = """\
The paper's Figs. 6 and 7 show the footprint of a roller with a B-TAN-2 profile on a plugged inner ring at 20 kN, and
half-width and pressure along it. The measured profile is not published as numbers and the figures are not digitised,
so nothing here is a comparison with that measurement. What follows is a **stand-in** of the same kind: a roller
{diameter:g} x {length:g} mm with a straight middle of {straight:g} mm and tangential circular arcs of {arc:g} mm
radius at both ends, {relief:.0f} um of relief at the end, on a solid cylinder of diameter {ring:g} and width
{width:g} mm in place of the plugged ring; steel, E = {modulus:g} MPa, {load:g} kN; mirrored faces and the depth of
plane strain on both bodies. Shapes, orders of size and laws can be judged with it: that the load is there, that the
footprint is symmetric, that the middle is a line contact, that no pressure peak is left at the ends, that both
elements agree. Numbers of the measured roller cannot.

**Found.** Approach {approach:.1f} um, in the middle {middle:.2f} GPa and a half-width of {half_width:.2f} mm/10. The
pressure rises by {hump:.0f} % from the middle to where the arcs begin, since curvature jumps there, and runs out at
{end:.2f} mm, inside the roller. Half-width and pressure in the middle are those of Hertz's line
contact under the line load there within {line:.4f} %. The parabolic element gives {parabolic_pressure:+.2f} % in the
greatest pressure and {parabolic_approach:+.2f} % in the approach. Under a tilt of {tilt:g} mrad the greatest pressure
is {tilted:.2f} GPa, {tilted_more:.1f} % more, and a moment of {moment:.1f} N m is needed.

The numbers that can be compared digit by digit are those of a second implementation of the paper's complete model
(parabolas, one image per face, depth of one diameter), written apart from this one: the same roller with the
logarithmic profile of ISO 16281, straight and under 0.5 mrad, on {strips} equal strips. All its digits are met.
"""


def contact(profile: Profile | None = None, depth: str = "plane-strain") -> Contact:
    """Return the roller on its ring, by default with the stand-in profile."""
    shape = profile or partial_crown(ARC, STRAIGHT)
    finite = {"material": STEEL, "side_faces": "mirror", "depth": depth}
    roller = Roller(diameter=DIAMETER, length=LENGTH, profile=shape, **finite)  # type: ignore[arg-type]
    return Contact(roller, Ring(diameter=RING_DIAMETER, length=RING_WIDTH, **finite))  # type: ignore[arg-type]


def section() -> Section:
    """Return the stand-in's checks and the comparison with the second program."""
    solution, parabolic, tilted, mirrored = (
        solve(contact(), load=LOAD, element=element, tilt=tilt)
        for element, tilt in ((SEMI_ELLIPTIC, 0.0), (PARABOLIC, 0.0), (SEMI_ELLIPTIC, TILT), (SEMI_ELLIPTIC, -TILT))
    )
    checks = [
        *_laws(solution),
        *_both_elements(solution, parabolic),
        *_tilted(tilted, mirrored),
        *(check for reference in _REFERENCES for check in _second_program(reference)),
    ]
    middle = _middle(solution)
    text = _TEXT.format(
        diameter=DIAMETER,
        length=LENGTH,
        straight=STRAIGHT,
        arc=ARC,
        relief=1e3 * float(partial_crown(ARC, STRAIGHT).relief(0.5 * LENGTH)),
        ring=RING_DIAMETER,
        width=RING_WIDTH,
        modulus=STEEL.modulus,
        load=1e-3 * LOAD,
        approach=1e3 * solution.approach,
        middle=TO_GPA * solution.centre_pressure[middle],
        half_width=TO_TENTHS * solution.half_width[middle],
        hump=100.0 * (solution.max_pressure / solution.centre_pressure[middle] - 1.0),
        end=solution.contact_y[0][1],
        line=100.0 * max(abs(check.difference) for check in checks if check.source.startswith("Hertz")),
        parabolic_pressure=100.0 * (parabolic.max_pressure / solution.max_pressure - 1.0),
        parabolic_approach=100.0 * (parabolic.approach / solution.approach - 1.0),
        tilt=1e3 * TILT,
        tilted=TO_GPA * tilted.max_pressure,
        tilted_more=100.0 * (tilted.max_pressure / solution.max_pressure - 1.0),
        moment=1e-3 * tilted.moment,
        strips=_STRIPS,
    )
    pictures = (
        Picture(
            "profiled-roller-footprint",
            "Footprint of the stand-in roller, after Fig. 6 of the paper: in true proportions, and stretched across.",
            functools.partial(_draw_footprint, solution),
            height=3.6,
        ),
        Picture(
            "profiled-roller-pressure",
            "Centre-line pressure and half-width of the stand-in roller on the scales of the paper's Fig. 7: in GPa "
            "and in tenths of a millimetre. Thin: under tilt.",
            functools.partial(_draw_pressure, solution, tilted),
            height=3.4,
        ),
    )
    return Section("A profiled roller on an inner ring (paper, Figs. 6 and 7)", text, tuple(checks), pictures)


def _middle(solution: Solution) -> int:
    return int(np.argmin(np.abs(solution.y)))


def _laws(solution: Solution) -> list[Check]:
    middle = _middle(solution)
    curvature = 2.0 / DIAMETER + 2.0 / RING_DIAMETER
    hertz = line_contact(
        line_load=float(solution.line_load[middle]), radius=1.0 / curvature, compliance=2.0 * STEEL.compliance
    )
    asymmetry = float(np.max(np.abs(solution.centre_pressure - solution.centre_pressure[::-1]))) / solution.max_pressure
    carried = float(np.sum(solution.line_load * solution.strip_width))
    running_out = sum(edge.kind is EdgeKind.RUN_OUT for edge in solution.edge_pressure)
    source = "Hertz's line contact under the line load there"
    # Were the rollers cut off at the end of the contact, 26 half-widths away, the half-width would be 2e-4 less.
    return [
        Check("stand-in: load that the strips carry", "equilibrium", LOAD, carried, 1e-9, "N"),
        Check("stand-in: moment", "symmetry", 0.0, solution.moment, 1e-6, "N mm", absolute=True),
        Check("stand-in: largest difference of p(y) and p(-y), of the greatest pressure", "symmetry", 0.0, asymmetry,
              1e-9, absolute=True),
        Check("stand-in: half-width in the middle", source, hertz.half_width,
              float(solution.half_width[middle]), 5e-4, "mm"),
        Check("stand-in: pressure in the middle", source, hertz.max_pressure,
              float(solution.centre_pressure[middle]), 5e-4, "MPa"),
        Check("stand-in: ends where the pressure runs out", "the stand-in is made so", 2.0,
              float(running_out), 0.0),
        Check("stand-in: distance of the greatest pressure from the middle", "where the arcs begin", 0.5 * STRAIGHT,
              abs(solution.max_pressure_y), 0.5, "mm", absolute=True),
    ]  # fmt: skip


def _both_elements(solution: Solution, parabolic: Solution) -> list[Check]:
    ours, theirs = _middle(solution), _middle(parabolic)
    source = "semi-elliptic strips"
    # No more than the parabola's bias in an elliptical contact as slender, 0.4 % of pressure and 1 % of approach; in
    # the middle of a line contact there is none.
    return [
        Check("stand-in, parabolic: approach", source, solution.approach, parabolic.approach, 1e-2, "mm"),
        Check("stand-in, parabolic: greatest pressure", source, solution.max_pressure, parabolic.max_pressure,
              4e-3, "MPa"),
        Check("stand-in, parabolic: pressure in the middle", source, float(solution.centre_pressure[ours]),
              float(parabolic.centre_pressure[theirs]), 2e-3, "MPa"),
        Check("stand-in, parabolic: half-width in the middle", source, float(solution.half_width[ours]),
              float(parabolic.half_width[theirs]), 2e-3, "mm"),
    ]  # fmt: skip


def _tilted(solution: Solution, mirrored: Solution) -> list[Check]:
    carried = float(np.sum(solution.line_load * solution.strip_width * solution.y))
    name = f"stand-in, {1e3 * TILT:g} mrad"
    return [
        Check(f"{name}: moment of the strips", "equilibrium", carried, solution.moment, 1e-9, "N mm"),
        Check(f"{name}: approach", "that of the opposite tilt", mirrored.approach, solution.approach, 1e-9, "mm"),
        Check(f"{name}: moment", "that of the opposite tilt, turned", -mirrored.moment, solution.moment, 1e-6, "N mm"),
    ]


def _second_program(reference: _Reference) -> list[Check]:
    contact_of_paper = contact(iso_logarithmic(diameter=DIAMETER, length=LENGTH), "diameter")
    solution = solve(contact_of_paper, load=LOAD, tilt=reference.tilt, element=PARABOLIC, strips=_STRIPS)
    case = f"ISO profile, {1e3 * reference.tilt:g} mrad"

    def check(name: str, expected: float, computed: float, decimals: int, unit: str) -> Check:
        tolerance = _HALF_DIGIT * 10.0**-decimals
        return Check(f"{case}: {name}", _SECOND_PROGRAM, expected, computed, tolerance, unit, absolute=True)

    checks = [check("approach", reference.approach, 1e3 * solution.approach, 6, "um")]
    for strip in reference.strips:
        q, c = float(solution.line_load[strip.index]), float(solution.element_half_width[strip.index])
        place = f"at y = {solution.y[strip.index]:.4f} mm"
        checks.append(check(f"summit s {place}", strip.summit, 0.75 * q / c**3, 3, "N/mm^4"))
        checks.append(check(f"c {place}", strip.c, c, 7, "mm"))
        if strip.line_load is not None:
            checks.append(check(f"line load {place}", strip.line_load, q, 4 if strip.index == 20 else 3, "N/mm"))
    if reference.moment is not None:
        checks.append(check("moment", reference.moment, solution.moment, 3, "N mm"))
    if reference.max_pressure is not None:
        # It has 1.0396 for 4 sqrt(6) / (3 pi), 4e-6 more.
        claim = f"{case}: greatest pressure"
        checks.append(Check(claim, _SECOND_PROGRAM, reference.max_pressure, solution.max_pressure, 5e-6, "MPa"))
    return checks


def _draw_footprint(solution: Solution, figure: Figure) -> None:
    upper, lower = figure.subplots(2, 1, height_ratios=(1.0, 3.2))
    footprint(solution, upper, colour_bar=False)
    footprint(solution, lower, stretch=STRETCH)
    upper.set_xlabel("")


def _draw_pressure(solution: Solution, tilted: Solution, figure: Figure) -> None:
    axes = figure.add_subplot()
    for one, width, words in ((solution, 1.5, ""), (tilted, 0.7, f", {1e3 * TILT:g} mrad")):
        y = one.y
        pressure, half_width = TO_GPA * one.centre_pressure, TO_TENTHS * one.half_width
        axes.plot(y, pressure, "-", color=FIRST, linewidth=width, label=f"pressure (GPa){words}")
        axes.plot(y, half_width, "--", color=SECOND, linewidth=width, label=f"half-width (mm/10){words}")
    axes.set(
        xlabel="y (mm)", ylabel="pressure (GPa), half-width (mm/10)", xlim=(-0.5 * LENGTH, 0.5 * LENGTH), ylim=(0, 4)
    )
    axes.legend(loc="lower center", ncols=2, fontsize=SMALL_SIZE)
