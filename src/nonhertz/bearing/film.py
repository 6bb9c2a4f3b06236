"""Oil film thickness between rollers and rings, along every contact.

With the viscosity eta at atmospheric pressure, its pressure coefficient alpha, the line load q, the entrainment speed u
(mean of both surfaces' speeds relative to the contact), the combined radius R across it, and 2 / E' = (1 - nu_a^2) /
E_a + (1 - nu_b^2) / E_b, films of fully flooded, isothermal line contacts are functions of

    U = eta u / (E' R)        G = alpha E'        W = q / (E' R)

    h_min / R = 1.714 U^0.694 G^0.568 W^-0.128        h_c / R = 2.922 U^0.692 G^0.470 W^-0.166     (Pan, Hamrock)
    h_min / R = 2.65 U^0.7 G^0.54 W^-0.13                                                          (Dowson, Higginson)

and of ellipses of the ellipticity k = a / b, from 1 to 8, with W = Q / (E' R^2)

    h_min / R = 3.63 U^0.68 G^0.49 W^-0.073 (1 - e^(-0.68 k))
    h_c / R = 2.69 U^0.67 G^0.53 W^-0.067 (1 - 0.61 e^(-0.73 k))                                   (Hamrock, Dowson)

Each position along a roller is treated as a line contact with its own q, R and u: flow along the contact is neglected,
so that films right at its ends are thinner than calculated. An elliptical contact within that range has the film of an
ellipse. Surfaces roll without sliding in the middle of the roller (`nonhertz.bearing.kinematics`); elsewhere speeds
follow from the radii from both axes: equal for cones with a common apex, different for barrels and between washers.

The film parameter lambda is h_min over the root of the sum of both Rq^2.

References
----------
Dowson, Higginson: Elasto-hydrodynamic Lubrication (1966); Hamrock, Dowson: J. Lubr. Technol. 99 (1977) 264; Pan,
Hamrock: J. Tribol. 111 (1989) 246; Hamrock, Schmid, Jacobson: Fundamentals of Fluid Film Lubrication, 2nd ed. (2004),
equations 18.72 and 18.74.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import format_digits, mm, um
from nonhertz.bearing.bearings import RollerBearing
from nonhertz.bearing.kinematics import PER_MINUTE, Kinematics
from nonhertz.bearing.oil import Lubrication
from nonhertz.bearing.row import Row
from nonhertz.bearing.section import RINGS
from nonhertz.bearing.solution import BearingSolution
from nonhertz.bearing.standard import LAMINAE, slice_loads
from nonhertz.errors import InputError
from nonhertz.inputs.checks import positive, whole
from nonhertz.inputs.short_repr import ShortRepr
from nonhertz.life.lamina import FEWEST, MOST
from nonhertz.result.brief import HasHtml, plain_text
from nonhertz.result.quantities import Quantity, attributes
from nonhertz.result.solution import Solution

Array = NDArray[np.float64]

#: Arrays of every roller at the inner and the outer ring, by name; NaN where there is no load.
FILM_QUANTITIES: Final[dict[str, Quantity]] = attributes(
    ("least_film", "least film of every roller at the inner and outer ring, by Pan and Hamrock", "mm"),
    ("central_film", "central film there", "mm"),
    ("line_film", "least film there by Dowson and Higginson", "mm"),
    ("least_film_y", "its position along the roller", "mm"),
    ("entrainment", "mean of both surfaces' speeds there", "mm/s"),
)
MOST_ELLIPTIC = 8.0
# Permitted relative deviation of mean over largest line load from 2/3, that of an ellipse.
_LIKE_ELLIPSE = 0.03


def pan_hamrock(speed: Array, material: float, load: Array) -> tuple[Array, Array]:
    """Return h_min / R and h_c / R of a line contact for U, G and W."""
    least = 1.714 * speed**0.694 * material**0.568 * load**-0.128
    return least, 2.922 * speed**0.692 * material**0.470 * load**-0.166


def dowson_higginson(speed: Array, material: float, load: Array) -> Array:
    """Return h_min / R of a line contact for U, G and W."""
    least: Array = 2.65 * speed**0.7 * material**0.54 * load**-0.13
    return least


def hamrock_dowson(speed: Array, material: float, load: Array, ellipticity: float) -> tuple[Array, Array]:
    """Return h_min / R and h_c / R of an ellipse for U, G, W = Q / (E' R^2) and k."""
    least: Array = 3.63 * speed**0.68 * material**0.49 * load**-0.073 * (1.0 - math.exp(-0.68 * ellipticity))
    central: Array = 2.69 * speed**0.67 * material**0.53 * load**-0.067 * (1.0 - 0.61 * math.exp(-0.73 * ellipticity))
    return least, central


@dataclass(frozen=True, eq=False, repr=False)
class ContactFilm(ShortRepr):
    """The film along a contact; arrays of shape (n,).

    Attributes
    ----------
    row : Row
        The row of rollers.
    ring : {"inner", "outer"}
        Which ring.
    rollers : tuple of int
        The rollers with this contact: rollers on both sides of a load have the same film.
    y, line_load : ndarray
        Places along the rollers' profiles [mm], and the load per length there [N/mm].
    least_film, central_film : ndarray
        Minimum and central film [mm]: by Pan and Hamrock for a line, by Hamrock and Dowson for an ellipse.
    line_film : ndarray
        Minimum film of a line by Dowson and Higginson [mm].
    entrainment, sliding : ndarray
        Mean of both surfaces' speeds, and speed of the ring minus that of the roller [mm/s].
    elliptic : bool
        Whether the film is that of an ellipse.
    """

    row: Row
    ring: str
    rollers: tuple[int, ...]
    y: Array
    line_load: Array
    least_film: Array
    central_film: Array
    line_film: Array
    entrainment: Array
    sliding: Array
    elliptic: bool


@dataclass(frozen=True, eq=False, repr=False)
class Films(HasHtml):
    """The films in a loaded bearing; made by `films`.

    Attributes
    ----------
    solution : BearingSolution
        The loaded bearing.
    kinematics : tuple of Kinematics
        The speeds of every row.
    lubrication : Lubrication
        Its oil.
    contacts : tuple of ContactFilm
        The films along all loaded contacts; those common to several rollers once.
    """

    solution: BearingSolution
    kinematics: tuple[Kinematics, ...]
    lubrication: Lubrication
    contacts: tuple[ContactFilm, ...]

    def __repr__(self) -> str:
        lines = [f"{type(self.solution.bearing.rows[0].bearing).__name__} at {format_digits(self.solution.speed)}/min"]
        if self.least is not None:
            roller, ring = self.least
            lines += [
                f"least film {um(self.least_film[self.least])}, central film there {um(self.central_film[self.least])}",
                f"between roller {roller + 1} and the {RINGS[ring]} ring, at y = {mm(self.least_film_y[self.least])}",
            ]
            if self.film_parameter is not None:
                lines.append(f"film parameter lambda {format_digits(self.film_parameter[self.least], 3)}")
        return plain_text("Films", lines)

    @property
    def least_film(self) -> Array:
        """The least film of every contact [mm], shape (rollers, 2); NaN where there is no load."""
        return self._at_least("least_film")

    @property
    def central_film(self) -> Array:
        """The central film where the least film is [mm], shape (rollers, 2)."""
        return self._at_least("central_film")

    @property
    def line_film(self) -> Array:
        """The least film there by Dowson and Higginson [mm], shape (rollers, 2)."""
        return self._at_least("line_film")

    @property
    def least_film_y(self) -> Array:
        """Position of the least film along the roller [mm], shape (rollers, 2)."""
        return self._at_least("y")

    @property
    def entrainment(self) -> Array:
        """The mean of both surfaces' speeds there [mm/s], shape (rollers, 2)."""
        return self._at_least("entrainment")

    @property
    def film_parameter(self) -> Array | None:
        """Lambda of every contact [-], shape (rollers, 2); None where a roughness is not known."""
        roughness = self.roughness
        return None if roughness is None else self.least_film / roughness

    @property
    def least(self) -> tuple[int, int] | None:
        """Roller and ring, 0 or 1, of the least film of all; None without load."""
        return _place_of_least(self.least_film) if self.contacts else None

    @property
    def least_parameter(self) -> tuple[int, int] | None:
        """Roller and ring of the smallest lambda of all; None without load or a roughness.

        Where the rings differ in roughness, it need not be where the film is least.
        """
        parameter = self.film_parameter
        return None if parameter is None or not self.contacts else _place_of_least(parameter)

    @cached_property
    def roughness(self) -> Array | None:
        """Rq of roller and ring together at every contact [mm], shape (rollers, 2); None where one is not known."""
        rows = []
        for row in (row.bearing for row in self.solution.bearing.rows):
            known = [part.roughness for part in (row.roller, row.inner, row.outer)]
            if any(value is None for value in known):
                return None
            roller, *rings = np.array(known, dtype=float)
            rows.append(np.tile(np.hypot(rings, roller), (row.rollers, 1)))
        return np.concatenate(rows)

    @property
    def rib_sliding(self) -> Array:
        """Sliding speed of the rollers' ends on load-supporting ribs of each ring [mm/s], shape (2,); NaN without.

        That of the row with the largest.
        """
        speeds = np.full(len(RINGS), np.nan)
        for row, motion in zip(self.solution.bearing.rows, self.kinematics, strict=True):
            for rib in row.bearing.rib_contacts:
                ring = RINGS.index(rib.ring)
                speed = abs(getattr(motion, f"{rib.ring}_speed") - motion.cage_speed) * rib.radius
                sliding = PER_MINUTE * abs(speed - abs(motion.roller_speed) * rib.height)
                speeds[ring] = np.fmax(speeds[ring], sliding)
        return speeds

    @property
    def elliptic(self) -> NDArray[np.bool_]:
        """Whether the film of a contact is that of an ellipse, shape (rollers, 2)."""
        values = np.zeros(self.solution.load.shape, dtype=bool)
        for contact in self.contacts:
            values[list(contact.rollers), RINGS.index(contact.ring)] = contact.elliptic
        return values

    def _at_least(self, name: str) -> Array:
        values = np.full(self.solution.load.shape, np.nan)
        for contact in self.contacts:
            values[list(contact.rollers), RINGS.index(contact.ring)] = getattr(contact, name)[
                int(np.argmin(contact.least_film))
            ]
        return values


def films(
    solution: BearingSolution, *, speed: float | None = None, lubrication: Lubrication, laminae: int = LAMINAE
) -> Films:
    """Return the films between the rollers of a loaded bearing and its rings.

    Parameters
    ----------
    solution : BearingSolution
        The loaded bearing.
    speed : float, optional
        Speed of the turning ring [1/min]; if left out, the speed at which the bearing was solved.
    lubrication : Lubrication
        The oil.
    laminae : int
        Number of slices, where the bearing was solved by them.

    Raises
    ------
    InputError
        If an argument is out of range, or the viscosity of the oil is not known.

    Examples
    --------
    >>> import nonhertz as nh
    >>> roller = nh.Roller(diameter=9, length=10, profile=nh.profile.crown(radius=4000))
    >>> rings = {"inner": nh.Ring(diameter=37.5), "outer": nh.Ring(diameter=-55.5)}
    >>> row = nh.bearing.CylindricalRollerBearing(roller=roller, **rings, rollers=13)
    >>> oil = nh.bearing.Lubrication(oil="ISO VG 68", temperature=70)
    >>> found = films(nh.bearing.solve(row, radial=10e3), speed=3000, lubrication=oil)
    >>> (1e3 * found.least_film[0]).round(2)  # um
    array([0.16, 0.19])
    """
    if not isinstance(solution, BearingSolution):
        raise InputError("solution", solution, "be a solved bearing", "give what nonhertz.bearing.solve returns")
    speed = solution.speed if speed is None else speed
    positive("speed", speed, "give the speed of the ring that turns in 1/min")
    if not isinstance(lubrication, Lubrication) or lubrication.dynamic_viscosity is None:
        raise InputError(
            "lubrication", lubrication, "have a viscosity", "give an oil with its temperature, or a viscosity"
        )
    rows = solution.bearing.rows
    motions = tuple(row.bearing.kinematics(**{f"{solution.turning}_speed": speed}) for row in rows)
    count = whole("laminae", laminae, FEWEST, MOST, "give the number of laminae, such as 41")
    oil = lubrication.dynamic_viscosity, lubrication.pressure_coefficient or 0.0
    along = _along_strips(solution) if solution.method == "strips" else _along_slices(solution, count)
    contacts = tuple(_film(loaded, motions[rows.index(loaded.row)], *oil) for loaded in along)
    return Films(solution, motions, lubrication, contacts)


def surface_speeds(bearing: RollerBearing, ring: int, motion: Kinematics, y: Array) -> tuple[Array, Array]:
    """Return the speeds of a raceway and of the rollers on it, relative to the contact and along it [mm/s]."""
    sense, angle, inclined = (-1.0, 1.0)[ring], bearing.contact_angles[ring], 0.5 * sum(bearing.contact_angles)
    narrows = 0.5 * (bearing.contact_angles[1] - bearing.contact_angles[0])
    relief = bearing.contacts[ring].a.relief_at(y)
    middle = 0.5 * (bearing.pitch + sense * bearing.roller_diameter * math.cos(inclined))
    around: Array = middle - y * math.sin(angle) - sense * relief * math.cos(angle)
    roller = 0.5 * bearing.roller_diameter - y * math.tan(narrows) - relief
    turns = abs((motion.inner_speed, motion.outer_speed)[ring] - motion.cage_speed)
    return PER_MINUTE * turns * around, PER_MINUTE * abs(motion.roller_speed) * roller


def _place_of_least(values: Array) -> tuple[int, int]:
    """Return roller and ring of the least of the values, some of which may be NaN."""
    roller, ring = np.unravel_index(int(np.nanargmin(values)), values.shape)
    return int(roller), int(ring)


class _Loaded(NamedTuple):
    """A loaded contact: places [mm], line loads [N/mm], and length over width where it is an ellipse."""

    row: Row
    ring: int
    rollers: list[int]
    y: Array
    load: Array
    ellipticity: float | None = None


def _along_strips(solution: BearingSolution) -> Iterator[_Loaded]:
    for pair in solution.distinct_contacts:
        loaded, solved = pair.solved.line_load > 0.0, pair.solved
        yield _Loaded(
            pair.row, pair.ring, pair.rollers, solved.y[loaded], solved.line_load[loaded], _ellipticity(solved)
        )


def _along_slices(solution: BearingSolution, laminae: int) -> Iterator[_Loaded]:
    for row, (slices, loads) in zip(solution.bearing.rows, slice_loads(solution, laminae), strict=True):
        width = float(slices.y[1] - slices.y[0])
        for j, ring in np.argwhere(loads.any(axis=2)).tolist():
            loaded = loads[j, ring] > 0.0
            yield _Loaded(row, ring, [row.first + j], slices.y[loaded], loads[j, ring][loaded] / width)


def _ellipticity(solved: Solution) -> float | None:
    """Return length over width of an elliptical contact; None for other contacts."""
    (low, high), *others = solved.contact_y
    ends = solved.contact.land
    mean = solved.load / (high - low) / float(solved.line_load.max())
    if others or low <= ends[0] or high >= ends[1] or abs(1.5 * mean - 1.0) > _LIKE_ELLIPSE:
        return None
    return 0.5 * (high - low) / solved.max_half_width


def _film(loaded: _Loaded, motion: Kinematics, viscosity: float, coefficient: float) -> ContactFilm:
    """Return the film along a contact in an oil [MPa s, 1/MPa]."""
    row, ring, rollers, y, load, ratio = loaded
    contact = row.bearing.contacts[ring]
    modulus, radius = 2.0 / (math.pi * contact.compliance), 1.0 / contact.curvature_at(y)
    raceway, roller = surface_speeds(row.bearing, ring, motion, y)
    entrainment = 0.5 * (raceway + roller)
    speed, material = viscosity * entrainment / (modulus * radius), coefficient * modulus
    of_line = load / (modulus * radius)
    elliptic = ratio is not None and 1.0 <= ratio <= MOST_ELLIPTIC
    if ratio is not None and elliptic:
        least, central = hamrock_dowson(speed, material, np.trapezoid(load, y) / (modulus * radius**2), ratio)
    else:
        least, central = pan_hamrock(speed, material, of_line)
    least, central, line = (film * radius for film in (least, central, dowson_higginson(speed, material, of_line)))
    sliding = raceway - roller
    return ContactFilm(row, RINGS[ring], tuple(rollers), y, load, least, central, line, entrainment, sliding, elliptic)
