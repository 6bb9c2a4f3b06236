"""Units of length as people and machines write them."""

from __future__ import annotations

import functools
import re
import unicodedata

# A prefix, or a power of ten ("1e-6 m", "10^-6 m"), before a metre; other units by name.
_METRE = re.compile(r"(?:(?:1?e|[x*]?10(?:\^|\*\*|(?=-)))([-+]?\d+)[*x]?)?([a-z]*?)m(?:et(?:er|re|ro)s?)?")
# Powers of ten of a millimetre.
_PREFIXES = {"k": 6, "": 3, "d": 2, "c": 1, "centi": 1, "zenti": 1, "m": 0, "milli": 0, "mili": 0}
_PREFIXES |= {"u": -3, "mu": -3, "micro": -3, "mikro": -3, "n": -6, "nano": -6}
_OTHERS = {"micron": 1e-3, "angstrom": 1e-7, "in": 25.4, "inch": 25.4, "inche": 25.4, "zoll": 25.4}
_OTHERS |= {"angstroem": 1e-7, "мкм": 1e-3, "мм": 1.0, "нм": 1e-6, "微米": 1e-3, "毫米": 1.0, "纳米": 1e-6}
_OTHERS |= {"mil": 0.0254, "thou": 0.0254, "uin": 25.4e-6, "microinch": 25.4e-6, "microinche": 25.4e-6}
_LONGEST = 30


@functools.lru_cache(maxsize=4096)
def millimetres(unit: str) -> float | None:
    """Return how many mm a unit is, None if it is not a unit of length.

    Examples
    --------
    >>> [millimetres(unit) for unit in ("um", "mu m", "Micrometers", "1e-6 m", "10^-9 m", "MM", "Mm", "s")]
    [0.001, 0.001, 0.001, 0.001, 1e-06, 1.0, None, None]
    """
    text = unit.strip(" .,:;'\"[](){}<>_/")
    if not text or len(text) > _LONGEST:
        return None
    text = {"\u00c5": "angstrom", "\u212b": "angstrom", "\u00b5": "micron", "\u03bc": "micron"}.get(text, text)
    # The letter of micrometres, and what becomes of it where UTF-8 is taken for Latin-1, or code page 850.
    text = re.sub("\u00c2?[\u00b5\u03bc]|\u00e6(?=m)", "u", text)
    text = "".join(letter for letter in unicodedata.normalize("NFKD", text) if not unicodedata.combining(letter))
    # "UM" can only mean "um", "Mm" is a megametre and "M" anything.
    if len(text) < 3 and text.isascii() and not (text.islower() or (text.isupper() and len(text) == 2)):
        return None
    text = re.sub(r"[\s-](?!\d)", "", text.casefold().replace("\u2212", "-"))
    if text.rstrip("s") in _OTHERS:
        return _OTHERS[text.rstrip("s")]
    match = _METRE.fullmatch(text)
    if match is None or match[2] not in _PREFIXES or len(match[1] or "") > 3:
        return None
    return float(f"1e{_PREFIXES[match[2]] + int(match[1] or 0)}")
