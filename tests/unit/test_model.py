"""A contact as the core sees it: what varies along the axis, functions of the user's, and who keeps them."""

import gc
import pickle
import threading
import weakref

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.bodies.influence import influence_of
from nonhertz.model.profile import Profile
from nonhertz.strip.model import model_of

Y = np.linspace(-9.0, 9.0, 13)
CROWNED = nh.Roller(diameter=20.0, length=20.0, profile=nh.profile.crown(radius=1000.0))


class Parabola(Profile):
    """What a user may write."""

    def relief(self, y):
        return 5e-4 * np.asarray(y) ** 2


def barrel(y):
    """A diameter that is a function, as a user may write."""
    return 20.0 - 0.01 * y**2


def test_separation_and_curvature_are_those_of_the_contact():
    tapered = nh.TabulatedDiameter(y=(-10.0, 0.0, 10.0), diameter=(18.0, 19.0, 21.0))
    a = nh.Body(diameter=tapered, length=20.0, profile=nh.profile.crown(radius=1000.0), position=0.5)
    contact = nh.Contact(a, nh.Body(diameter=barrel, length=30.0, profile=Parabola()))
    model = model_of(contact)
    np.testing.assert_allclose(model.separation(Y), contact.separation(Y), rtol=1e-13, atol=0.0)
    np.testing.assert_allclose(model.curvature(Y), contact.curvature(Y), rtol=1e-15, atol=0.0)
    sharper = np.maximum(contact.a.curvature(Y), contact.b.curvature(Y))
    np.testing.assert_allclose(model.sharper_curvature(Y), sharper, rtol=1e-15, atol=0.0)


def test_the_smaller_depth_counts_and_follows_the_diameter():
    tapered = nh.TabulatedDiameter(y=(-10.0, 10.0), diameter=(4.0, 24.0))
    a = nh.Body(diameter=tapered, length=20.0, depth="diameter", side_faces="none")
    depth = model_of(nh.Contact(a, nh.Plate(depth=15.0))).min_depth(np.array([-5.0, 0.0, 5.0]))
    np.testing.assert_allclose(depth, [9.0, 14.0, 15.0], rtol=1e-15, atol=0.0)


def test_without_depth_nothing_moves_and_no_width_counts():
    model = model_of(nh.Contact(nh.Body(diameter=20.0), nh.Plate()))
    assert np.all(np.isinf(model.min_depth(Y)))
    assert model.at_depth(Y, Y).size == 0
    assert model.by_width(Y).size == 0


def test_surfaces_that_conform_are_refused_in_the_words_of_the_contact():
    shrinking = nh.TabulatedDiameter(y=(-10.0, 10.0), diameter=(-30.0, -10.0))
    contact = nh.Contact(nh.Roller(diameter=20.0, length=20.0, depth="none"), nh.Body(diameter=shrinking))
    model, places = model_of(contact), np.array([-9.0, 9.0])
    with pytest.raises(nh.InputError) as expected:
        contact.curvature(places)
    with pytest.raises(nh.InputError) as refused:
        model.curvature(places)
    assert str(refused.value) == str(expected.value)


def test_a_depth_in_diameters_of_a_hollow_body_is_refused_where_it_is_hollow():
    waisted = nh.Body(diameter=lambda y: np.where(y > 5.0, -100.0, 20.0), depth="diameter")
    model = model_of(nh.Contact(waisted, nh.Roller(diameter=20.0, length=20.0, depth="none")))
    np.testing.assert_allclose(model.min_depth(Y[Y < 5.0]), 20.0)
    with pytest.raises(nh.InputError, match="convex everywhere"):
        model.min_depth(Y)


class Unfinished(Exception):  # noqa: N818
    """What a user's own profile may raise."""


class Stumbling(Profile):
    """A profile of the user's that does not know its own end."""

    def relief(self, y):
        if np.any(np.asarray(y) > 8.0):
            raise Unfinished("beyond 8")
        return 5e-4 * np.asarray(y) ** 2


def test_what_a_profile_raises_passes_through_in_threads_too():
    model = model_of(nh.Contact(nh.Body(diameter=20.0, profile=Stumbling()), nh.Plate()))
    raised = []

    def ask(last):
        try:
            raised.append(model.separation(np.array([0.0, last])).tolist())
        except Unfinished as error:
            raised.append(str(error))

    threads = [threading.Thread(target=ask, args=(last,)) for last in (7.0, 9.0, 7.0, 9.0)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert sorted(raised, key=str) == sorted([[0.0, 0.0245], "beyond 8"] * 2, key=str)


@pytest.mark.parametrize("relief", [lambda y: 0.0, lambda y: np.zeros(y.shape, np.float32), lambda y: [0] * y.size])
def test_a_relief_of_other_numbers_is_taken_as_numpy_takes_it(relief):
    class Flat(Profile):
        def relief(self, y):
            return relief(y)

    model = model_of(nh.Contact(nh.Body(diameter=20.0, length=20.0, profile=Flat()), CROWNED))
    np.testing.assert_array_equal(model.separation(Y), model_of(nh.Contact(CROWNED, nh.Plate())).separation(Y))


def test_a_model_keeps_its_functions_and_lets_go_of_them():
    profile = Parabola()
    model = model_of(nh.Contact(nh.Body(diameter=20.0, profile=profile), nh.Plate()))
    kept = weakref.ref(profile)
    del profile
    np.testing.assert_array_equal(model.separation(Y), 5e-4 * Y**2)
    del model
    gc.collect()
    assert kept() is None


def test_what_a_whole_roller_does_can_be_sent_to_another_process():
    influence = influence_of(nh.Contact(nh.Roller(diameter=20.0, length=20.0), nh.Plate()), nh.SEMI_ELLIPTIC)
    moved = influence.at_depth(Y[1:], Y)
    np.testing.assert_array_equal(pickle.loads(pickle.dumps(influence)).at_depth(Y[1:], Y), moved)
