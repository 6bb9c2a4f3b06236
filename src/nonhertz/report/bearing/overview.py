"""The overview of a loaded bearing: what was solved, its key numbers, its parts as on a drawing, and its geometry."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import Amount, amount, digits, given, mm, mpa, mrad, newton, newton_mm, um
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
from nonhertz.show.bearing import carrying, most_loaded

PARTS = ("roller", *RINGS)
NEAR_ENDS = 0.9  # of what can touch
PART_COLUMNS = ("", "rollers", "inner ring", "outer ring")
_PRESCRIBED: dict[str, tuple[str, Callable[..., Amount]]] = {
    "radial": ("a radial force of", newton),
    "axial": ("an axial force of", newton),
    "moment": ("a moment of", newton_mm),
    "radial_displacement": ("a radial displacement of", um),
    "axial_displacement": ("an axial displacement of", um),
    "tilt": ("a tilt of", mrad),
}


def bearing_opening(case: BearingCase) -> str:
    """Return one sentence on what was solved."""
    row = case.bearing.rows[0].bearing
    rows = len(case.bearing.rows)
    size = f"{mm(row.roller_diameter, row.roller_length, between=' x '):.5g}"
    what = f"{row.kind}{f' of {rows} rows' if rows > 1 else ''}".capitalize()
    each = " in each row" if rows > 1 else ""
    speed = f" at {given(float(case.prescribed['speed']))} 1/min" if case.prescribed.get("speed") else ""
    circle = f"on a pitch circle of {mm(row.pitch):.5g}"
    return f"{what}, {row.rollers} rollers of {size}{each} {circle}, {loads_in_words(case)}{speed}."


def loads_in_words(case: BearingCase) -> str:
    """Return what loads or moves the inner ring, as it follows "a bearing"."""
    acting = [_acting(name, case.prescribed[name]) for name in _PRESCRIBED if name in case.prescribed]
    return f"under {', '.join(acting[:-1])}{' and ' * (len(acting) > 1)}{acting[-1]}" if acting else "without a load"


def _acting(name: str, value: Any) -> str:
    words, kind = _PRESCRIBED[name]
    values = value if hasattr(value, "__iter__") else (value,)
    return f"{words} {kind(*values, between=' and '):.5g}"


def bearing_keys(found: BearingResults) -> list[Key]:
    """Return the key numbers."""
    solution = found.solution
    if solution is None:
        return []
    count = int(np.count_nonzero(carrying(solution)))
    keys = [*_pressure_keys(solution)]
    if count:
        j = most_loaded(solution)
        keys.append(Key.of("largest load", newton(solution.load[j].max()), solution.place_of(j)))
    keys.append(Key("loaded rollers", f"{count} of {solution.angle.size}", ""))
    keys += _motion_keys(solution)
    if solution.rib_load.max(initial=0.0) > 0.0:
        keys.append(Key.of("largest load of a rib", newton(solution.rib_load.max())))
    return [*keys, *(_life_keys(found.life, found.speed) if found.life else [])]


def _pressure_keys(solution: BearingSolution) -> list[Key]:
    if solution.method != "strips" or not solution.load.any():
        return []
    pressure = solution.max_pressure
    j, k = np.unravel_index(int(np.argmax(pressure)), pressure.shape)
    return [Key.of("maximum pressure", mpa(pressure[j, k]), f"{RINGS[k]} ring")]


def _motion_keys(solution: BearingSolution) -> list[Key]:
    moved, size = solution.displacement, float(np.max(np.abs(solution.displacement[:3])))
    keys = []
    radial = math.hypot(*moved[1:3])
    if radial > 1e-6 * size:
        keys.append(Key.of("radial displacement", um(radial)))
    if abs(moved[0]) > 1e-6 * size:
        keys.append(Key.of("axial displacement", um(moved[0])))
    tilt = math.hypot(*moved[3:])
    if tilt > 1e-9:
        keys.append(Key.of("tilt of the inner ring", mrad(tilt), spec="4"))
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
    places, (factor, unit), (_, micro) = mm(*_near_ends(row), between=" and "), mm().scale, um().scale
    rows: list[tuple[str, ...]] = [
        (f"diameter [{unit}]", *(_diameter(body) for body in bodies)),
        (f"length [{unit}]", *("–" if body.length is None else given(factor * body.length) for body in bodies)),
        ("corner", *(_corner(body) for body in bodies)),
        (f"relief at y = {places:.4g} [{micro}]", *_reliefs(row)),
        ("material", *(_material(body) for body in bodies)),
        ("bore, thickness", *(_behind(body) for body in bodies)),
        ("ends", *("–" if body.length is None else shown(body.side_faces) for body in bodies)),
    ]
    return [each for each in rows if any(cell not in {"", "–"} for cell in each[1:])]


def _diameter(body: Body) -> str:
    if body.diameter is None:
        return "flat"
    if isinstance(body.diameter, TabulatedDiameter):
        return " to ".join(mm(body.diameter.diameter[0], body.diameter.diameter[-1]).apart("g")[0])
    return mm(body.diameter).apart("g")[0][0] if isinstance(body.diameter, float | int) else "varies"


def _corner(body: Body) -> str:
    if body.chamfer is not None:
        return f"{mm(body.chamfer.length):g} at {given(math.degrees(body.chamfer.angle), 4)}°"
    return "–" if body.corner_radius is None else f"R {mm(body.corner_radius):g}"


def _reliefs(row: RollerBearing) -> list[str]:
    """Return the reliefs of the bodies near the ends of what can touch, without the arcs of barrels."""
    found = []
    for name in PARTS:
        ends = getattr(row, name).relief(_near_ends(row))
        found.append(" and ".join(um(*ends).apart("3")[0]) if np.any(ends != 0.0) else "–")
    return found


def _near_ends(row: RollerBearing) -> NDArray[np.float64]:
    """Return where reliefs are shown [mm]: at the very end some have none."""
    return NEAR_ENDS * np.array(row.contacts[0].interval)


def _material(body: Body) -> str:
    name = next((name for name, known in MATERIALS.items() if known == body.material), "")
    return name or f"E = {mpa(body.material.modulus):g}"


def _behind(body: Body) -> str:
    if body.bore is not None:
        return f"bore {_diameter(Body(diameter=body.bore))} {mm().scale[1]}"
    depth = body.behind.shown
    return "solid" if depth == "finite" else depth


def bearing_geometry(case: BearingCase) -> list[tuple[str, str, str]]:
    """Return name, value and unit of what follows from the dimensions of a bearing."""
    row = case.bearing.rows[0].bearing
    between = row.pitch * math.sin(math.pi / row.rollers) - row.roller_diameter
    room = mm(between).apart("4") if row.rollers > 1 else (["no neighbour"], "")
    rows = [("pitch diameter", mm(row.pitch).apart("g")), ("room between neighbouring rollers", room)]
    if row.nominal_angle and not isinstance(row, CylindricalThrustBearing):
        rows.append(("contact angles at inner and outer ring", _degrees(*row.contact_angles)))
    if isinstance(row, TaperedRollerBearing):
        rows.append(("half cone angle of the rollers", _degrees(row.half_cone_angle)))
    if isinstance(case.bearing, Paired):
        rows.append(("rows at x =", mm(*(each.x for each in case.bearing.rows)).apart("g")))
    for ring, contact in zip(RINGS, row.contacts, strict=True):
        radius = 1.0 / float(contact.curvature(np.zeros(1))[0])
        rows.append((f"combined radius across, {ring} ring", mm(radius).apart()))
    for ring in RINGS:
        rib = next((each for each in row.rib_contacts if each.ring == ring), None)
        if rib is not None:
            radii = mm(rib.radius_around, rib.radius_along).apart("4")
            rows.append((f"combined radii on the ribs, {ring} ring, around and along the flank", radii))
    if row.roller_density is not None:
        rows.append(("mass of a roller", amount(1e6 * row.inertia.mass, "g").apart(".4g")))
    return [(name, " and ".join(numbers), unit) for name, (numbers, unit) in rows]


def _degrees(*angles: float) -> tuple[list[str], str]:
    return [given(math.degrees(each), 5) for each in angles], "degrees"
