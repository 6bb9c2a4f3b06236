"""Out-of-round shapes of rings as values: from numbers at angles, or from Fourier terms, and sums of them.

A shape is a function of the angle [rad] from y towards z that returns the deviation from a circle [mm], positive for
less room: where an inner raceway bulges outwards or an outer one inwards. Shapes are compared by their numbers, unlike
functions, so that bearings with equal shapes are equal.

Bearings are solved at rest. An outer ring's shape is stationary, as in an oval housing; an inner ring's shape turns
with it, and a solution holds for one instant: `RingShape.turned` gives others.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Annotated, Any, Literal, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.amounts import mm
from nonhertz.errors import InputError
from nonhertz.inputs.checks import finite, numbers, whole
from nonhertz.inputs.descriptions import Count, Part, Quantities, Quantity, Several, Word
from nonhertz.inputs.fields import Input, cross_check, input_class

Array = NDArray[np.float64]
#: The curve through numbers at angles.
Curve = Literal["cubic", "linear"]

MOST_ORDER = 10_000
MOST_POINTS = 100_000
_TURN = 2.0 * math.pi
_CLOSED = 1e-9  # of a turn, within which two angles are the same
# Permitted error of a rounded last angle that closes the ring, such as 6.2832 rad: over a turn, over the smallest step.
_ROUNDED, _OF_STEP = 1e-4, 0.1
_ANGLES = "give a row of angles in rad, within one turn"
_DEVIATIONS = "give as many lengths in mm as angles"
_TERMS = "give a mapping such as {2: 0.005}, or {2: (0.005, 0.3)} with the angle of a crest"


@input_class()
class Wave(Input):
    """One wave around a ring."""

    waves: Annotated[
        int,
        Count(
            "the number of waves around the ring: 0 is a size error, 1 an eccentricity, 2 an oval",
            0,
            MOST_ORDER,
            "give the number of waves around the ring",
        ),
    ]
    amplitude: Annotated[float, Quantity("mm", "its amplitude, half the height from trough to crest")]
    phase: Annotated[float, Quantity("rad", "angle of a crest, from y towards z; a crest leaves least room")] = 0.0


@input_class()
class Waves(Input):
    """A ring's shape as a sum of waves."""

    terms: Annotated[
        tuple[Wave, ...],
        Several(Part("the waves, which add", Wave, "write [{ waves = 2, amplitude = '5 um' }]"), MOST_ORDER + 1),
    ]

    def __post_init__(self) -> None:
        super().__post_init__()
        object.__setattr__(self, "terms", tuple(sorted(self.terms, key=lambda wave: wave.waves)))

    @cross_check("terms")
    def _check_orders(self) -> None:
        known: set[int] = set()
        for position, wave in enumerate(self.terms, start=1):
            if wave.waves in known:
                remedy = "give each number of waves one amplitude and phase"
                raise InputError(f"terms[{position}].waves", wave.waves, "occur once", remedy)
            known.add(wave.waves)

    def at(self, angle: Array) -> Array:
        """Return the deviation [mm] at angles [rad]."""
        deviation = np.zeros_like(angle)
        for wave in self.terms:
            deviation += wave.amplitude * np.cos(wave.waves * (angle - wave.phase))
        return deviation

    def changed(self, turn: float, factor: float) -> Waves:
        """Return the same turned [rad] and multiplied."""
        return Waves(tuple(Wave(wave.waves, factor * wave.amplitude, wave.phase + turn) for wave in self.terms))


@input_class()
class Deviations(Input):
    """A ring's shape from deviations at angles, in ascending order; the first follows the last."""

    angle: Annotated[tuple[float, ...], Quantities("rad", "angles from y towards z, within one turn")]
    deviation: Annotated[
        tuple[float, ...], Quantities("mm", "deviations from a circle at these angles, positive for less room")
    ]
    curve: Annotated[
        Curve, Word("curve through them: 'cubic' or 'linear'", "write 'cubic' or 'linear'", get_args(Curve))
    ] = "cubic"

    def __post_init__(self) -> None:
        super().__post_init__()
        for name, values in zip(("angle", "deviation"), self._sort_open(), strict=True):
            object.__setattr__(self, name, tuple(values.tolist()))

    @cross_check("angle")
    def _check_angle(self) -> None:
        if len(self.angle) < 2:
            raise InputError("angle", self.angle, "be a row of at least two angles", _ANGLES)
        if len(self.angle) > MOST_POINTS:
            raise InputError("angle", len(self.angle), f"hold no more than {MOST_POINTS:,} angles", "give fewer")

    @cross_check("angle", "deviation")
    def _check_turn(self) -> None:
        if len(self.deviation) != len(self.angle):
            raise InputError("deviation", self.deviation, f"be a row of {len(self.angle)} lengths", _DEVIATIONS)
        places, _ = self._sort_open()
        if np.any(np.diff(places) <= _CLOSED * _TURN):
            twice = float(places[:-1][np.diff(places) <= _CLOSED * _TURN][0])
            raise InputError("angle", twice, "occur once", _ANGLES)

    def _sort_open(self) -> tuple[Array, Array]:
        """Return angles and deviations in ascending order, without the one that closes the ring."""
        order = np.argsort(self.angle, kind="stable")
        places, values = np.array(self.angle)[order], np.array(self.deviation)[order]
        span = float(places[-1] - places[0])
        rounding = max(_CLOSED * _TURN, min(_ROUNDED * _TURN, _OF_STEP * float(np.diff(places).min())))
        if span > _TURN + rounding:
            condition = f"span no more than one turn of {_TURN:.6g} rad"
            raise InputError("angle", span, condition, "give angles in rad, 360 degrees are 6.2832")
        if span < _TURN - rounding:
            return places, values
        if abs(values[-1] - values[0]) > 1e-6 * max(float(np.ptp(values)), 1e-6):
            condition = f"be the same where the ring closes, {mm(values[0]):.6g}"
            remedy = "leave out the angle that is a turn after the first"
            raise InputError("deviation", float(values[-1]), condition, remedy)
        return places[:-1], values[:-1]

    def at(self, angle: Array) -> Array:
        """Return the deviation [mm] at angles [rad]."""
        return np.asarray(self._curve(np.mod(angle - self.angle[0], _TURN)))

    @cached_property
    def _curve(self) -> Callable[[Array], Array]:
        places = np.append(self.angle, self.angle[0] + _TURN) - self.angle[0]
        values = np.append(self.deviation, self.deviation[0])
        if self.curve == "linear" or len(self.angle) < 3:
            return lambda angle: np.interp(angle, places, values)
        from scipy.interpolate import CubicSpline

        curve: Callable[[Array], Array] = CubicSpline(places, values, bc_type="periodic")
        return curve

    def changed(self, turn: float, factor: float) -> Deviations:
        """Return the same turned [rad] and multiplied."""
        angle, deviation = (value + turn for value in self.angle), (factor * value for value in self.deviation)
        return replace(self, angle=tuple(angle), deviation=tuple(deviation))


@dataclass(frozen=True)
class RingShape:
    """Deviation of a raceway from a circle; called with angles [rad], it returns lengths [mm].

    Made with `fourier_shape`, `tabulated_shape` and ``+``.

    Attributes
    ----------
    parts : tuple
        The terms of the sum.
    """

    parts: tuple[Waves | Deviations, ...]

    def __call__(self, angle: ArrayLike) -> Array:
        """Return the deviation from a circle at angles, positive for less room.

        Parameters
        ----------
        angle : array_like
            Angles from y towards z [rad].

        Returns
        -------
        array
            Deviations [mm], of the shape of ``angle``.
        """
        places = numbers("angle", angle, "give angles in rad")
        return np.asarray(np.sum([part.at(places) for part in self.parts], axis=0))

    def turned(self, by: float) -> RingShape:
        """Return the shape of the ring after a rotation.

        Parameters
        ----------
        by : float
            Angle of rotation from y towards z [rad].
        """
        finite("by", by, "give the angle in rad")
        return RingShape(tuple(part.changed(float(by), 1.0) for part in self.parts))

    def scaled(self, by: float) -> RingShape:
        """Return the shape with all deviations multiplied.

        Parameters
        ----------
        by : float
            Factor; -1 if deviations are positive for more room.
        """
        finite("by", by, "give a number")
        return RingShape(tuple(part.changed(0.0, float(by)) for part in self.parts))

    def __add__(self, other: RingShape) -> RingShape:
        return RingShape(self.parts + other.parts) if isinstance(other, RingShape) else NotImplemented


def fourier_shape(terms: Mapping[int, float | tuple[float, float]]) -> RingShape:
    """Return a shape from its waves around the ring.

    Parameters
    ----------
    terms : mapping of int to float or (float, float)
        Order n -> amplitude a [mm], or amplitude and angle of a crest [rad]: the sum of a cos(n (angle - crest)). Order
        0 is a size error, 1 an eccentricity, 2 an oval.

    Returns
    -------
    RingShape
        The shape; a crest leaves least room.

    Raises
    ------
    InputError
        If an order or amplitude is invalid.

    Examples
    --------
    >>> oval = fourier_shape({2: 0.005})
    >>> oval([0.0, math.pi / 2]).tolist()
    [0.005, -0.005]
    >>> oval == fourier_shape({2: (0.005, 0.0)}), (oval + fourier_shape({3: 0.001}))([0.0]).tolist()
    (True, [0.006])
    """
    if not isinstance(terms, Mapping):
        raise InputError("terms", terms, "be a mapping of orders to amplitudes", _TERMS)
    waves = []
    for order, wave in terms.items():
        place = f"terms[{order!r}]"
        number = whole("order", order, 0, MOST_ORDER, _TERMS)
        row = numbers(place, wave, _TERMS).ravel()
        if row.size not in (1, 2):
            raise InputError(place, wave, "be an amplitude, or an amplitude and an angle", _TERMS)
        waves.append(Wave(number, *row.tolist()))
    return RingShape((Waves(tuple(waves)),))


def tabulated_shape(angle: ArrayLike, deviation: ArrayLike, curve: Curve = "cubic") -> RingShape:
    """Return a shape from numbers at angles, such as measured ones.

    Parameters
    ----------
    angle : array_like, shape (n,)
        Angles from y towards z [rad], n at least 2, within one turn, in any order. An angle one turn after the first
        closes the ring and must have the same deviation.
    deviation : array_like, shape (n,)
        Deviations from a circle [mm], positive for less room.
    curve : {"cubic", "linear"}
        Curve through the numbers: the periodic cubic spline, with continuous curvature, or straight lines. Both close
        the ring; two numbers allow only lines.

    Returns
    -------
    RingShape
        The shape.

    Raises
    ------
    InputError
        If angles and deviations do not describe one turn of a ring.

    Examples
    --------
    >>> shape = tabulated_shape([0.0, 1.0, 2.0, 4.0], [0.0, 0.01, 0.0, -0.01], curve="linear")
    >>> shape([0.5, 3.0, 2 * math.pi]).round(4).tolist()
    [0.005, -0.005, 0.0]
    """
    inputs: dict[str, Any] = {"angle": angle, "deviation": deviation, "curve": curve}
    return RingShape((Deviations(**inputs),))
