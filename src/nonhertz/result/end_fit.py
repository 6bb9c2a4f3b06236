"""The strength K of a singular end, from the strips near it.

At distances s small compared with the half-width the equations of the strips are those of a plane wedge. Pressures of
``s^-alpha``, ``s^alpha`` and ``s^(2 - alpha)`` (other powers at a free end) displace its surface by smooth terms only,
so the pressure is ``K s^-alpha (1 + c s^(2 alpha) + d s^2 + ...)``. Strips have one pressure each and satisfy the
equations at their centres only; on the automatic grid that makes the last one wrong by 5 %, the third by 2 %, the
seventh by 0.5 %, however narrow they are. So the powers themselves are not fitted to the pressures of the strips, but
their discrete equivalents: the constant pressures on these strips that displace their centres exactly as the power
does, by the kernel ln|s - s'| + kappa ln(s + s') of the wedge and the term of a free face. The displacements under a
power have closed forms.

What remains is that strips are semi-elliptic across up to the end, where the true contact flares. Solutions that leave
the shape across free (`docs/end_study.py`) have a lower K by a factor that depends almost only on kappa. For ends that
are free of normal stress, too, there is no such solution, and no factor.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nonhertz.bodies.ends import edge_powers
from nonhertz.bodies.quarter_space import edge_kernel
from nonhertz.strip.element import SEMI_ELLIPTIC, Element

Array = NDArray[np.float64]

# Both in half-widths. The fit's three powers describe the pressure to 0.1 % that far; strips farther away than the
# second are not affected by the end.
FIT_REACH, WEDGE_REACH = 0.5, 1.0
FEWEST_STRIPS = 4
_NODES, _PANELS = 12, 60  # of integrals over powers
# K of semi-elliptic strips over the true one is 1 + FLARE (1 - kappa): within 0.1 % for contacts longer than 30
# half-widths, 0.5 % for those 4 long. Parabolic strips have no such factor: theirs depends on the profile.
FLARE = 0.006


def fit_strength(
    edges: Array, pressure: Array, freed: tuple[float, float], half_width: float, element: Element
) -> tuple[float | None, float | None]:
    """Return K [MPa mm^alpha] and c [mm^-beta] of p = K s^-alpha (1 + c s^beta).

    The powers are those of `nonhertz.bodies.ends.edge_powers`. K is the limit at the end; c makes the two terms fit the
    strips up to half a half-width as well as they can.

    Parameters
    ----------
    edges : ndarray, shape (n + 1,)
        Distances of the strips' edges from the end [mm], ascending from 0.
    pressure : ndarray, shape (n,)
        Pressures of the strips on the centre line [MPa], outermost strip first.
    freed : tuple of float
        kappa of the end, and the part of it that is also free of normal stress.
    half_width : float
        Half-width of the last strip [mm].
    element : Element
        The element of the strips.

    Returns
    -------
    tuple of two floats
        None both if fewer than four strips in contact lie within half a half-width of the end, or the loop failed.
    """
    centre = 0.5 * (edges[1:] + edges[:-1])
    idle = np.flatnonzero(pressure == 0.0)
    run = int(idle[0]) if idle.size else pressure.size
    near = int(np.count_nonzero(centre[:run] < FIT_REACH * half_width))
    if near < FEWEST_STRIPS or not np.all(np.isfinite(1.0 / pressure[:near])):
        return None, None
    affected = int(np.count_nonzero(centre[:run] < WEDGE_REACH * half_width))
    kappa, free = freed
    powers = edge_powers(kappa, free)
    of_powers = _wedge_pressures(edges[: affected + 1] / half_width, kappa, free, np.array(powers))
    relative = of_powers[:near] / pressure[:near, None]
    strength = float(np.linalg.lstsq(relative, np.ones(near), rcond=None)[0][0])
    if strength <= 0.0:
        return None, None
    if element == SEMI_ELLIPTIC and not free:
        strength /= 1.0 + FLARE * (1.0 - kappa)
    # Weighted by their widths, or the many narrow strips next to the end would decide.
    first, second, width = relative[:, 0], relative[:, 1], np.diff(edges[: near + 1])
    residual = width * (1.0 - strength * first)
    correction = float(residual @ second / (width * second @ second)) / strength
    return strength * half_width ** -powers[0], correction * half_width ** (powers[0] - powers[1])


def _wedge_pressures(edges: Array, kappa: float, free: float, powers: Array) -> Array:
    """Return the constant pressures of strips that displace their centres as the pressures s^power do.

    Parameters
    ----------
    edges : ndarray, shape (n + 1,)
        Distances from the end, ascending from 0; the pressures end with the last one.
    kappa : float
        Weight of the image about the end.
    free : float
        Weight of the term that a free face adds to the image.
    powers : ndarray, shape (k,)
        Above -1, and not integer.

    Returns
    -------
    ndarray, shape (n, k)
    """
    length = edges[-1]
    y = edges / length
    centre = 0.5 * (y[1:] + y[:-1])
    to_edges = _integral_of_log(y - centre[:, None]) + kappa * _integral_of_log(y + centre[:, None])
    of_strips = to_edges[:, 1:] - to_edges[:, :-1]
    moved = wedge_displacement(centre[:, None], kappa, powers)
    if free:
        node, share = np.polynomial.legendre.leggauss(_NODES)
        width = np.diff(y)[:, None]
        # Logarithms here are positive where displacements are negative, of loads twice as large.
        added = edge_kernel(centre[:, None, None], centre[:, None] + 0.5 * width * node) @ share
        of_strips = of_strips - 0.25 * free * added * width.T
        moved = moved - 0.5 * free * integrate_free_edge(centre, powers)
    pressures: Array = np.linalg.solve(of_strips, moved) * length**powers
    return pressures


def integrate_free_edge(x: Array, powers: Array) -> Array:
    """Return the integrals over t from 0 to 1 of t^power times the term of a free edge at x, shape (n, k)."""
    node, share = np.polynomial.legendre.leggauss(_NODES)
    panels: Array = 2.0 ** np.arange(-_PANELS, 1.0)
    half = 0.5 * np.diff(panels)[:, None]
    t, weight = (panels[:-1, None] + half * (1.0 + node)).ravel(), (half * share).ravel()
    added: Array = (edge_kernel(x[:, None], t) * weight) @ t[:, None] ** powers
    at_edge = edge_kernel(x, np.zeros(1))[:, None]
    whole: Array = added + at_edge * panels[0] ** (1.0 + powers) / (1.0 + powers)
    return whole


def _integral_of_log(x: Array) -> Array:
    """Return the integral of ln|t| from 0 to x; x is not zero."""
    integral: Array = x * (np.log(np.abs(x)) - 1.0)
    return integral


def wedge_displacement(x: Array, kappa: float, power: Array) -> Array:
    """Return the integral over t from 0 to 1 of t^power [ln|x - t| + kappa ln(x + t)], 0 < x < 1.

    Integrated by parts, with m = power + 1. The principal value of t^m / (x - t) from 0 to infinity is, continued
    analytically in m, pi cot(pi m) x^m. Its part beyond 1 and the integral of t^m / (x + t) are hypergeometric
    functions (DLMF 15.6.1).
    """
    # Imported here, because importing scipy takes longer than everything else that this package imports at first.
    from scipy.special import hyp2f1

    m = power + 1.0
    direct = np.pi / np.tan(np.pi * m) * x**m - hyp2f1(1.0, -m, 1.0 - m, x) / m
    image = -hyp2f1(1.0, m + 1.0, m + 2.0, -1.0 / x) / (x * (m + 1.0))
    moved: Array = (np.log1p(-x) + direct + kappa * (np.log1p(x) + image)) / m
    return moved
