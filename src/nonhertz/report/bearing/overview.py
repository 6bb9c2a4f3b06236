"""The overview of a loaded bearing: what was solved, its key numbers, its parts as on a drawing, and its geometry."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nonhertz.bearing.assessed import BearingLife
from nonhertz.bearing.bearings import CylindricalThrustBearing, Paired, RollerBearing, TaperedRollerBearing
from nonhertz.bearing.frames import RINGS
from nonhertz.bearing.solution import BearingSolution
from nonhertz.files.bearingfile import BearingCase
from nonhertz.model.body import Body, TabulatedDiameter
from nonhertz.model.materials import MATERIALS
from nonhertz.report.bearing.results import BearingResults
from nonhertz.report.inputs import shown
from nonhertz.report.overview import Key
from nonhertz.result.numerals import digits, given, unit_for
from nonhertz.show.bearing import carrying, most_loaded

PARTS = ("roller", *RINGS)
NEAR_ENDS = 0.9  # of what can touch
PART_COLUMNS = ("", "rollers", "inner ring", "outer ring")
_PRESCRIBED = {
    "radial": ("a radial force of", "N"),
    "axial": ("an axial force of", "N"),
    "moment": ("a moment of", "N mm"),
    "radial_displacement": ("a radial displacement of", "µm"),
    "axial_displacement": ("an axial displacement of", "µm"),
    "tilt": ("a tilt of", "mrad"),
}


def bearing_opening(case: BearingCase) -> str:
    """Return one sentence on what was solved."""
    row = case.bearing.rows[0].bearing
    rows = len(case.bearing.rows)
    size = f"{given(row.roller_diameter, 5)} x {given(row.roller_length, 5)} mm"
    what = f"{row.kind}{f' of {rows} rows' if rows > 1 else ''}".capitalize()
    each = " in each row" if rows > 1 else ""
    speed = f" at {given(float(case.prescribed['speed']))} 1/min" if case.prescribed.get("speed") else ""
    circle = f"on a pitch circle of {given(row.pitch, 5)} mm"
    return f"{what}, {row.rollers} rollers of {size}{each} {circle}, {loads_in_words(case)}{speed}."


def loads_in_words(case: BearingCase) -> str:
    """Return what loads or moves the inner ring, as it follows "a bearing"."""
    acting = [_acting(name, case.prescribed[name]) for name in _PRESCRIBED if name in case.prescribed]
    return f"under {', '.join(acting[:-1])}{' and ' * (len(acting) > 1)}{acting[-1]}" if acting else "without a load"


def _acting(name: str, value: Any) -> str:
    words, unit = _PRESCRIBED[name]
    scale = 1e3 if unit in {"µm", "mrad"} else 1.0
    values = [scale * float(each) for each in (value if hasattr(value, "__iter__") else (value,))]
    factor, unit = unit_for(values, unit)
    return f"{words} {' and '.join(given(factor * each, 5) for each in values)} {unit}"


def bearing_keys(found: BearingResults) -> list[Key]:
    """Return the key numbers."""
    solution = found.solution
    if solution is None:
        return []
    count = int(np.count_nonzero(carrying(solution)))
    keys = [*_pressure_keys(solution)]
    if count:
        j = most_loaded(solution)
        keys.append(_load_key("largest load", float(solution.load[j].max()), solution.place_of(j)))
    keys.append(Key("loaded rollers", f"{count} of {solution.angle.size}", ""))
    keys += _motion_keys(solution)
    if solution.rib_load.max(initial=0.0) > 0.0:
        keys.append(_load_key("largest load of a rib", float(solution.rib_load.max())))
    return [*keys, *(_life_keys(found.life, found.speed) if found.life else [])]


def _load_key(name: str, load: float, remark: str = "") -> Key:
    factor, unit = unit_for((load,), "N")
    return Key(name, digits(factor * load), unit, remark)


def _pressure_keys(solution: BearingSolution) -> list[Key]:
    if solution.method != "strips" or not solution.load.any():
        return []
    pressure = solution.max_pressure
    j, k = np.unravel_index(int(np.argmax(pressure)), pressure.shape)
    return [Key("maximum pressure", digits(float(pressure[j, k])), "MPa", f"{RINGS[k]} ring")]


def _motion_keys(solution: BearingSolution) -> list[Key]:
    moved, size = 1e3 * solution.displacement, float(np.max(np.abs(solution.displacement[:3])))
    keys = []
    radial = math.hypot(*moved[1:3])
    if radial > 1e-6 * size:
        keys.append(Key("radial displacement", digits(radial), "µm"))
    if abs(moved[0]) > 1e-6 * size:
        keys.append(Key("axial displacement", digits(float(moved[0])), "µm"))
    tilt = math.hypot(*moved[3:])
    if tilt > 1e-6:
        keys.append(Key("tilt of the inner ring", digits(tilt, 4), "mrad"))
    return keys


def _life_keys(life: BearingLife, speed: float | None) -> list[Key]:
    keys = []
    if math.isfinite(life.static_safety):
        keys.append(Key("static safety S0", digits(life.static_safety, 3), ""))
    if life.no_reference:
        keys.append(Key("modified life", "none", "", life.no_reference))
    elif math.isfinite(life.modified):
        hours = f"{digits(life.modified * 1e6 / (60.0 * speed), 4)} hours" if speed else ""
        keys.append(Key("modified life", digits(life.modified, 4), "million rev.", hours))
    return keys


def part_rows(case: BearingCase) -> list[tuple[str, ...]]:
    """Return the cells of `PART_COLUMNS`: what a drawing says of rollers and rings."""
    row = case.bearing.rows[0].bearing
    bodies = [getattr(row, name) for name in PARTS]
    places = " and ".join(given(float(place), 4) for place in _near_ends(row))
    rows: list[tuple[str, ...]] = [
        ("diameter [mm]", *(_diameter(body) for body in bodies)),
        ("length [mm]", *("–" if body.length is None else given(body.length) for body in bodies)),
        ("corner", *(_corner(body) for body in bodies)),
        (f"relief at y = {places} mm [µm]", *_reliefs(row)),
        ("material", *(_material(body) for body in bodies)),
        ("bore, thickness", *(_behind(body) for body in bodies)),
        ("ends", *("–" if body.length is None else shown(body.side_faces) for body in bodies)),
    ]
    return [each for each in rows if any(cell not in {"", "–"} for cell in each[1:])]


def _diameter(body: Body) -> str:
    if body.diameter is None:
        return "flat"
    if isinstance(body.diameter, TabulatedDiameter):
        return f"{given(body.diameter.diameter[0], 6)} to {given(body.diameter.diameter[-1], 6)}"
    return given(float(body.diameter), 6) if isinstance(body.diameter, float | int) else "varies"


def _corner(body: Body) -> str:
    if body.chamfer is not None:
        return f"{given(body.chamfer.length)} mm at {given(math.degrees(body.chamfer.angle), 4)}°"
    return "–" if body.corner_radius is None else f"R {given(body.corner_radius)} mm"


def _reliefs(row: RollerBearing) -> list[str]:
    """Return the reliefs of the bodies near the ends of what can touch [um], without the arcs of barrels."""
    found = []
    for name in PARTS:
        ends = 1e3 * getattr(row, name).relief(_near_ends(row))
        found.append(f"{digits(float(ends[0]), 3)} and {digits(float(ends[1]), 3)}" if np.any(ends != 0.0) else "–")
    return found


def _near_ends(row: RollerBearing) -> NDArray[np.float64]:
    """Return where reliefs are shown [mm]: at the very end some have none."""
    return NEAR_ENDS * np.array(row.contacts[0].interval)


def _material(body: Body) -> str:
    name = next((name for name, known in MATERIALS.items() if known == body.material), "")
    return name or f"E = {given(body.material.modulus)} MPa"


def _behind(body: Body) -> str:
    if body.bore is not None:
        return f"bore {_diameter(Body(diameter=body.bore))} mm"
    depth = body.behind.shown
    return "solid" if depth == "finite" else depth


def bearing_geometry(case: BearingCase) -> list[tuple[str, str, str]]:
    """Return name, value and unit of what follows from the dimensions of a bearing."""
    row = case.bearing.rows[0].bearing
    chord = row.pitch * math.sin(math.pi / row.rollers)
    between = digits(chord - row.roller_diameter, 4) if row.rollers > 1 else "no neighbour"
    rows = [("pitch diameter", given(row.pitch), "mm"), ("room between neighbouring rollers", between, "mm")]
    if row.nominal_angle and not isinstance(row, CylindricalThrustBearing):
        inner, outer = (given(math.degrees(each), 5) for each in row.contact_angles)
        rows.append(("contact angles at inner and outer ring", f"{inner} and {outer}", "degrees"))
    if isinstance(row, TaperedRollerBearing):
        rows.append(("half cone angle of the rollers", given(math.degrees(row.half_cone_angle), 5), "degrees"))
    if isinstance(case.bearing, Paired):
        places = " and ".join(given(each.x) for each in case.bearing.rows)
        rows.append(("rows at x =", places, "mm"))
    for ring, contact in zip(RINGS, row.contacts, strict=True):
        radius = 1.0 / float(contact.curvature(np.zeros(1))[0])
        rows.append((f"combined radius across, {ring} ring", digits(radius), "mm"))
    for ring in RINGS:
        rib = next((each for each in row.rib_contacts if each.ring == ring), None)
        if rib is not None:
            radii = f"{digits(rib.radius_around, 4)} and {digits(rib.radius_along, 4)}"
            rows.append((f"combined radii on the ribs, {ring} ring, around and along the flank", radii, "mm"))
    if row.roller_density is not None:
        rows.append(("mass of a roller", given(1e6 * row.inertia.mass, 4), "g"))
    return rows
