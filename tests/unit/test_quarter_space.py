"""What a free side face adds, against limits, reciprocity and values from elsewhere."""

import math

import numpy as np
import pytest
from scipy import integrate

from nonhertz.bodies import quarter_space
from nonhertz.bodies.ends import edge_exponent, edge_powers
from nonhertz.bodies.quarter_space import EDGE_SLOPE, edge_kernel, free_face

MATERIALS = [0.0, 0.3, 0.49]


def added(face, u, v):
    """E as it is kept."""
    from scipy import special

    u, v = np.broadcast_arrays(np.asarray(u, float), np.asarray(v, float))
    weights, distance = face.towards(u, v), np.multiply.outer(u + v, face.distances)
    return np.sum(weights[..., 0, :] * 2.0 * special.k0(distance) + weights[..., 1, :] * np.exp(-distance), axis=-1)


@pytest.mark.parametrize(
    ("poisson", "u", "v", "expected"),
    [
        (0.3, 0.2, 0.2, 1.728),
        (0.3, 0.2, 1.0, 0.268),
        (0.3, 0.5, 0.5, 0.593),
        (0.3, 1.0, 2.0, 0.0539),
        (0.3, 2.0, 2.0, 0.0252),
        (0.0, 0.2, 0.2, 0.560),
        (0.0, 0.5, 0.5, 0.0797),
        (0.0, 1.0, 1.0, 0.0389),
    ],
)
def test_values_of_another_quadrature_are_met(poisson, u, v, expected):
    # 480 nodes of a plain panel rule, good to a few thousandths.
    assert added(free_face(poisson), u, v) == pytest.approx(expected, rel=4e-3)


@pytest.mark.slow
@pytest.mark.parametrize("poisson", MATERIALS)
def test_faces_alternate_towards_the_same_loads(poisson):
    # One face after the other, a hundred times, instead of the sum of the series at once: on a plain grid, which is
    # good to a hundredth, and with the integral of K0 by another rule.
    step = 0.05
    y = step * (np.arange(160) + 0.5)
    operator = step * np.array([[_brought(z, v, poisson) for v in y] for z in y])
    load = operator[:, np.searchsorted(y, 2.0)] / step
    total, on_side = np.zeros_like(load), load
    for _ in range(100):
        on_top = operator @ on_side
        total, on_side = total + on_top, operator @ on_top
    solved = quarter_space.EdgeSolution.of(poisson)  # its displacement, from the same loads
    place = 4.0
    kernel = np.array([_k0(abs(place - at)) + _k0(place + at) for at in y])
    raised = 2.0 * step * float(kernel @ total)
    at_load = y[np.searchsorted(y, 2.0)]
    assert raised == pytest.approx(float(solved.at(np.array([place]), np.array([at_load]))[0]), rel=0.02)


def _k0(x):
    from scipy import special

    return special.k0(max(x, 1e-3))


def _brought(z, v, poisson):
    from scipy import special

    distance = math.hypot(z, v)
    k0, k1 = special.k0(distance), special.k1(distance)
    k2 = k0 + 2.0 * k1 / distance
    beyond = integrate.fixed_quad(lambda s: special.k0(np.hypot(s, v)), z, z + 12.0, n=40)[0]
    near = 2.0 * z * k1 / distance - z**3 * k2 / distance**2
    return 2.0 / math.pi * (near + z * k0 - (1.0 - 2.0 * poisson) * beyond)


@pytest.mark.parametrize("poisson", MATERIALS)
def test_near_the_edge_the_quarter_space_is_a_wedge(poisson):
    near, nearer = added(free_face(poisson), [1e-4, 1e-6], [1e-4, 1e-6])
    assert (nearer - near) / math.log(100.0) == pytest.approx(EDGE_SLOPE, rel=2e-4)


@pytest.mark.parametrize("poisson", MATERIALS)
def test_the_wedge_does_not_depend_on_the_material(poisson):
    r = np.array([1e-3, 0.1, 0.4, 1.0])
    of_face = added(free_face(poisson), np.full(4, 1e-6), 1e-6 * r)
    of_wedge = edge_kernel(np.full(4, 1e-6), 1e-6 * r)
    np.testing.assert_allclose(of_face - of_face[-1], of_wedge - of_wedge[-1], atol=1e-4)


@pytest.mark.parametrize("poisson", MATERIALS)
def test_what_is_kept_is_what_was_solved(poisson):
    solved = quarter_space.EdgeSolution.of(poisson)
    random = np.random.default_rng(3)
    u = 10.0 ** random.uniform(-4.0, 1.0, 500)
    v = u * 10.0 ** random.uniform(-2.5, 0.0, 500)
    np.testing.assert_allclose(added(free_face(poisson), u, v), solved.at(u, v), atol=1e-6)


def test_moments_are_the_coefficients_of_the_series():
    face, ratio = free_face(0.3), np.array([0.2, 1.0])
    found = face.moments(ratio, 2)
    for k in range(3):
        for row, each in enumerate(ratio):
            whole = integrate.quad(
                lambda s, k=k, each=each: s ** (2 * k) * float(added(face, s, s * each)), 0.0, 40.0, limit=200
            )
            assert found[row, k] == pytest.approx(whole[0] / math.pi, rel=1e-6)


@pytest.mark.parametrize(("kappa", "expected"), [(0.5, 0.22599), (1.0, 0.0)])
def test_exponents_of_free_ends(kappa, expected):
    # The first is known of a sharp edge on a long body of the same material, whatever Poisson's ratio.
    assert edge_exponent(kappa, free=kappa) == pytest.approx(expected, abs=1e-5)


def test_a_free_end_of_a_stiff_body_is_nearly_that_of_a_rigid_one():
    assert edge_exponent(1e-6, free=1e-6) == pytest.approx(0.5, abs=1e-5)


@pytest.mark.parametrize(("kappa", "free"), [(0.3, 0.3), (0.5, 0.5), (0.5, 0.2), (0.9, 0.9)])
def test_powers_at_an_end_move_its_surface_by_smooth_terms_only(kappa, free):
    from nonhertz.result.end_fit import integrate_free_edge, wedge_displacement

    x = np.geomspace(1e-3, 0.08, 9)

    def rough(powers):
        """What a polynomial of x does not describe of the displacement."""
        moved = wedge_displacement(x[:, None], kappa, powers) - 0.5 * free * integrate_free_edge(x, powers)
        smooth = np.vander(x, 6)
        return np.abs(smooth @ np.linalg.lstsq(smooth, moved, rcond=None)[0] - moved).max(axis=0)

    powers = np.array(edge_powers(kappa, free))
    assert np.all(rough(powers) < 3e-7)
    assert rough(powers + 0.05)[0] > 1e-5
