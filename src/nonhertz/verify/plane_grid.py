"""Strips against a plane grid, which assumes nothing about the pressure across the contact."""

from __future__ import annotations

import functools
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from nonhertz.comparison import Comparison, Stretch, compare
from nonhertz.hertz import point_contact
from nonhertz.model.body import Body, Plate, Ring, Roller, TabulatedDiameter
from nonhertz.model.contact import Contact
from nonhertz.model.material import STEEL
from nonhertz.model.profile import crown, iso_logarithmic
from nonhertz.plot.side_by_side import draw_across, draw_differences
from nonhertz.plot.style import SMALL_SIZE
from nonhertz.strip.element import PARABOLIC, SEMI_ELLIPTIC
from nonhertz.verify.claim import Check, Picture, Section

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_ELLIPSE = {"load": 1000.0, "radius_x": 10.0, "radius_y": 100.0}
_HALF_SPACE: dict[str, Any] = {"side_faces": "none", "depth": "none"}
_MIRRORED: dict[str, Any] = {"side_faces": "mirror"}
_LOGARITHMIC = iso_logarithmic(diameter=15.0, length=16.0)
_SOURCE = "plane grid"
_STRAIGHT = 0.02741221026671631  # mm, approach: that of `nonhertz.verify.half_space`
_DRAWN = {"straight", "tilted logarithm"}
_TEXT = """\
The plane grid of `nonhertz.patch` cuts the surface into {across} x {along} rectangles of uniform pressure and assumes
nothing of how the pressure is distributed across the contact. It has in common with the strips only the bodies and what
their faces and thickness add, images and depths. Seven cases are solved on it and with strips of both elements, as
`nonhertz compare` does with any case:

{cases}

| case | semi-elliptic: approach | pressure in the middle | parabolic: approach | pressure in the middle |
|---|---:|---:|---:|---:|
{rows}

**Found.** Where the pressure has a limit up to the ends, semi-elliptic strips and plane grid agree within
{smooth:.4f} % in approach and in the pressure in the middle. Up to sharp ends it is {sharp:.3f} %, but
there both err, and the same way: against the extrapolated value of the section on half-spaces the approach of the
straight roller is {strips_off:+.3f} % off on strips and {grid_off:+.3f} % on the grid, where errors at sharp ends fall
only in proportion to the cells. Parabolic strips are off by up to {bias:.1f} % in
the approach, the element's own bias.

Along the line, semi-elliptic strips are within {inner:.2f} % of the plane grid farther than one half-width from the
ends of the contact. By more than 1 % they differ only where a sharp end or the end of the contact is within one
half-width; what the solutions tell of why, stretch by stretch, with the largest difference that comes of each reason
where they differ most:

{reasons}

Parabolic strips differ by more than 1 % on {parabolic} stretches; on {own} of them the parabola's own bias is the
largest reason, by how far its half-width is from that of semi-elliptic strips.
"""


@dataclass(frozen=True, eq=False)
class _Case:
    name: str
    words: str
    contact: Contact
    given: dict[str, Any]
    sharp: bool = False

    @property
    def tolerance(self) -> float:
        # The methods' own accuracy targets; up to sharp ends strips are held to 1e-3, and the grid's error falls in
        # proportion to its cells only, 5e-4 of the approach with 512 of them.
        return 1e-3 if self.sharp else 2e-4


_CASES = (
    _Case(
        "ellipse", "Hertz's elliptical contact, radii 10 and 100 mm, half-spaces, 1000 N",
        Contact(Body(diameter=20.0, profile=crown(100.0)), Body()), {"load": 1000.0},
    ),
    _Case(
        "tilted crown", "roller 20 x 20 with a crown of 4000 mm, half-spaces, 3 kN, tilt -0.5 mrad: runs out inside",
        Contact(Roller(diameter=20.0, length=20.0, profile=crown(4000.0), **_HALF_SPACE), Plate()),
        {"load": 3000.0, "tilt": -0.5e-3},
    ),
    _Case(
        "tilted logarithm", "roller 15 x 16, profile of ISO 16281, half-spaces, ring of 60 mm, 20 kN, tilt 1 mrad: the "
        "greatest pressure near the end, but inside",
        Contact(Roller(diameter=15.0, length=16.0, profile=_LOGARITHMIC, **_HALF_SPACE), Ring(diameter=60.0)),
        {"load": 20e3, "tilt": 1e-3},
    ),
    _Case(
        "mirrored crown", "roller 15 x 16 with a crown of 1000 mm, mirrored faces and plane-strain depth, ring of 60 "
        "mm, 8 mm thick, 10 kN, tilt 0.3 mrad",
        Contact(
            Roller(diameter=15.0, length=16.0, profile=crown(1000.0), **_MIRRORED),
            Ring(diameter=60.0, length=24.0, depth=8.0, **_MIRRORED),
        ),
        {"load": 10e3, "tilt": 0.3e-3},
    ),
    _Case(
        "straight", "roller 20 x 20 without a profile, half-spaces, 20 kN: two sharp ends",
        Contact(Roller(diameter=20.0, length=20.0, **_HALF_SPACE), Plate()), {"load": 20e3}, sharp=True,
    ),
    _Case(
        "coincident", "two rollers 10 x 10, faces at the same places with all images, 10 kN: a piece of a line contact",
        Contact(*(Roller(diameter=10.0, length=10.0, images="series", **_MIRRORED) for _ in "ab")), {"load": 10e3},
    ),
    _Case(
        "tapered", "roller of 14 to 17 mm in diameter, profile of ISO 16281, mirrored faces, ring of 60 mm, 10 kN, the "
        "moment of 5 N m prescribed",
        Contact(
            Roller(
                diameter=TabulatedDiameter((-8.0, 8.0), (14.0, 17.0)), length=16.0, profile=_LOGARITHMIC, **_MIRRORED
            ),
            Ring(diameter=60.0),
        ),
        {"load": 10e3, "moment": 5e3},
    ),
)  # fmt: skip


def section() -> Section:
    """Return the comparison of all cases."""
    found = {case: compare(case.contact, **case.given) for case in _CASES}
    checks = [*_grid_itself(found), *(check for case, each in found.items() for check in _checks(case, each))]
    pictures = (
        Picture(
            "plane-grid-differences",
            "Pressure on the centre line, strips against plane grid, case by case: semi-elliptic (rings) and parabolic "
            "(crosses). Shaded: less than 1 %.",
            functools.partial(_draw_differences, found),
            height=7.0,
        ),
        Picture(
            "plane-grid-across",
            "Pressure across two of the rollers: cells (dots), and semi-elliptic (solid) and parabolic strips (dashed) "
            "in the shapes that they assume.",
            functools.partial(_draw_cuts, {case: each for case, each in found.items() if case.name in _DRAWN}),
            height=4.6,
        ),
    )
    return Section("Strips against a plane grid", _text(found), tuple(checks), pictures)


def _grid_itself(found: dict[_Case, Comparison]) -> list[Check]:
    """Return checks of the plane grid by itself, against known solutions."""
    by_name = {case.name: each.patch for case, each in found.items()}
    hertz = point_contact(**_ELLIPSE, compliance=2.0 * STEEL.compliance)
    ellipse, extrapolated = by_name["ellipse"], "uniform rectangles, extrapolated"
    # The circle of the crown instead of Hertz's parabola adds 3e-5.
    return [
        Check("ellipse, plane grid: approach", "Hertz", hertz.approach, ellipse.approach, 2e-4, "mm"),
        Check("ellipse, plane grid: greatest pressure", "Hertz", hertz.max_pressure, ellipse.max_pressure, 2e-4, "MPa"),
        Check("straight, plane grid: approach", extrapolated, _STRAIGHT, by_name["straight"].approach, 1e-3, "mm"),
    ]


def _checks(case: _Case, found: Comparison) -> list[Check]:
    def check(name: str, what: str, tolerance: float | None, of: str = "semi_elliptic") -> Check:
        each = found.quantity(name)
        claim = f"{case.name}{', parabolic' if of == 'parabolic' else ''}: {what}"
        return Check(claim, _SOURCE, each.patch, getattr(each, of), tolerance, each.unit, absolute=each.absolute)

    checks = [
        check("approach", "approach", case.tolerance),
        check("pressure at", "pressure in the middle", case.tolerance),
        # Half a cell, of about 50 in the half-width.
        check("half-width at", "half-width in the middle", 1e-2),
        # No more than its bias in an ellipse 4.5 times as long as wide, the widest contact here.
        check("approach", "approach", 1.6e-2, of="parabolic"),
    ]
    if "tilt" in case.given:
        # A difference of large moments: several times the error of either side.
        checks.append(check("moment", "moment", 1e-3))
    if "moment" in case.given:
        checks.append(check("tilt", "tilt", 1e-3))
    # A cell is either in contact or not.
    checks += [check(name, name, found.patch.dy) for name in ("contact from", "contact to")]
    unexplained = sum(not stretch.explained for stretch in found.stretches)
    return [
        *checks,
        Check(f"{case.name}: largest difference of pressure farther than a half-width from the ends", _SOURCE, 0.0,
              _inner(found), 1e-2, absolute=True),
        Check(f"{case.name}: stretches that differ by over 1 % and by more than their reasons", "the solutions", 0.0,
              float(unexplained), 0.0, absolute=True),
    ]  # fmt: skip


def _inner(found: Comparison) -> float:
    """Return the largest difference of semi-elliptic strips more than a half-width from the ends of the contact."""
    semi = found.semi_elliptic
    ends = np.ravel(semi.contact_y)
    inside = np.min(np.abs(semi.y[:, None] - ends), axis=1) > float(semi.half_width.max())
    return float(np.nanmax(np.abs(found.along(semi)[inside])))


def _text(found: dict[_Case, Comparison]) -> str:
    across, along = next(iter(found.values())).patch.cells
    smooth = [_middle(each)[:2] for case, each in found.items() if not case.sharp]
    sharp = [_middle(each)[:2] for case, each in found.items() if case.sharp]
    straight = next(each for case, each in found.items() if case.name == "straight")
    stretches = [stretch for each in found.values() for stretch in each.stretches]
    parabolic = [stretch for stretch in stretches if stretch.element == PARABOLIC.name]
    return _TEXT.format(
        across=across,
        along=along,
        cases="\n".join(f"- **{case.name}**: {case.words}." for case in found),
        rows="\n".join(_row(case, each) for case, each in found.items()),
        smooth=100.0 * float(np.max(np.abs(smooth))),
        sharp=100.0 * float(np.max(np.abs(sharp))),
        strips_off=100.0 * (straight.semi_elliptic.approach / _STRAIGHT - 1.0),
        grid_off=100.0 * (straight.patch.approach / _STRAIGHT - 1.0),
        bias=100.0 * max(abs(_middle(each)[2]) for each in found.values()),
        inner=100.0 * max(_inner(each) for each in found.values()),
        reasons="\n".join(_reasons(case, each) for case, each in found.items()),
        parabolic=len(parabolic),
        own=sum(_is_own(stretch) for stretch in parabolic),
    )


def _middle(found: Comparison) -> tuple[float, float, float, float]:
    """Return the differences of approach and middle pressure, those of semi-elliptic strips first."""
    (approach, of_parabola), (pressure, its_pressure) = (
        found.quantity(name).differences for name in ("approach", "pressure at")
    )
    return approach, pressure, of_parabola, its_pressure


def _row(case: _Case, found: Comparison) -> str:
    return f"| {case.name} | {' | '.join(f'{100.0 * each:+.4f} %' for each in _middle(found))} |"


def _reasons(case: _Case, found: Comparison) -> str:
    stretches = [each for each in found.stretches if each.element == SEMI_ELLIPTIC.name]
    if not stretches:
        return f"- **{case.name}**: nowhere."
    return "\n".join(f"- **{case.name}**, {_where(each)}: {' '.join(map(str, each.reasons))}" for each in stretches)


def _is_own(stretch: Stretch) -> bool:
    """Return whether the parabola's own bias is the largest reason."""
    return "the parabola's own" in max(stretch.reasons, key=lambda reason: reason.size).sentence


def _where(stretch: Stretch) -> str:
    return f"y = {stretch.low:.4g} to {stretch.high:.4g} mm, up to {100.0 * stretch.largest:+.2g} %"


def _draw_differences(found: dict[_Case, Comparison], figure: Figure) -> None:
    panels = figure.subplots(-(-len(found) // 2), 2).ravel()
    for axes, (case, each) in zip(panels, found.items(), strict=False):
        draw_differences(each, axes)
        axes.set_title(case.name, loc="left", fontsize=SMALL_SIZE)
        axes.set_xlabel("y (mm)")
        axes.set_ylabel("difference (%)" if axes.get_subplotspec().is_first_col() else "")
    for axes in panels[len(found) :]:
        axes.remove()


def _draw_cuts(found: dict[_Case, Comparison], figure: Figure) -> None:
    rows = figure.subplots(len(found), 3, squeeze=False)
    for row, (case, each) in zip(rows, found.items(), strict=True):
        for axes, station in zip(row, each.stations, strict=True):
            draw_across(each, axes, station)
        row[0].set_ylabel(f"{case.name}: p (MPa)")
