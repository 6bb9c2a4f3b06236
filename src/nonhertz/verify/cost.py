"""Section 8 of the paper: how time grows with the number of strips."""

from __future__ import annotations

import functools
import statistics
import time
from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from nonhertz.bodies.influence import influence_of
from nonhertz.model.body import Ring, Roller
from nonhertz.model.contact import Contact
from nonhertz.model.profile import iso_logarithmic
from nonhertz.plot.style import FIRST, INK, SECOND
from nonhertz.result.solution import Solution
from nonhertz.solver.one import solve
from nonhertz.strip.element import SEMI_ELLIPTIC
from nonhertz.strip.influence import coefficients, law_of, remote_of
from nonhertz.strip.records import Strips
from nonhertz.verify.claim import Check, Picture, Section

if TYPE_CHECKING:
    from matplotlib.figure import Figure

COUNTS = (25, 50, 100, 200, 400)
REPEATS = 11
FITTED_FROM = 100
_TEXT = """\
The paper puts the cost of its method at the square of the number of strips for setting up the influence coefficients,
and its point is that some tens of strips are enough where a plane grid needs thousands of rectangles. Timed here on
the machine that made this page, medians of {repeats}: a logarithmic roller under tilt on a ring, mirrored faces and
depths on both bodies.

| strips | coefficients once (ms) | whole solve (ms) | Newton steps |
|---|---|---|---|
{rows}

**Found.** Setting up grows like n^{assembly:.1f}. The solve as a whole grows like n^{whole:.1f} from {fitted} strips
on: the linear equations, 2n of them, cost n^3 in the end, but few contacts want more than 90 strips. Times of
different runs and machines differ by tens of per cent, and the exponents with them, so these are shown and not judged.
The page on speed in docs/benchmarks measures half-spaces, on grids from coarse to fine, and has exponents of its own.
"""


def section() -> Section:
    """Return times for several numbers of strips."""
    contact = _contact()
    rows, assembly, whole = [], [], []
    for count in COUNTS:
        solution = _solve(contact, count)
        assembly.append(1e3 * _median(functools.partial(_assemble, contact, solution)))
        whole.append(1e3 * _median(functools.partial(_solve, contact, count)))
        rows.append(f"| {count} | {assembly[-1]:.2f} | {whole[-1]:.1f} | {solution.iterations} |")
    of_assembly, of_whole = _exponent(assembly), _exponent(whole)
    text = _TEXT.format(repeats=REPEATS, rows="\n".join(rows), assembly=of_assembly, whole=of_whole, fitted=FITTED_FROM)
    source = "paper, section 8"
    checks = (
        Check(
            "setting up the coefficients: exponent of time over strips", source, 2.0, of_assembly, None, absolute=True
        ),
        Check("whole solve: exponent of time over strips", "between 2 and 3", 2.5, of_whole, None, absolute=True),
    )
    picture = Picture(
        "cost",
        "Time against strips, and the slopes of the second and third power.",
        functools.partial(_draw, assembly, whole),
    )
    return Section("Cost (paper, section 8)", text, checks, (picture,))


def _contact() -> Contact:
    profile = iso_logarithmic(diameter=15.0, length=16.0)
    return Contact(
        Roller(diameter=15.0, length=16.0, profile=profile, side_faces="mirror"),
        Ring(diameter=60.0, length=24.0, side_faces="mirror", depth="plane-strain"),
    )


def _solve(contact: Contact, count: int) -> Solution:
    return solve(contact, load=20000.0, tilt=0.5e-3, strips=count)


def _assemble(contact: Contact, solution: Solution) -> None:
    element, y, edges = SEMI_ELLIPTIC, solution.y, solution.edges
    law = law_of(influence_of(contact, element), element)
    at_rest = np.zeros((0, 0))
    strips = Strips(y, edges[:-1], edges[1:], contact.curvature(y), contact.separation(y), at_rest)
    active = np.flatnonzero(solution.line_load > 0.0)
    square = np.maximum(solution.element_half_width, 1e-3) ** 2
    remote = remote_of(strips, law, float(square.max()))
    coefficients(strips, square, active, law, remote, np.empty((4, active.size, active.size)))


def _median(run: Callable[[], object]) -> float:
    run()
    times = []
    for _ in range(REPEATS):
        begin = time.perf_counter()
        run()
        times.append(time.perf_counter() - begin)
    return statistics.median(times)


def _exponent(times: list[float]) -> float:
    fitted = np.array(COUNTS) >= FITTED_FROM
    log_count, log_time = np.log(np.array(COUNTS)[fitted]), np.log(np.array(times)[fitted])
    return float(np.polyfit(log_count, log_time, 1)[0])


def _draw(assembly: list[float], whole: list[float], figure: Figure) -> None:
    axes = figure.add_subplot()
    axes.loglog(COUNTS, whole, "o-", color=FIRST, label="whole solve")
    axes.loglog(COUNTS, assembly, "s--", color=SECOND, label="coefficients once")
    reference = np.array([100.0, 400.0])
    for power, dashes in ((2, ":"), (3, "-.")):
        slope = 0.5 * assembly[2] * (reference / 100.0) ** power
        axes.loglog(reference, slope, linestyle=dashes, color=INK, label=f"power {power}")
    axes.set(xlabel="strips", ylabel="time (ms)")
    axes.set_xticks(COUNTS, [str(count) for count in COUNTS])
    axes.minorticks_off()
    axes.legend()
