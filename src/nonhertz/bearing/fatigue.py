"""The life of rings and rollers from the stress in their volume.

Every model of `nonhertz.life` gives the probability that a body survives N passes of a load as

    ln(1/S) = A N^e 2 pi r I        I = int int <s - s_u>^k / z^h dz dy

with the integral I over its cross-section. At the ring that rotates relative to the load every point passes all Z
rollers, and their damage adds up by Miner's rule, station by station along the rollers; at the ring that is stationary
relative to the load the part of the circumference below a roller is loaded by that roller only:

    turning ring     I = int (mean_j i_j^(1/e))^e dy        i = int <s - s_u>^k / z^h dz
    standing ring    I = mean_j I_j

With s ~ q these are the means with the powers 4 and 9/2 of ISO/TS 16281. A roller passes all loads in turn, and in each
of its own revolutions once the inner and once the outer ring. Per revolution of a ring, with gamma = D cos(alpha) /
D_pw,

    passes     inner ring Z (1 + gamma) / 2    outer ring Z (1 - gamma) / 2    roller D_pw (1 - gamma^2) / (2 D), twice
    length     pi D_pw (1 - gamma)             pi D_pw (1 + gamma)             pi D, of Z rollers

The constant A is such that a ring has a life of 10^6 revolutions when every roller loads it with its dynamic capacity,
uniformly along its length: that is the definition of the capacity. With Lundberg and Palmgren's model a bearing with
uniform pressures thus has the L10r of ISO/TS 16281, and models with other exponents or a limit agree at the capacity.
ISO 281 gives a capacity for each ring; the constants from both agree within 0.3 %, which shows that passes are counted
as Lundberg and Palmgren did. For rollers the inner ring's constant is used. Lives of several bodies are combined by
Weibull's rule, L = (sum L_i^(-e))^(-1/e). ISO 281 attributes all failures to the rings: compare its lives with those
of the rings.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import chain

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import format_digits
from nonhertz.bearing.bearings import RollerBearing
from nonhertz.bearing.laminae import singular_ends
from nonhertz.bearing.ratings import Rating, rating
from nonhertz.bearing.section import RINGS
from nonhertz.bearing.solution import BearingSolution
from nonhertz.errors import InputError
from nonhertz.findings import Finding, HasFindings, finding
from nonhertz.inputs.checks import one_of
from nonhertz.life.catalogue import MODELS, VolumeModel
from nonhertz.life.volume import Exposure, even_exposure, exposure, section_exposure
from nonhertz.model.body import BodyName
from nonhertz.result.brief import HasHtml, plain_text, warning_lines
from nonhertz.result.edges import SingularEnd
from nonhertz.result.ends import ends_in_words
from nonhertz.result.read_only import ReadOnly
from nonhertz.result.solution import Solution

Array = NDArray[np.float64]
#: Exposures at each roller of a row; None where it is not loaded.
Seen = Sequence[Exposure | None]

BODIES, TOGETHER = ("inner ring", "outer ring", "rollers"), ("both rings", "rings and rollers")
FIELDS = ("sections", "whole")
# Largest relative change of the pressure over a half-width for which sections suffice, and permitted fraction of the
# damage where it changes by more.
_STEEP, _MOST_STEEP = 0.3, 0.05
_LEAST = 1e-3  # of the maximum pressure


@dataclass(frozen=True, eq=False, repr=False)
class VolumeLife(HasFindings, ReadOnly, HasHtml):
    """Lives of rings and rollers by a model of the stressed volume, with 90 % reliability [10^6 revolutions].

    Attributes
    ----------
    model : VolumeModel
        The model with its parameters.
    of_rows : ndarray, shape (rows, 3)
        Values for the inner ring, the outer ring and the rollers of each row.
    even : ndarray, shape (rows, 3)
        The same if every contact were Hertz's line contact, with its load uniform over its length.
    findings : tuple of Finding
        Limits of the validity.
    """

    model: VolumeModel
    of_rows: Array
    even: Array
    findings: tuple[Finding, ...]

    @property
    def inner(self) -> float:
        """Life of the inner ring, of all rows [10^6 revolutions]."""
        return self._combine(self.of_rows[:, 0])

    @property
    def outer(self) -> float:
        """Life of the outer ring, of all rows [10^6 revolutions]."""
        return self._combine(self.of_rows[:, 1])

    @property
    def rollers(self) -> float:
        """Life of all rollers together [10^6 revolutions]."""
        return self._combine(self.of_rows[:, 2])

    @property
    def rings(self) -> float:
        """Life of both rings together [10^6 revolutions], which compares with L10r."""
        return self._combine(self.of_rows[:, :2])

    @property
    def bearing(self) -> float:
        """Life of rings and rollers together [10^6 revolutions]."""
        return self._combine(self.of_rows)

    @property
    def relative_life(self) -> float:
        """Life of rings and rollers over the life with uniform line loads [-]; NaN if both are infinite."""
        even = self._combine(self.even)
        return self.bearing / even if math.isfinite(even) else (math.nan if math.isinf(self.bearing) else 0.0)

    def _combine(self, lives: Array) -> float:
        damage = float(np.sum(lives**-self.model.slope))
        return damage ** (-1.0 / self.model.slope) if damage > 0.0 else math.inf

    def __repr__(self) -> str:
        lives = (self.inner, self.outer, self.rollers)
        lines = [
            f"{self.model.name}, in million revolutions",
            ", ".join(f"{name} {format_digits(life, 4)}" for name, life in zip(BODIES, lives, strict=True)),
            f"rings {format_digits(self.rings, 4)}, with rollers {format_digits(self.bearing, 4)}: "
            f"{format_digits(self.relative_life, 3)} of that under uniform loads",
            *warning_lines(self.warnings),
        ]
        return plain_text("VolumeLife", lines)


def volume_life(
    solution: BearingSolution,
    model: VolumeModel | str = "lundberg-palmgren",
    *,
    field: str = "sections",
    dynamic: float | None = None,
) -> VolumeLife:
    """Return the lives of a bearing's rings and rollers from the stress in their volume.

    Parameters
    ----------
    solution : BearingSolution
        The loaded bearing, solved by strips.
    model : VolumeModel or str
        A volume model of `nonhertz.life`, or its name: Lundberg and Palmgren's, Ioannides and Harris's, Zaretsky's,
        Weibull's or your own.
    field : {"sections", "whole"}
        ``"sections"``: from cross-sections in plane strain, within seconds. ``"whole"``: from the stress below the
        whole contact, as in `nonhertz.life.exposure`, a minute for each contact of different load. Hollow rollers
        always use the whole contact, since their walls bend.
    dynamic : float, optional
        C of a catalogue [N], which replaces that of ISO 281; rows must then be equal.

    Raises
    ------
    InputError
        If the bearing was solved by slices or is not of bearing steel, or there is no such model.

    Notes
    -----
    Lives have a reliability of 90 %, without the effect of lubrication and contamination. They are calibrated with the
    capacities of `rating`, which include b_m but not the factor 0.83, lambda nu, for uneven line loads.

    With models of orthogonal shear, such as Lundberg and Palmgren's, lives by ``"sections"`` are within 1 % of those by
    the whole field, also where the pressure peaks at a corner; with a fatigue limit that is nearly reached, within a
    factor of 1.6. With models of other stresses they are up to a quarter too long where the pressure is smooth, and too
    short by a factor of two and more at such a peak, about which a warning is issued.

    Examples
    --------
    >>> import nonhertz as nh
    >>> roller = nh.Roller(diameter=9, length=10, corner_radius=0.3, profile=nh.profile.crown(radius=1200))
    >>> rings = {"inner": nh.Ring(diameter=37.5), "outer": nh.Ring(diameter=-55.5)}
    >>> row = nh.bearing.CylindricalRollerBearing(roller=roller, **rings, rollers=13)
    >>> lives = volume_life(nh.bearing.solve(row, radial=10e3))
    >>> lives.inner < lives.outer
    True
    """
    if not isinstance(solution, BearingSolution):
        raise InputError("solution", solution, "be a loaded bearing", "solve one with nonhertz.bearing.solve")
    if solution.method != "strips":
        raise InputError("solution", "by slices", "be by strips, which give pressures", "solve the bearing by strips")
    chosen = _model_of(model)
    one_of("field", field, FIELDS, "choose 'sections' for speed")
    rated = None if dynamic is None else rating(solution.bearing, dynamic=dynamic)
    turning = RINGS.index(solution.turning)
    of_rows: list[Array] = []
    even: list[Array] = []
    distinct: list[Exposure] = []
    for row in solution.bearing.rows:
        seen = _exposures(solution, range(row.rollers.start, row.rollers.stop), field)
        calibrated = Calibration(row.bearing, rated or rating(row.bearing), chosen)
        of_rows.append(calibrated.lives(seen, turning))
        even.append(calibrated.lives(list(map(_spread_evenly, seen)), turning))
        distinct += _distinct(chain(*seen))
    # For orthogonal shear, sections include the effect of nearby ones.
    knows = field != "sections" or chosen.stress == "orthogonal_shear"
    steep = 0.0 if knows else max((_steep(exposure, chosen) for exposure in distinct), default=0.0)
    stress = chosen.stress.replace("_", " ")
    return VolumeLife(
        chosen, np.array(of_rows), np.array(even), tuple(_findings(singular_ends(solution), steep, stress))
    )


def _model_of(model: VolumeModel | str) -> VolumeModel:
    names = tuple(name for name in MODELS if isinstance(MODELS[name](), VolumeModel))
    if isinstance(model, str) and model in names:
        default = MODELS[model]()
        assert isinstance(default, VolumeModel)
        return default
    if not isinstance(model, VolumeModel):
        raise InputError("model", model, "be a model of the stressed volume", f"choose from {', '.join(names)}")
    return model


def _findings(ends: set[SingularEnd], steep: float, stress: str) -> Iterator[Finding]:
    if ends:
        words = (
            "The damage grows without limit towards {ends}: the volume near it was left out, so lives are upper bounds."
        )
        yield finding("damage-at-ends", words, ends=ends_in_words(ends))
    if steep > _MOST_STEEP:
        yield finding(
            "steep-pressure",
            "{share:.0f} % of the damage below a contact is where the pressure changes by more than {limit:g} % over a "
            f"half-width and sections overestimate {stress}: use field = 'whole'.",
            share=100.0 * steep,
            limit=100.0 * _STEEP,
        )


def _exposures(solution: BearingSolution, rollers: range, field: str) -> list[Seen]:
    """Return the exposures of both rings at every roller, followed by those of the roller at both rings."""
    evaluate = cache(section_exposure if field == "sections" else exposure)

    def seen(contact: Solution | None, body: BodyName) -> Exposure | None:
        return None if contact is None else evaluate(contact, body=body)

    bodies: tuple[BodyName, ...] = ("b", "a")
    return [[seen(solution.contact(j, ring), body) for j in rollers] for body in bodies for ring in RINGS]


def _distinct(seen: Iterable[Exposure | None]) -> list[Exposure]:
    """Return the distinct exposures: those common to several rollers once."""
    return list(dict.fromkeys(exposure for exposure in seen if exposure is not None))


def _spread_evenly(seen: Seen) -> list[Exposure | None]:
    """Return the exposures under the same loads without ends, tilts and profiles."""
    return [None if exposure is None else exposure.reference for exposure in seen]


def _steep(seen: Exposure, chosen: VolumeModel) -> float:
    """Return the fraction of a contact's damage where the pressure is steep along it."""
    pressure = seen.shear.max(axis=1)
    pressure = np.maximum(pressure, _LEAST * pressure.max())
    changes = np.abs(np.gradient(pressure, seen.y)) * seen.half_width / pressure
    damage = seen.width * seen.density(chosen)
    return float(damage[changes > _STEEP].sum() / damage.sum()) if damage.sum() > 0.0 else 0.0


class Calibration:
    """A row's dynamic capacities, and the damage of a million revolutions under them by a model."""

    def __init__(self, row: RollerBearing, rated: Rating, chosen: VolumeModel) -> None:
        self._row, self._model, self._slope = row, chosen, chosen.slope
        gamma = row.roller_diameter * math.cos(0.5 * sum(row.contact_angles)) / row.pitch  # of rolling
        self._passes = 0.5 * row.rollers * np.array([1.0 + gamma, 1.0 - gamma])
        self._spin = 0.5 * row.pitch / row.roller_diameter * (1.0 - gamma**2)
        self._around = row.pitch * np.array([1.0 - gamma, 1.0 + gamma])
        damages = []
        for contact, capacity in zip(row.contacts, (rated.inner, rated.outer), strict=True):
            under = even_exposure(contact, capacity, "b", row.effective_interval)
            assert under is not None  # rollers have ends
            damages.append(under.damage(chosen))
        self._damages = np.array(damages)
        if not np.all(self._damages > 0.0):
            condition = "cause damage at the dynamic capacity: its fatigue limit is above all stresses there"
            raise InputError("model", chosen.name, condition, "give a lower fatigue limit")

    def constants(self) -> Array:
        """Return A, up to a common factor, from the capacity of each ring."""
        factors: Array = 1.0 / (self._passes**self._slope * self._around * self._damages)
        return factors

    def lives(self, seen: Sequence[Seen], turning: int) -> Array:
        """Return the lives of inner ring, outer ring and rollers [10^6 revolutions]."""
        rings = [
            # Each contact with a stationary ring has its own part of the circumference.
            self._passing_damage([seen[k]])
            if k == turning
            else np.mean([0.0 if exposure is None else exposure.damage(self._model) for exposure in seen[k]])
            for k in range(len(RINGS))
        ]
        of_rings = [self._life(damage / self._damages[k]) for k, damage in enumerate(rings)]
        of_rollers = self._row.rollers * self._row.roller_diameter * self._spin**self._slope * self.constants()[0]
        return np.array([*of_rings, self._life(of_rollers * self._passing_damage(seen[2:]))])

    def _passing_damage(self, passes: Sequence[Seen]) -> float:
        """Return the damage of contacts that pass over the same points: mean over rollers, sum over passes."""
        every = [seen for contacts in passes for seen in contacts if seen is not None]
        known = {seen: (seen.y, seen.density(self._model), seen.damage(self._model)) for seen in _distinct(every)}
        loaded = [known[seen] for seen in every if known[seen][2] > 0.0]
        if not loaded:
            return 0.0
        stations = np.unique(np.concatenate([y for y, _, _ in loaded]))
        total = np.zeros(stations.size)
        for y, density, damage in loaded:
            on_stations = np.interp(stations, y, density, left=0.0, right=0.0)
            # Interpolated to other stations, it must add up to the same damage.
            scale = damage / np.trapezoid(on_stations, stations) if stations.size > 1 else 1.0
            total += (on_stations * scale) ** (1.0 / self._slope)
        together = (total / len(passes[0])) ** self._slope
        if stations.size == 1:
            # The length over which a uniform density adds up to the damage.
            return float(together[0] * loaded[0][2] / loaded[0][1][0])
        return float(np.trapezoid(together, stations))

    def _life(self, damage: float) -> float:
        return float(damage ** (-1.0 / self._slope)) if damage > 0.0 else math.inf
