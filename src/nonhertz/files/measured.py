"""A measured profile in a case file: ``{ kind = "measured", file = "roller.txt", height_unit = "um" }``.

The file stays as the machine wrote it; the keys of the table say how to process it, each time it is read.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Annotated, Any, get_args

from nonhertz.errors import InputError
from nonhertz.files.traces import read_trace
from nonhertz.files.traces.line import Request
from nonhertz.findings import warn
from nonhertz.inputs.checks import text
from nonhertz.inputs.descriptions import Word, unknown_key_error
from nonhertz.inputs.fields import input_class, parameters_class
from nonhertz.inputs.files import is_special_file
from nonhertz.measured.chain import Measured, prepare
from nonhertz.measured.steps import Corners, Filter, Middle
from nonhertz.measured.trace import Trace
from nonhertz.model.profile import Profile, ProfileKind
from nonhertz.model.profile.table import Interpolation

#: The kind's name.
KIND = "measured"
_STEPS = parameters_class(prepare).descriptions
_COLUMNS = Request.descriptions
#: Keys that describe the columns of the file.
READING = tuple(name for name in _COLUMNS if name != "name")
#: Keys that say how to process the points.
PREPARING = tuple(name for name in _STEPS if name != "trace")


@input_class(kw_only=True)
class MeasuredProfile(ProfileKind):
    """A measured profile, prepared step by step."""

    file: Annotated[
        str, Word("the measured file; its path is relative to the case file", "name it in quotes", condition=text)
    ]
    position_unit: Annotated[str | None, _COLUMNS["position_unit"]] = None
    height_unit: Annotated[str | None, _COLUMNS["height_unit"]] = None
    position_column: Annotated[int | str | None, _COLUMNS["position_column"]] = None
    height_column: Annotated[int | str | None, _COLUMNS["height_column"]] = None
    sense: Annotated[str | None, _COLUMNS["sense"]] = None
    step: Annotated[float | None, _COLUMNS["step"]] = None
    level: Annotated[bool | None, _STEPS["level"]] = None
    align: Annotated[bool | Middle | None, _STEPS["align"]] = None
    trim: Annotated[bool | float | str | None, _STEPS["trim"]] = None
    corner: Annotated[Corners | None, _STEPS["corner"]] = None
    outliers: Annotated[bool | float | None, _STEPS["outliers"]] = None
    smooth: Annotated[bool | Filter | None, _STEPS["smooth"]] = None
    cutoff: Annotated[float | None, _STEPS["cutoff"]] = None
    slope: Annotated[float | None, _STEPS["slope"]] = None
    points: Annotated[bool | int | str | None, _STEPS["points"]] = None
    interpolation: Annotated[
        Interpolation | None,
        Word(
            "the curve through the points; 'cubic' for smoothed ones, else 'pchip', if left out",
            "choose the curve through the points",
            get_args(Interpolation),
        ),
    ] = None

    def profile(self, folder: Path) -> Profile:
        """Return the measured profile after all steps.

        Parameters
        ----------
        folder : Path
            Directory to which the name of its file is relative.

        Raises
        ------
        InputError
            If the file cannot be read, or a step does not suit it.

        Warns
        -----
        AccuracyWarning
            Limitations to know before solving with the profile, such as roughness that strips cannot resolve.
        """
        if is_special_file(folder / self.file):
            raise InputError("file", self.file, "be a file, not a device or a pipe", "save the measured points in one")
        values = {name: value for name, value in vars(self).items() if value is not None}
        measured = read_measured(folder / self.file, values)
        warn(measured.findings_for())
        return measured.profile(self.interpolation)


def validate_key(name: str, value: Any) -> Any:
    """Return the value of a key, lengths in mm.

    Raises
    ------
    InputError
        If the key is unknown or its value is of the wrong kind.
    """
    known = MeasuredProfile.descriptions
    if name not in known:
        raise unknown_key_error(name, value, known, "parameter", f"'{KIND}'")
    return known[name].validate(name, value)


def read_measured(
    source: Path | bytes,
    values: Mapping[str, Any],
    name: str | None = None,
    change: Callable[[Trace], Trace] | None = None,
) -> Measured:
    """Return the profile in a file, read and prepared as checked values specify.

    ``change`` is applied to the trace before any step.

    Raises
    ------
    InputError
        If it cannot be read, or a value is out of range.
    """
    trace = read_trace(source, name, **{key: values[key] for key in READING if key in values})
    trace = trace if change is None else change(trace)
    return prepare(trace, **{key: values[key] for key in PREPARING if key in values})
