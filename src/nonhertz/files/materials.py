"""The library of materials as plain numbers and text."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

from nonhertz.amounts import read_in
from nonhertz.model.materials import LIBRARY, Listed

#: Units of the numbers; dimensionless ones are left out.
UNITS = dict.fromkeys(("modulus", "yield_strength", "core_yield_strength", "pressure_limit"), "MPa")


@read_in("si")
def as_object(entries: tuple[Listed, ...] = LIBRARY) -> dict[str, Any]:
    """Return entries of the library by name; what is not known is None."""
    return {
        "materials": {
            each.name: {
                "group": each.group,
                "other_names": list(each.others),
                **asdict(each.material),
                "source": each.source,
                "note": each.note,
            }
            for each in entries
        },
        "units": UNITS,
    }
