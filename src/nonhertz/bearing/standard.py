"""What ISO/TS 16281 makes of a bearing: independent slices under every roller.

A roller between two raceways is cut into slices, whose loads are those of `nonhertz.life.lamina`. Of two equal contacts
in series each has half of the deflection, and half of the relief of both: where rings are of different materials, half
of the deflection of both, which is as the power 0.9 of their compliances. Rollers are solid ones
(docs/explain/standards.md says what of it was compared with what).
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
    """Return the slices of each row of a bearing that was solved by so many, and the loads of all [N].

    The latter, of shape (rollers, 2, laminae), are those of every contact; zero where it bears none.
    """
    rows = []
    for row in solution.bearing.rows:
        these, slices = row.rollers, standard_slices(row.bearing, laminae)
        loads = slices.loads(solution.approach[these].ravel(), solution.tilt[these].ravel()).reshape(-1, 2, laminae)
        rows.append((slices, np.where(solution.load[these, :, None] > 0.0, loads, 0.0)))
    return rows
