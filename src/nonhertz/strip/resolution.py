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

from nonhertz.compiled import compiled, plain_array
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
    """Return the `departure` of the separation `within` each of many strips [mm], shape (...)."""
    found: Array = _departures(plain_array(separation).reshape(-1, WITHIN)).reshape(separation.shape[:-1])
    return found


@compiled
def _departures(separation: Array) -> Array:
    found = np.empty(separation.shape[0])
    for i in range(found.size):
        found[i] = departure(separation[i])
    return found


@compiled
def departure(separation: Array) -> float:
    """Return the root mean square departure of the separation within a strip from a parabola [mm].

    Zero where the separation is infinite in part of the strip, where it is undefined.
    """
    total = 0.0
    for h in separation:
        if not math.isfinite(h):
            return 0.0
    one = two = three = 0.0
    for k in range(WITHIN):
        h = separation[k]
        one, two, three = one + h * _PARABOLA[k, 0], two + h * _PARABOLA[k, 1], three + h * _PARABOLA[k, 2]
    for k in range(WITHIN):
        of_parabola = one * _PARABOLA[k, 0] + two * _PARABOLA[k, 1] + three * _PARABOLA[k, 2]
        total += (separation[k] - of_parabola) ** 2
    return math.sqrt(total / WITHIN)
