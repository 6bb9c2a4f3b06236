"""A loaded bearing as text and as files: one JSON object, a table of rollers, and one of lines of contact."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from operator import itemgetter
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from nonhertz.bearing.bearings import TaperedRollerBearing
from nonhertz.bearing.film import FILM_QUANTITIES, Films
from nonhertz.bearing.quantities import QUANTITIES
from nonhertz.bearing.section import FORCES, MOTIONS, RINGS
from nonhertz.bearing.solution import CONTACT_QUANTITIES, PRESSURES, BearingSolution
from nonhertz.bearing.standard import slice_loads
from nonhertz.bearing.toleranced import AT_LIMITS
from nonhertz.files import results
from nonhertz.files.results import Key, ListOf, plain, quantity_keys, within
from nonhertz.result.quantities import ALONG, Quantity
from nonhertz.result.tables import csv_text, heading
from nonhertz.verdict import collect_findings

if TYPE_CHECKING:
    from nonhertz.bearing.assessed import BearingLife
    from nonhertz.files.bearingfile import BearingCase


_FIT: Final = (
    Key("mounted_pressure", "pressure between ring and seat, at 20 °C and at rest", "MPa"),
    Key("pressure", "the same in operation; 0 if the fit is loose", "MPa"),
    Key("seat_stress", "hoop stress of the ring in operation, at its seat", "MPa"),
    Key("raceway_stress", "the same at its raceway", "MPa"),
    Key("loosening_speed", "speed at which the pressure falls to zero; null if none does", "1/min"),
    Key("temperature_step", "temperature of the inner part less that of the outer part", "K"),
)
#: Reductions of the clearance.
LOSSES: Final = (
    Key("lost_to_inner_fit", "reduction by the fit of the inner ring", "mm"),
    Key("lost_to_outer_fit", "reduction by the fit of the outer ring", "mm"),
    Key("lost_to_temperatures", "reduction by temperatures", "mm"),
    Key("lost_to_speed", "reduction by the speed of the inner ring", "mm"),
)
_CLEARANCE: Final = (
    *within(
        "operating_clearance",
        Key("unmounted", "radial clearance before the bearing is mounted", "mm"),
        *LOSSES,
        Key("clearance", "radial clearance in operation; negative: preload", "mm"),
    ),
    Key(
        "axial", "axial clearance of one tapered row in operation", "mm",
        lambda case: case.operating_clearance.axial(case.bearing.rows[0].bearing.nominal_angle),
        applies=lambda case: isinstance(case.bearing.rows[0].bearing, TaperedRollerBearing),
    ),
    Key("expansion", "increase by temperatures between two rows", "mm", lambda case: case.fit.expansion(case.bearing)),
    *(Key(ring, f"fit of the {ring} ring", get=f"operating_clearance.{ring}", holds=_FIT) for ring in RINGS),
)  # fmt: skip
_KINEMATICS: Final = (
    Key("inner_speed", "speed of the inner ring", "1/min"),
    Key("outer_speed", "speed of the outer ring", "1/min"),
    Key("cage_speed", "speed of the cage", "1/min"),
    Key("roller_speed", "speed of a roller about its axis, relative to the cage", "1/min"),
    Key("inner_frequency", "frequency at which rollers pass a point of the inner ring, BPFI", "Hz"),
    Key("outer_frequency", "frequency at which rollers pass a point of the outer ring, BPFO", "Hz"),
    Key("roller_frequency", "frequency at which a point of a roller meets a ring, 2 BSF", "Hz"),
)
_FILM_ALONG: Final = ("least_film", "central_film", "entrainment")
_FRICTION: Final = (
    Key("speed_torque", "friction torque by speed and oil, M0", "N mm"),
    Key("load_torque", "friction torque by load, M1", "N mm"),
    Key("torque", "both together", "N mm"),
    Key("power", "power loss", "W"),
)
_FILM: Final = (
    Key("viscosity", "viscosity of the oil in the bearing", "mm^2/s", "lubrication.in_place.viscosity"),
    Key("dynamic_viscosity", "the same times the density", "MPa s", "lubrication.dynamic_viscosity"),
    Key("pressure_viscosity", "coefficient alpha", "1/MPa", "lubrication.pressure_coefficient"),
    *quantity_keys(FILM_QUANTITIES.values(), ListOf(ListOf(count=len(RINGS)))),
    Key(
        "film_parameter",
        "lambda of every contact; null without roughness",
        "",
        holds=ListOf(ListOf(count=2)),
        nullable=True,
    ),
    Key(
        "rib_sliding",
        "sliding speed of the rollers' ends on the ribs of both rings",
        "mm/s",
        holds=ListOf(count=2),
    ),
)


def _range(name: str, meaning: str, unit: str, *further: Key, get: Any = "") -> Key:
    holds = tuple(Key(word, words) for word, words in _AT.items())
    return Key(name, meaning, unit, get, (*holds, *further), nullable=True)


_AT: Final = {"least": "the least", "likely": "at the mean of all limits", "greatest": "the greatest"}
_PROBABLE: Final = Key("probable", "three standard deviations below and above the likely one", holds=ListOf(count=2))
_TOLERANCES: Final = (
    *within(
        "clearance",
        _range("shaft", "interference on the shaft; null without a seat", "mm", _PROBABLE),
        _range("housing", "interference in the housing; null without a seat", "mm", _PROBABLE),
        _range("unmounted", "radial clearance unmounted", "mm", _PROBABLE),
        _range("mounted", "radial clearance mounted, at 20 °C and at rest", "mm", _PROBABLE),
        _range("operating", "radial clearance in operation", "mm", _PROBABLE),
    ),
    *within(
        "results",
        *(
            _range(
                name, f"{QUANTITIES[name].label} at the least, the likely and the greatest clearance",
                QUANTITIES[name].unit, get=itemgetter(name),
            )
            for name in AT_LIMITS
        ),
    ),
)  # fmt: skip
_RATING: Final = (
    Key("dynamic", "basic dynamic load rating C", "N"),
    Key("static", "basic static load rating C0", "N"),
    Key("inner", "dynamic capacity of a contact with the inner ring", "N"),
    Key("outer", "dynamic capacity of a contact with the outer ring", "N"),
    Key("fatigue_limit", "fatigue load limit Cu", "N"),
    Key("rows", "number of equal rows", holds="integer"),
    Key("material_factor", "bm, from which C follows unless it is given"),
    Key("reduction", "lambda nu, reduction of C for uneven line loads"),
)
_REVOLUTIONS: Final = "10^6 revolutions"
_IN_HOURS: Final = {"basic": "L10", "reference": "L10r", "modified": "L_nmr", "rated": "rated life"}


def _hours(name: str) -> Callable[[BearingLife], float]:
    return lambda life: life.hours_per_million * getattr(life, name)


_OF_LOAD: Final = (
    Key("rating", "load ratings by ISO 281 and ISO 76", holds=_RATING),
    Key("equivalent_load", "P; of a spectrum, the constant load with the same L10", "N"),
    Key("static_load", "P0; of a spectrum, the largest", "N"),
    Key("basic_life", "L10 of ISO 281", _REVOLUTIONS),
    Key("reference_life", "L10r of ISO/TS 16281", _REVOLUTIONS),
    Key("basis", "the standard that L10r follows, and any departure from it", holds="string"),
    Key("viscosity_ratio", "kappa; null without a viscosity"),
    Key("contamination", "e_C; null without a cleanliness"),
    Key("life_factor", "a_ISO; null without viscosity and cleanliness"),
    Key("reliability_factor", "a_1"),
    Key("modified_life", "L_nmr; null if no_modified gives a reason", _REVOLUTIONS),
    Key("rated_life", "rated life: L_nmr, or a_1 L10r if there is none", _REVOLUTIONS),
    Key("speed", "speed that converts revolutions to hours; null if unknown", "1/min"),
    *(
        Key(f"{name}_hours", f"{meaning}; null without a speed", "h", _hours(f"{name}_life"))
        for name, meaning in _IN_HOURS.items()
    ),
    Key("static_safety", "S0 = C0 / P0; null without load"),
    Key("no_reference", "why there is no L10r; empty if there is one", holds="string"),
    Key("no_modified", "why there is no modified life; empty if there is one", holds="string"),
)
_PART: Final = (
    Key("share", "share of the revolutions", get=itemgetter(1)),
    *within(itemgetter(0), *_OF_LOAD),
    Key("parts", "empty", "", lambda _: (), ListOf("object")),
)
_LIFE: Final = (
    *_OF_LOAD,
    Key("parts", "the same for each load of a spectrum, with its share of the revolutions", "", holds=ListOf(_PART)),
)
_OF_SLICES: Final = [quantity for name, quantity in CONTACT_QUANTITIES.items() if name not in PRESSURES]
_FORCES, _MOTIONS = [*FORCES.values()], [*MOTIONS.values()]
_ROLLERS, _CONTACTS, _RING = ListOf(), ListOf(ListOf(count=len(RINGS))), ListOf(count=len(MOTIONS))


def _row_numbers(solution: BearingSolution) -> list[int]:
    return [k for k, row in enumerate(solution.bearing.rows, start=1) for _ in range(row.bearing.rollers)]


def _pressures(quantity: Quantity) -> Key:
    def get(solution: BearingSolution) -> Any:
        return quantity.get(solution) if solution.method == "strips" else None

    return Key(quantity.name, f"{quantity.label}; null by slices", quantity.unit, get, _CONTACTS, nullable=True)


def keys() -> tuple[Key, ...]:
    """Return the keys of the file of a loaded bearing."""
    return (
        results.FORMAT_KEY,
        Key("title", "title of the bearing", get="case.title", holds="string"),
        Key("method", "method by which contacts were solved", get="solution.method", holds=["strips", "slices"]),
        results.models_key(
            lambda rated: rated.solution.bearing.rows[0].bearing,
            {"roller": "the rollers", **{ring: f"the {ring} ring" for ring in RINGS}},
        ),
        Key(
            "operating_clearance", "clearance of a row and its reductions; null without fits", holds=_CLEARANCE,
            get=lambda rated: None if rated.case.fit is None else rated.case, nullable=True,
        ),
        *within(
            "solution",
            Key("row", "row of every roller, from 1", get=_row_numbers, holds=ListOf("integer")),
            Key(
                "x", "axial position of every roller", "mm",
                lambda solution: [row.x for row in solution.bearing.rows for _ in range(row.bearing.rollers)], _ROLLERS,
            ),
            Key("angle", "angle of every roller", "rad", holds=_ROLLERS),
            *quantity_keys(_OF_SLICES, _CONTACTS),
            Key("each_rib_load", "load on every roller's ends from each rib", "N", holds=ListOf(_ROLLERS)),
            *(_pressures(CONTACT_QUANTITIES[name]) for name in PRESSURES),
            Key(
                "roller_load", "load by speed on every roller, along x and r, and moment", ["N", "N", "N mm"],
                holds=ListOf(ListOf(count=3)),
            ),
            Key("displacement", "of the inner ring along x, y and z, and about y and z", _MOTIONS, holds=_RING),
            Key("force", "forces and moments on the inner ring, likewise", _FORCES, holds=_RING),
            Key(
                "stiffness", "d(force) / d(displacement)",
                [[f"{force}/{motion}" for motion in _MOTIONS] for force in _FORCES], holds=ListOf(_RING, len(FORCES)),
            ),
            Key("edge_rollers", "unloaded rollers at the edge of the load zone, from 0", holds=ListOf("integer")),
            Key(
                "edge_stiffness", "stiffness along x, y and z if these are loaded; null if there are none", "N/mm",
                holds=ListOf(count=3),
            ),
            Key("residual", "imbalance relative to the loads"),
        ),
        *quantity_keys(quantity for quantity in QUANTITIES.values() if not quantity.within),
        Key("film", "oil films; null without a speed or an oil", get="films", holds=_FILM, nullable=True),
        Key("kinematics", "speeds, frequencies; null at rest", get="case.kinematics", holds=_KINEMATICS, nullable=True),
        Key(
            "friction", "torque and power; null if speed, oil, series or sizes are unknown", "",
            lambda rated: rated.case.friction(rated.solution), _FRICTION, nullable=True,
        ),
        Key("thermal_speed", "thermal speed rating of ISO 15312; null if series or sizes are unknown", "1/min",
            get="case.thermal_speed"),
        Key("iterations", "Newton steps of the ring", get="solution.iterations", holds="integer"),
        Key(
            "tolerances", "limits of clearance and results by the classes; null without classes",
            get=lambda rated: rated.case.tolerances(rated.solution, rated.life), holds=_TOLERANCES, nullable=True,
        ),
        Key("life", "ratings and lives; null if life_reason gives a reason", holds=_LIFE, nullable=True),
        Key("life_reason", "why there is no life; empty if there is one", get="reason", holds="string"),
        results.assumed_key("case.assumed"),
        results.verdict_key(lambda rated: rated.case.verdict(rated.solution, rated.life)),
        *results.warning_keys(lambda it: collect_findings(it.solution, it.life, it.case.operating_clearance)),
        results.UNITS,
        Key("case", "the bearing as in a file, with all defaults", get="case.own_document", holds="object"),
    )  # fmt: skip


def as_object(solution: BearingSolution, case: BearingCase, life: BearingLife | None, reason: str) -> dict[str, Any]:
    """Return a loaded bearing as plain numbers, text, lists and dictionaries, with the case it belongs to.

    `nonhertz.files.resultfile.read_result` reads it back. Numbers are unrounded.
    """
    films = case.films(solution)
    return results.document(keys(), case=case, solution=solution, life=life, reason=reason, films=films)


def rollers_table(solution: BearingSolution, films: Films | None = None) -> str:
    """Return the rollers as CSV with a header of names and units; cells without a number are empty."""
    quantities = [*CONTACT_QUANTITIES.values()] if solution.method == "strips" else _OF_SLICES
    values = [(quantity, quantity.get(solution)) for quantity in quantities]
    if films is not None:
        values += [(quantity, quantity.get(films)) for quantity in FILM_QUANTITIES.values()]
    heads = [heading(f"{quantity.name}_{ring}", quantity.unit) for quantity, _ in values for ring in RINGS]
    columns = [column for _, rows in values for column in rows.T]
    cells = zip(_numbers(solution), _row_numbers(solution), solution.angle, *columns, strict=True)
    return csv_text(["roller", "row", "angle [rad]", *heads], map(plain, cells))


def lines_table(solution: BearingSolution, laminae: int, films: Films | None = None) -> str:
    """Return the quantities along all loaded contacts as CSV with a header of names and units.

    Parameters
    ----------
    solution : BearingSolution
        The loaded bearing.
    laminae : int
        Number of slices, if it was solved by slices.
    films : Films, optional
        Its oil films.
    """
    by_strips = solution.method == "strips"
    names = ALONG.keys() - {"gap"} if by_strips else ("y", "strip_width", "line_load")
    quantities = [quantity for name, quantity in ALONG.items() if name in names]
    heads = [heading(quantity.name, quantity.unit) for quantity in quantities]
    rows = _strips(solution, quantities) if by_strips else _slices(solution, laminae)
    if films is not None:
        heads += [heading(name, FILM_QUANTITIES[name].unit) for name in _FILM_ALONG]
        rows = _with_films(rows, films)
    return csv_text(["roller", "ring", *heads], rows)


def _numbers(solution: BearingSolution) -> Iterable[int]:
    """Return the numbers of rollers in tables, from 1."""
    return range(1, solution.angle.size + 1)


def _strips(solution: BearingSolution, quantities: Iterable[Quantity]) -> Iterator[Iterable[Any]]:
    for j, number in enumerate(_numbers(solution)):
        for ring in RINGS:
            contact = solution.contact(j, ring)
            if contact is not None:
                for numbers in zip(*(quantity.get(contact).tolist() for quantity in quantities), strict=True):
                    yield number, ring, *numbers


def _with_films(rows: Iterable[Iterable[Any]], films: Films) -> Iterator[Iterable[Any]]:
    """Yield rows of roller, ring, position and more with the film there; blank without load."""
    blank = ("",) * len(_FILM_ALONG)
    along = {
        (roller + 1, film.ring): dict(zip(film.y.tolist(), zip(*numbers, strict=True), strict=True))
        for film in films.contacts
        for numbers in [[getattr(film, name).tolist() for name in _FILM_ALONG]]
        for roller in film.rollers
    }
    for number, ring, y, *more in rows:
        yield number, ring, y, *more, *along.get((number, ring), {}).get(y, blank)


def _slices(solution: BearingSolution, laminae: int) -> Iterator[Iterable[Any]]:
    for row, (slices, loads) in zip(solution.bearing.rows, slice_loads(solution, laminae), strict=True):
        width = float(slices.y[1] - slices.y[0])
        for j, of_roller in enumerate(loads.tolist(), start=row.first):
            for k, ring in enumerate(RINGS):
                if solution.load[j, k] > 0.0:
                    for y, load in zip(slices.y.tolist(), of_roller[k], strict=True):
                        yield j + 1, ring, y, width, load / width


def files(solution: BearingSolution, case: BearingCase, life: BearingLife | None, reason: str) -> dict[str, str]:
    """Return the texts of result.json, rollers.csv and lines.csv, by file name."""
    return {
        "result.json": results.key_by_key(as_object(solution, case, life, reason)) + "\n",
        "rollers.csv": rollers_table(solution, case.films(solution)),
        "lines.csv": lines_table(solution, case.solver.laminae, case.films(solution)),
    }


def comparison_keys() -> tuple[Key, ...]:
    """Return the keys of the file of a bearing that was solved by strips and by slices."""
    angle, *compared = (key for key in keys() if key.name in {"angle", "load", "moment", "displacement", "force"})

    def difference(key: Key) -> Key:
        return replace(key, get=lambda both: np.subtract(*(key.value(parts(both[by])) for by in ("slices", "strips"))))

    def parts(solution: BearingSolution) -> SimpleNamespace:
        return SimpleNamespace(solution=solution)

    return (
        Key("title", "title of the bearing", holds="string"),
        replace(angle, get="strips.angle"),
        Key("strips", "by strips", get=lambda file: parts(file.strips), holds=(*compared,)),
        Key("slices", "by slices", get=lambda file: parts(file.slices), holds=(*compared,)),
        Key("differences", "of slices from strips", get=vars, holds=(*map(difference, compared),)),
        results.UNITS,
    )


def comparison_object(strips: BearingSolution, slices: BearingSolution, title: str) -> dict[str, Any]:
    """Return loads and displacements by both methods, and the differences of slices from strips, as plain numbers."""
    return results.document(comparison_keys(), strips=strips, slices=slices, title=title)


def comparison_table(strips: BearingSolution, slices: BearingSolution) -> str:
    """Return both methods' loads as CSV with a header of names and units."""
    head = [
        "roller",
        "angle [rad]",
        *(f"load_{ring}_{by} [N]" for ring in RINGS for by in ("strips", "slices")),
    ]
    columns = [solution.load[:, k] for k in range(len(RINGS)) for solution in (strips, slices)]
    cells = zip(_numbers(strips), strips.angle, *columns, strict=True)
    return csv_text(head, map(plain, cells))


def comparison_files(strips: BearingSolution, slices: BearingSolution, title: str) -> dict[str, str]:
    """Return the texts of comparison.json and comparison.csv, by file name."""
    return {
        "comparison.json": results.key_by_key(comparison_object(strips, slices, title)) + "\n",
        "comparison.csv": comparison_table(strips, slices),
    }
