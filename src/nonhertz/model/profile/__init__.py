"""Relief along the axis: how much material is removed at each y.

A profile is a function of the axial coordinate y [mm], measured from the middle of its body, whose value is
the relief [mm], positive where material is removed. Profiles are values: they add (``crown(...) +
chamfer(...)``), shift along the axis, scale and flip, and each operation returns a new one. Besides its function a
profile has *bends*, the positions where slope or curvature jumps and strips must be refined, and an *extent*,
outside which there is no body. An infinite relief also means that there is no body.

The lower-case functions are the catalogue, under the names that engineers use, each with its source. Each returns a
`Profile`, and raises `InputError` if a value is out of range. Profiles for a design load take the same four parameters:
load [N], length [mm], radius (combined, across the contact) [mm] and compliance (of both bodies) [1/MPa]. `with_drop`
makes any of them from its drop at a position, as drawings state it.
"""

from __future__ import annotations

from nonhertz.lazy import dir_of
from nonhertz.model.profile.base import Profile, Straight, Sum, Transformed
from nonhertz.model.profile.circular import Arcs, crown, partial_crown, two_radius
from nonhertz.model.profile.drop import with_drop
from nonhertz.model.profile.kind import CATALOGUE, PARAMETERS, ProfileKind
from nonhertz.model.profile.linear import Conical, TaperedEnds, chamfer, conical, straight, tapered_ends
from nonhertz.model.profile.logarithm import (
    Logarithmic,
    fujiwara_kawase,
    iso_logarithmic,
    iso_tapered,
    iso_thrust,
    johns_gohar,
    logarithmic,
)
from nonhertz.model.profile.table import Tabulated, from_file, tabulated
from nonhertz.model.profile.uniform_pressure import UniformPressure, lundberg

__all__ = [
    "CATALOGUE",
    "PARAMETERS",
    "Arcs",
    "Conical",
    "Logarithmic",
    "Profile",
    "ProfileKind",
    "Straight",
    "Sum",
    "Tabulated",
    "TaperedEnds",
    "Transformed",
    "UniformPressure",
    "chamfer",
    "conical",
    "crown",
    "from_file",
    "fujiwara_kawase",
    "iso_logarithmic",
    "iso_tapered",
    "iso_thrust",
    "johns_gohar",
    "logarithmic",
    "lundberg",
    "partial_crown",
    "straight",
    "tabulated",
    "tapered_ends",
    "two_radius",
    "with_drop",
]
__dir__ = dir_of(__name__)
