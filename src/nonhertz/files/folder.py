"""Files written into a directory, all of them or none."""

from __future__ import annotations

import contextlib
import os
import tempfile
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path

from nonhertz.amounts import display_units
from nonhertz.errors import InputError

_OUT_REMEDY = "give a directory to write to"
_DRAFTS = ".nonhertz-draft-"


def write_files(
    directory: str | Path, texts: Mapping[str, str], draw: Callable[[Path], object] | None = None
) -> tuple[Path, ...]:
    """Write texts, and the files of ``draw``, into a directory: all files or none.

    Figures are in SI units, whatever the display units are.

    Parameters
    ----------
    directory : str or Path
        Target directory; created if it does not exist. Files of the same names are overwritten.
    texts : mapping of str to str
        Texts by file name.
    draw : callable or None
        Writes further files (figures) into the directory passed to it; they are moved into place after it returns.

    Returns
    -------
    tuple of Path
        Paths of the files.

    Raises
    ------
    InputError
        If the directory cannot be written to.
    """
    directory = Path(directory)
    with _draft_folder(directory) as drafts:
        for name, text in texts.items():
            (drafts / name).write_text(text, encoding="utf-8", newline="\n")
        if draw is not None:
            with display_units("si"):
                draw(drafts)
        files = [(draft, directory / draft.name) for draft in sorted(drafts.iterdir())]
        for _, target in files:
            if target.is_dir():
                raise InputError("folder", str(directory), f"not hold a directory named {target.name}", _OUT_REMEDY)
        for draft, target in files:
            os.replace(draft, target)  # noqa: PTH105  (says that it replaces)
    return tuple(target for _, target in files)


def write_file(path: Path, text: str) -> Path:
    """Write a text into a file, whole or not at all, and return it.

    Raises
    ------
    InputError
        If it cannot be written.
    """
    try:
        return write_files(path.parent, {path.name: text})[0]
    except InputError as error:
        raise error.about("path", str(path)) from None


def refuse_unwritable(directory: Path, field: str = "folder") -> None:
    """Refuse a directory that cannot be written to before the work starts; `write_files` would do so only at the end.

    A test write leaves the directory as it was. ``field`` is what the error calls it.

    Raises
    ------
    InputError
        If the directory cannot be written to.
    """
    try:
        with _draft_folder(directory, keep=False):
            pass
    except InputError as error:
        raise error.about(field, error.value) from None


def refuse_unwritable_file(path: Path) -> None:
    """Refuse a file that cannot be written, or whose folder is missing together with the folder above: a typing error.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    if not (around := path.parent.parent).exists():
        condition = "be in an existing folder, or in a new one within it"
        raise InputError("out", str(path), condition, f"make {around} first, or correct the name")
    refuse_unwritable(path.parent)


@contextlib.contextmanager
def _draft_folder(directory: Path, *, keep: bool = True) -> Iterator[Path]:
    """Make a folder for drafts in a directory; refuse one that cannot be written to.

    The directory is created if necessary, and removed again on failure, or if ``keep`` is false.
    """
    made: list[Path] = []
    try:
        if directory.exists() and not directory.is_dir():
            raise InputError("folder", str(directory), "be a directory, not a file", _OUT_REMEDY)
        made = [path for path in (directory, *directory.parents) if not path.exists()]  # innermost first
        directory.mkdir(parents=True, exist_ok=True)
        # Inside the directory, not beside it: a move is only atomic within one file system.
        with tempfile.TemporaryDirectory(prefix=_DRAFTS, dir=directory) as drafts:
            yield Path(drafts)
    except BaseException as error:
        keep = False
        if not isinstance(error, OSError):
            raise
        condition = f"be a directory to write to ({(error.strerror or str(error)).lower()})"
        raise InputError("folder", str(directory), condition, "choose another") from None
    finally:
        for path in () if keep else made:
            with contextlib.suppress(OSError):
                path.rmdir()
