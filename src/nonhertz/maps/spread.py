"""Distribution of a solution's load along the contact: the fraction of the load up to a position, and its inverse."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nonhertz.maps.evaluation import QUANTILES
from nonhertz.model.contact import Contact

Array = NDArray[np.float64]

ANGLES = np.linspace(0.0, np.pi, QUANTILES)
# Tolerances relative to the width of a strip [-], and at an end of the bodies [mm].
_SAME = 1e-9


def spread(contact: Contact, edges: Array, line_load: Array, stations: Array) -> tuple[Array, Array]:
    """Return positions up to which a contact carries sin^2(k pi / 48) of its load [mm], k = 0 ... 24, and loads [N].

    The fraction of the load up to a position is expressed by an angle as sin^2(angle / 2). Where a line load falls to
    zero linearly the angle is linear, so that the position is a smooth function of it. On strips of a graded grid
    linear interpolation between their edges is exact to a few hundredths of a per cent. The loads are those on strips
    between ``stations``.

    Parameters
    ----------
    contact : Contact
        The bodies.
    edges, line_load : ndarray, shape (strips + 1,) and (strips,)
        Edges of the strips [mm] and the line loads on them [N/mm].
    stations : ndarray, shape (stations + 1,)
        Edges of other strips [mm].
    """
    summed = np.concatenate([[0.0], np.cumsum(line_load * np.diff(edges))])
    loaded = np.flatnonzero(line_load > 0.0)
    strips = slice(int(loaded[0]), int(loaded[-1]) + 2)
    y, share = edges[strips].copy(), summed[strips] / summed[-1]
    angle = 2.0 * np.arcsin(np.sqrt(np.clip(share, 0.0, 1.0)))
    # A contact that runs out ends somewhere in its last strip.
    low, high = contact.interval
    if y.size > 3 and y[0] > low + _SAME:
        y[0] = min(max(y[0], y[1] - (y[2] - y[1]) / (angle[2] - angle[1]) * angle[1]), y[1] - _SAME * (y[1] - y[0]))
    if y.size > 3 and y[-1] < high - _SAME:
        rest = (np.pi - angle[-2]) / (angle[-2] - angle[-3])
        y[-1] = max(min(y[-1], y[-2] + (y[-2] - y[-3]) * rest), y[-2] + _SAME * (y[-1] - y[-2]))
    rising = np.concatenate([[True], np.diff(angle) > 0.0])
    y, angle = y[rising], angle[rising]
    loads: Array = float(summed[-1]) * np.diff(np.sin(0.5 * np.interp(stations, y, angle)) ** 2)
    return np.interp(ANGLES, angle, y), loads
