"""What displacement is measured against, one file per choice; a new one appears in Python, case files and web form."""

from __future__ import annotations

from numbers import Real
from typing import Final

from nonhertz.bodies.depths.cylinder import Cylinder
from nonhertz.bodies.depths.depth import Depth
from nonhertz.bodies.depths.diameter import Diameter
from nonhertz.bodies.depths.endless import Endless
from nonhertz.bodies.depths.finite import Finite
from nonhertz.bodies.depths.plane_strain import PlaneStrain
from nonhertz.bodies.depths.thickness import Thickness
from nonhertz.errors import InputError
from nonhertz.inputs.checks import positive

DepthRule = str | float

#: Choices by their keywords.
DEPTHS: Final[dict[str, Depth]] = {
    depth.word: depth for depth in (Endless(), PlaneStrain(), Diameter(), Cylinder(), Finite())
}

WORDS: Final = ", ".join(map(repr, DEPTHS))
_REMEDY: Final = f"write {WORDS} or a depth in mm such as the thickness of a ring"


def depth_of(rule: DepthRule, convex: bool) -> Depth:
    """Return what displacement is measured against.

    Raises
    ------
    InputError
        If ``rule`` is neither one of the words nor a positive length, or requires a diameter and the body is not
        ``convex``.
    """
    if isinstance(rule, str) and rule in DEPTHS:
        if DEPTHS[rule].of_diameter and not convex:
            remedy = "give the thickness of a ring or plate in mm, or write 'none'"
            raise InputError("depth", rule, "only be used for a convex body, which has a diameter", remedy)
        return DEPTHS[rule]
    if isinstance(rule, bool) or not isinstance(rule, Real):
        raise InputError("depth", rule, f"be one of {WORDS} or a length", _REMEDY)
    positive("depth", rule, _REMEDY)
    return Thickness(float(rule))
