"""Smooth part of solid cylindrical rollers, from a table over their length and Poisson's ratio.

With full weight of all polynomials it is a smooth function of both: a Chebyshev series in Poisson's ratio and, on seven
intervals, in the logarithm of the length over the diameter, within 1e-6 of its largest number. The table was made with
shorter elements than a single shape uses, whose error is up to 1e-4. ``python -m nonhertz.bodies.solid_rollers`` makes
it.
"""

from __future__ import annotations

import math
from functools import cache
from importlib import resources
from pathlib import Path
from typing import Any

import numpy as np
from numpy.polynomial import chebyshev
from numpy.typing import NDArray

from nonhertz.bodies.smooth_part import response_matrix as worked_out
from nonhertz.bodies.smooth_part import terms_along
from nonhertz.model.outline import Outline

Array = NDArray[np.float64]

NAME = "solid_rollers.npz"
# Borders of intervals of the length over the diameter, which is half the length over the radius.
BORDERS = (0.1, 0.2, 0.4, 0.8, 1.6, 3.2, 6.4, 10.0)
LEAST_POISSON, MOST_POISSON = 0.0, 0.48
_LENGTHS, _POISSONS = 12, 12  # Chebyshev points of each
_PER_TERM, _LONGEST = 1.5, 0.4  # the longest element: half-lengths over the number of polynomials, and radii
_LEAST = 3e-8  # of the largest coefficient: smaller ones are left out, as are orders with a sum of 12 or more


def response_matrix(half_length: float, poisson: float, count: int) -> Array | None:
    """Return the matrix of a solid cylinder for `count` polynomials; None outside the table.

    Parameters
    ----------
    half_length : float
        Half the length [radii].
    poisson : float
        Poisson's ratio.
    count : int
        Number of polynomials, no more than `nonhertz.bodies.smooth_part.terms_along` returns.

    Returns
    -------
    ndarray, shape (count, count)
        As from `nonhertz.bodies.smooth_part.response_matrix`.
    """
    if not (BORDERS[0] <= half_length <= BORDERS[-1] and LEAST_POISSON <= poisson <= MOST_POISSON):
        return None
    k = min(max(int(np.searchsorted(BORDERS, half_length)) - 1, 0), len(BORDERS) - 2)
    orders, series = _table()[k]
    low, high = math.log(BORDERS[k]), math.log(BORDERS[k + 1])
    along = chebyshev.chebvander((2.0 * math.log(half_length) - low - high) / (high - low), _LENGTHS - 1)[0]
    across = chebyshev.chebvander(
        2.0 * (poisson - LEAST_POISSON) / (MOST_POISSON - LEAST_POISSON) - 1.0, _POISSONS - 1
    )[0]
    values = (along[orders[0]] * across[orders[1]]) @ series
    size = _count(k)
    matrix = np.zeros((size, size))
    rows, columns = _places(size)
    matrix[rows, columns] = matrix[columns, rows] = values
    return matrix[:count, :count]


def _count(k: int) -> int:
    """Return the number of polynomials for the longest roller of an interval."""
    return math.ceil(terms_along(Outline.cylinder(BORDERS[k + 1])))


def _places(size: int) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Return the indices of the independent numbers of a symmetric matrix that does not couple even and odd."""
    rows, columns = np.tril_indices(size)
    alike = (rows + columns) % 2 == 0
    return rows[alike], columns[alike]


@cache
def _table() -> list[tuple[NDArray[np.intp], Array]]:
    """Return for each interval the orders of the terms of the series, shape (2, terms), and their coefficients."""
    with (resources.files("nonhertz.bodies") / NAME).open("rb") as file, np.load(file) as arrays:
        return [
            (arrays[f"orders{k}"].astype(np.intp), arrays[f"series{k}"].astype(float)) for k in range(len(BORDERS) - 1)
        ]


def make(path: Path) -> None:
    """Compute the table and write it, which takes about ten minutes."""
    x, t = (np.cos(math.pi * (np.arange(count) + 0.5) / count) for count in (_LENGTHS, _POISSONS))
    to_series = [np.linalg.inv(chebyshev.chebvander(points, points.size - 1)) for points in (x, t)]
    poissons = LEAST_POISSON + 0.5 * (MOST_POISSON - LEAST_POISSON) * (1.0 + t)
    arrays: dict[str, Any] = {}
    for k in range(len(BORDERS) - 1):
        count = _count(k)
        rows, columns = _places(count)
        lengths = np.sqrt(BORDERS[k] * BORDERS[k + 1]) * (BORDERS[k + 1] / BORDERS[k]) ** (0.5 * x)
        values = np.array(
            [
                [
                    worked_out(Outline.cylinder(h), nu, count, min(_PER_TERM * h / count, _LONGEST))[rows, columns]
                    for nu in poissons.tolist()
                ]
                for h in lengths.tolist()
            ]
        )
        series = np.einsum("ia,jb,abm->ijm", *to_series, values)
        matters = np.max(np.abs(series), axis=2) > _LEAST * np.max(np.abs(series))
        matters &= np.add.outer(np.arange(_LENGTHS), np.arange(_POISSONS)) < _LENGTHS
        arrays[f"orders{k}"] = np.array(np.nonzero(matters)).astype(np.uint8)
        arrays[f"series{k}"] = series[matters].astype(np.float32)
        print(f"{BORDERS[k]:g} to {BORDERS[k + 1]:g}: {int(matters.sum())} terms of {count} polynomials")
    np.savez_compressed(path, **arrays)


if __name__ == "__main__":
    make(Path(__file__).with_name(NAME))
