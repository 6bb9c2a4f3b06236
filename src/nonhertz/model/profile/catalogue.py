"""The kinds of profile by name, with the units of their parameters and what a stated drop determines in each."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from nonhertz.model.profile.base import Profile
from nonhertz.model.profile.circular import crown, partial_crown, two_radius
from nonhertz.model.profile.linear import chamfer, conical, straight, tapered_ends
from nonhertz.model.profile.logarithm import (
    fujiwara_kawase,
    iso_logarithmic,
    iso_tapered,
    iso_thrust,
    johns_gohar,
    logarithmic,
)
from nonhertz.model.profile.table import tabulated
from nonhertz.model.profile.uniform_pressure import lundberg

#: Profiles that a case file may refer to by name.
CATALOGUE: dict[str, Callable[..., Profile]] = {
    "straight": straight,
    "crown": crown,
    "partial-crown": partial_crown,
    "two-radius": two_radius,
    "logarithmic": logarithmic,
    "lundberg": lundberg,
    "johns-gohar": johns_gohar,
    "fujiwara-kawase": fujiwara_kawase,
    "iso-logarithmic": iso_logarithmic,
    "iso-tapered": iso_tapered,
    "iso-thrust": iso_thrust,
    "conical": conical,
    "tapered-ends": tapered_ends,
    "chamfer": chamfer,
    "tabulated": tabulated,
}

#: Unit of every numeric parameter in the catalogue; a name has the same unit in every function.
PARAMETER_UNITS: dict[str, str] = {
    "amplitude": "mm",
    "angle": "rad",
    "centre": "mm",
    "compliance": "1/MPa",
    "diameter": "mm",
    "end_radius": "mm",
    "fraction": "",
    "k1": "",
    "k2": "",
    "length": "mm",
    "load": "N",
    "middle": "mm",
    "radius": "mm",
    "relief": "mm",
    "straight": "mm",
    "width": "mm",
    "y": "mm",
    "zm": "mm",
}

#: What a stated drop determines: the first of these parameters that is not given. A kind that is not listed is scaled.
BY_DROP: Final[dict[str, tuple[str, ...]]] = {
    "crown": ("radius",),
    "partial-crown": ("radius", "straight"),
    "two-radius": ("end_radius", "radius"),
    "logarithmic": ("amplitude",),
    "lundberg": ("load",),
    "johns-gohar": ("load",),
    "fujiwara-kawase": ("load", "zm"),
    "conical": ("angle",),
    "tapered-ends": ("angle", "straight"),
    "chamfer": ("angle", "width"),
}
