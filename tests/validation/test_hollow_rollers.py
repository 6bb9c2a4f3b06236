"""Stress in hollow rollers, whose walls bend, against finite elements and a curved beam."""

from pathlib import Path

import numpy as np
import pytest
from hollow_roller_elements import POINTS, solutions

import nonhertz as nh
from nonhertz.life.volume import section_exposure
from nonhertz.strength import assess
from nonhertz.subsurface import extremes, stress
from nonhertz.subsurface.rolling import revolution

DATA = Path(__file__).parent / "data"

pytestmark = pytest.mark.filterwarnings("ignore::nonhertz.AccuracyWarning")


def solved(diameter, bore, load, *, radius=None, length=None, options=None, **material):
    profile = nh.profile.straight() if radius is None else nh.profile.crown(radius=radius)
    steel = nh.Material(206e3, 0.3, **material)
    roller = nh.Roller(diameter=diameter, length=length or diameter, bore=bore, profile=profile, material=steel)
    return nh.solve(nh.Contact(roller, nh.Ring(diameter=4.0 * diameter)), load=load, **(options or {}))


# D, bore and load; von Mises stress at the bore under the load in the middle, at half and at 0.98 of the half-length,
# in the middle of the wall, and at the bore at 90 degrees: spectral elements of degree 7 with up to 110 waves around.
ELEMENTS = [
    ((20, 16, 4e3), {"radius": 4e3}, (868, 828, 696, 67.8, 535)),
    ((20, 14, 7e3), {"radius": 4e3}, (647, 615, 550, 99.7, 446)),
    ((20, 10, 20e3), {"radius": 4e3}, (589, 581, 570, 200, 528)),
    ((40, 28, 25e3), {"radius": 8e3}, (582, 549, 486, 91.4, 399)),
]


@pytest.mark.parametrize(("sizes", "more", "expected"), ELEMENTS)
def test_wall_bends_as_by_spectral_elements(sizes, more, expected):
    solution = solved(*sizes, **more)
    outer, inner, half = 0.5 * sizes[0], 0.5 * sizes[1], 0.5 * sizes[0]
    wall = outer - inner
    y = [0.0, 0.5 * half, 0.98 * half, 0.0, 0.0]
    found = stress(solution, [0.0, 0.0, 0.0, 0.0, inner], y, [wall, wall, wall, 0.5 * wall, outer]).von_mises
    # In the middle of the wall the elements themselves are not as good.
    off = np.abs(found / expected - 1.0)
    assert np.all(off < [0.005, 0.005, 0.005, 0.02, 0.005]), off


def test_field_near_the_contact_of_a_thin_wall_is_that_of_elements():
    solution = solved(20, 16, 4e3, radius=4e3)
    b = 0.157
    found = stress(solution, [0.0, 0.87 * b, 0.0, 0.0], [0.0, 0.0, 0.0, 5.0], b * np.array([0.7, 0.5, 2.0, 1.0]))
    # Up to 1,200 waves around; without the bending 625, 526, 425 and 557.
    np.testing.assert_allclose(found.von_mises, [341.0, 753.0, 200.0, 281.0], rtol=0.01)


@pytest.mark.slow
def test_random_rollers_are_as_by_quadratic_elements():
    expected = np.loadtxt(DATA / "hollow-roller-stress.txt")
    for solution, values in zip(solutions(), expected, strict=True):
        body = solution.contact.a
        angle, place, share = np.array(POINTS).T
        y = 0.5 * body.length * place
        outer, inner = (
            0.5 * np.array([each(at) if callable(each) else each for at in y]) for each in (body.diameter, body.bore)
        )
        radius, theta = inner + share * (outer - inner), np.radians(angle)
        found = stress(solution, radius * np.sin(theta), y, outer - radius * np.cos(theta)).von_mises
        np.testing.assert_allclose(found, values, rtol=0.01, atol=0.003 * values.max())


@pytest.mark.slow
def test_long_thin_roller_is_a_curved_beam():
    """Winkler's beam under two opposite loads (Timoshenko, Strength of Materials, Part II), in plane strain."""
    load, middle, wall, inner = 40.0, 19.0, 2.0, 18.0  # N/mm and mm
    neutral = wall / np.log((inner + wall) / inner)
    eccentricity = middle - neutral
    moment = load * middle / np.pi * (1.0 - eccentricity / middle)
    hoop = moment * (neutral - inner) / (wall * eccentricity * inner)
    solution = solved(40, 36, load * 120.0, length=120.0)
    found = stress(solution, 0.0, 0.0, 2.0)
    # The load itself, which a beam does not know, takes away a few per cent under it.
    assert float(found.sigma_x) == pytest.approx(hoop, rel=0.03)
    assert float(found.sigma_y) == pytest.approx(0.3 * hoop, rel=0.1)


@pytest.mark.slow
def test_yielding_bore_is_named():
    solution = solved(20, 16, 4e3, radius=4e3, yield_strength=800.0)
    found = extremes(solution)
    assert (found.bore.y, found.bore.x) == (pytest.approx(0.0, abs=0.01), pytest.approx(0.0, abs=1e-3))
    assert found.bore.at_bore
    assert found.bore.max == pytest.approx(868.0, rel=0.005)
    sentences = assess(solution, largest=found).sentences
    assert any(each.startswith("The bore of body a yields: its largest von Mises stress, 86") for each in sentences)
    assert "at the bore, y = 0 mm and z = 2.00 mm, exceeds the yield strength of 800 MPa by 8" in " ".join(sentences)


@pytest.mark.slow
@pytest.mark.parametrize(("bore", "load"), [(16, 4e3), (14, 7e3), (12, 15e3)])
def test_volume_life_counts_all_of_the_wall(bore, load):
    """Gauss sums from surface to bore, of the largest shear at many places in a quarter of a turn."""
    solution = solved(20, bore, load, radius=2000, options={"strips": 15})
    seen = nh.life.exposure(solution)
    assert seen.width.sum() == pytest.approx(20.0, rel=1e-12)  # from face to face
    node, weight = np.polynomial.legendre.leggauss(6)
    for station in np.searchsorted(seen.y, [0.0, 5.0, 9.5]):
        b = seen.half_width[station]
        panels = np.append(
            b * np.array([0.0, 0.1, 0.3, 0.6, 1.0, 1.5, 2.5]), np.linspace(2.5 * b, 10.0 - 0.5 * bore, 5)[1:]
        )
        half = 0.5 * np.diff(panels)[:, None]
        z, height = (panels[:-1, None] + half * (1.0 + node)).reshape(-1, 1), (half * weight).ravel()
        # Next to the contact the surface is flat: points pass by on straight lines.
        steps = np.linspace(0.0, 1.0, 26)
        arc = np.concatenate([b * steps[:-1:4], b + b * steps**2, 2.0 * b + (5.0 * np.pi - 2.0 * b) * steps[1:] ** 2])
        radius = 10.0 - z
        below = np.where(arc < 1.2 * b, z, 10.0 - radius * np.cos(arc / radius))
        shear = stress(solution, radius * np.sin(arc / radius), seen.y[station], below).max_shear.max(axis=-1)
        for model in (nh.life.zaretsky(), nh.life.weibull()):
            direct = np.sum(shear**model.exponent * height)
            assert seen.density(model)[station] == pytest.approx(direct, rel=0.01)


@pytest.mark.slow
def test_lives_by_sections_take_the_whole_field_of_a_hollow_roller():
    """By sections in plane strain this one would live 50 times as long, by maximum shear."""
    solution = solved(20, 16, 4e3, radius=2000, options={"strips": 7})
    whole, sections = nh.life.exposure(solution, body="a"), section_exposure(solution, body="a")
    np.testing.assert_array_equal(sections.shear, whole.shear)


@pytest.mark.slow
def test_shear_between_arc_and_depth_vanishes_at_the_bore():
    solution = solved(20, 16, 4e3, radius=2000, options={"strips": 7})
    found = revolution(solution, 0.0, [1.0, 2.0])
    assert found.orthogonal_shear[1] < 0.03 * found.shear[1]
    # Planes that do not turn have shear there.
    assert abs(stress(solution, 8.0 * np.sin(0.3), 0.0, 10.0 - 8.0 * np.cos(0.3)).tau_xz) > 0.1 * found.shear[1]


def test_displacement_knows_no_bending():
    with pytest.raises(nh.InputError, match="displacement = True must only be requested in bodies without a bore"):
        stress(solved(20, 10, 4e3, radius=4e3), 0.0, 0.0, 0.1, displacement=True)


@pytest.mark.slow
def test_wall_between_steps_of_a_bore_is_said_to_be_unknown():
    stepped = nh.TabulatedDiameter((-10.0, -4.0, -3.9, 10.0), (12.0, 12.0, 8.0, 8.0))
    solution = solved(20, stepped, 4e3, radius=4e3, yield_strength=2000.0)
    found = assess(solution)
    assert found.sentences[1].startswith("Whether body a yields is not known: bending of the wall between steps")
    warning = "The bore of body a has steps: stress below its surface is that of a solid body"
    assert found.warnings[-1].startswith(warning)
    assert stress(solution, 0.0, 0.0, 0.1).warnings[-1].startswith(warning)
