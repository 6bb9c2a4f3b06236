"""Files are read no further than a bound, and none is waited for.

What a path leads to need not be a file on disk: a device may have no end, and a pipe may have nobody who writes to it.
"""

from __future__ import annotations

import errno
import os
import stat
from pathlib import Path
from typing import Final

_WITHOUT_WAITING: Final = getattr(os, "O_NONBLOCK", 0)  # Windows has no such pipes


def content(path: str | os.PathLike[str], most: int) -> bytes:
    """Return what is in a file.

    Parameters
    ----------
    path : str or os.PathLike
        The file. A pipe is read to its end; one that nobody writes to is empty.
    most : int
        Bytes, at most.

    Raises
    ------
    OSError
        If it cannot be read; with ``errno.EFBIG`` if it is larger.
    ValueError
        If no file can have such a name.
    """
    with open(path, "rb", opener=_opened) as file:
        data = file.read(most + 1)
    if len(data) > most:
        raise OSError(errno.EFBIG, f"larger than {most / 1e6:g} MB")
    return data


def legible(name: str) -> str:
    r"""Return the name of a file as a line of text; a name can be any bytes and hold the end of a line.

    Examples
    --------
    >>> legible("roller\udcff.toml")
    'roller\ufffd.toml'
    """
    text = os.fsencode(name).decode("utf-8", "replace")
    return "".join(character if character.isprintable() else "\ufffd" for character in text)


def special(path: str | os.PathLike[str]) -> bool:
    """Return whether a path leads to a device, a pipe or a socket: to something that is neither file nor directory."""
    try:
        mode = Path(path).stat().st_mode
    except (OSError, ValueError):  # whoever opens it says why it cannot be
        return False
    return not stat.S_ISREG(mode) and not stat.S_ISDIR(mode)


def _opened(path: str, flags: int) -> int:
    descriptor = os.open(path, flags | _WITHOUT_WAITING)
    if _WITHOUT_WAITING:
        os.set_blocking(descriptor, True)
    return descriptor
