"""Samples of several distributions at once."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nonhertz.inputs.checks import one_of, whole
from nonhertz.io.spreads import Distribution

MOST_SAMPLES, MOST_DIMENSIONS = 10_000_000, 1000
METHODS = ("latin-hypercube", "sobol", "random")


@dataclass(frozen=True)
class Sampling:
    """How samples are drawn.

    Parameters
    ----------
    count : int
        How many.
    method : {"latin-hypercube", "sobol", "random"}
        A Latin hypercube has one sample in each of ``count`` layers of every parameter. Sobol's sequence, scrambled,
        fills space evenly; best with a power of two. Random samples are independent.
    seed : int
        The same seed draws the same samples.

    Raises
    ------
    InputError
        If a value is out of range.
    """

    count: int = 1000
    method: str = "latin-hypercube"
    seed: int = 0

    def __post_init__(self) -> None:
        object.__setattr__(self, "count", whole("count", self.count, 1, MOST_SAMPLES, "give the number of samples"))
        one_of("method", self.method, METHODS, "choose one of them")
        object.__setattr__(self, "seed", whole("seed", self.seed, 0, 2**32 - 1, "give a whole number"))

    def shares(self, dimensions: int) -> NDArray[np.float64]:
        """Return where in its distribution each parameter is, from 0 to 1, shape (count, dimensions).

        Raises
        ------
        InputError
            If there is no dimension, or more than a thousand.
        """
        dimensions = whole("dimensions", dimensions, 1, MOST_DIMENSIONS, "give the number of parameters")
        from scipy.stats import qmc

        generator = np.random.default_rng(self.seed)
        if self.method == "random":
            return generator.random((self.count, dimensions))
        if self.method == "sobol":
            sampler = qmc.Sobol(dimensions, rng=generator)
            return np.asarray(sampler.random_base2(math.ceil(math.log2(self.count)))[: self.count])
        return np.asarray(qmc.LatinHypercube(dimensions, rng=generator).random(self.count))

    def drawn(self, distributions: Sequence[Distribution]) -> NDArray[np.float64]:
        """Return samples of several distributions, shape (count, distributions)."""
        shares = np.clip(self.shares(len(distributions)), 1e-12, 1.0 - 1e-12)
        columns = [each.quantile(shares[:, k]) for k, each in enumerate(distributions)]
        return np.stack(columns, axis=1)
