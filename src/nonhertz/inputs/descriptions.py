"""Descriptions of the fields of inputs: unit, meaning, condition and remedy, with check and JSON schema of a value."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any, Protocol, TypeVar

from nonhertz.errors import InputError, InputsError, UnknownKeyError, nearest
from nonhertz.inputs.checks import above_zero, finite, flag, is_number, not_negative, numbers, one_of, positive, whole
from nonhertz.inputs.units import begins_with_digits, to_unit

Read = TypeVar("Read")
#: A check of a value, given its name, the value and the remedy: raises `InputError`, or returns what to keep, if any.
Condition = Callable[[str, Any, str], Any]


class Description(Protocol):
    """Description of a field, which stands beside its type in ``Annotated``.

    ``meaning``, ``condition``, ``remedy`` and ``words`` of all kinds are those of `Quantity`.
    """

    @property
    def meaning(self) -> str:
        """Meaning of the field, a clause without a full stop."""

    def validate(self, name: str, value: Any) -> Any:
        """Return the value to keep for an input, or raise `InputError`."""

    def schema(self) -> dict[str, Any]:
        """Return the JSON schema of its value in a file, except for tables, without the meaning."""


def collect_errors(name: str, entries: Iterable[Any], convert: Callable[[int, Any], Read]) -> list[Read]:
    """Return the converted entries of a field; ``convert`` takes their numbers, from 1, and values.

    Raises
    ------
    InputsError
        With the errors of all entries, each under the name of its entry, ``name[1]``.
    """
    values: list[Read] = []
    errors: list[InputError] = []
    for number, entry in enumerate(entries, start=1):
        try:
            values.append(convert(number, entry))
        except InputError as error:
            errors += error.within(f"{name}[{number}]").each
    if errors:
        raise InputsError(errors)
    return values


@dataclass(frozen=True)
class Quantity:
    """A number in a unit; as text it may have another unit, and some words may replace it.

    Attributes
    ----------
    unit : str
        As in `nonhertz.inputs.units.to_unit`, ``""`` for a plain number.
    meaning : str
        Meaning of the field, a clause without a full stop.
    condition : callable
        Its check.
    remedy : str
        What to do about a value that fails it, a clause without a full stop.
    words : mapping of str to object
        Words allowed in place of the number, with their meanings: text, or an object with a ``meaning``.
    """

    unit: str
    meaning: str
    condition: Condition = finite
    remedy: str = "write a number, or text with a unit"
    words: Mapping[str, Any] = field(default_factory=dict)

    def validate(self, name: str, value: Any) -> Any:
        """Return the number in the unit, or a word in its place."""
        if self.words and not (begins_with_digits(value) if isinstance(value, str) else is_number(value)):
            number = f"a number{f' in {self.unit}' if self.unit else ''}"
            return _validate_word(name, value, self.words, number, self.remedy)
        value = to_unit(name, value, self.unit)
        checked = self.condition(name, value, self.remedy)
        return value if checked is None else checked

    def schema(self) -> dict[str, Any]:
        """Return the schema of a number, text with a unit, or a word."""
        number: dict[str, Any] = {"type": "number"}
        if self.condition in (positive, above_zero):
            number["exclusiveMinimum"] = 0
        elif self.condition is not_negative:
            number["minimum"] = 0
        text = [{"type": "string"} | ({"pattern": "[0-9]"} if self.words else {})] if self.unit else []
        words = [{"enum": list(self.words)}] if self.words else []
        kinds: list[dict[str, Any]] = [*words, number, *text]
        return (number if len(kinds) == 1 else {"anyOf": kinds}) | ({"unit": self.unit} if self.unit else {})


@dataclass(frozen=True)
class OneOrTwo:
    """A quantity, or a pair of them.

    Attributes
    ----------
    item : Quantity
        Description of both.
    names : pair of str
        What distinguishes them.
    single : int or None
        Which of the two a single value is; None for both.
    """

    item: Quantity
    meaning: str
    names: tuple[str, str]
    single: int | None = None

    def validate(self, name: str, value: Any) -> Any:
        """Return the number or word, or two of them."""
        values = value.tolist() if hasattr(value, "tolist") else value
        if not isinstance(values, list | tuple):
            return self.item.validate(name, values)
        if len(values) != 2:
            raise InputError(name, value, "be one value or two", self.item.remedy)
        return tuple(collect_errors(name, values, lambda _, value: self.item.validate("", value)))

    def schema(self) -> dict[str, Any]:
        """Return the schema of one or two."""
        one = self.item.schema()
        both = {"type": "array", "items": one, "minItems": 2, "maxItems": 2}
        return one | {"anyOf": [*one.get("anyOf", [one]), both]}


@dataclass(frozen=True)
class Quantities:
    """Several numbers in a unit."""

    unit: str
    meaning: str

    def validate(self, name: str, value: Any) -> tuple[float, ...]:
        """Return the numbers in the unit."""
        remedy = f"give a list of numbers in {self.unit}"
        if isinstance(value, list | tuple):
            value = type(value)(to_unit(name, entry, self.unit) if isinstance(entry, str) else entry for entry in value)
            if any(isinstance(entry, bool) for entry in value):  # to arrays they are numbers
                raise InputError(name, value, "be real numbers", remedy)
        row = numbers(name, value, remedy)
        if row.ndim != 1:
            raise InputError(name, value, "be a row of numbers", remedy)
        return tuple(row.tolist())

    def schema(self) -> dict[str, Any]:
        """Return the schema of a list."""
        return {"type": "array", "items": Quantity(self.unit, "").schema(), "minItems": 2}


@dataclass(frozen=True)
class Word:
    """A word from a list, or any text that meets its condition.

    Attributes
    ----------
    words : tuple of str
        The allowed words; empty for any text.
    noun : str
        Collective name of the words, if they are too many to list in a sentence.
    """

    meaning: str
    remedy: str = ""
    words: tuple[str, ...] = ()
    condition: Condition | None = None
    noun: str = ""

    def validate(self, name: str, value: Any) -> Any:
        """Return the word."""
        if self.noun and not (isinstance(value, str) and value in self.words):
            raise unknown_word_error(name, value, self.noun, self.words, self.remedy)
        if self.words:
            one_of(name, value, self.words, self.remedy)
        checked = self.condition(name, value, self.remedy) if self.condition else None
        return value if checked is None else checked

    def schema(self) -> dict[str, Any]:
        """Return the schema of the words, or of any text."""
        return {"enum": list(self.words)} if self.words else {"type": "string"}


@dataclass(frozen=True)
class Part:
    """An input within another, or of a class of its own kind; some have names.

    Attributes
    ----------
    of : type
        Its class.
    remedy : str
        How to make one.
    named : mapping
        Inputs that can be given by name.
    likely : callable or None
        Returns the class from the fields of a table without a kind; ``of`` if left out.
    noun : str
        Collective name of the names; that of the class if left out.
    """

    meaning: str
    of: type
    remedy: str
    named: Mapping[str, Any] = field(default_factory=dict)
    likely: Callable[[Mapping[str, Any]], type[Any]] | None = None
    noun: str = ""

    def validate(self, name: str, value: Any) -> Any:
        """Return the input, looked up if given by name."""
        if self.named and isinstance(value, str):
            if value not in self.named:
                raise unknown_word_error(name, value, self.noun or self.of.__name__.lower(), self.named, self.remedy)
            return self.named[value]
        if not isinstance(value, self.of):
            article = "an" if self.of.__name__[0] in "AEIOU" else "a"
            named = " or the name of one" if self.named else ""
            raise InputError(name, value, f"be {article} {self.of.__name__}{named}", self.remedy)
        return value

    def schema(self) -> dict[str, Any]:
        """Return the schema of a name."""
        return {"type": "string"}


@dataclass(frozen=True)
class Count:
    """A whole number; some words may replace it.

    Attributes
    ----------
    least : int
        The smallest.
    most : float
        The largest, infinite for any.
    """

    meaning: str
    least: int
    most: float
    remedy: str
    words: Mapping[str, Any] = field(default_factory=dict)

    def validate(self, name: str, value: Any) -> int | str:
        """Return the number, or a word in its place."""
        counted = is_number(value) and self.least <= value <= self.most and float(value).is_integer()
        if self.words and not counted:
            bounds = f"of at least {self.least}" if math.isinf(self.most) else f"from {self.least} to {self.most:g}"
            return _validate_word(name, value, self.words, f"a whole number {bounds}", self.remedy)
        return whole(name, value, self.least, self.most, self.remedy)

    def schema(self) -> dict[str, Any]:
        """Return the schema of a whole number, or a word."""
        number: dict[str, Any] = {"type": "integer", "minimum": self.least}
        if not math.isinf(self.most):
            number["maximum"] = self.most
        return {"anyOf": [{"enum": list(self.words)}, number]} if self.words else number


@dataclass(frozen=True)
class Flag:
    """True or False."""

    meaning: str
    remedy: str = "write true or false, without quotes"

    def validate(self, name: str, value: Any) -> bool:
        """Return the value."""
        flag(name, value, self.remedy)
        return bool(value)

    def schema(self) -> dict[str, Any]:
        """Return the schema of either."""
        return {"type": "boolean"}


@dataclass(frozen=True)
class OrFlag:
    """True or False, or a value of another kind.

    Attributes
    ----------
    item : Described
        Description of the other kind.
    """

    item: Description
    meaning: str

    def validate(self, name: str, value: Any) -> Any:
        """Return either."""
        if isinstance(value, bool):
            return value
        try:
            return self.item.validate(name, value)
        except InputError as error:
            condition = re.sub("^be ", "be true or false, or ", error.condition)
            raise InputError(name, error.value, condition, error.remedy) from None

    def schema(self) -> dict[str, Any]:
        """Return the schema of either."""
        other = self.item.schema()
        either = {"anyOf": [{"type": "boolean"}, *other.get("anyOf", [other])]}
        return either | ({"unit": other["unit"]} if "unit" in other else {})


@dataclass(frozen=True)
class Several:
    """Several words without repeats, or several inputs of one class.

    Attributes
    ----------
    item : Word or Part
        What one of them is; its meaning and remedy are those of all.
    most : int
        The largest number of them.
    """

    item: Word | Part
    most: int

    @property
    def meaning(self) -> str:
        """Meaning of the entries."""
        return self.item.meaning

    @property
    def of(self) -> type | None:
        """The class of the inputs; None for words."""
        return self.item.of if isinstance(self.item, Part) else None

    def validate(self, name: str, value: Any) -> tuple[Any, ...]:
        """Return them."""
        remedy = f"choose from {', '.join(self.item.words)}" if isinstance(self.item, Word) else self.item.remedy
        if not isinstance(value, list | tuple) or value == []:
            condition = f"be a list of {'names' if self.of is None else self.of.__name__}"
            raise InputError(name, value, condition, remedy)
        if len(value) > self.most:
            condition = f"have at most {self.most} {'names' if self.of is None else 'entries'}"
            raise InputError(name, value, condition, remedy)
        items = collect_errors(name, value, lambda _, entry: self.item.validate("", entry))
        return tuple(dict.fromkeys(items) if self.of is None else items)

    def schema(self) -> dict[str, Any]:
        """Return the schema of a list, except for tables in it."""
        return {"type": "array", "minItems": 1} | ({"items": self.item.schema()} if self.of is None else {})


@dataclass(frozen=True)
class Custom:
    """A value with its own check and schema.

    Attributes
    ----------
    json : mapping
        Its JSON schema.
    """

    meaning: str
    condition: Condition
    json: Mapping[str, Any]
    remedy: str = ""

    def validate(self, name: str, value: Any) -> Any:
        """Return what its check returns."""
        return self.condition(name, value, self.remedy)

    def schema(self) -> dict[str, Any]:
        """Return a copy of its schema."""
        return dict(self.json)


#: All ways to describe a field.
KINDS = (Quantity, OneOrTwo, Quantities, Count, Flag, OrFlag, Word, Part, Several, Custom)


def _validate_word(name: str, value: Any, words: Mapping[str, Any], number: str, remedy: str) -> str:
    """Return one of the words that may replace a number."""
    if not isinstance(value, str) or value not in words:
        raise InputError(
            name, value, f"be {'one of ' * (len(words) > 1)}{', '.join(map(repr, words))} or {number}", remedy
        )
    return value


def unknown_word_error(field: str, value: object, what: str, known: Iterable[str], otherwise: str = "") -> InputError:
    """Return the error for an unknown word; it suggests the closest known one.

    Where none is close it lists all known words, or says ``otherwise`` where these are too many.
    """
    known = tuple(known)
    match = nearest(value, known)
    remedy = f"did you mean '{match}'?" if match else otherwise or list_choices(known)
    return InputError(field, value, f"be a known {what}", remedy)


def unknown_key_error(
    name: str, value: object, known: Iterable[str], noun: str = "key", owner: str = ""
) -> UnknownKeyError:
    """Return the error for an unknown name; it suggests the closest known name, or lists all if none is close."""
    known = tuple(known)
    return UnknownKeyError(name, value, nearest(name, known), list_choices(known), noun, owner)


def list_choices(known: Iterable[str]) -> str:
    """Return the remedy that lists known words."""
    return "choose from " + ", ".join(f"'{name}'" for name in known)


def describe_field(description: Description) -> str:
    """Return the description of a field as one clause: meaning, unit, and the words allowed in its place."""
    choice = description.item if isinstance(description, OneOrTwo) else description
    unit = getattr(choice, "unit", "")
    words = choice.words if isinstance(choice, Quantity | Count) else {}
    listed_words = ", ".join(f"{word!r} ({getattr(meaning, 'meaning', meaning)})" for word, meaning in words.items())
    number = f", or {choice.meaning}" if choice is not description else ""
    return f"{description.meaning}{f' [{unit}]' * bool(unit)}{f': {listed_words}{number}' if words else ''}"


def find_remedy(description: Any) -> str:
    """Return what to do about a field."""
    remedy = getattr(description, "remedy", "")
    return str(remedy or (find_remedy(description.item) if hasattr(description, "item") else "give it"))
