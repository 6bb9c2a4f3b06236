"""How much a case file may hold, so that whatever is in one is answered at once.

Far more than any case needs: a bound is met by a wrong path or a broken generator, not by a person.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from typing import Any, Final

LARGEST_CASE: Final = 1_000_000
"""Bytes; some 50,000 points."""
NESTING: Final = 16
"""Tables and lists within one another; a case has six at most."""
KEYS: Final = 5000
"""In the whole file; a thousand loads have three each."""
PROFILES: Final = 100
"""Of a body."""
LOADS: Final = 1000
"""Of a spectrum."""
MISTAKES: Final = 20
"""That are told one by one."""

TOO_DEEP: Final = "lists or tables are nested too deeply"
_KEY_PART = r"""(?:[\w-]+|"(?:[^"\\\n]|\\.)*"|'[^'\n]*')"""
_LONG_KEY = re.compile(rf"(?:^|[\[{{,])[ \t]*(?:{_KEY_PART}[ \t]*\.[ \t]*){{{NESTING}}}", re.MULTILINE)


def has_long_key(text: str) -> bool:
    """Return whether a key in the text of a case file has more parts than tables may be nested.

    To be asked before the text is parsed, which takes the square of their number.
    """
    return _LONG_KEY.search(text) is not None


def excess(document: dict[str, Any]) -> str:
    """Return what there is too much of in a document, as a clause; empty if there is not.

    Examples
    --------
    >>> excess({"load": {"load": 20000.0}})
    ''
    >>> excess({f"k{number}": 1 for number in range(6000)})
    'there are more than 5000 keys'
    """
    if deeper(document, NESTING):
        return TOO_DEEP
    if sum(map(len, _tables(document))) > KEYS:
        return f"there are more than {KEYS} keys"
    return ""


def deeper(value: Any, most: int) -> bool:
    """Return whether there are more than so many tables and lists within one another."""
    level: Iterable[Any] = (value,)
    for _ in range(most):
        level = [inner for outer in level for inner in _entries(outer)]
        if not level:
            return False
    return True


def _tables(value: Any) -> Iterator[dict[str, Any]]:
    """Yield all tables in a value, and itself if it is one."""
    if isinstance(value, dict):
        yield value
    for entry in _entries(value):
        yield from _tables(entry)


def _entries(value: Any) -> Iterable[Any]:
    if isinstance(value, dict):
        return value.values()
    return value if isinstance(value, list) else ()
