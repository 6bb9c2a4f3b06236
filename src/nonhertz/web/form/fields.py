"""The building blocks of a form: fields with their texts, and groups of fields."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from typing import Any, Final

from nonhertz.web.form.ranges import Range
from nonhertz.web.form.units import Unit, in_figures

Edits = list[tuple[str, Any]]

_MOST_BITS: Final = 1023
_PLAIN_NUMBER: Final = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?")


@dataclass(frozen=True)
class Option:
    """An option: its word, and what else changes in the document when it is chosen."""

    value: str
    label: str
    edits: Edits = field(default_factory=list)

    @property
    def edits_text(self) -> str:
        """The edits as JSON; empty if only the word is set."""
        return json.dumps(self.edits) if self.edits else ""


@dataclass(frozen=True)
class FormField:
    """One input.

    Attributes
    ----------
    path : str
        The key, such as ``"body.a.profile[1].radius"``.
    label, help, unit : str
        The texts beside it.
    kind : str
        How text maps to a value: ``"quantity"`` and ``"integer-or-word"`` (a plain number, else text), ``"list"``
        (of these, separated by blanks, or JSON), ``"text"``, ``"choice"``, ``"boolean"``, ``"json"`` (JSON if valid,
        else text), ``"hidden-json"``. If the text is empty, the key is left out.
    value : str
        The text in it; of a quantity with units, the number in the one that is chosen.
    units, word : tuple of Unit, str
        The units to choose from, and the one that is chosen.
    stands_for : str
        The value in the document as JSON, where it is not what the text in its unit would say.
    default : str
        What leaving it empty means.
    options : tuple of Option
        Choices, or suggested words.
    slider : Range or None
        That of a slider, for numbers.
    structural : bool
        Whether changing it changes the form.
    removable : bool
        Whether it has a button to remove it, being unknown.
    """

    path: str
    label: str
    kind: str
    value: str
    help: str = ""
    unit: str = ""
    default: str = ""
    options: tuple[Option, ...] = ()
    slider: Range | None = None
    units: tuple[Unit, ...] = ()
    word: str = ""
    stands_for: str = ""
    structural: bool = False
    removable: bool = False

    @property
    def size(self) -> str:
        """How long a list or a text is that is not shown."""
        value = json.loads(self.value)
        return f"{len(value)} {'letters' if isinstance(value, str) else 'numbers'}"

    @property
    def id(self) -> str:
        """An HTML identifier, the same every time the form is made."""
        return "field-" + "".join(c if c.isascii() and c.isalnum() else f"-{ord(c):x}" for c in self.path)


@dataclass(frozen=True)
class FormGroup:
    """Fields that belong together: a table of the document, or a list of tables.

    Attributes
    ----------
    path, label, help : str
        As for a `FormField`.
    members : tuple
        Fields and groups.
    folded : tuple
        More of them, shown on demand.
    base : str
        An empty table or list as JSON if the document has this one, whatever is in it; an empty string if it does not.
    removable : bool
        Whether it is an entry of a list, which can be removed.
    additions : tuple of Option
        What can be added to it.
    optional : bool
        Whether it is left out where all of its keys are.
    """

    path: str
    label: str
    members: tuple[FormField | FormGroup, ...]
    help: str = ""
    folded: tuple[FormField | FormGroup, ...] = ()
    base: str = ""
    removable: bool = False
    additions: tuple[Option, ...] = ()
    optional: bool = False

    @property
    def fields(self) -> Iterator[FormField]:
        """All fields, at any depth."""
        for member in (*self.members, *self.folded):
            if isinstance(member, FormField):
                yield member
            else:
                yield from member.fields


def text_in(kind: str, value: Any) -> str | None:
    """Return the text of a value in a field; None if this kind of field cannot hold it."""
    match kind:
        case "quantity" | "integer-or-word":
            return number_or_words(value)
        case "list":
            return _listed(value)
        case "boolean":
            return json.dumps(value) if isinstance(value, bool) else None
        case "json":
            return json.dumps(value)
    return value if isinstance(value, str) and value and value == value.strip() and "\n" not in value else None


def number_or_words(value: Any) -> str | None:
    """Return the text of a number, or text that cannot be mistaken for a number; None for anything else."""
    if isinstance(value, bool):
        return None
    if isinstance(value, int | float):
        return in_figures(value) if is_number(value) else None
    fits = isinstance(value, str) and value and value == value.strip() and "\n" not in value
    return value if fits and not _PLAIN_NUMBER.fullmatch(value) else None


def is_number(value: int | float) -> bool:
    """Return whether a number is finite and, if an integer, fits into a float."""
    return value.bit_length() <= _MOST_BITS if isinstance(value, int) else math.isfinite(value)


def _listed(value: Any) -> str | None:
    """Return entries separated by blanks, or as JSON if they contain blanks themselves."""
    if not isinstance(value, list):
        return None
    texts = [number_or_words(entry) for entry in value]
    if not value or any(text is None or " " in text or text.startswith("[") for text in texts):
        return json.dumps(value)
    return " ".join(str(text) for text in texts)


def options_of(words: Iterable[str]) -> tuple[Option, ...]:
    """Return words as choices or suggestions."""
    return tuple(Option(word, word) for word in words)
