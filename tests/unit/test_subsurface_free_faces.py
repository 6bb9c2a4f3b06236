"""The steps from a load to the table of what a free face adds, against quadrature and another library's splines."""

import numpy as np
import pytest
from scipy.interpolate import make_interp_spline
from scipy.special import j1

from nonhertz.bodies.quarter_space import NODES, nodes_on, to_legendre
from nonhertz.bodies.quarter_space_field import quarter_space_field
from nonhertz.native import core
from nonhertz.subsurface.free_faces import FreeFaceField, Spectrum


@pytest.mark.parametrize("power", [0, 1, 5])
def test_parts_of_a_load_at_the_nodes_integrate_polynomials(power):
    panels = quarter_space_field(0.3).panels
    k, edges, steps = np.array([0.5, 2.0, 400.0]), np.array([0.0, 0.7, 3.0]), np.array([[5.0, -2.0, 3.0]] * 3)
    weights = np.polynomial.legendre.leggauss(NODES)[1]
    parts = core.at_nodes(panels, to_legendre(), weights, k, edges, steps)
    reach = np.minimum(k[:, None] * edges, panels[-1])
    wanted = np.sum(steps * reach ** (power + 1), axis=1) / (power + 1)
    np.testing.assert_allclose(parts @ nodes_on(panels)[0] ** power, wanted, rtol=1e-11)


def test_splines_over_distances_are_those_through_their_values():
    known = np.linspace(-3.0, 2.0, 12)
    values = np.random.default_rng(1).normal(size=(2, known.size, 3))
    splines = [make_interp_spline(known, each, 3) for each in values]
    log_k, log_r = np.array([-1.0, 0.7]), np.linspace(-4.0, 3.5, 31)
    coefficients = np.array([spline.c.ravel() for spline in splines])
    found = core.between_distances(splines[0].t, log_k, log_r, coefficients).reshape(2, log_r.size, 3)
    for each, shift, spline in zip(found, log_k, splines, strict=True):
        at = shift + log_r
        wanted = np.where((at > known[-1])[:, None], 0.0, spline(np.clip(at, known[0], known[-1])))
        np.testing.assert_allclose(each, wanted, atol=1e-12)


@pytest.mark.parametrize("by", [0.3, -0.3])
def test_a_load_that_is_moved_across_moves_what_a_face_adds(by):
    # An even load, and the same as an even and an odd one.
    edges, steps = np.array([0.0, 2.0, 6.0]), np.array([-1.0, 0.4, 0.6])

    def field(moved):
        def spectrum(k, y):
            whole = (2.0 * j1(k) / k)[:, None] * steps
            shift = k[:, None] * moved
            return Spectrum(edges, whole * np.cos(shift), whole * np.sin(shift) if moved else None)

        return FreeFaceField.of(spectrum, 0.0, -1.0, 1.0, 6.0, 0.3)

    x, y, z = np.meshgrid([-0.8, -0.1, 0.5], [0.0, 0.4, 3.0], [0.0, 0.2, 1.0])
    points = np.column_stack([x.ravel(), y.ravel(), z.ravel()])
    there = points + np.array([by, 0.0, 0.0])
    for quantity in (FreeFaceField.stress, FreeFaceField.displacement):
        wanted = quantity(field(0.0), points)
        np.testing.assert_allclose(quantity(field(by), there), wanted, atol=0.02 * np.abs(wanted).max())
