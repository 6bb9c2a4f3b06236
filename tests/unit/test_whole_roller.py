"""A whole roller: modes around it, the smooth part of its displacement, and what is kept of it."""

import dataclasses
import math

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.bodies import smooth_part, solid_rollers
from nonhertz.bodies.harmonic_elements import DEGREE, HarmonicElements, nodal_polynomials, with_kinks
from nonhertz.bodies.influence import influence_of
from nonhertz.bodies.smooth_part import fade_weights, response_matrix, terms_along
from nonhertz.bodies.stored import cache_on_disk
from nonhertz.bodies.whole_roller import whole_roller
from nonhertz.model.outline import Outline
from nonhertz.strip.influence import displacements


def elements(half_length=1.0, poisson=0.3, bore=0.0, most=24):
    return HarmonicElements(Outline.cylinder(half_length, bore), poisson, most)


def compressed(body, n, loads, places):
    """How far the surface moves inwards at places, over the loads' amplitudes and K."""
    moved = body.displaced(n, body.forces(loads))[:, 0, -1].T
    half = body.outline.symmetric
    at, borders = np.abs(places) if half else places, body.axial_borders
    e = np.clip(np.searchsorted(borders, at) - 1, 0, borders.size - 2)
    weights, _ = nodal_polynomials((2.0 * at - borders[e] - borders[e + 1]) / np.diff(borders)[e])
    found = -np.einsum("pn,pnk->pk", weights, moved[e[:, None] * DEGREE + np.arange(DEGREE + 1)])
    if half:
        found[:, 1::2] *= np.sign(places)[:, None]
    return found


PLACES = np.array([-1.0, -0.8, -0.4, 0.0, 0.4, 0.8, 1.0])


@pytest.mark.parametrize(
    ("poisson", "modes"),
    [  # of n, k: of an endless cylinder, from its Papkovich-Neuber solution (depth.md)
        (0.3, {(0, 1.0): 0.3819, (2, 0.5): 0.55977, (4, 2.0): 0.22638, (10, 3.0): 0.09449}),
        (0.0, {(0, 1.0): 0.49543, (2, 0.5): 0.49617, (4, 2.0): 0.21986, (10, 3.0): 0.09297}),
    ],
)
@pytest.mark.slow
def test_modes_in_the_middle_of_a_long_cylinder_are_those_of_an_endless_one(poisson, modes):
    body = elements(8.0, poisson)
    for (n, k), expected in modes.items():
        moved = compressed(body, n, lambda z, k=k: np.cos(k * z)[:, None], np.zeros(1))
        assert moved[0, 0] / (2.0 * math.pi) == pytest.approx(expected, abs=1e-4)


def test_a_uniform_pressure_all_around_moves_the_surface_by_the_same_everywhere():
    moved = compressed(elements(), 0, lambda z: np.ones((z.size, 1)), np.linspace(-1.0, 1.0, 5))
    # In units of p R / (2 mu), u = -(1 - nu) / (1 + nu) for a cylinder that is free to grow longer.
    in_k = 2.0 * math.pi / (1.0 - 0.3) * 0.5 * (1.0 - 0.3) / (1.0 + 0.3)
    np.testing.assert_allclose(moved[:, 0], in_k, rtol=1e-9)


@pytest.mark.parametrize("n", [0, 2, 4])
def test_the_axis_of_a_solid_roller_moves_along_itself_alone_and_not_under_waves(n):
    body = elements()
    moved = body.displaced(n, body.forces(lambda z: np.cos(z)[:, None]))[0, :, 0]
    np.testing.assert_array_equal(moved[: 2 if n == 0 else 3], 0.0)
    assert (np.abs(moved[2]).max() > 1.0) == (n == 0)


def test_the_smooth_part_is_symmetric_and_does_not_mix_even_and_odd():
    found = whole_roller(Outline.cylinder(1.0), 0.3).matrix
    np.testing.assert_allclose(found, found.T, atol=1e-12)
    count = np.arange(len(found))
    assert np.all(found[np.add.outer(count, count) % 2 == 1] == 0.0)
    assert np.abs(found[-2:, :4]).max() < 0.02 * np.abs(found).max()


def test_slopes_of_the_curved_part_are_those_of_its_values():
    curved = whole_roller(Outline.cylinder(1.0), 0.3).curved
    step = 25.0 / (len(curved) - 1)
    for k in (0, 2):
        slopes = (curved[202:, k] - curved[200:-2, k]) / (2.0 * step)
        np.testing.assert_allclose(curved[201:-1, k + 1], slopes, rtol=0.0, atol=1e-5)


@pytest.mark.parametrize(("bore", "n"), [(0.5, 0), (0.5, 2), (0.8, 6)])
def test_modes_of_a_bored_cylinder_are_those_of_a_plane_one(bore, n):
    # In the middle of a long one under the same load all along: plane, and free to grow longer for n = 0.
    poisson = 0.3
    moved = compressed(elements(8.0, poisson, bore), n, lambda z: np.ones((z.size, 1)), np.zeros(1))[0, 0]
    modulus_over_shear = 2.0 * (1.0 + poisson)
    to_displacement = (1.0 - poisson) / (2.0 * math.pi)  # with a shear modulus of 1
    assert moved * to_displacement == pytest.approx(plane_mode(bore, n, poisson, modulus_over_shear), rel=2e-4)


def plane_mode(bore, n, poisson, modulus):
    """Inward displacement of a ring of outer radius 1 under a pressure cos(n theta), by Michell's functions."""
    if n == 0:  # Lame, without axial stress
        return ((1.0 - poisson) + (1.0 + poisson) * bore**2) / (1.0 - bore**2) / modulus

    def stresses_and_motion(power):
        # Airy's function r^power cos(n theta), in plane strain: sigma_rr, tau_rt, 2 mu u_r.
        m = power

        def at(r):
            rr = (m - n * n) * r ** (m - 2)
            shear = n * (m - 1) * r ** (m - 2)
            square = (m * m - n * n) * r ** (m - 2)  # of Laplace's operator
            # 2 mu u_r = -dphi/dr + (1 - nu) times the integral of that along r; 0 / 0 for a harmonic function
            radial = -m * r ** (m - 1) + (0.0 if m * m == n * n else (1.0 - poisson) * square * r / (m - 1))
            return rr, shear, radial

        return at

    functions = [stresses_and_motion(m) for m in (n, n + 2, -n, 2 - n)]
    matrix = np.array([[f(r)[i] for f in functions] for r in (1.0, bore) for i in (0, 1)])
    amplitudes = np.linalg.solve(matrix, [-1.0, 0.0, 0.0, 0.0])
    return -0.5 * sum(a * f(1.0)[2] for a, f in zip(amplitudes, functions, strict=True))


def recessed(wall, deep=0.1, radius=0.4):
    """A solid roller with a recess in both ends, whose wall is a steep cone over a short length."""
    z = (-1.0, -1.0 + deep, -1.0 + deep + wall, 1.0 - deep - wall, 1.0 - deep, 1.0)
    return Outline(z, (1.0,) * 6, (radius, radius, 0.0, 0.0, radius, radius))


@pytest.mark.slow
@pytest.mark.parametrize("n", [0, 2, 4])
def test_the_wall_of_a_step_can_be_as_short_as_one_likes(n):
    def at_ends(wall, most=24):
        moved = compressed(HarmonicElements(recessed(wall), 0.3, most), n, lambda z: np.stack([z**0, z], 1), PLACES)
        return moved[[0, -1]]

    upright = at_ends(1e-6, most=48)
    # A cone is softer by what it takes away, as on finer elements: 0.33 % for the last.
    for wall, off in ((1e-4, 1e-3), (1e-3, 2e-3), (5e-3, 4e-3)):
        np.testing.assert_allclose(at_ends(wall), upright, rtol=off)
    np.testing.assert_allclose(at_ends(0.02), at_ends(0.02, most=48), rtol=1.2e-3)
    # It weakens the ends, more than a recess half as deep.
    solid = compressed(elements(), n, lambda z: np.stack([z**0, z], 1), PLACES)[[0, -1]]
    assert np.all(np.abs(upright) > 1.01 * np.abs(solid))


def test_borders_hold_every_kink_and_grow_away_from_it():
    kinks = (-0.5, -0.4999, 0.3, 0.31)
    borders = with_kinks(np.linspace(-1.0, 1.0, 5), kinks, 0.1)
    assert set(kinks) <= set(borders.tolist())
    sizes = np.diff(borders)
    assert np.all(sizes > 0.0)
    assert np.max(np.maximum(sizes[1:] / sizes[:-1], sizes[:-1] / sizes[1:])) < 6.0


def test_sums_over_modes_are_those_of_their_terms():
    distance = np.array([0.3, 1.0, 2.0])
    # 2 K0 integrated over all n is pi / s, and exp(-n s) is 1 / s.
    from scipy import special

    n = np.arange(2.0, 400.0, 2.0)[:, None]
    images = 2.0 / math.pi * np.sum(2.0 * special.k0(n * distance), axis=0) - 1.0 / distance
    planes = 2.0 / math.pi * np.sum(np.exp(-n * distance), axis=0) - 1.0 / math.pi / distance
    np.testing.assert_allclose(smooth_part.sum_over_images(distance), images, atol=1e-9)
    np.testing.assert_allclose(smooth_part.sum_over_planes(distance), planes, atol=1e-9)
    near = np.array([1e-3, 4.9e-3, 5.1e-3])  # of all modes exp(-n s) is a geometric series
    planes = 2.0 / math.pi / np.expm1(2.0 * near) - 1.0 / math.pi / near
    np.testing.assert_allclose(smooth_part.sum_over_planes(near), planes, atol=1e-9)


def roller(**changes):
    return nh.Roller(**{"diameter": 20.0, "length": 20.0, "side_faces": "free", "depth": "finite"} | changes)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: roller(side_faces=("free", "none")), "depth = 'finite' must only be used for a body with two free"),
        (lambda: roller(images=3), "images = 3 must be 1 where depth = 'finite'"),
        (lambda: roller(length=500.0), "must only be used for a length of 0.1 to 10 diameters, not 25"),
        (
            lambda: nh.Roller(diameter=20.0, length=1.9, bore=8.0),
            "bore = 8.0 must only be used for a length of 0.1 to 10 diameters, not 0.095: leave it out, and give the "
            "thickness of the wall instead, depth = 6.",
        ),
        (
            lambda: nh.Roller(diameter=20.0, length=250.0, bore=8.0),
            "bore = 8.0 must only be used for a length of 0.1 to 10 diameters, not 12.5: leave it out, and give ",
        ),
        (
            lambda: nh.Roller(diameter=20.0, length=20.0, bore=8.0, side_faces="mirror"),
            "bore = 8.0 must only be used for a body with two free side faces: write side_faces = 'free', or leave it",
        ),
        (lambda: nh.Roller(diameter=20.0, length=20.0, bore=8.0, images=3), "images = 3 must be 1 where depth = 'fi"),
        (lambda: roller(diameter=nh.TabulatedDiameter((-1.0, 1.0), (18.0, 20.0))), "where the radius changes by less"),
        (lambda: roller(bore=25.0), "bore = 25.0 must leave a wall of 0.08 times the radius at least, not -2.5 mm"),
        (lambda: roller(bore=5.0, depth="plane-strain"), "bore = 5.0 must only be given where depth = 'finite'"),
        (lambda: nh.Ring(diameter=-80.0, length=20.0, side_faces="free", depth="finite"), "for a convex body"),
    ],
)
def test_bodies_that_are_no_whole_roller_are_refused(make, message):
    with pytest.raises(nh.InputError) as refused:
        make()
    assert message in str(refused.value)


def test_the_way_out_for_a_short_hollow_roller_works():
    with pytest.raises(nh.InputError, match=r"depth = 6\.$"):
        nh.Roller(diameter=20.0, length=1.9, bore=8.0)
    disc = nh.Roller(diameter=20.0, length=1.9, depth=6.0, profile=nh.profile.crown(100.0))
    assert nh.solve(nh.Contact(disc, nh.Plate()), load=200.0).load == pytest.approx(200.0)


def test_sizes_beyond_all_numbers_are_no_whole_roller():
    with np.errstate(all="raise"):
        assert nh.Roller(diameter=1e100, length=1.0).behind.word == "plane-strain"


@pytest.mark.parametrize("name", ["length", "bore"])
def test_gradients_by_dimensions_are_what_contacts_solved_anew_differ_by(name):
    body = roller(bore=8.0)
    contact = nh.Contact(body, nh.Ring(diameter=80.0))
    found = nh.solve(contact, load=5e3, tilt=1e-4)
    at, step = getattr(body, name), 1e-3

    def again(value):
        changed = nh.Contact(dataclasses.replace(body, **{name: value}), contact.b)
        edges = found.edges * changed.interval[1] / contact.interval[1]
        return nh.solve(changed, load=5e3, tilt=1e-4, strips=edges)

    low, high = again(at - step), again(at + step)
    for quantity in ("approach", "max_pressure"):
        expected = (getattr(high, quantity) - getattr(low, quantity)) / (2.0 * step)
        # The difference itself is right to some (step / at)^2.
        assert found.gradient(quantity).by(f"a.{name}") == pytest.approx(expected, rel=1e-5)


def test_arrays_are_computed_once_and_kept_on_disk(tmp_path, monkeypatch):
    monkeypatch.setenv("NONHERTZ_CACHE_DIR", str(tmp_path))
    made = []

    def make(value):
        made.append(value)
        return np.array([value, 1.0])

    first, second = cache_on_disk(__name__)(make), cache_on_disk(__name__)(make)  # as in two processes
    for kept in (first, first, second):
        np.testing.assert_array_equal(kept(2.5), [2.5, 1.0])
    assert made == [2.5]
    assert not first(2.5).flags.writeable
    (file,) = tmp_path.iterdir()
    file.write_bytes(file.read_bytes()[:-3])
    np.testing.assert_array_equal(cache_on_disk(__name__)(make)(2.5), [2.5, 1.0])
    assert made == [2.5, 2.5]


def test_arrays_are_computed_where_nothing_can_be_kept(tmp_path, monkeypatch):
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("NONHERTZ_CACHE_DIR", str(tmp_path / "file"))
    np.testing.assert_array_equal(cache_on_disk(__name__)(lambda value: np.array([value]))(3.0), [3.0])


@pytest.mark.parametrize(("half_length", "poisson"), [(0.11, 0.3), (0.1999, 0.02), (0.73, 0.3), (1.37, 0.475)])
def test_the_table_of_solid_rollers_gives_what_short_elements_give(half_length, poisson):
    outline = Outline.cylinder(half_length)
    count = math.ceil(terms_along(outline))
    worked_out = response_matrix(outline, poisson, count, 1.2 * half_length / count)
    tabulated = solid_rollers.response_matrix(half_length, poisson, count)
    counting = np.outer(fade_weights(outline), fade_weights(outline))
    np.testing.assert_allclose(counting * tabulated, counting * worked_out, atol=3e-6 * np.abs(worked_out).max())


def test_outside_the_table_a_solid_roller_is_worked_out():
    assert solid_rollers.response_matrix(1.0, 0.49, 18) is None
    assert whole_roller(Outline.cylinder(1.0), 0.49).matrix.shape == (18, 18)


def test_in_contact_the_surface_of_a_tapered_roller_moves_by_what_the_bodies_overlap():
    tapered = roller(diameter=lambda y: 20.0 + 0.2 * y, profile=nh.profile.crown(2000))
    solution = nh.solve(nh.Contact(tapered, nh.Plate()), load=10e3, strips=21)
    y, squares, bears = solution.y, solution.element_half_width**2, solution.line_load > 0.0
    ratios = np.divide(solution.contact.compliance * solution.line_load, squares, out=np.zeros_like(y), where=bears)
    influence = influence_of(solution.contact, nh.SEMI_ELLIPTIC)
    moved = displacements(influence, y, solution.edges, ratios, squares, nh.SEMI_ELLIPTIC)
    overlap = solution.approach + solution.tilt * y - solution.contact.separation(y)
    np.testing.assert_allclose(moved[bears], overlap[bears], rtol=0.0, atol=1e-12)
