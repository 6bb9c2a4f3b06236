"""The damage along a contact, and the stress and damage around a dent."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from nonhertz.figures.dent import around_dent
from nonhertz.figures.life import Spectrum, life_densities
from nonhertz.life import Life, Overrolled, VolumeModel
from nonhertz.model.body import BodyName
from nonhertz.plot.axes import OWN, Axes, Figure, drawing
from nonhertz.plot.drawer import draw_on, sheet_of
from nonhertz.plot.style import sheet_style


@drawing
def life_density(spectrum: Spectrum, lives: Sequence[Life], ax: Axes = OWN, *, compared: Sequence[Life] = ()) -> Axes:
    """Draw the fatigue of a body: damage per length against y, over its mean under the ideal pressure.

    1, the thin line, is Hertz's line pressure with the load spread evenly. The laminae of ISO/TS 16281 are steps. If
    the damage by any model exceeds six times the ideal somewhere, the axis is logarithmic, from a hundredth. The legend
    gives the lives.

    Parameters
    ----------
    spectrum : sequence of pairs
        Solutions and their shares of the revolutions.
    lives : sequence of Life
        Lives of one body by several models.
    compared : sequence of Life
        Lives of that body in another case; only the first is drawn, as a grey line.
    """
    body: BodyName = lives[0].body
    return draw_on(life_densities(spectrum, {body: lives}, {body: compared}), ax)


def life_figure(
    spectrum: Spectrum,
    lives: Mapping[BodyName, Sequence[Life]],
    title: str = "",
    compared: Mapping[BodyName, Sequence[Life]] | None = None,
) -> Figure:
    """Return a finished figure of `life_density`, a panel per body, or only for b if their lives are within 5 %.

    Parameters
    ----------
    spectrum : sequence of pairs
        Solutions and their shares of the revolutions.
    lives : mapping of str to sequence of Life
        One life per model for each body, ``"a"`` and ``"b"``.
    title : str
        Heading; none if empty.
    compared : mapping of str to sequence of Life, optional
        Those of another case.

    Returns
    -------
    matplotlib.figure.Figure
        `save` writes it.
    """
    with sheet_style():
        return sheet_of(life_densities(spectrum, lives, compared), title)


def dent_figure(overrolled: Overrolled, model: VolumeModel, title: str = "") -> Figure:
    """Return a figure of stress and damage around a dent that is rolled over, by one model.

    On the left the largest value of the model's stress over the passage and the depth; on the right the share of the
    added damage that lies within a distance of the middle, in either direction. Thin lines are the bowl and the rim.

    Parameters
    ----------
    overrolled : Overrolled
        The dent, rolled over.
    model : VolumeModel
        A model of `nonhertz.life`.
    title : str
        Heading; none if empty.

    Returns
    -------
    matplotlib.figure.Figure
        `save` writes it.
    """
    with sheet_style():
        return sheet_of(around_dent(overrolled, model), title)
