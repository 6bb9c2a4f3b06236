"""The output of all readers: positions and heights as in the file, and from these a sorted trace."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Annotated, Any

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import mm
from nonhertz.errors import InputError
from nonhertz.files.traces.lengths import millimetres
from nonhertz.inputs.checks import positive, text
from nonhertz.inputs.descriptions import Custom, Quantity, Word
from nonhertz.inputs.fields import Input, input_class
from nonhertz.measured.trace import FEWEST_POINTS, LONGEST, Array, Trace, dropouts, holes, usual_step

#: Points of the longest line that is read.
MOST_POINTS = 500_000
# Heights without a unit are taken as mm only below this fraction of the line's length and below this median slope from
# point to point: a flat line in um without chamfers is given away by its roughness alone.
_PLAUSIBLE, _PLAUSIBLE_SLOPE = 0.1, 0.5
# No machine measures beyond a kilometre or within a nanometre [mm]; some write 3.4e38 for "not measured".
_LARGEST, _SHORTEST = 1e6, 1e-6
# Positions closer than this fraction of the usual step, and than a nanometre, count as one: strokes differ by rounding.
_SAME = 1e-3


def _column(name: str, value: Any, remedy: str) -> Any:
    if isinstance(value, bool) or not isinstance(value, str | int | float):
        raise InputError(name, value, "be a whole number or text", remedy)
    return value


def check_length_unit(name: str, value: Any, remedy: str) -> None:
    """Refuse what is not a unit of length."""
    text(name, value, remedy)
    length_factor(name, value)


_QUOTES = "put it in quotes"
_COLUMN = {"anyOf": [{"type": "integer", "minimum": 1}, {"type": "string"}]}
_WHICH = "give its number from 1, or its name"


@input_class()
class Request(Input):
    """The caller's options for a file; see `nonhertz.files.read_trace`."""

    name: Annotated[str, Word("name of the file in messages", "give its name", condition=text)]
    position_unit: Annotated[
        str | None,
        Word("unit of the positions; what the file states, or mm, if left out", _QUOTES, condition=check_length_unit),
    ] = None
    height_unit: Annotated[
        str | None,
        Word("unit of the heights; what the file states, or mm, if left out", _QUOTES, condition=check_length_unit),
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
            "whether the column is positive where there is material, 'height', or where it is removed, 'drop'",
            "write 'height' or 'drop'",
            ("height", "drop"),
        ),
    ] = None
    step: Annotated[
        float | None,
        Quantity(
            "mm",
            "distance between neighbouring points if the file has only heights, one per line, or numbers of points "
            "for positions; by default that stated in the file",
            positive,
            "give it with its unit, such as '0.5 um'",
        ),
    ] = None

    def error(self, condition: str, remedy: str) -> InputError:
        """Return an error about the file."""
        return InputError("file", self.name, condition, remedy)

    def refuse_choices(self, what: str) -> None:
        """Refuse units and columns for a format that states its own."""
        for field in ("position_unit", "height_unit", "position_column", "height_column", "step"):
            value = getattr(self, field)
            if value is not None:
                raise InputError(field, value, f"not be given for {what}, which states its own", "leave it out")


@dataclass(frozen=True, eq=False)
class Line:
    """A measured line as a file has it.

    Attributes
    ----------
    y, height : array
        Positions and heights [mm], NaN where nothing was measured.
    notes : tuple of str
        How it has been processed so far.
    units_known : (bool, bool)
        Whether the units of positions and heights were stated.
    drop : bool
        Whether the heights are positive where material is removed.
    """

    y: Array
    height: Array
    notes: tuple[str, ...] = ()
    units_known: tuple[bool, bool] = (True, True)
    drop: bool = False

    def noted(self, *notes: str) -> Line:
        """Return the line with more notes in front."""
        return replace(self, notes=(*notes, *self.notes))


def length_factor(field: str, unit: str) -> float:
    """Return how many mm a unit is.

    Raises
    ------
    InputError
        If it is not a unit of length.
    """
    if (factor := millimetres(unit)) is not None:
        return factor
    from nonhertz.inputs.units import to_unit

    try:
        return float(to_unit(field, unit if unit[:1].isdigit() else f"1 {unit}", "mm"))
    except InputError:
        raise InputError(field, unit, "be a unit of length", "write mm, um, nm, m or in") from None


def build_trace(line: Line, request: Request) -> Trace:
    """Return the trace of a line: in ascending order, each position once, gaps known.

    Raises
    ------
    InputError
        If there are too few or too many points, or heights without a unit that cannot be in mm.
    """
    if len(line.y) > MOST_POINTS:
        raise request.error(f"hold no more than {MOST_POINTS:,} points", "export fewer; a few thousand are enough")
    notes = list(line.notes)
    measured = np.isfinite(line.y) & np.isfinite(line.height)
    if not np.all(measured):
        notes.append(f"{int(np.sum(~measured))} of {len(measured)} points have no value and were left out.")
    y, height = line.y[measured], line.height[measured]
    if len(y) == 0:
        raise request.error("hold measured points (there is no pair of numbers)", "export the profile again")
    y, height = _sort_points(y, height, notes)
    if len(y) < FEWEST_POINTS:
        clause = "is only one" if len(y) == 1 else f"are only {len(y)}"
        raise request.error(f"hold at least {FEWEST_POINTS} positions (there {clause})", "measure more points")
    _check_size(y, height, request)
    _check_plausible(y, height, line.units_known, request)
    unknown = [what for what, known in zip(("positions", "heights"), line.units_known, strict=True) if not known]
    if unknown:
        notes.append(f"The file states no unit for its {' and '.join(unknown)}; they were taken as mm.")
    if (request.sense or ("drop" if line.drop else "height")) == "drop":
        height = -height
        notes.append("The column is positive where material is removed; its sign was reversed.")
    gaps = tuple(sorted({*dropouts(y, *_find_unmeasured(line, measured)), *holes(y)}))
    if gaps:
        places = ", ".join(f"{mm(*gap, between=' to '):.5g}" for gap in gaps[:5]) + (", ..." if len(gaps) > 5 else "")
        notes.append(f"Nothing was measured from y = {places}.")
    return Trace(y, height, gaps, name=request.name, notes=tuple(notes))


def _find_unmeasured(line: Line, known: NDArray[np.bool_]) -> tuple[Array, Array]:
    """Return positions at which nothing was measured, and pairs of measured ones with unmeasured ones between them.

    A point without a height has its own position, wherever it is in the file. One without a position can be located
    only by its neighbours in the file.
    """
    nowhere = ~np.isfinite(line.y)
    places = np.flatnonzero(known)
    passed = np.diff(np.cumsum(nowhere)[places]) > 0
    pairs = np.column_stack([line.y[places[:-1]][passed], line.y[places[1:]][passed]])
    return line.y[~known & ~nowhere], pairs


def _sort_points(y: Array, height: Array, notes: list[str]) -> tuple[Array, Array]:
    back = int(np.sum(np.diff(y) < 0.0))
    if back and np.all(np.diff(y) < 0.0):
        notes.append("Positions descend in the file; their order was reversed.")
    elif back:
        notes.append(f"Positions go back {back} times in the file; the points were sorted.")
    # By height where positions coincide, so that their means do not depend on the order in the file either.
    order = np.lexsort((height, y))
    y, height = y[order], height[order]
    first = np.diff(y, prepend=-np.inf) > min(_SHORTEST, _SAME * usual_step(y))
    if not np.all(first):
        which = np.cumsum(first) - 1
        counts = np.bincount(which)
        notes.append(f"{int(np.sum(counts > 1))} positions occur more than once; their heights were averaged.")
        y, height = y[first], np.bincount(which, height) / counts
    return y, height


def _check_size(y: Array, height: Array, request: Request) -> None:
    largest = float(max(np.max(np.abs(y)), np.max(np.abs(height))))
    if largest > _LARGEST:
        condition = f"hold positions and heights within a kilometre (there is one of {mm(largest):.3g})"
        raise request.error(condition, "write nan where nothing was measured, and correct the units")
    if y[-1] - y[0] < _SHORTEST:
        condition = f"hold positions that are further apart ({mm(y[-1] - y[0]):.3g} in all)"
        raise request.error(condition, "correct their unit or their column")


def _check_plausible(y: Array, height: Array, known: tuple[bool, bool], request: Request) -> None:
    drop, length = float(np.ptp(height)), float(y[-1] - y[0])
    steps = np.diff(y)
    # Points of two strokes lie arbitrarily close together, and slopes between them mean nothing.
    far = steps >= np.median(steps)
    slope = float(np.median(np.abs(np.diff(height)[far] / steps[far])))
    if not known[0] and length > LONGEST:
        what, absurd = "position", f"in mm the line would be {length:.4g} long"
    elif not known[1] and drop > _PLAUSIBLE * length:
        what, absurd = "height", f"in mm they would differ by {drop:.3g} on a length of {length:.3g}"
    elif not known[1] and slope > _PLAUSIBLE_SLOPE:
        what, absurd = "height", f"in mm they would rise and fall by {slope:.3g} in a mm from point to point"
    else:
        return
    remedy = f"give {what}_unit, such as 'um', or 'mm' if they really are in mm"
    raise request.error(f"state the unit of its {what}s ({absurd})", remedy)
