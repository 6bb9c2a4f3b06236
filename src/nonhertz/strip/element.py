"""The two strip elements, each four functions of one variable.

A strip is uniform along y between two edges and carries, across the contact, a pressure of fixed shape phi on
|x| <= a. Seen from a point on the centre line at the signed distance y' of one of its edges, everything it does
there is a function of t = y'/a alone, and the strip's effect is the difference between its two edges (theory:
docs/explain/theory.md). With a load q per unit length and a half-space compliance K,

    displacement            w             = K q [A]             A'(t)   = int phi / sqrt(xi^2 + t^2) dxi
    curvature               -d2w/dx2      = K q [B] / a^2       B(t)    = int psi t / sqrt(xi^2 + t^2) dxi
    derivatives by a        through tA' and tB'                 t B'(t) = int psi t xi^2 / (xi^2 + t^2)^(3/2) dxi

where psi = -phi'/xi. Both shapes have closed forms, but the solver needs millions of values: it reads all
four functions from one table of polynomials, eight intervals per octave of t, located from the bits of t without
a logarithm. The table is made once, when an element is first used: from the closed forms up to t = 8, and
beyond, where these begin to cancel, from a series in 1/t^2 whose coefficients are moments of phi. Beyond t = 256 a
few terms of the series suffice.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, fields
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.native import core

Array = NDArray[np.float64]

# The table covers [SMALL, FAR]; below it the leading terms are exact to rounding, beyond it a short series is.
SMALL_EXPONENT, FAR_EXPONENT = -30, 8
SMALL, FAR = 2.0**SMALL_EXPONENT, 2.0**FAR_EXPONENT
INTERVALS_PER_OCTAVE = 8
DEGREE = 8
# The closed forms suffer cancellation beyond t = CANCELLING; there the table is made from LONG_SERIES terms.
CANCELLING, LONG_SERIES = 8.0, 11
SHORT_SERIES = 4
MEANS = 10  # arithmetic-geometric means from 1 and SMALL until both agree to the last bit
# Beyond t = REMOTE the powers t^-2 to t^-2 POWERS give A and B to 1e-13.
REMOTE, POWERS = 10.0, 5
# Offsets of the table's parts.
SERIES_AT = (FAR_EXPONENT - SMALL_EXPONENT) * INTERVALS_PER_OCTAVE * (DEGREE + 1) * 4
LEADING_AT = SERIES_AT + SHORT_SERIES * 4
POWERS_AT = LEADING_AT + 4

A, T_DA, B, T_DB = range(4)


@dataclass(frozen=True, repr=False)
class Element:
    """A strip with a fixed pressure shape across the contact.

    Attributes
    ----------
    name : str
        ``"semi-elliptic"`` or ``"parabolic"``.
    line_factor : float
        kappa = 2 B(infinity): in a line contact a^2 = kappa K q rho; 4 (Hertz) or 6.
    hertz_ratio : float
        b / a, from the element's half-width to that of the Hertz line contact of equal load: 1 or sqrt(2/3).

    References
    ----------
    J. M. de Mul, J. J. Kalker, G. M. Vree, An orthogonal uniform/parabolic surface pressure half-space element
    for the analysis of non-Hertzian contact, Computational Mechanics, CIMNE, Barcelona 1998: Eqs. (24), (25),
    (32), (33) are the parabolic element, Eqs. (59)-(62) the limits. The semi-elliptic one is Reusner's.

    Examples
    --------
    >>> displacement, *_ = SEMI_ELLIPTIC.functions(2.0)
    >>> round(float(displacement), 12)
    2.594391254771
    """

    name: str
    line_factor: float
    hertz_ratio: float
    centre_factor: float
    """p(0) = centre_factor * q / a, the element's own pressure on the centre line."""
    far_constant: float
    """A(t) - ln(2 t) at infinity, -int phi ln|xi|."""
    _moments: tuple[Callable[[int], float], Callable[[int], float]]
    """k -> int phi xi^2k and k -> int psi xi^2k."""
    _closed_forms: Callable[[Array], tuple[Array, Array, Array]]
    """t in [SMALL, CANCELLING] -> A', B, t B'."""
    _leading: tuple[float, float, float, float]
    """For t -> 0: A' = l0 ln(l1/t), B = l2 t ln(l3/t)."""
    smoothed: Callable[[Array], tuple[Array, Array]]
    """t > 0 -> (1/pi) int phi t / (xi^2 + t^2), and its second derivative."""

    def __repr__(self) -> str:
        return f"Element({self.name!r})"

    def __getstate__(self) -> dict[str, Any]:
        # What is worked out from the fields is worked out again.
        return {each.name: getattr(self, each.name) for each in fields(self)}

    def functions(self, t: ArrayLike) -> tuple[Array, Array, Array, Array]:
        """Return A, t A', B and t B' at ``t``, arrays of its shape, odd in t.

        The relative error is below 1e-12 for |t| from 1e-8 to 1e8.
        """
        t = np.asarray(t, dtype=float)
        values = core.evaluate(self.core, np.ascontiguousarray(t).ravel())
        return tuple(values[:, k].reshape(t.shape) for k in range(4))  # type: ignore[return-value]

    @cached_property
    def core(self) -> core.Element:
        """The element as the core reads it."""
        return core.Element(self.name, self.line_factor, self.hertz_ratio, self.far_constant, self.table)

    @cached_property
    def table(self) -> Array:
        """Coefficients that the compiled core reads, in one flat array.

        Polynomials, far series, leading terms, and the factors of t^-2k, k = 1 to `POWERS`, in A and in B.
        """
        powers = self._series(POWERS + 1)[-2::-1, [A, B]]
        return np.concatenate([self._polynomials(), self._series(SHORT_SERIES).ravel(), self._leading, powers.ravel()])

    def _polynomials(self) -> Array:
        """Return polynomial coefficients, (intervals, DEGREE + 1, 4) flattened, highest power first.

        On each interval the variable runs over [-1, 1]. The interval is short compared with the distance to the
        nearest singularity (t = 0 and t = +-i), so the Chebyshev interpolant is exact to rounding at this degree.
        """
        octaves = np.arange(SMALL_EXPONENT, FAR_EXPONENT)
        low = (2.0 ** octaves[:, None] * (1.0 + np.arange(INTERVALS_PER_OCTAVE) / INTERVALS_PER_OCTAVE)).ravel()
        half = np.repeat(2.0**octaves, INTERVALS_PER_OCTAVE) / (2 * INTERVALS_PER_OCTAVE)
        nodes = np.polynomial.chebyshev.chebpts1(DEGREE + 1)
        t = low[:, None] + half[:, None] * (1.0 + nodes)
        near = low < CANCELLING
        values = np.empty((*t.shape, 4))
        slope, values[near, :, B], values[near, :, T_DB] = self._closed_forms(t[near])
        values[near, :, T_DA] = t[near] * slope
        values[near, :, A] = self._integrated(slope, low[near], half[near], nodes)
        values[~near] = np.polynomial.polynomial.polyval(t[~near] ** -2.0, self._series(LONG_SERIES)[::-1]).transpose(
            1, 2, 0
        )
        values[~near, :, A] += np.log(2.0 * t[~near])
        to_powers = np.linalg.inv(np.polynomial.chebyshev.chebvander(nodes, DEGREE))
        chebyshev = np.einsum("kn,inf->ikf", to_powers, values)
        powers = np.zeros((DEGREE + 1, DEGREE + 1))
        for k in range(DEGREE + 1):
            powers[k, : k + 1] = np.polynomial.chebyshev.cheb2poly([0.0] * k + [1.0])
        coefficients = np.einsum("kp,ikf->ipf", powers, chebyshev)
        return np.ascontiguousarray(coefficients[:, ::-1, :]).ravel()

    def _integrated(self, slope: Array, low: Array, half: Array, nodes: Array) -> Array:
        """Return A at the nodes: the integral of A' from 0, interval by interval."""
        fit = np.linalg.inv(np.polynomial.chebyshev.chebvander(nodes, DEGREE))
        integral = np.polynomial.chebyshev.chebint(fit @ slope.T, lbnd=-1.0) * half
        within = np.polynomial.chebyshev.chebval(nodes, integral)
        whole = np.polynomial.chebyshev.chebval(1.0, integral)
        l0, l1, *_ = self._leading
        start = l0 * SMALL * (math.log(l1 / SMALL) + 1.0)
        before = start + np.concatenate([[0.0], np.cumsum(whole)[:-1]])
        return np.asarray(before[:, None] + within, dtype=float)

    def _series(self, terms: int) -> Array:
        """Return the far series in 1/t^2, shape (terms, 4), highest power first; A without ln(2t)."""
        of_phi, of_psi = self._moments
        rows = np.zeros((terms, 4))
        binomial = 1.0
        for k in range(terms):
            rows[k, A] = self.far_constant if k == 0 else -binomial * of_phi(k) / (2 * k)
            rows[k, T_DA] = binomial * of_phi(k)
            rows[k, B] = binomial * of_psi(k)
            rows[k, T_DB] = -2 * k * binomial * of_psi(k)
            binomial *= -(0.5 + k) / (k + 1)  # binomial(-1/2, k + 1)
        return np.ascontiguousarray(rows[::-1])


def _semi_elliptic_closed_forms(t: Array) -> tuple[Array, Array, Array]:
    square = t * t
    k2, k2_other = 1.0 / (1.0 + square), square / (1.0 + square)
    first, excess = _elliptic(k2, k2_other)
    slope = 4.0 / np.pi * np.sqrt(1.0 + square) * excess
    b = 4.0 / np.pi * np.sqrt(k2_other) * first
    t_db = 4.0 / np.pi * t * np.sqrt(k2) * excess
    return slope, b, t_db


def _elliptic(k2: Array, k2_other: Array) -> tuple[Array, Array]:
    """Return the complete elliptic integrals K and K - E of modulus squared ``k2`` = 1 - ``k2_other``.

    By the arithmetic-geometric mean (DLMF 19.8.5 and 19.8.6), which does not cancel in K - E, and in place of scipy,
    whose import takes as long as all others of a solve together.
    """
    a, b, total, weight = np.ones_like(k2), np.sqrt(k2_other), 0.5 * k2, 0.5
    for _ in range(MEANS):
        a, b, difference = 0.5 * (a + b), np.sqrt(a * b), 0.5 * (a - b)
        weight *= 2.0
        total = total + weight * difference**2
    first = 0.5 * np.pi / a
    return first, first * total


def _parabolic_closed_forms(t: Array) -> tuple[Array, Array, Array]:
    root = np.sqrt(1.0 + t * t)
    inverse = np.arcsinh(1.0 / t)
    slope = 1.0 / root + 1.5 * ((1.0 + 0.5 * t * t) * inverse - (1.0 + t * t / 6.0) / root)
    slope -= 0.25 * (root + t * t / root)
    return slope, 3.0 * t * inverse, 3.0 * t * (inverse - 1.0 / root)


def _semi_elliptic_smoothed(t: Array) -> tuple[Array, Array]:
    root = np.sqrt(1.0 + t * t)
    return 2.0 / np.pi / (root + t), 2.0 / np.pi / root**3


def _parabolic_smoothed(t: Array) -> tuple[Array, Array]:
    near, x = np.minimum(t, CANCELLING), np.maximum(t, CANCELLING) ** -2.0
    angle = np.arctan(1.0 / near)
    value = 1.5 / np.pi * ((1.0 + near * near) * angle - near)
    second = 3.0 / np.pi * (angle - near / (1.0 + near * near))
    # (1 + t^2) arctan(1/t) - t and arctan(1/t) - t / (1 + t^2), by their series in 1 / t
    powers = range(LONG_SERIES)
    far_value = sum((-x) ** k * (1.0 / (2 * k + 1) - 1.0 / (2 * k + 3)) for k in powers)
    far_second = sum((-x) ** k * (1.0 - 1.0 / (2 * k + 3)) for k in powers)
    is_far = t > CANCELLING
    return (
        np.where(is_far, 1.5 / np.pi * np.sqrt(x) * far_value, value),
        np.where(is_far, 3.0 / np.pi * x**1.5 * far_second, second),
    )


def _semi_elliptic_moment(k: int) -> float:
    """Return int (2/pi) sqrt(1 - xi^2) xi^2k."""
    return math.comb(2 * k, k) / (4.0**k * (k + 1))


def _semi_elliptic_slope_moment(k: int) -> float:
    """Return int (2/pi) xi^2k / sqrt(1 - xi^2)."""
    return 2.0 * math.comb(2 * k, k) / 4.0**k


def _parabolic_moment(k: int) -> float:
    """Return int (3/4) (1 - xi^2) xi^2k."""
    return 3.0 / ((2 * k + 1) * (2 * k + 3))


def _parabolic_slope_moment(k: int) -> float:
    """Return int (3/2) xi^2k."""
    return 3.0 / (2 * k + 1)


#: Reusner's element: semi-elliptic across, exact for line contacts and elliptical Hertz contacts.
SEMI_ELLIPTIC = Element(
    name="semi-elliptic",
    line_factor=4.0,
    hertz_ratio=1.0,
    centre_factor=2.0 / math.pi,
    far_constant=math.log(2.0) + 0.5,
    _moments=(_semi_elliptic_moment, _semi_elliptic_slope_moment),
    _closed_forms=_semi_elliptic_closed_forms,
    # A' = (4/pi) (ln(4/t) - 1), B = (4/pi) t ln(4/t)
    _leading=(4.0 / math.pi, 4.0 / math.e, 4.0 / math.pi, 4.0),
    smoothed=_semi_elliptic_smoothed,
)

#: The paper's element: parabolic across, with the bias that this shape introduces (see docs/explain/theory.md).
PARABOLIC = Element(
    name="parabolic",
    line_factor=6.0,
    hertz_ratio=math.sqrt(2.0 / 3.0),
    centre_factor=0.75,
    far_constant=4.0 / 3.0,
    _moments=(_parabolic_moment, _parabolic_slope_moment),
    _closed_forms=_parabolic_closed_forms,
    # A' = 3/2 (ln(2/t) - 1) + 1 - 1/4 = 3/2 (ln(2/t) - 1/2), B = 3 t ln(2/t)
    _leading=(1.5, 2.0 / math.sqrt(math.e), 3.0, 2.0),
    smoothed=_parabolic_smoothed,
)

ELEMENTS = {element.name: element for element in (SEMI_ELLIPTIC, PARABOLIC)}
