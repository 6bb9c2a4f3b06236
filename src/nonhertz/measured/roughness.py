"""Roughness of a measured line, and how much of it strips can represent.

A strip assumes one semi-ellipse of half-width b for the pressure across the contact, which varies along y from strip to
strip. The effect of a wave of length l along y extends as far as l / (2 pi) to the side and below. As long as that is
more than b, the wave affects the whole width of the contact alike and one semi-ellipse represents it; a shorter wave,
l < 2 pi b, acts only locally, the contact breaks up into patches, and strips cannot describe it.

The pressure that presses such waves flat is known. A wave of amplitude A on a half-space needs the pressure

    p = pi E* A / l = E* / 2 times the amplitude of its slope

(Westergaard 1939; Johnson 1985, section 13.2), so the root mean square of the pressure is E* / 2 times that of the
slope of all short waves together, whatever their lengths. Where that is not small compared with the pressure of the
contact, solving with these waves gives a picture of the roughness and not of the contact: smooth first.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from nonhertz.amounts import mm, mpa, mrad
from nonhertz.findings import Finding, finding
from nonhertz.measured.filters import gaussian, nominal_form, shortest_cutoff
from nonhertz.measured.trace import Array, Points
from nonhertz.model.materials import MATERIALS

#: For a typical roller bearing under load: half-width [mm] and pressure [MPa].
HALF_WIDTH, PRESSURE = 0.1, 1500.0
#: For two steel bodies [1/MPa].
STEEL_COMPLIANCE = 2.0 * MATERIALS["steel"].compliance
# Fraction of the contact's pressure that short waves may need.
_RIPPLE = 0.1
_OCTAVES = 6
_DEGREE = 4  # of the nominal form: circles and crowns, without waves of less than half the line


@dataclass(frozen=True)
class Roughness:
    """Height parameters of what a Gaussian filter removes once the nominal form is taken off, ISO 21920-2.

    Attributes
    ----------
    ra, rq : float
        Mean of the absolute values and root mean square [mm].
    rz : float
        Height from lowest to highest [mm], averaged over sections as long as the cutoff.
    sections : int
        Number of sections; the standard has five.
    cutoff : float
        Cutoff of the filter [mm].
    bands : tuple of (float, float, float)
        Octaves of wavelengths, from and to [mm], and the root mean square of the waves in each [mm]; the first extends
        down to the shortest waves.
    """

    ra: float
    rq: float
    rz: float
    sections: int
    cutoff: float
    bands: tuple[tuple[float, float, float], ...]

    @property
    def main_band(self) -> tuple[float, float, float]:
        """The octave with the highest waves."""
        return max(self.bands, key=lambda band: band[2])


def roughness_in(points: Points, cutoff: float) -> Roughness:
    """Return the roughness of a line.

    The polynomial of degree four of least squares is taken off as the nominal form; on a line of two cutoffs or more,
    half a cutoff at either end, where the filter has points on one side only, is left out.

    Parameters
    ----------
    points : Points
        The line without chamfers.
    cutoff : float
        Wavelength [mm] up to which waves are roughness.

    Returns
    -------
    Roughness
        Height parameters and wavelengths.

    Raises
    ------
    InputError
        If the points cannot resolve the cutoff.

    References
    ----------
    ISO 21920-2:2021, Geometrical product specifications - Surface texture: Profile - Terms, definitions and surface
    texture parameters.
    """
    points = points.lifted(points.height - nominal_form(points, _DEGREE))
    end = 0.5 * cutoff if points.span >= 2.0 * cutoff else 0.0
    inside = (points.y >= points.y[0] + end) & (points.y <= points.y[-1] - end)
    rough, y, weights = ((points.height - gaussian(points, cutoff))[inside], points.y[inside], points.weights[inside])
    sections = max(round((y[-1] - y[0]) / cutoff), 1)
    of = np.minimum(((y - y[0]) / (y[-1] - y[0]) * sections).astype(int), sections - 1)
    heights = [np.ptp(rough[of == k]) for k in range(sections) if np.any(of == k)]
    return Roughness(
        ra=float(np.average(np.abs(rough), weights=weights)),
        rq=float(np.sqrt(np.average(rough**2, weights=weights))),
        rz=float(np.mean(heights)),
        sections=len(heights),
        cutoff=cutoff,
        bands=_bands(y, rough, cutoff),
    )


def short_wave_slope(points: Points, wavelength: float) -> float:
    """Return the root mean square slope of all waves shorter than ``wavelength`` [mm]."""
    if wavelength < shortest_cutoff(points):
        return 0.0
    rough = points.height - gaussian(points, min(wavelength, points.span))
    steps = np.diff(points.y)
    return float(np.sqrt(np.average((np.diff(rough) / steps) ** 2, weights=steps)))


def strain_on_strips(
    points: Points, half_width: float, pressure: float, compliance: float, smoothed: bool
) -> Iterator[Finding]:
    """Yield that a line has waves that strips cannot represent.

    Parameters
    ----------
    points : Points
        The line to solve with.
    half_width, pressure, compliance : float
        Values of the contact [mm, MPa, 1/MPa], as in `nonhertz.measured.Measured.warnings_for`.
    smoothed : bool
        Whether a filter was applied, which decides the remedy.

    References
    ----------
    H. M. Westergaard, Bearing pressures and cracks, Journal of Applied Mechanics 6 (1939) A49-A53. K. L. Johnson,
    Contact Mechanics, Cambridge University Press 1985, section 13.2.
    """
    shortest = 2.0 * np.pi * half_width
    slope = short_wave_slope(points, shortest)
    # Compliances here are (1 - nu^2) / (pi E), so that 1 / (pi compliance) is E*.
    ripple = 0.5 * slope / (math.pi * compliance)
    if ripple > _RIPPLE * pressure:
        remedy = "smooth with a longer cutoff" if smoothed else "smooth it first"
        yield finding(
            "waves-left",
            "Waves shorter than {shortest:.2g}, 2 pi half-widths of {half_width:.3g}, are left in the profile with a "
            "root mean square slope of {slope:.3g}: pressing them flat takes {ripple:.3g} compared with {pressure:.4g} "
            f"in the contact, and strips cannot resolve changes within the width of the contact; {remedy}.",
            shortest=mm(shortest),
            half_width=mm(half_width),
            slope=mrad(slope),
            ripple=mpa(ripple),
            pressure=mpa(pressure),
        )


def _bands(y: Array, rough: Array, cutoff: float) -> tuple[tuple[float, float, float], ...]:
    """Return octaves of wavelengths below twice the cutoff and the root mean square of the waves in each."""
    count = len(y)
    even = np.interp(np.linspace(y[0], y[-1], count), y, rough)
    window = np.hanning(count)
    power = np.abs(np.fft.rfft(even * window)) ** 2
    power *= np.mean(even**2) / max(float(np.sum(power)), 1e-300)
    length = (y[-1] - y[0]) / np.maximum(np.arange(len(power)), 1e-9)
    edges = 2.0 * cutoff * 0.5 ** np.arange(_OCTAVES + 1)
    edges[-1] = 0.0
    octaves = zip(edges[1:], edges[:-1], strict=True)
    return tuple(
        (float(low), float(high), float(np.sqrt(np.sum(power[(length > low) & (length <= high)]))))
        for low, high in reversed(list(octaves))
    )
