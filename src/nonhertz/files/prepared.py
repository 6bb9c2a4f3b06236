"""A prepared measured profile as text and as files: numbers, a table to solve with, and a fragment of a case file."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from nonhertz.amounts import read_in, um
from nonhertz.files.measured import KIND
from nonhertz.files.results import key_by_key, plain
from nonhertz.inputs.files import seen_from
from nonhertz.measured import Measured, ProfileFit, Roughness
from nonhertz.result.tables import csv_text

#: Units of the numbers; dimensionless ones are left out. Fitted parameters have the units of the catalogue.
UNITS: dict[str, Any] = {
    "steps": {
        "tilt": "rad",
        **dict.fromkeys(("shift", "low", "high", "land_low", "land_high", "width_low", "depth_low"), "mm"),
        **dict.fromkeys(("width_high", "depth_high", "limit", "cutoff", "rms"), "mm"),
    },
    "roughness": {"ra": "mm", "rq": "mm", "rz": "mm", "cutoff": "mm", "bands": {"from": "mm", "to": "mm", "rms": "mm"}},
    "fits": {"offset": "mm", "shift": "mm", "tilt": "rad", "rms": "mm", "largest": "mm"},
    "y": "mm",
    "relief": "mm",
}
TABLE = "profile.csv"


@read_in("si")
def as_object(measured: Measured, fits: Sequence[ProfileFit] = ()) -> dict[str, Any]:
    """Return a prepared profile as plain numbers, text, lists and dictionaries.

    Parameters
    ----------
    measured : Measured
        The trace and its steps.
    fits : sequence of ProfileFit
        Fitted profiles, best first.

    Returns
    -------
    dict
        Non-finite numbers are None.
    """
    return {
        "name": measured.trace.name,
        "notes": list(measured.trace.notes),
        "steps": [{"name": state.name, "words": state.words} | plain(state.numbers) for state in measured.states],
        "gaps": plain(measured.points.gaps),
        "roughness": _roughness(measured.roughness),
        "fits": [plain(vars(fit)) for fit in fits],
        "warnings": list(measured.warnings),
        "y": plain(measured.points.y),
        "relief": plain(measured.relief),
        "units": UNITS,
    }


def as_table(measured: Measured) -> str:
    """Return positions and relief as CSV, which ``kind = "tabulated"`` reads."""
    # A picometre is finer than any machine resolves.
    rows = zip(measured.points.y.tolist(), measured.relief.tolist(), strict=True)
    return csv_text(["y [mm]", "relief [mm]"], ([f"{y:.9g}", f"{relief:.9f}"] for y, relief in rows))


@read_in("si")
def as_case(file: Path, values: Mapping[str, Any], measured: Measured, fits: Sequence[ProfileFit] = ()) -> str:
    """Return the line of a case file that makes this profile, with alternatives that come close as comments.

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


@read_in("si")
def files(
    directory: Path, file: Path, values: Mapping[str, Any], measured: Measured, fits: Sequence[ProfileFit]
) -> dict[str, str]:
    """Return the texts of profile.json, profile.csv and profile.toml, by file name.

    Parameters
    ----------
    directory : Path
        Where they will be: the case file's path to the measured file is relative to it.
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
        "profile.toml": as_case(seen_from(directory, file), values, measured, fits),
    }


def _table(entries: Mapping[str, Any]) -> str:
    # Numbers, booleans and strings are written alike in JSON and TOML; the keys need no quotes.
    return "{ " + ", ".join(f"{key} = {json.dumps(value, ensure_ascii=False)}" for key, value in entries.items()) + " }"


def _roughness(roughness: Roughness) -> dict[str, Any]:
    bands = [{"from": low, "to": high, "rms": rms} for low, high, rms in roughness.bands]
    heights = {"ra": roughness.ra, "rq": roughness.rq, "rz": roughness.rz}
    return heights | {"sections": roughness.sections, "cutoff": roughness.cutoff, "bands": bands}
