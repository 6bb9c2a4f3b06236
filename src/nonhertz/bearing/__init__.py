"""Whole bearings: rollers between two rings in equilibrium.

Examples
--------
>>> import nonhertz as nh
>>> roller = nh.Roller(diameter=9, length=10, profile=nh.profile.crown(radius=4000))
>>> rings = {"inner": nh.Ring(diameter=37.5), "outer": nh.Ring(diameter=-55.5)}
>>> row = nh.bearing.CylindricalRollerBearing(roller=roller, **rings, rollers=13, clearance=0.0184)
>>> solution = nh.bearing.solve(row, radial=20e3, tilt=1e-3)
>>> solution.load[:4, 0].round(-1)
array([6860., 5710., 2670.,    0.])
"""

from typing import TYPE_CHECKING

from nonhertz.lazy import attach

if TYPE_CHECKING:
    from nonhertz.bearing.assessed import BearingLife as BearingLife
    from nonhertz.bearing.assessed import assess as assess
    from nonhertz.bearing.bearings import CylindricalRollerBearing as CylindricalRollerBearing
    from nonhertz.bearing.bearings import CylindricalThrustBearing as CylindricalThrustBearing
    from nonhertz.bearing.bearings import NeedleRollerBearing as NeedleRollerBearing
    from nonhertz.bearing.bearings import RollerBearing as RollerBearing
    from nonhertz.bearing.bearings import SphericalRollerBearing as SphericalRollerBearing
    from nonhertz.bearing.bearings import TaperedRollerBearing as TaperedRollerBearing
    from nonhertz.bearing.catalogue import CatalogueGuess as CatalogueGuess
    from nonhertz.bearing.catalogue import from_catalogue as from_catalogue
    from nonhertz.bearing.clearance import Mounting as Mounting
    from nonhertz.bearing.fatigue import VolumeLife as VolumeLife
    from nonhertz.bearing.fatigue import volume_life as volume_life
    from nonhertz.bearing.film import ContactFilm as ContactFilm
    from nonhertz.bearing.film import Films as Films
    from nonhertz.bearing.film import films as films
    from nonhertz.bearing.fits import Range as Range
    from nonhertz.bearing.fits import clearance_limits as clearance_limits
    from nonhertz.bearing.fits import ring_limits as ring_limits
    from nonhertz.bearing.fits import seat_limits as seat_limits
    from nonhertz.bearing.friction import Friction as Friction
    from nonhertz.bearing.kinematics import Kinematics as Kinematics
    from nonhertz.bearing.lubrication import contamination_factor as contamination_factor
    from nonhertz.bearing.lubrication import life_factor as life_factor
    from nonhertz.bearing.lubrication import oil_viscosity as oil_viscosity
    from nonhertz.bearing.lubrication import reference_viscosity as reference_viscosity
    from nonhertz.bearing.lubrication import reliability_factor as reliability_factor
    from nonhertz.bearing.mapped import BearingMaps as BearingMaps
    from nonhertz.bearing.mapped import maps as maps
    from nonhertz.bearing.oil import Lubrication as Lubrication
    from nonhertz.bearing.oil import OilInPlace as OilInPlace
    from nonhertz.bearing.operating import ClearanceRanges as ClearanceRanges
    from nonhertz.bearing.operating import InterferenceFit as InterferenceFit
    from nonhertz.bearing.operating import OperatingClearance as OperatingClearance
    from nonhertz.bearing.pairs import Paired as Paired
    from nonhertz.bearing.pairs import paired as paired
    from nonhertz.bearing.ratings import Rating as Rating
    from nonhertz.bearing.ratings import rating as rating
    from nonhertz.bearing.ribs import Rib as Rib
    from nonhertz.bearing.row import Row as Row
    from nonhertz.bearing.seats import Housing as Housing
    from nonhertz.bearing.seats import Shaft as Shaft
    from nonhertz.bearing.shapes import RingShape as RingShape
    from nonhertz.bearing.shapes import fourier_shape as fourier_shape
    from nonhertz.bearing.shapes import tabulated_shape as tabulated_shape
    from nonhertz.bearing.solution import BearingSolution as BearingSolution
    from nonhertz.bearing.solution import UnrolledPressure as UnrolledPressure
    from nonhertz.bearing.spectrum import BearingLoadCase as BearingLoadCase
    from nonhertz.bearing.spectrum import shares_of_revolutions as shares_of_revolutions
    from nonhertz.bearing.spectrum import solve_spectrum as solve_spectrum
    from nonhertz.bearing.states import BearingSolutions as BearingSolutions
    from nonhertz.bearing.static import pressure_safety as pressure_safety
    from nonhertz.bearing.tables import ForceTable as ForceTable
    from nonhertz.bearing.tables import table as table
    from nonhertz.bearing.toleranced import Tolerances as Tolerances
    from nonhertz.bearing.verb import solve as solve
    from nonhertz.bearing.verb import solve_many as solve_many

__getattr__, __dir__ = attach(
    __name__,
    {
        "assessed": ("BearingLife", "assess"),
        "bearings": (
            "CylindricalRollerBearing",
            "CylindricalThrustBearing",
            "NeedleRollerBearing",
            "RollerBearing",
            "SphericalRollerBearing",
            "TaperedRollerBearing",
        ),
        "catalogue": ("CatalogueGuess", "from_catalogue"),
        "clearance": ("Mounting",),
        "fatigue": ("VolumeLife", "volume_life"),
        "fits": ("Range", "clearance_limits", "ring_limits", "seat_limits"),
        "film": ("ContactFilm", "Films", "films"),
        "friction": ("Friction",),
        "kinematics": ("Kinematics",),
        "lubrication": (
            "contamination_factor",
            "life_factor",
            "oil_viscosity",
            "reference_viscosity",
            "reliability_factor",
        ),
        "mapped": ("BearingMaps", "maps"),
        "oil": ("Lubrication", "OilInPlace"),
        "operating": ("ClearanceRanges", "InterferenceFit", "OperatingClearance"),
        "pairs": ("Paired", "paired"),
        "ratings": ("Rating", "rating"),
        "ribs": ("Rib",),
        "row": ("Row",),
        "seats": ("Housing", "Shaft"),
        "shapes": ("RingShape", "fourier_shape", "tabulated_shape"),
        "solution": ("BearingSolution", "UnrolledPressure"),
        "spectrum": ("BearingLoadCase", "shares_of_revolutions", "solve_spectrum"),
        "states": ("BearingSolutions",),
        "static": ("pressure_safety",),
        "tables": ("ForceTable", "table"),
        "toleranced": ("Tolerances",),
        "verb": ("solve", "solve_many"),
    },
    {"LoadCase": "BearingLoadCase"},
)
