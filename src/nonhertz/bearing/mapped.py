"""Contacts of rollers by maps: stand-ins that cost a microsecond, for many states of one bearing."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nonhertz.bearing.bearings import Paired, RollerBearing
from nonhertz.bearing.laws import Answer
from nonhertz.bearing.strips import StripLaw
from nonhertz.errors import InputError
from nonhertz.inputs.checks import positive
from nonhertz.maps.evaluation import all_pressed
from nonhertz.maps.value import ContactMap
from nonhertz.maps.verb import contact_map
from nonhertz.model.contact import Contact

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

ROUGH_STRIPS = 21  # where a step leads out of a map


@dataclass(frozen=True, eq=False, repr=False)
class BearingMaps:
    """Maps of all contacts of a bearing; made by `maps`.

    Attributes
    ----------
    bearing : RollerBearing or Paired
        The bearing.
    contacts : tuple of pairs of ContactMap
        For each row those of the inner and the outer ring.
    """

    bearing: RollerBearing | Paired
    contacts: tuple[tuple[ContactMap, ContactMap], ...]

    def __repr__(self) -> str:
        pairs = [each for pair in self.contacts for each in pair]
        bound = max(max(each.bound.load, each.bound.moment) for each in pairs)
        loads = min(each.most_load for each in pairs)
        return f"BearingMaps({len(pairs)} contacts, loads up to {loads:.4g} N, within {bound:.2g})"


def maps(bearing: RollerBearing | Paired, *, load: float, tilt: float = 2e-3, accuracy: float = 1e-4) -> BearingMaps:
    """Return maps of all contacts of a bearing, with which its states are solved in little time.

    Parameters
    ----------
    bearing : RollerBearing or Paired
        The bearing.
    load : float
        The largest load of a roller [N].
    tilt : float
        The largest tilt of a contact, to both sides [rad].
    accuracy : float
        As in `nonhertz.map`.

    Raises
    ------
    InputError
        If the input is invalid.
    """
    if not isinstance(bearing, RollerBearing | Paired):
        raise InputError("bearing", bearing, "be a bearing", "make one, such as a CylindricalRollerBearing")
    positive("load", load, "give the largest load of a roller in N")
    positive("tilt", tilt, "give the largest tilt of a contact in rad")
    known: dict[Contact, ContactMap] = {}
    for row in bearing.rows:
        for contact in row.bearing.contacts:
            if contact not in known:
                known[contact] = contact_map(contact, load=(0.0, load), tilt=(-tilt, tilt), accuracy=accuracy)
    pairs = [row.bearing.contacts for row in bearing.rows]
    return BearingMaps(bearing, tuple((known[inner], known[outer]) for inner, outer in pairs))


class MapLaw:
    """How a contact answers by its map, and by a few strips where a step leads out of it.

    Parameters
    ----------
    contact : Contact
        Roller and ring.
    map_ : ContactMap
        Its map.
    """

    def __init__(self, contact: Contact, map_: ContactMap) -> None:
        self._contact, self._map = contact, map_
        self._strips: StripLaw | None = None

    def pressed(self, rows: Indices, approach: Array, tilt: Array) -> Answer:
        """Return the answer of contacts."""
        found = self._found(approach, tilt)
        answer = Answer(found[:, 2], found[:, 3], found[:, [4, 5, 5, 6]].reshape(-1, 2, 2))
        beyond = np.flatnonzero(found[:, 7] == 0.0)
        if beyond.size:
            if self._strips is None:
                self._strips = StripLaw(self._contact, ROUGH_STRIPS)
            by_strips = self._strips.pressed(rows[beyond], approach[beyond], tilt[beyond])
            for whole, part in zip(answer, by_strips, strict=True):
                whole[beyond] = part
        return answer

    def covers(self, approach: Array, tilt: Array) -> NDArray[np.bool_]:
        """Return which approaches and tilts the map holds."""
        inside: NDArray[np.bool_] = self._found(approach, tilt)[:, 7] != 0.0
        return inside

    def _found(self, approach: Array, tilt: Array) -> Array:
        found = np.empty((approach.size, 8))
        all_pressed(self._map.tables, np.ascontiguousarray(approach), np.ascontiguousarray(tilt), found)
        return found
