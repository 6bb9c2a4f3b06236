"""Load ratings and equivalent loads of bearings, ISO 281 and ISO 76.

The formulas of one raceway are in `nonhertz.life.capacity`; for i equal rows, in X, O or tandem, C is i^(7/9) times
that of one row. Several rows in X or O are rated as one bearing of two or more rows, with its factors:

    one row, or all of them turned the same way     P = F_r, or 0.4 F_r + 0.4 cot(alpha) F_a
    rows turned against each other                  P = F_r + 0.45 cot(alpha) F_a, or 0.67 [F_r + cot(alpha) F_a]

up to F_a / F_r = 1.5 tan(alpha), and above; two public programs use them, and catalogues of spherical roller bearings
agree. P_0 is the larger of F_r and 0.5 F_r + 0.22 cot(alpha) F_a, or F_r + 0.44 cot(alpha) F_a for opposed rows (one
program). Cylindrical thrust bearings have P = P_0 = F_a.

The static rating C_0 = 44 (1 - gamma) i Z L D cos(alpha) is the load at which the pressure reaches 4000 MPa on the
roller that carries 5 C_0 / (i Z cos(alpha)); the same pressure under an axial load on flat washers gives 220 Z L D.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from nonhertz.bearing.bearings import CylindricalThrustBearing, RollerBearing, SphericalRollerBearing
from nonhertz.bearing.equilibrium import NO_LOAD
from nonhertz.bearing.pairs import Paired
from nonhertz.bearing.solution import BearingSolution
from nonhertz.errors import InputError
from nonhertz.inputs.checks import positive
from nonhertz.inputs.short_repr import ShortRepr
from nonhertz.life.capacity import (
    MATERIAL_FACTOR,
    REDUCTION,
    THRUST_REDUCTION,
    Raceway,
    is_hollow,
    thrust_capacity,
    thrust_rating,
)
from nonhertz.model.material import is_steel
from nonhertz.model.materials import name_of
from nonhertz.result.brief import HasHtml

_STATIC = 44.0  # N/mm^2
_SHARE_OF_MOST_LOADED = 5.0
_MATERIAL_FACTORS = {SphericalRollerBearing: 1.15, CylindricalThrustBearing: 1.0}  # b_m
_OF_ROWS = 7.0 / 9.0  # power of the number of rows with which C grows
_ALIKE = 1e-9


@dataclass(frozen=True, repr=False)
class Rating(ShortRepr, HasHtml):
    """Load ratings of a bearing, by ISO 281 and ISO 76.

    Attributes
    ----------
    dynamic : float
        Basic dynamic load rating C [N]: radial, or axial for a thrust bearing.
    static : float
        Basic static load rating C_0 [N], in the same direction.
    inner, outer : float
        Dynamic capacities of one contact Q_ci and Q_ce [N].
    fatigue_limit : float
        Fatigue load limit C_u [N].
    rows : int
        Number of equal rows, i.
    material_factor : float
        b_m used for C, unless C is a catalogue's: 1.1; 1.15 for spherical roller bearings and 1 for thrust bearings,
        see docs/explain/standards.md.
    reduction : float
        lambda nu, the reduction of C for uneven line loads, which is not part of the capacities of contacts: 0.83, or
        0.73 for thrust bearings.
    """

    dynamic: float
    static: float
    inner: float
    outer: float
    fatigue_limit: float
    rows: int = 1
    material_factor: float = MATERIAL_FACTOR
    reduction: float = REDUCTION

    @property
    def of_thrust(self) -> bool:
        """Whether it is the rating of a thrust bearing, for axial loads."""
        return self.reduction == THRUST_REDUCTION


def rating(
    bearing: RollerBearing | Paired,
    *,
    dynamic: float | None = None,
    static: float | None = None,
    material_factor: float | None = None,
) -> Rating:
    """Return the ratings of a bearing.

    Parameters
    ----------
    bearing : RollerBearing or Paired
        The bearing; several rows must be equal.
    dynamic, static : float, optional
        C and C_0 of a catalogue [N], which replace those of the standards' formulas; for all rows together.
    material_factor : float, optional
        b_m in place of the one of the bearing's kind: 1 for needle rollers in a drawn cup.

    Raises
    ------
    InputError
        If rows differ, thrust bearings are opposed, or a part is not of bearing steel.

    Notes
    -----
    C includes the factor 0.83 (0.73 for thrust bearings) for uneven line loads, lambda nu.

    Examples
    --------
    >>> import nonhertz as nh
    >>> roller = nh.Roller(diameter=10, length=9.6)
    >>> rings = {"inner": nh.Ring(diameter=55), "outer": nh.Ring(diameter=-75)}
    >>> row = nh.bearing.CylindricalRollerBearing(roller=roller, **rings, rollers=14)
    >>> round(rating(row).dynamic, 1), round(rating(row).inner, 1), round(rating(row).outer, 1)
    (48416.8, 11449.6, 17271.6)
    """
    row, rows = _row_of(bearing)
    for name, value in (("dynamic", dynamic), ("static", static)):
        if value is not None:
            positive(name, value, f"give the basic {name} load rating in N")
    if material_factor is not None:
        positive("material_factor", material_factor, "give b_m, 1.1 for cylindrical and tapered rollers")
    usual = next((known for kind, known in _MATERIAL_FACTORS.items() if isinstance(row, kind)), MATERIAL_FACTOR)
    factor = usual if material_factor is None else float(material_factor)
    by_standards = _dynamic(row, rows, factor), _static(row, rows)
    load, still = (of if own is None else float(own) for of, own in zip(by_standards, (dynamic, static), strict=True))
    limit = float(still / 8.2 * min(1.0, (100.0 / row.pitch) ** 0.3))
    reduction = THRUST_REDUCTION if isinstance(row, CylindricalThrustBearing) else REDUCTION
    return Rating(load, still, *_capacities(row, rows, load), limit, rows, factor, reduction)


def _dynamic(row: RollerBearing, rows: int, factor: float) -> float:
    """Return C of equal rows [N], ISO 281."""
    if isinstance(row, CylindricalThrustBearing):
        # As for radial bearings; the standard's sum over different rows reduces to this for equal ones.
        of_one = thrust_rating(row.roller_diameter, length_of(row), row.pitch, row.rollers)
        return float(factor * of_one * rows**_OF_ROWS)
    return raceways(row)[0].load_rating(row.rollers, rows=rows, material_factor=factor)


def _static(row: RollerBearing, rows: int) -> float:
    """Return C_0 of equal rows [N], ISO 76."""
    size = rows * row.rollers * length_of(row) * row.roller_diameter
    if isinstance(row, CylindricalThrustBearing):
        return _SHARE_OF_MOST_LOADED * _STATIC * size
    across = math.cos(row.nominal_angle)
    return _STATIC * (1.0 - row.roller_diameter * across / row.pitch) * size * across


def _capacities(row: RollerBearing, rows: int, load: float) -> tuple[float, float]:
    """Return Q_ci and Q_ce of a bearing of equal rows with the rating C [N]."""
    if isinstance(row, CylindricalThrustBearing):
        return (thrust_capacity(load / rows**_OF_ROWS, row.rollers),) * 2
    inner, outer = (raceway.capacity_of(load, row.rollers, rows=rows) for raceway in raceways(row))
    return inner, outer


def raceways(bearing: RollerBearing) -> tuple[Raceway, Raceway]:
    """Return both raceways of a radial row for ISO 281."""
    of_both = bearing.roller_diameter, length_of(bearing), bearing.pitch
    angle = bearing.nominal_angle
    return Raceway(*of_both, True, contact_angle=angle), Raceway(*of_both, False, contact_angle=angle)


def length_of(bearing: RollerBearing) -> float:
    """Return the effective roller length of ISO 281 [mm]."""
    low, high = bearing.effective_interval
    return high - low


def are_opposed(bearing: RollerBearing | Paired) -> bool:
    """Return whether rows of a bearing are opposed, as in X and O."""
    return len({row.turned for row in bearing.rows}) > 1


def equivalent_loads(solution: BearingSolution) -> tuple[float, float]:
    """Return P of ISO 281 and P_0 of ISO 76 [N], which do not include preload and moments."""
    bearing, (axial, radial) = solution.bearing, axial_and_radial(solution)
    row = bearing.rows[0].bearing
    if isinstance(row, CylindricalThrustBearing):
        return axial, axial
    angle = row.nominal_angle
    if angle == 0.0:
        return radial, radial
    along = axial / math.tan(angle)
    much = axial > 1.5 * math.tan(angle) * radial
    if are_opposed(bearing):
        return (0.67 * (radial + along) if much else radial + 0.45 * along), radial + 0.44 * along
    return (0.4 * (radial + along) if much else radial), max(0.5 * radial + 0.22 * along, radial)


def axial_on_ribs(solution: BearingSolution) -> float:
    """Return the axial load on ribs [N], of rows without a contact angle."""
    return 0.0 if any(row.bearing.nominal_angle for row in solution.bearing.rows) else axial_and_radial(solution)[0]


def axial_and_radial(solution: BearingSolution) -> tuple[float, float]:
    """Return the magnitudes of the axial and the radial force on the inner ring [N]."""
    # The residual of the balance of preloaded rollers is not a force.
    borne = solution.load.sum() + solution.each_rib_load.sum()
    force = np.where(np.abs(solution.force) > NO_LOAD * borne, solution.force, 0.0)
    return abs(float(force[0])), math.hypot(*force[1:3])


def _row_of(bearing: RollerBearing | Paired) -> tuple[RollerBearing, int]:
    """Return one of equal rows, and their number."""
    if not isinstance(bearing, RollerBearing | Paired) or type(bearing) is RollerBearing:
        condition = "be a bearing of rollers"
        raise InputError("bearing", type(bearing).__name__, condition, "make one with nonhertz.bearing")
    rows = [row.bearing for row in bearing.rows]
    for row in rows:
        _refuse_other_rollers(row)
    if any(not _are_alike(rows[0], row) for row in rows[1:]):
        condition = "have rows of the same kind and size, as the load ratings of ISO 281 are for"
        raise InputError(
            "bearing", "Paired", condition, "rate the rows by themselves, each under its share of the loads"
        )
    if isinstance(rows[0], CylindricalThrustBearing) and are_opposed(bearing):
        condition = "have all its thrust bearings turned the same way: the others do not support this load"
        raise InputError("bearing", "Paired", condition, "rate the rows that support it")
    return rows[0], len(rows)


def _refuse_other_rollers(row: RollerBearing) -> None:
    """Refuse rollers and rings that are not of bearing steel, and hollow rollers."""
    of_steel = [is_steel(part.material) for part in (row.roller, row.inner, row.outer)]
    if all(of_steel[1:]) and name_of(row.roller.material) == "silicon-nitride":
        condition = "have rollers of bearing steel: hybrid bearings are rated by ISO 20056-1 and -2, not by ISO 281"
        raise InputError("bearing", "with ceramic rollers", condition, "ask the maker for its ratings")
    if not all(of_steel):
        raise InputError("bearing", "of other materials", "be of bearing steel", "leave the ratings out")
    if is_hollow(row.roller):
        condition = "have solid rollers, whose capacities ISO 281 has"
        raise InputError("bearing", "with hollow rollers", condition, "leave the ratings out")


def _are_alike(one: RollerBearing, other: RollerBearing) -> bool:
    sizes = [
        (row.roller_diameter, length_of(row), row.pitch, row.nominal_angle, float(row.rollers)) for row in (one, other)
    ]
    same = all(math.isclose(a, b, rel_tol=_ALIKE) for a, b in zip(*sizes, strict=True))
    return type(one) is type(other) and same
