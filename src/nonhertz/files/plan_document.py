"""A plan file and its sections."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import field
from typing import Annotated, Any

from nonhertz.errors import InputError
from nonhertz.files.bounds import FORMAT, LOADS
from nonhertz.files.sampling import Sampling
from nonhertz.files.sections import FORMAT_FIELD, describe_title
from nonhertz.inputs.checks import one_line
from nonhertz.inputs.descriptions import Count, Custom, Part, Quantity, Several, Word
from nonhertz.inputs.fields import Input, input_class
from nonhertz.life import MODELS, ContactLoadCase
from nonhertz.life import model as fatigue_model

_REMEDY = "write a line for each path, such as \"load.load\" = '5 kN : 40 kN : 8'"
_VARIED: dict[str, Any] = {
    "type": "object",
    "additionalProperties": {"anyOf": [{"type": "string"}, {"type": "array", "minItems": 1}, {"type": "object"}]},
}
_TEXTS = {"type": "array", "items": {"type": "string"}}


def flatten(tables: Mapping[str, Any]) -> Iterator[tuple[str, Any]]:
    """Yield paths and values of tables in tables: TOML makes them of dotted keys without quotes.

    Examples
    --------
    >>> list(flatten({"load": {"tilt": "0 : 1 mrad : 3"}, "load.load": [1.0]}))
    [('load.tilt', '0 : 1 mrad : 3'), ('load.load', [1.0])]
    """
    for key, value in tables.items():
        if isinstance(value, dict):
            yield from ((f"{key}.{below}", entry) for below, entry in flatten(value))
        else:
            yield key, value


def _flatten_table(name: str, value: Any, remedy: str) -> dict[str, Any]:
    if not isinstance(value, dict):
        raise InputError(name, value, "be a table", remedy)
    return dict(flatten(value))


def _by_paths(meaning: str) -> Custom:
    """Return the description of a table of values by path."""
    return Custom(meaning, _flatten_table, _VARIED, _REMEDY)


def _as_given(name: str, value: Any, remedy: str) -> Any:
    return value


@input_class(kw_only=True)
class DesignLoad(Input):
    """One load of a design."""

    load: Annotated[float, ContactLoadCase.descriptions["load"]]
    tilt: Annotated[float, ContactLoadCase.descriptions["tilt"]] = 0.0
    share: Annotated[float | None, Quantity("", "its share of the revolutions; all equal if no load has one")] = None


@input_class(kw_only=True)
class DesignGoal(Input):
    """The goal of a design, and its constraints."""

    goal: Annotated[
        str | None,
        Word(
            "'pressure': the lowest peak pressure; 'life': the longest life; pressure if left out",
            "name one of them",
            ("pressure", "life"),
        ),
    ] = None
    model: Annotated[
        str | None,
        Word(
            "name of the fatigue model of lives; 'lundberg-palmgren' if left out",
            "name one of them",
            tuple(MODELS),
        ),
    ] = None
    starts: Annotated[
        int | None, Count("number of searches, 5 if left out", 1, math.inf, "give the number of searches")
    ] = None
    loads: Annotated[
        tuple[DesignLoad, ...],
        Several(
            Part("the loads; those of the case if left out", DesignLoad, "write each under [[design.loads]]"), LOADS
        ),
    ] = ()
    where: Annotated[
        Mapping[str, Any],
        _by_paths("limits that must be met under every load, such as approach = 'at most 30 um'"),
    ] = field(default_factory=dict)

    @property
    def keywords(self) -> dict[str, Any]:
        """The given values, as keywords of `nonhertz.optimize`."""
        model = None if self.model is None else fatigue_model(self.model)
        keywords = {"goal": self.goal, "model": model, "n_starts": self.starts, "loads": self._cases or None}
        return {"constraints": self.where} | {name: value for name, value in keywords.items() if value is not None}

    @property
    def _cases(self) -> tuple[ContactLoadCase, ...]:
        """The loads with their shares."""
        even = 1.0 / max(1, len(self.loads))
        unsaid = all(load.share is None for load in self.loads)
        return tuple(
            ContactLoadCase(load=load.load, tilt=load.tilt, share=even if unsaid else (load.share or 0.0))
            for load in self.loads
        )


@input_class(kw_only=True)
class PlanDocument(Input):
    """A plan file."""

    format: Annotated[int, FORMAT_FIELD] = FORMAT
    title: Annotated[str, describe_title("study")] = ""
    case: Annotated[
        str,
        Word(
            "the case file or bearing file that is varied, relative to the plan",
            "write a short name",
            condition=one_line,
        ),
    ]
    over: Annotated[
        Mapping[str, Any], _by_paths("sweep: the values of each path of the case; all combinations are rows")
    ] = field(default_factory=dict)
    vary: Annotated[
        Mapping[str, Any], _by_paths("design: lowest and highest value of each path that may be chosen")
    ] = field(default_factory=dict)
    design: Annotated[DesignGoal, Part("goal and constraints of the design", DesignGoal, "give a table")] = field(
        default_factory=DesignGoal
    )
    tolerance: Annotated[Mapping[str, Any], _by_paths("tolerance study: the distribution of each path of the case")] = (
        field(default_factory=dict)
    )
    samples: Annotated[Sampling, Part("sampling of distributions", Sampling, "give a table")] = Sampling()
    limits: Annotated[
        Mapping[str, Any],
        _by_paths("tolerance study: limits of results, such as max_pressure = 'at most 3800 MPa'"),
    ] = field(default_factory=dict)
    quantities: Annotated[Any, Custom("the quantities in a row; the usual ones if left out", _as_given, _TEXTS)] = ()
