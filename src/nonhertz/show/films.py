"""The oil films of a bearing, in rows."""

from __future__ import annotations

from nonhertz.amounts import format_digits, format_input, mm, um
from nonhertz.bearing.film import Films
from nonhertz.bearing.section import RINGS
from nonhertz.files.bearingfile import BearingCase
from nonhertz.show.sections import Row, Section, summary

NO_ROUGHNESS = "give roughness, Rq, of rollers and both rings"


def sections(films: Films) -> list[Section]:
    """Return the sections on the films of a bearing."""
    return [Section("Film", [summary(film_rows(BearingCase(films.solution.bearing), films))])]


def film_rows(case: BearingCase, films: Films | None) -> list[Row]:
    """Return name, value and remark of the minimum film, its film parameter, and the oil; without films, the reason."""
    if films is None or films.least is None:
        return [("minimum film", "not judged", _why_no_films(case, films))]
    at = films.least
    place = f"{_place_of(films, at)}, y = {mm(films.least_film_y[at]):4}"
    how = "Hamrock and Dowson, elliptical contact" if films.elliptic[at] else "Pan and Hamrock"
    rows = [
        ("minimum film", f"{um(films.least_film[at]):4}", place),
        ("", f"{um(films.central_film[at]):4}", f"central film there; both by {how}"),
        ("", f"{um(films.line_film[at]):4}", "minimum film there by Dowson and Higginson"),
        ("entrainment", _metres(films.entrainment[at]), "mean speed of both surfaces there"),
    ]
    parameter, smallest = films.film_parameter, films.least_parameter
    if parameter is None or smallest is None:
        rows.append(("film parameter", "not judged", NO_ROUGHNESS))
    else:
        words = "lambda: minimum film over combined Rq"
        elsewhere = "" if smallest == at else f", {_place_of(films, smallest)}"
        rows.append(("film parameter", format_digits(parameter[smallest], 3), words + elsewhere))
    for name, speed in zip(RINGS, films.rib_sliding.tolist(), strict=True):
        if speed > 0.0:
            rows.append(("sliding on ribs", _metres(speed), f"of the rollers' ends, {name} ring"))
    return [*rows, *_oil_rows(films)]


def _place_of(films: Films, contact: tuple[int, int]) -> str:
    roller, ring = contact
    return f"{RINGS[ring]} ring, {films.solution.place_of(roller)}"


def _why_no_films(case: BearingCase, films: Films | None) -> str:
    missing = [] if case.prescribed.speed else ["load.speed"]
    missing += [] if films or case.lubrication.dynamic_viscosity else ["an oil in [lubrication]"]
    return f"give {' and '.join(missing)}" if missing else "no load"


def _metres(speed: float) -> str:
    return f"{format_digits(1e-3 * speed, 3)} m/s"


def _oil_rows(films: Films) -> list[Row]:
    """Return the row on the oil."""
    oil = films.lubrication
    base = "base oil of the grease" if oil.grease else "oil"
    named = f"{oil.oil or base} at {format_input(oil.temperature)} °C" if oil.temperature is not None else base
    viscosity, dynamic = oil.in_place.viscosity or 0.0, oil.dynamic_viscosity or 0.0
    return [("oil", f"{format_digits(viscosity, 4)} mm²/s", f"{named}, {format_digits(1e9 * dynamic, 4)} mPa s")]
