"""Penetration: the overlap of the undeformed bodies, the approach beyond first touch at the tilt of the solution.

Where the separation does not start at zero, as of a wheel above a rail, or the bodies are tilted about a place away
from the contact, most of the approach is made before they touch, or it is negative. What deforms them is the rest, and
an error of the approach is told relative to that.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

# Of the penetration: it is not shown in addition to an approach that differs by less.
NOTICEABLE = 0.05


def deepest(separation: Callable[[Array], Array], y: Array, rigid: Array) -> Array:
    """Return the largest interference of the undeformed bodies [mm], for one case or many.

    Exact where it is at one of the places; elsewhere a parabola through three of them gives the place, and the
    separation there the depth, so that an error of the place counts by its square only.

    Parameters
    ----------
    separation : callable
        Of the bodies on the centre line [mm], for an array of places [mm].
    y : ndarray, shape (n,)
        Places [mm], ascending: corners of the profiles and the ends of the bodies among them.
    rigid : ndarray, shape (..., 2)
        Approach and tilt [mm, rad].

    Returns
    -------
    ndarray, shape (...)
    """
    approach, tilt = rigid[..., 0], rigid[..., 1]
    depth = approach[..., None] + tilt[..., None] * y - separation(y)
    largest: Array = depth.max(axis=-1)
    if y.size < 3:
        return largest
    middle = np.clip(depth.argmax(axis=-1), 1, y.size - 2)
    before, here, after = (np.take_along_axis(depth, middle[..., None] + step, -1)[..., 0] for step in (-1, 0, 1))
    to_left, to_right = y[middle] - y[middle - 1], y[middle + 1] - y[middle]
    with np.errstate(divide="ignore", invalid="ignore"):  # infinite relief, or a straight line
        falling, rising = (here - before) / to_left, (after - here) / to_right
        vertex = y[middle] + (falling * to_right + rising * to_left) / (2.0 * (falling - rising))
    place = np.clip(np.where(np.isfinite(vertex), vertex, y[middle]), y[middle - 1], y[middle + 1])
    at_vertex: Array = approach + tilt * place - separation(place.ravel()).reshape(place.shape)
    deeper: Array = np.maximum(largest, at_vertex)
    return deeper


def is_noticeable(approach: float, penetration: float) -> bool:
    """Return whether the penetration should be shown beside the approach."""
    return abs(approach - penetration) > NOTICEABLE * abs(penetration)
