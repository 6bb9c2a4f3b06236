"""Two rings, one pressed into the other: a bearing's rings with shaft and housing."""

from __future__ import annotations

import math
from dataclasses import dataclass

from nonhertz.amounts import mm
from nonhertz.bearing.bearings import RollerBearing
from nonhertz.bearing.kinematics import PER_MINUTE
from nonhertz.bearing.operating import InterferenceFit
from nonhertz.bearing.seats import Housing, Shaft
from nonhertz.bearing.thick_rings import ThickRing
from nonhertz.errors import InputError


@dataclass(frozen=True)
class Joint:
    """Two rings, one inside the other; one of them is the bearing's."""

    inside: ThickRing
    outside: ThickRing
    interference: float
    on_shaft: bool
    strains: tuple[float, float] = (0.0, 0.0)  # thermal strains of the inside and the outside part
    speed: float = 0.0  # of both [rad/s]

    @property
    def radius(self) -> float:
        """Radius of the interface [mm]."""
        return self.inside.outer

    def parting(self, *, pressure: float = 0.0, speed: float = 0.0) -> float:
        """Return the radial distance by which the interface opens under a pressure [MPa] or a speed [rad/s]."""
        outside = self.outside.growth(self.radius, inside=pressure, speed=speed)
        return outside - self.inside.growth(self.radius, outside=pressure, speed=speed)

    @property
    def overlap_at_rest(self) -> float:
        """Radial overlap of the separate parts at rest [mm]."""
        return 0.5 * self.interference + self.radius * (self.strains[0] - self.strains[1])

    @property
    def pressure(self) -> float:
        """The pressure between the parts [MPa]."""
        overlap = self.overlap_at_rest - self.speed**2 * self.parting(speed=1.0)
        return max(0.0, overlap / self.parting(pressure=1.0))

    @property
    def ring(self) -> ThickRing:
        """The bearing's ring."""
        return self.outside if self.on_shaft else self.inside

    @property
    def loads(self) -> dict[str, float]:
        """Loads on the bearing's ring."""
        return {"inside" if self.on_shaft else "outside": self.pressure, "speed": self.speed}

    @property
    def raceway_radius(self) -> float:
        """Radius of the bearing's raceway [mm]."""
        return self.ring.outer if self.on_shaft else self.ring.inner

    @property
    def raceway(self) -> float:
        """Growth of the diameter of the bearing's raceway [mm]."""
        radius, strain = self.raceway_radius, self.strains[1 if self.on_shaft else 0]
        return 2.0 * (self.ring.growth(radius, **self.loads) + strain * radius)

    def describe(self, mounted_pressure: float, temperature_step: float) -> InterferenceFit:
        """Return pressures and stresses, with the pressure when mounted [MPa] and the temperature step [K]."""
        parting, at_rest = self.parting(speed=1.0), self.overlap_at_rest
        loosening = 0.0 if at_rest <= 0.0 else math.inf
        if at_rest > 0.0 and self.on_shaft and parting > 0.0:
            loosening = math.sqrt(at_rest / parting) / PER_MINUTE
        return InterferenceFit(
            mounted_pressure=mounted_pressure,
            pressure=self.pressure,
            seat_stress=self.ring.hoop_stress(self.radius, **self.loads),
            raceway_stress=self.ring.hoop_stress(self.raceway_radius, **self.loads),
            loosening_speed=loosening,
            temperature_step=temperature_step,
        )


def fits_of(
    bearing: RollerBearing, shaft: Shaft, housing: Housing, densities: tuple[float, float]
) -> tuple[Joint, Joint]:
    """Return inner ring on shaft, and outer ring in housing, cold and at rest, from densities of shaft and ring."""
    inner, outer = (abs(float(ring.diameter)) for ring in (bearing.inner, bearing.outer))  # type: ignore[arg-type]
    assert shaft.diameter is not None
    assert housing.diameter is not None
    if shaft.diameter >= inner:
        condition = f"be less than the diameter of the inner raceway, {mm(inner):g}"
        raise InputError("shaft.diameter", shaft.diameter, condition, "give the bore of the inner ring in mm")
    if housing.diameter <= outer:
        condition = f"exceed the diameter of the outer raceway, {mm(outer):g}"
        raise InputError("housing.diameter", housing.diameter, condition, "give the bearing's outside diameter in mm")
    seat, bore = 0.5 * shaft.diameter, 0.5 * housing.diameter
    on_shaft = (
        ThickRing(0.5 * shaft.bore, seat, shaft.material, densities[0]),
        ThickRing(seat, 0.5 * inner, bearing.inner.material, densities[1]),
    )
    in_housing = (
        ThickRing(0.5 * outer, bore, bearing.outer.material, 0.0),
        ThickRing(bore, 0.5 * housing.outside_diameter, housing.material, 0.0),
    )
    return (
        Joint(*on_shaft, shaft.effective_interference, True),
        Joint(*in_housing, housing.effective_interference, False),
    )
