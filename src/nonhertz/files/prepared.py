"""A prepared measured profile as text and as files: numbers, a table to solve with, and a fragment of a case file."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from operator import itemgetter
from pathlib import Path
from typing import Any, Final

from nonhertz.amounts import display_units, um
from nonhertz.files import results
from nonhertz.files.measured import KIND
from nonhertz.files.results import Key, ListOf, key_by_key, within
from nonhertz.inputs.files import relative_path
from nonhertz.measured import Measured, ProfileFit
from nonhertz.result.tables import csv_text

TABLE = "profile.csv"
_STEPS: Final = {
    "tilt": "rad",
    **dict.fromkeys(("shift", "low", "high", "land_low", "land_high", "width_low", "depth_low"), "mm"),
    **dict.fromkeys(("width_high", "depth_high", "limit", "cutoff", "rms"), "mm"),
}
_ROUGHNESS: Final = (
    Key("ra", "mean absolute height", "mm"),
    Key("rq", "root mean square height", "mm"),
    Key("rz", "mean of the height differences in sections", "mm"),
    Key("sections", "number of sections", holds="integer"),
    Key("cutoff", "length of a section", "mm"),
    Key(
        "bands", "octaves of wavelength", holds=ListOf((
            Key("from", "shortest", "mm", itemgetter(0)),
            Key("to", "longest", "mm", itemgetter(1)),
            Key("rms", "root mean square height of these", "mm", itemgetter(2)),
        )),
    ),
)  # fmt: skip
_FIT: Final = (
    Key("kind", "kind of profile", holds="string"),
    Key("parameters", "its parameters, in the units of case files", holds="object"),
    Key("standard_errors", "by parameter; null where the trace does not determine it", holds="object"),
    Key("offset", "height added to it", "mm"),
    Key("shift", "shift along y", "mm"),
    Key("tilt", "slope added to it", "rad"),
    Key("rms", "root mean square residual", "mm"),
    Key("largest", "largest residual", "mm"),
    Key("points", "effective number of independent points"),
    Key("penalised", "Bayesian information criterion, by which kinds are ranked"),
)
#: Keys of the file of a prepared profile.
PROFILE: Final = (
    *within(
        "measured",
        Key("name", "the measured file", get="trace.name", holds="string"),
        Key("notes", "notes on how it was read", get="trace.notes", holds=ListOf("string")),
        Key(
            "steps", "name and words of each step, and its numbers", _STEPS, holds=ListOf("object"),
            get=lambda measured: [{"name": step.name, "words": step.words, **step.numbers} for step in measured.states],
        ),
        Key("gaps", "from and to of stretches without points", "mm", "points.gaps", ListOf(ListOf(count=2))),
        Key("roughness", "roughness that smoothing removes", holds=_ROUGHNESS),
    ),
    Key("fits", "fitted profiles, best first", holds=ListOf(_FIT)),
    *within(
        "measured",
        Key("warnings", "warnings, a sentence each", holds=ListOf("string")),
        Key("y", "points of the profile", "mm", "points.y", ListOf()),
        Key("relief", "relief at these", "mm", holds=ListOf()),
    ),
    results.UNITS,
)  # fmt: skip


def as_object(measured: Measured, fits: Sequence[ProfileFit] = ()) -> dict[str, Any]:
    """Return a prepared profile, and fitted ones, best first, as plain numbers, text, lists and dictionaries."""
    return results.document(PROFILE, measured=measured, fits=fits)


def as_table(measured: Measured) -> str:
    """Return positions and relief as CSV, which ``kind = "tabulated"`` reads."""
    # A picometre is finer than any machine resolves.
    rows = zip(measured.points.y.tolist(), measured.relief.tolist(), strict=True)
    return csv_text(["y [mm]", "relief [mm]"], ([f"{y:.9g}", f"{relief:.9f}"] for y, relief in rows))


@display_units("si")
def as_case(file: Path, values: Mapping[str, Any], measured: Measured, fits: Sequence[ProfileFit] = ()) -> str:
    """Return the line of a case file for this profile, with close alternatives as comments.

    Parameters
    ----------
    file : Path
        The measured file, as the case file should refer to it.
    values : mapping
        The other keys of the table of kind ``"measured"``.
    measured : Measured
        The prepared profile.
    fits : sequence of ProfileFit
        Fitted profiles, best first.

    Returns
    -------
    str
        TOML.
    """
    lines = [
        f"# Profile measured in {measured.trace.name}; for [body.a] or [body.b] of a case file beside this one.",
        f"profile = [{_table({'kind': KIND, 'file': file.as_posix(), **values})}]",
        "# Or the resulting points:",
        "# profile = [" + _table({"kind": "tabulated", "file": TABLE, "interpolation": measured.interpolation}) + "]",
    ]
    if fits:
        best = fits[0]
        lines.append(f"# Or the best fit from the catalogue, within {um(best.rms):.2g} root mean square:")
        lines.append(f"# profile = [{_table({'kind': best.kind, **best.parameters, 'shift': best.shift})}]")
    return "\n".join(lines) + "\n"


@display_units("si")
def files(
    directory: Path, file: Path, values: Mapping[str, Any], measured: Measured, fits: Sequence[ProfileFit]
) -> dict[str, str]:
    """Return the texts of profile.json, profile.csv and profile.toml, by file name.

    Parameters
    ----------
    directory : Path
        Their directory, to which the path of the measured file is relative.
    file : Path
        The measured file.
    values : mapping
        The other keys of the table of kind ``"measured"``.
    measured : Measured
        The trace and its steps.
    fits : sequence of ProfileFit
        Fitted profiles, best first.
    """
    return {
        "profile.json": key_by_key(as_object(measured, fits)) + "\n",
        TABLE: as_table(measured),
        "profile.toml": as_case(relative_path(directory, file), values, measured, fits),
    }


def _table(entries: Mapping[str, Any]) -> str:
    # Numbers, booleans and strings are the same in JSON and TOML; the keys need no quotes.
    return "{ " + ", ".join(f"{key} = {json.dumps(value, ensure_ascii=False)}" for key, value in entries.items()) + " }"
