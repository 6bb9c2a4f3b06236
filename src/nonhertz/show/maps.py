"""A map of a contact in rows: its range, what it was built from, and how far it is from the solver."""

from __future__ import annotations

from nonhertz.amounts import mrad, newton, um
from nonhertz.maps import ContactMap
from nonhertz.maps.misses import SAFETY
from nonhertz.show.sections import Row, Said, Section, summary


def sections(found: ContactMap) -> list[Section]:
    """Return what is shown of a map."""
    pressed = (newton if found.given == "load" else um)(*found.pressed, between=" to ")
    rows: list[Row] = [
        (found.given, f"{pressed:.4g}", f"loads up to {newton(found.max_load)}"),
        ("tilt", f"{mrad(*found.tilt_range, between=' to '):.4g}", ""),
        ("cases", str(found.cases), f"{found.failed} more had no solution" if found.failed else ""),
        *(("" if number else "error", *each) for number, each in enumerate(found.errors_in_words)),
    ]
    sampled = f"Errors are the largest of {found.sampled_error.points} sampled ones, times {SAFETY:g}, and no bounds."
    return [Section("", [Said([found.description]), summary(rows), Said([sampled])])]
