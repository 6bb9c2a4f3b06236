"""Random deviations of form: relief that wanders along a body, added to its profile.

A deviation is a stationary Gaussian process with the covariance s^2 exp(-(d / l)^2) between places at the distance d;
s is its root mean square and l its correlation length. What a straight line through it explains is left out: the mean
belongs to the diameter and the slope to the tilt.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nonhertz.errors import InputError
from nonhertz.files.paths import Keys
from nonhertz.files.spreads import Distribution
from nonhertz.inputs.units import in_unit

Array = NDArray[np.float64]

PER_LENGTH = 6  # points in a correlation length: a cubic spline through them is within 1e-3 of the process
FEWEST, MOST = 9, 400


def with_form(document: Mapping[str, Any], keys: Keys, form: Distribution, share: float) -> list[dict[str, Any]]:
    """Return the profile of a body with a random deviation added.

    Parameters
    ----------
    document : mapping
        What the file of the body holds.
    keys : tuple
        Where its profile is.
    form : Distribution
        Of the kind ``"form"``.
    share : float
        Which deviation, from 0 to 1: the same number makes the same one.

    Raises
    ------
    InputError
        If the body has no length, or it is more than 66 correlation lengths.
    """
    body: Any = document
    for key in keys[:-1]:
        body = body[key]
    length = in_unit("length", body.get("length"), "mm")
    place = ".".join(map(str, keys[:-1]))
    if not isinstance(length, float) or not 0.0 < length < math.inf:
        raise InputError(f"{place}.length", body.get("length"), "be given for a random form", "give it in mm")
    rms, correlation = form.numbers
    count = max(FEWEST, math.ceil(PER_LENGTH * length / correlation) + 1)
    if count > MOST:
        least = PER_LENGTH * length / (MOST - 1)
        raise InputError(
            "correlation length", correlation, f"be at least {least:.3g} mm", "describe waviness, not roughness"
        )
    y = np.linspace(-0.5 * length, 0.5 * length, count)
    relief = rms * deviation(count, length / correlation, share)
    profile = body.get("profile", [])
    table = {"kind": "tabulated", "y": y.tolist(), "relief": relief.tolist(), "interpolation": "cubic"}
    return [*(profile if isinstance(profile, list) else [profile]), table]


def deviation(count: int, lengths: float, share: float) -> Array:
    """Return a deviation of unit variance at evenly spaced places.

    Parameters
    ----------
    count : int
        How many places.
    lengths : float
        The distance between the outermost, in correlation lengths.
    share : float
        Which deviation, from 0 to 1.
    """
    factor = _factor(count, lengths)
    generator = np.random.default_rng(int(share * 2.0**53))
    return np.asarray(factor @ generator.standard_normal(factor.shape[1]))


@functools.lru_cache(maxsize=8)
def _factor(count: int, lengths: float) -> Array:
    """Return a matrix that makes correlated numbers of independent ones, without a straight line in them."""
    at = np.linspace(0.0, lengths, count)
    covariance = np.exp(-((at[:, None] - at) ** 2))
    values, vectors = np.linalg.eigh(covariance)
    factor = vectors * np.sqrt(np.clip(values, 0.0, None))
    line = np.linalg.qr(np.stack([np.ones(count), at - at.mean()], axis=1))[0]
    factor = factor - line @ (line.T @ factor)
    # The root mean square is that of what is left.
    return np.asarray(factor / np.sqrt(np.mean(np.sum(factor**2, axis=1))))
