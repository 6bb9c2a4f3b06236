"""A whole roller: modes around it, the smooth part of its displacement, and what is kept of it."""

import math

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.bodies import whole_roller as module
from nonhertz.bodies.harmonic_elements import Cylinder
from nonhertz.bodies.stored import stored
from nonhertz.bodies.whole_roller import whole_roller


@pytest.mark.parametrize(
    ("poisson", "n", "k", "expected"),
    [
        # Of an endless cylinder, from its Papkovich-Neuber solution (theory.md).
        (0.3, 0, 1.0, 0.3819), (0.3, 2, 0.5, 0.55977), (0.3, 4, 2.0, 0.22638), (0.3, 10, 3.0, 0.09449),
        (0.0, 0, 1.0, 0.49543), (0.0, 2, 0.5, 0.49617), (0.0, 4, 2.0, 0.21986), (0.0, 10, 3.0, 0.09297),
    ],
)  # fmt: skip
def test_modes_in_the_middle_of_a_long_cylinder_are_those_of_an_endless_one(poisson, n, k, expected):
    moved = Cylinder(8.0, poisson).compressed(n, [lambda z: np.cos(k * z)], np.zeros(1))
    assert moved[0, 0] / (2.0 * math.pi) == pytest.approx(expected, abs=1e-4)


def test_a_uniform_pressure_all_around_moves_the_surface_by_the_same_everywhere():
    moved = Cylinder(1.0, 0.3).compressed(0, [np.ones_like], np.linspace(-1.0, 1.0, 5))
    # In units of p R / (2 mu), u = -(1 - nu) / (1 + nu) for a cylinder that is free to grow longer.
    in_k = 2.0 * math.pi / (1.0 - 0.3) * 0.5 * (1.0 - 0.3) / (1.0 + 0.3)
    np.testing.assert_allclose(moved[:, 0], in_k, rtol=1e-9)


def test_even_and_odd_loads_move_the_surface_evenly_and_oddly():
    places = np.array([-0.7, 0.7])
    moved = Cylinder(1.0, 0.3).compressed(2, [lambda z: z**2, lambda z: z], places)
    np.testing.assert_allclose(moved[0], [moved[1, 0], -moved[1, 1]], rtol=1e-12)


@pytest.mark.parametrize("n", [0, 2, 6])
def test_modes_are_reciprocal(n):
    node, weight = np.polynomial.legendre.leggauss(24)
    moved = Cylinder(1.0, 0.3).compressed(n, [np.ones_like, lambda z: z, lambda z: z**4], node)
    assert weight @ (moved[:, 0] * node**4) == pytest.approx(weight @ moved[:, 2], rel=1e-4)


def test_the_smooth_part_is_symmetric_and_does_not_mix_even_and_odd():
    found = whole_roller(1.0, 0.3).matrix
    np.testing.assert_array_equal(found, found.T)
    count = np.arange(len(found))
    assert np.all(found[np.add.outer(count, count) % 2 == 1] == 0.0)
    assert np.abs(found[-2:, :4]).max() < 0.02 * np.abs(found).max()


def test_a_strip_moves_as_its_parts_do():
    whole, y = whole_roller(1.0, 0.3), np.array([[-0.5, 0.1, 0.9]])
    parts = whole.displacement(y, np.array([[-0.3, 0.0, 0.2, 0.7]]))
    np.testing.assert_allclose(parts.sum(axis=-1), whole.displacement(y, np.array([[-0.3, 0.7]]))[..., 0], rtol=1e-12)


@pytest.mark.parametrize("half_length", [0.3, 1.0, 3.0])
def test_more_modes_by_elements_change_little(half_length, monkeypatch):
    edges, y = np.linspace(-half_length, half_length, 101), half_length * np.array([0.0, 0.6, 1.0])
    found = whole_roller(half_length, 0.3).displacement(y, edges).sum(axis=-1)
    monkeypatch.setattr(module, "_MODES", 36)
    fresh = module.WholeRoller(half_length, module._matrix.__wrapped__(half_length, 0.3))
    # The whole compression is about 8 in these units.
    np.testing.assert_allclose(fresh.displacement(y, edges).sum(axis=-1), found, atol=0.01)


def test_sums_over_modes_are_those_of_their_terms():
    distance = np.array([0.3, 1.0, 2.0])
    # 2 K0 integrated over all n is pi / s, and exp(-n s) is 1 / s.
    from scipy import special

    n = np.arange(2.0, 400.0, 2.0)[:, None]
    images = 2.0 / math.pi * np.sum(2.0 * special.k0(n * distance), axis=0) - 1.0 / distance
    planes = 2.0 / math.pi * np.sum(np.exp(-n * distance), axis=0) - 1.0 / math.pi / distance
    np.testing.assert_allclose(module._sum_over_images(distance), images, atol=1e-9)
    np.testing.assert_allclose(module._sum_over_planes(distance), planes, atol=1e-9)


def roller(**changes):
    return nh.Roller(**{"diameter": 20.0, "length": 20.0, "side_faces": "free", "depth": "finite"} | changes)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: roller(side_faces="mirror"), "depth = 'finite' must only be used for a body with two free side faces"),
        (lambda: roller(side_faces=("free", "none")), "must only be used for a body with two free side faces"),
        (lambda: roller(images=3), "images = 3 must be 1 where depth = 'finite'"),
        (lambda: roller(length=500.0), "must only be used for a length of 0.1 to 10 diameters, not 25"),
        (lambda: roller(diameter=nh.TabulatedDiameter((-1.0, 1.0), (19.0, 20.0))), "only be used for a body of one"),
        (lambda: nh.Ring(diameter=-80.0, length=20.0, side_faces="free", depth="finite"), "for a convex body"),
        (lambda: nh.Body(diameter=20.0, depth="finite"), "must only be used for a body with two free side faces"),
    ],
)
def test_bodies_that_are_no_solid_cylinder_are_refused(make, message):
    with pytest.raises(nh.InputError) as refused:
        make()
    assert message in str(refused.value)


def test_a_moved_roller_is_the_same_roller():
    profile = nh.profile.crown(radius=3000.0)
    here, there = (
        nh.solve(nh.Contact(roller(profile=profile, position=at), nh.Ring(diameter=80.0)), load=1e4)
        for at in (0.0, 3.0)
    )
    assert there.approach == pytest.approx(here.approach, rel=1e-6)


def test_twice_the_roller_under_four_times_the_load_approaches_twice_as_far():
    def solved(scale):
        profile = nh.profile.crown(radius=3000.0 * scale)
        body = roller(profile=profile, diameter=20.0 * scale, length=20.0 * scale)
        return nh.solve(nh.Contact(body, nh.Ring(diameter=80.0 * scale)), load=1e4 * scale**2)

    assert solved(2.0).approach == pytest.approx(2.0 * solved(1.0).approach, rel=1e-9)


def test_arrays_are_computed_once_and_kept_on_disk(tmp_path, monkeypatch):
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path))
    made = []

    def make(value):
        made.append(value)
        return np.array([value, 1.0])

    first, second = stored(__name__)(make), stored(__name__)(make)  # as in two processes
    for kept in (first, first, second):
        np.testing.assert_array_equal(kept(2.5), [2.5, 1.0])
    assert made == [2.5]
    assert not first(2.5).flags.writeable
    (file,) = (tmp_path / "nonhertz").iterdir()
    file.write_bytes(file.read_bytes()[:-3])
    np.testing.assert_array_equal(stored(__name__)(make)(2.5), [2.5, 1.0])
    assert made == [2.5, 2.5]


def test_arrays_are_computed_where_nothing_can_be_kept(tmp_path, monkeypatch):
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path / "file"))
    np.testing.assert_array_equal(stored(__name__)(lambda value: np.array([value]))(3.0), [3.0])
