"""Tolerances: how results are distributed when dimensions are, and which dimension matters.

Samples are drawn in Saltelli's arrangement, so that the same rows give quantiles and Sobol's indices. Quantiles are of
the samples a and b of its blocks, with the interval in which the true quantile lies with 95 % certainty whatever the
distribution: between two of the ordered numbers, chosen by the binomial distribution. It is exact for independent
samples; samples that fill space evenly, as these do, have smaller errors.

The first index of a parameter is the share of the variance that would be gone if the parameter were fixed; its total
index is the share that would be left if all others were. They are estimated from correlations: of results that share
the one parameter, and of results that share all others. The estimate with the smallest asymptotic variance (Janon et
al.) is never above 1 where the product estimates of Saltelli et al. scatter to either side. What scatter puts below 0,
or a total above 1, is set to that bound, which the true index does not cross. Intervals, again of 95 %, are percentiles
of resampled blocks within the same bounds.

References
----------
A. Saltelli et al., Variance based sensitivity analysis of model output, Computer Physics Communications 181 (2010)
259-270, doi:10.1016/j.cpc.2009.09.018, for the arrangement.

A. Janon et al., Asymptotic normality and efficiency of two Sobol index estimators, ESAIM: Probability and Statistics
18 (2014) 342-364, doi:10.1051/ps/2013040, equation (6).

H. A. David, H. N. Nagaraja, Order Statistics, 3rd ed., Wiley 2003, section 7.1, for the intervals of quantiles.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.errors import InputError
from nonhertz.files.bearingfile import BearingCase
from nonhertz.files.casefile import Case
from nonhertz.files.planfile import Plan
from nonhertz.files.sampling import SALTELLI, Sampling
from nonhertz.files.spreads import Distribution
from nonhertz.inputs.checks import numbers
from nonhertz.result.brief import plain_text
from nonhertz.study.sweeps import Progress, Sweep, planned, sweep

Array = NDArray[np.float64]

CERTAINTY = 0.95
SHARES = (0.01, 0.5, 0.99)
FEWEST_BLOCKS = 8  # of indices: fewer cannot be resampled
SEED, RESAMPLED = 1, 400  # of resampling


@dataclass(frozen=True)
class Quantile:
    """The value below which a share of all results lies.

    Attributes
    ----------
    share : float
        The share.
    value : float
        The estimate; nan without samples.
    low, high : float
        Between these the true value lies with 95 % certainty; infinite where there are too few samples to say.
    """

    share: float
    value: float
    low: float
    high: float


@dataclass(frozen=True)
class Index:
    """How much of the variance of a result is due to one parameter.

    Attributes
    ----------
    path : str
        The parameter.
    first, total : float
        The share of the variance that would be gone if it were fixed, and the share that would be left if all others
        were; from 0 to 1.
    first_low, first_high, total_low, total_high : float
        Between these they lie with 95 % certainty.
    """

    path: str
    first: float
    first_low: float
    first_high: float
    total: float
    total_low: float
    total_high: float


class Tolerance:
    """How the results of a plan are distributed.

    Attributes
    ----------
    sweep : Sweep
        The samples and their rows.
    """

    def __init__(self, sweep: Sweep) -> None:
        self.sweep = sweep

    def __repr__(self) -> str:
        said = [f"{len(self.sweep)} rows of {self.sweep.plan.title!r}"]
        for quantity in self.sweep.quantities:
            quantiles = (each.value for each in self.quantiles(quantity.name))
            said.append(f"{quantity.label} {quantity.amount(*quantiles)}")
        said[0] += f"; 1 %, 50 % and 99 % of {self.independent.size} samples:" if len(said) > 1 else ""
        if self.sweep.failed:
            said.append(f"{self.sweep.failed} rows failed")
        return plain_text("Tolerance", said)

    @property
    def independent(self) -> NDArray[np.intp]:
        """The numbers of the rows that are independent samples: those whose values are drawn for them alone."""
        per_block = len(self.sweep.paths) + 2
        return np.arange(len(self.sweep)).reshape(-1, per_block)[:, [0, -1]].ravel()

    def samples(self, name: str) -> Array:
        """Return a quantity of all independent samples, nan where a row has failed.

        Raises
        ------
        KeyError
            If the rows have no such quantity.
        """
        return np.asarray(self.sweep[name], dtype=float)[self.independent]

    def quantiles(self, name: str, shares: ArrayLike = SHARES) -> tuple[Quantile, ...]:
        """Return quantiles of a quantity, of the rows that have not failed.

        Parameters
        ----------
        name : str
            The quantity.
        shares : array_like
            Above 0 and below 1.

        Raises
        ------
        KeyError
            If the rows have no such quantity.
        InputError
            If a share is not between 0 and 1.
        """
        found = np.atleast_1d(numbers("shares", shares, "give shares of all results"))
        if not np.all((found > 0.0) & (found < 1.0)) or found.ndim > 1:
            raise InputError("shares", shares, "lie above 0 and below 1", "give shares of all results")
        values = self.samples(name)
        return tuple(quantile(values[np.isfinite(values)], share) for share in found.tolist())

    def indices(self, name: str) -> tuple[Index, ...]:
        """Return how much of a quantity's variance is due to each parameter, the largest total first.

        Blocks with a row that has failed are left out. Empty if nothing varies, or fewer than eight blocks are left.

        Raises
        ------
        KeyError
            If the rows have no such quantity.
        """
        per_block = len(self.sweep.paths) + 2
        blocks = np.asarray(self.sweep[name], dtype=float).reshape(-1, per_block)
        blocks = blocks[np.all(np.isfinite(blocks), axis=1)]
        if len(blocks) < FEWEST_BLOCKS or np.ptp(blocks) <= 1e-12 * np.abs(blocks).max():
            return ()
        return sobol_indices(self.sweep.paths, blocks - blocks.mean())

    @cached_property
    def tightened_first(self) -> Mapping[str, str]:
        """For each quantity, the parameter whose tolerance to tighten first: that of the largest total index."""
        found = {quantity.name: self.indices(quantity.name) for quantity in self.sweep.quantities}
        return {name: indices[0].path for name, indices in found.items() if indices}


def quantile(values: Array, share: float) -> Quantile:
    """Return a quantile of independent numbers, with its interval.

    Parameters
    ----------
    values : ndarray, shape (n,)
        Finite numbers.
    share : float
        Above 0 and below 1.
    """
    from scipy.stats import binom

    if not values.size:
        return Quantile(share, math.nan, -math.inf, math.inf)
    ordered, beyond = np.sort(values), 0.5 * (1.0 - CERTAINTY)
    # Of n numbers, those below the quantile are binomial.
    low, high = (int(binom.ppf(each, values.size, share)) for each in (beyond, 1.0 - beyond))
    bounds = np.concatenate([[-np.inf], ordered, [np.inf]])
    value = float(np.quantile(ordered, share, method="median_unbiased"))
    return Quantile(share, value, float(bounds[low]), float(bounds[min(high + 1, values.size + 1)]))


def sobol_indices(paths: Sequence[str], blocks: Array) -> tuple[Index, ...]:
    """Return Sobol's indices of parameters, the largest total first.

    Parameters
    ----------
    paths : sequence of str
        Names of the parameters.
    blocks : ndarray, shape (n, parameters + 2)
        Results of Saltelli's arrangement.
    """
    draws = np.random.default_rng(SEED).integers(len(blocks), size=(RESAMPLED, len(blocks)))
    beyond = 0.5 * (1.0 - CERTAINTY)
    ends = np.quantile([_first_and_total(blocks[draw]) for draw in draws], (beyond, 1.0 - beyond), axis=0)
    (first, total), (first_low, total_low), (first_high, total_high) = np.clip(
        [_first_and_total(blocks), *ends], 0.0, 1.0
    ).tolist()
    columns = zip(paths, first, first_low, first_high, total, total_low, total_high, strict=True)
    return tuple(sorted((Index(*column) for column in columns), key=lambda index: -index.total))


def _first_and_total(blocks: Array) -> Array:
    """Return first and total indices without bounds, shape (2, parameters)."""
    a, mixed, b = blocks[:, :1], blocks[:, 1:-1], blocks[:, -1:]  # one parameter of each mixed row is that of b
    return np.stack([1.0 - _uncorrelated(b, mixed), _uncorrelated(a, mixed)])


def _uncorrelated(one: Array, other: Array) -> Array:
    """Return 1 minus the correlation of pairs of the same distribution, with mean and variance of both together."""
    pooled = 0.5 * np.mean(one**2 + other**2, axis=0) - (0.5 * np.mean(one + other, axis=0)) ** 2
    # A resampled column may hold a single value.
    return np.asarray(0.5 * np.mean((one - other) ** 2, axis=0) / np.where(pooled > 0.0, pooled, np.inf))


def tolerance(
    plan: Plan | Case | BearingCase | str | Path,
    *,
    over: Mapping[str, Any] | None = None,
    samples: int | None = None,
    seed: int | None = None,
    quantities: tuple[str, ...] | None = None,
    out: str | Path | None = None,
    workers: int | None = None,
    scheduler: str | None = None,
    announce: Callable[[Progress], object] | None = None,
) -> Tolerance:
    """Solve a case or a bearing for samples of its dimensions and loads, and find what they do to the results.

    Parameters
    ----------
    plan : Plan or Case or BearingCase or str or Path
        A plan, or the file of one; or a case, with ``over``.
    over : mapping, optional
        The distribution of each path of the case's file, such as ``{"body.a.diameter": "normal(nominal, 5 um)"}``.
    samples : int, optional
        How many rows, at most: so many fill whole blocks of two more than there are parameters. By default those of
        the plan, 10,000 if it does not say.
    seed : int, optional
        The same seed draws the same samples.
    quantities, out, workers, scheduler, announce
        As in `nonhertz.sweep`.

    Returns
    -------
    Tolerance

    Raises
    ------
    CaseError, Interrupted, ImportError
        As `nonhertz.sweep`.
    InputError
        As `nonhertz.sweep`; and if a path has values in place of a distribution.

    Examples
    --------
    >>> import nonhertz as nh
    >>> roller = nh.Roller(diameter=20, length=20, profile=nh.profile.crown(radius=4000))
    >>> case = nh.Case(nh.Contact(roller, nh.Plate()), {"load": 20e3}, {"strips": 21})
    >>> over = {"load.load": "normal(20 kN, 1 kN)", "body.a.profile.radius": "uniform(3800 mm, 4200 mm)"}
    >>> found = tolerance(case, over=over, samples=64, quantities=("max_pressure",))
    >>> found.indices("max_pressure")[0].path
    'load.load'
    """
    asked = planned(plan, over, None, quantities, "tolerance")
    if not asked.spreads:
        remedy = "say how a path of the case is distributed, such as 'load.load=normal(nominal,1kN)'"
        raise InputError("over", {}, "vary something", remedy)
    for path, spread in asked.spreads.items():
        if not isinstance(spread, Distribution):
            remedy = "write one, such as 'normal(nominal, 5 um)', or sweep over values"
            raise InputError(path, asked.over[path], "be a distribution", remedy)
    drawn = Sampling(
        asked.samples.count if samples is None else samples, SALTELLI, asked.samples.seed if seed is None else seed
    )
    return Tolerance(
        sweep(asked.changed(samples=drawn), out=out, workers=workers, scheduler=scheduler, announce=announce)
    )
