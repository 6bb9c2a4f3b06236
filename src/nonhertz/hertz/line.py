"""The line contact of Hertz, and the compression of bodies in it."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.amounts import mm
from nonhertz.errors import InputError
from nonhertz.hertz.pair import PLACES_REMEDY, Materials, semicircle, total_compliance
from nonhertz.inputs.checks import number_that, numbers, positive
from nonhertz.inputs.short_repr import ShortRepr
from nonhertz.model.material import Material, check_poisson

Array = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True, repr=False)
class LineContact(ShortRepr):
    """A Hertz contact over an infinitely long strip, as made by `line_contact`.

    It has no approach of its own: in plane strain the displacement grows without bound with the distance of
    its reference point. `plane_strain_cylinder_compression` and
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
        return np.asarray(self.max_pressure * semicircle(numbers("x", x, PLACES_REMEDY) / self.half_width))

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
        x, z = numbers("x", x, PLACES_REMEDY), numbers("z", z, PLACES_REMEDY)
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


def line_contact(
    *,
    line_load: float,
    radius: float,
    compliance: float | None = None,
    e_star: float | None = None,
    materials: Materials | None = None,
) -> LineContact:
    """Return the Hertz contact of two bodies that first touch along a line.

    b^2 = 4 K q rho and p0 = 2 q / (pi b).

    Parameters
    ----------
    line_load : float
        Load per unit length q [N/mm], positive.
    radius : float
        Combined radius of curvature rho across the contact [mm], 1/rho = 1/rho_a + 1/rho_b, positive.
    compliance : float, optional
        Sum of both half-space compliances K = (1 - nu^2) / (pi E) [1/MPa]: ``Contact.compliance``. Give this,
        ``e_star`` or ``materials``.
    e_star : float, optional
        Contact modulus E* = 1 / (pi K), with 1/E* = (1 - nu_a^2) / E_a + (1 - nu_b^2) / E_b [MPa].
    materials : pair of Material or str, optional
        Materials of body a and body b, or their names.

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
    compliance = total_compliance(compliance, e_star, materials)
    half_width = 2.0 * math.sqrt(compliance * line_load * radius)
    return LineContact(
        line_load=float(line_load),
        radius=float(radius),
        compliance=compliance,
        half_width=half_width,
        max_pressure=2.0 * float(line_load) / (math.pi * half_width),
    )


def plane_strain_cylinder_compression(contact: LineContact, *, diameter: float, material: Material) -> float:
    """Return the compression [mm] of a long solid cylinder: how far its axis moves towards its line contact.

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


def _refuse_wider(contact: LineContact, name: str, value: float, remedy: str) -> None:
    """Refuse a line contact that is wider than the length or diameter of its body."""
    if not isinstance(contact, LineContact):
        raise InputError("contact", contact, "be a LineContact", "make one with line_contact")
    condition = f"exceed the width of contact of {mm(2.0 * contact.half_width):.6g}"
    number_that(lambda width: width > 2.0 * contact.half_width, condition, positive)(name, value, remedy)
