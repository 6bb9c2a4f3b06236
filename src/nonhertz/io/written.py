"""A case as the document of a case file: every value in base units, nothing left to a default.

`nonhertz.io.casefile.case_in` reads it back as the same case. It contains the points of measured and tabulated
profiles, so it needs no other file.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

from nonhertz.errors import InputError
from nonhertz.io.bounds import FORMAT
from nonhertz.model.body import Body, TabulatedDiameter
from nonhertz.model.material import Material
from nonhertz.model.materials import MATERIALS
from nonhertz.model.profile import Flipped, Profile, Scaled, Shifted, Straight, Sum

if TYPE_CHECKING:
    from nonhertz.io.casefile import Case, LifeCase
    from nonhertz.model.contact import Contact


def document(case: Case) -> dict[str, Any]:
    """Return a case as the document of a case file.

    Raises
    ------
    InputError
        If no case file can hold it: a profile or diameter of a user-defined class, or strips given by their edges.
    """
    found: dict[str, Any] = {"format": FORMAT} | ({"title": case.title} if case.title else {})
    found["body"] = bodies(case.contact)
    found["load"] = {name: float(value) for name, value in case.prescribed.items()}
    found["solver"] = _solver(case.solver)
    life = _life(case.life)
    block = case.title_block.table
    return found | ({"life": life} if life else {}) | ({"report": block} if block else {})


def bodies(contact: Contact) -> dict[str, Any]:
    """Return the tables of both bodies."""
    found = {}
    for name, body in (("a", contact.a), ("b", contact.b)):
        try:
            found[name] = body_table(body)
        except InputError as error:
            raise error.within(f"body.{name}") from None
    return found


def body_table(body: Body) -> dict[str, Any]:
    """Return the table of a body."""
    table: dict[str, Any] = {"kind": type(body).__name__.lower()}
    for name, value in (("diameter", body.diameter), ("bore", body.bore)):
        if value is not None:
            table[name] = _diameter(name, value)
    for name in ("length", "effective_length", "corner_radius", "position", "case_depth"):
        value = getattr(body, name)
        if value is not None:
            table[name] = float(value)
    if body.chamfer is not None:
        table["chamfer"] = {name: float(value) for name, value in asdict(body.chamfer).items()}
    table["material"] = material_table(body.material)
    profiles = list(profile_tables(body.profile))
    if profiles:
        table["profile"] = profiles
    for name in ("side_faces", "images", "depth"):
        if getattr(body, name) is not None:
            table[name] = _plain(getattr(body, name))
    return table


def _diameter(name: str, value: object) -> float | dict[str, Any]:
    if isinstance(value, TabulatedDiameter):
        return {"y": _plain(value.y), "diameter": _plain(value.diameter)}
    if isinstance(value, float | int):
        return float(value)
    remedy = "give a TabulatedDiameter of its values"
    raise InputError(name, value, "be a number or a table to go into a case file", remedy)


def material_table(material: Material) -> str | dict[str, float | str]:
    """Return the name of a material, or what is known of it."""
    named = [name for name, known in MATERIALS.items() if known == material]
    if named:
        return named[0]
    known = {name: value for name, value in asdict(material).items() if value is not None}
    return {name: value if isinstance(value, str) else float(value) for name, value in known.items()}


def profile_tables(profile: Profile) -> list[dict[str, Any]]:
    """Return the tables whose profiles add up to this one.

    Raises
    ------
    InputError
        If it is of a user-defined class.
    """
    entry = profile.catalogue_entry
    if entry is not None:
        kind, parameters = entry
        table = {"kind": kind} | {name: _plain(each) for name, each in parameters.items()}
        return [] if kind == "straight" else [table]
    if isinstance(profile, Straight):
        return []
    if isinstance(profile, Sum):
        return [table for part in profile.parts for table in profile_tables(part)]
    if isinstance(profile, Shifted):
        return [_shifted(table, profile.by) for table in profile_tables(profile.profile)]
    if isinstance(profile, Flipped):
        return [_flipped(table) for table in profile_tables(profile.profile)]
    if isinstance(profile, Scaled):
        return [table | {"scale": table.get("scale", 1.0) * profile.by} for table in profile_tables(profile.profile)]
    remedy = "tabulate it: nonhertz.profile.tabulated(y, profile.relief(y))"
    raise InputError("profile", type(profile).__name__, "be from the catalogue to go into a case file", remedy)


def _shifted(table: dict[str, Any], by: float) -> dict[str, Any]:
    # A table is flipped last, after its shift.
    return table | {"shift": table.get("shift", 0.0) + (-by if table.get("flip") else by)}


def _flipped(table: dict[str, Any]) -> dict[str, Any]:
    rest = {name: value for name, value in table.items() if name != "flip"}
    return rest if "flip" in table else rest | {"flip": True}


def _solver(options: Mapping[str, Any]) -> dict[str, Any]:
    strips = options.get("strips")
    if not (strips is None or isinstance(strips, str | int)):
        raise InputError("strips", "edges", "be 'auto' or a number to go into a case file", "give the number of strips")
    element = options.get("element")
    name = "semi-elliptic" if element is None else element.name
    accuracy = options.get("accuracy")
    aimed = {} if accuracy is None else {"accuracy": accuracy}
    return {"element": name, "strips": "auto" if strips is None else strips, **aimed}


def _life(life: LifeCase) -> dict[str, Any]:
    found = {
        "rollers": life.rollers,
        "contact_angle": life.contact_angle,
        "models": list(life.names),
        **life.parameters,
        "dent": life.dent,
    }
    found["spectrum"] = [
        {"load": float(each.load), "share": float(each.share), "tilt": float(each.tilt)} for each in life.spectrum
    ]
    return {name: value for name, value in found.items() if value is not None and value != []}


def _plain(value: Any) -> Any:
    """Return strings, booleans and numbers as plain TOML and JSON values, and sequences of them as lists."""
    if isinstance(value, str | bool):
        return value
    if isinstance(value, int):
        return int(value)
    if hasattr(value, "__iter__"):
        return [_plain(each) for each in value]
    return float(value)
