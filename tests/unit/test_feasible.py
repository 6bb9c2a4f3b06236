"""What no loads on any strips can meet: what is refused, of strips that were given and of automatic ones."""

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.native import core
from nonhertz.strip.model import model_of

CROWNED = nh.Contact(nh.Roller(diameter=20, length=20, profile=nh.profile.crown(500)), nh.Plate())
MODEL = model_of(CROWNED)
EDGES = np.linspace(-10.0, 10.0, 5)  # centres at 2.5 and 7.5 mm


def prescription(*, load=None, approach=None, moment=None, tilt=0.0):
    """What is given by force, and the targets, in the unit of a compliance of 1."""
    first, second = (load, approach)[load is None], (moment, tilt)[moment is None]
    return (load is not None, moment is not None), (first, second)


def refusal_of(given, *, chosen=True, model=MODEL, edges=EDGES):
    with pytest.raises(core.Refused) as refused:
        core.refuse_infeasible(model, edges, *given, chosen=chosen)
    assert not core.is_feasible(model, edges, *given)
    return refused.value.args


@pytest.mark.parametrize(
    ("chosen", "why"), [(True, core.Refusal.ARM_OFF_STRIPS), (False, core.Refusal.ARM_OUTSIDE)], ids=str
)
def test_a_resultant_beyond_the_outermost_centres(chosen, why):
    reason, arm, low, high, strips = refusal_of(prescription(load=1.0, moment=8.0), chosen=chosen)
    assert (reason, arm, low, high) == (why, 8.0, -7.5, 7.5)
    assert strips == (4 if chosen else 0)
    core.refuse_infeasible(MODEL, EDGES, *prescription(load=1.0, moment=7.5), chosen=chosen)


def test_strips_that_miss_a_contact_between_their_centres():
    # The crown is 6 um back at 2.5 mm.
    given = prescription(approach=3e-3)
    assert refusal_of(given)[0] is core.Refusal.BETWEEN_STRIPS
    assert refusal_of(given, chosen=False)[:2] == (core.Refusal.UNRESOLVED, 3e-3)


@pytest.mark.parametrize("tilt", [0.0, 1e-3, -1e-3])
def test_an_approach_counts_with_its_tilt(tilt):
    assert not core.is_feasible(MODEL, EDGES, *prescription(approach=-1e-3, tilt=0.0))
    reached = 7.5 * abs(tilt) - 7.5**2 / 1000.0  # above the outer centre
    assert core.is_feasible(MODEL, EDGES, *prescription(approach=-reached + 1e-6, tilt=tilt))
    lifted = max(2.5 * abs(tilt) - 2.5**2 / 1000.0, reached)
    assert not core.is_feasible(MODEL, EDGES, *prescription(approach=-lifted - 1e-6, tilt=tilt))


@pytest.mark.parametrize("tilt", [0.0, 1e-3, -1e-2])
def test_bodies_that_are_apart_are_told_where_they_begin_to_touch(tilt):
    # A circle touches where it is as steep as the tilt.
    why, needed, *_ = refusal_of(prescription(approach=-0.1, tilt=tilt))
    assert why is core.Refusal.APART
    assert needed == pytest.approx(500.0 * (1.0 - np.sqrt(1.0 + tilt**2)), abs=1e-10)


def test_a_moment_that_tilts_the_bodies_apart_is_refused():
    why, approach, *_ = refusal_of(prescription(approach=-1e-2, moment=0.0))
    assert (why, approach) == (core.Refusal.TILTED_APART, -1e-2)


@pytest.mark.parametrize(
    ("relief", "why", "at"),
    [
        (lambda y: np.where(y > 7.0, np.nan, 0.0), core.Refusal.NAN_RELIEF, 7.5),
        (lambda y: np.full_like(y, np.inf), core.Refusal.ENDLESS_RELIEF, 0.0),
    ],
    ids=["NaN", "infinite"],
)
def test_a_relief_that_is_no_number_is_refused(relief, why, at):
    reason, value, *_ = refusal_of(prescription(load=1.0), model=model_of(with_relief(relief)))
    assert (reason, value) == (why, at)


def with_relief(relief):
    class Made(nh.profile.Profile):
        def relief(self, y):
            return relief(np.asarray(y, dtype=float))

    return nh.Contact(nh.Body(diameter=20, length=20, profile=Made()), nh.Plate())


def test_endless_bodies_with_a_wall_on_one_side_are_looked_at_on_the_other_too():
    wall = with_relief(lambda y: np.where(y < -1.0, np.inf, y**2 / 2000.0))
    endless = nh.Contact(nh.Ring(diameter=20, profile=wall.a.profile), nh.Plate())
    low, high = core.bound_contact(model_of(endless), *prescription(load=1e-4, moment=0.5e-4))
    assert low == pytest.approx(-1.0)
    assert 0.5 < high < 100.0
    with pytest.raises(core.Refused) as refused:
        core.bound_contact(model_of(endless), *prescription(load=1e-4, moment=-1.1e-4))
    assert refused.value.args[0] is core.Refusal.ARM_OUTSIDE


def test_a_contact_that_nothing_ends_is_refused():
    with pytest.raises(core.Refused) as refused:
        core.bound_contact(model_of(nh.Contact(nh.Ring(diameter=20), nh.Plate())), *prescription(load=1e-4))
    assert refused.value.args[0] is core.Refusal.NO_END
