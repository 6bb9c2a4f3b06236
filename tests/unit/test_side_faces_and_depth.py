"""What side faces and thickness add: ends and their weights, chains of images, series, and depths."""

import dataclasses
import math

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.bodies.depths import REFERENCES, plane_strain_depth
from nonhertz.bodies.ends import ends
from nonhertz.bodies.images import ALL_LINKS, SEPARATE_LINKS
from nonhertz.bodies.influence import Influence, influence_of
from nonhertz.bodies.shape import HERTZ
from nonhertz.model.depths import DEPTHS, Depth
from nonhertz.model.side_faces import SIDE_FACES, SideFace
from nonhertz.strip.influence import displacements

EDGES = np.linspace(-8.0, 8.0, 25)
Y = 0.5 * (EDGES[1:] + EDGES[:-1])
STEEL = nh.Material(modulus=206000.0, poisson=0.3)


def roller(**changes):
    return nh.Roller(**({"diameter": 15.0, "length": 16.0, "material": STEEL, "side_faces": "mirror"} | changes))


def plate(**changes):
    return nh.Plate(**({"material": STEEL, "side_faces": "mirror"} | changes))


def on_plate(**changes):
    return nh.Contact(roller(**changes), plate())


def below(contact, element=nh.SEMI_ELLIPTIC):
    """Depth at Y of each body that has any."""
    return [depth.below(Y) for depth in influence_of(contact, element).references]


# Ends

STIFF = plate(material=nh.Material(3.0 * STEEL.modulus, STEEL.poisson))
# y, side, weights of the images in both bodies, and kappa; equal materials have half of the compliance each.
ENDS = {
    "one body that ends": (on_plate(), [(-8.0, -1, (1.0, 0.0), 0.5), (8.0, 1, (1.0, 0.0), 0.5)]),
    # K ~ (1 - nu^2) / E: 0.91 / 206 against 0.91 / 618, three quarters of both.
    "of another share": (nh.Contact(roller(), STIFF), [(-8.0, -1, (1.0, 0.0), 0.75), (8.0, 1, (1.0, 0.0), 0.75)]),
    "the other body": (nh.Contact(STIFF, roller()), [(-8.0, -1, (0.0, 1.0), 0.75), (8.0, 1, (0.0, 1.0), 0.75)]),
    "different lengths": (
        nh.Contact(roller(), plate(length=24.0, position=1.0, side_faces=(0.5, "calibrated"))),
        [
            (-8.0, -1, (1.0, 0.0), 0.5), (-11.0, -1, (0.0, 0.5), 0.25),
            (8.0, 1, (1.0, 0.0), 0.5), (13.0, 1, (0.0, 1.6), 0.8),
        ],
    ),
    "none freed": (on_plate(side_faces="none"), []),
    "one freed": (on_plate(side_faces=("none", "mirror")), [(8.0, 1, (1.0, 0.0), 0.5)]),
    "one weighed": (on_plate(side_faces=(0.3, 0)), [(-8.0, -1, (0.3, 0.0), 0.15)]),
    "no body that ends": (nh.Contact(nh.Body(diameter=15.0), plate()), []),
    # Ends are faces, not where contact ends.
    "moved": (
        on_plate(position=2.0, effective_length=10.0), [(-6.0, -1, (1.0, 0.0), 0.5), (10.0, 1, (1.0, 0.0), 0.5)]
    ),
    # Alone, a heavy face keeps its weight up to kappa = 1.
    "heavy": (on_plate(side_faces=1.999), [(-8.0, -1, (1.999, 0.0), 0.9995), (8.0, 1, (1.999, 0.0), 0.9995)]),
    "apart": (
        nh.Contact(roller(), plate(length=16.0, position=1.7e-5)),
        [
            (-8.0, -1, (1.0, 0.0), 0.5), (-8.0 + 1.7e-5, -1, (0.0, 1.0), 0.5),
            (8.0, 1, (1.0, 0.0), 0.5), (8.0 + 1.7e-5, 1, (0.0, 1.0), 0.5),
        ],
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", ENDS)
def test_every_freed_face_is_an_end_with_the_weights_of_its_body(name):
    contact, expected = ENDS[name]
    found = ends(contact)
    assert [end[:3] for end in expected] == [(end.y, end.side, end.weights) for end in found]
    assert [end[3] for end in expected] == pytest.approx([end.image_weight for end in found], rel=1e-12)
    assert all(end.free == 0.0 for end in found)


@pytest.mark.parametrize("shift", [0.0, 1.4e-5, -1.4e-5])
def test_coincident_faces_are_one_end_with_the_weights_of_both(shift):
    # To a ten-thousandth of 0.02 of the combined radius of 7.5 mm, 1.5e-5.
    low, high = ends(nh.Contact(roller(), plate(length=16.0, position=shift)))
    assert (low.weights, high.weights) == ((1.0, 1.0), (1.0, 1.0))
    assert (low.image_weight, high.image_weight) == (1.0, 1.0)
    assert (low.y, high.y) == pytest.approx((-8.0 + 0.5 * shift, 8.0 + 0.5 * shift), rel=1e-12)


@pytest.mark.parametrize(
    ("apart", "kappa"), [(0.0, 1.0), (0.0375, 4.0 / 7.0), (0.075, 2.0 / 3.0), (0.15, 0.8), (1.0, 0.8)]
)
def test_heavy_faces_a_little_apart_are_lowered_by_as_much_as_they_are_near(apart, kappa):
    # Of kappa = 0.8 each, the other counts less with the distance and not at all from 0.02 of the radius, 7.5 mm, on.
    heavy = {"side_faces": "calibrated"}
    found = [
        end for end in ends(nh.Contact(roller(**heavy), plate(length=16.0 + 2.0 * apart, **heavy))) if end.side > 0
    ]
    assert [end.image_weight for end in found] == pytest.approx([kappa] * len(found), rel=1e-12)
    assert len(found) == (1 if apart == 0.0 else 2)


@pytest.mark.parametrize(
    ("of_a", "of_b", "wanted", "used"),
    [
        ("calibrated", "calibrated", 1.6, (1.0, 1.0)),
        ("calibrated", 0.8, 1.2, (1.6 / 1.2, 0.8 / 1.2)),
        (3.0, "none", 1.5, (2.0, 0.0)),
        ("mirror", "mirror", 1.0, (1.0, 1.0)),
        (1.5, 0.3, 0.9, (1.5, 0.3)),
    ],
)
def test_weights_are_lowered_in_proportion_to_kappa_one(of_a, of_b, wanted, used):
    for end in ends(nh.Contact(roller(side_faces=of_a), plate(length=16.0, side_faces=of_b))):
        assert end.requested == pytest.approx(wanted, rel=1e-12)
        assert end.weights == pytest.approx(used, rel=1e-12)
        assert end.image_weight == pytest.approx(min(wanted, 1.0), rel=1e-12)


# Images


@pytest.mark.parametrize("element", [nh.SEMI_ELLIPTIC, nh.PARABOLIC], ids=lambda e: e.name)
def test_a_mirrored_face_is_free_of_shear(element):
    # A load and its image are even about the face: the surface of the body that ends there has no slope across it.
    # The body alone, on a counterpart that is almost rigid.
    rigid = plate(material=nh.Material(1e15 * STEEL.modulus, STEEL.poisson))
    influence = influence_of(nh.Contact(roller(), rigid), element)
    r, m = np.zeros(Y.size), np.full(Y.size, 0.04)
    r[3] = 0.1
    at = np.array([-8.0 - 1e-3, -8.0, -8.0 + 1e-3])
    before, here, after = displacements(influence, at, EDGES, r, m, element)
    # The strip alone has a slope of 1.4 times its displacement over the distance of 2.3 mm. The image about the other
    # face, 30 mm away, leaves 2e-4 of that.
    assert abs(after - before) < 1e-3 * abs(2e-3 * here / 2.3)


# Series


def displacement(influence, q, element=nh.SEMI_ELLIPTIC):
    m = np.full(Y.size, 0.04)
    return displacements(influence, Y, EDGES, q / m, m, element)


# 100 images per face leave (16.5 / 200)^2 of what the far ones add. To one side alone they are also as far off as
# the loads lie from the middle, in the first order.
@pytest.mark.parametrize(
    ("side_faces", "within"),
    [("mirror", 0.01), (1.6, 0.01), ((0.97, 1.0), 0.01), ((0.5, 1.6), 0.04)],
    ids=["mirror", "heavy", "light", "unlike"],
)
@pytest.mark.parametrize("depth", ["plane-strain", 3.0, 40.0])
def test_a_series_is_what_many_images_add_up_to(side_faces, within, depth):
    body = {"side_faces": side_faces, "depth": depth, "position": 0.5}
    series = influence_of(on_plate(images="series", **body), nh.SEMI_ELLIPTIC)
    explicit = influence_of(on_plate(images=100, **body), nh.SEMI_ELLIPTIC)
    # A lopsided load, so that places and strips are told apart.
    load = np.linspace(0.5, 1.5, Y.size)
    exact, found = displacement(explicit, load), displacement(series, load)
    nearest_only = Influence(series.terms, tuple(dataclasses.replace(part, far=None) for part in series.references))
    far = np.max(np.abs(displacement(nearest_only, load) - exact))
    assert far > 1e-9 * np.max(exact)
    assert np.max(np.abs(found - exact)) < within * far


# Depths


def test_a_roller_on_a_plate_has_one_depth_of_its_own():
    (depth,) = influence_of(on_plate(), nh.SEMI_ELLIPTIC).references
    assert depth.poisson_factor == pytest.approx(1.0 / 1.4, rel=1e-14)
    # The roller's half of the compliance, directly and in both images.
    table = {(sign, offset): weight for sign, offset, weight in depth.terms.tolist()}
    assert table == pytest.approx(dict.fromkeys([(1.0, 0.0), (-1.0, -16.0), (-1.0, 16.0)], 0.5), rel=1e-12)


@pytest.mark.parametrize("poisson", [0.0, 0.3, 0.45])
def test_depth_of_a_long_cylinder_in_plane_strain(poisson):
    semi_elliptic = math.exp(-0.5 + poisson / (2.0 * (1.0 - poisson)))
    parabolic = math.sqrt(6.0) * math.exp(-11.0 / 6.0 + 1.0 / (2.0 * (1.0 - poisson)))
    assert plane_strain_depth(nh.SEMI_ELLIPTIC, poisson) == pytest.approx(semi_elliptic, rel=1e-14)
    assert plane_strain_depth(nh.PARABOLIC, poisson) == pytest.approx(parabolic, rel=1e-14)


@pytest.mark.parametrize(
    ("contact", "depths"),
    [
        (on_plate(depth="none"), []),
        (on_plate(depth="diameter"), [15.0]),
        (on_plate(depth=4.0), [4.0]),
        (nh.Contact(roller(depth=4.0), nh.Ring(diameter=-60.0, depth=5.0)), [4.0, 5.0]),
        (nh.Contact(roller(depth="diameter"), nh.Ring(diameter=60.0, depth="diameter")), [15.0, 60.0]),
        (nh.Contact(roller(depth="none"), plate(depth=7)), [7.0]),
    ],
)
def test_depths_below_the_surface(contact, depths):
    expected = np.tile(np.array(depths).reshape(-1, 1), Y.size)
    np.testing.assert_allclose(np.array(below(contact)).reshape(expected.shape), expected, rtol=1e-15, atol=0.0)


@pytest.mark.parametrize(("depth", "factor"), [("diameter", 1.0), ("plane-strain", 0.75148)])
def test_depth_follows_a_tapered_diameter(depth, factor):
    taper = nh.TabulatedDiameter((-8.0, 8.0), (14.0, 18.0))
    (found,) = below(on_plate(diameter=taper, position=1.0, depth=depth))
    expected = factor * np.clip(16.0 + 0.25 * (Y - 1.0), 14.0, 18.0)
    np.testing.assert_allclose(found, expected, rtol=1e-5, atol=0.0)


def test_the_depth_of_plane_strain_is_one_whatever_shape_the_pressure_is_counted_with():
    of_hertz = [plane_strain_depth(HERTZ, poisson) for poisson in (0.0, 0.3, 0.5)]
    of_strips = [plane_strain_depth(nh.SEMI_ELLIPTIC, poisson) for poisson in (0.0, 0.3, 0.5)]
    np.testing.assert_allclose(of_hertz, of_strips, rtol=1e-12)


def test_images_too_far_to_be_told_apart_are_those_of_an_endless_series():
    """Against the same sum of line loads at multiples of the length, to a hundred times as many links."""
    length, depth, factor = 16.0, 5.0, 1.0 / (2.0 * (1.0 - STEEL.poisson))
    (below,) = influence_of(on_plate(depth=depth, images="series"), nh.SEMI_ELLIPTIC).references
    distance = length * (np.arange(SEPARATE_LINKS, 100 * ALL_LINKS) + 1.0)
    square = distance**2 + depth**2
    kernel = 1.0 / distance - 1.0 / np.sqrt(square) - factor * depth**2 / square**1.5
    # The roller has half of the compliance. Links go to either side.
    expected = 2.0 * 0.5 * kernel.sum()
    strip = np.zeros(1), np.array([-0.5, 0.5])
    found = dataclasses.replace(below, far=None).displacement(*strip) - below.displacement(*strip)
    np.testing.assert_allclose(found, [[expected]], rtol=1e-6)


# Treatments of one's own: a side face and a reference are in solver, stress, case files and messages at once


class OnSprings:
    """A bed of springs in place of half-spaces' depth: a matrix that knows nothing of points below the surface."""

    def below(self, y):
        return np.full(y.shape, np.inf)

    def displacement(self, y, edges):
        at = (y[..., None] > edges[..., None, :-1]) & (y[..., None] < edges[..., None, 1:])
        return -np.where(at, SINKS, 0.0)


SINKS = 3.0  # each spring, under K q


def test_a_side_face_of_ones_own_is_a_word_everywhere(monkeypatch, tmp_path):
    monkeypatch.setitem(SIDE_FACES, "halved", SideFace("halved", "by images of half the pressure", 0.5))
    halved, weighted = (nh.solve(on_plate(side_faces=rule), load=5e3, strips=21) for rule in ("halved", 0.5))
    np.testing.assert_array_equal(halved.line_load, weighted.line_load)
    assert halved.edge_pressure[0].image_weight == 0.25
    below, same = (nh.subsurface.stress(solution, 0.0, 7.9, 0.1).von_mises for solution in (halved, weighted))
    np.testing.assert_array_equal(below, same)
    case = nh.Case(on_plate(side_faces="halved"), {"load": 5e3})
    case.write(tmp_path / "case.toml")
    assert nh.read_case(tmp_path / "case.toml").contact == case.contact


def test_a_reference_of_ones_own_moves_the_surface_by_its_matrix(monkeypatch):
    monkeypatch.setitem(DEPTHS, "springs", Depth("springs", "on springs", "a bed of springs"))
    monkeypatch.setitem(REFERENCES, "springs", lambda *_: OnSprings())
    solution = nh.solve(on_plate(depth="springs"), load=5e3, strips=21)
    influence = influence_of(on_plate(depth="none"), nh.SEMI_ELLIPTIC)
    K, element = solution.contact.compliance, nh.SEMI_ELLIPTIC
    m = (solution.half_width / element.hertz_ratio) ** 2
    r = K * solution.line_load / m
    risen = displacements(influence, solution.y, solution.edges, r, m, element)
    expected = risen + SINKS * K * solution.line_load
    np.testing.assert_allclose(solution.interference, expected, rtol=1e-8)


def bonded(k, poisson):
    """Compliance of a layer of thickness 1 on a rigid seat, over that of a half-space, for waves of wave number k."""
    kappa = 3.0 - 4.0 * poisson
    return (2.0 * kappa * np.sinh(2.0 * k) - 4.0 * k) / (2.0 * kappa * np.cosh(2.0 * k) + 4.0 * k**2 + 1.0 + kappa**2)


def sliding(k, poisson):
    """The same without friction on the seat."""
    return (np.cosh(2.0 * k) - 1.0) / (np.sinh(2.0 * k) + 2.0 * k)


@pytest.mark.parametrize(("seat", "times"), [(bonded, 1.21), (sliding, 1.44)])
def test_a_layer_on_a_seat_moves_as_with_the_depth_that_is_documented(seat, times):
    # K. L. Johnson, Contact Mechanics, section 5.8. Under a long load 2 K q times the integral over k of compliance
    # times the load's transform over k; the same of a half-space against a point at depth 1 is 1 - exp(-k) and a
    # constant.
    poisson = 0.3
    node, weight = np.polynomial.legendre.leggauss(400)
    k, share = 15.0 * (1.0 + node), 15.0 * weight
    softer = share @ ((seat(k, poisson) - 1.0 + np.exp(-k)) / k)
    # The package's own half-space: its displacement under a long load grows with the logarithm of the depth.
    edges, square = np.linspace(-400.0, 400.0, 801), np.full(800, 0.01)

    def moved(depth):
        body = nh.Plate(material=nh.Material(206000.0, poisson), depth=depth)
        influence = influence_of(
            nh.Contact(nh.Body(diameter=20.0, material=body.material, depth=depth), body), nh.SEMI_ELLIPTIC
        )
        return displacements(influence, np.zeros(1), edges, 1.0 / square, square, nh.SEMI_ELLIPTIC)[0]

    layer = moved(1.0) + 2.0 * (softer + 1.0 / (2.0 * (1.0 - poisson)))
    assert moved(times) == pytest.approx(layer, rel=3e-3)
    assert abs(moved(1.0) / layer - 1.0) > 0.03
