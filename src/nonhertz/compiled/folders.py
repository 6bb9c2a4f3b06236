"""Files that are whole or count as missing, in the folders that may hold them.

A file begins with a digest of its key and of what follows, so that one that was cut, overwritten or put in another's
place is not read. It is written under a name of its own and then moved, so that processes do not meet in it and one
that ends halfway leaves the old file.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import time
import uuid
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numba.core.config
from numba.misc.appdirs import AppDirs

LARGEST = 128 * 2**20
"""Bytes in a folder, of which a solver takes 8 million; beyond them goes what has been used least lately."""

_FORSAKEN = 3600.0  # s, after which nobody is still writing a draft
_DRAFT = ".draft-"
_DIGEST = hashlib.sha256().digest_size


class UnwritableError(Exception):
    """No folder took a file; each is named with the reason."""


def folders() -> tuple[Path, ...]:
    """Return where files are looked for: in ``NUMBA_CACHE_DIR`` if that is set, else with the package or the user."""
    settings: Any = numba.core.config
    if settings.CACHE_DIR:
        return (Path(settings.CACHE_DIR).absolute() / "nonhertz",)
    # With no home to be found the latter is a relative path, which would be created wherever the program runs.
    places = Path(__file__).parents[1] / "__pycache__", Path(AppDirs("nonhertz", appauthor=False).user_cache_dir)
    return tuple(place / "machine-code" for place in places if place.is_absolute())


def read(name: str, key: bytes) -> bytes | None:
    """Return what was written under a name and a key, or None if it is not there as it was written."""
    for path in (folder / name for folder in folders()):
        with contextlib.suppress(OSError):
            data = path.read_bytes()
            if data[:_DIGEST] == _digest(key, data[_DIGEST:]):
                _mark_used(path)
                return data[_DIGEST:]
    return None


def write(name: str, key: bytes, content: bytes) -> None:
    """Write a file in the first folder that takes it.

    Raises
    ------
    UnwritableError
        If none does.
    """
    failures = []
    for folder in folders():
        try:
            _place(folder, name, _digest(key, content) + content)
        except OSError as error:
            failures.append(f"{folder} ({error.strerror or error})")
        else:
            _make_room(folder)
            return
    raise UnwritableError(", ".join(failures))


def _digest(key: bytes, content: bytes) -> bytes:
    return hashlib.sha256(hashlib.sha256(key).digest() + content).digest()


def _mark_used(path: Path) -> None:
    # Somebody else's folder is read all the same.
    with contextlib.suppress(OSError):
        os.utime(path)


def _place(folder: Path, name: str, data: bytes) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    draft = folder / f"{_DRAFT}{uuid.uuid4().hex}"
    try:
        # Closed before it is moved: a full disk may tell only then.
        with draft.open("xb") as file:
            file.write(data)
        draft.replace(folder / name)
    finally:
        with contextlib.suppress(OSError):
            draft.unlink(missing_ok=True)


def _make_room(folder: Path) -> None:
    """Delete drafts that a killed process has left, and what has been used least lately beyond `LARGEST`."""
    total = 0
    for path, used, size in sorted(_entries(folder), key=lambda entry: entry[1], reverse=True):
        total += size
        if total > LARGEST or (path.name.startswith(_DRAFT) and used < time.time() - _FORSAKEN):
            with contextlib.suppress(OSError):
                path.unlink()


def _entries(folder: Path) -> Iterator[tuple[Path, float, int]]:
    # Other processes delete as well.
    with contextlib.suppress(OSError), os.scandir(folder) as entries:
        for entry in entries:
            with contextlib.suppress(OSError):
                yield Path(entry.path), entry.stat().st_mtime, entry.stat().st_size
