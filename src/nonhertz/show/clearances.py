"""Rows of the clearance of a bearing, from before mounting to operation, and of its tolerances."""

from __future__ import annotations

import math
from collections.abc import Sequence

from nonhertz.amounts import Amount, format_digits, mpa, um
from nonhertz.bearing.bearings import TaperedRollerBearing
from nonhertz.bearing.fits import Range
from nonhertz.bearing.operating import OperatingClearance
from nonhertz.bearing.pairs import Paired
from nonhertz.bearing.quantities import QUANTITIES
from nonhertz.bearing.toleranced import Tolerances
from nonhertz.files.bearing_results import LOSSES
from nonhertz.files.bearingfile import BearingCase
from nonhertz.show.beside import ABSENT
from nonhertz.show.sections import Notes, Row, Section, Table, summary

TOLERANCES = "Tolerances"
_OF_TOLERANCES = (
    "At the least and the greatest clearance all parts are at their limits; the last column is the mean plus and "
    "minus three standard deviations, for parts that are independent and normally distributed."
)


def sections(operating: OperatingClearance) -> list[Section]:
    """Return the sections on a radial clearance in operation."""
    rows = [*_loss_rows(operating), ("in operation", f"{um(operating.clearance):4}", "radial"), *_seat_rows(operating)]
    return [Section("Clearance", [summary(rows)])]


def fit_rows(case: BearingCase) -> list[Row]:
    """Return the clearance before mounting and its reductions; of tapered rows the axial ones."""
    operating = case.operating_clearance
    if operating is None or case.fit is None:
        return []
    rows = _loss_rows(operating, *_way_of(case))
    if isinstance(case.bearing, Paired):
        rows.append(("", f"{um(case.fit.expansion(case.bearing)):4}", "increase by temperatures between the rows"))
    return [*rows, *_seat_rows(operating)]


def _loss_rows(operating: OperatingClearance, factor: float = 1.0, way: str = "radial") -> list[Row]:
    """Return the clearance before mounting, and its reductions."""
    rows = [("before mounting", f"{um(factor * operating.unmounted):g}", way)]
    return rows + [("", f"{um(factor * key.value(operating)):4}", key.meaning) for key in LOSSES]


def _seat_rows(operating: OperatingClearance) -> list[Row]:
    """Return the pressures of both seats."""
    rows = []
    for ring, fit in (("inner", operating.inner), ("outer", operating.outer)):
        loose = ", loosened" if fit.loosened else ""
        value = f"{mpa(fit.pressure):4}{loose}"
        rows.append((f"{ring} fit", value, f"{mpa(fit.mounted_pressure):4} when mounted"))
    return rows


def tolerance_section(case: BearingCase, tolerances: Tolerances) -> Section:
    """Return interferences, clearance and results at the least, the likely and the greatest clearance."""
    return _tolerances(tolerances, *_way_of(case))


def tolerance_sections(tolerances: Tolerances) -> list[Section]:
    """Return the sections on the same of a bearing without its case, with radial clearances."""
    return [_tolerances(tolerances)]


def _tolerances(tolerances: Tolerances, factor: float = 1.0, way: str = "radial") -> Section:
    ranges = tolerances.clearance
    clearances = {"unmounted": ranges.unmounted, "mounted": ranges.mounted, "in operation": ranges.operating}
    interferences = {"on shaft": ranges.shaft, "in housing": ranges.housing}
    lengths = {
        f"interference {where}": length_range
        for where, length_range in interferences.items()
        if length_range is not None
    }
    # The greatest interference leaves the least clearance.
    rows = [_range_row(name, length_range, Range.AT[::-1]) for name, length_range in lengths.items()]
    rows += [
        _range_row(f"{way} clearance {when}", clearance_range.scaled(factor))
        for when, clearance_range in clearances.items()
    ]
    for name, result_range in tolerances.results.items():
        values = QUANTITIES[name].amount(*(result_range.at(which) for which in Range.AT))
        if any(map(math.isfinite, values.values)):
            rows.append(_row_of(f"{QUANTITIES[name].label} {QUANTITIES[name].symbol}".strip(), values))
    heads = ("", "least clearance", "likely", "greatest clearance", "99.7 % within")
    return Section(TOLERANCES, [Table(rows, heads, (0, 4)), Notes([_OF_TOLERANCES])])


def _range_row(name: str, length_range: Range, order: Sequence[str] = Range.AT) -> tuple[str, ...]:
    """Return a row of a length at the limits."""
    probable = "" if length_range.known else " to ".join(um(*length_range.probable).apart("4")[0])
    return _row_of(name, um(*(length_range.at(which) for which in order)), probable)


def _row_of(name: str, values: Amount, probable: str = "") -> tuple[str, ...]:
    """Return a row of three values in the unit of the largest."""
    factor, unit = values.scale
    texts = (format_digits(factor * value, 4) if math.isfinite(value) else ABSENT for value in values.values)
    return f"{name} [{unit}]", *texts, probable


def _way_of(case: BearingCase) -> tuple[float, str]:
    """Return the factor of radial clearances, and its name: axial ones of tapered rows are proportional to them."""
    row = case.bearing.rows[0].bearing
    if isinstance(row, TaperedRollerBearing):
        return 0.5 / math.tan(row.nominal_angle), "axial"
    return 1.0, "radial"
