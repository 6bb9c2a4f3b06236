"""The amplitude and half-width that a profile for a design load depends on."""

from __future__ import annotations

import math

from nonhertz.errors import InputError, shown
from nonhertz.inputs.checks import positive
from nonhertz.model.material import STEEL


def design_amplitude(load: float, length: float, compliance: float | None) -> float:
    """Return the amplitude q / (pi E*) [mm] of the logarithm that spreads ``load`` evenly over ``length``.

    It equals (load / length) times the sum of both bodies' compliances; None means steel on steel.
    """
    positive("load", load, "give the design load of one contact in N")
    positive("length", length, "give the length over which the profile is drawn in mm")
    if compliance is None:
        compliance = 2.0 * STEEL.compliance
    positive("compliance", compliance, "give the sum of both bodies' (1 - nu^2) / (pi E) in 1/MPa")
    return float(load) / float(length) * float(compliance)


def design_half_width(load: float, length: float, radius: float, compliance: float | None) -> float:
    """Return the Hertz half-width b = sqrt(4 q rho (K_a + K_b)) [mm] at the design load."""
    amplitude = design_amplitude(load, length, compliance)
    positive("radius", radius, "give the combined radius of curvature across the contact in mm")
    half_width = 2.0 * math.sqrt(amplitude * radius)
    if 2.0 * half_width >= length:
        raise InputError(
            "load",
            load,
            f"leave a line contact, but it would be {2.0 * half_width:.3g} mm wide on {shown(length)} mm of length",
            "lower the load or check length and radius",
        )
    return half_width
