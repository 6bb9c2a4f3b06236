"""The solution of a bearing: loads, displacements, stiffness, pressures."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, Final, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.amounts import mpa, mrad, newton, newton_mm, um
from nonhertz.bearing.bearings import RollerBearing
from nonhertz.bearing.equilibrium import NO_LOAD, States, drop_rounding
from nonhertz.bearing.pairs import Paired, loaded_shares, parts_of
from nonhertz.bearing.ribs import RibContact
from nonhertz.bearing.row import Row
from nonhertz.bearing.section import RINGS
from nonhertz.bearing.strained import findings_of
from nonhertz.errors import InputError, without_accuracy_warnings
from nonhertz.findings import Finding, sentences
from nonhertz.hertz import PointContact
from nonhertz.inputs.assumed import collect_assumptions
from nonhertz.inputs.checks import numbers, one_of, whole
from nonhertz.result.brief import HasHtml, plain_text
from nonhertz.result.data import library
from nonhertz.result.quantities import Quantity, attributes
from nonhertz.result.read_only import ReadOnly
from nonhertz.result.solution import Solution
from nonhertz.solver.one import solve

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr
    from matplotlib.axes import Axes

Array = NDArray[np.float64]

POINTS = 401  # along a roller
#: Arrays of every roller at the inner and the outer ring, by name.
CONTACT_QUANTITIES: Final[dict[str, Quantity]] = attributes(
    ("load", "load of every roller at the inner and outer ring", "N"),
    ("moment", "moment of every roller at the inner and outer ring", "N mm"),
    ("approach", "approach of every roller at the inner and outer ring", "mm"),
    ("tilt", "tilt of every roller at the inner and outer ring", "rad"),
    ("contact_angle", "contact angle of every roller at the inner and outer ring", "rad"),
    ("max_pressure", "maximum pressure of every roller at the inner and outer ring", "MPa"),
    ("max_pressure_y", "where it is along the roller", "mm"),
    ("rib_load", "load on every roller's ends from the ribs of each ring", "N"),
)
#: Those that slices do not give.
PRESSURES: Final = ("max_pressure", "max_pressure_y")
_SAME = 1e-9  # of the largest approach


@dataclass(frozen=True, eq=False, repr=False)
class UnrolledPressure(ReadOnly):
    """The centre-line pressure between the rollers of a row and one of its rings.

    Attributes
    ----------
    ring : {"inner", "outer"}
        Which ring.
    row : int
        Index of the row, from 0.
    angle : ndarray, shape (rollers,)
        Where the rollers are [rad].
    y : ndarray, shape (n,)
        Places along the rollers' profiles [mm].
    pressure : ndarray, shape (rollers, n)
        Pressure on the line x = 0 [MPa], interpolated as by `Solution.pressure`: zero out of contact, not converged in
        a strip at a singular end.
    """

    ring: str
    row: int
    angle: Array
    y: Array
    pressure: Array


class DistinctContact(NamedTuple):
    """A solved contact and the rollers that share it, as those at equal angles on both sides of a load do."""

    row: Row
    ring: int  # 0 of the inner, 1 of the outer one
    rollers: list[int]  # among those of all rows
    solved: Solution


@dataclass(frozen=True, eq=False, repr=False)
class BearingSolution(ReadOnly, HasHtml):
    """A bearing in equilibrium.

    Attributes
    ----------
    bearing : RollerBearing or Paired
        The bearing; arrays list the rollers of all rows, one row after another.
    method : {"strips", "slices"}
        How its contacts were solved.
    turning : {"inner", "outer"}
        The ring that turns; the other ring and the load are at rest.
    speed : float
        Its speed [1/min], for lives and films too; 0 if none was given.
    angle : ndarray, shape (rollers,)
        Where the rollers are [rad].
    load, moment, approach, tilt, contact_angle : ndarray, shape (rollers, 2)
        At the contacts with the inner and the outer ring [N, N mm, mm, rad, rad]; loads are 0 out of contact.
    each_rib_load : ndarray, shape (rollers, ribs)
        Load of each rib on the ends of the rollers [N], in the order of ``rib_contacts`` of the row.
    displacement : ndarray, shape (5,)
        Displacement of the inner ring along x, y and z [mm] and about y and z [rad].
    force : ndarray, shape (5,)
        Forces [N] and moments [N mm] on the inner ring.
    stiffness : ndarray, shape (5, 5)
        d(force) / d(displacement).
    roller_load : ndarray, shape (rollers, 3)
        Centrifugal load of every roller, along x and r of its row [N], and its gyroscopic moment [N mm].
    edge_rollers : ndarray of int
        Rollers at the edge of the load zone: unloaded, but loaded when the ring moves by 10 nm.
    edge_stiffness : ndarray, shape (3,)
        Change of force over such a motion along x, y and z, in the direction in which it is larger [N/mm]; NaN if
        there are no such rollers, and in states of `solve_many`, which looks for neither.
    residual : float
        Residual of equilibrium, over the loads.
    iterations : int
        Newton steps of the ring.
    """

    bearing: RollerBearing | Paired
    method: str
    turning: str
    speed: float
    angle: Array
    load: Array
    moment: Array
    approach: Array
    tilt: Array
    contact_angle: Array
    each_rib_load: Array
    displacement: Array
    force: Array
    stiffness: Array
    roller_load: Array
    edge_rollers: NDArray[np.int64]
    edge_stiffness: Array
    residual: float
    iterations: int

    @classmethod
    def of(
        cls,
        bearing: RollerBearing | Paired,
        method: str,
        turning: str,
        speed: float,
        states: States,
        roller_load: Array,
        edge: tuple[NDArray[np.int64], Array] | None = None,
    ) -> BearingSolution:
        """Return the only state of a bearing."""
        load, (approach, tilt) = states.load[0], np.moveaxis(states.pose[0, :, :2], -1, 0)
        edge_rollers, edge_stiffness = edge or (np.zeros(0, dtype=np.int64), np.full(3, np.nan))
        # The residual of a roller that has lifted off is no load.
        borne = load > NO_LOAD * np.max(load, initial=0.0)
        angles = [
            np.tile(of_row.contact_angles if method == "strips" else (of_row.nominal_angle,) * 2, (of_row.rollers, 1))
            for of_row in (row.bearing for row in bearing.rows)
        ]
        return cls(
            bearing=bearing,
            method=method,
            turning=turning,
            speed=speed,
            angle=np.concatenate([row.bearing.angles for row in bearing.rows]),
            load=np.where(borne, load, 0.0)[:, :2],
            moment=np.where(borne, states.answer[0, ..., 1], 0.0)[:, :2],
            approach=approach,
            tilt=tilt,
            contact_angle=np.concatenate(angles),
            each_rib_load=np.where(borne, load, 0.0)[:, 2:],
            displacement=states.ring[0],
            force=states.force[0],
            stiffness=states.stiffness[0],
            roller_load=roller_load,
            edge_rollers=edge_rollers,
            edge_stiffness=edge_stiffness,
            residual=float(states.residual[0]),
            iterations=int(states.steps[0]),
        )

    def __repr__(self) -> str:
        most = int(np.argmax(self.load.max(axis=1)))
        pitch = self.bearing.rows[0].bearing.pitch
        lever = np.array([1.0, 1.0, 1.0, pitch, pitch])
        rows = [f"{type(row.bearing).__name__} of {row.bearing.rollers} rollers" for row in self.bearing.rows]
        force = drop_rounding(self.force, 1.0 / lever, float(self.load.sum()))
        moved = drop_rounding(self.displacement, lever, float(np.abs(self.approach).max()))
        loaded = np.count_nonzero(self.load.min(axis=1) > 0.0)  # those that both rings press
        lines = [
            f"{' and '.join(rows)}, by {self.method}",
            f"force {newton(*force[:3])} along x, y, z; moment {newton_mm(*force[3:])} about y, z",
            f"displacement {um(*moved[:3])} along x, y, z; rotation {mrad(*moved[3:])} about y, z",
            f"{loaded} rollers loaded; at {np.degrees(self.angle[most]):.1f} degrees "
            f"{newton(*self.load[most], between=' and ')} at the inner and the outer ring",
        ]
        if self.method == "strips":
            largest = mpa(*self.max_pressure.max(axis=0), between=" and ")
            lines.append(f"maximum pressure {largest} at the inner and the outer ring")
        return plain_text("BearingSolution", lines)

    def contact(self, roller: int, ring: str = "inner") -> Solution | None:
        """Return the contact of a roller with a ring, solved by strips for its load and tilt; None if unloaded.

        Its approach and moment differ from those of the bearing by some 1e-5: in the bearing, both contacts of a roller
        share a grid of strips.

        Parameters
        ----------
        roller : int
            Its index, from 0.
        ring : {"inner", "outer"}
            Which ring.

        Raises
        ------
        InputError
            If there is no such contact, or the bearing was solved by slices.
        """
        roller = self._number_of(roller, ring)
        return self._contacts.get((roller, RINGS.index(ring)))

    @property
    def rib_load(self) -> Array:
        """Load on the ends of the rollers from the ribs of the inner and the outer ring [N], shape (rollers, 2)."""
        total = np.zeros(self.load.shape)
        for loads, rib in self.loaded_ribs:
            total[:, RINGS.index(rib.ring)] += loads
        return total

    def rib_contact(self, roller: int, ring: str = "inner") -> PointContact | None:
        """Return the contact of a roller's end with the rib of a ring that bears most, after Hertz; None if unloaded.

        Parameters
        ----------
        roller : int
            Its index, from 0.
        ring : {"inner", "outer"}
            Which ring.

        Raises
        ------
        InputError
            If there is no such roller or ring.
        """
        roller = self._number_of(roller, ring)
        pressing = [(float(loads[roller]), rib) for loads, rib in self.loaded_ribs if rib.ring == ring]
        load, rib = max(pressing, key=lambda pair: pair[0], default=(0.0, None))
        return rib.under(load) if rib is not None and load > 0.0 else None

    def place_of(self, roller: int) -> str:
        """Return a roller in words, which count from 1: ``"roller 1 at 0.0 degrees"``.

        Parameters
        ----------
        roller : int
            Its index, from 0.

        Raises
        ------
        InputError
            If there is no such roller.
        """
        roller = self._number_of(roller)
        row = next(k for k, row in enumerate(self.bearing.rows, start=1) if roller < row.rollers.stop)
        among = f", row {row}" if len(self.bearing.rows) > 1 else ""
        return f"roller {roller + 1} at {np.degrees(self.angle[roller]):.1f} degrees{among}"

    def _number_of(self, roller: int, ring: str = RINGS[0]) -> int:
        one_of("ring", ring, RINGS, "name one of both")
        return whole("roller", roller, 0, self.angle.size - 1, "count from 0")

    @property
    def assumed(self) -> tuple[Finding, ...]:
        """Assumptions in place of what the bearing leaves out and the result depends on."""
        return collect_assumptions(parts_of(self.bearing))

    @property
    def warnings(self) -> tuple[str, ...]:
        """The findings, a sentence each."""
        return sentences(self.findings)

    @cached_property
    def findings(self) -> tuple[Finding, ...]:
        """What limits the validity: findings of contacts by strips, rib contacts that reach an edge, bores.

        One of each kind, that of the most loaded roller, with a count.
        """
        return findings_of(self)

    @property
    def loaded_ribs(self) -> list[tuple[Array, RibContact]]:
        """The ribs, with the load of each on every roller [N], which is zero for rollers of other rows."""
        ribs = []
        for row in self.bearing.rows:
            # Slices ignore the ribs of tapered rows.
            for rib, loads in zip(row.bearing.rib_contacts, self.each_rib_load[row.rollers].T, strict=False):
                on_all = np.zeros(self.angle.size)
                on_all[row.rollers] = loads
                ribs.append((on_all, rib))
        return ribs

    @cached_property
    def distinct_contacts(self) -> tuple[DistinctContact, ...]:
        """The loaded contacts, solved by strips for their loads and tilts.

        Raises
        ------
        InputError
            If the bearing was solved by slices.
        """
        if self.method != "strips":
            raise InputError("method", self.method, "be 'strips' for pressures", "solve the bearing by strips")
        size, contacts = _SAME * float(np.max(np.abs(self.approach), initial=1e-300)), []
        for row in self.bearing.rows:
            poses = np.stack([self.approach, self.tilt * row.bearing.roller_length], axis=-1)
            for k, contact in enumerate(row.bearing.contacts):
                alike: dict[tuple[int, ...], list[int]] = {}
                for j in range(row.rollers.start, row.rollers.stop):
                    if self.load[j, k] > 0.0:
                        alike.setdefault(tuple(round(value / size) for value in poses[j, k].tolist()), []).append(j)
                for rollers in alike.values():
                    load, tilt = (float(values[rollers[0], k]) for values in (self.load, self.tilt))
                    with without_accuracy_warnings():
                        contacts.append(DistinctContact(row, k, rollers, solve(contact, load=load, tilt=tilt)))
        return tuple(contacts)

    @cached_property
    def _contacts(self) -> dict[tuple[int, int], Solution]:
        return {(j, contact.ring): contact.solved for contact in self.distinct_contacts for j in contact.rollers}

    @property
    def max_pressure(self) -> Array:
        """Maximum pressure of every contact [MPa], shape (rollers, 2); zero where there is no load."""
        return self._of_contacts("max_pressure")

    @property
    def max_pressure_y(self) -> Array:
        """Position of the maximum pressure along the roller [mm], shape (rollers, 2); NaN where there is no load."""
        places = self._of_contacts("max_pressure_y")
        return np.where(self.load > 0.0, places, np.nan)

    @property
    def loaded_share(self) -> Array:
        """Share of the rollers of each row that the inner ring loads, shape (rows,)."""
        return loaded_shares(self.bearing, self.load)

    @property
    def load_zone(self) -> Array:
        """Angle of the load zone of each row [rad], shape (rows,).

        The angular pitch times the number of rollers that the inner ring loads: 2 pi where it loads all, one pitch
        where it loads one, the sum where the zone has several parts. Over 2 pi it is `loaded_share`.
        """
        return 2.0 * np.pi * self.loaded_share

    def rollers_of(self, row: int) -> slice:
        """Return the slice of ``load`` and other arrays that holds the rollers of a row.

        Parameters
        ----------
        row : int
            Its index, from 0.

        Raises
        ------
        InputError
            If there is no such row.
        """
        row = whole("row", row, 0, len(self.bearing.rows) - 1, "count the rows from 0")
        return self.bearing.rows[row].rollers

    def unrolled_pressure(self, ring: str = "inner", *, row: int = 0, y: ArrayLike | None = None) -> UnrolledPressure:
        """Return the centre-line pressure of all rollers of a row on one ring, over angle and y.

        Parameters
        ----------
        ring : {"inner", "outer"}
            Which ring.
        row : int
            Index of the row, from 0.
        y : array_like, optional
            Places along the rollers' profiles [mm], shape (n,); 401 of them evenly over the length if left out.

        Raises
        ------
        InputError
            If there is no such ring or row, ``y`` is not a one-dimensional array, or the bearing was solved by slices.

        Examples
        --------
        >>> import nonhertz as nh
        >>> roller = nh.Roller(diameter=9, length=10, profile=nh.profile.crown(radius=4000))
        >>> rings = {"inner": nh.Ring(diameter=37.5), "outer": nh.Ring(diameter=-55.5)}
        >>> bearing = nh.bearing.CylindricalRollerBearing(roller=roller, **rings, rollers=13, clearance=0.0184)
        >>> nh.bearing.solve(bearing, radial=5e3).unrolled_pressure("outer", y=[-4, 0, 4]).pressure.shape
        (13, 3)
        """
        one_of("ring", ring, RINGS, "name one of both")
        these = self.rollers_of(row)
        remedy = "give places along the rollers in mm, or leave it out"
        evenly = 0.5 * self.bearing.rows[row].bearing.roller_length * np.linspace(-1.0, 1.0, POINTS)
        places = evenly if y is None else np.array(numbers("y", y, remedy))
        if places.ndim != 1 or not places.size:
            raise InputError("y", y, "be a row of numbers", remedy)
        pressure = np.zeros((self.angle.size, places.size))
        for contact in self.distinct_contacts:
            if (contact.row.first, RINGS[contact.ring]) == (these.start, ring):
                pressure[contact.rollers] = contact.solved.pressure(0.0, places)
        return UnrolledPressure(ring, row, self.angle[these], places, pressure[these])

    def plot(self, what: str = "loads", ax: Axes | None = None) -> Axes:
        """Draw the bearing and return the axes; ``axes.figure`` is the figure.

        Parameters
        ----------
        what : str
            ``"loads"``, ``"pressure"``, ``"roller"`` (the most loaded one), ``"relief"`` or ``"displacement"`` (against
            load); see `nonhertz.plot`.
        ax : matplotlib.axes.Axes, optional
            Where to draw; of loads, polar ones.

        Raises
        ------
        InputError
            If there is no such drawing, or none of this bearing.
        """
        import nonhertz  # plot imports this module

        return nonhertz.plot.draw(self, what, ax)

    def to_dataframe(self) -> pd.DataFrame:
        """Return a pandas DataFrame: a row for each roller and ring, units in ``attrs["units"]``.

        Rollers are numbered in their row. The load of a rib is in the row of its ring. Pressures are NaN by slices.

        Raises
        ------
        ImportError
            If pandas is not installed.
        """
        pandas = library("pandas", "to_dataframe")
        counts = np.array([row.bearing.rollers for row in self.bearing.rows])
        columns: dict[str, Any] = {
            "row": np.repeat(np.arange(counts.size), 2 * counts),
            "roller": np.repeat(np.concatenate([np.arange(count) for count in counts]), 2),
            "angle": np.repeat(self.angle, 2),
            "ring": list(RINGS) * self.angle.size,
        }
        unknown = PRESSURES if self.method != "strips" else ()
        for name, quantity in CONTACT_QUANTITIES.items():
            columns[name] = np.full(self.load.size, np.nan) if name in unknown else quantity.get(self).ravel()
        frame = pandas.DataFrame(columns)
        frame.attrs["units"] = {"angle": "rad"} | {name: quantity.unit for name, quantity in CONTACT_QUANTITIES.items()}
        return frame

    def to_xarray(self) -> xr.Dataset:
        """Return an xarray Dataset: a variable for each quantity, with units, over ``roller`` and ``ring``.

        The coordinate ``ring`` is "inner" or "outer", ``roller`` counts from 0 over all rows, and ``angle`` is where a
        roller is [rad]. By slices there are no pressures.

        Raises
        ------
        ImportError
            If xarray is not installed.
        """
        xarray = library("xarray", "to_xarray")
        unknown = PRESSURES if self.method != "strips" else ()
        data: xr.Dataset = xarray.Dataset(
            {
                name: (("roller", "ring"), quantity.get(self), {"units": quantity.unit, "long_name": quantity.label})
                for name, quantity in CONTACT_QUANTITIES.items()
                if name not in unknown
            },
            coords={
                "roller": np.arange(self.angle.size),
                "ring": list(RINGS),
                "angle": ("roller", self.angle, {"units": "rad"}),
            },
        )
        return data

    def _of_contacts(self, name: str) -> Array:
        values = np.zeros(self.load.shape)
        for contact in self.distinct_contacts:
            values[contact.rollers, contact.ring] = getattr(contact.solved, name)
        return values
