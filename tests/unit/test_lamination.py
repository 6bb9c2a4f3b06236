"""The finer strips that the field right below a contact is taken from."""

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.subsurface import lamination
from nonhertz.subsurface.lamination import laminate

# Few strips, of which a large estimate is said.
pytestmark = pytest.mark.filterwarnings("ignore:The .* is uncertain:nonhertz.AccuracyWarning")

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
    "a strip between": lambda: solved(nh.profile.crown(radius=-40000), load=240.0, strips=9),
    "parabolic": lambda: solved(nh.profile.crown(radius=2000), load=4e3, element=nh.PARABOLIC),
}


@pytest.fixture(scope="module", params=CASES)
def case(request):
    solution = CASES[request.param]()
    return solution, laminate(solution)


def pieces_of(cut):
    strips = cut.first.size - 1
    return tuple(each[strips:] for each in (cut.low, cut.high, cut.line_load, cut.half_width))


def test_pieces_bear_load_and_moment(case):
    solution, cut = case
    low, high, load, half_width = pieces_of(cut)
    assert load @ (high - low) == pytest.approx(solution.load, rel=1e-9)
    moment = float(load @ ((high - low) * 0.5 * (low + high)))
    assert moment == pytest.approx(solution.moment, abs=1e-3 * solution.load * 10.0)
    assert np.all(load >= 0.0)
    assert np.all(half_width > 0.0)
    strips = cut.first.size - 1
    whole = cut.line_load[:strips] * (cut.high[:strips] - cut.low[:strips])
    of_pieces = np.add.reduceat(load * (high - low), cut.first[:-1] - strips)
    np.testing.assert_allclose(whole, of_pieces, rtol=1e-12)
    assert cut.first[-1] == cut.low.size
    # They follow each other without a gap inside a contact.
    assert np.count_nonzero(low[1:] != high[:-1]) == len(solution.contact_y) - 1
    assert np.all(high > low)


@pytest.mark.filterwarnings("ignore::nonhertz.errors.AccuracyWarning")  # few strips are what this is about
@pytest.mark.parametrize("strips", [1, 2, 3, 5, 10, 20, "uneven"])
@pytest.mark.parametrize("moment", [0.0, 1.5e3])
def test_few_and_uneven_strips_bear_their_load_too(strips, moment):
    edges = np.concatenate([[-10.0], np.linspace(-1.0, 1.0, 22), [10.0]]) if strips == "uneven" else strips
    contact = nh.Contact(roller(nh.profile.crown(radius=4000)), RING)
    given = {} if strips == 1 else {"moment": moment}
    solution = nh.solve(contact, load=2e3, strips=edges, **given)
    cut = laminate(solution)
    low, high, load, _ = pieces_of(cut)
    assert load @ (high - low) == pytest.approx(2e3, rel=1e-9)
    touching = solution.line_load > 0.0
    assert load @ ((high - low) * 0.5 * (low + high)) == pytest.approx(solution.moment, abs=1e-3 * 2e3 * 10.0)
    # Strip by strip but for what run-outs may add, not only in all.
    of_strips = cut.line_load[: cut.first.size - 1] * (cut.high - cut.low)[: cut.first.size - 1]
    np.testing.assert_allclose(of_strips, (solution.line_load * solution.strip_width)[touching], atol=5e-4 * 2e3)
    # Two are equal in an even contact; else the pieces are not just the strips, which bear their load anyway.
    assert cut.low.size > 2 * np.count_nonzero(touching) or strips in {1, 2}


def test_pieces_that_bear_another_load_are_not_used(monkeypatch):
    solution = solved(nh.profile.crown(radius=2000), load=4e3)
    strips = lamination.LoadedStrips.of(solution)
    right = laminate(solution)
    assert lamination.carries_load(right, strips)
    one, negative = np.ones((2, right.low.size))
    one[one.size // 2], negative[-1] = 1.1, -1.0
    turned = 1.0 + 0.005 * (right.low + right.high)
    loads = [right._replace(line_load=right.line_load * factor) for factor in (one, negative, turned)]
    for wrong in (*loads, right._replace(half_width=np.inf * right.half_width)):
        assert not lamination.carries_load(wrong, strips)
        monkeypatch.setattr(lamination, "cut_into_pieces", lambda _, wrong=wrong: wrong)
        low, high, load, _ = pieces_of(laminate(solution))
        assert load @ (high - low) == pytest.approx(4e3, rel=1e-12)


@pytest.mark.parametrize("load", [20e3, 200.0])
def test_at_a_corner_the_last_strip_bears_its_pressure(load):
    solution = solved(nh.profile.chamfer(20, 1.0), strips="auto", load=load)
    touching = solution.line_load > 0.0
    field = nh.subsurface.stress(solution, 0.0, solution.y[touching], 0.0)
    np.testing.assert_allclose(-field.sigma_z, solution.centre_pressure[touching], rtol=2e-4)


def test_pieces_keep_the_values_at_the_centres(case):
    solution, cut = case
    low, high, load, half_width = pieces_of(cut)
    touching = solution.line_load > 0.0
    for name, found in (("line_load", load), ("half_width", half_width)):
        wanted = getattr(solution, name)[touching]
        there = np.interp(solution.y[touching], 0.5 * (low + high), found)
        # Between pieces it is interpolated linearly here; at run-outs and sharp ends that is coarse.
        np.testing.assert_allclose(there[3:-3], wanted[3:-3], rtol=0.02, atol=0.01 * wanted.max())


def test_a_strip_falls_to_where_its_contact_runs_out():
    solution = solved(nh.profile.crown(radius=2000), load=4e3, tilt=1e-4)
    strips = lamination.LoadedStrips.of(solution)
    for at, end in ((0, solution.contact_y[0][0]), (-1, solution.contact_y[-1][1])):
        middle, half = 0.5 * (strips.low[at] + strips.high[at]), 0.5 * (strips.high[at] - strips.low[at])
        assert middle + half * strips.run_out[at] == pytest.approx(end, rel=1e-12)
    assert np.all(np.isinf(strips.run_out[1:-1]))


@pytest.mark.parametrize("load", [500.0, 4e3])
def test_the_pieces_of_a_mirrored_contact_are_mirrored(load):
    # Few strips: pressures that fall so steeply that the line through a strip would fall below nothing.
    cuts = [laminate(solved(nh.profile.crown(radius=1000), strips=9, load=load, tilt=tilt)) for tilt in (4e-4, -4e-4)]
    (low, high, borne, half_width), mirrored = map(pieces_of, cuts)
    np.testing.assert_allclose(low, -mirrored[1][::-1], rtol=1e-9, atol=1e-9)
    np.testing.assert_allclose(borne, mirrored[2][::-1], rtol=1e-7, atol=1e-9)
    np.testing.assert_allclose(half_width, mirrored[3][::-1], rtol=1e-7, atol=1e-9)
    assert np.all(high > low)
