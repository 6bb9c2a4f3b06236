"""A measured profile in a case file: ``{ kind = "measured", file = "roller.txt", height_unit = "um" }``.

The file stays as the machine wrote it; the table says, key by key, how to process it, which is done afresh each time.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Any, get_args

from nonhertz.errors import InputError
from nonhertz.files.traces import read_trace
from nonhertz.findings import warn
from nonhertz.inputs.checks import positive, text
from nonhertz.inputs.fields import Count, Custom, Flag, OrFlag, Quantity, Word, described, unknown
from nonhertz.inputs.files import special
from nonhertz.measured import Measured, Trace, prepare
from nonhertz.measured.steps import Corners, Filter, Middle
from nonhertz.measured.trace import FEWEST_POINTS
from nonhertz.model.profile import Profile, ProfileKind
from nonhertz.model.profile.table import Interpolation

#: The kind's name.
KIND = "measured"
#: Keys that describe the columns of the file.
READING = ("position_unit", "height_unit", "position_column", "height_column", "sense")
#: Keys that say how to process the points.
PREPARING = ("level", "align", "trim", "corner", "outliers", "smooth", "cutoff", "slope", "points")

_QUOTES = "put it in quotes"


def _column(name: str, value: Any, remedy: str) -> Any:
    if isinstance(value, bool) or not isinstance(value, str | int | float):
        raise InputError(name, value, "be a whole number or text", remedy)
    return value


_COLUMN = {"anyOf": [{"type": "integer", "minimum": 1}, {"type": "string"}]}
_WHICH = "give its number from 1, or its name"


@described(kw_only=True)
class MeasuredProfile(ProfileKind):
    """A measured profile, prepared step by step."""

    file: Annotated[
        str, Word("the measured file; its path is relative to the case file", "name it in quotes", condition=text)
    ]
    position_unit: Annotated[
        str | None,
        Word("unit of the positions; what the file states, or mm, if left out", _QUOTES, condition=text),
    ] = None
    height_unit: Annotated[
        str | None,
        Word("unit of the heights; what the file states, or mm, if left out", _QUOTES, condition=text),
    ] = None
    position_column: Annotated[
        int | str | None, Custom("column of the positions, by number from 1 or by name", _column, _COLUMN, _WHICH)
    ] = None
    height_column: Annotated[
        int | str | None, Custom("column of the heights, by number from 1 or by name", _column, _COLUMN, _WHICH)
    ] = None
    sense: Annotated[
        str | None,
        Word(
            "whether the column is positive where material is, 'height', or where it is taken away, 'drop'",
            "write 'height' or 'drop'",
            ("height", "drop"),
        ),
    ] = None
    level: Annotated[bool | None, Flag("whether to take off the tilt at which the body lay in the machine")] = None
    align: Annotated[
        bool | Middle | None,
        OrFlag(
            Word("", "choose how to find the middle", get_args(Middle)),
            "how the middle of the body is found; false leaves y as it is",
        ),
    ] = None
    trim: Annotated[
        bool | float | str | None,
        OrFlag(
            Quantity("mm", "", positive, "give the length to keep in mm, or 'auto'", {"auto": "land and corners"}),
            "'auto' finds the land and its corners, a length is kept about y = 0, false keeps all",
        ),
    ] = None
    corner: Annotated[
        Corners | None,
        Word(
            "whether corners that the trace holds are kept, smoothed apart from the land, or cut off",
            "choose what becomes of the corners",
            get_args(Corners),
        ),
    ] = None
    outliers: Annotated[
        bool | float | None,
        OrFlag(
            Quantity("", "", positive, "give a number of robust standard deviations, such as 5"),
            "robust standard deviations beyond which points are taken out; true for 5, false for none",
        ),
    ] = None
    smooth: Annotated[
        bool | Filter | None,
        OrFlag(Word("", "choose a filter", get_args(Filter)), "the filter that takes roughness off, or false"),
    ] = None
    cutoff: Annotated[
        float | None,
        Quantity(
            "mm",
            "wavelength of which the filter lets half through",
            positive,
            "give a wavelength in mm, such as 0.8",
        ),
    ] = None
    slope: Annotated[
        float | None,
        Quantity(
            "",
            "slope at which a chamfer begins",
            positive,
            "give the slope at which a chamfer begins, 0.05 being 50 um in a millimetre",
        ),
    ] = None
    points: Annotated[
        bool | int | str | None,
        OrFlag(
            Count("", FEWEST_POINTS, float("inf"), "give a number of points to keep", {"auto": "eight per cutoff"}),
            "how many points to keep; 'auto' for eight per cutoff, false for all",
        ),
    ] = None
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
            Directory that the name of its file is relative to.

        Raises
        ------
        InputError
            If the file cannot be read, or a step does not suit it.

        Warns
        -----
        AccuracyWarning
            Limitations to know before solving with the profile, such as roughness that strips cannot resolve.
        """
        if special(folder / self.file):
            raise InputError("file", self.file, "be a file, not a device or a pipe", "save the measured points in one")
        values = {name: value for name, value in vars(self).items() if value is not None}
        measured = measured_from(trace_from(folder / self.file, values), values)
        warn(measured.findings_for())
        return measured.profile(self.interpolation)


def checked(name: str, value: Any) -> Any:
    """Return the value of a key, lengths in mm.

    Raises
    ------
    InputError
        If the key is unknown or its value is of the wrong kind.
    """
    known = MeasuredProfile.descriptions
    if name not in known:
        raise unknown(name, value, f"parameter of '{KIND}'", name, known)
    return known[name].take(name, value)


def measured_from(trace: Trace, values: Mapping[str, Any]) -> Measured:
    """Return a trace processed by the steps that the checked values specify.

    Raises
    ------
    InputError
        If a value is out of range.
    """
    return prepare(trace, **{name: values[name] for name in PREPARING if name in values})


def trace_from(source: Path | bytes, values: Mapping[str, Any], name: str | None = None) -> Trace:
    """Return the trace in a file, with its columns read as the checked values specify.

    Raises
    ------
    InputError
        If it cannot be read.
    """
    return read_trace(source, name, **{key: values[key] for key in READING if key in values})
