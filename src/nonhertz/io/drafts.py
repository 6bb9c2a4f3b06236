"""Temporary folders in which files are written before they are moved into place, and cleanup after killed processes.

A folder is locked for as long as it is in use. The system releases the lock when the process ends, however it ends, so
a folder that can be locked is abandoned. A process ID would not do: it is reused after a while, and it means nothing to
other machines and containers that share the directory.
"""

from __future__ import annotations

import contextlib
import os
import re
import shutil
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Final

PREFIX: Final = ".nonhertz-draft-"
_NAME = re.compile(re.escape(PREFIX) + r"\w{8}")


@contextlib.contextmanager
def drafts_in(directory: Path) -> Iterator[Path]:
    """Make an empty folder for the body of a ``with`` statement, after removing those left behind by killed processes.

    Raises
    ------
    OSError
        If the directory cannot be written to.
    """
    _sweep(directory)
    with contextlib.ExitStack() as held:
        folder = None
        while folder is None:
            folder = _locked_folder(directory, held)
        try:
            yield folder
        finally:
            shutil.rmtree(folder, ignore_errors=True)


def _locked_folder(directory: Path, held: contextlib.ExitStack) -> Path | None:
    """Make and lock a folder; return None if another process took it for an abandoned one in the meantime."""
    # Inside the directory, not beside it: a move is only atomic within one file system.
    folder = Path(tempfile.mkdtemp(prefix=PREFIX, dir=directory))
    if sys.platform == "win32":
        return folder
    try:
        descriptor = os.open(folder, os.O_RDONLY)
    except FileNotFoundError:
        return None
    held.callback(os.close, descriptor)
    return folder if _lock(descriptor) is not False and folder.exists() else None


def _sweep(directory: Path) -> None:
    # A directory may be writable but not readable.
    with contextlib.suppress(OSError):
        for folder in directory.iterdir():
            if _NAME.fullmatch(folder.name):
                _remove_abandoned(folder)


def _remove_abandoned(folder: Path) -> None:
    if sys.platform == "win32":
        return
    try:
        descriptor = os.open(folder, os.O_RDONLY | os.O_DIRECTORY | os.O_NOFOLLOW)
    except OSError:  # another process was faster, or it is not one of our folders
        return
    try:
        if _lock(descriptor):
            shutil.rmtree(folder, ignore_errors=True)
    finally:
        os.close(descriptor)


def _lock(descriptor: int) -> bool | None:
    """Return whether a folder could be locked: False if a process holds it, None if the file system has no locks."""
    if sys.platform == "win32":  # nothing is locked, so nothing is swept
        return None
    import fcntl

    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        return False
    except OSError:
        return None
    return True
