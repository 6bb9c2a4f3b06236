"""Lundberg's profile: the relief with which a line contact has the same pressure along its whole length.

Where the pressure is a semi-ellipse across and constant along the contact, the centre line is depressed by

    w(y) = K q [A((a - y) / b) + A((a + y) / b)] ,      A(t) = int_0^t (4/pi) sqrt(1 + s^2) (K(k) - E(k)) ds ,

K(k), E(k) being complete elliptic integrals with k^2 = 1/(1 + s^2), so the relief must be w(0) - w(y). A has no
closed form, but it is a single function of one variable: t A'(t) is integrated in ln t once per process, and a
piecewise cubic represents the result to ten digits. The table serves every profile, so a profile holds only three
numbers.
"""

from __future__ import annotations

import functools
import math
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from nonhertz.model.profile.base import Array, Formula, Profile
from nonhertz.model.profile.design_load import (
    COMPLIANCE,
    LENGTH,
    LOAD,
    RADIUS,
    design_amplitude,
    design_half_width,
    line_contact,
)
from nonhertz.model.profile.kind import kind

# The table's range in t and its step in ln t. Outside, the first terms of the series are exact to 1e-11.
TABLE_RANGE = _NEAR, _FAR, _STEP = 1e-5, 64.0, 0.01


@dataclass(frozen=True)
class UniformPressure(Formula):
    """The relief that makes the pressure uniform along a contact of given length and half-width."""

    amplitude: float
    length: float
    half_width: float

    def relief_at(self, y: Array) -> Array:
        """Return the relief [mm]; finite everywhere, with a vertical tangent at both ends of the length."""
        half = 0.5 * self.length
        ends = np.stack([half - y, half + y]) / self.half_width
        middle = _displacement(np.array(half / self.half_width))
        return np.asarray(self.amplitude * (2.0 * middle - _displacement(ends).sum(axis=0)))

    @property
    def bends(self) -> tuple[float, ...]:
        """Both ends of the length."""
        return (-0.5 * self.length, 0.5 * self.length)


@kind(by_drop=("load",), of_body={"length": "land", "radius": "radius"}, cross_checks=(line_contact,))
def lundberg(
    load: Annotated[float, LOAD],
    length: Annotated[float, LENGTH],
    radius: Annotated[float, RADIUS],
    compliance: Annotated[float | None, COMPLIANCE] = None,
) -> Profile:
    """Return Lundberg's profile for a design load: under that load the pressure is uniform along the length.

    Relief = A [2 A1(a/b) - A1((a - y)/b) - A1((a + y)/b)], where A = (load / length) (K_a + K_b),
    a = length / 2, b is the Hertz half-width of the line contact at the design load and A1 the displacement
    function of a strip with a semi-elliptic pressure (see the module). For y well within the ends this is
    nearly A ln(1 / (1 - (y / a)^2)); at the end it is not infinite but A (ln(a / b) + 1.1932). Beyond the
    ends it follows the deformed surface, so that a longer body would just touch there with zero pressure.

    Returns
    -------
    Profile
        The profile, meant as the combined relief of both bodies.

    Notes
    -----
    Both bodies are half-spaces, and the relief is exact only on the centre line. Within about one half-width
    of the ends no relief with circular cross-sections gives a semi-elliptic pressure of constant width: the contact
    narrows and its peak pressure rises there (by 3 % one half-width from the end in the example below, as solved
    with this package, and more beyond).

    References
    ----------
    G. Lundberg, Elastische Beruehrung zweier Halbraeume, Forschung auf dem Gebiete des Ingenieurwesens 10
    (1939) 201-211, doi:10.1007/BF02584950. The exact integral that replaces his logarithm is our own
    derivation.

    Examples
    --------
    >>> profile = lundberg(load=20e3, length=20, radius=10)
    >>> round(float(profile.relief(5.0)), 6), round(float(profile.relief(10.0)), 6)
    (0.000805, 0.012848)
    """
    amplitude = design_amplitude(load, length, compliance)
    return UniformPressure(amplitude, length, design_half_width(load, length, radius, compliance))


def _displacement(t: Array) -> Array:
    """Return A(t), odd in t."""
    size = np.abs(t)
    position = (np.log(np.clip(size, _NEAR, _FAR)) - math.log(_NEAR)) / _STEP
    c0, c1, c2, c3 = columns = table()
    cell = np.minimum(position.astype(np.intp), columns.shape[1] - 1)
    s = position - cell
    value = c0[cell] + s * (c1[cell] + s * (c2[cell] + s * c3[cell]))
    near = size < _NEAR
    if near.any():
        value = np.where(near, 4.0 / math.pi * size * np.log(4.0 / np.maximum(size, 1e-300)), value)
    far = size > _FAR
    if far.any():
        t2 = np.maximum(size, _FAR) ** -2
        value = np.where(far, -0.5 * np.log(t2 / 16.0) + 0.5 + t2 * (1.0 / 16.0 - 3.0 / 256.0 * t2), value)
    return np.asarray(np.copysign(value, t))


@functools.cache
def table() -> Array:
    """Return the coefficients of the cubics for A, rows c0 to c3, one column per cell of ln t."""
    cells = math.ceil(math.log(_FAR / _NEAR) / _STEP)
    knots: Array = math.log(_NEAR) + _STEP * np.arange(cells + 1, dtype=np.float64)
    nodes, weights = np.polynomial.legendre.leggauss(4)
    inner = np.asarray(knots[:-1, None] + 0.5 * _STEP * (nodes + 1.0), dtype=np.float64)
    rise = 0.5 * _STEP * (_slope(inner) @ weights)
    start = 4.0 / math.pi * _NEAR * math.log(4.0 / _NEAR)
    low = start + np.concatenate([[0.0], np.cumsum(rise)[:-1]])
    slope = _STEP * _slope(knots)
    first, second = slope[:-1], slope[1:]
    return np.stack([low, first, 3.0 * rise - 2.0 * first - second, first + second - 2.0 * rise])


def _slope(u: Array) -> Array:
    """Return t A'(t) at t = exp(u)."""
    # Imported here, because importing scipy takes longer than everything else that this package imports at first.
    from scipy.special import ellipe, ellipkm1

    t = np.exp(u)
    m = 1.0 / (1.0 + t * t)
    return np.asarray(4.0 / math.pi * t / np.sqrt(m) * (ellipkm1(t * t * m) - ellipe(m)))
