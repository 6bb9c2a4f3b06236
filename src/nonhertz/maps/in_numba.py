"""`nonhertz.maps.evaluation` in machine code, for bearings by maps until their balance is found in C++."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from nonhertz.compiled import compiled

Array = NDArray[np.float64]

ORDER = 6  # coefficients of a polynomial of degree 5
CELL = ORDER * ORDER
MOST_LOAD, TILT_LOW, TILT_HIGH, CENTRE, NARROW, WIDENING, RISE, LOW_END, HIGH_END, LOAD_CELLS, TILT_CELLS = range(11)
HEAD = 11  # numbers before the borders of the cells
THIRD = 1.0 / 3.0
Values = tuple[float, float, float, float, float]
# Newton's method converges quadratically, and one linear step follows: a last step of 1e-5 leaves 1e-20.
_STEPS, _CLOSE = 60, 1e-5
# Of the slope of the approach, were it quadratic in x: keeps the stiffness finite whatever the coefficients are.
_LEAST_SLOPE = 1e-3


class Tables(NamedTuple):
    """What compiled code needs of a map: flat arrays.

    Attributes
    ----------
    mean_approach : ndarray
        Eleven numbers: largest load, lowest and highest tilt, the three of the tilt coordinate, what the approach
        typically grows by up to the largest load, ends of the contact, cells in both directions; borders of the cells
        in x, then in z; coefficients of the mean approach, 36 per cell. In one array, because in compiled code each
        array taken out of a tuple costs a count of its references, which is more than the arithmetic of a polynomial.
    others : ndarray
        Coefficients of maximum pressure / x, largest half-width / x and the places along y up to which the contact
        bears sin^2(k pi / 48) of the load, k = 0 ... 24; 36 per cell and quantity, cell by cell.
    """

    mean_approach: Array
    others: Array


class State(NamedTuple):
    """What compiled evaluation returns.

    Attributes
    ----------
    approach, tilt, load, moment : float
        delta [mm], gamma [rad], Q [N], T [N mm].
    load_by_approach, load_by_tilt, moment_by_tilt : float
        Stiffness [N/mm, N/rad, N mm/rad]; moment_by_approach is load_by_tilt.
    inside : bool
        Whether the point is in the range of the map. Outside, load and moment are continued linearly.
    """

    approach: float
    tilt: float
    load: float
    moment: float
    load_by_approach: float
    load_by_tilt: float
    moment_by_tilt: float
    inside: bool


@compiled
def tilt_coordinate(numbers: Array, x: float, tilt: float) -> tuple[float, float, float, float, float, float]:
    """Return z and dz/dx, dz/dgamma, d2z/dx2, d2z/dxdgamma, d2z/dgamma2."""
    if numbers[WIDENING] == 0.0:
        slope = 1.0 / (numbers[TILT_HIGH] - numbers[TILT_LOW])
        return (tilt - numbers[TILT_LOW]) * slope, 0.0, slope, 0.0, 0.0, 0.0
    scale = numbers[NARROW] + numbers[WIDENING] * x**3
    scale_x, scale_xx = 3.0 * numbers[WIDENING] * x**2, 6.0 * numbers[WIDENING] * x
    w, w_x, w_xx, w_g, w_xg, w_gg = _stretched(tilt - numbers[CENTRE], scale, scale_x, scale_xx)
    low, low_x, low_xx, _, _, _ = _stretched(numbers[TILT_LOW] - numbers[CENTRE], scale, scale_x, scale_xx)
    high, high_x, high_xx, _, _, _ = _stretched(numbers[TILT_HIGH] - numbers[CENTRE], scale, scale_x, scale_xx)
    span, span_x, span_xx = high - low, high_x - low_x, high_xx - low_xx
    z = (w - low) / span
    z_x = (w_x - low_x - z * span_x) / span
    z_g = w_g / span
    z_xx = (w_xx - low_xx - z * span_xx - 2.0 * z_x * span_x) / span
    z_xg = (w_xg - z_g * span_x) / span
    return z, z_x, z_g, z_xx, z_xg, w_gg / span


@compiled
def _stretched(
    angle: float, scale: float, scale_x: float, scale_xx: float
) -> tuple[float, float, float, float, float, float]:
    """Return asinh(angle / scale) and its derivatives by x, twice x, angle, x and angle, twice angle."""
    root = math.sqrt(angle * angle + scale * scale)
    rate = -angle / (scale * root)  # by the scale
    rate_scale = angle * (2.0 * scale * scale + angle * angle) / (scale * scale * root**3)
    return (
        math.asinh(angle / scale),
        rate * scale_x,
        rate * scale_xx + rate_scale * scale_x * scale_x,
        1.0 / root,
        -scale / root**3 * scale_x,
        -angle / root**3,
    )


@compiled
def _interval(table: Array, first: int, count: int, place: float) -> int:
    """Return in which of ``count`` intervals, whose borders begin at index ``first``, a place is."""
    low, high = 0, count
    while high - low > 1:
        middle = (low + high) // 2
        if place >= table[first + middle]:
            low = middle
        else:
            high = middle
    return low


@compiled
def _cell(table: Array, x: float, z: float) -> tuple[int, float, float, float, float]:
    """Return the number of a cell, the place in it and one over its sizes."""
    count, across = int(table[LOAD_CELLS]), int(table[TILT_CELLS])
    i = HEAD + _interval(table, HEAD, count, x)
    beginning = HEAD + count + 1
    j = beginning + _interval(table, beginning, across, z)
    by_width, by_height = 1.0 / (table[i + 1] - table[i]), 1.0 / (table[j + 1] - table[j])
    number = (i - HEAD) * across + j - beginning
    return number, (x - table[i]) * by_width, (z - table[j]) * by_height, by_width, by_height


@compiled
def _polynomial(coefficients: Array, first: int, t: float, u: float) -> tuple[float, float, float, float, float, float]:
    """Return a polynomial in t and u and its derivatives by t, u, twice t, t and u, twice u."""
    f = f_t = f_tt = f_u = f_tu = f_uu = 0.0
    for i in range(ORDER - 1, -1, -1):
        at = first + ORDER * i
        g = g_u = g_uu = 0.0
        for j in range(ORDER - 1, -1, -1):
            g_uu = g_uu * u + g_u
            g_u = g_u * u + g
            g = g * u + coefficients[at + j]
        f_tt = f_tt * t + f_t
        f_t = f_t * t + f
        f = f * t + g
        f_tu = f_tu * t + f_u
        f_u = f_u * t + g_u
        f_uu = f_uu * t + g_uu
    return f, f_t, f_u, 2.0 * f_tt, f_tu, 2.0 * f_uu


@compiled
def _at(table: Array, x: float, tilt: float) -> Values:
    """Return approach and d approach/dx, moment / load and its derivatives by x and by tilt, at x and tilt."""
    z, z_x, z_g, z_xx, z_xg, z_gg = tilt_coordinate(table, x, tilt)
    number, t, u, by_width, by_height = _cell(table, x, z)
    cells = HEAD + int(table[LOAD_CELLS]) + int(table[TILT_CELLS]) + 2
    f, f_x, f_z, f_xx, f_xz, f_zz = _polynomial(table, cells + CELL * number, t, u)
    f_x, f_xx = f_x * by_width, f_xx * (by_width * by_width)
    f_z, f_zz, f_xz = f_z * by_height, f_zz * (by_height * by_height), f_xz * (by_width * by_height)
    by_x = f_x + f_z * z_x
    twice_x = f_xx + (2.0 * f_xz + f_zz * z_x) * z_x + f_z * z_xx
    arm_x = -((f_xz + f_zz * z_x) * z_g + f_z * z_xg)
    arm_g = -(f_zz * z_g * z_g + f_z * z_gg)
    return f + THIRD * x * by_x, THIRD * (4.0 * by_x + x * twice_x), -f_z * z_g, arm_x, arm_g


@compiled
def _first(table: Array, tilt: float) -> tuple[float, float]:
    """Return the approach of first touch and the moment / load there, from the first row of a polynomial."""
    z, _, slope, _, _, _ = tilt_coordinate(table, 0.0, tilt)
    number, _, u, _, by_height = _cell(table, 0.0, z)
    cells = HEAD + int(table[LOAD_CELLS]) + int(table[TILT_CELLS]) + 2
    f = f_u = 0.0
    for power in range(ORDER - 1, -1, -1):
        f_u = f_u * u + f
        f = f * u + table[cells + CELL * number + power]
    return f, -f_u * by_height * slope


@compiled
def _touching(table: Array, tilt: float, first: float, approach: float) -> tuple[float, float, Values]:
    """Return x at an approach beyond first touch, the approach under the largest load, and what `_at` returns there.

    x is 1 where the approach is beyond that of the largest load.
    """
    goal, low, high, last, x = math.sqrt(approach - first), 0.0, 1.0, 0.0, 1.0
    close = False
    for step in range(_STEPS):
        values = _at(table, x, tilt)
        found, slope = values[0], values[1]
        if step == 0:
            last = found
            if approach >= last:
                break
            # Between no load and the largest the root of the rise is nearly linear in x; the slope bends it.
            ratio = goal / math.sqrt(last - first)
            bent = x + (1.0 - 2.0 * (last - first) / slope) * (1.0 - ratio) if slope > 0.0 else 1.0
            x = ratio * min(max(bent, 0.5), 2.0)
            x = min(x, 1.0)
            continue
        if close:
            break
        if found > approach:
            high = x
        else:
            low = x
        beyond = math.sqrt(max(found - first, 0.0))
        better = x + (goal - beyond) * 2.0 * beyond / slope if slope > 0.0 and beyond > 0.0 else -1.0
        if not low <= better <= high:
            better = 0.5 * (low + high)
        close = abs(better - x) <= _CLOSE * x
        x = better
    return x, last, values


@compiled
def _state(table: Array, x: float, tilt: float, values: Values, inside: bool) -> State:
    """Return the state at x > 0 and tilt, from what `_at` returns there."""
    approach, slope, arm, arm_x, arm_g = values
    slope = max(slope, _LEAST_SLOPE * table[RISE] * x)
    most = table[MOST_LOAD]
    load = most * x**3
    moment_by_load = arm + THIRD * x * arm_x
    stiffness = 3.0 * most * x * x / slope
    by_tilt = moment_by_load * stiffness
    return State(approach, tilt, load, load * arm, stiffness, by_tilt, load * arm_g + moment_by_load * by_tilt, inside)


@compiled
def _moved(state: State, approach: float, tilt: float) -> State:
    """Return a state at a neighbouring approach and tilt, load and moment continued linearly."""
    by, turn = approach - state.approach, tilt - state.tilt
    return State(
        approach, tilt,
        state.load + state.load_by_approach * by + state.load_by_tilt * turn,
        state.moment + state.load_by_tilt * by + state.moment_by_tilt * turn,
        state.load_by_approach, state.load_by_tilt, state.moment_by_tilt, state.inside,
    )  # fmt: skip


@compiled
def pressed(tables: Tables, approach: float, tilt: float) -> State:
    """Return the state of a contact at an approach [mm] and a tilt [rad].

    Out of contact load, moment and stiffness are zero. Outside the range of the map they are continued linearly from
    its border, and ``inside`` is False; a load continued below zero is zero, with no stiffness.

    Parameters
    ----------
    tables : Tables
        ``ContactMap.tables``.
    approach, tilt : float
        delta [mm] and gamma [rad], finite.

    Returns
    -------
    State
    """
    table = tables.mean_approach
    within = min(max(tilt, table[TILT_LOW]), table[TILT_HIGH])
    first, arm = _first(table, within)
    # Beyond the range of tilts the first touch goes on in a straight line.
    level = approach + arm * (tilt - within)
    if not level > first:
        return State(approach, tilt, 0.0, 0.0, 0.0, 0.0, 0.0, within == tilt)
    x, last, values = _touching(table, within, first, level)
    inside = within == tilt and level <= last
    state = _moved(_state(table, x, within, values, inside), approach, tilt)
    if state.load > 0.0:
        return state
    return State(approach, tilt, 0.0, 0.0, 0.0, 0.0, 0.0, inside)


@compiled
def loaded(tables: Tables, load: float, tilt: float) -> State:
    """Return the state of a contact under a load [N] and at a tilt [rad].

    Under no load it is that of first touch, without stiffness. Outside the range of the map the approach is continued
    linearly from its border, and ``inside`` is False.

    Parameters
    ----------
    tables : Tables
        ``ContactMap.tables``.
    load, tilt : float
        Q [N], not negative, and gamma [rad], finite.

    Returns
    -------
    State
    """
    table = tables.mean_approach
    most = table[MOST_LOAD]
    within = min(max(tilt, table[TILT_LOW]), table[TILT_HIGH])
    inside = within == tilt and 0.0 <= load <= most
    if not load > 0.0:
        first, arm = _first(table, within)
        return State(first - arm * (tilt - within), tilt, 0.0, 0.0, 0.0, 0.0, 0.0, inside)
    x = min((load / most) ** (1.0 / 3.0), 1.0)
    state = _state(table, x, within, _at(table, x, within), inside)
    if inside:
        return state
    turn = tilt - within
    by = (load - state.load - state.load_by_tilt * turn) / state.load_by_approach
    return _moved(state, state.approach + by, tilt)
