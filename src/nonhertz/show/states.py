"""Many states of one bearing in rows: solved ones, tables of forces, and the maps of its contacts."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import newton
from nonhertz.bearing.equilibrium import without_rounding
from nonhertz.bearing.mapped import BearingMaps
from nonhertz.bearing.quantities import QUANTITIES
from nonhertz.bearing.section import DISPLACEMENTS, FORCES, RINGS
from nonhertz.bearing.states import BearingSolutions
from nonhertz.bearing.tables import ForceTable
from nonhertz.result.quantities import Quantity
from nonhertz.show.beside import numbers_table
from nonhertz.show.sections import Notes, Section, Table

Array = NDArray[np.float64]


def sections(solutions: BearingSolutions) -> list[Section]:
    """Return the sections on many loads of a bearing: forces, motions and the largest load of a contact."""
    loads = np.where(solutions.converged, solutions.load.max(axis=(-2, -1)), np.nan)
    numbers = [*_numbers(solutions), (QUANTITIES["max_load"], loads.ravel())]
    return [Section("", [_count_states(solutions), numbers_table("state", numbers)])]


def force_table_sections(table: ForceTable) -> list[Section]:
    """Return the sections on a table of forces: its ranges, and the sampled error of interpolation."""
    sampled = f"Interpolated linearly, the sampled error is {table.error_in_words}."
    notes = Notes([sampled] if table.checked_force.size else [])
    return [Section("", [_count_states(table), numbers_table("state", list(_numbers(table))), notes])]


def map_sections(maps: BearingMaps) -> list[Section]:
    """Return the loads up to which the contacts of a bearing are mapped, and errors of load and moment."""
    rows, heads = [], ["", "loads up to"]
    for number, pair in enumerate(maps.contacts, start=1):
        for ring, contact_map in zip(RINGS, pair, strict=True):
            errors = contact_map.errors_in_words[:2]
            heads[2:] = [f"error {of}" for _, of in errors]
            shares = (share for share, _ in errors)
            rows.append((f"row {number}, {ring} ring", f"{newton(contact_map.max_load):.4g}", *shares))
    return [Section("", [Table(rows, heads, (0,))])]


def _count_states(states: BearingSolutions | ForceTable) -> Notes:
    return Notes([f"{np.count_nonzero(states.converged)} of {states.converged.size} states have a balance"])


def _numbers(states: BearingSolutions | ForceTable) -> Iterator[tuple[Quantity, Array]]:
    """Yield forces and motions of all states, shape (states,); NaN of those without a balance."""
    pitch = states.bearing.rows[0].bearing.pitch
    lever = np.array([1.0, 1.0, 1.0, pitch, pitch])
    for names, values, weights in ((FORCES, states.force, 1.0 / lever), (DISPLACEMENTS, states.displacement, lever)):
        known = np.where(states.converged[..., None], without_rounding(values, weights), np.nan).reshape(-1, len(names))
        yield from ((QUANTITIES[name], known[:, k]) for k, name in enumerate(names))
