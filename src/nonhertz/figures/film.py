"""Figures of the oil films in a bearing: over the load zone, and along the roller with the minimum film."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import um
from nonhertz.bearing.film import ContactFilm, Films
from nonhertz.bearing.section import RINGS
from nonhertz.figures.angles import around, loaded_middle, turn_axis
from nonhertz.figures.roller import STYLES
from nonhertz.figures.value import Axis, Colour, Figure, Level, Line, Mark, Panel, Points

ROOM = 1.15
#: Of the largest line load along a contact: where it is less, as at its ends, films are not drawn.
_LOADED = 0.02


def film_figures(films: Films) -> dict[str, Figure]:
    """Return the minimum film of all rollers at both rings over angle, and the film along one; none without load.

    Parameters
    ----------
    films : Films
        The films in a loaded bearing.

    Returns
    -------
    dict of str to Figure
        ``"film"``, with a panel for each row, and ``"film-along"``, of the roller with the minimum film.
    """
    if films.least is None:
        return {}
    solution = films.solution
    middle = loaded_middle(solution)
    carrying = solution.load[:, :1] > 0.0
    least = np.where(carrying, films.least_film, np.nan)
    rows = range(len(solution.bearing.rows))
    over = Figure(
        turn_axis(middle),
        [_over_angle(films, least, row, middle) for row in rows],
        f"minimum film {um(films.least_film[films.least]):.3g}",
        "Minimum oil film of the rollers at both rings, over the angle from the first roller.",
    )
    return {"film": over, "film-along": _along(films, films.least[0])}


def _over_angle(films: Films, least: NDArray[np.float64], row: int, middle: float) -> Panel:
    these = films.solution.rollers_of(row)
    angle = around(np.degrees(films.solution.angle[these]), middle)
    order = np.argsort(angle)
    marks: list[Mark] = []
    for k, ring in enumerate(RINGS):
        film = least[these, k][order]
        marks += [
            Line(angle[order], film, name=f"{ring} ring", **STYLES[ring]),
            Points(angle[order][np.isfinite(film)], film[np.isfinite(film)], colour=STYLES[ring]["colour"]),
        ]
    heading = "Minimum film" + (f", row {row + 1}" if len(films.solution.bearing.rows) > 1 else "")
    top, roughness = float(np.nanmax(least)), _roughness_at(films, these.start)
    return Panel(
        f"film-{row + 1}",
        heading,
        Axis("Minimum film", "h", "mm", "um", range=(0.0, ROOM * max((top, *roughness)))),
        [*marks, *_rough(roughness)],
        f"{heading} of every roller over its angle, from {um(float(np.nanmin(least))):.3g} to {um(top):.3g}.",
        _words_of_roughness(roughness),
        160,
    )


def _along(films: Films, roller: int) -> Figure:
    among = {contact.ring: contact for contact in films.contacts if roller in contact.rollers}
    half = 0.5 * next(iter(among.values())).row.bearing.roller_length
    marks: list[Mark] = []
    for ring, film in among.items():
        marks += _lines(film, ring)
    top = max(float(np.nanmax(mark.y)) for mark in marks if isinstance(mark, Line))
    place, roughness = films.solution.place_of(roller), _roughness_at(films, roller)
    what = f"{place[0].upper()}{place[1:]}, with the minimum film"
    panel = Panel(
        "film-along",
        "Film along the roller",
        Axis("Film", "h", "mm", "um", range=(0.0, ROOM * max((top, *roughness)))),
        [*marks, *_rough(roughness)],
        f"Minimum and central film along {place}.",
        _words_of_roughness(roughness),
        200,
    )
    along = Axis("Axial position y", "y", "mm", range=(-half, half))
    return Figure(along, [panel], what, f"{what}: minimum and central oil film along it, at both rings.")


def _lines(film: ContactFilm, ring: str) -> Iterator[Line]:
    # Towards the ends, where the load runs out, the formulas for line contacts overestimate the film.
    inside = film.line_load >= _LOADED * film.line_load.max()
    colour = STYLES[ring]["colour"]
    yield Line(film.y, np.where(inside, film.least_film, np.nan), name=f"{ring} ring, minimum", colour=colour)
    central = np.where(inside, film.central_film, np.nan)
    yield Line(film.y, central, name=f"{ring} ring, central", colour=colour, dash="dashed")


def _roughness_at(films: Films, roller: int) -> tuple[float, ...]:
    """Return Rq of a roller with the inner and with the outer ring [mm]; empty where it is not known."""
    return () if films.roughness is None else tuple(films.roughness[roller].tolist())


def _rough(roughness: tuple[float, ...]) -> list[Mark]:
    colours: list[Colour] = ["ink"] if len(set(roughness)) == 1 else [STYLES[ring]["colour"] for ring in RINGS]
    return [Level(level, colour=colour, dash="ends") for level, colour in zip(roughness, colours, strict=False)]


def _words_of_roughness(roughness: tuple[float, ...]) -> str:
    if not roughness:
        return ""
    words = f"{um(roughness[0]):.3g}"
    if len(set(roughness)) > 1:
        words = f"{um(*roughness, between=' and '):.3g} at the inner and the outer ring"
    return f"dash-dotted: Rq of both surfaces, {words}, lambda = 1"
