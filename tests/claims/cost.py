"""Section 8 of the paper: how time grows with the number of strips."""

from __future__ import annotations

import functools
import statistics
import timeit
from collections.abc import Callable, Iterator

import numpy as np

from claims.claim import Claim
from nonhertz import SEMI_ELLIPTIC, Contact, Ring, Roller, Solution, solve
from nonhertz.bodies.influence import influence_of
from nonhertz.model.profile import iso_logarithmic
from nonhertz.native import core
from nonhertz.strip.influence import kernel_of

COUNTS = (100, 200, 400)
REPEATS = 11


def claims() -> Iterator[Claim]:
    """Yield the claims: of times, which differ by tens of per cent, so that they are shown and not judged."""
    profile = iso_logarithmic(diameter=15.0, length=16.0)
    contact = Contact(
        Roller(diameter=15.0, length=16.0, profile=profile, side_faces="mirror"),
        Ring(diameter=60.0, length=24.0, side_faces="mirror", depth="plane-strain"),
    )

    def solved(count: int) -> Solution:
        return solve(contact, load=20000.0, tilt=0.5e-3, strips=count)

    def assembly() -> float:
        return _exponent([functools.partial(_assemble, contact, solved(count)) for count in COUNTS])

    def whole() -> float:
        return _exponent([functools.partial(solved, count) for count in COUNTS])

    quantity = "exponent of time over strips"
    yield Claim(f"setting up the coefficients: {quantity}", "paper, section 8", 2.0, assembly, None, absolute=True)
    yield Claim(f"whole solve: {quantity}", "between 2 and 3", 2.5, whole, None, absolute=True)


def _assemble(contact: Contact, solution: Solution) -> None:
    element, y, edges = SEMI_ELLIPTIC, solution.y, solution.edges
    kernel = kernel_of(influence_of(contact, element), element)
    curvature, nothing, flat = contact.curvature(y), np.zeros(y.size), np.zeros((0, 0))
    grid = core.Grid(edges, curvature, contact.separation(y), nothing, nothing, flat, flat)
    square = np.maximum(solution.element_half_width, 1e-3) ** 2
    core.coefficients(grid, square, np.flatnonzero(solution.line_load > 0.0), kernel)


def _exponent(runs: list[Callable[[], object]]) -> float:
    """Return the exponent of the median time of runs, without the first, over the number of their strips."""
    times = [statistics.median(timeit.repeat(run, number=1, repeat=1 + REPEATS)[1:]) for run in runs]
    return float(np.polyfit(np.log(COUNTS), np.log(times), 1)[0])
