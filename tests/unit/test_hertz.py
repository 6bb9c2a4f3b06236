import dataclasses
import math
import re

import numpy as np
import pytest

from nonhertz.errors import InputError
from nonhertz.hertz import (
    LineContact,
    PointContact,
    half_space_line_compression,
    line_contact,
    plane_strain_cylinder_compression,
    point_contact,
)
from nonhertz.model.material import STEEL, Material
from nonhertz.model.materials import MATERIALS

COMPLIANCE = 2.0 * STEEL.compliance
SILICON_NITRIDE = MATERIALS["silicon-nitride"]
# Slender both ways, nearly circular and circular.
RADII_Y = [1e-11, 1e-7, 0.3, 10.0 - 1e-9, 10.0, 10.0 + 1e-9, 85.0, 1e9, 1e13]


def ellipse(**changes: float) -> PointContact:
    return point_contact(**{"load": 1000.0, "radius_x": 10.0, "radius_y": 100.0, "compliance": COMPLIANCE, **changes})


def line(**changes: float) -> LineContact:
    return line_contact(**{"line_load": 800.0, "radius": 7.5, "compliance": COMPLIANCE, **changes})


# Point contact


@pytest.mark.parametrize("radius_y", RADII_Y)
def test_swapped_radii_swap_the_axes_and_nothing_else(radius_y):
    contact, turned = ellipse(radius_y=radius_y), ellipse(radius_x=radius_y, radius_y=10.0)
    assert (contact.half_width, contact.half_length) == (turned.half_length, turned.half_width)
    assert (contact.max_pressure, contact.approach) == (turned.max_pressure, turned.approach)


@pytest.mark.parametrize("radius_y", RADII_Y)
def test_the_approach_leads_back_to_the_load(radius_y):
    contact = ellipse(radius_y=radius_y)
    back = point_contact(approach=contact.approach, radius_x=10.0, radius_y=radius_y, compliance=COMPLIANCE)
    # One solution reached by two ways; they differ by a few roundings.
    np.testing.assert_allclose(dataclasses.astuple(back), dataclasses.astuple(contact), rtol=1e-14)


@pytest.mark.parametrize("radius_y", [1e-7, 10.0, 85.0])
def test_stiffness_is_the_slope_of_load_over_approach(radius_y):
    contact, step = ellipse(radius_y=radius_y), 1e-4
    low, high = (ellipse(radius_y=radius_y, load=1000.0 * (1.0 + s)) for s in (-step, step))
    slope = (high.load - low.load) / (high.approach - low.approach)
    # Central difference: error step^2 / 27.
    np.testing.assert_allclose(contact.stiffness, slope, rtol=1e-9)


@pytest.mark.parametrize("radius_y", [0.3, 10.0, 1e9])
def test_pressure_across_adds_up_to_the_line_load_and_that_to_the_load(radius_y):
    contact = ellipse(radius_y=radius_y)
    y = contact.half_length * np.array([-0.9, 0.0, 0.5])
    # x = b(y) sin t makes the integrand cos^2, for which equal steps are exact.
    t = np.linspace(-0.5 * math.pi, 0.5 * math.pi, 65)
    width = contact.half_width_at(y)[:, None]
    across = np.trapezoid(contact.pressure(y[:, None], x=width * np.sin(t)) * np.cos(t), t) * width[:, 0]
    np.testing.assert_allclose(contact.line_load_at(y), across, rtol=1e-13)
    nodes, weights = np.polynomial.legendre.leggauss(2)
    along = contact.half_length * weights @ contact.line_load_at(contact.half_length * nodes)
    np.testing.assert_allclose(along, contact.load, rtol=1e-14)


def test_nothing_is_carried_outside_the_ellipse():
    contact = ellipse()
    y = contact.half_length * np.array([-3.0, -1.0, 1.0, 1.001])
    for values in (contact.pressure(y), contact.half_width_at(y), contact.line_load_at(y)):
        assert values.tolist() == [0.0, 0.0, 0.0, 0.0]
    # A solution's pressure has x first.
    with pytest.raises(TypeError):
        contact.pressure(0.0, 0.0)
    assert float(contact.pressure(0.0, x=contact.half_width)) == 0.0
    assert float(contact.pressure(0.8 * contact.half_length, x=0.7 * contact.half_width)) == 0.0


def test_bodies_at_an_angle_have_the_gap_whose_curvatures_numpy_diagonalises():
    rng = np.random.default_rng(25)
    for _ in range(200):
        (ax, ay), angle = 1.0 / rng.uniform(5.0, 50.0, 2), rng.uniform(-np.pi, np.pi)
        bx, by = rng.choice([-1.0, 0.0, 1.0]) / rng.uniform(60.0, 500.0), 1.0 / rng.uniform(5.0, 500.0)
        turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
        gap = np.diag([ax, ay]) + turn @ np.diag([bx, by]) @ turn.T
        pair = {"radius_x": (1.0 / ax, 1.0 / bx if bx else math.inf), "radius_y": (1.0 / ay, 1.0 / by), "angle": angle}
        found = point_contact(load=1e3, compliance=COMPLIANCE, **pair)
        radii = 1.0 / np.linalg.eigvalsh(gap)[::-1]
        np.testing.assert_allclose(sorted([found.radius_x, found.radius_y]), radii, rtol=1e-12)
        x = np.array([np.cos(found.turned), np.sin(found.turned)])
        np.testing.assert_allclose(gap @ x, x / found.radius_x, rtol=1e-10, atol=1e-12)
        assert abs(found.turned) <= np.pi / 4.0
        plain = point_contact(load=1e3, compliance=COMPLIANCE, radius_x=found.radius_x, radius_y=found.radius_y)
        assert found.max_pressure == plain.max_pressure


@pytest.mark.parametrize(
    ("changes", "sentence"),
    [
        ({"radius_x": 0.01, "radius_y": 1e99}, "radius_y = 1e+99 must lie within a factor of 1e100 of radius_x = 0.01"),
        ({"angle": 0.1}, "radius_x = 10.0 must be a pair of radii other than zero where one radius is a pair or an"),
        ({"radius_x": (10.0, math.inf), "radius_y": (math.inf, math.inf), "angle": 0.1}, "radius_x = (10.0, inf) must"),
        ({"load": "1 kN"}, "load = '1 kN' must be a finite number: give the load in N"),
        ({"load": None}, "load must be given: give either the load in N or the approach in mm."),
        ({"approach": 0.01}, "load = 1000.0 must be left out where approach = 0.01 is given"),
        ({"load": None, "approach": -0.01}, "approach = -0.01 must be positive: give the approach in mm"),
    ],
)
def test_a_point_contact_refuses_input_in_one_sentence(changes, sentence):
    with pytest.raises(InputError) as raised:
        ellipse(**changes)
    assert str(raised.value).startswith(sentence)
    assert str(raised.value).count("\n") == 0


# Line contact


def test_line_pressure_adds_up_to_the_line_load_and_ends_at_the_edge():
    contact = line()
    # As for the ellipse: equal steps are exact in t.
    t = np.linspace(-0.5 * math.pi, 0.5 * math.pi, 65)
    across = np.trapezoid(contact.pressure(contact.half_width * np.sin(t)) * np.cos(t), t)
    np.testing.assert_allclose(across * contact.half_width, contact.line_load, rtol=1e-13)
    assert contact.pressure(contact.half_width * np.array([-1.5, -1.0, 0.0, 1.0])).tolist() == [
        0.0,
        0.0,
        contact.max_pressure,
        0.0,
    ]


# Compression


def test_each_cylinder_counts_with_its_own_material():
    contact = line(compliance=STEEL.compliance + SILICON_NITRIDE.compliance)
    steel, ceramic = (
        plane_strain_cylinder_compression(contact, diameter=15.0, material=material)
        for material in (STEEL, SILICON_NITRIDE)
    )
    np.testing.assert_allclose(steel / ceramic, STEEL.compliance / SILICON_NITRIDE.compliance, rtol=1e-14)


def test_a_cylinder_narrower_than_the_contact_is_refused():
    contact = line()
    with pytest.raises(InputError, match=r"^diameter = 0.1 must exceed the width of contact of 0\.5\d* mm: "):
        plane_strain_cylinder_compression(contact, diameter=0.1, material=STEEL)
    with pytest.raises(InputError, match=r"^length = 0.1 must exceed the width of contact of 0\.5\d* mm: "):
        half_space_line_compression(contact, length=0.1)


# Both bodies' elasticity


@pytest.mark.parametrize("make", [ellipse, line])
def test_materials_or_e_star_say_what_the_compliance_does(make):
    # 1/E* = (1 - nu_a^2)/E_a + (1 - nu_b^2)/E_b, of which K = 1/(pi E*): 207 and 310 GPa, 0.3 and 0.26.
    e_star = 1.0 / ((1.0 - 0.3**2) / 207e3 + (1.0 - 0.26**2) / 310e3)
    a, b = Material(modulus=207e3, poisson=0.3), Material(modulus=310e3, poisson=0.26)
    expected = dataclasses.astuple(make(compliance=1.0 / (math.pi * e_star)))
    for pair in ({"e_star": e_star}, {"materials": (a, b)}, {"materials": ("steel", "silicon-nitride")}):
        np.testing.assert_allclose(dataclasses.astuple(make(compliance=None, **pair)), expected, rtol=1e-14)


@pytest.mark.parametrize(
    ("pair", "sentence"),
    [
        ({"compliance": None}, "must be given: give one of materials, e_star and compliance"),
        ({"e_star": 115e3}, "e_star = 115000.0 must be left out where compliance is given"),
        ({"materials": (STEEL, STEEL)}, "must be left out where compliance is given"),
        ({"compliance": None, "materials": (STEEL,)}, "must be a pair: "),
        ({"compliance": None, "materials": ("stel", STEEL)}, "materials[0] = 'stel' must be a known material: did"),
        ({"compliance": None, "e_star": -1.0}, "e_star = -1.0 must"),
    ],
    ids=str,
)
@pytest.mark.parametrize("make", [ellipse, line])
def test_elasticity_is_given_once(make, pair, sentence):
    with pytest.raises(InputError, match=re.escape(sentence)):
        make(**pair)
