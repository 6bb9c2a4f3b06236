"""``nonhertz profile``: what a measured file becomes."""

from __future__ import annotations

import contextlib
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Annotated, Any

from cyclopts import Parameter

from nonhertz.cli.answer import Answer
from nonhertz.cli.options import refuse_unwritable_out, write_outputs
from nonhertz.errors import InputError
from nonhertz.files.measured import PREPARING, READING, read_measured, validate_key
from nonhertz.files.prepared import as_object, files
from nonhertz.files.results import key_by_key
from nonhertz.inputs.checks import one_of
from nonhertz.measured import ProfileFit
from nonhertz.measured.fitting import KINDS
from nonhertz.plot.measured import measured_figure
from nonhertz.show.measured import sections

BEST = "best"
KEYS = (*READING, *PREPARING)  # keys of a measured profile in a file, and options of the same names
_NO, _YES = frozenset({"no", "false", "none"}), frozenset({"yes", "true"})
# Options whose values are always text, whatever they look like.
_WORDS = frozenset({"position_unit", "height_unit", "sense"})


def profile(
    file: Path,
    /,
    *,
    position_unit: str | None = None,
    height_unit: str | None = None,
    position_column: str | None = None,
    height_column: str | None = None,
    sense: str | None = None,
    step: str | None = None,
    level: Annotated[bool | None, Parameter(show_default=False)] = None,
    align: str | None = None,
    trim: str | None = None,
    corner: str | None = None,
    outliers: str | None = None,
    smooth: str | None = None,
    cutoff: str | None = None,
    slope: str | None = None,
    points: str | None = None,
    fit: str | None = None,
    out: Path | None = None,
) -> Answer:
    """Prepare a measured profile step by step.

    Parameters
    ----------
    file : Path
        The measuring machine's file: text in columns or of heights alone, a workbook, .smd, .prf or .x3p.
    position_unit : str
        Unit of the positions in a text file; by default what the file states, or mm.
    height_unit : str
        Unit of the heights in a text file, such as um; by default what the file states, or mm.
    position_column : str
        Column of the positions, by number from 1 or by name.
    height_column : str
        Column of the heights.
    sense : str
        height (positive where there is material) or drop (positive where material is removed).
    step : str
        Distance between neighbouring points, such as 0.5um, where the file has heights alone, one per line.
    level : bool
        Remove the tilt of the body in the measuring machine; --no-level keeps it.
    align : str
        How to find the middle of the body: ends, symmetry or no.
    trim : str
        What to keep: auto for the land and its corners, a length, or no for all.
    corner : str
        keep the corners in the trace, or cut them off.
    outliers : str
        Number of robust standard deviations beyond which a point is removed, 5 by default, or no.
    smooth : str
        Filter: gaussian, spline or no.
    cutoff : str
        Wavelength at which the filter transmits 50 %; by default 0.8 mm, or a fifth of a shorter land.
    slope : str
        Slope at which a chamfer begins, 0.05 by default.
    points : str
        How many points to keep: auto, a number, or no for all.
    fit : str
        A kind of profile to fit, such as crown, or best to compare all.
    out : Path
        Directory for profile.csv, profile.json, profile.toml and the figure; created if it does not exist.
    """
    words = {key: word for key, word in locals().items() if key in KEYS and word is not None}
    refuse_unwritable_out(out)
    with _rename_options():
        values = {key: validate_key(key, _parse_word(key, word)) for key, word in words.items()}
        measured = read_measured(file, values)
        _ = measured.states
    fits: tuple[ProfileFit, ...] = ()
    if fit is not None:
        one_of("--fit", fit, (*KINDS, BEST), "name a kind of profile, or 'best' to compare all")
        fits = measured.fit_best() if fit == BEST else (measured.fit(fit),)
    name = measured.trace.name
    made = write_outputs(
        out,
        lambda: files(out or Path(), file, values, measured, fits),
        lambda: {"profile-steps": measured_figure(measured, name, fits[0] if fits else None)},
    )
    shown = sections(measured, fits)
    return Answer(name, shown, lambda: key_by_key(as_object(measured, fits)), None, measured.warnings, made)


@contextlib.contextmanager
def _rename_options() -> Iterator[None]:
    """Name refused values by their options."""
    try:
        yield
    except InputError as error:
        remedy, field = error.remedy, "--" + error.field.replace("_", "-")
        if error.field == "file":
            remedy = re.sub(r"\b(position|height)_(unit|column)\b", r"--\1-\2", remedy)
            remedy, field = re.sub(r"\bgive step, such as '(\S+) um'", r"give --step, such as \1um", remedy), "FILE"
        raise InputError(field, error.value, error.condition, remedy) from None


def _parse_word(name: str, word: str | bool) -> Any:
    """Return the value that a word means: a number if it looks like one, false for "no", or text with a unit."""
    if isinstance(word, bool) or name in _WORDS:
        return word
    if word.lower() in _NO | _YES:
        return word.lower() in _YES
    with contextlib.suppress(ValueError):
        number = float(word)
        return int(number) if number.is_integer() else number
    return word
