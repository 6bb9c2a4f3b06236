"""A measured profile in rows: the effect of each step, its relief and roughness, and the profiles fitted to it."""

from __future__ import annotations

from collections.abc import Sequence

from nonhertz.amounts import mm, of_dimension, um, with_error
from nonhertz.measured import Measured, ProfileFit
from nonhertz.show.sections import Notes, Row, Section, Table, summary

# Larger errors, in mm and relative to the value, mean that a parameter is not determined, as in "0 +- 28000 mm".
_METRES, _SWALLOWED = 1e3, 10.0
_FITTED = ("fit", "parameters and standard errors", "rms", "largest", "behind")


def sections(measured: Measured, fits: Sequence[ProfileFit] = ()) -> list[Section]:
    """Return the sections on a measured profile and on the profiles fitted to it, best first."""
    return [Section("", [Notes(measured.trace.notes), summary(rows(measured)), _fit_rows(fits)])]


def fit_sections(fit: ProfileFit) -> list[Section]:
    """Return the sections on one profile fitted to points."""
    return [Section("", [_fit_rows([fit])])]


def _fit_rows(fits: Sequence[ProfileFit]) -> Table:
    fitted = []
    for fit in fits:
        names = [*fit.parameters, *(["shift"] if "shift" in fit.standard_errors else [])]
        residuals = f"{um(fit.rms):.3g}", f"{um(fit.largest):.3g}", f"{fit.penalised - fits[0].penalised:.1f}"
        fitted.append((fit.kind, ", ".join(_parameter(fit, name) for name in names), *residuals))
    return Table(fitted, _FITTED, (0, 1))


def rows(measured: Measured) -> list[Row]:
    """Return name and sentence of every step, the resulting relief, and the roughness."""
    roughness = measured.roughness
    low, high, most = roughness.main_band
    return [
        *((state.name, state.words, "") for state in measured.states),
        ("relief", _relief(measured), ""),
        ("roughness", f"Ra {um(roughness.ra):.3g}, Rq {um(roughness.rq):.3g}, Rz {um(roughness.rz):.3g} below "
                      f"{mm(roughness.cutoff):.3g}; most of it, {um(most):.3g}, in waves "
                      + (f"from {mm(low, high, between=' to '):.3g}." if low else f"shorter than {mm(high):.3g}."), ""),
    ]  # fmt: skip


def _relief(measured: Measured) -> str:
    points = measured.points
    land, highest = points.on_land, points.height.max()
    words = " and ".join(f"{um(float(highest - land.height[k])):.4g} at y = {mm(land.y[k]):.5g}" for k in (0, -1))
    if points.land is None:
        return f"{words}."
    ends = " and ".join(f"{um(float(highest - points.height[k])):.4g} at {mm(points.y[k]):.5g}" for k in (0, -1))
    return f"{words}, where the land ends; {ends}, where the profile ends."


def _parameter(fit: ProfileFit, name: str) -> str:
    value = fit.parameters.get(name, fit.shift)
    unit = fit.unit_of(name)
    error = fit.standard_errors.get(name)
    if error is not None and not error < max(_METRES, _SWALLOWED * abs(value)):
        return f"{name} not determined by the points"  # any value fits equally well
    shown = of_dimension((value,), unit)
    return f"{name} {shown if error is None else with_error(shown, error)}"
