"""Dynamic capacity of a raceway, its load for a life of a million revolutions, after Lundberg and Palmgren and ISO 281.

For a radial bearing with Z rollers of diameter D and effective length L on the pitch diameter D_pw, with the contact
angle alpha and gamma = D cos(alpha) / D_pw,

    C_r = 1.1 f_c (L cos alpha)^(7/9) Z^(3/4) D^(29/27)
    f_c = 551.13373 * 0.377 * 0.83 * gamma^(2/9) (1 - gamma)^(29/27) / (1 + gamma)^(1/4) * {1 + [1.04 g]^(9/2)}^(-2/9)
    Q_ci = C_r / (0.83 * 0.378 Z cos alpha) {1 + [1.038 g]^(9/2)}^(2/9)    g = ((1 - gamma) / (1 + gamma))^(143/108)
    Q_ce = C_r / (0.83 * 0.364 Z cos alpha) {1 + [1.038 g]^(-9/2)}^(2/9)

In a bearing of i equal rows, i L replaces L in C_r, and the capacities are those of a single row: C_r is also divided
by i^(7/9). 0.83 is lambda nu, the reduction of the load rating for uneven line loads. It is not part of the
capacities: laminae have their own, uneven loads. 1.1 is b_m, for cylindrical and tapered roller
bearings and needle rollers in machined rings; the standard has 1.0 for drawn cups and 1.15 for spherical roller
bearings.

For a thrust bearing whose rollers lie square to the axis, gamma = D / D_pw and

    C_a = 472.45388 * 0.73 * 0.85 gamma^(2/9) L^(7/9) Z^(3/4) D^(29/27)        Q_c = 2^(2/9) C_a / (0.73 Z)

where 0.73 is lambda, and 0.85 is eta = 1 - 0.15 sin(alpha).

docs/explain/standards.md lists the sources in which each of these formulas was found.
"""

from __future__ import annotations

import math
from typing import Annotated

import numpy as np

from nonhertz.amounts import mm
from nonhertz.errors import InputError
from nonhertz.inputs.checks import not_negative, number_that, positive, whole
from nonhertz.inputs.descriptions import Flag, Quantity, Word
from nonhertz.inputs.fields import Input, cross_check, input_class
from nonhertz.model.body import BODIES, Body, BodyName, Plate, Ring, Roller
from nonhertz.model.contact import Contact
from nonhertz.model.diameter import TabulatedDiameter
from nonhertz.model.material import is_steel

MATERIAL_FACTOR = 1.1  # b_m of cylindrical and tapered roller bearings
REDUCTION = 0.83  # lambda nu: reduces the load rating for uneven line loads; not part of the capacity of laminae
_OF_THRUST, THRUST_REDUCTION, _INCLINED = 472.45388, 0.73, 0.85  # N, lambda, eta
SAME = 1e-9
ANGLE_REMEDY, _MOST_ANGLE = "give it in rad, for a radial bearing: 45 degrees at most", math.radians(45.0)
_NO_ROLLER = "neither of the bodies is a roller of finite length"
_DIAMETER_EXPONENT, _LENGTH_EXPONENT = 29.0 / 27.0, 7.0 / 9.0


#: Contact angles of radial bearings.
contact_angle_at_most = number_that(
    lambda angle: angle <= _MOST_ANGLE, f"not exceed {_MOST_ANGLE:.4g} rad", not_negative
)


@input_class()
class Raceway(Input):
    """A ring under rollers."""

    roller_diameter: Annotated[float, Quantity("mm", "roller diameter D", positive, "give the roller's diameter in mm")]
    length: Annotated[
        float,
        Quantity(
            "mm",
            "length over which roller and ring can touch, without corners and chamfers",
            positive,
            "give the length over which roller and ring can touch in mm",
        ),
    ]
    pitch_diameter: Annotated[
        float,
        Quantity(
            "mm",
            "diameter of the circle of roller centres",
            positive,
            "give the diameter of the circle of roller centres in mm",
        ),
    ]
    inner: Annotated[bool, Flag("whether it is an inner ring", "write True for an inner ring, False for an outer one")]
    body: Annotated[
        BodyName, Word("the body of the contact that is the ring", "name the body that is the ring", BODIES)
    ] = "b"
    contact_angle: Annotated[float, Quantity("rad", "contact angle", contact_angle_at_most, ANGLE_REMEDY)] = 0.0

    @cross_check("roller_diameter", "pitch_diameter")
    def _check_pitch(self) -> None:
        if self.pitch_diameter <= self.roller_diameter:
            condition = f"exceed the roller's diameter of {mm(self.roller_diameter):g}"
            raise InputError("pitch_diameter", self.pitch_diameter, condition, "give that of the roller centres")

    @property
    def most_rollers(self) -> int:
        """The number of rollers that fit side by side on the pitch circle."""
        return int(math.pi / math.asin(self.roller_diameter / self.pitch_diameter) + SAME)

    def load_rating(self, rollers: int, *, rows: int = 1, material_factor: float | None = None) -> float:
        """Return the basic dynamic radial load rating C_r [N] of a bearing, ISO 281.

        It includes the factor 0.83 for uneven line loads, lambda nu.

        Parameters
        ----------
        rollers : int
            Number of rollers in a row.
        rows : int
            Number of equal rows.
        material_factor : float, optional
            b_m; 1.1 if left out.

        Examples
        --------
        >>> round(Raceway(10.0, 9.6, 65.0, True).load_rating(14), 1)
        48416.8
        """
        rollers = self._check_rollers(rollers)
        gamma, ratio = self._gamma, self._ratio
        of_geometry = gamma ** (2 / 9) * (1.0 - gamma) ** (29 / 27) / (1.0 + gamma) ** 0.25
        both_rings = (1.0 + (1.04 * ratio ** (143 / 108)) ** 4.5) ** (-2 / 9)
        factor = 551.13373 * 0.377 * REDUCTION * of_geometry * both_rings
        length = _check_rows(rows) * self.length * math.cos(self.contact_angle)
        quality = MATERIAL_FACTOR if material_factor is None else material_factor
        positive("material_factor", quality, "give b_m, 1.1 for cylindrical and tapered rollers")
        of_size = length**_LENGTH_EXPONENT * rollers**0.75 * self.roller_diameter**_DIAMETER_EXPONENT
        return float(quality * factor * of_size)

    def capacity(self, rollers: int) -> float:
        """Return the dynamic capacity Q_ci or Q_ce of one contact [N], ISO/TS 16281 Eqs. (47), (48).

        Parameters
        ----------
        rollers : int
            Number of rollers in the bearing.

        Examples
        --------
        >>> inner, outer = (Raceway(10.0, 9.6, 65.0, inner) for inner in (True, False))
        >>> round(inner.capacity(14), 1), round(outer.capacity(14), 1)
        (11449.6, 17271.6)
        """
        rollers = self._check_rollers(rollers)
        return self.capacity_of(self.load_rating(rollers), rollers)

    def capacity_of(self, load_rating: float, rollers: int, *, rows: int = 1) -> float:
        """Return the same from a given load rating C_r [N], such as a catalogue's, for a bearing of equal rows.

        Examples
        --------
        >>> round(Raceway(10.53019, 11.65, 51.56, True, contact_angle=0.20698).capacity_of(59500, 14), -1)
        14150.0
        """
        positive("load_rating", load_rating, "give the basic dynamic radial load rating in N")
        rollers = self._check_rollers(rollers)
        other = (1.038 * self._ratio ** (143 / 108)) ** 4.5
        share = 0.378 * (1.0 + other) ** (-2 / 9) if self.inner else 0.364 * (1.0 + 1.0 / other) ** (-2 / 9)
        of_rows = _check_rows(rows) ** _LENGTH_EXPONENT * rollers
        return float(load_rating / (REDUCTION * share * of_rows * math.cos(self.contact_angle)))

    @property
    def _gamma(self) -> float:
        return self.roller_diameter * math.cos(self.contact_angle) / self.pitch_diameter

    @property
    def _ratio(self) -> float:
        return (1.0 - self._gamma) / (1.0 + self._gamma)

    def _check_rollers(self, rollers: int) -> int:
        """Return a number of rollers, or reject one that does not fit side by side on the pitch circle."""
        return whole("rollers", rollers, 1, self.most_rollers, "give the number of rollers in the bearing")


def _check_rows(rows: int) -> int:
    return whole("rows", rows, 1, 100, "give the number of equal rows")


def thrust_rating(roller_diameter: float, length: float, pitch_diameter: float, rollers: int) -> float:
    """Return the basic dynamic axial load rating C_a [N] of cylindrical rollers between flat washers, ISO 281.

    b_m is 1 for them.

    Examples
    --------
    >>> round(thrust_rating(5.0, 5.0, 50.0, 20))
    32737
    """
    gamma = roller_diameter / pitch_diameter
    of_size = length**_LENGTH_EXPONENT * rollers**0.75 * roller_diameter**_DIAMETER_EXPONENT
    return float(_OF_THRUST * THRUST_REDUCTION * _INCLINED * gamma ** (2 / 9) * of_size)


def thrust_capacity(load_rating: float, rollers: int) -> float:
    """Return the dynamic capacity [N] of one contact of a thrust bearing with flat washers."""
    return float(2.0 ** (2 / 9) * load_rating / (THRUST_REDUCTION * rollers))


def raceway(contact: Contact, *, contact_angle: float | None = None) -> tuple[Raceway | None, str]:
    """Return the ring of a contact under its roller, or None and the reason why there is none.

    The ring is the body that is a `Ring`; if neither or both are, the concave or larger of those that are not a
    `Roller`.

    Parameters
    ----------
    contact : Contact
        Roller and ring in the plane of their common generator.
    contact_angle : float, optional
        Contact angle of the bearing: the angle between the normal of the outer raceway and the radial plane [rad].
        Without it tapered rollers have no raceway, and cylindrical rollers that of a radial bearing.

    Notes
    -----
    Diameters in a contact are measured square to the generator, so that the rollers' centres lie on a circle of
    diameter (D_ring + D) cos(alpha) for an inner ring, (abs(D_ring) - D) cos(alpha) for an outer ring. At the inner
    ring of a tapered bearing alpha is smaller by the angle of the rollers' cone.
    """
    if not isinstance(contact, Contact):
        raise InputError("contact", contact, "be a Contact", "make one of two bodies with nonhertz.Contact")
    if contact_angle is not None:
        not_negative("contact_angle", contact_angle, ANGLE_REMEDY)
    bodies = contact.bodies
    why = _why_unrated(contact, tapered=contact_angle is not None)
    if why:
        return None, why
    middle = 0.5 * sum(contact.interval)
    diameters = {name: _diameter(body, middle) for name, body in bodies.items()}
    rings: list[BodyName] = [name for name, body in bodies.items() if isinstance(body, Ring)]
    others: list[BodyName] = [name for name, body in bodies.items() if not isinstance(body, Roller)]
    name = rings[0] if len(rings) == 1 else max(others, key=lambda ring: (diameters[ring] < 0.0, abs(diameters[ring])))
    roller = bodies["b" if name == "a" else "a"]
    return _raceway(name, diameters[name], roller, contact.land, contact_angle or 0.0)


def of_rolling_bearing(contact: Contact) -> bool:
    """Return whether both bodies are parts of a rolling bearing: rollers, rings or washers of bearing steel.

    For a wheel on a rail or for gear teeth, neither the life of ISO 281 nor its ratio to that of an ideal profile is
    meaningful.
    """
    return all(isinstance(body, Roller | Ring | Plate) and is_steel(body.material) for body in contact.bodies.values())


def _why_unrated(contact: Contact, tapered: bool) -> str:
    bodies = contact.bodies.values()
    reasons = {
        "L10 is known only for a roller on a ring": any(body.diameter is None for body in bodies),
        "L10 of a tapered roller needs the contact angle of its bearing: give contact_angle": (
            not tapered and any(callable(body.diameter) for body in bodies)
        ),
        "the capacity of ISO 281 holds only for bearing steel": not all(is_steel(body.material) for body in bodies),
        "the capacity of ISO 281 holds only for solid rollers": any(is_hollow(body) for body in bodies),
        _NO_ROLLER: not np.all(np.isfinite(contact.interval)),
        "neither of the bodies is a ring; give one of them kind = 'ring'": all(
            isinstance(body, Roller) for body in bodies
        ),
    }
    return next((reason for reason, applies in reasons.items() if applies), "")


def _raceway(
    name: BodyName, ring: float, roller: Body, interval: tuple[float, float], angle: float
) -> tuple[Raceway | None, str]:
    low, high = interval
    cone = _cone(roller, interval)
    # The diameter of a cone square to its generator is larger than that square to its axis.
    diameter = _diameter(roller, 0.5 * (low + high)) * math.cos(cone)
    if diameter <= 0.0:
        return None, _NO_ROLLER
    inner = ring > 0.0
    across = abs(ring) + (diameter if inner else -diameter)
    pitch = across * math.cos(max(0.0, angle - 2.0 * cone) if inner else angle)
    if pitch <= diameter:
        return None, "the ring is too small for the roller"
    return Raceway(diameter, high - low, pitch, inner, name, angle), ""


def _diameter(body: Body, y: float) -> float:
    diameter = body.diameter
    return float(np.asarray(diameter(np.array([y])))[0]) if callable(diameter) else float(diameter)  # type: ignore[arg-type]


def _cone(roller: Body, interval: tuple[float, float]) -> float:
    """Return half of the cone angle of a roller [rad], from the change of its diameter square to the generator."""
    low, high = interval
    slope = 0.5 * abs(_diameter(roller, high) - _diameter(roller, low)) / (high - low)
    # sin(c) / cos(c)^2 is the slope.
    return math.asin(2.0 * slope / (1.0 + math.sqrt(1.0 + 4.0 * slope**2)))


def is_hollow(body: Body) -> bool:
    """Return whether a body has a bore from end to end; recesses in its ends do not count."""
    bore = body.bore
    return bore is not None and (not isinstance(bore, TabulatedDiameter) or min(bore.diameter) > 0.0)
