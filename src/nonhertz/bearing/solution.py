"""What is known of a loaded bearing."""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from nonhertz.bearing.bearings import Paired, RollerBearing
from nonhertz.bearing.equilibrium import States
from nonhertz.errors import AccuracyWarning, InputError
from nonhertz.inputs.checks import one_of, whole
from nonhertz.result.brief import plain_text
from nonhertz.result.numerals import digits
from nonhertz.result.solution import ReadOnly, Solution
from nonhertz.solver.one import solve

Array = NDArray[np.float64]

RINGS = ("inner", "outer")
NO_LOAD = 1e-8  # of the largest
_SAME = 1e-9  # of the largest approach


@dataclass(frozen=True, eq=False, repr=False)
class BearingSolution(ReadOnly):
    """A bearing in equilibrium.

    Attributes
    ----------
    bearing : RollerBearing or Paired
        The bearing; the rollers of several rows follow one another.
    method : {"strips", "slices"}
        How its contacts were solved.
    angle : ndarray, shape (rollers,)
        Where the rollers are [rad].
    load, moment, approach, tilt, contact_angle : ndarray, shape (rollers, 2)
        Of the contacts with the inner and the outer ring [N, N mm, mm, rad, rad]; a roller that touches nothing has
        no load.
    rib_load : ndarray, shape (rollers,)
        On the ends of the rollers [N].
    displacement : ndarray, shape (5,)
        Of the inner ring along x, y and z [mm] and about y and z [rad].
    force : ndarray, shape (5,)
        Forces [N] and moments [N mm] on the inner ring that go with it.
    stiffness : ndarray, shape (5, 5)
        d(force) / d(displacement).
    roller_load : ndarray, shape (rollers, 3)
        What speed loads every roller with, along x and r of its row [N] and as a moment [N mm].
    residual : float
        What is left of the balance, over the loads.
    steps : int
        Newton steps of the ring.
    """

    bearing: RollerBearing | Paired
    method: str
    angle: Array
    load: Array
    moment: Array
    approach: Array
    tilt: Array
    contact_angle: Array
    rib_load: Array
    displacement: Array
    force: Array
    stiffness: Array
    roller_load: Array
    residual: float
    steps: int

    @classmethod
    def of(cls, bearing: RollerBearing | Paired, method: str, found: States, roller_load: Array) -> BearingSolution:
        """Return the only state of a bearing."""
        rollers = found.rollers
        # What is left of the balance of a roller that has lifted off is no load.
        borne = rollers.load[0] > NO_LOAD * np.max(rollers.load[0], initial=0.0)
        angles = [
            np.tile(each.contact_angles if method == "strips" else (each.nominal_angle,) * 2, (each.rollers, 1))
            for each in (row.bearing for row in bearing.rows)
        ]
        return cls(
            bearing=bearing,
            method=method,
            angle=np.concatenate([row.bearing.angles for row in bearing.rows]),
            load=np.where(borne, rollers.load[0], 0.0)[:, :2],
            moment=np.where(borne, rollers.moment[0], 0.0)[:, :2],
            approach=rollers.approach[0, :, :2],
            tilt=rollers.tilt[0, :, :2],
            contact_angle=np.concatenate(angles),
            rib_load=np.sum(np.where(borne, rollers.load[0], 0.0)[:, 2:], axis=1),
            displacement=found.ring[0],
            force=found.force[0],
            stiffness=found.stiffness[0],
            roller_load=roller_load,
            residual=float(found.residual[0]),
            steps=int(found.steps[0]),
        )

    def __repr__(self) -> str:
        most = int(np.argmax(self.load.max(axis=1)))
        pitch = self.bearing.rows[0].bearing.pitch
        lever = np.array([1.0, 1.0, 1.0, pitch, pitch])
        rows = [f"{type(row.bearing).__name__} of {row.bearing.rollers} rollers" for row in self.bearing.rows]
        force, moved = _in_words(self.force, 1.0 / lever), _in_words(1e3 * self.displacement, lever)
        loaded = np.count_nonzero(self.load.max(axis=1) > 0.0)
        said = [
            f"{' and '.join(rows)}, by {self.method}",
            f"force {', '.join(force[:3])} N along x, y, z; moment {', '.join(force[3:])} N mm about y, z",
            f"displacement {', '.join(moved[:3])} um along x, y, z; rotation {', '.join(moved[3:])} mrad about y, z",
            f"{loaded} rollers loaded; at {np.degrees(self.angle[most]):.1f} degrees {digits(self.load[most, 0])} N "
            f"at the inner and {digits(self.load[most, 1])} N at the outer ring",
        ]
        return plain_text("BearingSolution", said)

    def contact(self, roller: int, ring: str = "inner") -> Solution | None:
        """Return the contact of a roller with a ring, solved by strips at its approach and tilt; None if unloaded.

        Parameters
        ----------
        roller : int
            Its number, from 0.
        ring : {"inner", "outer"}
            Which ring.

        Raises
        ------
        InputError
            If there is no such contact, or the bearing was solved by slices.
        """
        roller = whole("roller", roller, 0, self.angle.size - 1, "count from 0")
        one_of("ring", ring, RINGS, "name one of both")
        if self.method != "strips":
            raise InputError("method", self.method, "be 'strips' for pressures", "solve the bearing by strips")
        found: Solution | None = self._solutions[roller][RINGS.index(ring)]
        return found

    @cached_property
    def _solutions(self) -> list[list[Solution | None]]:
        size = _SAME * float(np.max(np.abs(self.approach), initial=1e-300))
        solutions: list[list[Solution | None]] = []
        for row in self.bearing.rows:
            # Those on both sides of a load are the same.
            known: dict[tuple[int, int, int], Solution] = {}
            for j in range(len(solutions), len(solutions) + row.bearing.rollers):
                solutions.append([])
                for k, contact in enumerate(row.bearing.contacts):
                    if not self.load[j, k] > 0.0:
                        solutions[j].append(None)
                        continue
                    approach, tilt = float(self.approach[j, k]), float(self.tilt[j, k])
                    key = (k, round(approach / size), round(tilt * row.bearing.roller_length / size))
                    if key not in known:
                        with warnings.catch_warnings():
                            warnings.simplefilter("ignore", AccuracyWarning)
                            known[key] = solve(contact, approach=approach, tilt=tilt)
                    solutions[j].append(known[key])
        return solutions

    @property
    def max_pressure(self) -> Array:
        """Maximum pressure of every contact [MPa], shape (rollers, 2); zero where there is no load."""
        return self._of_contacts("max_pressure")

    @property
    def max_pressure_y(self) -> Array:
        """Where it is along the roller [mm], shape (rollers, 2); NaN where there is no load."""
        found = self._of_contacts("max_pressure_y")
        return np.where(self.load > 0.0, found, np.nan)

    def _of_contacts(self, name: str) -> Array:
        found = np.zeros(self.load.shape)
        for j in range(self.angle.size):
            for k, ring in enumerate(RINGS):
                solution = self.contact(j, ring)
                if solution is not None:
                    found[j, k] = getattr(solution, name)
        return found


def _in_words(values: Array, weights: Array) -> list[str]:
    """Return numbers as text; what is rounding beside the others is zero."""
    sizes = np.abs(values * weights)
    return [digits(value if size > NO_LOAD * sizes.max() else 0.0) for value, size in zip(values, sizes, strict=True)]
