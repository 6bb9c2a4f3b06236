"""Writing inputs into the tables of files, by the types of their fields."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from itertools import chain
from typing import Any

from nonhertz.errors import InputError
from nonhertz.inputs.fields import Input, default_of
from nonhertz.model.material import Material
from nonhertz.model.materials import name_of
from nonhertz.model.profile import Profile, Straight, Sum, Transformed


def document_of(value: Any, *, name: str = "", defaults: bool = True) -> Any:
    """Return a value as in a file: tables, lists, numbers in base units, words.

    Parameters
    ----------
    value : object
        An input, or the value of a field of one.
    name : str
        Name of the field, for the message.
    defaults : bool
        Whether fields of an input that are at their defaults are written too.

    Raises
    ------
    InputError
        If it cannot be written, such as a profile or a diameter of a user-defined class.
    """
    if isinstance(value, Profile):
        return list(profile_tables(value))
    if isinstance(value, Input):
        return _table(value, defaults)
    if isinstance(value, Mapping):
        return {
            key: document_of(entry, name=key, defaults=defaults) for key, entry in value.items() if entry is not None
        }
    if isinstance(value, str | int):
        return value
    if hasattr(value, "__iter__"):
        return [document_of(entry, name=name, defaults=defaults) for entry in value]
    if hasattr(value, "__float__"):
        return float(value)
    table = " or a table" if name.endswith(("diameter", "bore")) else ""
    condition = f"be a number{table} to be written to a file"
    raise InputError(name, value, condition, "tabulate it, or use it only in Python")


def _table(value: Input, defaults: bool) -> dict[str, Any] | str:
    """Return the table of an input, or the name of a material that has one."""
    if isinstance(value, Material) and (name := name_of(value)):
        return name
    word = next((word for word, kind in value.kinds.items() if kind is type(value)), None)
    fields = {
        field.name: document_of(entry, name=field.name, defaults=defaults)
        for field in dataclasses.fields(value)  # type: ignore[arg-type]
        if (entry := getattr(value, field.name)) is not None and (defaults or entry != default_of(field))
    }
    return ({} if word is None else {"kind": word}) | {key: entry for key, entry in fields.items() if entry != []}


def profile_tables(profile: Profile) -> list[dict[str, Any]]:
    """Return the tables whose profiles add up to this one.

    Raises
    ------
    InputError
        If it is of a user-defined class.
    """
    if isinstance(profile, Straight):
        return []
    if profile.catalogue_entry is not None:
        kind, parameters = profile.catalogue_entry
        return [{"kind": kind} | {name: document_of(parameter) for name, parameter in parameters.items()}]
    if isinstance(profile, Sum):
        return list(chain.from_iterable(map(profile_tables, profile.parts)))
    if isinstance(profile, Transformed):
        moves: dict[str, Any] = {"scale": profile.scale, "shift": profile.shift, "flip": profile.flip}
        if isinstance(profile.profile, Sum):
            return profile_tables(Sum(tuple(part.moved(**moves) for part in profile.profile.parts)))
        usual = {"scale": 1.0, "shift": 0.0, "flip": False}
        changed = {name: value for name, value in moves.items() if value != usual[name]}
        return [table | changed for table in profile_tables(profile.profile)]
    remedy = "tabulate it: nonhertz.profile.tabulated(y, profile.relief(y))"
    raise InputError("profile", type(profile).__name__, "be from the catalogue to be written to a case file", remedy)
