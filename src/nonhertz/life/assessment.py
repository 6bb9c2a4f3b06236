"""From solved contacts to lives by the chosen models.

Lives are relative to that of the same bodies under an ideal pressure, Hertz's line contact with a uniform load per unit
length. Absolute lives are given where a standard has a capacity: for rollers in cylindrical rings, and for tapered
rollers whose contact angle is known.

Under a spectrum, with the fraction u_i of the revolutions under the load i, damage accumulates by the Palmgren-Miner
rule, 1 / L = sum u_i / L_i.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import chain
from typing import NamedTuple, Unpack

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import format_digits, mm
from nonhertz.errors import InputError
from nonhertz.findings import Finding, HasFindings, finding
from nonhertz.inputs.checks import check_list, whole
from nonhertz.life.capacity import Raceway, raceway
from nonhertz.life.catalogue import MODELS, RATED, Model, VolumeModel, lundberg_palmgren, model
from nonhertz.life.lamina import EXPONENT, LEFT_OUT, LaminaModel, laminae_of
from nonhertz.life.spectrum import check_shares, miner
from nonhertz.life.volume import Exposure, exposure
from nonhertz.model.body import BodyName
from nonhertz.patch.solution import PatchSolution
from nonhertz.result.brief import HasHtml, plain_text, warning_lines
from nonhertz.result.edges import EdgeKind, SingularEnd
from nonhertz.result.ends import ends_in_words, outermost, step_at
from nonhertz.result.read_only import ReadOnly
from nonhertz.result.solution import Solution
from nonhertz.result.solved import Solved
from nonhertz.subsurface.evaluation import Running, refuse_options
from nonhertz.subsurface.inside import Inside, check_body, check_solution

Array = NDArray[np.float64]
Spectrum = Sequence[tuple[Solved, float]]

SHORT = 4.0  # half-widths
_NO_ROLLERS = "it needs the number of rollers"
_ROLLERS_REMEDY = "give the number of rollers in the bearing"


@dataclass(frozen=True, eq=False, repr=False)
class Life(HasFindings, ReadOnly, HasHtml):
    """Fatigue life of one body of a contact by one model.

    Attributes
    ----------
    model : Model
        The model with its parameters.
    body : {"a", "b"}
        Which body.
    damage : float
        The integral of the model over a cross-section of the stressed volume [MPa^k mm^(2-h)], or the sum over laminae
        of (f q / q_c)^(9/2) [-] for one roller; under a spectrum, that of the constant load with the same life. The
        ratio of the lives of two contacts is the ratio of their damages to the power -1/e, for raceways of the same
        length and number of rollers.
    reference : float
        The same under the ideal pressure; NaN where the bodies can touch over an unlimited length.
    million_revolutions : float or None
        L_10 [10^6 revolutions of the ring, all rollers passing under this load], with 90 % reliability. None for the
        roller, without a number of rollers, where no standard gives a capacity, or at a sharp end.
    unrated : Finding or None
        Reason why there is no absolute life; None if there is one.
    raceway : Raceway or None
        The ring under the roller, if the contact is of a ring and a roller.
    y : ndarray, shape (stations,)
        Stations [mm].
    density : ndarray, shape (stations,)
        Damage per length at each station over the mean of the reference [-]; 1 under the ideal pressure.
    findings : tuple of Finding
        Limits of the validity of the result.
    """

    model: Model
    body: BodyName
    damage: float
    reference: float
    million_revolutions: float | None
    unrated: Finding | None
    raceway: Raceway | None
    y: Array
    density: Array
    findings: tuple[Finding, ...]

    def __repr__(self) -> str:
        relative, absolute = self.relative_life, self.million_revolutions
        ideal = (
            "no damage"
            if math.isnan(relative)
            else f"{format_digits(relative, 3)} of the life under the ideal pressure"
        )
        rated = f"no life in revolutions: {self.unrated}"
        if absolute is not None:
            rated = f"L10 = {format_digits(absolute, 4)} million revolutions"
        return plain_text("Life", [f"{self.model.name}, body {self.body}", ideal, rated, *warning_lines(self.warnings)])

    @property
    def no_revolutions(self) -> str:
        """Reason why there is no life in revolutions; empty if there is one."""
        return "" if self.unrated is None else str(self.unrated)

    @property
    def relative_life(self) -> float:
        """Life over the life under the ideal pressure [-].

        Infinite without damage; NaN without a reference, or where neither pressure causes damage.
        """
        return ratio(self.reference, self.damage, self.model.slope)

    def over(self, other: Life) -> float:
        """Return this life over another by the same model [-].

        NaN for laminae where only one of the contacts has a raceway: the damages then refer to different capacities.

        Raises
        ------
        InputError
            If the models differ.
        """
        if not isinstance(other, Life) or self.model != other.model:
            remedy = "compare lives by one model with the same parameters"
            named = getattr(getattr(other, "model", other), "name", other)
            raise InputError("other", named, f"be by the model {self.model.name}", remedy)
        if isinstance(self.model, LaminaModel) and (self.raceway is None) != (other.raceway is None):
            return math.nan
        return ratio(other.damage, self.damage, self.model.slope)


def ratio(reference: float, damage: float, slope: float) -> float:
    """Return the life under a damage over that under a reference."""
    if damage == 0.0:
        return math.inf if reference > 0.0 else math.nan
    return float((reference / damage) ** (1.0 / slope))


def assess(
    solution: Solved | Spectrum,
    models: Model | str | Iterable[Model | str] = (),
    *,
    body: BodyName = "a",
    rollers: int | None = None,
    contact_angle: float | None = None,
    **options: Unpack[Running],
) -> tuple[Life, ...]:
    """Return the fatigue life of one body of a contact by several models.

    Parameters
    ----------
    solution : Solution or PatchSolution, or several of them with shares
        A solved contact, or a spectrum: pairs of a solution and its share of the revolutions; see
        `nonhertz.life.solve_spectrum`. Where the shares add up to less than 1, the contact is unloaded for the rest,
        like rollers outside the load zone.
    models : model or name, or several
        See `nonhertz.life.MODELS`; all of them, with default parameters, if left out.
    body : {"a", "b"}
        The body that fatigues. The capacity of ISO 281, and with it a life in revolutions, refers to the ring.
    rollers : int, optional
        Number of rollers in the bearing, for absolute lives.
    contact_angle : float, optional
        Contact angle of the bearing [rad], required for absolute lives of tapered rollers; see `nonhertz.life.raceway`.
    **options
        ``threads`` and ``callback`` as in `nonhertz.subsurface.stress`.

    Returns
    -------
    tuple of Life
        One for each model.

    Raises
    ------
    InputError
        If a model, body or share is not valid, or nothing is in contact.

    Notes
    -----
    Absolute lives follow from the capacities of ISO 281, which include b_m = 1.1 but not the factor 0.83 (lambda nu)
    that lowers the load rating of a bearing for uneven line loads.

    Compared with grids four times as fine, relative lives are within 0.5 % where the pressure is smooth. At a sharp
    end, or a corner of the profile where the contact ends, the damage is unbounded by every model; the volume within a
    tenth of the largest half-width of it is then left out, and a warning says so.

    Examples
    --------
    >>> import nonhertz as nh
    >>> ring = nh.Ring(diameter=80)
    >>> roller = nh.Roller(diameter=20, length=20, profile=nh.profile.iso_logarithmic(diameter=20, length=20))
    >>> (life,) = assess(nh.solve(nh.Contact(roller, ring), load=20e3), "lundberg-palmgren", body="b")
    >>> round(life.relative_life, 2)
    0.75
    """
    refuse_options("assess", options, Running)
    check_body(body)
    chosen = _choose_models(models)
    spectrum = _spectrum(solution)
    ring, why = raceway(spectrum[0][0].contact, contact_angle=contact_angle)
    bearing = _Bearing(ring, why, _check_rollers(rollers, ring), body)
    exposures: list[Exposure] = []
    if any(isinstance(member, VolumeModel) for member in chosen):
        exposures = [exposure(solution, body=body, **options) for solution, _ in spectrum]
    return tuple(_assess_model(member, spectrum, exposures, bearing) for member in chosen)


class _Bearing(NamedTuple):
    """Data of the bearing: the ring or the reason why there is none, the number of rollers, and the body assessed."""

    ring: Raceway | None
    why: str
    rollers: int | None
    body: BodyName


def _check_rollers(rollers: int | None, ring: Raceway | None) -> int | None:
    if rollers is None:
        return None
    rollers = whole("rollers", rollers, 1, math.inf, _ROLLERS_REMEDY)
    if ring is not None and rollers > ring.most_rollers:
        condition = f"fit side by side on the pitch circle of {mm(ring.pitch_diameter):g}, {ring.most_rollers} at most"
        raise InputError("rollers", rollers, condition, _ROLLERS_REMEDY)
    return rollers


def _choose_models(models: Model | str | Iterable[Model | str]) -> list[Model]:
    several = [models] if isinstance(models, str | VolumeModel | LaminaModel) else models
    remedy = f"give models or their names: {', '.join(MODELS)}"
    members = check_list("models", several, "be a fatigue model or several", remedy)
    chosen = [model(member) if isinstance(member, str) else member for member in members or MODELS]
    for member in chosen:
        if not isinstance(member, VolumeModel | LaminaModel):
            raise InputError("models", member, "be a fatigue model or several", remedy)
    return chosen


def _spectrum(solution: Solved | Spectrum) -> Spectrum:
    if isinstance(solution, Solution | PatchSolution):
        return [(check_solution(solution), 1.0)]
    condition, remedy = "be a solved contact or several with their shares", "give pairs of a solution and its share"
    return check_shares(solution, check_solution, "contact", condition, f"{remedy} of the revolutions")


class _Damage(NamedTuple):
    """Damage by one load: in total, under the ideal pressure, and per length along y, with limits of its validity."""

    total: float
    ideal: float
    y: Array
    density: Array
    singular_ends: tuple[SingularEnd, ...]
    findings: tuple[Finding, ...] = ()


def _damage_in_volume(chosen: VolumeModel, solution: Solved, exposed: Exposure) -> _Damage:
    ideal = math.nan if exposed.reference is None else exposed.reference.damage(chosen)
    ends, findings = solution.singular_ends, Inside.of(solution, exposed.body).findings
    return _Damage(exposed.damage(chosen), ideal, exposed.y, exposed.density(chosen), ends, findings)


def _damage_of_laminae(chosen: LaminaModel, solution: Solved, ring: Raceway | None) -> _Damage:
    laminae = laminae_of(solution, chosen)
    edges = laminae.edges
    # Without a ring the capacity depends only on the length.
    capacity = ring.capacity(1) if ring is not None else float(edges[-1] - edges[0]) ** (7.0 / 9.0)
    damages = laminae.damage(capacity)
    ideal = (solution.load / capacity) ** EXPONENT
    ends = solution.singular_ends if laminae.sharp else ()
    return _Damage(float(damages.sum()), ideal, 0.5 * (edges[1:] + edges[:-1]), damages, ends)


def _million_revolutions(
    chosen: Model, damage: float, spectrum: Spectrum, damages: list[_Damage], ring: Raceway, rollers: int
) -> float:
    if isinstance(chosen, LaminaModel):
        # Each roller passes once per revolution: the capacity falls as Z^(-1/4), and the life as 1 / Z.
        return float(damage ** (-1.0 / chosen.slope) / rollers)
    # For each load by itself: (Q_c / Q)^4 for the ideal pressure, times the relative life.
    of_loads = [
        (ring.capacity(rollers) / solution.load) ** 4 * ratio(of_load.ideal, of_load.total, chosen.slope)
        for (solution, _), of_load in zip(spectrum, damages, strict=True)
    ]
    return miner(of_loads, [share for _, share in spectrum])


def _assess_model(chosen: Model, spectrum: Spectrum, exposures: list[Exposure], bearing: _Bearing) -> Life:
    solutions, weights = zip(*spectrum, strict=True)
    ring, rollers = bearing.ring, bearing.rollers
    if isinstance(chosen, VolumeModel):
        mean_length = float(np.ptp(solutions[0].contact.land))
        damages = [_damage_in_volume(chosen, *pair) for pair in zip(solutions, exposures, strict=True)]
    else:
        mean_length = chosen.laminae
        damages = [_damage_of_laminae(chosen, solution, ring) for solution in solutions]
    totals, ideals, y, densities, ends_of, findings_of = zip(*damages, strict=True)
    ends, shares = set(chain.from_iterable(ends_of)), np.array(weights)
    damage, reference = (_combine_damage(np.array(values), shares, chosen.slope) for values in (totals, ideals))
    stations, density = _density(y, densities, np.array(totals), shares, chosen)
    unrated, absolute = _why_unrated(chosen, bearing, ends), None
    if unrated is None and ring is not None and rollers is not None:
        absolute = _million_revolutions(chosen, damage, spectrum, damages, ring, rollers)
    strains = dict.fromkeys(chain.from_iterable(solution.findings for solution in solutions))
    findings = (*strains, *_towards_ends(solutions, ends), *dict.fromkeys(chain.from_iterable(findings_of)))
    over = _over(density, reference / mean_length)
    return Life(chosen, bearing.body, damage, reference, absolute, unrated, ring, stations, over, findings)


def _towards_ends(solutions: Sequence[Solved], ends: set[SingularEnd]) -> Iterator[Finding]:
    """Yield findings on the effect of singular ends on the damage, if there are any."""
    if not ends:
        return
    nearer = f"nearer to {'them' if len(ends) > 1 else 'it'}"
    yield finding(
        "damage-at-ends",
        f"The damage grows without limit towards {{ends}}: the volume {nearer} than {{left_out:g}} of the largest "
        "half-width was left out, so the life is an upper bound, even above 1.",
        ends=ends_in_words(ends),
        left_out=LEFT_OUT,
    )
    if any(_is_coarse(solution, end) for solution in solutions for end in solution.singular_ends):
        what = "a corner" if all(end.kind is EdgeKind.CORNER for end in ends) else "a sharp end"
        words = f"The strips or cells at {what} are longer than the region left out: use finer ones."
        yield finding("coarse-at-ends", words)
    if any(np.ptp(outermost(solution)) < SHORT * solution.max_half_width for solution in solutions):
        words = (
            "The contact is shorter than {shortest:g} half-widths between its ends: hardly any volume is left to count."
        )
        yield finding("short-contact", words, shortest=SHORT)


def _is_coarse(solution: Solved, end: SingularEnd) -> bool:
    """Return whether the strip or row at an end is longer than the region left out there."""
    return step_at(solution, end) > LEFT_OUT * solution.max_half_width


def _over(density: Array, mean: float) -> Array:
    """Return densities over a mean; NaN where the mean is unknown, infinite where it is zero."""
    with np.errstate(divide="ignore", invalid="ignore"):
        return density / mean


def _why_unrated(chosen: Model, bearing: _Bearing, ends: set[SingularEnd]) -> Finding | None:
    """Return the reason why a model gives no life in revolutions for a body, or None."""
    ring, why, rollers, body = bearing
    if why:
        return Finding.from_text(why)
    if chosen.name not in RATED:
        return Finding.from_text(f"{chosen.name} has no capacity of its own")
    if isinstance(chosen, VolumeModel) and chosen != lundberg_palmgren():
        return Finding.from_text("the capacity of ISO 281 holds for the slope 9/8 and the usual exponents")
    if ring is not None and ring.body != body:
        return Finding.from_text(f"the capacity is that of the ring, body {ring.body}")
    if rollers is None:
        return Finding.from_text(_NO_ROLLERS)
    words = "the damage grows without limit towards {ends}"
    return finding("damage-at-ends", words, ends=ends_in_words(ends)) if ends else None


def _combine_damage(damages: Array, shares: Array, slope: float) -> float:
    """Return the damage under a constant load with the same life as the spectrum."""
    return float((shares @ damages ** (1.0 / slope)) ** slope)


def _density(
    y: Sequence[Array], densities: Sequence[Array], damages: Array, shares: Array, model: Model
) -> tuple[Array, Array]:
    """Return the union of all stations, and the damage per length there whose integral is the spectrum's damage."""
    slope = model.slope
    together = _combine_damage(damages, shares, slope)
    stations = y[0] if len(y) == 1 else np.unique(np.concatenate(y))
    total = np.zeros(stations.size)
    for along, density, damage, share in zip(y, densities, damages, shares, strict=True):
        if damage > 0.0:
            counted = share * (damage / together) ** (1.0 / slope - 1.0)
            total += counted * np.interp(stations, along, density, left=0.0, right=0.0)
    return stations, total
