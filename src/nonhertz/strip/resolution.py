"""What happens between the strip centres, where a solution does not look.

Contact conditions are enforced only at strip centres. A profile that is rough within a strip, or an overlap off the
centre of a wide strip out of contact, shows in none of them, nor in a comparison with coarser grids, which sample even
fewer places. So the bodies are sampled again: at several places within each strip in contact, for how far the
separation departs from a parabola; and along the whole bodies, including every crest of the profiles, for overlaps
where no strip is in contact.
"""

from __future__ import annotations

import math

import numpy as np

from nonhertz.strip.problem import Problem
from nonhertz.strip.records import Array

WITHIN = 9  # places in a strip
# K q / a that flattens a departure, over departure / width: a wave of amplitude A, sqrt(2) times its root mean square,
# takes a pressure of A / (K l), and q / a is pi / 2 times the pressure.
RIPPLE = 0.5 * math.pi * math.sqrt(2.0)
PLACES = (np.arange(WITHIN) + 0.5) / WITHIN - 0.5
_PARABOLA = np.linalg.qr(np.vander(PLACES, 3))[0]


def within(problem: Problem, edges: Array) -> tuple[Array, Array]:
    """Return places within each strip and the separation there, shape (..., strips, places) each."""
    y = 0.5 * (edges[..., 1:] + edges[..., :-1])[..., None] + np.diff(edges)[..., None] * PLACES
    return y, problem.model.separation(y.ravel()).reshape(y.shape)


def departures(separation: Array) -> Array:
    """Return the root mean square departure of the separation `within` each strip from a parabola [mm].

    Zero where the separation is infinite in part of a strip, where it is undefined.
    """
    finite = np.all(np.isfinite(separation), axis=-1)
    h = np.where(finite[..., None], separation, 0.0)
    left = h - (h @ _PARABOLA) @ _PARABOLA.T
    departure: Array = np.sqrt(np.mean(left**2, axis=-1))
    return departure


def roughness(departure: Array, width: Array, load: Array) -> tuple[Array, Array]:
    """Return the roughness that strips do not resolve, for one case or many.

    Parameters
    ----------
    departure, width : ndarray, shape (..., strips)
        See `departures`; widths [mm], zero in padding.
    load : ndarray, shape (..., strips)
        Load of each strip, in any unit.

    Returns
    -------
    tuple of ndarray, shape (...), and ndarray, shape (..., strips)
        Mean over the contact [mm], each strip weighted by its load; and the pressure ripple needed to flatten each
        strip, as K q / a. A wave of amplitude A and length l takes pi E* A / l = A / (K l), and within a strip l is at
        most the strip's width.
    """
    mean = np.sum(load * departure, axis=-1) / np.sum(load, axis=-1)
    steepness = np.divide(departure, width, out=np.zeros_like(departure), where=width > 0.0)
    return mean, RIPPLE * steepness
