"""Inputs: frozen dataclasses whose fields are described once, where they are declared.

An input is a frozen dataclass made with `input_class` from `Input`, its fields annotated such as
``length: Annotated[float, Quantity("mm", "length along the axis", positive, "give it in mm")]``, see
`nonhertz.inputs.descriptions`. From these come its checks and its docstring in Python, and in `nonhertz.files` reading,
writing and the schema of files. A condition on several fields is a method marked with `cross_check`, which names them,
so that a file reader can check it even if other fields are wrong.
"""

from __future__ import annotations

import dataclasses
import functools
import inspect
import itertools
import operator
import re
import sys
import textwrap
import types
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import (
    Annotated,
    Any,
    ClassVar,
    Literal,
    ParamSpec,
    Self,
    TypeVar,
    Union,
    dataclass_transform,
    get_args,
    get_origin,
    get_type_hints,
)

from nonhertz.errors import InputError, InputsError
from nonhertz.inputs.assumed import Assumed
from nonhertz.inputs.descriptions import (
    KINDS,
    Description,
    Part,
    describe_field,
    find_remedy,
    list_choices,
    unknown_key_error,
)

AnyClass = TypeVar("AnyClass")
Result = TypeVar("Result")
P = ParamSpec("P")
Method = TypeVar("Method", bound=Callable[[Any], None])
Function = TypeVar("Function", bound=Callable[..., Any])
_MOST_SHOWN = 6  # of the entries of a row
_NEXT_SECTION = re.compile(r"^[A-Z][a-z]+\n-+$", re.MULTILINE)


def cross_check(*names: str) -> Callable[[Method], Method]:
    """Mark a method that raises `InputError` where these fields are inconsistent."""

    def mark(method: Method) -> Method:
        method.checked_fields = frozenset(names)  # type: ignore[attr-defined]
        return method

    return mark


class Input:
    """Base class of inputs: checks every field, then the conditions on several fields.

    Attributes
    ----------
    kinds : mapping of str to type
        For an input of several kinds, the class of each by its word in a file.
    meaning_of_kind : str
        Meaning of that word.
    instead : mapping of str to str
        Fields that replace others and cannot be given together with them.
    apart : tuple of tuples of str
        Groups of mutually exclusive fields.
    """

    # Made by `input_class`: descriptions of the fields by name, and assumptions where they are left out; the required
    # fields, and those that may be None; the classes of fields that hold inputs; and the checks of several fields, a
    # class's own before those of its bases, each with the names of the fields.
    descriptions: ClassVar[Mapping[str, Description]] = {}
    assumptions: ClassVar[Mapping[str, Assumed]] = {}
    without_default: ClassVar[frozenset[str]] = frozenset()
    optional: ClassVar[frozenset[str]] = frozenset()
    inputs: ClassVar[Mapping[str, type[Any]]] = {}
    cross_checks: ClassVar[tuple[tuple[Callable[[Any], None], frozenset[str]], ...]] = ()

    kinds: ClassVar[Mapping[str, type[Any]]] = {}
    meaning_of_kind: ClassVar[str] = ""
    instead: ClassVar[Mapping[str, str]] = {}
    apart: ClassVar[tuple[tuple[str, ...], ...]] = ()

    def __post_init__(self) -> None:
        for name, description in self.descriptions.items():
            value = getattr(self, name)
            if value is not None or name not in self.optional:
                object.__setattr__(self, name, description.validate(name, value))
        provided = {name: value for name in self.descriptions if (value := getattr(self, name)) is not None}
        for error in mutually_exclusive_errors(type(self), provided):
            raise error
        for check, _ in self.cross_checks:
            check(self)

    def __repr__(self) -> str:
        return call_repr(self)

    @property
    def keywords(self) -> dict[str, Any]:
        """Values that are not None, as keywords of a function that takes them."""
        return {name: value for name in self.descriptions if (value := getattr(self, name)) is not None}

    @classmethod
    def likely(cls, values: Mapping[str, Any]) -> type[Any]:
        """Return the class of an input from the values of a table that gives no kind."""
        return cls

    @classmethod
    def unchecked(cls, **values: Any) -> Self:
        """Return an input with these values and defaults elsewhere, without any check."""
        instance = object.__new__(cls)
        for own in dataclasses.fields(cls):  # type: ignore[arg-type]
            object.__setattr__(instance, own.name, values.get(own.name, default_of(own)))
        return instance


@dataclass_transform(frozen_default=True, field_specifiers=(dataclasses.field,))
def input_class(**options: Any) -> Callable[[type[AnyClass]], type[AnyClass]]:
    """Return a decorator that makes a frozen dataclass with its fields in its docstring; options as for `dataclass`."""

    def decorate(cls: type[Any]) -> type[Any]:
        cls = dataclass(frozen=True, repr=False, **options)(cls)
        hints, fields = _resolve_hints(cls), dataclasses.fields(cls)
        bare, marks = (
            _strip_descriptions(hints),
            {name: getattr(hint, "__metadata__", ()) for name, hint in hints.items()},
        )
        described_by = _first_of(marks, lambda mark: isinstance(mark, KINDS))
        cls.descriptions = {field.name: described_by[field.name] for field in fields}
        cls.assumptions = _first_of(marks, lambda mark: isinstance(mark, Assumed))
        cls.without_default = frozenset(field.name for field in fields if default_of(field) is dataclasses.MISSING)
        kinds = {name: get_args(bare[name]) or (bare[name],) for name in cls.descriptions}
        cls.optional = frozenset(name for name, alternatives in kinds.items() if types.NoneType in alternatives)
        cls.inputs = _first_of(kinds, lambda kind: isinstance(kind, type) and issubclass(kind, Input))
        checks = [(name, check) for base in cls.__mro__ for name, check in vars(base).items()]
        cls.cross_checks = tuple(
            (check, check.checked_fields)
            for name, check in checks
            if hasattr(check, "checked_fields") and getattr(cls, name) is check
        )
        cls.__doc__ = _insert_parameters(cls, bare)
        cls.__init__ = _make_constructor(cls)
        cls.__init__.__signature__ = strip_signature(cls.__init__, bare)
        return cls

    return decorate


def _first_of(choices: Mapping[str, Iterable[Any]], holds: Callable[[Any], bool]) -> dict[str, Any]:
    """Return for each name the first of its choices for which ``holds`` is true; names without one are left out."""
    firsts = ((name, next(filter(holds, several), None)) for name, several in choices.items())
    return {name: first for name, first in firsts if first is not None}


def _resolve_hints(cls: type[Any]) -> dict[str, Any]:
    """Return the types of the fields of a dataclass with their descriptions.

    `get_type_hints` would also evaluate the annotations of `Input` for each of its classes, which took half as long as
    all other imports of a first solve.
    """
    names = {field.name for field in dataclasses.fields(cls)}
    hints: dict[str, Any] = {}
    for base in reversed(cls.__mro__):
        own = {name: annotation for name, annotation in inspect.get_annotations(base).items() if name in names}
        if own:
            scope, annotated = vars(sys.modules[base.__module__]), types.SimpleNamespace(__annotations__=own)
            hints |= get_type_hints(annotated, scope, {base.__name__: base}, include_extras=True)
    return hints


def _strip_descriptions(hints: Mapping[str, Any]) -> dict[str, Any]:
    """Return types without the descriptions of the fields."""
    return {name: hint.__origin__ if get_origin(hint) is Annotated else hint for name, hint in hints.items()}


def parameters_class(function: Callable[..., Any], base: type[Input] = Input) -> type[Any]:
    """Return an input class of a function's parameters, which are annotated like the fields of an input."""
    function = inspect.unwrap(function)
    hints = get_type_hints(function, include_extras=True)
    parameters = inspect.signature(function).parameters.values()
    defaults = {p.name: p.default for p in parameters if p.default is not p.empty}
    annotations = {p.name: hints[p.name] for p in parameters}
    body = {"__annotations__": annotations, "__module__": function.__module__, "__doc__": function.__doc__}
    cls: type[Any] = input_class()(type(function.__name__, (base,), body | defaults))
    return cls


def validate_call(function: Callable[P, Result]) -> Callable[P, Result]:
    """Return a function whose parameters are checked, and listed in its docstring, by their descriptions."""
    cls = parameters_class(function)

    @functools.wraps(function)
    def validated(*values: P.args, **keywords: P.kwargs) -> Result:
        return function(**vars(cls(*values, **keywords)))  # type: ignore[call-arg]

    validated.__doc__ = cls.__doc__
    hints = _strip_descriptions(get_type_hints(function, include_extras=True))
    validated.__signature__ = strip_signature(function, hints)  # type: ignore[attr-defined]
    return validated


def document_parameters(*classes: type[Input]) -> Callable[[Function], Function]:
    """Return a decorator that inserts fields of inputs into a function's docstring, where it names these in braces."""

    def insert(function: Function) -> Function:
        text = inspect.cleandoc(function.__doc__ or "")
        for cls in classes:
            text = text.replace(
                f"{{{cls.__name__}}}", "\n".join(_document_fields(cls, _strip_descriptions(_resolve_hints(cls))))
            )
        function.__doc__ = text
        return function

    return insert


def mutually_exclusive_errors(cls: type[Input], provided: Mapping[str, Any]) -> list[InputError]:
    """Return an error for each field that is given together with one that it replaces or excludes."""
    ruled_out = (pair for group in cls.apart for pair in itertools.combinations(group, 2))
    return [
        InputError(name, provided[name], f"not be given together with {other}", "leave one out")
        for name, other in (*cls.instead.items(), *ruled_out)
        if name in provided and other in provided
    ]


def call_repr(value: Any) -> str:
    """Return the call that makes a dataclass as a user would type it, without defaults and hidden fields."""
    values = {
        field.name: (getattr(value, field.name), default_of(field)) for field in dataclasses.fields(value) if field.repr
    }
    described = getattr(value, "descriptions", {})
    arguments = (
        f"{name}={_short(_name_in(described.get(name), actual))}"
        for name, (actual, usual) in values.items()
        if actual != usual
    )
    return f"{type(value).__name__}({', '.join(arguments)})"


def _name_in(description: Description | None, value: Any) -> Any:
    """Return the name by which an input can be given; the input itself if it has none."""
    named = description.named if isinstance(description, Part) else {}
    return next((name for name, other in named.items() if other == value), value)


def _short(value: Any) -> str:
    """Return a value as a user would type it; only the first and last of many."""
    if isinstance(value, tuple) and len(value) > _MOST_SHOWN:
        first, last = (f"{end:.6g}" if isinstance(end, float) else _short(end) for end in (value[0], value[-1]))
        return f"({first}, ..., {last})"
    return f"{value:.12g}" if isinstance(value, float) else repr(value)


def default_of(field: dataclasses.Field[Any]) -> Any:
    """Return the default of a field, `dataclasses.MISSING` if there is none."""
    return field.default if field.default_factory is dataclasses.MISSING else field.default_factory()


def _insert_parameters(cls: type[Any], hints: Mapping[str, Any]) -> str:
    """Return the docstring of an input with its fields before the other sections."""
    text = inspect.cleandoc(cls.__doc__ or "")
    section = _NEXT_SECTION.search(text)
    before, after = (text[: section.start()].rstrip(), "\n\n" + text[section.start() :]) if section else (text, "")
    return "\n".join([before, "", "Parameters", "----------", *_document_fields(cls, hints)]) + after


def _document_fields(cls: type[Any], hints: Mapping[str, Any]) -> Iterator[str]:
    """Yield the lines that list the fields of an input, with their types."""
    for name, description in cls.descriptions.items():
        meaning = describe_field(description)
        yield f"{name} : {_name_type(hints[name])}"
        yield from textwrap.wrap(
            f"{meaning[:1].upper()}{meaning[1:]}.", 120, initial_indent=" " * 4, subsequent_indent=" " * 4
        )


def _name_type(kind: Any) -> str:
    """Return a type as docstrings name it."""
    kinds = get_args(kind) if isinstance(kind, types.UnionType) or get_origin(kind) is Union else (kind,)
    return " or ".join(dict.fromkeys(map(_name_alternative, kinds)))


def _name_alternative(kind: Any) -> str:
    origin, arguments = get_origin(kind), get_args(kind)
    if origin is tuple and Ellipsis not in arguments:
        return "pair"
    if origin in (tuple, Sequence):
        return f"{origin.__name__.lower()} of {arguments[0].__name__}"
    words: dict[Any, str] = {Callable: "callable", Literal: "str"}
    return words.get(origin) or str(kind.__name__).replace("NoneType", "None")


def _readable(kind: Any) -> Any:
    """Return a type for a signature: of functions without their types, which take ten lines in ``help``."""
    if get_origin(kind) is Callable:
        return Callable
    if isinstance(kind, types.UnionType):
        return functools.reduce(operator.or_, map(_readable, get_args(kind)))
    return kind


def strip_signature(function: Callable[..., Any], hints: Mapping[str, Any]) -> inspect.Signature:
    """Return the signature of a function with these types, without the descriptions of its parameters."""
    signature = inspect.signature(function)
    plain = [p.replace(annotation=_readable(hints.get(p.name, p.annotation))) for p in signature.parameters.values()]
    return signature.replace(parameters=plain, return_annotation=hints.get("return", signature.return_annotation))


def _make_constructor(cls: type[Any]) -> Callable[..., None]:
    """Return the constructor of an input, whose errors suggest a field for an unknown name and list missing fields."""
    plain = cls.__init__
    names = [field.name for field in dataclasses.fields(cls) if field.init]
    by_name_only = all(field.kw_only for field in dataclasses.fields(cls) if field.init)

    @functools.wraps(plain)
    def constructor(self: Any, *values: Any, **keywords: Any) -> None:
        if values and by_name_only:
            raise TypeError(f"{cls.__name__} takes its values by name: {list_choices(names)}.")
        for name, value in keywords.items():
            if name not in names:
                raise TypeError(str(unknown_key_error(name, value, names, "field", cls.__name__)))
        if missing := cls.without_default.difference(keywords, names[: len(values)]):
            remedies = {name: find_remedy(cls.descriptions[name]) for name in names if name in missing}
            raise InputsError(InputError(name, None, "be given", remedy) for name, remedy in remedies.items())
        plain(self, *values, **keywords)

    return constructor
