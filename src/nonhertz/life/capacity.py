"""The load that a raceway carries for a million revolutions, after Lundberg and Palmgren as in ISO 281.

For a radial bearing with Z rollers of diameter D and effective length L on the pitch diameter D_pw, with the contact
angle alpha and gamma = D cos(alpha) / D_pw,

    C_r = 1.1 f_c (L cos alpha)^(7/9) Z^(3/4) D^(29/27)
    f_c = 551.13373 * 0.377 * 0.83 * gamma^(2/9) (1 - gamma)^(29/27) / (1 + gamma)^(1/4) * {1 + [1.04 g]^(9/2)}^(-2/9)
    Q_ci = C_r / (0.83 * 0.378 Z cos alpha) {1 + [1.038 g]^(9/2)}^(2/9)    g = ((1 - gamma) / (1 + gamma))^(143/108)
    Q_ce = C_r / (0.83 * 0.364 Z cos alpha) {1 + [1.038 g]^(-9/2)}^(2/9)

Both standards are quoted from public programs that agree with each other; their text itself was not available.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from nonhertz.errors import InputError
from nonhertz.inputs.checks import flag, not_negative, one_of, positive, whole
from nonhertz.model.body import Body, BodyName, Ring, Roller
from nonhertz.model.contact import Contact
from nonhertz.model.material import Material

MATERIAL_FACTOR = 1.1  # b_m of cylindrical and tapered roller bearings
REDUCTION = 0.83  # lambda nu: reduces the load rating for uneven line loads; not part of the capacity of laminae
SAME = 1e-9
STEEL_MODULUS = 195e3, 220e3  # MPa
_ANGLE_REMEDY, _MOST_ANGLE = "give it in rad, for a radial bearing: 45 degrees at most", math.radians(45.0)
_DIAMETER_EXPONENT, _LENGTH_EXPONENT = 29.0 / 27.0, 7.0 / 9.0


@dataclass(frozen=True)
class Raceway:
    """A ring under rollers.

    Attributes
    ----------
    roller_diameter : float
        D [mm].
    length : float
        Length on which roller and ring can touch [mm].
    pitch_diameter : float
        Diameter of the circle of roller centres [mm].
    inner : bool
        Whether it is an inner ring.
    body : str
        Which of the bodies of a contact is the ring, ``"a"`` or ``"b"``.
    contact_angle : float
        alpha [rad].
    """

    roller_diameter: float
    length: float
    pitch_diameter: float
    inner: bool
    body: BodyName = "b"
    contact_angle: float = 0.0

    def __post_init__(self) -> None:
        positive("roller_diameter", self.roller_diameter, "give the roller's diameter in mm")
        positive("length", self.length, "give the length on which roller and ring can touch in mm")
        positive("pitch_diameter", self.pitch_diameter, "give the diameter of the circle of roller centres in mm")
        flag("inner", self.inner, "write True for an inner ring, False for an outer one")
        one_of("body", self.body, ("a", "b"), "name the body that is the ring")
        not_negative("contact_angle", self.contact_angle, _ANGLE_REMEDY)
        if self.contact_angle > _MOST_ANGLE:
            raise InputError("contact_angle", self.contact_angle, f"not exceed {_MOST_ANGLE:.4g} rad", _ANGLE_REMEDY)
        if self.pitch_diameter <= self.roller_diameter:
            condition = f"exceed the roller's diameter of {self.roller_diameter:g} mm"
            raise InputError("pitch_diameter", self.pitch_diameter, condition, "give that of the roller centres")

    @property
    def most_rollers(self) -> int:
        """The number of rollers that fit side by side on the pitch circle."""
        return int(math.pi / math.asin(self.roller_diameter / self.pitch_diameter) + SAME)

    def load_rating(self, rollers: int) -> float:
        """Return the basic dynamic radial load rating C_r [N] of a bearing, ISO 281.

        Examples
        --------
        >>> round(Raceway(10.0, 9.6, 65.0, True).load_rating(14), 1)
        48416.8
        """
        rollers = self._checked(rollers)
        gamma, ratio = self._gamma, self._ratio
        of_geometry = gamma ** (2 / 9) * (1.0 - gamma) ** (29 / 27) / (1.0 + gamma) ** 0.25
        both_rings = (1.0 + (1.04 * ratio ** (143 / 108)) ** 4.5) ** (-2 / 9)
        factor = 551.13373 * 0.377 * REDUCTION * of_geometry * both_rings
        length = self.length * math.cos(self.contact_angle)
        of_size = length**_LENGTH_EXPONENT * rollers**0.75 * self.roller_diameter**_DIAMETER_EXPONENT
        return float(MATERIAL_FACTOR * factor * of_size)

    def capacity(self, rollers: int) -> float:
        """Return the dynamic capacity Q_ci or Q_ce of one contact [N], ISO/TS 16281 Eqs. (47), (48).

        Parameters
        ----------
        rollers : int
            Number of rollers in the bearing, which all pass in one revolution.

        Examples
        --------
        >>> inner, outer = (Raceway(10.0, 9.6, 65.0, inner) for inner in (True, False))
        >>> round(inner.capacity(14), 1), round(outer.capacity(14), 1)
        (11449.6, 17271.6)
        """
        rollers = self._checked(rollers)
        return self.capacity_of(self.load_rating(rollers), rollers)

    def capacity_of(self, load_rating: float, rollers: int) -> float:
        """Return the same for a load rating C_r [N] of one's own, a catalogue's say.

        Examples
        --------
        >>> round(Raceway(10.53019, 11.65, 51.56, True, contact_angle=0.20698).capacity_of(59500, 14), -1)
        14150.0
        """
        positive("load_rating", load_rating, "give the basic dynamic radial load rating in N")
        rollers = self._checked(rollers)
        other = (1.038 * self._ratio ** (143 / 108)) ** 4.5
        share = 0.378 * (1.0 + other) ** (-2 / 9) if self.inner else 0.364 * (1.0 + 1.0 / other) ** (-2 / 9)
        return float(load_rating / (REDUCTION * share * rollers * math.cos(self.contact_angle)))

    @property
    def _gamma(self) -> float:
        return self.roller_diameter * math.cos(self.contact_angle) / self.pitch_diameter

    @property
    def _ratio(self) -> float:
        return (1.0 - self._gamma) / (1.0 + self._gamma)

    def _checked(self, rollers: int) -> int:
        """Return a number of rollers, or reject one that does not fit side by side on the pitch circle."""
        return whole("rollers", rollers, 1, self.most_rollers, "give the number of rollers in the bearing")


def raceway(contact: Contact) -> tuple[Raceway | None, str]:
    """Return the ring of a contact under its roller, or None and why there is none.

    The ring is the body that is a `Ring`; if neither or both are, the concave or larger of those that are not a
    `Roller`.
    """
    if not isinstance(contact, Contact):
        raise InputError("contact", contact, "be a Contact", "make one of two bodies with nonhertz.Contact")
    bodies = {"a": contact.a, "b": contact.b}
    if not all(isinstance(body.diameter, float | int) for body in bodies.values()):
        return None, "L10 is known only for a cylindrical roller on a cylindrical ring"
    if not all(is_steel(body.material) for body in bodies.values()):
        return None, "the capacity of ISO 281 is that of bearing steel"
    rings = [name for name, body in bodies.items() if isinstance(body, Ring)]
    others = [name for name, body in bodies.items() if not isinstance(body, Roller)]
    if not others:
        return None, "neither of the bodies is a ring; give one of them kind = 'ring'"
    name = rings[0] if len(rings) == 1 else max(others, key=lambda each: _largeness(bodies[each]))
    ring, roller = bodies[name], bodies["b" if name == "a" else "a"]
    return _raceway(name, float(ring.diameter), float(roller.diameter), contact.interval)  # type: ignore[arg-type]


def _raceway(name: BodyName, ring: float, roller: float, interval: tuple[float, float]) -> tuple[Raceway | None, str]:
    low, high = interval
    if roller <= 0.0 or not math.isfinite(high - low):
        return None, "neither of the bodies is a roller that ends"
    inner = ring > 0.0
    pitch = abs(ring) + (roller if inner else -roller)
    if pitch <= roller:
        return None, "the ring is too small for the roller"
    return Raceway(roller, high - low, pitch, inner, name), ""


def _largeness(body: Body) -> tuple[bool, float]:
    diameter = float(body.diameter)  # type: ignore[arg-type]
    return diameter < 0.0, abs(diameter)


def is_steel(material: Material) -> bool:
    """Return whether a material is as stiff as bearing steel."""
    low, high = STEEL_MODULUS
    return low <= material.modulus <= high
