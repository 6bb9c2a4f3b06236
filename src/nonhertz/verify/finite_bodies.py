"""Side faces and depth in their limits, and against a second implementation."""

from __future__ import annotations

import functools
from typing import TYPE_CHECKING

import numpy as np

from nonhertz.errors import without_accuracy_warnings
from nonhertz.hertz import LineContact, line_contact, plane_strain_cylinder_compression
from nonhertz.model.body import Body, Plate, Roller
from nonhertz.model.contact import Contact
from nonhertz.model.material import Material
from nonhertz.model.profile import crown
from nonhertz.plot.style import FIRST, INK, SECOND
from nonhertz.result.solution import EdgeKind, Solution
from nonhertz.solver.one import solve
from nonhertz.strip.element import PARABOLIC, SEMI_ELLIPTIC, Element
from nonhertz.verify.claim import Check, Picture, Section

if TYPE_CHECKING:
    from matplotlib.figure import Figure

STEEL = Material(206000.0, 0.3)
DIAMETER, LOAD = 10.0, 10000.0  # of the coincident pair, with a length of one diameter
FAR = 1e7  # mm
# Approach [um] of the pair with the parabola, by number of images, from an independently written program.
_SECOND_PROGRAM = {1: 24.1905, 2: 24.1098, 4: 24.0871, 10: 24.0813, 40: 24.0804}
_LAST_DIGIT = 0.6e-4  # um
_TEXT = """\
What finite length and thickness must come to in their limits, whatever happens in between.

- **Faces and depths far away** must change nothing: a crowned roller with faces {far:.0e} mm away, or of such a depth.
- **Two equal straight rollers with coincident faces**, mirrored and with the depth of plane strain, are a piece cut
  out of two endless cylinders: the pressure must be that of Hertz's line contact at every strip up to the end, and the
  approach that of plane strain. One image per face leaves the other face's image uncancelled; the full series does
  not. Without depth the pressure is not uniform with one image, and the full series has no sum. A second program,
  written apart from this one, gave the approach for 1 to 40 images.
- **Only what ends, ends**: the image of a body counts with its share of the compliance. The faces of a roller a
  thousand times stiffer than the plate must change nothing.
- **Image weights that come to more than kappa = 1** have no solution that refinement converges to. They must be lowered
  until it is 1, with a warning for each end.

**Found.** {verdict} With one image per face the approach of the coincident pair, as long as thick, is
{one_image:.2f} % too large, and its pressure off by at most {pressure:.4f} % (semi-elliptic strips).
"""


@without_accuracy_warnings()
def section() -> Section:
    """Return the limits."""
    one, series = _pair(images=1), _pair(images="series")
    checks = [
        *_far_away(),
        *_coincident(),
        *_second_program(),
        *_stiff_roller(),
        *_too_heavy(),
    ]
    failed = sum(check.passed is False for check in checks)
    text = _TEXT.format(
        far=FAR,
        verdict="All of this holds." if not failed else f"{failed} of the checks below fail.",
        one_image=100.0 * (one.approach / series.approach - 1.0),
        pressure=100.0 * float(np.max(np.abs(one.centre_pressure / _line().max_pressure - 1.0))),
    )
    picture = Picture(
        "coincident-ends",
        "Two equal straight rollers with coincident ends: pressure over that of Hertz's line contact.",
        functools.partial(
            _draw,
            [
                ("mirrored, depth of plane strain", one),
                ("mirrored, no depth", _pair(depth="none")),
                ("half-spaces", _pair(side_faces="none", depth="none")),
            ],
        ),
    )
    return Section("Side faces and depth: limits", text, tuple(checks), (picture,))


def _line() -> LineContact:
    """Return Hertz's contact of the pair."""
    return line_contact(line_load=LOAD / DIAMETER, radius=0.25 * DIAMETER, compliance=2.0 * STEEL.compliance)


def _pair(element: Element = SEMI_ELLIPTIC, strips: int | None = None, **rules: str | int) -> Solution:
    asked = {"side_faces": "mirror"} | rules
    roller = Roller(diameter=DIAMETER, length=DIAMETER, material=STEEL, **asked)  # type: ignore[arg-type]
    return solve(Contact(roller, roller), load=LOAD, element=element, strips=strips)


def _far_away() -> list[Check]:
    def crowned(length: float | None, faces: str, depth: str | float) -> Solution:
        body = Body(
            diameter=20.0, length=length, effective_length=20.0, profile=crown(4000.0), material=STEEL,
            side_faces=faces, depth=depth,
        )  # fmt: skip
        return solve(Contact(body, Plate(material=STEEL)), load=3000.0)

    near = crowned(None, "none", "none")
    checks = []
    for name, other in (
        ("faces far away", crowned(FAR, "mirror", "none")),
        ("depth far away", crowned(None, "none", FAR)),
    ):
        source = "nothing changes"
        pressure = float(
            np.max(np.abs(other.centre_pressure / near.max_pressure - near.centre_pressure / near.max_pressure))
        )
        checks += [
            Check(f"{name}: approach", source, near.approach, other.approach, 1e-6, "mm"),
            Check(f"{name}: largest change of pressure, of the maximum", source, 0.0, pressure, 1e-6, absolute=True),
            Check(f"{name}: stiffness", source, near.stiffness[0, 0], other.stiffness[0, 0], 1e-6, "N/mm"),
        ]
    return checks


def _coincident() -> list[Check]:
    line = _line()
    compression = 2.0 * plane_strain_cylinder_compression(line, diameter=DIAMETER, material=STEEL)
    checks = []
    for element in (SEMI_ELLIPTIC, PARABOLIC):
        for name, strips in (("41 strips", 41), ("automatic strips", None)):
            for images in (1, "series"):
                solution = _pair(element, strips, images=images)
                off = np.abs(solution.centre_pressure / line.max_pressure - 1.0)
                count = "one image per face" if images == 1 else "all images"
                case = f"coincident ends, {element.name}, {name}, {count}"
                worst = line.max_pressure * (1.0 + float(np.max(off)))
                checks.append(
                    Check(
                        f"{case}: pressure at the worst strip",
                        "Hertz's line contact",
                        line.max_pressure,
                        worst,
                        1e-3,
                        "MPa",
                    )
                )
    exact = _pair(images="series")
    checks.append(
        Check("coincident ends, all images: approach", "plane strain", compression, exact.approach, 1e-5, "mm")
    )
    return checks


def _second_program() -> list[Check]:
    return [
        Check(
            f"coincident ends, parabolic, 41 strips, {images} images per face: approach", "a second program",
            expected, 1e3 * _pair(PARABOLIC, 41, images=images).approach, _LAST_DIGIT, "um", absolute=True,
        )
        for images, expected in _SECOND_PROGRAM.items()
    ]  # fmt: skip


def _stiff_roller() -> list[Check]:
    def pressed(faces: str) -> Solution:
        stiff = Material(1e3 * STEEL.modulus, STEEL.poisson)
        roller = Roller(diameter=20.0, length=20.0, material=stiff, side_faces=faces, depth="none")
        return solve(Contact(roller, Plate(material=STEEL)), load=20000.0)

    with_faces, without = pressed("mirror"), pressed("none")
    claim = "faces of a roller a thousand times stiffer than the plate: approach"
    return [Check(claim, "share of the compliance", without.approach, with_faces.approach, 1e-3, "mm")]


def _too_heavy() -> list[Check]:
    heavy, mirrored = _pair(side_faces="calibrated"), _pair(side_faces="mirror")
    said = sum("weights were lowered" in sentence for sentence in heavy.warnings)
    finite = sum(edge.kind is EdgeKind.FINITE for edge in heavy.edge_pressure)
    return [
        Check("kappa 1.6 at both ends: warnings", "one for each end", 2.0, float(said), 0.0),
        Check("kappa 1.6 at both ends: ends reported as finite", "kappa lowered to 1", 2.0, float(finite), 0.0),
        Check(
            "kappa 1.6 at both ends: end pressure", "that of weight 1",
            mirrored.edge_pressure[1].pressure, heavy.edge_pressure[1].pressure, 1e-9, "MPa",
        ),
    ]  # fmt: skip


def _draw(curves: list[tuple[str, Solution]], figure: Figure) -> None:
    axes = figure.add_subplot()
    line = _line()
    styles = ((FIRST, "-"), (SECOND, "--"), (INK, ":"))
    for (name, solution), (colour, dashes) in zip(curves, styles, strict=True):
        axes.plot(solution.y, solution.centre_pressure / line.max_pressure, color=colour, linestyle=dashes, label=name)
    axes.set(xlabel="y (mm)", ylabel="pressure / Hertz's line contact", ylim=(0.9, 1.2), xlim=(-5.2, 5.2))
    axes.legend(loc="upper center")
