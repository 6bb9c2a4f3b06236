"""Loading of the inner ring as given: forces, moments, displacements and rotations of one state or many."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Annotated, ClassVar, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.amounts import newton
from nonhertz.bearing.bearings import RollerBearing
from nonhertz.bearing.pairs import Paired
from nonhertz.bearing.section import RINGS
from nonhertz.errors import InputError
from nonhertz.inputs.assumed import Assumed
from nonhertz.inputs.checks import broadcast, finite, not_negative, number_that, numbers
from nonhertz.inputs.descriptions import OneOrTwo, Quantity, Word
from nonhertz.inputs.fields import Input, input_class
from nonhertz.model.prescription import MOST_TILT

Array = NDArray[np.float64]

#: A number, or one along each of two axes.
OneOrBoth = float | tuple[float, float]
#: Names of two components, and which of them a single number is.
_ALONG_Y, _ABOUT_Z = (("along y", "along z"), 0), (("about y", "about z"), 1)
_ROTATION = "give it in rad: 1 mrad is 0.001, 1 degree 0.01745"


_SMALL = f"be a small angle, of at most {MOST_TILT:g} rad"
_rotation = number_that(lambda value: abs(value) <= MOST_TILT, _SMALL)


@input_class(kw_only=True)
class TurningRing(Input):
    """Which ring turns."""

    turning: Annotated[
        str,
        Word(
            "which ring turns: 'inner' or 'outer'; the other is at rest, as the loads are",
            "name the ring that turns against the load",
            RINGS,
        ),
        Assumed("inner ring turns", "L10r"),
    ] = "inner"


@input_class(kw_only=True)
class BearingLoad(Input):
    """Loads or motions of the inner ring; the outer ring is at rest.

    Raises
    ------
    InputError
        If one of them is out of range. Whether a bearing can support the load is checked when it is solved.
    """

    instead: ClassVar[Mapping[str, str]] = {
        "radial_displacement": "radial",
        "axial_displacement": "axial",
        "tilt": "moment",
    }

    radial: Annotated[
        OneOrBoth | None,
        OneOrTwo(
            Quantity("N", "a force", finite, "give it in N"),
            "radial force along y, towards the first roller, or a list of two: along y and z",
            *_ALONG_Y,
        ),
    ] = None
    radial_displacement: Annotated[
        OneOrBoth | None,
        OneOrTwo(
            Quantity("mm", "a displacement", finite, "give it in mm"),
            "radial displacement along y, or along y and z, in place of the force",
            *_ALONG_Y,
        ),
    ] = None
    axial: Annotated[float | None, Quantity("N", "axial force, along x", finite, "give it in N")] = None
    axial_displacement: Annotated[
        float | None, Quantity("mm", "axial displacement, in place of the force", finite, "give it in mm")
    ] = None
    tilt: Annotated[
        OneOrBoth | None,
        OneOrTwo(
            Quantity("rad", "a rotation", _rotation, _ROTATION),
            "rotation of the inner ring about z, in the plane of x and y, or a list of two: about y and z; positive "
            "about z moves the ring at high x along +y; without tilt and moment the ring does not tilt",
            *_ABOUT_Z,
        ),
    ] = None
    moment: Annotated[
        OneOrBoth | None,
        OneOrTwo(
            Quantity("N mm", "a moment", finite, "give it in N mm"),
            "moment on the inner ring about z, or about y and z, in place of the tilt",
            *_ABOUT_Z,
        ),
    ] = None
    speed: Annotated[
        float,
        Quantity(
            "1/min",
            "speed of the turning ring, for centrifugal loads and the life",
            not_negative,
            "give the speed of the turning ring in 1/min",
        ),
    ] = 0.0


class Prescribed(NamedTuple):
    """The given values."""

    by_force: NDArray[np.bool_]  # for each motion of the ring, whether its force or moment is given, (5,)
    target: Array  # given values [N, N mm, mm, rad], (states, 5)


class _Pair(NamedTuple):
    """A force and the motion that may replace it; ``first`` is the component that a single number stands for."""

    force: str
    motion: str
    where: slice
    first: int


_PAIRS = (
    _Pair("radial", "radial_displacement", slice(1, 3), 0),
    _Pair("axial", "axial_displacement", slice(0, 1), 0),
    _Pair("moment", "tilt", slice(3, 5), 1),
)
_COINCIDE = 0.02  # of the pitch diameter: largest distance between the centres of spheres that count as one


def one_state(bearing: RollerBearing | Paired, load: BearingLoad) -> Prescribed:
    """Return the given values of one state.

    Raises
    ------
    InputError
        If the bearing cannot support the load.
    """
    values = {
        name: np.asarray(value, dtype=float)[None]
        for pair in _PAIRS
        for name in (pair.force, pair.motion)
        if (value := getattr(load, name)) is not None
    }
    return _check_values(bearing, values, 1)


def many_states(
    bearing: RollerBearing | Paired, inputs: Mapping[str, ArrayLike | None]
) -> tuple[Prescribed, tuple[int, ...]]:
    """Return the given values of many states, and their shape: arrays along y, x and about z."""
    rows = {name: numbers(name, value, "give numbers") for name, value in inputs.items() if value is not None}
    spread = dict(zip(rows, broadcast("give arrays of matching shapes", *rows.values()), strict=True)) if rows else {}
    shape = next(iter(spread.values())).shape if spread else ()
    if not math.prod(shape):
        name = next(iter(rows))
        raise InputError(name, inputs[name], "hold at least one number", "give a number or an array of them")
    flat = {name: values.ravel() for name, values in spread.items()}
    return _check_values(bearing, flat, math.prod(shape)), shape


def motions(displacement: ArrayLike, others: Mapping[str, object]) -> tuple[Prescribed, tuple[int, ...]]:
    """Return the given motions of the ring in many states, and their shape."""
    for name, value in others.items():
        if value is not None:
            raise InputError(name, value, "not be given together with displacement", "leave one of them out")
    remedy = "give x, y and z in mm and rotations about y and z in rad"
    motion = numbers("displacement", displacement, remedy)
    if motion.ndim == 0 or motion.shape[-1] != 5 or not motion.size:
        raise InputError("displacement", motion.shape, "be of shape (..., 5)", remedy)
    _refuse_large("displacement", motion[..., 3:])
    return Prescribed(np.zeros(5, dtype=np.bool_), motion.reshape(-1, 5)), motion.shape[:-1]


def _check_values(bearing: RollerBearing | Paired, values: Mapping[str, Array], count: int) -> Prescribed:
    """Check the given values: for each name numbers, shape (count,), or components, shape (count, components)."""
    by_force, target = np.zeros(5, dtype=np.bool_), np.zeros((count, 5))
    axially = any(any(row.bears_axially) for row in bearing.rows)
    radially = any(row.bearing.bears_radially for row in bearing.rows)
    forced = {"radial": radially, "axial": axially, "moment": False}
    aligns = bool(np.ptp([row.aligns_about for row in bearing.rows]) < _COINCIDE * bearing.rows[0].bearing.pitch)
    for pair in _PAIRS:
        names = values.keys() & {pair.force, pair.motion}
        if len(names) == 2:
            condition = f"not be given together with {pair.force}"
            raise InputError(pair.motion, values[pair.motion][0].tolist(), condition, "leave one of them out")
        by_force[pair.where] = pair.force in names if names else forced[pair.force]
        for value in map(values.__getitem__, names):
            target[:, pair.where if value.ndim > 1 else pair.where.start + pair.first] = value
    _refuse_unborne("axial", axially, "move along the axis", (by_force, target), _PAIRS[1].where)
    _refuse_unborne("radial", radially, "move across the axis", (by_force, target), _PAIRS[0].where)
    _refuse_unborne("moment", not aligns, "turn about the centre of a sphere", (by_force, target), _PAIRS[2].where)
    _refuse_falling_apart(bearing, by_force, target)
    if "tilt" in values:
        _refuse_large("tilt", target[:, 3:])
    return Prescribed(by_force, target)


def _refuse_unborne(name: str, borne: bool, way: str, acting: tuple[NDArray[np.bool_], Array], where: slice) -> None:
    """Refuse a force that the bearing cannot support; without one, the ring is held in that direction."""
    by_force, target = acting
    if borne or not np.any(by_force[where]):
        return
    if np.any(target[:, where] != 0.0):
        condition = f"be zero for a bearing whose inner ring is free to {way}"
        largest = float(np.max(np.abs(target[:, where])))
        remedy = "give tilt, or use one that supports moments" if name == "moment" else f"use one for {name} loads"
        raise InputError(name, largest, condition, remedy)
    by_force[where] = False


def _refuse_falling_apart(bearing: RollerBearing | Paired, by_force: NDArray[np.bool_], target: Array) -> None:
    """Refuse an axial force below that required by the radial force where rows support axial loads one way only."""
    up, down = np.any([row.bears_axially for row in bearing.rows], axis=0)
    if not by_force[0] or up == down:
        return
    radial = np.hypot(target[:, 1], target[:, 2]) if np.all(by_force[1:3]) else np.zeros(len(target))
    # A row located axially by ribs, or not at all, needs no axial force for a radial one.
    slope = min(math.tan(row.bearing.nominal_angle) for row in bearing.rows)
    least = np.where(radial > 0.0, slope * radial, 0.0)
    axial = target[:, 0] if up else -target[:, 0]
    falls = np.flatnonzero(~((axial > least) | ((axial == 0.0) & (least == 0.0))))
    if falls.size:
        k = falls[0]
        way, remedy = "+x" if up else "-x", "with less the row separates"
        condition = (
            f"exceed {newton(least[k]):.4g} along {way}, the tangent of the contact angle times the radial force"
        )
        if least[k] == 0.0:
            condition, remedy = (
                f"act along {way}, the only direction in which this bearing supports it",
                "turn it round",
            )
        raise InputError("axial", float(target[k, 0]), condition, f"{remedy}; or give axial_displacement")


def _refuse_large(name: str, rotations: Array) -> None:
    """Refuse rotations that are not small."""
    largest = float(rotations.flat[np.argmax(np.abs(rotations))])
    if abs(largest) > MOST_TILT:
        raise InputError(name, largest, _SMALL, _ROTATION)
