"""Contacts on given strips, solved one after the other by the core: one case is a batch of one.

Where the Newton loop fails from one start, the next is tried: the case before, if it is similar and on the same strips;
the solution on another grid; springs; then, if ``patient``, springs with r and m stepped together, springs with
shortened steps, and finally the load raised in steps from a small one.
"""

from __future__ import annotations

from nonhertz.native import core
from nonhertz.strip.records import Array, Flags, Grids, States

# Of a solution, and of one that only serves as the start on the next grid: largest relative residuals.
TOLERANCE, ROUGH_TOLERANCE = core.TOLERANCE, core.ROUGH_TOLERANCE
# Depth in half-widths of independent springs, which may be half of the true one where bodies are thin, below which a
# failure is blamed on the thin body.
SCARCELY = 4.0
# On more strips, a step costs the cube of the strips, and on 2,000 some seconds: not all starts are tried.
PATIENT_STRIPS = core.PATIENT_STRIPS


def solve_on_strips(
    grids: Grids,
    prescribed: Flags,
    targets: Array,
    kernel: core.Kernel,
    near: States,
    found: States,
    tolerance: float,
    patient: bool,
) -> None:
    """Solve every case on its strips, overwriting ``found``.

    Parameters
    ----------
    grids : Grids
        The strips of every case, or one grid for all.
    prescribed : ndarray of bool, shape (2,)
        Whether the load (else the approach) and the moment (else the tilt) are given.
    targets : ndarray, shape (cases, 2)
        K Q or delta, K T or gamma.
    kernel : Kernel
        How strips act.
    near : States
        Solutions on other strips, where they have converged; no rows if there are none.
    found : States
        Result, a row per case.
    tolerance : float
        Largest relative residual of a solution.
    patient : bool
        Whether to try hard.
    """
    core.solve_on_strips(grids, flags(prescribed), targets, kernel, near, found, tolerance, patient)


def flags(prescribed: Flags) -> tuple[bool, bool]:
    """Return which of load and moment are given, for the core."""
    first, second = prescribed.tolist()
    return first, second
