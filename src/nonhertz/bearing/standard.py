"""What ISO/TS 16281 makes of a bearing: independent slices under every roller.

A roller between two raceways is cut into slices, whose loads are those of `nonhertz.life.lamina`. Of two equal contacts
in series each has half of the deflection, and half of the relief of both: where rings are of different materials, half
of the deflection of both, which is as the power 0.9 of their compliances. Rollers are solid ones
(docs/explain/standards.md says what of it was compared with what).
"""

from __future__ import annotations

import numpy as np

from nonhertz.bearing.bearings import RollerBearing
from nonhertz.bearing.laws import Slices
from nonhertz.life.lamina import STIFFENING, lamina_stiffness, slice_compliance

LAMINAE = 41


def standard_slices(bearing: RollerBearing, laminae: int = LAMINAE) -> Slices:
    """Return the slices of one contact of a bearing's rollers, the same at both rings."""
    inner, outer = bearing.contacts
    low, high = bearing.effective_interval
    y = low + (high - low) * (np.arange(laminae) + 0.5) / laminae
    relief = 0.5 * (inner.separation(y) + outer.separation(y))
    approach = 0.5 * sum(slice_compliance(contact) ** (1.0 / STIFFENING) for contact in bearing.contacts)
    return Slices(y, relief, lamina_stiffness(high - low, laminae, approach**STIFFENING), STIFFENING)
