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
    """Return the model in a file, XML or JSON by its content.

    Raises
    ------
    InputError
        If it cannot be read, is too large, is not REXS, or of a version before 1.4.
    """
    data, name = read_input_file("rexs", path, LARGEST)
    try:
        text = data.decode("utf-8-sig")
        model = _of_document(json.loads(text)["model"] if text.lstrip()[:1] == "{" else _xml_document(text))
    except (ValueError, TypeError, KeyError, AttributeError, OverflowError, RecursionError, ET.ParseError) as error:
        reason = str(error).partition("\n")[0][:80] or type(error).__name__
        raise InputError("rexs", name, f"be a model in REXS, as XML or JSON ({reason})", _REMEDY) from None
    version = re.match(r"(\d{1,4})\.(\d{1,4})", model.head["version"])
    if version is None or (int(version[1]), int(version[2])) < _OLDEST:
        raise InputError("rexs", name, f"be of version 1.4 or later, not {model.head['version'][:20]!r}", _REMEDY)
    return model


def _of_document(document: dict[str, Any]) -> Model:
    """Return the model of the contents of JSON below its root."""
    model = Model({"version": str(document["version"])})
    for entry in document.get("relations", ()):
        roles = [(str(ref["role"]), int(ref["id"])) for ref in entry["refs"]]
        model.relations.append((entry["type"], int(entry.get("order") or 0), roles))
    for entry in document["components"]:
        component = Component(str(entry["type"]), str(entry.get("name") or ""), _attributes(entry))
        model.components[int(entry["id"])] = component
    model.load_cases += _load_cases(document)
    return model


def _load_cases(document: dict[str, Any]) -> Iterator[dict[int, Attributes]]:
    spectra = document.get("load_spectrum") or ()
    for spectrum in [spectra] if isinstance(spectra, dict) else spectra:
        for case in spectrum["load_cases"]:
            yield {int(entry["id"]): _attributes(entry) for entry in case["components"]}


def _attributes(component: dict[str, Any]) -> Attributes:
    return {str(entry["id"]): (_value(entry), str(entry.get("unit") or "")) for entry in component["attributes"]}


def _value(attribute: dict[str, Any]) -> Any:
    """Return the value of an attribute of JSON, which is under the name of its type."""
    return next((value for name, value in attribute.items() if name not in ("id", "unit")), None)


def _xml_document(text: str) -> dict[str, Any]:
    """Return the contents below the root of JSON for the same model."""
    if "<!DOCTYPE" in text or "<!ENTITY" in text:  # which could make a small file fill the memory
        raise ValueError("it has a document type")
    root = ET.fromstring(text)
    if _tag(root) != "model":
        raise ValueError(f"its root is {_tag(root)[:40]!r}, not 'model'")
    relations = [
        dict(entry.attrib, refs=[ref.attrib for ref in entry]) for entry in root.iter() if _tag(entry) == "relation"
    ]
    cases = [
        {"components": _xml_components(case)}
        for spectrum in root if _tag(spectrum) == "load_spectrum" for case in spectrum if _tag(case) == "load_case"
    ]  # fmt: skip
    components = [entry for above in root if _tag(above) == "components" for entry in _xml_components(above)]
    spectrum = {"load_cases": cases}
    return dict(root.attrib, relations=relations, components=components, load_spectrum=spectrum)


def _xml_components(above: ET.Element) -> list[dict[str, Any]]:
    return [
        dict(component.attrib, attributes=[dict(entry.attrib, value=_xml_value(entry)) for entry in component])
        for component in above
    ]


def _xml_value(attribute: ET.Element) -> str | list[str]:
    arrays = [entry for entry in attribute if _tag(entry) == "array"]
    return [entry.text or "" for entry in arrays[0]] if arrays else (attribute.text or "").strip()


def _tag(element: ET.Element) -> str:
    return element.tag.rpartition("}")[2]


def as_json(model: Model) -> str:
    """Return a model as JSON."""
    return json.dumps({"model": model.head | _document(model)}, indent=1, ensure_ascii=False) + "\n"


def as_xml(model: Model) -> str:
    """Return a model as XML."""
    document, root = _document(model), ET.Element("model", model.head)
    relations = ET.SubElement(root, "relations")
    for relation in document["relations"]:
        element = _add(relations, "relation", relation)
        for ref in relation["refs"]:
            _add(element, "ref", ref)
    _add_components(ET.SubElement(root, "components"), document)
    if model.load_cases:
        spectrum = _add(root, "load_spectrum", document["load_spectrum"])
        for case in document["load_spectrum"]["load_cases"]:
            _add_components(_add(spectrum, "load_case", case), case)
    ET.indent(root)
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{ET.tostring(root, encoding="unicode")}\n'


def _add(above: ET.Element, tag: str, entry: dict[str, Any]) -> ET.Element:
    """Add an element with the values of an entry that are not lists."""
    return ET.SubElement(above, tag, {name: str(value) for name, value in entry.items() if not isinstance(value, list)})


def _add_components(above: ET.Element, document: dict[str, Any]) -> None:
    for component in document["components"]:
        element = _add(above, "component", component)
        for entry in component["attributes"]:
            attribute, value = (
                ET.SubElement(element, "attribute", {"id": entry["id"], "unit": entry["unit"]}),
                _value(entry),
            )
            if isinstance(value, list):
                array = ET.SubElement(attribute, "array")
                for number in value:
                    ET.SubElement(array, "c").text = repr(number)
            else:
                attribute.text = json.dumps(value) if isinstance(value, bool) else str(value)


def _document(model: Model) -> dict[str, Any]:
    """Return a model as the contents of JSON below its root."""
    relations = [
        {"id": number, "type": type_}
        | ({} if order is None else {"order": order})
        | {"refs": [{"id": other, "role": role, "hint": model.components[other].type} for role, other in roles]}
        for number, (type_, order, roles) in enumerate(model.relations, start=1)
    ]
    attributes = {number: component.attributes for number, component in model.components.items()}
    cases = [
        {"id": number, "components": _list_components(model, case)}
        for number, case in enumerate(model.load_cases, start=1)
    ]
    spectrum = {"load_spectrum": {"id": 1, "load_cases": cases}} if cases else {}
    return {"relations": relations, "components": _list_components(model, attributes)} | spectrum


def _list_components(model: Model, attributes: dict[int, Attributes]) -> list[dict[str, Any]]:
    """Return components that have attributes in the model itself or in a load case, in their order."""
    return [
        {"id": number, "type": component.type}
        | ({"name": component.name} if component.name else {})
        | {"attributes": [_typed_attribute(name, *attribute) for name, attribute in attributes[number].items()]}
        for number, component in model.components.items()
        if number in attributes
    ]


_ENUMS: Final = re.compile("_type$|_class$|absorption|^position|^kind$")


def _typed_attribute(name: str, value: Any, unit: str) -> dict[str, Any]:
    """Return an attribute of JSON, with its value under the name of its type."""
    types = {bool: "boolean", int: "integer", float: "floating_point", list: "floating_point_array"}
    word = "enum" if isinstance(value, str) and _ENUMS.search(name) else types.get(type(value), "string")
    return {"id": name, "unit": unit, word: value}
