"""Numbers as people write them on a drawing."""

from __future__ import annotations

from nonhertz.tables.summary import digits


def given(value: float, significant: int = 6) -> str:
    """Return a number that was given, without zeros that say nothing.

    Examples
    --------
    >>> given(9.0), given(0.000523598775598), given(207000.0), given(2.5e-7), given(57.3, 1)
    ('9', '0.000523599', '207000', '2.5e-07', '57')
    """
    mantissa, exponent, power = digits(value, significant).partition("e")
    return (mantissa.rstrip("0").rstrip(".") if "." in mantissa else mantissa) + exponent + power
