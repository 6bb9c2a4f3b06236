"""Pressures at which Hertzian contacts begin to yield."""

from __future__ import annotations

import functools
from typing import Final

import numpy as np
from numpy.typing import NDArray

from nonhertz.model.material import check_poisson

#: Depths below the middle of a Hertzian contact, over its radius or half-width, at which stress is evaluated.
DEPTHS: Final = np.linspace(0.0, 20.0, 20001)


def onset_of_yield(poisson: float) -> tuple[float, float]:
    """Return the maximum pressure over the yield strength at which circular and line contacts begin to yield [-].

    The von Mises criterion is evaluated on the axis below the maximum pressure, where yielding begins: 1.61 and 1.79
    for a Poisson's ratio of 0.3.

    Parameters
    ----------
    poisson : float
        Poisson's ratio of the body [-], in (-1, 0.5].

    Raises
    ------
    InputError
        If Poisson's ratio is out of range.

    References
    ----------
    K. L. Johnson, Contact Mechanics, Cambridge University Press 1985, Eqs. (3.45) and (4.45).

    Examples
    --------
    >>> circle, line = onset_of_yield(0.3)
    >>> round(circle, 2), round(line, 2)
    (1.61, 1.79)
    """
    check_poisson("poisson", poisson)
    return _onset_of_yield(float(poisson))


@functools.cache
def _onset_of_yield(poisson: float) -> tuple[float, float]:
    return tuple(1.0 / float(stress.max()) for stress in von_mises_on_axis(poisson))  # type: ignore[return-value]


def von_mises_on_axis(poisson: float) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the von Mises stress over the maximum pressure below a circle and a line, at `DEPTHS`."""
    z, root = DEPTHS, np.hypot(1.0, DEPTHS)
    circle = np.abs(1.5 / root**2 - (1.0 + poisson) * (1.0 - z * np.arctan2(1.0, z)))
    across, normal = 2.0 * z - (root + z**2 / root), -1.0 / root
    along = poisson * (across + normal)
    line = np.sqrt(((across - normal) ** 2 + (normal - along) ** 2 + (along - across) ** 2) / 2.0)
    return circle, line
