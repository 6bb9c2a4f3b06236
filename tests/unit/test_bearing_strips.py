"""Contacts of a bearing by strips: they follow from one step to the next, and both rings use the same strips."""

import dataclasses
import math
from pathlib import Path

import numpy as np
import pytest
from crowned_rows import nu206
from numpy.testing import assert_allclose, assert_array_equal

import nonhertz as nh
from nonhertz.bearing.strips import cut_into_strips, no_solution_error
from nonhertz.errors import without_accuracy_warnings
from nonhertz.native import core

EXAMPLES = Path(__file__).parents[2] / "examples"
NU206 = nu206(corner_radius=0.3, profile=nh.profile.crown(1200.0))
INNER, OUTER = NU206.contacts
POSES = [(0.0118, 1.46e-4), (0.004, 0.0), (0.009, -1.2e-3), (0.0006, 2e-4)]


def law_of(*contacts, strips=None):
    return core.StripLaw([cut_into_strips(each) for each in contacts], strips)


def asked(law, *pose, row=0, other=None):
    """Answers of one contact of a roller, or of both with another pose at the other ring."""
    poses = [pose] if other is None else [pose, other]
    return law.answer(np.array([row]), np.array([poses]))[0, :, :6].squeeze()


def laid_for(contact, approach):
    """Edges of the strips that are laid for an approach of a contact by itself."""
    law = law_of(contact)
    asked(law, approach, 0.0)
    return law.edges(0)


@pytest.fixture
def laws(monkeypatch):
    """Give the laws by which bearings are solved."""
    made, make = [], core.StripLaw

    def law(*given):
        made.append(make(*given))
        return made[-1]

    monkeypatch.setattr(core, "StripLaw", law)
    return made


def laid(laws):
    """Return how often strips have been laid."""
    return sum(len(law.laid_for) for law in laws)


def size_of(answer):
    """Sizes of load, moment and stiffness, for tolerances."""
    load, half = abs(answer[0]), 5.0
    stiffness = abs(answer[2])
    return np.array([load, load * half, stiffness, stiffness * half, stiffness * half, stiffness * half**2])


@pytest.mark.parametrize("pose", POSES)
def test_answers_are_those_of_a_contact_by_itself(pose):
    found = asked(law_of(INNER), *pose)
    alone = nh.solve(INNER, approach=pose[0], tilt=pose[1])
    assert_allclose(found[0], alone.load, rtol=2e-4)
    assert_allclose(found[1], alone.moment, atol=2e-4 * 5.0 * alone.load)


@pytest.mark.parametrize("pose", POSES)
@pytest.mark.parametrize("change", [(1e-3, 0.0), (-0.02, 0.01), (0.015, -0.004), (-0.1, 0.0)])
def test_a_contact_that_followed_is_the_one_solved_there_on_the_same_strips(pose, change):
    law = law_of(INNER, strips=41)
    asked(law, *pose)
    depth = float(cut_into_strips(INNER).penetration(np.array([pose]))[0])
    there = pose[0] + change[0] * depth, pose[1] + change[1] * depth / 5.0
    anew = asked(law_of(INNER, strips=41), *there)
    followed = asked(law, *there)
    assert (law.solved, law.followed) == (1, 1)
    # The load is exact to the square of the last step, the stiffness to the step.
    assert np.all(np.abs(followed - anew) <= np.array([1e-9, 1e-9, 1e-5, 1e-5, 1e-5, 1e-5]) * size_of(anew))


def test_stiffness_is_the_derivative_on_kept_strips():
    law = law_of(INNER, strips=41)
    middle = asked(law, 0.01, 3e-4)
    for k, step in enumerate([(1e-6, 0.0), (0.0, 1e-7)]):
        more = asked(law, 0.01 + step[0], 3e-4 + step[1])
        less = asked(law, 0.01 - step[0], 3e-4 - step[1])
        slope = (more - less)[:2] / (2.0 * max(step))
        assert_allclose(middle[[2 + k, 4 + k]], slope, rtol=1e-4)


def test_the_other_ring_takes_the_strips_and_loses_nothing():
    law, pose = law_of(INNER, OUTER), (0.0118, 1.46e-4)
    first, second = asked(law, *pose, other=pose)
    assert_array_equal(law.edges(0, 0), law.edges(0, 1))
    assert (law.solved, law.followed, len(law.laid_for)) == (0, 1, 1)
    for contact, found in ((INNER, first), (OUTER, second)):
        alone = nh.solve(contact, approach=pose[0], tilt=pose[1])
        assert_allclose(found[0], alone.load, rtol=2e-4)
        assert_allclose(found[1], alone.moment, atol=2e-4 * 5.0 * alone.load)


def test_the_ring_that_is_pressed_deeper_lays_the_strips():
    law = law_of(INNER, OUTER)
    asked(law, 0.0115, 0.0, other=(0.012, 0.0))
    deeper = laid_for(OUTER, 0.012)
    assert_array_equal(law.edges(0, 1), deeper)
    assert_array_equal(law.edges(0, 0), deeper)
    asked(law, 0.0115, 0.0, other=(0.02, 0.0))
    assert_array_equal(law.edges(0, 1), deeper)  # it is on its way


def test_rings_whose_separations_differ_lay_their_own():
    crowned = nh.Contact(NU206.roller, nh.Ring(diameter=-55.5, depth=3.25, profile=nh.profile.crown(3000.0)))
    law = law_of(INNER, crowned)
    asked(law, 0.0115, 0.0, other=(0.012, 0.0))
    assert_array_equal(law.edges(0, 0), laid_for(INNER, 0.0115))
    assert_array_equal(law.edges(0, 1), laid_for(crowned, 0.012))


@pytest.mark.parametrize(("deeper", "anew"), [(0.01, False), (0.05, True), (-0.05, False), (-0.2, True)])
def test_near_the_balance_strips_are_laid_anew_where_the_contact_has_become_another(deeper, anew):
    law = law_of(INNER)
    asked(law, 0.01, 0.0)
    before = law.edges(0).copy()
    law.lay_anew()
    asked(law, 0.01 * (1.0 + deeper), 0.0)
    after = law.edges(0)
    assert anew != (before.shape == after.shape and bool(np.all(before == after)))


def test_on_the_way_strips_are_kept_up_to_three_times_the_depth():
    law = law_of(INNER)
    asked(law, 0.004, 0.0)
    before = law.edges(0).copy()
    asked(law, 0.004 * 2.9, 0.0)
    assert_array_equal(law.edges(0), before)
    asked(law, 0.004 * 3.1, 0.0)
    assert_array_equal(law.edges(0), laid_for(INNER, 0.004 * 3.1))


def test_the_same_contacts_are_solved_once():
    law = law_of(INNER)
    poses = np.array([(0.01, 0.0), (0.005, 1e-4), (0.01, 0.0), (-0.003, 0.0)])
    found = law.answer(np.arange(4), poses[:, None])[:, 0]
    assert law.laid_for == [(0.01, 0.0), (0.005, 1e-4)]
    assert found[0, 0] == found[2, 0] > found[1, 0] > found[3, 0] == 0.0


def test_contacts_that_mirror_each_other_answer_so():
    """Each led on its own strips: what these do far away was mixed up between grids of as many."""
    law = law_of(INNER)
    for approach in (0.01, 0.0101):
        one, other = (asked(law, approach, tilt, row=row) for row, tilt in enumerate((1e-5, -1e-5)))
        assert_allclose(law.edges(0), -law.edges(1)[::-1], atol=1e-9)
        assert np.all(np.abs(one - other * [1, -1, 1, -1, -1, 1]) <= 1e-9 * size_of(one))
    assert not np.allclose(law.edges(0), law.edges(1), atol=1e-4)


def test_few_loops_are_kept():
    contact = cut_into_strips(INNER)
    law, most = core.StripLaw([contact]), 0
    for row in range(40):
        asked(law, 0.01, 1e-5 * row, row=row)
        asked(law, 0.01 + 1e-5, 1e-5 * row, row=row)
        most = max(most, contact.loops)
    assert law.followed == 40
    assert contact.loops < most <= 32
    alone = nh.solve(INNER, approach=0.01 + 1e-5, tilt=1e-5)
    assert_allclose(asked(law, 0.01 + 1e-5, 1e-5, row=1)[0], alone.load, rtol=2e-4)


def test_a_contact_without_a_solution_is_named():
    with pytest.raises(core.Unsolved) as raised:
        asked(law_of(INNER), 30.0, 0.0)
    said = "The contact of a roller pressed 30000 µm into its raceway at a tilt of 0 mrad has no solution: "
    assert str(no_solution_error(raised.value)).startswith(said)


def test_a_profile_without_a_number_is_named():
    class Broken(nh.profile.Profile):
        def relief(self, y):
            return np.where(np.asarray(y) > 3.1, np.nan, np.square(y) / 8000.0)

    with pytest.raises(nh.InputError, match=r"^profile = nan must not be NaN, but is at y = 3\.\d+: correct"):
        nh.bearing.solve(nu206(profile=Broken()), radial=5e3)


@pytest.mark.parametrize(("speed", "most"), [(30.0, 100), (3000.0, 26)])
def test_rollers_that_speed_alone_presses_cost_little(speed, most, laws):
    """They crossed the clearance in leaps that pressed them half a millimetre deep: a hundred times the work."""
    found = nh.bearing.solve(NU206, radial=11e3, tilt=1e-3, speed=speed)
    idle = found.load[:, 0] == 0.0
    assert np.count_nonzero(idle) >= 6
    assert_allclose(found.load[idle, 1], found.roller_load[idle, 1], atol=1e-9 * found.load.max())
    assert laid(laws) <= most


def test_idle_tapered_rollers_cost_little(laws):
    """On the outer ring and the rib they tilted to and fro, each time on other strips: 180 where 30 do."""
    found = nh.read_bearing(EXAMPLES / "tapered-pair.toml").solve()
    idle = found.load[:, 0] == 0.0
    assert np.count_nonzero(idle) == 12
    # Each rests between outer raceway and rib under its centrifugal load, whatever the others bear: a frustum of steel,
    # whose cage rolls on both raceways, and whose end touches the rib 4.6 mm from its axis with a radius of 145 mm.
    large, small, length, pitch, outer = 0.5 * 10.958057, 0.5 * 10.102316, 12.25, 51.56, 0.20697859599400753
    axis = outer - math.atan((large - small) / length)
    areas = large**2 + large * small + small**2
    middle = 0.5 * length - 0.25 * length * (large**2 + 2.0 * large * small + 3.0 * small**2) / areas
    cage = 1500.0 * math.pi / 30.0 * 0.5 * (1.0 - (large + small) * math.cos(axis) / pitch)
    force = 7.85e-9 * math.pi * length / 3.0 * areas * cage**2 * (0.5 * pitch + middle * math.sin(axis))
    rib = axis - math.asin(4.6 / 145.0)
    assert_allclose(found.load[idle, 1], force / (math.cos(outer) + math.sin(outer) * math.tan(rib)), rtol=1e-3)
    assert_allclose(found.rib_load[idle, 0], 0.167 * 12.25 / 11.65, rtol=3e-3)
    assert laid(laws) <= 45


@pytest.mark.parametrize("tilt", [1e-4, 1.37e-4, 3.3e-4])
def test_the_load_fades_with_the_penetration(tilt):
    """Where bodies overlap most between samples, light contacts were cut off that still bore a load."""
    contact = nh.Contact(nh.Roller(diameter=9.0, length=10.0, profile=nh.profile.crown(1200.0)), NU206.inner)
    law = law_of(contact)
    summit = 1200.0 * (np.sqrt(1.0 + tilt**2) - 1.0)
    depth = np.geomspace(1e-4, 1e-9, 6)
    poses = np.stack([depth - summit, np.full(6, tilt)], axis=1)
    assert_allclose(cut_into_strips(contact).penetration(poses), depth, rtol=1e-3, atol=1e-12)
    loads = np.array([asked(law, each - summit, tilt)[0] for each in depth])
    # Hertz's ellipse, whose load falls nearly with the power 3/2.
    powers = np.diff(np.log(loads)) / np.diff(np.log(depth))
    assert np.all((powers > 1.3) & (powers < 1.6))
    assert asked(law, -1e-9 - summit, tilt)[0] == 0.0


@pytest.mark.parametrize("tilt", [2e-4, -1.6e-3, 4.4e-3])
def test_the_overlap_on_a_corner_is_that_of_its_circle(tilt):
    """A tilted roller touches beside the end of its flat part, where samples of the profile lie far apart."""
    contact = cut_into_strips(nh.Contact(nh.Roller(diameter=9.0, length=10.0, corner_radius=0.3), nh.Plate()))
    touch = abs(tilt) * 4.7 + 0.3 * (np.sqrt(1.0 + tilt**2) - 1.0)
    depth = np.array([1e-3, 1e-8, 0.0, -1e-8, -1e-3])
    poses = np.stack([depth - touch, np.full(5, tilt)], axis=1)
    assert_allclose(contact.penetration(poses), depth, rtol=0.0, atol=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize("profile", [None, nh.profile.logarithmic(0.0063, 12.7, 0.95)])
@pytest.mark.parametrize("speed", [10.0, 1e3])
@pytest.mark.filterwarnings("ignore:roller .* ring")
def test_rollers_that_tip_between_washers_end(profile, speed, laws):
    """A small moment of their own tips idle ones until two corners touch: the search for that never ended."""
    straight = nh.Roller(diameter=8.2, length=12.7, corner_radius=0.386)
    roller = straight if profile is None else dataclasses.replace(straight, profile=profile)
    washers = {"inner": nh.Plate(), "outer": nh.Plate(), "pitch_diameter": 28.3}
    bearing = nh.bearing.CylindricalThrustBearing(roller=roller, **washers, rollers=9)
    found = nh.bearing.solve(bearing, axial=3107.0, tilt=-1.627e-3, speed=speed)
    assert all(max(law.evaluations.values()) <= 100 for law in laws)
    # Of the washers' motion at a roller each of its contacts takes half, but for what its own moment does.
    x, turned = found.displacement[[0, 4]]
    closer, tilt = x - 14.15 * turned * np.cos(found.angle), -turned * np.cos(found.angle)
    loads = [
        nh.solve(bearing.contacts[0], approach=by / 2.0, tilt=turn / 2.0).load if by + abs(turn) * 6.35 > 4e-3 else 0.0
        for by, turn in zip(closer, tilt, strict=True)
    ]
    assert_allclose(found.load[:, 0], loads, atol=2e-4 * max(loads))
    assert_allclose(np.sum(loads), 3107.0, rtol=3e-4)


@pytest.mark.slow
def test_light_contacts_take_no_more_strips_than_by_themselves():
    """They began with as many as heavy ones had needed, and asked for six times more: 2,000 strips, 1.5 GB."""
    contact = nh.Contact(nh.Roller(diameter=4.0, length=5.2, corner_radius=0.153), nh.Ring(diameter=31.0))
    law, approach = law_of(contact), np.array([1.5e-4, 1e-4, 3e-8])
    law.answer(np.arange(3), np.stack([approach, np.zeros(3)], axis=1)[:, None])
    with without_accuracy_warnings():  # a speck at a corner: its maximum pressure is not known to be within its size
        alone = [nh.solve(contact, approach=each).strips for each in approach]
    assert [law.edges(row).size - 1 for row in range(3)] == alone


def test_few_strips_bear_close_to_a_corner():
    """A roller that tips over its end found no balance on strips whose last centre was too far inside."""
    law = law_of(INNER, strips=21)
    tilt = 0.02
    corner = NU206.roller.length / 2 - 0.3
    found = asked(law, 2e-3 - tilt * corner + corner**2 / 2400.0, tilt)
    assert found[1] / found[0] > 0.97 * corner
