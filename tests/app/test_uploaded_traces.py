"""What the page makes of a long measured file before its steps."""

import json

import numpy as np
from numpy.testing import assert_allclose

import nonhertz as nh
from nonhertz.measured import Trace
from nonhertz.web.limits import UPLOAD_POINTS
from nonhertz.web.view.uploads import MOST_POINTS, _average, answer_to_file


def test_no_mean_is_taken_over_a_gap():
    """An odd number of points lies before it, so that two neighbours would be one on either side."""
    y = np.linspace(0.0, 10.0, 2 * UPLOAD_POINTS)
    before = y[y < 3.0]
    before = before[: len(before) // 2 * 2 - 1]
    behind = y[y > 6.0]
    y = np.concatenate([before, behind])
    found = _average(Trace(y, np.zeros(len(y)), ((before[-1], behind[0]),)))
    assert len(y) // 2 <= len(found) <= len(y) // 2 + 2
    assert not np.any((found.y > before[-1]) & (found.y < behind[0]))


def lowest_of(found, name):
    """Return the lower end of the heights that are drawn of a step [mm]."""
    (panel,) = (panel for panel in found["steps"]["panels"] if panel["name"] == name)
    return panel["upright"]["range"][0]


def test_steps_are_drawn_so_that_the_land_is_seen_beside_its_corners():
    """And the corners of a long roller leave the land its points."""
    roller = nh.Roller(diameter=15, length=80, profile=nh.profile.crown(radius=1e5), corner_radius=1.5)
    y = np.linspace(-39.9, 39.9, 8001)
    content = "\n".join(f"{a:.4f}\t{1e3 * b:.4f}" for a, b in zip(y, -roller.relief(y), strict=True)).encode()
    found = json.loads(answer_to_file(content, "roller.txt", {"height_unit": "um"}))
    # One and a half times the drop at the ends of the land, and 12 % of that beside. Trim finds them within 10 um,
    # level and align 33 um beyond, as their sentences say.
    for name, end in (("level", 38.533), ("align", 38.533), ("trim", 38.5), ("smooth", 38.5)):
        assert_allclose(lowest_of(found, name), -1.5 * 1.12 * roller.relief(end), rtol=0.01)
    assert len(found["table"]["y"]) <= MOST_POINTS
    assert np.sum(np.abs(found["table"]["y"]) < 38.4) > 0.4 * MOST_POINTS
    cut = json.loads(answer_to_file(content, "roller.txt", {"height_unit": "um", "corner": "cut"}))
    assert lowest_of(cut, "smooth") < -(38.5**2) / 2e5, "a land that was cut out is drawn whole"
