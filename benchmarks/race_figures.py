"""Drawings of the race: error against time."""

from __future__ import annotations

from typing import Any

from accuracy_reached import ASKED, Entry
from entrants import AUTOMATIC, TO
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from races import QUANTITIES

from nonhertz.plot.style import FAINT_INK, FIRST, HAIR, LINE, PALE, SECOND, SMALL_SIZE, THIN, sheet_style

# All colours are Okabe and Ito's; markers differ too.
LOOK: dict[str, dict[str, Any]] = {
    "strips: semi-elliptic": {"color": FIRST, "marker": "o", "label": "strips"},
    "batch: semi-elliptic": {"color": "#56B4E9", "marker": "v", "linestyle": "--", "label": "strips, many at once"},
    "strips: parabolic": {"color": FAINT_INK, "marker": "x", "label": "strips, parabolic"},
    "patch": {"color": "#009E73", "marker": "s", "label": "plane grid"},
    "tamaas": {"color": SECOND, "marker": "^", "label": "tamaas"},
    "ContactMechanics": {"color": "#CC79A7", "marker": "D", "label": "ContactMechanics"},
    "ASPHER": {"color": "#E69F00", "marker": "p", "label": "ASPHER"},
}
LEAST = 1e-7  # smaller errors are drawn here
EQUAL = 0.0  # the shape of equal strips; of cells it is their number along over that across
FIRST_SHAPES = (EQUAL, 1.0, 4.0)  # drawn thick and open


def figures(results: dict[str, Any]) -> dict[str, Figure]:
    """Return the drawings by name."""
    with sheet_style():
        return {
            "race": _sheet(results, ("approach", "max_pressure"), 7.4),
            "race-centre": _sheet(results, ("centre_pressure",), 4.4),
        }


def _sheet(results: dict[str, Any], quantities: tuple[str, ...], width: float) -> Figure:
    raced = results["races"]
    figure = Figure(figsize=(width, 2.35 * len(raced) + 0.5), layout="constrained")
    panels = figure.subplots(len(raced), len(quantities), sharex=True, squeeze=False)
    for row, race in zip(panels, raced.values(), strict=True):
        for axes, quantity in zip(row, quantities, strict=True):
            _panel(axes, race, quantity)
        row[0].set_title(race["title"], loc="left")
    for axes in panels[-1]:
        axes.set_xlabel("Time of a solve [s]")
    figure.legend(*panels[0, 0].get_legend_handles_labels(), loc="outside upper center", ncols=3)
    return figure


def _panel(axes: Axes, race: dict[str, Any], quantity: str) -> None:
    axes.set(xscale="log", yscale="log", ylabel=f"Error of {QUANTITIES[quantity]}")
    for prefix, look in LOOK.items():
        entries = [entry for entry in race["entries"] if entry["entrant"].startswith(prefix)]
        _program(axes, [entry for entry in entries if entry["error"][quantity] is not None], quantity, look)
    if quantity in ASKED:
        axes.axhline(ASKED[quantity], color=FAINT_INK, linewidth=HAIR, linestyle=(0, (4, 3)))
        axes.annotate(f"asked: {ASKED[quantity]:g}", (1.0, ASKED[quantity]), (-2, 2), ha="right",
                      xycoords=("axes fraction", "data"), **_note(FAINT_INK))  # fmt: skip
    low, high = axes.get_ylim()
    axes.axhspan(0.1 * LEAST, max(race["uncertainty"][quantity], LEAST), color=PALE, linewidth=0, zorder=0)
    axes.set_ylim(0.5 * low, 2.0 * high)


def _program(axes: Axes, entries: list[Entry], quantity: str, look: dict[str, Any]) -> None:
    """Draw a line for each shape of cells, and for automatic grids of rising accuracy."""
    shapes: dict[float | str, list[Entry]] = {}
    for entry in entries:
        shapes.setdefault(_shape(entry["grid"]), []).append(entry)
    for shape, ladder in shapes.items():
        at = [entry["time"] for entry in ladder], [max(entry["error"][quantity], LEAST) for entry in ladder]
        fine = shape not in FIRST_SHAPES
        style = {"linewidth": THIN if fine else LINE, "markersize": 4, "fillstyle": "full" if fine else "none"} | look
        axes.plot(*at, **style | ({"label": "_"} if fine else {}))
        if shape == AUTOMATIC and look["label"] == "strips":
            axes.annotate("automatic", (at[0][0], at[1][0]), (5, -2), va="top", **_note(look["color"]))


def _note(colour: str) -> dict[str, Any]:
    return {"textcoords": "offset points", "fontsize": SMALL_SIZE, "color": colour}


def _shape(grid: Any) -> float | str:
    if isinstance(grid, str):
        return grid.partition(TO)[0]
    return EQUAL if isinstance(grid, int) else grid[1] / grid[0]
