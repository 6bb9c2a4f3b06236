"""Figure of the surroundings of a dent that is rolled over."""

from __future__ import annotations

import numpy as np

from nonhertz.amounts import mpa
from nonhertz.figures.value import Across, Array, Axis, Cells, Figure, Line, Mark, Panel
from nonhertz.life import Overrolled, VolumeModel
from nonhertz.life.overrolling import outer

AROUND, REACHES = 181, 60
"""Points of a circle, and distances up to which the added damage is summed."""
HIGH = 230


def around_dent(overrolled: Overrolled, model: VolumeModel) -> Figure:
    """Return the largest stress around a dent by a model, and the share of the added damage within a distance of it.

    Parameters
    ----------
    overrolled : Overrolled
        The dent, rolled over.
    model : VolumeModel
        The model whose stress and damage are shown.
    """
    y, x, dent = overrolled.y, overrolled.x, overrolled.dent
    largest = getattr(overrolled, model.stress).max(axis=-1)
    rim, turn = 0.5 * outer(dent), np.linspace(0.0, 2.0 * np.pi, AROUND)
    radii = {rim: "rim", 0.5 * dent.diameter: "bowl"}
    edges = _edges(y), _edges(x)
    marks: list[Mark] = [Cells(*edges, largest.T)]
    marks += [Line(dent.y + radius * np.cos(turn), radius * np.sin(turn), colour="paper") for radius in sorted(radii)]
    words = f"Largest {model.stress.replace('_', ' ')}"
    colours = Axis(words, "stress", "MPa", range=(float(largest.min()), float(largest.max())))
    reach = np.linspace(0.0, x[-1], REACHES)[1:]
    excess = np.array([overrolled.excess(model, distance) for distance in reach])
    share = excess / (excess[-1] or 1.0)
    along = Axis("Axial position y", "y", "mm", range=_ends(edges[0]))
    panels = [
        Panel("stress", "", Axis("By the middle of the dent x", "x", "mm", range=_ends(edges[1])), marks,
              f"{words} around the dent: up to {mpa(float(largest.max())):.4g}.", height=HIGH, colours=colours,
              proportional=True, along=along),
        Panel("damage", "", Axis("Share of the added damage", "share"),
              [Across(rim, "rim", above=True, colour="faint"), Line(reach, share)],
              f"{100.0 * np.interp(rim, reach, share):.0f} % of the added damage is within the rim.", height=HIGH,
              beside=True, along=Axis("Up to this distance from the middle", "distance", "mm", range=(0.0, reach[-1]))),
    ]  # fmt: skip
    caption = "The largest stress around the dent while it is rolled over, and where it adds damage."
    return Figure(along, panels, caption=caption)


def _edges(places: Array) -> Array:
    """Return the edges of cells around places."""
    middles = 0.5 * (places[1:] + places[:-1])
    return np.concatenate([[2.0 * places[0] - middles[0]], middles, [2.0 * places[-1] - middles[-1]]])


def _ends(edges: Array) -> tuple[float, float]:
    return float(edges[0]), float(edges[-1])
