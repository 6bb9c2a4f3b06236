"""The tables of a plan file, as pydantic models."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Annotated, Any

from pydantic import Field, PlainValidator, WithJsonSchema, field_validator

from nonhertz.errors import InputError
from nonhertz.inputs.checks import one_line
from nonhertz.io.bounds import FORMAT
from nonhertz.io.document import Angle, Force, Format, Number, Table, read_loads
from nonhertz.io.mistakes import unknown
from nonhertz.io.sampling import METHODS, Sampling

if TYPE_CHECKING:
    from nonhertz.life import LoadCase

_VARIED_SCHEMA = {
    "type": "object",
    "additionalProperties": {"anyOf": [{"type": "string"}, {"type": "array", "minItems": 1}, {"type": "object"}]},
}


def flat(tables: Mapping[str, Any]) -> Iterator[tuple[str, Any]]:
    """Yield paths and values of tables in tables: TOML makes them of dotted keys without quotes.

    Examples
    --------
    >>> list(flat({"load": {"tilt": "0 : 1 mrad : 3"}, "load.load": [1.0]}))
    [('load.tilt', '0 : 1 mrad : 3'), ('load.load', [1.0])]
    """
    for key, value in tables.items():
        if isinstance(value, dict):
            yield from ((f"{key}.{below}", entry) for below, entry in flat(value))
        else:
            yield key, value


def _read_varied(value: Any) -> dict[str, Any]:
    if not isinstance(value, dict):
        remedy = "write a line for each path, such as \"load.load\" = '5 kN : 40 kN : 8'"
        raise InputError("over", value, "be a table", remedy)
    return dict(flat(value))


Varied = Annotated[dict[str, Any], PlainValidator(_read_varied), WithJsonSchema(_VARIED_SCHEMA)]
Unread = Annotated[Any, PlainValidator(lambda value: value)]


class SamplesTable(Table):
    """How samples are drawn from distributions."""

    count: Annotated[Unread, WithJsonSchema({"type": "integer", "minimum": 1})] = Field(
        default=Sampling.count, description="how many"
    )
    method: Annotated[Unread, WithJsonSchema({"enum": list(METHODS)})] = Field(
        default=Sampling.method, description="'latin-hypercube', 'sobol' or 'random'; 'saltelli' for indices"
    )
    seed: Annotated[Unread, WithJsonSchema({"type": "integer", "minimum": 0})] = Field(
        default=Sampling.seed, description="a whole number; the same draws the same samples"
    )

    @field_validator("count", "method", "seed")
    @classmethod
    def _check(cls, value: Any, info: Any) -> Any:
        return getattr(Sampling(**{str(info.field_name): value}), str(info.field_name))

    def sampling(self) -> Sampling:
        """Return the sampling."""
        return Sampling(self.count, self.method, self.seed)


class DesignLoadTable(Table):
    """One load of a design."""

    load: Force = Field(description="the load that presses the bodies together [N]")
    tilt: Angle = Field(default=0.0, description="tilt [rad], positive loads the side of positive y")
    share: Number | None = Field(default=None, description="its share of the revolutions; all equal if no load has one")


def _read_loads(value: Any) -> tuple[DesignLoadTable, ...]:
    return read_loads(value, DesignLoadTable)


class DesignTable(Table):
    """What a design is best for."""

    goal: Annotated[Unread, WithJsonSchema({"enum": ["pressure", "life"]})] = Field(
        default=None,
        description="'pressure': the least largest pressure; 'life': the longest life; pressure if left out",
    )
    model: Unread = Field(
        default=None, description="name of the fatigue model of lives; 'lundberg-palmgren' if left out"
    )
    starts: Annotated[Unread, WithJsonSchema({"type": "integer", "minimum": 1})] = Field(
        default=None, description="number of searches, 5 if left out"
    )
    loads: Annotated[
        tuple[DesignLoadTable, ...],
        PlainValidator(_read_loads),
        WithJsonSchema({"type": "array", "items": DesignLoadTable.model_json_schema(), "minItems": 1}),
    ] = Field(default=(), description="the loads; those of the case if left out")
    where: Varied = Field(
        default_factory=dict, description="what must hold under every load, such as approach = 'at most 30 um'"
    )

    @field_validator("model")
    @classmethod
    def _check_model(cls, value: Any) -> Any:
        from nonhertz.life import MODELS

        if not isinstance(value, str) or value not in MODELS:
            raise unknown("model", value, "fatigue model", value, MODELS)
        return value

    def cases(self) -> tuple[LoadCase, ...]:
        """Return the loads with their shares."""
        from nonhertz.life import LoadCase

        even = 1.0 / len(self.loads)
        unsaid = all(each.share is None for each in self.loads)
        return tuple(
            LoadCase(load=each.load, tilt=each.tilt, share=even if unsaid else (each.share or 0.0))
            for each in self.loads
        )


class PlanTable(Table):
    """A plan file."""

    format: Format = Field(default=FORMAT, description="format of the file")
    title: str = Field(default="", description="what the study is called in tables and figures")
    case: str = Field(description="the case file or bearing file that is varied, relative to the plan")
    over: Varied = Field(
        default_factory=dict, description="of a sweep: what each path of the case runs over; all combinations are rows"
    )
    vary: Varied = Field(
        default_factory=dict, description="of a design: lowest and highest value of each path that it may choose"
    )
    design: DesignTable = Field(default_factory=DesignTable, description="what the design is best for")
    tolerance: Varied = Field(
        default_factory=dict, description="of a tolerance study: the distribution of each path of the case"
    )
    samples: SamplesTable = Field(default_factory=SamplesTable, description="how samples are drawn from distributions")
    quantities: Annotated[Unread, WithJsonSchema({"type": "array", "items": {"type": "string"}})] = Field(
        default=(), description="the numbers that a row holds; the usual ones if left out"
    )

    @field_validator("title", "case")
    @classmethod
    def _check(cls, value: str, info: Any) -> str:
        one_line(str(info.field_name), value, "write a short name")
        return value
