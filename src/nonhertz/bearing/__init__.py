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

from nonhertz.bearing.assessed import BearingLife, assess
from nonhertz.bearing.bearings import (
    CylindricalRollerBearing,
    CylindricalThrustBearing,
    NeedleRollerBearing,
    Paired,
    RollerBearing,
    Row,
    SphericalRollerBearing,
    TaperedRollerBearing,
    paired,
)
from nonhertz.bearing.catalogue import CatalogueGuess, from_catalogue
from nonhertz.bearing.clearance import Fit, Housing, Mounting, OperatingClearance, Shaft
from nonhertz.bearing.fatigue import VolumeLife, volume_life
from nonhertz.bearing.lubrication import (
    contamination_factor,
    life_factor,
    oil_viscosity,
    reference_viscosity,
    reliability_factor,
)
from nonhertz.bearing.mapped import BearingMaps, maps
from nonhertz.bearing.ratings import Rating, rating
from nonhertz.bearing.ribs import Rib
from nonhertz.bearing.shapes import RingShape, fourier_shape, tabulated_shape
from nonhertz.bearing.solution import BearingSolution, UnrolledPressure
from nonhertz.bearing.spectrum import LoadCase, shares_of_revolutions, solve_spectrum
from nonhertz.bearing.states import BearingSolutions
from nonhertz.bearing.static import pressure_safety
from nonhertz.bearing.tables import ForceTable, table
from nonhertz.bearing.verb import solve, solve_many

__all__ = [
    "BearingLife",
    "BearingMaps",
    "BearingSolution",
    "BearingSolutions",
    "CatalogueGuess",
    "CylindricalRollerBearing",
    "CylindricalThrustBearing",
    "Fit",
    "ForceTable",
    "Housing",
    "LoadCase",
    "Mounting",
    "NeedleRollerBearing",
    "OperatingClearance",
    "Paired",
    "Rating",
    "Rib",
    "RingShape",
    "RollerBearing",
    "Row",
    "Shaft",
    "SphericalRollerBearing",
    "TaperedRollerBearing",
    "UnrolledPressure",
    "VolumeLife",
    "assess",
    "contamination_factor",
    "fourier_shape",
    "from_catalogue",
    "life_factor",
    "maps",
    "oil_viscosity",
    "paired",
    "pressure_safety",
    "rating",
    "reference_viscosity",
    "reliability_factor",
    "shares_of_revolutions",
    "solve",
    "solve_many",
    "solve_spectrum",
    "table",
    "tabulated_shape",
    "volume_life",
]
