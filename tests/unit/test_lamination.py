"""The finer strips that the field right below a contact is taken from."""

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.subsurface.lamination import CHANGE, MOST, NARROW, laminated

RING = nh.Ring(diameter=80)


def roller(profile=None, **changes):
    return nh.Roller(diameter=20, length=20, profile=profile or nh.profile.straight(), **changes)


def solved(profile=None, strips=41, load=10e3, **given):
    return nh.solve(nh.Contact(roller(profile), RING), load=load, strips=strips, **given)


CASES = {
    "runs out": lambda: solved(nh.profile.crown(radius=2000), load=4e3, tilt=1e-4),
    "sharp ends": solved,
    "automatic": lambda: solved(nh.profile.iso_logarithmic(diameter=20, length=20), strips="auto", tilt=5e-4),
    "two pieces": lambda: solved(nh.profile.crown(radius=-40000), load=200.0),
    "parabolic": lambda: solved(nh.profile.crown(radius=2000), load=4e3, element=nh.PARABOLIC),
}


@pytest.fixture(scope="module", params=CASES)
def case(request):
    solution = CASES[request.param]()
    return solution, laminated(solution)


def pieces_of(cut):
    strips = cut.first.size - 1
    return tuple(each[strips:] for each in (cut.low, cut.high, cut.line_load, cut.half_width))


def test_pieces_bear_the_load_but_for_what_run_outs_hide(case):
    solution, cut = case
    low, high, load, _ = pieces_of(cut)
    assert load @ (high - low) == pytest.approx(solution.load, rel=3e-3)
    strips = cut.first.size - 1
    whole = cut.line_load[:strips] * (cut.high[:strips] - cut.low[:strips])
    of_pieces = np.add.reduceat(load * (high - low), cut.first[:-1] - strips)
    np.testing.assert_allclose(whole, of_pieces, rtol=1e-12)
    assert cut.first[-1] == cut.low.size


def test_pieces_follow_each_other_without_a_gap_inside_a_contact(case):
    solution, cut = case
    low, high, _, _ = pieces_of(cut)
    gaps = np.flatnonzero(low[1:] != high[:-1])
    assert gaps.size == len(solution.contact_y) - 1
    assert np.all(high > low)


def test_pieces_keep_the_values_at_the_centres(case):
    solution, cut = case
    low, high, load, half_width = pieces_of(cut)
    touching = solution.line_load > 0.0
    for name, found in (("line_load", load), ("half_width", half_width)):
        wanted = getattr(solution, name)[touching]
        there = np.interp(solution.y[touching], 0.5 * (low + high), found)
        # Between pieces it is interpolated linearly here; at run-outs and sharp ends that is coarse.
        np.testing.assert_allclose(there[3:-3], wanted[3:-3], rtol=0.02, atol=0.01 * wanted.max())


def test_pieces_differ_little_or_are_narrow(case):
    _, cut = case
    strips = cut.first.size - 1
    count = np.diff(cut.first)
    for k in np.flatnonzero(count < MOST):
        part = slice(cut.first[k], cut.first[k + 1])
        pressure = cut.line_load[part] / cut.half_width[part]
        narrow = (cut.high[part] - cut.low[part]).max() <= NARROW * cut.half_width[k] * (1.0 + 1e-9)
        assert narrow or np.ptp(pressure) <= CHANGE * count[k] * 2.0 * pressure.max()
    assert strips == np.count_nonzero(case[0].line_load)


def test_an_even_pressure_is_left_alone():
    long = nh.Roller(diameter=20, length=10, images="series")
    cut = laminated(nh.solve(nh.Contact(long, long), load=10e3, strips=11))
    assert cut.low.size == 22


def test_a_single_strip_is_its_own_piece():
    cut = laminated(solved(strips=1))
    assert cut.low.tolist() == [-10.0, -10.0]
