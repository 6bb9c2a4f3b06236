"""From a measured file to the points of a profile, with the effect of each step."""

from __future__ import annotations

import json
from typing import Any, Final

import numpy as np

from nonhertz.amounts import mm, um
from nonhertz.errors import InputError
from nonhertz.figures.measured import measured_steps
from nonhertz.files.measured import read_measured, validate_key
from nonhertz.measured import Measured, Trace
from nonhertz.measured.corners import positions
from nonhertz.measured.trace import FEWEST_POINTS
from nonhertz.model.profile import Tabulated
from nonhertz.model.profile.table import Interpolation
from nonhertz.web.limits import UPLOAD_POINTS
from nonhertz.web.view.replies import broken, job

MOST_POINTS: Final = 300
"""Points of the profile; more would affect no result, and the whole case is sent with every request."""
_NANOMETRES: Final = 6  # decimals of a mm


@job
def answer_to_file(content: bytes, name: str, options: dict[str, str]) -> dict[str, Any]:
    """Answer to a measured file with points, steps, roughness and warnings, or with its mistakes.

    Parameters
    ----------
    content : bytes
        The file.
    name : str
        Its name.
    options : dict
        Keys of a profile of kind "measured", as text.
    """
    values, mistakes = {}, []
    for option, text in options.items():
        try:
            values[option] = validate_key(option, _value(text))
        except InputError as error:
            mistakes.append((_path(option), str(error)))
    if mistakes:
        return broken(mistakes)
    try:
        return _answer(read_measured(content, values, name, _average), values.get("interpolation"))
    except InputError as error:
        return broken([(_path(error.field), str(error))])


def _average(trace: Trace) -> Trace:
    """Return a trace with no more points than the page accepts, averaging neighbours, which are closer than any cutoff.

    Points are not averaged across a gap.
    """
    every = -(-len(trace) // UPLOAD_POINTS)
    if every == 1:
        return trace
    behind_gaps = np.searchsorted(trace.y, [high for _, high in trace.gaps])
    starts = np.union1d(np.arange(0, len(trace), every), behind_gaps).astype(np.intp)
    counts = np.diff(starts, append=len(trace))
    y, height = (np.add.reduceat(values, starts) / counts for values in (trace.y, trace.height))
    note = f"Groups of {every} of the {len(trace)} points were averaged; 'nonhertz profile' uses all points."
    return Trace(y, height, trace.gaps, name=trace.name, notes=(*trace.notes, note))


def _value(text: str) -> Any:
    """Return the value of a query parameter: true, false, a number, or the text itself."""
    try:
        value = json.loads(text)
    except (ValueError, RecursionError):
        return text
    return value if isinstance(value, bool | int | float) else text


def _path(field: str) -> str:
    return f"upload.{field}" if field.isidentifier() and field != "file" else "upload"


def _answer(measured: Measured, interpolation: Interpolation | None) -> dict[str, Any]:
    roughness = measured.roughness
    profile = _short(measured).profile(interpolation)
    assert isinstance(profile, Tabulated)
    return {
        "ok": True,
        "name": measured.trace.name,
        "table": {
            "kind": "tabulated",
            "y": [round(y, _NANOMETRES) for y in profile.y],
            "relief": [round(relief, _NANOMETRES + 2) for relief in profile.values],
            "interpolation": profile.interpolation,
        },
        "steps": measured_steps(measured).to_json(),
        "notes": list(measured.trace.notes),
        "roughness": [
            *([name, f"{um(getattr(roughness, name.lower())):3}", ""] for name in ("Ra", "Rq", "Rz")),
            ["cutoff", f"{mm(roughness.cutoff):3}", f"{roughness.sections} sections"],
        ],
        "warnings": list(measured.warnings),
    }


def _short(measured: Measured) -> Measured:
    """Return a measured profile with no more points than the page is sent."""
    if measured.points.y.size <= MOST_POINTS:
        return measured
    thinned = measured.states[-1].name == "thin"
    whole = measured.without("thin") if thinned else measured
    # Corners keep points of their own, and so does the land beside them.
    return whole.thinned(max(MOST_POINTS - positions(whole.points).size, FEWEST_POINTS))
