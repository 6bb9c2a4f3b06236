"""Reading files up to a size limit and without blocking.

A path need not lead to a file on disk: a device may be endless and a pipe may have no writer.
"""

from __future__ import annotations

import errno
import os
import stat
import sys
from pathlib import Path
from typing import Final

from nonhertz.errors import InputError

_WITHOUT_WAITING: Final = getattr(os, "O_NONBLOCK", 0)  # Windows has no such pipes


def read_bytes(path: str | os.PathLike[str], most: int) -> bytes:
    """Return the contents of a file.

    Parameters
    ----------
    path : str or os.PathLike
        The file. A pipe is read to its end; one without a writer is empty.
    most : int
        Largest size in bytes.

    Raises
    ------
    OSError
        If it cannot be read; with ``errno.EFBIG`` if it is larger.
    ValueError
        If the name is impossible for a file.
    """
    with open(path, "rb", opener=_open_file) as file:
        data = file.read(most + 1)
    if len(data) > most:
        raise OSError(errno.EFBIG, f"larger than {most / 1e6:g} MB")
    return data


def read_input_file(field: str, path: str | os.PathLike[str], most: int) -> tuple[bytes, str]:
    """Return the contents of the file named by a field, and its name as messages show it.

    Raises
    ------
    InputError
        If it cannot be read, or is larger than ``most`` bytes.
    """
    if not isinstance(path, str | os.PathLike):
        raise InputError(field, path, "be the path of a file", "give a string or a Path")
    try:
        name = printable_name(Path(path).name or str(path))
        return read_bytes(path, most), name
    except (OSError, ValueError) as error:  # ValueError: not a valid file name
        if getattr(error, "errno", None) == errno.EFBIG:
            condition, remedy = f"be no larger than {most // 1_000_000} MB", "export fewer points"
            raise InputError(field, name, condition, remedy) from None
        reason = (getattr(error, "strerror", None) or str(error)).lower()
        condition = f"be a file that can be read ({reason})"
        raise InputError(field, str(path), condition, "check path and permissions") from None


def printable_name(name: str) -> str:
    r"""Return the name of a file as a line of text; a name can be any bytes and may contain line breaks.

    Examples
    --------
    >>> printable_name("roller\udcff.toml")
    'roller\ufffd.toml'
    """
    text = os.fsencode(name).decode("utf-8", "replace")
    return "".join(character if character.isprintable() else "\ufffd" for character in text)


def relative_path(directory: Path, file: Path) -> Path:
    """Return the path of a file relative to a directory."""
    try:
        return Path(os.path.relpath(file, directory))
    except ValueError:  # on another drive
        return file.absolute()


def is_special_file(path: str | os.PathLike[str]) -> bool:
    """Return whether a path leads to a device, a pipe or a socket: something that is neither a file nor a directory."""
    try:
        mode = Path(path).stat().st_mode
    except (OSError, ValueError):  # opening it will raise the error with its reason
        return False
    return not stat.S_ISREG(mode) and not stat.S_ISDIR(mode)


def _open_file(path: str, flags: int) -> int:
    descriptor = os.open(path, flags | _WITHOUT_WAITING)
    if sys.platform != "win32":
        os.set_blocking(descriptor, True)
    return descriptor
