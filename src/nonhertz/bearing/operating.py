"""Operating clearance of a bearing and pressures of its fits, as values."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields

from nonhertz.amounts import format_digits, mpa, um
from nonhertz.bearing.fits import Range
from nonhertz.errors import InputError
from nonhertz.findings import Finding, HasFindings, finding
from nonhertz.inputs.checks import positive
from nonhertz.result.brief import HasHtml, plain_text

MOST_STEP = 30.0  # K, between a ring and its seat; above this one of the temperatures was probably left out


@dataclass(frozen=True, kw_only=True, repr=False)
class ClearanceRanges:
    """Limits of interferences and radial clearance of a row by their classes [mm].

    Attributes
    ----------
    shaft, housing : Range or None
        Interference on shaft and in housing; None without seats.
    unmounted, mounted, operating : Range
        Radial clearance unmounted, mounted at 20 degC and at rest, and in operation. It is least at the greatest
        interferences.
    """

    shaft: Range | None
    housing: Range | None
    unmounted: Range
    mounted: Range
    operating: Range

    def __repr__(self) -> str:
        names = {"shaft": "interference on the shaft", "housing": "interference in the housing"}
        ranges = {field.name: getattr(self, field.name) for field in fields(self)}
        return plain_text(
            "ClearanceRanges",
            [
                f"{names.get(name, f'clearance {name}')} {um(value.least, value.greatest, between=' to '):4}, "
                f"likely {um(value.likely):4}"
                for name, value in ranges.items()
                if value is not None
            ],
        )

    @property
    def known(self) -> bool:
        """Whether all are single numbers."""
        return all(limits is None or limits.known for limits in (self.shaft, self.housing, self.unmounted))


@dataclass(frozen=True, kw_only=True)
class InterferenceFit:
    """The interference fit of a ring on its seat.

    Attributes
    ----------
    mounted_pressure : float
        Pressure at the interface, at 20 degC and at rest [MPa].
    pressure : float
        The same in operation [MPa]; 0 if the fit is lost.
    seat_stress, raceway_stress : float
        Hoop stress of the bearing's ring in operation, at its seat and at its raceway [MPa].
    loosening_speed : float
        Speed at which the pressure falls to zero at operating temperatures [1/min]; infinite if there is none, 0 if the
        fit is lost at rest. For an outer ring, which is at rest, infinite or 0.
    temperature_step : float
        Temperature of the inside part minus that of the outside part [K].
    """

    mounted_pressure: float
    pressure: float
    seat_stress: float
    raceway_stress: float
    loosening_speed: float
    temperature_step: float

    @property
    def loosened(self) -> bool:
        """Whether the fit has a pressure when mounted, but not in operation."""
        return self.mounted_pressure > 0.0 and self.pressure == 0.0


@dataclass(frozen=True, kw_only=True, repr=False)
class OperatingClearance(HasFindings, HasHtml):
    """Operating radial clearance of a bearing, and its reductions.

    Reductions are taken in turn, and thus add up: first the bearing is mounted, then it warms up, then it turns. The
    change of a fit by temperature or speed belongs to these.

    Attributes
    ----------
    unmounted : float
        Radial clearance unmounted [mm].
    lost_to_inner_fit, lost_to_outer_fit : float
        Clearance lost to the fits when the bearing is mounted [mm].
    lost_to_temperatures : float
        Clearance lost to temperatures [mm]; negative where they increase it.
    lost_to_speed : float
        Clearance lost to speed [mm].
    inner, outer : InterferenceFit
        Pressures and stresses of both fits.

    See Also
    --------
    Mounting.operating : finds one
    """

    unmounted: float
    lost_to_inner_fit: float
    lost_to_outer_fit: float
    lost_to_temperatures: float
    lost_to_speed: float
    inner: InterferenceFit
    outer: InterferenceFit

    @property
    def findings(self) -> tuple[Finding, ...]:  # type: ignore[override]
        """Doubtful temperature steps across interference fits: contact of the metals levels them out."""
        words = (
            "The {ring} is {step:.3g} K {way} than the {seat} it is pressed together with: check the temperatures of "
            "both."
        )
        parts = ("inner ring", "shaft", -self.inner.temperature_step), (
            "outer ring", "housing", self.outer.temperature_step
        )  # fmt: skip
        return tuple(
            finding(
                "temperature-step",
                words,
                ring=ring,
                seat=seat,
                step=abs(step),
                way="warmer" if step > 0.0 else "colder",
            )
            for (ring, seat, step), fit in zip(parts, (self.inner, self.outer), strict=True)
            if fit.mounted_pressure > 0.0 and abs(step) > MOST_STEP
        )

    @property
    def mounted(self) -> float:
        """Radial clearance mounted, at 20 degC and at rest [mm]."""
        return self.unmounted - (self.lost_to_inner_fit + self.lost_to_outer_fit)

    @property
    def clearance(self) -> float:
        """Radial clearance in operation [mm]; negative: preload."""
        return self.mounted - self.lost_to_temperatures - self.lost_to_speed

    def axial(self, contact_angle: float) -> float:
        """Return the axial clearance of one tapered row with this radial clearance [mm].

        Parameters
        ----------
        contact_angle : float
            Contact angle of the row [rad].

        Returns
        -------
        float
            C / (2 tan alpha): the clearance of a `TaperedRollerBearing`, of this row alone.
        """
        positive("contact_angle", contact_angle, "give the contact angle of the row in rad: 12 degrees are 0.21")
        if contact_angle >= 0.5 * math.pi:
            raise InputError("contact_angle", contact_angle, "be less than a right angle", "give it in rad")
        return 0.5 * self.clearance / math.tan(contact_angle)

    def __repr__(self) -> str:
        lines = [
            f"radial clearance {um(self.clearance):4} of {um(self.unmounted):4} unmounted",
            f"reduction due to inner fit {um(self.lost_to_inner_fit):4}, outer fit {um(self.lost_to_outer_fit):4}",
            f"reduction due to temperatures {um(self.lost_to_temperatures):4}, speed {um(self.lost_to_speed):4}",
            *(
                line
                for name, fit in (("inner", self.inner), ("outer", self.outer))
                for line in _describe_fit(name, fit)
            ),
        ]
        return plain_text("OperatingClearance", [*lines, *self.warnings])


def _describe_fit(name: str, fit: InterferenceFit) -> list[str]:
    state = ", loosened" if fit.loosened else ""
    if 0.0 < fit.loosening_speed < math.inf and not fit.loosened:
        state = f", comes loose at {format_digits(fit.loosening_speed, 3)}/min"
    return [
        f"{name} fit: pressure {mpa(fit.mounted_pressure):4} mounted, {mpa(fit.pressure):4} in operation{state}",
        f"{name} ring: hoop stress {mpa(fit.seat_stress):4} at the seat, {mpa(fit.raceway_stress):4} at the raceway",
    ]
