"""The verb: a bearing and what acts on it in, loads and motions out."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.bearing.bearings import Paired, RollerBearing, TaperedRollerBearing
from nonhertz.bearing.equilibrium import TOLERANCE, Joint, States, System, balanced
from nonhertz.bearing.laws import ContactLaw, Point
from nonhertz.bearing.mapped import BearingMaps, MapLaw
from nonhertz.bearing.section import raceway_motion
from nonhertz.bearing.solution import BearingSolution
from nonhertz.bearing.standard import EXPONENT, LAMINAE, STIFFNESS, standard_slices
from nonhertz.bearing.states import BearingSolutions
from nonhertz.bearing.strips import StripLaw
from nonhertz.errors import ConvergenceError, InputError
from nonhertz.inputs.checks import broadcast, finite, not_negative, numbers, one_of, whole
from nonhertz.life.lamina import FEWEST, MOST
from nonhertz.model.prescription import MOST_TILT

Array = NDArray[np.float64]
Method = Literal["strips", "slices"]

METHODS = ("strips", "slices")
# What leads to the neighbourhood of the balance, and what may be left there, over the loads.
FEW_SLICES, ROUGH_STRIPS, NEARBY = 11, 21, 1e-2
_UNIT_OF_SPEED = math.pi / 30.0


def solve(
    bearing: RollerBearing | Paired,
    *,
    radial: ArrayLike | None = None,
    axial: float | None = None,
    moment: ArrayLike | None = None,
    radial_displacement: ArrayLike | None = None,
    axial_displacement: float | None = None,
    tilt: ArrayLike | None = None,
    speed: float = 0.0,
    method: Method = "strips",
    laminae: int = LAMINAE,
    maps: BearingMaps | None = None,
) -> BearingSolution:
    """Load a bearing, or move its inner ring; the outer ring is at rest.

    Parameters
    ----------
    bearing : RollerBearing or Paired
        The bearing.
    radial, radial_displacement : float or tuple of float, optional
        Force [N] on the inner ring or its displacement [mm]: along y, or along y and z. Not both; without either there
        is no radial force.
    axial, axial_displacement : float, optional
        The same along x, where the bearing bears axial loads; without either there is no axial force.
    moment, tilt : float or tuple of float, optional
        Moment [N mm] on the inner ring or its rotation [rad]: about z, or about y and z. Without either the ring does
        not tilt. A positive tilt about z moves the ring at high x along +y.
    speed : float
        Of the inner ring [1/min], for centrifugal loads and the rollers' gyroscopic moments.
    method : {"strips", "slices"}
        ``"strips"``: every contact by strips, on the automatic grid. ``"slices"``: the independent slices of ISO/TS
        16281, with the nominal contact angle at both rings and no ribs, for comparison.
    laminae : int
        Number of slices, at least 30.
    maps : BearingMaps, optional
        Of this bearing, from `maps`, in place of strips while the balance is found.

    Returns
    -------
    BearingSolution

    Raises
    ------
    InputError
        If the input is invalid.
    ConvergenceError
        If no balance is found.

    Notes
    -----
    Rollers have three motions of their own, along x and r and about the tangent; friction and skew are left out, and
    displacements are small compared with the rollers. Every roller is pressed alike on both sides by its contacts, as
    the model of its whole body assumes; where they are tilted differently, that neglects the odd part.

    Examples
    --------
    >>> import nonhertz as nh
    >>> roller = nh.Roller(diameter=9, length=10, profile=nh.profile.crown(radius=4000))
    >>> rings = {"inner": nh.Ring(diameter=37.5), "outer": nh.Ring(diameter=-55.5)}
    >>> row = nh.bearing.CylindricalRollerBearing(roller=roller, **rings, rollers=13, clearance=0.018)
    >>> float(solve(row, radial=20e3, method="slices").load[0, 0].round(-1))
    6830.0
    """
    setting = _Setting.checked(bearing, speed, method, laminae, maps)
    by_force, target = _given(bearing, (radial, radial_displacement), (axial, axial_displacement), (moment, tilt))
    found = setting.solved(by_force, target[None])
    if not found.residual[0] <= TOLERANCE:
        raise ConvergenceError(
            f"Rollers and rings found no balance in {found.steps[0]} steps: the loads may leave the inner ring unheld.",
            None,
        )
    return BearingSolution.of(bearing, method, found, setting.load)


def solve_many(
    bearing: RollerBearing | Paired,
    *,
    radial: ArrayLike | None = None,
    axial: ArrayLike | None = None,
    moment: ArrayLike | None = None,
    radial_displacement: ArrayLike | None = None,
    axial_displacement: ArrayLike | None = None,
    tilt: ArrayLike | None = None,
    speed: float = 0.0,
    method: Method = "strips",
    laminae: int = LAMINAE,
    maps: BearingMaps | None = None,
) -> BearingSolutions:
    """Load a bearing in many ways; with maps a state costs a millisecond.

    Parameters
    ----------
    bearing : RollerBearing or Paired
        The bearing.
    radial, axial, moment, radial_displacement, axial_displacement, tilt : array_like, optional
        As in `solve`, along y, x and about z, broadcast against each other.
    speed, method, laminae, maps
        As in `solve`, for all states.

    Returns
    -------
    BearingSolutions

    Raises
    ------
    InputError
        If the input is invalid.
    """
    setting = _Setting.checked(bearing, speed, method, laminae, maps)
    given = {
        "radial": radial, "axial": axial, "moment": moment, "radial_displacement": radial_displacement,
        "axial_displacement": axial_displacement, "tilt": tilt,
    }  # fmt: skip
    rows = {name: numbers(name, each, "give numbers") for name, each in given.items() if each is not None}
    spread = dict(zip(rows, broadcast("give arrays that fit each other", *rows.values()), strict=True)) if rows else {}
    shape = next(iter(spread.values())).shape if spread else ()
    count = math.prod(shape)
    if not count:
        name = next(iter(rows))
        raise InputError(name, given[name], "hold at least one number", "give a number or an array of them")
    flat = {name: each.ravel() for name, each in spread.items()}
    found = []
    for k in range(count):
        one: dict[str, float | None] = {name: float(flat[name][k]) if name in flat else None for name in given}
        pairs = (one["radial"], one["radial_displacement"]), (one["axial"], one["axial_displacement"])
        found.append(_given(bearing, *pairs, (one["moment"], one["tilt"])))
    states = setting.solved(found[0][0], np.array([target for _, target in found]))
    return BearingSolutions.of(bearing, method, states, setting.load, shape)


@dataclass(frozen=True, eq=False)
class _Setting:
    """A bearing and how it is to be solved, checked."""

    bearing: RollerBearing | Paired
    method: str
    laminae: int
    maps: BearingMaps | None
    load: Array

    @classmethod
    def checked(
        cls, bearing: RollerBearing | Paired, speed: float, method: str, laminae: int, maps: BearingMaps | None
    ) -> _Setting:
        if not isinstance(bearing, RollerBearing | Paired):
            remedy = "make one, such as nonhertz.bearing.CylindricalRollerBearing"
            raise InputError("bearing", bearing, "be a bearing", remedy)
        one_of("method", method, METHODS, "use 'strips', or 'slices' for comparison")
        laminae = whole("laminae", laminae, FEWEST, MOST, "give the number of slices, 41 say")
        not_negative("speed", speed, "give the speed of the inner ring in 1/min")
        if maps is not None:
            if not isinstance(maps, BearingMaps) or maps.bearing != bearing:
                remedy = "make them with nonhertz.bearing.maps"
                raise InputError("maps", maps, "be maps of this bearing", remedy)
            if method != "strips":
                raise InputError("maps", maps, "not be given with slices", "leave out method")
        rate = _UNIT_OF_SPEED * float(speed)
        rows = [row.bearing for row in bearing.rows]
        load = np.concatenate([np.tile(each.load_by_speed(rate), (each.rollers, 1)) for each in rows])
        return cls(bearing, method, laminae, maps, load)

    def solved(self, by_force: NDArray[np.bool_], target: Array) -> States:
        """Return the states of the bearing."""
        depth = _depth(self.bearing, by_force, target)
        start = np.zeros_like(target)
        start[:, 0] = np.where(target[:, 0] != 0.0, np.sign(target[:, 0]) * depth, 0.0)
        if self.method == "slices":
            return balanced(_sliced(self.bearing, self.load, self.laminae), by_force, target, start, depth)
        sliced = balanced(_sliced(self.bearing, self.load, FEW_SLICES), by_force, target, start, depth, NEARBY)
        if self.maps is not None:
            laws = [
                [MapLaw(*each) for each in zip(row.bearing.contacts, pair, strict=True)]
                for row, pair in zip(self.bearing.rows, self.maps.contacts, strict=True)
            ]
            found = balanced(_jointed(self.bearing, self.load, laws), by_force, target, sliced.ring, depth)
            _refuse_beyond(self.bearing, laws, found)
            return found
        rough = balanced(self._stripped(ROUGH_STRIPS), by_force, target, sliced.ring, depth, NEARBY)
        fine = self._stripped(None)
        found = balanced(fine, by_force, target, rough.ring, depth, NEARBY, rough.rollers.motion)
        # Strips are laid for the contacts as they were when they were first met.
        for joint in fine.joints:
            if isinstance(joint.law, StripLaw):
                joint.law.lay_anew()
        return balanced(fine, by_force, target, found.ring, depth, motion=found.rollers.motion)

    def _stripped(self, strips: int | None) -> System:
        laws = [[StripLaw(contact, strips) for contact in row.bearing.contacts] for row in self.bearing.rows]
        return _jointed(self.bearing, self.load, laws)


def _refuse_beyond(bearing: RollerBearing | Paired, laws: Sequence[Sequence[MapLaw]], found: States) -> None:
    """Refuse states whose contacts the maps do not hold."""
    first = 0
    rollers = found.rollers
    for row, pair in zip(bearing.rows, laws, strict=True):
        count = row.bearing.rollers
        these = slice(first, first + count)
        for k, law in enumerate(pair):
            approach, tilt = rollers.approach[:, these, k], rollers.tilt[:, these, k]
            covered = law.covers(approach.ravel(), tilt.ravel()).reshape(approach.shape)
            if not np.all(covered | (rollers.load[:, these, k] == 0.0)):
                load, turned = float(rollers.load.max()), float(np.abs(rollers.tilt).max())
                condition = f"reach to loads of {load:.4g} N and tilts of {turned:.4g} rad, which these states have"
                raise InputError("maps", "too small", condition, "make larger ones")
        first += count


def _given(
    bearing: RollerBearing | Paired,
    radial: tuple[ArrayLike | None, ArrayLike | None],
    axial: tuple[float | None, float | None],
    turning: tuple[ArrayLike | None, ArrayLike | None],
) -> tuple[NDArray[np.bool_], Array]:
    """Return of which motions the force is given, and what is given, each of shape (5,)."""
    by_force, target = np.zeros(5, dtype=np.bool_), np.zeros(5)
    axially = any(row.bearing.holds_axially for row in bearing.rows)
    radially = any(row.bearing.bears_radially for row in bearing.rows)
    pairs = (
        ("radial", "radial_displacement", radial, slice(1, 3), ("N", "mm"), radially),
        ("axial", "axial_displacement", axial, slice(0, 1), ("N", "mm"), axially),
        ("moment", "tilt", turning, slice(3, 5), ("N mm", "rad"), False),
    )
    for force, motion, values, where, units, forced in pairs:
        if values[0] is not None and values[1] is not None:
            raise InputError(motion, values[1], f"not be given together with {force}", "leave one of them out")
        by_force[where] = values[0] is not None or (values[1] is None and forced)
        name, value, unit = (motion, values[1], units[1]) if values[1] is not None else (force, values[0], units[0])
        if value is None:
            continue
        given = numbers(name, value, f"give it in {unit}")
        size = where.stop - where.start
        if given.ndim and given.shape != (size,):
            raise InputError(name, value, "be a number or two" if size == 2 else "be a number", f"give it in {unit}")
        # A single number is along y, or about z: in the plane of the first roller.
        target[where] = given if given.ndim else ((0.0, given) if force == "moment" else (given, 0.0))[:size]
    for name, borne, where, way in (
        ("axial", axially, slice(0, 1), "along"),
        ("radial", radially, slice(1, 3), "across"),
    ):
        if not borne and np.any(by_force[where]):
            if np.any(target[where] != 0.0):
                condition = f"be zero for a bearing whose inner ring is free to move {way} the axis"
                raise InputError(
                    name, float(np.max(np.abs(target[where]))), condition, f"use one that bears {name} loads"
                )
            by_force[where] = False
    least = _least_axial(bearing, math.hypot(*target[1:3]) if np.all(by_force[1:3]) else 0.0)
    if by_force[0] and least is not None and not (target[0] > least or target[0] == least == 0.0):
        condition = f"exceed {least:.4g} N, the tangent of the contact angle times the radial force"
        remedy = "without that rows that bear it one way alone fall apart; or give axial_displacement"
        raise InputError("axial", float(target[0]), condition, remedy)
    if np.max(np.abs(target[3:])) > MOST_TILT and turning[1] is not None:
        remedy = "give it in rad: 1 mrad is 0.001, 1 degree 0.01745"
        raise InputError("tilt", turning[1], f"be a small angle, of at most {MOST_TILT:g} rad", remedy)
    for each in target:
        finite("load", float(each), "give forces in N and moments in N mm")
    return by_force, target


def _least_axial(bearing: RollerBearing | Paired, radial: float) -> float | None:
    """Return the axial force [N] that the radial one needs where all rows bear axial loads along +x; else None."""
    if not all(row.bearing.holds_axially and not row.turned for row in bearing.rows):
        return None
    return min(math.tan(row.bearing.nominal_angle) for row in bearing.rows) * radial if radial > 0.0 else 0.0


def _depth(bearing: RollerBearing | Paired, by_force: NDArray[np.bool_], target: Array) -> float:
    """Return a penetration of the size to be expected [mm]."""
    rows = [row.bearing for row in bearing.rows]
    pitch = max(row.pitch for row in rows)
    reach = np.array([1.0, 1.0, 1.0, pitch, pitch])
    most = float(np.max(np.where(by_force, np.abs(target) / reach, 0.0), initial=0.0)) * 5.0
    most /= sum(row.rollers for row in rows)
    length = min(row.roller_length for row in rows)
    by_load = float((most / (STIFFNESS * length ** (8.0 / 9.0))) ** (1.0 / EXPONENT))
    moved = float(np.max(np.where(by_force, 0.0, np.abs(target * reach)), initial=0.0))
    gap = max(float(np.max(np.abs(each))) for row in bearing.rows for each in row.gaps)
    return max(by_load, moved, 1e-6 * max(row.roller_diameter for row in rows)) + 4.0 * gap


def _sliced(bearing: RollerBearing | Paired, load: Array, laminae: int) -> System:
    """Return the rollers with independent slices, as ISO/TS 16281 has them."""
    joints: list[Joint] = []
    first, load = 0, load.copy()
    for row in bearing.rows:
        angle, law = row.bearing.nominal_angle, standard_slices(row.bearing, laminae)
        # The standard knows of nothing that holds rollers along their axes: what presses on the raceway is left.
        normal = np.array([math.sin(angle), math.cos(angle), 0.0])
        load[first : first + row.bearing.rollers] = np.outer(load[first : first + row.bearing.rollers] @ normal, normal)
        for column, gap in enumerate(row.gaps):
            inner = column == 0
            joints.append(Joint(inner, raceway_motion(angle, inner=inner), gap, law, column, first))
        first += row.bearing.rollers
    return _system(bearing, joints, load)


def _jointed(bearing: RollerBearing | Paired, load: Array, laws: Sequence[Sequence[ContactLaw]]) -> System:
    """Return the rollers with a law for each raceway of each row, and ribs."""
    joints: list[Joint] = []
    first = 0
    for row, of_row in zip(bearing.rows, laws, strict=True):
        for column, (motion, gap, law) in enumerate(zip(row.bearing.raceway_motions, row.gaps, of_row, strict=True)):
            joints.append(Joint(column == 0, motion, gap, law, column, first))
        if isinstance(row.bearing, TaperedRollerBearing):
            motion, radius = row.bearing.end_contact()
            free = np.zeros(row.bearing.rollers)
            joints.append(Joint(True, motion, free, _end(row.bearing, radius), 2, first))
        first += row.bearing.rollers
    return _system(bearing, joints, load)


def _system(bearing: RollerBearing | Paired, joints: list[Joint], load: Array) -> System:
    motion = np.concatenate([row.ring_motion for row in bearing.rows])
    lever = 0.5 * max(row.bearing.roller_length for row in bearing.rows)
    return System(motion, tuple(joints), load, lever)


def _end(bearing: RollerBearing, radius: float) -> ContactLaw:
    """Return how a spherical end answers on a flat rib, after Hertz."""
    compliance = bearing.roller.material.compliance + bearing.inner.material.compliance
    # K = 1 / (pi E*), and the load is 4/3 E* R^(1/2) approach^(3/2).
    return Point(4.0 / 3.0 / (math.pi * compliance) * math.sqrt(radius))
