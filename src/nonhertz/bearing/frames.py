"""Loaded bearings as pandas tables: a row per contact, or per state."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from nonhertz.bearing.section import MOTIONS
from nonhertz.result.data import library

if TYPE_CHECKING:
    import pandas as pd

    from nonhertz.bearing.solution import BearingSolution
    from nonhertz.bearing.states import BearingSolutions

RINGS = ("inner", "outer")
CONTACT_UNITS = {
    "angle": "rad", "load": "N", "moment": "N mm", "approach": "mm", "tilt": "rad", "contact_angle": "rad",
    "max_pressure": "MPa", "max_pressure_y": "mm", "rib_load": "N",
}  # fmt: skip
STATE_UNITS = {
    "force_x": "N", "force_y": "N", "force_z": "N", "moment_about_y": "N mm", "moment_about_z": "N mm",
    "displacement_x": "mm", "displacement_y": "mm", "displacement_z": "mm", "rotation_about_y": "rad",
    "rotation_about_z": "rad", "max_load_inner": "N", "max_load_outer": "N",
}  # fmt: skip


def contact_frame(solution: BearingSolution) -> pd.DataFrame:
    """Return a row for each roller and ring; see `BearingSolution.to_dataframe`."""
    pandas = library("pandas", "to_dataframe")
    counts = [row.bearing.rollers for row in solution.bearing.rows]
    unknown = np.full(solution.load.shape, np.nan)
    stripped = solution.method == "strips"
    columns: dict[str, Any] = {
        "row": np.repeat(np.arange(len(counts)), 2 * np.array(counts)),
        "roller": np.repeat(np.concatenate([np.arange(count) for count in counts]), 2),
        "angle": np.repeat(solution.angle, 2),
        "ring": list(RINGS) * solution.angle.size,
        **{name: getattr(solution, name).ravel() for name in ("load", "moment", "approach", "tilt", "contact_angle")},
        "max_pressure": (solution.max_pressure if stripped else unknown).ravel(),
        "max_pressure_y": (solution.max_pressure_y if stripped else unknown).ravel(),
        "rib_load": solution.rib_load.ravel(),
    }
    frame = pandas.DataFrame(columns)
    frame.attrs["units"] = dict(CONTACT_UNITS)
    return frame


def state_frame(solutions: BearingSolutions) -> pd.DataFrame:
    """Return a row for each state; see `BearingSolutions.to_dataframe`."""
    pandas = library("pandas", "to_dataframe")
    shape = solutions.converged.shape
    names = list(STATE_UNITS)
    found: list[Any] = [solutions.force[..., k] for k in range(len(MOTIONS))]
    found += [solutions.displacement[..., k] for k in range(len(MOTIONS))]
    found += [solutions.load[..., k].max(axis=-1) for k in range(len(RINGS))]
    # What a state without a balance ended with is no result.
    columns: dict[str, Any] = {
        name: np.where(solutions.converged, values, np.nan).ravel() for name, values in zip(names, found, strict=True)
    }
    shares = np.where(solutions.converged[..., None], solutions.loaded_share, np.nan)
    columns |= {f"loaded_share_{row}": shares[..., row].ravel() for row in range(shares.shape[-1])}
    columns["converged"] = solutions.converged.ravel()
    if len(shape) > 1:
        axes = [f"axis_{number}" for number in range(len(shape))]
        index = pandas.MultiIndex.from_product([range(length) for length in shape], names=axes)
    else:
        index = pandas.RangeIndex(solutions.converged.size, name="state")
    frame = pandas.DataFrame(columns, index=index)
    frame.attrs["units"] = dict(STATE_UNITS)
    return frame
