"""Features that strips cannot represent: relief that also varies across the contact.

Every feature is a callable value that takes positions x, y [mm] and returns a relief [mm], positive where material is
removed, which is added to the gap of the bodies. Any function of x and y can be used as well.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.amounts import mm
from nonhertz.errors import InputError
from nonhertz.inputs.checks import finite, not_negative, number_that, positive
from nonhertz.inputs.descriptions import Quantity
from nonhertz.inputs.fields import Input, cross_check, input_class

Array = NDArray[np.float64]

DIRECTIONS = {"across": 0.0, "along": 0.5 * math.pi}


_CENTRE_REMEDY = "give the middle of the dent in mm"
_SHOULDER_REMEDY = "give the outer diameter of the shoulder in mm, or leave it out"


@input_class(kw_only=True)
class Dent(Input):
    """A round dent, such as an over-rolled hard particle leaves in a raceway, with an optional shoulder.

    The bowl is depth cos^2(pi s / diameter) within s = diameter / 2 of its centre, with a smooth rim. The
    shoulder is material pushed up around it: -shoulder sin^2(2 pi (s - diameter/2) / (shoulder_diameter - diameter))
    between the two circles.

    Raises
    ------
    InputError
        If a value is out of range.

    Examples
    --------
    >>> dent = Dent(depth=0.003, diameter=0.4, shoulder=0.0005)
    >>> dent([0.0, 0.2, 0.26], 0.0).round(6).tolist()
    [0.003, 0.0, -0.0005]
    """

    x: Annotated[float, Quantity("mm", "position of its centre across the contact", finite, _CENTRE_REMEDY)] = 0.0
    y: Annotated[float, Quantity("mm", "position of its centre along the contact", finite, _CENTRE_REMEDY)] = 0.0
    depth: Annotated[float, Quantity("mm", "depth of the bowl", positive, "give the depth of the dent in mm")]
    diameter: Annotated[float, Quantity("mm", "diameter of the bowl", positive, "give the diameter of the dent in mm")]
    shoulder: Annotated[
        float,
        Quantity(
            "mm",
            "height of the material pushed up around it",
            not_negative,
            "give the height of the shoulder in mm, or leave it out",
        ),
    ] = 0.0
    shoulder_diameter: Annotated[
        float | None,
        Quantity(
            "mm",
            "outer diameter of the shoulder, 1.6 times that of the bowl if left out",
            positive,
            _SHOULDER_REMEDY,
        ),
    ] = None

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.shoulder_diameter is None:
            object.__setattr__(self, "shoulder_diameter", 1.6 * self.diameter)

    @cross_check("diameter", "shoulder_diameter")
    def _check_shoulder(self) -> None:
        if self.shoulder_diameter is not None and self.shoulder_diameter <= self.diameter:
            condition = f"exceed the diameter of {mm(self.diameter):g}"
            raise InputError("shoulder_diameter", self.shoulder_diameter, condition, _SHOULDER_REMEDY)

    @property
    def _outer(self) -> float:
        assert self.shoulder_diameter is not None
        return self.shoulder_diameter

    def __call__(self, x: ArrayLike, y: ArrayLike) -> Array:
        """Return the relief [mm] at positions ``x``, ``y`` [mm], broadcast against each other."""
        away = np.hypot(np.asarray(x, dtype=float) - self.x, np.asarray(y, dtype=float) - self.y)
        bowl = np.cos(math.pi * np.minimum(away / self.diameter, 0.5)) ** 2
        into = (2.0 * away - self.diameter) / (self._outer - self.diameter)
        relief: Array = self.depth * bowl - self.shoulder * np.sin(math.pi * np.clip(into, 0.0, 1.0)) ** 2
        return relief


@dataclass(frozen=True, kw_only=True)
class Waviness:
    """Waves in any direction: relief amplitude (1 - cos(2 pi s / wavelength + phase)), s along the direction.

    Parameters
    ----------
    amplitude : float
        Half the height from trough to crest [mm].
    wavelength : float
        Distance from crest to crest [mm], positive.
    direction : str or float
        Direction of propagation: ``"across"`` (x; ridges run along the contact), ``"along"``
        (y), or an angle from x towards y [rad].
    phase : float
        Phase at the origin [rad]; zero puts a crest, with no relief, there.

    Raises
    ------
    InputError
        If a value is out of range.

    Examples
    --------
    >>> Waviness(amplitude=0.001, wavelength=0.5, direction="along")(0.0, [0.0, 0.25]).round(6).tolist()
    [0.0, 0.002]
    """

    amplitude: float
    wavelength: float
    direction: str | float = "across"
    phase: float = 0.0

    def __post_init__(self) -> None:
        not_negative("amplitude", self.amplitude, "give half of the height of the waves in mm")
        positive("wavelength", self.wavelength, "give the distance from crest to crest in mm")
        finite("phase", self.phase, "give the phase at the origin in rad")
        if not (isinstance(self.direction, str) and self.direction in DIRECTIONS):
            finite("direction", self.direction, "write 'across', 'along' or an angle from x in rad")  # type: ignore[arg-type]

    @property
    def angle(self) -> float:
        """The direction as an angle from x towards y [rad]."""
        return DIRECTIONS[self.direction] if isinstance(self.direction, str) else float(self.direction)

    def __call__(self, x: ArrayLike, y: ArrayLike) -> Array:
        """Return the relief [mm] at positions ``x``, ``y`` [mm], broadcast against each other."""
        along = np.asarray(x, dtype=float) * math.cos(self.angle) + np.asarray(y, dtype=float) * math.sin(self.angle)
        relief: Array = self.amplitude * (1.0 - np.cos(2.0 * math.pi * along / self.wavelength + self.phase))
        return relief


@dataclass(frozen=True, kw_only=True)
class ChamferRun:
    """A chamfer whose start varies around the roller, as when it is ground askew: its edge is a slanted line.

    The relief is slope times the distance beyond the edge y = start + skew x, towards the end of the body. Within
    ``blend`` of the edge a parabola rounds the corner; at a sharp corner the pressure would be singular.

    Parameters
    ----------
    start : float
        Position where the chamfer begins on the centre line [mm]; it extends towards +y if positive, else towards -y.
    slope : float
        Tangent of the angle of the chamfer, positive.
    skew : float
        Slope dy/dx of its edge [-].
    blend : float
        Half the length over which the corner is rounded [mm], zero for a sharp one.

    Raises
    ------
    InputError
        If a value is out of range.

    Examples
    --------
    >>> ChamferRun(start=9.0, slope=0.1)(0.0, [8.0, 9.5]).round(6).tolist()
    [0.0, 0.05]
    """

    start: float
    slope: float
    skew: float = 0.0
    blend: float = 0.0

    def __post_init__(self) -> None:
        remedy = "give the position where the chamfer begins in mm, positive for the end at high y"
        number_that(lambda start: start != 0.0, "not be zero")("start", self.start, remedy)
        positive("slope", self.slope, "give the tangent of the angle of the chamfer")
        finite("skew", self.skew, "give the slope dy/dx of the chamfer's edge")
        not_negative("blend", self.blend, "give half of the rounded length in mm, or leave it out")

    def __call__(self, x: ArrayLike, y: ArrayLike) -> Array:
        """Return the relief [mm] at positions ``x``, ``y`` [mm], broadcast against each other."""
        edge = self.start + self.skew * np.asarray(x, dtype=float)
        beyond = math.copysign(1.0, self.start) * (np.asarray(y, dtype=float) - edge)
        if self.blend == 0.0:
            return self.slope * np.maximum(beyond, 0.0)
        into = np.clip(beyond + self.blend, 0.0, 2.0 * self.blend)
        relief: Array = self.slope * (into**2 / (4.0 * self.blend) + np.maximum(beyond - self.blend, 0.0))
        return relief
