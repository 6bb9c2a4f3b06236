"""The kinds of profile by name."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from nonhertz.model.profile.base import Profile
from nonhertz.model.profile.circular import crown, partial_crown, two_radius
from nonhertz.model.profile.kind import ProfileKind, parameters_of, word
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

_IN_ORDER: tuple[Callable[..., Profile], ...] = (
    straight,
    crown,
    partial_crown,
    two_radius,
    logarithmic,
    lundberg,
    johns_gohar,
    fujiwara_kawase,
    iso_logarithmic,
    iso_tapered,
    iso_thrust,
    conical,
    tapered_ends,
    chamfer,
    tabulated,
)
#: Profiles that a case file may refer to by name.
CATALOGUE: Final[dict[str, Callable[..., Profile]]] = {word(each): each for each in _IN_ORDER}
#: What each of them takes.
PARAMETERS: Final[dict[str, type[ProfileKind]]] = {name: parameters_of(each) for name, each in CATALOGUE.items()}
