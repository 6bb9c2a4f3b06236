"""The form for catalogue data of a bearing: symbols with meanings, and units in which catalogues print them."""

from __future__ import annotations

from typing import Any, Final

from nonhertz.files.catalogue import NEEDED, SYMBOLS

_PRINTED: Final = {"C": "kN", "C0": "kN", "alpha": "deg", "clearance": "um"}
_RACEWAYS: Final = (("F", "E"), "F and E together give the diameter and pitch circle of the rollers")
#: By type of bearing, symbols that may be given as well, and a hint.
_KINDS: Final = {
    "cylindrical": _RACEWAYS,
    "needle": _RACEWAYS,
    "tapered": (("alpha", "e", "Y"), "one of the three is needed; for the width give T"),
}


def catalogue_form() -> dict[str, Any]:
    """Return the fields of the form as JSON: needed ones, those by type of bearing with a hint, and the clearance."""
    return {
        "needed": [*map(_field, NEEDED)],
        "kinds": {kind: {"others": [*map(_field, others)], "hint": hint} for kind, (others, hint) in _KINDS.items()},
        "clearance": _field("clearance"),
    }


def _field(symbol: str) -> tuple[str, str, str]:
    _, unit, meaning = SYMBOLS[symbol]
    return symbol, meaning, _PRINTED.get(symbol, unit)
