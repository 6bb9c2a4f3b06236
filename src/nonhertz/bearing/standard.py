"""Contacts of a bearing by ISO/TS 16281: independent slices of every roller.

A roller between two raceways is cut into slices with the loads of `nonhertz.life.lamina`. Each of two equal contacts in
series has half of the deflection, and half of the combined relief; with rings of different materials, half of their
total deflection, which grows with the power 0.9 of their compliances. Rollers are solid. docs/explain/standards.md
lists the comparisons made.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from nonhertz.bearing.bearings import RollerBearing
from nonhertz.bearing.laws import Slices
from nonhertz.life.lamina import STIFFENING, lamina_stiffness, slice_compliance

if TYPE_CHECKING:
    from nonhertz.bearing.solution import BearingSolution

Array = NDArray[np.float64]
LAMINAE = 41


def standard_slices(bearing: RollerBearing, laminae: int = LAMINAE) -> Slices:
    """Return the slices of one contact of a bearing's rollers, the same at both rings."""
    inner, outer = bearing.contacts
    low, high = bearing.effective_interval
    y = low + (high - low) * (np.arange(laminae) + 0.5) / laminae
    relief = 0.5 * (inner.separation(y) + outer.separation(y))
    approach = 0.5 * sum(slice_compliance(contact) ** (1.0 / STIFFENING) for contact in bearing.contacts)
    return Slices(y, relief, lamina_stiffness(high - low, laminae, approach**STIFFENING), STIFFENING)


def slice_loads(solution: BearingSolution, laminae: int = LAMINAE) -> list[tuple[Slices, Array]]:
    """Return the slices of each row of a bearing solved with this number of laminae, and their loads [N].

    Loads have the shape (rollers, 2, laminae); zero for unloaded contacts.
    """
    rows = []
    for row in solution.bearing.rows:
        these, slices = row.rollers, standard_slices(row.bearing, laminae)
        loads = slices.loads(solution.approach[these].ravel(), solution.tilt[these].ravel()).reshape(-1, 2, laminae)
        rows.append((slices, np.where(solution.load[these, :, None] > 0.0, loads, 0.0)))
    return rows
