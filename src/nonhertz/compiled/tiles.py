"""Numbers that are worked on eight at a time, in registers: tuples, of which the compiler makes vector instructions."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nonhertz.compiled import compiled

Array = NDArray[np.float64]
Eight = tuple[float, float, float, float, float, float, float, float]

#: Places whose polynomials are evaluated at a time: enough for no instruction to wait for the one before it.
TILE = 16
ZERO: Eight = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


@compiled
def eight(values: Array, at: int) -> Eight:
    """Return eight neighbouring numbers of an array."""
    i = np.uint64(at)
    return (
        values[i], values[i + np.uint64(1)], values[i + np.uint64(2)], values[i + np.uint64(3)],
        values[i + np.uint64(4)], values[i + np.uint64(5)], values[i + np.uint64(6)], values[i + np.uint64(7)],
    )  # fmt: skip


@compiled
def put(values: Array, at: int, s: Eight) -> None:
    """Write them into an array."""
    for k in range(8):
        values[np.uint64(at) + np.uint64(k)] = s[k]


@compiled
def horner(s: Eight, x: Eight, c: float) -> Eight:
    """Return s x + c."""
    return (
        s[0] * x[0] + c, s[1] * x[1] + c, s[2] * x[2] + c, s[3] * x[3] + c,
        s[4] * x[4] + c, s[5] * x[5] + c, s[6] * x[6] + c, s[7] * x[7] + c,
    )  # fmt: skip


@compiled
def product(s: Eight, w: Eight) -> Eight:
    """Return s w."""
    return (
        s[0] * w[0], s[1] * w[1], s[2] * w[2], s[3] * w[3], s[4] * w[4], s[5] * w[5], s[6] * w[6], s[7] * w[7]
    )  # fmt: skip


@compiled
def polynomial(x: Array, coefficients: Array, out: Array) -> None:
    """Fill in a polynomial, highest power first, at places of which there are so many as whole tiles have."""
    for first in range(0, x.size, TILE):
        one, other, of_one, of_other = eight(x, first), eight(x, first + 8), ZERO, ZERO
        for c in coefficients:
            of_one, of_other = horner(of_one, one, c), horner(of_other, other, c)
        put(out, first, of_one)
        put(out, first + 8, of_other)
