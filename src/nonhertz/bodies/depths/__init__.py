"""What displacement is measured against, one file per choice; a new one appears in Python, case files and web form."""

from __future__ import annotations

from typing import Final

from nonhertz.bodies.depths.cylinder import Cylinder
from nonhertz.bodies.depths.depth import Depth
from nonhertz.bodies.depths.diameter import Diameter
from nonhertz.bodies.depths.endless import Endless
from nonhertz.bodies.depths.finite import Finite
from nonhertz.bodies.depths.plane_strain import PlaneStrain
from nonhertz.bodies.depths.thickness import Thickness
from nonhertz.errors import InputError

DepthRule = str | float

#: Choices by their keywords.
DEPTHS: Final[dict[str, Depth]] = {
    depth.word: depth for depth in (Endless(), PlaneStrain(), Diameter(), Cylinder(), Finite())
}

WORDS: Final = ", ".join(map(repr, DEPTHS))
REMEDY: Final = f"write {WORDS} or a depth in mm such as the thickness of a ring"


def depth_of(rule: DepthRule, convex: bool) -> Depth:
    """Return what displacement is measured against by a rule.

    Raises
    ------
    InputError
        If it requires a diameter and the body is not ``convex``.
    """
    if not isinstance(rule, str):
        return Thickness(float(rule))
    if DEPTHS[rule].of_diameter and not convex:
        remedy = "give the thickness of a ring or plate in mm, or write 'none'"
        raise InputError("depth", rule, "only be used for a convex body, which has a diameter", remedy)
    return DEPTHS[rule]
