"""The four functions of each element against quadrature of the integrals that define them."""

import functools
import math

import mpmath as mp
import numpy as np
import pytest

import nonhertz as nh

ELEMENTS = {element.name: element for element in (nh.SEMI_ELLIPTIC, nh.PARABOLIC)}
FUNCTIONS = ("A", "tA'", "B", "tB'")
both_elements = pytest.mark.parametrize("element", ELEMENTS.values(), ids=ELEMENTS)
# Wanted are 1e-12 (parabolic) and 1e-10 (semi-elliptic); both reach 3e-13.
RTOL = 1e-12

DECADES = [float(t) for t in 10.0 ** np.arange(-8.0, 9.0)]
ODD_PLACES = [3.7e-7, 2.2e-4, 0.0314, 0.37, 0.71, 1.13, 1.93, 2.9, 5.3, 6.77, 23.0, 70.0, 640.0, 12345.6]
# Where a table may change from one row or formula to the next: powers of two, eighths between them.
BOUNDARIES = [2.0**-30, 2.0**-20, 1.0, 1.125, 1.25, 1.875, 2.0, 8.0, 256.0]
BELOW = [float(np.nextafter(t, 0.0)) for t in BOUNDARIES]
PLACES = sorted({*DECADES, *ODD_PLACES, *BOUNDARIES, *BELOW})


@functools.cache
def integrals(name, t):
    """A, t A', B and t B' at ``t`` > 0 by quadrature over half the strip's width, in 20 digits.

    For the semi-ellipse xi = sin(theta), so that neither phi nor psi = -phi'/xi has an end singularity.
    """
    with mp.workdps(20):
        t = mp.mpf(t)
        if name == "parabolic":
            end, place = mp.mpf(1), lambda v: v
            phi, psi = (lambda v: mp.mpf("1.5") * (1 - v * v)), (lambda v: mp.mpf(3))
        else:
            end, place = mp.pi / 2, mp.sin
            phi, psi = (lambda v: 4 / mp.pi * mp.cos(v) ** 2), (lambda v: 4 / mp.pi)
        # Every integrand changes its course within a decade or two of xi = t.
        nodes = [mp.mpf(0), *(t * mp.mpf(30) ** k for k in range(-1, 8) if t * mp.mpf(30) ** k < 0.6), end]

        def over_the_width(integrand):
            return mp.quad(integrand, nodes)

        return (
            over_the_width(lambda v: phi(v) * mp.asinh(t / place(v))),
            over_the_width(lambda v: phi(v) * t / mp.hypot(place(v), t)),
            over_the_width(lambda v: psi(v) * t / mp.hypot(place(v), t)),
            over_the_width(lambda v: psi(v) * t * place(v) ** 2 / mp.hypot(place(v), t) ** 3),
        )


@both_elements
@pytest.mark.parametrize("which", range(4), ids=FUNCTIONS)
@pytest.mark.slow
def test_functions_equal_their_defining_integrals(element, which):
    expected = [float(integrals(element.name, t)[which]) for t in PLACES]
    np.testing.assert_allclose(element.functions(PLACES)[which], expected, rtol=RTOL, atol=0.0)


@both_elements
def test_functions_vanish_at_zero_and_keep_their_sign_near_it(element):
    np.testing.assert_array_equal(element.functions(0.0), np.zeros(4))
    assert np.all(np.array(element.functions(1e-300)) > 0.0)


@both_elements
def test_functions_have_the_shape_of_their_argument(element):
    t = np.array([[0.5, -2.0, 1e5], [1e-12, 9.0, 3.0]])
    for values in element.functions(t):
        assert values.shape == t.shape
    assert element.functions(2.0)[0].shape == ()
    np.testing.assert_array_equal(element.functions(t.T)[0], element.functions(t)[0].T)


@both_elements
def test_functions_do_not_jump_between_rows_of_a_table(element):
    # From one double to the next the functions change by 1e-16 of themselves; the rest is the table's error.
    octaves = 2.0 ** np.arange(-34.0, 12.0)
    boundary = (octaves[:, None] * (1.0 + np.arange(16) / 16.0)).ravel()
    below = element.functions(np.nextafter(boundary, 0.0))
    np.testing.assert_allclose(below, element.functions(boundary), rtol=RTOL, atol=0.0)


@pytest.mark.parametrize(("name", "ratio"), [("semi-elliptic", 1.0), ("parabolic", math.sqrt(2.0 / 3.0))])
def test_hertz_ratio_is_that_of_equal_line_loads(name, ratio):
    # The paper's Eq. (61).
    assert abs(ELEMENTS[name].hertz_ratio - ratio) < 1e-15


# A separate implementation of the paper, E = 206000, nu = 0.3, a strip 0.4 wide, c = 0.25, centred at yj = 1:
# C and P are displacement and curvature per unit of the summit s (q = 4/3 s c^3), Cd and Pd their derivatives
# by c. Nine digits are given.
COEFFICIENTS = {
    0.0: (1.18000912e-8, 1.40992791e-7, 1.19573140e-8, 1.37802852e-7),
    1.0: (1.09428655e-7, 1.10433121e-6, 2.35687676e-6, 7.02720057e-6),
}


@pytest.mark.parametrize("seen_from", COEFFICIENTS)
def test_parabolic_coefficients_of_a_separate_implementation(seen_from):
    compliance = nh.Material(modulus=206000, poisson=0.3).compliance
    c = 0.25
    upper = nh.PARABOLIC.functions((1.2 - seen_from) / c)
    lower = nh.PARABOLIC.functions((0.8 - seen_from) / c)
    a, ta, b, tb = np.subtract(upper, lower)
    found = compliance * np.array(
        [4.0 / 3.0 * c**3 * a, c**2 * (4.0 * a - 4.0 / 3.0 * ta), 4.0 / 3.0 * c * b, 4.0 / 3.0 * (b - tb)]
    )
    np.testing.assert_allclose(found, COEFFICIENTS[seen_from], rtol=5e-9, atol=0.0)


@pytest.mark.parametrize("element", [nh.SEMI_ELLIPTIC, nh.PARABOLIC], ids=lambda element: element.name)
def test_what_is_no_number_stays_none(element):
    # It must not become a place beyond the table either, which only ends a process now and then.
    for values in element.functions(math.nan):
        assert math.isnan(values)
