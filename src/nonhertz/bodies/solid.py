"""What must be known about bodies, and about the pressure across their contact, to compute how loads act."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]


class Elastic(Protocol):
    """Elastic constants."""

    @property
    def poisson(self) -> float:
        """Poisson's ratio."""

    @property
    def compliance(self) -> float:
        """K = (1 - nu^2) / (pi E) [1/MPa]."""


class Solid(Protocol):
    """The part of a body that affects how loads act: `nonhertz.Body` is one."""

    @property
    def material(self) -> Elastic:
        """Elastic constants."""

    @property
    def diameter(self) -> object:
        """Diameter across the contact [mm]: a number, a function of y, or None for a flat body."""

    @property
    def bore(self) -> float | Callable[[Array], ArrayLike] | None:
        """Diameter of the bore [mm]: a number, a function of the distance from the middle, or None."""

    @property
    def length(self) -> float | None:
        """Distance between the side faces [mm]; None for an unbounded body."""

    @property
    def faces(self) -> tuple[float, float]:
        """Axial positions of the side faces [mm], infinite for an unbounded body."""

    @property
    def face_weights(self) -> tuple[float, float]:
        """Weights of the images about the side faces; zero where a face is not freed or does not exist."""

    @property
    def free_faces(self) -> tuple[bool, bool]:
        """Whether the side faces are freed exactly: what images leave on them is taken away, too."""

    @property
    def corner_angles(self) -> tuple[float, float]:
        """Angles between the surface and the side faces at low and high y, within the body [rad]."""

    @property
    def images(self) -> int | str:
        """Number of mirror images per face, or ``"series"``."""

    def curvature(self, y: Array) -> Array:
        """Return the curvature across the contact at ``y`` [1/mm]."""


class Pair(Protocol):
    """Two bodies in contact: `nonhertz.Contact` is one."""

    @property
    def a(self) -> Solid:
        """One body."""

    @property
    def b(self) -> Solid:
        """The other."""

    @property
    def compliance(self) -> float:
        """Sum of both compliances K [1/MPa]."""

    @property
    def interval(self) -> tuple[float, float]:
        """The axial interval on which both bodies can touch [mm]."""

    def curvature(self, y: Array) -> Array:
        """Return the combined curvature across the contact at ``y`` [1/mm]."""


class Shape(Protocol):
    """The far-field constants of a pressure distribution across the contact: a strip element, or `HERTZ`."""

    @property
    def far_constant(self) -> float:
        """-int phi ln|xi| of the shape phi, whose integral is 1, over its half-width."""

    @property
    def hertz_ratio(self) -> float:
        """Half-width of the Hertz line contact of equal load over that of the shape."""


@dataclass(frozen=True)
class _Hertz:
    far_constant: float = math.log(2.0) + 0.5
    hertz_ratio: float = 1.0


#: The semi-ellipse of a line contact.
HERTZ: Shape = _Hertz()
