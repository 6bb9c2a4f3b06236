"""Published limits of bearings: axial load on ribs, minimum load, hoop stress of rings; speed by ISO 15312.

Each is a comparison with its source. The permissible continuous axial load on ribs of cylindrical bearings, twice
which is allowed for brief periods of some 1000 revolutions and three times in occasional peaks, is the least of
(SKF 2018)

    0.5 F_r        0.0045 kN D^1.5 of series 2, or 0.0023 kN D^1.7        k_1 10^4 C_0 / (n (d + D)) - k_2 F_r

where C_0 becomes 7.5 C_0^(2/3), in kN, if pi B (d + D) exceeds 50000 mm^2; it holds for a viscosity ratio of 2, a
misalignment of at most one minute of arc, and a heat flow of 0.5 mW/mm^2. Otherwise it is not judged as met, nor above
that of another manufacturer (HR 1, 2006), in N,

    k_S k_B d_m^1.5 n^-0.6        at most 0.075 k_B d_m^2.1 and 0.4 F_r

with k_S from 10 to 15 in an oil sump.

References
----------
SKF: Rolling bearings (2018), pages 106, 510 and 511; INA/FAG: Rolling Bearings, HR 1 (2006), page 49; NTN: Ball and
Roller Bearings, 2203/E, page A-78, for the stress of rings; SKF, the viscosity ratio (skf.com), and ZKL: Rolling
Bearings, section 4.2.1, for additives.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, Final, NamedTuple

import numpy as np

from nonhertz.amounts import format_digits, mpa, newton
from nonhertz.bearing.bearings import CylindricalThrustBearing, RollerBearing, SphericalRollerBearing
from nonhertz.bearing.friction import reference_load_share, reference_speed
from nonhertz.bearing.pairs import Paired
from nonhertz.bearing.ratings import Rating, are_opposed, axial_and_radial, axial_on_ribs, equivalent_loads
from nonhertz.bearing.solution import BearingSolution
from nonhertz.findings import Finding, finding

if TYPE_CHECKING:
    from nonhertz.bearing.operating import OperatingClearance

HOOP_STRESS: Final = 127.0  # MPa
SUMP: Final = 10.0  # k_S, the least in an oil sump
_AREA: Final = 50000.0  # mm^2
_LUBRICATION: Final = {  # k_1, k_2 by (full complement, grease)
    (False, False): (1.5, 0.15), (False, True): (1.0, 0.1), (True, False): (1.0, 0.3), (True, True): (0.5, 0.15),
}  # fmt: skip
_UNPROTECTED: Final = 0.4  # kappa
_OF_RIBS: Final = 2.0  # kappa
_MINUTE: Final = math.radians(1.0 / 60.0)
_LEAST_LOAD: Final = 0.02  # of C; for spherical bearings 0.01 of C_0


class Limit(NamedTuple):
    """A comparison with a limit: whether it is met, None where not known, and the sentence."""

    met: bool | None
    finding: Finding


def rib_limit_skf(
    *,
    radial: float,
    static: float,
    bore: float,
    outside_diameter: float,
    width: float,
    speed: float,
    series: str,
    full: bool = False,
    grease: bool = False,
) -> tuple[float, float, float]:
    """Return the permissible continuous axial loads on ribs [N] by radial load, strength of the ribs, and heat.

    Parameters
    ----------
    radial, static : float
        F_r and C_0 [N].
    bore, outside_diameter, width : float
        d, D and B [mm].
    speed : float
        Speed [1/min].
    series : str
        Dimension series.
    full, grease : bool
        Whether it is full-complement (without a cage), and lubricated by grease.

    Examples
    --------
    >>> sizes = {"bore": 30, "outside_diameter": 62, "width": 16}
    >>> by = rib_limit_skf(radial=10e3, static=36.5e3, **sizes, speed=3000, series="2")
    >>> [round(each) for each in by]
    [5000, 2197, 484]
    """
    k1, k2 = _LUBRICATION[full, grease]
    size = bore + outside_diameter
    strength = 0.0045 * outside_diameter**1.5 if series == "2" else 0.0023 * outside_diameter**1.7
    borne = 1e-3 * static
    borne = 7.5 * borne ** (2.0 / 3.0) if math.pi * width * size > _AREA else borne
    heat = math.inf if not speed else k1 * borne * 1e4 / (abs(speed) * size) - 1e-3 * k2 * radial
    return 0.5 * radial, 1e3 * float(strength), 1e3 * max(0.0, float(heat))


def rib_limit_schaeffler(
    factor: float, *, radial: float, mean_diameter: float, speed: float, lubrication: float = SUMP
) -> float:
    """Return the permissible continuous axial load on ribs [N] by HR 1.

    Parameters
    ----------
    factor : float
        k_B of the series.
    radial : float
        F_r [N].
    mean_diameter, speed : float
        (d + D) / 2 [mm] and n [1/min].
    lubrication : float
        k_S.

    Examples
    --------
    >>> round(rib_limit_schaeffler(18.0, radial=10e3, mean_diameter=46, speed=3000))
    460
    """
    most = min(0.4 * radial, 0.075 * factor * mean_diameter**2.1)
    by_heat = math.inf if not speed else lubrication * factor * mean_diameter**1.5 * math.pow(abs(speed), -0.6)
    return float(min(most, by_heat))


def limits(
    solution: BearingSolution,
    *,
    rating: Rating | None = None,
    clearance: OperatingClearance | None = None,
    grease: bool = False,
    viscosity_ratio: float | None = None,
) -> tuple[Limit, ...]:
    """Return the comparisons of a loaded bearing with limits published by manufacturers.

    Parameters
    ----------
    solution : BearingSolution
        The loaded bearing, with its speed.
    rating : Rating or None
        Its load ratings.
    clearance : OperatingClearance or None
        Its fits in operation.
    grease : bool
        Whether it is lubricated by grease.
    viscosity_ratio : float or None
        kappa, if known.
    """
    checks = [*_rings(clearance), *_preload(solution)]
    if rating is not None:
        checks += [
            *_ribs(solution, rating.static, grease, viscosity_ratio),
            *_least_load(solution, rating),
            *_speed(solution, rating.static),
        ]
    return (*checks, *_additives(viscosity_ratio))


def _ribs(solution: BearingSolution, static: float, grease: bool, ratio: float | None) -> Iterator[Limit]:
    axial, (_, radial) = axial_on_ribs(solution), axial_and_radial(solution)
    if not axial > 0.0 or not solution.each_rib_load.size:
        return
    row = solution.bearing.rows[0].bearing
    sizes: dict[str, Any] = {name: getattr(row, name) for name in ("series", "bore", "outside_diameter", "width")}
    if what := _missing_for_ribs(sizes, len(solution.bearing.rows)):
        words = "Whether ribs support the axial load of {load:4} is not judged: {what}."
        yield Limit(None, finding("rib-limit", words, load=newton(axial), what=what))
        return
    full = bool(row.of_series.get("full"))
    by = rib_limit_skf(radial=radial, static=static, **sizes, speed=solution.speed, full=full, grease=grease)
    reasons = "half the radial load", "the strength of ribs", "the heat on ribs"
    least = int(np.argmin(by))
    words = "The axial load on ribs is {load:4}; {reason} permits {limit:4} continuously, twice briefly (SKF 2018"
    words += "{where}{other})."
    where, other, allowed = _outside_of_rule(solution, ratio), "", math.inf
    if "rib" in row.of_series and not grease:
        mean = 0.5 * (sizes["bore"] + sizes["outside_diameter"])
        factor = row.of_series["rib"]
        allowed = rib_limit_schaeffler(factor, radial=radial, mean_diameter=mean, speed=solution.speed)
        other = f"; Schaeffler 2006, oil sump: {newton(allowed):4}"
    amounts = {"load": newton(axial), "limit": newton(by[least])}
    met: bool | None = bool(axial <= by[least])
    if met and (where or axial > allowed):
        met = None
    yield Limit(met, finding("rib-limit", words, **amounts, reason=reasons[least], where=where, other=other))


def _outside_of_rule(solution: BearingSolution, ratio: float | None) -> str:
    """Return the conditions of SKF's rule for ribs that are not fulfilled or not known; empty if there are none."""
    words, tilt = "", math.hypot(*solution.displacement[3:])
    if solution.speed and (ratio is None or ratio < _OF_RIBS):
        words += f", for kappa of at least {_OF_RIBS:g}" + (f", not {format_digits(ratio, 3)}" if ratio else "")
    if tilt > _MINUTE * (1.0 + 1e-6):
        words += f", for a misalignment of at most 1', not {format_digits(tilt / _MINUTE, 3)}'"
    return words


def _missing_for_ribs(sizes: dict[str, Any], rows: int) -> str:
    """Return the data missing for manufacturers' rules for ribs; empty if none."""
    missing = [name for name, size in sizes.items() if size is None]
    if missing:
        return f"give bearing.{', '.join(missing)}"
    return "manufacturers' rules apply to single rows" if rows > 1 else ""


def _least_load(solution: BearingSolution, rating: Rating) -> Iterator[Limit]:
    row, load, speed = solution.bearing.rows[0].bearing, equivalent_loads(solution)[0], solution.speed
    # Preload, which P does not include, also prevents skidding.
    if not speed or not load > 0.0 or isinstance(row, CylindricalThrustBearing) or _is_preloaded(solution.bearing):
        return
    spherical = isinstance(row, SphericalRollerBearing)
    least = 0.01 * rating.static if spherical else _LEAST_LOAD * rating.dynamic
    rule, met = "0.01 C0" if spherical else "0.02 C", load >= least
    words = "The load P of {load:4} is {state} {least:4}, {rule}, the minimum load against skidding (SKF 2018)."
    state = "at least" if met else "less than"
    amounts = {"load": newton(load), "least": newton(least)}
    yield Limit(met, finding("least-load", words, **amounts, state=state, rule=rule))


def _speed(solution: BearingSolution, static: float) -> Iterator[Limit]:
    speed = solution.speed
    limit = reference_speed(solution.bearing, static) if speed else None
    if limit is None:
        return
    met = abs(speed) <= limit
    load = reference_load_share(solution.bearing.rows[0].bearing)
    rating = f"the thermal speed rating of {{limit}} 1/min (ISO 15312, for a load of {load:g} C0)"
    words = f"The speed of {{speed}} 1/min is below {rating}."
    if not met:
        words = f"The speed of {{speed}} 1/min exceeds {rating}: whether the bearing stays cool is not judged."
    yield Limit(
        True if met else None, finding("speed", words, speed=format_digits(speed, 4), limit=format_digits(limit, 3))
    )


def _additives(ratio: float | None) -> Iterator[Limit]:
    if ratio is not None and ratio < _UNPROTECTED:
        words = "For kappa of {ratio}, below {least}, manufacturers require EP additives (SKF, ZKL): whether the "
        words += "lubricant has them is not judged."
        yield Limit(
            None, finding("additives", words, ratio=format_digits(ratio, 3), least=format_digits(_UNPROTECTED, 2))
        )


def _rings(clearance: OperatingClearance | None) -> Iterator[Limit]:
    if clearance is None:
        return
    stresses = {
        ring: max(abs(fit.seat_stress), abs(fit.raceway_stress))
        for ring, fit in (("inner", clearance.inner), ("outer", clearance.outer))
    }
    ring = max(stresses, key=stresses.__getitem__)
    met = stresses[ring] <= HOOP_STRESS
    words = "The hoop stress of the {ring} ring due to its fit, {stress:3}, is {state} {limit:g} (NTN 2203/E)."
    amounts = {"stress": mpa(stresses[ring]), "limit": mpa(HOOP_STRESS)}
    yield Limit(met, finding("hoop-stress", words, ring=ring, **amounts, state="within" if met else "beyond"))


def _preload(solution: BearingSolution) -> Iterator[Limit]:
    """Yield a limit for each row of a preloaded pair that has lost its load."""
    bearing = solution.bearing
    if not isinstance(bearing, Paired) or not are_opposed(bearing) or bearing.rows[0].bearing.nominal_angle == 0.0:
        return
    for number, row in enumerate(bearing.rows, start=1):
        if _is_preloaded(bearing) and not np.any(solution.load[row.rollers, 0] > 0.0):
            words = "Row {row} is unloaded: the preload of the pair is lost under load."
            yield Limit(False, finding("preload-lost", words, row=number))


def _is_preloaded(bearing: RollerBearing | Paired) -> bool:
    """Return whether rollers are loaded without external load.

    The inner ring may move along its axis: opposed rows share their room.
    """
    rooms = []
    for row in bearing.rows:
        slope = math.sin(row.bearing.nominal_angle)
        rooms.append(row.bearing.gap / (slope or 1.0) + (0.5 * row.clearance if slope else 0.0))
    return round(math.fsum(rooms), 9) < 0.0
