"""Whole bearings whose loads and lives are known, and what is known of them."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike
from scipy.integrate import quad
from scipy.optimize import newton, root

from claims.claim import Array
from nonhertz import Material, Ring, Roller, Solution, TabulatedDiameter, solve
from nonhertz.bearing import CylindricalRollerBearing, TaperedRollerBearing
from nonhertz.model.profile import Profile, iso_logarithmic, straight

#: Q_max Z / F_r and F_a / (F_r tan alpha) of half a load zone, of very many rollers without clearance, as published for
#: contacts with an exponent of 1.1; the other exponent is that of slices.
STRIBECK, SJOVALL = 4.08, 1.260
EXPONENTS = (1.1, 10.0 / 9.0)


def zone_integral(power: float, *, weighted: bool) -> float:
    """Return the mean over all angles of cos^power, times the cosine if weighted, over half a circle."""

    def integrand(angle: float) -> float:
        return float(max(math.cos(angle), 0.0) ** power * (math.cos(angle) if weighted else 1.0))

    half = 0.5 * math.pi
    return float(quad(integrand, -math.pi, math.pi, points=(-half, half))[0]) / (2.0 * math.pi)


@dataclass(frozen=True)
class LaminaCase:
    """A line of the example of ISO/TS 16281: Z = 14, D = 10, pitch 65, L = 9.6 mm, 41 slices; found independently."""

    clearance: float  # mm
    profiled: bool  # with the profile of the standard, or straight
    tilt: float  # rad
    displacement: float | None  # um, of the inner ring; None if it is not known
    loads: tuple[float, ...]  # N, of the first rollers
    life: float  # 10^6 revolutions, L10r without the standard's function of the edge stress
    edged_life: float  # and with it

    @property
    def name(self) -> str:
        """The line in words."""
        shape = "profile" if self.profiled else "straight"
        return f"{1e3 * self.clearance:.3g} um, {shape}, {1e3 * self.tilt:g} mrad"

    @property
    def bearing(self) -> CylindricalRollerBearing:
        """The bearing."""
        profile = StandardLogarithm() if self.profiled else straight()
        return CylindricalRollerBearing(
            roller=Roller(diameter=10.0, length=9.6, profile=profile), inner=Ring(diameter=55.0),
            outer=Ring(diameter=-75.0), rollers=14, clearance=self.clearance,
        )  # fmt: skip


class StandardLogarithm(Profile):
    """The profile of ISO/TS 16281 of rollers of 10 x 9.6 mm, written down anew."""

    def relief(self, y: ArrayLike) -> Array:
        """Return the relief [mm]."""
        return np.asarray(-0.0035 * np.log(1.0 - (2.0 * np.asarray(y) / 9.6) ** 2))


LAMINA_LOAD, LAMINA_BASIC_LIFE = 4450.0, 2854.0  # N, 10^6 revolutions
LAMINA_CASES = (
    LaminaCase(0.0, False, 0.0, 8.24624, (1298.77,), 29021.0, 10091.0),
    LaminaCase(0.0406, False, 0.0, 32.2223, (1956.26, 1383.92), 9329.5, 3244.1),
    LaminaCase(0.0406, True, 0.0, 35.8148, (1924.78, 1338.05, 91.53), 5213.0, 5027.3),
    LaminaCase(0.0406, True, 1e-3, None, (1914.56,), 4706.2, 4501.1),
    LaminaCase(0.0406, True, 2e-3, None, (1892.98,), 3668.9, 3435.3),
)

#: a_ISO at the viscosity ratio kappa, for e_C C_u / P of `LIMITS`: of five public programs, to all digits.
LIMITS = (0.01, 0.1, 0.5)
LIFE_FACTORS = {
    0.2: (0.109, 0.124, 0.152),
    0.5: (0.130, 0.195, 0.374),
    1.0: (0.169, 0.399, 1.714),
    2.0: (0.186, 0.516, 3.081),
    4.0: (0.203, 0.664, 5.587),
}


@dataclass(frozen=True)
class Masta:
    """NSK HR30306J under 30 kN radial and 9 kN axial load, as MASTA solved it and a public program quotes it."""

    radial: float = 30e3  # N
    axial: float = 9e3
    dynamic: float = 59.5e3  # N: C and C_0 of the catalogue
    static: float = 60e3
    laminae: int = 40
    speed: float = 1500.0  # 1/min, of the inner ring
    viscosity: float = 55.23  # mm^2/s, of the oil
    loads: tuple[float, ...] = (8487.0, 7757.0, 5773.0, 3175.0, 949.0, 0.0)  # N, of the first rollers
    life: float = 19.43  # 10^6 revolutions, L10r
    life_factor: float = 1.154  # a_ISO


MASTA = Masta()
#: What that program finds itself: L10r [10^6 revolutions] and a_ISO.
PROGRAM_LIFE, PROGRAM_FACTOR = 20.81, 1.139
#: The same found apart from here by the slices of ISO/TS 16281: displacement [um], L10r without and with the function
#: of the edge stress [10^6 revolutions], and a_ISO.
SLICES_DISPLACEMENT, SLICES_LIFE, SLICES_EDGED_LIFE, SLICES_FACTOR = 30.80, 21.66, 20.71, 1.18

_RELIEFS = {  # um over mm from the middle, highest power first
    "roller": (0.001713, -0.007566, 0.1307, 0.1991, 0.04019),
    "inner": (0.01255, 0.01808, 0.01308, -0.1398, 0.2076),
    "outer": (0.0006185, -0.001334, 0.2418, 0.08751, 0.1606),
}


@dataclass(frozen=True)
class Polynomial(Profile):
    """A profile by powers of the distance from the middle [um over mm], the highest first."""

    coefficients: tuple[float, ...]

    def relief(self, y: ArrayLike) -> Array:
        """Return the relief [mm]."""
        return np.asarray(1e-3 * np.polyval(np.array(self.coefficients), np.asarray(y)))


def hr30306j() -> TaperedRollerBearing:
    """Return the NSK HR30306J with the profiles of its rollers and raceways."""
    steel, angle, mean, pitch, length = Material(210e3, 0.3), math.radians(11.859), 10.53019, 51.56, 11.65
    across = mean / math.cos(angle)
    roller, inner, outer = (Polynomial(_RELIEFS[name]) for name in ("roller", "inner", "outer"))
    taper = TabulatedDiameter((-0.5 * length, 0.5 * length), (10.9371, 10.123273))
    return TaperedRollerBearing(
        roller=Roller(diameter=taper, length=length, profile=roller, material=steel),
        inner=Ring(diameter=pitch - across, profile=inner, material=steel),
        outer=Ring(diameter=-(pitch + across), profile=outer, material=steel),
        rollers=14, pitch_diameter=pitch, contact_angle=angle,
    )  # fmt: skip


NU206_LOAD, NU206_TILT = 20e3, 1e-3  # N, rad
_SPRING = 250e3  # N/mm


def nu206() -> CylindricalRollerBearing:
    """Return an NU 206 with the profile of ISO/TS 16281."""
    profile = iso_logarithmic(diameter=9.0, length=8.8)
    return CylindricalRollerBearing(
        roller=Roller(diameter=9.0, length=10.0, effective_length=8.8, profile=profile),
        inner=Ring(diameter=37.5, length=16.0, depth=3.75), outer=Ring(diameter=-55.5, length=16.0, depth=3.25),
        rollers=13, clearance=0.0184,
    )  # fmt: skip


def by_hand(bearing: CylindricalRollerBearing, load: float, tilt: float) -> tuple[float, Array]:
    """Return the displacement of the inner ring [mm] and the loads of its rollers, down to the first idle one [N].

    The rollers' motions and the displacement of the ring are found one after the other, from single contacts solved
    with `nonhertz.solve` alone; the load is along y, towards the first roller.
    """
    cosines = np.cos(2.0 * math.pi / bearing.rollers * np.arange(1 + int(0.25 * bearing.rollers)))
    # All but the first have a twin on the other side of the load.
    weights = cosines * np.where(cosines < 1.0, 2.0, 1.0)

    def loads(moved: float) -> Array:
        return np.array([_borne(bearing, moved * cosine, tilt * cosine) for cosine in cosines])

    # As if springs of the size of two contacts of steel in series bore it.
    start = 0.5 * bearing.clearance + 5.0 * load / bearing.rollers / _SPRING
    moved = float(newton(lambda moved: float(weights @ loads(moved)) / load - 1.0, start, tol=1e-11))
    return moved, loads(moved)


def _borne(bearing: CylindricalRollerBearing, inwards: float, tilt: float) -> float:
    """Return the load of a roller between two contacts, towards which the inner ring moves and tilts."""
    slack = 0.25 * bearing.clearance
    if inwards <= 2.0 * slack:
        return 0.0

    def pressed(motion: Array) -> list[Solution]:
        poses = np.array([inwards, tilt]) - motion, motion
        return [
            solve(contact, approach=float(moved) - slack, tilt=float(turned))
            for contact, (moved, turned) in zip(bearing.contacts, poses, strict=True)
        ]

    def off(motion: Array) -> tuple[float, float]:
        inner, outer = pressed(motion)
        return inner.load - outer.load, inner.moment - outer.moment

    # Of the roller along r, and its own tilt.
    return pressed(root(off, [0.5 * inwards, 0.5 * tilt], tol=1e-11).x)[0].load
