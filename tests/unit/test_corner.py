"""Corners between surface and side faces: their shape, what they refuse, and what grids make of them."""

import math

import numpy as np
import pytest
from scipy.optimize import brentq

import nonhertz as nh
from nonhertz.model.corner import Cornered, Rounded
from nonhertz.result.ends import corner_ends

CROWN = nh.profile.crown(radius=3000.0)
CHAMFER = nh.Chamfer(length=1.0, angle=math.radians(15.0), blend_radius=2.0)


def roller(**changes):
    return nh.Roller(
        **{"diameter": 15.0, "length": 20.0, "profile": CROWN, "corner_radius": 0.5, "side_faces": "mirror"} | changes
    )


def test_the_length_includes_the_corner_and_the_profile_ends_where_it_begins():
    body = roller()
    assert body.interval == (-10.0, 10.0)
    on_land = np.linspace(-9.5, 9.5, 21)
    np.testing.assert_array_equal(body.relief(on_land), CROWN.relief(on_land))
    assert body.bends == (-9.5, 9.5)


@pytest.mark.parametrize("side", [-1.0, 1.0])
def test_a_rounded_corner_goes_on_with_the_slope_of_the_profile(side):
    body, distance = roller(), np.array([0.0, 0.1, 0.3, 0.5])
    slope = 9.5 / math.sqrt(3000.0**2 - 9.5**2)
    circle = 0.5 - np.sqrt(0.25 - distance**2)
    expected = float(CROWN.relief(9.5)) + slope * distance + circle
    np.testing.assert_allclose(body.relief(side * (9.5 + distance)), expected, rtol=1e-9)


def test_a_corner_of_a_moved_body_moves_with_it():
    moved = roller(position=3.0)
    np.testing.assert_allclose(moved.relief([-6.8, 12.8]), roller().relief([-9.8, 9.8]), rtol=1e-12)
    assert moved.bends == (-6.5, 12.5)
    assert moved.interval == (-7.0, 13.0)


def test_a_chamfer_begins_with_an_arc_and_ends_straight():
    arc = 2.0 * math.sin(CHAMFER.angle)
    distance = np.array([0.0, 0.2, arc, 0.8, 1.0])
    expected = np.where(
        distance <= arc,
        2.0 - np.sqrt(4.0 - np.minimum(distance, arc) ** 2),
        2.0 * (1.0 - math.cos(CHAMFER.angle)) + (distance - arc) * math.tan(CHAMFER.angle),
    )
    np.testing.assert_allclose(CHAMFER.drop(distance), expected, rtol=1e-12)
    body = roller(corner_radius=None, chamfer=CHAMFER, profile=nh.profile.straight())
    np.testing.assert_allclose(body.relief(9.0 + distance), expected, rtol=1e-9, atol=1e-15)
    np.testing.assert_allclose(body.bends, [-9.0 - arc, -9.0, 9.0, 9.0 + arc])


def test_a_chamfer_without_a_blend_is_an_edge():
    body = roller(corner_radius=None, chamfer=nh.Chamfer(length=1.0, angle=0.3), profile=nh.profile.straight())
    np.testing.assert_allclose(body.relief([9.0, 9.5]), [0.0, 0.5 * math.tan(0.3)], rtol=1e-12)
    solution = _quiet(nh.Contact(body, nh.Ring(diameter=80.0)))
    assert [end.kind for end in solution.singular_ends] == [nh.EdgeKind.CORNER] * 2


def _quiet(contact, **load):
    with pytest.warns(nh.AccuracyWarning):
        return nh.solve(contact, **{"load": 20e3} | load)


def test_bends_of_the_profile_beyond_the_land_are_not_there():
    profile = nh.profile.partial_crown(radius=500.0, straight=19.4)
    assert roller(profile=profile).bends == (-9.5, 9.5)
    assert roller(profile=profile, corner_radius=0.2).bends == (-9.8, -9.7, 9.7, 9.8)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: roller(corner_radius=10.0), "length = 20.0 must leave a land"),
        (lambda: roller(chamfer=CHAMFER), "corner_radius = 0.5 must not be given together with chamfer"),
        (lambda: roller(effective_length=18.0), "corner_radius = 0.5 must not be given together with effective_length"),
        (lambda: nh.Plate(corner_radius=0.5), "length must be given where corner_radius is"),
        (lambda: roller(corner_radius=None, chamfer=0.5), "chamfer = 0.5 must be a Chamfer"),
        (lambda: roller(profile=nh.profile.tabulated([-5.0, 5.0], [0.0, 0.0])), "must reach both ends of the land, y "),
        (lambda: nh.Chamfer(length=1.0, angle=1.6), "angle = 1.6 must lie between 0 and pi / 2"),
        (lambda: nh.Chamfer(length=1.0, angle=0.3, blend_radius=4.0), "blend_radius = 4.0 must leave the arc"),
    ],
)
def test_impossible_corners_are_refused(make, message):
    with pytest.raises(nh.InputError) as refused:
        make()
    assert message in str(refused.value)


def test_contacts_end_within_the_corner_and_their_pressure_has_a_limit():
    contact = nh.Contact(roller(), nh.Ring(diameter=80.0, depth=10.0))
    found = [nh.solve(contact, load=30e3, tilt=5.8e-4, accuracy=accuracy) for accuracy in (1e-4, 1e-5)]
    for solution in found:
        assert [edge.kind for edge in solution.edge_pressure] == [nh.EdgeKind.RUN_OUT] * 2
        assert 9.5 < solution.contact_y[-1][1] < 9.6
        assert 9.5 < solution.max_pressure_y < 9.55
        assert not corner_ends(contact, solution.edges, solution.centre_pressure, solution.half_width)
    coarse, fine = found
    assert coarse.max_pressure == pytest.approx(fine.max_pressure, rel=coarse.error_estimate.max_pressure)
    assert coarse.max_pressure == pytest.approx(fine.max_pressure, rel=5e-3)
    assert coarse.approach == pytest.approx(fine.approach, rel=1e-4)


@pytest.mark.parametrize(("next_to_it", "beside", "ends"), [(120.0, 130.0, (9.0,)), (130.0, 120.0, ())])
def test_a_contact_round_a_corner_ends_there_only_if_its_pressure_rises_towards_it(next_to_it, beside, ends):
    body = roller(corner_radius=None, chamfer=nh.Chamfer(length=1.0, angle=0.3), profile=nh.profile.straight())
    edges = np.array([8.6, 8.7, 8.8, 8.9, 9.0, 9.02])
    pressure = np.array([100.0, 110.0, next_to_it, beside, 90.0])
    assert corner_ends(nh.Contact(body, nh.Plate()), edges, pressure, np.full(5, 0.4)) == ends


def test_a_surface_with_corners_adds_and_shifts_like_any_profile():
    surface = Cornered(CROWN, 10.0, Rounded(0.5))
    np.testing.assert_allclose(surface.shifted(1.0).relief([10.6]), surface.relief([9.6]), rtol=1e-12)
    np.testing.assert_allclose(surface.scaled(2.0).relief([9.8]), 2.0 * surface.relief([9.8]), rtol=1e-12)


def iso(y):
    """ISO 16281 for a diameter of 10 and an effective length of 9.4 mm."""
    return -0.0035 * math.log(1.0 - (y / 4.7) ** 2)


def test_a_logarithm_over_the_land_continues_along_its_tangent_where_it_becomes_an_edge():
    body = nh.Roller(diameter=10.0, length=10.0, corner_radius=0.3, profile=nh.profile.iso_logarithmic(10.0, 9.4))
    edge = brentq(lambda y: 2.0 * 0.0035 * (4.7**2 + y**2) / (4.7**2 - y**2) ** 2 - 10.0 / 0.3, 4.0, 4.7 - 1e-9)
    slope = 2.0 * 0.0035 * edge / (4.7**2 - edge**2)
    y = np.array([0.0, 3.0, 4.68, edge])
    np.testing.assert_allclose(body.relief(y), [iso(place) for place in y], rtol=1e-5)
    assert float(body.relief(4.7)) == pytest.approx(iso(edge) + slope * (4.7 - edge), rel=3e-4)
    assert float(body.relief(5.0)) == pytest.approx(iso(edge) + slope * (5.0 - edge) + 0.3, rel=3e-4)
    assert body.land == (-4.7, 4.7)
    np.testing.assert_allclose(body.bends, [-4.7, -edge, edge, 4.7], rtol=2e-6)


@pytest.mark.parametrize("corner", [{"corner_radius": 0.3}, {"chamfer": nh.Chamfer(length=0.3, angle=0.3)}])
@pytest.mark.parametrize("side", [-1.0, 1.0])
@pytest.mark.parametrize(
    "profile",
    [
        nh.profile.iso_logarithmic(10.0, 9.4),
        nh.profile.iso_tapered(10.0, 9.0),  # ends within the land
        nh.profile.iso_logarithmic(10.0, 9.5),  # would end on the corner
        nh.profile.iso_logarithmic(10.0, 9.4).shifted(0.2) + nh.profile.conical(1e-3),
        nh.profile.iso_logarithmic(10.0, 9.4).scaled(-1.0),
        nh.profile.fujiwara_kawase(load=2e3, length=9.4, k2=0.2, zm=0.5),
        nh.profile.crown(radius=4.65),
    ],
)
def test_a_surface_with_corners_is_finite_up_to_the_faces_and_smooth_up_to_the_land_s_ends(profile, side, corner):
    body = nh.Body(diameter=10.0, length=10.0, profile=profile, **corner)
    assert np.all(np.isfinite(body.relief(np.linspace(-5.0, 5.0, 2001))))
    # A kink is a change of slope that does not vanish with the step, as that by the largest curvature does.
    y, step = side * np.concatenate([np.linspace(4.2, 4.69, 50), np.linspace(4.69, 4.6999, 400)]), 2e-6
    below, at, above = (body.relief(y + by) for by in (-step, 0.0, step))
    assert np.abs(above - 2.0 * at + below).max() / step < 0.01


@pytest.mark.parametrize("scale", [1e-3, 0.5, 7.0, 1e3])
@pytest.mark.parametrize(
    ("diameter", "length", "radius", "profile", "parameters"),
    [
        (180.0, 28.0, 1.2, nh.profile.crown, (90.0,)),
        (10.0, 10.0, 0.3, nh.profile.iso_logarithmic, (10.0, 9.4)),
        (10.0, 10.0, 0.3, nh.profile.iso_logarithmic, (10.0, 9.0)),
        (10.0, 10.0, 0.3, nh.profile.crown, (4.75,)),
    ],
)
def test_a_body_n_times_as_large_has_n_times_the_relief(diameter, length, radius, profile, parameters, scale):
    def of_size(n):
        made = profile(*(n * parameter for parameter in parameters))
        return nh.Body(diameter=n * diameter, length=n * length, corner_radius=n * radius, profile=made)

    # Where the tangents of an edge begin is found by differences.
    y = np.linspace(-0.5, 0.5, 401) * length
    np.testing.assert_allclose(of_size(scale).relief(scale * y), scale * of_size(1.0).relief(y), rtol=1e-5)


def test_what_stops_before_the_land_ends_is_refused_at_any_size():
    for scale in (1e-3, 1.0, 1e3):
        short = nh.profile.tabulated([-4.6 * scale, 4.6 * scale], [0.0, 0.0])
        with pytest.raises(nh.InputError, match="must reach both ends of the land, y = -"):
            nh.Body(length=10.0 * scale, corner_radius=0.3 * scale, profile=short)


@pytest.mark.parametrize("interpolation", ["pchip", "linear", "cubic"])
def test_a_rough_table_that_stops_before_the_land_ends_is_no_edge(interpolation):
    # Its curvature between the steps of differences is as large as that of a logarithm at its end.
    rng = np.random.default_rng(7)
    for length in 10.0 ** rng.uniform(-6.0, 0.9, 30):
        y, relief = np.linspace(-0.5, 0.5, 6) * length, 10.0 ** rng.uniform(-9.0, -2.0) * rng.random(6)
        short = nh.profile.tabulated(y, relief, interpolation).shifted(0.1)
        with pytest.raises(nh.InputError, match="must reach both ends of the land"):
            nh.Body(length=10.0, corner_radius=0.3, profile=short)


def test_the_profile_of_iso_16281_over_the_land_has_no_spike_at_its_end():
    ring = nh.Ring(diameter=40.0, length=14.0)
    profile = nh.profile.iso_logarithmic(10.0, 9.4)
    with_corner, without = (
        nh.solve(
            nh.Contact(nh.Roller(diameter=10.0, length=10.0, profile=profile, **corner), ring), load=4e3, tilt=2.9e-4
        )
        for corner in ({"corner_radius": 0.3}, {})
    )
    assert abs(with_corner.max_pressure_y) < 2.0
    assert with_corner.max_pressure == pytest.approx(without.max_pressure, rel=1e-9)
