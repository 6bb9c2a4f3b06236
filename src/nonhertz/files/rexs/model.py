"""A REXS model as components, relations and load cases: from XML and JSON, and to both."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Final
from xml.etree import ElementTree as ET

from nonhertz.errors import InputError
from nonhertz.inputs.files import read_input_file

LARGEST: Final = 50_000_000  # bytes
VERSION: Final = "1.4"
_OLDEST: Final = (1, 4)
_REMEDY: Final = "export the model as REXS 1.4 or later, .rexs or .rexs.json"
Value = tuple[Any, str]
Attributes = dict[str, Value]


@dataclass
class Component:
    """A component: its type and name, and its attributes with their units."""

    type: str
    name: str = ""
    attributes: Attributes = field(default_factory=dict)


@dataclass
class Model:
    """Components by number, relations as types with roles and numbers, and attributes of load cases by component."""

    head: dict[str, str]
    components: dict[int, Component] = field(default_factory=dict)
    relations: list[tuple[str, int | None, list[tuple[str, int]]]] = field(default_factory=list)
    load_cases: list[dict[int, Attributes]] = field(default_factory=list)

    def add(self, kind: str, name: str = "", attributes: Attributes | None = None) -> int:
        """Add a component, and return its number."""
        self.components[len(self.components) + 1] = Component(kind, name, attributes or {})
        return len(self.components)

    def relate(self, kind: str, order: int | None = None, /, **roles: int) -> None:
        """Add a relation of components by their roles."""
        self.relations.append((kind, order, list(roles.items())))

    def parts(self, whole: int, kind: str) -> list[int]:
        """Return the numbers of the components of a type that a component has, or refers to, in their order."""
        ordered = [
            (order or 0, dict(roles))
            for _, order, roles in self.relations
            if ("assembly", whole) in roles or ("origin", whole) in roles
        ]
        numbers = [
            roles.get("part", roles.get("referenced")) for _, roles in sorted(ordered, key=lambda entry: entry[0])
        ]
        return [entry for entry in numbers if entry in self.components and self.components[entry].type == kind]


def read_model(path: str | Path) -> Model:
    """Return the model in a file, XML or JSON by what it holds.

    Raises
    ------
    InputError
        If it cannot be read, is too large, no REXS, or of a version before 1.4.
    """
    data, name = read_input_file("rexs", path, LARGEST)
    try:
        text = data.decode("utf-8-sig")
        model = _of_json(text) if text.lstrip()[:1] == "{" else _of_xml(text)
    except (ValueError, TypeError, KeyError, AttributeError, OverflowError, RecursionError, ET.ParseError) as error:
        reason = str(error).partition("\n")[0][:80] or type(error).__name__
        raise InputError("rexs", name, f"be a model in REXS, as XML or JSON ({reason})", _REMEDY) from None
    version = re.match(r"(\d{1,4})\.(\d{1,4})", model.head["version"])
    if version is None or (int(version[1]), int(version[2])) < _OLDEST:
        raise InputError("rexs", name, f"be of version 1.4 or later, not {model.head['version'][:20]!r}", _REMEDY)
    return model


def _of_xml(text: str) -> Model:
    if "<!DOCTYPE" in text or "<!ENTITY" in text:  # which could make a small file fill the memory
        raise ValueError("it has a document type")
    root = ET.fromstring(text)
    if _tag(root) != "model":
        raise ValueError(f"its root is {_tag(root)[:40]!r}, not 'model'")

    def attributes(element: ET.Element) -> Attributes:
        return {entry.attrib["id"]: ((entry.text or "").strip(), entry.get("unit", "")) for entry in element}

    model = Model({"version": root.attrib["version"]})
    for entry in root.iter():
        if _tag(entry) == "relation":
            roles = [(ref.attrib["role"], int(ref.attrib["id"])) for ref in entry]
            model.relations.append((entry.attrib["type"], int(entry.get("order", 0)), roles))
    for outer in root:
        if _tag(outer) == "components":
            for entry in outer:
                component = Component(entry.attrib["type"], entry.get("name", ""), attributes(entry))
                model.components[int(entry.attrib["id"])] = component
        elif _tag(outer) == "load_spectrum":
            cases = [entry for entry in outer if _tag(entry) == "load_case"]
            model.load_cases += [{int(entry.attrib["id"]): attributes(entry) for entry in case} for case in cases]
    return model


def _tag(element: ET.Element) -> str:
    return element.tag.rpartition("}")[2]


def _of_json(text: str) -> Model:
    root = json.loads(text)["model"]

    def attributes(entries: list[dict[str, Any]]) -> Attributes:
        values = {}
        for entry in entries:
            value = next((value for name, value in entry.items() if name not in ("id", "unit")), None)
            values[str(entry["id"])] = value, str(entry.get("unit") or "")
        return values

    model = Model({"version": str(root["version"])})
    for entry in root.get("relations", ()):
        roles = [(str(ref["role"]), int(ref["id"])) for ref in entry["refs"]]
        model.relations.append((entry["type"], int(entry.get("order") or 0), roles))
    for entry in root["components"]:
        component = Component(str(entry["type"]), str(entry.get("name") or ""), attributes(entry["attributes"]))
        model.components[int(entry["id"])] = component
    spectra = root.get("load_spectrum") or ()
    for spectrum in [spectra] if isinstance(spectra, dict) else spectra:
        for case in spectrum["load_cases"]:
            model.load_cases.append({int(entry["id"]): attributes(entry["attributes"]) for entry in case["components"]})
    return model


def as_xml(model: Model) -> str:
    """Return a model as XML."""
    root = ET.Element("model", model.head)
    relations = ET.SubElement(root, "relations")
    for number, (type_, order, roles) in enumerate(model.relations, start=1):
        placed = {} if order is None else {"order": str(order)}
        relation = ET.SubElement(relations, "relation", {"id": str(number), "type": type_} | placed)
        for role, other in roles:
            hint = model.components[other].type
            ET.SubElement(relation, "ref", {"id": str(other), "role": role, "hint": hint})

    def write(above: ET.Element, entries: Iterator[tuple[int, Component, Attributes]]) -> None:
        for number, component, attributes in entries:
            named = {"name": component.name} if component.name else {}
            element = ET.SubElement(above, "component", {"id": str(number), "type": component.type} | named)
            for name, (value, unit) in attributes.items():
                attribute = ET.SubElement(element, "attribute", {"id": name, "unit": unit})
                if isinstance(value, list):
                    array = ET.SubElement(attribute, "array")
                    for entry in value:
                        ET.SubElement(array, "c").text = repr(entry)
                else:
                    attribute.text = json.dumps(value) if isinstance(value, bool) else str(value)

    write(ET.SubElement(root, "components"), _components(model))
    if model.load_cases:
        spectrum = ET.SubElement(root, "load_spectrum", {"id": "1"})
        for number, case in enumerate(model.load_cases, start=1):
            write(ET.SubElement(spectrum, "load_case", {"id": str(number)}), _components(model, case))
    ET.indent(root)
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{ET.tostring(root, encoding="unicode")}\n'


def as_json(model: Model) -> str:
    """Return a model as JSON."""

    def components(entries: Iterator[tuple[int, Component, Attributes]]) -> list[dict[str, Any]]:
        return [
            {"id": number, "type": component.type}
            | ({"name": component.name} if component.name else {})
            | {"attributes": [_typed(name, *attribute) for name, attribute in attributes.items()]}
            for number, component, attributes in entries
        ]

    relations = [
        {"id": number, "type": type_}
        | ({} if order is None else {"order": order})
        | {"refs": [{"id": other, "role": role, "hint": model.components[other].type} for role, other in roles]}
        for number, (type_, order, roles) in enumerate(model.relations, start=1)
    ]
    cases = [
        {"id": number, "components": components(_components(model, case))}
        for number, case in enumerate(model.load_cases, start=1)
    ]
    body = model.head | {"relations": relations, "components": components(_components(model))}
    spectrum = {"load_spectrum": {"id": 1, "load_cases": cases}} if cases else {}
    return json.dumps({"model": body | spectrum}, indent=1, ensure_ascii=False) + "\n"


def _components(model: Model, case: dict[int, Attributes] | None = None) -> Iterator[tuple[int, Component, Attributes]]:
    for number, component in model.components.items():
        if case is None:
            yield number, component, component.attributes
        elif number in case:
            yield number, component, case[number]


_ENUMS: Final = re.compile("_type$|_class$|absorption|^position|^kind$")


def _typed(name: str, value: Any, unit: str) -> dict[str, Any]:
    """Return an attribute of JSON, whose value stands under its type."""
    types = {bool: "boolean", int: "integer", float: "floating_point", list: "floating_point_array"}
    word = "enum" if isinstance(value, str) and _ENUMS.search(name) else types.get(type(value), "string")
    return {"id": name, "unit": unit, word: value}
