"""Tolerances: distributions of results from those of dimensions, and the influence of each dimension.

Samples are drawn in Saltelli's arrangement, so that the same rows give quantiles and Sobol's indices. Quantiles are of
the samples a and b of its blocks, with the interval in which the true quantile lies with 95 % certainty whatever the
distribution: between two of the ordered numbers, chosen by the binomial distribution. It is exact for independent
samples; samples that fill space evenly, as these do, have smaller errors.

The first index of a parameter is the share of the variance that would be gone if the parameter were fixed; its total
index is the share that would be left if all others were. They are estimated from correlations: of results that share
the one parameter, and of results that share all others. That of smallest asymptotic variance (Janon et al.) cannot
exceed 1, as the products of Saltelli et al. do. Small first indices scatter more for it, but none is below 0 or above
its total in truth: estimates and intervals are cut off there. Intervals are percentiles of resampled blocks, again of
95 %.

References
----------
A. Saltelli et al., Variance based sensitivity analysis of model output, Computer Physics Communications 181 (2010)
259-270, doi:10.1016/j.cpc.2009.09.018, for the arrangement.

A. Janon et al., Asymptotic normality and efficiency of two Sobol index estimators, ESAIM: Probability and Statistics
18 (2014) 342-364, doi:10.1051/ps/2013040.

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
from nonhertz.findings import finding
from nonhertz.inputs.checks import numbers
from nonhertz.result.brief import HasHtml, plain_text
from nonhertz.result.quantities import Quantity
from nonhertz.study.limits import CERTAINTY, Capability, Limit, capabilities, limits_in
from nonhertz.study.quantities import choose_quantities, known_quantities
from nonhertz.study.sweeps import Progress, Sweep, make_plan, sweep
from nonhertz.verdict import Level, Verdict

Array = NDArray[np.float64]

PROBABILITIES = (0.01, 0.5, 0.99)
FEWEST_BLOCKS = 8  # of indices: fewer cannot be resampled
SEED, RESAMPLED = 1, 400  # of resampling
#: The default results of a study: pressure and life.
MAIN = ("max_pressure", "life", "relative_life", "basic_life", "reference_life", "modified_life", "static_safety")
# The quality of a row, and a position: not reasons to tighten a tolerance.
_NO_RESULTS = {"error", "warnings", "max_pressure_y"}
WORTH_TIGHTENING = 0.02  # of the variance, in total: smaller shares are negligible


@dataclass(frozen=True)
class Quantile:
    """The value below which a result lies with a probability.

    Attributes
    ----------
    probability : float
        The probability, above 0 and below 1.
    value : float
        The estimate; NaN without samples.
    low, high : float
        Its 95 % confidence interval; infinite with too few samples.
    """

    probability: float
    value: float
    low: float
    high: float


@dataclass(frozen=True)
class Index:
    """Sobol's indices of one parameter: its contribution to the variance of a result.

    Attributes
    ----------
    path : str
        The parameter.
    first, total : float
        The share of the variance that would vanish if the parameter were fixed, and the share that would remain if all
        others were fixed; from 0 to 1.
    first_low, first_high, total_low, total_high : float
        Their 95 % confidence intervals.
    """

    path: str
    first: float
    first_low: float
    first_high: float
    total: float
    total_low: float
    total_high: float


class Tolerance(HasHtml):
    """The distributions of the results of a plan.

    Attributes
    ----------
    sweep : Sweep
        The samples and their rows.
    limits : tuple of Limit
        Limits of quantities.
    main : tuple of Quantity
        The results to study: those named by the plan and those with a limit; by default pressures and lives, or all if
        rows have none.
    """

    def __init__(self, sweep: Sweep, limits: tuple[Limit, ...] = (), names: Sequence[str] = ()) -> None:
        self.sweep, self.limits = sweep, limits
        main = {*(names or MAIN), *(limit.name for limit in limits)}
        known_ones = (quantity for quantity in sweep.quantities if names or sweep.extremes(quantity.name) is not None)
        self.main = tuple(quantity for quantity in known_ones if quantity.name in main) or self.results
        self._indices: dict[str, tuple[Index, ...]] = {}

    def __repr__(self) -> str:
        title = f" of {self.sweep.plan.title!r}" if self.sweep.plan.title else ""
        lines = [f"{len(self.sweep)} rows{title}"]
        for quantity in self.main:
            quantiles = (quantile.value for quantile in self.quantiles(quantity.name))
            lines.append(f"{quantity.label} {quantity.amount(*quantiles)}")
        lines[0] += f"; 1 %, 50 % and 99 % of {self.independent.size} samples:" if len(lines) > 1 else ""
        lines += [
            f"{part.beyond} of {part.samples} samples are beyond the limit of {part.quantity}"
            for part in self.capabilities
        ]
        if self.sweep.failed:
            lines.append(f"{self.sweep.failed} rows failed")
        return plain_text("Tolerance", lines)

    @property
    def independent(self) -> NDArray[np.intp]:
        """The numbers of the rows that are independent samples, all of whose values are drawn anew."""
        per_block = len(self.sweep.paths) + 2
        return np.arange(len(self.sweep)).reshape(-1, per_block)[:, [0, -1]].ravel()

    def samples(self, name: str) -> Array:
        """Return a quantity of all independent samples, NaN where a row has failed.

        Raises
        ------
        KeyError
            If the rows have no such quantity.
        """
        return np.asarray(self.sweep[name], dtype=float)[self.independent]

    def quantiles(self, name: str, probabilities: ArrayLike = PROBABILITIES) -> tuple[Quantile, ...]:
        """Return quantiles of a quantity over the rows that have not failed.

        Parameters
        ----------
        name : str
            The quantity.
        probabilities : array_like
            Above 0 and below 1.

        Raises
        ------
        KeyError
            If the rows have no such quantity.
        InputError
            If a probability is not between 0 and 1.
        """
        wanted = np.atleast_1d(numbers("probabilities", probabilities, "give probabilities"))
        if not np.all((wanted > 0.0) & (wanted < 1.0)) or wanted.ndim > 1:
            raise InputError("probabilities", probabilities, "lie above 0 and below 1", "give probabilities")
        values = self.samples(name)
        return tuple(quantile(values[np.isfinite(values)], share) for share in wanted.tolist())

    @property
    def results(self) -> tuple[Quantity, ...]:
        """The quantities for which tolerances are ranked: not given quantities, such as a tilt, nor positions."""
        none = self.sweep.given | _NO_RESULTS
        return tuple(quantity for quantity in self.sweep.quantities if quantity.name not in none)

    @cached_property
    def capabilities(self) -> tuple[Capability, ...]:
        """The independent samples compared with the limits."""
        return tuple(side for limit in self.limits for side in capabilities(limit, self.samples(limit.name)))

    @property
    def verdict(self) -> Verdict | None:
        """Whether all samples are within the limits, and limits of materials are met."""
        beyond, of_rows = [], self.sweep.verdict
        for side in self.capabilities:
            if side.beyond:
                quantity = known_quantities(bearing=self.sweep.plan.template.is_bearing)[side.quantity]
                words = "{beyond} of {samples} samples are beyond the limit of the {label}, {kind} {limit:.6g}."
                numbers = {"samples": side.samples, "beyond": side.beyond, "limit": quantity.amount(side.limit)}
                beyond.append(finding("beyond-limit", words, label=quantity.label, kind=side.kind, **numbers))
        if not beyond:
            return of_rows
        return Verdict(Level.NOT_MET, (*beyond, *(of_rows.findings if of_rows else ())))

    def indices(self, name: str) -> tuple[Index, ...]:
        """Return Sobol's indices of all parameters for a quantity, the largest total first.

        Blocks with a row that has failed are left out. Empty if nothing varies, or fewer than eight blocks are left.

        Raises
        ------
        KeyError
            If the rows have no such quantity.
        """
        if not isinstance(name, str) or name not in self._indices:
            per_block = len(self.sweep.paths) + 2
            blocks = np.asarray(self.sweep[name], dtype=float).reshape(-1, per_block)
            blocks = blocks[np.all(np.isfinite(blocks), axis=1)]
            varies = len(blocks) >= FEWEST_BLOCKS and np.ptp(blocks) > 1e-12 * np.abs(blocks).max()
            self._indices[name] = sobol_indices(self.sweep.paths, blocks - blocks.mean()) if varies else ()
        return self._indices[name]

    @cached_property
    def tightened_first(self) -> Mapping[str, tuple[str, ...]]:
        """For each result, the parameters whose tolerances to tighten first; results without any are left out.

        These are the one with the largest total index, and those that cannot be distinguished from it, because their
        intervals reach its estimate. Loads are not tolerances, and parameters with less than 2 % of the variance are
        left out.
        """
        first = {}
        for quantity in self.results:
            ranked = [index for index in self.indices(quantity.name) if not is_operating_load(index.path)]
            if ranked and ranked[0].total >= WORTH_TIGHTENING:
                first[quantity.name] = tuple(index.path for index in ranked if index.total_high >= ranked[0].total)
        return first


def is_operating_load(path: str) -> bool:
    """Return whether a path is an operating load, which no drawing limits; a tilt is limited.

    Examples
    --------
    >>> is_operating_load("load.radial"), is_operating_load("load.tilt"), is_operating_load("body.a.diameter")
    (True, False, False)
    """
    section, _, name = path.partition(".")
    return section == "load" and not name.startswith("tilt")


def quantile(values: Array, probability: float) -> Quantile:
    """Return a quantile of independent numbers, with its interval.

    Parameters
    ----------
    values : ndarray, shape (n,)
        Finite numbers.
    probability : float
        Above 0 and below 1.
    """
    from scipy.stats import binom

    if not values.size:
        return Quantile(probability, math.nan, -math.inf, math.inf)
    ordered, beyond = np.sort(values), 0.5 * (1.0 - CERTAINTY)
    # The number of samples below the quantile is binomial.
    low, high = (int(binom.ppf(bound, values.size, probability)) for bound in (beyond, 1.0 - beyond))
    bounds = np.concatenate([[-np.inf], ordered, [np.inf]])
    value = float(np.quantile(ordered, probability, method="median_unbiased"))
    return Quantile(probability, value, float(bounds[low]), float(bounds[min(high + 1, values.size + 1)]))


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
    first, total = np.clip([_first_and_total(blocks), *ends], 0.0, 1.0).transpose(1, 0, 2)
    # A first index is no larger than its total: where they cross, the one with the narrower interval counts.
    better = np.where(np.ptp(first[1:], axis=0) < np.ptp(total[1:], axis=0), first[0], total[0])
    first[0], total[0] = np.where(first[0] > total[0], better, [first[0], total[0]])
    first[2], total[1] = np.minimum(first[2], total[2]), np.maximum(total[1], first[1])
    for rows in (first, total):
        rows[1], rows[2] = np.minimum(rows[1], rows[0]), np.maximum(rows[2], rows[0])
    columns = zip(paths, *first.tolist(), *total.tolist(), strict=True)
    return tuple(sorted((Index(*column) for column in columns), key=lambda index: -index.total))


def _first_and_total(blocks: Array) -> Array:
    """Return first and total indices without bounds, shape (2, parameters)."""
    a, mixed, b = blocks[:, :1], blocks[:, 1:-1], blocks[:, -1:]  # one parameter of each mixed row is that of b
    return np.stack([1.0 - _one_minus_correlation(b, mixed), _one_minus_correlation(a, mixed)])


def _one_minus_correlation(one: Array, other: Array) -> Array:
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
    limits: Mapping[str, Any] | None = None,
    out: str | Path | None = None,
    workers: int | None = None,
    scheduler: str | None = None,
    callback: Callable[[Progress], object] | None = None,
) -> Tolerance:
    """Propagate distributions of the dimensions and loads of a case or a bearing to its results, by sampling.

    Parameters
    ----------
    plan : Plan or Case or BearingCase or str or Path
        A plan, or the file of one; or a case, with ``over``.
    over : mapping, optional
        The distribution of each path of the case's file, such as ``{"body.a.diameter": "normal(nominal, 5 um)"}``.
    samples : int, optional
        Largest number of rows; whole blocks have two more rows than there are parameters. By default that of the plan,
        or 2,000.
    seed : int, optional
        The same seed draws the same samples.
    limits : mapping, optional
        Limits of quantities, such as ``{"max_pressure": "at most 3800 MPa"}``; by default those of the plan. Their
        quantities are added to the rows.
    quantities, out, workers, scheduler, callback
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
    study = make_plan(plan, over, None, quantities, "tolerance").changed(limits=limits)
    if not study.spreads:
        remedy = "give the distribution of a path of the case, such as 'load.load=normal(nominal,1kN)'"
        raise InputError("over", {}, "vary something", remedy)
    for path, spread in study.spreads.items():
        if not isinstance(spread, Distribution):
            remedy = "write one, such as 'normal(nominal, 5 um)', or sweep over values"
            raise InputError(path, study.over[path], "be a distribution", remedy)
    drawn = Sampling(
        study.samples.count if samples is None else samples, SALTELLI, study.samples.seed if seed is None else seed
    )
    names, bounds = study.quantities, check_limits(study)
    usual = [quantity.name for quantity in choose_quantities(names, bearing=study.template.is_bearing)]
    rows = tuple(dict.fromkeys([*usual, *(limit.name for limit in bounds)]))
    study = study.changed(samples=drawn, quantities=rows)
    return Tolerance(sweep(study, out=out, workers=workers, scheduler=scheduler, callback=callback), bounds, names)


def check_limits(plan: Plan) -> tuple[Limit, ...]:
    """Return the limits of a plan.

    Raises
    ------
    InputError
        If there is no such quantity, or a text is not a limit.
    """
    try:
        return limits_in(plan.limits, known_quantities(bearing=plan.template.is_bearing))
    except InputError as error:
        raise error.within("limits") from None
