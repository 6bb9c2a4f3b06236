"""Cache files that are either intact or treated as missing, and the folders that may hold them.

A file begins with a digest of its key and of its contents, so that one that was truncated, overwritten or swapped is
not read. It is written under a temporary name and then moved, so that processes do not interfere and one that is
killed halfway leaves the old file intact.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import sys
import time
from collections.abc import Iterator
from pathlib import Path

LARGEST = 128 * 2**20
"""Bytes in a folder, of which a solver takes 8 million; beyond that the least recently used files are deleted."""

_FORSAKEN = 3600.0  # s, after which a draft is no longer being written
_DRAFT = ".draft-"
_DIGEST = hashlib.sha256().digest_size


class UnwritableError(Exception):
    """No folder could be written to; each is named with the reason."""


def folders() -> tuple[Path, ...]:
    """Return the cache folders: in ``NUMBA_CACHE_DIR`` if that is set, else beside the package and of the user."""
    chosen = os.environ.get("NUMBA_CACHE_DIR")
    if chosen:
        return (Path(chosen).absolute() / "nonhertz",)
    # If no home directory is found the latter is relative, and would be created wherever the program runs.
    places = Path(__file__).parents[1] / "__pycache__", _of_user()
    return tuple(place / "machine-code" for place in places if place.is_absolute())


def read(name: str, key: bytes) -> bytes | None:
    """Return what was written under a name and a key, or None if it is missing or damaged."""
    for path in (folder / name for folder in folders()):
        with contextlib.suppress(OSError):
            data = path.read_bytes()
            if data[:_DIGEST] == _digest(key, data[_DIGEST:]):
                _mark_used(path)
                return data[_DIGEST:]
    return None


def write(name: str, key: bytes, content: bytes) -> None:
    """Write a file in the first folder that can be written to.

    Raises
    ------
    UnwritableError
        If none can.
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


def held() -> list[tuple[Path, int]]:
    """Return the folders that hold machine code, and the bytes in each."""
    sizes = [(folder, sum(size for _, _, size in _entries(folder))) for folder in folders()]
    return [(folder, size) for folder, size in sizes if size]


def _of_user() -> Path:
    """Return the user's cache folder of this package, by the conventions of the operating system."""
    if sys.platform == "win32":
        return Path(os.environ.get("LOCALAPPDATA", ""), "nonhertz", "Cache")
    # Where no home is known, this leaves the tilde, and Path.expanduser raises an exception.
    home = os.path.expanduser("~")  # noqa: PTH111
    if sys.platform == "darwin":
        return Path(home, "Library", "Caches", "nonhertz")
    return Path(os.environ.get("XDG_CACHE_HOME") or Path(home, ".cache"), "nonhertz")


def _digest(key: bytes, content: bytes) -> bytes:
    return hashlib.sha256(hashlib.sha256(key).digest() + content).digest()


def _mark_used(path: Path) -> None:
    # A read-only folder can still be read from.
    with contextlib.suppress(OSError):
        os.utime(path)


def _place(folder: Path, name: str, data: bytes) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    draft = folder / f"{_DRAFT}{os.urandom(16).hex()}"
    try:
        # Closed before it is moved: a full disk may be reported only on closing.
        with draft.open("xb") as file:
            file.write(data)
        draft.replace(folder / name)
    finally:
        with contextlib.suppress(OSError):
            draft.unlink(missing_ok=True)


def _make_room(folder: Path) -> None:
    """Delete drafts left by killed processes, and the least recently used files beyond `LARGEST`."""
    total = 0
    for path, used, size in sorted(_entries(folder), key=lambda entry: entry[1], reverse=True):
        total += size
        if total > LARGEST or (path.name.startswith(_DRAFT) and used < time.time() - _FORSAKEN):
            with contextlib.suppress(OSError):
                path.unlink()


def _entries(folder: Path) -> Iterator[tuple[Path, float, int]]:
    # Other processes may be deleting files too.
    with contextlib.suppress(OSError), os.scandir(folder) as entries:
        for entry in entries:
            with contextlib.suppress(OSError):
                yield Path(entry.path), entry.stat().st_mtime, entry.stat().st_size
