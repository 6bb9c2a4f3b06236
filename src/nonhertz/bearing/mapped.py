"""Contacts of rollers by maps: surrogates that take a microsecond, for many states of one bearing."""

from __future__ import annotations

from dataclasses import dataclass

from nonhertz.amounts import newton
from nonhertz.bearing.bearings import RollerBearing
from nonhertz.bearing.pairs import Paired
from nonhertz.errors import InputError, without_accuracy_warnings
from nonhertz.findings import warn
from nonhertz.inputs.checks import positive
from nonhertz.maps.value import INACCURATE, ContactMap
from nonhertz.maps.verb import contact_map
from nonhertz.model.contact import Contact
from nonhertz.result.brief import HasHtml


@dataclass(frozen=True, eq=False, repr=False)
class BearingMaps(HasHtml):
    """Maps of all contacts of a bearing; made by `maps`.

    Attributes
    ----------
    bearing : RollerBearing or Paired
        The bearing.
    contacts : tuple of pairs of ContactMap
        For each row the maps of the contacts with the inner and the outer ring.
    """

    bearing: RollerBearing | Paired
    contacts: tuple[tuple[ContactMap, ContactMap], ...]

    def __repr__(self) -> str:
        pairs = [map_ for pair in self.contacts for map_ in pair]
        error = max(max(map_.sampled_error.load, map_.sampled_error.moment) for map_ in pairs)
        loads = min(map_.max_load for map_ in pairs)
        return f"BearingMaps({len(pairs)} contacts, loads up to {newton(loads):.4g}, sampled error {error:.2g})"


def maps(bearing: RollerBearing | Paired, *, load: float, tilt: float = 2e-3, accuracy: float = 1e-4) -> BearingMaps:
    """Return maps of all contacts of a bearing, with which its states are solved quickly.

    Parameters
    ----------
    bearing : RollerBearing or Paired
        The bearing.
    load : float
        The largest load of a roller [N].
    tilt : float
        The largest tilt of a contact, in both directions [rad].
    accuracy : float
        As in `nonhertz.maps.contact_map`.

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
                with without_accuracy_warnings():
                    known[contact] = contact_map(contact, load=(0.0, load), tilt=(-tilt, tilt), accuracy=accuracy)
    # A bearing uses only loads and moments of a map.
    warn(finding for made in known.values() for finding in made.findings if finding.kind == INACCURATE)
    pairs = [row.bearing.contacts for row in bearing.rows]
    return BearingMaps(bearing, tuple((known[inner], known[outer]) for inner, outer in pairs))
