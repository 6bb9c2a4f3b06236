"""A map of a contact in rows: its range, what it was built from, and how far it is from the solver."""

from __future__ import annotations

from nonhertz.amounts import mrad, newton, um
from nonhertz.maps import ContactMap
from nonhertz.maps.misses import SAFETY
from nonhertz.maps.value import in_share
from nonhertz.show.sections import Row, Said, Section, summary

_OF = {
    "load": "of the load",
    "moment": "of load times half-length",
    "stiffness": "of the stiffness",
    "max_pressure": "of the maximum pressure",
    "max_half_width": "of the half-width",
    "strip_loads": "of the load on each of {strips} strips",
}


def sections(found: ContactMap) -> list[Section]:
    """Return what is shown of a map."""
    pressed = (newton if found.given == "load" else um)(*found.pressed, between=" to ")
    error, strips = found.sampled_error, found.stations.size - 1
    errors = [(in_share(getattr(error, name)), words.format(strips=strips)) for name, words in _OF.items()]
    rows: list[Row] = [
        (found.given, f"{pressed:.4g}", f"loads up to {newton(found.max_load)}"),
        ("tilt", f"{mrad(*found.tilt_range, between=' to '):.4g}", ""),
        ("cases", str(found.cases), f"{found.failed} more had no solution" if found.failed else ""),
        *(("" if number else "error", *each) for number, each in enumerate(errors)),
    ]
    sampled = f"Errors are the largest of {error.points} sampled ones, times {SAFETY:g}, and no bounds."
    return [Section("", [Said([found.description]), summary(rows), Said([sampled])])]
