"""A bearing and its results as a REXS model."""

from __future__ import annotations

import copy
import json
import math
from collections.abc import Iterable, Iterator
from datetime import UTC, datetime
from pathlib import Path
from types import SimpleNamespace
from typing import Any, Final

import numpy as np

from nonhertz import __version__
from nonhertz.bearing.assessed import BearingLife
from nonhertz.bearing.section import RINGS
from nonhertz.bearing.solution import BearingSolution
from nonhertz.bearing.standard import slice_loads
from nonhertz.errors import InputError
from nonhertz.files.bearingfile import BearingCase
from nonhertz.files.folder import write_file
from nonhertz.files.rexs import attributes as table
from nonhertz.files.rexs.attributes import Attribute
from nonhertz.files.rexs.model import VERSION, Attributes, Model, as_json, as_xml
from nonhertz.model.materials import MATERIALS

FORMS: Final = {"xml": as_xml, "json": as_json}
_FORCES, _MOTIONS = ("f_u", "f_v", "f_w", "m_v", "m_w"), ("d_u", "d_v", "d_w", "rot_v", "rot_w")
_LIVES: Final = ("basic_life", "reference_life", "modified_life")
_PLACES: Final = 81  # along a roller's profile
LOADS: Final = ("radial", "axial", "moment", "radial_displacement", "axial_displacement", "tilt")


def to_rexs(
    case: BearingCase, solution: BearingSolution | None = None, life: BearingLife | None = None, *, form: str = "xml"
) -> str:
    """Return a bearing as REXS 1.4, with loads and results in a load case.

    Parameters
    ----------
    case : BearingCase
        The bearing and its loads.
    solution : BearingSolution, optional
        The result of `BearingCase.solve`, for loads, pressures and stiffness.
    life : BearingLife, optional
        The result of `BearingCase.assess`, for lives.
    form : {"xml", "json"}
        The form of the text.

    Raises
    ------
    InputError
        If there is no such form, or the bearing cannot be written.
    """
    if form not in FORMS:
        raise InputError("form", form, "be 'xml' or 'json'", "choose one of them")
    return FORMS[form](_model(case, solution, life))


def form_of(path: Path) -> str:
    """Return the form of a REXS file by its name.

    Raises
    ------
    InputError
        If its name has another ending.
    """
    endings = {".rexs": "xml", ".rexs.xml": "xml", ".rexsj": "json", ".rexs.json": "json"}
    known = next((form for ending, form in endings.items() if path.name.lower().endswith(ending)), None)
    if known is None:
        raise InputError("path", str(path), "end with .rexs, .rexs.xml, .rexsj or .rexs.json", "rename the file")
    return known


def write_rexs(
    path: str | Path, case: BearingCase, solution: BearingSolution | None = None, life: BearingLife | None = None
) -> Path:
    """Write a bearing to a REXS file, as XML (.rexs, .rexs.xml) or JSON (.rexsj, .rexs.json), and return the file.

    Raises
    ------
    InputError
        If the file's name has another ending, or the file or the bearing cannot be written.
    """
    path = Path(path)
    return write_file(path, to_rexs(case, solution, life, form=form_of(path)))


def _model(case: BearingCase, solution: BearingSolution | None, life: BearingLife | None) -> Model:
    document = copy.deepcopy(case.own_document)
    del document["format"]
    kind = document["bearing"].pop("kind")
    date = datetime.now(UTC).astimezone().isoformat(timespec="seconds")
    names = ("version", "applicationId", "applicationVersion", "date")
    model = Model(dict(zip(names, (VERSION, "nonhertz", __version__, date), strict=True)))
    loads = [document["load"], *document.get("life", {}).pop("spectrum", ())]
    states = [_load_case(load, case.life.turning) for load in loads]
    # A bearing has its place in REXS between two other components.
    unit, shaft, casing = (model.add(entry) for entry in (table.GEAR_UNIT, "shaft", "gear_casing"))
    bearing = model.add(table.BEARING, case.title or case.bearing.rows[0].bearing.kind)
    for part in (shaft, casing):
        model.relate("assembly", assembly=unit, part=part)
    model.relate("side", assembly=bearing, inner_part=shaft, outer_part=casing)
    material = _add_materials(model, bearing, document)
    attributes = _take_attributes(case, document, kind)
    rollers = _add_rows(model, bearing, case, attributes, material)
    rest = json.dumps({name: entry for name, entry in document.items() if entry}), "none"
    model.components[bearing].attributes |= attributes[table.BEARING] | _words(case, kind) | {table.REST: rest}
    if solution is not None:
        states[0] |= _of_ring(solution, states[0]) | _read_off(table.RESULTS, _known_of(case, solution, life), kind)
    model.load_cases = [time | {bearing: state} for time, state in zip(_times(case, unit), states, strict=True)]
    if solution is not None:
        model.load_cases[0] |= _add_contacts(model, rollers, case, solution, kind)
    return model


def _take_attributes(case: BearingCase, document: dict[str, Any], kind: str) -> dict[str, Attributes]:
    """Take the keys that are attributes out of a document, by component."""
    row = case.bearing.rows[0].bearing
    low, high = row.effective_interval
    # Closer to each other towards the ends, where profiles fall off and may have no end.
    y = 0.5 * (low + high) - 0.5 * (high - low) * np.cos(math.pi * (np.arange(_PLACES) + 0.5) / _PLACES)
    known = SimpleNamespace(
        case=case, row=row, effective_length=high - low, profile_y=y, profile_relief=row.roller.profile.relief(y)
    )
    # With fits, the clearance is that before mounting.
    other = f"{'radial' if case.fit is None else 'operating_radial'}_bearing_clearance"
    entries = [entry for entry in table.EXCHANGED if entry.id != other and kind in entry.kinds]
    attributes = {
        component: _taken([entry for entry in entries if entry.component == component], document, known)
        for component in (table.BEARING, table.ROW, table.ROLLER)
    }
    attributes[table.BEARING] |= _classes(document, kind)
    attributes[table.ROLLER] |= _read_off(table.PROFILE, known, kind)
    return attributes


def _classes(document: dict[str, Any], kind: str) -> Attributes:
    """Take classes of bores, seats and clearance out of a document."""
    attributes: Attributes = {}
    for entry in table.CLASSES:
        place, name = _place_of(document, entry)
        word = place.get(name)
        if kind in entry.kinds and isinstance(word, str):
            attributes[entry.id] = table.CLASS_WORDS.get(word, word), "none"
            del place[name]
    return attributes


def _place_of(document: dict[str, Any], entry: Attribute) -> tuple[dict[str, Any], str]:
    """Return the table of a key, empty where it is missing, and its name there."""
    *tables, name = entry.key.split(".")
    for step in tables:
        document = document.get(step, {})
    return document, name


def _words(case: BearingCase, kind: str) -> Attributes:
    """Return the kind of a bearing in the words of REXS."""
    rows = case.bearing.rows
    up, down = (any(entry.bears_axially[k] for entry in rows) for k in range(2))
    return {
        "bearing_type": (table.TYPES[kind][0], "none"),
        "axial_force_absorption": (table.DIRECTIONS[up, down], "none"),
        "radial_force_absorption": (rows[0].bearing.bears_radially, "none"),
        "number_of_bearing_rows": (len(rows), "none"),
    }


def _add_materials(model: Model, bearing: int, document: dict[str, Any]) -> int | None:
    """Add oil and materials, and return the number of the rollers' material."""
    oil = _oil(document)
    if oil:
        model.relate("reference", origin=bearing, referenced=model.add(table.OIL, "oil", oil))
    numbers = {name: model.add(table.MATERIAL, name, entry) for name, entry in _materials(document).items()}
    if "rings" in numbers:
        model.relate("reference", origin=bearing, referenced=numbers["rings"])
    return numbers.get("rollers")


def _add_rows(
    model: Model, bearing: int, case: BearingCase, attributes: dict[str, Attributes], material: int | None
) -> list[int]:
    """Add rows and rollers, and return the numbers of all rollers."""
    rollers = []
    for order, entry in enumerate(case.bearing.rows, start=1):
        words = {
            "axial_force_absorption_of_row": (table.DIRECTIONS[entry.bears_axially], "none"),
            "position_of_rolling_elements": ("one_rolling_element_on_v_axis", "none"),
        }
        row = model.add(table.ROW, f"row {order}", attributes[table.ROW] | words)
        model.relate("ordered_assembly", order, assembly=bearing, part=row)
        for k, angle in enumerate(entry.bearing.angles.tolist(), start=1):
            at = {"angular_position_around_u": (math.degrees(angle), "deg")}
            rollers.append(model.add(table.ROLLER, "", attributes[table.ROLLER] | at))
            model.relate("ordered_assembly", k, assembly=row, part=rollers[-1])
            if material is not None:
                model.relate("reference", origin=rollers[-1], referenced=material)
    return rollers


def _add_contacts(
    model: Model, rollers: list[int], case: BearingCase, solution: BearingSolution, kind: str
) -> dict[int, Attributes]:
    """Add a contact at each ring for every roller, and return their results."""
    states = {}
    for roller, at_rings in zip(rollers, _known_of_contacts(case, solution), strict=True):
        for ring, known in zip(RINGS, at_rings, strict=True):
            word = {"rolling_element_contact_type": (f"{ring}_raceway_contact", "none")}
            contact = model.add(table.CONTACT, "", word)
            model.relate("assembly", assembly=roller, part=contact)
            states[contact] = _read_off(table.CONTACTS, known, kind)
    return states


def _times(case: BearingCase, unit: int) -> list[dict[int, Attributes]]:
    """Return a load case of the gear unit for the load, and one with its share of the time for each of a spectrum."""
    spectrum = case.spectrum
    if not all(entry.speed for entry in spectrum):
        return [{}] * (1 + len(spectrum))
    times = [entry.share / entry.speed for entry in spectrum]
    percent = 100.0 * sum(entry.share for entry in spectrum) / (sum(times) or 1.0)
    return [{}, *({unit: {table.TIME_SHARE: (percent * time, "%")}} for time in times)]


def _taken(entries: Iterable[Attribute], document: dict[str, Any], known: Any) -> Attributes:
    """Remove the keys that are attributes from a document, and return these."""
    attributes: Attributes = {}
    for entry in entries:
        place: Any
        place, name = _place_of(document, entry)
        value = place.get(name)
        if isinstance(value, int):
            attributes[entry.id] = place.pop(name), entry.unit
        elif isinstance(value, float):
            attributes[entry.id] = place.pop(name) / entry.size, entry.unit
        elif entry.value:
            attributes[entry.id] = float(entry.of(known)) / entry.size, entry.unit
    return attributes


def _read_off(entries: Iterable[Attribute], known: Any, kind: str) -> Attributes:
    """Return known values as attributes."""
    attributes: Attributes = {}
    for entry in entries:
        value = entry.of(known) if kind in entry.kinds else None
        if isinstance(value, np.ndarray) and value.ndim:
            attributes[entry.id] = (value / entry.size).tolist(), entry.unit
        elif value is not None and math.isfinite(value):
            attributes[entry.id] = float(value) / entry.size, entry.unit
    return attributes


def _load_case(load: dict[str, Any], turning: str) -> Attributes:
    """Remove prescribed loads, a speed and a share of revolutions from a table of loads, and return them."""
    prescribed = {name: _pair(name, load.pop(name)) for name in LOADS if name in load}
    attributes: Attributes = {table.PRESCRIBED: (" ".join(prescribed), "none")}
    for entry in table.LOADS:
        key, _, place = entry.key.removeprefix("load.").partition(".")
        if key in prescribed:
            attributes[entry.id] = prescribed[key][int(place or 0)] / entry.size, entry.unit
    if "speed" in load:
        attributes[f"speed_{turning}_ring"] = load.pop("speed"), "1 / min"
    if "share" in load:
        attributes[table.REVOLUTION_SHARE] = load.pop("share"), "none"
    return attributes


def _pair(name: str, value: float | list[float]) -> list[float]:
    """Return values about both axes, or one value of the bearing's axis."""
    if isinstance(value, list) or name not in table.PAIRS:
        return value if isinstance(value, list) else [value]
    return [value, 0.0] if table.PAIRS[name] == 0 else [0.0, value]


def _of_ring(solution: BearingSolution, prescribed: Attributes) -> Attributes:
    """Return forces and displacements that are not prescribed, and the forces on shaft and housing."""
    force, moved = solution.force.tolist(), solution.displacement.tolist()
    attributes: Attributes = {}
    for entry, value in zip(table.LOADS, [*force, *moved], strict=True):
        if entry.id not in prescribed:
            attributes[entry.id] = value / entry.size, entry.unit
    for entry, value in zip(table.REACTIONS, force, strict=True):
        attributes[entry.id] = value / entry.size, entry.unit
        attributes[entry.id.replace("inner", "outer")] = -value / entry.size, entry.unit
    return attributes


def _known_of(case: BearingCase, solution: BearingSolution, life: BearingLife | None) -> SimpleNamespace:
    """Return the values of a loaded bearing, by the paths of the table."""
    stiffness = {
        f"{force}_{motion}": value
        for force, row in zip(_FORCES, solution.stiffness, strict=True)
        for motion, value in zip(_MOTIONS, row, strict=True)
    }
    lives = {} if life is None else {name: 1e6 * getattr(life, name) for name in _LIVES}
    pressure = dict(zip(RINGS, solution.max_pressure.max(axis=0), strict=True)) if solution.method == "strips" else {}
    return SimpleNamespace(
        case=case, life=life, stiffness=stiffness, revolutions=lives,
        hours={name: life.hours_per_million * lives[name] / 1e6 for name in lives} if life and life.speed else {},
        pressure=pressure | ({"both": max(pressure.values())} if pressure else {}),
    )  # fmt: skip


def _known_of_contacts(case: BearingCase, solution: BearingSolution) -> Iterator[list[dict[str, Any]]]:
    """Yield the values of every roller at the inner and at the outer ring."""
    if solution.method == "strips":
        details = ([_of_strips(solution, j, ring) for ring in range(2)] for j in range(solution.angle.size))
    else:
        slices = slice_loads(solution, case.solver.laminae)
        details = ([{"y": entry.y, "lamina_load": at} for at in load] for entry, loads in slices for load in loads)
    for j, at_rings in enumerate(details):
        yield [
            {name: getattr(solution, name)[j, k] for name in ("load", "moment", "contact_angle")} | detail
            for k, detail in enumerate(at_rings)
        ]


def _of_strips(solution: BearingSolution, roller: int, ring: int) -> dict[str, Any]:
    contact = solution.contact(roller, RINGS[ring])
    if contact is None:
        return {}
    return {
        "y": contact.y, "lamina_load": contact.line_load * contact.strip_width, "pressure": contact.centre_pressure,
        "max_pressure": solution.max_pressure[roller, ring],
    }  # fmt: skip


def _oil(document: dict[str, Any]) -> Attributes:
    oil = document.get("lubrication", {})
    attributes: Attributes = {}
    if "oil" in oil:
        attributes["name"] = oil.pop("oil"), "none"
    if "viscosities" in oil and oil.get("temperatures") == [40.0, 100.0]:
        thick, thin = oil.pop("viscosities")
        attributes |= {
            f"viscosity_at_{at}_degree_celsius": (entry, "mm^2 / s") for at, entry in ((40, thick), (100, thin))
        }
    if attributes or "viscosity" in oil:
        attributes["kind"] = ("grease" if oil.get("grease") else "oil"), "none"
    return attributes


def _materials(document: dict[str, Any]) -> dict[str, Attributes]:
    """Take materials out of a document, if both rings have the same."""
    components: dict[str, Attributes] = {}
    rings = [document[ring].get("material") for ring in RINGS]
    for name, name_or_table, bodies in (
        ("rollers", document["roller"].get("material"), ("roller",)),
        ("rings", rings[0], RINGS),
    ):
        if name_or_table is None or (name == "rings" and rings[0] != rings[1]):
            continue
        material = MATERIALS[name_or_table] if isinstance(name_or_table, str) else SimpleNamespace(**name_or_table)
        components[name] = {
            "elastic_modulus": (float(material.modulus), "N / mm^2"),
            "poisson_ratio": (float(material.poisson), "none"),
        }
        if isinstance(name_or_table, str):
            components[name]["material_designation"] = name_or_table, "none"
            for body in bodies:
                del document[body]["material"]
    return components
