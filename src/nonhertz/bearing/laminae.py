"""The laminae of ISO/TS 16281 in a whole bearing.

    L10r = {sum_k [(q_ei / q_ci)^(9/2) + (q_ee / q_ce)^(9/2)]}^(-8/9)     over the laminae k of all rows,

q_e being the mean over the rollers of the row of (f q)^4 to the power 1/4 at the ring that rotates relative to the
load, and the mean with the power 9/2 at the other ring; q_c = Q_c n^(-7/9) is the capacity of a lamina. The bearing
load that would load all laminae like this one,

    P_k = 0.323 i Z cos(alpha) n {[q_ei^(9/2) + (r q_ee)^(9/2)] / [1 + r^(9/2)]}^(2/9)        r = 1.038 q_ci / q_ce,

gives it a factor a_ISO; its damage is divided by a_ISO^(9/8). P_k is from one program, for a single row; the number of
rows i is added here, since C_u refers to all rows together.

Towards a sharp end the pressure grows as s^-0.226 for steel on steel, and the damage (p^2)^(9/2) as s^-2: its sum
diverges, and no life by pressures exists.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from nonhertz.bearing.lubrication import MOST_FACTOR, life_factor
from nonhertz.bearing.ratings import Rating
from nonhertz.bearing.section import RINGS
from nonhertz.bearing.solution import BearingSolution
from nonhertz.bearing.standard import slice_loads
from nonhertz.life.lamina import EXPONENT, SLOPE, edge_function, iso_16281, laminae_of
from nonhertz.result.edges import SingularEnd

Array = NDArray[np.float64]

TURNING, STANDING = 4.0, 4.5  # powers of means over rollers
_WORST_FACTOR = 0.1


def singular_ends(solution: BearingSolution) -> set[SingularEnd]:
    """Return the ends of loaded contacts at which the pressure is singular."""
    return {end for contact in solution.distinct_contacts for end in contact.solved.singular_ends}


def lamina_means(solution: BearingSolution, laminae: int, edge_stress: str, turning: str) -> list[Array]:
    """Return q_e of every lamina [N] at both rings, shape (2, laminae), for each row."""
    effective = _effective_loads(solution, laminae, edge_stress)
    return [mean_over_rollers(effective[row.rollers], turning) for row in solution.bearing.rows]


def mean_over_rollers(effective: Array, turning: str) -> Array:
    """Return the mean over rollers of loads of shape (rollers, 2, laminae), with the power of each ring."""
    powers = [TURNING if ring == turning else STANDING for ring in RINGS]
    return np.array([np.mean(effective[:, k] ** power, axis=0) ** (1.0 / power) for k, power in enumerate(powers)])


def lamina_life(rated: Rating, means: list[Array], factors: list[Array] | None = None) -> float:
    """Return the life [10^6 revolutions] of rows of laminae, with optional life factors."""
    damage = 0.0
    for number, loads in enumerate(means):
        count = loads.shape[1]
        capacities = np.array([[rated.inner], [rated.outer]]) * count ** (-7.0 / 9.0)
        longer = np.ones(count) if factors is None else factors[number]
        damage += float(np.sum(np.sum((loads / capacities) ** EXPONENT, axis=0) * longer**-SLOPE))
    return damage ** (-1.0 / SLOPE) if damage > 0.0 else math.inf


def life_factors(
    solution: BearingSolution, rated: Rating, means: list[Array], kappa: float, contamination: float
) -> list[Array]:
    """Return a_ISO of every lamina, for each row."""
    limit = contamination * rated.fatigue_limit
    factors = []
    for row, mean in zip(solution.bearing.rows, means, strict=True):
        share = 1.038 * rated.inner / rated.outer
        both = (mean[0] ** EXPONENT + (share * mean[1]) ** EXPONENT) / (1.0 + share**EXPONENT)
        size = 0.323 * rated.rows * row.bearing.rollers * math.cos(row.bearing.nominal_angle) * mean.shape[1]
        factors.append(np.array([_factor_at(kappa, limit, load) for load in size * both ** (1.0 / EXPONENT)]))
    return factors


def _factor_at(kappa: float, limit: float, load: float) -> float:
    if load <= 0.0:
        return MOST_FACTOR
    # Without a fatigue limit lubrication has no effect.
    return life_factor(kappa, limit / load) if limit > 0.0 else _WORST_FACTOR


def _effective_loads(solution: BearingSolution, laminae: int, edge_stress: str) -> Array:
    """Return f q of every lamina [N], shape (rollers, 2, laminae)."""
    effective = np.zeros((*solution.load.shape, laminae))
    if solution.method == "slices":
        effective = np.concatenate([loads for _, loads in slice_loads(solution, laminae)])
        return effective * (edge_function(laminae) if edge_stress == "standard" else 1.0)
    model = iso_16281(laminae=laminae, edge_stress=edge_stress)
    for row, ring, rollers, contact in solution.distinct_contacts:
        cut = laminae_of(contact, model, row.bearing.effective_interval)
        effective[rollers, ring] = cut.factor * cut.load
    return effective
