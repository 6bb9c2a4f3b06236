"""Drawings of studies: numbers against one or two parameters, and distributions.

They take plain arrays and labels, so that numbers of any origin can be drawn.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike

from nonhertz.figures import studies
from nonhertz.figures.value import Array, Axis, Figure, Panel
from nonhertz.plot.axes import OWN, Axes, drawing
from nonhertz.plot.drawer import draw_framed


@drawing
def study_lines(
    x: ArrayLike, lines: Mapping[str, ArrayLike], ax: Axes = OWN, *, x_label: str, y_label: str, key: str = ""
) -> Axes:
    """Draw numbers against one parameter, a line for each name; a gap where there is no number.

    If the largest is more than thirty times the smallest, as lives are, the axis is logarithmic.

    Parameters
    ----------
    x : array_like, shape (n,)
        Values of the parameter: numbers, or words.
    lines : mapping of str to array_like, shape (n,)
        Numbers by name of the line; a single line needs no name.
    x_label, y_label : str
        Names of the axes, with units.
    key : str
        Heading of the names.
    """
    places = np.asarray(x)
    along = Axis(x_label)
    if places.dtype.kind not in "iuf":
        along, places = Axis(x_label, categories=tuple(map(str, places.tolist()))), np.arange(places.size)
    numbers = {name: _numbers(values) for name, values in lines.items()}
    return _draw(studies.lines_over(along, _numbers(places), numbers, Axis(y_label), key=key), ax)


@drawing
def study_map(
    x: ArrayLike, y: ArrayLike, values: ArrayLike, ax: Axes = OWN, *, x_label: str, y_label: str, label: str
) -> Axes:
    """Draw numbers over two parameters as a map with contours; white where there is no number.

    Parameters
    ----------
    x, y : array_like, shape (m,), (n,)
        Values of the parameters.
    values : array_like, shape (n, m)
        The numbers.
    ax : matplotlib.axes.Axes, optional
        Where to draw; a colour bar is put beside it; if left out, in a figure of its own, ``ax.figure``.
    x_label, y_label, label : str
        Names of the axes and of the numbers, with units.
    """
    numbers = _numbers(values).T
    return _draw(studies.map_over(Axis(x_label), _numbers(x), Axis(y_label), _numbers(y), numbers, Axis(label)), ax)


@drawing
def histogram(
    values: ArrayLike,
    ax: Axes = OWN,
    *,
    label: str,
    quantiles: Mapping[float, tuple[float, float]] | None = None,
    limits: Sequence[float] = (),
) -> Axes:
    """Draw the distribution of numbers, with confidence intervals of quantiles.

    If the largest is more than ten times the smallest, the axis is logarithmic. Else single numbers far beyond the
    others, by as much as those between 1 % and 99 % differ, are not drawn; their share is written below.

    Parameters
    ----------
    values : array_like
        The numbers; those that are not finite are left out.
    label : str
        Name of the numbers, with their unit.
    quantiles : mapping of float to pair of float, optional
        Intervals by probability, such as ``{0.5: (1990.0, 2010.0)}``.
    limits : sequence of float
        Limits of the numbers.
    """
    return _draw(studies.distribution(Axis(label), _numbers(values), quantiles, limits), ax)


@drawing
def tornado(
    names: Sequence[str],
    first: ArrayLike,
    total: ArrayLike,
    ax: Axes = OWN,
    *,
    intervals: tuple[ArrayLike, ArrayLike] | None = None,
) -> Axes:
    """Draw Sobol's indices as bars, the first name on top: the first index inside the total one.

    Parameters
    ----------
    names : sequence of str
        The parameters.
    first, total : array_like, shape (n,)
        Their indices, from 0 to 1.
    intervals : pair of array_like, shape (2, n), optional
        Lower and upper ends of the confidence intervals of both.
    """
    ends = None if intervals is None else (_numbers(intervals[0]), _numbers(intervals[1]))
    return _draw(studies.variance_shares(names, _numbers(first), _numbers(total), ends), ax)


@drawing
def profile_band(
    y: ArrayLike, nominal: ArrayLike, band: tuple[ArrayLike, ArrayLike], ax: Axes = OWN, *, label: str
) -> Axes:
    """Draw a profile with the band in which most of its samples lie; relief grows downwards, as material is taken away.

    Parameters
    ----------
    y : array_like, shape (n,)
        Positions along the body [mm].
    nominal : array_like, shape (n,)
        Relief of the nominal profile [mm].
    band : pair of array_like, shape (n,)
        Lowest and highest relief of the band [mm].
    label : str
        Name of the band.
    """
    low, high = band
    panel = studies.profile_band(_numbers(y), _numbers(nominal), (_numbers(low), _numbers(high)), label=label)
    return _draw(panel, ax)


def _numbers(values: ArrayLike) -> Array:
    return np.asarray(values, dtype=float)


def _draw(panel: Panel, ax: Axes) -> Axes:
    assert panel.along is not None
    return draw_framed(panel, Figure(panel.along, [panel]), ax)
