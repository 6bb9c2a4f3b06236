"""What the page makes of a long measured file before its steps."""

from __future__ import annotations

import numpy as np

from nonhertz.measured import Trace
from nonhertz.web.limits import UPLOAD_POINTS
from nonhertz.web.view.uploads import _averaged


def test_no_mean_is_taken_over_a_gap():
    """An odd number of points lies before it, so that two neighbours would be one on either side."""
    y = np.linspace(0.0, 10.0, 2 * UPLOAD_POINTS)
    before = y[y < 3.0]
    before = before[: len(before) // 2 * 2 - 1]
    behind = y[y > 6.0]
    y = np.concatenate([before, behind])
    found = _averaged(Trace(y, np.zeros(len(y)), ((before[-1], behind[0]),)))
    assert len(y) // 2 <= len(found) <= len(y) // 2 + 2
    assert not np.any((found.y > before[-1]) & (found.y < behind[0]))
