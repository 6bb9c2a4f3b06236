"""Exactly free side faces against solutions of two half-spaces iterated, in three dimensions."""

import numpy as np
import pytest

import nonhertz as nh
from claims import free_ends
from claims.claim import pressures

pytestmark = pytest.mark.filterwarnings("ignore::nonhertz.AccuracyWarning")

MODULUS_OF_CONTACT = 1e5


def beside_a_face(*, both, poisson=0.3, **more):
    """Two cylinders that end, or one on another that goes on, in contact from y = 0 to some 14 mm."""
    material = nh.Material(2.0 * MODULUS_OF_CONTACT * (1.0 - poisson**2), poisson)
    profile = nh.profile.partial_crown(radius=2500.0, straight=26.0).shifted(-20.0)
    ends = {"length": 40.0, "position": 20.0, "side_faces": ("free", "none")}
    one = nh.Roller(diameter=400.0, material=material, depth="none", profile=profile, **ends)
    other = nh.Roller(diameter=400.0, material=material, depth="none", **ends)
    contact = nh.Contact(one, other if both else nh.Ring(diameter=400.0, material=material))
    return nh.solve(contact, load=785.4 * 14.0, **more)


@pytest.mark.parametrize(
    ("both", "expected", "within"),
    [(True, free_ends.EXACT_BOTH, (0.01, 0.005)), (False, free_ends.EXACT_ROLLER, (0.04, 0.015))],
)
def test_the_pressure_towards_free_ends(both, expected, within):
    pressure = np.array(pressures(beside_a_face(both=both, accuracy=1e-5), [*free_ends.DISTANCES, 8.0]))
    off = np.abs(pressure[:-1] / pressure[-1] / expected - 1.0)
    np.testing.assert_array_less(off, [*within, 0.005, 0.005, 0.005, 0.005])


def test_coincident_ends_press_the_less_the_more_they_bulge():
    # The end is in plane stress, the middle in plane strain: their ratio is about 1 - nu^2.
    at_end = []
    for poisson in (0.0, 0.3, 0.45):
        solution = beside_a_face(both=True, poisson=poisson)
        assert solution.edge_pressure[0].kind is nh.EdgeKind.FINITE
        at_end.append(pressures(solution, [0.1])[0] / solution.centre_pressure[-40:].max())
    assert at_end[0] > at_end[1] > at_end[2]


# On cells within what the claims allow, and closer.
@pytest.mark.parametrize(
    ("solved", "middle", "nearest", "towards_end"),
    [(free_ends.by_strips, 1e-3, 0, 5e-3), pytest.param(free_ends.on_grid, 3e-4, 1, 3e-3, marks=pytest.mark.slow)],
)
def test_straight_rollers_on_a_long_ring(solved, middle, nearest, towards_end):
    solution = solved(free_ends.STRAIGHT)
    half_width = float(np.interp(0.0, solution.y, solution.half_width))
    assert pressures(solution, [0.0])[0] == pytest.approx(free_ends.MIDDLE, rel=middle)
    places = 10.0 - half_width * np.array(free_ends.PLACES[nearest:])
    np.testing.assert_allclose(pressures(solution, places), free_ends.PRESSURES[nearest:], rtol=towards_end)
    if solved is free_ends.by_strips:
        # The other solution ends 1 to 2 % short: its bodies are cut off.
        assert solution.approach == pytest.approx(0.03469 * 1.015, rel=0.01)
        assert solved(free_ends.TILTED).moment == pytest.approx(free_ends.MOMENT, rel=0.003)


def straight(side_faces="free"):
    steel = nh.Material(206000.0, 0.3)
    roller = nh.Roller(diameter=20.0, length=20.0, material=steel, side_faces=side_faces, depth="none")
    return nh.Contact(roller, nh.Ring(diameter=80.0, material=steel))


def test_free_ends_are_softer_than_mirrored_and_stiffer_than_nothing_on_one_side_or_both():
    faces = ("mirror", "calibrated", "free", ("free", "mirror"))
    mirror, calibrated, free, one_sided = (nh.solve(straight(each), load=20e3) for each in faces)
    assert mirror.approach < calibrated.approach < free.approach
    assert mirror.approach < one_sided.approach < free.approach
    assert free.moment == pytest.approx(0.0, abs=1.0)
    assert one_sided.edge_pressure[0].exponent == free.edge_pressure[0].exponent
    assert one_sided.edge_pressure[1].exponent == mirror.edge_pressure[1].exponent


def test_strength_and_exponent_describe_the_pressure_near_a_free_end():
    solution = nh.solve(straight(), load=20e3, accuracy=1e-5)
    edge = solution.edge_pressure[1]
    distance = 10.0 - solution.y[::-1]
    near = (distance < 0.5 * solution.half_width[-1]) & (np.arange(distance.size) > 0)
    np.testing.assert_allclose(edge.at(distance[near]), solution.centre_pressure[::-1][near], rtol=0.025)
    assert edge.exponent == pytest.approx(0.22599, abs=1e-5)
