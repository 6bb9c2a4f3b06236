"""What the fields of an input say of themselves, once: unit, meaning, condition and remedy.

An input is a frozen dataclass made with `described` from `Input`, its fields annotated such as
``length: Annotated[float, Quantity("mm", "length along the axis", positive, "give it in mm")]``. From these come its
checks and its docstring in Python, and in `nonhertz.files` reading, writing and the schema of files. What concerns
several fields is a method marked with `together`, which names them, so that a reader can run it where others are wrong.
"""

from __future__ import annotations

import dataclasses
import functools
import inspect
import itertools
import math
import re
import sys
import textwrap
import types
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import (
    Annotated,
    Any,
    ClassVar,
    Literal,
    ParamSpec,
    Protocol,
    Self,
    TypeVar,
    Union,
    dataclass_transform,
    get_args,
    get_origin,
    get_type_hints,
)

from nonhertz.errors import InputError, InputsError, UnknownKeyError, nearest
from nonhertz.inputs.assumed import Assumed
from nonhertz.inputs.checks import above_zero, finite, flag, is_number, not_negative, numbers, one_of, positive, whole
from nonhertz.inputs.units import begins_with_digits, in_unit

#: A check of a value, given its name, the value and the remedy: raises `InputError`, or returns what to keep, if any.
Condition = Callable[[str, Any, str], Any]
AnyClass = TypeVar("AnyClass")
Read = TypeVar("Read")
P = ParamSpec("P")
Method = TypeVar("Method", bound=Callable[[Any], None])
Function = TypeVar("Function", bound=Callable[..., Any])

_NEXT_SECTION = re.compile(r"^[A-Z][a-z]+\n-+$", re.MULTILINE)


class Described(Protocol):
    """What a field holds: stands in ``Annotated`` beside its type.

    In all kinds of it ``meaning``, ``condition``, ``remedy`` and ``words`` are as of `Quantity`.
    """

    @property
    def meaning(self) -> str:
        """What it is, a clause without a full stop."""

    def take(self, name: str, value: Any) -> Any:
        """Return the value to keep of one that is given, or raise `InputError`."""

    def schema(self) -> dict[str, Any]:
        """Return the JSON schema of its value in a file, but for tables and without its meaning."""


def one_by_one(name: str, entries: Iterable[Any], take: Callable[[int, Any], Read]) -> list[Read]:
    """Return what is taken of the entries of a field, each given with its number from 1.

    Raises
    ------
    InputsError
        With the errors of all of them, each in the field of its entry, ``name[1]``.
    """
    values: list[Read] = []
    errors: list[InputError] = []
    for number, entry in enumerate(entries, start=1):
        try:
            values.append(take(number, entry))
        except InputError as error:
            errors += error.within(f"{name}[{number}]").each
    if errors:
        raise InputsError(errors)
    return values


@dataclass(frozen=True)
class Quantity:
    """A number in a unit; text may give it in another unit, and some words may stand for it.

    Attributes
    ----------
    unit : str
        As of `nonhertz.inputs.units.in_unit`, ``""`` for a plain number.
    meaning : str
        What it is, a clause without a full stop.
    condition : callable
        Its check.
    remedy : str
        What to do about a value that fails it, a clause without a full stop.
    words : mapping of str to object
        Words in place of the number, and what each means: a text, or what has one as its ``meaning``.
    """

    unit: str
    meaning: str
    condition: Condition = finite
    remedy: str = "write a number, or text with a unit"
    words: Mapping[str, Any] = field(default_factory=dict)

    def take(self, name: str, value: Any) -> Any:
        """Return the number in the unit, or a word in its place."""
        if self.words and not (begins_with_digits(value) if isinstance(value, str) else is_number(value)):
            number = f"a number{f' in {self.unit}' if self.unit else ''}"
            return _word_or(name, value, self.words, number, self.remedy)
        value = in_unit(name, value, self.unit)
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
        What both are.
    names : pair of str
        What tells them apart.
    single : int or None
        Which of the two one alone is; None for both.
    """

    item: Quantity
    meaning: str
    names: tuple[str, str]
    single: int | None = None

    def take(self, name: str, value: Any) -> Any:
        """Return the number or word, or two of them."""
        values = value.tolist() if hasattr(value, "tolist") else value
        if not isinstance(values, list | tuple):
            return self.item.take(name, values)
        if len(values) != 2:
            raise InputError(name, value, "be one value or two", self.item.remedy)
        return tuple(one_by_one(name, values, lambda _, value: self.item.take("", value)))

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

    def take(self, name: str, value: Any) -> tuple[float, ...]:
        """Return the numbers in the unit."""
        remedy = f"give a list of numbers in {self.unit}"
        if isinstance(value, list | tuple):
            value = type(value)(in_unit(name, entry, self.unit) if isinstance(entry, str) else entry for entry in value)
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
    """A word of a list, or any text that its condition lets pass.

    Attributes
    ----------
    words : tuple of str
        The words; none for any text.
    noun : str
        What the words are, if they are too many for a sentence.
    """

    meaning: str
    remedy: str = ""
    words: tuple[str, ...] = ()
    condition: Condition | None = None
    noun: str = ""

    def take(self, name: str, value: Any) -> Any:
        """Return the word."""
        if self.noun and value not in self.words:
            raise unknown(name, value, self.noun, self.words, self.remedy)
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
        Those that a name stands for.
    likely : callable or None
        The class of one whose table in a file gives no kind, by its fields; ``of`` if left out.
    """

    meaning: str
    of: type
    remedy: str
    named: Mapping[str, Any] = field(default_factory=dict)
    likely: Callable[[Mapping[str, Any]], type[Input]] | None = None

    def take(self, name: str, value: Any) -> Any:
        """Return the input, or that of a name."""
        if self.named and isinstance(value, str):
            if value not in self.named:
                raise unknown(name, value, self.of.__name__.lower(), self.named, self.remedy)
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
    """A whole number; some words may stand for it.

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

    def take(self, name: str, value: Any) -> int | str:
        """Return the number, or a word in its place."""
        counted = is_number(value) and self.least <= value <= self.most and float(value).is_integer()
        if self.words and not counted:
            bounds = f"of at least {self.least}" if math.isinf(self.most) else f"from {self.least} to {self.most:g}"
            return _word_or(name, value, self.words, f"a whole number {bounds}", self.remedy)
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

    def take(self, name: str, value: Any) -> bool:
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
        What it is otherwise.
    """

    item: Described
    meaning: str

    def take(self, name: str, value: Any) -> Any:
        """Return either."""
        if isinstance(value, bool):
            return value
        try:
            return self.item.take(name, value)
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
        """What they are."""
        return self.item.meaning

    @property
    def of(self) -> type | None:
        """The class of the inputs; None for words."""
        return self.item.of if isinstance(self.item, Part) else None

    def take(self, name: str, value: Any) -> tuple[Any, ...]:
        """Return them."""
        remedy = f"choose from {', '.join(self.item.words)}" if isinstance(self.item, Word) else self.item.remedy
        if not isinstance(value, list | tuple) or value == []:
            condition = f"be a list of {'names' if self.of is None else self.of.__name__}"
            raise InputError(name, value, condition, remedy)
        if len(value) > self.most:
            condition = f"have at most {self.most} {'names' if self.of is None else 'entries'}"
            raise InputError(name, value, condition, remedy)
        items = one_by_one(name, value, lambda _, entry: self.item.take("", entry))
        return tuple(dict.fromkeys(items) if self.of is None else items)

    def schema(self) -> dict[str, Any]:
        """Return the schema of a list, but for tables in it."""
        return {"type": "array", "minItems": 1} | ({"items": self.item.schema()} if self.of is None else {})


@dataclass(frozen=True)
class Custom:
    """A value that has a check and a schema of its own.

    Attributes
    ----------
    json : mapping
        Its JSON schema.
    """

    meaning: str
    condition: Condition
    json: Mapping[str, Any]
    remedy: str = ""

    def take(self, name: str, value: Any) -> Any:
        """Return what its check returns."""
        return self.condition(name, value, self.remedy)

    def schema(self) -> dict[str, Any]:
        """Return a copy of its schema."""
        return dict(self.json)


#: All ways to describe a field.
KINDS = (Quantity, OneOrTwo, Quantities, Count, Flag, OrFlag, Word, Part, Several, Custom)


def _word_or(name: str, value: Any, words: Mapping[str, Any], number: str, remedy: str) -> str:
    """Return a word of those that may stand for a number."""
    if not isinstance(value, str) or value not in words:
        raise InputError(
            name, value, f"be {'one of ' * (len(words) > 1)}{', '.join(map(repr, words))} or {number}", remedy
        )
    return value


def together(*names: str) -> Callable[[Method], Method]:
    """Mark a method that raises `InputError` where these fields do not go together."""

    def marked(method: Method) -> Method:
        method.together = frozenset(names)  # type: ignore[attr-defined]
        return method

    return marked


class Input:
    """Base of what is given: checks every field, then those that have to go together.

    Attributes
    ----------
    kinds : mapping of str to type
        Of an input of several kinds the class of each, by the word in a file.
    meaning_of_kind : str
        What that word decides.
    instead : mapping of str to str
        Fields that are given in place of others, not beside them.
    apart : tuple of tuples of str
        Groups of fields of which no two are given.
    """

    # Made by `described`: what describes the fields, by name, and what is assumed where they are left out; which must
    # be given, and which may be None; the classes of those that hold inputs; and the checks of several fields, those of
    # a class before those of its bases, each with the names of the fields.
    descriptions: ClassVar[Mapping[str, Described]] = {}
    assumptions: ClassVar[Mapping[str, Assumed]] = {}
    without_default: ClassVar[frozenset[str]] = frozenset()
    optional: ClassVar[frozenset[str]] = frozenset()
    inputs: ClassVar[Mapping[str, type[Any]]] = {}
    checks_together: ClassVar[tuple[tuple[Callable[[Any], None], frozenset[str]], ...]] = ()

    kinds: ClassVar[Mapping[str, type[Any]]] = {}
    meaning_of_kind: ClassVar[str] = ""
    instead: ClassVar[Mapping[str, str]] = {}
    apart: ClassVar[tuple[tuple[str, ...], ...]] = ()

    def __post_init__(self) -> None:
        for name, description in self.descriptions.items():
            value = getattr(self, name)
            if value is not None or name not in self.optional:
                object.__setattr__(self, name, description.take(name, value))
        provided = {name: value for name in self.descriptions if (value := getattr(self, name)) is not None}
        for error in given_beside(type(self), provided):
            raise error
        for check, _ in self.checks_together:
            check(self)

    def __repr__(self) -> str:
        return short_repr(self)

    @property
    def keywords(self) -> dict[str, Any]:
        """What is given: keywords of the function that takes such an input."""
        return {name: value for name in self.descriptions if (value := getattr(self, name)) is not None}

    @classmethod
    def likely(cls, values: Mapping[str, Any]) -> type[Any]:
        """Return the class of an input whose table gives no kind, by its values."""
        return cls

    @classmethod
    def unchecked(cls, **values: Any) -> Self:
        """Return an input of which some fields are known and the others at their defaults, without any check."""
        instance = object.__new__(cls)
        for own in dataclasses.fields(cls):  # type: ignore[arg-type]
            object.__setattr__(instance, own.name, values.get(own.name, default_of(own)))
        return instance


@dataclass_transform(frozen_default=True, field_specifiers=(dataclasses.field,))
def described(**options: Any) -> Callable[[type[AnyClass]], type[AnyClass]]:
    """Return a decorator that makes a frozen dataclass whose docstring has its fields; options as of `dataclass`."""

    def made(cls: type[Any]) -> type[Any]:
        cls = dataclass(frozen=True, repr=False, **options)(cls)
        hints = _hints_of(cls)

        def marks(kind: Any) -> dict[str, Any]:
            every = {name: getattr(hint, "__metadata__", ()) for name, hint in hints.items()}
            return {
                name: matches[0]
                for name, metadata in every.items()
                if (matches := [one for one in metadata if isinstance(one, kind)])
            }

        described_by = marks(KINDS)
        cls.descriptions = {field.name: described_by[field.name] for field in dataclasses.fields(cls)}
        cls.assumptions = marks(Assumed)
        cls.without_default = frozenset(
            field.name for field in dataclasses.fields(cls) if default_of(field) is dataclasses.MISSING
        )
        bare = _without_marks(hints)
        kinds = {name: get_args(hint) or (hint,) for name, hint in bare.items() if name in cls.descriptions}
        cls.optional = frozenset(name for name, alternatives in kinds.items() if type(None) in alternatives)
        inputs = {
            name: [one for one in alternatives if isinstance(one, type) and issubclass(one, Input)]
            for name, alternatives in kinds.items()
        }
        cls.inputs = {name: classes[0] for name, classes in inputs.items() if classes}
        together = [
            (name, member) for base in cls.__mro__ for name, member in vars(base).items() if hasattr(member, "together")
        ]
        cls.checks_together = tuple((check, check.together) for name, check in together if getattr(cls, name) is check)
        cls.__doc__ = _with_parameters(cls, bare)
        cls.__init__ = _naming_the_nearest(cls)
        cls.__init__.__signature__ = plain_signature(cls.__init__, bare)
        return cls

    return made


def _hints_of(cls: type[Any]) -> dict[str, Any]:
    """Return the types of the fields of a dataclass with what describes them.

    `get_type_hints` would evaluate the annotations of `Input` for each of its classes, too, which took half as long as
    all else that is imported for a first solve.
    """
    names = {field.name for field in dataclasses.fields(cls)}
    hints: dict[str, Any] = {}
    for base in reversed(cls.__mro__):
        own = {name: annotation for name, annotation in inspect.get_annotations(base).items() if name in names}
        if own:
            scope, annotated = vars(sys.modules[base.__module__]), types.SimpleNamespace(__annotations__=own)
            hints |= get_type_hints(annotated, scope, {base.__name__: base}, include_extras=True)
    return hints


def _without_marks(hints: Mapping[str, Any]) -> dict[str, Any]:
    """Return types without what describes the fields."""
    return {name: hint.__origin__ if get_origin(hint) is Annotated else hint for name, hint in hints.items()}


def parameters_of(function: Callable[..., Any], base: type[Input] = Input) -> type[Any]:
    """Return the class of what a function takes, whose parameters are annotated as the fields of an input are."""
    function = inspect.unwrap(function)
    hints = get_type_hints(function, include_extras=True)
    parameters = inspect.signature(function).parameters.values()
    defaults = {p.name: p.default for p in parameters if p.default is not p.empty}
    annotations = {p.name: hints[p.name] for p in parameters}
    body = {"__annotations__": annotations, "__module__": function.__module__, "__doc__": function.__doc__}
    cls: type[Any] = described()(type(function.__name__, (base,), body | defaults))
    return cls


def checked(function: Callable[P, Read]) -> Callable[P, Read]:
    """Return a function whose parameters are checked and listed in its docstring by what describes them."""
    cls = parameters_of(function)

    @functools.wraps(function)
    def called(*values: P.args, **keywords: P.kwargs) -> Read:
        return function(**vars(cls(*values, **keywords)))  # type: ignore[call-arg]

    called.__doc__ = cls.__doc__
    hints = _without_marks(get_type_hints(function, include_extras=True))
    called.__signature__ = plain_signature(function, hints)  # type: ignore[attr-defined]
    return called


def taking(*classes: type[Input]) -> Callable[[Function], Function]:
    """Return a decorator that lists fields of inputs in the docstring of a function, where it names these in braces."""

    def listed(function: Function) -> Function:
        text = inspect.cleandoc(function.__doc__ or "")
        for cls in classes:
            text = text.replace(f"{{{cls.__name__}}}", "\n".join(_parameters(cls, _without_marks(_hints_of(cls)))))
        function.__doc__ = text
        return function

    return listed


def given_beside(cls: type[Input], provided: Mapping[str, Any]) -> list[InputError]:
    """Return an error for each field that is given beside one that it takes the place of or rules out."""
    ruled_out = (pair for group in cls.apart for pair in itertools.combinations(group, 2))
    return [
        InputError(name, provided[name], f"not be given together with {other}", "leave one out")
        for name, other in (*cls.instead.items(), *ruled_out)
        if name in provided and other in provided
    ]


def short_repr(value: Any) -> str:
    """Return the call that makes a dataclass, without what is at its default or not shown."""
    values = {
        field.name: (getattr(value, field.name), default_of(field)) for field in dataclasses.fields(value) if field.repr
    }
    arguments = (f"{name}={actual!r}" for name, (actual, usual) in values.items() if actual != usual)
    return f"{type(value).__name__}({', '.join(arguments)})"


def default_of(field: dataclasses.Field[Any]) -> Any:
    """Return the default of a field, `dataclasses.MISSING` if there is none."""
    return field.default if field.default_factory is dataclasses.MISSING else field.default_factory()


def unknown(field: str, value: object, what: str, known: Iterable[str], otherwise: str = "") -> InputError:
    """Return the error for a value that is no known word; it suggests the closest.

    Where none is close it lists all that are known, or says ``otherwise`` where these are too many.
    """
    known = tuple(known)
    match = nearest(value, known)
    remedy = f"did you mean '{match}'?" if match else otherwise or _choice(known)
    return InputError(field, value, f"be a known {what}", remedy)


def unknown_key(name: str, value: object, known: Iterable[str], noun: str = "key", owner: str = "") -> UnknownKeyError:
    """Return the error for a name that is not known; it suggests the closest, or where none is close lists them all."""
    known = tuple(known)
    return UnknownKeyError(name, value, nearest(name, known), _choice(known), noun, owner)


def _choice(known: Iterable[str]) -> str:
    return "choose from " + ", ".join(f"'{name}'" for name in known)


def text_of(description: Described) -> str:
    """Return what describes a field as one clause: meaning, unit, and the words that may stand in its place."""
    choice = description.item if isinstance(description, OneOrTwo) else description
    unit = getattr(choice, "unit", "")
    words = choice.words if isinstance(choice, Quantity | Count) else {}
    listed_words = ", ".join(f"{word!r} ({getattr(meaning, 'meaning', meaning)})" for word, meaning in words.items())
    number = f", or {choice.meaning}" if choice is not description else ""
    return f"{description.meaning}{f' [{unit}]' * bool(unit)}{f': {listed_words}{number}' if words else ''}"


def _with_parameters(cls: type[Any], hints: Mapping[str, Any]) -> str:
    """Return the docstring of an input with its fields before the other sections."""
    text = inspect.cleandoc(cls.__doc__ or "")
    section = _NEXT_SECTION.search(text)
    before, after = (text[: section.start()].rstrip(), "\n\n" + text[section.start() :]) if section else (text, "")
    return "\n".join([before, "", "Parameters", "----------", *_parameters(cls, hints)]) + after


def _parameters(cls: type[Any], hints: Mapping[str, Any]) -> Iterator[str]:
    """Yield the lines that list the fields of an input, with their types."""
    for name, description in cls.descriptions.items():
        meaning = text_of(description)
        yield f"{name} : {_words_of(hints[name])}"
        yield from textwrap.wrap(
            f"{meaning[:1].upper()}{meaning[1:]}.", 120, initial_indent=" " * 4, subsequent_indent=" " * 4
        )


def _remedy(description: Any) -> str:
    """Return what to do about a field."""
    remedy = getattr(description, "remedy", "")
    return str(remedy or (_remedy(description.item) if hasattr(description, "item") else "give it"))


def _words_of(kind: Any) -> str:
    """Return a type as docstrings name it."""
    kinds = get_args(kind) if isinstance(kind, types.UnionType) or get_origin(kind) is Union else (kind,)
    names = [
        "callable"
        if get_origin(option) is Callable
        else "pair"
        if get_origin(option) is tuple and Ellipsis not in get_args(option)
        else f"{get_origin(option).__name__.lower()} of {get_args(option)[0].__name__}"
        if get_origin(option) in (tuple, Sequence)
        else "str"
        if get_origin(option) is Literal
        else option.__name__.replace("NoneType", "None")
        for option in kinds
    ]
    return " or ".join(dict.fromkeys(names))


def plain_signature(function: Callable[..., Any], hints: Mapping[str, Any]) -> inspect.Signature:
    """Return the signature of a function with these types, which do not say what describes its parameters."""
    signature = inspect.signature(function)
    plain = [p.replace(annotation=hints.get(p.name, p.annotation)) for p in signature.parameters.values()]
    return signature.replace(parameters=plain, return_annotation=hints.get("return", signature.return_annotation))


def _naming_the_nearest(cls: type[Any]) -> Callable[..., None]:
    """Return the constructor of an input that says which field an unknown one may be, and which are missing."""
    plain = cls.__init__
    names = [field.name for field in dataclasses.fields(cls) if field.init]

    @functools.wraps(plain)
    def constructor(self: Any, *values: Any, **keywords: Any) -> None:
        for name, value in keywords.items():
            if name not in names:
                raise TypeError(str(unknown_key(name, value, names, "field", cls.__name__)))
        if missing := cls.without_default.difference(keywords, names[: len(values)]):
            remedies = {name: _remedy(cls.descriptions[name]) for name in names if name in missing}
            raise InputsError(InputError(name, None, "be given", remedy) for name, remedy in remedies.items())
        plain(self, *values, **keywords)

    return constructor
