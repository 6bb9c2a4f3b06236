"""A loaded bearing in rows: its type, loads and displacements, rollers, life, and two methods side by side."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import (
    amount,
    format_column,
    format_digits,
    format_input,
    mm,
    mpa,
    mrad,
    newton,
    newton_mm,
    um,
)
from nonhertz.bearing.assessed import LEFT_OUT, BearingLife
from nonhertz.bearing.bearings import (
    CylindricalRollerBearing,
    CylindricalThrustBearing,
    RollerBearing,
    SphericalRollerBearing,
    TaperedRollerBearing,
)
from nonhertz.bearing.equilibrium import NO_LOAD, drop_rounding
from nonhertz.bearing.fatigue import BODIES, TOGETHER, VolumeLife
from nonhertz.bearing.film import Films
from nonhertz.bearing.kinematics import Kinematics
from nonhertz.bearing.pairs import Paired
from nonhertz.bearing.quantities import QUANTITIES, SolvedBearing, further
from nonhertz.bearing.ratings import Rating
from nonhertz.bearing.section import RINGS
from nonhertz.bearing.solution import BearingSolution
from nonhertz.files.bearingfile import BearingCase
from nonhertz.result.quantities import Quantity
from nonhertz.show.beside import beside, changes, shared_quantities
from nonhertz.show.clearances import fit_rows, tolerance_section
from nonhertz.show.films import film_rows
from nonhertz.show.friction import friction_rows, limit_rows
from nonhertz.show.lives import of_life
from nonhertz.show.sections import Cell, Notes, Row, Section, Table, assumed_rows, summary
from nonhertz.study.quantities import number_of

OF_LARGEST = "Differences of loads are in per cent of the largest load by strips, others of the value by strips."
#: The parts of a solution whose numbers both strips and slices have.
_COMPARED = ("displacement", "force", "load")
ALL_ROLLERS = "All rollers"
#: The name of the first of the last rows of the summary, on the method.
METHOD = "method"
_REVOLUTIONS = " million revolutions"
_WithClearance = CylindricalRollerBearing | SphericalRollerBearing | TaperedRollerBearing
_PLAY = 1e-3  # mm: smaller differences are rounding of diameters


def sections(case: BearingCase, solution: BearingSolution, life: BearingLife | None, reason: str) -> list[Section]:
    """Return the sections on a loaded bearing; without rows on its life if there is neither a life nor a reason."""
    tolerances = case.tolerances(solution, life)
    films = case.films(solution)
    results, lives = case_sections(case, solution, life, reason)
    return [
        results,
        *([] if tolerances is None else [tolerance_section(case, tolerances)]),
        lives,
        Section("Film", [summary(film_rows(case, films))]),
        Section("Friction", [summary(friction_rows(case, solution))]),
        Section("Manufacturers' limits", [summary(limit_rows(case, solution))]),
        Section("Speeds and frequencies", [summary(kinematic_rows(case.kinematics))]),
        Section(ALL_ROLLERS, [roller_table(solution, films)]),
    ]


def case_sections(
    case: BearingCase, solution: BearingSolution, life: BearingLife | None, reason: str
) -> tuple[Section, Section]:
    """Return the first of these: the loaded bearing, and its ratings and life."""
    lives = life_rows(life, reason) if life is not None or reason else []
    if lives and case.spectrum:
        share = f"{format_input(100.0 * sum(load_case.share for load_case in case.spectrum), 4)} % of revolutions"
        lives.insert(0, ("life under", f"{len(case.spectrum)} loads of a spectrum", share))
    return (
        Section("Results", [summary(summary_rows(case, solution))]),
        Section("Ratings and life", [summary([*lives, *assumed_rows(case.assumed)])]),
    )


def compared_sections(case: BearingCase, strips: BearingSolution, slices: BearingSolution) -> list[Section]:
    """Return the sections that compare a bearing by strips and by slices."""
    alike = [quantity for part in _COMPARED for quantity in QUANTITIES.values() if quantity.within == part]
    numbers = [clean_numbers(alike, SolvedBearing(case, solution)) for solution in (strips, slices)]
    return [
        Section("Strips compared with slices", [beside(shared_quantities(alike, numbers), ("strips", "slices"))]),
        Section("", [compared_table(strips, slices), Notes([OF_LARGEST])]),
    ]


def summary_rows(case: BearingCase, solution: BearingSolution) -> list[Row]:
    """Return name, value and remark of the loads on a bearing, its displacement, and its most loaded roller."""
    return [
        *_bearing_rows(solution.bearing, fitted=case.fit is not None),
        *_preload_rows(case.bearing),
        *fit_rows(case),
        *_load_rows(solution),
        *([("speed", f"{format_input(solution.speed)} 1/min", "")] if solution.speed else []),
        *_most_loaded_rows(solution),
        *_pressure_rows(solution),
        *_rib_rows(solution),
        *_stiffness_rows(solution),
        *(
            (quantity.label, str(quantity.amount(value)), "")
            for quantity, value in further(SolvedBearing(case, solution))
        ),
        *_method_rows(solution),
    ]


def solution_sections(solution: BearingSolution) -> list[Section]:
    """Return the sections on a loaded bearing without its case: not what fits have taken."""
    rows = summary_rows(BearingCase(solution.bearing), solution)
    return [Section("Results", [summary([*rows, *assumed_rows(solution.assumed)])])]


def rating_sections(rating: Rating) -> list[Section]:
    """Return the sections on the load ratings of a bearing."""
    return [Section("Ratings", [summary([_rating_row(rating)])])]


def _rating_row(rating: Rating) -> Row:
    ratings = f"C = {newton(rating.dynamic):4}, C0 = {newton(rating.static):4}"
    return "load ratings", ratings, f"fatigue load limit Cu = {newton(rating.fatigue_limit):4}"


def life_sections(life: BearingLife) -> list[Section]:
    """Return the sections on the life of a bearing."""
    return [Section("Ratings and life", [summary([*life_rows(life, ""), *assumed_rows(life.assumed)])])]


def volume_life_sections(life: VolumeLife) -> list[Section]:
    """Return the sections on lives by a model of the stressed volume: of rings, rollers and all together."""
    values = (life.inner, life.outer, life.rollers, life.rings, life.bearing)
    rows = [(name, of_life(value, _REVOLUTIONS), "") for name, value in zip((*BODIES, *TOGETHER), values, strict=True)]
    relative = ("life against even loads", format_digits(life.relative_life, 3), "rings and rollers")
    return [Section("Life", [summary([("model", life.model.name, ""), *rows, relative])])]


def kinematic_sections(kinematics: Kinematics) -> list[Section]:
    """Return the sections on speeds and frequencies of over-rolling."""
    return [Section("Speeds and frequencies", [summary(kinematic_rows(kinematics))])]


def life_rows(life_result: BearingLife | None, reason: str) -> list[Row]:
    """Return name, value and remark of ratings, safety and lives; without a life, the reason."""
    if life_result is None:
        return [("life", "none", reason)]
    rating = life_result.rating

    def beside(life: float, remark: str = "") -> str:
        """Return a remark, after the life in hours if there is one."""
        hours = ""
        if life_result.speed and math.isfinite(life):
            speed = format_input(float(life_result.speed), 4)
            hours = f"{format_digits(life_result.hours_per_million * life, 4)} hours at {speed} 1/min"
        return ", ".join(filter(None, (hours, remark)))

    factors, of_oil = life_result.factors
    safety = "none" if math.isnan(life_result.static_safety) else "no load"
    if math.isfinite(life_result.static_safety):
        safety = f"S0 = {format_digits(life_result.static_safety, 3)}"
    return [
        _rating_row(rating),
        (
            "equivalent load",
            f"P = {newton(life_result.equivalent_load):4}, P0 = {newton(life_result.static_load):4}",
            LEFT_OUT if life_result.internally_loaded else "",
        ),
        ("static safety", safety, ""),
        (
            "life L10",
            of_life(life_result.basic_life, _REVOLUTIONS),
            beside(life_result.basic_life, "ISO 281:2007"),
        ),
        (
            "L10r",
            of_life(life_result.reference_life, _REVOLUTIONS),
            life_result.no_reference or beside(life_result.reference_life, life_result.basis),
        ),
        (
            "rated life" if life_result.no_modified else "modified life",
            of_life(life_result.rated_life, _REVOLUTIONS),
            beside(life_result.rated_life),
        ),
        ("", factors, "; ".join(filter(None, (", ".join(of_oil), life_result.no_modified)))),
    ]


def kinematic_rows(kinematics: Kinematics | None) -> list[Row]:
    """Return name, value and remark of speeds and of frequencies of over-rolling, with their orders; none at rest."""
    if kinematics is None:
        return []
    rows = [
        ("cage", kinematics.cage_speed / 60.0, f"{format_digits(kinematics.cage_speed, 5)} 1/min", ""),
        (
            "rollers",
            kinematics.roller_speed / 60.0,
            f"{format_digits(kinematics.roller_speed, 5)} 1/min",
            "about their axes, relative to the cage, ",
        ),
        (
            "over-rolling",
            kinematics.inner_frequency,
            f"{format_digits(kinematics.inner_frequency, 5)} Hz",
            "inner ring, BPFI, ",
        ),
        ("", kinematics.outer_frequency, f"{format_digits(kinematics.outer_frequency, 5)} Hz", "outer ring, BPFO, "),
        (
            "",
            kinematics.roller_frequency,
            f"{format_digits(kinematics.roller_frequency, 5)} Hz",
            "rollers, twice per turn, 2 BSF, ",
        ),
    ]
    return [
        (name, value, f"{what}order {format_digits(abs(frequency) / kinematics.shaft_frequency, 4)}")
        for name, frequency, value, what in rows
    ]


def roller_table(solution: BearingSolution, films: Films | None = None) -> Table:
    """Return loads, tilts, pressures and films of every roller, in units that suit the largest; blank for none."""
    ribbed, ribs = solution.each_rib_load.size > 0, solution.rib_load.max(axis=1, initial=0.0)
    pressed = solution.method == "strips"
    pressures = solution.max_pressure if pressed else np.zeros(solution.load.shape)
    (load, of_load), (rib, of_rib), (pressure, of_pressure) = (
        amounts.scale
        for amounts in (newton(*solution.load.flat), newton(*solution.rib_load.flat), mpa(*pressures.flat))
    )
    least = np.zeros(solution.load.shape) if films is None else np.nan_to_num(films.least_film)
    film, of_film = um(*least.flat).scale
    heads = (
        *("roller", "row", "angle [deg]", f"load inner [{of_load}]", f"outer [{of_load}]"),
        *("tilt inner [mrad]", "outer [mrad]", f"max p inner [{of_pressure}]", f"outer [{of_pressure}]"),
        f"rib load [{of_rib}]",
        *((f"film inner [{of_film}]", f"outer [{of_film}]") if films else ()),
    )
    loads_in_words = format_column((load * solution.load).flat)
    rows = []
    for j, roller in enumerate(_rollers(solution)):
        tilts = [format_digits(1e3 * tilt, 4) for tilt in _tilts(solution)[j]] if are_loaded(solution)[j] else ["", ""]
        rows.append(
            (
                *roller, *loads_in_words[2 * j : 2 * j + 2], *tilts,
                *_format_positive(pressure * pressures[j], 4),
                format_digits(rib * ribs[j], 4) if ribbed else "",
                *(_format_positive(film * least[j], 3) if films else ()),
            )
        )  # fmt: skip
    return Table(rows, heads, (), "numbers narrow")


def _format_positive(values: NDArray[np.float64], digits: int) -> list[str]:
    """Return numbers in words; blank where they are not positive."""
    return [format_digits(value, digits) if value > 0.0 else "" for value in values.tolist()]


def clean(quantity: Quantity, solved: SolvedBearing) -> float:
    """Return a number, zero if it is rounding relative to the largest load or displacement; NaN if there is none."""
    value, solution = number_of(quantity, solved), solved.solution
    load, moved = float(solution.load.max()), float(np.max(np.abs(solution.displacement[:3])))
    pitch = solution.bearing.rows[0].bearing.pitch
    largest = {"N": load, "N mm": load * pitch, "mm": moved, "rad": moved / pitch}.get(quantity.unit, 0.0)
    return 0.0 if abs(value) <= NO_LOAD * largest else value


def clean_numbers(quantities: Iterable[Quantity], solved: SolvedBearing) -> dict[str, float]:
    """Return numbers by name, zero where they are rounding; NaN where there is none."""
    return {quantity.name: clean(quantity, solved) for quantity in quantities}


def compared_table(strips: BearingSolution, slices: BearingSolution) -> Table:
    """Return the loads of every roller by strips and by slices, in the unit that suits the largest load."""
    most = float(strips.load.max())
    factor, unit = newton(most, float(slices.load.max())).scale
    heads = (head for ring in RINGS for head in (f"{ring}: strips [{unit}]", f"slices [{unit}]"))
    rows = []
    for j, roller in enumerate(_rollers(strips)):
        cells: list[str | Cell] = [*roller]
        for pair in zip(strips.load[j].tolist(), slices.load[j].tolist(), strict=True):
            # Most rollers of a bearing are not loaded.
            words = changes(pair, most) if pair[0] != pair[1] else ("", "")
            cells += map(Cell, (format_digits(factor * load) for load in pair), words)
        rows.append(cells)
    return Table(rows, ("roller", "row", "angle [deg]", *heads), (), "numbers narrow", remarks="difference")


def are_loaded(solution: BearingSolution) -> NDArray[np.bool_]:
    """Return which rollers are loaded by both rings, shape (rollers,); at speed others load the outer ring only."""
    return np.asarray(solution.load.min(axis=1) > 0.0)


def most_loaded(solution: BearingSolution) -> int:
    """Return the index of the roller with the largest load."""
    return int(np.argmax(solution.load.max(axis=1)))


def _bearing_rows(bearing: RollerBearing | Paired, *, fitted: bool) -> list[Row]:
    rows = [row.bearing for row in bearing.rows]
    alike = all(row == rows[0] for row in rows)
    kinds = " and ".join(dict.fromkeys(row.kind for row in rows))
    table = [("bearing", f"{kinds}{f', {len(rows)} rows' if rows[1:] else ''}", "")]
    for number, row in enumerate(rows[:1] if alike else rows, start=1):
        which = "" if not rows[1:] else "each row" if alike else f"row {number}"
        size = f"{row.rollers}, {mm(row.roller_diameter, row.roller_length, between=' x '):g}"
        table.append(("rollers", size, f"{f'in {which}, ' if which else ''}pitch circle {mm(row.pitch):g}"))
        if isinstance(row, _WithClearance):
            table += _clearance_rows(row, fitted, f", of {which}" if which else "")
        if row.nominal_angle > 0.0 and not isinstance(row, CylindricalThrustBearing):
            table.append(("contact angle", f"{format_input(math.degrees(row.nominal_angle), 5)} degrees", ""))
    if isinstance(bearing, Paired):
        # Rounded to 10 nm: a clearance from a preload or from temperatures has digits that nobody gave.
        between = um(round(bearing.clearance, 5))
        table.append(("clearance of the rows", f"{between:g}", "axial"))
    return table


def _clearance_rows(row: _WithClearance, fitted: bool, which: str) -> list[Row]:
    clearance = row.clearance_range.likely
    group = f", the mean of {row.clearance}" if isinstance(row.clearance, str) else ""
    way = "axial" if isinstance(row, TaperedRollerBearing) else "radial"
    when, words = (", in operation", f"{um(clearance):4}") if fitted else ("", f"{um(clearance):g}")
    rows = [("clearance", words, f"{way}{when}{which}{group}")]
    if row.nominal_angle == 0.0 and min(abs(row.play), abs(row.play - clearance)) > _PLAY:
        rows.append(("", f"{um(row.play):4}", "from the diameters of raceways and rollers, not used"))
    return rows


def _preload_rows(bearing: RollerBearing | Paired) -> list[Row]:
    """Return the preload from which the clearance of the rows follows."""
    if not isinstance(bearing, Paired) or bearing.preload is None:
        return []
    return [("preload", f"{newton(bearing.preload):g}", "axial, of the mounted rows without load")]


def _load_rows(solution: BearingSolution) -> list[Row]:
    pitch = solution.bearing.rows[0].bearing.pitch
    lever = np.array([1.0, 1.0, 1.0, pitch, pitch])
    force = drop_rounding(solution.force, 1.0 / lever, float(solution.load.sum()))
    moved = drop_rounding(solution.displacement, lever, float(np.abs(solution.approach).max()))
    return [
        ("force", str(newton(*force[:3])), "on the inner ring, along x, y, z"),
        ("moment", str(newton_mm(*force[3:])), "about y, z"),
        ("displacement", str(um(*moved[:3])), "along x, y, z"),
        ("tilt", str(mrad(*moved[3:])), "about y, z"),
    ]


def _most_loaded_rows(solution: BearingSolution) -> list[Row]:
    loaded = int(np.count_nonzero(are_loaded(solution)))
    if not loaded:
        return [("loaded rollers", f"none of {solution.angle.size}", "")]
    j = most_loaded(solution)
    tilts = _tilts(solution)[j]
    rows = [
        ("loaded rollers", f"{loaded} of {solution.angle.size}", _zones(solution)),
        ("most loaded roller", str(newton(*solution.load[j], between=" and ")), "at inner and outer ring"),
        ("", solution.place_of(j), ""),
    ]
    if np.any(tilts != 0.0):
        rows.append(("", f"tilted by {mrad(*tilts, between=' and '):4}", "relative to inner and outer ring"))
    return rows


def _zones(solution: BearingSolution) -> str:
    """Return the load zones of every row in words."""
    rows, carries = solution.bearing.rows, are_loaded(solution)
    zones = [_zone(solution.angle[row.rollers], carries[row.rollers]) for row in rows]
    return "; ".join(f"row {number}: {zone}" for number, zone in enumerate(zones, start=1)) if rows[1:] else zones[0]


def _zone(angle: NDArray[np.float64], loaded: NDArray[np.bool_]) -> str:
    if loaded.all():
        return "all round" if loaded.size > 1 else f"{_degrees(angle[0])} degrees"
    starts, ends = (angle[loaded & ~np.roll(loaded, step)] for step in (1, -1))
    if not starts.size:
        return "none"
    if ends[0] < starts[0]:  # a zone that includes the angle zero
        starts = np.roll(starts, 1) - 2.0 * math.pi * (np.arange(starts.size) == 0)
    words = [
        f"{_degrees(low)} to {_degrees(high)}" if low != high else _degrees(low)
        for low, high in zip(starts, ends, strict=True)
    ]
    return f"{' and '.join(words)} degrees"


def _tilts(solution: BearingSolution) -> NDArray[np.float64]:
    """Return the tilts of all contacts [rad], zero where they are rounding relative to the approach."""
    half = 0.5 * max(row.bearing.roller_length for row in solution.bearing.rows)
    floor = 1e-9 * float(np.max(np.abs(solution.approach), initial=0.0))
    return np.where(half * np.abs(solution.tilt) > floor, solution.tilt, 0.0)


def _pressure_rows(solution: BearingSolution) -> list[Row]:
    if solution.method != "strips":
        return [("maximum pressure", "none", "slices have loads only; solve by strips for pressures")]
    pressure, where = solution.max_pressure, solution.max_pressure_y
    if not pressure.max() > 0.0:
        return []
    rows: list[Row] = []
    for k, ring in enumerate(RINGS):
        j = int(np.argmax(pressure[:, k]))
        if not pressure[j, k] > 0.0:
            continue
        name = "" if rows else "maximum pressure"
        place = f"{ring} ring, {solution.place_of(j)}, y = {mm(where[j, k]):4}"
        rows.append((name, str(mpa(pressure[j, k])), place))
    return rows


def _rib_rows(solution: BearingSolution) -> list[Row]:
    if not solution.rib_load.max(initial=0.0) > 0.0:
        return []
    j, k = np.unravel_index(int(np.argmax(solution.rib_load)), solution.rib_load.shape)
    where = f"{RINGS[k]} ring, {solution.place_of(int(j))}"
    ellipse = solution.rib_contact(int(j), RINGS[k])
    pressure = "" if ellipse is None else f", {mpa(ellipse.max_pressure):4}"
    return [("largest rib load", f"{newton(solution.rib_load[j, k])}{pressure}", where)]


def _stiffness_rows(solution: BearingSolution) -> list[Row]:
    diagonal = np.diag(solution.stiffness)
    pitch = solution.bearing.rows[0].bearing.pitch
    stiffness = drop_rounding(diagonal, np.array([1.0, 1.0, 1.0, *[1.0 / pitch**2] * 2]))
    rows = [("stiffness", str(amount(stiffness[:3], "N/mm", "N/um")), "along x, y, z")]
    ready = [str(j + 1) for j in solution.edge_rollers]
    if ready:
        who = f"rollers {', '.join(ready)} stand" if 1 < len(ready) < 5 else f"{len(ready)} rollers stand"
        who = f"roller {ready[0]} stands" if len(ready) == 1 else who
        rows.append(
            (
                "",
                str(amount(solution.edge_stiffness, "N/mm", "N/um")),
                f"within {amount(1e-5, 'mm', 'nm'):g}: {who} at the edge of the load zone, unloaded",
            )
        )
    return [
        *rows,
        ("", str(amount(stiffness[3:], "N mm/rad", "N m/mrad")), "about y, z"),
    ]


def _method_rows(solution: BearingSolution) -> list[Row]:
    if solution.method != "strips":
        return [(METHOD, "slices", "independent, of ISO/TS 16281, two equal contacts in series")]
    bearing = solution.bearing.rows[0].bearing
    return [
        (METHOD, "strips", "semi-elliptic, on automatic grids"),
        ("  roller", bearing.roller.model, ""),
        *((f"  {ring} ring", getattr(bearing, ring).model, "") for ring in RINGS),
    ]


def _rollers(solution: BearingSolution) -> Iterator[tuple[str, str, str]]:
    """Yield number, row and angle of every roller, counted from 1; rows are blank where there is only one."""
    several = len(solution.bearing.rows) > 1
    for number, row in enumerate(solution.bearing.rows, start=1):
        for j in range(row.rollers.start, row.rollers.stop):
            yield str(j + 1), str(number) if several else "", _degrees(solution.angle[j])


def _degrees(angle: float) -> str:
    return f"{math.degrees(angle):.1f}"
