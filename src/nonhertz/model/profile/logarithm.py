"""Logarithmic profiles: the general one, ISO 16281, Johns and Gohar, Fujiwara and Kawase."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from nonhertz.errors import InputError
from nonhertz.inputs.checks import not_negative, number_that, positive
from nonhertz.inputs.descriptions import Quantity
from nonhertz.model.profile.base import Array, Formula, Profile
from nonhertz.model.profile.design_load import (
    COMPLIANCE,
    LENGTH,
    LOAD,
    RADIUS,
    design_amplitude,
    design_half_width,
    line_contact,
)
from nonhertz.model.profile.kind import kind

# The factor with which Johns and Gohar fitted their logarithm to Lundberg's drop at the end; -ln 0.3033 = 1.1930.
_END = 0.3033
# Positions are clipped to these, in mm and in half-lengths, so that no square overflows.
_FAR, _BEYOND = 1e100, 1e150
_MOST_DROP = 700.0  # amplitudes: below exp(-708) numbers lose precision
_LEAST_SHARE = 1e-9  # crowned fraction of the length; less would be lost in rounding of the length


@dataclass(frozen=True)
class Logarithmic(Formula):
    """Relief ``amplitude * ln(1 / (1 - (1 - rest) s^2))`` with s measured from a straight middle to the end.

    ``s = max(0, |y| - straight / 2) / (curved / 2)`` is 1 at the ends, ``|y| = length / 2``; ``curved`` is the length
    of the curved part, both ends together, ``straight = length - curved``. ``rest`` is the value of ``1 - (1 - rest)
    s^2`` at the ends, where the relief is ``amplitude * ln(1 / rest)``, or ``at_end`` if that is less. Beyond the
    point where this value reaches zero the relief is infinite.
    """

    amplitude: float
    length: float
    rest: float
    curved: float
    at_end: float = math.inf

    @property
    def straight(self) -> float:
        """Length of the straight middle [mm]."""
        return self.length - self.curved

    def relief_at(self, y: Array) -> Array:
        """Return the relief [mm]; infinite at and beyond the pole of the logarithm."""
        distance = np.minimum(np.abs(y), _FAR)
        half = 0.5 * self.curved
        share = np.minimum(np.maximum(distance - 0.5 * self.straight, 0.0) / half, _BEYOND)
        # 1 - s, measured from the end: the difference of nearly equal numbers is exact, so it is zero at the end and
        # accurate close to it, where a millionth of the argument makes micrometres of relief.
        to_end = np.maximum((0.5 * self.length - distance) / half, -_BEYOND)
        argument = to_end * (1.0 + share) + self.rest * share**2
        inside = argument > 0.0
        outer = np.where(inside, -np.log(np.where(inside, argument, 1.0)), np.inf)
        # In the middle, s itself is accurate.
        inner = -np.log1p(-(1.0 - self.rest) * np.minimum(share, 0.5) ** 2)
        drop = np.where(to_end > 0.5, inner, outer)
        # With zero amplitude there is a body up to the pole, but none beyond.
        relief = np.where(np.isinf(drop), np.inf, self.amplitude * np.where(np.isinf(drop), 0.0, drop))
        return np.asarray(np.where(to_end >= 0.0, np.minimum(relief, self.at_end), relief) + 0.0)

    @property
    def bends(self) -> tuple[float, ...]:
        """Both ends of the straight middle, if there is one."""
        return (-0.5 * self.straight, 0.5 * self.straight) if self.straight > 0.0 else ()


_share = number_that(lambda value: 0.0 < value <= 1.0, "lie in (0, 1]")
_crowned_share = number_that(lambda value: _LEAST_SHARE <= value <= 1.0, f"lie between {_LEAST_SHARE:g} and 1")


@kind(by_drop=("amplitude",), of_body={"length": "land"})
def logarithmic(
    amplitude: Annotated[
        float, Quantity("mm", "the amplitude A", not_negative, "give the amplitude of the logarithm in mm")
    ],
    length: Annotated[
        float,
        Quantity(
            "mm",
            "the length over which the profile is drawn, excluding the straight middle",
            positive,
            "give the length over which the profile is drawn in mm",
        ),
    ],
    fraction: Annotated[
        float,
        Quantity(
            "",
            "the fraction of the half-length at which the end of the roller lies on the curve, in (0, 1]; at 1 the "
            "relief at the end is infinite, just below 1 it is large but finite",
            _share,
            "give a fraction of the half-length",
        ),
    ] = 1.0,
    straight: Annotated[
        float,
        Quantity(
            "mm",
            "the length of a straight middle",
            not_negative,
            "give the length of the straight middle in mm, 0 for none",
        ),
    ] = 0.0,
) -> Profile:
    """Return a general logarithmic profile.

    Relief = ``amplitude * ln(1 / (1 - (2 y fraction / length)^2))``, with y measured from the end of the
    straight middle if there is one.

    References
    ----------
    G. Lundberg, Elastische Beruehrung zweier Halbraeume, Forschung auf dem Gebiete des Ingenieurwesens 10
    (1939) 201-211, doi:10.1007/BF02584950; the general amplitude and length after P. M. Johns and R. Gohar,
    Roller bearings under radial and eccentric loads, Tribology International 14 (1981) 131-136.

    Examples
    --------
    >>> profile = logarithmic(amplitude=0.005, length=20, fraction=0.9999)
    >>> round(float(profile.relief(10.0)), 6)
    0.042586
    """
    rest = (1.0 - fraction) * (1.0 + fraction)
    return Logarithmic(amplitude, length + straight, rest, curved=length)


_DIAMETER = Quantity(
    "mm", "the roller diameter D (D_we), its mean if tapered", positive, "give the roller's diameter in mm"
)
_EFFECTIVE_LENGTH = Quantity(
    "mm",
    "the effective roller length L (L_we), without the corners",
    positive,
    "give the roller's effective length in mm",
)


@kind(of_body={"diameter": "diameter", "length": "land"})
def iso_logarithmic(
    diameter: Annotated[float, _DIAMETER],
    length: Annotated[float, _EFFECTIVE_LENGTH],
) -> Profile:
    """Return the reference profile of ISO 16281 for cylindrical and needle rollers.

    Up to length = 2.5 diameter: relief = 0.00035 D ln(1 / (1 - (2 y / L)^2)). Longer rollers have a straight
    middle of L - 2.5 D, and beyond it 0.0005 D ln(1 / (1 - ((2 abs(y) - (L - 2.5 D)) / (2.5 D))^2)).

    Returns
    -------
    Profile
        The profile; at abs(y) = length / 2 its relief is infinite.

    Notes
    -----
    Two independent programs that implement ISO/TS 16281:2008 (AxisForge, and minzhun/ISO16281 for the short form) and
    one that implements DIN 26281 (moritzploss/tribology, short form) have the same formulas; see
    docs/explain/standards.md.

    References
    ----------
    ISO/TS 16281:2008 (now ISO 16281), Rolling bearings - Methods for calculating the modified reference
    rating life for universally loaded rolling bearings, profile functions of cylindrical rollers.

    Examples
    --------
    >>> round(float(iso_logarithmic(diameter=10, length=10).relief(2.5)), 8)
    0.00100689
    >>> float(iso_logarithmic(diameter=10, length=40).relief(7.5))
    0.0
    """
    curved = min(length, 2.5 * diameter)
    coefficient = 0.00035 if curved == length else 0.0005
    return Logarithmic(coefficient * diameter, length, rest=0.0, curved=curved)


@kind(of_body={"diameter": "diameter", "length": "land"})
def iso_tapered(
    diameter: Annotated[float, _DIAMETER],
    length: Annotated[float, _EFFECTIVE_LENGTH],
) -> Profile:
    """Return the reference profile of ISO 16281 for tapered rollers of radial and thrust bearings.

    Relief = 0.00045 D ln(1 / (1 - (2 y / L)^2)).

    Returns
    -------
    Profile
        The profile; at abs(y) = length / 2 its relief is infinite.

    Notes
    -----
    Formula and coefficient agree with minzhun/ISO16281 and with what users of the MASTA software read back from its
    profile of that name.

    References
    ----------
    ISO/TS 16281:2008 (now ISO 16281), profile functions of tapered rollers; see `iso_logarithmic`.

    Examples
    --------
    >>> round(float(iso_tapered(diameter=10, length=10).relief(2.5)), 8)
    0.00129457
    """
    return Logarithmic(0.00045 * diameter, length, rest=0.0, curved=length)


@kind(of_body={"diameter": "diameter", "length": "land"})
def iso_thrust(
    diameter: Annotated[float, _DIAMETER],
    length: Annotated[float, _EFFECTIVE_LENGTH],
) -> Profile:
    """Return the reference profile of ISO 16281 for rollers of cylindrical and needle roller thrust bearings.

    It is the same as for cylindrical rollers, `iso_logarithmic`; for tapered rollers of thrust bearings use
    `iso_tapered`.

    Notes
    -----
    That thrust rollers share the functions of radial ones was taken from minzhun/ISO16281, a program that implements
    ISO/TS 16281:2008.

    References
    ----------
    ISO/TS 16281:2008 (now ISO 16281); see `iso_logarithmic`.

    Examples
    --------
    >>> iso_thrust(diameter=8, length=8) == iso_logarithmic(diameter=8, length=8)
    True
    """
    return iso_logarithmic(diameter, length)


@kind(by_drop=("load",), of_body={"length": "land", "radius": "radius"}, cross_checks=(line_contact,))
def johns_gohar(
    load: Annotated[float, LOAD],
    length: Annotated[float, LENGTH],
    radius: Annotated[float, RADIUS],
    compliance: Annotated[float | None, COMPLIANCE] = None,
) -> Profile:
    """Return the profile of Johns and Gohar for a design load: Lundberg's, with a finite slope at the end.

    Relief = A ln(1 / (1 - (1 - 0.3033 b / a) (y / a)^2)), where A = (load / length) (K_a + K_b), a = length /
    2 and b is the Hertz half-width of the line contact at the design load. At the end it is A ln(a / (0.3033
    b)).

    Returns
    -------
    Profile
        The profile, meant as the combined relief of both bodies.

    References
    ----------
    P. M. Johns and R. Gohar, Roller bearings under radial and eccentric loads, Tribology International 14 (1981)
    131-136, in the form of H. Fujiwara and T. Kawase, NTN Technical Review 75 (2007) 140-148.

    Examples
    --------
    >>> profile = johns_gohar(load=20e3, length=20, radius=10)
    >>> round(float(profile.relief(10.0)), 5)
    0.01285
    """
    amplitude = design_amplitude(load, length, compliance)
    half_width = design_half_width(load, length, radius, compliance)
    rest = _END * 2.0 * half_width / length
    return Logarithmic(amplitude, length, rest, curved=length)


def _line_contact_or_end(
    load: float, length: float, radius: float | None, zm: float | None, compliance: float | None
) -> None:
    if zm is None and radius is None:
        raise InputError("zm", zm, "be given where radius is not", "give the relief at the end in mm")
    if zm is None and radius is not None:
        line_contact(load, length, radius, compliance)


@kind(by_drop=("load", "zm"), of_body={"length": "land", "radius": "radius"}, cross_checks=(_line_contact_or_end,))
def fujiwara_kawase(
    load: Annotated[float, LOAD],
    length: Annotated[float, LENGTH],
    radius: Annotated[float | None, RADIUS] = None,
    k1: Annotated[
        float,
        Quantity(
            "",
            "the factor K1 on the load, above 1 for rollers that tilt",
            positive,
            "give the factor on the load, 1 for the design load itself",
        ),
    ] = 1.0,
    k2: Annotated[
        float,
        Quantity(
            "",
            "the fraction K2 of the length that is crowned, from 1e-9 to 1",
            _crowned_share,
            "give the fraction of the length that is crowned",
        ),
    ] = 1.0,
    zm: Annotated[
        float | None,
        Quantity(
            "mm",
            "the relief at the end; if left out, A ln(a / (0.3033 b)) with the Hertz half-width b at the design load, "
            "which for k1 = k2 = 1 gives the profile of Johns and Gohar",
            positive,
            "give the relief at the end in mm, or leave it out for that of Johns and Gohar",
        ),
    ] = None,
    compliance: Annotated[float | None, COMPLIANCE] = None,
) -> Profile:
    """Return the profile of Fujiwara and Kawase: `johns_gohar` with three design parameters.

    With A = k1 (load / length) (K_a + K_b), a = length / 2 and s = (abs(y) - (1 - k2) a) / (k2 a), the relief
    is A ln(1 / (1 - (1 - exp(-zm / A)) s^2)) for s > 0 and zero in the straight middle.

    Returns
    -------
    Profile
        The profile, meant as the relief of both bodies together.

    References
    ----------
    H. Fujiwara and T. Kawase, Logarithmic profiles of rollers in roller bearings and optimization of the
    profiles, NTN Technical Review 75 (2007) 140-148.

    Examples
    --------
    >>> profile = fujiwara_kawase(load=20e3, length=20, k1=1.5, k2=0.6, zm=0.03)
    >>> round(float(profile.relief(10.0)), 9), profile.bends
    (0.03, (-4.0, 4.0))
    """
    amplitude = k1 * design_amplitude(load, length, compliance)
    at_end = math.inf if zm is None else zm
    if zm is None:
        assert radius is not None
        rest = _END * 2.0 * design_half_width(load, length, radius, compliance) / length
    else:
        # Under a light design load the exponential underflows, yet the relief at the end must stay finite.
        rest = math.exp(-zm / amplitude) if zm < _MOST_DROP * amplitude else 0.0
    return Logarithmic(amplitude, length, rest, curved=k2 * length, at_end=at_end)
