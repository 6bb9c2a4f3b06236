"""A cylinder of infinite length: its modes, and how far its surface moves."""

import math

import numpy as np
import pytest
from scipy import special

import nonhertz as nh
from nonhertz.bodies import endless_cylinder
from nonhertz.bodies.depths import AxisOfCylinder, EvenDepth
from nonhertz.bodies.influence import HALF_SPACE, influence_of
from nonhertz.strip.influence import displacements


@pytest.mark.parametrize(
    ("poisson", "n", "k", "expected"),
    [
        # From the same potentials by other hands (depth.md).
        (0.3, 0, 1.0, 0.3819), (0.3, 2, 0.5, 0.55977), (0.3, 4, 2.0, 0.22638), (0.3, 10, 3.0, 0.09449),
        (0.0, 0, 1.0, 0.49543), (0.0, 2, 0.5, 0.49617), (0.0, 4, 2.0, 0.21986), (0.0, 10, 3.0, 0.09297),
    ],
)  # fmt: skip
def test_modes(poisson, n, k, expected):
    assert endless_cylinder.modes(np.array([k]), max(n, 2), poisson)[n // 2, 0] == pytest.approx(expected, abs=6e-6)


@pytest.mark.parametrize("poisson", [0.0, 0.3, 0.49])
def test_modes_of_short_waves_are_those_of_a_half_space(poisson):
    found = endless_cylinder.modes(np.array([60.0]), 100, poisson)[::10, 0]
    np.testing.assert_allclose(found, 1.0 / np.hypot(60.0, np.arange(0, 101, 20)), rtol=0.02)


def test_the_difference_to_a_half_space():
    found = math.pi * endless_cylinder.difference_spectrum(np.array([0.1, 0.5, 1.0, 2.0, 4.0]), 0.3)
    np.testing.assert_allclose(found, [-2.6276, -1.0454, -0.4400, -0.0607, 0.0120], atol=6e-5)


def test_an_even_load_moves_the_surface_as_the_sum_over_modes_does():
    # The transform, with no polynomials and no spline between, and without the waves beyond the last, 5e-5.
    node, weight = np.polynomial.legendre.leggauss(8)
    borders = np.concatenate([np.linspace(0.0, 2.0, 9), np.linspace(2.25, 48.0, 184)])
    half = 0.5 * np.diff(borders)[:, None]
    k, share = (borders[:-1, None] + half * (1.0 + node)).ravel(), (half * weight).ravel()
    smooth = endless_cylinder.difference_spectrum(k, 0.3) + special.k0(k) / math.pi
    s = np.array([0.1, 0.5, 1.0, 3.0])[:, None]
    expected = 2.0 * (np.sin(k * s) / k) @ (share * smooth) - np.arcsinh(s[:, 0])
    cylinder = AxisOfCylinder(EvenDepth(2.0), 0.3, HALF_SPACE)  # of radius 1, whose displacement is less by this
    found = cylinder.displacement(np.zeros(1), np.append(0.0, s[:, 0]))[0]
    np.testing.assert_allclose(-np.cumsum(found), expected, atol=1e-4)


@pytest.mark.parametrize("poisson", [0.0, 0.3, 0.45])
def test_a_uniform_load_compresses_it_in_plane_strain_and_makes_it_longer(poisson):
    half_width = 0.05
    material = nh.Material(206000.0, poisson)
    body = nh.Body(diameter=20.0, material=material, depth="cylinder")
    influence = influence_of(
        nh.Contact(body, nh.Body(diameter=20.0, material=material, depth="cylinder")), nh.SEMI_ELLIPTIC
    )
    edges = np.linspace(-150.0, 150.0, 201)
    square = np.full(200, half_width**2)
    found = displacements(influence, np.zeros(1), edges, 1.0 / square, square, nh.SEMI_ELLIPTIC)[0]
    expected = 2.0 * math.log(40.0 / half_width) - 1.0 + 2.0 * poisson**2 / (1.0 - poisson**2)
    assert found == pytest.approx(expected, rel=1e-5)


def test_mirrored_ends_of_a_cylinder_are_those_of_a_row_of_rollers():
    # A load over the whole of the middle one, and images on its neighbours, is a uniform load.
    whole = nh.Body(diameter=20.0, depth="cylinder")
    cut = nh.Body(diameter=20.0, length=30.0, side_faces="mirror", images="series", depth="cylinder")
    edges, y = np.linspace(-15.0, 15.0, 101), np.array([0.0, 10.0, 14.9])
    long_edges = np.linspace(-200.0, 200.0, 801)

    def moved(body, at):
        influence, square = influence_of(nh.Contact(body, body), nh.SEMI_ELLIPTIC), np.full(at.size - 1, 0.04)
        return displacements(influence, y, at, 1.0 / square, square, nh.SEMI_ELLIPTIC)

    np.testing.assert_allclose(moved(cut, edges), moved(whole, long_edges), rtol=1e-6)


def test_free_faces_are_refused():
    with pytest.raises(nh.InputError) as refused:
        nh.Body(diameter=20.0, length=20.0, side_faces="free", depth="cylinder")
    assert "depth = 'cylinder' must not be used for a body with free side faces" in str(refused.value)
