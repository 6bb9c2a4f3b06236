"""What a case, of a contact or a bearing, was read from: its text, and the files named in it."""

from __future__ import annotations

import contextlib
import warnings
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any, TypeVar

from nonhertz.errors import AccuracyWarning

MOST_ATTACHED = 10_000_000  # bytes; larger files are not attached

Read = TypeVar("Read")


@dataclass(frozen=True, eq=False)
class Origin:
    """What a case was read from.

    Attributes
    ----------
    document : dict
        The parsed text.
    text : str or None
        The text; None for a case that came from elsewhere, such as the page.
    notes : tuple of str
        Warnings raised when it was read, such as gaps in a measured profile.
    folder : Path or None
        Directory that file names are relative to; None where no file may be read.
    """

    document: dict[str, Any]
    text: str | None
    notes: tuple[str, ...]
    folder: Path | None

    @property
    def files(self) -> tuple[str, ...]:
        """The names of the files that the text refers to, without repeats."""
        return tuple(dict.fromkeys(_files_in(self.document)))

    @cached_property
    def attachments(self) -> Mapping[str, bytes]:
        """Contents of these files by name; missing and too large ones are left out."""
        found: dict[str, bytes] = {}
        for name in self.files if self.folder is not None else ():
            with contextlib.suppress(OSError):
                file = Path(self.folder or "", name)
                if file.stat().st_size <= MOST_ATTACHED:
                    found[name] = file.read_bytes()
        return found


def with_notes(read: Callable[[], Read]) -> tuple[Read, tuple[str, ...]]:
    """Return what a function reads, and its warnings without repeats; the warnings are also issued."""
    with warnings.catch_warnings(record=True, action="always", category=AccuracyWarning) as caught:
        value = read()
    for each in caught:
        warnings.warn_explicit(each.message, each.category, each.filename, each.lineno)
    notes = dict.fromkeys(str(each.message) for each in caught if issubclass(each.category, AccuracyWarning))
    return value, tuple(notes)


def body_tables(document: Mapping[str, Any]) -> Iterator[tuple[str, Mapping[str, Any]]]:
    """Yield place and table of every body in the document of a case, of a contact or a bearing."""
    bodies = document.get("body", {})
    for name, table in bodies.items() if isinstance(bodies, Mapping) else ():
        yield f"body.{name}", table
    for name in ("roller", "inner", "outer"):
        if name in document:
            yield name, document[name]


def _files_in(value: Any) -> Iterator[str]:
    """Yield the names of files in a document: only tables of profiles and shapes have such a key."""
    if isinstance(value, Mapping) and isinstance(value.get("file"), str):
        yield value["file"]
    for each in value.values() if isinstance(value, Mapping) else value if isinstance(value, list) else ():
        yield from _files_in(each)
