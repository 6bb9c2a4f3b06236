"""Limits on the content of a case file, so that any file is answered promptly.

They are far above the needs of any case: only a wrong path or a broken generator exceeds them.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any, Final

FORMAT: Final = 1
"""Of case files and results; incremented when a later release can no longer read old files unchanged."""
LARGEST_CASE: Final = 1_000_000
"""Bytes of a file; some 50,000 points."""
NESTING: Final = 16
"""Levels of nested tables and lists; a case has six at most."""
KEYS: Final = 5000
"""Keys in the whole file; a thousand loads have three each."""
PROFILES: Final = 100
"""Profiles of a body."""
LOADS: Final = 1000
"""Loads of a spectrum."""
MISTAKES: Final = 20
"""Mistakes listed one by one; further ones are only counted."""

TOO_DEEP: Final = "lists or tables are nested too deeply"
_KEY_PART = r"""(?:[\w-]+|"(?:[^"\\\n]|\\.)*"|'[^'\n]*')"""
_LONG_KEY = re.compile(rf"(?:^|[\[{{,])[ \t]*(?:{_KEY_PART}[ \t]*\.[ \t]*){{{NESTING}}}", re.MULTILINE)


def has_long_key(text: str) -> bool:
    """Return whether a dotted key in the text of a case file has more parts than the nesting limit.

    Check this before parsing: the parser's time grows with the square of the number of parts.
    """
    return _LONG_KEY.search(text) is not None


def exceeded_limit(document: dict[str, Any]) -> str:
    """Return which limit a document exceeds, as a clause; empty if none.

    Examples
    --------
    >>> exceeded_limit({"load": {"load": 20000.0}})
    ''
    >>> exceeded_limit({f"k{number}": 1 for number in range(6000)})
    'there are more than 5000 keys'
    """
    if is_deeper(document, NESTING):
        return TOO_DEEP
    if sum(len(table) for _, table in walk(document) if isinstance(table, dict)) > KEYS:
        return f"there are more than {KEYS} keys"
    return ""


def is_deeper(value: Any, most: int) -> bool:
    """Return whether tables and lists are nested more than ``most`` levels deep."""
    return any(len(place) >= most for place, _ in walk(value))


def walk(value: Any) -> Iterator[tuple[tuple[str | int, ...], Any]]:
    """Yield every value in tables and lists with its place, from the outside in; positions in lists count from 1.

    Examples
    --------
    >>> [place for place, _ in walk({"load": {"load": 20000.0}, "title": "one"})]
    [(), ('load',), ('load', 'load'), ('title',)]
    """
    pending: list[tuple[tuple[str | int, ...], Any]] = [((), value)]
    while pending:
        place, current = pending.pop()
        yield place, current
        is_list = isinstance(current, list)
        inner = current.items() if isinstance(current, dict) else enumerate(current, start=1) if is_list else ()
        pending += reversed([((*place, key), entry) for key, entry in inner])
