"""The closed forms against the conditions that define them, and against numbers worked out elsewhere.

The integrals are those of Boussinesq and Flamant for the pressure, done by quadrature in 30 digits: no
elliptic integral and no formula of the module is used. K. L. Johnson, Contact Mechanics, Cambridge University
Press, 1985, doi:10.1017/CBO9781139171731, is "Johnson" below.
"""

import math

import mpmath as mp
import numpy as np
import pytest

from nonhertz.hertz import (
    half_space_line_compression,
    line_contact,
    plane_strain_cylinder_compression,
    point_contact,
)
from nonhertz.model.material import STEEL, Material


@pytest.fixture(autouse=True)
def _thirty_digits():
    with mp.workdps(30):
        yield


# The ellipse: the bodies touch everywhere inside it


def surface_displacement(contact, along_x, along_y):
    """Both surfaces' displacement at (along_x b, along_y a), Johnson Section 3.5.

    The potential of the pressure is summed over chords through the point. Along a chord the pressure is the
    root of a quadratic, whose integral is a semicircle's area; the chord's direction is (b cos t, a sin t).
    """
    b, a = mp.mpf(contact.half_width), mp.mpf(contact.half_length)
    inside = 1 - along_x**2 - along_y**2

    def chord(t):
        cos, sin = mp.cos(t), mp.sin(t)
        return (inside + (along_x * cos) ** 2 + (along_y * sin) ** 2) / mp.hypot(b * cos, a * sin)

    # A slender ellipse makes the integrand 1/t from the axis ratio upwards: one interval a decade.
    decades = [mp.mpf(10) ** n for n in range(-9, 0)]
    nodes = [0, *decades, mp.pi / 4, *(mp.pi / 2 - d for d in reversed(decades)), mp.pi / 2]
    return contact.compliance * mp.mpf(contact.max_pressure) * mp.pi * a * b * mp.quad(chord, nodes)


@pytest.mark.parametrize("radius_y", [1e-11, 1e-7, 1.0, 10.0, 10.0 * (1.0 + 1e-10), 11.0, 100.0, 4000.0, 1e9, 1e13])
@pytest.mark.slow
def test_the_gap_is_closed_over_the_whole_ellipse(radius_y):
    contact = point_contact(load=1000.0, radius_x=10.0, radius_y=radius_y, compliance=2.0 * STEEL.compliance)
    for along_x, along_y in ((0, 0), (mp.mpf("0.9"), 0), (0, mp.mpf("0.9")), (mp.mpf("0.5"), mp.mpf("0.6"))):
        x, y = along_x * mp.mpf(contact.half_width), along_y * mp.mpf(contact.half_length)
        overlap = mp.mpf(contact.approach) - x**2 / (2 * mp.mpf(10)) - y**2 / (2 * mp.mpf(radius_y))
        gap = surface_displacement(contact, along_x, along_y) - overlap
        # Rounding of the axes, which the slenderest contacts have to about 1e-15.
        assert abs(gap) < 1e-14 * contact.approach
    volume = 2 * mp.pi / 3 * mp.mpf(contact.half_width) * contact.half_length * contact.max_pressure
    assert abs(volume - 1000) < 1e-11


# T. A. Harris and M. N. Kotzalas, Essential Concepts of Bearing Technology, 5th ed., CRC Press, 2006,
# ISBN 978-0-8493-7183-7, Table 6.1, dimensionless contact parameters: F(rho), a*, b*, delta*. Quoted from
# memory, not compared with the printed page; that 22 rows agree with the exact solution is the evidence.
HARRIS = """
0        1       1       1
0.1075   1.0760  0.9318  0.9974
0.3204   1.2623  0.8114  0.9761
0.4795   1.4556  0.7278  0.9429
0.5916   1.6440  0.6687  0.9077
0.6716   1.8258  0.6245  0.8733
0.7332   2.011   0.5881  0.8394
0.7948   2.265   0.5480  0.7961
0.83495  2.494   0.5186  0.7602
0.87366  2.800   0.4863  0.7169
0.90999  3.233   0.4499  0.6636
0.93657  3.738   0.4166  0.6112
0.95738  4.395   0.3830  0.5551
0.97290  5.267   0.3490  0.4960
0.983797 6.448   0.3150  0.4352
0.990902 8.062   0.2814  0.3745
0.995112 10.222  0.2497  0.3176
0.997300 12.789  0.2232  0.2705
0.9981847 14.839 0.2072  0.2427
0.9989156 17.974 0.18822 0.2106
0.9994785 23.55  0.16442 0.17167
0.9998527 37.38  0.13050 0.11995
"""


@pytest.mark.parametrize("row", HARRIS.split("\n")[1:-1])
def test_dimensionless_parameters_of_the_bearing_textbook(row):
    difference, long_axis, short_axis, approach = (float(word) for word in row.split())
    # With a curvature sum of 1 mm^-1 and 3 Q pi K / 2 = 1 the parameters are the axes and twice the approach.
    contact = point_contact(
        load=2.0 / 3.0,
        radius_x=2.0 / (1.0 + difference),
        radius_y=2.0 / (1.0 - difference),
        compliance=1.0 / math.pi,
    )
    # Four to five digits are printed of the parameters and of 1 - F; the worst row (0.4795) is off by 3.2e-4.
    np.testing.assert_allclose(
        [contact.half_length, contact.half_width, 2.0 * contact.approach],
        [long_axis, short_axis, approach],
        rtol=4e-4,
    )


AXES = ("half_length", "half_width", "max_pressure", "approach")
# Radius along y [mm], load [N], modulus [MPa], and numbers found elsewhere; the radius along x is 10 mm.
ELSEWHERE = [
    # A separate program, made for axis ratios of 3, 5, 10, 20 and 50; three digits of the radius (52.97 as 53.0).
    (53.0, 2000.0, 206e3, (1.1247, 0.37491, 2264.7, 18.968e-3), 3e-4),
    (118.3, 2000.0, 206e3, (1.5987, 0.31974, 1868.2, 15.917e-3), 3e-4),
    (365.4, 2000.0, 206e3, (2.5554, 0.25554, 1462.4, 12.201e-3), 3e-4),
    (1176.5, 2000.0, 206e3, (4.0666, 0.20333, 1154.9, 9.0956e-3), 3e-4),
    (5810.0, 2000.0, 206e3, (7.4979, 0.14996, 849.3, 5.9623e-3), 3e-4),
    # Johnson, Eqs. (4.25)-(4.28), with mpmath in 30 digits.
    (100.0, 1000.0, 207e3, (1.17874225447462, 0.26197489937219, 1546.18997154843, 0.0103787089074731), 1e-12),
    # Roller of 20 mm on a flat, crown 4000 mm, gap + 0.0005 y: the Hertz ellipse moved to y = -2, where the gap is
    # -0.0005. That program evaluates closed forms, too, so that the tolerance is rounding.
    (
        4000.0, 3000.0, 207e3,
        (7.440484776030298, 0.18388997874427906, 1046.8955314336308, 0.008110877926920768 + 0.0005), 2e-13,
    ),
]  # fmt: skip


@pytest.mark.parametrize(("radius_y", "load", "modulus", "expected", "within"), ELSEWHERE)
def test_ellipses_found_elsewhere(radius_y, load, modulus, expected, within):
    contact = point_contact(
        load=load, radius_x=10.0, radius_y=radius_y, compliance=2.0 * Material(modulus, 0.3).compliance
    )
    np.testing.assert_allclose([getattr(contact, name) for name in AXES], expected, rtol=within, atol=0.0)
    if radius_y == 4000.0:
        assert float(contact.pressure(2.0)) == pytest.approx(1008.3656928162496, rel=2e-13)
        assert float(contact.half_width_at(2.0)) == pytest.approx(0.1771221103260539, rel=2e-13)


# The line contact


def test_the_gap_is_closed_across_the_line_contact():
    # Flamant: u(0) - u(x) = 2 K integral p(s) ln(|x - s| / |s|) ds must be x^2 / (2 rho).
    contact = line_contact(line_load=800.0, radius=7.5, compliance=2.0 * STEEL.compliance)
    b = mp.mpf(contact.half_width)

    def pressure(s):
        return contact.max_pressure * mp.sqrt((1 - s / b) * (1 + s / b))

    for share in ("0.3", "0.8", "1"):
        x = mp.mpf(share) * b
        difference = mp.quad(lambda s, x=x: pressure(s) * mp.log(abs((x - s) / s)), [-b, 0, x / 2, x, b])
        # Quadrature through the logarithms; the closed form is exact to rounding.
        closed = 2 * mp.mpf(contact.compliance) * difference / (x**2 / (2 * mp.mpf("7.5")))
        assert abs(closed - 1) < 1e-12


# Compression in a line contact


@pytest.mark.parametrize("poisson", [0.0, 0.3, 0.5])
@pytest.mark.parametrize("ratio", [10, 100, 1000])
def test_cylinder_compression_is_the_integral_of_the_strain(poisson, ratio):
    # From the contact to the centre, stresses along the axis of a disc (Johnson Section 5.6): those of the
    # contact's pressure, of the point load opposite, and the tension that frees the rim.
    material = Material(modulus=207000.0, poisson=poisson)
    # Equal cylinders with b = R / ratio.
    compliance, radius = 2.0 * material.compliance, 10.0
    line_load = (radius / ratio) ** 2 / (4.0 * compliance * 0.5 * radius)
    contact = line_contact(line_load=line_load, radius=0.5 * radius, compliance=compliance)
    b, R, nu, q = mp.mpf(contact.half_width), mp.mpf(radius), mp.mpf(poisson), mp.mpf(line_load)

    def strain(z):
        root = mp.sqrt(b**2 + z**2)
        stress_z = q / mp.pi * (1 / R - 2 / (2 * R - z) - 2 / root)
        stress_x = q / mp.pi * (1 / R - 2 * (b**2 + 2 * z**2) / (b**2 * root) + 4 * z / b**2)
        return -(1 - nu**2) / 207000 * (stress_z - nu / (1 - nu) * stress_x)

    exact = mp.quad(strain, [0, b, R / 2, R])
    found = plane_strain_cylinder_compression(contact, diameter=2.0 * radius, material=material)
    # The formula leaves out terms of (b/R)^2 against q K1.
    assert abs(found - exact) < contact.line_load * material.compliance / ratio**2


def test_two_equal_cylinders_of_a_separate_program():
    # Diameter 10, 1000 N/mm: half-width, pressure and the approach of the axes as printed there.
    steel = Material(modulus=206000.0, poisson=0.3)
    contact = line_contact(line_load=1000.0, radius=2.5, compliance=2.0 * steel.compliance)
    approach = 2.0 * plane_strain_cylinder_compression(contact, diameter=10.0, material=steel)
    np.testing.assert_allclose(
        [contact.half_width, contact.max_pressure, approach], [0.167698, 3796.234, 24.0803e-3], rtol=3e-6
    )


@pytest.mark.parametrize("length", [4.0, 20.0, 200.0])
def test_strip_compression_is_the_potential_of_its_pressure(length):
    # Boussinesq: a line of length L at distance x moves the middle by 2 K asinh(L / 2x) per unit line load.
    contact = line_contact(line_load=800.0, radius=7.5, compliance=2.0 * STEEL.compliance)
    b, half = mp.mpf(contact.half_width), mp.mpf(length) / 2

    def across(t):
        # x = b sin t; the pressure's root and dx give cos^2.
        return mp.cos(t) ** 2 * mp.asinh(half / (b * mp.sin(t)))

    exact = 4 * contact.compliance * mp.mpf(contact.max_pressure) * b * mp.quad(across, [0, mp.pi / 2])
    left_out = exact - half_space_line_compression(contact, length=length)
    unit = contact.line_load * contact.compliance
    # The term that the docstring states; the next one is below 3 % of it at L = 15 b, the shortest here.
    assert left_out / (unit * b**2 / (2 * length**2)) == pytest.approx(1.0, rel=0.03)
