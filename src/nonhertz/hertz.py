"""Hertz's closed forms: the point contact, the line contact, and the compression in a line contact.

Everything else in the package is checked against this module, so it has to be accurate to the last digits for
every shape, from the circle to a contact a million times longer than wide. Over an ellipse of half-width b
(across, x) and half-length a (along, y) the pressure p = p0 sqrt(1 - (x/b)^2 - (y/a)^2) presses a half-space
into a paraboloid. In Carlson's symmetric elliptic integrals the three conditions of Hertz read

    1/Rx = K Q R_D(0, a^2, b^2)      1/Ry = K Q R_D(0, b^2, a^2)      delta = (3/2) K Q R_F(0, a^2, b^2)

with K the sum of both half-space compliances (1 - nu^2) / (pi E) and Q the load. Every integrand is positive,
so nothing cancels; the usual forms, (K(e) - E(e)) / e^2 and the like, lose all digits near the circle, and
their modulus e loses them in slender contacts. Rx/Ry is a function of b/a alone. The slope of ln(Rx/Ry) over
ln(b/a) rises from 3/2 at the circle to 2 in the limit of slender contacts (both limits derived, monotonicity
between them found numerically), so a step of 4/7 of the error in ln(Rx/Ry) leaves at most a seventh of the
error in ln(b/a), from any start. That is the whole solver: no bracket, no derivative, and only rounding error is
left after twenty steps.
"""

from __future__ import annotations

import cmath
import math
from dataclasses import dataclass
from numbers import Real

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.amounts import mm
from nonhertz.errors import InputError, shown
from nonhertz.inputs.checks import LEAST, finite, number_that, numbers, positive
from nonhertz.model.material import Material, check_poisson

__all__ = [
    "LineContact",
    "PointContact",
    "half_space_line_compression",
    "line_contact",
    "plane_strain_cylinder_compression",
    "point_contact",
]

Array = NDArray[np.float64]

_RADIUS_REMEDY = (
    "give the combined radius 1 / (1/R_a + 1/R_b) in mm, or a pair of both bodies' radii; a contact of parallel "
    "straight bodies is a line_contact"
)
_COMPLIANCE_REMEDY = "give the sum of both bodies' (1 - nu^2) / (pi E) in 1/MPa, which is Contact.compliance"

_PLACES_REMEDY = "give positions in mm"

# Near a ratio of 1e-300 the integrals leave the range of double precision, and each decade adds rounding error.
_SMALLEST_RADIUS_RATIO = 1e-100


@dataclass(frozen=True, kw_only=True)
class PointContact:
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

    def pressure(self, y: ArrayLike, x: ArrayLike = 0.0) -> Array:
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
        across = numbers("x", x, _PLACES_REMEDY) / self.half_width
        along = numbers("y", y, _PLACES_REMEDY) / self.half_length
        return np.asarray(self.max_pressure * _semicircle(np.hypot(across, along)))

    def half_width_at(self, y: ArrayLike) -> Array:
        """Return the half-width b sqrt(1 - (y/a)^2) [mm] at ``y`` [mm], zero beyond the ends."""
        return np.asarray(self.half_width * _semicircle(numbers("y", y, _PLACES_REMEDY) / self.half_length))

    def line_load_at(self, y: ArrayLike) -> Array:
        """Return the load per unit length 3Q/(4a) (1 - (y/a)^2) [N/mm] at ``y`` [mm], zero beyond the ends.

        It is the pressure integrated across the contact: what a strip at ``y`` carries per unit length.
        """
        share = _semicircle(numbers("y", y, _PLACES_REMEDY) / self.half_length) ** 2
        return np.asarray(0.75 * self.load / self.half_length * share)


@dataclass(frozen=True, kw_only=True)
class LineContact:
    """A Hertz contact over an infinitely long strip, as made by `line_contact`.

    It has no approach of its own: in plane strain the displacement grows without bound with the distance of
    the point that it is measured against. `plane_strain_cylinder_compression` and
    `half_space_line_compression` each choose such a point.

    Parameters
    ----------
    line_load : float
        Load per unit length q [N/mm].
    radius : float
        Combined radius of curvature rho across the contact [mm].
    compliance : float
        Sum of both half-space compliances K = (1 - nu^2) / (pi E) [1/MPa].
    half_width : float
        Half-width b [mm].
    max_pressure : float
        Pressure p0 on the centre line [MPa].
    """

    line_load: float
    radius: float
    compliance: float
    half_width: float
    max_pressure: float

    def pressure(self, x: ArrayLike) -> Array:
        """Return the pressure p0 sqrt(1 - (x/b)^2) [MPa] at ``x`` [mm] across, zero outside."""
        return np.asarray(self.max_pressure * _semicircle(numbers("x", x, _PLACES_REMEDY) / self.half_width))

    def stress(self, x: ArrayLike, z: ArrayLike, poisson: float) -> Array:
        """Return the plane-strain stress below the surface [MPa], compressive stress negative.

        With zeta = x + i z and s = sqrt(zeta^2 - b^2) it is

            sigma_x, sigma_z = Im F +- z Re F'     tau_xz = -z Im F'     sigma_y = nu (sigma_x + sigma_z)

        with plus for x and minus for z, where F = p0 b / (zeta + s) and F' = -F / s.

        Parameters
        ----------
        x, z : array_like
            Positions across and depths below the surface [mm], z >= 0, broadcast against each other.
        poisson : float
            Poisson's ratio nu [-] of the body.

        Returns
        -------
        ndarray
            sigma_x, sigma_y, sigma_z, tau_yz, tau_xz, tau_xy along the last axis, as in `nonhertz.subsurface.Field`.

        References
        ----------
        E. McEwen, Stresses in elastic cylinders in contact along a generatrix, Philosophical Magazine 40 (1949)
        454-459, doi:10.1080/14786444908521733. K. L. Johnson, Contact Mechanics, Cambridge University Press, 1985,
        section 4.2, doi:10.1017/CBO9781139171731.

        Examples
        --------
        >>> contact = line_contact(line_load=1000, radius=10, compliance=2.8e-6)
        >>> shear = contact.stress(0.866025 * contact.half_width, 0.5 * contact.half_width, 0.3)[4]
        >>> round(float(shear / contact.max_pressure), 4)
        -0.25
        """
        x, z = numbers("x", x, _PLACES_REMEDY), numbers("z", z, _PLACES_REMEDY)
        if np.any(z < 0.0):
            raise InputError("z", float(z.min()), "not be negative", "z points into the body, from 0 on its surface")
        check_poisson("poisson", poisson)
        zeta = (x + 1j * z) / self.half_width
        # Separate square roots, for the branch that behaves as zeta far away.
        root = np.sqrt(zeta - 1.0) * np.sqrt(zeta + 1.0)
        transform = self.max_pressure / (zeta + root)
        with np.errstate(divide="ignore", invalid="ignore"):
            # On the surface the second term vanishes, even at the edges, where its factor is infinite.
            slope = np.where(zeta.imag > 0.0, zeta.imag * transform / root, 0.0)
        across, below = transform.imag - slope.real, transform.imag + slope.real
        none = np.zeros_like(across)
        return np.stack([across, poisson * (across + below), below, none, slope.imag, none], axis=-1)


def point_contact(
    *,
    radius_x: float | tuple[float, float],
    radius_y: float | tuple[float, float],
    compliance: float,
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
        those of body a and body b, each in its own principal planes: negative concave, infinite straight.
    compliance : float
        Sum of both half-space compliances K = (1 - nu^2) / (pi E) [1/MPa]: ``Contact.compliance``.
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
        do not touch at a point alone, or if the radii differ by more than a factor of 1e100.

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
    turned = 0.0
    finite("angle", angle, "give the angle between the planes of x of both bodies in rad")
    if isinstance(radius_x, tuple | list) or isinstance(radius_y, tuple | list) or angle != 0.0:
        radius_x, radius_y, turned = _combined(radius_x, radius_y, angle)
    positive("radius_x", radius_x, _RADIUS_REMEDY)
    positive("radius_y", radius_y, _RADIUS_REMEDY)
    positive("compliance", compliance, _COMPLIANCE_REMEDY)
    radius_x, radius_y, compliance = float(radius_x), float(radius_y), float(compliance)
    # Ordering the radii first makes a contact and its mirror image about x = y agree to the last bit.
    short_radius, long_radius = sorted((radius_x, radius_y))
    if short_radius / long_radius < _SMALLEST_RADIUS_RATIO:
        condition = f"lie within a factor of 1e100 of radius_x = {shown(radius_x)}"
        raise InputError("radius_y", radius_y, condition, "use line_contact for straight bodies")

    slenderness = _axis_ratio(short_radius / long_radius)
    from scipy.special import elliprd, elliprf

    displacement = 1.5 * float(elliprf(0.0, slenderness**2, 1.0))  # delta a / (K Q)
    curvature = float(elliprd(0.0, slenderness**2, 1.0))  # a^3 / (K Q R), R the long radius
    # Of the two curvature conditions the one with the long radius is used: it hardly depends on the axis ratio.
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


def _combined(radius_x: object, radius_y: object, angle: float) -> tuple[float, float, float]:
    """Return the combined radii of two bodies at an angle, and the angle from x of body a to x of the contact."""
    curvatures = []
    for name, radii in (("radius_x", radius_x), ("radius_y", radius_y)):
        pair = list(radii) if isinstance(radii, tuple | list) else []
        if len(pair) != 2 or not all(isinstance(radius, Real) and abs(float(radius)) >= LEAST for radius in pair):
            condition = "be a pair of radii other than zero where one radius is a pair or an angle is given"
            raise InputError(name, radii, condition, "give those of body a and body b in mm, infinite where straight")
        curvatures.append([1.0 / float(radius) for radius in pair])
    (ax, bx), (ay, by) = curvatures
    # A body's curvature in a plane at phi from its x is its mean plus its half-difference times cos 2 phi.
    mean, half = 0.5 * (ax + ay + bx + by), 0.5 * (ax - ay) + 0.5 * (bx - by) * cmath.exp(2j * angle)
    larger = mean + abs(half)
    cosine, sine = math.cos(angle) ** 2, math.sin(angle) ** 2
    # The determinant in place of mean - |half|, which cancels where the axes are all but parallel.
    determinant = ax * ay + bx * by + (ax * by + ay * bx) * cosine + (ax * bx + ay * by) * sine
    if not (larger > 0.0 and determinant > 0.0):
        remedy = "raise the radii of the concave body; a contact of parallel straight bodies is a line_contact"
        raise InputError("radius_x", radius_x, "leave a gap that opens in every direction", remedy)
    smaller = determinant / larger
    along = half if half.real >= 0.0 else -half
    x, y = (larger, smaller) if half.real >= 0.0 else (smaller, larger)
    return 1.0 / x, 1.0 / y, 0.5 * cmath.phase(along)


def line_contact(*, line_load: float, radius: float, compliance: float) -> LineContact:
    """Return the Hertz contact of two bodies that first touch along a line.

    b^2 = 4 K q rho and p0 = 2 q / (pi b).

    Parameters
    ----------
    line_load : float
        Load per unit length q [N/mm], positive.
    radius : float
        Combined radius of curvature rho across the contact [mm], 1/rho = 1/rho_a + 1/rho_b, positive.
    compliance : float
        Sum of both half-space compliances K = (1 - nu^2) / (pi E) [1/MPa]: ``Contact.compliance``.

    Returns
    -------
    LineContact
        Half-width, pressure and quantities derived from them.

    Raises
    ------
    InputError
        If a value is not positive and finite.

    Notes
    -----
    Plane strain, without friction, for a half-width small compared with both radii.

    References
    ----------
    K. L. Johnson, Contact Mechanics, Cambridge University Press, 1985, Eqs. (4.43)-(4.45),
    doi:10.1017/CBO9781139171731.

    Examples
    --------
    >>> contact = line_contact(line_load=1000, radius=10, compliance=2.8e-6)
    >>> round(contact.half_width, 4), round(contact.max_pressure, 1)
    (0.3347, 1902.3)
    """
    positive("line_load", line_load, "give the load per unit length in N/mm")
    positive("radius", radius, "give the combined radius 1 / (1/rho_a + 1/rho_b) across the contact in mm")
    positive("compliance", compliance, _COMPLIANCE_REMEDY)
    half_width = 2.0 * math.sqrt(compliance * line_load * radius)
    return LineContact(
        line_load=float(line_load),
        radius=float(radius),
        compliance=float(compliance),
        half_width=half_width,
        max_pressure=2.0 * float(line_load) / (math.pi * half_width),
    )


def plane_strain_cylinder_compression(contact: LineContact, *, diameter: float, material: Material) -> float:
    """Return how far the axis of a long solid cylinder moves towards its line contact [mm].

    delta = q K1 (2 ln(4R/b) - 1), with R = D/2 and K1 the compliance of this cylinder alone. The load enters
    at the contact and leaves at the opposite side of the cylinder, so the diameter between two equal contacts
    shortens by twice as much, and two cylinders approach by the sum of both values.

    Parameters
    ----------
    contact : LineContact
        The contact; gives the line load q and the half-width b.
    diameter : float
        Diameter D of the cylinder [mm], larger than the width of the contact.
    material : Material
        Material of the cylinder.

    Returns
    -------
    float
        Compression from the centre to the contact [mm].

    Raises
    ------
    InputError
        If ``contact`` or ``material`` has the wrong type, or the diameter is not larger than 2b.

    Notes
    -----
    Plane strain, for b small compared with R: the neglected terms are of the order of q K1 (b/R)^2.

    References
    ----------
    K. L. Johnson, Contact Mechanics, Cambridge University Press, 1985, Section 5.6, Eq. (5.57),
    doi:10.1017/CBO9781139171731.

    Examples
    --------
    >>> from nonhertz.model.material import STEEL
    >>> contact = line_contact(line_load=1000, radius=10, compliance=2 * STEEL.compliance)
    >>> round(plane_strain_cylinder_compression(contact, diameter=20, material=STEEL), 6)
    0.011989
    """
    if not isinstance(material, Material):
        raise InputError("material", material, "be a Material", "use nonhertz.Material(modulus, poisson)")
    _refuse_wider(contact, "diameter", diameter, "give the cylinder's diameter in mm")
    logarithm = math.log(2.0 * diameter / contact.half_width)
    return contact.line_load * material.compliance * (2.0 * logarithm - 1.0)


def half_space_line_compression(contact: LineContact, *, length: float) -> float:
    """Return the approach of two half-spaces pressed together over a strip of finite length [mm].

    delta = q K (1 + ln(16 a^2 / b^2)), with a = L/2: the displacement in the middle of a strip of length L
    that carries the pressure of the line contact uniformly along y, relative to points far away. K is the sum
    over both bodies, each of which contributes its own share.

    Parameters
    ----------
    contact : LineContact
        The contact; gives the line load q, the half-width b and the compliance K.
    length : float
        Length L of the strip [mm], larger than the width of the contact.

    Returns
    -------
    float
        Approach [mm].

    Raises
    ------
    InputError
        If ``contact`` has the wrong type, or the length is not larger than 2b.

    Notes
    -----
    For L large compared with b: the neglected terms are q K b^2 / (2 L^2) and of higher order.

    References
    ----------
    M. J. Puttock and E. G. Thwaite, Elastic Compression of Spheres and Cylinders at Point and Line Contact,
    National Standards Laboratory Technical Paper 25, CSIRO, Melbourne, 1969, the cases of parallel cylinders
    and of a cylinder on a plane, there with b^2 = 4 K q rho inserted: delta = q K (1 + ln(4 a^2 / (K q rho))).

    Examples
    --------
    >>> contact = line_contact(line_load=1000, radius=10, compliance=2.8e-6)
    >>> round(half_space_line_compression(contact, length=20), 6)
    0.029588
    """
    _refuse_wider(contact, "length", length, "give the length of the strip in mm, or use point_contact")
    logarithm = math.log(2.0 * length / contact.half_width)
    return contact.line_load * contact.compliance * (1.0 + 2.0 * logarithm)


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


def _semicircle(position: Array) -> Array:
    # As a product: 1 - position^2 would cancel close to the edge.
    return np.asarray(np.sqrt(np.maximum((1.0 - position) * (1.0 + position), 0.0)))


def _refuse_wider(contact: LineContact, name: str, value: float, remedy: str) -> None:
    """Refuse a line contact that is wider than what it presses."""
    if not isinstance(contact, LineContact):
        raise InputError("contact", contact, "be a LineContact", "make one with line_contact")
    condition = f"exceed the width of contact of {mm(2.0 * contact.half_width):.6g}"
    number_that(lambda width: width > 2.0 * contact.half_width, condition, positive)(name, value, remedy)
