"""The solutions of one bearing under many loads."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import newton
from nonhertz.bearing.bearings import RollerBearing
from nonhertz.bearing.equilibrium import NO_LOAD, TOLERANCE, States
from nonhertz.bearing.pairs import Paired, loaded_shares
from nonhertz.bearing.section import DISPLACEMENTS, FORCES, RINGS
from nonhertz.bearing.solution import BearingSolution
from nonhertz.errors import ConvergenceError
from nonhertz.result.brief import HasHtml, plain_text
from nonhertz.result.data import library, product_index
from nonhertz.result.read_only import ReadOnly

if TYPE_CHECKING:
    import pandas as pd

Array = NDArray[np.float64]
#: Units of a state: forces on and displacements of the inner ring, and the largest loads at both rings.
STATE_UNITS = FORCES | DISPLACEMENTS | {f"max_load_{ring}": "N" for ring in RINGS}


@dataclass(frozen=True, eq=False, repr=False)
class BearingSolutions(ReadOnly, HasHtml):
    """A bearing in equilibrium under many loads; indexing returns one of them as a `BearingSolution`.

    Attributes
    ----------
    bearing : RollerBearing or Paired
        The bearing.
    method : str
        How its contacts were solved.
    turning : {"inner", "outer"}
        The ring that turns.
    speed : float
        Its speed [1/min].
    displacement, force : ndarray, shape (..., 5)
        Displacements of the inner ring and forces on it, as in `BearingSolution`.
    stiffness : ndarray, shape (..., 5, 5)
        d(force) / d(displacement).
    load : ndarray, shape (..., rollers, 2)
        Loads of the contacts with the inner and the outer ring [N].
    converged : ndarray of bool, shape (...)
        Whether equilibrium was found; where not, the other values are those of the last step.
    axes : mapping of str to ndarray
        The values of the input that varies along each axis and no other, by its name, such as ``radial``. Other axes
        are numbered: ``state``, or ``state_0``.
    """

    bearing: RollerBearing | Paired
    method: str
    turning: str
    speed: float
    displacement: Array
    force: Array
    stiffness: Array
    load: Array
    converged: NDArray[np.bool_]
    axes: Mapping[str, Array]
    _states: States
    _roller_load: Array

    @classmethod
    def of(
        cls,
        bearing: RollerBearing | Paired,
        method: str,
        turning: str,
        speed: float,
        states: States,
        roller_load: Array,
        shape: tuple[int, ...],
        axes: Mapping[str, Array],
    ) -> BearingSolutions:
        """Return the states of a bearing as an array of the given shape."""
        load = states.load[..., :2]
        most = np.max(states.load, axis=(1, 2), keepdims=True)
        return cls(
            bearing=bearing,
            method=method,
            turning=turning,
            speed=speed,
            displacement=states.ring.reshape(*shape, 5),
            force=states.force.reshape(*shape, 5),
            stiffness=states.stiffness.reshape(*shape, 5, 5),
            load=np.where(load > NO_LOAD * most, load, 0.0).reshape(*shape, *load.shape[1:]),
            converged=states.converged(TOLERANCE).reshape(shape),
            axes=axes,
            _states=states,
            _roller_load=roller_load,
        )

    def __repr__(self) -> str:
        converged = np.count_nonzero(self.converged)
        rows = [f"{type(row.bearing).__name__} of {row.bearing.rollers} rollers" for row in self.bearing.rows]
        shape = " x ".join(map(str, self.converged.shape))
        lines = [
            f"{' and '.join(rows)}, by {self.method}",
            f"{converged} of {self.converged.size} states converged, shape {shape}",
        ]
        if converged:
            most = self.load[self.converged].max(axis=(1, 2))
            ends = dict.fromkeys((float(most.min()), float(most.max())))
            lines.append(f"largest load of a contact {newton(*ends, between=' to ')}")
        return plain_text("BearingSolutions", lines)

    def __len__(self) -> int:
        return len(self.converged)

    def __getitem__(self, number: int | tuple[int, ...]) -> BearingSolution:
        try:
            at = np.arange(self.converged.size).reshape(self.converged.shape)[number]
        except (TypeError, ValueError):
            raise IndexError(f"{number!r} is no index") from None
        if np.ndim(at):
            raise IndexError("an index for every axis is needed")
        if not self.converged[number]:
            raise ConvergenceError(f"State {number} of the bearing has no equilibrium.", None)
        state = self._states.portion(slice(at, at + 1))
        return BearingSolution.of(self.bearing, self.method, self.turning, self.speed, state, self._roller_load)

    @property
    def loaded_share(self) -> Array:
        """Share of the rollers of each row that the inner ring loads, shape (..., rows)."""
        return loaded_shares(self.bearing, self.load)

    def to_dataframe(self) -> pd.DataFrame:
        """Return a pandas DataFrame: a row for each state, units in ``attrs["units"]``.

        Forces and moments on the inner ring, its displacements and rotations, the largest loads of a roller on both
        rings, the loaded share of every row, and whether equilibrium was found; where not, numbers are NaN. The index
        has a level for each of ``axes``.

        Raises
        ------
        ImportError
            If pandas is not installed.
        """
        pandas = library("pandas", "to_dataframe")
        numbers = np.concatenate([self.force, self.displacement, self.load.max(axis=-2), self.loaded_share], axis=-1)
        # The last step of a state that did not converge is no result.
        rows = np.where(self.converged[..., None], numbers, np.nan).reshape(self.converged.size, -1)
        names = [*STATE_UNITS, *(f"loaded_share_{row}" for row in range(self.loaded_share.shape[-1]))]
        frame = pandas.DataFrame(rows, index=product_index(pandas, self.axes), columns=names).assign(
            converged=self.converged.ravel()
        )
        frame.attrs["units"] = dict(STATE_UNITS)
        return frame
