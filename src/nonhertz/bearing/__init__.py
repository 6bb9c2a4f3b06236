"""Whole bearings: rollers between two rings in equilibrium.

Examples
--------
>>> import nonhertz as nh
>>> roller = nh.Roller(diameter=9, length=10, profile=nh.profile.crown(radius=4000))
>>> rings = {"inner": nh.Ring(diameter=37.5), "outer": nh.Ring(diameter=-55.5)}
>>> row = nh.bearing.CylindricalRollerBearing(roller=roller, **rings, rollers=13, clearance=0.018)
>>> found = nh.bearing.solve(row, radial=20e3, tilt=1e-3)
>>> found.load[:4, 0].round(-1)
array([6850., 5700., 2680.,    0.])
"""

from __future__ import annotations

from nonhertz.bearing.bearings import (
    CylindricalRollerBearing,
    CylindricalThrustBearing,
    NeedleRollerBearing,
    Paired,
    Rib,
    RollerBearing,
    Row,
    SphericalRollerBearing,
    TaperedRollerBearing,
    paired,
)
from nonhertz.bearing.mapped import BearingMaps, maps
from nonhertz.bearing.rating import (
    BearingLife,
    Rating,
    assess,
    contamination_factor,
    life_factor,
    rating,
    reference_viscosity,
    reliability_factor,
)
from nonhertz.bearing.solution import BearingSolution
from nonhertz.bearing.states import BearingSolutions
from nonhertz.bearing.verb import solve, solve_many

__all__ = [
    "BearingLife",
    "BearingMaps",
    "BearingSolution",
    "BearingSolutions",
    "CylindricalRollerBearing",
    "CylindricalThrustBearing",
    "NeedleRollerBearing",
    "Paired",
    "Rating",
    "Rib",
    "RollerBearing",
    "Row",
    "SphericalRollerBearing",
    "TaperedRollerBearing",
    "assess",
    "contamination_factor",
    "life_factor",
    "maps",
    "paired",
    "rating",
    "reference_viscosity",
    "reliability_factor",
    "solve",
    "solve_many",
]
