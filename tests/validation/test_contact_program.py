"""The strip of the half-space program CONTACT: one element 200 mm long under a cylinder of radius 500 mm.

Example "carter2d" of https://github.com/eve70a/CONTACT: both bodies G = 82000 MPa, nu = 0.28, load 35780 N,
the pressure uniform along y; results approach 0.00649156 mm, greatest pressure 113.9 MPa, half-width 1.0 mm.
"""

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.bodies.influence import HALF_SPACE, Influence
from nonhertz.strip.problem import Problem, settle

LENGTH, RADIUS, LOAD = 200.0, 500.0, 35780.0
MATERIAL = nh.Material(modulus=2.0 * 82000.0 * 1.28, poisson=0.28)
COMPLIANCE = 2.0 * MATERIAL.compliance


def pressed(element):
    """Approach, half-width and pressure of the one strip."""
    problem = Problem(
        separation=np.zeros_like,
        curvature=lambda y: np.full_like(y, 1.0 / RADIUS),
        element=element,
        prescribed=np.array([True, False]),
        target=np.array([COMPLIANCE * LOAD, 0.0]),
        influence=Influence(HALF_SPACE),
        compliance=COMPLIANCE,
    )
    state = settle(problem, np.array([-0.5 * LENGTH, 0.5 * LENGTH]))
    assert state.converged
    half_width = element.hertz_ratio * np.sqrt(state.m[0])
    return state.rigid[0], half_width, 2.0 * LOAD / LENGTH / (np.pi * half_width)


def test_semi_elliptic_strip_is_that_of_contact():
    approach, half_width, pressure = pressed(nh.SEMI_ELLIPTIC)
    np.testing.assert_allclose(approach, 0.00649156, rtol=1e-4, atol=0.0)  # the figure to reach
    np.testing.assert_allclose(half_width, 1.0, rtol=0.0, atol=5e-4)  # digits given
    np.testing.assert_allclose(pressure, 113.89, rtol=0.0, atol=5e-3)  # digits given


def test_parabolic_strip_has_its_known_deficit():
    # The same strip with the paper's element: -0.96 % in approach, 2 q K times 0.0625464, from the two logarithms.
    approach, half_width, pressure = pressed(nh.PARABOLIC)
    np.testing.assert_allclose(approach, 0.00642906, rtol=0.0, atol=5e-9)
    deficit = 2.0 * LOAD / LENGTH * COMPLIANCE * 0.0625464
    np.testing.assert_allclose(approach + deficit, 0.00649161, rtol=0.0, atol=5e-9)
    np.testing.assert_allclose([half_width, pressure], [0.999998, 113.892], rtol=5e-6, atol=0.0)


def test_closed_form_of_puttock_and_thwaite_is_the_same():
    line = nh.hertz.line_contact(line_load=LOAD / LENGTH, radius=RADIUS, compliance=COMPLIANCE)
    closed = nh.hertz.half_space_line_compression(line, length=LENGTH)
    np.testing.assert_allclose(closed, 0.00649159, rtol=0.0, atol=5e-9)
    # It leaves out q K b^2 / (2 L^2), 1e-5 of itself, which the strip contains.
    np.testing.assert_allclose(pressed(nh.SEMI_ELLIPTIC)[0], closed, rtol=1e-5, atol=0.0)


@pytest.mark.parametrize("element", [nh.SEMI_ELLIPTIC, nh.PARABOLIC], ids=lambda e: e.name)
def test_a_uniform_pressure_needs_lundbergs_relief(element):
    # On many strips the load is spread evenly only if the ends are relieved; the approach is then the same.
    profile = nh.profile.lundberg(load=LOAD, length=LENGTH, radius=RADIUS, compliance=COMPLIANCE)
    roller = nh.Roller(
        diameter=2 * RADIUS, length=LENGTH, profile=profile, material=MATERIAL, side_faces="none", depth="none"
    )
    solution = nh.solve(nh.Contact(roller, nh.Plate(material=MATERIAL)), load=LOAD, element=element)
    middle = np.abs(solution.y) < 0.45 * LENGTH
    # The ends within a half-width are not quite uniform; the middle feels it by 1e-4.
    np.testing.assert_allclose(solution.centre_pressure[middle], 113.89, rtol=2e-3, atol=0.0)
    np.testing.assert_allclose(solution.approach, pressed(element)[0], rtol=2e-3, atol=0.0)
