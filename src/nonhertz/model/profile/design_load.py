"""The parameters of profiles for a design load, and the amplitude and half-width that follow from them."""

from __future__ import annotations

import math

from nonhertz.amounts import mm
from nonhertz.errors import InputError
from nonhertz.inputs.checks import positive
from nonhertz.inputs.descriptions import Quantity
from nonhertz.model.material import STEEL

LOAD = Quantity("N", "the design load of the contact", positive, "give the design load of one contact in N")
LENGTH = Quantity(
    "mm", "the effective length of the contact", positive, "give the length over which the profile is drawn in mm"
)
RADIUS = Quantity(
    "mm",
    "the combined radius of curvature rho across the contact, 1/rho = 1/rho_a + 1/rho_b",
    positive,
    "give the combined radius of curvature across the contact in mm",
)
COMPLIANCE = Quantity(
    "1/MPa",
    "K_a + K_b = 1 / (pi E*), the sum of both bodies' (1 - nu^2) / (pi E), as given by Contact.compliance; steel on "
    "steel if left out",
    positive,
    "give the sum of both bodies' (1 - nu^2) / (pi E) in 1/MPa",
)


def design_amplitude(load: float, length: float, compliance: float | None) -> float:
    """Return the amplitude q / (pi E*) [mm] of the logarithm that distributes ``load`` uniformly over ``length``.

    It equals (load / length) times the sum of both bodies' compliances; None means steel on steel.
    """
    return load / length * (2.0 * STEEL.compliance if compliance is None else compliance)


def design_half_width(load: float, length: float, radius: float, compliance: float | None) -> float:
    """Return the Hertz half-width b = sqrt(4 q rho (K_a + K_b)) [mm] at the design load."""
    return 2.0 * math.sqrt(design_amplitude(load, length, compliance) * radius)


def line_contact(load: float, length: float, radius: float, compliance: float | None) -> None:
    """Refuse a contact that would be wider than long."""
    half_width = design_half_width(load, length, radius, compliance)
    if 2.0 * half_width >= length:
        condition = f"leave a line contact, but it would be {mm(2.0 * half_width):.3g} wide on {mm(length):g} of length"
        raise InputError("load", load, condition, "lower the load or check length and radius")
