"""Where along a contact its bodies fatigue, and what a dent does to its surroundings."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from nonhertz.figures.life import Spectrum, life_densities
from nonhertz.life import Life, Overrolled, VolumeModel
from nonhertz.life.overrolling import outer
from nonhertz.model.body import BodyName
from nonhertz.plot.axes import OWN, Axes, Figure, drawing, measure, open_frame
from nonhertz.plot.drawer import draw_on, sheet_of
from nonhertz.plot.sheets import sheet
from nonhertz.plot.style import COLOUR_MAP, FAINT_INK, FIRST, HAIR, LINE, sheet_style

DENT_HIGH = 2.7  # inch


@drawing
def life_density(spectrum: Spectrum, lives: Sequence[Life], ax: Axes = OWN, *, compared: Sequence[Life] = ()) -> Axes:
    """Draw where a body fatigues: damage per length against y, over its mean under the ideal pressure.

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


def dent_figure(found: Overrolled, model: VolumeModel, title: str = "") -> Figure:
    """Return a figure of what a dent that is rolled over does to its surroundings, by one model.

    On the left the largest value of the model's stress over the passage and the depth; on the right the share of the
    added damage that lies within a distance of the middle, in either direction. Thin lines are the bowl and the rim.

    Parameters
    ----------
    found : Overrolled
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
    rim = 0.5 * outer(found.dent)
    length, stress = measure("mm"), measure("MPa")
    with sheet_style():
        figure = sheet(DENT_HIGH)
        figure.set_layout_engine("constrained")
        area, share = figure.subplots(1, 2, width_ratios=(1.2, 1.0))
        largest = getattr(found, model.stress).max(axis=-1)
        places = length(found.y), length(found.x)
        field = area.pcolormesh(*places, stress(largest), cmap=COLOUR_MAP, shading="nearest", rasterized=True)
        around = np.linspace(0.0, 2.0 * np.pi, 181)
        for radius in {rim, 0.5 * found.dent.diameter}:
            circle = found.dent.y + radius * np.cos(around), radius * np.sin(around)
            area.plot(*(length(each) for each in circle), color="white", linewidth=HAIR)
        area.set(xlabel=length.label("Axial position $y$"), aspect="equal")
        area.set_ylabel(length.label("By the middle of the dent $x$"))
        area.locator_params(nbins=5)
        figure.colorbar(field, ax=area, label=stress.label(f"Largest {model.stress.replace('_', ' ')}"), shrink=0.8)
        reach = np.linspace(0.0, found.x[-1], 60)[1:]
        excess = np.array([found.excess(model, each) for each in reach])
        share.axvline(length.factor * rim, color=FAINT_INK, linewidth=HAIR)
        share.plot(length(reach), excess / (excess[-1] or 1.0), color=FIRST, linewidth=LINE)
        share.set_xlabel(length.label("Up to this distance from the middle"))
        share.set_ylabel("Share of the added damage [-]")
        share.set_xlim(0.0, length.factor * reach[-1])
        open_frame(share)
        if title:
            figure.suptitle(title, x=0.01, ha="left")
    return figure
