"""Samples of several distributions at once."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Annotated

import numpy as np
from numpy.typing import NDArray

from nonhertz.files.spreads import Distribution
from nonhertz.inputs.checks import whole
from nonhertz.inputs.descriptions import Count, Word
from nonhertz.inputs.fields import Input, input_class

MOST_SAMPLES, MOST_DIMENSIONS = 10_000_000, 1000
SALTELLI = "saltelli"
_DIMENSIONS = "give the number of parameters"
METHODS = ("latin-hypercube", "sobol", "random", SALTELLI)


@input_class()
class Sampling(Input):
    """How samples are drawn from distributions.

    A Latin hypercube has one sample in each of ``count`` layers of every parameter. Sobol's sequence, scrambled, fills
    space evenly; best with a power of two. Random samples are independent. Saltelli's arrangement, for Sobol's indices,
    consists of blocks: a sample a, for each parameter a copy of a with that parameter taken from b, and a sample b.

    Raises
    ------
    InputError
        If a value is out of range.
    """

    count: Annotated[int, Count("how many", 1, MOST_SAMPLES, "give the number of samples")] = 2_000
    method: Annotated[
        str,
        Word("'latin-hypercube', 'sobol' or 'random'; 'saltelli' for indices", "choose one of them", METHODS),
    ] = "latin-hypercube"
    seed: Annotated[
        int, Count("a whole number; the same draws the same samples", 0, 2**32 - 1, "give a whole number")
    ] = 0

    def shares(self, dimensions: int) -> NDArray[np.float64]:
        """Return the quantile of each parameter in its distribution, from 0 to 1, shape (count, dimensions).

        Raises
        ------
        InputError
            If there is no dimension, or more than a thousand.
        """
        dimensions = whole("dimensions", dimensions, 1, MOST_DIMENSIONS, _DIMENSIONS)
        from scipy.stats import qmc

        if self.method == SALTELLI:
            return self._in_blocks(dimensions)
        generator = np.random.default_rng(self.seed)
        if self.method == "random":
            return generator.random((self.count, dimensions))
        if self.method == "sobol":
            sampler = qmc.Sobol(dimensions, rng=generator)
            return np.asarray(sampler.random_base2(math.ceil(math.log2(self.count)))[: self.count])
        return np.asarray(qmc.LatinHypercube(dimensions, rng=generator).random(self.count))

    def blocks(self, dimensions: int) -> int:
        """Return the number of blocks in Saltelli's arrangement: as many as fit into ``count``, at least one.

        Raises
        ------
        InputError
            As for `shares`.
        """
        dimensions = whole("dimensions", dimensions, 1, MOST_DIMENSIONS, _DIMENSIONS)
        return max(1, self.count // (dimensions + 2))

    def size(self, dimensions: int) -> int:
        """Return the number of samples that are drawn: ``count``, or as many as fill whole blocks.

        Raises
        ------
        InputError
            As for `shares`.
        """
        blocks = self.blocks(dimensions)
        return blocks * (dimensions + 2) if self.method == SALTELLI else self.count

    def _in_blocks(self, dimensions: int) -> NDArray[np.float64]:
        """Return Saltelli's arrangement, block after block."""
        pairs = Sampling(self.blocks(dimensions), "sobol", self.seed).shares(2 * dimensions)
        first, second = pairs[:, :dimensions], pairs[:, dimensions:]
        blocks = np.repeat(first[:, None, :], dimensions + 2, axis=1)
        for k in range(dimensions):
            blocks[:, k + 1, k] = second[:, k]
        blocks[:, -1] = second
        return blocks.reshape(-1, dimensions)

    def draw(self, distributions: Sequence[Distribution]) -> NDArray[np.float64]:
        """Return samples of several distributions, shape (count, distributions)."""
        shares = np.clip(self.shares(len(distributions)), 1e-12, 1.0 - 1e-12)
        columns = [distribution.quantile(shares[:, k]) for k, distribution in enumerate(distributions)]
        return np.stack(columns, axis=1)
