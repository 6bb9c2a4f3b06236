"""A document out of the form's HTML, by the rules that the page's own script follows."""

import json
import re
from html.parser import HTMLParser
from typing import Any

ABSENT = object()
NUMBERS = ("quantity", "integer-or-word")
PLAIN_NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?")
PART = re.compile(r'\.?([A-Za-z0-9_-]+)|\.?("(?:[^"\\]|\\.)*")|\[(\d+)\]')


class Inputs(HTMLParser):
    """The inputs of a form in the order of the page, as attributes with their values; options with those of theirs."""

    def __init__(self, html: str) -> None:
        super().__init__()
        self.found: list[dict[str, Any]] = []
        self.options: list[dict[str, Any]] = []
        self._select: dict[str, Any] | None = None
        self.feed(html)

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        values: dict[str, Any] = dict(attributes)
        if tag == "select":
            self._select = values | {"value": None}
            self.found.append(self._select)
        elif tag == "option" and self._select is not None:
            self.options.append(values | {"select": self._select})
            if "selected" in values or self._select["value"] is None:
                self._select["value"] = values["value"]
        elif tag in {"input", "button"}:
            self.found.append(values)

    def handle_endtag(self, tag: str) -> None:
        if tag == "select":
            self._select = None

    @property
    def fields(self) -> list[dict[str, Any]]:
        """Those that stand for a key of the document."""
        return [each for each in self.found if "data-kind" in each]


def document_in(html: str) -> dict[str, Any]:
    """Return the document that a form shows."""
    document: dict[str, Any] = {}
    found = Inputs(html)
    units = {each["data-unit-of"]: each["value"] for each in found.found if "data-unit-of" in each}
    for each in found.fields:
        value = value_of(each["data-kind"], each["value"])
        if each.get("data-stands-for"):
            value = json.loads(each["data-stands-for"])
        elif isinstance(value, float) and units.get(each.get("id"), each.get("data-unit")) != each.get("data-unit"):
            value = f"{each['value'].strip()} {units[each['id']]}"
        if value is not ABSENT:
            set_at(document, each["name"], value)
    return document


def value_of(kind: str, text: str) -> Any:
    """Return what the text in an input stands for."""
    text = text.strip()
    if not text:
        return ABSENT
    readers = {"list": listed, "json": json_or_text, "hidden-json": json.loads, "boolean": "true".__eq__}
    return readers.get(kind, number_or_text if kind in NUMBERS else str)(text)


def listed(text: str) -> Any:
    return json.loads(text) if text.startswith("[") else [number_or_text(each) for each in text.split()]


def json_or_text(text: str) -> Any:
    try:
        return json.loads(text)
    except ValueError:
        return text


def number_or_text(text: str) -> Any:
    return json.loads(json.dumps(float(text))) if PLAIN_NUMBER.fullmatch(text) else text


def parts_of(path: str) -> list[str | int]:
    """Return the keys and positions, from 0, in a path."""
    parts: list[str | int] = []
    end = 0
    for found in PART.finditer(path):
        assert found.start() == end, path
        end = found.end()
        bare, quoted, position = found.groups()
        parts.append(int(position) - 1 if position else bare if bare is not None else json.loads(quoted))
    assert end == len(path), path
    return parts


def set_at(document: Any, path: str, value: Any) -> None:
    """Set, or with None delete, what stands at a path; tables on the way are made."""
    *way, last = parts_of(path)
    for part in way:
        if isinstance(part, str) and part not in document:
            document[part] = {}
        document = document[part]
    if value is None:
        del document[last]
    elif isinstance(document, list) and last == len(document):
        document.append(value)
    else:
        document[last] = value
