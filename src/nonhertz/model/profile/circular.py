"""Profiles made of circular arcs: crowned, partially crowned, and two radii."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Annotated

import numpy as np
from numpy.typing import ArrayLike

from nonhertz.amounts import mm
from nonhertz.errors import InputError
from nonhertz.inputs.checks import not_negative, number_that, positive
from nonhertz.inputs.descriptions import Flag, Quantity
from nonhertz.model.profile.base import Array, Formula, Profile
from nonhertz.model.profile.kind import kind


def drop_of_circle(radius: float, y: ArrayLike) -> Array:
    """Drop [mm] of a circle at the distance ``y`` from its summit; infinite beyond the circle."""
    size, distance = abs(radius), np.abs(y)
    inside = np.maximum((size - distance) * (size + distance), 0.0)
    # R - sqrt(R^2 - y^2) would lose the few micrometres that matter to cancellation if R is metres.
    drop = distance**2 / (size + np.sqrt(inside))
    return np.where(distance <= size, math.copysign(1.0, radius) * drop, np.inf)


@dataclass(frozen=True)
class Arcs(Formula):
    """A middle and two ends, each a circular arc, the same on both sides.

    The middle has its summit at y = 0 and ends at ``junction``; the arc of the positive end has its summit at
    ``end_summit`` (it applies only beyond ``junction``). An infinite ``radius`` makes a straight middle.
    """

    radius: float
    end_radius: float
    junction: float
    end_summit: float

    def relief_at(self, y: Array) -> Array:
        """Return the relief [mm]; infinite beyond the point where an arc becomes vertical."""
        distance = np.abs(y)
        end = drop_of_circle(self.end_radius, np.maximum(distance, self.junction) - self.end_summit)
        if math.isfinite(self.radius):
            end = drop_of_circle(self.radius, np.minimum(distance, self.junction)) + end
        return np.asarray(end - self._end_at_junction)

    @cached_property
    def _end_at_junction(self) -> float:
        return float(drop_of_circle(self.end_radius, self.junction - self.end_summit))

    @property
    def bends(self) -> tuple[float, ...]:
        """Positions where the arcs meet, if there is a middle."""
        return (-self.junction, self.junction) if self.junction > 0.0 else ()


_not_zero = number_that(lambda value: value != 0.0, "not be zero")


@kind(by_drop=("radius",))
def crown(
    radius: Annotated[
        float,
        Quantity(
            "mm",
            "the crown radius R along the axis, positive for a crown, negative for a hollow, higher at the ends",
            _not_zero,
            "give the crown radius in mm, negative for a hollow profile",
        ),
    ],
    centre: Annotated[
        float,
        Quantity(
            "mm",
            "the position y0 of the summit from the middle of the body",
            remedy="give the position of the summit in mm",
        ),
    ] = 0.0,
) -> Profile:
    """Return a crowned profile: one circular arc over the whole length.

    Relief = R - sqrt(R^2 - (y - y0)^2), about (y - y0)^2 / (2 R); infinite for abs(y - y0) > abs(R).

    References
    ----------
    Geometry of the circle; "fully crowned" in T. A. Harris and M. N. Kotzalas, Rolling Bearing Analysis, 5th
    edition, CRC Press 2006.

    Examples
    --------
    >>> round(float(crown(radius=1000).relief(10.0)), 9)
    0.05000125
    """
    arcs = Arcs(math.inf, radius, junction=0.0, end_summit=0.0)
    return arcs.shifted(centre) if centre != 0.0 else arcs


def _outside_the_middle(radius: float, straight: float, blended: bool) -> None:
    if not blended and 0.5 * straight > radius:
        condition = f"not exceed twice the radius of {mm(radius):g}"
        raise InputError("straight", straight, condition, "shorten it or raise the radius")


@kind(by_drop=("radius", "straight"), cross_checks=(_outside_the_middle,))
def partial_crown(
    radius: Annotated[
        float,
        Quantity("mm", "the radius R of the arcs along the axis", positive, "give the radius of the end arcs in mm"),
    ],
    straight: Annotated[
        float,
        Quantity(
            "mm",
            "the length of the straight middle, 0 for a crown",
            not_negative,
            "give the length of the straight middle in mm, 0 for none",
        ),
    ],
    blended: Annotated[
        bool,
        Flag(
            "whether the arcs leave the straight middle tangentially",
            "write true for arcs that leave the middle without a slope",
        ),
    ] = True,
) -> Profile:
    """Return a partially crowned profile: a straight middle and a circular arc at each end.

    Two shapes go by this name. Blended, the arcs begin at the ends of the straight middle with zero slope
    ("tangential"): relief = R - sqrt(R^2 - s^2) with s = abs(y) - straight / 2. Not blended, both ends belong
    to one arc with its summit in the middle of the body, whose top the straight part cuts off, so that
    they meet it at the angle asin(straight / (2 R)): relief = sqrt(R^2 - straight^2 / 4) - sqrt(R^2 - y^2).

    References
    ----------
    The two shapes are "tangential crowning" and "crowning" in the manual of the MESYS bearing software,
    https://www.mesys.ag/manual/crowning.html.

    Examples
    --------
    >>> round(float(partial_crown(radius=500, straight=10).relief(10.0)), 9)
    0.025000625
    >>> round(float(partial_crown(radius=500, straight=10, blended=False).relief(10.0)), 9)
    0.075009377
    """
    half = 0.5 * straight
    return Arcs(math.inf, radius, junction=half, end_summit=half if blended else 0.0)


def _within_the_circle(radius: float, middle: float) -> None:
    if middle >= 2.0 * radius:
        condition = f"be less than twice the radius of {mm(radius):g}"
        raise InputError("middle", middle, condition, "shorten it or raise the radius")


@kind(by_drop=("end_radius", "radius"), cross_checks=(_within_the_circle,))
def two_radius(
    radius: Annotated[
        float,
        Quantity(
            "mm",
            "the radius R1 of the middle arc along the axis, usually the larger one",
            positive,
            "give the radius of the middle arc in mm",
        ),
    ],
    end_radius: Annotated[
        float,
        Quantity(
            "mm", "the radius R2 of the end arcs along the axis", positive, "give the radius of the end arcs in mm"
        ),
    ],
    middle: Annotated[
        float,
        Quantity(
            "mm",
            "the length of the middle arc, below twice R1",
            positive,
            "give the length of the middle arc in mm",
        ),
    ],
) -> Profile:
    """Return a profile of two radii: one arc in the middle, another at the ends, tangential where they meet.

    For abs(y) <= y1 = middle / 2 the relief is R1 - sqrt(R1^2 - y^2); beyond y1 it follows the circle of radius
    R2 that has the same slope there and whose summit lies at y1 (1 - R2 / R1).

    References
    ----------
    "Two tangential radii" in the manual of the MESYS bearing software,
    https://www.mesys.ag/manual/crowning.html.

    Examples
    --------
    >>> profile = two_radius(radius=5000, end_radius=500, middle=10)
    >>> round(float(profile.relief(5.0)), 7), round(float(profile.relief(10.0)), 7)
    (0.0025, 0.0325009)
    """
    half = 0.5 * middle
    return Arcs(radius, end_radius, half, end_summit=half * (1.0 - end_radius / radius))
