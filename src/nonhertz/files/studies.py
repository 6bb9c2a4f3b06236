"""Sweeps, tolerance studies, designs and fronts as JSON: a table of keys for each of them."""

from __future__ import annotations

import json
from collections.abc import Iterable
from operator import attrgetter, itemgetter
from pathlib import Path
from typing import Any, Final

from nonhertz.files import results
from nonhertz.files.results import Get, Key, ListOf, MapOf, input_keys, within
from nonhertz.life import ContactLoadCase


def _of_quantities(method: str, quantities: str) -> Get:
    """Return a function of a study that calls its method with the name of each of its quantities."""
    get = attrgetter(quantities)
    return lambda study: {quantity.name: getattr(study, method)(quantity.name) for quantity in get(study)}


def _units_of_rows(sweep: Any) -> dict[str, str]:
    return {name: sweep.unit(name) for name in (*sweep.paths, *(quantity.name for quantity in sweep.quantities))}


_RESULTS: Final = "results other than given quantities and positions"
_VALUES: Final = MapOf(("number", "string", "boolean", "array", "object", "null"))
_FILES: Final = Key(
    "files", "files that were written", get=lambda study: [*map(str, study.files)], holds=ListOf("string")
)
_ROWS: Final = within(
    "sweep",
    Key("title", "title of the plan", get="plan.title", holds="string"),
    Key("rows", "number of rows", get=len, holds="integer"),
    Key("failed", "number of failed rows", holds="integer"),
)
_ASSUMED: Final = results.assumed_key("sweep.assumed")
_REASON: Final = (
    Key("sentence", "why", get=itemgetter(0), holds="string"),
    Key("rows", "number of rows that failed for this reason", get=itemgetter(1), holds="integer"),
    Key("first", "the first of them, from 0", get=itemgetter(2), holds="integer"),
)
_REASONS: Final = Key(
    "failures", "the commonest reasons why rows failed", get=lambda study: study.sweep.reasons(), holds=ListOf(_REASON)
)
_UNITS_OF_ROWS: Final = Key(
    "units", "units of paths and quantities; empty of dimensionless ones", holds=MapOf("string"),
    get=lambda study: _units_of_rows(study.sweep),
)  # fmt: skip
#: Keys of a sweep.
SWEEP: Final = (
    *_ROWS,
    results.verdict_key(attrgetter("sweep.verdict")),
    _ASSUMED,
    *within(
        "sweep",
        Key("over", "paths that are varied", get="paths", holds=ListOf("string")),
        Key("shape", "numbers of values along the axes of the rows", holds=ListOf("integer")),
        Key(
            "extremes", "least and greatest number of each quantity; null if no row has one",
            get=_of_quantities("extremes", "quantities"), holds=MapOf(("array", "null")),
        ),
    ),
    _REASONS,
    _FILES,
    _UNITS_OF_ROWS,
)  # fmt: skip

_BEST: Final = (
    Key("value", "value of the input", get=itemgetter(0)),
    Key("life", "the life", "10^6 revolutions", itemgetter(1)),
)
#: Keys of a diagram of a bearing.
DIAGRAM: Final = (
    *_ROWS,
    results.verdict_key(attrgetter("sweep.verdict")),
    _ASSUMED,
    *within(
        "diagram",
        Key("over", "the input that is varied", get="path", holds="string"),
        Key("present", "its value in the file; null if it has none there"),
        Key("values", "its values", holds=ListOf()),
        Key("longest_life", "the value with the longest life; null without a life", "", holds=_BEST, nullable=True),
        Key(
            "numbers", "numbers over the values, by quantity", holds=MapOf(ListOf()),
            get=lambda diagram: {quantity.name: diagram.sweep[quantity.name] for quantity in diagram.quantities},
        ),
    ),
    _REASONS,
    _FILES,
    _UNITS_OF_ROWS,
)  # fmt: skip

_CERTAIN: Final = "95 % two-sided"
_QUANTILE: Final = (
    Key("share", "fraction of all results below it", get="probability"),
    Key("value", "the estimate; null without samples"),
    Key("low", f"lower confidence limit, {_CERTAIN}; null with too few samples"),
    Key("high", f"upper confidence limit, {_CERTAIN}; null with too few samples"),
)
_CAPABILITY: Final = (
    Key("quantity", "the quantity", holds="string"),
    Key("kind", "of limit", holds=["at most", "at least"]),
    Key("limit", "the limit"),
    Key("samples", "number of samples", holds="integer"),
    Key("beyond", "number of samples beyond the limit", holds="integer"),
    Key("share", "fraction beyond the limit", get="fraction"),
    Key("low", f"lower confidence limit of the fraction, {_CERTAIN}"),
    Key("high", f"upper confidence limit of the fraction, {_CERTAIN}"),
    Key("mean", "mean of the samples"),
    Key("deviation", "standard deviation of the samples"),
    Key("cpk", "one-sided capability index; null if nothing varies"),
)
_INDEX: Final = (
    Key("path", "the parameter", holds="string"),
    Key("first", "share of the variance that would be gone if it were fixed"),
    Key("first_low", f"lower confidence limit, {_CERTAIN}"),
    Key("first_high", f"upper confidence limit, {_CERTAIN}"),
    Key("total", "share of the variance that would be left if all others were fixed"),
    Key("total_low", f"lower confidence limit, {_CERTAIN}"),
    Key("total_high", f"upper confidence limit, {_CERTAIN}"),
)
#: Keys of a tolerance study.
TOLERANCE: Final = (
    *_ROWS,
    results.verdict_key(attrgetter("tolerance.verdict")),
    _ASSUMED,
    *within(
        "tolerance",
        Key("independent_samples", "rows that are independent samples", get="independent.size", holds="integer"),
        Key(
            "quantiles", "quantiles of each quantity", get=_of_quantities("quantiles", "sweep.quantities"),
            holds=MapOf(ListOf(_QUANTILE)),
        ),
        Key("limits", "samples compared with limits", get="capabilities", holds=ListOf(_CAPABILITY)),
        Key(
            "indices", f"of {_RESULTS}: how much of the variance is due to each parameter",
            get=_of_quantities("indices", "results"), holds=MapOf(ListOf(_INDEX)),
        ),
        Key("tightened_first", f"of {_RESULTS}: parameters to tighten first", holds=MapOf(ListOf("string"))),
    ),
    _REASONS,
    _FILES,
    _UNITS_OF_ROWS,
)  # fmt: skip

_START: Final = (
    Key("begun", "values of the paths at its start", holds=_VALUES),
    Key("ended", "values of the paths at its end", holds=_VALUES),
    Key("value", "the goal at its end; null if it failed"),
    Key("history", "the goal after each step", holds=ListOf()),
    Key("meets", "whether it meets the bounds", holds="boolean"),
    Key("failure", "why it failed; empty if it did not", holds="string"),
)
_BAND: Final = (
    Key("path", "the variable", holds="string"),
    Key("cost", "relative loss of the goal at the ends"),
    Key("low", "low end"),
    Key("high", "high end"),
)
#: Keys of a design.
DESIGN: Final = (
    *within(
        "design",
        Key("title", "title of the case", get="was.title", holds="string"),
        Key("goal", "goal of the design", holds=["pressure", "life"]),
        Key("values", "the best values of the paths", holds=_VALUES),
        Key("value", "the goal there: the maximum pressure, or the life relative to that of the case"),
        Key("before", "the goal of the original case"),
        Key("worst", "load with the maximum pressure, or with the largest share of the damage", holds="string"),
        results.verdict_key(attrgetter("verdict")),
        Key("agreeing_starts", "searches that agree within 1 %", get="agreeing", holds="integer"),
        Key("starts", "the searches, the best first", holds=ListOf(_START)),
        *results.warning_keys(attrgetter("findings")),
        results.assumed_key("was.assumed"),
        Key("bands", "ranges of values in which the goal is worse by no more than a cost", holds=ListOf(_BAND)),
        Key("loads", "the loads", holds=ListOf(input_keys(ContactLoadCase))),
    ),
    _FILES,
    Key(
        "units", "units of the paths and of the goal", holds=MapOf("string"),
        get=lambda study: study.design.units | {"value": "MPa" if study.design.goal == "pressure" else ""},
    ),
)  # fmt: skip

_POINT: Final = (
    Key("values", "values of the paths", get=itemgetter(0), holds=_VALUES),
    Key("max_pressure_without_tilt", "maximum pressure under the loads without tilt", "MPa", itemgetter(1)),
    Key("max_pressure_with_tilt", "maximum pressure under the loads with tilt", "MPa", itemgetter(2)),
)
#: Keys of a front.
FRONT: Final = (
    *within(
        "front",
        Key(
            "points", "from the best for loads with tilt to the best for those without", "", holds=ListOf(_POINT),
            get=lambda front: zip(front.values, front.first, front.second, strict=True),
        ),
        results.verdict_key(attrgetter("verdict")),
        *results.warning_keys(attrgetter("findings")),
        Key("units", "units of the paths", holds=MapOf("string")),
    ),
    _FILES,
)  # fmt: skip


def as_text(keys: Iterable[Key], files: Iterable[Path] = (), **study: Any) -> str:
    """Return a study as JSON text, with the files that were written; ``study`` has its parts by name."""
    return json.dumps(results.document(keys, files=files, **study), indent=2, allow_nan=False)
