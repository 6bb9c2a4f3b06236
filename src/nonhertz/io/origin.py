"""What a case was read from: its text, and the files that the text names."""

from __future__ import annotations

import contextlib
import warnings
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any, TypeVar

from nonhertz.errors import AccuracyWarning
from nonhertz.io.profiles import profile_tables

MOST_ATTACHED = 10_000_000  # bytes of a file that is carried along

Read = TypeVar("Read")


@dataclass(frozen=True, eq=False)
class Origin:
    """What a case was read from.

    Attributes
    ----------
    document : dict
        What the text holds.
    text : str or None
        The text; None of a case that came from elsewhere, as from the page.
    notes : tuple of str
        What was warned of when it was read, such as gaps in a measured profile.
    folder : Path or None
        What names of other files are relative to; None where none may be read.
    """

    document: dict[str, Any]
    text: str | None
    notes: tuple[str, ...]
    folder: Path | None

    @property
    def files(self) -> tuple[str, ...]:
        """The names of the files that the text names, each once."""
        return tuple(dict.fromkeys(_files_in(self.document)))

    @cached_property
    def attachments(self) -> Mapping[str, bytes]:
        """What is in these files by their names, as far as they are still there and not too large."""
        found: dict[str, bytes] = {}
        for name in self.files if self.folder is not None else ():
            with contextlib.suppress(OSError):
                file = Path(self.folder or "", name)
                if file.stat().st_size <= MOST_ATTACHED:
                    found[name] = file.read_bytes()
        return found


def with_notes(read: Callable[[], Read]) -> tuple[Read, tuple[str, ...]]:
    """Return what a function reads, and each sentence that it warned of once; the warnings are given too."""
    with warnings.catch_warnings(record=True, action="always", category=AccuracyWarning) as caught:
        value = read()
    for each in caught:
        warnings.warn_explicit(each.message, each.category, each.filename, each.lineno)
    notes = dict.fromkeys(str(each.message) for each in caught if issubclass(each.category, AccuracyWarning))
    return value, tuple(notes)


def _files_in(document: Mapping[str, Any]) -> Iterator[str]:
    for body in document.get("body", {}).values():
        for table in profile_tables(body):
            if isinstance(table.get("file"), str):
                yield table["file"]
