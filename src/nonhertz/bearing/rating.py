"""Ratings and life of a bearing: ISO 281, ISO 76 and the laminae of ISO/TS 16281.

    L10  = (C / P)^(10/3)                                       from the equivalent load P
    L10r = {sum_k [(q_ei / q_ci)^(9/2) + (q_ee / q_ce)^(9/2)]}^(-8/9)     from the loads of all laminae k,

q_ei being the mean over all rollers of (f q)^4 to the power 1/4 at the ring that turns against the load, q_ee that of
the power 9/2 at the one that does not, and q_c the capacity of a lamina (`nonhertz.life.capacity`). In both a million
revolutions are the unit, and 90 % of bearings last longer. With lubrication and cleanliness

    a_ISO = 0.1 [1 - (1.5859 - k1 / kappa^k2) (e_C C_u / P)^0.4]^(-9.185), at most 50,

with (k1, k2) = (1.3993, 0.054381) for 0.1 <= kappa < 0.4, (1.2348, 0.19087) for kappa < 1 and (1.2348, 0.071739) up to
4, where P is that of a lamina in the sums of L10r,

    P_k = 0.323 Z cos(alpha) n {[q_ei^(9/2) + (1.038 q_ci / q_ce q_ee)^(9/2)] / [1 + (1.038 q_ci / q_ce)^(9/2)]}^(2/9),

and the damage of a lamina is divided by its factor to the power 9/8. kappa is the viscosity over nu_1, 45000 n^(-0.83)
D_pw^(-1/2) below n = 1000/min and 4500 n^(-1/2) D_pw^(-1/2) above; C_u = C_0 / 8.2, times (100 / D_pw)^0.3 above a
pitch diameter of 100 mm. For other reliabilities than 90 %, a_1 = 0.95 (ln(1/R) / ln(1/0.9))^(2/3) + 0.05, within 0.005
of the standard's table.

The static rating C_0 = 44 (1 - gamma) Z L D cos(alpha) is the load at which 4000 MPa are reached, and the safety S_0 is
C_0 over P_0. The standards are quoted from public programs that agree with each other (the lamina's P_k from one of
them); their text was not available.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nonhertz.bearing.bearings import CylindricalRollerBearing, Paired, RollerBearing, TaperedRollerBearing
from nonhertz.bearing.solution import BearingSolution
from nonhertz.bearing.standard import LAMINAE, standard_slices
from nonhertz.errors import InputError
from nonhertz.inputs.checks import one_of, positive, whole
from nonhertz.life.capacity import Raceway, is_steel
from nonhertz.life.lamina import EDGE_STRESS, EXPONENT, FEWEST, MOST, SLOPE, edge_function, iso_16281, laminae_of
from nonhertz.result.brief import plain_text
from nonhertz.result.numerals import digits

Array = NDArray[np.float64]

MOST_FACTOR = 50.0
LEAST_RATIO, MOST_RATIO = 0.1, 4.0
_BY_RATIO = ((0.4, 1.3993, 0.054381), (1.0, 1.2348, 0.19087), (math.inf, 1.2348, 0.071739))
_STATIC = 44.0  # N/mm^2
_TURNING, _STANDING = 4.0, 4.5  # powers of means over rollers


@dataclass(frozen=True)
class Rating:
    """What a bearing can bear, by ISO 281 and ISO 76.

    Attributes
    ----------
    dynamic : float
        Basic dynamic radial load rating C [N].
    static : float
        Basic static radial load rating C_0 [N].
    inner, outer : float
        Dynamic capacities of one contact Q_ci and Q_ce [N].
    fatigue_limit : float
        Fatigue load limit C_u [N].
    """

    dynamic: float
    static: float
    inner: float
    outer: float
    fatigue_limit: float


def rating(bearing: RollerBearing, *, dynamic: float | None = None, static: float | None = None) -> Rating:
    """Return the ratings of a bearing.

    Parameters
    ----------
    bearing : RollerBearing
        The bearing.
    dynamic, static : float, optional
        C and C_0 of a catalogue [N], in place of those of the standards' formulas.

    Examples
    --------
    >>> import nonhertz as nh
    >>> roller = nh.Roller(diameter=10, length=9.6)
    >>> rings = {"inner": nh.Ring(diameter=55), "outer": nh.Ring(diameter=-75)}
    >>> row = nh.bearing.CylindricalRollerBearing(roller=roller, **rings, rollers=14)
    >>> round(rating(row).dynamic, 1), round(rating(row).inner, 1), round(rating(row).outer, 1)
    (48416.8, 11449.6, 17271.6)
    """
    if not isinstance(bearing, CylindricalRollerBearing | TaperedRollerBearing):
        # Spherical and thrust bearings have other factors.
        condition = "be a cylindrical, needle or tapered roller bearing of one row"
        raise InputError("bearing", type(bearing).__name__, condition, "rate such a row by itself")
    if not all(is_steel(each.material) for each in (bearing.roller, bearing.inner, bearing.outer)):
        raise InputError("bearing", "of other materials", "be of bearing steel", "leave the ratings out")
    inner, outer = raceways(bearing)
    if dynamic is not None:
        positive("dynamic", dynamic, "give the basic dynamic load rating in N")
    if static is not None:
        positive("static", static, "give the basic static load rating in N")
    load = inner.load_rating(bearing.rollers) if dynamic is None else float(dynamic)
    angle = bearing.nominal_angle
    gamma = bearing.roller_diameter * math.cos(angle) / bearing.pitch
    size = bearing.rollers * inner.length * bearing.roller_diameter * math.cos(angle)
    still = _STATIC * (1.0 - gamma) * size if static is None else float(static)
    limit = still / 8.2 * min(1.0, (100.0 / bearing.pitch) ** 0.3)
    of_inner, of_outer = (each.capacity_of(load, bearing.rollers) for each in (inner, outer))
    return Rating(load, still, of_inner, of_outer, limit)


def raceways(bearing: RollerBearing) -> tuple[Raceway, Raceway]:
    """Return both raceways as ISO 281 sees them."""
    low, high = bearing.contacts[0].interval
    of_both = bearing.roller_diameter, high - low, bearing.pitch
    angle = bearing.nominal_angle
    return Raceway(*of_both, True, contact_angle=angle), Raceway(*of_both, False, contact_angle=angle)


def reference_viscosity(speed: float, pitch_diameter: float) -> float:
    """Return nu_1 [mm^2/s], the viscosity at which the surfaces just part.

    Parameters
    ----------
    speed : float
        [1/min].
    pitch_diameter : float
        [mm].

    Examples
    --------
    >>> round(reference_viscosity(1500, 51.56), 2)
    16.18
    """
    positive("speed", speed, "give the speed in 1/min")
    positive("pitch_diameter", pitch_diameter, "give that of the rollers' middles in mm")
    by_speed = 45000.0 * speed**-0.83 if speed < 1000.0 else 4500.0 / math.sqrt(speed)
    return float(by_speed / math.sqrt(pitch_diameter))


def life_factor(viscosity_ratio: float, relative_limit: float) -> float:
    """Return a_ISO [-] of a radial roller bearing.

    Parameters
    ----------
    viscosity_ratio : float
        kappa, at least 0.1; more than 4 counts as 4.
    relative_limit : float
        e_C C_u / P.

    Examples
    --------
    >>> round(life_factor(1.0, 0.5), 3)
    1.714
    """
    positive("viscosity_ratio", viscosity_ratio, "give the viscosity over the reference viscosity")
    positive("relative_limit", relative_limit, "give e_C C_u / P")
    if viscosity_ratio < LEAST_RATIO:
        condition = f"be at least {LEAST_RATIO:g}, below which ISO 281 has no factor"
        raise InputError(
            "viscosity_ratio", viscosity_ratio, condition, "use a thicker oil, or leave out the lubrication"
        )
    kappa = min(viscosity_ratio, MOST_RATIO)
    k1, k2 = next((k1, k2) for below, k1, k2 in _BY_RATIO if kappa < below)
    left = 1.0 - (1.5859 - k1 / kappa**k2) * relative_limit**0.4
    return MOST_FACTOR if left <= 0.0 else min(MOST_FACTOR, 0.1 * left**-9.185)


def reliability_factor(reliability: float) -> float:
    """Return a_1 [-] for a reliability from 0.9 to 0.9995.

    Examples
    --------
    >>> reliability_factor(0.9), round(reliability_factor(0.99), 3)
    (1.0, 0.248)
    """
    positive("reliability", reliability, "give 0.9, or more")
    if not 0.9 <= reliability <= 0.9995:
        raise InputError("reliability", reliability, "lie between 0.9 and 0.9995", "give 0.95 for 95 %")
    return float(0.95 * (math.log(1.0 / reliability) / math.log(1.0 / 0.9)) ** (2.0 / 3.0) + 0.05)


def contamination_factor(viscosity_ratio: float, pitch_diameter: float) -> float:
    """Return e_C [-] of normal cleanliness with circulating oil and a fine filter.

    The only class that two sources confirm; for others give e_C as a number.

    Examples
    --------
    >>> round(contamination_factor(3.413, 51.56), 4)
    0.8174
    """
    positive("viscosity_ratio", viscosity_ratio, "give the viscosity over the reference viscosity")
    positive("pitch_diameter", pitch_diameter, "give that of the rollers' middles in mm")
    by_film = min(0.0864 * min(viscosity_ratio, MOST_RATIO) ** 0.68 * pitch_diameter**0.55, 1.0)
    return float(by_film * max(0.0, 1.0 - 0.6796 / pitch_diameter ** (1.0 / 3.0)))


@dataclass(frozen=True, repr=False)
class BearingLife:
    """How long a bearing lasts under one load, in 10^6 revolutions.

    Attributes
    ----------
    rating : Rating
        What it can bear.
    equivalent_load, static_load : float
        P and P_0 [N].
    basic : float
        L10, of ISO 281.
    reference : float
        L10r, of the laminae.
    viscosity_ratio, contamination, life_factor : float or None
        kappa, e_C and by how much they change the life, a_ISO [-]; None without a viscosity.
    reliability_factor : float
        a_1 [-].
    modified : float
        L_nmr: L10r times a_1, and times a_ISO if there is one.
    static_safety : float
        S_0 [-].
    """

    rating: Rating
    equivalent_load: float
    static_load: float
    basic: float
    reference: float
    viscosity_ratio: float | None
    contamination: float | None
    life_factor: float | None
    reliability_factor: float
    modified: float
    static_safety: float

    def __repr__(self) -> str:
        rated = self.rating
        said = [
            f"C = {digits(1e-3 * rated.dynamic)} kN, C0 = {digits(1e-3 * rated.static)} kN, "
            f"P = {digits(1e-3 * self.equivalent_load)} kN, S0 = {digits(self.static_safety, 3)}",
            f"L10 = {digits(self.basic, 4)}, L10r = {digits(self.reference, 4)} million revolutions",
            f"modified {digits(self.modified, 4)} million revolutions: a1 = {digits(self.reliability_factor, 3)}"
            + self._lubricated(),
        ]
        return plain_text("BearingLife", said)

    def _lubricated(self) -> str:
        if self.life_factor is None or self.viscosity_ratio is None or self.contamination is None:
            return ", without lubrication"
        return (
            f", a_ISO = {digits(self.life_factor, 4)} with kappa = {digits(self.viscosity_ratio, 3)} and "
            f"e_C = {digits(self.contamination, 3)}"
        )


def assess(
    solution: BearingSolution,
    *,
    speed: float | None = None,
    viscosity: float | None = None,
    contamination: float | None = None,
    reliability: float = 0.9,
    edge_stress: str | None = None,
    laminae: int = LAMINAE,
    dynamic: float | None = None,
    static: float | None = None,
) -> BearingLife:
    """Return how long a bearing lasts; the load stands still, and the inner ring turns.

    Parameters
    ----------
    solution : BearingSolution
        The loaded bearing.
    speed : float, optional
        [1/min], beside a viscosity.
    viscosity : float, optional
        Of the oil at its temperature in the bearing [mm^2/s].
    contamination : float, optional
        e_C, above 0 and at most 1; if left out, `contamination_factor`.
    reliability : float
        Share of bearings that last longer, from 0.9 to 0.9995.
    edge_stress : {"pressure", "standard", "none"}, optional
        As in `nonhertz.life.iso_16281`; the pressures that were solved for if there are any, else the standard's.
    laminae : int
        Number of slices.
    dynamic, static : float, optional
        Ratings of a catalogue [N].

    Raises
    ------
    InputError
        If an argument is out of range, or pressures are asked of a bearing that was solved by slices.
    """
    if not isinstance(solution, BearingSolution):
        raise InputError("solution", solution, "be a loaded bearing", "solve one with nonhertz.bearing.solve")
    laminae = whole("laminae", laminae, FEWEST, MOST, "give the number of slices, 41 say")
    by_strips = solution.method == "strips"
    stress = ("pressure" if by_strips else "standard") if edge_stress is None else edge_stress
    one_of("edge_stress", stress, EDGE_STRESS, "use 'pressure' for what was solved")
    if stress == "pressure" and not by_strips:
        raise InputError("edge_stress", stress, "be 'standard' or 'none' for slices", "solve the bearing by strips")
    bearing = solution.bearing
    if isinstance(bearing, Paired):
        raise InputError("solution", "Paired", "be of one row", "solve the row alone under its share of the loads")
    rated = rating(bearing, dynamic=dynamic, static=static)
    load, still = _equivalent(solution, bearing)
    means = _means(_suffered(solution, bearing, laminae, stress))
    reference = _life(rated, means, np.ones(laminae))
    of_reliability = reliability_factor(reliability)
    kappa, clean = _oil(bearing, speed, viscosity, contamination)
    factor = None
    if kappa is not None and clean is not None:
        loads = _lamina_loads(bearing, rated, means)
        factors = np.array([_factor_at(kappa, clean * rated.fatigue_limit, each) for each in loads])
        factor = _life(rated, means, factors) / reference if math.isfinite(reference) else MOST_FACTOR
    return BearingLife(
        rating=rated,
        equivalent_load=load,
        static_load=still,
        basic=(rated.dynamic / load) ** (10.0 / 3.0) if load > 0.0 else math.inf,
        reference=reference,
        viscosity_ratio=kappa,
        contamination=clean,
        life_factor=factor,
        reliability_factor=of_reliability,
        modified=of_reliability * reference * (1.0 if factor is None else factor),
        static_safety=rated.static / still if still > 0.0 else math.inf,
    )


def _equivalent(solution: BearingSolution, bearing: RollerBearing) -> tuple[float, float]:
    """Return P of ISO 281 and P_0 of ISO 76 [N]."""
    radial, axial = math.hypot(*solution.force[1:3]), abs(float(solution.force[0]))
    if not isinstance(bearing, TaperedRollerBearing):
        return radial, radial
    angle = bearing.nominal_angle
    load = radial if axial <= 1.5 * math.tan(angle) * radial else 0.4 * radial + 0.4 / math.tan(angle) * axial
    return load, max(0.5 * radial + 0.22 / math.tan(angle) * axial, radial)


def _suffered(solution: BearingSolution, bearing: RollerBearing, laminae: int, edge_stress: str) -> Array:
    """Return f q of every lamina [N], shape (rollers, 2, laminae)."""
    found = np.zeros((*solution.load.shape, laminae))
    if solution.method == "slices":
        slices = standard_slices(bearing, laminae)
        found[:] = slices.loads(solution.approach.ravel(), solution.tilt.ravel()).reshape(found.shape)
        found *= edge_function(laminae) if edge_stress == "standard" else 1.0
        return np.where(solution.load[..., None] > 0.0, found, 0.0)
    model = iso_16281(laminae=laminae, edge_stress=edge_stress)
    for j in range(bearing.rollers):
        for k, ring in enumerate(("inner", "outer")):
            contact = solution.contact(j, ring)
            if contact is not None:
                cut = laminae_of(contact, model)
                found[j, k] = cut.factor * cut.load
    return found


def _means(suffered: Array) -> Array:
    """Return the mean over the rollers of every lamina [N], shape (2, laminae): the inner ring turns."""
    means = [np.mean(suffered[:, k] ** power, axis=0) ** (1.0 / power) for k, power in enumerate((_TURNING, _STANDING))]
    return np.array(means)


def _life(rated: Rating, means: Array, factors: Array) -> float:
    """Return the life [10^6 revolutions] of laminae that last longer by factors."""
    capacities = np.array([[rated.inner], [rated.outer]]) * factors.size ** (-7.0 / 9.0)
    damage = float(np.sum(np.sum((means / capacities) ** EXPONENT, axis=0) * factors**-SLOPE))
    return damage ** (-1.0 / SLOPE) if damage > 0.0 else math.inf


def _lamina_loads(bearing: RollerBearing, rated: Rating, means: Array) -> Array:
    """Return the load on the bearing that would load it as every lamina is [N], shape (laminae,)."""
    share = 1.038 * rated.inner / rated.outer
    both = (means[0] ** EXPONENT + (share * means[1]) ** EXPONENT) / (1.0 + share**EXPONENT)
    size = 0.323 * bearing.rollers * math.cos(bearing.nominal_angle) * means.shape[1]
    return np.asarray(size * both ** (1.0 / EXPONENT))


def _factor_at(kappa: float, limit: float, load: float) -> float:
    return life_factor(kappa, limit / load) if load > 0.0 else MOST_FACTOR


def _oil(
    bearing: RollerBearing, speed: float | None, viscosity: float | None, contamination: float | None
) -> tuple[float | None, float | None]:
    """Return kappa and e_C, or None for both without a viscosity."""
    if viscosity is None:
        for name, value in (("speed", speed), ("contamination", contamination)):
            if value is not None:
                raise InputError(name, value, "be given with a viscosity", "give the viscosity too, or leave it out")
        return None, None
    positive("viscosity", viscosity, "give that of the oil in the bearing in mm^2/s")
    if speed is None:
        raise InputError("speed", None, "be given with a viscosity", "give the speed in 1/min")
    kappa = viscosity / reference_viscosity(speed, bearing.pitch)
    if contamination is None:
        return kappa, contamination_factor(kappa, bearing.pitch)
    positive("contamination", contamination, "give e_C, above 0 and at most 1")
    if contamination > 1.0:
        raise InputError("contamination", contamination, "not exceed 1", "give e_C, above 0 and at most 1")
    return kappa, float(contamination)
