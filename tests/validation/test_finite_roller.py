"""A whole roller against three-dimensional finite elements."""

import json
import math
from pathlib import Path

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.bodies.influence import HALF_SPACE, Influence, influence_of
from nonhertz.strip.influence import displacements

REFERENCE = json.loads((Path(__file__).parent / "data" / "finite-roller.json").read_text(encoding="utf-8"))
CASES = {case["id"]: case for case in REFERENCE["cases"]}
LOADS = {
    "1": lambda y: np.full_like(y, 1e3),
    "2": lambda y: np.where(np.abs(y) < 8.0, 1e3, 0.0),
    "4": lambda y: 100.0 * y,
    "5-0": lambda y: np.where(np.abs(y) < 0.25, 1e3, 0.0),
    "5-9.75": lambda y: np.where(y > 9.5, 1e3, 0.0),
    "6-0.0": lambda y: np.full_like(y, 1e3),
    "8": lambda y: np.full_like(y, 1e3),
}
EDGES = np.unique(
    np.concatenate([
        np.linspace(-10.0, 10.0, 161), [-9.5, -8.0, -0.25, 0.25, 8.0, 9.5],
        *(sign * (10.0 - np.geomspace(0.005, 0.12, 14)) for sign in (-1.0, 1.0)),
    ])
)  # fmt: skip


def moved(case):
    """Displacement of the roller's surface under the reference's load [mm], and the reference."""
    material = nh.Material(206000.0, case["nu"])
    roller = nh.Roller(diameter=20.0, length=case["L"], material=material, side_faces="free", depth="finite")
    influence = influence_of(nh.Contact(roller, nh.Plate(material=material)), nh.SEMI_ELLIPTIC)
    y, square = np.array(case["y"]), np.full(EDGES.size - 1, case["b"] ** 2)
    ratio = LOADS[case["id"]](0.5 * (EDGES[1:] + EDGES[:-1])) / square
    both = displacements(influence, y, EDGES, ratio, square, nh.SEMI_ELLIPTIC)
    plate = displacements(Influence(HALF_SPACE), y, EDGES, ratio, square, nh.SEMI_ELLIPTIC)
    compliance = (1.0 - case["nu"] ** 2) / (math.pi * 206000.0)
    return compliance * (both - 0.5 * plate) / 0.5, np.array(case["w"]), y


@pytest.mark.parametrize("case", ["1", "6-0.0", "8"])
def test_a_uniform_load_compresses_the_roller_as_elements_say(case):
    found, expected, _ = moved(CASES[case])
    # Half-widths of 0.05 and 0.02 radii, in place of 0.03.
    np.testing.assert_allclose(found, expected, rtol=2e-3)


@pytest.mark.parametrize("case", ["2", "4", "5-0", "5-9.75"])
def test_uneven_loads_move_the_surface_as_elements_say(case):
    found, expected, _ = moved(CASES[case])
    np.testing.assert_allclose(found, expected, atol=1.5e-3 * np.abs(expected).max())


def test_the_compliance_against_tilting():
    found, expected, y = moved(CASES["4"])
    assert np.trapezoid(found * y, y) == pytest.approx(np.trapezoid(expected * y, y), rel=1e-3)


def test_a_long_roller_is_compressed_as_in_plane_strain_and_grows_longer():
    # Johnson's compression of a long cylinder, and what a roller that is free to grow longer adds.
    poisson, half_width = 0.3, 0.3
    material = nh.Material(206000.0, poisson)
    roller = nh.Roller(diameter=20.0, length=160.0, material=material, side_faces="free", depth="finite")
    influence = influence_of(nh.Contact(roller, nh.Plate(material=material)), nh.SEMI_ELLIPTIC)
    edges, square = np.linspace(-80.0, 80.0, 641), np.full(640, half_width**2)
    both, plate = (
        displacements(each, np.zeros(1), edges, 1.0 / square, square, nh.SEMI_ELLIPTIC)[0]
        for each in (influence, Influence(HALF_SPACE))
    )
    expected = 2.0 * math.log(40.0 / half_width) - 1.0 + 2.0 * poisson**2 / (1.0 - poisson**2)
    assert (both - 0.5 * plate) / 0.5 == pytest.approx(expected, rel=2e-3)
