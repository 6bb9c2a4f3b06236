"""The life of a loaded bearing by ISO 281 and ISO/TS 16281, under one load or a spectrum.

    L10 = (C / P)^(10/3)        L_nmr = a_1 a_ISO L10r

in millions of revolutions, with L10r from `nonhertz.bearing.laminae`. Under a spectrum, with a share u of the
revolutions for each load, 1 / L = sum u / L (Palmgren, Miner). The static safety is C_0 over P_0.

For P above C / 2, where contacts may yield, ISO 281 refers to the maker of the bearing. P leaves out preload and
moments; the load that would give L10r has them, P_ref = C L10r^(-3/10) of ISO/TS 16281.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Annotated

import numpy as np
from numpy.typing import ArrayLike

from nonhertz.amounts import format_digits, newton
from nonhertz.bearing.bearings import CylindricalThrustBearing
from nonhertz.bearing.laminae import lamina_life, lamina_means, life_factors, singular_ends
from nonhertz.bearing.lubrication import (
    MOST_FACTOR,
    contamination_factor,
    reference_viscosity,
    reliability_factor,
)
from nonhertz.bearing.oil import OilInPlace
from nonhertz.bearing.prescribed import TurningRing
from nonhertz.bearing.ratings import Rating, axial_on_ribs, equivalent_loads, rating
from nonhertz.bearing.solution import BearingSolution
from nonhertz.bearing.standard import LAMINAE
from nonhertz.errors import InputError
from nonhertz.findings import Finding, HasFindings, finding
from nonhertz.inputs.assumed import Assumed, collect_assumptions
from nonhertz.inputs.checks import numbers, positive
from nonhertz.inputs.descriptions import Count, Quantity, Word
from nonhertz.inputs.fields import Input, document_parameters, input_class
from nonhertz.life.lamina import EDGE_STRESS, FEWEST, MOST
from nonhertz.life.required import REQUIRED, million_revolutions
from nonhertz.life.spectrum import WHOLE, check_shares, miner
from nonhertz.result.brief import HasHtml, plain_text
from nonhertz.result.edges import SingularEnd
from nonhertz.result.ends import ends_in_words

#: A loaded bearing, or several loads of one bearing with their shares of the revolutions.
Loaded = BearingSolution | Sequence[tuple[BearingSolution, float]]

_LIFE_EXPONENT = 10.0 / 3.0
_HEAVY = 0.5  # of C: the largest P of the life equation of ISO 281, unless the maker allows more
#: Said of P where it is zero although contacts bear loads.
LEFT_OUT = "leaves out preload, moments, speed and ribs"
_TEXT = "ISO/TS 16281:2008"
_ROUNDED = "give corners, or a profile with more relief there, or edge_stress = 'standard'"
#: Said where there is no modified life for want of oil.
NO_OIL = "give viscosity and cleanliness for the modified life"
_NO_OIL_FOR_THRUST = "no modified life of thrust bearings, whose a_ISO was found in one source only"
_PAIRS = "pairs of a loaded bearing and its share of the revolutions"


@dataclass(frozen=True, repr=False)
class BearingLife(HasFindings, HasHtml):
    """How long a bearing lasts under one load or a spectrum of loads, in 10^6 revolutions.

    Attributes
    ----------
    rating : Rating
        C and C_0.
    equivalent_load, static_load : float
        P and P_0 [N], which leave out preload and moment; of a spectrum, the constant load with the same L10, and the
        largest P_0.
    reference_life : float
        L10r, of the laminae; NaN by pressures that are singular at an end, where the integral of (f q)^(9/2) diverges.
        Centrifugal loads on the outer ring count, also of rollers that the inner ring does not load.
    viscosity_ratio, contamination, life_factor : float or None
        kappa, e_C and a_ISO [-]. All are None without a viscosity, the last two without a cleanliness or an e_C. For a
        spectrum, the smallest kappa and e_C.
    reliability_factor : float
        a_1 [-].
    singular_ends : tuple of SingularEnd
        Ends towards which the damage has no limit, so that there is no L10r; empty if there are none.
    parts : tuple of (BearingLife, float)
        For a spectrum, the life under each load alone and its share; empty under one load.
    axial_on_ribs : float
        Axial load on the ribs of cylindrical rows [N], which neither P nor the laminae include; of a spectrum, the
        largest.
    assumed : tuple of Finding
        Assumptions in place of conditions that were left out.
    required : float or None
        The required life; None if there is none.
    basis : str
        The standard of L10r, departures from it, and whether the bearing is beyond its scope.
    speed : float or None
        Speed for lives in hours [1/min], of a spectrum the mean over the time; None if not known.
    pressed : bool
        Whether the inner ring loads rollers, of a spectrum under one of its loads.
    """

    rating: Rating
    equivalent_load: float
    static_load: float
    reference_life: float
    viscosity_ratio: float | None
    contamination: float | None
    life_factor: float | None
    reliability_factor: float
    singular_ends: tuple[SingularEnd, ...] = ()
    parts: tuple[tuple[BearingLife, float], ...] = ()
    axial_on_ribs: float = 0.0
    assumed: tuple[Finding, ...] = ()
    required: float | None = None
    basis: str = _TEXT
    speed: float | None = None
    pressed: bool = True

    @property
    def hours_per_million(self) -> float:
        """How long 10^6 revolutions take [h]; NaN without a speed."""
        return math.nan if self.speed is None else 1e6 / (60.0 * self.speed)

    @property
    def basic_life(self) -> float:
        """L10 of ISO 281; infinite without load, NaN where contacts bear only loads that P leaves out.

        That of a spectrum is NaN where the inner ring presses rollers under one of its loads but P is zero.
        """
        return math.pow(self._safety(self.rating.dynamic, self.equivalent_load), _LIFE_EXPONENT)

    @property
    def modified_life(self) -> float:
        """L_nmr = a_1 a_ISO L10r; NaN where oil or cleanliness are not known."""
        return math.nan if self.life_factor is None else self.rated_life

    @property
    def rated_life(self) -> float:
        """L_nmr if there is one, or else a_1 L10r."""
        return self.reliability_factor * self.reference_life * (1.0 if self.life_factor is None else self.life_factor)

    @property
    def rated_hours(self) -> float:
        """The life that stands [h]; NaN without a speed."""
        return self.hours_per_million * self.rated_life

    @property
    def no_modified(self) -> str:
        """Why there is no modified life; empty if there is one."""
        return "" if self.life_factor is not None else _NO_OIL_FOR_THRUST if self.rating.of_thrust else NO_OIL

    @property
    def static_safety(self) -> float:
        """S_0 [-]; infinite without load, NaN where contacts bear what P_0 leaves out alone."""
        return self._safety(self.rating.static, self.static_load)

    def _safety(self, rating: float, load: float) -> float:
        if self.internally_loaded:
            return math.nan
        return rating / load if load else math.inf

    @property
    def no_reference(self) -> str:
        """Why there is no L10r; empty if there is one."""
        ends = self.singular_ends
        return f"the damage grows without limit towards {ends_in_words(ends)}; {_ROUNDED}" if ends else ""

    @property
    def reference_load(self) -> float:
        """P_ref of ISO/TS 16281 [N], with which L10 would be L10r; NaN where there is no L10r."""
        return float(self.rating.dynamic * self.reference_life ** (-1.0 / _LIFE_EXPONENT))

    @cached_property
    def findings(self) -> tuple[Finding, ...]:  # type: ignore[override]
        """What limits the validity: axial loads on ribs, and loads under which the equations need not hold.

        For a spectrum, its heaviest load.
        """
        notes = []
        if self.axial_on_ribs:
            words = "Ribs support the axial load of {load:4}, which no life here includes."
            notes.append(finding("load-on-ribs", words, load=newton(self.axial_on_ribs)))
        rest = 1.0 - math.fsum(share for _, share in self.parts)
        if self.speed is not None and rest > WHOLE and len({life.speed for life, _ in self.parts}) > 1:
            words = "Hours assume the mean speed of the loads, {speed:.4g} 1/min, for the {percent:.3g} % of the "
            words += "revolutions without load, too."
            notes.append(finding("unloaded-speed", words, speed=self.speed, percent=100.0 * rest))
        lives = [life for life, _ in self.parts] or [self]
        heaviest = max(life.equivalent_load for life in lives)
        by_rollers = max((life.reference_load for life in lives if not math.isnan(life.reference_life)), default=0.0)
        if max(heaviest, by_rollers) <= _HEAVY * self.rating.dynamic:
            return tuple(notes)
        by_force = heaviest > _HEAVY * self.rating.dynamic
        words = (
            "The equivalent load P of {load:4} exceeds"
            if by_force
            else "Rollers are loaded as by a P of {load:4}, over"
        )
        words += " half the rating C of {rating:4}: contacts may yield, and the equations of life need not hold."
        numbers = {"load": newton(heaviest if by_force else by_rollers), "rating": newton(self.rating.dynamic)}
        return (*notes, finding("heavy-load", words, **numbers))

    @property
    def internally_loaded(self) -> bool:
        """Whether contacts bear loads though P is zero, which leaves out preload, moments, speed and ribs.

        For a spectrum, whether they do under one of its loads, other than by speed on the outer ring alone.
        """
        if self.parts:
            return any(life.internally_loaded and life.pressed for life, _ in self.parts)
        return self.equivalent_load == 0.0 and not math.isinf(self.reference_life)

    def __repr__(self) -> str:
        rated = self.rating
        lines = [
            f"C = {newton(rated.dynamic)}, C0 = {newton(rated.static)}, "
            f"P = {newton(self.equivalent_load)}, S0 = {_or_none(self.static_safety, 3)}",
            f"L10 = {_or_none(self.basic_life)}, L10r = {format_digits(self.reference_life, 4)} million revolutions",
            self._rated_in_words(),
        ]
        if self.internally_loaded:
            lines.append(f"no S0 and no L10: P {LEFT_OUT}")
        if self.no_reference:
            lines[1:3] = [f"L10 = {_or_none(self.basic_life)} million revolutions, no L10r: {self.no_reference}"]
        if self.parts:
            lines.append(
                f"under {len(self.parts)} loads for {format_digits(sum(share for _, share in self.parts), 3)} of it"
            )
        if self.required is not None:
            met = "met" if self.rated_life >= self.required else "not met"
            lines.append(f"required {format_digits(self.required, 4)} million revolutions: {met}")
        if self.assumed:
            lines.append(f"assumed: {', '.join(dict(assumption.numbers)['default'] for assumption in self.assumed)}")
        return plain_text("BearingLife", [*lines, *self.warnings])

    def _rated_in_words(self) -> str:
        factors, of_oil = self.factors
        kind, why = ("rated", f"; {self.no_modified}") if self.no_modified else ("modified", "")
        words = f"{kind} {format_digits(self.rated_life, 4)} million revolutions: {factors}"
        return words + (f" with {' and '.join(of_oil)}" if of_oil else "") + why

    @property
    def factors(self) -> tuple[str, tuple[str, ...]]:
        """The factors of L10r in words, and those of a_ISO as far as they are known."""
        factors = [f"a1 = {format_digits(self.reliability_factor, 3)}"]
        if self.life_factor is not None:
            factors.append(f"a_ISO = {'none' if self.no_reference else format_digits(self.life_factor, 4)}")
        of_oil = ("kappa", self.viscosity_ratio), ("e_C", self.contamination)
        return ", ".join(factors), tuple(
            f"{name} = {format_digits(value, 3)}" for name, value in of_oil if value is not None
        )


def _or_none(value: float, significant: int = 4) -> str:
    return "none" if math.isnan(value) else format_digits(value, significant)


def _reliability(name: str, value: float, remedy: str) -> None:
    positive(name, value, remedy)
    reliability_factor(value)


_RATING = "give the load rating in N"


@input_class(kw_only=True)
class LifeConditions(Input):
    """Conditions of an assessment besides speed and oil.

    Raises
    ------
    InputError
        If one of them is out of range.
    """

    reliability: Annotated[
        float,
        Quantity("", "share of bearings that last longer, from 0.9 to 0.9995", _reliability, "give 0.9, or more"),
        Assumed("reliability of 90 %", "the life"),
    ] = 0.9
    edge_stress: Annotated[
        str | None,
        Word(
            "edges of the laminae: 'pressure' as solved by strips (if left out), 'standard' or 'none'",
            "use 'pressure' for what was solved",
            EDGE_STRESS,
        ),
        Assumed("edge stress by the method", "L10r"),
    ] = None
    laminae: Annotated[int, Count("number of laminae", FEWEST, MOST, "give the number of laminae, 41 say")] = LAMINAE
    dynamic: Annotated[
        float | None,
        Quantity("N", "basic dynamic load rating C of a catalogue; that of ISO 281 if left out", positive, _RATING),
        Assumed("C by ISO 281", "lives"),
    ] = None
    static: Annotated[
        float | None,
        Quantity("N", "basic static load rating C0 of a catalogue; that of ISO 76 if left out", positive, _RATING),
        Assumed("C0 by ISO 76", "S0"),
    ] = None
    required: Annotated[float | str | None, REQUIRED] = None

    @property
    def reliability_factor(self) -> float:
        """a_1 [-]."""
        return reliability_factor(self.reliability)


@input_class(kw_only=True)
class _Conditions(TurningRing, LifeConditions, OilInPlace):
    """All conditions, with the oil and the ring that turns."""


@document_parameters(OilInPlace, LifeConditions)
def assess(
    solution: Loaded,
    *,
    speed: ArrayLike | None = None,
    viscosity: float | None = None,
    contamination: float | None = None,
    cleanliness: str | None = None,
    reliability: float = 0.9,
    edge_stress: str | None = None,
    laminae: int = LAMINAE,
    dynamic: float | None = None,
    static: float | None = None,
    required: float | str | None = None,
) -> BearingLife:
    """Return the life of a bearing under stationary loads.

    Parameters
    ----------
    solution : BearingSolution, or several of one bearing with their shares
        The loaded bearing, or a spectrum: pairs of a solution and its share of the revolutions, from `solve_spectrum`
        or with `shares_of_revolutions`. Where shares add up to less than 1, the bearing is unloaded for the rest.
    speed : float or sequence of float, optional
        Speed [1/min], for a modified life and for lives in hours: one, or one for each load of a spectrum. If left out,
        the speeds of the solutions, if all have one.
    {OilInPlace}
    {LifeConditions}

    Returns
    -------
    BearingLife
        Ratings, equivalent load, static safety, and lives in millions of revolutions.

    Raises
    ------
    InputError
        If an argument is out of range, ``edge_stress="pressure"`` is given for a bearing solved by slices, rows differ,
        or a viscosity is given for a thrust bearing, whose formula was found in one source only.

    Notes
    -----
    For viscosities see `oil_viscosity`, for e_C `contamination_factor`. Without a viscosity, or without a cleanliness
    or an e_C, there is no modified life.

    L10 contains the factor lambda nu = 0.83 for uneven line loads; L10r does not, since the laminae have the line loads
    themselves. P leaves out moments. Where a contact reaches a sharp end, there is no L10r by pressures.
    """
    pairs = _pairs(solution)
    conditions = _Conditions(
        viscosity=viscosity,
        contamination=contamination,
        cleanliness=cleanliness,
        reliability=reliability,
        edge_stress=edge_stress,
        laminae=laminae,
        dynamic=dynamic,
        static=static,
        required=required,
    )
    if speed is None and all(state.speed for state, _ in pairs):
        speed = [state.speed for state, _ in pairs]
    _check_oil(conditions, speed, pairs[0][0])
    speeds = _speeds(speed, len(pairs))
    lives = tuple(
        (_assess_one(state, replace(conditions, turning=state.turning), pace), share)
        for (state, share), pace in zip(pairs, speeds, strict=True)
    )
    life = lives[0][0] if isinstance(solution, BearingSolution) else _combine_lives(lives, conditions)
    if conditions.required is None:
        return life
    return replace(life, required=million_revolutions(conditions.required, life.speed))


def _pairs(solution: Loaded) -> list[tuple[BearingSolution, float]]:
    if isinstance(solution, BearingSolution):
        return [(solution, 1.0)]
    condition, remedy = "be a loaded bearing, or several with their shares", f"give one, or {_PAIRS}"

    def check(value: object) -> None:
        if not isinstance(value, BearingSolution):
            raise InputError("solution", value, condition, remedy)

    return check_shares(solution, check, "bearing", condition, remedy)


def _check_oil(conditions: _Conditions, speed: object, solution: BearingSolution) -> None:
    if conditions.viscosity is None:
        return
    if speed is None:
        raise InputError("speed", None, "be given with a viscosity", "give the speed in 1/min")
    if any(isinstance(row.bearing, CylindricalThrustBearing) for row in solution.bearing.rows):
        condition = "be left out for thrust bearings, whose a_ISO was found in one source only"
        raise InputError("viscosity", conditions.viscosity, condition, "assess the bearing without lubrication")


def _speeds(speed: ArrayLike | None, count: int) -> list[float | None]:
    if speed is None:
        return [None] * count
    remedy = "give the speed in 1/min, or one for each load"
    speeds = numbers("speed", speed, remedy)
    if speeds.ndim > 1 or speeds.size not in (1, count):
        raise InputError("speed", speeds.size, f"be one, or {count}, one for each load", remedy)
    for value in speeds.ravel().tolist():
        positive("speed", value, remedy)
    return np.broadcast_to(speeds, count).tolist()  # type: ignore[no-any-return]


def _assess_one(solution: BearingSolution, conditions: _Conditions, speed: float | None) -> BearingLife:
    usual = {"strips": "pressure", "slices": "standard"}[solution.method]
    stress = conditions.edge_stress or usual
    if stress == "pressure" != usual:
        raise InputError("edge_stress", stress, "be 'standard' or 'none' for slices", "solve the bearing by strips")
    rated = rating(solution.bearing, dynamic=conditions.dynamic, static=conditions.static)
    load, still = equivalent_loads(solution)
    means = lamina_means(solution, conditions.laminae, stress, conditions.turning)
    ends = singular_ends(solution) if stress == "pressure" else set()
    reference = math.nan if ends else lamina_life(rated, means)
    kappa, clean = _oil_factors(conditions, speed, solution.bearing.rows[0].bearing.pitch)
    factor = None
    if kappa is not None and clean is not None:
        factors = life_factors(solution, rated, means, kappa, float(clean))
        factor = MOST_FACTOR if math.isinf(reference) else lamina_life(rated, means, factors) / reference
    return BearingLife(
        rating=rated,
        equivalent_load=load,
        static_load=still,
        reference_life=reference,
        viscosity_ratio=kappa,
        contamination=clean,
        life_factor=factor,
        reliability_factor=conditions.reliability_factor,
        singular_ends=tuple(ends),
        axial_on_ribs=axial_on_ribs(solution),
        assumed=collect_assumptions({"": conditions}),
        basis=_basis(solution, stress),
        speed=speed,
        pressed=bool(solution.load[:, 0].any()),
    )


def _oil_factors(conditions: _Conditions, speed: float | None, pitch: float) -> tuple[float | None, float | None]:
    """Return kappa and e_C, as far as they are known."""
    if conditions.viscosity is None or speed is None:
        return None, None
    kappa, clean = conditions.viscosity / reference_viscosity(speed, pitch), conditions.contamination
    if clean is None and conditions.cleanliness is not None:
        clean = contamination_factor(kappa, pitch, conditions.cleanliness)
    return kappa, clean


def _basis(solution: BearingSolution, edge_stress: str) -> str:
    """Return the standard of L10r, which is for slices of single rows under radial load, with departures from it."""
    rows = solution.bearing.rows
    extended = len(rows) > 1 or rows[0].bearing.nominal_angle or axial_on_ribs(solution)
    words = f"extended {_TEXT}" if extended else _TEXT
    if solution.method == "strips":
        words += ", by strips"
    if edge_stress == "none" or (edge_stress == "standard" and solution.method == "strips"):
        words += f", {edge_stress if edge_stress == 'standard' else 'no'} edge stress"
    return words


_COMBINED = (
    *("reference_life", "rated_life", "equivalent_load", "static_load", "viscosity_ratio", "contamination"),
    *("singular_ends", "axial_on_ribs"),
)


def _combine_lives(parts: tuple[tuple[BearingLife, float], ...], conditions: _Conditions) -> BearingLife:
    lives, shares = map(list, zip(*parts, strict=True))
    first = parts[0][0]
    columns = {name: [getattr(life, name) for life in lives] for name in _COMBINED}
    reference, rated = (miner(columns[name], shares) for name in ("reference_life", "rated_life"))
    # Either all lives have their oil, or none has.
    kappa, clean = (
        None if None in columns[name] else min(columns[name]) for name in ("viscosity_ratio", "contamination")
    )
    of_oil = MOST_FACTOR if math.isinf(reference) else rated / (conditions.reliability_factor * reference)
    # Shares are those of the revolutions: slow ones take longer.
    minutes = [share / life.speed for life, share in parts if life.speed is not None]
    return replace(
        first,
        equivalent_load=float(
            np.dot(np.power(columns["equivalent_load"], _LIFE_EXPONENT), shares) ** (1.0 / _LIFE_EXPONENT)
        ),
        static_load=max(columns["static_load"]),
        reference_life=reference,
        viscosity_ratio=kappa,
        contamination=clean,
        life_factor=None if first.life_factor is None else of_oil,
        singular_ends=next(filter(None, columns["singular_ends"]), ()),
        parts=parts,
        axial_on_ribs=max(columns["axial_on_ribs"]),
        speed=math.fsum(shares) / math.fsum(minutes) if minutes else None,
        pressed=any(life.pressed for life in lives),
    )
