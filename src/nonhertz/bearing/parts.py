"""What fields of bearings say of themselves: bodies, diameters, clearance and contact angle."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Annotated, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.bearing.fits import CLEARANCE_GROUPS
from nonhertz.bearing.ribs import Rib
from nonhertz.errors import InputError
from nonhertz.inputs.assumed import Assumed
from nonhertz.inputs.checks import finite, number_that, positive
from nonhertz.inputs.descriptions import Part, Quantity
from nonhertz.model.body import Body, Plate, Ring, Roller

Array = NDArray[np.float64]
#: How far a raceway lies from a circle: at angles [rad], how much less room it leaves [mm].
Shape = Callable[[Array], ArrayLike]

MOST_ROLLERS = 1000
# Of the roller's diameter: by how much raceways may leave more or less room for it than the clearance says.
FITS = 0.02
# Of the pitch diameter: the largest radial clearance C. Motions of the ring are taken as small, and where it is off its
# centre by C / 2 the gap is off by C^2 / (4 pitch), at 0.01 by 0.5 % of C / 2.
MOST_CLEARANCE = 0.01
MOST_ANGLE = math.radians(45.0)
RACEWAY = "make it with Ring, or with Plate for washers"
DENSITY = "give it in t/mm^3, 7.85e-9 for steel"


def function_of_angle(name: str, value: Any, remedy: str) -> None:
    """Refuse what is not a function of the angle."""
    if not callable(value):
        raise InputError(name, value, "be a function of the angle", remedy)


def likely_raceway(values: Mapping[str, Any]) -> type[Body]:
    """Return the class of a raceway without a kind: a washer has no diameter."""
    return Plate if values.get("diameter") is None else Ring


#: The bodies of a bearing.
Rollers = Annotated[
    Body,
    Part(
        "the rollers, all identical, with diameter and length; y of their profile goes along the bearing's axis, x",
        Body,
        "make them with Roller or Body",
        likely=lambda values: Roller,
    ),
]
InnerRing = Annotated[
    Body,
    Part(
        "the inner ring, its diameter that of the raceway, or the shaft's washer, which is flat and has none",
        Body,
        RACEWAY,
        likely=likely_raceway,
    ),
]
OuterRing = Annotated[
    Body,
    Part(
        "the outer ring, its diameter that of the raceway and negative, or the housing's washer, which is flat and has "
        "none",
        Body,
        RACEWAY,
        likely=likely_raceway,
    ),
]
PITCH = Quantity(
    "mm",
    "the diameter of the circle of the rollers' middles; the mean of both raceways if left out",
    positive,
    "give that of the rollers' middles in mm",
)
CLEARANCE = Quantity(
    "mm",
    "internal clearance of a row: from one side to the other the inner ring moves by so much, along the axis for "
    "tapered bearings, up to where a second row like this would hold it, and across it for others; negative: preload",
    finite,
    "give the internal clearance in mm, or its group",
    dict.fromkeys(CLEARANCE_GROUPS, "group of ISO 5753-1"),
)
NO_CLEARANCE = Assumed("no clearance", "loads of rollers, displacements, pressures and L10r")
BORE = "give the nominal bore in mm"
OUTSIDE = "give the nominal outside diameter in mm"
ANGLE = Quantity(
    "rad",
    "the angle between the normal of the outer raceway and the radial plane, of tapered and spherical bearings",
    number_that(lambda value: value <= MOST_ANGLE, f"not exceed {MOST_ANGLE:.4g} rad, 45 degrees", positive),
    "give it in rad: 12 degrees are 0.21",
)
RIB = Part(
    "where the inner ring's rib touches the rollers of a tapered bearing, or all ribs those of a cylindrical one; a "
    "usual place if left out",
    Rib,
    "make one with nonhertz.bearing.Rib, or leave it out",
)
