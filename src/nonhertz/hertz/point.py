"""The point contact of Hertz.

Over an ellipse of half-width b (across, x) and half-length a (along, y) the pressure p = p0 sqrt(1 - (x/b)^2 -
(y/a)^2) presses a half-space into a paraboloid. In Carlson's symmetric elliptic integrals the three conditions of
Hertz read

    1/Rx = K Q R_D(0, a^2, b^2)      1/Ry = K Q R_D(0, b^2, a^2)      delta = (3/2) K Q R_F(0, a^2, b^2)

with K the sum of both half-space compliances (1 - nu^2) / (pi E) and Q the load. Every integrand is positive, so
nothing cancels; the usual forms, (K(e) - E(e)) / e^2 and the like, lose all digits near the circle, and their modulus
e loses them in slender contacts. Rx/Ry is a function of b/a alone. The slope of ln(Rx/Ry) over ln(b/a) rises from 3/2
at the circle to 2 in the limit of slender contacts (both limits derived, monotonicity between them found numerically),
so a step of 4/7 of the error in ln(Rx/Ry) leaves at most a seventh of the error in ln(b/a), from any start. That is
the whole solver: no bracket, no derivative, and only rounding error is left after twenty steps.
"""

from __future__ import annotations

import cmath
import math
from dataclasses import dataclass
from numbers import Real

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.errors import InputError, shown
from nonhertz.hertz.pair import PLACES_REMEDY, Materials, semicircle, total_compliance
from nonhertz.inputs.checks import LEAST, finite, numbers, positive
from nonhertz.inputs.short_repr import ShortRepr

Array = NDArray[np.float64]
Pair = tuple[float, float]

_RADIUS_REMEDY = (
    "give the combined radius 1 / (1/R_a + 1/R_b) in mm, or a pair of both bodies' radii; a contact of parallel "
    "straight bodies is a line_contact"
)
# Near a ratio of 1e-300 the integrals leave the range of double precision, and each decade adds rounding error.
_SMALLEST_RADIUS_RATIO = 1e-100


@dataclass(frozen=True, kw_only=True, repr=False)
class PointContact(ShortRepr):
    """A Hertz contact over an ellipse, as made by `point_contact`.

    Parameters
    ----------
    load : float
        Load Q [N].
    radius_x, radius_y : float
        Combined radii of curvature Rx across and Ry along the contact [mm].
    compliance : float
        Sum of both half-space compliances K = (1 - nu^2) / (pi E) [1/MPa].
    half_width : float
        Semi-axis b across the contact, in x [mm].
    half_length : float
        Semi-axis a along the contact, in y [mm].
    max_pressure : float
        Pressure p0 in the middle [MPa].
    approach : float
        Approach delta of points of the two bodies far from the contact [mm].
    turned : float
        Angle from x of body a to x of the contact [rad], within 45 degrees; 0 unless the bodies lie at an angle.
    """

    load: float
    radius_x: float
    radius_y: float
    compliance: float
    half_width: float
    half_length: float
    max_pressure: float
    approach: float
    turned: float = 0.0

    @property
    def ellipticity(self) -> float:
        """Ratio a / b of half-length to half-width [-]; below 1 where the contact is wider than long."""
        return self.half_length / self.half_width

    @property
    def stiffness(self) -> float:
        """Stiffness dQ / d delta = (3/2) Q / delta [N/mm], since Q grows with delta^(3/2)."""
        return 1.5 * self.load / self.approach

    def pressure(self, y: ArrayLike, *, x: ArrayLike = 0.0) -> Array:
        """Return the pressure p0 sqrt(1 - (x/b)^2 - (y/a)^2) [MPa], zero outside the ellipse.

        Parameters
        ----------
        y, x : array_like
            Positions along and across the contact [mm] from its middle, broadcast against each other;
            on the centre line if ``x`` is left out.

        Returns
        -------
        ndarray
            Pressure [MPa], of the broadcast shape.

        Examples
        --------
        >>> contact = point_contact(load=1000, radius_x=10, radius_y=100, compliance=2.8e-6)
        >>> contact.pressure([0.0, contact.half_length]).round(1).tolist()
        [1545.7, 0.0]
        """
        across = numbers("x", x, PLACES_REMEDY) / self.half_width
        along = numbers("y", y, PLACES_REMEDY) / self.half_length
        return np.asarray(self.max_pressure * semicircle(np.hypot(across, along)))

    def half_width_at(self, y: ArrayLike) -> Array:
        """Return the half-width b sqrt(1 - (y/a)^2) [mm] at ``y`` [mm], zero beyond the ends."""
        return np.asarray(self.half_width * semicircle(numbers("y", y, PLACES_REMEDY) / self.half_length))

    def line_load_at(self, y: ArrayLike) -> Array:
        """Return the load per unit length 3Q/(4a) (1 - (y/a)^2) [N/mm] at ``y`` [mm], zero beyond the ends.

        It is the pressure integrated across the contact: what a strip at ``y`` carries per unit length.
        """
        share = semicircle(numbers("y", y, PLACES_REMEDY) / self.half_length) ** 2
        return np.asarray(0.75 * self.load / self.half_length * share)


def point_contact(
    *,
    radius_x: float | Pair,
    radius_y: float | Pair,
    compliance: float | None = None,
    e_star: float | None = None,
    materials: Materials | None = None,
    angle: float = 0.0,
    load: float | None = None,
    approach: float | None = None,
) -> PointContact:
    """Return the Hertz contact of two bodies that first touch at a point.

    Give either the load or the approach. The undeformed gap is x^2 / (2 Rx) + y^2 / (2 Ry); either radius may
    be the larger one.

    Parameters
    ----------
    radius_x, radius_y : float or pair of float
        Combined radii of curvature Rx across and Ry along the contact [mm], 1/R = 1/R_a + 1/R_b, positive. Or pairs of
        the radii of body a and body b, each in its own principal planes: negative if concave, infinite if straight.
    compliance : float, optional
        Sum of both half-space compliances K = (1 - nu^2) / (pi E) [1/MPa]: ``Contact.compliance``. Give this,
        ``e_star`` or ``materials``.
    e_star : float, optional
        Contact modulus E* = 1 / (pi K), with 1/E* = (1 - nu_a^2) / E_a + (1 - nu_b^2) / E_b [MPa].
    materials : pair of Material or str, optional
        Materials of body a and body b, or their names.
    angle : float
        Angle from x of body a to x of body b [rad], where radii are pairs.
    load : float, optional
        Load Q [N], positive.
    approach : float, optional
        Approach delta [mm], positive.

    Returns
    -------
    PointContact
        Semi-axes, pressure, approach and quantities derived from them.

    Raises
    ------
    InputError
        If a value is not positive and finite, if not exactly one of ``load`` and ``approach`` is given, if the bodies
        do not touch at a single point, or if the radii differ by more than a factor of 1e100.

    Notes
    -----
    Holds for smooth elastic bodies without friction and a contact small compared with both radii and both bodies.
    Results are within 1e-13 of the exact solution for radius ratios from 1e-12 to 1e12.

    References
    ----------
    H. Hertz, Ueber die Beruehrung fester elastischer Koerper, Journal fuer die reine und angewandte
    Mathematik 92 (1882) 156-171, doi:10.1515/crll.1882.92.156. K. L. Johnson, Contact Mechanics, Cambridge
    University Press, 1985, Eqs. (4.3)-(4.5) and (4.25)-(4.28), doi:10.1017/CBO9781139171731. B. C. Carlson, Numerical
    computation of real or complex elliptic integrals, Numerical Algorithms 10 (1995) 13-26,
    doi:10.1007/BF02198293.

    Examples
    --------
    >>> round(point_contact(load=1000, radius_x=10, radius_y=100, materials=("steel", "steel")).max_pressure)
    1546
    >>> contact = point_contact(load=1000, radius_x=10, radius_y=100, compliance=2.8e-6)
    >>> round(contact.half_width, 4), round(contact.half_length, 4), round(contact.approach, 6)
    (0.262, 1.1789, 0.010382)
    >>> back = point_contact(approach=contact.approach, radius_x=10, radius_y=100, compliance=2.8e-6)
    >>> round(back.load, 9)
    1000.0

    Two cylinders of radius 10 mm, their axes crossed by 60 degrees:

    >>> straight = {"radius_x": (10.0, 10.0), "radius_y": (math.inf, math.inf), "angle": math.radians(60)}
    >>> crossed = point_contact(load=1000, compliance=2.8e-6, **straight)
    >>> round(crossed.radius_x, 4), round(crossed.radius_y, 4), round(math.degrees(crossed.turned), 4)
    (6.6667, 20.0, 30.0)
    """
    radius_x, radius_y, turned = _combine_radii(radius_x, radius_y, angle)
    compliance = total_compliance(compliance, e_star, materials)
    # Ordering the radii first makes a contact and its mirror image about x = y agree to the last bit.
    short_radius, long_radius = sorted((radius_x, radius_y))
    if short_radius / long_radius < _SMALLEST_RADIUS_RATIO:
        condition = f"lie within a factor of 1e100 of radius_x = {shown(radius_x)}"
        raise InputError("radius_y", radius_y, condition, "use line_contact for straight bodies")

    slenderness = _axis_ratio(short_radius / long_radius)
    from scipy.special import elliprd, elliprf

    displacement = 1.5 * float(elliprf(0.0, slenderness**2, 1.0))  # delta a / (K Q)
    curvature = float(elliprd(0.0, slenderness**2, 1.0))  # a^3 / (K Q R), R the long radius
    # The curvature condition with the long radius is used: it hardly depends on the axis ratio.
    if load is not None and approach is None:
        positive("load", load, "give the load in N, or the approach in mm instead")
        load = float(load)
        major = math.cbrt(compliance * load * long_radius * curvature)
        approach = compliance * load * displacement / major
    elif approach is not None and load is None:
        positive("approach", approach, "give the approach in mm, or the load in N instead")
        approach = float(approach)
        major = math.sqrt(approach * long_radius * curvature / displacement)
        load = major**3 / (compliance * long_radius * curvature)
    else:
        condition = "be given" if load is None else f"be left out where approach = {shown(approach)} is given"
        raise InputError("load", load, condition, "give either the load in N or the approach in mm")
    minor = slenderness * major
    half_width, half_length = (minor, major) if radius_x <= radius_y else (major, minor)
    return PointContact(
        load=load,
        radius_x=radius_x,
        radius_y=radius_y,
        compliance=compliance,
        half_width=half_width,
        half_length=half_length,
        max_pressure=1.5 * load / (math.pi * minor * major),
        approach=approach,
        turned=turned,
    )


def _combine_radii(radius_x: float | Pair, radius_y: float | Pair, angle: float) -> tuple[float, float, float]:
    """Return combined radii, for pairs those of bodies at an angle, and the angle from x of body a to x of both."""
    turned = 0.0
    finite("angle", angle, "give the angle between the planes of x of both bodies in rad")
    if isinstance(radius_x, tuple | list) or isinstance(radius_y, tuple | list) or angle != 0.0:
        radius_x, radius_y, turned = _combine_pairs(radius_x, radius_y, angle)
    positive("radius_x", radius_x, _RADIUS_REMEDY)
    positive("radius_y", radius_y, _RADIUS_REMEDY)
    return float(radius_x), float(radius_y), turned


def _combine_pairs(radius_x: object, radius_y: object, angle: float) -> tuple[float, float, float]:
    """Return the combined radii of two bodies at an angle, and the angle from x of body a to x of the contact."""
    (ax, bx), (ay, by) = _curvatures("radius_x", radius_x), _curvatures("radius_y", radius_y)
    # A body's curvature in a plane at phi from its x is its mean plus its half-difference times cos 2 phi.
    mean, half = 0.5 * (ax + ay + bx + by), 0.5 * (ax - ay) + 0.5 * (bx - by) * cmath.exp(2j * angle)
    larger = mean + abs(half)
    cosine, sine = math.cos(angle) ** 2, math.sin(angle) ** 2
    # The determinant instead of mean - |half|, which cancels where the axes are nearly parallel.
    determinant = ax * ay + bx * by + (ax * by + ay * bx) * cosine + (ax * bx + ay * by) * sine
    if not (larger > 0.0 and determinant > 0.0):
        remedy = "raise the radii of the concave body; a contact of parallel straight bodies is a line_contact"
        raise InputError("radius_x", radius_x, "leave a gap that opens in every direction", remedy)
    smaller = determinant / larger
    along = half if half.real >= 0.0 else -half
    x, y = (larger, smaller) if half.real >= 0.0 else (smaller, larger)
    return 1.0 / x, 1.0 / y, 0.5 * cmath.phase(along)


def _curvatures(name: str, radii: object) -> list[float]:
    """Return the curvatures of both bodies from a pair of radii."""
    pair = list(radii) if isinstance(radii, tuple | list) else []
    if len(pair) != 2 or not all(isinstance(radius, Real) and abs(float(radius)) >= LEAST for radius in pair):
        condition = "be a pair of radii other than zero where one radius is a pair or an angle is given"
        raise InputError(name, radii, condition, "give those of body a and body b in mm, infinite where straight")
    return [1.0 / float(radius) for radius in pair]


def _axis_ratio(radius_ratio: float) -> float:
    """Return b/a <= 1 for Rx/Ry <= 1, by the iteration in the module's docstring."""
    from scipy.special import elliprd

    target = math.log(radius_ratio)
    log_ratio = target / 1.75
    # The start is off by at most 22 (at a radius ratio of 1e-100), and 22 / 7^20 is below rounding.
    for _ in range(20):
        squared = math.exp(2.0 * log_ratio)
        reached = math.log(float(elliprd(0.0, squared, 1.0)) / float(elliprd(0.0, 1.0, squared)))
        log_ratio += (target - reached) / 1.75
    return math.exp(log_ratio)
