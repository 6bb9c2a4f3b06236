"""What ``nonhertz profile`` makes of a measured file, and what it prints."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from nonhertz.amounts import mm, of_dimension, um, with_error
from nonhertz.cli.printing import Printed
from nonhertz.errors import InputError
from nonhertz.files.folder import write_files
from nonhertz.files.measured import checked, measured_from, trace_from
from nonhertz.files.prepared import files
from nonhertz.inputs.checks import one_of
from nonhertz.measured import Fit, Measured
from nonhertz.measured.fit import KINDS
from nonhertz.show.sections import Table

BEST = "best"
_PLAIN_NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
_NO, _YES = frozenset({"no", "false", "none"}), frozenset({"yes", "true"})
# Options whose values are always text, whatever they look like.
_WORDS = frozenset({"position_unit", "height_unit", "sense"})


def options(**words: str | bool | None) -> dict[str, Any]:
    """Return the values of command-line options by case-file key; None is left out.

    Text that looks like a number becomes one, "no" is false, and lengths are text with a unit or a number in mm.

    Raises
    ------
    InputError
        If a value has the wrong type; the option is named as on the command line.
    """
    values = {}
    for name, word in words.items():
        if word is None:
            continue
        try:
            values[name] = checked(name, _meant(name, word))
        except InputError as error:
            raise option_named(error) from None
    return values


def option_named(error: InputError) -> InputError:
    """Return the same error with the option named as on the command line."""
    if error.field == "file":
        remedy = re.sub(r"\b(position|height)_(unit|column)\b", r"--\1-\2", error.remedy)
        return InputError("file", error.value, error.condition, remedy)
    return InputError("--" + error.field.replace("_", "-"), error.value, error.condition, error.remedy)


def prepared(file: Path, values: Mapping[str, Any]) -> Measured:
    """Return the profile in a file after all steps.

    Raises
    ------
    InputError
        If the file cannot be read or a step does not suit it.
    """
    try:
        measured = measured_from(trace_from(file, values), values)
        _ = measured.states
    except InputError as error:
        raise option_named(error) from None
    return measured


def fitted(measured: Measured, kind: str | None) -> tuple[Fit, ...]:
    """Return the requested fits: of one kind, of all kinds for "best", or none.

    Raises
    ------
    InputError
        If the kind cannot be fitted.
    """
    if kind is None:
        return ()
    one_of("--fit", kind, (*KINDS, BEST), "name a kind of profile, or 'best' to compare all")
    return measured.fit_best() if kind == BEST else (measured.fit(kind),)


def written(
    directory: Path, file: Path, values: Mapping[str, Any], measured: Measured, fits: Sequence[Fit]
) -> tuple[Path, ...]:
    """Write all that `print_profile` prints, with a figure, and return the files.

    Raises
    ------
    InputError
        If the directory cannot be written to.
    """
    from nonhertz.plot import save
    from nonhertz.plot.measured import measured_figure

    def draw(folder: Path) -> None:
        figure = measured_figure(measured, measured.trace.name, fits[0] if fits else None)
        save(figure, folder / "profile-steps")

    return write_files(directory, files(directory, file, values, measured, fits), draw)


def print_profile(measured: Measured, fits: Sequence[Fit]) -> None:
    """Print the steps, the roughness, the fits and warnings."""
    printing = Printed(measured.trace.name)
    printing.say(*measured.trace.notes)
    printing.table(Table(profile_rows(measured)))
    heads = ("fit", "parameters and standard errors", "rms", "largest", "behind")
    printing.table(Table(fit_rows(fits), heads, (0, 1)))
    printing.warn(*measured.warnings)


def profile_rows(measured: Measured) -> list[tuple[str, str]]:
    """Return name and sentence of every step, the resulting relief, and the roughness."""
    found = measured.roughness
    low, high, most = found.main_band
    return [
        *((state.name, state.words) for state in measured.states),
        ("relief", _relief(measured)),
        ("roughness", f"Ra {um(found.ra):.3g}, Rq {um(found.rq):.3g}, Rz {um(found.rz):.3g} below "
                      f"{mm(found.cutoff):.3g}; most of it, {um(most):.3g}, in waves "
                      + (f"from {mm(low, high, between=' to '):.3g}." if low else f"shorter than {mm(high):.3g}.")),
    ]  # fmt: skip


def _relief(measured: Measured) -> str:
    points = measured.points
    land, highest = points.on_land, points.height.max()
    words = " and ".join(f"{um(float(highest - land.height[k])):.4g} at y = {mm(land.y[k]):.5g}" for k in (0, -1))
    if points.land is None:
        return f"{words}."
    ends = " and ".join(f"{um(float(highest - points.height[k])):.4g} at {mm(points.y[k]):.5g}" for k in (0, -1))
    return f"{words}, where the land ends; {ends}, where the profile ends."


def fit_rows(fits: Sequence[Fit]) -> list[tuple[str, ...]]:
    """Return kind, parameters with their standard errors, and residuals of each fit, best first."""
    return [
        (
            fit.kind,
            ", ".join(_parameter(fit, name) for name in (*fit.parameters, "shift") if _is_free(fit, name)),
            f"{um(fit.rms):.3g}",
            f"{um(fit.largest):.3g}",
            f"{fit.penalised - fits[0].penalised:.1f}",
        )
        for fit in fits
    ]


def _is_free(fit: Fit, name: str) -> bool:
    return name in fit.parameters or name in fit.standard_errors


def _parameter(fit: Fit, name: str) -> str:
    value = fit.parameters.get(name, fit.shift)
    unit = fit.unit_of(name)
    error = fit.standard_errors.get(name)
    if error is not None and not math.isfinite(error):
        return f"{name} not determined by the points"  # any value fits as well
    shown = of_dimension((value,), unit)
    return f"{name} {shown if error is None else with_error(shown, error)}"


def _meant(name: str, word: str | bool) -> Any:
    if isinstance(word, bool) or name in _WORDS:
        return word
    if word.lower() in _NO | _YES:
        return word.lower() in _YES
    if _PLAIN_NUMBER.fullmatch(word):
        number = float(word)
        return (
            int(number) if name in {"points", "position_column", "height_column"} and number == int(number) else number
        )
    return word
