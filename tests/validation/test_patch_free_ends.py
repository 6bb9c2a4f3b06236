"""Rectangles against strips on bodies with free faces, beside what the claims of `nonhertz verify` say of them.

Strips read their own integrals of it along their length, of a pressure that is a semi-ellipse across; cells have a
matrix between rows, of a pressure that is anything across.
"""

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.verify import free_ends
from nonhertz.verify.claim import pressures

# Most end at a free face on a body that goes on, where the pressure has no limit.
pytestmark = [pytest.mark.slow, pytest.mark.filterwarnings("ignore::nonhertz.AccuracyWarning")]

STEEL = nh.Material(206000.0, 0.3)
SOFT = nh.Material(100000.0, 0.42)
SIZE = {"diameter": 20.0, "length": 20.0}
LOGARITHMIC = nh.profile.iso_logarithmic(**SIZE)
FREE = {"side_faces": "free", "depth": "none", "material": STEEL}
LONG = nh.Ring(diameter=80.0, material=STEEL)
AS_LONG = nh.Ring(diameter=80.0, length=20.0, **FREE)
TILT = 0.3e-3
CASES = {
    "straight, both end": (FREE, AS_LONG, {"load": 20e3}),
    "logarithmic, both end": (FREE | {"profile": LOGARITHMIC}, AS_LONG, {"load": 42e3, "tilt": TILT}),
    "unlike bodies and faces": (
        FREE | {"material": SOFT, "side_faces": ("free", "mirror")},
        nh.Ring(diameter=80.0, length=20.4, position=0.1, **FREE),
        {"load": 10e3, "tilt": TILT},
    ),
    "plane-strain depth": (FREE | {"depth": "plane-strain"}, LONG, {"load": 20e3, "tilt": TILT}),
}


def contact(name):
    return nh.Contact(nh.Roller(**SIZE, **CASES[name][0]), CASES[name][1])


@pytest.mark.parametrize("name", CASES)
def test_both_find_the_same(name):
    given = CASES[name][2]
    strips, patch = nh.solve(contact(name), **given), nh.patch.solve(contact(name), **given, cells=(64, 512))
    # Found: 1e-5, 3e-4 where tilted, and 3e-5.
    assert patch.approach == pytest.approx(strips.approach, rel=5e-5)
    assert patch.moment == pytest.approx(strips.moment, rel=1e-3, abs=1.0)
    middle = [float(np.interp(0.0, each.y, each.centre_pressure)) for each in (patch, strips)]
    assert middle[0] == pytest.approx(middle[1], rel=1e-4)
    assert patch.max_pressure == pytest.approx(strips.max_pressure, rel=2e-3)
    half_width = float(strips.half_width.max())
    for side in (-1.0, 1.0):
        places = side * (10.0 - half_width * np.array([0.5, 0.7, 1.0, 2.0, 5.0]))
        near = [np.interp(places, each.y, each.centre_pressure) for each in (patch, strips)]
        clear = np.min(np.abs(places[:, None] - np.array(strips.contact_y).ravel()), axis=1) > 0.25 * half_width
        np.testing.assert_allclose(near[0][clear], near[1][clear], rtol=5e-3)


def test_towards_an_end_it_is_the_solution_of_two_half_spaces_iterated():
    solution = free_ends.on_grid(free_ends.STRAIGHT)
    assert pressures(solution, [0.0])[0] == pytest.approx(free_ends.MIDDLE, rel=3e-4)
    places = 10.0 - free_ends.half_width(free_ends.STRAIGHT) * np.array(free_ends.PLACES)
    np.testing.assert_allclose(pressures(solution, places[1:]), free_ends.PRESSURES[1:], rtol=3e-3)


@pytest.mark.parametrize(("case", "singular"), [(free_ends.STRAIGHT, 2), (free_ends.TOGETHER, 0)])
def test_the_estimate_covers_the_change_to_a_finer_grid(case, singular):
    coarse, fine = (nh.patch.solve(case.contact, load=20e3, cells=cells) for cells in ((32, 128), (96, 384)))
    for quantity in ("approach", "max_pressure"):
        estimate = getattr(coarse.error_estimate, quantity)
        assert abs(getattr(coarse, quantity) / getattr(fine, quantity) - 1.0) < estimate < 0.03
    assert len(fine.singular_ends) == singular
