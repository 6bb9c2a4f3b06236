"""Layout of the numbers of a map, and the C functions that evaluate it for other programs.

The method is explained in ``src/core/maps/contact_map.hpp``, where maps are evaluated.
"""

from __future__ import annotations

import ctypes
from typing import NamedTuple

from nonhertz.native import core

ORDER = 6  # coefficients of a polynomial of degree 5
MOST_LOAD, TILT_LOW, TILT_HIGH, CENTRE, NARROW, WIDENING, RISE, LOW_END, HIGH_END, LOAD_CELLS, TILT_CELLS = range(11)
QUANTILES = 25


class State(NamedTuple):
    """The eight numbers of a state, in the order in which `AT_APPROACH` and `AT_LOAD` write them.

    Attributes
    ----------
    approach, tilt, load, moment : float
        delta [mm], gamma [rad], Q [N], T [N mm].
    load_by_approach, load_by_tilt, moment_by_tilt : float
        Stiffness [N/mm, N/rad, N mm/rad]; moment_by_approach is load_by_tilt.
    inside : float
        1 if the point is in the range of the map, else 0. Outside, load and moment are continued linearly.
    """

    approach: float
    tilt: float
    load: float
    moment: float
    load_by_approach: float
    load_by_tilt: float
    moment_by_tilt: float
    inside: float


_POINTER, _NUMBER, _COUNT = ctypes.c_void_p, ctypes.c_double, ctypes.c_int64
_at_a_point = ctypes.CFUNCTYPE(None, _POINTER, _NUMBER, _NUMBER, _POINTER)
_along_strips = ctypes.CFUNCTYPE(None, _POINTER, _NUMBER, _NUMBER, _COUNT, _POINTER, _POINTER)
_at_approach, _at_load, _maxima, _strip_loads = core.map_functions()

#: ``void at_approach(const double *table, double approach, double tilt, double *state)`` writes the state of a contact
#: at an approach [mm] and a tilt [rad]: the eight numbers of `State`. ``table`` is `ContactMap.table`. Out of contact
#: load, moment and stiffness are zero. Outside the range of the map they are continued linearly from its border, and
#: ``inside`` is 0; a load continued below zero is zero, with no stiffness.
AT_APPROACH = _at_a_point(_at_approach)
#: ``void at_load(const double *table, double load, double tilt, double *state)`` writes the state under a load [N], not
#: negative, and at a tilt [rad]. Under no load it is the state of first touch, without stiffness. Outside the range of
#: the map the approach is continued linearly from its border, and ``inside`` is 0.
AT_LOAD = _at_a_point(_at_load)
#: ``void maxima(const double *table, double load, double tilt, double *maxima)`` writes two numbers: maximum pressure
#: [MPa] and largest half-width [mm] under a load and a tilt, as `AT_APPROACH` writes them; zero under no load. Outside
#: the range of the map the nearest load and tilt within it are used.
MAXIMA = _at_a_point(_maxima)
#: ``void strip_loads(const double *table, double load, double tilt, int64_t n, const double *stations, double *loads)``
#: writes the load on each of n strips [N] between n + 1 ascending stations [mm], such as those of the map. Where
#: the strips cover the contact, their sum is the load; outside the range of the map it is as wide as at its border.
STRIP_LOADS = _along_strips(_strip_loads)
