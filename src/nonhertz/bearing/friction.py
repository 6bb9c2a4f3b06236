"""Friction torque and power loss of a bearing, and its thermal speed rating.

After Palmgren, with the mean d_m of bore d and outside diameter D, the kinematic viscosity nu and the speed n

    M_0 = f_0 10^-7 (nu n)^(2/3) d_m^3        or f_0 160 10^-7 d_m^3 for nu n below 2000 mm^2/s /min
    M_1 = f_1 P_1 d_m

in N mm, with factors by series and lubrication (friction.toml). P_1 is F_r for cylindrical and needle bearings; F_a for
thrust bearings; the larger of F_r and 2 Y F_a for a tapered row, Y = 0.4 cot(alpha); and for spherical bearings, with
e = 1.5 tan(alpha), F_r (1 + 0.6 (F_a / (e F_r))^3) up to F_a = e F_r, and 1.6 F_a / e above.

These formulas are empirical: catalogues state that torques may differ considerably. The friction of ribs of cylindrical
bearings under axial loads, M_2 = f_2 F_a d_m, is left out, with a remark, since f_2 is published only as a chart,
"subject to wide scatter". So are seals and the effect of oil on a vertical shaft.

The thermal speed rating of ISO 15312:2003 and 2018 is the speed at which the heat of M_0 + M_1 equals the heat that
leaves the seats,

    q pi B (D + d), with q = 0.016 W/mm^2, or 0.016 (A / 50000 mm^2)^-0.34 for a larger area A

(thrust bearings: 0.020 W/mm^2, exponent -0.16, A = pi (D^2 - d^2) / 2), in an oil bath with 12 mm^2/s (thrust 24) at
70 degC, in surroundings of 20 degC, under 0.05 C_0r (thrust 0.02 C_0a).

References
----------
Palmgren: Ball and Roller Bearing Engineering, 3rd ed. (1959); INA/FAG: Rolling Bearings, HR 1 (2006), pages 56 to 65;
Timken Engineering Manual, page 184; NTN: Ball and Roller Bearings, 2203/E, page A-108, for the conditions of ISO 15312.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Final

from nonhertz.bearing.bearings import (
    CylindricalThrustBearing,
    RollerBearing,
    SphericalRollerBearing,
    TaperedRollerBearing,
)
from nonhertz.bearing.kinematics import PER_MINUTE
from nonhertz.bearing.pairs import Paired
from nonhertz.bearing.ratings import axial_and_radial, equivalent_loads
from nonhertz.bearing.solution import BearingSolution
from nonhertz.inputs.short_repr import ShortRepr
from nonhertz.result.brief import HasHtml

_OIL, _GREASE = 0, 1
_SLOW: Final = 2000.0  # nu n [mm^2/s /min] below which M_0 is constant
_AREA: Final = 50000.0  # mm^2, above which the heat flow density falls


@dataclass(frozen=True)
class Conditions:
    """Reference conditions of ISO 15312: viscosity [mm^2/s], share of C_0, heat flow density [W/mm^2], its exponent."""

    viscosity: float
    share: float
    heat: float
    exponent: float


_RADIAL: Final = Conditions(12.0, 0.05, 0.016, -0.34)
_THRUST: Final = Conditions(24.0, 0.02, 0.020, -0.16)


def speed_torque(factor: float, viscosity: float, speed: float, mean_diameter: float) -> float:
    """Return M_0 [N mm] for f_0, nu [mm^2/s], n [1/min] and d_m [mm]."""
    drag = viscosity * abs(speed)
    return float(1e-7 * factor * (160.0 if drag < _SLOW else drag ** (2.0 / 3.0)) * mean_diameter**3)


def load_torque(factor: float, load: float, mean_diameter: float) -> float:
    """Return M_1 [N mm] for f_1, P_1 [N] and d_m [mm]."""
    return factor * load * mean_diameter


def heat_flow(area: float, conditions: Conditions = _RADIAL) -> float:
    """Return the heat [W] that leaves seats of an area [mm^2] under the conditions of ISO 15312."""
    return conditions.heat * area * math.pow(max(1.0, area / _AREA), conditions.exponent)


def thermal_speed(
    f0: float, f1: float, *, bore: float, outside_diameter: float, width: float, static: float, thrust: bool = False
) -> float:
    """Return the thermal speed rating of ISO 15312 [1/min].

    Parameters
    ----------
    f0, f1 : float
        Factors in an oil bath, and under the reference load.
    bore, outside_diameter, width : float
        d, D and B (T for tapered bearings) [mm].
    static : float
        C_0 [N].
    thrust : bool
        Whether it is a thrust bearing.

    Examples
    --------
    >>> round(thermal_speed(2.0, 0.0003, bore=25, outside_diameter=52, width=15, static=27500))  # NU 205-E: 11800
    11817
    """
    conditions = _THRUST if thrust else _RADIAL
    seats = (outside_diameter**2 - bore**2) / 2.0 if thrust else width * (outside_diameter + bore)
    mean, heat = 0.5 * (bore + outside_diameter), heat_flow(math.pi * seats, conditions)
    of_load = load_torque(f1, conditions.share * static, mean)

    def loss(speed: float) -> float:
        return power(speed_torque(f0, conditions.viscosity, speed, mean) + of_load, speed)

    low, high = 0.0, 1.0
    while loss(high) < heat:
        low, high = high, 2.0 * high
    while high - low > 1e-9 * high:
        middle = 0.5 * (low + high)
        low, high = (middle, high) if loss(middle) < heat else (low, middle)
    return high


def power(torque: float, speed: float) -> float:
    """Return the power [W] of a torque [N mm] at a speed [1/min]."""
    return 1e-3 * torque * abs(speed) * PER_MINUTE


@dataclass(frozen=True, repr=False)
class Friction(ShortRepr, HasHtml):
    """Friction of a loaded bearing; made by `nonhertz.BearingCase.friction`.

    Attributes
    ----------
    speed_torque, load_torque : float
        M_0 and M_1 [N mm].
    speed : float
        Speed [1/min].
    axial : float
        Axial load on ribs of cylindrical bearings [N], whose friction M_2 is not included in the torque.
    """

    speed_torque: float
    load_torque: float
    speed: float
    axial: float

    @property
    def torque(self) -> float:
        """M_0 + M_1 [N mm]."""
        return self.speed_torque + self.load_torque

    @property
    def power(self) -> float:
        """Power loss [W]."""
        return power(self.torque, self.speed)


def friction(solution: BearingSolution, *, viscosity: float, static: float, grease: bool = False) -> Friction | None:
    """Return torque and power loss of a loaded bearing; None where no factors are published for it.

    Parameters
    ----------
    solution : BearingSolution
        The loaded bearing, with its speed; its series, bore and outside diameter must be known.
    viscosity : float
        Viscosity of the oil, or of the grease's base oil, in the bearing [mm^2/s].
    static : float
        C_0 [N].
    grease : bool
        Whether it is lubricated by grease.
    """
    row, factors = of_series(solution.bearing)
    if not factors or row.bore is None or row.outside_diameter is None:
        return None
    axial, radial = axial_and_radial(solution)
    mean = 0.5 * (row.bore + row.outside_diameter)
    f1 = load_factor(factors, equivalent_loads(solution)[1] / static)
    return Friction(
        speed_torque(factors["f0"][_GREASE if grease else _OIL], viscosity, solution.speed, mean),
        load_torque(f1, _decisive(row, axial, radial), mean),
        solution.speed,
        0.0 if row.nominal_angle else axial,
    )


def reference_speed(bearing: RollerBearing | Paired, static: float) -> float | None:
    """Return the thermal speed rating of a bearing with C_0 [N]; None where series or sizes are not known."""
    row, factors = of_series(bearing)
    if not factors or row.bore is None or row.outside_diameter is None or row.width is None:
        return None
    thrust = isinstance(row, CylindricalThrustBearing)
    f1 = load_factor(factors, reference_load_share(row))
    sizes = {"bore": row.bore, "outside_diameter": row.outside_diameter, "width": row.width}
    return thermal_speed(factors["f0"][_OIL], f1, **sizes, static=static, thrust=thrust)


def reference_load_share(row: RollerBearing) -> float:
    """Return the load over C_0 at which ISO 15312 rates the speed of a row [-]."""
    return (_THRUST if isinstance(row, CylindricalThrustBearing) else _RADIAL).share


def of_series(bearing: RollerBearing | Paired) -> tuple[RollerBearing, dict[str, Any]]:
    """Return a row and its factors; no factors for numbers of rows not in catalogues: one, or two for barrels."""
    row = bearing.rows[0].bearing
    usual = 2 if isinstance(row, SphericalRollerBearing) else 1
    return row, row.of_series if len(bearing.rows) == usual else {}


def load_factor(factors: dict[str, Any], share: float) -> float:
    """Return f_1 for P_0 / C_0."""
    f1 = factors["f1"]
    return float(f1[0] * share ** f1[1] if isinstance(f1, list) else f1)


def _decisive(row: RollerBearing, axial: float, radial: float) -> float:
    """Return P_1 [N]."""
    if isinstance(row, CylindricalThrustBearing):
        return axial
    if isinstance(row, TaperedRollerBearing):
        return max(radial, 0.8 * axial / math.tan(row.nominal_angle))
    if isinstance(row, SphericalRollerBearing) and row.nominal_angle:
        limit = 1.5 * math.tan(row.nominal_angle)
        if axial > limit * radial:
            return 1.6 * axial / limit
        return radial * (1.0 + 0.6 * (axial / (limit * radial)) ** 3) if radial else 0.0
    return radial
