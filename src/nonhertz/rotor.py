"""Bearings in programs for rotor dynamics: their stiffness at a load as a bearing element of ROSS.

ROSS has x and y across the shaft and z along it, in N and m; here x is along the shaft, y and z across, in N and mm.
ROSS's x, y, z are y, z, x here, which turns the axes but does not mirror them: rotations keep their sign, and a
positive load along y here is one along x there. ROSS's motions are those of the shaft, and so of the inner ring.

A bearing of ROSS holds its node along x, y and z, and x and z, or y and z, are not coupled. What a roller bearing has
beside that, its stiffness against rotation and what couples rotations and axial with radial motions, has no place
there. Motions that are not held in ROSS can be let go here (``free``); the forces along them then stay what they are,
and the stiffness is that which is left (static condensation).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.bearing import BearingSolution
from nonhertz.bearing.section import MOTIONS
from nonhertz.errors import InputError
from nonhertz.inputs.checks import listed, not_negative, numbers, whole
from nonhertz.result.data import library

__all__ = ["bearing_element", "stiffness"]

Array = NDArray[np.float64]

MOST_NODES = 1_000_000
#: Which of the inner ring's motions are ROSS's x, y and z.
HELD = (MOTIONS.index("y"), MOTIONS.index("z"), MOTIONS.index("x"))
FREED = ("x", "about_y", "about_z")
_IN_METRES = 1e3  # N/m per N/mm
_RADIANS = math.pi / 30.0  # rad/s per 1/min
_RIDGE = 1e-12  # of the largest stiffness, below which nothing resists


def stiffness(solution: BearingSolution, *, free: Sequence[str] = ()) -> Array:
    """Return the stiffness of a bearing at its load along ROSS's axes.

    Parameters
    ----------
    solution : BearingSolution
        The bearing under its load.
    free : sequence of str
        Motions that give way, so that the force or moment along them stays the same: of ``"x"``, ``"about_y"``,
        ``"about_z"``. The others are held. Left out, all are: right where the shaft is stiff against the bearing's
        moments and another bearing holds it along its axis.

    Returns
    -------
    ndarray, shape (3, 3)
        d(force) / d(displacement) along x, y and z of ROSS [N/m].

    Raises
    ------
    InputError
        If the input is invalid.

    Examples
    --------
    >>> import nonhertz as nh
    >>> roller = nh.Roller(diameter=9, length=10, profile=nh.profile.crown(radius=4000))
    >>> rings = {"inner": nh.Ring(diameter=37.5), "outer": nh.Ring(diameter=-55.5)}
    >>> row = nh.bearing.CylindricalRollerBearing(roller=roller, **rings, rollers=13)
    >>> loaded = nh.bearing.solve(row, radial=(0, 5e3), method="slices")
    >>> abs(stiffness(loaded) / 1e6).round(0)
    array([[404.,   0.,   0.],
           [  0., 579.,   0.],
           [  0.,   0.,   0.]])
    """
    if not isinstance(solution, BearingSolution):
        raise InputError("solution", solution, "be a BearingSolution", "make one with nonhertz.bearing.solve")
    remedy = "name some of " + ", ".join(FREED) + ", or leave it out"
    names = listed("free", free, "be a list of motions", remedy)
    for name in names:
        if name not in FREED:
            raise InputError("free", name, "be a motion that ROSS does not need", remedy)
    gone = [MOTIONS.index(name) for name in dict.fromkeys(names)]
    whole_of_it = np.array(solution.stiffness)
    kept = [k for k in HELD if k not in gone]
    left = np.zeros((5, 5))
    left[np.ix_(kept, kept)] = _condensed(whole_of_it, kept, gone, _lever(solution))
    return _IN_METRES * left[np.ix_(HELD, HELD)]


def _lever(solution: BearingSolution) -> Array:
    """Return lengths that make displacements of the ring's motions [mm], shape (5,)."""
    pitch = max(row.bearing.pitch for row in solution.bearing.rows)
    return np.array([1.0, 1.0, 1.0, 0.5 * pitch, 0.5 * pitch])


def _condensed(matrix: Array, kept: list[int], gone: list[int], lever: Array) -> Array:
    """Return the stiffness of some motions where others give way; what nothing resists is left alone."""
    block: Array = matrix[np.ix_(kept, kept)]
    if not gone:
        return block
    scaled = matrix / np.outer(lever, lever)
    against = scaled[np.ix_(gone, gone)]
    # Of a free motion that nothing resists, as along the axis of a cylindrical row, the pseudo-inverse makes nothing.
    followed = np.linalg.pinv(against, rcond=_RIDGE) @ scaled[np.ix_(gone, kept)]
    found: Array = scaled[np.ix_(kept, kept)] - scaled[np.ix_(kept, gone)] @ followed
    return found


def bearing_element(
    n: int,
    solution: BearingSolution | Sequence[BearingSolution],
    *,
    speed: ArrayLike | None = None,
    damping: float = 0.0,
    damping_time: float = 0.0,
    free: Sequence[str] = (),
    **options: Any,
) -> Any:
    """Return a bearing element of ROSS with the stiffness of a bearing at its load.

    Parameters
    ----------
    n : int
        Number of the shaft's node.
    solution : BearingSolution or sequence of BearingSolution
        The bearing under its load; or at several speeds, one for each, which differ by what speed does to the rollers.
    speed : array_like, optional
        The speeds of several solutions, ascending [1/min]; the element has them as ``frequency`` [rad/s].
    damping : float
        Along x and y, and along z where there is stiffness [N s/m]. Friction and oil are not part of the model, so that
        damping is known from elsewhere.
    damping_time : float
        Damping besides, as a share of the stiffness: damping over stiffness [s]. For roller bearings 0.25e-5 to
        2.5e-5 s are usual (Kraemer, Dynamics of Rotors and Foundations, 1993; recalled).
    free : sequence of str
        As in `stiffness`.
    **options
        Passed on to ``ross.BearingElement``, such as ``tag``, ``n_link`` or ``color``.

    Returns
    -------
    ross.BearingElement
        With kxx, kxy, kyx, kyy, kzz and the same of damping.

    Raises
    ------
    InputError
        If the input is invalid.
    ImportError
        If ROSS is not installed: the extra ``ross``.

    Notes
    -----
    Between given speeds, ROSS puts a spline through four coefficients or more, a parabola or a line through fewer, and
    continues them beyond. Its spline may miss coefficients by about 1, which is nothing for a stiffness in N/m but may
    be something for damping of a few N s/m.
    """
    node = whole("n", n, 0, MOST_NODES, "give the number of the node, from 0")
    not_negative("damping", damping, "give it in N s/m")
    not_negative("damping_time", damping_time, "give damping over stiffness in s, 1e-5 say")
    remedy = "give one or more from nonhertz.bearing.solve"
    if isinstance(solution, BearingSolution):
        states = [solution]
    else:
        states = listed("solution", solution, "be solutions of a bearing", remedy)
    if not states:
        raise InputError("solution", solution, "hold a solution for each speed", remedy)
    k = np.array([stiffness(each, free=free) for each in states])
    frequency = None if isinstance(solution, BearingSolution) and speed is None else _frequency(speed, len(states))
    c = damping_time * k + damping * np.eye(3) * (np.diagonal(k, axis1=1, axis2=2) > 0.0)[:, None, :]
    ross = library("ross", "bearing_element", "ross", "ross-rotordynamics")
    places = {"xx": (0, 0), "xy": (0, 1), "yx": (1, 0), "yy": (1, 1), "zz": (2, 2)}
    given = {f"{letter}{name}": of[:, i, j] for letter, of in (("k", k), ("c", c)) for name, (i, j) in places.items()}
    if frequency is None:
        return ross.BearingElement(n=node, **{name: float(values[0]) for name, values in given.items()}, **options)
    return ross.BearingElement(n=node, **given, frequency=frequency, **options)


def _frequency(speed: ArrayLike | None, count: int) -> Array:
    """Return speeds in rad/s, one for each of several solutions."""
    remedy = "give the speed of each solution in 1/min, two or more that ascend"
    found = numbers("speed", speed, remedy)  # type: ignore[arg-type]
    if found.shape != (count,) or count < 2 or np.any(np.diff(found) <= 0.0) or found[0] < 0.0:
        raise InputError("speed", speed, f"be ascending and as many as the solutions, {count}", remedy)
    return found * _RADIANS
