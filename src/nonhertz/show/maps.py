"""A map of a contact in rows: its range, the solves behind it, and its errors."""

from __future__ import annotations

from nonhertz.amounts import mrad, newton, um
from nonhertz.maps import ContactMap
from nonhertz.maps.misses import SAFETY
from nonhertz.show.sections import Notes, Row, Section, summary


def sections(contact_map: ContactMap) -> list[Section]:
    """Return the section on a map."""
    pressed = (newton if contact_map.given == "load" else um)(*contact_map.pressed, between=" to ")
    rows: list[Row] = [
        (contact_map.given, f"{pressed:.4g}", f"loads up to {newton(contact_map.max_load)}"),
        ("tilt", f"{mrad(*contact_map.tilt_range, between=' to '):.4g}", ""),
        ("cases", str(contact_map.cases), f"{contact_map.failed} more failed" if contact_map.failed else ""),
        *(("" if number else "error", *words) for number, words in enumerate(contact_map.errors_in_words)),
    ]
    sampled = (
        f"Errors are the largest at {contact_map.sampled_error.points} sampled points times {SAFETY:g}, not bounds."
    )
    return [Section("", [Notes([contact_map.description]), summary(rows), Notes([sampled])])]
