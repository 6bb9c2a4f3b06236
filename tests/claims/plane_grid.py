"""Strips against a plane grid, which assumes nothing about the pressure across the contact.

The grid has in common with the strips only the bodies and what their faces and thickness add, images and depths.
"""

from __future__ import annotations

import functools
from collections.abc import Iterator
from typing import Any

import numpy as np

from claims.claim import Case, Claim, Evidence, Value, solved
from nonhertz import Body, Comparison, Contact, Plate, Ring, Roller, TabulatedDiameter, compare
from nonhertz.hertz import point_contact
from nonhertz.model.material import STEEL
from nonhertz.model.profile import crown, iso_logarithmic

_HALF_SPACE: dict[str, Any] = {"side_faces": "none", "depth": "none"}
_MIRRORED: dict[str, Any] = {"side_faces": "mirror"}
_LOGARITHMIC = iso_logarithmic(diameter=15.0, length=16.0)
_STRAIGHT = 0.02741221026671631  # mm, approach: that of `claims.half_space`


ELLIPSE, TILTED_CROWN, _, _, STRAIGHT, _, _ = CASES = (
    Case("ellipse", Contact(Body(diameter=20.0, profile=crown(100.0)), Body()), {"load": 1000.0}),
    Case(
        "tilted crown",  # runs out inside the body
        Contact(Roller(diameter=20.0, length=20.0, profile=crown(4000.0), **_HALF_SPACE), Plate()),
        {"load": 3000.0, "tilt": -0.5e-3},
    ),
    Case(
        "tilted logarithm",  # the greatest pressure near the end, but inside
        Contact(Roller(diameter=15.0, length=16.0, profile=_LOGARITHMIC, **_HALF_SPACE), Ring(diameter=60.0)),
        {"load": 20e3, "tilt": 1e-3},
    ),
    Case(
        "mirrored crown",
        Contact(
            Roller(diameter=15.0, length=16.0, profile=crown(1000.0), **_MIRRORED),
            Ring(diameter=60.0, length=24.0, depth=8.0, **_MIRRORED),
        ),
        {"load": 10e3, "tilt": 0.3e-3},
    ),
    Case(
        "straight",
        Contact(Roller(diameter=20.0, length=20.0, **_HALF_SPACE), Plate()), {"load": 20e3}, sharp=True,
    ),
    Case(
        "coincident",  # a piece of a line contact
        Contact(*(Roller(diameter=10.0, length=10.0, images="series", **_MIRRORED) for _ in "ab")), {"load": 10e3},
    ),
    Case(
        "tapered",
        Contact(
            Roller(
                diameter=TabulatedDiameter((-8.0, 8.0), (14.0, 17.0)), length=16.0, profile=_LOGARITHMIC, **_MIRRORED
            ),
            Ring(diameter=60.0),
        ),
        {"load": 10e3, "moment": 5e3},
    ),
)  # fmt: skip


@solved
def compared(case: Case) -> Comparison:
    """Return a case on the plane grid and on strips of both elements."""
    return compare(case.contact, **case.given)


def claims() -> Iterator[Claim]:
    """Yield the claims."""
    hertz = point_contact(load=1000.0, radius_x=10.0, radius_y=100.0, compliance=2.0 * STEEL.compliance)
    ellipse = Evidence("ellipse, plane grid", "Hertz", lambda: compared(ELLIPSE).patch, lambda: hertz)
    why = "the circle of the crown instead of Hertz's parabola adds 3e-5"
    yield ellipse.claim("approach", "approach", 2e-4, "mm", why=why)
    yield ellipse.claim("greatest pressure", "max_pressure", 2e-4, "MPa", why=why)
    yield Claim(
        "straight, plane grid: approach", "uniform rectangles, extrapolated", _STRAIGHT,
        lambda: compared(STRAIGHT).patch.approach, 1e-3, "mm",
    )  # fmt: skip
    for case in CASES:
        yield from _of_case(case)


def _of_case(case: Case) -> Iterator[Claim]:
    of = Evidence(case.name, "plane grid", functools.partial(compared, case))

    def claim(name: str, what: str, tolerance: Value, unit: str, why: str = "", *, absolute: bool = False) -> Claim:
        return of.claim(
            what, lambda found: found.quantity(name).semi_elliptic, tolerance, unit,
            expected=lambda: of.found().quantity(name).patch, absolute=absolute, why=why,
        )  # fmt: skip

    # The methods' own accuracy targets; up to sharp ends strips are held to 1e-3, and the grid's error falls in
    # proportion to its cells only, 5e-4 of the approach with 512 of them.
    tolerance = 1e-3 if case.sharp else 2e-4
    yield claim("approach", "approach", tolerance, "mm")
    yield claim("pressure at", "pressure in the middle", tolerance, "MPa")
    yield claim("half-width at", "half-width in the middle", 1e-2, "mm", "half a cell, of about 50 in the half-width")
    yield Claim(
        f"{case.name}, parabolic: approach", of.source, lambda: of.found().quantity("approach").patch,
        lambda: of.found().quantity("approach").parabolic, 1.6e-2, "mm",
        why="its bias in an ellipse 4.5 times as long as wide, the widest contact here",
    )  # fmt: skip
    if "tilt" in case.given:
        why = "a difference of large moments: several times the error of either side"
        yield claim("moment", "moment", 1e-3, "N mm", why)
    if "moment" in case.given:
        yield claim("tilt", "tilt", 1e-3, "rad")
    for end in ("contact from", "contact to"):
        why = "a cell is either in contact or not"
        yield claim(end, end, lambda: of.found().patch.dy, "mm", why, absolute=True)
    yield of.claim("largest difference of pressure farther than a half-width from the ends", inner, 1e-2)


def inner(found: Comparison) -> float:
    """Return the largest difference of semi-elliptic strips more than a half-width from the ends of the contact."""
    semi = found.semi_elliptic
    ends = np.ravel(semi.contact_y)
    inside = np.min(np.abs(semi.y[:, None] - ends), axis=1) > float(semi.half_width.max())
    return float(np.nanmax(np.abs(found.along(semi)[inside])))
