"""A bearing, and what is found of it, as a model in REXS."""

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
from nonhertz.bearing.solution import BearingSolution, slice_loads
from nonhertz.errors import InputError
from nonhertz.files.bearingfile import BearingCase
from nonhertz.files.folder import write_file
from nonhertz.files.rexs import attributes as table
from nonhertz.files.rexs.attributes import Attribute
from nonhertz.files.rexs.model import VERSION, Attributes, Model, as_json, as_xml
from nonhertz.model.materials import MATERIALS

FORMS: Final = {"xml": as_xml, "json": as_json}
#: Loads and motions of two axes, and which of them one number alone is.
PAIRS: Final = {"radial": 0, "radial_displacement": 0, "moment": 1, "tilt": 1}
_FORCES, _MOTIONS = ("f_u", "f_v", "f_w", "m_v", "m_w"), ("d_u", "d_v", "d_w", "rot_v", "rot_w")
_LIVES: Final = ("basic_life", "reference_life", "modified_life")
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
        What `BearingCase.solve` returned, for loads, pressures and stiffness.
    life : BearingLife, optional
        What `BearingCase.assess` returned, for lives.
    form : {"xml", "json"}
        Which of both forms.

    Raises
    ------
    InputError
        If there is no such form, or no file can hold the bearing.
    """
    if form not in FORMS:
        raise InputError("form", form, "be 'xml' or 'json'", "choose one of them")
    return FORMS[form](_model(case, solution, life))


def form_of(path: Path) -> str:
    """Return the form of a file of REXS by its name.

    Raises
    ------
    InputError
        If its name has another ending.
    """
    endings = {".rexs": "xml", ".rexs.xml": "xml", ".rexsj": "json", ".rexs.json": "json"}
    known = next((form for ending, form in endings.items() if path.name.lower().endswith(ending)), None)
    if known is None:
        raise InputError("--rexs", str(path), "end with .rexs, .rexs.xml, .rexsj or .rexs.json", "rename the file")
    return known


def write_rexs(
    path: str | Path, case: BearingCase, solution: BearingSolution | None = None, life: BearingLife | None = None
) -> Path:
    """Write what `to_rexs` returns to a file, as XML (.rexs, .rexs.xml) or JSON (.rexsj, .rexs.json), and return it.

    Raises
    ------
    InputError
        If the file's name has another ending, it cannot be written, or no file can hold the bearing.
    """
    path = Path(path)
    return write_file(path, to_rexs(case, solution, life, form=form_of(path)))


def _model(case: BearingCase, solution: BearingSolution | None, life: BearingLife | None) -> Model:
    document = copy.deepcopy(case.own_document)
    del document["format"]
    rows, kind = case.bearing.rows, document["bearing"].pop("kind")
    row = rows[0].bearing
    low, high = row.effective_interval
    y = row.roller_length * np.linspace(-0.5, 0.5, 41)
    known = SimpleNamespace(
        case=case, row=row, effective_length=high - low, profile_y=y, profile_relief=row.roller.profile.relief(y)
    )
    date = datetime.now(UTC).astimezone().isoformat(timespec="seconds")
    names = ("version", "applicationId", "applicationVersion", "date")
    model = Model(dict(zip(names, (VERSION, "nonhertz", __version__, date), strict=True)))
    loads, oil, materials = _load_case(document["load"], case.life.turning), _oil(document), _materials(document)
    # With fits the clearance is that before mounting.
    other = f"{'radial' if case.fit is None else 'operating_radial'}_bearing_clearance"
    exchanged = [entry for entry in table.EXCHANGED if entry.id != other and kind in entry.kinds]
    of_bearing, of_rows, of_rollers = (
        _taken([entry for entry in exchanged if entry.component == component], document, known)
        for component in (table.BEARING, table.ROW, table.ROLLER)
    )
    of_rollers |= _read_off(table.PROFILE, known, kind)
    # A bearing has its place in REXS between two other components.
    unit, shaft, casing = (model.add(entry) for entry in ("gear_unit", "shaft", "gear_casing"))
    bearing = model.add(table.BEARING, case.title or row.kind)
    for part in (shaft, casing):
        model.relate("assembly", assembly=unit, part=part)
    model.relate("side", assembly=bearing, inner_part=shaft, outer_part=casing)
    if oil:
        model.relate("reference", origin=bearing, referenced=model.add(table.OIL, "oil", oil))
    made_of = {name: model.add(table.MATERIAL, name, entry) for name, entry in materials.items()}
    if "rings" in made_of:
        model.relate("reference", origin=bearing, referenced=made_of["rings"])
    contacts = []
    for order, entry in enumerate(rows, start=1):
        words = {
            "axial_force_absorption_of_row": (table.DIRECTIONS[entry.bears_axially], "none"),
            "position_of_rolling_elements": ("one_rolling_element_on_v_axis", "none"),
        }
        number = model.add(table.ROW, f"row {order}", of_rows | words)
        model.relate("ordered_assembly", order, assembly=bearing, part=number)
        for k, angle in enumerate(entry.bearing.angles.tolist(), start=1):
            roller = model.add(
                table.ROLLER, "", of_rollers | {"angular_position_around_u": (math.degrees(angle), "deg")}
            )
            model.relate("ordered_assembly", k, assembly=number, part=roller)
            if "rollers" in made_of:
                model.relate("reference", origin=roller, referenced=made_of["rollers"])
            for ring in RINGS if solution is not None else ():
                word = {"rolling_element_contact_type": (f"{ring}_raceway_contact", "none")}
                contacts.append(model.add(table.CONTACT, "", word))
                model.relate("assembly", assembly=roller, part=contacts[-1])
    up, down = (any(entry.bears_axially[k] for entry in rows) for k in range(2))
    group = document["bearing"].get("clearance")
    model.components[bearing].attributes |= of_bearing | {
        "bearing_type": (table.TYPES[kind][0], "none"),
        "axial_force_absorption": (table.DIRECTIONS[up, down], "none"),
        "radial_force_absorption": (row.bears_radially, "none"),
        "number_of_bearing_rows": (len(rows), "none"),
        **({"radial_clearance_class": (group.replace("CN", "C0"), "none")} if isinstance(group, str) else {}),
        table.REST: (json.dumps({name: entry for name, entry in document.items() if entry}), "none"),
    }
    state = {bearing: loads}
    if solution is not None:
        loads |= _of_ring(solution, loads) | _read_off(table.RESULTS, _known_of(case, solution, life), kind)
        for number, at in zip(contacts, _known_of_contacts(case, solution), strict=True):
            state[number] = _read_off(table.CONTACTS, at, kind)
    model.load_cases.append(state)
    return model


def _taken(entries: Iterable[Attribute], document: dict[str, Any], known: Any) -> Attributes:
    """Take the keys that are attributes out of a document."""
    attributes: Attributes = {}
    for entry in entries:
        *tables, name = entry.key.split(".")
        place: Any = document
        for step in tables:
            place = place.get(step, {})
        value = place.get(name)
        if isinstance(value, int):
            attributes[entry.id] = place.pop(name), entry.unit
        elif isinstance(value, float):
            attributes[entry.id] = place.pop(name) / entry.size, entry.unit
        elif entry.value:
            attributes[entry.id] = float(entry.of(known)) / entry.size, entry.unit
    return attributes


def _read_off(entries: Iterable[Attribute], known: Any, kind: str) -> Attributes:
    """Return what is known as attributes."""
    attributes: Attributes = {}
    for entry in entries:
        value = entry.of(known) if kind in entry.kinds else None
        if isinstance(value, np.ndarray) and value.ndim:
            attributes[entry.id] = (value / entry.size).tolist(), entry.unit
        elif value is not None and math.isfinite(value):
            attributes[entry.id] = float(value) / entry.size, entry.unit
    return attributes


def _load_case(load: dict[str, Any], turning: str) -> Attributes:
    """Take what is prescribed out of the table of loads."""
    names = [name for name in LOADS if name in load]
    for name in names:
        if name in PAIRS and not isinstance(load[name], list):
            load[name] = [load[name], 0.0] if PAIRS[name] == 0 else [0.0, load[name]]
    attributes: Attributes = {table.PRESCRIBED: (" ".join(names), "none")}
    for entry in table.LOADS:
        key, _, place = entry.key.removeprefix("load.").partition(".")
        if key in load:
            attributes[entry.id] = (load[key][int(place)] if place else load[key]) / entry.size, entry.unit
    for name in names:
        del load[name]
    if "speed" in load:
        attributes[f"speed_{turning}_ring"] = load.pop("speed"), "1 / min"
    return attributes


def _of_ring(solution: BearingSolution, prescribed: Attributes) -> Attributes:
    """Return forces and motions that are not prescribed, and what the bearing does to parts within and around it."""
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
    """Return what is known of a loaded bearing, by the paths of the table."""
    stiffness = {
        f"{force}_{motion}": value
        for force, row in zip(_FORCES, solution.stiffness, strict=True)
        for motion, value in zip(_MOTIONS, row, strict=True)
    }
    lives = {} if life is None else {name: 1e6 * getattr(life, name) for name in _LIVES}
    pressure = dict(zip(RINGS, solution.max_pressure.max(axis=0), strict=True)) if solution.method == "strips" else {}
    return SimpleNamespace(
        case=case, life=life, stiffness=stiffness, revolutions=lives,
        hours={name: life.hours(1e-6 * entry) for name, entry in lives.items()} if life and life.speed else {},
        pressure=pressure | ({"both": max(pressure.values())} if pressure else {}),
    )  # fmt: skip


def _known_of_contacts(case: BearingCase, solution: BearingSolution) -> Iterator[dict[str, Any]]:
    """Yield what is known of every roller at the inner and at the outer ring."""
    by_strips = solution.method == "strips"
    slices = [] if by_strips else slice_loads(solution, case.solver.laminae)
    of_slices = [(entry.y, load) for entry, loads in slices for load in loads]
    for j in range(solution.angle.size):
        for k, ring in enumerate(RINGS):
            known = {name: getattr(solution, name)[j, k] for name in ("load", "moment", "contact_angle")}
            if not by_strips:
                known |= {"y": of_slices[j][0], "lamina_load": of_slices[j][1][k]}
            elif (contact := solution.contact(j, ring)) is not None:
                known |= {"y": contact.y, "lamina_load": contact.line_load * contact.strip_width}
                known |= {"pressure": contact.centre_pressure, "max_pressure": solution.max_pressure[j, k]}
            yield known


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
