"""The required life: in millions of revolutions, or in hours at the speed of the bearing."""

from __future__ import annotations

import re
from typing import Final

from nonhertz.errors import InputError
from nonhertz.inputs.checks import is_number, positive
from nonhertz.inputs.descriptions import Custom

_HOURS: Final = re.compile(r"(\d+(?:\.\d*)?(?:[eE][+-]?\d+)?) *h")
_REMEDY: Final = "give millions of revolutions as a number, or hours as text such as '20000 h'"


def _parse(name: str, value: object, remedy: str) -> float | str:
    """Return millions of revolutions, or hours as a number, a space and h."""
    if isinstance(value, str):
        hours = _HOURS.fullmatch(value.strip())
        if hours is None or float(hours.group(1)) <= 0.0:
            raise InputError(name, value, "be a number of hours above zero, followed by h", remedy)
        return f"{hours.group(1)} h"
    if not is_number(value):
        raise InputError(name, value, "be millions of revolutions, or hours", remedy)
    number = float(value)  # type: ignore[arg-type]
    positive(name, number, remedy)
    return number


#: Description of the field.
REQUIRED: Final = Custom(
    "required life in millions of revolutions or, as text such as '20000 h', in hours: the verdict includes it",
    _parse,
    {"anyOf": [{"type": "number", "exclusiveMinimum": 0}, {"type": "string", "pattern": rf"^ *{_HOURS.pattern} *$"}]},
    _REMEDY,
)


def million_revolutions(required: float | str, speed: float | None) -> float:
    """Return the required life [10^6 revolutions].

    Parameters
    ----------
    required : float or str
        As in `REQUIRED`.
    speed : float or None
        Speed [1/min], needed for hours.

    Raises
    ------
    InputError
        If hours are required without a speed.

    Examples
    --------
    >>> million_revolutions("20000 h", 1000.0), million_revolutions(150.0, None)
    (1200.0, 150.0)
    """
    if not isinstance(required, str):
        return required
    if speed is None:
        raise InputError("required", required, "be in millions of revolutions where there is no speed", _REMEDY)
    return 60e-6 * speed * float(required.removesuffix("h"))
