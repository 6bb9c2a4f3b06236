"""Descriptions of fields of bearings: bodies, diameters, clearance and contact angle."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Annotated, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.amounts import mm
from nonhertz.bearing.fits import CLEARANCE_GROUPS
from nonhertz.bearing.ribs import Rib
from nonhertz.errors import InputError
from nonhertz.inputs.assumed import Assumed
from nonhertz.inputs.checks import finite, number_that, positive
from nonhertz.inputs.descriptions import Part, Quantity
from nonhertz.model.body import Body, Plate, Ring, Roller

Array = NDArray[np.float64]
#: Deviation of a raceway from a circle: angles [rad] -> reduction of room [mm].
Shape = Callable[[Array], ArrayLike]

MOST_ROLLERS = 1000
# Fraction of the roller's diameter by which the room between raceways may differ from the clearance.
FITS = 0.02
# Largest radial clearance C over the pitch diameter. Motions of the ring are assumed small: where it is off-centre by
# C / 2 the gap has an error of C^2 / (4 pitch), 0.5 % of C / 2 at 0.01.
MOST_CLEARANCE = 0.01
MOST_ANGLE = math.radians(45.0)
RACEWAY = "make it with Ring, or with Plate for washers"
DENSITY = "give it in t/mm^3, 7.85e-9 for steel"


def function_of_angle(name: str, value: Any, remedy: str) -> None:
    """Refuse anything but a function of the angle."""
    if not callable(value):
        raise InputError(name, value, "be a function of the angle", remedy)


def refuse_large_clearance(name: str, clearance: float, radial: float, pitch: float) -> None:
    """Refuse a clearance, axial or radial, whose radial one is not small in a row of this pitch diameter [mm]."""
    if abs(radial) > MOST_CLEARANCE * pitch:
        most = abs(clearance / radial) * MOST_CLEARANCE * pitch
        condition = f"lie between {-most:.3g} and {mm(most):.3g}, for displacements that are small in this bearing"
        raise InputError(name, clearance, condition, "give it in mm: 20 um are 0.02")


def likely_raceway(values: Mapping[str, Any]) -> type[Body]:
    """Return the class of a raceway without a kind: a washer if it has no diameter."""
    return Plate if values.get("diameter") is None else Ring


#: The bodies of a bearing.
Rollers = Annotated[
    Body,
    Part(
        "the rollers, all identical, with diameter and length; y of their profile points along the bearing's axis, x",
        Body,
        "make them with Roller or Body",
        likely=lambda values: Roller,
    ),
]
InnerRing = Annotated[
    Body,
    Part(
        "the inner ring, with the raceway's diameter, or the shaft washer, which is flat and has none",
        Body,
        RACEWAY,
        likely=likely_raceway,
    ),
]
OuterRing = Annotated[
    Body,
    Part(
        "the outer ring, with the raceway's diameter as a negative number, or the housing washer, which is flat and "
        "has none",
        Body,
        RACEWAY,
        likely=likely_raceway,
    ),
]
PITCH = Quantity(
    "mm",
    "the pitch diameter, of the circle of the rollers' centres; the mean of both raceways if left out",
    positive,
    "give the pitch diameter in mm",
)
CLEARANCE = Quantity(
    "mm",
    "internal clearance of a row: radial, for tapered bearings axial, as if a second, opposed row located the ring; "
    "negative: preload",
    finite,
    "give the internal clearance in mm, or its group",
    dict.fromkeys(CLEARANCE_GROUPS, "group of ISO 5753-1"),
)
NO_CLEARANCE = Assumed("no clearance", "loads of rollers, displacements, pressures and L10r")
BORE = "give the nominal bore in mm"
OUTSIDE = "give the nominal outside diameter in mm"
ANGLE = Quantity(
    "rad",
    "contact angle of tapered and spherical bearings, between the normal of the outer raceway and the radial plane",
    number_that(lambda value: value <= MOST_ANGLE, f"not exceed {MOST_ANGLE:.4g} rad, 45 degrees", positive),
    "give it in rad: 12 degrees are 0.21",
)
RIB = Part(
    "contact of the inner ring's rib with the rollers of a tapered bearing, or of all ribs with those of a cylindrical "
    "one; typical values if left out",
    Rib,
    "make one with nonhertz.bearing.Rib, or leave it out",
)
