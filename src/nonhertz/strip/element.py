"""The two strip elements, each four functions of one variable.

A strip is uniform along y between two edges and carries, across the contact, a pressure of fixed shape phi on
|x| <= a. Seen from a point on the centre line at the signed distance y' of one of its edges, everything it does
there is a function of t = y'/a alone, and the strip's effect is the difference between its two edges (theory:
docs/explain/theory.md). With a load q per unit length and a half-space compliance K,

    displacement            w             = K q [A]             A'(t)   = int phi / sqrt(xi^2 + t^2) dxi
    curvature               -d2w/dx2      = K q [B] / a^2       B(t)    = int psi t / sqrt(xi^2 + t^2) dxi
    derivatives by a        through tA' and tB'                 t B'(t) = int psi t xi^2 / (xi^2 + t^2)^(3/2) dxi

where psi = -phi'/xi. Both shapes have closed forms, but the solver needs millions of values: the core reads all
four functions from one table of polynomials, eight intervals per octave of t, located from the bits of t without
a logarithm. It makes the table once, when it is loaded: from the closed forms up to t = 8, and beyond, where these
begin to cancel, from a series in 1/t^2 whose coefficients are moments of phi. Beyond t = 256 a few terms of the series
suffice.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.native import core

Array = NDArray[np.float64]


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

    def __repr__(self) -> str:
        return f"Element({self.name!r})"

    def functions(self, t: ArrayLike) -> tuple[Array, Array, Array, Array]:
        """Return A, t A', B and t B' at ``t``, arrays of its shape, odd in t.

        The relative error is below 1e-12 for |t| from 1e-8 to 1e8.
        """
        t = np.asarray(t, dtype=float)
        values = core.evaluate(self.core, np.ascontiguousarray(t).ravel())
        return tuple(values[:, k].reshape(t.shape) for k in range(4))  # type: ignore[return-value]

    @property
    def core(self) -> core.Element:
        """The element in the core."""
        return {"semi-elliptic": core.SEMI_ELLIPTIC, "parabolic": core.PARABOLIC}[self.name]


#: Reusner's element: semi-elliptic across, exact for line contacts and elliptical Hertz contacts.
SEMI_ELLIPTIC = Element(
    name="semi-elliptic",
    line_factor=4.0,
    hertz_ratio=1.0,
    centre_factor=2.0 / math.pi,
    far_constant=math.log(2.0) + 0.5,
)

#: The paper's element: parabolic across, with the bias that this shape introduces (see docs/explain/theory.md).
PARABOLIC = Element(
    name="parabolic",
    line_factor=6.0,
    hertz_ratio=math.sqrt(2.0 / 3.0),
    centre_factor=0.75,
    far_constant=4.0 / 3.0,
)

ELEMENTS = {element.name: element for element in (SEMI_ELLIPTIC, PARABOLIC)}
