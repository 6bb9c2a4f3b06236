"""What ISO/TS 16281 makes of a bearing: independent slices under every roller.

A roller of the length L between two raceways is cut into n slices, each of which bears 35948 L^(8/9) / n delta^(10/9)
under the deflection delta of both contacts together [N, mm]. Of two equal contacts in series each has half of it, and
half of the relief of both. The standard is quoted from public programs that agree with each other.
"""

from __future__ import annotations

import numpy as np

from nonhertz.bearing.bearings import RollerBearing
from nonhertz.bearing.laws import Slices

STIFFNESS, EXPONENT = 35948.0, 10.0 / 9.0
LAMINAE = 41


def standard_slices(bearing: RollerBearing, laminae: int = LAMINAE) -> Slices:
    """Return the slices of one contact of a bearing's rollers, the same at both rings."""
    inner, outer = bearing.contacts
    low, high = max(inner.interval[0], outer.interval[0]), min(inner.interval[1], outer.interval[1])
    y = low + (high - low) * (np.arange(laminae) + 0.5) / laminae
    relief = 0.5 * (inner.separation(y) + outer.separation(y))
    stiffness = STIFFNESS * (high - low) ** (8.0 / 9.0) / laminae * 2.0**EXPONENT
    return Slices(y, relief, stiffness, EXPONENT)
