"""Kinds of profile: functions whose parameters are described once, for Python, files and forms.

A kind is a function marked with `kind`, its parameters annotated like the fields of an input, see
`nonhertz.inputs.fields`. From these follow the checks before it is called, its docstring, and the class that readers
and forms use. A condition on several parameters is a function of just these that raises `InputError`.
"""

from __future__ import annotations

import functools
import inspect
from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any, ClassVar, Final, ParamSpec, get_type_hints

from nonhertz.inputs.fields import Input, parameters_class, strip_signature
from nonhertz.model.profile.base import Profile

P = ParamSpec("P")


class ProfileKind(Input):
    """Parameters of a kind of profile: one class for each kind.

    Attributes
    ----------
    by_drop : tuple of str
        A stated drop determines the first of these parameters that is not given; without any, the relief is scaled.
    of_body : mapping
        Parameters that default to a dimension of the body, or of both bodies together, where a table in a file leaves
        them out: ``"diameter"``, ``"length"`` between the side faces, ``"land"`` between corners or within the
        effective length, or the combined ``"radius"``.
    """

    by_drop: ClassVar[tuple[str, ...]] = ()
    of_body: ClassVar[Mapping[str, str]] = {}


#: The functions of all kinds, by their names in files.
CATALOGUE: Final[dict[str, Callable[..., Profile]]] = {}
#: The parameters of each kind.
PARAMETERS: Final[dict[str, type[ProfileKind]]] = {}


def kind(
    *,
    by_drop: tuple[str, ...] = (),
    of_body: Mapping[str, str] = MappingProxyType({}),
    cross_checks: tuple[Callable[..., None], ...] = (),
) -> Callable[[Callable[P, Profile]], Callable[P, Profile]]:
    """Return a decorator that adds a function to the catalogue as a kind; files write its name with dashes.

    Parameters
    ----------
    by_drop, of_body : tuple of str, mapping
        As in `ProfileKind`.
    cross_checks : tuple of callable
        Conditions on several parameters, each a function of these by name.
    """

    def decorate(function: Callable[P, Profile]) -> Callable[P, Profile]:
        word, cls = function.__name__.replace("_", "-"), parameters_class(function, ProfileKind)
        cls.by_drop, cls.of_body = by_drop, of_body
        cls.cross_checks = tuple(_as_cross_check(check) for check in cross_checks)

        @functools.wraps(function)
        def profile(*values: P.args, **keywords: P.kwargs) -> Profile:
            parameters = cls(*values, **keywords)
            return function(**vars(parameters)).with_entry(word, parameters)  # type: ignore[call-arg]

        profile.__doc__ = cls.__doc__
        profile.__signature__ = strip_signature(function, get_type_hints(function))  # type: ignore[attr-defined]
        CATALOGUE[word], PARAMETERS[word] = profile, cls
        return profile

    return decorate


def _as_cross_check(check: Callable[..., None]) -> tuple[Callable[[Any], None], frozenset[str]]:
    names = tuple(inspect.signature(check).parameters)
    return (lambda fields: check(*(getattr(fields, name) for name in names))), frozenset(names)
